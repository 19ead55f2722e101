(()=>{var lf='.uplot, .uplot *, .uplot *::before, .uplot *::after {box-sizing: border-box;}.uplot {font-family: system-ui, -apple-system, "Segoe UI", Roboto, "Helveti\
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
.u-axis.u-off, .u-select.u-off, .u-cursor-x.u-off, .u-cursor-y.u-off, .u-cursor-pt.u-off {display: none;}';var cf=':root { --actual: #1d5fbf; --actual-more: #0f7f83; --expected: #b35309; }\n@media (prefers-color-scheme: dark) { :root { --actual: #7db4ff; --actual-more\
: #5fd0c5; --expected: #ffb45c; } }\n.plots { display: grid; grid-template-columns: repeat(auto-fit, minmax(min(100%, 20rem), 1fr)); gap: 1rem; }\n.plots figure {\
 min-width: 0; margin: 0; }\n.plots figcaption { font-weight: 600; }\n.plot { min-width: 0; }\n.u-legend { font-size: .82rem; text-align: left; }\n.uplot .u-legend \
tr, .uplot .u-legend td, .uplot .u-legend th { padding: 0 .3rem; border: 0; }\n.uplot .u-legend tr { display: inline-block; padding: 0 .4rem 0 0; }\n.uplot .u-leg\
end th { display: inline-flex; align-items: center; font-weight: 400; }\n.uplot .u-legend td { display: inline-block; font-variant-numeric: tabular-nums; }\n.uplo\
t .u-legend tbody { display: block; }\n.uplot .u-legend .ring .u-marker { border-radius: 50%; }\n.u-inline.u-live th::after { color: var(--soft); }\n.uplot .u-curs\
or-x { border-right: 1px dashed var(--soft); }\n.uplot .u-select { background: color-mix(in srgb, var(--actual) 20%, transparent); }\n.view3d { position: relative\
; height: 22rem; border: 1px solid var(--line); border-radius: .4rem; background: var(--panel);\n  overflow: hidden; }\n.view3d canvas { display: block; width: 10\
0%; height: 100%; cursor: grab; touch-action: pan-y; }\n.controls { display: flex; flex-wrap: wrap; align-items: center; gap: .5rem .9rem; margin: .5rem 0; }\n.co\
ntrols input[type="range"] { flex: 1 1 12rem; min-width: 0; accent-color: var(--actual); }\n.controls button { padding: .25rem .8rem; border: 1px solid var(--sof\
t); border-radius: .4rem; background: var(--panel);\n  color: var(--ink); font: inherit; cursor: pointer; }\n.controls .player { flex: 1 1 100%; }\n.controls butto\
n[aria-pressed="true"] { border-width: 2px; font-weight: 600; }\n.controls :focus-visible, .view3d canvas:focus-visible { outline: 3px solid #3b82f6; outline-off\
set: 2px; }\n.controls output { flex: 1 1 100%; font-variant-numeric: tabular-nums; }\n.key { display: inline-flex; align-items: center; gap: .35rem; margin-right\
: 1rem; }\n.key svg { flex: none; width: 2.2rem; height: 1rem; }\n.viewer { flex: 0 0 100%; min-width: 0; }\n.viewer .stack, .viewer .controls { max-width: 46rem; \
}\n.viewer .stack { position: relative; border: 1px solid var(--line); }\n.viewer .stack img { display: block; width: 100%; max-width: none; image-rendering: pixe\
lated; }\n.viewer .stack .over { position: absolute; inset: 0; }\n.viewer .stack .edge { position: absolute; top: 0; bottom: 0; width: 2px; margin-left: -1px; bac\
kground: #fff;\n  box-shadow: 0 0 0 1px #000; }\n.viewer .tag { position: absolute; top: .4rem; left: .4rem; padding: 0 .5rem; border-radius: .3rem; background: #\
000b;\n  color: #fff; font-size: .82rem; }\n.viewer .tag.right { left: auto; right: .4rem; }\n.viewer .stack [hidden] { display: none; }\n';var hf=':root { --contact: #c2185b; --select: #e08a00; --asleep: #8a97a6; --way: #6a4bc4; --warn: #7a5200; --stage: #e9eef4; --stage-2: #f8fafc; }\n@media (prefe\
rs-color-scheme: dark) { :root { --contact: #ff79b0; --select: #ffc04d; --asleep: #6d7a89; --way: #b7a0ff; --warn: #ffcf70;\n  --stage: #11161b; --stage-2: #222a\
33; } }\nbody.session { max-width: none; padding: .9rem 1.25rem 2rem; }\n.session h1 { font-size: 1.25rem; overflow-wrap: anywhere; }\n.session h2 { margin: 0; fon\
t-size: .95rem; }\n.session .facts { display: flex; flex-wrap: wrap; gap: .35rem .5rem; align-items: center; margin: .3rem 0; }\n.session .scene { margin-right: .\
4rem; overflow-wrap: anywhere; }\n.chip.warn { color: var(--warn); }\n.session .chip { color: var(--soft); border-color: var(--line); white-space: normal; overflo\
w-wrap: anywhere; }\n.session .chip.fail { color: var(--bad); border-color: var(--bad); }\n.session .chip.warn { color: var(--warn); border-color: var(--warn); }\n\
.session .side { display: inline-block; min-width: 1.5em; margin-right: .35rem; padding: 0 .3rem; border-radius: .3rem; color: var(--paper);\n  text-align: cente\
r; font-size: .85em; font-weight: 600; }\n.session .side-a { background: var(--actual); } .session .side-b { background: var(--expected); }\n.notices p { margin: \
.2rem 0; padding: .3rem .7rem; border-left: .25rem solid var(--line); background: var(--panel); font-size: .88rem;\n  overflow-wrap: anywhere; }\n.notices p.warn \
{ border-color: var(--warn); }\n.notices p.fail { border-color: var(--bad); background: var(--bad-panel); }\n.session .trouble, .session .bad { color: var(--bad);\
 font-weight: 600; } .session .good { color: var(--good); font-weight: 600; }\n.work { display: grid; grid-template-columns: minmax(0, 1fr) minmax(17rem, 23rem);\
 gap: 1rem; margin-top: .6rem; align-items: start; }\n.shown { min-width: 0; }\n.session .view3d { height: min(50vh, 40rem); min-height: 18rem; border-radius: .6r\
em; background: radial-gradient(ellipse at 50% 30%, var(--stage-2), var(--stage)); }\n.view3d .tag { position: absolute; top: .5rem; left: .5rem; padding: .05rem\
 .55rem; border-radius: .3rem; background: var(--actual); color: var(--paper);\n  font-size: .82rem; font-weight: 600; pointer-events: none; }\n.view3d .tag + .ta\
g { left: auto; right: .5rem; background: var(--expected); }\n.view3d.halves .tag + .tag { left: calc(50% + .5rem); right: auto; }\n.view3d.halves::after { conten\
t: ""; position: absolute; top: 0; bottom: 0; left: 50%; width: 1px; background: var(--line); }\n.over-view { position: absolute; inset: auto 0 45%; margin: 0 au\
to; width: fit-content; max-width: 90%; padding: .6rem 1rem; border-radius: .4rem;\n  background: var(--bad-panel); color: var(--bad); font-weight: 600; }\n.over-\
view[hidden] { display: none; }\n.toolbar { display: flex; flex-wrap: wrap; gap: .4rem .5rem; align-items: center; margin-bottom: .5rem; font-size: .92rem; }\n.se\
ssion button, .session select, .session input[type="search"], .session input[type="number"] { padding: .22rem .65rem; border: 1px solid var(--line);\n  border-ra\
dius: .4rem; background: var(--panel); color: var(--ink); font: inherit; }\n.session button { cursor: pointer; }\n.session button:hover:not(:disabled) { border-co\
lor: var(--soft); }\n.session button:disabled { opacity: .5; cursor: default; }\n.session button[aria-pressed="true"] { border-color: var(--actual); color: var(--\
actual); font-weight: 600;\n  background: color-mix(in srgb, var(--actual) 12%, var(--panel)); }\n.session :focus-visible { outline: 3px solid #3b82f6; outline-of\
fset: 1px; }\n.session button.link { padding: 0; border: 0; background: none; color: var(--actual); text-decoration: underline; text-underline-offset: .15em; }\n.\
session button.jump { border-color: var(--bad); color: var(--bad); font-weight: 600; }\n.said { display: block; margin: .45rem 0; min-height: 1.5em; font-variant\
-numeric: tabular-nums; }\n.told { position: absolute; width: 1px; height: 1px; overflow: hidden; clip-path: inset(50%); white-space: nowrap; }\n.player { display\
: flex; flex-wrap: wrap; gap: .35rem; align-items: center; flex: 1 1 20rem; min-width: 0; }\n.player button { display: inline-grid; place-items: center; width: 2\
.3rem; height: 2.1rem; padding: 0; }\n.player .icon, .player .icon svg { display: block; width: 1.25rem; height: 1.25rem; }\n.player .play svg path, .player .back\
 svg path { fill: currentColor; }\n.player input[type="range"] { flex: 1 1 10rem; min-width: 6rem; accent-color: var(--actual); }\n.player .step { width: 6.5rem; \
text-align: right; font-variant-numeric: tabular-nums; }\n.timeline { position: relative; margin-top: .7rem; border: 1px solid var(--line); border-radius: .5rem;\
 background: var(--panel); overflow: hidden; touch-action: pan-y; }\n.lane { display: grid; grid-template-columns: 11.5rem minmax(0, 1fr); align-items: stretch; \
border-bottom: 1px solid var(--line); }\n.lane[hidden] { display: none; }\n.lane:last-of-type { border-bottom: 0; }\n.lane .label { display: flex; flex-direction: \
column; justify-content: center; padding: .1rem .6rem; min-width: 0; font-size: .76rem; line-height: 1.25; border-right: 1px solid var(--line); }\n.lane .label s\
pan:first-child { color: var(--soft); }\n.lane .value { overflow: hidden; text-overflow: ellipsis; white-space: nowrap; font-variant-numeric: tabular-nums; }\n.la\
ne canvas { display: block; width: 100%; cursor: col-resize; }\n.timeline .cursor { position: absolute; top: 0; bottom: 0; left: 0; width: 0; border-left: 1.5px \
solid var(--ink); pointer-events: none; }\naside { min-width: 0; font-size: .92rem; }\n.search-row { display: flex; gap: .3rem; }\n.search-row input { flex: 1; min\
-width: 0; }\n.search output { display: block; min-height: 1.5em; margin: .25rem 0; }\n.hits, .marks, ol.inputs { margin: 0 0 .5rem; padding-left: 1.1rem; }\n.hits\
 li.at { font-weight: 600; }\n.session details.panel { margin: 0 0 .6rem; background: var(--paper); }\n.session details.panel summary { padding: .4rem .75rem; }\n.\
panel .inside { padding: .4rem .75rem .6rem; overflow-wrap: anywhere; }\n.panel table { font-size: .86rem; }\n.panel caption { padding: .3rem 0; text-align: left;\
 color: var(--soft); }\n.panel th { font-weight: 400; } .panel thead th { color: var(--soft); }\n.phases th[scope], .pair th { white-space: nowrap; }\n.pair td { f\
ont-size: .85em; } .pair .differs :is(td, th[scope="row"]) { font-weight: 400; }\n.panel .pair tr:first-child :is(th[scope="row"], td) { padding-bottom: 0; borde\
r-bottom: 0; }\n.panel .pair tr + tr :is(th, td) { padding-top: 0; }\n.panel th, .panel td { padding: .15rem .4rem .15rem 0; vertical-align: baseline; }\ntr.differ\
s th, tr.differs td { color: var(--bad); font-weight: 600; } tr.differs button.link { color: inherit; }\nol.blame { margin: .3rem 0; padding-left: 1.3rem; } ol.b\
lame p { margin: .1rem 0; } .shares { padding-left: 1rem; color: var(--soft); }\n.actions { display: flex; gap: .4rem; flex-wrap: wrap; }\n.keys { display: grid; \
grid-template-columns: auto 1fr; gap: .15rem .8rem; margin: 0; font-size: .86rem; }\n.keys dd { margin: 0; } kbd { font: inherit; font-weight: 600; white-space: \
nowrap; }\n@media (max-width: 60rem) { .work { grid-template-columns: minmax(0, 1fr); } }\n@media (max-width: 44rem) {\n  body.session { padding: .6rem; }\n  .sessi\
on .view3d { height: 46vh; min-height: 14rem; }\n  .lane { grid-template-columns: 7.2rem minmax(0, 1fr); }\n  .session thead { position: static; } .session table \
{ display: table; } .session tbody { display: table-row-group; }\n  .session thead { display: table-header-group; } .session tr { display: table-row; }\n  .sessio\
n th, .session td, .session td.number { display: table-cell; padding: .15rem .4rem .15rem 0; border-bottom: 1px solid var(--line); }\n  .session td.number { text\
-align: right; }\n  .player button { width: 2.6rem; height: 2.5rem; }\n  .player input[type="range"] { flex-basis: 100%; order: 9; }\n}\n@media (prefers-reduced-mot\
ion: reduce) { * { scroll-behavior: auto; } }\n';var n_="uplot",i_="u-hz",s_="u-vt",r_="u-title",o_="u-wrap",a_="u-under",l_="u-over",c_="u-axis",Ks="u-off",h_="u-select",u_="u-cursor-x",d_="u-cursor-y",f_="u-\
cursor-pt",p_="u-legend",m_="u-live",g_="u-inline",__="u-series",x_="u-marker",uf="u-label",y_="u-value",Ao="width",Eo="height";var df="bottom",Sr="left",bh="right",Bh="#000",ff=Bh+"0",Mh="mousemove",pf="mousedown",Sh="mouseup",mf="mouseenter",gf="mouseleave",_f="dblclick",v_="resize",b_="\
scroll",xf="change",Fa="dppxchange",kh="--",Pr=typeof window<"u",Ch=Pr?document:null,Tr=Pr?window:null,M_=Pr?navigator:null,wt,La;function Rh(){let i=devicePixelRatio;
wt!=i&&(wt=i,La&&Ih(xf,La,Rh),La=matchMedia("(min-resolution: ".concat(wt-.001,"dppx) and (max-resolution: ").concat(wt+.001,"dppx)")),js(xf,La,Rh),Tr.dispatchEvent(
new CustomEvent(Fa)))}function Zn(i,e){if(e!=null){let t=i.classList;!t.contains(e)&&t.add(e)}}function Ph(i,e){let t=i.classList;t.contains(e)&&t.remove(e)}function zt(i,e,t){
i.style[e]=t+"px"}function gi(i,e,t,n){let s=Ch.createElement(i);return e!=null&&Zn(s,e),t?.insertBefore(s,n),s}function ai(i,e){return gi("div",i,e)}var yf=new WeakMap;
function Di(i,e,t,n,s){let r="translate("+e+"px,"+t+"px)",o=yf.get(i);r!=o&&(i.style.transform=r,yf.set(i,r),e<0||t<0||e>n||t>s?Zn(i,Ks):Ph(i,Ks))}var vf=new WeakMap;
function bf(i,e,t){let n=e+t,s=vf.get(i);n!=s&&(vf.set(i,n),i.style.background=e,i.style.borderColor=t)}var Mf=new WeakMap;function Sf(i,e,t,n){let s=e+""+t,r=Mf.
get(i);s!=r&&(Mf.set(i,s),i.style.height=t+"px",i.style.width=e+"px",i.style.marginLeft=n?-e/2+"px":0,i.style.marginTop=n?-t/2+"px":0)}var zh={passive:!0},S_={...zh,
capture:!0};function js(i,e,t,n){e.addEventListener(i,t,n?S_:zh)}function Ih(i,e,t,n){e.removeEventListener(i,t,zh)}Pr&&Rh();function _i(i,e,t,n){let s;t=t||0,n=
n||e.length-1;let r=n<=2147483647;for(;n-t>1;)s=r?t+n>>1:Jn((t+n)/2),e[s]<i?t=s:n=s;return i-e[t]<=e[n]-i?t:n}function Kf(i){return(t,n,s)=>{let r=-1,o=-1;for(let a=n;a<=
s;a++)if(i(t[a])){r=a;break}for(let a=s;a>=n;a--)if(i(t[a])){o=a;break}return[r,o]}}var jf=i=>i!=null,Qf=i=>i!=null&&i>0,ka=Kf(jf),w_=Kf(Qf);function T_(i,e,t,n=0,s=!1){
let r=s?w_:ka,o=s?Qf:jf;[e,t]=r(i,e,t);let a=i[e],l=i[e];if(e>-1)if(n==1)a=i[e],l=i[t];else if(n==-1)a=i[t],l=i[e];else for(let c=e;c<=t;c++){let d=i[c];o(d)&&(d<
a?a=d:d>l&&(l=d))}return[a??Nt,l??-Nt]}function za(i,e,t,n){let s=Af(i),r=Af(e);i==e&&(s==-1?(i*=t,e/=t):(i/=t,e*=t));let o=t==10?Ki:ep,a=s==1?Jn:li,l=r==1?li:Jn,
c=a(o(dn(i))),d=l(o(dn(e))),u=Ar(t,c),h=Ar(t,d);return t==10&&(c<0&&(u=Dt(u,-c)),d<0&&(h=Dt(h,-d))),n||t==2?(i=u*s,e=h*r):(i=sp(i,u),e=Va(e,h)),[i,e]}function Vh(i,e,t,n){
let s=za(i,e,t,n);return i==0&&(s[0]=0),e==0&&(s[1]=0),s}var Gh=.1,wf={mode:3,pad:Gh},Ro={pad:0,soft:null,mode:0},A_={min:Ro,max:Ro};function Oa(i,e,t,n){return Ga(
t)?Tf(i,e,t):(Ro.pad=t,Ro.soft=n?0:null,Ro.mode=n?3:0,Tf(i,e,A_))}function Mt(i,e){return i??e}function E_(i,e,t){for(e=Mt(e,0),t=Mt(t,i.length-1);e<=t;){if(i[e]!=
null)return!0;e++}return!1}function Tf(i,e,t){let n=t.min,s=t.max,r=Mt(n.pad,0),o=Mt(s.pad,0),a=Mt(n.hard,-Nt),l=Mt(s.hard,Nt),c=Mt(n.soft,Nt),d=Mt(s.soft,-Nt),
u=Mt(n.mode,0),h=Mt(s.mode,0),f=e-i,p=Ki(f),x=Fn(dn(i),dn(e)),m=Ki(x),g=dn(m-p);(f<1e-24||g>10)&&(f=0,(i==0||e==0)&&(f=1e-24,u==2&&c!=Nt&&(r=0),h==2&&d!=-Nt&&(o=
0)));let y=f||x||1e3,S=Ki(y),b=Ar(10,Jn(S)),C=y*(f==0?i==0?.1:1:r),w=Dt(sp(i-C,b/10),24),_=i>=c&&(u==1||u==3&&w<=c||u==2&&w>=c)?c:Nt,M=Fn(a,w<_&&i>=_?_:xi(_,w)),
R=y*(f==0?e==0?.1:1:o),P=Dt(Va(e+R,b/10),24),I=e<=d&&(h==1||h==3&&P>=d||h==2&&P<=d)?d:-Nt,F=xi(l,P>I&&e<=I?I:Fn(I,P));return M==F&&M==0&&(F=100),[M,F]}var C_=new Intl.
NumberFormat(Pr?M_.language:"en-US"),Hh=i=>C_.format(i),Kn=Math,Ua=Kn.PI,dn=Kn.abs,Jn=Kn.floor,un=Kn.round,li=Kn.ceil,xi=Kn.min,Fn=Kn.max,Ar=Kn.pow,Af=Kn.sign,Ki=Kn.
log10,ep=Kn.log2,R_=(i,e=1)=>Kn.sinh(i)*e,wh=(i,e=1)=>Kn.asinh(i/e),Nt=1/0;function Ef(i){return(Ki((i^i>>31)-(i>>31))|0)+1}function Lh(i,e,t){return xi(Fn(i,e),
t)}function tp(i){return typeof i=="function"}function gt(i){return tp(i)?i:()=>i}var P_=()=>{},np=i=>i,ip=(i,e)=>e,I_=i=>null,Cf=i=>!0,Rf=(i,e)=>i==e,L_=/\.\d*?(?=9{6,}|0{6,})/gm,
Qs=i=>{if(op(i)||Ts.has(i))return i;let e="".concat(i),t=e.match(L_);if(t==null)return i;let n=t[0].length-1;if(e.indexOf("e-")!=-1){let[s,r]=e.split("e");return+"".
concat(Qs(s),"e").concat(r)}return Dt(i,n)};function Zs(i,e){return Qs(Dt(Qs(i/e))*e)}function Va(i,e){return Qs(li(Qs(i/e))*e)}function sp(i,e){return Qs(Jn(Qs(
i/e))*e)}function Dt(i,e=0){if(op(i))return i;let t=10**e,n=i*t*(1+Number.EPSILON);return un(n)/t}var Ts=new Map;function rp(i){return((""+i).split(".")[1]||"").
length}function Io(i,e,t,n){let s=[],r=n.map(rp);for(let o=e;o<t;o++){let a=dn(o),l=Dt(Ar(i,o),a);for(let c=0;c<n.length;c++){let d=i==10?+"".concat(n[c],"e").concat(
o):n[c]*l,u=(o>=0?0:a)+(o>=r[c]?0:r[c]),h=i==10?d:Dt(d,u);s.push(h),Ts.set(h,u)}}return s}var Po={},Wh=[],Er=[null,null],ws=Array.isArray,op=Number.isInteger,N_=i=>i===
void 0;function Pf(i){return typeof i=="string"}function Ga(i){let e=!1;if(i!=null){let t=i.constructor;e=t==null||t==Object}return e}function D_(i){return i!=null&&
typeof i=="object"}var U_=Object.getPrototypeOf(Uint8Array),ap="__proto__";function Cr(i,e=Ga){let t;if(ws(i)){let n=i.find(s=>s!=null);if(ws(n)||e(n)){t=Array(
i.length);for(let s=0;s<i.length;s++)t[s]=Cr(i[s],e)}else t=i.slice()}else if(i instanceof U_)t=i.slice();else if(e(i)){t={};for(let n in i)n!=ap&&(t[n]=Cr(i[n],
e))}else t=i;return t}function on(i){let e=arguments;for(let t=1;t<e.length;t++){let n=e[t];for(let s in n)s!=ap&&(Ga(i[s])?on(i[s],Cr(n[s])):i[s]=Cr(n[s]))}return i}
var F_=0,O_=1,B_=2;function k_(i,e,t){for(let n=0,s,r=-1;n<e.length;n++){let o=e[n];if(o>r){for(s=o-1;s>=0&&i[s]==null;)i[s--]=null;for(s=o+1;s<t&&i[s]==null;)i[r=
s++]=null}}}function z_(i,e){if(H_(i)){let o=i[0].slice();for(let a=1;a<i.length;a++)o.push(...i[a].slice(1));return W_(o[0])||(o=G_(o)),o}let t=new Set;for(let o=0;o<
i.length;o++){let l=i[o][0],c=l.length;for(let d=0;d<c;d++)t.add(l[d])}let n=[Array.from(t).sort((o,a)=>o-a)],s=n[0].length,r=new Map;for(let o=0;o<s;o++)r.set(
n[0][o],o);for(let o=0;o<i.length;o++){let a=i[o],l=a[0];for(let c=1;c<a.length;c++){let d=a[c],u=Array(s).fill(void 0),h=e?e[o][c]:O_,f=[];for(let p=0;p<d.length;p++){
let x=d[p],m=r.get(l[p]);x===null?h!=F_&&(u[m]=x,h==B_&&f.push(m)):u[m]=x}k_(u,f,s),n.push(u)}}return n}var V_=typeof queueMicrotask>"u"?i=>Promise.resolve().then(
i):queueMicrotask;function G_(i){let e=i[0],t=e.length,n=Array(t);for(let r=0;r<n.length;r++)n[r]=r;n.sort((r,o)=>e[r]-e[o]);let s=[];for(let r=0;r<i.length;r++){
let o=i[r],a=Array(t);for(let l=0;l<t;l++)a[l]=o[n[l]];s.push(a)}return s}function H_(i){let e=i[0][0],t=e.length;for(let n=1;n<i.length;n++){let s=i[n][0];if(s.
length!=t)return!1;if(s!=e){for(let r=0;r<t;r++)if(s[r]!=e[r])return!1}}return!0}function W_(i,e=100){let t=i.length;if(t<=1)return!0;let n=0,s=t-1;for(;n<=s&&i[n]==
null;)n++;for(;s>=n&&i[s]==null;)s--;if(s<=n)return!0;let r=Fn(1,Jn((s-n+1)/e));for(let o=i[n],a=n+r;a<=s;a+=r){let l=i[a];if(l!=null){if(l<=o)return!1;o=l}}return!0}
var lp=["January","February","March","April","May","June","July","August","September","October","November","December"],cp=["Sunday","Monday","Tuesday","Wednesda\
y","Thursday","Friday","Saturday"];function hp(i){return i.slice(0,3)}var X_=cp.map(hp),$_=lp.map(hp),q_={MMMM:lp,MMM:$_,WWWW:cp,WWW:X_};function To(i){return(i<
10?"0":"")+i}function Y_(i){return(i<10?"00":i<100?"0":"")+i}var Z_={YYYY:i=>i.getFullYear(),YY:i=>(i.getFullYear()+"").slice(2),MMMM:(i,e)=>e.MMMM[i.getMonth()],
MMM:(i,e)=>e.MMM[i.getMonth()],MM:i=>To(i.getMonth()+1),M:i=>i.getMonth()+1,DD:i=>To(i.getDate()),D:i=>i.getDate(),WWWW:(i,e)=>e.WWWW[i.getDay()],WWW:(i,e)=>e.WWW[i.
getDay()],HH:i=>To(i.getHours()),H:i=>i.getHours(),h:i=>{let e=i.getHours();return e==0?12:e>12?e-12:e},AA:i=>i.getHours()>=12?"PM":"AM",aa:i=>i.getHours()>=12?
"pm":"am",a:i=>i.getHours()>=12?"p":"a",mm:i=>To(i.getMinutes()),m:i=>i.getMinutes(),ss:i=>To(i.getSeconds()),s:i=>i.getSeconds(),fff:i=>Y_(i.getMilliseconds())};
function Xh(i,e){e=e||q_;let t=[],n=/\{([a-z]+)\}|[^{]+/gi,s;for(;s=n.exec(i);)t.push(s[0][0]=="{"?Z_[s[1]]:s[0]);return r=>{let o="";for(let a=0;a<t.length;a++)
o+=typeof t[a]=="string"?t[a]:t[a](r,e);return o}}var J_=new Intl.DateTimeFormat().resolvedOptions().timeZone;function K_(i,e){let t;return e=="UTC"||e=="Etc/UT\
C"?t=new Date(+i+i.getTimezoneOffset()*6e4):e==J_?t=i:(t=new Date(i.toLocaleString("en-US",{timeZone:e})),t.setMilliseconds(i.getMilliseconds())),t}var up=i=>i%
1==0,Ba=[1,2,2.5,5],j_=Io(10,-32,0,Ba),dp=Io(10,0,32,Ba),Q_=dp.filter(up),Js=j_.concat(dp),$h="\n",fp="{YYYY}",If=$h+fp,pp="{M}/{D}",Co=$h+pp,Na=Co+"/{YY}",mp="\
{aa}",ex="{h}:{mm}",wr=ex+mp,Lf=$h+wr,Nf=":{ss}",Tt=null;function gp(i){let e=i*1e3,t=e*60,n=t*60,s=n*24,r=s*30,o=s*365,l=(i==1?Io(10,0,3,Ba).filter(up):Io(10,-3,
0,Ba)).concat([e,e*5,e*10,e*15,e*30,t,t*5,t*10,t*15,t*30,n,n*2,n*3,n*4,n*6,n*8,n*12,s,s*2,s*3,s*4,s*5,s*6,s*7,s*8,s*9,s*10,s*15,r,r*2,r*3,r*4,r*6,o,o*2,o*5,o*10,
o*25,o*50,o*100]),c=[[o,fp,Tt,Tt,Tt,Tt,Tt,Tt,1],[s*28,"{MMM}",If,Tt,Tt,Tt,Tt,Tt,1],[s,pp,If,Tt,Tt,Tt,Tt,Tt,1],[n,"{h}"+mp,Na,Tt,Co,Tt,Tt,Tt,1],[t,wr,Na,Tt,Co,Tt,
Tt,Tt,1],[e,Nf,Na+" "+wr,Tt,Co+" "+wr,Tt,Lf,Tt,1],[i,Nf+".{fff}",Na+" "+wr,Tt,Co+" "+wr,Tt,Lf,Tt,1]];function d(u){return(h,f,p,x,m,g)=>{let y=[],S=m>=o,b=m>=r&&
m<o,C=u(p),w=Dt(C*i,3),_=Th(C.getFullYear(),S?0:C.getMonth(),b||S?1:C.getDate()),M=Dt(_*i,3);if(b||S){let R=b?m/r:0,P=S?m/o:0,I=w==M?w:Dt(Th(_.getFullYear()+P,_.
getMonth()+R,1)*i,3),F=new Date(un(I/i)),z=F.getFullYear(),D=F.getMonth();for(let G=0;I<=x;G++){let Y=Th(z+P*G,D+R*G,1),W=Y-u(Dt(Y*i,3));I=Dt((+Y+W)*i,3),I<=x&&
y.push(I)}}else{let R=m>=s?s:m,P=Jn(p)-Jn(w),I=M+P+Va(w-M,R);y.push(I);let F=u(I),z=F.getHours()+F.getMinutes()/t+F.getSeconds()/n,D=m/n,G=h.axes[f]._space,Y=g/
G;for(;I=Dt(I+m,i==1?0:3),!(I>x);)if(D>1){let W=Jn(Dt(z+D,6))%24,Q=u(I).getHours()-W;Q>1&&(Q=-1),I-=Q*n,z=(z+D)%24;let se=y[y.length-1];Dt((I-se)/m,3)*Y>=.7&&y.
push(I)}else y.push(I)}return y}}return[l,c,d]}var[tx,nx,ix]=gp(1),[sx,rx,ox]=gp(.001);Io(2,-53,53,[1]);function Df(i,e){return i.map(t=>t.map((n,s)=>s==0||s==8||
n==null?n:e(s==1||t[8]==0?n:t[1]+n)))}function Uf(i,e){return(t,n,s,r,o)=>{let a=e.find(p=>o>=p[0])||e[e.length-1],l,c,d,u,h,f;return n.map(p=>{let x=i(p),m=x.getFullYear(),
g=x.getMonth(),y=x.getDate(),S=x.getHours(),b=x.getMinutes(),C=x.getSeconds(),w=m!=l&&a[2]||g!=c&&a[3]||y!=d&&a[4]||S!=u&&a[5]||b!=h&&a[6]||C!=f&&a[7]||a[1];return l=
m,c=g,d=y,u=S,h=b,f=C,w(x)})}}function ax(i,e){let t=Xh(e);return(n,s,r,o,a)=>s.map(l=>t(i(l)))}function Th(i,e,t){return new Date(i,e,t)}function Ff(i,e){return e(
i)}var lx="{YYYY}-{MM}-{DD} {h}:{mm}{aa}";function Of(i,e){return(t,n,s,r)=>r==null?kh:e(i(n))}function cx(i,e){let t=i.series[e];return t.width?t.stroke(i,e):t.
points.width?t.points.stroke(i,e):null}function hx(i,e){return i.series[e].fill(i,e)}var ux={show:!0,live:!0,isolate:!1,mount:P_,markers:{show:!0,width:2,stroke:cx,
fill:hx,dash:"solid"},idx:null,idxs:null,values:[]};function dx(i,e){let t=i.cursor.points,n=ai(),s=t.size(i,e);zt(n,Ao,s),zt(n,Eo,s);let r=s/-2;zt(n,"marginLef\
t",r),zt(n,"marginTop",r);let o=t.width(i,e,s);return o&&zt(n,"borderWidth",o),n}function fx(i,e){let t=i.series[e].points;return t._fill||t._stroke}function px(i,e){
let t=i.series[e].points;return t._stroke||t._fill}function mx(i,e){return i.series[e].points.size}var Ah=[0,0];function gx(i,e,t){return Ah[0]=e,Ah[1]=t,Ah}function Da(i,e,t,n=!0){
return s=>{s.button==0&&(!n||s.target==e)&&t(s)}}function Eh(i,e,t,n=!0){return s=>{(!n||s.target==e)&&t(s)}}var _x={show:!0,x:!0,y:!0,lock:!1,move:gx,points:{one:!1,
show:dx,size:mx,width:0,stroke:px,fill:fx},bind:{mousedown:Da,mouseup:Da,click:Da,dblclick:Da,mousemove:Eh,mouseleave:Eh,mouseenter:Eh},drag:{setScale:!0,x:!0,y:!1,
dist:0,uni:null,click:(i,e)=>{e.stopPropagation(),e.stopImmediatePropagation()},_x:!1,_y:!1},focus:{dist:(i,e,t,n,s)=>n-s,prox:-1,bias:0},hover:{skip:[void 0],prox:null,
bias:0},left:-10,top:-10,idx:null,dataIdx:null,idxs:null,event:null},_p={show:!0,stroke:"rgba(0,0,0,0.07)",width:2},qh=on({},_p,{filter:ip}),xp=on({},qh,{size:10}),
yp=on({},_p,{show:!1}),Yh='12px system-ui, -apple-system, "Segoe UI", Roboto, "Helvetica Neue", Arial, "Noto Sans", sans-serif, "Apple Color Emoji", "Segoe UI E\
moji", "Segoe UI Symbol", "Noto Color Emoji"',vp="bold "+Yh,bp=1.5,Bf={show:!0,scale:"x",stroke:Bh,space:50,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:vp,
side:2,grid:qh,ticks:xp,border:yp,font:Yh,lineGap:bp,rotate:0},xx="Value",yx="Time",kf={show:!0,scale:"x",auto:!1,sorted:1,min:Nt,max:-Nt,idxs:[]};function vx(i,e,t,n,s){
return e.map(r=>r==null?"":Hh(r))}function bx(i,e,t,n,s,r,o){let a=[],l=Ts.get(s)||0;t=o?t:Dt(Va(t,s),l);for(let c=t;c<=n;c=Dt(c+s,l))a.push(Object.is(c,-0)?0:c);
return a}function Nh(i,e,t,n,s,r,o){let a=[],l=i.scales[i.axes[e].scale].log,c=l==10?Ki:ep,d=Jn(c(t));s=Ar(l,d),l==10&&(s=Js[_i(s,Js)]);let u=t,h=s*l;l==10&&(h=
Js[_i(h,Js)]);do a.push(u),u=u+s,l==10&&!Ts.has(u)&&(u=Dt(u,Ts.get(s))),u>=h&&(s=u,h=s*l,l==10&&(h=Js[_i(h,Js)]));while(u<=n);return a}function Mx(i,e,t,n,s,r,o){
let l=i.scales[i.axes[e].scale].asinh,c=n>l?Nh(i,e,Fn(l,t),n,s):[l],d=n>=0&&t<=0?[0]:[];return(t<-l?Nh(i,e,Fn(l,-n),-t,s):[l]).reverse().map(h=>-h).concat(d,c)}
var Mp=/./,Sx=/[12357]/,wx=/[125]/,zf=/1/,Dh=(i,e,t,n)=>i.map((s,r)=>e==4&&s==0||r%n==0&&t.test(s.toExponential()[s<0?1:0])?s:null);function Tx(i,e,t,n,s){let r=i.
axes[t],o=r.scale,a=i.scales[o],l=i.valToPos,c=r._space,d=l(10,o),u=l(9,o)-d>=c?Mp:l(7,o)-d>=c?Sx:l(5,o)-d>=c?wx:zf;if(u==zf){let h=dn(l(1,o)-d);if(h<c)return Dh(
e.slice().reverse(),a.distr,u,li(c/h)).reverse()}return Dh(e,a.distr,u,1)}function Ax(i,e,t,n,s){let r=i.axes[t],o=r.scale,a=r._space,l=i.valToPos,c=dn(l(1,o)-l(
2,o));return c<a?Dh(e.slice().reverse(),3,Mp,li(a/c)).reverse():e}function Ex(i,e,t,n){return n==null?kh:e==null?"":Hh(e)}var Vf={show:!0,scale:"y",stroke:Bh,space:30,
gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:vp,side:3,grid:qh,ticks:xp,border:yp,font:Yh,lineGap:bp,rotate:0};function Cx(i,e){let t=3+(i||1)*2;return Dt(
t*e,3)}function Rx(i,e){let{scale:t,idxs:n}=i.series[0],s=i._data[0],r=i.valToPos(s[n[0]],t,!0),o=i.valToPos(s[n[1]],t,!0),a=dn(o-r),l=i.series[e],c=a/(l.points.
space*wt);return n[1]-n[0]<=c}var Gf={scale:null,auto:!0,sorted:0,min:Nt,max:-Nt},Sp=(i,e,t,n,s)=>s,Hf={show:!0,auto:!0,sorted:0,gaps:Sp,alpha:1,facets:[on({},Gf,
{scale:"x"}),on({},Gf,{scale:"y"})]},Wf={scale:"y",auto:!0,sorted:0,show:!0,spanGaps:!1,gaps:Sp,alpha:1,points:{show:Rx,filter:null},values:null,min:Nt,max:-Nt,
idxs:[],path:null,clip:null};function Px(i,e,t,n,s){return t/10}var wp={time:!0,auto:!0,distr:1,log:10,asinh:1,min:null,max:null,dir:1,ori:0},Ix=on({},wp,{time:!1,
ori:1}),Xf={};function Tp(i,e){let t=Xf[i];return t||(t={key:i,plots:[],sub(n){t.plots.push(n)},unsub(n){t.plots=t.plots.filter(s=>s!=n)},pub(n,s,r,o,a,l,c){for(let d=0;d<
t.plots.length;d++)t.plots[d]!=s&&t.plots[d].pub(n,s,r,o,a,l,c)}},i!=null&&(Xf[i]=t)),t}var Rr=1,Uh=2;function er(i,e,t){let n=i.mode,s=i.series[e],r=n==2?i._data[e]:
i._data,o=i.scales,a=i.bbox,l=r[0],c=n==2?r[1]:r[e],d=n==2?o[s.facets[0].scale]:o[i.series[0].scale],u=n==2?o[s.facets[1].scale]:o[s.scale],h=a.left,f=a.top,p=a.
width,x=a.height,m=i.valToPosH,g=i.valToPosV;return d.ori==0?t(s,l,c,d,u,m,g,h,f,p,x,Wa,Ir,$a,Ep,Rp):t(s,l,c,d,u,g,m,f,h,x,p,Xa,Lr,Kh,Cp,Pp)}function Zh(i,e){let t=0,
n=0,s=Mt(i.bands,Wh);for(let r=0;r<s.length;r++){let o=s[r];o.series[0]==e?t=o.dir:o.series[1]==e&&(o.dir==1?n|=1:n|=2)}return[t,n==1?-1:n==2?1:n==3?2:0]}function Lx(i,e,t,n,s){
let r=i.mode,o=i.series[e],a=r==2?o.facets[1].scale:o.scale,l=i.scales[a];return s==-1?l.min:s==1?l.max:l.distr==3?l.dir==1?l.min:l.max:0}function ji(i,e,t,n,s,r){
return er(i,e,(o,a,l,c,d,u,h,f,p,x,m)=>{let g=o.pxRound,y=c.dir*(c.ori==0?1:-1),S=c.ori==0?Ir:Lr,b,C;y==1?(b=t,C=n):(b=n,C=t);let w=g(u(a[b],c,x,f)),_=g(h(l[b],
d,m,p)),M=g(u(a[C],c,x,f)),R=g(h(r==1?d.max:d.min,d,m,p)),P=new Path2D(s);return S(P,M,R),S(P,w,R),S(P,w,_),P})}function Ha(i,e,t,n,s,r){let o=null;if(i.length>
0){o=new Path2D;let a=e==0?$a:Kh,l=t;for(let u=0;u<i.length;u++){let h=i[u];if(h[1]>h[0]){let f=h[0]-l;f>0&&a(o,l,n,f,n+r),l=h[1]}}let c=t+s-l,d=10;c>0&&a(o,l,n-
d/2,c,n+r+d)}return o}function Nx(i,e,t){let n=i[i.length-1];n&&n[0]==e?n[1]=t:i.push([e,t])}function Jh(i,e,t,n,s,r,o){let a=[],l=i.length;for(let c=s==1?t:n;c>=
t&&c<=n;c+=s)if(e[c]===null){let u=c,h=c;if(s==1)for(;++c<=n&&e[c]===null;)h=c;else for(;--c>=t&&e[c]===null;)h=c;let f=r(i[u]),p=h==u?f:r(i[h]),x=u-s;f=o<=0&&x>=
0&&x<l?r(i[x]):f;let g=h+s;p=o>=0&&g>=0&&g<l?r(i[g]):p,p>=f&&a.push([f,p])}return a}function $f(i){return i==0?np:i==1?un:e=>Zs(e,i)}function Ap(i){let e=i==0?Wa:
Xa,t=i==0?(s,r,o,a,l,c)=>{s.arcTo(r,o,a,l,c)}:(s,r,o,a,l,c)=>{s.arcTo(o,r,l,a,c)},n=i==0?(s,r,o,a,l)=>{s.rect(r,o,a,l)}:(s,r,o,a,l)=>{s.rect(o,r,l,a)};return(s,r,o,a,l,c=0,d=0)=>{
c==0&&d==0?n(s,r,o,a,l):(c=xi(c,a/2,l/2),d=xi(d,a/2,l/2),e(s,r+c,o),t(s,r+a,o,r+a,o+l,c),t(s,r+a,o+l,r,o+l,d),t(s,r,o+l,r,o,d),t(s,r,o,r+a,o,c),s.closePath())}}
var Wa=(i,e,t)=>{i.moveTo(e,t)},Xa=(i,e,t)=>{i.moveTo(t,e)},Ir=(i,e,t)=>{i.lineTo(e,t)},Lr=(i,e,t)=>{i.lineTo(t,e)},$a=Ap(0),Kh=Ap(1),Ep=(i,e,t,n,s,r)=>{i.arc(e,
t,n,s,r)},Cp=(i,e,t,n,s,r)=>{i.arc(t,e,n,s,r)},Rp=(i,e,t,n,s,r,o)=>{i.bezierCurveTo(e,t,n,s,r,o)},Pp=(i,e,t,n,s,r,o)=>{i.bezierCurveTo(t,e,s,n,o,r)};function Ip(i){
return(e,t,n,s,r)=>er(e,t,(o,a,l,c,d,u,h,f,p,x,m)=>{let{pxRound:g,points:y}=o,S,b;c.ori==0?(S=Wa,b=Ep):(S=Xa,b=Cp);let C=Dt(y.width*wt,3),w=(y.size-y.width)/2*wt,
_=Dt(w*2,3),M=new Path2D,R=new Path2D,{left:P,top:I,width:F,height:z}=e.bbox;$a(R,P-_,I-_,F+_*2,z+_*2);let D=G=>{if(l[G]!=null){let Y=g(u(a[G],c,x,f)),W=g(h(l[G],
d,m,p));S(M,Y+w,W),b(M,Y,W,w,0,Ua*2)}};if(r)r.forEach(D);else for(let G=n;G<=s;G++)D(G);return{stroke:C>0?M:null,fill:M,clip:R,flags:Rr|Uh}})}function Lp(i){return(e,t,n,s,r,o)=>{
n!=s&&(r!=n&&o!=n&&i(e,t,n),r!=s&&o!=s&&i(e,t,s),i(e,t,o))}}var Dx=Lp(Ir),Ux=Lp(Lr);function Np(i){let e=Mt(i?.alignGaps,0);return(t,n,s,r)=>er(t,n,(o,a,l,c,d,u,h,f,p,x,m)=>{
[s,r]=ka(l,s,r);let g=o.pxRound,y=z=>g(u(z,c,x,f)),S=z=>g(h(z,d,m,p)),b,C;c.ori==0?(b=Ir,C=Dx):(b=Lr,C=Ux);let w=c.dir*(c.ori==0?1:-1),_={stroke:new Path2D,fill:null,
clip:null,band:null,gaps:null,flags:Rr},M=_.stroke,R=!1;if(r-s>=x*4){let z=ue=>t.posToVal(ue,c.key,!0),D=null,G=null,Y,W,ce,K=y(a[w==1?s:r]),Q=y(a[s]),se=y(a[r]),
de=z(w==1?Q+1:se-1);for(let ue=w==1?s:r;ue>=s&&ue<=r;ue+=w){let ee=a[ue],xe=(w==1?ee<de:ee>de)?K:y(ee),Ee=l[ue];xe==K?Ee!=null?(W=Ee,D==null?(b(M,xe,S(W)),Y=D=G=
W):W<D?D=W:W>G&&(G=W)):Ee===null&&(R=!0):(D!=null&&C(M,K,S(D),S(G),S(Y),S(W)),Ee!=null?(W=Ee,b(M,xe,S(W)),D=G=Y=W):(D=G=null,Ee===null&&(R=!0)),K=xe,de=z(K+w))}
D!=null&&D!=G&&ce!=K&&C(M,K,S(D),S(G),S(Y),S(W))}else for(let z=w==1?s:r;z>=s&&z<=r;z+=w){let D=l[z];D===null?R=!0:D!=null&&b(M,y(a[z]),S(D))}let[I,F]=Zh(t,n);if(o.
fill!=null||I!=0){let z=_.fill=new Path2D(M),D=o.fillTo(t,n,o.min,o.max,I),G=S(D),Y=y(a[s]),W=y(a[r]);w==-1&&([W,Y]=[Y,W]),b(z,W,G),b(z,Y,G)}if(!o.spanGaps){let z=[];
R&&z.push(...Jh(a,l,s,r,w,y,e)),_.gaps=z=o.gaps(t,n,s,r,z),_.clip=Ha(z,c.ori,f,p,x,m)}return F!=0&&(_.band=F==2?[ji(t,n,s,r,M,-1),ji(t,n,s,r,M,1)]:ji(t,n,s,r,M,
F)),_})}function Fx(i){let e=Mt(i.align,1),t=Mt(i.ascDesc,!1),n=Mt(i.alignGaps,0),s=Mt(i.extend,!1);return(r,o,a,l)=>er(r,o,(c,d,u,h,f,p,x,m,g,y,S)=>{[a,l]=ka(u,
a,l);let b=c.pxRound,{left:C,width:w}=r.bbox,_=Q=>b(p(Q,h,y,m)),M=Q=>b(x(Q,f,S,g)),R=h.ori==0?Ir:Lr,P={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,
flags:Rr},I=P.stroke,F=h.dir*(h.ori==0?1:-1),z=M(u[F==1?a:l]),D=_(d[F==1?a:l]),G=D,Y=D;s&&e==-1&&(Y=C,R(I,Y,z)),R(I,D,z);for(let Q=F==1?a:l;Q>=a&&Q<=l;Q+=F){let se=u[Q];
if(se==null)continue;let de=_(d[Q]),ue=M(se);e==1?R(I,de,z):R(I,G,ue),R(I,de,ue),z=ue,G=de}let W=G;s&&e==1&&(W=C+w,R(I,W,z));let[ce,K]=Zh(r,o);if(c.fill!=null||
ce!=0){let Q=P.fill=new Path2D(I),se=c.fillTo(r,o,c.min,c.max,ce),de=M(se);R(Q,W,de),R(Q,Y,de)}if(!c.spanGaps){let Q=[];Q.push(...Jh(d,u,a,l,F,_,n));let se=c.width*
wt/2,de=t||e==1?se:-se,ue=t||e==-1?-se:se;Q.forEach(ee=>{ee[0]+=de,ee[1]+=ue}),P.gaps=Q=c.gaps(r,o,a,l,Q),P.clip=Ha(Q,h.ori,m,g,y,S)}return K!=0&&(P.band=K==2?[
ji(r,o,a,l,I,-1),ji(r,o,a,l,I,1)]:ji(r,o,a,l,I,K)),P})}function qf(i,e,t,n,s,r,o=Nt){if(i.length>1){let a=null;for(let l=0,c=1/0;l<i.length;l++)if(e[l]!==void 0){
if(a!=null){let d=dn(i[l]-i[a]);d<c&&(c=d,o=dn(t(i[l],n,s,r)-t(i[a],n,s,r)))}a=l}}return o}function Ox(i){i=i||Po;let e=Mt(i.size,[.6,Nt,1]),t=i.align||0,n=i.gap||
0,s=i.radius;s=s==null?[0,0]:typeof s=="number"?[s,0]:s;let r=gt(s),o=1-e[0],a=Mt(e[1],Nt),l=Mt(e[2],1),c=Mt(i.disp,Po),d=Mt(i.each,f=>{}),{fill:u,stroke:h}=c;return(f,p,x,m)=>er(
f,p,(g,y,S,b,C,w,_,M,R,P,I)=>{let F=g.pxRound,z=t,D=n*wt,G=a*wt,Y=l*wt,W,ce;b.ori==0?[W,ce]=r(f,p):[ce,W]=r(f,p);let K=b.dir*(b.ori==0?1:-1),Q=b.ori==0?$a:Kh,se=b.
ori==0?d:(Re,$e,it,Se,Lt,ze,Xe)=>{d(Re,$e,it,Lt,Se,Xe,ze)},de=Mt(f.bands,Wh).find(Re=>Re.series[0]==p),ue=de!=null?de.dir:0,ee=g.fillTo(f,p,g.min,g.max,ue),me=F(
_(ee,C,I,R)),xe,Ee,Me,He=P,nt=F(g.width*wt),Ve=!1,ut=null,lt=null,et=null,Gt=null;u!=null&&(nt==0||h!=null)&&(Ve=!0,ut=u.values(f,p,x,m),lt=new Map,new Set(ut).
forEach(Re=>{Re!=null&&lt.set(Re,new Path2D)}),nt>0&&(et=h.values(f,p,x,m),Gt=new Map,new Set(et).forEach(Re=>{Re!=null&&Gt.set(Re,new Path2D)})));let{x0:Ut,size:Qt}=c;
if(Ut!=null&&Qt!=null){z=1,y=Ut.values(f,p,x,m),Ut.unit==2&&(y=y.map(it=>f.posToVal(M+it*P,b.key,!0)));let Re=Qt.values(f,p,x,m);Qt.unit==2?Ee=Re[0]*P:Ee=w(Re[0],
b,P,M)-w(0,b,P,M),He=qf(y,S,w,b,P,M,He),Me=He-Ee+D}else He=qf(y,S,w,b,P,M,He),Me=He*o+D,Ee=He-Me;Me<1&&(Me=0),nt>=Ee/2&&(nt=0),Me<5&&(F=np);let Pt=Me>0,gn=He-Me-
(Pt?nt:0);Ee=F(Lh(gn,Y,G)),xe=(z==0?Ee/2:z==K?0:Ee)-z*K*((z==0?D/2:0)+(Pt?nt/2:0));let vt={stroke:null,fill:null,clip:null,band:null,gaps:null,flags:0},cn=Ve?null:
new Path2D,$t=null;if(de!=null)$t=f.data[de.series[1]];else{let{y0:Re,y1:$e}=c;Re!=null&&$e!=null&&(S=$e.values(f,p,x,m),$t=Re.values(f,p,x,m))}let en=W*Ee,B=ce*
Ee;for(let Re=K==1?x:m;Re>=x&&Re<=m;Re+=K){let $e=S[Re];if($e==null)continue;if($t!=null){let $=$t[Re]??0;if($e-$==0)continue;me=_($,C,I,R)}let it=b.distr!=2||c!=
null?y[Re]:Re,Se=w(it,b,P,M),Lt=_(Mt($e,ee),C,I,R),ze=F(Se-xe),Xe=F(Fn(Lt,me)),L=F(xi(Lt,me)),T=Xe-L;if($e!=null){let $=$e<0?B:en,he=$e<0?en:B;Ve?(nt>0&&et[Re]!=
null&&Q(Gt.get(et[Re]),ze,L+Jn(nt/2),Ee,Fn(0,T-nt),$,he),ut[Re]!=null&&Q(lt.get(ut[Re]),ze,L+Jn(nt/2),Ee,Fn(0,T-nt),$,he)):Q(cn,ze,L+Jn(nt/2),Ee,Fn(0,T-nt),$,he),
se(f,p,Re,ze-nt/2,L,Ee+nt,T)}}return nt>0?vt.stroke=Ve?Gt:cn:Ve||(vt._fill=g.width==0?g._fill:g._stroke??g._fill,vt.width=0),vt.fill=Ve?lt:cn,vt})}function Bx(i,e){
let t=Mt(e?.alignGaps,0);return(n,s,r,o)=>er(n,s,(a,l,c,d,u,h,f,p,x,m,g)=>{[r,o]=ka(c,r,o);let y=a.pxRound,S=W=>y(h(W,d,m,p)),b=W=>y(f(W,u,g,x)),C,w,_;d.ori==0?
(C=Wa,_=Ir,w=Rp):(C=Xa,_=Lr,w=Pp);let M=d.dir*(d.ori==0?1:-1),R=S(l[M==1?r:o]),P=R,I=[],F=[];for(let W=M==1?r:o;W>=r&&W<=o;W+=M)if(c[W]!=null){let K=l[W],Q=S(K);
I.push(P=Q),F.push(b(c[W]))}let z={stroke:i(I,F,C,_,w,y),fill:null,clip:null,band:null,gaps:null,flags:Rr},D=z.stroke,[G,Y]=Zh(n,s);if(a.fill!=null||G!=0){let W=z.
fill=new Path2D(D),ce=a.fillTo(n,s,a.min,a.max,G),K=b(ce);_(W,P,K),_(W,R,K)}if(!a.spanGaps){let W=[];W.push(...Jh(l,c,r,o,M,S,t)),z.gaps=W=a.gaps(n,s,r,o,W),z.clip=
Ha(W,d.ori,p,x,m,g)}return Y!=0&&(z.band=Y==2?[ji(n,s,r,o,D,-1),ji(n,s,r,o,D,1)]:ji(n,s,r,o,D,Y)),z})}function kx(i){return Bx(zx,i)}function zx(i,e,t,n,s,r){let o=i.
length;if(o<2)return null;let a=new Path2D;if(t(a,i[0],e[0]),o==2)n(a,i[1],e[1]);else{let l=Array(o),c=Array(o-1),d=Array(o-1),u=Array(o-1);for(let h=0;h<o-1;h++)
d[h]=e[h+1]-e[h],u[h]=i[h+1]-i[h],c[h]=d[h]/u[h];l[0]=c[0];for(let h=1;h<o-1;h++)c[h]===0||c[h-1]===0||c[h-1]>0!=c[h]>0?l[h]=0:(l[h]=3*(u[h-1]+u[h])/((2*u[h]+u[h-
1])/c[h-1]+(u[h]+2*u[h-1])/c[h]),isFinite(l[h])||(l[h]=0));l[o-1]=c[o-2];for(let h=0;h<o-1;h++)s(a,i[h]+u[h]/3,e[h]+l[h]*u[h]/3,i[h+1]-u[h]/3,e[h+1]-l[h+1]*u[h]/
3,i[h+1],e[h+1])}return a}var Fh=new Set;function Yf(){for(let i of Fh)i.syncRect(!0)}Pr&&(js(v_,Tr,Yf),js(b_,Tr,Yf,!0),js(Fa,Tr,()=>{fn.pxRatio=wt}));var Vx=Np(),
Gx=Ip();function Zf(i,e,t,n){return(n?[i[0],i[1]].concat(i.slice(2)):[i[0]].concat(i.slice(1))).map((r,o)=>Oh(r,o,e,t))}function Hx(i,e){return i.map((t,n)=>n==
0?{}:on({},e,t))}function Oh(i,e,t,n){return on({},e==0?t:n,i)}function Dp(i,e,t){return e==null?Er:[e,t]}var Wx=Dp;function Xx(i,e,t){return e==null?Er:Oa(e,t,
Gh,!0)}function Up(i,e,t,n){return e==null?Er:za(e,t,i.scales[n].log,!1)}var $x=Up;function Fp(i,e,t,n){return e==null?Er:Vh(e,t,i.scales[n].log,!1)}var qx=Fp;function Yx(i,e,t,n,s){
let r=Fn(Ef(i),Ef(e)),o=e-i,a=_i(s/n*o,t);do{let l=t[a],c=n*l/o;if(c>=s&&r+(l<5?Ts.get(l):0)<=17)return[l,c]}while(++a<t.length);return[0,0]}function Jf(i){let e,
t;return i=i.replace(/(\d+)px/,(n,s)=>(e=un((t=+s)*wt))+"px"),[i,e,t]}function Zx(i){i.show&&[i.font,i.labelFont].forEach(e=>{let t=Dt(e[2]*wt,1);e[0]=e[0].replace(
/[0-9.]+px/,t+"px"),e[1]=t})}function fn(i,e,t){let n={mode:Mt(i.mode,1)},s=n.mode;function r(v,A,N,U){let H=A.valToPct(v);return U+N*(A.dir==-1?1-H:H)}function o(v,A,N,U){
let H=A.valToPct(v);return U+N*(A.dir==-1?H:1-H)}function a(v,A,N,U){return A.ori==0?r(v,A,N,U):o(v,A,N,U)}n.valToPosH=r,n.valToPosV=o;let l=!1;n.status=0;let c=n.
root=ai(n_);if(i.id!=null&&(c.id=i.id),Zn(c,i.class),i.title){let v=ai(r_,c);v.textContent=i.title}let d=gi("canvas"),u=n.ctx=d.getContext("2d"),h=ai(o_,c);js("\
click",h,v=>{v.target===p&&(Ot!=xr||Ht!=yr)&&Sn.click(n,v)},!0);let f=n.under=ai(a_,h);h.appendChild(d);let p=n.over=ai(l_,h);i=Cr(i);let x=+Mt(i.pxAlign,1),m=$f(
x);(i.plugins||[]).forEach(v=>{v.opts&&(i=v.opts(n,i)||i)});let g=i.ms||.001,y=n.series=s==1?Zf(i.series||[],kf,Wf,!1):Hx(i.series||[null],Hf),S=n.axes=Zf(i.axes||
[],Bf,Vf,!0),b=n.scales={},C=n.bands=i.bands||[];C.forEach(v=>{v.fill=gt(v.fill||null),v.dir=Mt(v.dir,-1)});let w=s==2?y[1].facets[0].scale:y[0].scale,_={axes:Zi,
series:ft},M=(i.drawOrder||["axes","series"]).map(v=>_[v]);function R(v){let A=v.distr==3?N=>Ki(N>0?N:v.clamp(n,N,v.min,v.max,v.key)):v.distr==4?N=>wh(N,v.asinh):
v.distr==100?N=>v.fwd(N):N=>N;return N=>{let U=A(N),{_min:H,_max:J}=v,ae=J-H;return(U-H)/ae}}function P(v){let A=b[v];if(A==null){let N=(i.scales||Po)[v]||Po;if(N.
from!=null){P(N.from);let U=on({},b[N.from],N,{key:v});U.valToPct=R(U),b[v]=U}else{A=b[v]=on({},v==w?wp:Ix,N),A.key=v;let U=A.time,H=A.range,J=ws(H);if((v!=w||s==
2&&!U)&&(J&&(H[0]==null||H[1]==null)&&(H={min:H[0]==null?wf:{mode:1,hard:H[0],soft:H[0]},max:H[1]==null?wf:{mode:1,hard:H[1],soft:H[1]}},J=!1),!J&&Ga(H))){let ae=H;
H=(fe,ve,Ne)=>ve==null?Er:Oa(ve,Ne,ae)}A.range=gt(H||(U?Wx:v==w?A.distr==3?$x:A.distr==4?qx:Dp:A.distr==3?Up:A.distr==4?Fp:Xx)),A.auto=gt(J?!1:A.auto),A.clamp=gt(
A.clamp||Px),A._min=A._max=null,A.valToPct=R(A)}}}P("x"),P("y"),s==1&&y.forEach(v=>{P(v.scale)}),S.forEach(v=>{P(v.scale)});for(let v in i.scales)P(v);let I=b[w],
F=I.distr,z,D;I.ori==0?(Zn(c,i_),z=r,D=o):(Zn(c,s_),z=o,D=r);let G={};for(let v in b){let A=b[v];(A.min!=null||A.max!=null)&&(G[v]={min:A.min,max:A.max},A.min=A.
max=null)}let Y=i.tzDate||(v=>new Date(un(v/g))),W=i.fmtDate||Xh,ce=g==1?ix(Y):ox(Y),K=Uf(Y,Df(g==1?nx:rx,W)),Q=Of(Y,Ff(lx,W)),se=[],de=n.legend=on({},ux,i.legend),
ue=n.cursor=on({},_x,{drag:{y:s==2}},i.cursor),ee=de.show,me=ue.show,xe=de.markers;de.idxs=se,xe.width=gt(xe.width),xe.dash=gt(xe.dash),xe.stroke=gt(xe.stroke),
xe.fill=gt(xe.fill);let Ee,Me,He,nt=[],Ve=[],ut,lt=!1,et={};if(de.live){let v=y[1]?y[1].values:null;lt=v!=null,ut=lt?v(n,1,0):{_:0};for(let A in ut)et[A]=kh}if(ee)
if(Ee=gi("table",p_,c),He=gi("tbody",null,Ee),de.mount(n,Ee),lt){Me=gi("thead",null,Ee,He);let v=gi("tr",null,Me);gi("th",null,v);for(var Gt in ut)gi("th",uf,v).
textContent=Gt}else Zn(Ee,g_),de.live&&Zn(Ee,m_);let Ut={show:!0},Qt={show:!1};function Pt(v,A){if(A==0&&(lt||!de.live||s==2))return Er;let N=[],U=gi("tr",__,He,
He.childNodes[A]);Zn(U,v.class),v.show||Zn(U,Ks);let H=gi("th",null,U);if(xe.show){let fe=ai(x_,H);if(A>0){let ve=xe.width(n,A);ve&&(fe.style.border=ve+"px "+xe.
dash(n,A)+" "+xe.stroke(n,A)),fe.style.background=xe.fill(n,A)}}let J=ai(uf,H);v.label instanceof HTMLElement?J.appendChild(v.label):J.textContent=v.label,A>0&&
(xe.show||(J.style.color=v.width>0?xe.stroke(n,A):xe.fill(n,A)),vt("click",H,fe=>{if(ue._lock)return;Ze(fe);let ve=y.indexOf(v);if((fe.ctrlKey||fe.metaKey)!=de.
isolate){let Ne=y.some((De,Fe)=>Fe>0&&Fe!=ve&&De.show);y.forEach((De,Fe)=>{Fe>0&&Pi(Fe,Ne?Fe==ve?Ut:Qt:Ut,!0,rn.setSeries)})}else Pi(ve,{show:!v.show},!0,rn.setSeries)},
!1),Je&&vt(mf,H,fe=>{ue._lock||(Ze(fe),Pi(y.indexOf(v),br,!0,rn.setSeries))},!1));for(var ae in ut){let fe=gi("td",y_,U);fe.textContent="--",N.push(fe)}return[U,
N]}let gn=new Map;function vt(v,A,N,U=!0){let H=gn.get(A)||{},J=ue.bind[v](n,A,N,U);J&&(js(v,A,H[v]=J),gn.set(A,H))}function cn(v,A,N){let U=gn.get(A)||{};for(let H in U)
(v==null||H==v)&&(Ih(H,A,U[H]),delete U[H]);v==null&&gn.delete(A)}let $t=0,en=0,B=0,Re=0,$e=0,it=0,Se=$e,Lt=it,ze=B,Xe=Re,L=0,T=0,$=0,he=0;n.bbox={};let oe=!1,_e=!1,
ye=!1,te=!1,ie=!1,pe=!1;function O(v,A,N){(N||v!=n.width||A!=n.height)&&re(v,A),ct(!1),ye=!0,_e=!0,Tn()}function re(v,A){n.width=$t=B=v,n.height=en=Re=A,$e=it=0,
be(),Ge();let N=n.bbox;L=N.left=Zs($e*wt,.5),T=N.top=Zs(it*wt,.5),$=N.width=Zs(B*wt,.5),he=N.height=Zs(Re*wt,.5)}let ne=3;function we(){let v=!1,A=0;for(;!v;){A++;
let N=mr(A),U=Ri(A);v=A==ne||N&&U,v||(re(n.width,n.height),_e=!0)}}function ge({width:v,height:A}){O(v,A)}n.setSize=ge;function be(){let v=!1,A=!1,N=!1,U=!1;S.forEach(
(H,J)=>{if(H.show&&H._show){let{side:ae,_size:fe}=H,ve=ae%2,Ne=H.label!=null?H.labelSize:0,De=fe+Ne;De>0&&(ve?(B-=De,ae==3?($e+=De,U=!0):N=!0):(Re-=De,ae==0?(it+=
De,v=!0):A=!0))}}),Ei[0]=v,Ei[1]=N,Ei[2]=A,Ei[3]=U,B-=fi[1]+fi[3],$e+=fi[3],Re-=fi[2]+fi[0],it+=fi[0]}function Ge(){let v=$e+B,A=it+Re,N=$e,U=it;function H(J,ae){
switch(J){case 1:return v+=ae,v-ae;case 2:return A+=ae,A-ae;case 3:return N-=ae,N+ae;case 0:return U-=ae,U+ae}}S.forEach((J,ae)=>{if(J.show&&J._show){let fe=J.side;
J._pos=H(fe,J._size),J.label!=null&&(J._lpos=H(fe,J.labelSize))}})}if(ue.dataIdx==null){let v=ue.hover,A=v.skip=new Set(v.skip??[]);A.add(void 0);let N=v.prox=gt(
v.prox),U=v.bias??=0;ue.dataIdx=(H,J,ae,fe)=>{if(J==0)return ae;let ve=ae,Ne=N(H,J,ae,fe)??Nt,De=Ne>=0&&Ne<Nt,Fe=I.ori==0?B:Re,tt=ue.left,St=e[0],bt=e[J];if(A.has(
bt[ae])){ve=null;let pt=null,Ye=null,We;if(U==0||U==-1)for(We=ae;pt==null&&We-- >0;)A.has(bt[We])||(pt=We);if(U==0||U==1)for(We=ae;Ye==null&&We++<bt.length;)A.has(
bt[We])||(Ye=We);if(pt!=null||Ye!=null)if(De){let kt=pt==null?-1/0:z(St[pt],I,Fe,0),Zt=Ye==null?1/0:z(St[Ye],I,Fe,0),vn=tt-kt,It=Zt-tt;vn<=It?vn<=Ne&&(ve=pt):It<=
Ne&&(ve=Ye)}else ve=Ye==null?pt:pt==null?Ye:ae-pt<=Ye-ae?pt:Ye}else De&&dn(tt-z(St[ae],I,Fe,0))>Ne&&(ve=null);return ve}}let Ze=v=>{ue.event=v};ue.idxs=se,ue._lock=
!1;let le=ue.points;le.show=gt(le.show),le.size=gt(le.size),le.stroke=gt(le.stroke),le.width=gt(le.width),le.fill=gt(le.fill);let Oe=n.focus=on({},i.focus||{alpha:.3},
ue.focus),Je=Oe.prox>=0,Ce=Je&&le.one,ot=[],Ft=[],In=[];function _o(v,A){let N=le.show(n,A);if(N instanceof HTMLElement)return Zn(N,f_),Zn(N,v.class),Di(N,-10,-10,
B,Re),p.insertBefore(N,ot[A]),N}function dr(v,A){if(s==1||A>0){let N=s==1&&b[v.scale].time,U=v.value;v.value=N?Pf(U)?Of(Y,Ff(U,W)):U||Q:U||Ex,v.label=v.label||(N?
yx:xx)}if(Ce||A>0){v.width=v.width==null?1:v.width,v.paths=v.paths||Vx||I_,v.fillTo=gt(v.fillTo||Lx),v.pxAlign=+Mt(v.pxAlign,x),v.pxRound=$f(v.pxAlign),v.stroke=
gt(v.stroke||null),v.fill=gt(v.fill||null),v._stroke=v._fill=v._paths=v._focus=null;let N=Cx(Fn(1,v.width),1),U=v.points=on({},{size:N,width:Fn(1,N*.2),stroke:v.
stroke,space:N*2,paths:Gx,_stroke:null,_fill:null},v.points);U.show=gt(U.show),U.filter=gt(U.filter),U.fill=gt(U.fill),U.stroke=gt(U.stroke),U.paths=gt(U.paths),
U.pxAlign=v.pxAlign}if(ee){let N=Pt(v,A);nt.splice(A,0,N[0]),Ve.splice(A,0,N[1]),de.values.push(null)}if(me){se.splice(A,0,null);let N=null;Ce?A==0&&(N=_o(v,A)):
A>0&&(N=_o(v,A)),ot.splice(A,0,N),Ft.splice(A,0,0),In.splice(A,0,0)}yn("addSeries",A)}function uh(v,A){A=A??y.length,v=s==1?Oh(v,A,kf,Wf):Oh(v,A,{},Hf),y.splice(
A,0,v),dr(y[A],A)}n.addSeries=uh;function Ca(v){if(y.splice(v,1),ee){de.values.splice(v,1),Ve.splice(v,1);let A=nt.splice(v,1)[0];cn(null,A.firstChild),A.remove()}
me&&(se.splice(v,1),ot.splice(v,1)[0].remove(),Ft.splice(v,1),In.splice(v,1)),yn("delSeries",v)}n.delSeries=Ca;let Ei=[!1,!1,!1,!1];function $i(v,A){if(v._show=
v.show,v.show){let N=v.side%2,U=b[v.scale];U==null&&(v.scale=N?y[1].scale:w,U=b[v.scale]);let H=U.time;v.size=gt(v.size),v.space=gt(v.space),v.rotate=gt(v.rotate),
ws(v.incrs)&&v.incrs.forEach(ae=>{!Ts.has(ae)&&Ts.set(ae,rp(ae))}),v.incrs=gt(v.incrs||(U.distr==2?Q_:H?g==1?tx:sx:Js)),v.splits=gt(v.splits||(H&&U.distr==1?ce:
U.distr==3?Nh:U.distr==4?Mx:bx)),v.stroke=gt(v.stroke),v.grid.stroke=gt(v.grid.stroke),v.ticks.stroke=gt(v.ticks.stroke),v.border.stroke=gt(v.border.stroke);let J=v.
values;v.values=ws(J)&&!ws(J[0])?gt(J):H?ws(J)?Uf(Y,Df(J,W)):Pf(J)?ax(Y,J):J||K:J||vx,v.filter=gt(v.filter||(U.distr>=3&&U.log==10?Tx:U.distr==3&&U.log==2?Ax:ip)),
v.font=Jf(v.font),v.labelFont=Jf(v.labelFont),v._size=v.size(n,null,A,0),v._space=v._rotate=v._incrs=v._found=v._splits=v._values=null,v._size>0&&(Ei[A]=!0,v._el=
ai(c_,h))}}function qi(v,A,N,U){let[H,J,ae,fe]=N,ve=A%2,Ne=0;return ve==0&&(fe||J)&&(Ne=A==0&&!H||A==2&&!ae?un(Bf.size/3):0),ve==1&&(H||ae)&&(Ne=A==1&&!J||A==3&&
!fe?un(Vf.size/2):0),Ne}let xo=n.padding=(i.padding||[qi,qi,qi,qi]).map(v=>gt(Mt(v,qi))),fi=n._padding=xo.map((v,A)=>v(n,A,Ei,0)),qt,Kt=null,jt=null,Ci=s==1?y[0].
idxs:null,Xn=null,xs=!1;function yo(v,A){if(e=v??[],n.data=n._data=e,s==2){qt=0;for(let N=1;N<y.length;N++)qt+=e[N][0].length}else{e.length==0&&(n.data=n._data=
e=[[]]),Xn=e[0],qt=Xn.length;let N=e;if(F==2){N=e.slice();let U=N[0]=Array(qt);for(let H=0;H<qt;H++)U[H]=H}n._data=e=N}if(ct(!0),yn("setData"),F==2&&(ye=!0),A!==
!1){let N=I;N.auto(n,xs)?vo():bs(w,N.min,N.max),te=te||ue.left>=0,pe=!0,Tn()}}n.setData=yo;function vo(){xs=!0;let v,A;s==1&&(qt>0?(Kt=Ci[0]=0,jt=Ci[1]=qt-1,v=e[0][Kt],
A=e[0][jt],F==2?(v=Kt,A=jt):v==A&&(F==3?[v,A]=za(v,v,I.log,!1):F==4?[v,A]=Vh(v,v,I.log,!1):I.time?A=v+un(86400/g):[v,A]=Oa(v,A,Gh,!0))):(Kt=Ci[0]=v=null,jt=Ci[1]=
A=null)),bs(w,v,A)}let fr,ys,pr,E,k,j,q,Z,Te,Pe;function Ae(v,A,N,U,H,J){v??=ff,N??=Wh,U??="butt",H??=ff,J??="round",v!=fr&&(u.strokeStyle=fr=v),H!=ys&&(u.fillStyle=
ys=H),A!=pr&&(u.lineWidth=pr=A),J!=k&&(u.lineJoin=k=J),U!=j&&(u.lineCap=j=U),N!=E&&u.setLineDash(E=N)}function Ie(v,A,N,U){A!=ys&&(u.fillStyle=ys=A),v!=q&&(u.font=
q=v),N!=Z&&(u.textAlign=Z=N),U!=Te&&(u.textBaseline=Te=U)}function ke(v,A,N,U,H=0){if(U.length>0&&v.auto(n,xs)&&(A==null||A.min==null)){let J=Mt(Kt,0),ae=Mt(jt,
U.length-1),fe=N.min==null?T_(U,J,ae,H,v.distr==3):[N.min,N.max];v.min=xi(v.min,N.min=fe[0]),v.max=Fn(v.max,N.max=fe[1])}}let je={min:null,max:null};function dt(){
for(let U in b){let H=b[U];G[U]==null&&(H.min==null||G[w]!=null&&H.auto(n,xs))&&(G[U]=je)}for(let U in b){let H=b[U];G[U]==null&&H.from!=null&&G[H.from]!=null&&
(G[U]=je)}G[w]!=null&&ct(!0);let v={};for(let U in G){let H=G[U];if(H!=null){let J=v[U]=Cr(b[U],D_);if(H.min!=null)on(J,H);else if(U!=w||s==2)if(qt==0&&J.from==
null){let ae=J.range(n,null,null,U);J.min=ae[0],J.max=ae[1]}else J.min=Nt,J.max=-Nt}}if(qt>0){y.forEach((U,H)=>{if(s==1){let J=U.scale,ae=G[J];if(ae==null)return;
let fe=v[J];if(H==0){let ve=fe.range(n,fe.min,fe.max,J);fe.min=ve[0],fe.max=ve[1],Kt=_i(fe.min,e[0]),jt=_i(fe.max,e[0]),jt-Kt>1&&(e[0][Kt]<fe.min&&Kt++,e[0][jt]>
fe.max&&jt--),U.min=Xn[Kt],U.max=Xn[jt]}else U.show&&U.auto&&ke(fe,ae,U,e[H],U.sorted);U.idxs[0]=Kt,U.idxs[1]=jt}else if(H>0&&U.show&&U.auto){let[J,ae]=U.facets,
fe=J.scale,ve=ae.scale,[Ne,De]=e[H],Fe=v[fe],tt=v[ve];Fe!=null&&ke(Fe,G[fe],J,Ne,J.sorted),tt!=null&&ke(tt,G[ve],ae,De,ae.sorted),U.min=ae.min,U.max=ae.max}});for(let U in v){
let H=v[U],J=G[U];if(H.from==null&&(J==null||J.min==null)){let ae=H.range(n,H.min==Nt?null:H.min,H.max==-Nt?null:H.max,U);H.min=ae[0],H.max=ae[1]}}}for(let U in v){
let H=v[U];if(H.from!=null){let J=v[H.from];if(J.min==null)H.min=H.max=null;else{let ae=H.range(n,J.min,J.max,U);H.min=ae[0],H.max=ae[1]}}}let A={},N=!1;for(let U in v){
let H=v[U],J=b[U];if(J.min!=H.min||J.max!=H.max){J.min=H.min,J.max=H.max;let ae=J.distr;J._min=ae==3?Ki(J.min):ae==4?wh(J.min,J.asinh):ae==100?J.fwd(J.min):J.min,
J._max=ae==3?Ki(J.max):ae==4?wh(J.max,J.asinh):ae==100?J.fwd(J.max):J.max,A[U]=N=!0}}if(N){y.forEach((U,H)=>{s==2?H>0&&A.y&&(U._paths=null):A[U.scale]&&(U._paths=
null)});for(let U in A)ye=!0,yn("setScale",U);me&&ue.left>=0&&(te=pe=!0)}for(let U in G)G[U]=null}function Be(v){let A=Lh(Kt-1,0,qt-1),N=Lh(jt+1,0,qt-1);for(;v[A]==
null&&A>0;)A--;for(;v[N]==null&&N<qt-1;)N++;return[A,N]}function ft(){if(qt>0){let v=y.some(A=>A._focus)&&Pe!=Oe.alpha;v&&(u.globalAlpha=Pe=Oe.alpha),y.forEach(
(A,N)=>{if(N>0&&A.show&&(Xt(N,!1),Xt(N,!0),A._paths==null)){let U=Pe;Pe!=A.alpha&&(u.globalAlpha=Pe=A.alpha);let H=s==2?[0,e[N][0].length-1]:Be(e[N]);A._paths=A.
paths(n,N,H[0],H[1]),Pe!=U&&(u.globalAlpha=Pe=U)}}),y.forEach((A,N)=>{if(N>0&&A.show){let U=Pe;Pe!=A.alpha&&(u.globalAlpha=Pe=A.alpha),A._paths!=null&&Et(N,!1);
{let H=A._paths!=null?A._paths.gaps:null,J=A.points.show(n,N,Kt,jt,H),ae=A.points.filter(n,N,J,H);(J||ae)&&(A.points._paths=A.points.paths(n,N,Kt,jt,ae),Et(N,!0))}
Pe!=U&&(u.globalAlpha=Pe=U),yn("drawSeries",N)}}),v&&(u.globalAlpha=Pe=1)}}function Xt(v,A){let N=A?y[v].points:y[v];N._stroke=N.stroke(n,v),N._fill=N.fill(n,v)}
function Et(v,A){let N=A?y[v].points:y[v],{stroke:U,fill:H,clip:J,flags:ae,_stroke:fe=N._stroke,_fill:ve=N._fill,_width:Ne=N.width}=N._paths;Ne=Dt(Ne*wt,3);let De=null,
Fe=Ne%2/2;A&&ve==null&&(ve=Ne>0?"#fff":fe);let tt=N.pxAlign==1&&Fe>0;if(tt&&u.translate(Fe,Fe),!A){let St=L-Ne/2,bt=T-Ne/2,pt=$+Ne,Ye=he+Ne;De=new Path2D,De.rect(
St,bt,pt,Ye)}A?Ue(fe,Ne,N.dash,N.cap,ve,U,H,ae,J):Ct(v,fe,Ne,N.dash,N.cap,ve,U,H,ae,De,J),tt&&u.translate(-Fe,-Fe)}function Ct(v,A,N,U,H,J,ae,fe,ve,Ne,De){let Fe=!1;
ve!=0&&C.forEach((tt,St)=>{if(tt.series[0]==v){let bt=y[tt.series[1]],pt=e[tt.series[1]],Ye=(bt._paths||Po).band;ws(Ye)&&(Ye=tt.dir==1?Ye[0]:Ye[1]);let We,kt=null;
bt.show&&Ye&&E_(pt,Kt,jt)?(kt=tt.fill(n,St)||J,We=bt._paths.clip):Ye=null,Ue(A,N,U,H,kt,ae,fe,ve,Ne,De,We,Ye),Fe=!0}}),Fe||Ue(A,N,U,H,J,ae,fe,ve,Ne,De)}let hn=Rr|
Uh;function Ue(v,A,N,U,H,J,ae,fe,ve,Ne,De,Fe){Ae(v,A,N,U,H),(ve||Ne||Fe)&&(u.save(),ve&&u.clip(ve),Ne&&u.clip(Ne)),Fe?(fe&hn)==hn?(u.clip(Fe),De&&u.clip(De),mt(
H,ae),tn(v,J,A)):fe&Uh?(mt(H,ae),u.clip(Fe),tn(v,J,A)):fe&Rr&&(u.save(),u.clip(Fe),De&&u.clip(De),mt(H,ae),u.restore(),tn(v,J,A)):(mt(H,ae),tn(v,J,A)),(ve||Ne||
Fe)&&u.restore()}function tn(v,A,N){N>0&&(A instanceof Map?A.forEach((U,H)=>{u.strokeStyle=fr=H,u.stroke(U)}):A!=null&&v&&u.stroke(A))}function mt(v,A){A instanceof
Map?A.forEach((N,U)=>{u.fillStyle=ys=U,u.fill(N)}):A!=null&&v&&u.fill(A)}function Yi(v,A,N,U){let H=S[v],J;if(U<=0)J=[0,0];else{let ae=H._space=H.space(n,v,A,N,
U),fe=H._incrs=H.incrs(n,v,A,N,U,ae);J=Yx(A,N,fe,U,ae)}return H._found=J}function nn(v,A,N,U,H,J,ae,fe,ve,Ne){let De=ae%2/2;x==1&&u.translate(De,De),Ae(fe,ae,ve,
Ne,fe),u.beginPath();let Fe,tt,St,bt,pt=H+(U==0||U==3?-J:J);N==0?(tt=H,bt=pt):(Fe=H,St=pt);for(let Ye=0;Ye<v.length;Ye++)A[Ye]!=null&&(N==0?Fe=St=v[Ye]:tt=bt=v[Ye],
u.moveTo(Fe,tt),u.lineTo(St,bt));u.stroke(),x==1&&u.translate(-De,-De)}function mr(v){let A=!0;return S.forEach((N,U)=>{if(!N.show)return;let H=b[N.scale];if(H.
min==null){N._show&&(A=!1,N._show=!1,ct(!1));return}else N._show||(A=!1,N._show=!0,ct(!1));let J=N.side,ae=J%2,{min:fe,max:ve}=H,[Ne,De]=Yi(U,fe,ve,ae==0?B:Re);
if(De==0)return;let Fe=H.distr==2,tt=N._splits=N.splits(n,U,fe,ve,Ne,De,Fe),St=H.distr==2?tt.map(We=>Xn[We]):tt,bt=H.distr==2?Xn[tt[1]]-Xn[tt[0]]:Ne,pt=N._values=
N.values(n,N.filter(n,St,U,De,bt),U,De,bt);N._rotate=J==2?N.rotate(n,pt,U,De):0;let Ye=N._size;N._size=li(N.size(n,pt,U,v)),Ye!=null&&N._size!=Ye&&(A=!1)}),A}function Ri(v){
let A=!0;return xo.forEach((N,U)=>{let H=N(n,U,Ei,v);H!=fi[U]&&(A=!1),fi[U]=H}),A}function Zi(){for(let v=0;v<S.length;v++){let A=S[v];if(!A.show||!A._show)continue;
let N=A.side,U=N%2,H,J,ae=A.stroke(n,v),fe=N==0||N==3?-1:1,[ve,Ne]=A._found;if(A.label!=null){let Dn=A.labelGap*fe,Yn=un((A._lpos+Dn)*wt);Ie(A.labelFont[0],ae,"\
center",N==2?"top":df),u.save(),U==1?(H=J=0,u.translate(Yn,un(T+he/2)),u.rotate((N==3?-Ua:Ua)/2)):(H=un(L+$/2),J=Yn);let Ys=tp(A.label)?A.label(n,v,ve,Ne):A.label;
u.fillText(Ys,H,J),u.restore()}if(Ne==0)continue;let De=b[A.scale],Fe=U==0?$:he,tt=U==0?L:T,St=A._splits,bt=De.distr==2?St.map(Dn=>Xn[Dn]):St,pt=De.distr==2?Xn[St[1]]-
Xn[St[0]]:ve,Ye=A.ticks,We=A.border,kt=Ye.show?Ye.size:0,Zt=un(kt*wt),vn=un((A.alignTo==2?A._size-kt-A.gap:A.gap)*wt),It=A._rotate*-Ua/180,Jt=m(A._pos*wt),$n=(Zt+
vn)*fe,Nn=Jt+$n;J=U==0?Nn:0,H=U==1?Nn:0;let ri=A.font[0],pi=A.align==1?Sr:A.align==2?bh:It>0?Sr:It<0?bh:U==0?"center":N==3?bh:Sr,Li=It||U==1?"middle":N==2?"top":
df;Ie(ri,ae,pi,Li);let qn=A.font[1]*A.lineGap,oi=St.map(Dn=>m(a(Dn,De,Fe,tt))),mi=A._values;for(let Dn=0;Dn<mi.length;Dn++){let Yn=mi[Dn];if(Yn!=null){U==0?H=oi[Dn]:
J=oi[Dn],Yn=""+Yn;let Ys=Yn.indexOf("\n")==-1?[Yn]:Yn.split(/\n/gm);for(let Un=0;Un<Ys.length;Un++){let af=Ys[Un];It?(u.save(),u.translate(H,J+Un*qn),u.rotate(It),
u.fillText(af,0,0),u.restore()):u.fillText(af,H,J+Un*qn)}}}Ye.show&&nn(oi,Ye.filter(n,bt,v,Ne,pt),U,N,Jt,Zt,Dt(Ye.width*wt,3),Ye.stroke(n,v),Ye.dash,Ye.cap);let Ni=A.
grid;Ni.show&&nn(oi,Ni.filter(n,bt,v,Ne,pt),U,U==0?2:1,U==0?T:L,U==0?he:$,Dt(Ni.width*wt,3),Ni.stroke(n,v),Ni.dash,Ni.cap),We.show&&nn([Jt],[1],U==0?1:0,U==0?1:
2,U==1?T:L,U==1?he:$,Dt(We.width*wt,3),We.stroke(n,v),We.dash,We.cap)}yn("drawAxes")}function ct(v){y.forEach((A,N)=>{N>0&&(A._paths=null,v&&(s==1?(A.min=null,A.
max=null):A.facets.forEach(U=>{U.min=null,U.max=null})))})}let Yt=!1,Ln=!1,Rt=[];function sn(){Ln=!1;for(let v=0;v<Rt.length;v++)yn(...Rt[v]);Rt.length=0}function Tn(){
Yt||(V_(Gd),Yt=!0)}function Ra(v,A=!1){Yt=!0,Ln=A,v(n),Gd(),A&&Rt.length>0&&queueMicrotask(sn)}n.batch=Ra;function Gd(){if(oe&&(dt(),oe=!1),ye&&(we(),ye=!1),_e){
if(zt(f,Sr,$e),zt(f,"top",it),zt(f,Ao,B),zt(f,Eo,Re),zt(p,Sr,$e),zt(p,"top",it),zt(p,Ao,B),zt(p,Eo,Re),zt(h,Ao,$t),zt(h,Eo,en),d.width=un($t*wt),d.height=un(en*
wt),S.forEach(({_el:v,_show:A,_size:N,_pos:U,side:H})=>{if(v!=null)if(A){let J=H===3||H===0?N:0,ae=H%2==1;zt(v,ae?"left":"top",U-J),zt(v,ae?"width":"height",N),
zt(v,ae?"top":"left",ae?it:$e),zt(v,ae?"height":"width",ae?Re:B),Ph(v,Ks)}else Zn(v,Ks)}),fr=ys=pr=k=j=q=Z=Te=E=null,Pe=1,So(!0),$e!=Se||it!=Lt||B!=ze||Re!=Xe){
ct(!1);let v=B/ze,A=Re/Xe;if(me&&!te&&ue.left>=0){ue.left*=v,ue.top*=A,gr&&Di(gr,un(ue.left),0,B,Re),_r&&Di(_r,0,un(ue.top),B,Re);for(let N=0;N<ot.length;N++){let U=ot[N];
U!=null&&(Ft[N]*=v,In[N]*=A,Di(U,li(Ft[N]),li(In[N]),B,Re))}}if(Bt.show&&!ie&&Bt.left>=0&&Bt.width>0){Bt.left*=v,Bt.width*=v,Bt.top*=A,Bt.height*=A;for(let N in _h)
zt(vr,N,Bt[N])}Se=$e,Lt=it,ze=B,Xe=Re}yn("setSize"),_e=!1}$t>0&&en>0&&(u.clearRect(0,0,d.width,d.height),yn("drawClear"),M.forEach(v=>v()),yn("draw")),Bt.show&&
ie&&(Pa(Bt),ie=!1),me&&te&&(qs(null,!0,!1),te=!1),de.show&&de.live&&pe&&(mh(),pe=!1),l||(l=!0,n.status=1,yn("ready")),xs=!1,Yt=!1}n.redraw=(v,A)=>{ye=A||!1,v!==
!1?bs(w,I.min,I.max):Tn()};function dh(v,A){let N=b[v];if(N.from==null){if(qt==0){let U=N.range(n,A.min,A.max,v);A.min=U[0],A.max=U[1]}if(A.min>A.max){let U=A.min;
A.min=A.max,A.max=U}if(qt>1&&A.min!=null&&A.max!=null&&A.max-A.min<1e-16)return;v==w&&N.distr==2&&qt>0&&(A.min=_i(A.min,e[0]),A.max=_i(A.max,e[0]),A.min==A.max&&
A.max++),G[v]=A,oe=!0,Tn()}}n.setScale=dh;let fh,ph,gr,_r,Hd,Wd,xr,yr,Xd,$d,Ot,Ht,vs=!1,Sn=ue.drag,_n=Sn.x,xn=Sn.y;me&&(ue.x&&(fh=ai(u_,p)),ue.y&&(ph=ai(d_,p)),
I.ori==0?(gr=fh,_r=ph):(gr=ph,_r=fh),Ot=ue.left,Ht=ue.top);let Bt=n.select=on({show:!0,over:!0,left:0,width:0,top:0,height:0},i.select),vr=Bt.show?ai(h_,Bt.over?
p:f):null;function Pa(v,A){if(Bt.show){for(let N in v)Bt[N]=v[N],N in _h&&zt(vr,N,v[N]);A!==!1&&yn("setSelect")}}n.setSelect=Pa;function V0(v){if(y[v].show)ee&&
Ph(nt[v],Ks);else if(ee&&Zn(nt[v],Ks),me){let N=Ce?ot[0]:ot[v];N!=null&&Di(N,-10,-10,B,Re)}}function bs(v,A,N){dh(v,{min:A,max:N})}function Pi(v,A,N,U){A.focus!=
null&&$0(v),A.show!=null&&y.forEach((H,J)=>{J>0&&(v==J||v==null)&&(H.show=A.show,V0(J),s==2?(bs(H.facets[0].scale,null,null),bs(H.facets[1].scale,null,null)):bs(
H.scale,null,null),Tn())}),N!==!1&&yn("setSeries",v,A),U&&wo("setSeries",n,v,A)}n.setSeries=Pi;function G0(v,A){on(C[v],A)}function H0(v,A){v.fill=gt(v.fill||null),
v.dir=Mt(v.dir,-1),A=A??C.length,C.splice(A,0,v)}function W0(v){v==null?C.length=0:C.splice(v,1)}n.addBand=H0,n.setBand=G0,n.delBand=W0;function X0(v,A){y[v].alpha=
A,me&&ot[v]!=null&&(ot[v].style.opacity=A),ee&&nt[v]&&(nt[v].style.opacity=A)}let Ji,Ms,$s,br={focus:!0};function $0(v){if(v!=$s){let A=v==null,N=Oe.alpha!=1;y.
forEach((U,H)=>{if(s==1||H>0){let J=A||H==0||H==v;U._focus=A?null:J,N&&X0(H,J?1:Oe.alpha)}}),$s=v,N&&Tn()}}ee&&Je&&vt(gf,Ee,v=>{ue._lock||(Ze(v),$s!=null&&Pi(null,
br,!0,rn.setSeries))});function Ii(v,A,N){let U=b[A];N&&(v=v/wt-(U.ori==1?it:$e));let H=B;U.ori==1&&(H=Re,v=H-v),U.dir==-1&&(v=H-v);let J=U._min,ae=U._max,fe=v/
H,ve=J+(ae-J)*fe,Ne=U.distr;return Ne==3?Ar(10,ve):Ne==4?R_(ve,U.asinh):Ne==100?U.bwd(ve):ve}function q0(v,A){let N=Ii(v,w,A);return _i(N,e[0],Kt,jt)}n.valToIdx=
v=>_i(v,e[0]),n.posToIdx=q0,n.posToVal=Ii,n.valToPos=(v,A,N)=>b[A].ori==0?r(v,b[A],N?$:B,N?L:0):o(v,b[A],N?he:Re,N?T:0),n.setCursor=(v,A,N)=>{Ot=v.left,Ht=v.top,
qs(null,A,N)};function qd(v,A){zt(vr,Sr,Bt.left=v),zt(vr,Ao,Bt.width=A)}function Yd(v,A){zt(vr,"top",Bt.top=v),zt(vr,Eo,Bt.height=A)}let bo=I.ori==0?qd:Yd,Mo=I.
ori==1?qd:Yd;function Y0(){if(ee&&de.live)for(let v=s==2?1:0;v<y.length;v++){if(v==0&&lt)continue;let A=de.values[v],N=0;for(let U in A)Ve[v][N++].firstChild.nodeValue=
A[U]}}function mh(v,A){if(v!=null&&(v.idxs?v.idxs.forEach((N,U)=>{se[U]=N}):N_(v.idx)||se.fill(v.idx),de.idx=se[0]),ee&&de.live){for(let N=0;N<y.length;N++)(N>0||
s==1&&!lt)&&Z0(N,se[N]);Y0()}pe=!1,A!==!1&&yn("setLegend")}n.setLegend=mh;function Z0(v,A){let N=y[v],U=v==0&&F==2?Xn:e[v],H;lt?H=N.values(n,v,A)??et:(H=N.value(
n,A==null?null:U[A],v,A),H=H==null?et:{_:H}),de.values[v]=H}function qs(v,A,N){Xd=Ot,$d=Ht,[Ot,Ht]=ue.move(n,Ot,Ht),ue.left=Ot,ue.top=Ht,me&&(gr&&Di(gr,un(Ot),0,
B,Re),_r&&Di(_r,0,un(Ht),B,Re));let U,H=Kt>jt;Ji=Nt,Ms=null;let J=I.ori==0?B:Re,ae=I.ori==1?B:Re;if(Ot<0||qt==0||H){U=ue.idx=null;for(let fe=0;fe<y.length;fe++){
let ve=ot[fe];ve!=null&&Di(ve,-10,-10,B,Re)}Je&&Pi(null,br,!0,v==null&&rn.setSeries),de.live&&(se.fill(U),pe=!0)}else{let fe,ve,Ne;s==1&&(fe=I.ori==0?Ot:Ht,ve=Ii(
fe,w),U=ue.idx=_i(ve,e[0],Kt,jt),Ne=z(e[0][U],I,J,0));let De=-10,Fe=-10,tt=0,St=0,bt=!0,pt="",Ye="";for(let We=s==2?1:0;We<y.length;We++){let kt=y[We],Zt=se[We],
vn=Zt==null?null:s==1?e[We][Zt]:e[We][1][Zt],It=ue.dataIdx(n,We,U,ve),Jt=It==null?null:s==1?e[We][It]:e[We][1][It];if(pe=pe||Jt!=vn||It!=Zt,se[We]=It,We>0&&kt.show){
let $n=It==null?-10:It==U?Ne:z(s==1?e[0][It]:e[We][0][It],I,J,0),Nn=Jt==null?-10:D(Jt,s==1?b[kt.scale]:b[kt.facets[1].scale],ae,0);if(Je&&Jt!=null){let ri=I.ori==
1?Ot:Ht,pi=dn(Oe.dist(n,We,It,Nn,ri));if(pi<Ji){let Li=Oe.bias;if(Li!=0){let qn=Ii(ri,kt.scale),oi=Jt>=0?1:-1,mi=qn>=0?1:-1;mi==oi&&(mi==1?Li==1?Jt>=qn:Jt<=qn:Li==
1?Jt<=qn:Jt>=qn)&&(Ji=pi,Ms=We)}else Ji=pi,Ms=We}}if(pe||Ce){let ri,pi;I.ori==0?(ri=$n,pi=Nn):(ri=Nn,pi=$n);let Li,qn,oi,mi,Ni,Dn,Yn=!0,Ys=le.bbox;if(Ys!=null){
Yn=!1;let Un=Ys(n,We);oi=Un.left,mi=Un.top,Li=Un.width,qn=Un.height}else oi=ri,mi=pi,Li=qn=le.size(n,We);if(Dn=le.fill(n,We),Ni=le.stroke(n,We),Ce)We==Ms&&Ji<=Oe.
prox&&(De=oi,Fe=mi,tt=Li,St=qn,bt=Yn,pt=Dn,Ye=Ni);else{let Un=ot[We];Un!=null&&(Ft[We]=oi,In[We]=mi,Sf(Un,Li,qn,Yn),bf(Un,Dn,Ni),Di(Un,li(oi),li(mi),B,Re))}}}}if(Ce){
let We=Oe.prox,kt=$s==null?Ji<=We:Ji>We||Ms!=$s;if(pe||kt){let Zt=ot[0];Zt!=null&&(Ft[0]=De,In[0]=Fe,Sf(Zt,tt,St,bt),bf(Zt,pt,Ye),Di(Zt,li(De),li(Fe),B,Re))}}}if(Bt.
show&&vs)if(v!=null){let[fe,ve]=rn.scales,[Ne,De]=rn.match,[Fe,tt]=v.cursor.sync.scales,St=v.cursor.drag;if(_n=St._x,xn=St._y,_n||xn){let{left:bt,top:pt,width:Ye,
height:We}=v.select,kt=v.scales[Fe].ori,Zt=v.posToVal,vn,It,Jt,$n,Nn,ri=fe!=null&&Ne(fe,Fe),pi=ve!=null&&De(ve,tt);ri&&_n?(kt==0?(vn=bt,It=Ye):(vn=pt,It=We),Jt=
b[fe],$n=z(Zt(vn,Fe),Jt,J,0),Nn=z(Zt(vn+It,Fe),Jt,J,0),bo(xi($n,Nn),dn(Nn-$n))):bo(0,J),pi&&xn?(kt==1?(vn=bt,It=Ye):(vn=pt,It=We),Jt=b[ve],$n=D(Zt(vn,tt),Jt,ae,
0),Nn=D(Zt(vn+It,tt),Jt,ae,0),Mo(xi($n,Nn),dn(Nn-$n))):Mo(0,ae)}else xh()}else{let fe=dn(Xd-Hd),ve=dn($d-Wd);if(I.ori==1){let tt=fe;fe=ve,ve=tt}_n=Sn.x&&fe>=Sn.
dist,xn=Sn.y&&ve>=Sn.dist;let Ne=Sn.uni;Ne!=null?_n&&xn&&(_n=fe>=Ne,xn=ve>=Ne,!_n&&!xn&&(ve>fe?xn=!0:_n=!0)):Sn.x&&Sn.y&&(_n||xn)&&(_n=xn=!0);let De,Fe;_n&&(I.ori==
0?(De=xr,Fe=Ot):(De=yr,Fe=Ht),bo(xi(De,Fe),dn(Fe-De)),xn||Mo(0,ae)),xn&&(I.ori==1?(De=xr,Fe=Ot):(De=yr,Fe=Ht),Mo(xi(De,Fe),dn(Fe-De)),_n||bo(0,J)),!_n&&!xn&&(bo(
0,0),Mo(0,0))}if(Sn._x=_n,Sn._y=xn,v==null){if(N){if(of!=null){let[fe,ve]=rn.scales;rn.values[0]=fe!=null?Ii(I.ori==0?Ot:Ht,fe):null,rn.values[1]=ve!=null?Ii(I.
ori==1?Ot:Ht,ve):null}wo(Mh,n,Ot,Ht,B,Re,U)}if(Je){let fe=N&&rn.setSeries,ve=Oe.prox;$s==null?Ji<=ve&&Pi(Ms,br,!0,fe):Ji>ve?Pi(null,br,!0,fe):Ms!=$s&&Pi(Ms,br,!0,
fe)}}pe&&(de.idx=U,mh()),A!==!1&&yn("setCursor")}let Ss=null;Object.defineProperty(n,"rect",{get(){return Ss==null&&So(!1),Ss}});function So(v=!1){v?Ss=null:(Ss=
p.getBoundingClientRect(),yn("syncRect",Ss))}function Zd(v,A,N,U,H,J,ae){ue._lock||vs&&v!=null&&v.movementX==0&&v.movementY==0||(gh(v,A,N,U,H,J,ae,!1,v!=null),v!=
null?qs(null,!0,!0):qs(A,!0,!1))}function gh(v,A,N,U,H,J,ae,fe,ve){if(Ss==null&&So(!1),Ze(v),v!=null)N=v.clientX-Ss.left,U=v.clientY-Ss.top;else{if(N<0||U<0){Ot=
-10,Ht=-10;return}let[Ne,De]=rn.scales,Fe=A.cursor.sync,[tt,St]=Fe.values,[bt,pt]=Fe.scales,[Ye,We]=rn.match,kt=A.axes[0].side%2==1,Zt=I.ori==0?B:Re,vn=I.ori==1?
B:Re,It=kt?J:H,Jt=kt?H:J,$n=kt?U:N,Nn=kt?N:U;if(bt!=null?N=Ye(Ne,bt)?a(tt,b[Ne],Zt,0):-10:N=Zt*($n/It),pt!=null?U=We(De,pt)?a(St,b[De],vn,0):-10:U=vn*(Nn/Jt),I.
ori==1){let ri=N;N=U,U=ri}}ve&&(A==null||A.cursor.event.type==Mh)&&((N<=1||N>=B-1)&&(N=Zs(N,B)),(U<=1||U>=Re-1)&&(U=Zs(U,Re))),fe?(Hd=N,Wd=U,[xr,yr]=ue.move(n,N,
U)):(Ot=N,Ht=U)}let _h={width:0,height:0,left:0,top:0};function xh(){Pa(_h,!1)}let Jd,Kd,jd,Qd;function ef(v,A,N,U,H,J,ae){vs=!0,_n=xn=Sn._x=Sn._y=!1,gh(v,A,N,U,
H,J,ae,!0,!1),v!=null&&(vt(Sh,Ch,tf,!1),wo(pf,n,xr,yr,B,Re,null));let{left:fe,top:ve,width:Ne,height:De}=Bt;Jd=fe,Kd=ve,jd=Ne,Qd=De}function tf(v,A,N,U,H,J,ae){
vs=Sn._x=Sn._y=!1,gh(v,A,N,U,H,J,ae,!1,!0);let{left:fe,top:ve,width:Ne,height:De}=Bt,Fe=Ne>0||De>0,tt=Jd!=fe||Kd!=ve||jd!=Ne||Qd!=De;if(Fe&&tt&&Pa(Bt),Sn.setScale&&
Fe&&tt){let St=fe,bt=Ne,pt=ve,Ye=De;if(I.ori==1&&(St=ve,bt=De,pt=fe,Ye=Ne),_n&&bs(w,Ii(St,w),Ii(St+bt,w)),xn)for(let We in b){let kt=b[We];We!=w&&kt.from==null&&
kt.min!=Nt&&bs(We,Ii(pt+Ye,We),Ii(pt,We))}xh()}else ue.lock&&(ue._lock=!ue._lock,qs(A,!0,v!=null));v!=null&&(cn(Sh,Ch),wo(Sh,n,Ot,Ht,B,Re,null))}function J0(v,A,N,U,H,J,ae){
if(ue._lock)return;Ze(v);let fe=vs;if(vs){let ve=!0,Ne=!0,De=10,Fe,tt;I.ori==0?(Fe=_n,tt=xn):(Fe=xn,tt=_n),Fe&&tt&&(ve=Ot<=De||Ot>=B-De,Ne=Ht<=De||Ht>=Re-De),Fe&&
ve&&(Ot=Ot<xr?0:B),tt&&Ne&&(Ht=Ht<yr?0:Re),qs(null,!0,!0),vs=!1}Ot=-10,Ht=-10,se.fill(null),qs(null,!0,!0),fe&&(vs=fe)}function nf(v,A,N,U,H,J,ae){ue._lock||(Ze(
v),vo(),xh(),v!=null&&wo(_f,n,Ot,Ht,B,Re,null))}function sf(){S.forEach(Zx),O(n.width,n.height,!0)}js(Fa,Tr,sf);let Mr={};Mr.mousedown=ef,Mr.mousemove=Zd,Mr.mouseup=
tf,Mr.dblclick=nf,Mr.setSeries=(v,A,N,U)=>{let H=rn.match[2];N=H(n,A,N),N!=-1&&Pi(N,U,!0,!1)},me&&(vt(pf,p,ef),vt(Mh,p,Zd),vt(mf,p,v=>{Ze(v),So(!1)}),vt(gf,p,J0),
vt(_f,p,nf),Fh.add(n),n.syncRect=So);let Ia=n.hooks=i.hooks||{};function yn(v,A,N){Ln?Rt.push([v,A,N]):v in Ia&&Ia[v].forEach(U=>{U.call(null,n,A,N)})}(i.plugins||
[]).forEach(v=>{for(let A in v.hooks)Ia[A]=(Ia[A]||[]).concat(v.hooks[A])});let rf=(v,A,N)=>N,rn=on({key:null,setSeries:!1,filters:{pub:Cf,sub:Cf},scales:[w,y[1]?
y[1].scale:null],match:[Rf,Rf,rf],values:[null,null]},ue.sync);rn.match.length==2&&rn.match.push(rf),ue.sync=rn;let of=rn.key,yh=Tp(of);function wo(v,A,N,U,H,J,ae){
rn.filters.pub(v,A,N,U,H,J,ae)&&yh.pub(v,A,N,U,H,J,ae)}yh.sub(n);function K0(v,A,N,U,H,J,ae){rn.filters.sub(v,A,N,U,H,J,ae)&&Mr[v](null,A,N,U,H,J,ae)}n.pub=K0;function j0(){
yh.unsub(n),Fh.delete(n),gn.clear(),Ih(Fa,Tr,sf),c.remove(),Ee?.remove(),yn("destroy")}n.destroy=j0;function vh(){yn("init",i,e),yo(e||i.data,!1),G[w]?dh(w,G[w]):
vo(),ie=Bt.show&&(Bt.width>0||Bt.height>0),te=pe=!0,O(i.width,i.height)}return y.forEach(dr),S.forEach($i),t?t instanceof HTMLElement?(t.appendChild(c),vh()):t(
n,vh):vh(),n}fn.assign=on;fn.fmtNum=Hh;fn.rangeNum=Oa;fn.rangeLog=za;fn.rangeAsinh=Vh;fn.orient=er;fn.pxRatio=wt;fn.join=z_;fn.fmtDate=Xh,fn.tzDate=K_;fn.sync=Tp;
{fn.addGap=Nx,fn.clipGaps=Ha;let i=fn.paths={points:Ip};i.linear=Np,i.stepped=Fx,i.bars=Ox,i.spline=kx}function Qi(){let i=getComputedStyle(document.documentElement),e=t=>i.getPropertyValue(t).trim();return{paper:e("--paper"),ink:e("--ink"),soft:e("--soft"),line:e(
"--line"),bad:e("--bad"),actual:e("--actual"),actual_more:e("--actual-more"),expected:e("--expected"),contact:e("--contact"),select:e("--select"),asleep:e("--as\
leep"),way:e("--way"),lanes:[e("--actual"),e("--actual-more"),e("--expected"),e("--way")]}}function qa(i){matchMedia("(prefers-color-scheme: dark)").addEventListener(
"change",i)}var Vn=i=>i.reduce((e,t)=>t>e?t:e,-1/0),Ui=(i={})=>Object.assign(Object.create(null),i);function X(i,e={},...t){let n=Object.assign(document.createElement(
i),e);return n.append(...t),n}function An(i){if(i==null)return"\u2013";let e=Math.abs(i);return e===0||e>=.1?"".concat(Number(i.toPrecision(4))," m"):e>=.001?"".
concat(Number((i*1e3).toPrecision(4))," mm"):e>=1e-6?"".concat(Number((i*1e6).toPrecision(4))," \xB5m"):"".concat(Number(i.toPrecision(3)).toExponential()," m")}
function Lo(i){return i==null?"\u2013":"".concat(Number(i.toPrecision(5))," J")}var Op=210,Jx=[{title:"Energy",group:"energy",unit:Lo,lines:[{label:"total",column:"total",source:"states"},{label:"potential",column:"potential",source:"track",
dash:[7,4]},{label:"kinetic",column:"kinetic",source:"states",dash:[2,3]}]},{title:"Symmetry",group:"symmetry",unit:An,lines:[{label:"lateral error",column:"lat\
eral_max",source:"track"},{label:"column spread",column:"column_spread",source:"track",dash:[7,4]}]},{title:"Heights",group:"stacking",unit:An,lines:[{label:"hi\
ghest",column:"height_max",source:"track"},{label:"mean",column:"height_mean",source:"track",dash:[7,4]}]}];function Kx(i){return(i.channels??[]).map(({key:e,name:t,
unit:n,one:s})=>{let r=o=>({label:s?"value":o,column:"".concat(e," ").concat(o),source:e});return{title:"Channel ".concat(t),unit:o=>o==null?"\u2013":"".concat(
Number(o.toPrecision(6))).concat(n===""?"":" ".concat(n)),lines:s?[r("largest")]:[r("largest"),{...r("least"),dash:[7,4]}]}})}var jh=i=>i===void 0||i.every(e=>e===
null);function jx(i,e){let t=i.lines.filter(r=>!jh(e.actual?.[r.column])),n=t.length>0?[[e.actual.step,...t.map(r=>e.actual[r.column])]]:[],s=[];for(let r of t){
let o=e.expected[r.source];!o||jh(o[r.column])||(n.push([o.step,o[r.column]]),s.push(r))}return{lines:t,rings:s,table:n.length>0?fn.join(n):null}}function Qx(i,e,t,n){
let s=(a,l)=>i.unit(l),r=[n.actual,n.actual_more,n.soft],o=a=>r[e.indexOf(a)];return[{label:"step"},...e.map(a=>({label:a.label,value:s,stroke:o(a),width:1.75,dash:a.
dash,spanGaps:!0,points:{show:!1}})),...t.map(a=>({label:"".concat(a.label,", expected"),value:s,stroke:n.expected,width:1.5,class:"ring",paths:()=>null,points:{
show:!0,size:8,width:1.5,stroke:n.expected,fill:"transparent"}}))]}function ey(i,e,t){return e===null||t===null?[0,1]:e===t?e===0?[-.001,.001]:[e-Math.abs(e)/10,
t+Math.abs(t)/10]:fn.rangeNum(e,t,.1,!0)}function ty(i,e){return t=>{if(i===null)return;let n=Math.round(t.valToPos(i,"x",!0)),{top:s,height:r}=t.bbox,o=t.ctx;o.
save(),o.strokeStyle=e.bad,o.lineWidth=devicePixelRatio,o.setLineDash([3*devicePixelRatio,3*devicePixelRatio]),o.beginPath(),o.moveTo(n,s),o.lineTo(n,s+r),o.stroke(),
o.restore()}}function ny(i,e){let t={stroke:e.soft,grid:{stroke:e.line,width:1},ticks:{stroke:e.line,width:1}},n=(s,r)=>r.map(o=>o===null?"":i.unit(o));return[{
...t,label:"step",labelSize:20,size:36},{...t,values:n,size:82}]}function iy(i,e,t,n){let{lines:s,rings:r,table:o}=jx(i,t);if(o===null)return null;let a=Qi(),l={
width:e.clientWidth,height:Op,scales:{x:{time:!1},y:{range:ey}},legend:{markers:{width:2,dash:(c,d)=>c.series[d].dash?"dashed":"solid"}},axes:ny(i,a),series:Qx(
i,s,r,a),hooks:{draw:[ty(n,a)]},cursor:{y:!1,drag:{x:!0,y:!1}}};return new fn(l,o,e)}function sy(i,e){let t=i.lines.filter(n=>!jh(e.actual?.[n.column])).map(n=>{
let s=e.actual[n.column].at(-1),r=e.expected[n.source]?.[n.column]?.at(-1);return"".concat(n.label," at the end ").concat(i.unit(s),", expected ").concat(i.unit(
r))});return"".concat(i.title," over steps: ").concat(t.join("; "))}function Bp(i,e,{first:t,groups:n}){let s=[...Jx.filter(d=>n.includes(d.group)),...Kx(e)],r="\
Lines: this run. Rings: expected, where the golden keeps it (positions to the millimetre)."+(t===null?"":" Dashed upright line: first difference, step ".concat(
t,"."))+" Drag across a plot to zoom, double-click to zoom out.",o=X("div",{className:"plots"}),a=s.map(d=>{let u=X("div",{className:"plot"});return u.setAttribute(
"role","img"),u.setAttribute("aria-label",sy(d,e)),o.append(X("figure",{},X("figcaption",{textContent:d.title}),u)),u});s.length>0&&i.append(X("h3",{textContent:"\
Over the steps"}),X("p",{className:"soft",textContent:r}),o);let l=[],c=()=>{for(let d of l)d?.destroy();l=s.map((d,u)=>iy(d,a[u],e,t)),l.forEach((d,u)=>{a[u].parentElement.
hidden=d===null})};return c(),{redraw:c,resize(){l.forEach((d,u)=>{let h=a[u].clientWidth;d!==null&&h>0&&h!==d.width&&d.setSize({width:h,height:Op})})},show_step(d){
for(let u of l)u?.setCursor({left:u.valToPos(d,"x"),top:0})}}}var ry=700,Qh=(i,e)=>X("img",{src:i.querySelector("img").src,alt:"".concat(e," picture")});function kp(i){let e=S=>i.querySelector('figure[data-kind="'.concat(S,
'"]'));if(!e("expected")||!e("actual"))return;let t=Qh(e("expected"),"expected"),n=Qh(e("actual"),"actual"),s=e("difference")?Qh(e("difference"),"difference"):null;
n.className="over";let r=X("div",{className:"edge"}),o=X("span",{className:"tag",textContent:"expected"}),a=X("span",{className:"tag right",textContent:"actual"}),
l=X("div",{className:"stack"},t,n,r,o,a),c=X("input",{type:"range",min:0,max:100,value:50,className:"picture-slider"});c.setAttribute("aria-label","step ".concat(
i.dataset.step,": expected to the left of the edge, actual to the right"));let d=X("output"),u=X("button",{type:"button",textContent:"Blink",className:"picture-\
blink"}),h=X("button",{type:"button",textContent:"Difference"});s&&(s.className="over",l.append(s));let f=null,p=!1,x=S=>{n.style.clipPath="inset(0 0 0 ".concat(
S,"%)"),r.style.left="".concat(S,"%"),r.hidden=S<=0||S>=100||p,o.hidden=S<=0||p,a.hidden=S>=100||p,s&&(s.hidden=!p),p?d.value="difference: the brighter, the fur\
ther apart":S>=100?d.value="expected":S<=0?d.value="actual":d.value="left of the edge expected, right of it actual"},m=()=>{clearInterval(f),f=null,u.setAttribute(
"aria-pressed","false")},g=S=>{p=S,h.setAttribute("aria-pressed",String(S))};c.addEventListener("input",()=>{m(),g(!1),x(Number(c.value))}),u.addEventListener("\
click",()=>{let S=f!==null;if(m(),g(!1),S)return x(Number(c.value));let b=!0;u.setAttribute("aria-pressed","true"),x(100),f=setInterval(()=>{b=!b,x(b?100:0)},ry)}),
h.addEventListener("click",()=>{m(),g(!p),x(Number(c.value))}),m(),g(!1),x(50);let y=X("div",{className:"controls"},c,u,...s?[h]:[],d);i.prepend(X("div",{className:"\
viewer"},l,y))}var Gp={failed:"failed",within_bounds:"moved within bounds",unchanged:"unchanged",out_of_bounds:"out of bounds, not required",not_judged:"not judged"},Hp=Object.
keys(Gp),zp={name:i=>i.dataset.name,verdict:i=>Hp.indexOf(i.dataset.verdict),magnitude:i=>-Number(i.dataset.magnitude),category:i=>i.dataset.category},oy=(i,e)=>i<
e?-1:i>e?1:0;function ay(i,e,t){let n=[...i.rows].sort((s,r)=>(t?-1:1)*oy(zp[e](s),zp[e](r)));i.append(...n)}function ly(i){let e=[...i.querySelectorAll("th[dat\
a-sort]")];for(let t of e){let n=X("button",{type:"button",textContent:t.textContent});t.replaceChildren(n),n.addEventListener("click",()=>{let s=t.getAttribute(
"aria-sort")==="ascending";for(let r of e)r.removeAttribute("aria-sort");t.setAttribute("aria-sort",s?"descending":"ascending"),ay(i.tBodies[0],t.dataset.sort,s)})}}
function Vp(i,e,t){let n=X("select",{},X("option",{value:"",textContent:"all"}),...e.map(s=>X("option",{value:s,textContent:t(s)})));return{select:n,place:X("la\
bel",{},i,n)}}function Wp(i){ly(i);let e=[...i.tBodies[0].rows,...document.querySelectorAll("details[data-verdict]")],t=l=>[...new Set(e.map(c=>c.dataset[l]))],
n=Vp("Verdict",Hp.filter(l=>t("verdict").includes(l)),l=>Gp[l]),s=Vp("Category",t("category").sort(),l=>l),r=X("input",{type:"search"}),o=X("output"),a=()=>{let l=0;
for(let c of e){let d=c instanceof HTMLTableRowElement,u=d?c.dataset.name:c.querySelector("h3").id;c.hidden=n.select.value!==""&&c.dataset.verdict!==n.select.value||
s.select.value!==""&&c.dataset.category!==s.select.value||!u.includes(r.value),d&&!c.hidden&&++l}o.value="".concat(l," of ").concat(i.tBodies[0].rows.length," f\
ailed or moved cases")};for(let l of[n.select,s.select,r])l.addEventListener("input",a);a(),i.parentElement.before(X("div",{className:"filters"},n.place,s.place,
X("label",{},"Name",r),o))}var Sm=0,Lu=1,wm=2;var pa=1,Tm=2,ao=3,ks=0,zn=1,Gi=2,rr=0,lo=1,Nu=2,Du=3,Uu=4,Am=5;var or=100,Em=101,Cm=102,Rm=103,Pm=104,Im=200,Lm=201,Nm=202,Dm=203,Fu=204,Ou=205,Um=206,Fm=207,Om=208,Bm=209,km=210,zm=211,Vm=212,Gm=213,Hm=214,vl=0,bl=1,Ml=2,Jr=3,
Sl=4,wl=5,Tl=6,Al=7,ec=0,Wm=1,Xm=2,Hi=0,Bu=1,ku=2,zu=3,Vu=4,Gu=5,Hu=6,Wu=7;var Xu=300,ar=301,co=302,tc=303,nc=304,El=1e3,Bi=1001,Cl=1002,Mn=1003,$m=1004;var ma=1005;var Bn=1006,ic=1007;var ds=1008;var Wn=1009,$u=1010,qu=1011,ho=1012,sc=1013,Si=1014,di=1015,wi=1016,rc=1017,oc=1018,lr=1020,Yu=35902,Zu=35899,Ju=1021,Ku=1022,Ti=1023,os=1026,fs=1027,ac=1028,lc=1029,
zs=1030,cc=1031;var hc=1033,ga=33776,_a=33777,xa=33778,ya=33779,uc=35840,dc=35841,fc=35842,pc=35843,mc=36196,gc=37492,_c=37496,xc=37488,yc=37489,va=37490,vc=37491,bc=37808,Mc=37809,
Sc=37810,wc=37811,Tc=37812,Ac=37813,Ec=37814,Cc=37815,Rc=37816,Pc=37817,Ic=37818,Lc=37819,Nc=37820,Dc=37821,Uc=36492,Fc=36494,Oc=36495,Bc=36283,kc=36284,ba=36285,
zc=36286;var Vo=2300,Rl=2301,xl=2302,wu=2303,Tu=2400,Au=2401,Eu=2402;var qm=3200;var Vc=0,Ym=1,ps="",ei="srgb",Go="srgb-linear",Ho="linear",At="srgb";var yl=7680;var Zm=519,Jm=512,Km=513,jm=514,ju=515,Qm=516,eg=517,Qu=518,ed=519,tg=35044;var td="300 es",hi=2e3,Kr=2001;function cy(i){for(let e=i.length-1;e>=0;--e)if(i[e]>=65535)return!0;return!1}function hy(i){return ArrayBuffer.isView(i)&&!(i instanceof DataView)}function Wo(i){return document.createElementNS("http://www.w3.org/1999/xhtml",i)}function ng(){
let i=Wo("canvas");return i.style.display="block",i}var Xp={},jr=null;function nd(...i){let e="THREE."+i.shift();jr?jr("log",e,...i):console.log(e,...i)}function ig(i){let e=i[0];if(typeof e=="string"&&e.startsWith("TSL:")){let t=i[1];
t&&t.isStackTrace?i[0]+=" "+t.getLocation():i[1]='Stack trace not available. Enable "THREE.Node.captureStackTrace" to capture stack traces.'}return i}function qe(...i){
i=ig(i);let e="THREE."+i.shift();if(jr)jr("warn",e,...i);else{let t=i[0];t&&t.isStackTrace?console.warn(t.getError(e)):console.warn(e,...i)}}function Ke(...i){i=
ig(i);let e="THREE."+i.shift();if(jr)jr("error",e,...i);else{let t=i[0];t&&t.isStackTrace?console.error(t.getError(e)):console.error(e,...i)}}function zo(...i){
let e=i.join(" ");e in Xp||(Xp[e]=!0,qe(...i))}function sg(i,e,t){return new Promise(function(n,s){function r(){switch(i.clientWaitSync(e,i.SYNC_FLUSH_COMMANDS_BIT,0)){case i.WAIT_FAILED:s();break;case i.TIMEOUT_EXPIRED:
setTimeout(r,t);break;default:n()}}setTimeout(r,t)})}var rg={[vl]:vl,[Ml]:Tl,[Sl]:Sl,[Jr]:wl,[bl]:bl,[Tl]:Ml,[Al]:Al,[wl]:Jr},ki=class{addEventListener(e,t){this.
_listeners===void 0&&(this._listeners={});let n=this._listeners;n[e]===void 0&&(n[e]=[]),n[e].indexOf(t)===-1&&n[e].push(t)}hasEventListener(e,t){let n=this._listeners;
return n===void 0?!1:n[e]!==void 0&&n[e].indexOf(t)!==-1}removeEventListener(e,t){let n=this._listeners;if(n===void 0)return;let s=n[e];if(s!==void 0){let r=s.indexOf(
t);r!==-1&&s.splice(r,1)}}dispatchEvent(e){let t=this._listeners;if(t===void 0)return;let n=t[e.type];if(n!==void 0){e.target=this;let s=n.slice(0);for(let r=0,
o=s.length;r<o;r++)s[r].call(this,e);e.target=null}}},En=["00","01","02","03","04","05","06","07","08","09","0a","0b","0c","0d","0e","0f","10","11","12","13","1\
4","15","16","17","18","19","1a","1b","1c","1d","1e","1f","20","21","22","23","24","25","26","27","28","29","2a","2b","2c","2d","2e","2f","30","31","32","33","3\
4","35","36","37","38","39","3a","3b","3c","3d","3e","3f","40","41","42","43","44","45","46","47","48","49","4a","4b","4c","4d","4e","4f","50","51","52","53","5\
4","55","56","57","58","59","5a","5b","5c","5d","5e","5f","60","61","62","63","64","65","66","67","68","69","6a","6b","6c","6d","6e","6f","70","71","72","73","7\
4","75","76","77","78","79","7a","7b","7c","7d","7e","7f","80","81","82","83","84","85","86","87","88","89","8a","8b","8c","8d","8e","8f","90","91","92","93","9\
4","95","96","97","98","99","9a","9b","9c","9d","9e","9f","a0","a1","a2","a3","a4","a5","a6","a7","a8","a9","aa","ab","ac","ad","ae","af","b0","b1","b2","b3","b\
4","b5","b6","b7","b8","b9","ba","bb","bc","bd","be","bf","c0","c1","c2","c3","c4","c5","c6","c7","c8","c9","ca","cb","cc","cd","ce","cf","d0","d1","d2","d3","d\
4","d5","d6","d7","d8","d9","da","db","dc","dd","de","df","e0","e1","e2","e3","e4","e5","e6","e7","e8","e9","ea","eb","ec","ed","ee","ef","f0","f1","f2","f3","f\
4","f5","f6","f7","f8","f9","fa","fb","fc","fd","fe","ff"];var eu=Math.PI/180,Pl=180/Math.PI;function Ma(){let i=Math.random()*4294967295|0,e=Math.random()*4294967295|0,t=Math.random()*4294967295|0,n=Math.random()*4294967295|
0;return(En[i&255]+En[i>>8&255]+En[i>>16&255]+En[i>>24&255]+"-"+En[e&255]+En[e>>8&255]+"-"+En[e>>16&15|64]+En[e>>24&255]+"-"+En[t&63|128]+En[t>>8&255]+"-"+En[t>>
16&255]+En[t>>24&255]+En[n&255]+En[n>>8&255]+En[n>>16&255]+En[n>>24&255]).toLowerCase()}function at(i,e,t){return Math.max(e,Math.min(t,i))}function uy(i,e){return(i%
e+e)%e}function tu(i,e,t){return(1-t)*i+t*e}function og(i){return Math.pow(2,Math.floor(Math.log(i)/Math.LN2))}function id(i){switch(i.constructor){case Uint32Array:return 4294967295;case Uint16Array:return 65535;case Uint8Array:case Uint8ClampedArray:return 255;case Int32Array:
return 2147483647;case Int16Array:return 32767;case Int8Array:return 127;default:return}}function dy(i,e){if(e.constructor===Float32Array)return i;let t=id(e);if(t===
void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.max(i/t,-1)}function fy(i,e){if(e.constructor===Float32Array)return i;let t=id(e);
if(t===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.round(i*t)}var st=class{static{this.prototype.isVector2=!0}constructor(e=0,t=0){this.x=e,this.y=t}get width(){return this.x}set width(e){this.x=e}get height(){return this.
y}set height(e){this.y=e}set(e,t){return this.x=e,this.y=t,this}setScalar(e){return this.x=e,this.y=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,
this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;default:throw new Error("THREE.Vector2: index is out of range: "+e)}return this}getComponent(e){
switch(e){case 0:return this.x;case 1:return this.y;default:throw new Error("THREE.Vector2: index is out of range: "+e)}}clone(){return new this.constructor(this.
x,this.y)}copy(e){return this.x=e.x,this.y=e.y,this}add(e){return this.x+=e.x,this.y+=e.y,this}addScalar(e){return this.x+=e,this.y+=e,this}addVectors(e,t){return this.
x=e.x+t.x,this.y=e.y+t.y,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this}subScalar(e){return this.x-=
e,this.y-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this}multiply(e){return this.x*=e.x,this.y*=e.y,this}multiplyScalar(e){return this.x*=e,this.
y*=e,this}divide(e){return this.x/=e.x,this.y/=e.y,this}divideScalar(e){return this.multiplyScalar(1/e)}applyMatrix3(e){let t=this.x,n=this.y,s=e.elements;return this.
x=s[0]*t+s[3]*n+s[6],this.y=s[1]*t+s[4]*n+s[7],this}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this}max(e){return this.x=Math.max(this.
x,e.x),this.y=Math.max(this.y,e.y),this}clamp(e,t){return this.x=at(this.x,e.x,t.x),this.y=at(this.y,e.y,t.y),this}clampScalar(e,t){return this.x=at(this.x,e,t),
this.y=at(this.y,e,t),this}clampLength(e,t){let n=this.length();return this.divideScalar(n||1).multiplyScalar(at(n,e,t))}floor(){return this.x=Math.floor(this.x),
this.y=Math.floor(this.y),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.
y),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this}negate(){return this.x=-this.x,this.y=-this.y,this}dot(e){return this.x*e.
x+this.y*e.y}cross(e){return this.x*e.y-this.y*e.x}lengthSq(){return this.x*this.x+this.y*this.y}length(){return Math.sqrt(this.x*this.x+this.y*this.y)}manhattanLength(){
return Math.abs(this.x)+Math.abs(this.y)}normalize(){return this.divideScalar(this.length()||1)}angle(){return Math.atan2(-this.y,-this.x)+Math.PI}angleTo(e){let t=Math.
sqrt(this.lengthSq()*e.lengthSq());if(t===0)return Math.PI/2;let n=this.dot(e)/t;return Math.acos(at(n,-1,1))}distanceTo(e){return Math.sqrt(this.distanceToSquared(
e))}distanceToSquared(e){let t=this.x-e.x,n=this.y-e.y;return t*t+n*n}manhattanDistanceTo(e){return Math.abs(this.x-e.x)+Math.abs(this.y-e.y)}setLength(e){return this.
normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this}lerpVectors(e,t,n){return this.x=e.x+(t.x-e.x)*n,this.y=e.y+(t.
y-e.y)*n,this}equals(e){return e.x===this.x&&e.y===this.y}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.
y,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this}rotateAround(e,t){let n=Math.cos(t),s=Math.sin(t),r=this.x-e.x,o=this.y-e.y;return this.
x=r*n-o*s+e.x,this.y=r*s+o*n+e.y,this}random(){return this.x=Math.random(),this.y=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y}},kn=class{constructor(e=0,t=0,n=0,s=1){
this.isQuaternion=!0,this._x=e,this._y=t,this._z=n,this._w=s}static slerpFlat(e,t,n,s,r,o,a){let l=n[s+0],c=n[s+1],d=n[s+2],u=n[s+3],h=r[o+0],f=r[o+1],p=r[o+2],
x=r[o+3];if(u!==x||l!==h||c!==f||d!==p){let m=l*h+c*f+d*p+u*x;m<0&&(h=-h,f=-f,p=-p,x=-x,m=-m);let g=1-a;if(m<.9995){let y=Math.acos(m),S=Math.sin(y);g=Math.sin(
g*y)/S,a=Math.sin(a*y)/S,l=l*g+h*a,c=c*g+f*a,d=d*g+p*a,u=u*g+x*a}else{l=l*g+h*a,c=c*g+f*a,d=d*g+p*a,u=u*g+x*a;let y=1/Math.sqrt(l*l+c*c+d*d+u*u);l*=y,c*=y,d*=y,
u*=y}}e[t]=l,e[t+1]=c,e[t+2]=d,e[t+3]=u}static multiplyQuaternionsFlat(e,t,n,s,r,o){let a=n[s],l=n[s+1],c=n[s+2],d=n[s+3],u=r[o],h=r[o+1],f=r[o+2],p=r[o+3];return e[t]=
a*p+d*u+l*f-c*h,e[t+1]=l*p+d*h+c*u-a*f,e[t+2]=c*p+d*f+a*h-l*u,e[t+3]=d*p-a*u-l*h-c*f,e}get x(){return this._x}set x(e){this._x=e,this._onChangeCallback()}get y(){
return this._y}set y(e){this._y=e,this._onChangeCallback()}get z(){return this._z}set z(e){this._z=e,this._onChangeCallback()}get w(){return this._w}set w(e){this.
_w=e,this._onChangeCallback()}set(e,t,n,s){return this._x=e,this._y=t,this._z=n,this._w=s,this._onChangeCallback(),this}clone(){return new this.constructor(this.
_x,this._y,this._z,this._w)}copy(e){return this._x=e.x,this._y=e.y,this._z=e.z,this._w=e.w,this._onChangeCallback(),this}setFromEuler(e,t=!0){let n=e._x,s=e._y,
r=e._z,o=e._order,a=Math.cos,l=Math.sin,c=a(n/2),d=a(s/2),u=a(r/2),h=l(n/2),f=l(s/2),p=l(r/2);switch(o){case"XYZ":this._x=h*d*u+c*f*p,this._y=c*f*u-h*d*p,this._z=
c*d*p+h*f*u,this._w=c*d*u-h*f*p;break;case"YXZ":this._x=h*d*u+c*f*p,this._y=c*f*u-h*d*p,this._z=c*d*p-h*f*u,this._w=c*d*u+h*f*p;break;case"ZXY":this._x=h*d*u-c*
f*p,this._y=c*f*u+h*d*p,this._z=c*d*p+h*f*u,this._w=c*d*u-h*f*p;break;case"ZYX":this._x=h*d*u-c*f*p,this._y=c*f*u+h*d*p,this._z=c*d*p-h*f*u,this._w=c*d*u+h*f*p;
break;case"YZX":this._x=h*d*u+c*f*p,this._y=c*f*u+h*d*p,this._z=c*d*p-h*f*u,this._w=c*d*u-h*f*p;break;case"XZY":this._x=h*d*u-c*f*p,this._y=c*f*u-h*d*p,this._z=
c*d*p+h*f*u,this._w=c*d*u+h*f*p;break;default:qe("Quaternion: .setFromEuler() encountered an unknown order: "+o)}return t===!0&&this._onChangeCallback(),this}setFromAxisAngle(e,t){
let n=t/2,s=Math.sin(n);return this._x=e.x*s,this._y=e.y*s,this._z=e.z*s,this._w=Math.cos(n),this._onChangeCallback(),this}setFromRotationMatrix(e){let t=e.elements,
n=t[0],s=t[4],r=t[8],o=t[1],a=t[5],l=t[9],c=t[2],d=t[6],u=t[10],h=n+a+u;if(h>0){let f=.5/Math.sqrt(h+1);this._w=.25/f,this._x=(d-l)*f,this._y=(r-c)*f,this._z=(o-
s)*f}else if(n>a&&n>u){let f=2*Math.sqrt(1+n-a-u);this._w=(d-l)/f,this._x=.25*f,this._y=(s+o)/f,this._z=(r+c)/f}else if(a>u){let f=2*Math.sqrt(1+a-n-u);this._w=
(r-c)/f,this._x=(s+o)/f,this._y=.25*f,this._z=(l+d)/f}else{let f=2*Math.sqrt(1+u-n-a);this._w=(o-s)/f,this._x=(r+c)/f,this._y=(l+d)/f,this._z=.25*f}return this.
_onChangeCallback(),this}setFromUnitVectors(e,t){let n=e.dot(t)+1;return n<1e-8?(n=0,Math.abs(e.x)>Math.abs(e.z)?(this._x=-e.y,this._y=e.x,this._z=0,this._w=n):
(this._x=0,this._y=-e.z,this._z=e.y,this._w=n)):(this._x=e.y*t.z-e.z*t.y,this._y=e.z*t.x-e.x*t.z,this._z=e.x*t.y-e.y*t.x,this._w=n),this.normalize()}angleTo(e){
return 2*Math.acos(Math.abs(at(this.dot(e),-1,1)))}rotateTowards(e,t){let n=this.angleTo(e);if(n===0)return this;let s=Math.min(1,t/n);return this.slerp(e,s),this}identity(){
return this.set(0,0,0,1)}invert(){return this.conjugate()}conjugate(){return this._x*=-1,this._y*=-1,this._z*=-1,this._onChangeCallback(),this}dot(e){return this.
_x*e._x+this._y*e._y+this._z*e._z+this._w*e._w}lengthSq(){return this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w}length(){return Math.sqrt(this.
_x*this._x+this._y*this._y+this._z*this._z+this._w*this._w)}normalize(){let e=this.length();return e===0?(this._x=0,this._y=0,this._z=0,this._w=1):(e=1/e,this._x=
this._x*e,this._y=this._y*e,this._z=this._z*e,this._w=this._w*e),this._onChangeCallback(),this}multiply(e){return this.multiplyQuaternions(this,e)}premultiply(e){
return this.multiplyQuaternions(e,this)}multiplyQuaternions(e,t){let n=e._x,s=e._y,r=e._z,o=e._w,a=t._x,l=t._y,c=t._z,d=t._w;return this._x=n*d+o*a+s*c-r*l,this.
_y=s*d+o*l+r*a-n*c,this._z=r*d+o*c+n*l-s*a,this._w=o*d-n*a-s*l-r*c,this._onChangeCallback(),this}slerp(e,t){let n=e._x,s=e._y,r=e._z,o=e._w,a=this.dot(e);a<0&&(n=
-n,s=-s,r=-r,o=-o,a=-a);let l=1-t;if(a<.9995){let c=Math.acos(a),d=Math.sin(c);l=Math.sin(l*c)/d,t=Math.sin(t*c)/d,this._x=this._x*l+n*t,this._y=this._y*l+s*t,this.
_z=this._z*l+r*t,this._w=this._w*l+o*t,this._onChangeCallback()}else this._x=this._x*l+n*t,this._y=this._y*l+s*t,this._z=this._z*l+r*t,this._w=this._w*l+o*t,this.
normalize();return this}slerpQuaternions(e,t,n){return this.copy(e).slerp(t,n)}random(){let e=2*Math.PI*Math.random(),t=2*Math.PI*Math.random(),n=Math.random(),
s=Math.sqrt(1-n),r=Math.sqrt(n);return this.set(s*Math.sin(e),s*Math.cos(e),r*Math.sin(t),r*Math.cos(t))}equals(e){return e._x===this._x&&e._y===this._y&&e._z===
this._z&&e._w===this._w}fromArray(e,t=0){return this._x=e[t],this._y=e[t+1],this._z=e[t+2],this._w=e[t+3],this._onChangeCallback(),this}toArray(e=[],t=0){return e[t]=
this._x,e[t+1]=this._y,e[t+2]=this._z,e[t+3]=this._w,e}fromBufferAttribute(e,t){return this._x=e.getX(t),this._y=e.getY(t),this._z=e.getZ(t),this._w=e.getW(t),this.
_onChangeCallback(),this}toJSON(){return this.toArray()}_onChange(e){return this._onChangeCallback=e,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,
yield this._y,yield this._z,yield this._w}},V=class{static{this.prototype.isVector3=!0}constructor(e=0,t=0,n=0){this.x=e,this.y=t,this.z=n}set(e,t,n){return n===
void 0&&(n=this.z),this.x=e,this.y=t,this.z=n,this}setScalar(e){return this.x=e,this.y=e,this.z=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setZ(e){
return this.z=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;case 2:this.z=t;break;default:throw new Error("THREE.Vector3: index\
 is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;case 2:return this.z;default:throw new Error("THREE.Vecto\
r3: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y,this.z)}copy(e){return this.x=e.x,this.y=e.y,this.z=e.z,this}add(e){return this.
x+=e.x,this.y+=e.y,this.z+=e.z,this}addScalar(e){return this.x+=e,this.y+=e,this.z+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this.z=e.z+t.z,this}addScaledVector(e,t){
return this.x+=e.x*t,this.y+=e.y*t,this.z+=e.z*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this.z-=e.z,this}subScalar(e){return this.x-=e,this.y-=e,this.z-=e,this}subVectors(e,t){
return this.x=e.x-t.x,this.y=e.y-t.y,this.z=e.z-t.z,this}multiply(e){return this.x*=e.x,this.y*=e.y,this.z*=e.z,this}multiplyScalar(e){return this.x*=e,this.y*=
e,this.z*=e,this}multiplyVectors(e,t){return this.x=e.x*t.x,this.y=e.y*t.y,this.z=e.z*t.z,this}applyEuler(e){return this.applyQuaternion($p.setFromEuler(e))}applyAxisAngle(e,t){
return this.applyQuaternion($p.setFromAxisAngle(e,t))}applyMatrix3(e){let t=this.x,n=this.y,s=this.z,r=e.elements;return this.x=r[0]*t+r[3]*n+r[6]*s,this.y=r[1]*
t+r[4]*n+r[7]*s,this.z=r[2]*t+r[5]*n+r[8]*s,this}applyNormalMatrix(e){return this.applyMatrix3(e).normalize()}applyMatrix4(e){let t=this.x,n=this.y,s=this.z,r=e.
elements,o=1/(r[3]*t+r[7]*n+r[11]*s+r[15]);return this.x=(r[0]*t+r[4]*n+r[8]*s+r[12])*o,this.y=(r[1]*t+r[5]*n+r[9]*s+r[13])*o,this.z=(r[2]*t+r[6]*n+r[10]*s+r[14])*
o,this}applyQuaternion(e){let t=this.x,n=this.y,s=this.z,r=e.x,o=e.y,a=e.z,l=e.w,c=2*(o*s-a*n),d=2*(a*t-r*s),u=2*(r*n-o*t);return this.x=t+l*c+o*u-a*d,this.y=n+
l*d+a*c-r*u,this.z=s+l*u+r*d-o*c,this}project(e){return this.applyMatrix4(e.matrixWorldInverse).applyMatrix4(e.projectionMatrix)}unproject(e){return this.applyMatrix4(
e.projectionMatrixInverse).applyMatrix4(e.matrixWorld)}transformDirection(e){let t=this.x,n=this.y,s=this.z,r=e.elements;return this.x=r[0]*t+r[4]*n+r[8]*s,this.
y=r[1]*t+r[5]*n+r[9]*s,this.z=r[2]*t+r[6]*n+r[10]*s,this.normalize()}divide(e){return this.x/=e.x,this.y/=e.y,this.z/=e.z,this}divideScalar(e){return this.multiplyScalar(
1/e)}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this.z=Math.min(this.z,e.z),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.
max(this.y,e.y),this.z=Math.max(this.z,e.z),this}clamp(e,t){return this.x=at(this.x,e.x,t.x),this.y=at(this.y,e.y,t.y),this.z=at(this.z,e.z,t.z),this}clampScalar(e,t){
return this.x=at(this.x,e,t),this.y=at(this.y,e,t),this.z=at(this.z,e,t),this}clampLength(e,t){let n=this.length();return this.divideScalar(n||1).multiplyScalar(
at(n,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.
ceil(this.y),this.z=Math.ceil(this.z),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this}roundToZero(){return this.
x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this}dot(e){return this.
x*e.x+this.y*e.y+this.z*e.z}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z)}manhattanLength(){
return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)}normalize(){return this.divideScalar(this.length()||1)}setLength(e){return this.normalize().multiplyScalar(
e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this.z+=(e.z-this.z)*t,this}lerpVectors(e,t,n){return this.x=e.x+(t.x-e.x)*n,this.y=e.y+(t.y-e.
y)*n,this.z=e.z+(t.z-e.z)*n,this}cross(e){return this.crossVectors(this,e)}crossVectors(e,t){let n=e.x,s=e.y,r=e.z,o=t.x,a=t.y,l=t.z;return this.x=s*l-r*a,this.
y=r*o-n*l,this.z=n*a-s*o,this}projectOnVector(e){let t=e.lengthSq();if(t===0)return this.set(0,0,0);let n=e.dot(this)/t;return this.copy(e).multiplyScalar(n)}projectOnPlane(e){
return nu.copy(this).projectOnVector(e),this.sub(nu)}reflect(e){return this.sub(nu.copy(e).multiplyScalar(2*this.dot(e)))}angleTo(e){let t=Math.sqrt(this.lengthSq()*
e.lengthSq());if(t===0)return Math.PI/2;let n=this.dot(e)/t;return Math.acos(at(n,-1,1))}distanceTo(e){return Math.sqrt(this.distanceToSquared(e))}distanceToSquared(e){
let t=this.x-e.x,n=this.y-e.y,s=this.z-e.z;return t*t+n*n+s*s}manhattanDistanceTo(e){return Math.abs(this.x-e.x)+Math.abs(this.y-e.y)+Math.abs(this.z-e.z)}setFromSpherical(e){
return this.setFromSphericalCoords(e.radius,e.phi,e.theta)}setFromSphericalCoords(e,t,n){let s=Math.sin(t)*e;return this.x=s*Math.sin(n),this.y=Math.cos(t)*e,this.
z=s*Math.cos(n),this}setFromCylindrical(e){return this.setFromCylindricalCoords(e.radius,e.theta,e.y)}setFromCylindricalCoords(e,t,n){return this.x=e*Math.sin(t),
this.y=n,this.z=e*Math.cos(t),this}setFromMatrixPosition(e){let t=e.elements;return this.x=t[12],this.y=t[13],this.z=t[14],this}setFromMatrixScale(e){let t=this.
setFromMatrixColumn(e,0).length(),n=this.setFromMatrixColumn(e,1).length(),s=this.setFromMatrixColumn(e,2).length();return this.x=t,this.y=n,this.z=s,this}setFromMatrixColumn(e,t){
return this.fromArray(e.elements,t*4)}setFromMatrix3Column(e,t){return this.fromArray(e.elements,t*3)}setFromEuler(e){return this.x=e._x,this.y=e._y,this.z=e._z,
this}setFromColor(e){return this.x=e.r,this.y=e.g,this.z=e.b,this}equals(e){return e.x===this.x&&e.y===this.y&&e.z===this.z}fromArray(e,t=0){return this.x=e[t],
this.y=e[t+1],this.z=e[t+2],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e[t+2]=this.z,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(
t),this.z=e.getZ(t),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this}randomDirection(){let e=Math.random()*Math.PI*2,t=Math.
random()*2-1,n=Math.sqrt(1-t*t);return this.x=n*Math.cos(e),this.y=t,this.z=n*Math.sin(e),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z}},nu=new V,
$p=new kn,Qe=class{static{this.prototype.isMatrix3=!0}constructor(e,t,n,s,r,o,a,l,c){this.elements=[1,0,0,0,1,0,0,0,1],e!==void 0&&this.set(e,t,n,s,r,o,a,l,c)}set(e,t,n,s,r,o,a,l,c){
let d=this.elements;return d[0]=e,d[1]=s,d[2]=a,d[3]=t,d[4]=r,d[5]=l,d[6]=n,d[7]=o,d[8]=c,this}identity(){return this.set(1,0,0,0,1,0,0,0,1),this}copy(e){let t=this.
elements,n=e.elements;return t[0]=n[0],t[1]=n[1],t[2]=n[2],t[3]=n[3],t[4]=n[4],t[5]=n[5],t[6]=n[6],t[7]=n[7],t[8]=n[8],this}extractBasis(e,t,n){return e.setFromMatrix3Column(
this,0),t.setFromMatrix3Column(this,1),n.setFromMatrix3Column(this,2),this}setFromMatrix4(e){let t=e.elements;return this.set(t[0],t[4],t[8],t[1],t[5],t[9],t[2],
t[6],t[10]),this}multiply(e){return this.multiplyMatrices(this,e)}premultiply(e){return this.multiplyMatrices(e,this)}multiplyMatrices(e,t){let n=e.elements,s=t.
elements,r=this.elements,o=n[0],a=n[3],l=n[6],c=n[1],d=n[4],u=n[7],h=n[2],f=n[5],p=n[8],x=s[0],m=s[3],g=s[6],y=s[1],S=s[4],b=s[7],C=s[2],w=s[5],_=s[8];return r[0]=
o*x+a*y+l*C,r[3]=o*m+a*S+l*w,r[6]=o*g+a*b+l*_,r[1]=c*x+d*y+u*C,r[4]=c*m+d*S+u*w,r[7]=c*g+d*b+u*_,r[2]=h*x+f*y+p*C,r[5]=h*m+f*S+p*w,r[8]=h*g+f*b+p*_,this}multiplyScalar(e){
let t=this.elements;return t[0]*=e,t[3]*=e,t[6]*=e,t[1]*=e,t[4]*=e,t[7]*=e,t[2]*=e,t[5]*=e,t[8]*=e,this}determinant(){let e=this.elements,t=e[0],n=e[1],s=e[2],r=e[3],
o=e[4],a=e[5],l=e[6],c=e[7],d=e[8];return t*o*d-t*a*c-n*r*d+n*a*l+s*r*c-s*o*l}invert(){let e=this.elements,t=e[0],n=e[1],s=e[2],r=e[3],o=e[4],a=e[5],l=e[6],c=e[7],
d=e[8],u=d*o-a*c,h=a*l-d*r,f=c*r-o*l,p=t*u+n*h+s*f;if(p===0)return this.set(0,0,0,0,0,0,0,0,0);let x=1/p;return e[0]=u*x,e[1]=(s*c-d*n)*x,e[2]=(a*n-s*o)*x,e[3]=
h*x,e[4]=(d*t-s*l)*x,e[5]=(s*r-a*t)*x,e[6]=f*x,e[7]=(n*l-c*t)*x,e[8]=(o*t-n*r)*x,this}transpose(){let e,t=this.elements;return e=t[1],t[1]=t[3],t[3]=e,e=t[2],t[2]=
t[6],t[6]=e,e=t[5],t[5]=t[7],t[7]=e,this}getNormalMatrix(e){return this.setFromMatrix4(e).invert().transpose()}transposeIntoArray(e){let t=this.elements;return e[0]=
t[0],e[1]=t[3],e[2]=t[6],e[3]=t[1],e[4]=t[4],e[5]=t[7],e[6]=t[2],e[7]=t[5],e[8]=t[8],this}setUvTransform(e,t,n,s,r,o,a){let l=Math.cos(r),c=Math.sin(r);return this.
set(n*l,n*c,-n*(l*o+c*a)+o+e,-s*c,s*l,-s*(-c*o+l*a)+a+t,0,0,1),this}scale(e,t){return zo("Matrix3: .scale() is deprecated. Use .makeScale() instead."),this.premultiply(
iu.makeScale(e,t)),this}rotate(e){return zo("Matrix3: .rotate() is deprecated. Use .makeRotation() instead."),this.premultiply(iu.makeRotation(-e)),this}translate(e,t){
return zo("Matrix3: .translate() is deprecated. Use .makeTranslation() instead."),this.premultiply(iu.makeTranslation(e,t)),this}makeTranslation(e,t){return e.isVector2?
this.set(1,0,e.x,0,1,e.y,0,0,1):this.set(1,0,e,0,1,t,0,0,1),this}makeRotation(e){let t=Math.cos(e),n=Math.sin(e);return this.set(t,-n,0,n,t,0,0,0,1),this}makeScale(e,t){
return this.set(e,0,0,0,t,0,0,0,1),this}equals(e){let t=this.elements,n=e.elements;for(let s=0;s<9;s++)if(t[s]!==n[s])return!1;return!0}fromArray(e,t=0){for(let n=0;n<
9;n++)this.elements[n]=e[n+t];return this}toArray(e=[],t=0){let n=this.elements;return e[t]=n[0],e[t+1]=n[1],e[t+2]=n[2],e[t+3]=n[3],e[t+4]=n[4],e[t+5]=n[5],e[t+
6]=n[6],e[t+7]=n[7],e[t+8]=n[8],e}clone(){return new this.constructor().fromArray(this.elements)}},iu=new Qe,qp=new Qe().set(.4123908,.3575843,.1804808,.212639,
.7151687,.0721923,.0193308,.1191948,.9505322),Yp=new Qe().set(3.2409699,-1.5373832,-.4986108,-.9692436,1.8759675,.0415551,.0556301,-.203977,1.0569715);function py(){
let i={enabled:!0,workingColorSpace:Go,spaces:{},convert:function(s,r,o){return this.enabled===!1||r===o||!r||!o||(this.spaces[r].transfer===At&&(s.r=rs(s.r),s.
g=rs(s.g),s.b=rs(s.b)),this.spaces[r].primaries!==this.spaces[o].primaries&&(s.applyMatrix3(this.spaces[r].toXYZ),s.applyMatrix3(this.spaces[o].fromXYZ)),this.spaces[o].
transfer===At&&(s.r=Zr(s.r),s.g=Zr(s.g),s.b=Zr(s.b))),s},workingToColorSpace:function(s,r){return this.convert(s,this.workingColorSpace,r)},colorSpaceToWorking:function(s,r){
return this.convert(s,r,this.workingColorSpace)},getPrimaries:function(s){return this.spaces[s].primaries},getTransfer:function(s){return s===ps?Ho:this.spaces[s].
transfer},getToneMappingMode:function(s){return this.spaces[s].outputColorSpaceConfig.toneMappingMode||"standard"},getLuminanceCoefficients:function(s,r=this.workingColorSpace){
return s.fromArray(this.spaces[r].luminanceCoefficients)},define:function(s){Object.assign(this.spaces,s)},_getMatrix:function(s,r,o){return s.copy(this.spaces[o].
fromXYZ).multiply(this.spaces[r].toXYZ)},_getDrawingBufferColorSpace:function(s){return this.spaces[s].outputColorSpaceConfig.drawingBufferColorSpace},_getUnpackColorSpace:function(s=this.
workingColorSpace){return this.spaces[s].workingColorSpaceConfig.unpackColorSpace}},e=[.64,.33,.3,.6,.15,.06],t=[.2126,.7152,.0722],n=[.3127,.329];return i.define(
{[Go]:{primaries:e,whitePoint:n,transfer:Ho,toXYZ:qp,fromXYZ:Yp,luminanceCoefficients:t,workingColorSpaceConfig:{unpackColorSpace:ei},outputColorSpaceConfig:{drawingBufferColorSpace:ei}},
[ei]:{primaries:e,whitePoint:n,transfer:At,toXYZ:qp,fromXYZ:Yp,luminanceCoefficients:t,outputColorSpaceConfig:{drawingBufferColorSpace:ei}}}),i}var _t=py();function rs(i){
return i<.04045?i*.0773993808:Math.pow(i*.9478672986+.0521327014,2.4)}function Zr(i){return i<.0031308?i*12.92:1.055*Math.pow(i,.41666)-.055}var Nr,Il=class{static getDataURL(e,t="\
image/png"){if(/^data:/i.test(e.src)||typeof HTMLCanvasElement>"u")return e.src;let n;if(e instanceof HTMLCanvasElement)n=e;else{Nr===void 0&&(Nr=Wo("canvas")),
Nr.width=e.width,Nr.height=e.height;let s=Nr.getContext("2d");e instanceof ImageData?s.putImageData(e,0,0):s.drawImage(e,0,0,e.width,e.height),n=Nr}return n.toDataURL(
t)}static sRGBToLinear(e){if(typeof HTMLImageElement<"u"&&e instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&e instanceof HTMLCanvasElement||typeof ImageBitmap<
"u"&&e instanceof ImageBitmap){let t=Wo("canvas");t.width=e.width,t.height=e.height;let n=t.getContext("2d");n.drawImage(e,0,0,e.width,e.height);let s=n.getImageData(
0,0,e.width,e.height),r=s.data;for(let o=0;o<r.length;o++)r[o]=rs(r[o]/255)*255;return n.putImageData(s,0,0),t}else if(e.data){let t=e.data.slice(0);for(let n=0;n<
t.length;n++)t instanceof Uint8Array||t instanceof Uint8ClampedArray?t[n]=Math.floor(rs(t[n]/255)*255):t[n]=rs(t[n]);return{data:t,width:e.width,height:e.height}}else
return qe("ImageUtils.sRGBToLinear(): Unsupported image type. No color space conversion applied."),e}},my=0,Qr=class{constructor(e=null){this.isTextureSource=!0,
Object.defineProperty(this,"id",{value:my++}),this.uuid=Ma(),this.data=e,this.dataReady=!0,this.version=0}getSize(e){let t=this.data;return typeof HTMLVideoElement<
"u"&&t instanceof HTMLVideoElement?e.set(t.videoWidth,t.videoHeight,0):typeof VideoFrame<"u"&&t instanceof VideoFrame?e.set(t.displayWidth,t.displayHeight,0):t!==
null?e.set(t.width||0,t.height||0,t.depth||0):e.set(0,0,0),e}set needsUpdate(e){e===!0&&this.version++}toJSON(e){let t=e===void 0||typeof e=="string";if(!t&&e.images[this.
uuid]!==void 0)return e.images[this.uuid];let n={uuid:this.uuid,url:""},s=this.data;if(s!==null){let r;if(Array.isArray(s)){r=[];for(let o=0,a=s.length;o<a;o++)
s[o].isDataTexture?r.push(su(s[o].image)):r.push(su(s[o]))}else r=su(s);n.url=r}return t||(e.images[this.uuid]=n),n}};function su(i){return typeof HTMLImageElement<
"u"&&i instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&i instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&i instanceof ImageBitmap?Il.getDataURL(
i):i.data?{data:Array.from(i.data),width:i.width,height:i.height,type:i.data.constructor.name}:(qe("Texture: Unable to serialize Texture."),{})}var gy=0,ru=new V,Hn=class i extends ki{constructor(e=i.DEFAULT_IMAGE,t=i.DEFAULT_MAPPING,n=Bi,s=Bi,r=Bn,o=ds,a=Ti,l=Wn,c=i.DEFAULT_ANISOTROPY,d=ps){super(),this.
isTexture=!0,Object.defineProperty(this,"id",{value:gy++}),this.uuid=Ma(),this.name="",this.source=new Qr(e),this.mipmaps=[],this.mapping=t,this.channel=0,this.
wrapS=n,this.wrapT=s,this.magFilter=r,this.minFilter=o,this.anisotropy=c,this.format=a,this.internalFormat=null,this.type=l,this.offset=new st(0,0),this.repeat=
new st(1,1),this.center=new st(0,0),this.rotation=0,this.matrixAutoUpdate=!0,this.matrix=new Qe,this.generateMipmaps=!0,this.mipmapsAutoUpdate=!0,this.premultiplyAlpha=
!1,this.flipY=!0,this.unpackAlignment=4,this.colorSpace=d,this.userData={},this.updateRanges=[],this.version=0,this.onUpdate=null,this.renderTarget=null,this.isRenderTargetTexture=
!1,this.isArrayTexture=!!(e&&e.depth&&e.depth>1),this.pmremVersion=0,this.isPMREMTexture=!1,this.normalized=!1}get width(){return this.source.getSize(ru).x}get height(){
return this.source.getSize(ru).y}get depth(){return this.source.getSize(ru).z}get image(){return this.source.data}set image(e){this.source.data=e}updateMatrix(){
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
Xu)return e;if(e.applyMatrix3(this.matrix),e.x<0||e.x>1)switch(this.wrapS){case El:e.x=e.x-Math.floor(e.x);break;case Bi:e.x=e.x<0?0:1;break;case Cl:Math.abs(Math.
floor(e.x)%2)===1?e.x=Math.ceil(e.x)-e.x:e.x=e.x-Math.floor(e.x);break}if(e.y<0||e.y>1)switch(this.wrapT){case El:e.y=e.y-Math.floor(e.y);break;case Bi:e.y=e.y<
0?0:1;break;case Cl:Math.abs(Math.floor(e.y)%2)===1?e.y=Math.ceil(e.y)-e.y:e.y=e.y-Math.floor(e.y);break}return this.flipY&&(e.y=1-e.y),e}set needsUpdate(e){e===
!0&&(this.version++,this.source.needsUpdate=!0)}set needsPMREMUpdate(e){e===!0&&this.pmremVersion++}};Hn.DEFAULT_IMAGE=null;Hn.DEFAULT_MAPPING=Xu;Hn.DEFAULT_ANISOTROPY=
1;var Wt=class{static{this.prototype.isVector4=!0}constructor(e=0,t=0,n=0,s=1){this.x=e,this.y=t,this.z=n,this.w=s}get width(){return this.z}set width(e){this.z=
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
y=e.y/t,this.z=e.z/t),this}setAxisAngleFromRotationMatrix(e){let t,n,s,r,l=e.elements,c=l[0],d=l[4],u=l[8],h=l[1],f=l[5],p=l[9],x=l[2],m=l[6],g=l[10];if(Math.abs(
d-h)<.01&&Math.abs(u-x)<.01&&Math.abs(p-m)<.01){if(Math.abs(d+h)<.1&&Math.abs(u+x)<.1&&Math.abs(p+m)<.1&&Math.abs(c+f+g-3)<.1)return this.set(1,0,0,0),this;t=Math.
PI;let S=(c+1)/2,b=(f+1)/2,C=(g+1)/2,w=(d+h)/4,_=(u+x)/4,M=(p+m)/4;return S>b&&S>C?S<.01?(n=0,s=.707106781,r=.707106781):(n=Math.sqrt(S),s=w/n,r=_/n):b>C?b<.01?
(n=.707106781,s=0,r=.707106781):(s=Math.sqrt(b),n=w/s,r=M/s):C<.01?(n=.707106781,s=.707106781,r=0):(r=Math.sqrt(C),n=_/r,s=M/r),this.set(n,s,r,t),this}let y=Math.
sqrt((m-p)*(m-p)+(u-x)*(u-x)+(h-d)*(h-d));return Math.abs(y)<.001&&(y=1),this.x=(m-p)/y,this.y=(u-x)/y,this.z=(h-d)/y,this.w=Math.acos((c+f+g-1)/2),this}setFromMatrixPosition(e){
let t=e.elements;return this.x=t[12],this.y=t[13],this.z=t[14],this.w=t[15],this}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this.z=Math.
min(this.z,e.z),this.w=Math.min(this.w,e.w),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this.z=Math.max(this.z,e.z),this.w=Math.max(
this.w,e.w),this}clamp(e,t){return this.x=at(this.x,e.x,t.x),this.y=at(this.y,e.y,t.y),this.z=at(this.z,e.z,t.z),this.w=at(this.w,e.w,t.w),this}clampScalar(e,t){
return this.x=at(this.x,e,t),this.y=at(this.y,e,t),this.z=at(this.z,e,t),this.w=at(this.w,e,t),this}clampLength(e,t){let n=this.length();return this.divideScalar(
n||1).multiplyScalar(at(n,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this.w=Math.floor(this.w),this}ceil(){
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
w}},Ll=class extends ki{constructor(e=1,t=1,n={}){super(),n=Object.assign({generateMipmaps:!1,internalFormat:null,minFilter:Bn,depthBuffer:!0,stencilBuffer:!1,resolveColorBuffer:!0,
resolveDepthBuffer:!0,resolveStencilBuffer:!0,storeMultisampledColorBuffer:!0,storeMultisampledDepthBuffer:!0,storeMultisampledStencilBuffer:!0,depthTexture:null,
samples:0,count:1,depth:1,multiview:!1,useArrayDepthTexture:!1},n),this.isRenderTarget=!0,this.width=e,this.height=t,this.depth=n.depth,this.scissor=new Wt(0,0,
e,t),this.scissorTest=!1,this.viewport=new Wt(0,0,e,t),this.textures=[];let s=n.count;for(let r=0;r<s;r++)this.textures[r]=new Hn({width:e,height:t,depth:n.depth}),
this.textures[r].isRenderTargetTexture=!0,this.textures[r].renderTarget=this;this._setTextureOptions(n),this.depthBuffer=n.depthBuffer,this.stencilBuffer=n.stencilBuffer,
this.resolveColorBuffer=n.resolveColorBuffer,this.resolveDepthBuffer=n.resolveDepthBuffer,this.resolveStencilBuffer=n.resolveStencilBuffer,this.storeMultisampledColorBuffer=
n.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=n.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=n.storeMultisampledStencilBuffer,
this._depthTexture=null,this.depthTexture=n.depthTexture,this.samples=n.samples,this.multiview=n.multiview,this.useArrayDepthTexture=n.useArrayDepthTexture}_setTextureOptions(e={}){
let t={minFilter:Bn,generateMipmaps:!1,flipY:!1,internalFormat:null};e.mapping!==void 0&&(t.mapping=e.mapping),e.wrapS!==void 0&&(t.wrapS=e.wrapS),e.wrapT!==void 0&&
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
clone(),this.textures[t].isRenderTargetTexture=!0,this.textures[t].renderTarget=this;let s=Object.assign({},e.textures[t].image);this.textures[t].source=new Qr(
s)}if(this.depthBuffer=e.depthBuffer,this.stencilBuffer=e.stencilBuffer,this.resolveColorBuffer=e.resolveColorBuffer,this.resolveDepthBuffer=e.resolveDepthBuffer,
this.resolveStencilBuffer=e.resolveStencilBuffer,this.storeMultisampledColorBuffer=e.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=e.storeMultisampledDepthBuffer,
this.storeMultisampledStencilBuffer=e.storeMultisampledStencilBuffer,e.depthTexture!==null)if(e.depthTexture.renderTarget===e){let t=e.depthTexture.clone();t.renderTarget=
null,this.depthTexture=t}else this.depthTexture=e.depthTexture;else this.depthTexture=null;return this.samples=e.samples,this.multiview=e.multiview,this.useArrayDepthTexture=
e.useArrayDepthTexture,this}dispose(){this.dispatchEvent({type:"dispose"})}},ni=class extends Ll{constructor(e=1,t=1,n={}){super(e,t,n),this.isWebGLRenderTarget=
!0}},Xo=class extends Hn{constructor(e=null,t=1,n=1,s=1){super(null),this.isDataArrayTexture=!0,this.image={data:e,width:t,height:n,depth:s},this.magFilter=Mn,this.
minFilter=Mn,this.wrapR=Bi,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1,this.layerUpdates=new Set}copy(e){return super.copy(e),this.wrapR=e.wrapR,
this}addLayerUpdate(e){this.layerUpdates.add(e)}clearLayerUpdates(){this.layerUpdates.clear()}};var Nl=class extends Hn{constructor(e=null,t=1,n=1,s=1){super(null),this.isData3DTexture=!0,this.image={data:e,width:t,height:n,depth:s},this.magFilter=Mn,this.
minFilter=Mn,this.wrapR=Bi,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}copy(e){return super.copy(e),this.wrapR=e.wrapR,this}};var xt=class i{static{this.prototype.isMatrix4=!0}constructor(e,t,n,s,r,o,a,l,c,d,u,h,f,p,x,m){this.elements=[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1],e!==void 0&&this.
set(e,t,n,s,r,o,a,l,c,d,u,h,f,p,x,m)}set(e,t,n,s,r,o,a,l,c,d,u,h,f,p,x,m){let g=this.elements;return g[0]=e,g[4]=t,g[8]=n,g[12]=s,g[1]=r,g[5]=o,g[9]=a,g[13]=l,g[2]=
c,g[6]=d,g[10]=u,g[14]=h,g[3]=f,g[7]=p,g[11]=x,g[15]=m,this}identity(){return this.set(1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1),this}clone(){return new i().fromArray(this.
elements)}copy(e){let t=this.elements,n=e.elements;return t[0]=n[0],t[1]=n[1],t[2]=n[2],t[3]=n[3],t[4]=n[4],t[5]=n[5],t[6]=n[6],t[7]=n[7],t[8]=n[8],t[9]=n[9],t[10]=
n[10],t[11]=n[11],t[12]=n[12],t[13]=n[13],t[14]=n[14],t[15]=n[15],this}copyPosition(e){let t=this.elements,n=e.elements;return t[12]=n[12],t[13]=n[13],t[14]=n[14],
this}setFromMatrix3(e){let t=e.elements;return this.set(t[0],t[3],t[6],0,t[1],t[4],t[7],0,t[2],t[5],t[8],0,0,0,0,1),this}extractBasis(e,t,n){return this.determinantAffine()===
0?(e.set(1,0,0),t.set(0,1,0),n.set(0,0,1),this):(e.setFromMatrixColumn(this,0),t.setFromMatrixColumn(this,1),n.setFromMatrixColumn(this,2),this)}makeBasis(e,t,n){
return this.set(e.x,t.x,n.x,0,e.y,t.y,n.y,0,e.z,t.z,n.z,0,0,0,0,1),this}extractRotation(e){if(e.determinantAffine()===0)return this.identity();let t=this.elements,
n=e.elements,s=1/Dr.setFromMatrixColumn(e,0).length(),r=1/Dr.setFromMatrixColumn(e,1).length(),o=1/Dr.setFromMatrixColumn(e,2).length();return t[0]=n[0]*s,t[1]=
n[1]*s,t[2]=n[2]*s,t[3]=0,t[4]=n[4]*r,t[5]=n[5]*r,t[6]=n[6]*r,t[7]=0,t[8]=n[8]*o,t[9]=n[9]*o,t[10]=n[10]*o,t[11]=0,t[12]=0,t[13]=0,t[14]=0,t[15]=1,this}makeRotationFromEuler(e){
let t=this.elements,n=e.x,s=e.y,r=e.z,o=Math.cos(n),a=Math.sin(n),l=Math.cos(s),c=Math.sin(s),d=Math.cos(r),u=Math.sin(r);if(e.order==="XYZ"){let h=o*d,f=o*u,p=a*
d,x=a*u;t[0]=l*d,t[4]=-l*u,t[8]=c,t[1]=f+p*c,t[5]=h-x*c,t[9]=-a*l,t[2]=x-h*c,t[6]=p+f*c,t[10]=o*l}else if(e.order==="YXZ"){let h=l*d,f=l*u,p=c*d,x=c*u;t[0]=h+x*
a,t[4]=p*a-f,t[8]=o*c,t[1]=o*u,t[5]=o*d,t[9]=-a,t[2]=f*a-p,t[6]=x+h*a,t[10]=o*l}else if(e.order==="ZXY"){let h=l*d,f=l*u,p=c*d,x=c*u;t[0]=h-x*a,t[4]=-o*u,t[8]=p+
f*a,t[1]=f+p*a,t[5]=o*d,t[9]=x-h*a,t[2]=-o*c,t[6]=a,t[10]=o*l}else if(e.order==="ZYX"){let h=o*d,f=o*u,p=a*d,x=a*u;t[0]=l*d,t[4]=p*c-f,t[8]=h*c+x,t[1]=l*u,t[5]=
x*c+h,t[9]=f*c-p,t[2]=-c,t[6]=a*l,t[10]=o*l}else if(e.order==="YZX"){let h=o*l,f=o*c,p=a*l,x=a*c;t[0]=l*d,t[4]=x-h*u,t[8]=p*u+f,t[1]=u,t[5]=o*d,t[9]=-a*d,t[2]=-c*
d,t[6]=f*u+p,t[10]=h-x*u}else if(e.order==="XZY"){let h=o*l,f=o*c,p=a*l,x=a*c;t[0]=l*d,t[4]=-u,t[8]=c*d,t[1]=h*u+x,t[5]=o*d,t[9]=f*u-p,t[2]=p*u-f,t[6]=a*d,t[10]=
x*u+h}return t[3]=0,t[7]=0,t[11]=0,t[12]=0,t[13]=0,t[14]=0,t[15]=1,this}makeRotationFromQuaternion(e){return this.compose(_y,e,xy)}lookAt(e,t,n){let s=this.elements;
return jn.subVectors(e,t),jn.lengthSq()===0&&(jn.z=1),jn.normalize(),As.crossVectors(n,jn),As.lengthSq()===0&&(Math.abs(n.z)===1?jn.x+=1e-4:jn.z+=1e-4,jn.normalize(),
As.crossVectors(n,jn)),As.normalize(),Ya.crossVectors(jn,As),s[0]=As.x,s[4]=Ya.x,s[8]=jn.x,s[1]=As.y,s[5]=Ya.y,s[9]=jn.y,s[2]=As.z,s[6]=Ya.z,s[10]=jn.z,this}multiply(e){
return this.multiplyMatrices(this,e)}premultiply(e){return this.multiplyMatrices(e,this)}multiplyMatrices(e,t){let n=e.elements,s=t.elements,r=this.elements,o=n[0],
a=n[4],l=n[8],c=n[12],d=n[1],u=n[5],h=n[9],f=n[13],p=n[2],x=n[6],m=n[10],g=n[14],y=n[3],S=n[7],b=n[11],C=n[15],w=s[0],_=s[4],M=s[8],R=s[12],P=s[1],I=s[5],F=s[9],
z=s[13],D=s[2],G=s[6],Y=s[10],W=s[14],ce=s[3],K=s[7],Q=s[11],se=s[15];return r[0]=o*w+a*P+l*D+c*ce,r[4]=o*_+a*I+l*G+c*K,r[8]=o*M+a*F+l*Y+c*Q,r[12]=o*R+a*z+l*W+c*
se,r[1]=d*w+u*P+h*D+f*ce,r[5]=d*_+u*I+h*G+f*K,r[9]=d*M+u*F+h*Y+f*Q,r[13]=d*R+u*z+h*W+f*se,r[2]=p*w+x*P+m*D+g*ce,r[6]=p*_+x*I+m*G+g*K,r[10]=p*M+x*F+m*Y+g*Q,r[14]=
p*R+x*z+m*W+g*se,r[3]=y*w+S*P+b*D+C*ce,r[7]=y*_+S*I+b*G+C*K,r[11]=y*M+S*F+b*Y+C*Q,r[15]=y*R+S*z+b*W+C*se,this}multiplyScalar(e){let t=this.elements;return t[0]*=
e,t[4]*=e,t[8]*=e,t[12]*=e,t[1]*=e,t[5]*=e,t[9]*=e,t[13]*=e,t[2]*=e,t[6]*=e,t[10]*=e,t[14]*=e,t[3]*=e,t[7]*=e,t[11]*=e,t[15]*=e,this}determinant(){let e=this.elements,
t=e[0],n=e[4],s=e[8],r=e[12],o=e[1],a=e[5],l=e[9],c=e[13],d=e[2],u=e[6],h=e[10],f=e[14],p=e[3],x=e[7],m=e[11],g=e[15],y=l*f-c*h,S=a*f-c*u,b=a*h-l*u,C=o*f-c*d,w=o*
h-l*d,_=o*u-a*d;return t*(x*y-m*S+g*b)-n*(p*y-m*C+g*w)+s*(p*S-x*C+g*_)-r*(p*b-x*w+m*_)}determinantAffine(){let e=this.elements,t=e[0],n=e[4],s=e[8],r=e[1],o=e[5],
a=e[9],l=e[2],c=e[6],d=e[10];return t*(o*d-a*c)-n*(r*d-a*l)+s*(r*c-o*l)}transpose(){let e=this.elements,t;return t=e[1],e[1]=e[4],e[4]=t,t=e[2],e[2]=e[8],e[8]=t,
t=e[6],e[6]=e[9],e[9]=t,t=e[3],e[3]=e[12],e[12]=t,t=e[7],e[7]=e[13],e[13]=t,t=e[11],e[11]=e[14],e[14]=t,this}setPosition(e,t,n){let s=this.elements;return e.isVector3?
(s[12]=e.x,s[13]=e.y,s[14]=e.z):(s[12]=e,s[13]=t,s[14]=n),this}invert(){let e=this.elements,t=e[0],n=e[1],s=e[2],r=e[3],o=e[4],a=e[5],l=e[6],c=e[7],d=e[8],u=e[9],
h=e[10],f=e[11],p=e[12],x=e[13],m=e[14],g=e[15],y=t*a-n*o,S=t*l-s*o,b=t*c-r*o,C=n*l-s*a,w=n*c-r*a,_=s*c-r*l,M=d*x-u*p,R=d*m-h*p,P=d*g-f*p,I=u*m-h*x,F=u*g-f*x,z=h*
g-f*m,D=y*z-S*F+b*I+C*P-w*R+_*M;if(D===0)return this.set(0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0);let G=1/D;return e[0]=(a*z-l*F+c*I)*G,e[1]=(s*F-n*z-r*I)*G,e[2]=(x*_-m*
w+g*C)*G,e[3]=(h*w-u*_-f*C)*G,e[4]=(l*P-o*z-c*R)*G,e[5]=(t*z-s*P+r*R)*G,e[6]=(m*b-p*_-g*S)*G,e[7]=(d*_-h*b+f*S)*G,e[8]=(o*F-a*P+c*M)*G,e[9]=(n*P-t*F-r*M)*G,e[10]=
(p*w-x*b+g*y)*G,e[11]=(u*b-d*w-f*y)*G,e[12]=(a*R-o*I-l*M)*G,e[13]=(t*I-n*R+s*M)*G,e[14]=(x*S-p*C-m*y)*G,e[15]=(d*C-u*S+h*y)*G,this}scale(e){let t=this.elements,
n=e.x,s=e.y,r=e.z;return t[0]*=n,t[4]*=s,t[8]*=r,t[1]*=n,t[5]*=s,t[9]*=r,t[2]*=n,t[6]*=s,t[10]*=r,t[3]*=n,t[7]*=s,t[11]*=r,this}getMaxScaleOnAxis(){let e=this.elements,
t=e[0]*e[0]+e[1]*e[1]+e[2]*e[2],n=e[4]*e[4]+e[5]*e[5]+e[6]*e[6],s=e[8]*e[8]+e[9]*e[9]+e[10]*e[10];return Math.sqrt(Math.max(t,n,s))}makeTranslation(e,t,n){return e.
isVector3?this.set(1,0,0,e.x,0,1,0,e.y,0,0,1,e.z,0,0,0,1):this.set(1,0,0,e,0,1,0,t,0,0,1,n,0,0,0,1),this}makeRotationX(e){let t=Math.cos(e),n=Math.sin(e);return this.
set(1,0,0,0,0,t,-n,0,0,n,t,0,0,0,0,1),this}makeRotationY(e){let t=Math.cos(e),n=Math.sin(e);return this.set(t,0,n,0,0,1,0,0,-n,0,t,0,0,0,0,1),this}makeRotationZ(e){
let t=Math.cos(e),n=Math.sin(e);return this.set(t,-n,0,0,n,t,0,0,0,0,1,0,0,0,0,1),this}makeRotationAxis(e,t){let n=Math.cos(t),s=Math.sin(t),r=1-n,o=e.x,a=e.y,l=e.
z,c=r*o,d=r*a;return this.set(c*o+n,c*a-s*l,c*l+s*a,0,c*a+s*l,d*a+n,d*l-s*o,0,c*l-s*a,d*l+s*o,r*l*l+n,0,0,0,0,1),this}makeScale(e,t,n){return this.set(e,0,0,0,0,
t,0,0,0,0,n,0,0,0,0,1),this}makeShear(e,t,n,s,r,o){return this.set(1,n,r,0,e,1,o,0,t,s,1,0,0,0,0,1),this}compose(e,t,n){let s=this.elements,r=t._x,o=t._y,a=t._z,
l=t._w,c=r+r,d=o+o,u=a+a,h=r*c,f=r*d,p=r*u,x=o*d,m=o*u,g=a*u,y=l*c,S=l*d,b=l*u,C=n.x,w=n.y,_=n.z;return s[0]=(1-(x+g))*C,s[1]=(f+b)*C,s[2]=(p-S)*C,s[3]=0,s[4]=(f-
b)*w,s[5]=(1-(h+g))*w,s[6]=(m+y)*w,s[7]=0,s[8]=(p+S)*_,s[9]=(m-y)*_,s[10]=(1-(h+x))*_,s[11]=0,s[12]=e.x,s[13]=e.y,s[14]=e.z,s[15]=1,this}decompose(e,t,n){let s=this.
elements;e.x=s[12],e.y=s[13],e.z=s[14];let r=this.determinantAffine();if(r===0)return n.set(1,1,1),t.identity(),this;let o=Dr.set(s[0],s[1],s[2]).length(),a=Dr.
set(s[4],s[5],s[6]).length(),l=Dr.set(s[8],s[9],s[10]).length();r<0&&(o=-o),yi.copy(this);let c=1/o,d=1/a,u=1/l;return yi.elements[0]*=c,yi.elements[1]*=c,yi.elements[2]*=
c,yi.elements[4]*=d,yi.elements[5]*=d,yi.elements[6]*=d,yi.elements[8]*=u,yi.elements[9]*=u,yi.elements[10]*=u,t.setFromRotationMatrix(yi),n.x=o,n.y=a,n.z=l,this}makePerspective(e,t,n,s,r,o,a=hi,l=!1){
let c=this.elements,d=2*r/(t-e),u=2*r/(n-s),h=(t+e)/(t-e),f=(n+s)/(n-s),p,x;if(l)p=r/(o-r),x=o*r/(o-r);else if(a===hi)p=-(o+r)/(o-r),x=-2*o*r/(o-r);else if(a===
Kr)p=-o/(o-r),x=-o*r/(o-r);else throw new Error("THREE.Matrix4.makePerspective(): Invalid coordinate system: "+a);return c[0]=d,c[4]=0,c[8]=h,c[12]=0,c[1]=0,c[5]=
u,c[9]=f,c[13]=0,c[2]=0,c[6]=0,c[10]=p,c[14]=x,c[3]=0,c[7]=0,c[11]=-1,c[15]=0,this}makeOrthographic(e,t,n,s,r,o,a=hi,l=!1){let c=this.elements,d=2/(t-e),u=2/(n-
s),h=-(t+e)/(t-e),f=-(n+s)/(n-s),p,x;if(l)p=1/(o-r),x=o/(o-r);else if(a===hi)p=-2/(o-r),x=-(o+r)/(o-r);else if(a===Kr)p=-1/(o-r),x=-r/(o-r);else throw new Error(
"THREE.Matrix4.makeOrthographic(): Invalid coordinate system: "+a);return c[0]=d,c[4]=0,c[8]=0,c[12]=h,c[1]=0,c[5]=u,c[9]=0,c[13]=f,c[2]=0,c[6]=0,c[10]=p,c[14]=
x,c[3]=0,c[7]=0,c[11]=0,c[15]=1,this}equals(e){let t=this.elements,n=e.elements;for(let s=0;s<16;s++)if(t[s]!==n[s])return!1;return!0}fromArray(e,t=0){for(let n=0;n<
16;n++)this.elements[n]=e[n+t];return this}toArray(e=[],t=0){let n=this.elements;return e[t]=n[0],e[t+1]=n[1],e[t+2]=n[2],e[t+3]=n[3],e[t+4]=n[4],e[t+5]=n[5],e[t+
6]=n[6],e[t+7]=n[7],e[t+8]=n[8],e[t+9]=n[9],e[t+10]=n[10],e[t+11]=n[11],e[t+12]=n[12],e[t+13]=n[13],e[t+14]=n[14],e[t+15]=n[15],e}},Dr=new V,yi=new xt,_y=new V(
0,0,0),xy=new V(1,1,1),As=new V,Ya=new V,jn=new V,Zp=new xt,Jp=new kn,as=class i{constructor(e=0,t=0,n=0,s=i.DEFAULT_ORDER){this.isEuler=!0,this._x=e,this._y=t,
this._z=n,this._order=s}get x(){return this._x}set x(e){this._x=e,this._onChangeCallback()}get y(){return this._y}set y(e){this._y=e,this._onChangeCallback()}get z(){
return this._z}set z(e){this._z=e,this._onChangeCallback()}get order(){return this._order}set order(e){this._order=e,this._onChangeCallback()}set(e,t,n,s=this._order){
return this._x=e,this._y=t,this._z=n,this._order=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._order)}copy(e){
return this._x=e._x,this._y=e._y,this._z=e._z,this._order=e._order,this._onChangeCallback(),this}setFromRotationMatrix(e,t=this._order,n=!0){let s=e.elements,r=s[0],
o=s[4],a=s[8],l=s[1],c=s[5],d=s[9],u=s[2],h=s[6],f=s[10];switch(t){case"XYZ":this._y=Math.asin(at(a,-1,1)),Math.abs(a)<.9999999?(this._x=Math.atan2(-d,f),this._z=
Math.atan2(-o,r)):(this._x=Math.atan2(h,c),this._z=0);break;case"YXZ":this._x=Math.asin(-at(d,-1,1)),Math.abs(d)<.9999999?(this._y=Math.atan2(a,f),this._z=Math.
atan2(l,c)):(this._y=Math.atan2(-u,r),this._z=0);break;case"ZXY":this._x=Math.asin(at(h,-1,1)),Math.abs(h)<.9999999?(this._y=Math.atan2(-u,f),this._z=Math.atan2(
-o,c)):(this._y=0,this._z=Math.atan2(l,r));break;case"ZYX":this._y=Math.asin(-at(u,-1,1)),Math.abs(u)<.9999999?(this._x=Math.atan2(h,f),this._z=Math.atan2(l,r)):
(this._x=0,this._z=Math.atan2(-o,c));break;case"YZX":this._z=Math.asin(at(l,-1,1)),Math.abs(l)<.9999999?(this._x=Math.atan2(-d,c),this._y=Math.atan2(-u,r)):(this.
_x=0,this._y=Math.atan2(a,f));break;case"XZY":this._z=Math.asin(-at(o,-1,1)),Math.abs(o)<.9999999?(this._x=Math.atan2(h,c),this._y=Math.atan2(a,r)):(this._x=Math.
atan2(-d,f),this._y=0);break;default:qe("Euler: .setFromRotationMatrix() encountered an unknown order: "+t)}return this._order=t,n===!0&&this._onChangeCallback(),
this}setFromQuaternion(e,t,n){return Zp.makeRotationFromQuaternion(e),this.setFromRotationMatrix(Zp,t,n)}setFromVector3(e,t=this._order){return this.set(e.x,e.y,
e.z,t)}reorder(e){return Jp.setFromEuler(this),this.setFromQuaternion(Jp,e)}equals(e){return e._x===this._x&&e._y===this._y&&e._z===this._z&&e._order===this._order}fromArray(e){
return this._x=e[0],this._y=e[1],this._z=e[2],e[3]!==void 0&&(this._order=e[3]),this._onChangeCallback(),this}toArray(e=[],t=0){return e[t]=this._x,e[t+1]=this.
_y,e[t+2]=this._z,e[t+3]=this._order,e}_onChange(e){return this._onChangeCallback=e,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this.
_z,yield this._order}};as.DEFAULT_ORDER="XYZ";var eo=class{constructor(){this.mask=1}set(e){this.mask=(1<<e|0)>>>0}enable(e){this.mask|=1<<e|0}enableAll(){this.
mask=-1}toggle(e){this.mask^=1<<e|0}disable(e){this.mask&=~(1<<e|0)}disableAll(){this.mask=0}test(e){return(this.mask&e.mask)!==0}isEnabled(e){return(this.mask&
(1<<e|0))!==0}},yy=0,Kp=new V,Ur=new kn,es=new xt,Za=new V,No=new V,vy=new V,by=new kn,jp=new V(1,0,0),Qp=new V(0,1,0),em=new V(0,0,1),tm={type:"added"},My={type:"\
removed"},Fr={type:"childadded",child:null},ou={type:"childremoved",child:null},wn=class i extends ki{constructor(){super(),this.isObject3D=!0,Object.defineProperty(
this,"id",{value:yy++}),this.uuid=Ma(),this.name="",this.type="Object3D",this.parent=null,this.children=[],this.up=i.DEFAULT_UP.clone();let e=new V,t=new as,n=new kn,
s=new V(1,1,1);function r(){n.setFromEuler(t,!1)}function o(){t.setFromQuaternion(n,void 0,!1)}t._onChange(r),n._onChange(o),Object.defineProperties(this,{position:{
configurable:!0,enumerable:!0,value:e},rotation:{configurable:!0,enumerable:!0,value:t},quaternion:{configurable:!0,enumerable:!0,value:n},scale:{configurable:!0,
enumerable:!0,value:s},modelViewMatrix:{value:new xt},normalMatrix:{value:new Qe}}),this.matrix=new xt,this.matrixWorld=new xt,this.matrixAutoUpdate=i.DEFAULT_MATRIX_AUTO_UPDATE,
this.matrixWorldAutoUpdate=i.DEFAULT_MATRIX_WORLD_AUTO_UPDATE,this.matrixWorldNeedsUpdate=!1,this.layers=new eo,this.visible=!0,this.castShadow=!1,this.receiveShadow=
!1,this.frustumCulled=!0,this.renderOrder=0,this.animations=[],this.customDepthMaterial=void 0,this.customDistanceMaterial=void 0,this.static=!1,this.userData={},
this.pivot=null}onBeforeShadow(){}onAfterShadow(){}onBeforeRender(){}onAfterRender(){}applyMatrix4(e){this.matrixAutoUpdate&&this.updateMatrix(),this.matrix.premultiply(
e),this.matrix.decompose(this.position,this.quaternion,this.scale),this.pivot!==null&&this.position.copy(this.pivot).applyMatrix4(this.matrix).sub(this.pivot)}applyQuaternion(e){
return this.quaternion.premultiply(e),this}setRotationFromAxisAngle(e,t){this.quaternion.setFromAxisAngle(e,t)}setRotationFromEuler(e){this.quaternion.setFromEuler(
e,!0)}setRotationFromMatrix(e){this.quaternion.setFromRotationMatrix(e)}setRotationFromQuaternion(e){this.quaternion.copy(e)}rotateOnAxis(e,t){return Ur.setFromAxisAngle(
e,t),this.quaternion.multiply(Ur),this}rotateOnWorldAxis(e,t){return Ur.setFromAxisAngle(e,t),this.quaternion.premultiply(Ur),this}rotateX(e){return this.rotateOnAxis(
jp,e)}rotateY(e){return this.rotateOnAxis(Qp,e)}rotateZ(e){return this.rotateOnAxis(em,e)}translateOnAxis(e,t){return Kp.copy(e).applyQuaternion(this.quaternion),
this.position.add(Kp.multiplyScalar(t)),this}translateX(e){return this.translateOnAxis(jp,e)}translateY(e){return this.translateOnAxis(Qp,e)}translateZ(e){return this.
translateOnAxis(em,e)}localToWorld(e){return this.updateWorldMatrix(!0,!1),e.applyMatrix4(this.matrixWorld)}worldToLocal(e){return this.updateWorldMatrix(!0,!1),
e.applyMatrix4(es.copy(this.matrixWorld).invert())}lookAt(e,t,n){e.isVector3?Za.copy(e):Za.set(e,t,n);let s=this.parent;this.updateWorldMatrix(!0,!1),No.setFromMatrixPosition(
this.matrixWorld),this.isCamera||this.isLight?es.lookAt(No,Za,this.up):es.lookAt(Za,No,this.up),this.quaternion.setFromRotationMatrix(es),s&&(es.extractRotation(
s.matrixWorld),Ur.setFromRotationMatrix(es),this.quaternion.premultiply(Ur.invert()))}add(e){if(arguments.length>1){for(let t=0;t<arguments.length;t++)this.add(
arguments[t]);return this}return e===this?(Ke("Object3D.add: object can't be added as a child of itself.",e),this):(e&&e.isObject3D?(e.removeFromParent(),e.parent=
this,this.children.push(e),e.dispatchEvent(tm),Fr.child=e,this.dispatchEvent(Fr),Fr.child=null):Ke("Object3D.add: object not an instance of THREE.Object3D.",e),
this)}remove(e){if(arguments.length>1){for(let n=0;n<arguments.length;n++)this.remove(arguments[n]);return this}let t=this.children.indexOf(e);return t!==-1&&(e.
parent=null,this.children.splice(t,1),e.dispatchEvent(My),ou.child=e,this.dispatchEvent(ou),ou.child=null),this}removeFromParent(){let e=this.parent;return e!==
null&&e.remove(this),this}clear(){return this.remove(...this.children)}attach(e){return this.updateWorldMatrix(!0,!1),es.copy(this.matrixWorld).invert(),e.parent!==
null&&(e.parent.updateWorldMatrix(!0,!1),es.multiply(e.parent.matrixWorld)),e.applyMatrix4(es),e.removeFromParent(),e.parent=this,this.children.push(e),e.updateWorldMatrix(
!1,!0),e.dispatchEvent(tm),Fr.child=e,this.dispatchEvent(Fr),Fr.child=null,this}getObjectById(e){return this.getObjectByProperty("id",e)}getObjectByName(e){return this.
getObjectByProperty("name",e)}getObjectByProperty(e,t){if(this[e]===t)return this;for(let n=0,s=this.children.length;n<s;n++){let o=this.children[n].getObjectByProperty(
e,t);if(o!==void 0)return o}}getObjectsByProperty(e,t,n=[]){this[e]===t&&n.push(this);let s=this.children;for(let r=0,o=s.length;r<o;r++)s[r].getObjectsByProperty(
e,t,n);return n}getWorldPosition(e){return this.updateWorldMatrix(!0,!1),e.setFromMatrixPosition(this.matrixWorld)}getWorldQuaternion(e){return this.updateWorldMatrix(
!0,!1),this.matrixWorld.decompose(No,e,vy),e}getWorldScale(e){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(No,by,e),e}getWorldDirection(e){this.
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
(s.boundingSphere=this.boundingSphere.toJSON()),this.boundingBox!==null&&(s.boundingBox=this.boundingBox.toJSON()));function r(a,l){return a[l.uuid]===void 0&&(a[l.
uuid]=l.toJSON(e)),l.uuid}if(this.isScene)this.background&&(this.background.isColor?s.background=this.background.toJSON():this.background.isTexture&&(s.background=
this.background.toJSON(e).uuid)),this.environment&&this.environment.isTexture&&this.environment.isRenderTargetTexture!==!0&&(s.environment=this.environment.toJSON(
e).uuid);else if(this.isMesh||this.isLine||this.isPoints){s.geometry=r(e.geometries,this.geometry);let a=this.geometry.parameters;if(a!==void 0&&a.shapes!==void 0){
let l=a.shapes;if(Array.isArray(l))for(let c=0,d=l.length;c<d;c++){let u=l[c];r(e.shapes,u)}else r(e.shapes,l)}}if(this.isSkinnedMesh&&(s.bindMode=this.bindMode,
s.bindMatrix=this.bindMatrix.toArray(),this.skeleton!==void 0&&(r(e.skeletons,this.skeleton),s.skeleton=this.skeleton.uuid)),this.material!==void 0)if(Array.isArray(
this.material)){let a=[];for(let l=0,c=this.material.length;l<c;l++)a.push(r(e.materials,this.material[l]));s.material=a}else s.material=r(e.materials,this.material);
if(this.children.length>0){s.children=[];for(let a=0;a<this.children.length;a++)s.children.push(this.children[a].toJSON(e).object)}if(this.animations.length>0){
s.animations=[];for(let a=0;a<this.animations.length;a++){let l=this.animations[a];s.animations.push(r(e.animations,l))}}if(t){let a=o(e.geometries),l=o(e.materials),
c=o(e.textures),d=o(e.images),u=o(e.shapes),h=o(e.skeletons),f=o(e.animations),p=o(e.nodes);a.length>0&&(n.geometries=a),l.length>0&&(n.materials=l),c.length>0&&
(n.textures=c),d.length>0&&(n.images=d),u.length>0&&(n.shapes=u),h.length>0&&(n.skeletons=h),f.length>0&&(n.animations=f),p.length>0&&(n.nodes=p)}return n.object=
s,n;function o(a){let l=[];for(let c in a){let d=a[c];delete d.metadata,l.push(d)}return l}}clone(e){return new this.constructor().copy(this,e)}copy(e,t=!0){if(this.
name=e.name,this.up.copy(e.up),this.position.copy(e.position),this.rotation.order=e.rotation.order,this.quaternion.copy(e.quaternion),this.scale.copy(e.scale),this.
pivot=e.pivot!==null?e.pivot.clone():null,this.matrix.copy(e.matrix),this.matrixWorld.copy(e.matrixWorld),this.matrixAutoUpdate=e.matrixAutoUpdate,this.matrixWorldAutoUpdate=
e.matrixWorldAutoUpdate,this.matrixWorldNeedsUpdate=e.matrixWorldNeedsUpdate,this.layers.mask=e.layers.mask,this.visible=e.visible,this.castShadow=e.castShadow,
this.receiveShadow=e.receiveShadow,this.frustumCulled=e.frustumCulled,this.renderOrder=e.renderOrder,this.static=e.static,this.animations=e.animations.slice(),this.
userData=JSON.parse(JSON.stringify(e.userData)),t===!0)for(let n=0;n<e.children.length;n++){let s=e.children[n];this.add(s.clone())}return this}dispose(){this.dispatchEvent(
{type:"dispose"})}};wn.DEFAULT_UP=new V(0,1,0);wn.DEFAULT_MATRIX_AUTO_UPDATE=!0;wn.DEFAULT_MATRIX_WORLD_AUTO_UPDATE=!0;var Gn=class extends wn{constructor(){super(),
this.isGroup=!0,this.type="Group"}},Sy={type:"move"},to=class{constructor(){this._targetRay=null,this._grip=null,this._hand=null}getHandSpace(){return this._hand===
null&&(this._hand=new Gn,this._hand.matrixAutoUpdate=!1,this._hand.visible=!1,this._hand.joints={},this._hand.inputState={pinching:!1}),this._hand}getTargetRaySpace(){
return this._targetRay===null&&(this._targetRay=new Gn,this._targetRay.matrixAutoUpdate=!1,this._targetRay.visible=!1,this._targetRay.hasLinearVelocity=!1,this.
_targetRay.linearVelocity=new V,this._targetRay.hasAngularVelocity=!1,this._targetRay.angularVelocity=new V),this._targetRay}getGripSpace(){return this._grip===
null&&(this._grip=new Gn,this._grip.matrixAutoUpdate=!1,this._grip.visible=!1,this._grip.hasLinearVelocity=!1,this._grip.linearVelocity=new V,this._grip.hasAngularVelocity=
!1,this._grip.angularVelocity=new V,this._grip.eventsEnabled=!1),this._grip}dispatchEvent(e){return this._targetRay!==null&&this._targetRay.dispatchEvent(e),this.
_grip!==null&&this._grip.dispatchEvent(e),this._hand!==null&&this._hand.dispatchEvent(e),this}connect(e){if(e&&e.hand){let t=this._hand;if(t)for(let n of e.hand.
values())this._getHandJoint(t,n)}return this.dispatchEvent({type:"connected",data:e}),this}disconnect(e){return this.dispatchEvent({type:"disconnected",data:e}),
this._targetRay!==null&&(this._targetRay.visible=!1),this._grip!==null&&(this._grip.visible=!1),this._hand!==null&&(this._hand.visible=!1),this}update(e,t,n){let s=null,
r=null,o=null,a=this._targetRay,l=this._grip,c=this._hand;if(e&&t.session.visibilityState!=="visible-blurred"){if(c&&e.hand){o=!0;for(let x of e.hand.values()){
let m=t.getJointPose(x,n),g=this._getHandJoint(c,x);m!==null&&(g.matrix.fromArray(m.transform.matrix),g.matrix.decompose(g.position,g.quaternion,g.scale),g.matrixWorldNeedsUpdate=
!0,g.jointRadius=m.radius),g.visible=m!==null}let d=c.joints["index-finger-tip"],u=c.joints["thumb-tip"],h=d.position.distanceTo(u.position),f=.02,p=.005;c.inputState.
pinching&&h>f+p?(c.inputState.pinching=!1,this.dispatchEvent({type:"pinchend",handedness:e.handedness,target:this})):!c.inputState.pinching&&h<=f-p&&(c.inputState.
pinching=!0,this.dispatchEvent({type:"pinchstart",handedness:e.handedness,target:this}))}else l!==null&&e.gripSpace&&(r=t.getPose(e.gripSpace,n),r!==null&&(l.matrix.
fromArray(r.transform.matrix),l.matrix.decompose(l.position,l.quaternion,l.scale),l.matrixWorldNeedsUpdate=!0,r.linearVelocity?(l.hasLinearVelocity=!0,l.linearVelocity.
copy(r.linearVelocity)):l.hasLinearVelocity=!1,r.angularVelocity?(l.hasAngularVelocity=!0,l.angularVelocity.copy(r.angularVelocity)):l.hasAngularVelocity=!1,l.eventsEnabled&&
l.dispatchEvent({type:"gripUpdated",data:e,target:this})));a!==null&&(s=t.getPose(e.targetRaySpace,n),s===null&&r!==null&&(s=r),s!==null&&(a.matrix.fromArray(s.
transform.matrix),a.matrix.decompose(a.position,a.quaternion,a.scale),a.matrixWorldNeedsUpdate=!0,s.linearVelocity?(a.hasLinearVelocity=!0,a.linearVelocity.copy(
s.linearVelocity)):a.hasLinearVelocity=!1,s.angularVelocity?(a.hasAngularVelocity=!0,a.angularVelocity.copy(s.angularVelocity)):a.hasAngularVelocity=!1,this.dispatchEvent(
Sy)))}return a!==null&&(a.visible=s!==null),l!==null&&(l.visible=r!==null),c!==null&&(c.visible=o!==null),this}_getHandJoint(e,t){if(e.joints[t.jointName]===void 0){
let n=new Gn;n.matrixAutoUpdate=!1,n.visible=!1,e.joints[t.jointName]=n,e.add(n)}return e.joints[t.jointName]}},ag={aliceblue:15792383,antiquewhite:16444375,aqua:65535,
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
violet:15631086,wheat:16113331,white:16777215,whitesmoke:16119285,yellow:16776960,yellowgreen:10145074},Es={h:0,s:0,l:0},Ja={h:0,s:0,l:0};function au(i,e,t){return t<
0&&(t+=1),t>1&&(t-=1),t<1/6?i+(e-i)*6*t:t<1/2?e:t<2/3?i+(e-i)*6*(2/3-t):i}var rt=class{constructor(e,t,n){return this.isColor=!0,this.r=1,this.g=1,this.b=1,this.
set(e,t,n)}set(e,t,n){if(t===void 0&&n===void 0){let s=e;s&&s.isColor?this.copy(s):typeof s=="number"?this.setHex(s):typeof s=="string"&&this.setStyle(s)}else this.
setRGB(e,t,n);return this}setScalar(e){return this.r=e,this.g=e,this.b=e,this}setHex(e,t=ei){return e=Math.floor(e),this.r=(e>>16&255)/255,this.g=(e>>8&255)/255,
this.b=(e&255)/255,_t.colorSpaceToWorking(this,t),this}setRGB(e,t,n,s=_t.workingColorSpace){return this.r=e,this.g=t,this.b=n,_t.colorSpaceToWorking(this,s),this}setHSL(e,t,n,s=_t.
workingColorSpace){if(e=uy(e,1),t=at(t,0,1),n=at(n,0,1),t===0)this.r=this.g=this.b=n;else{let r=n<=.5?n*(1+t):n+t-n*t,o=2*n-r;this.r=au(o,r,e+1/3),this.g=au(o,r,
e),this.b=au(o,r,e-1/3)}return _t.colorSpaceToWorking(this,s),this}setStyle(e,t=ei){function n(r){r!==void 0&&parseFloat(r)<1&&qe("Color: Alpha component of "+e+
" will be ignored.")}let s;if(s=/^(\w+)\(([^\)]*)\)/.exec(e)){let r,o=s[1],a=s[2];switch(o){case"rgb":case"rgba":if(r=/^\s*(\d+)\s*,\s*(\d+)\s*,\s*(\d+)\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.
exec(a))return n(r[4]),this.setRGB(Math.min(255,parseInt(r[1],10))/255,Math.min(255,parseInt(r[2],10))/255,Math.min(255,parseInt(r[3],10))/255,t);if(r=/^\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.
exec(a))return n(r[4]),this.setRGB(Math.min(100,parseFloat(r[1]))/100,Math.min(100,parseFloat(r[2]))/100,Math.min(100,parseFloat(r[3]))/100,t);break;case"hsl":case"\
hsla":if(r=/^\s*([+-]?(?:\d+(?:\.\d+)?|\.\d+))\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return n(
r[4]),this.setHSL(parseFloat(r[1])/360,parseFloat(r[2])/100,parseFloat(r[3])/100,t);break;default:qe("Color: Unknown color model "+e)}}else if(s=/^\#([A-Fa-f\d]+)$/.
exec(e)){let r=s[1],o=r.length;if(o===3)return this.setRGB(parseInt(r.charAt(0),16)/15,parseInt(r.charAt(1),16)/15,parseInt(r.charAt(2),16)/15,t);if(o===6)return this.
setHex(parseInt(r,16),t);qe("Color: Invalid hex color "+e)}else if(e&&e.length>0)return this.setColorName(e,t);return this}setColorName(e,t=ei){let n=ag[e.toLowerCase()];
return n!==void 0?this.setHex(n,t):qe("Color: Unknown color "+e),this}clone(){return new this.constructor(this.r,this.g,this.b)}copy(e){return this.r=e.r,this.g=
e.g,this.b=e.b,this}copySRGBToLinear(e){return this.r=rs(e.r),this.g=rs(e.g),this.b=rs(e.b),this}copyLinearToSRGB(e){return this.r=Zr(e.r),this.g=Zr(e.g),this.b=
Zr(e.b),this}convertSRGBToLinear(){return this.copySRGBToLinear(this),this}convertLinearToSRGB(){return this.copyLinearToSRGB(this),this}getHex(e=ei){return _t.
workingToColorSpace(Cn.copy(this),e),Math.round(at(Cn.r*255,0,255))*65536+Math.round(at(Cn.g*255,0,255))*256+Math.round(at(Cn.b*255,0,255))}getHexString(e=ei){return("\
000000"+this.getHex(e).toString(16)).slice(-6)}getHSL(e,t=_t.workingColorSpace){_t.workingToColorSpace(Cn.copy(this),t);let n=Cn.r,s=Cn.g,r=Cn.b,o=Math.max(n,s,
r),a=Math.min(n,s,r),l,c,d=(a+o)/2;if(a===o)l=0,c=0;else{let u=o-a;switch(c=d<=.5?u/(o+a):u/(2-o-a),o){case n:l=(s-r)/u+(s<r?6:0);break;case s:l=(r-n)/u+2;break;case r:
l=(n-s)/u+4;break}l/=6}return e.h=l,e.s=c,e.l=d,e}getRGB(e,t=_t.workingColorSpace){return _t.workingToColorSpace(Cn.copy(this),t),e.r=Cn.r,e.g=Cn.g,e.b=Cn.b,e}getStyle(e=ei){
_t.workingToColorSpace(Cn.copy(this),e);let t=Cn.r,n=Cn.g,s=Cn.b;return e!==ei?"color(".concat(e," ").concat(t.toFixed(3)," ").concat(n.toFixed(3)," ").concat(s.
toFixed(3),")"):"rgb(".concat(Math.round(t*255),",").concat(Math.round(n*255),",").concat(Math.round(s*255),")")}offsetHSL(e,t,n){return this.getHSL(Es),this.setHSL(
Es.h+e,Es.s+t,Es.l+n)}add(e){return this.r+=e.r,this.g+=e.g,this.b+=e.b,this}addColors(e,t){return this.r=e.r+t.r,this.g=e.g+t.g,this.b=e.b+t.b,this}addScalar(e){
return this.r+=e,this.g+=e,this.b+=e,this}sub(e){return this.r=Math.max(0,this.r-e.r),this.g=Math.max(0,this.g-e.g),this.b=Math.max(0,this.b-e.b),this}multiply(e){
return this.r*=e.r,this.g*=e.g,this.b*=e.b,this}multiplyScalar(e){return this.r*=e,this.g*=e,this.b*=e,this}lerp(e,t){return this.r+=(e.r-this.r)*t,this.g+=(e.g-
this.g)*t,this.b+=(e.b-this.b)*t,this}lerpColors(e,t,n){return this.r=e.r+(t.r-e.r)*n,this.g=e.g+(t.g-e.g)*n,this.b=e.b+(t.b-e.b)*n,this}lerpHSL(e,t){this.getHSL(
Es),e.getHSL(Ja);let n=tu(Es.h,Ja.h,t),s=tu(Es.s,Ja.s,t),r=tu(Es.l,Ja.l,t);return this.setHSL(n,s,r),this}setFromVector3(e){return this.r=e.x,this.g=e.y,this.b=
e.z,this}applyMatrix3(e){let t=this.r,n=this.g,s=this.b,r=e.elements;return this.r=r[0]*t+r[3]*n+r[6]*s,this.g=r[1]*t+r[4]*n+r[7]*s,this.b=r[2]*t+r[5]*n+r[8]*s,
this}equals(e){return e.r===this.r&&e.g===this.g&&e.b===this.b}fromArray(e,t=0){return this.r=e[t],this.g=e[t+1],this.b=e[t+2],this}toArray(e=[],t=0){return e[t]=
this.r,e[t+1]=this.g,e[t+2]=this.b,e}fromBufferAttribute(e,t){return this.r=e.getX(t),this.g=e.getY(t),this.b=e.getZ(t),this}toJSON(){return this.getHex()}*[Symbol.
iterator](){yield this.r,yield this.g,yield this.b}},Cn=new rt;rt.NAMES=ag;var $o=class extends wn{constructor(){super(),this.isScene=!0,this.type="Scene",this.background=null,this.environment=null,this.fog=null,this.backgroundBlurriness=
0,this.backgroundIntensity=1,this.backgroundRotation=new as,this.environmentIntensity=1,this.environmentRotation=new as,this.overrideMaterial=null,typeof __THREE_DEVTOOLS__<
"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}copy(e,t){return super.copy(e,t),this.background=e.background!==null?e.background.
clone():null,this.environment=e.environment!==null?e.environment.clone():null,this.fog=e.fog!==null?e.fog.clone():null,this.backgroundBlurriness=e.backgroundBlurriness,
this.backgroundIntensity=e.backgroundIntensity,this.backgroundRotation.copy(e.backgroundRotation),this.environmentIntensity=e.environmentIntensity,this.environmentRotation.
copy(e.environmentRotation),this.overrideMaterial=e.overrideMaterial!==null?e.overrideMaterial.clone():null,this.matrixAutoUpdate=e.matrixAutoUpdate,this}toJSON(e){
let t=super.toJSON(e);return this.fog!==null&&(t.object.fog=this.fog.toJSON()),t.object.backgroundBlurriness=this.backgroundBlurriness,t.object.backgroundIntensity=
this.backgroundIntensity,t.object.backgroundRotation=this.backgroundRotation.toArray(),t.object.environmentIntensity=this.environmentIntensity,t.object.environmentRotation=
this.environmentRotation.toArray(),t}},vi=new V,ts=new V,lu=new V,ns=new V,Or=new V,Br=new V,nm=new V,cu=new V,hu=new V,uu=new V,du=new Wt,fu=new Wt,pu=new Wt,Oi=class i{constructor(e=new V,t=new V,n=new V){
this.a=e,this.b=t,this.c=n}static getNormal(e,t,n,s){s.subVectors(n,t),vi.subVectors(e,t),s.cross(vi);let r=s.lengthSq();return r>0?s.multiplyScalar(1/Math.sqrt(
r)):s.set(0,0,0)}static getBarycoord(e,t,n,s,r){vi.subVectors(s,t),ts.subVectors(n,t),lu.subVectors(e,t);let o=vi.dot(vi),a=vi.dot(ts),l=vi.dot(lu),c=ts.dot(ts),
d=ts.dot(lu),u=o*c-a*a;if(u===0)return r.set(0,0,0),null;let h=1/u,f=(c*l-a*d)*h,p=(o*d-a*l)*h;return r.set(1-f-p,p,f)}static containsPoint(e,t,n,s){return this.
getBarycoord(e,t,n,s,ns)===null?!1:ns.x>=0&&ns.y>=0&&ns.x+ns.y<=1}static getInterpolation(e,t,n,s,r,o,a,l){return this.getBarycoord(e,t,n,s,ns)===null?(l.x=0,l.
y=0,"z"in l&&(l.z=0),"w"in l&&(l.w=0),null):(l.setScalar(0),l.addScaledVector(r,ns.x),l.addScaledVector(o,ns.y),l.addScaledVector(a,ns.z),l)}static getInterpolatedAttribute(e,t,n,s,r,o){
return du.setScalar(0),fu.setScalar(0),pu.setScalar(0),du.fromBufferAttribute(e,t),fu.fromBufferAttribute(e,n),pu.fromBufferAttribute(e,s),o.setScalar(0),o.addScaledVector(
du,r.x),o.addScaledVector(fu,r.y),o.addScaledVector(pu,r.z),o}static isFrontFacing(e,t,n,s){return vi.subVectors(n,t),ts.subVectors(e,t),vi.cross(ts).dot(s)<0}set(e,t,n){
return this.a.copy(e),this.b.copy(t),this.c.copy(n),this}setFromPointsAndIndices(e,t,n,s){return this.a.copy(e[t]),this.b.copy(e[n]),this.c.copy(e[s]),this}setFromAttributeAndIndices(e,t,n,s){
return this.a.fromBufferAttribute(e,t),this.b.fromBufferAttribute(e,n),this.c.fromBufferAttribute(e,s),this}clone(){return new this.constructor().copy(this)}copy(e){
return this.a.copy(e.a),this.b.copy(e.b),this.c.copy(e.c),this}getArea(){return vi.subVectors(this.c,this.b),ts.subVectors(this.a,this.b),vi.cross(ts).length()*
.5}getMidpoint(e){return e.addVectors(this.a,this.b).add(this.c).multiplyScalar(1/3)}getNormal(e){return i.getNormal(this.a,this.b,this.c,e)}getPlane(e){return e.
setFromCoplanarPoints(this.a,this.b,this.c)}getBarycoord(e,t){return i.getBarycoord(e,this.a,this.b,this.c,t)}getInterpolation(e,t,n,s,r){return i.getInterpolation(
e,this.a,this.b,this.c,t,n,s,r)}containsPoint(e){return i.containsPoint(e,this.a,this.b,this.c)}isFrontFacing(e){return i.isFrontFacing(this.a,this.b,this.c,e)}intersectsBox(e){
return e.intersectsTriangle(this)}closestPointToPoint(e,t){let n=this.a,s=this.b,r=this.c,o,a;Or.subVectors(s,n),Br.subVectors(r,n),cu.subVectors(e,n);let l=Or.
dot(cu),c=Br.dot(cu);if(l<=0&&c<=0)return t.copy(n);hu.subVectors(e,s);let d=Or.dot(hu),u=Br.dot(hu);if(d>=0&&u<=d)return t.copy(s);let h=l*u-d*c;if(h<=0&&l>=0&&
d<=0&&l-d>0)return o=l/(l-d),t.copy(n).addScaledVector(Or,o);uu.subVectors(e,r);let f=Or.dot(uu),p=Br.dot(uu);if(p>=0&&f<=p)return t.copy(r);let x=f*c-l*p;if(x<=
0&&c>=0&&p<=0)return a=c/(c-p),t.copy(n).addScaledVector(Br,a);let m=d*p-f*u;if(m<=0&&u-d>=0&&f-p>=0)return nm.subVectors(r,s),a=(u-d)/(u-d+(f-p)),t.copy(s).addScaledVector(
nm,a);let g=1/(m+x+h);return o=x*g,a=h*g,t.copy(n).addScaledVector(Or,o).addScaledVector(Br,a)}equals(e){return e.a.equals(this.a)&&e.b.equals(this.b)&&e.c.equals(
this.c)}},zi=class{constructor(e=new V(1/0,1/0,1/0),t=new V(-1/0,-1/0,-1/0)){this.isBox3=!0,this.min=e,this.max=t}set(e,t){return this.min.copy(e),this.max.copy(
t),this}setFromArray(e){this.makeEmpty();for(let t=0,n=e.length;t<n;t+=3)this.expandByPoint(bi.fromArray(e,t));return this}setFromBufferAttribute(e){this.makeEmpty();
for(let t=0,n=e.count;t<n;t++)this.expandByPoint(bi.fromBufferAttribute(e,t));return this}setFromPoints(e){this.makeEmpty();for(let t=0,n=e.length;t<n;t++)this.
expandByPoint(e[t]);return this}setFromCenterAndSize(e,t){let n=bi.copy(t).multiplyScalar(.5);return this.min.copy(e).sub(n),this.max.copy(e).add(n),this}setFromObject(e,t=!1){
return this.makeEmpty(),this.expandByObject(e,t)}clone(){return new this.constructor().copy(this)}copy(e){return this.min.copy(e.min),this.max.copy(e.max),this}makeEmpty(){
return this.min.x=this.min.y=this.min.z=1/0,this.max.x=this.max.y=this.max.z=-1/0,this}isEmpty(){return this.max.x<this.min.x||this.max.y<this.min.y||this.max.z<
this.min.z}getCenter(e){return this.isEmpty()?e.set(0,0,0):e.addVectors(this.min,this.max).multiplyScalar(.5)}getSize(e){return this.isEmpty()?e.set(0,0,0):e.subVectors(
this.max,this.min)}expandByPoint(e){return this.min.min(e),this.max.max(e),this}expandByVector(e){return this.min.sub(e),this.max.add(e),this}expandByScalar(e){
return this.min.addScalar(-e),this.max.addScalar(e),this}expandByObject(e,t=!1){e.updateWorldMatrix(!1,!1);let n=e.geometry;if(n!==void 0){let r=n.getAttribute(
"position");if(t===!0&&r!==void 0&&e.isInstancedMesh!==!0&&e.isBatchedMesh!==!0)for(let o=0,a=r.count;o<a;o++)e.isMesh===!0?e.getVertexPosition(o,bi):bi.fromBufferAttribute(
r,o),bi.applyMatrix4(e.matrixWorld),this.expandByPoint(bi);else e.boundingBox!==void 0?(e.boundingBox===null&&e.computeBoundingBox(),Ka.copy(e.boundingBox)):(n.
boundingBox===null&&n.computeBoundingBox(),Ka.copy(n.boundingBox)),Ka.applyMatrix4(e.matrixWorld),this.union(Ka)}let s=e.children;for(let r=0,o=s.length;r<o;r++)
this.expandByObject(s[r],t);return this}containsPoint(e){return e.x>=this.min.x&&e.x<=this.max.x&&e.y>=this.min.y&&e.y<=this.max.y&&e.z>=this.min.z&&e.z<=this.max.
z}containsBox(e){return this.min.x<=e.min.x&&e.max.x<=this.max.x&&this.min.y<=e.min.y&&e.max.y<=this.max.y&&this.min.z<=e.min.z&&e.max.z<=this.max.z}getParameter(e,t){
return t.set((e.x-this.min.x)/(this.max.x-this.min.x),(e.y-this.min.y)/(this.max.y-this.min.y),(e.z-this.min.z)/(this.max.z-this.min.z))}intersectsBox(e){return e.
max.x>=this.min.x&&e.min.x<=this.max.x&&e.max.y>=this.min.y&&e.min.y<=this.max.y&&e.max.z>=this.min.z&&e.min.z<=this.max.z}intersectsSphere(e){return this.clampPoint(
e.center,bi),bi.distanceToSquared(e.center)<=e.radius*e.radius}intersectsPlane(e){let t,n;return e.normal.x>0?(t=e.normal.x*this.min.x,n=e.normal.x*this.max.x):
(t=e.normal.x*this.max.x,n=e.normal.x*this.min.x),e.normal.y>0?(t+=e.normal.y*this.min.y,n+=e.normal.y*this.max.y):(t+=e.normal.y*this.max.y,n+=e.normal.y*this.
min.y),e.normal.z>0?(t+=e.normal.z*this.min.z,n+=e.normal.z*this.max.z):(t+=e.normal.z*this.max.z,n+=e.normal.z*this.min.z),t<=-e.constant&&n>=-e.constant}intersectsTriangle(e){
if(this.isEmpty())return!1;this.getCenter(Do),ja.subVectors(this.max,Do),kr.subVectors(e.a,Do),zr.subVectors(e.b,Do),Vr.subVectors(e.c,Do),Cs.subVectors(zr,kr),
Rs.subVectors(Vr,zr),tr.subVectors(kr,Vr);let t=[0,-Cs.z,Cs.y,0,-Rs.z,Rs.y,0,-tr.z,tr.y,Cs.z,0,-Cs.x,Rs.z,0,-Rs.x,tr.z,0,-tr.x,-Cs.y,Cs.x,0,-Rs.y,Rs.x,0,-tr.y,tr.
x,0];return!mu(t,kr,zr,Vr,ja)||(t=[1,0,0,0,1,0,0,0,1],!mu(t,kr,zr,Vr,ja))?!1:(Qa.crossVectors(Cs,Rs),t=[Qa.x,Qa.y,Qa.z],mu(t,kr,zr,Vr,ja))}clampPoint(e,t){return t.
copy(e).clamp(this.min,this.max)}distanceToPoint(e){return this.clampPoint(e,bi).distanceTo(e)}getBoundingSphere(e){return this.isEmpty()?e.makeEmpty():(this.getCenter(
e.center),e.radius=this.getSize(bi).length()*.5),e}intersect(e){return this.min.max(e.min),this.max.min(e.max),this.isEmpty()&&this.makeEmpty(),this}union(e){return this.
min.min(e.min),this.max.max(e.max),this}applyMatrix4(e){return this.isEmpty()?this:(is[0].set(this.min.x,this.min.y,this.min.z).applyMatrix4(e),is[1].set(this.min.
x,this.min.y,this.max.z).applyMatrix4(e),is[2].set(this.min.x,this.max.y,this.min.z).applyMatrix4(e),is[3].set(this.min.x,this.max.y,this.max.z).applyMatrix4(e),
is[4].set(this.max.x,this.min.y,this.min.z).applyMatrix4(e),is[5].set(this.max.x,this.min.y,this.max.z).applyMatrix4(e),is[6].set(this.max.x,this.max.y,this.min.
z).applyMatrix4(e),is[7].set(this.max.x,this.max.y,this.max.z).applyMatrix4(e),this.setFromPoints(is),this)}translate(e){return this.min.add(e),this.max.add(e),
this}equals(e){return e.min.equals(this.min)&&e.max.equals(this.max)}toJSON(){return{min:this.min.toArray(),max:this.max.toArray()}}fromJSON(e){return this.min.
fromArray(e.min),this.max.fromArray(e.max),this}},is=[new V,new V,new V,new V,new V,new V,new V,new V],bi=new V,Ka=new zi,kr=new V,zr=new V,Vr=new V,Cs=new V,Rs=new V,
tr=new V,Do=new V,ja=new V,Qa=new V,nr=new V;function mu(i,e,t,n,s){for(let r=0,o=i.length-3;r<=o;r+=3){nr.fromArray(i,r);let a=s.x*Math.abs(nr.x)+s.y*Math.abs(
nr.y)+s.z*Math.abs(nr.z),l=e.dot(nr),c=t.dot(nr),d=n.dot(nr);if(Math.max(-Math.max(l,c,d),Math.min(l,c,d))>a)return!1}return!0}var an=new V,el=new st,wy=0,Mi=class extends ki{constructor(e,t,n=!1){if(super(),Array.isArray(e))throw new TypeError("THREE.BufferAttribute: array should be a \
Typed Array.");this.isBufferAttribute=!0,Object.defineProperty(this,"id",{value:wy++}),this.name="",this.array=e,this.itemSize=t,this.count=e!==void 0?e.length/
t:0,this.normalized=n,this.usage=tg,this.updateRanges=[],this.gpuType=di,this.version=0,this._normalizationScale=e!==void 0?id(e):void 0}onUploadCallback(){}set needsUpdate(e){
e===!0&&this.version++}setUsage(e){return this.usage=e,this}addUpdateRange(e,t){this.updateRanges.push({start:e,count:t})}clearUpdateRanges(){this.updateRanges.
length=0}copy(e){return this.name=e.name,this.array=new e.array.constructor(e.array),this.itemSize=e.itemSize,this.count=e.count,this.normalized=e.normalized,this.
usage=e.usage,this.gpuType=e.gpuType,this._normalizationScale=e._normalizationScale,this}copyAt(e,t,n){e*=this.itemSize,n*=t.itemSize;for(let s=0,r=this.itemSize;s<
r;s++)this.array[e+s]=t.array[n+s];return this}copyArray(e){return this.array.set(e),this}applyMatrix3(e){if(this.itemSize===2)for(let t=0,n=this.count;t<n;t++)
el.fromBufferAttribute(this,t),el.applyMatrix3(e),this.setXY(t,el.x,el.y);else if(this.itemSize===3)for(let t=0,n=this.count;t<n;t++)an.fromBufferAttribute(this,
t),an.applyMatrix3(e),this.setXYZ(t,an.x,an.y,an.z);return this}applyMatrix4(e){for(let t=0,n=this.count;t<n;t++)an.fromBufferAttribute(this,t),an.applyMatrix4(
e),this.setXYZ(t,an.x,an.y,an.z);return this}applyNormalMatrix(e){for(let t=0,n=this.count;t<n;t++)an.fromBufferAttribute(this,t),an.applyNormalMatrix(e),this.setXYZ(
t,an.x,an.y,an.z);return this}transformDirection(e){for(let t=0,n=this.count;t<n;t++)an.fromBufferAttribute(this,t),an.transformDirection(e),this.setXYZ(t,an.x,
an.y,an.z);return this}set(e,t=0){return this.array.set(e,t),this}getComponent(e,t){let n=this.array[e*this.itemSize+t];return this.normalized&&(n=this._denormalize(
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
return t!==void 0?Math.max(e/t,-1):dy(e,this.array)}_normalize(e){let t=this._normalizationScale;return t!==void 0?Math.round(e*t):fy(e,this.array)}};var qo=class extends Mi{constructor(e,t,n){super(new Uint16Array(e),t,n)}};var Yo=class extends Mi{constructor(e,t,n){super(new Uint32Array(e),t,n)}};var yt=class extends Mi{constructor(e,t,n){super(new Float32Array(e),t,n)}},Ty=new zi,Uo=new V,gu=new V,ls=class{constructor(e=new V,t=-1){this.isSphere=!0,this.
center=e,this.radius=t}set(e,t){return this.center.copy(e),this.radius=t,this}setFromPoints(e,t){let n=this.center;t!==void 0?n.copy(t):Ty.setFromPoints(e).getCenter(
n);let s=0;for(let r=0,o=e.length;r<o;r++)s=Math.max(s,n.distanceToSquared(e[r]));return this.radius=Math.sqrt(s),this}copy(e){return this.center.copy(e.center),
this.radius=e.radius,this}isEmpty(){return this.radius<0}makeEmpty(){return this.center.set(0,0,0),this.radius=-1,this}containsPoint(e){return e.distanceToSquared(
this.center)<=this.radius*this.radius}distanceToPoint(e){return e.distanceTo(this.center)-this.radius}intersectsSphere(e){let t=this.radius+e.radius;return e.center.
distanceToSquared(this.center)<=t*t}intersectsBox(e){return e.intersectsSphere(this)}intersectsPlane(e){return Math.abs(e.distanceToPoint(this.center))<=this.radius}clampPoint(e,t){
let n=this.center.distanceToSquared(e);return t.copy(e),n>this.radius*this.radius&&(t.sub(this.center).normalize(),t.multiplyScalar(this.radius).add(this.center)),
t}getBoundingBox(e){return this.isEmpty()?(e.makeEmpty(),e):(e.set(this.center,this.center),e.expandByScalar(this.radius),e)}applyMatrix4(e){return this.center.
applyMatrix4(e),this.radius=this.radius*e.getMaxScaleOnAxis(),this}translate(e){return this.center.add(e),this}expandByPoint(e){if(this.isEmpty())return this.center.
copy(e),this.radius=0,this;Uo.subVectors(e,this.center);let t=Uo.lengthSq();if(t>this.radius*this.radius){let n=Math.sqrt(t),s=(n-this.radius)*.5;this.center.addScaledVector(
Uo,s/n),this.radius+=s}return this}union(e){return e.isEmpty()?this:this.isEmpty()?(this.copy(e),this):(this.center.equals(e.center)===!0?this.radius=Math.max(this.
radius,e.radius):(gu.subVectors(e.center,this.center).setLength(e.radius),this.expandByPoint(Uo.copy(e.center).add(gu)),this.expandByPoint(Uo.copy(e.center).sub(
gu))),this)}equals(e){return e.center.equals(this.center)&&e.radius===this.radius}clone(){return new this.constructor().copy(this)}toJSON(){return{radius:this.radius,
center:this.center.toArray()}}fromJSON(e){return this.radius=e.radius,this.center.fromArray(e.center),this}},Ay=0,ci=new xt,_u=new wn,Gr=new V,Qn=new zi,Fo=new zi,
bn=new V,ln=class i extends ki{constructor(){super(),this.isBufferGeometry=!0,Object.defineProperty(this,"id",{value:Ay++}),this.uuid=Ma(),this.name="",this.type=
"BufferGeometry",this.index=null,this.indirect=null,this.indirectOffset=0,this.attributes={},this.morphAttributes={},this.morphTargetsRelative=!1,this.groups=[],
this.boundingBox=null,this.boundingSphere=null,this.drawRange={start:0,count:1/0},this.userData={},this._transformed=!1}getIndex(){return this.index}setIndex(e){
return Array.isArray(e)?this.index=new(cy(e)?Yo:qo)(e,1):this.index=e,this}setIndirect(e,t=0){return this.indirect=e,this.indirectOffset=t,this}getIndirect(){return this.
indirect}getAttribute(e){return this.attributes[e]}setAttribute(e,t){return this.attributes[e]=t,this}deleteAttribute(e){return delete this.attributes[e],this}hasAttribute(e){
return this.attributes[e]!==void 0}addGroup(e,t,n=0){this.groups.push({start:e,count:t,materialIndex:n})}clearGroups(){this.groups=[]}setDrawRange(e,t){this.drawRange.
start=e,this.drawRange.count=t}applyMatrix4(e){let t=this.attributes.position;t!==void 0&&(t.applyMatrix4(e),t.needsUpdate=!0);let n=this.attributes.normal;if(n!==
void 0){let r=new Qe().getNormalMatrix(e);n.applyNormalMatrix(r),n.needsUpdate=!0}let s=this.attributes.tangent;return s!==void 0&&(s.transformDirection(e),s.needsUpdate=
!0),this.boundingBox!==null&&this.computeBoundingBox(),this.boundingSphere!==null&&this.computeBoundingSphere(),this._transformed=!0,this}applyQuaternion(e){return ci.
makeRotationFromQuaternion(e),this.applyMatrix4(ci),this}rotateX(e){return ci.makeRotationX(e),this.applyMatrix4(ci),this}rotateY(e){return ci.makeRotationY(e),
this.applyMatrix4(ci),this}rotateZ(e){return ci.makeRotationZ(e),this.applyMatrix4(ci),this}translate(e,t,n){return ci.makeTranslation(e,t,n),this.applyMatrix4(
ci),this}scale(e,t,n){return ci.makeScale(e,t,n),this.applyMatrix4(ci),this}lookAt(e){return _u.lookAt(e),_u.updateMatrix(),this.applyMatrix4(_u.matrix),this}center(){
return this.computeBoundingBox(),this.boundingBox.getCenter(Gr).negate(),this.translate(Gr.x,Gr.y,Gr.z),this}setFromPoints(e){let t=this.getAttribute("position");
if(t===void 0){let n=[];for(let s=0,r=e.length;s<r;s++){let o=e[s];n.push(o.x,o.y,o.z||0)}this.setAttribute("position",new yt(n,3))}else{let n=Math.min(e.length,
t.count);for(let s=0;s<n;s++){let r=e[s];t.setXYZ(s,r.x,r.y,r.z||0)}e.length>t.count&&qe("BufferGeometry: Buffer size too small for points data. Use .dispose() \
and create a new geometry."),t.needsUpdate=!0}return this}computeBoundingBox(){this.boundingBox===null&&(this.boundingBox=new zi);let e=this.attributes.position,
t=this.morphAttributes.position;if(e&&e.isGLBufferAttribute){Ke("BufferGeometry.computeBoundingBox(): GLBufferAttribute requires a manual bounding box.",this),this.
boundingBox.set(new V(-1/0,-1/0,-1/0),new V(1/0,1/0,1/0));return}if(e!==void 0){if(this.boundingBox.setFromBufferAttribute(e),t)for(let n=0,s=t.length;n<s;n++){
let r=t[n];Qn.setFromBufferAttribute(r),this.morphTargetsRelative?(bn.addVectors(this.boundingBox.min,Qn.min),this.boundingBox.expandByPoint(bn),bn.addVectors(this.
boundingBox.max,Qn.max),this.boundingBox.expandByPoint(bn)):(this.boundingBox.expandByPoint(Qn.min),this.boundingBox.expandByPoint(Qn.max))}}else this.boundingBox.
makeEmpty();(isNaN(this.boundingBox.min.x)||isNaN(this.boundingBox.min.y)||isNaN(this.boundingBox.min.z))&&Ke('BufferGeometry.computeBoundingBox(): Computed min\
/max have NaN values. The "position" attribute is likely to have NaN values.',this)}computeBoundingSphere(){this.boundingSphere===null&&(this.boundingSphere=new ls);
let e=this.attributes.position,t=this.morphAttributes.position;if(e&&e.isGLBufferAttribute){Ke("BufferGeometry.computeBoundingSphere(): GLBufferAttribute requir\
es a manual bounding sphere.",this),this.boundingSphere.set(new V,1/0);return}if(e){let n=this.boundingSphere.center;if(Qn.setFromBufferAttribute(e),t)for(let r=0,
o=t.length;r<o;r++){let a=t[r];Fo.setFromBufferAttribute(a),this.morphTargetsRelative?(bn.addVectors(Qn.min,Fo.min),Qn.expandByPoint(bn),bn.addVectors(Qn.max,Fo.
max),Qn.expandByPoint(bn)):(Qn.expandByPoint(Fo.min),Qn.expandByPoint(Fo.max))}Qn.getCenter(n);let s=0;for(let r=0,o=e.count;r<o;r++)bn.fromBufferAttribute(e,r),
s=Math.max(s,n.distanceToSquared(bn));if(t)for(let r=0,o=t.length;r<o;r++){let a=t[r],l=this.morphTargetsRelative;for(let c=0,d=a.count;c<d;c++)bn.fromBufferAttribute(
a,c),l&&(Gr.fromBufferAttribute(e,c),bn.add(Gr)),s=Math.max(s,n.distanceToSquared(bn))}this.boundingSphere.radius=Math.sqrt(s),isNaN(this.boundingSphere.radius)&&
Ke('BufferGeometry.computeBoundingSphere(): Computed radius is NaN. The "position" attribute is likely to have NaN values.',this)}}computeTangents(){let e=this.
index,t=this.attributes;if(e===null||t.position===void 0||t.normal===void 0||t.uv===void 0){Ke("BufferGeometry: .computeTangents() failed. Missing required attr\
ibutes (index, position, normal or uv)");return}let n=t.position,s=t.normal,r=t.uv,o=this.getAttribute("tangent");(o===void 0||o.count!==n.count)&&(o=new Mi(new Float32Array(
4*n.count),4),this.setAttribute("tangent",o));let a=[],l=[],c=new Uint8Array(n.count);for(let R=0;R<n.count;R++)a[R]=new V,l[R]=new V;let d=new V,u=new V,h=new V,
f=new st,p=new st,x=new st,m=new V,g=new V;function y(R,P,I){c[R]=c[P]=c[I]=1,d.fromBufferAttribute(n,R),u.fromBufferAttribute(n,P),h.fromBufferAttribute(n,I),f.
fromBufferAttribute(r,R),p.fromBufferAttribute(r,P),x.fromBufferAttribute(r,I),u.sub(d),h.sub(d),p.sub(f),x.sub(f);let F=1/(p.x*x.y-x.x*p.y);isFinite(F)&&(m.copy(
u).multiplyScalar(x.y).addScaledVector(h,-p.y).multiplyScalar(F),g.copy(h).multiplyScalar(p.x).addScaledVector(u,-x.x).multiplyScalar(F),a[R].add(m),a[P].add(m),
a[I].add(m),l[R].add(g),l[P].add(g),l[I].add(g))}let S=this.groups;S.length===0&&(S=[{start:0,count:e.count}]);for(let R=0,P=S.length;R<P;++R){let I=S[R],F=I.start,
z=I.count;for(let D=F,G=F+z;D<G;D+=3)y(e.getX(D+0),e.getX(D+1),e.getX(D+2))}let b=new V,C=new V,w=new V,_=new V;function M(R){w.fromBufferAttribute(s,R),_.copy(
w);let P=a[R];b.copy(P),b.sub(w.multiplyScalar(w.dot(P))).normalize(),C.crossVectors(_,P);let F=C.dot(l[R])<0?-1:1;o.setXYZW(R,b.x,b.y,b.z,F)}for(let R=0,P=n.count;R<
P;++R)c[R]&&M(R);this._transformed=!0}computeVertexNormals(){let e=this.index,t=this.getAttribute("position");if(t!==void 0){let n=this.getAttribute("normal");if(n===
void 0||n.count!==t.count)n=new Mi(new Float32Array(t.count*3),3),this.setAttribute("normal",n);else for(let h=0,f=n.count;h<f;h++)n.setXYZ(h,0,0,0);let s=new V,
r=new V,o=new V,a=new V,l=new V,c=new V,d=new V,u=new V;if(e)for(let h=0,f=e.count;h<f;h+=3){let p=e.getX(h+0),x=e.getX(h+1),m=e.getX(h+2);s.fromBufferAttribute(
t,p),r.fromBufferAttribute(t,x),o.fromBufferAttribute(t,m),d.subVectors(o,r),u.subVectors(s,r),d.cross(u),a.fromBufferAttribute(n,p),l.fromBufferAttribute(n,x),
c.fromBufferAttribute(n,m),a.add(d),l.add(d),c.add(d),n.setXYZ(p,a.x,a.y,a.z),n.setXYZ(x,l.x,l.y,l.z),n.setXYZ(m,c.x,c.y,c.z)}else for(let h=0,f=t.count;h<f;h+=
3)s.fromBufferAttribute(t,h+0),r.fromBufferAttribute(t,h+1),o.fromBufferAttribute(t,h+2),d.subVectors(o,r),u.subVectors(s,r),d.cross(u),n.setXYZ(h+0,d.x,d.y,d.z),
n.setXYZ(h+1,d.x,d.y,d.z),n.setXYZ(h+2,d.x,d.y,d.z);this.normalizeNormals(),n.needsUpdate=!0}}normalizeNormals(){let e=this.attributes.normal;for(let t=0,n=e.count;t<
n;t++)bn.fromBufferAttribute(e,t),bn.normalize(),e.setXYZ(t,bn.x,bn.y,bn.z)}toNonIndexed(){function e(a,l){let c=a.array,d=a.itemSize,u=a.normalized,h=new c.constructor(
l.length*d),f=0,p=0;for(let x=0,m=l.length;x<m;x++){a.isInterleavedBufferAttribute?f=l[x]*a.data.stride+a.offset:f=l[x]*d;for(let g=0;g<d;g++)h[p++]=c[f++]}return new Mi(
h,d,u)}if(this.index===null)return qe("BufferGeometry.toNonIndexed(): BufferGeometry is already non-indexed."),this;let t=new i,n=this.index.array,s=this.attributes;
for(let a in s){let l=s[a],c=e(l,n);t.setAttribute(a,c)}let r=this.morphAttributes;for(let a in r){let l=[],c=r[a];for(let d=0,u=c.length;d<u;d++){let h=c[d],f=e(
h,n);l.push(f)}t.morphAttributes[a]=l}t.morphTargetsRelative=this.morphTargetsRelative;let o=this.groups;for(let a=0,l=o.length;a<l;a++){let c=o[a];t.addGroup(c.
start,c.count,c.materialIndex)}return t}toJSON(){let e={metadata:{version:4.7,type:"BufferGeometry",generator:"BufferGeometry.toJSON"}};if(e.uuid=this.uuid,e.type=
this.parameters!==void 0&&this._transformed===!0?"BufferGeometry":this.type,e.name=this.name,Object.keys(this.userData).length>0&&(e.userData=this.userData),this.
parameters!==void 0&&this._transformed!==!0){let l=this.parameters;for(let c in l)l[c]!==void 0&&(e[c]=l[c]);return e}e.data={attributes:{}};let t=this.index;t!==
null&&(e.data.index={type:t.array.constructor.name,array:Array.prototype.slice.call(t.array)});let n=this.attributes;for(let l in n){let c=n[l];e.data.attributes[l]=
c.toJSON(e.data)}let s={},r=!1;for(let l in this.morphAttributes){let c=this.morphAttributes[l],d=[];for(let u=0,h=c.length;u<h;u++){let f=c[u];d.push(f.toJSON(
e.data))}d.length>0&&(s[l]=d,r=!0)}r&&(e.data.morphAttributes=s,e.data.morphTargetsRelative=this.morphTargetsRelative);let o=this.groups;o.length>0&&(e.data.groups=
JSON.parse(JSON.stringify(o)));let a=this.boundingSphere;return a!==null&&(e.data.boundingSphere=a.toJSON()),e}clone(){return new this.constructor().copy(this)}copy(e){
this.index=null,this.attributes={},this.morphAttributes={},this.groups=[],this.boundingBox=null,this.boundingSphere=null;let t={};this.name=e.name;let n=e.index;
n!==null&&this.setIndex(n.clone());let s=e.attributes;for(let c in s){let d=s[c];this.setAttribute(c,d.clone(t))}let r=e.morphAttributes;for(let c in r){let d=[],
u=r[c];for(let h=0,f=u.length;h<f;h++)d.push(u[h].clone(t));this.morphAttributes[c]=d}this.morphTargetsRelative=e.morphTargetsRelative;let o=e.groups;for(let c=0,
d=o.length;c<d;c++){let u=o[c];this.addGroup(u.start,u.count,u.materialIndex)}let a=e.boundingBox;a!==null&&(this.boundingBox=a.clone());let l=e.boundingSphere;
return l!==null&&(this.boundingSphere=l.clone()),this.drawRange.start=e.drawRange.start,this.drawRange.count=e.drawRange.count,this.userData=e.userData,this._transformed=
e._transformed,this}dispose(){this.dispatchEvent({type:"dispose"})}};var xu=new V,Ey=new V,Cy=new Qe,ti=class{constructor(e=new V(1,0,0),t=0){this.isPlane=!0,this.normal=e,this.constant=t}set(e,t){return this.normal.copy(e),this.
constant=t,this}setComponents(e,t,n,s){return this.normal.set(e,t,n),this.constant=s,this}setFromNormalAndCoplanarPoint(e,t){return this.normal.copy(e),this.constant=
-t.dot(this.normal),this}setFromCoplanarPoints(e,t,n){let s=xu.subVectors(n,t).cross(Ey.subVectors(e,t)).normalize();return this.setFromNormalAndCoplanarPoint(s,
e),this}copy(e){return this.normal.copy(e.normal),this.constant=e.constant,this}normalize(){let e=1/this.normal.length();return this.normal.multiplyScalar(e),this.
constant*=e,this}negate(){return this.constant*=-1,this.normal.negate(),this}distanceToPoint(e){return this.normal.dot(e)+this.constant}distanceToSphere(e){return this.
distanceToPoint(e.center)-e.radius}projectPoint(e,t){return t.copy(e).addScaledVector(this.normal,-this.distanceToPoint(e))}intersectLine(e,t,n=!0){let s=e.delta(
xu),r=this.normal.dot(s);if(r===0)return this.distanceToPoint(e.start)===0?t.copy(e.start):null;let o=-(e.start.dot(this.normal)+this.constant)/r;return n===!0&&
(o<0||o>1)?null:t.copy(e.start).addScaledVector(s,o)}intersectsLine(e){let t=this.distanceToPoint(e.start),n=this.distanceToPoint(e.end);return t<0&&n>0||n<0&&t>
0}intersectsBox(e){return e.intersectsPlane(this)}intersectsSphere(e){return e.intersectsPlane(this)}coplanarPoint(e){return e.copy(this.normal).multiplyScalar(
-this.constant)}applyMatrix4(e,t){let n=t||Cy.getNormalMatrix(e),s=this.coplanarPoint(xu).applyMatrix4(e),r=this.normal.applyMatrix3(n).normalize();return this.
constant=-s.dot(r),this}translate(e){return this.constant-=e.dot(this.normal),this}equals(e){return e.normal.equals(this.normal)&&e.constant===this.constant}clone(){
return new this.constructor().copy(this)}toJSON(){return{normal:this.normal.toArray(),constant:this.constant}}fromJSON(e){return this.normal.fromArray(e.normal),
this.constant=e.constant,this}},Ry=0,cs=class extends ki{constructor(){super(),this.isMaterial=!0,Object.defineProperty(this,"id",{value:Ry++}),this.uuid=Ma(),this.
name="",this.type="Material",this.blending=lo,this.side=ks,this.vertexColors=!1,this.opacity=1,this.transparent=!1,this.alphaHash=!1,this.blendSrc=Fu,this.blendDst=
Ou,this.blendEquation=or,this.blendSrcAlpha=null,this.blendDstAlpha=null,this.blendEquationAlpha=null,this.blendColor=new rt(0,0,0),this.blendAlpha=0,this.depthFunc=
Jr,this.depthTest=!0,this.depthWrite=!0,this.stencilWriteMask=255,this.stencilFunc=Zm,this.stencilRef=0,this.stencilFuncMask=255,this.stencilFail=yl,this.stencilZFail=
yl,this.stencilZPass=yl,this.stencilWrite=!1,this.clippingPlanes=null,this.clipIntersection=!1,this.clipShadows=!1,this.shadowSide=null,this.colorWrite=!0,this.
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
for(let a in r){let l=r[a];delete l.metadata,o.push(l)}return o}if(t){let r=s(e.textures),o=s(e.images);r.length>0&&(n.textures=r),o.length>0&&(n.images=o)}return n}fromJSON(e,t){
if(e.uuid!==void 0&&(this.uuid=e.uuid),e.name!==void 0&&(this.name=e.name),e.color!==void 0&&this.color!==void 0&&this.color.setHex(e.color),e.roughness!==void 0&&
(this.roughness=e.roughness),e.metalness!==void 0&&(this.metalness=e.metalness),e.sheen!==void 0&&(this.sheen=e.sheen),e.sheenColor!==void 0&&(this.sheenColor=new rt().
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
e.colorWrite!==void 0&&(this.colorWrite=e.colorWrite),e.clippingPlanes!==void 0&&(this.clippingPlanes=e.clippingPlanes.map(n=>new ti().fromJSON(n))),e.clipIntersection!==
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
(n=[n,n]),this.normalScale=new st().fromArray(n)}return e.displacementMap!==void 0&&(this.displacementMap=t[e.displacementMap]||null),e.displacementScale!==void 0&&
(this.displacementScale=e.displacementScale),e.displacementBias!==void 0&&(this.displacementBias=e.displacementBias),e.roughnessMap!==void 0&&(this.roughnessMap=
t[e.roughnessMap]||null),e.metalnessMap!==void 0&&(this.metalnessMap=t[e.metalnessMap]||null),e.emissiveMap!==void 0&&(this.emissiveMap=t[e.emissiveMap]||null),
e.emissiveIntensity!==void 0&&(this.emissiveIntensity=e.emissiveIntensity),e.specularMap!==void 0&&(this.specularMap=t[e.specularMap]||null),e.specularIntensityMap!==
void 0&&(this.specularIntensityMap=t[e.specularIntensityMap]||null),e.specularColorMap!==void 0&&(this.specularColorMap=t[e.specularColorMap]||null),e.envMap!==
void 0&&(this.envMap=t[e.envMap]||null),e.envMapRotation!==void 0&&this.envMapRotation.fromArray(e.envMapRotation),e.envMapIntensity!==void 0&&(this.envMapIntensity=
e.envMapIntensity),e.reflectivity!==void 0&&(this.reflectivity=e.reflectivity),e.refractionRatio!==void 0&&(this.refractionRatio=e.refractionRatio),e.lightMap!==
void 0&&(this.lightMap=t[e.lightMap]||null),e.lightMapIntensity!==void 0&&(this.lightMapIntensity=e.lightMapIntensity),e.aoMap!==void 0&&(this.aoMap=t[e.aoMap]||
null),e.aoMapIntensity!==void 0&&(this.aoMapIntensity=e.aoMapIntensity),e.gradientMap!==void 0&&(this.gradientMap=t[e.gradientMap]||null),e.clearcoatMap!==void 0&&
(this.clearcoatMap=t[e.clearcoatMap]||null),e.clearcoatRoughnessMap!==void 0&&(this.clearcoatRoughnessMap=t[e.clearcoatRoughnessMap]||null),e.clearcoatNormalMap!==
void 0&&(this.clearcoatNormalMap=t[e.clearcoatNormalMap]||null),e.clearcoatNormalScale!==void 0&&(this.clearcoatNormalScale=new st().fromArray(e.clearcoatNormalScale)),
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
this.version++}};var ss=new V,yu=new V,tl=new V,nl=new V,no=class{constructor(e=new V,t=new V(0,0,-1)){this.origin=e,this.direction=t}set(e,t){return this.origin.copy(e),this.direction.
copy(t),this}copy(e){return this.origin.copy(e.origin),this.direction.copy(e.direction),this}at(e,t){return t.copy(this.origin).addScaledVector(this.direction,e)}lookAt(e){
return this.direction.copy(e).sub(this.origin).normalize(),this}recast(e){return this.origin.copy(this.at(e,ss)),this}closestPointToPoint(e,t){t.subVectors(e,this.
origin);let n=t.dot(this.direction);return n<0?t.copy(this.origin):t.copy(this.origin).addScaledVector(this.direction,n)}distanceToPoint(e){return Math.sqrt(this.
distanceSqToPoint(e))}distanceSqToPoint(e){let t=ss.subVectors(e,this.origin).dot(this.direction);return t<0?this.origin.distanceToSquared(e):(ss.copy(this.origin).
addScaledVector(this.direction,t),ss.distanceToSquared(e))}distanceSqToSegment(e,t,n,s){yu.copy(e).add(t).multiplyScalar(.5),tl.copy(t).sub(e).normalize(),nl.copy(
this.origin).sub(yu);let r=e.distanceTo(t)*.5,o=-this.direction.dot(tl),a=nl.dot(this.direction),l=-nl.dot(tl),c=nl.lengthSq(),d=Math.abs(1-o*o),u,h,f,p;if(d>0)
if(u=o*l-a,h=o*a-l,p=r*d,u>=0)if(h>=-p)if(h<=p){let x=1/d;u*=x,h*=x,f=u*(u+o*h+2*a)+h*(o*u+h+2*l)+c}else h=r,u=Math.max(0,-(o*h+a)),f=-u*u+h*(h+2*l)+c;else h=-r,
u=Math.max(0,-(o*h+a)),f=-u*u+h*(h+2*l)+c;else h<=-p?(u=Math.max(0,-(-o*r+a)),h=u>0?-r:Math.min(Math.max(-r,-l),r),f=-u*u+h*(h+2*l)+c):h<=p?(u=0,h=Math.min(Math.
max(-r,-l),r),f=h*(h+2*l)+c):(u=Math.max(0,-(o*r+a)),h=u>0?r:Math.min(Math.max(-r,-l),r),f=-u*u+h*(h+2*l)+c);else h=o>0?-r:r,u=Math.max(0,-(o*h+a)),f=-u*u+h*(h+
2*l)+c;return n&&n.copy(this.origin).addScaledVector(this.direction,u),s&&s.copy(yu).addScaledVector(tl,h),f}intersectSphere(e,t){if(e.radius<0)return null;ss.subVectors(
e.center,this.origin);let n=ss.dot(this.direction),s=ss.dot(ss)-n*n,r=e.radius*e.radius;if(s>r)return null;let o=Math.sqrt(r-s),a=n-o,l=n+o;return l<0?null:a<0?
this.at(l,t):this.at(a,t)}intersectsSphere(e){return e.radius<0?!1:this.distanceSqToPoint(e.center)<=e.radius*e.radius}distanceToPlane(e){let t=e.normal.dot(this.
direction);if(t===0)return e.distanceToPoint(this.origin)===0?0:null;let n=-(this.origin.dot(e.normal)+e.constant)/t;return n>=0?n:null}intersectPlane(e,t){let n=this.
distanceToPlane(e);return n===null?null:this.at(n,t)}intersectsPlane(e){let t=e.distanceToPoint(this.origin);return t===0||e.normal.dot(this.direction)*t<0}intersectBox(e,t){
let n,s,r,o,a,l,c=1/this.direction.x,d=1/this.direction.y,u=1/this.direction.z,h=this.origin;return c>=0?(n=(e.min.x-h.x)*c,s=(e.max.x-h.x)*c):(n=(e.max.x-h.x)*
c,s=(e.min.x-h.x)*c),d>=0?(r=(e.min.y-h.y)*d,o=(e.max.y-h.y)*d):(r=(e.max.y-h.y)*d,o=(e.min.y-h.y)*d),n>o||r>s||((r>n||isNaN(n))&&(n=r),(o<s||isNaN(s))&&(s=o),u>=
0?(a=(e.min.z-h.z)*u,l=(e.max.z-h.z)*u):(a=(e.max.z-h.z)*u,l=(e.min.z-h.z)*u),n>l||a>s)||((a>n||n!==n)&&(n=a),(l<s||s!==s)&&(s=l),s<0)?null:this.at(n>=0?n:s,t)}intersectsBox(e){
return this.intersectBox(e,ss)!==null}intersectTriangle(e,t,n,s,r){let o=this.origin,a=this.direction,l=a.x,c=a.y,d=a.z,u=e.x-o.x,h=e.y-o.y,f=e.z-o.z,p=t.x-o.x,
x=t.y-o.y,m=t.z-o.z,g=n.x-o.x,y=n.y-o.y,S=n.z-o.z,b=Math.abs(l),C=Math.abs(c),w=Math.abs(d),_,M,R,P,I,F,z,D,G,Y,W,ce;if(b>=C&&b>=w?(R=l,F=u,G=p,ce=g,l>=0?(_=c,M=
d,P=h,I=f,z=x,D=m,Y=y,W=S):(_=d,M=c,P=f,I=h,z=m,D=x,Y=S,W=y)):C>=w?(R=c,F=h,G=x,ce=y,c>=0?(_=d,M=l,P=f,I=u,z=m,D=p,Y=S,W=g):(_=l,M=d,P=u,I=f,z=p,D=m,Y=g,W=S)):(R=
d,F=f,G=m,ce=S,d>=0?(_=l,M=c,P=u,I=h,z=p,D=x,Y=g,W=y):(_=c,M=l,P=h,I=u,z=x,D=p,Y=y,W=g)),R===0)return null;let K=_/R,Q=M/R,se=1/R,de=P-K*F,ue=I-Q*F,ee=z-K*G,me=D-
Q*G,xe=Y-K*ce,Ee=W-Q*ce,Me=xe*me-Ee*ee,He=de*Ee-ue*xe,nt=ee*ue-me*de;if(s){if(Me<0||He<0||nt<0)return null}else if((Me<0||He<0||nt<0)&&(Me>0||He>0||nt>0))return null;
let Ve=Me+He+nt;if(Ve===0)return null;let ut=se*(Me*F+He*G+nt*ce);return(Ve>0?ut<0:ut>0)?null:this.at(ut/Ve,r)}applyMatrix4(e){return this.origin.applyMatrix4(e),
this.direction.transformDirection(e),this}equals(e){return e.origin.equals(this.origin)&&e.direction.equals(this.direction)}clone(){return new this.constructor().
copy(this)}},hs=class extends cs{constructor(e){super(),this.isMeshBasicMaterial=!0,this.type="MeshBasicMaterial",this.color=new rt(16777215),this.map=null,this.
lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new as,
this.combine=ec,this.reflectivity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="r\
ound",this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.lightMap=e.lightMap,this.lightMapIntensity=e.lightMapIntensity,
this.aoMap=e.aoMap,this.aoMapIntensity=e.aoMapIntensity,this.specularMap=e.specularMap,this.alphaMap=e.alphaMap,this.envMap=e.envMap,this.envMapRotation.copy(e.
envMapRotation),this.combine=e.combine,this.reflectivity=e.reflectivity,this.refractionRatio=e.refractionRatio,this.wireframe=e.wireframe,this.wireframeLinewidth=
e.wireframeLinewidth,this.wireframeLinecap=e.wireframeLinecap,this.wireframeLinejoin=e.wireframeLinejoin,this.fog=e.fog,this}},im=new xt,ir=new no,il=new ls,sm=new V,
sl=new V,rl=new V,ol=new V,vu=new V,al=new V,rm=new V,ll=new V,ui=class extends wn{constructor(e=new ln,t=new hs){super(),this.isMesh=!0,this.type="Mesh",this.geometry=
e,this.material=t,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.count=1,this.updateMorphTargets()}copy(e,t){return super.copy(e,t),e.
morphTargetInfluences!==void 0?this.morphTargetInfluences=e.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,e.morphTargetDictionary!==void 0?this.
morphTargetDictionary=Object.assign({},e.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(e.material)?e.material.slice():e.material,
this.geometry=e.geometry,this}updateMorphTargets(){let t=this.geometry.morphAttributes,n=Object.keys(t);if(n.length>0){let s=t[n[0]];if(s!==void 0){this.morphTargetInfluences=
[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}getVertexPosition(e,t){
let n=this.geometry,s=n.attributes.position,r=n.morphAttributes.position,o=n.morphTargetsRelative;t.fromBufferAttribute(s,e);let a=this.morphTargetInfluences;if(r&&
a){al.set(0,0,0);for(let l=0,c=r.length;l<c;l++){let d=a[l],u=r[l];d!==0&&(vu.fromBufferAttribute(u,e),o?al.addScaledVector(vu,d):al.addScaledVector(vu.sub(t),d))}
t.add(al)}return t}intersectsFrustum(e){return e.intersectsObject(this)}raycast(e,t){let n=this.geometry,s=this.material,r=this.matrixWorld;s!==void 0&&(n.boundingSphere===
null&&n.computeBoundingSphere(),il.copy(n.boundingSphere),il.applyMatrix4(r),ir.copy(e.ray).recast(e.near),!(il.containsPoint(ir.origin)===!1&&(ir.intersectSphere(
il,sm)===null||ir.origin.distanceToSquared(sm)>(e.far-e.near)**2))&&(im.copy(r).invert(),ir.copy(e.ray).applyMatrix4(im),!(n.boundingBox!==null&&ir.intersectsBox(
n.boundingBox)===!1)&&this._computeIntersections(e,t,ir)))}_computeIntersections(e,t,n){let s,r=this.geometry,o=this.material,a=r.index,l=r.attributes.position,
c=r.attributes.uv,d=r.attributes.uv1,u=r.attributes.normal,h=r.groups,f=r.drawRange;if(a!==null)if(Array.isArray(o))for(let p=0,x=h.length;p<x;p++){let m=h[p],g=o[m.
materialIndex],y=Math.max(m.start,f.start),S=Math.min(a.count,Math.min(m.start+m.count,f.start+f.count));for(let b=y,C=S;b<C;b+=3){let w=a.getX(b),_=a.getX(b+1),
M=a.getX(b+2);s=cl(this,g,e,n,c,d,u,w,_,M),s&&(s.faceIndex=Math.floor(b/3),s.face.materialIndex=m.materialIndex,t.push(s))}}else{let p=Math.max(0,f.start),x=Math.
min(a.count,f.start+f.count);for(let m=p,g=x;m<g;m+=3){let y=a.getX(m),S=a.getX(m+1),b=a.getX(m+2);s=cl(this,o,e,n,c,d,u,y,S,b),s&&(s.faceIndex=Math.floor(m/3),
t.push(s))}}else if(l!==void 0)if(Array.isArray(o))for(let p=0,x=h.length;p<x;p++){let m=h[p],g=o[m.materialIndex],y=Math.max(m.start,f.start),S=Math.min(l.count,
Math.min(m.start+m.count,f.start+f.count));for(let b=y,C=S;b<C;b+=3){let w=b,_=b+1,M=b+2;s=cl(this,g,e,n,c,d,u,w,_,M),s&&(s.faceIndex=Math.floor(b/3),s.face.materialIndex=
m.materialIndex,t.push(s))}}else{let p=Math.max(0,f.start),x=Math.min(l.count,f.start+f.count);for(let m=p,g=x;m<g;m+=3){let y=m,S=m+1,b=m+2;s=cl(this,o,e,n,c,d,
u,y,S,b),s&&(s.faceIndex=Math.floor(m/3),t.push(s))}}}};function Py(i,e,t,n,s,r,o,a){let l;if(e.side===zn?l=n.intersectTriangle(o,r,s,!0,a):l=n.intersectTriangle(
s,r,o,e.side===ks,a),l===null)return null;ll.copy(a),ll.applyMatrix4(i.matrixWorld);let c=t.ray.origin.distanceTo(ll);return c<t.near||c>t.far?null:{distance:c,
point:ll.clone(),object:i}}function cl(i,e,t,n,s,r,o,a,l,c){i.getVertexPosition(a,sl),i.getVertexPosition(l,rl),i.getVertexPosition(c,ol);let d=Py(i,e,t,n,sl,rl,
ol,rm);if(d){let u=new V;Oi.getBarycoord(rm,sl,rl,ol,u),s&&(d.uv=Oi.getInterpolatedAttribute(s,a,l,c,u,new st)),r&&(d.uv1=Oi.getInterpolatedAttribute(r,a,l,c,u,
new st)),o&&(d.normal=Oi.getInterpolatedAttribute(o,a,l,c,u,new V),d.normal.dot(n.direction)>0&&d.normal.multiplyScalar(-1));let h={a,b:l,c,normal:new V,materialIndex:0};
Oi.getNormal(sl,rl,ol,h.normal),d.face=h,d.barycoord=u}return d}var Zo=class extends Hn{constructor(e=null,t=1,n=1,s,r,o,a,l,c=Mn,d=Mn,u,h){super(null,o,a,l,c,d,s,r,u,h),this.isDataTexture=!0,this.image={data:e,width:t,height:n},
this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}};var Jo=class extends Mi{constructor(e,t,n,s=1){super(e,t,n),this.isInstancedBufferAttribute=!0,this.meshPerAttribute=s}copy(e){return super.copy(e),this.meshPerAttribute=
e.meshPerAttribute,this}toJSON(){let e=super.toJSON();return e.meshPerAttribute=this.meshPerAttribute,e.isInstancedBufferAttribute=!0,e}},Hr=new xt,om=new xt,hl=[],
am=new zi,Iy=new xt,Oo=new ui,Bo=new ls,Is=class extends ui{constructor(e,t,n){super(e,t),this.isInstancedMesh=!0,this.instanceMatrix=new Jo(new Float32Array(n*
16),16),this.instanceColor=null,this.morphTexture=null,this.count=n,this.boundingBox=null,this.boundingSphere=null;for(let s=0;s<n;s++)this.setMatrixAt(s,Iy)}computeBoundingBox(){
let e=this.geometry,t=this.count;this.boundingBox===null&&(this.boundingBox=new zi),e.boundingBox===null&&e.computeBoundingBox(),this.boundingBox.makeEmpty();for(let n=0;n<
t;n++)this.getMatrixAt(n,Hr),am.copy(e.boundingBox).applyMatrix4(Hr),this.boundingBox.union(am)}computeBoundingSphere(){let e=this.geometry,t=this.count;this.boundingSphere===
null&&(this.boundingSphere=new ls),e.boundingSphere===null&&e.computeBoundingSphere(),this.boundingSphere.makeEmpty();for(let n=0;n<t;n++)this.getMatrixAt(n,Hr),
Bo.copy(e.boundingSphere).applyMatrix4(Hr),this.boundingSphere.union(Bo)}copy(e,t){return super.copy(e,t),this.instanceMatrix.copy(e.instanceMatrix),this.morphTexture=
e.morphTexture!==null?e.morphTexture.clone():null,this.instanceColor=e.instanceColor!==null?e.instanceColor.clone():null,this.count=e.count,this.boundingBox=e.boundingBox!==
null?e.boundingBox.clone():null,this.boundingSphere=e.boundingSphere!==null?e.boundingSphere.clone():null,this}getColorAt(e,t){return this.instanceColor===null?
t.setRGB(1,1,1):t.fromArray(this.instanceColor.array,e*3)}getMatrixAt(e,t){return t.fromArray(this.instanceMatrix.array,e*16)}getMorphAt(e,t){let n=t.morphTargetInfluences,
s=this.morphTexture.source.data.data,r=n.length+1,o=e*r+1;for(let a=0;a<n.length;a++)n[a]=s[o+a]}raycast(e,t){let n=this.matrixWorld,s=this.count;if(Oo.geometry=
this.geometry,Oo.material=this.material,Oo.material!==void 0&&(this.boundingSphere===null&&this.computeBoundingSphere(),Bo.copy(this.boundingSphere),Bo.applyMatrix4(
n),e.ray.intersectsSphere(Bo)!==!1))for(let r=0;r<s;r++){this.getMatrixAt(r,Hr),om.multiplyMatrices(n,Hr),Oo.matrixWorld=om,Oo.raycast(e,hl);for(let o=0,a=hl.length;o<
a;o++){let l=hl[o];l.instanceId=r,l.object=this,t.push(l)}hl.length=0}}setColorAt(e,t){return this.instanceColor===null&&(this.instanceColor=new Jo(new Float32Array(
this.instanceMatrix.count*3).fill(1),3)),t.toArray(this.instanceColor.array,e*3),this}setMatrixAt(e,t){return t.toArray(this.instanceMatrix.array,e*16),this}setMorphAt(e,t){
let n=t.morphTargetInfluences,s=n.length+1;this.morphTexture===null&&(this.morphTexture=new Zo(new Float32Array(s*this.count),s,this.count,ac,di));let r=this.morphTexture.
source.data.data,o=0;for(let c=0;c<n.length;c++)o+=n[c];let a=this.geometry.morphTargetsRelative?1:1-o,l=s*e;return r[l]=a,r.set(n,l+1),this}updateMorphTargets(){}dispose(){
super.dispose(),this.instanceMatrix.dispose(),this.instanceColor!==null&&this.instanceColor.dispose(),this.morphTexture!==null&&(this.morphTexture.dispose(),this.
morphTexture=null)}},sr=new ls,Ly=new st(.5,.5),ul=new V,Ls=class{constructor(e=new ti,t=new ti,n=new ti,s=new ti,r=new ti,o=new ti){this.planes=[e,t,n,s,r,o]}set(e,t,n,s,r,o){
let a=this.planes;return a[0].copy(e),a[1].copy(t),a[2].copy(n),a[3].copy(s),a[4].copy(r),a[5].copy(o),this}copy(e){let t=this.planes;for(let n=0;n<6;n++)t[n].copy(
e.planes[n]);return this}setFromProjectionMatrix(e,t=hi,n=!1){let s=this.planes,r=e.elements,o=r[0],a=r[1],l=r[2],c=r[3],d=r[4],u=r[5],h=r[6],f=r[7],p=r[8],x=r[9],
m=r[10],g=r[11],y=r[12],S=r[13],b=r[14],C=r[15];if(s[0].setComponents(c-o,f-d,g-p,C-y).normalize(),s[1].setComponents(c+o,f+d,g+p,C+y).normalize(),s[2].setComponents(
c+a,f+u,g+x,C+S).normalize(),s[3].setComponents(c-a,f-u,g-x,C-S).normalize(),n)s[4].setComponents(l,h,m,b).normalize(),s[5].setComponents(c-l,f-h,g-m,C-b).normalize();else if(s[4].
setComponents(c-l,f-h,g-m,C-b).normalize(),t===hi)s[5].setComponents(c+l,f+h,g+m,C+b).normalize();else if(t===Kr)s[5].setComponents(l,h,m,b).normalize();else throw new Error(
"THREE.Frustum.setFromProjectionMatrix(): Invalid coordinate system: "+t);return this}intersectsObject(e){if(e.boundingSphere!==void 0)e.boundingSphere===null&&
e.computeBoundingSphere(),sr.copy(e.boundingSphere).applyMatrix4(e.matrixWorld);else{let t=e.geometry;t.boundingSphere===null&&t.computeBoundingSphere(),sr.copy(
t.boundingSphere).applyMatrix4(e.matrixWorld)}return this.intersectsSphere(sr)}intersectsSprite(e){sr.center.set(0,0,0);let t=Ly.distanceTo(e.center);return sr.
radius=.7071067811865476+t,sr.applyMatrix4(e.matrixWorld),this.intersectsSphere(sr)}intersectsSphere(e){let t=this.planes,n=e.center,s=-e.radius;for(let r=0;r<6;r++)
if(t[r].distanceToPoint(n)<s)return!1;return!0}intersectsBox(e){let t=this.planes;for(let n=0;n<6;n++){let s=t[n];if(ul.x=s.normal.x>0?e.max.x:e.min.x,ul.y=s.normal.
y>0?e.max.y:e.min.y,ul.z=s.normal.z>0?e.max.z:e.min.z,s.distanceToPoint(ul)<0)return!1}return!0}containsPoint(e){let t=this.planes;for(let n=0;n<6;n++)if(t[n].distanceToPoint(
e)<0)return!1;return!0}clone(){return new this.constructor().copy(this)}},lm=new xt,Dl=class i{constructor(){this.coordinateSystem=hi,this._frustums=[],this._count=
0}setFromArrayCamera(e){let t=e.cameras,n=this._frustums;for(let s=0;s<t.length;s++){let r=t[s];lm.multiplyMatrices(r.projectionMatrix,r.matrixWorldInverse),n[s]===
void 0&&(n[s]=new Ls),n[s].setFromProjectionMatrix(lm,r.coordinateSystem,r.reversedDepth)}return this._count=t.length,this}getFrustum(e){return this._frustums[e]}intersectsObject(e){
let t=this._frustums;for(let n=0;n<this._count;n++)if(t[n].intersectsObject(e))return!0;return!1}intersectsSprite(e){let t=this._frustums;for(let n=0;n<this._count;n++)
if(t[n].intersectsSprite(e))return!0;return!1}intersectsSphere(e){let t=this._frustums;for(let n=0;n<this._count;n++)if(t[n].intersectsSphere(e))return!0;return!1}intersectsBox(e){
let t=this._frustums;for(let n=0;n<this._count;n++)if(t[n].intersectsBox(e))return!0;return!1}containsPoint(e){let t=this._frustums;for(let n=0;n<this._count;n++)
if(t[n].containsPoint(e))return!0;return!1}copy(e){this.coordinateSystem=e.coordinateSystem;let t=this._frustums,n=e._frustums;for(let s=0;s<e._count;s++)t[s]===
void 0&&(t[s]=new Ls),t[s].copy(n[s]);return this._count=e._count,this}clone(){return new i().copy(this)}};var Ns=class extends cs{constructor(e){super(),this.isLineBasicMaterial=!0,this.type="LineBasicMaterial",this.color=new rt(16777215),this.map=null,this.linewidth=
1,this.linecap="round",this.linejoin="round",this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.linewidth=e.
linewidth,this.linecap=e.linecap,this.linejoin=e.linejoin,this.fog=e.fog,this}},Ul=new V,Fl=new V,cm=new xt,ko=new no,dl=new ls,bu=new V,hm=new V,Ol=class extends wn{constructor(e=new ln,t=new Ns){
super(),this.isLine=!0,this.type="Line",this.geometry=e,this.material=t,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.updateMorphTargets()}copy(e,t){
return super.copy(e,t),e.morphTargetInfluences!==void 0?this.morphTargetInfluences=e.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,e.morphTargetDictionary!==
void 0?this.morphTargetDictionary=Object.assign({},e.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(e.material)?e.material.
slice():e.material,this.geometry=e.geometry,this}computeLineDistances(){let e=this.geometry;if(e.index===null){let t=e.attributes.position,n=[0];for(let s=1,r=t.
count;s<r;s++)Ul.fromBufferAttribute(t,s-1),Fl.fromBufferAttribute(t,s),n[s]=n[s-1],n[s]+=Ul.distanceTo(Fl);e.setAttribute("lineDistance",new yt(n,1))}else qe("\
Line.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}intersectsFrustum(e){return e.intersectsObject(this)}raycast(e,t){
let n=this.geometry,s=this.matrixWorld,r=e.params.Line.threshold,o=n.drawRange;if(n.boundingSphere===null&&n.computeBoundingSphere(),dl.copy(n.boundingSphere),dl.
applyMatrix4(s),dl.radius+=r,e.ray.intersectsSphere(dl)===!1)return;cm.copy(s).invert(),ko.copy(e.ray).applyMatrix4(cm);let a=r/((this.scale.x+this.scale.y+this.
scale.z)/3),l=a*a,c=this.isLineSegments?2:1,d=n.index,h=n.attributes.position;if(d!==null){let f=Math.max(0,o.start),p=Math.min(d.count,o.start+o.count);for(let x=f,
m=p-1;x<m;x+=c){let g=d.getX(x),y=d.getX(x+1),S=fl(this,e,ko,l,g,y,x);S&&t.push(S)}if(this.isLineLoop){let x=d.getX(p-1),m=d.getX(f),g=fl(this,e,ko,l,x,m,p-1);g&&
t.push(g)}}else{let f=Math.max(0,o.start),p=Math.min(h.count,o.start+o.count);for(let x=f,m=p-1;x<m;x+=c){let g=fl(this,e,ko,l,x,x+1,x);g&&t.push(g)}if(this.isLineLoop){
let x=fl(this,e,ko,l,p-1,f,p-1);x&&t.push(x)}}}updateMorphTargets(){let t=this.geometry.morphAttributes,n=Object.keys(t);if(n.length>0){let s=t[n[0]];if(s!==void 0){
this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=
r}}}}};function fl(i,e,t,n,s,r,o){let a=i.geometry.attributes.position;if(Ul.fromBufferAttribute(a,s),Fl.fromBufferAttribute(a,r),t.distanceSqToSegment(Ul,Fl,bu,
hm)>n)return;bu.applyMatrix4(i.matrixWorld);let c=e.ray.origin.distanceTo(bu);if(!(c<e.near||c>e.far))return{distance:c,point:hm.clone().applyMatrix4(i.matrixWorld),
index:o,face:null,faceIndex:null,barycoord:null,object:i}}var um=new V,dm=new V,io=class extends Ol{constructor(e,t){super(e,t),this.isLineSegments=!0,this.type=
"LineSegments"}computeLineDistances(){let e=this.geometry;if(e.index===null){let t=e.attributes.position,n=[];for(let s=0,r=t.count;s<r;s+=2)um.fromBufferAttribute(
t,s),dm.fromBufferAttribute(t,s+1),n[s]=s===0?0:n[s-1],n[s+1]=n[s]+um.distanceTo(dm);e.setAttribute("lineDistance",new yt(n,1))}else qe("LineSegments.computeLin\
eDistances(): Computation only possible with non-indexed BufferGeometry.");return this}};var Ko=class extends Hn{constructor(e=[],t=ar,n,s,r,o,a,l,c,d){super(e,t,n,s,r,o,a,l,c,d),this.isCubeTexture=!0,this.flipY=!1}get images(){return this.image}set images(e){
this.image=e}};var us=class extends Hn{constructor(e,t,n=Si,s,r,o,a=Mn,l=Mn,c,d=os,u=1){if(d!==os&&d!==fs)throw new Error("THREE.DepthTexture: format must be either THREE.Dept\
hFormat or THREE.DepthStencilFormat");let h={width:e,height:t,depth:u};super(h,s,r,o,a,l,d,n,c),this.isDepthTexture=!0,this.flipY=!1,this.generateMipmaps=!1,this.
compareFunction=null}copy(e){return super.copy(e),this.source=new Qr(Object.assign({},e.image)),this.compareFunction=e.compareFunction,this}toJSON(e){let t=super.
toJSON(e);return t.compareFunction=this.compareFunction,t}},jo=class extends us{constructor(e,t=Si,n=ar,s,r,o=Mn,a=Mn,l,c=os){let d={width:e,height:e,depth:1},u=[
d,d,d,d,d,d];super(e,e,t,n,s,r,o,a,l,c),this.image=u,this.isCubeDepthTexture=!0,this.isCubeTexture=!0}get images(){return this.image}set images(e){this.image=e}},
Qo=class extends Hn{constructor(e=null){super(),this.sourceTexture=e,this.isExternalTexture=!0}copy(e){return super.copy(e),this.sourceTexture=e.sourceTexture,this}},
Ds=class i extends ln{constructor(e=1,t=1,n=1,s=1,r=1,o=1){super(),this.type="BoxGeometry",this.parameters={width:e,height:t,depth:n,widthSegments:s,heightSegments:r,
depthSegments:o};let a=this;s=Math.floor(s),r=Math.floor(r),o=Math.floor(o);let l=[],c=[],d=[],u=[],h=0,f=0;p("z","y","x",-1,-1,n,t,e,o,r,0),p("z","y","x",1,-1,
n,t,-e,o,r,1),p("x","z","y",1,1,e,n,t,s,o,2),p("x","z","y",1,-1,e,n,-t,s,o,3),p("x","y","z",1,-1,e,t,n,s,r,4),p("x","y","z",-1,-1,e,t,-n,s,r,5),this.setIndex(l),
this.setAttribute("position",new yt(c,3)),this.setAttribute("normal",new yt(d,3)),this.setAttribute("uv",new yt(u,2));function p(x,m,g,y,S,b,C,w,_,M,R){let P=b/
_,I=C/M,F=b/2,z=C/2,D=w/2,G=_+1,Y=M+1,W=0,ce=0,K=new V;for(let Q=0;Q<Y;Q++){let se=Q*I-z;for(let de=0;de<G;de++){let ue=de*P-F;K[x]=ue*y,K[m]=se*S,K[g]=D,c.push(
K.x,K.y,K.z),K[x]=0,K[m]=0,K[g]=w>0?1:-1,d.push(K.x,K.y,K.z),u.push(de/_),u.push(1-Q/M),W+=1}}for(let Q=0;Q<M;Q++)for(let se=0;se<_;se++){let de=h+se+G*Q,ue=h+se+
G*(Q+1),ee=h+(se+1)+G*(Q+1),me=h+(se+1)+G*Q;l.push(de,ue,me),l.push(ue,ee,me),ce+=6}a.addGroup(f,ce,R),f+=ce,h+=W}}copy(e){return super.copy(e),this.parameters=
Object.assign({},e.parameters),this}static fromJSON(e){return new i(e.width,e.height,e.depth,e.widthSegments,e.heightSegments,e.depthSegments)}},ea=class i extends ln{constructor(e=1,t=1,n=4,s=8,r=1){
super(),this.type="CapsuleGeometry",this.parameters={radius:e,height:t,capSegments:n,radialSegments:s,heightSegments:r},t=Math.max(0,t),n=Math.max(1,Math.floor(
n)),s=Math.max(3,Math.floor(s)),r=Math.max(1,Math.floor(r));let o=[],a=[],l=[],c=[],d=t/2,u=Math.PI/2*e,h=t,f=2*u+h,p=n*2+r,x=s+1,m=new V,g=new V;for(let y=0;y<=
p;y++){let S=0,b=0,C=0,w=0;if(y<=n){let R=y/n,P=R*Math.PI/2;b=-d-e*Math.cos(P),C=e*Math.sin(P),w=-e*Math.cos(P),S=R*u}else if(y<=n+r){let R=(y-n)/r;b=-d+R*t,C=e,
w=0,S=u+R*h}else{let R=(y-n-r)/n,P=R*Math.PI/2;b=d+e*Math.sin(P),C=e*Math.cos(P),w=e*Math.sin(P),S=u+h+R*u}let _=Math.max(0,Math.min(1,S/f)),M=0;y===0?M=.5/s:y===
p&&(M=-.5/s);for(let R=0;R<=s;R++){let P=R/s,I=P*Math.PI*2,F=Math.sin(I),z=Math.cos(I);g.x=-C*z,g.y=b,g.z=C*F,a.push(g.x,g.y,g.z),m.set(-C*z,w,C*F),m.normalize(),
l.push(m.x,m.y,m.z),c.push(P+M,_)}if(y>0){let R=(y-1)*x;for(let P=0;P<s;P++){let I=R+P,F=R+P+1,z=y*x+P,D=y*x+P+1;o.push(I,F,z),o.push(F,D,z)}}}this.setIndex(o),
this.setAttribute("position",new yt(a,3)),this.setAttribute("normal",new yt(l,3)),this.setAttribute("uv",new yt(c,2))}copy(e){return super.copy(e),this.parameters=
Object.assign({},e.parameters),this}static fromJSON(e){return new i(e.radius,e.height,e.capSegments,e.radialSegments,e.heightSegments)}};var Us=class i extends ln{constructor(e=1,t=1,n=1,s=32,r=1,o=!1,a=0,l=Math.PI*2){super(),this.type="CylinderGeometry",this.parameters={radiusTop:e,radiusBottom:t,
height:n,radialSegments:s,heightSegments:r,openEnded:o,thetaStart:a,thetaLength:l};let c=this;s=Math.floor(s),r=Math.floor(r);let d=[],u=[],h=[],f=[],p=0,x=[],m=n/
2,g=0;y(),o===!1&&(e>0&&S(!0),t>0&&S(!1)),this.setIndex(d),this.setAttribute("position",new yt(u,3)),this.setAttribute("normal",new yt(h,3)),this.setAttribute("\
uv",new yt(f,2));function y(){let b=new V,C=new V,w=0,_=(t-e)/n;for(let M=0;M<=r;M++){let R=[],P=M/r,I=P*(t-e)+e;for(let F=0;F<=s;F++){let z=F/s,D=z*l+a,G=Math.
sin(D),Y=Math.cos(D);C.x=I*G,C.y=-P*n+m,C.z=I*Y,u.push(C.x,C.y,C.z),b.set(G,_,Y).normalize(),h.push(b.x,b.y,b.z),f.push(z,1-P),R.push(p++)}x.push(R)}for(let M=0;M<
s;M++)for(let R=0;R<r;R++){let P=x[R][M],I=x[R+1][M],F=x[R+1][M+1],z=x[R][M+1];(e>0||R!==0)&&(d.push(P,I,z),w+=3),(t>0||R!==r-1)&&(d.push(I,F,z),w+=3)}c.addGroup(
g,w,0),g+=w}function S(b){let C=p,w=new st,_=new V,M=0,R=b===!0?e:t,P=b===!0?1:-1;for(let F=1;F<=s;F++)u.push(0,m*P,0),h.push(0,P,0),f.push(.5,.5),p++;let I=p;for(let F=0;F<=
s;F++){let D=F/s*l+a,G=Math.cos(D),Y=Math.sin(D);_.x=R*Y,_.y=m*P,_.z=R*G,u.push(_.x,_.y,_.z),h.push(0,P,0),w.x=G*.5+.5,w.y=Y*.5*P+.5,f.push(w.x,w.y),p++}for(let F=0;F<
s;F++){let z=C+F,D=I+F;b===!0?d.push(D,D+1,z):d.push(D+1,D,z),M+=3}c.addGroup(g,M,b===!0?1:2),g+=M}}copy(e){return super.copy(e),this.parameters=Object.assign({},
e.parameters),this}static fromJSON(e){return new i(e.radiusTop,e.radiusBottom,e.height,e.radialSegments,e.heightSegments,e.openEnded,e.thetaStart,e.thetaLength)}},
ta=class i extends Us{constructor(e=1,t=1,n=32,s=1,r=!1,o=0,a=Math.PI*2){super(0,e,t,n,s,r,o,a),this.type="ConeGeometry",this.parameters={radius:e,height:t,radialSegments:n,
heightSegments:s,openEnded:r,thetaStart:o,thetaLength:a}}static fromJSON(e){return new i(e.radius,e.height,e.radialSegments,e.heightSegments,e.openEnded,e.thetaStart,
e.thetaLength)}},Bl=class i extends ln{constructor(e=[],t=[],n=1,s=0){super(),this.type="PolyhedronGeometry",this.parameters={vertices:e,indices:t,radius:n,detail:s};
let r=[],o=[];a(s),c(n),d(),this.setAttribute("position",new yt(r,3)),this.setAttribute("normal",new yt(r.slice(),3)),this.setAttribute("uv",new yt(o,2)),s===0?
this.computeVertexNormals():this.normalizeNormals();function a(y){let S=new V,b=new V,C=new V;for(let w=0;w<t.length;w+=3)f(t[w+0],S),f(t[w+1],b),f(t[w+2],C),l(
S,b,C,y)}function l(y,S,b,C){let w=C+1,_=[];for(let M=0;M<=w;M++){_[M]=[];let R=y.clone().lerp(b,M/w),P=S.clone().lerp(b,M/w),I=w-M;for(let F=0;F<=I;F++)F===0&&
M===w?_[M][F]=R:_[M][F]=R.clone().lerp(P,F/I)}for(let M=0;M<w;M++)for(let R=0;R<2*(w-M)-1;R++){let P=Math.floor(R/2);R%2===0?(h(_[M][P+1]),h(_[M+1][P]),h(_[M][P])):
(h(_[M][P+1]),h(_[M+1][P+1]),h(_[M+1][P]))}}function c(y){let S=new V;for(let b=0;b<r.length;b+=3)S.x=r[b+0],S.y=r[b+1],S.z=r[b+2],S.normalize().multiplyScalar(
y),r[b+0]=S.x,r[b+1]=S.y,r[b+2]=S.z}function d(){let y=new V;for(let S=0;S<r.length;S+=3){y.x=r[S+0],y.y=r[S+1],y.z=r[S+2];let b=m(y)/2/Math.PI+.5,C=g(y)/Math.PI+
.5;o.push(b,1-C)}p(),u()}function u(){for(let y=0;y<o.length;y+=6){let S=o[y+0],b=o[y+2],C=o[y+4],w=Math.max(S,b,C),_=Math.min(S,b,C);w>.9&&_<.1&&(S<.2&&(o[y+0]+=
1),b<.2&&(o[y+2]+=1),C<.2&&(o[y+4]+=1))}}function h(y){r.push(y.x,y.y,y.z)}function f(y,S){let b=y*3;S.x=e[b+0],S.y=e[b+1],S.z=e[b+2]}function p(){let y=new V,S=new V,
b=new V,C=new V,w=new st,_=new st,M=new st;for(let R=0,P=0;R<r.length;R+=9,P+=6){y.set(r[R+0],r[R+1],r[R+2]),S.set(r[R+3],r[R+4],r[R+5]),b.set(r[R+6],r[R+7],r[R+
8]),w.set(o[P+0],o[P+1]),_.set(o[P+2],o[P+3]),M.set(o[P+4],o[P+5]),C.copy(y).add(S).add(b).divideScalar(3);let I=m(C);x(w,P+0,y,I),x(_,P+2,S,I),x(M,P+4,b,I)}}function x(y,S,b,C){
C<0&&y.x===1&&(o[S]=y.x-1),b.x===0&&b.z===0&&(o[S]=C/2/Math.PI+.5)}function m(y){return Math.atan2(y.z,-y.x)}function g(y){return Math.atan2(-y.y,Math.sqrt(y.x*
y.x+y.z*y.z))}}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new i(e.vertices,e.indices,e.radius,e.
detail)}};var so=class i extends Bl{constructor(e=1,t=0){let n=[1,0,0,-1,0,0,0,1,0,0,-1,0,0,0,1,0,0,-1],s=[0,2,4,0,4,3,0,3,5,0,5,2,1,2,5,1,5,3,1,3,4,1,4,2];super(n,s,e,t),
this.type="OctahedronGeometry",this.parameters={radius:e,detail:t}}static fromJSON(e){return new i(e.radius,e.detail)}},na=class i extends ln{constructor(e=1,t=1,n=1,s=1){
super(),this.type="PlaneGeometry",this.parameters={width:e,height:t,widthSegments:n,heightSegments:s};let r=e/2,o=t/2,a=Math.floor(n),l=Math.floor(s),c=a+1,d=l+
1,u=e/a,h=t/l,f=[],p=[],x=[],m=[];for(let g=0;g<d;g++){let y=g*h-o;for(let S=0;S<c;S++){let b=S*u-r;p.push(b,-y,0),x.push(0,0,1),m.push(S/a),m.push(1-g/l)}}for(let g=0;g<
l;g++)for(let y=0;y<a;y++){let S=y+c*g,b=y+c*(g+1),C=y+1+c*(g+1),w=y+1+c*g;f.push(S,b,w),f.push(b,C,w)}this.setIndex(f),this.setAttribute("position",new yt(p,3)),
this.setAttribute("normal",new yt(x,3)),this.setAttribute("uv",new yt(m,2))}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){
return new i(e.width,e.height,e.widthSegments,e.heightSegments)}};var ia=class i extends ln{constructor(e=1,t=32,n=16,s=0,r=Math.PI*2,o=0,a=Math.PI){super(),this.type="SphereGeometry",this.parameters={radius:e,widthSegments:t,
heightSegments:n,phiStart:s,phiLength:r,thetaStart:o,thetaLength:a},t=Math.max(3,Math.floor(t)),n=Math.max(2,Math.floor(n));let l=Math.min(o+a,Math.PI),c=0,d=[],
u=new V,h=new V,f=[],p=[],x=[],m=[];for(let g=0;g<=n;g++){let y=[],S=g/n,b=o+S*a,C=e*Math.cos(b),w=Math.sqrt(e*e-C*C),_=0;g===0&&o===0?_=.5/t:g===n&&l===Math.PI&&
(_=-.5/t);for(let M=0;M<=t;M++){let R=M/t,P=s+R*r;u.x=-w*Math.cos(P),u.y=C,u.z=w*Math.sin(P),p.push(u.x,u.y,u.z),h.copy(u).normalize(),x.push(h.x,h.y,h.z),m.push(
R+_,1-S),y.push(c++)}d.push(y)}for(let g=0;g<n;g++)for(let y=0;y<t;y++){let S=d[g][y+1],b=d[g][y],C=d[g+1][y],w=d[g+1][y+1];(g!==0||o>0)&&f.push(S,b,w),(g!==n-1||
l<Math.PI)&&f.push(b,C,w)}this.setIndex(f),this.setAttribute("position",new yt(p,3)),this.setAttribute("normal",new yt(x,3)),this.setAttribute("uv",new yt(m,2))}copy(e){
return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new i(e.radius,e.widthSegments,e.heightSegments,e.phiStart,e.
phiLength,e.thetaStart,e.thetaLength)}};function cr(i){let e={};for(let t in i){e[t]={};for(let n in i[t]){let s=i[t][n];if(fm(s))s.isRenderTargetTexture?(qe("UniformsUtils: Textures of render targets\
 cannot be cloned via cloneUniforms() or mergeUniforms()."),e[t][n]=null):e[t][n]=s.clone();else if(Array.isArray(s))if(fm(s[0])){let r=[];for(let o=0,a=s.length;o<
a;o++)r[o]=s[o].clone();e[t][n]=r}else e[t][n]=s.slice();else e[t][n]=s}}return e}function Rn(i){let e={};for(let t=0;t<i.length;t++){let n=cr(i[t]);for(let s in n)
e[s]=n[s]}return e}function fm(i){return i&&(i.isColor||i.isMatrix3||i.isMatrix4||i.isVector2||i.isVector3||i.isVector4||i.isTexture||i.isQuaternion)}function Ny(i){
let e=[];for(let t=0;t<i.length;t++)e.push(i[t].clone());return e}function sd(i){let e=i.getRenderTarget();return e===null?i.outputColorSpace:e.isXRRenderTarget===
!0?e.texture.colorSpace:_t.workingColorSpace}var lg={clone:cr,merge:Rn},Dy="void main() {\n gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.\
0 );\n}",Uy="void main() {\n gl_FragColor = vec4( 1.0, 0.0, 0.0, 1.0 );\n}",Vi=class extends cs{constructor(e){super(),this.isShaderMaterial=!0,this.type="Shade\
rMaterial",this.defines={},this.uniforms={},this.uniformsGroups=[],this.vertexShader=Dy,this.fragmentShader=Uy,this.linewidth=1,this.wireframe=!1,this.wireframeLinewidth=
1,this.fog=!1,this.lights=!1,this.clipping=!1,this.forceSinglePass=!0,this.extensions={clipCullDistance:!1,multiDraw:!1},this.defaultAttributeValues={color:[1,1,
1],uv:[0,0],uv1:[0,0]},this.index0AttributeName=void 0,this.uniformsNeedUpdate=!1,this.glslVersion=null,e!==void 0&&this.setValues(e)}copy(e){return super.copy(
e),this.fragmentShader=e.fragmentShader,this.vertexShader=e.vertexShader,this.uniforms=cr(e.uniforms),this.uniformsGroups=Ny(e.uniformsGroups),this.defines=Object.
assign({},e.defines),this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.fog=e.fog,this.lights=e.lights,this.clipping=e.clipping,this.extensions=
Object.assign({},e.extensions),this.glslVersion=e.glslVersion,this.defaultAttributeValues=Object.assign({},e.defaultAttributeValues),this.index0AttributeName=e.
index0AttributeName,this.uniformsNeedUpdate=e.uniformsNeedUpdate,this}toJSON(e){let t=super.toJSON(e);t.glslVersion=this.glslVersion,t.uniforms={};for(let s in this.
uniforms){let o=this.uniforms[s].value;o&&o.isTexture?t.uniforms[s]={type:"t",value:o.toJSON(e).uuid}:o&&o.isColor?t.uniforms[s]={type:"c",value:o.getHex()}:o&&
o.isVector2?t.uniforms[s]={type:"v2",value:o.toArray()}:o&&o.isVector3?t.uniforms[s]={type:"v3",value:o.toArray()}:o&&o.isVector4?t.uniforms[s]={type:"v4",value:o.
toArray()}:o&&o.isMatrix3?t.uniforms[s]={type:"m3",value:o.toArray()}:o&&o.isMatrix4?t.uniforms[s]={type:"m4",value:o.toArray()}:t.uniforms[s]={value:o}}Object.
keys(this.defines).length>0&&(t.defines=this.defines),t.vertexShader=this.vertexShader,t.fragmentShader=this.fragmentShader,t.lights=this.lights,t.clipping=this.
clipping;let n={};for(let s in this.extensions)this.extensions[s]===!0&&(n[s]=!0);return Object.keys(n).length>0&&(t.extensions=n),t}fromJSON(e,t){if(super.fromJSON(
e,t),e.uniforms!==void 0)for(let n in e.uniforms){let s=e.uniforms[n];switch(this.uniforms[n]={},s.type){case"t":this.uniforms[n].value=t[s.value]||null;break;case"\
c":this.uniforms[n].value=new rt().setHex(s.value);break;case"v2":this.uniforms[n].value=new st().fromArray(s.value);break;case"v3":this.uniforms[n].value=new V().
fromArray(s.value);break;case"v4":this.uniforms[n].value=new Wt().fromArray(s.value);break;case"m3":this.uniforms[n].value=new Qe().fromArray(s.value);break;case"\
m4":this.uniforms[n].value=new xt().fromArray(s.value);break;default:this.uniforms[n].value=s.value}}if(e.defines!==void 0&&(this.defines=e.defines),e.vertexShader!==
void 0&&(this.vertexShader=e.vertexShader),e.fragmentShader!==void 0&&(this.fragmentShader=e.fragmentShader),e.glslVersion!==void 0&&(this.glslVersion=e.glslVersion),
e.extensions!==void 0)for(let n in e.extensions)this.extensions[n]=e.extensions[n];return e.lights!==void 0&&(this.lights=e.lights),e.clipping!==void 0&&(this.clipping=
e.clipping),this}},kl=class extends Vi{constructor(e){super(e),this.isRawShaderMaterial=!0,this.type="RawShaderMaterial"}};var sa=class extends cs{constructor(e){super(),this.isMeshLambertMaterial=!0,this.type="MeshLambertMaterial",this.color=new rt(16777215),this.map=null,this.lightMap=
null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.emissive=new rt(0),this.emissiveIntensity=1,this.emissiveMap=null,this.bumpMap=null,this.
bumpScale=1,this.normalMap=null,this.normalMapType=Vc,this.normalScale=new st(1,1),this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.
specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new as,this.combine=ec,this.reflectivity=1,this.envMapIntensity=1,this.refractionRatio=
.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.flatShading=!1,this.fog=!0,this.setValues(e)}copy(e){
return super.copy(e),this.color.copy(e.color),this.map=e.map,this.lightMap=e.lightMap,this.lightMapIntensity=e.lightMapIntensity,this.aoMap=e.aoMap,this.aoMapIntensity=
e.aoMapIntensity,this.emissive.copy(e.emissive),this.emissiveMap=e.emissiveMap,this.emissiveIntensity=e.emissiveIntensity,this.bumpMap=e.bumpMap,this.bumpScale=
e.bumpScale,this.normalMap=e.normalMap,this.normalMapType=e.normalMapType,this.normalScale.copy(e.normalScale),this.displacementMap=e.displacementMap,this.displacementScale=
e.displacementScale,this.displacementBias=e.displacementBias,this.specularMap=e.specularMap,this.alphaMap=e.alphaMap,this.envMap=e.envMap,this.envMapRotation.copy(
e.envMapRotation),this.combine=e.combine,this.reflectivity=e.reflectivity,this.envMapIntensity=e.envMapIntensity,this.refractionRatio=e.refractionRatio,this.wireframe=
e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.wireframeLinecap=e.wireframeLinecap,this.wireframeLinejoin=e.wireframeLinejoin,this.flatShading=e.
flatShading,this.fog=e.fog,this}},zl=class extends cs{constructor(e){super(),this.isMeshDepthMaterial=!0,this.type="MeshDepthMaterial",this.depthPacking=qm,this.
map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.wireframe=!1,this.wireframeLinewidth=1,this.setValues(
e)}copy(e){return super.copy(e),this.depthPacking=e.depthPacking,this.map=e.map,this.alphaMap=e.alphaMap,this.displacementMap=e.displacementMap,this.displacementScale=
e.displacementScale,this.displacementBias=e.displacementBias,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this}},Vl=class extends cs{constructor(e){
super(),this.isMeshDistanceMaterial=!0,this.type="MeshDistanceMaterial",this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.
displacementBias=0,this.setValues(e)}copy(e){return super.copy(e),this.map=e.map,this.alphaMap=e.alphaMap,this.displacementMap=e.displacementMap,this.displacementScale=
e.displacementScale,this.displacementBias=e.displacementBias,this}};var ra=class extends Ns{constructor(e){super(),this.isLineDashedMaterial=!0,this.type="LineDashedMaterial",this.scale=1,this.dashSize=3,this.gapSize=1,this.setValues(
e)}copy(e){return super.copy(e),this.scale=e.scale,this.dashSize=e.dashSize,this.gapSize=e.gapSize,this}};function Wr(i,e){return!i||i.constructor===e?i:typeof e.
BYTES_PER_ELEMENT=="number"?new e(i):Array.prototype.slice.call(i)}function pl(i){return i!==void 0&&i.inTangents!==void 0&&i.outTangents!==void 0}var Fs=class{constructor(e,t,n,s){this.parameterPositions=e,this._cachedIndex=0,this.resultBuffer=s!==void 0?s:new t.constructor(n),this.sampleValues=t,this.valueSize=
n,this.settings=null,this.DefaultSettings_={}}evaluate(e){let t=this.parameterPositions,n=this._cachedIndex,s=t[n],r=t[n-1];n:{e:{let o;t:{i:if(!(e<s)){for(let a=n+
2;;){if(s===void 0){if(e<r)break i;return n=t.length,this._cachedIndex=n,this.copySampleValue_(n-1)}if(n===a)break;if(r=s,s=t[++n],e<s)break e}o=t.length;break t}
if(!(e>=r)){let a=t[1];e<a&&(n=2,r=a);for(let l=n-2;;){if(r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(n===l)break;if(s=r,r=t[--n-1],e>=r)break e}
o=n,n=0;break t}break n}for(;n<o;){let a=n+o>>>1;e<t[a]?o=a:n=a+1}if(s=t[n],r=t[n-1],r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(s===void 0)
return n=t.length,this._cachedIndex=n,this.copySampleValue_(n-1)}this._cachedIndex=n,this.intervalChanged_(n,r,s)}return this.interpolate_(n,r,e,s)}getSettings_(){
return this.settings||this.DefaultSettings_}copySampleValue_(e){let t=this.resultBuffer,n=this.sampleValues,s=this.valueSize,r=e*s;for(let o=0;o!==s;++o)t[o]=n[r+
o];return t}interpolate_(){throw new Error("THREE.Interpolant: Call to abstract method.")}intervalChanged_(){}},Gl=class extends Fs{constructor(e,t,n,s){super(e,
t,n,s),this._weightPrev=-0,this._offsetPrev=-0,this._weightNext=-0,this._offsetNext=-0,this.DefaultSettings_={endingStart:Tu,endingEnd:Tu}}intervalChanged_(e,t,n){
let s=this.parameterPositions,r=e-2,o=e+1,a=s[r],l=s[o];if(a===void 0)switch(this.getSettings_().endingStart){case Au:r=e,a=2*t-n;break;case Eu:r=s.length-2,a=t+
s[r]-s[r+1];break;default:r=e,a=n}if(l===void 0)switch(this.getSettings_().endingEnd){case Au:o=e,l=2*n-t;break;case Eu:o=1,l=n+s[1]-s[0];break;default:o=e-1,l=
t}let c=(n-t)*.5,d=this.valueSize;this._weightPrev=c/(t-a),this._weightNext=c/(l-n),this._offsetPrev=r*d,this._offsetNext=o*d}interpolate_(e,t,n,s){let r=this.resultBuffer,
o=this.sampleValues,a=this.valueSize,l=e*a,c=l-a,d=this._offsetPrev,u=this._offsetNext,h=this._weightPrev,f=this._weightNext,p=(n-t)/(s-t),x=p*p,m=x*p,g=-h*m+2*
h*x-h*p,y=(1+h)*m+(-1.5-2*h)*x+(-.5+h)*p+1,S=(-1-f)*m+(1.5+f)*x+.5*p,b=f*m-f*x;for(let C=0;C!==a;++C)r[C]=g*o[d+C]+y*o[c+C]+S*o[l+C]+b*o[u+C];return r}},Hl=class extends Fs{constructor(e,t,n,s){
super(e,t,n,s)}interpolate_(e,t,n,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=e*a,c=l-a,d=(n-t)/(s-t),u=1-d;for(let h=0;h!==a;++h)r[h]=o[c+
h]*u+o[l+h]*d;return r}},Wl=class extends Fs{constructor(e,t,n,s){super(e,t,n,s)}interpolate_(e){return this.copySampleValue_(e-1)}},Xl=class extends Fs{interpolate_(e,t,n,s){
let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=e*a,c=l-a,d=this.inTangents,u=this.outTangents;if(!d||!u){let p=(n-t)/(s-t),x=1-p;for(let m=0;m!==
a;++m)r[m]=o[c+m]*x+o[l+m]*p;return r}let h=a*2,f=e-1;for(let p=0;p!==a;++p){let x=o[c+p],m=o[l+p],g=f*h+p*2,y=u[g],S=u[g+1],b=e*h+p*2,C=d[b],w=d[b+1],_=Oy(n,t,
y,C,s);r[p]=cg(_,x,S,w,m)}return r}};function cg(i,e,t,n,s){let r=1-i;return r*r*r*e+3*r*r*i*t+3*r*i*i*n+i*i*i*s}function Fy(i,e,t,n,s){let r=1-i;return 3*r*r*(t-
e)+6*r*i*(n-t)+3*i*i*(s-n)}function Oy(i,e,t,n,s){let r=(i-e)/(s-e);for(let o=0;o<8;o++){let a=cg(r,e,t,n,s)-i;if(Math.abs(a)<1e-10)break;let l=Fy(r,e,t,n,s);if(Math.
abs(l)<1e-10)break;r=Math.max(0,Math.min(1,r-a/l))}return r}var ii=class{constructor(e,t,n,s){if(e===void 0)throw new Error("THREE.KeyframeTrack: track name is \
undefined");if(t===void 0||t.length===0)throw new Error("THREE.KeyframeTrack: no keyframes in track named "+e);this.name=e,this.times=Wr(t,this.TimeBufferType),
this.values=Wr(n,this.ValueBufferType),this.setInterpolation(s||this.DefaultInterpolation)}static toJSON(e){let t=e.constructor,n;if(t.toJSON!==this.toJSON)n=t.
toJSON(e);else{n={name:e.name,times:Wr(e.times,Array),values:Wr(e.values,Array)};let s=e.getInterpolation();s!==e.DefaultInterpolation&&(n.interpolation=s),pl(e.
settings)&&(n.settings={inTangents:Wr(e.settings.inTangents,Array),outTangents:Wr(e.settings.outTangents,Array)})}return n.type=e.ValueTypeName,n}InterpolantFactoryMethodDiscrete(e){
return new Wl(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodLinear(e){return new Hl(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodSmooth(e){
return new Gl(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodBezier(e){let t=new Xl(this.times,this.values,this.getValueSize(),e);return this.
settings&&(t.inTangents=this.settings.inTangents,t.outTangents=this.settings.outTangents),t}setInterpolation(e){let t;switch(e){case Vo:t=this.InterpolantFactoryMethodDiscrete;
break;case Rl:t=this.InterpolantFactoryMethodLinear;break;case xl:t=this.InterpolantFactoryMethodSmooth;break;case wu:t=this.InterpolantFactoryMethodBezier;break}
if(t===void 0){let n="unsupported interpolation for "+this.ValueTypeName+" keyframe track named "+this.name;if(this.createInterpolant===void 0)if(e!==this.DefaultInterpolation)
this.setInterpolation(this.DefaultInterpolation);else throw new Error(n);return qe("KeyframeTrack:",n),this}return this.createInterpolant=t,this}getInterpolation(){
switch(this.createInterpolant){case this.InterpolantFactoryMethodDiscrete:return Vo;case this.InterpolantFactoryMethodLinear:return Rl;case this.InterpolantFactoryMethodSmooth:
return xl;case this.InterpolantFactoryMethodBezier:return wu}}getValueSize(){return this.values.length/this.times.length}shift(e){if(e!==0){let t=this.times;for(let n=0,
s=t.length;n!==s;++n)t[n]+=e;pl(this.settings)&&(pm(this.settings.inTangents,e),pm(this.settings.outTangents,e))}return this}scale(e){if(e!==1){let t=this.times;
for(let n=0,s=t.length;n!==s;++n)t[n]*=e;pl(this.settings)&&(mm(this.settings.inTangents,e),mm(this.settings.outTangents,e))}return this}trim(e,t){let n=this.times,
s=n.length,r=0,o=s-1;for(;r!==s&&n[r]<e;)++r;for(;o!==-1&&n[o]>t;)--o;if(++o,r!==0||o!==s){r>=o&&(o=Math.max(o,1),r=o-1);let a=this.getValueSize();this.times=n.
slice(r,o),this.values=this.values.slice(r*a,o*a)}return this}validate(){let e=!0,t=this.getValueSize();t-Math.floor(t)!==0&&(Ke("KeyframeTrack: Invalid value s\
ize in track.",this),e=!1);let n=this.times,s=this.values,r=n.length;r===0&&(Ke("KeyframeTrack: Track is empty.",this),e=!1);let o=null;for(let a=0;a!==r;a++){let l=n[a];
if(typeof l=="number"&&isNaN(l)){Ke("KeyframeTrack: Time is not a valid number.",this,a,l),e=!1;break}if(o!==null&&o>l){Ke("KeyframeTrack: Out of order keys.",this,
a,l,o),e=!1;break}o=l}if(s!==void 0&&hy(s))for(let a=0,l=s.length;a!==l;++a){let c=s[a];if(isNaN(c)){Ke("KeyframeTrack: Value is not a valid number.",this,a,c),
e=!1;break}}return e}optimize(){let e=this.times.slice(),t=this.values.slice(),n=this.getValueSize(),s=this.getInterpolation()===xl,r=e.length-1,o=1;for(let a=1;a<
r;++a){let l=!1,c=e[a],d=e[a+1];if(c!==d&&(a!==1||c!==e[0]))if(s)l=!0;else{let u=a*n,h=u-n,f=u+n;for(let p=0;p!==n;++p){let x=t[u+p];if(x!==t[h+p]||x!==t[f+p]){
l=!0;break}}}if(l){if(a!==o){e[o]=e[a];let u=a*n,h=o*n;for(let f=0;f!==n;++f)t[h+f]=t[u+f]}++o}}if(r>0){e[o]=e[r];for(let a=r*n,l=o*n,c=0;c!==n;++c)t[l+c]=t[a+c];
++o}return o!==e.length?(this.times=e.slice(0,o),this.values=t.slice(0,o*n)):(this.times=e,this.values=t),this}clone(){let e=this.times.slice(),t=this.values.slice(),
n=this.constructor,s=new n(this.name,e,t);return s.createInterpolant=this.createInterpolant,pl(this.settings)&&(s.settings={inTangents:this.settings.inTangents.
slice(),outTangents:this.settings.outTangents.slice()}),s}};function pm(i,e){for(let t=0,n=i.length;t!==n;t+=2)i[t]+=e}function mm(i,e){for(let t=0,n=i.length;t!==
n;t+=2)i[t]*=e}ii.prototype.ValueTypeName="";ii.prototype.TimeBufferType=Float32Array;ii.prototype.ValueBufferType=Float32Array;ii.prototype.DefaultInterpolation=
Rl;var Os=class extends ii{constructor(e,t,n){super(e,t,n)}};Os.prototype.ValueTypeName="bool";Os.prototype.ValueBufferType=Array;Os.prototype.DefaultInterpolation=
Vo;Os.prototype.InterpolantFactoryMethodLinear=void 0;Os.prototype.InterpolantFactoryMethodSmooth=void 0;var $l=class extends ii{constructor(e,t,n,s){super(e,t,
n,s)}};$l.prototype.ValueTypeName="color";var ql=class extends ii{constructor(e,t,n,s){super(e,t,n,s)}};ql.prototype.ValueTypeName="number";var Yl=class extends Fs{constructor(e,t,n,s){
super(e,t,n,s)}interpolate_(e,t,n,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=(n-t)/(s-t),c=e*a;for(let d=c+a;c!==d;c+=4)kn.slerpFlat(r,0,
o,c-a,o,c,l);return r}},oa=class extends ii{constructor(e,t,n,s){super(e,t,n,s)}InterpolantFactoryMethodLinear(e){return new Yl(this.times,this.values,this.getValueSize(),
e)}};oa.prototype.ValueTypeName="quaternion";oa.prototype.InterpolantFactoryMethodSmooth=void 0;var Bs=class extends ii{constructor(e,t,n){super(e,t,n)}};Bs.prototype.
ValueTypeName="string";Bs.prototype.ValueBufferType=Array;Bs.prototype.DefaultInterpolation=Vo;Bs.prototype.InterpolantFactoryMethodLinear=void 0;Bs.prototype.InterpolantFactoryMethodSmooth=
void 0;var Zl=class extends ii{constructor(e,t,n,s){super(e,t,n,s)}};Zl.prototype.ValueTypeName="vector";var Jl=class{constructor(e,t,n){let s=this,r=!1,o=0,a=0,l,c=[];this.onStart=void 0,this.onLoad=e,this.onProgress=t,this.onError=n,this._abortController=null,this.
itemStart=function(d){a++,r===!1&&s.onStart!==void 0&&s.onStart(d,o,a),r=!0},this.itemEnd=function(d){o++,s.onProgress!==void 0&&s.onProgress(d,o,a),o===a&&(r=!1,
s.onLoad!==void 0&&s.onLoad())},this.itemError=function(d){s.onError!==void 0&&s.onError(d)},this.resolveURL=function(d){return d=d.normalize("NFC"),l?l(d):d},this.
setURLModifier=function(d){return l=d,this},this.addHandler=function(d,u){return c.push(d,u),this},this.removeHandler=function(d){let u=c.indexOf(d);return u!==
-1&&c.splice(u,2),this},this.getHandler=function(d){for(let u=0,h=c.length;u<h;u+=2){let f=c[u],p=c[u+1];if(f.global&&(f.lastIndex=0),f.test(d))return p}return null},
this.abort=function(){return this.abortController.abort(),this._abortController=null,this}}get abortController(){return this._abortController||(this._abortController=
new AbortController),this._abortController}},hg=new Jl,Kl=class{constructor(e){this.manager=e!==void 0?e:hg,this.crossOrigin="anonymous",this.withCredentials=!1,
this.path="",this.resourcePath="",this.requestHeader={},this.priority="auto",this.cache="default",typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(
new CustomEvent("observe",{detail:this}))}load(){}loadAsync(e,t){let n=this;return new Promise(function(s,r){n.load(e,s,t,r)})}parse(){}setCrossOrigin(e){return this.
crossOrigin=e,this}setWithCredentials(e){return this.withCredentials=e,this}setPath(e){return this.path=e,this}setResourcePath(e){return this.resourcePath=e,this}setRequestHeader(e){
return this.requestHeader=e,this}setPriority(e){return this.priority=e,this}setCache(e){return this.cache=e,this}abort(){return this}};Kl.DEFAULT_MATERIAL_NAME=
"__DEFAULT";var aa=class extends wn{static registerNode(e){this.prototype._lightNode=e}constructor(e,t=1){super(),this.isLight=!0,this.type="Light",this.color=new rt(e),this.
intensity=t}copy(e,t){return super.copy(e,t),this.color.copy(e.color),this.intensity=e.intensity,this}toJSON(e){let t=super.toJSON(e);return t.object.color=this.
color.getHex(),t.object.intensity=this.intensity,t}},la=class extends aa{constructor(e,t,n){super(e,n),this.isHemisphereLight=!0,this.type="HemisphereLight",this.
position.copy(wn.DEFAULT_UP),this.updateMatrix(),this.groundColor=new rt(t)}copy(e,t){return super.copy(e,t),this.groundColor.copy(e.groundColor),this}toJSON(e){
let t=super.toJSON(e);return t.object.groundColor=this.groundColor.getHex(),t}},Mu=new xt,gm=new V,_m=new V,jl=class{constructor(e){this.camera=e,this.intensity=
1,this.bias=0,this.biasNode=null,this.normalBias=0,this.radius=1,this.blurSamples=8,this.mapSize=new st(512,512),this.mapType=Wn,this.map=null,this.mapPass=null,
this.matrix=new xt,this.autoUpdate=!0,this.needsUpdate=!1,this._frustum=new Ls,this._frameExtents=new st(1,1),this._viewportCount=1,this._viewports=[new Wt(0,0,
1,1)]}getViewportCount(){return this._viewportCount}getCamera(){return this.camera}getFrustum(){return this._frustum}updateMatrices(e){let t=this.camera;gm.setFromMatrixPosition(
e.matrixWorld),t.position.copy(gm),_m.setFromMatrixPosition(e.target.matrixWorld),t.lookAt(_m),t.updateMatrixWorld(),this._updateMatrix(t,this.matrix,this._frustum)}_updateMatrix(e,t,n,s){
Mu.multiplyMatrices(e.projectionMatrix,e.matrixWorldInverse),n.setFromProjectionMatrix(Mu,e.coordinateSystem,e.reversedDepth);let r=this._frameExtents,o=s?s.z/r.
x:1,a=s?s.w/r.y:1,l=s?s.x/r.x:0,c=s?s.y/r.y:0;e.coordinateSystem===Kr||e.reversedDepth?t.set(.5*o,0,0,.5*o+l,0,.5*a,0,.5*a+c,0,0,1,0,0,0,0,1):t.set(.5*o,0,0,.5*
o+l,0,.5*a,0,.5*a+c,0,0,.5,.5,0,0,0,1),t.multiply(Mu)}getViewport(e){return this._viewports[e]}getFrameExtents(){return this._frameExtents}dispose(){this.map&&this.
map.dispose(),this.mapPass&&this.mapPass.dispose()}copy(e){return this.camera=e.camera.clone(),this.intensity=e.intensity,this.bias=e.bias,this.radius=e.radius,
this.autoUpdate=e.autoUpdate,this.needsUpdate=e.needsUpdate,this.normalBias=e.normalBias,this.blurSamples=e.blurSamples,this.mapSize.copy(e.mapSize),this.mapType=
e.mapType,this.biasNode=e.biasNode,this}clone(){return new this.constructor().copy(this)}toJSON(){let e={};return e.intensity=this.intensity,e.bias=this.bias,e.
normalBias=this.normalBias,e.radius=this.radius,e.blurSamples=this.blurSamples,e.mapSize=this.mapSize.toArray(),e.mapType=this.mapType,e.camera=this.camera.toJSON(
!1).object,delete e.camera.matrix,e}},ml=new V,gl=new kn,Fi=new V,ca=class extends wn{constructor(){super(),this.isCamera=!0,this.type="Camera",this.matrixWorldInverse=
new xt,this.projectionMatrix=new xt,this.projectionMatrixInverse=new xt,this.coordinateSystem=hi,this._reversedDepth=!1}get reversedDepth(){return this._reversedDepth}copy(e,t){
return super.copy(e,t),this.matrixWorldInverse.copy(e.matrixWorldInverse),this.projectionMatrix.copy(e.projectionMatrix),this.projectionMatrixInverse.copy(e.projectionMatrixInverse),
this.coordinateSystem=e.coordinateSystem,this}getWorldDirection(e){return super.getWorldDirection(e).negate()}updateMatrixWorld(e){super.updateMatrixWorld(e),this.
matrixWorld.decompose(ml,gl,Fi),Fi.x===1&&Fi.y===1&&Fi.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(ml,gl,Fi.set(
1,1,1)).invert()}updateWorldMatrix(e,t,n=!1){super.updateWorldMatrix(e,t,n),this.matrixWorld.decompose(ml,gl,Fi),Fi.x===1&&Fi.y===1&&Fi.z===1?this.matrixWorldInverse.
copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(ml,gl,Fi.set(1,1,1)).invert()}clone(){return new this.constructor().copy(this)}},Ps=new V,xm=new st,
ym=new st,On=class extends ca{constructor(e=50,t=1,n=.1,s=2e3){super(),this.isPerspectiveCamera=!0,this.type="PerspectiveCamera",this.fov=e,this.zoom=1,this.near=
n,this.far=s,this.focus=10,this.aspect=t,this.view=null,this.filmGauge=35,this.filmOffset=0,this.updateProjectionMatrix()}copy(e,t){return super.copy(e,t),this.
fov=e.fov,this.zoom=e.zoom,this.near=e.near,this.far=e.far,this.focus=e.focus,this.aspect=e.aspect,this.view=e.view===null?null:Object.assign({},e.view),this.filmGauge=
e.filmGauge,this.filmOffset=e.filmOffset,this}setFocalLength(e){let t=.5*this.getFilmHeight()/e;this.fov=Pl*2*Math.atan(t),this.updateProjectionMatrix()}getFocalLength(){
let e=Math.tan(eu*.5*this.fov);return .5*this.getFilmHeight()/e}getEffectiveFOV(){return Pl*2*Math.atan(Math.tan(eu*.5*this.fov)/this.zoom)}getFilmWidth(){return this.
filmGauge*Math.min(this.aspect,1)}getFilmHeight(){return this.filmGauge/Math.max(this.aspect,1)}getViewBounds(e,t,n){Ps.set(-1,-1,.5).applyMatrix4(this.projectionMatrixInverse),
t.set(Ps.x,Ps.y).multiplyScalar(-e/Ps.z),Ps.set(1,1,.5).applyMatrix4(this.projectionMatrixInverse),n.set(Ps.x,Ps.y).multiplyScalar(-e/Ps.z)}getViewSize(e,t){return this.
getViewBounds(e,xm,ym),t.subVectors(ym,xm)}setViewOffset(e,t,n,s,r,o){this.aspect=e/t,this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,
offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=e,this.view.fullHeight=t,this.view.offsetX=n,this.view.offsetY=s,this.view.width=r,this.view.
height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let e=this.
near,t=e*Math.tan(eu*.5*this.fov)/this.zoom,n=2*t,s=this.aspect*n,r=-.5*s,o=this.view;if(this.view!==null&&this.view.enabled){let l=o.fullWidth,c=o.fullHeight;r+=
o.offsetX*s/l,t-=o.offsetY*n/c,s*=o.width/l,n*=o.height/c}let a=this.filmOffset;a!==0&&(r+=e*a/this.getFilmWidth()),this.projectionMatrix.makePerspective(r,r+s,
t,t-n,e,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(e){let t=super.toJSON(e);return t.
object.fov=this.fov,t.object.zoom=this.zoom,t.object.near=this.near,t.object.far=this.far,t.object.focus=this.focus,t.object.aspect=this.aspect,this.view!==null&&
(t.object.view=Object.assign({},this.view)),t.object.filmGauge=this.filmGauge,t.object.filmOffset=this.filmOffset,t}};var ha=class extends ca{constructor(e=-1,t=1,n=1,s=-1,r=.1,o=2e3){super(),this.isOrthographicCamera=!0,this.type="OrthographicCamera",this.zoom=1,this.view=null,
this.left=e,this.right=t,this.top=n,this.bottom=s,this.near=r,this.far=o,this.updateProjectionMatrix()}copy(e,t){return super.copy(e,t),this.left=e.left,this.right=
e.right,this.top=e.top,this.bottom=e.bottom,this.near=e.near,this.far=e.far,this.zoom=e.zoom,this.view=e.view===null?null:Object.assign({},e.view),this}setViewOffset(e,t,n,s,r,o){
this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=e,this.view.fullHeight=
t,this.view.offsetX=n,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=
!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let e=(this.right-this.left)/(2*this.zoom),t=(this.top-this.bottom)/(2*this.zoom),n=(this.right+this.
left)/2,s=(this.top+this.bottom)/2,r=n-e,o=n+e,a=s+t,l=s-t;if(this.view!==null&&this.view.enabled){let c=(this.right-this.left)/this.view.fullWidth/this.zoom,d=(this.
top-this.bottom)/this.view.fullHeight/this.zoom;r+=c*this.view.offsetX,o=r+c*this.view.width,a-=d*this.view.offsetY,l=a-d*this.view.height}this.projectionMatrix.
makeOrthographic(r,o,a,l,this.near,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(e){
let t=super.toJSON(e);return t.object.zoom=this.zoom,t.object.left=this.left,t.object.right=this.right,t.object.top=this.top,t.object.bottom=this.bottom,t.object.
near=this.near,t.object.far=this.far,this.view!==null&&(t.object.view=Object.assign({},this.view)),t}},Cu=class extends jl{constructor(){super(new ha(-5,5,5,-5,
.5,500)),this.isDirectionalLightShadow=!0}},ro=class extends aa{constructor(e,t){super(e,t),this.isDirectionalLight=!0,this.type="DirectionalLight",this.position.
copy(wn.DEFAULT_UP),this.updateMatrix(),this.target=new wn,this.shadow=new Cu}dispose(){super.dispose(),this.shadow.dispose()}copy(e){return super.copy(e),this.
target=e.target.clone(),this.shadow=e.shadow.clone(),this}toJSON(e){let t=super.toJSON(e);return t.object.shadow=this.shadow.toJSON(),t.object.target=this.target.
uuid,t}};var Xr=-90,$r=1,oo=class extends wn{constructor(e,t,n){super(),this.type="CubeCamera",this.renderTarget=n,this.coordinateSystem=null,this.activeMipmapLevel=0;let s=new On(
Xr,$r,e,t);s.layers=this.layers,this.add(s);let r=new On(Xr,$r,e,t);r.layers=this.layers,this.add(r);let o=new On(Xr,$r,e,t);o.layers=this.layers,this.add(o);let a=new On(
Xr,$r,e,t);a.layers=this.layers,this.add(a);let l=new On(Xr,$r,e,t);l.layers=this.layers,this.add(l);let c=new On(Xr,$r,e,t);c.layers=this.layers,this.add(c)}updateCoordinateSystem(){
let e=this.coordinateSystem,t=this.children.concat(),[n,s,r,o,a,l]=t;for(let c of t)this.remove(c);if(e===hi)n.up.set(0,1,0),n.lookAt(1,0,0),s.up.set(0,1,0),s.lookAt(
-1,0,0),r.up.set(0,0,-1),r.lookAt(0,1,0),o.up.set(0,0,1),o.lookAt(0,-1,0),a.up.set(0,1,0),a.lookAt(0,0,1),l.up.set(0,1,0),l.lookAt(0,0,-1);else if(e===Kr)n.up.set(
0,-1,0),n.lookAt(-1,0,0),s.up.set(0,-1,0),s.lookAt(1,0,0),r.up.set(0,0,1),r.lookAt(0,1,0),o.up.set(0,0,-1),o.lookAt(0,-1,0),a.up.set(0,-1,0),a.lookAt(0,0,1),l.up.
set(0,-1,0),l.lookAt(0,0,-1);else throw new Error("THREE.CubeCamera.updateCoordinateSystem(): Invalid coordinate system: "+e);for(let c of t)this.add(c),c.updateMatrixWorld()}update(e,t){
this.parent===null&&this.updateMatrixWorld();let{renderTarget:n,activeMipmapLevel:s}=this;this.coordinateSystem!==e.coordinateSystem&&(this.coordinateSystem=e.coordinateSystem,
this.updateCoordinateSystem());let[r,o,a,l,c,d]=this.children,u=e.getRenderTarget(),h=e.getActiveCubeFace(),f=e.getActiveMipmapLevel(),p=e.xr.enabled;e.xr.enabled=
!1;let x=n.texture.mipmapsAutoUpdate;n.texture.mipmapsAutoUpdate=!1;let m=!1;e.isWebGLRenderer===!0?m=e.state.buffers.depth.getReversed():m=e.reversedDepthBuffer,
e.setRenderTarget(n,0,s),m&&e.autoClear===!1&&e.clearDepth(),e.render(t,r),e.setRenderTarget(n,1,s),m&&e.autoClear===!1&&e.clearDepth(),e.render(t,o),e.setRenderTarget(
n,2,s),m&&e.autoClear===!1&&e.clearDepth(),e.render(t,a),e.setRenderTarget(n,3,s),m&&e.autoClear===!1&&e.clearDepth(),e.render(t,l),e.setRenderTarget(n,4,s),m&&
e.autoClear===!1&&e.clearDepth(),e.render(t,c),n.texture.mipmapsAutoUpdate=x,e.setRenderTarget(n,5,s),m&&e.autoClear===!1&&e.clearDepth(),e.render(t,d),e.setRenderTarget(
u,h,f),e.xr.enabled=p,n.texture.needsPMREMUpdate=!0}},Ql=class extends On{constructor(e=[]){super(),this.isArrayCamera=!0,this.isMultiViewCamera=!1,this.cameras=
e,this.perCameraFrustumCulled=!1}};var rd="\\[\\]\\.:\\/",By=new RegExp("["+rd+"]","g"),od="[^"+rd+"]",ky="[^"+rd.replace("\\.","")+"]",zy=/((?:WC+[\/:])*)/.source.replace("WC",od),Vy=/(WCOD+)?/.
source.replace("WCOD",ky),Gy=/(?:\.(WC+)(?:\[(.+)\])?)?/.source.replace("WC",od),Hy=/\.(WC+)(?:\[(.+)\])?/.source.replace("WC",od),Wy=new RegExp("^"+zy+Vy+Gy+Hy+
"$"),Xy=["material","materials","bones","map"],Ru=class{constructor(e,t,n){let s=n||Vt.parseTrackName(t);this._targetGroup=e,this._bindings=e.subscribe_(t,s)}getValue(e,t){
this.bind();let n=this._targetGroup.nCachedObjects_,s=this._bindings[n];s!==void 0&&s.getValue(e,t)}setValue(e,t){let n=this._bindings;for(let s=this._targetGroup.
nCachedObjects_,r=n.length;s!==r;++s)n[s].setValue(e,t)}bind(){let e=this._bindings;for(let t=this._targetGroup.nCachedObjects_,n=e.length;t!==n;++t)e[t].bind()}unbind(){
let e=this._bindings;for(let t=this._targetGroup.nCachedObjects_,n=e.length;t!==n;++t)e[t].unbind()}},Vt=class i{constructor(e,t,n){this.path=t,this.parsedPath=
n||i.parseTrackName(t),this.node=i.findNode(e,this.parsedPath.nodeName),this.rootNode=e,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}static create(e,t,n){
return e&&e.isAnimationObjectGroup?new i.Composite(e,t,n):new i(e,t,n)}static sanitizeNodeName(e){return e.replace(/\s/g,"_").replace(By,"")}static parseTrackName(e){
let t=Wy.exec(e);if(t===null)throw new Error("THREE.PropertyBinding: Cannot parse trackName: "+e);let n={nodeName:t[2],objectName:t[3],objectIndex:t[4],propertyName:t[5],
propertyIndex:t[6]},s=n.nodeName&&n.nodeName.lastIndexOf(".");if(s!==void 0&&s!==-1){let r=n.nodeName.substring(s+1);Xy.indexOf(r)!==-1&&(n.nodeName=n.nodeName.
substring(0,s),n.objectName=r)}if(n.propertyName===null||n.propertyName.length===0)throw new Error("THREE.PropertyBinding: can not parse propertyName from track\
Name: "+e);return n}static findNode(e,t){if(t===void 0||t===""||t==="."||t===-1||t===e.name||t===e.uuid)return e;if(e.skeleton){let n=e.skeleton.getBoneByName(t);
if(n!==void 0)return n}if(e.children){let n=function(r){for(let o=0;o<r.length;o++){let a=r[o];if(a.name===t||a.uuid===t)return a;let l=n(a.children);if(l)return l}
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
this.setValue=this._setValue_unavailable,!e){qe("PropertyBinding: No target node found for track: "+this.path+".");return}if(n){let c=t.objectIndex;switch(n){case"\
materials":if(!e.material){Ke("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!e.material.materials){Ke("PropertyB\
inding: Can not bind to material.materials as node.material does not have a materials array.",this);return}e=e.material.materials;break;case"bones":if(!e.skeleton){
Ke("PropertyBinding: Can not bind to bones as node does not have a skeleton.",this);return}e=e.skeleton.bones;for(let d=0;d<e.length;d++)if(e[d].name===c){c=d;break}
break;case"map":if("map"in e){e=e.map;break}if(!e.material){Ke("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!e.
material.map){Ke("PropertyBinding: Can not bind to material.map as node.material does not have a map.",this);return}e=e.material.map;break;default:if(e[n]===void 0){
Ke("PropertyBinding: Can not bind to objectName of node undefined.",this);return}e=e[n]}if(c!==void 0){if(e[c]===void 0){Ke("PropertyBinding: Trying to bind to \
objectIndex of objectName, but is undefined.",this,e);return}e=e[c]}}let o=e[s];if(o===void 0){let c=t.nodeName;Ke("PropertyBinding: Trying to update property f\
or track: "+c+"."+s+" but it wasn't found.",e);return}let a=this.Versioning.None;this.targetObject=e,e.isMaterial===!0?a=this.Versioning.NeedsUpdate:e.isObject3D===
!0&&(a=this.Versioning.MatrixWorldNeedsUpdate);let l=this.BindingType.Direct;if(r!==void 0){if(s==="morphTargetInfluences"){if(!e.geometry){Ke("PropertyBinding:\
 Can not bind to morphTargetInfluences because node does not have a geometry.",this);return}if(!e.geometry.morphAttributes){Ke("PropertyBinding: Can not bind to\
 morphTargetInfluences because node does not have a geometry.morphAttributes.",this);return}e.morphTargetDictionary[r]!==void 0&&(r=e.morphTargetDictionary[r])}
l=this.BindingType.ArrayElement,this.resolvedProperty=o,this.propertyIndex=r}else o.fromArray!==void 0&&o.toArray!==void 0?(l=this.BindingType.HasFromToArray,this.
resolvedProperty=o):Array.isArray(o)?(l=this.BindingType.EntireArray,this.resolvedProperty=o):this.propertyName=s;this.getValue=this.GetterByBindingType[l],this.
setValue=this.SetterByBindingTypeAndVersioning[l][a]}unbind(){this.node=null,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}};Vt.Composite=
Ru;Vt.prototype.BindingType={Direct:0,EntireArray:1,ArrayElement:2,HasFromToArray:3};Vt.prototype.Versioning={None:0,NeedsUpdate:1,MatrixWorldNeedsUpdate:2};Vt.
prototype.GetterByBindingType=[Vt.prototype._getValue_direct,Vt.prototype._getValue_array,Vt.prototype._getValue_arrayElement,Vt.prototype._getValue_toArray];Vt.
prototype.SetterByBindingTypeAndVersioning=[[Vt.prototype._setValue_direct,Vt.prototype._setValue_direct_setNeedsUpdate,Vt.prototype._setValue_direct_setMatrixWorldNeedsUpdate],
[Vt.prototype._setValue_array,Vt.prototype._setValue_array_setNeedsUpdate,Vt.prototype._setValue_array_setMatrixWorldNeedsUpdate],[Vt.prototype._setValue_arrayElement,
Vt.prototype._setValue_arrayElement_setNeedsUpdate,Vt.prototype._setValue_arrayElement_setMatrixWorldNeedsUpdate],[Vt.prototype._setValue_fromArray,Vt.prototype.
_setValue_fromArray_setNeedsUpdate,Vt.prototype._setValue_fromArray_setMatrixWorldNeedsUpdate]];var Q1=new Float32Array(1);var vm=new xt,ua=class{constructor(e,t,n=0,s=1/0){this.ray=new no(e,t),this.near=n,this.far=s,this.camera=null,this.layers=new eo,this.params={Mesh:{},Line:{threshold:1},
LOD:{},Points:{threshold:1},Sprite:{}}}set(e,t){this.ray.set(e,t)}setFromCamera(e,t){t.isPerspectiveCamera?(this.ray.origin.setFromMatrixPosition(t.matrixWorld),
this.ray.direction.set(e.x,e.y,.5).unproject(t).sub(this.ray.origin).normalize(),this.camera=t):t.isOrthographicCamera?(this.ray.origin.set(e.x,e.y,t.projectionMatrix.
elements[14]).unproject(t),this.ray.direction.set(0,0,-1).transformDirection(t.matrixWorld),this.camera=t):Ke("Raycaster: Unsupported camera type: "+t.type)}setFromXRController(e){
return vm.identity().extractRotation(e.matrixWorld),this.ray.origin.setFromMatrixPosition(e.matrixWorld),this.ray.direction.set(0,0,-1).applyMatrix4(vm),this}intersectObject(e,t=!0,n=[]){
return Pu(e,this,n,t),n.sort(bm),n}intersectObjects(e,t=!0,n=[]){for(let s=0,r=e.length;s<r;s++)Pu(e[s],this,n,t);return n.sort(bm),n}};function bm(i,e){return i.
distance-e.distance}function Pu(i,e,t,n){let s=!0;if(i.layers.test(e.layers)&&i.raycast(e,t)===!1&&(s=!1),s===!0&&n===!0){let r=i.children;for(let o=0,a=r.length;o<
a;o++)Pu(r[o],e,t,!0)}}var Iu=class{static{this.prototype.isMatrix2=!0}constructor(e,t,n,s){this.elements=[1,0,0,1],e!==void 0&&this.set(e,t,n,s)}identity(){return this.set(1,0,0,1),this}fromArray(e,t=0){
for(let n=0;n<4;n++)this.elements[n]=e[n+t];return this}set(e,t,n,s){let r=this.elements;return r[0]=e,r[2]=t,r[1]=n,r[3]=s,this}};var Mm=new V,_l=new V,qr=new V,Yr=new V,Su=new V,$y=new V,qy=new V,da=class{constructor(e=new V,t=new V){this.start=e,this.end=t}set(e,t){return this.start.copy(
e),this.end.copy(t),this}copy(e){return this.start.copy(e.start),this.end.copy(e.end),this}getCenter(e){return e.addVectors(this.start,this.end).multiplyScalar(
.5)}delta(e){return e.subVectors(this.end,this.start)}distanceSq(){return this.start.distanceToSquared(this.end)}distance(){return this.start.distanceTo(this.end)}at(e,t){
return this.delta(t).multiplyScalar(e).add(this.start)}closestPointToPointParameter(e,t){Mm.subVectors(e,this.start),_l.subVectors(this.end,this.start);let n=_l.
dot(_l);if(n===0)return 0;let r=_l.dot(Mm)/n;return t&&(r=at(r,0,1)),r}closestPointToPoint(e,t,n){let s=this.closestPointToPointParameter(e,t);return this.delta(
n).multiplyScalar(s).add(this.start)}distanceSqToLine3(e,t=$y,n=qy){let s=10000000000000001e-32,r,o,a=this.start,l=e.start,c=this.end,d=e.end;qr.subVectors(c,a),
Yr.subVectors(d,l),Su.subVectors(a,l);let u=qr.dot(qr),h=Yr.dot(Yr),f=Yr.dot(Su);if(u<=s&&h<=s)return t.copy(a),n.copy(l),t.distanceToSquared(n);if(u<=s)r=0,o=f/
h,o=at(o,0,1);else{let p=qr.dot(Su);if(h<=s)o=0,r=at(-p/u,0,1);else{let x=qr.dot(Yr),m=u*h-x*x;m!==0?r=at((x*f-p*h)/m,0,1):r=0,o=(x*r+f)/h,o<0?(o=0,r=at(-p/u,0,
1)):o>1&&(o=1,r=at((x-p)/u,0,1))}}return t.copy(a).addScaledVector(qr,r),n.copy(l).addScaledVector(Yr,o),t.distanceToSquared(n)}applyMatrix4(e){return this.start.
applyMatrix4(e),this.end.applyMatrix4(e),this}equals(e){return e.start.equals(this.start)&&e.end.equals(this.end)}clone(){return new this.constructor().copy(this)}};var fa=class extends io{constructor(e=10,t=10,n=4473924,s=8947848){n=new rt(n),s=new rt(s);let r=t/2,o=e/t,a=e/2,l=[],c=[];for(let h=0,f=0,p=-a;h<=t;h++,p+=o){l.
push(-a,0,p,a,0,p),l.push(p,0,-a,p,0,a);let x=h===r?n:s;x.toArray(c,f),f+=3,x.toArray(c,f),f+=3,x.toArray(c,f),f+=3,x.toArray(c,f),f+=3}let d=new ln;d.setAttribute(
"position",new yt(l,3)),d.setAttribute("color",new yt(c,3));let u=new Ns({vertexColors:!0,toneMapped:!1});super(d,u),this.type="GridHelper"}dispose(){super.dispose(),
this.geometry.dispose(),this.material.dispose()}};function ad(i,e,t,n){let s=Yy(n);switch(t){case Ju:return i*e;case ac:return i*e/s.components*s.byteLength;case lc:return i*e/s.components*s.byteLength;case zs:
return i*e*2/s.components*s.byteLength;case cc:return i*e*2/s.components*s.byteLength;case Ku:return i*e*3/s.components*s.byteLength;case Ti:return i*e*4/s.components*
s.byteLength;case hc:return i*e*4/s.components*s.byteLength;case ga:case _a:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*8;case xa:case ya:return Math.floor((i+
3)/4)*Math.floor((e+3)/4)*16;case dc:case pc:return Math.max(i,16)*Math.max(e,8)/4;case uc:case fc:return Math.max(i,8)*Math.max(e,8)/2;case mc:case gc:case xc:case yc:
return Math.floor((i+3)/4)*Math.floor((e+3)/4)*8;case _c:case va:case vc:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*16;case bc:return Math.floor((i+3)/4)*Math.
floor((e+3)/4)*16;case Mc:return Math.floor((i+4)/5)*Math.floor((e+3)/4)*16;case Sc:return Math.floor((i+4)/5)*Math.floor((e+4)/5)*16;case wc:return Math.floor(
(i+5)/6)*Math.floor((e+4)/5)*16;case Tc:return Math.floor((i+5)/6)*Math.floor((e+5)/6)*16;case Ac:return Math.floor((i+7)/8)*Math.floor((e+4)/5)*16;case Ec:return Math.
floor((i+7)/8)*Math.floor((e+5)/6)*16;case Cc:return Math.floor((i+7)/8)*Math.floor((e+7)/8)*16;case Rc:return Math.floor((i+9)/10)*Math.floor((e+4)/5)*16;case Pc:
return Math.floor((i+9)/10)*Math.floor((e+5)/6)*16;case Ic:return Math.floor((i+9)/10)*Math.floor((e+7)/8)*16;case Lc:return Math.floor((i+9)/10)*Math.floor((e+
9)/10)*16;case Nc:return Math.floor((i+11)/12)*Math.floor((e+9)/10)*16;case Dc:return Math.floor((i+11)/12)*Math.floor((e+11)/12)*16;case Uc:case Fc:case Oc:return Math.
ceil(i/4)*Math.ceil(e/4)*16;case Bc:case kc:return Math.ceil(i/4)*Math.ceil(e/4)*8;case ba:case zc:return Math.ceil(i/4)*Math.ceil(e/4)*16}throw new Error("Unab\
le to determine texture byte length for ".concat(t," format."))}function Yy(i){switch(i){case Wn:case $u:return{byteLength:1,components:1};case ho:case qu:case wi:
return{byteLength:2,components:1};case rc:case oc:return{byteLength:2,components:4};case Si:case sc:case di:return{byteLength:4,components:1};case Yu:case Zu:return{
byteLength:4,components:3}}throw new Error("THREE.TextureUtils: Unknown texture type ".concat(i,"."))}typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("register",{detail:{revision:"187"}}));typeof window<"u"&&(window.__THREE__?qe("\
WARNING: Multiple instances of Three.js being imported."):window.__THREE__="187");function Lg(){let i=null,e=!1,t=null,n=null;function s(r,o){n=i.requestAnimationFrame(s),t(r,o)}return{start:function(){e!==!0&&t!==null&&i!==null&&(n=i.requestAnimationFrame(
s),e=!0)},stop:function(){i!==null&&i.cancelAnimationFrame(n),e=!1},setAnimationLoop:function(r){t=r},setContext:function(r){i=r}}}function Jy(i){let e=new WeakMap;
function t(a,l){let c=a.array,d=a.usage,u=c.byteLength,h=i.createBuffer();i.bindBuffer(l,h),i.bufferData(l,c,d),a.onUploadCallback();let f;if(c instanceof Float32Array)
f=i.FLOAT;else if(typeof Float16Array<"u"&&c instanceof Float16Array)f=i.HALF_FLOAT;else if(c instanceof Uint16Array)a.isFloat16BufferAttribute?f=i.HALF_FLOAT:f=
i.UNSIGNED_SHORT;else if(c instanceof Int16Array)f=i.SHORT;else if(c instanceof Uint32Array)f=i.UNSIGNED_INT;else if(c instanceof Int32Array)f=i.INT;else if(c instanceof
Int8Array)f=i.BYTE;else if(c instanceof Uint8Array)f=i.UNSIGNED_BYTE;else if(c instanceof Uint8ClampedArray)f=i.UNSIGNED_BYTE;else throw new Error("THREE.WebGLA\
ttributes: Unsupported buffer data format: "+c);return{buffer:h,type:f,bytesPerElement:c.BYTES_PER_ELEMENT,version:a.version,size:u}}function n(a,l,c){let d=l.array,
u=l.updateRanges;if(i.bindBuffer(c,a),u.length===0)i.bufferSubData(c,0,d);else{u.sort((f,p)=>f.start-p.start);let h=0;for(let f=1;f<u.length;f++){let p=u[h],x=u[f];
x.start<=p.start+p.count+1?p.count=Math.max(p.count,x.start+x.count-p.start):(++h,u[h]=x)}u.length=h+1;for(let f=0,p=u.length;f<p;f++){let x=u[f];i.bufferSubData(
c,x.start*d.BYTES_PER_ELEMENT,d,x.start,x.count)}l.clearUpdateRanges()}l.onUploadCallback()}function s(a){return a.isInterleavedBufferAttribute&&(a=a.data),e.get(
a)}function r(a){a.isInterleavedBufferAttribute&&(a=a.data);let l=e.get(a);l&&(i.deleteBuffer(l.buffer),e.delete(a))}function o(a,l){if(a.isInterleavedBufferAttribute&&
(a=a.data),a.isGLBufferAttribute){let d=e.get(a);(!d||d.version<a.version)&&e.set(a,{buffer:a.buffer,type:a.type,bytesPerElement:a.elementSize,version:a.version});
return}let c=e.get(a);if(c===void 0)e.set(a,t(a,l));else if(c.version<a.version){if(c.size!==a.array.byteLength)throw new Error("THREE.WebGLAttributes: The size\
 of the buffer attribute's array buffer does not match the original size. Resizing buffer attributes is not supported.");n(c.buffer,a,l),c.version=a.version}}return{
get:s,remove:r,update:o}}var Ky="#ifdef USE_ALPHAHASH\n if ( diffuseColor.a < getAlphaHashThreshold( vPosition ) ) discard;\n#endif",jy="#ifdef USE_ALPHAHASH\n c\
onst float ALPHA_HASH_SCALE = 0.05;\n float hash2D( vec2 value ) {\n  return fract( 1.0e4 * sin( 17.0 * value.x + 0.1 * value.y ) * ( 0.1 + abs( sin( 13.0 * value\
.y + value.x ) ) ) );\n }\n float hash3D( vec3 value ) {\n  return hash2D( vec2( hash2D( value.xy ), value.z ) );\n }\n float getAlphaHashThreshold( vec3 position ) \
{\n  float maxDeriv = max(\n   length( dFdx( position.xyz ) ),\n   length( dFdy( position.xyz ) )\n  );\n  float pixScale = 1.0 / ( ALPHA_HASH_SCALE * maxDeriv );\n  \
vec2 pixScales = vec2(\n   exp2( floor( log2( pixScale ) ) ),\n   exp2( ceil( log2( pixScale ) ) )\n  );\n  vec2 alpha = vec2(\n   hash3D( floor( pixScales.x * posit\
ion.xyz ) ),\n   hash3D( floor( pixScales.y * position.xyz ) )\n  );\n  float lerpFactor = fract( log2( pixScale ) );\n  float x = ( 1.0 - lerpFactor ) * alpha.x + \
lerpFactor * alpha.y;\n  float a = min( lerpFactor, 1.0 - lerpFactor );\n  vec3 cases = vec3(\n   x * x / ( 2.0 * a * ( 1.0 - a ) ),\n   ( x - 0.5 * a ) / ( 1.0 - a\
 ),\n   1.0 - ( ( 1.0 - x ) * ( 1.0 - x ) / ( 2.0 * a * ( 1.0 - a ) ) )\n  );\n  float threshold = ( x < ( 1.0 - a ) )\n   ? ( ( x < a ) ? cases.x : cases.y )\n   : \
cases.z;\n  return clamp( threshold , 1.0e-6, 1.0 );\n }\n#endif",Qy="#ifdef USE_ALPHAMAP\n diffuseColor.a *= texture2D( alphaMap, vAlphaMapUv ).g;\n#endif",ev="\
#ifdef USE_ALPHAMAP\n uniform sampler2D alphaMap;\n#endif",tv="#ifdef USE_ALPHATEST\n #ifdef ALPHA_TO_COVERAGE\n diffuseColor.a = smoothstep( alphaTest, alphaTest\
 + fwidth( diffuseColor.a ), diffuseColor.a );\n if ( diffuseColor.a == 0.0 ) discard;\n #else\n if ( diffuseColor.a < alphaTest ) discard;\n #endif\n#endif",nv="\
#ifdef USE_ALPHATEST\n uniform float alphaTest;\n#endif",iv="#ifdef USE_AOMAP\n float ambientOcclusion = ( texture2D( aoMap, vAoMapUv ).r - 1.0 ) * aoMapIntensit\
y + 1.0;\n reflectedLight.indirectDiffuse *= ambientOcclusion;\n #if defined( USE_CLEARCOAT ) \n  clearcoatSpecularIndirect *= ambientOcclusion;\n #endif\n #if defin\
ed( USE_SHEEN ) \n  sheenSpecularIndirect *= ambientOcclusion;\n #endif\n #if defined( USE_ENVMAP ) && defined( STANDARD )\n  float dotNV = saturate( dot( geometryN\
ormal, geometryViewDir ) );\n  reflectedLight.indirectSpecular *= computeSpecularOcclusion( dotNV, ambientOcclusion, material.roughness );\n #endif\n#endif",sv="\
#ifdef USE_AOMAP\n uniform sampler2D aoMap;\n uniform float aoMapIntensity;\n#endif",rv="#ifdef USE_BATCHING\n #if ! defined( GL_ANGLE_multi_draw )\n #define gl_D\
rawID _gl_DrawID\n uniform int _gl_DrawID;\n #endif\n uniform highp sampler2D batchingTexture;\n uniform highp usampler2D batchingIdTexture;\n mat4 getBatchingMatrix\
( const in float i ) {\n  int size = textureSize( batchingTexture, 0 ).x;\n  int j = int( i ) * 4;\n  int x = j % size;\n  int y = j / size;\n  vec4 v1 = texelFetch(\
 batchingTexture, ivec2( x, y ), 0 );\n  vec4 v2 = texelFetch( batchingTexture, ivec2( x + 1, y ), 0 );\n  vec4 v3 = texelFetch( batchingTexture, ivec2( x + 2, y \
), 0 );\n  vec4 v4 = texelFetch( batchingTexture, ivec2( x + 3, y ), 0 );\n  return mat4( v1, v2, v3, v4 );\n }\n float getIndirectIndex( const in int i ) {\n  int s\
ize = textureSize( batchingIdTexture, 0 ).x;\n  int x = i % size;\n  int y = i / size;\n  return float( texelFetch( batchingIdTexture, ivec2( x, y ), 0 ).r );\n }\n#\
endif\n#ifdef USE_BATCHING_COLOR\n uniform sampler2D batchingColorTexture;\n vec4 getBatchingColor( const in float i ) {\n  int size = textureSize( batchingColorTex\
ture, 0 ).x;\n  int j = int( i );\n  int x = j % size;\n  int y = j / size;\n  return texelFetch( batchingColorTexture, ivec2( x, y ), 0 );\n }\n#endif",ov="#if\
def USE_BATCHING\n mat4 batchingMatrix = getBatchingMatrix( getIndirectIndex( gl_DrawID ) );\n#endif",av="vec3 transformed = vec3( position );\n#ifdef USE_ALPHAH\
ASH\n vPosition = vec3( position );\n#endif",lv="vec3 objectNormal = vec3( normal );\n#ifdef USE_TANGENT\n vec3 objectTangent = vec3( tangent.xyz );\n#endif",cv="\
float G_BlinnPhong_Implicit( ) {\n return 0.25;\n}\nfloat D_BlinnPhong( const in float shininess, const in float dotNH ) {\n return RECIPROCAL_PI * ( shininess * 0.\
5 + 1.0 ) * pow( dotNH, shininess );\n}\nvec3 BRDF_BlinnPhong( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in vec3 specularColor, c\
onst in float shininess ) {\n vec3 halfDir = normalize( lightDir + viewDir );\n float dotNH = saturate( dot( normal, halfDir ) );\n float dotVH = saturate( dot( vi\
ewDir, halfDir ) );\n vec3 F = F_Schlick( specularColor, 1.0, dotVH );\n float G = G_BlinnPhong_Implicit( );\n float D = D_BlinnPhong( shininess, dotNH );\n return \
F * ( G * D );\n} // validated",hv="#ifdef USE_IRIDESCENCE\n const mat3 XYZ_TO_REC709 = mat3(\n   3.2404542, -0.9692660,  0.0556434,\n  -1.5371385,  1.8760108, -0.\
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
( I, vec3( 0.0 ) );\n }\n#endif",uv="#ifdef USE_BUMPMAP\n uniform sampler2D bumpMap;\n uniform float bumpScale;\n vec2 dHdxy_fwd() {\n  vec2 dSTdx = dFdx( vBumpMapU\
v );\n  vec2 dSTdy = dFdy( vBumpMapUv );\n  float Hll = bumpScale * texture2D( bumpMap, vBumpMapUv ).x;\n  float dBx = bumpScale * texture2D( bumpMap, vBumpMapUv +\
 dSTdx ).x - Hll;\n  float dBy = bumpScale * texture2D( bumpMap, vBumpMapUv + dSTdy ).x - Hll;\n  return vec2( dBx, dBy );\n }\n vec3 perturbNormalArb( vec3 surf_po\
s, vec3 surf_norm, vec2 dHdxy, float faceDirection ) {\n  vec3 vSigmaX = normalize( dFdx( surf_pos.xyz ) );\n  vec3 vSigmaY = normalize( dFdy( surf_pos.xyz ) );\n \
 vec3 vN = surf_norm;\n  vec3 R1 = cross( vSigmaY, vN );\n  vec3 R2 = cross( vN, vSigmaX );\n  float fDet = dot( vSigmaX, R1 ) * faceDirection;\n  vec3 vGrad = sign\
( fDet ) * ( dHdxy.x * R1 + dHdxy.y * R2 );\n  return normalize( abs( fDet ) * surf_norm - vGrad );\n }\n#endif",dv="#if NUM_CLIPPING_PLANES > 0\n vec4 plane;\n #\
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
loop_end\n   if ( clipped ) discard;\n  #endif\n #endif\n#endif",fv="#if NUM_CLIPPING_PLANES > 0\n varying vec3 vClipPosition;\n uniform vec4 clippingPlanes[ NUM_\
CLIPPING_PLANES ];\n#endif",pv="#if NUM_CLIPPING_PLANES > 0\n varying vec3 vClipPosition;\n#endif",mv="#if NUM_CLIPPING_PLANES > 0\n vClipPosition = - mvPosition\
.xyz;\n#endif",gv="#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )\n diffuseColor *= vColor;\n#endif",_v="#if defined( USE_COLOR ) || defined( USE_COLOR_\
ALPHA )\n varying vec4 vColor;\n#endif",xv="#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_C\
OLOR )\n varying vec4 vColor;\n#endif",yv="#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_CO\
LOR )\n vColor = vec4( 1.0 );\n#endif\n#ifdef USE_COLOR_ALPHA\n vColor *= color;\n#elif defined( USE_COLOR )\n vColor.rgb *= color;\n#endif\n#ifdef USE_INSTANCING_COLOR\
\n vColor.rgb *= instanceColor.rgb;\n#endif\n#ifdef USE_BATCHING_COLOR\n vColor *= getBatchingColor( getIndirectIndex( gl_DrawID ) );\n#endif",vv="#define PI 3.\
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
 in float dotVH ) {\n float fresnel = exp2( ( - 5.55473 * dotVH - 6.98316 ) * dotVH );\n return f0 * ( 1.0 - fresnel ) + ( f90 * fresnel );\n} // validated",bv="\
vec3 transformedNormal = objectNormal;\n#ifdef USE_TANGENT\n vec3 transformedTangent = objectTangent;\n#endif\n#ifdef USE_BATCHING\n mat3 bm = mat3( batchingMatrix )\
;\n transformedNormal /= vec3( dot( bm[ 0 ], bm[ 0 ] ), dot( bm[ 1 ], bm[ 1 ] ), dot( bm[ 2 ], bm[ 2 ] ) );\n transformedNormal = bm * transformedNormal;\n #ifdef \
USE_TANGENT\n  transformedTangent = bm * transformedTangent;\n #endif\n#endif\n#ifdef USE_INSTANCING\n mat3 im = mat3( instanceMatrix );\n transformedNormal /= vec3( \
dot( im[ 0 ], im[ 0 ] ), dot( im[ 1 ], im[ 1 ] ), dot( im[ 2 ], im[ 2 ] ) );\n transformedNormal = im * transformedNormal;\n #ifdef USE_TANGENT\n  transformedTange\
nt = im * transformedTangent;\n #endif\n#endif\ntransformedNormal = normalMatrix * transformedNormal;\n#ifdef FLIP_SIDED\n transformedNormal = - transformedNormal;\n#\
endif\n#ifdef USE_TANGENT\n transformedTangent = ( modelViewMatrix * vec4( transformedTangent, 0.0 ) ).xyz;\n#endif",Mv="#ifdef USE_DISPLACEMENTMAP\n uniform sam\
pler2D displacementMap;\n uniform float displacementScale;\n uniform float displacementBias;\n#endif",Sv="#ifdef USE_DISPLACEMENTMAP\n transformed += normalize( \
objectNormal ) * ( texture2D( displacementMap, vDisplacementMapUv ).x * displacementScale + displacementBias );\n#endif",wv="#ifdef USE_EMISSIVEMAP\n vec4 emissi\
veColor = texture2D( emissiveMap, vEmissiveMapUv );\n #ifdef DECODE_VIDEO_TEXTURE_EMISSIVE\n  emissiveColor = sRGBTransferEOTF( emissiveColor );\n #endif\n totalEmi\
ssiveRadiance *= emissiveColor.rgb;\n#endif",Tv="#ifdef USE_EMISSIVEMAP\n uniform sampler2D emissiveMap;\n#endif",Av="gl_FragColor = linearToOutputTexel( gl_Fra\
gColor );",Ev="vec4 LinearTransferOETF( in vec4 value ) {\n return value;\n}\nvec4 sRGBTransferEOTF( in vec4 value ) {\n return vec4( mix( pow( value.rgb * 0.947867\
2986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), value.rgb * 0.0773993808, vec3( lessThanEqual( value.rgb, vec3( 0.04045 ) ) ) ), value.a );\n}\nvec4 sRGBTransferOETF(\
 in vec4 value ) {\n return vec4( mix( pow( value.rgb, vec3( 0.41666 ) ) * 1.055 - vec3( 0.055 ), value.rgb * 12.92, vec3( lessThanEqual( value.rgb, vec3( 0.0031\
308 ) ) ) ), value.a );\n}",Cv="#ifdef USE_ENVMAP\n #ifdef ENV_WORLDPOS\n  vec3 cameraToFrag;\n  if ( isOrthographic ) {\n   cameraToFrag = normalize( vec3( - viewM\
atrix[ 0 ][ 2 ], - viewMatrix[ 1 ][ 2 ], - viewMatrix[ 2 ][ 2 ] ) );\n  } else {\n   cameraToFrag = normalize( vWorldPosition - cameraPosition );\n  }\n  vec3 world\
Normal = transformNormalByInverseViewMatrix( normal, viewMatrix );\n  #ifdef ENVMAP_MODE_REFLECTION\n   vec3 reflectVec = reflect( cameraToFrag, worldNormal );\n  \
#else\n   vec3 reflectVec = refract( cameraToFrag, worldNormal, refractionRatio );\n  #endif\n #else\n  vec3 reflectVec = vReflect;\n #endif\n #ifdef ENVMAP_TYPE_CUBE\
\n  vec4 envColor = textureCube( envMap, envMapRotation * reflectVec );\n  #ifdef ENVMAP_BLENDING_MULTIPLY\n   outgoingLight = mix( outgoingLight, outgoingLight * \
envColor.xyz, specularStrength * reflectivity );\n  #elif defined( ENVMAP_BLENDING_MIX )\n   outgoingLight = mix( outgoingLight, envColor.xyz, specularStrength * \
reflectivity );\n  #elif defined( ENVMAP_BLENDING_ADD )\n   outgoingLight += envColor.xyz * specularStrength * reflectivity;\n  #endif\n #endif\n#endif",Rv="#if\
def USE_ENVMAP\n uniform float envMapIntensity;\n uniform mat3 envMapRotation;\n uniform samplerCube envMap;\n #ifdef ENVMAP_TYPE_PMREM\n  float roughnessToMip( cons\
t in float roughness ) {\n   float r = clamp( roughness, 0.0, 1.0 );\n   return ENVMAP_MAX_LOD * r * ( 2.0 - r );\n  }\n #endif\n#endif",Pv="#ifdef USE_ENVMAP\n \
uniform float reflectivity;\n #if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )\n  #define ENV_WORLDPOS\n #endif\n #i\
fdef ENV_WORLDPOS\n  varying vec3 vWorldPosition;\n  uniform float refractionRatio;\n #else\n  varying vec3 vReflect;\n #endif\n#endif",Iv="#ifdef USE_ENVMAP\n #\
if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )\n  #define ENV_WORLDPOS\n #endif\n #ifdef ENV_WORLDPOS\n  \n  varying\
 vec3 vWorldPosition;\n #else\n  varying vec3 vReflect;\n  uniform float refractionRatio;\n #endif\n#endif",Lv="#ifdef USE_ENVMAP\n #ifdef ENV_WORLDPOS\n  vWorldP\
osition = worldPosition.xyz;\n #else\n  vec3 cameraToVertex;\n  if ( isOrthographic ) {\n   cameraToVertex = normalize( vec3( - viewMatrix[ 0 ][ 2 ], - viewMatrix[ \
1 ][ 2 ], - viewMatrix[ 2 ][ 2 ] ) );\n  } else {\n   cameraToVertex = normalize( worldPosition.xyz - cameraPosition );\n  }\n  vec3 worldNormal = transformNormalBy\
InverseViewMatrix( transformedNormal, viewMatrix );\n  #ifdef ENVMAP_MODE_REFLECTION\n   vReflect = reflect( cameraToVertex, worldNormal );\n  #else\n   vReflect = \
refract( cameraToVertex, worldNormal, refractionRatio );\n  #endif\n #endif\n#endif",Nv="#ifdef USE_FOG\n vFogDepth = - mvPosition.z;\n#endif",Dv="#ifdef USE_FO\
G\n varying float vFogDepth;\n#endif",Uv="#ifdef USE_FOG\n #ifdef FOG_EXP2\n  float fogFactor = 1.0 - exp( - fogDensity * fogDensity * vFogDepth * vFogDepth );\n #\
else\n  float fogFactor = smoothstep( fogNear, fogFar, vFogDepth );\n #endif\n gl_FragColor.rgb = mix( gl_FragColor.rgb, fogColor, fogFactor );\n#endif",Fv="#if\
def USE_FOG\n uniform vec3 fogColor;\n varying float vFogDepth;\n #ifdef FOG_EXP2\n  uniform float fogDensity;\n #else\n  uniform float fogNear;\n  uniform float fogFa\
r;\n #endif\n#endif",Ov="#ifdef USE_GRADIENTMAP\n uniform sampler2D gradientMap;\n#endif\nvec3 getGradientIrradiance( vec3 normal, vec3 lightDirection ) {\n float d\
otNL = dot( normal, lightDirection );\n vec2 coord = vec2( dotNL * 0.5 + 0.5, 0.0 );\n #ifdef USE_GRADIENTMAP\n  return vec3( texture2D( gradientMap, coord ).r );\n\
 #else\n  vec2 fw = fwidth( coord ) * 0.5;\n  return mix( vec3( 0.7 ), vec3( 1.0 ), smoothstep( 0.7 - fw.x, 0.7 + fw.x, coord.x ) );\n #endif\n}",Bv="#ifdef USE\
_LIGHTMAP\n uniform sampler2D lightMap;\n uniform float lightMapIntensity;\n#endif",kv="LambertMaterial material;\nmaterial.diffuseColor = diffuseColor.rgb;\nmate\
rial.specularStrength = specularStrength;",zv="varying vec3 vViewPosition;\nstruct LambertMaterial {\n vec3 diffuseColor;\n float specularStrength;\n};\nvoid RE_Dire\
ct_Lambert( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geome\
tryClearcoatNormal, const in LambertMaterial material, inout ReflectedLight reflectedLight ) {\n float dotNL = saturate( dot( geometryNormal, directLight.directi\
on ) );\n vec3 irradiance = dotNL * directLight.color;\n reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );\n}\nvoid RE_IndirectDif\
fuse_Lambert( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClear\
coatNormal, const in LambertMaterial material, inout ReflectedLight reflectedLight ) {\n reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.di\
ffuseColor );\n}\n#define RE_Direct    RE_Direct_Lambert\n#define RE_IndirectDiffuse  RE_IndirectDiffuse_Lambert",Vv="uniform bool receiveShadow;\nuniform vec3 a\
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
lightprobes_pars_fragment>",Gv="#ifdef USE_ENVMAP\n vec3 getIBLIrradiance( const in vec3 normal ) {\n  #ifdef ENVMAP_TYPE_PMREM\n   vec3 worldNormal = transformNor\
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
Hv="ToonMaterial material;\nmaterial.diffuseColor = diffuseColor.rgb;",Wv="varying vec3 vViewPosition;\nstruct ToonMaterial {\n vec3 diffuseColor;\n};\nvoid RE_Dire\
ct_Toon( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometry\
ClearcoatNormal, const in ToonMaterial material, inout ReflectedLight reflectedLight ) {\n vec3 irradiance = getGradientIrradiance( geometryNormal, directLight.d\
irection ) * directLight.color;\n reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );\n}\nvoid RE_IndirectDiffuse_Toon( const in ve\
c3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in Toon\
Material material, inout ReflectedLight reflectedLight ) {\n reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );\n}\n#define RE_D\
irect    RE_Direct_Toon\n#define RE_IndirectDiffuse  RE_IndirectDiffuse_Toon",Xv="BlinnPhongMaterial material;\nmaterial.diffuseColor = diffuseColor.rgb;\nmateria\
l.specularColor = specular;\nmaterial.specularShininess = shininess;\nmaterial.specularStrength = specularStrength;",$v="varying vec3 vViewPosition;\nstruct Blin\
nPhongMaterial {\n vec3 diffuseColor;\n vec3 specularColor;\n float specularShininess;\n float specularStrength;\n};\nvoid RE_Direct_BlinnPhong( const in IncidentLigh\
t directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in Blin\
nPhongMaterial material, inout ReflectedLight reflectedLight ) {\n float dotNL = saturate( dot( geometryNormal, directLight.direction ) );\n vec3 irradiance = dot\
NL * directLight.color;\n reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );\n reflectedLight.directSpecular += irradiance * BRDF\
_BlinnPhong( directLight.direction, geometryViewDir, geometryNormal, material.specularColor, material.specularShininess ) * material.specularStrength;\n}\nvoid RE\
_IndirectDiffuse_BlinnPhong( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec\
3 geometryClearcoatNormal, const in BlinnPhongMaterial material, inout ReflectedLight reflectedLight ) {\n reflectedLight.indirectDiffuse += irradiance * BRDF_La\
mbert( material.diffuseColor );\n}\n#define RE_Direct    RE_Direct_BlinnPhong\n#define RE_IndirectDiffuse  RE_IndirectDiffuse_BlinnPhong",qv="PhysicalMaterial m\
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
sotropyV.x - tbn[ 0 ] * anisotropyV.y;\n#endif",Yv="uniform sampler2D dfgLUT;\nstruct PhysicalMaterial {\n vec3 diffuseColor;\n vec3 diffuseContribution;\n vec3 spe\
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
V + ambientOcclusion, exp2( - 16.0 * roughness - 1.0 ) ) - 1.0 + ambientOcclusion );\n}",Zv="\nvec3 geometryPosition = - vViewPosition;\nvec3 geometryNormal = nor\
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
nce = vec3( 0.0 );\n vec3 clearcoatRadiance = vec3( 0.0 );\n#endif",Jv="#if defined( RE_IndirectDiffuse )\n #ifdef USE_LIGHTMAP\n  vec4 lightMapTexel = texture2D(\
 lightMap, vLightMapUv );\n  vec3 lightMapIrradiance = lightMapTexel.rgb * lightMapIntensity;\n  irradiance += lightMapIrradiance;\n #endif\n #if defined( USE_ENVMA\
P ) && defined( ENVMAP_TYPE_PMREM )\n  #if defined( STANDARD ) || defined( LAMBERT ) || defined( PHONG )\n   iblIrradiance += getIBLIrradiance( geometryNormal );\n\
  #endif\n #endif\n#endif\n#if defined( USE_ENVMAP ) && defined( RE_IndirectSpecular )\n #ifdef USE_ANISOTROPY\n  vec3 iblRadiance = getIBLAnisotropyRadiance( geomet\
ryViewDir, geometryNormal, material.roughness, material.anisotropyB, material.anisotropy );\n #else\n  vec3 iblRadiance = getIBLRadiance( geometryViewDir, geometr\
yNormal, material.roughness );\n #endif\n #ifdef USE_RETROREFLECTION\n  #ifdef USE_ANISOTROPY\n   vec3 retroIBLRadiance = getIBLAnisotropyRetroRadiance( geometryVie\
wDir, geometryNormal, material.roughness, material.anisotropyB, material.anisotropy );\n  #else\n   vec3 retroIBLRadiance = getIBLRetroRadiance( geometryViewDir, \
geometryNormal, material.roughness );\n  #endif\n  iblRadiance = mix( iblRadiance, retroIBLRadiance, saturate( material.retroreflectivity ) );\n #endif\n radiance +\
= iblRadiance;\n #ifdef USE_CLEARCOAT\n  clearcoatRadiance += getIBLRadiance( geometryViewDir, geometryClearcoatNormal, material.clearcoatRoughness );\n #endif\n#en\
dif",Kv="#if defined( RE_IndirectDiffuse )\n #if defined( LAMBERT ) || defined( PHONG )\n  irradiance += iblIrradiance;\n #endif\n RE_IndirectDiffuse( irradiance, g\
eometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );\n#endif\n#if defined( RE_IndirectSpecular )\n RE_IndirectSpe\
cular( radiance, iblIrradiance, clearcoatRadiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );\n#endi\
f",jv="#if NUM_LIGHT_PROBE_GRIDS > 0\nuniform highp sampler3D probesSH[ NUM_LIGHT_PROBE_GRIDS ];\nuniform vec3 probesMin[ NUM_LIGHT_PROBE_GRIDS ];\nuniform vec3 pr\
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
Qv="#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )\n gl_FragDepth = vIsPerspective == 0.0 ? gl_FragCoord.z : log2( vFragDepth ) * logDepthBufFC * 0.5;\n#endif",eb="\
#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )\n uniform float logDepthBufFC;\n varying float vFragDepth;\n varying float vIsPerspective;\n#endif",tb="#ifdef USE_L\
OGARITHMIC_DEPTH_BUFFER\n varying float vFragDepth;\n varying float vIsPerspective;\n#endif",nb="#ifdef USE_LOGARITHMIC_DEPTH_BUFFER\n vFragDepth = 1.0 + gl_Posi\
tion.w;\n vIsPerspective = float( isPerspectiveMatrix( projectionMatrix ) );\n#endif",ib="#ifdef USE_MAP\n vec4 sampledDiffuseColor = texture2D( map, vMapUv );\n \
#ifdef DECODE_VIDEO_TEXTURE\n  sampledDiffuseColor = sRGBTransferEOTF( sampledDiffuseColor );\n #endif\n diffuseColor *= sampledDiffuseColor;\n#endif",sb="#ifde\
f USE_MAP\n uniform sampler2D map;\n#endif",rb="#if defined( USE_MAP ) || defined( USE_ALPHAMAP )\n #if defined( USE_POINTS_UV )\n  vec2 uv = vUv;\n #else\n  vec2 u\
v = ( uvTransform * vec3( gl_PointCoord.x, 1.0 - gl_PointCoord.y, 1 ) ).xy;\n #endif\n#endif\n#ifdef USE_MAP\n diffuseColor *= texture2D( map, uv );\n#endif\n#ifdef U\
SE_ALPHAMAP\n diffuseColor.a *= texture2D( alphaMap, uv ).g;\n#endif",ob="#if defined( USE_POINTS_UV )\n varying vec2 vUv;\n#else\n #if defined( USE_MAP ) || defin\
ed( USE_ALPHAMAP )\n  uniform mat3 uvTransform;\n #endif\n#endif\n#ifdef USE_MAP\n uniform sampler2D map;\n#endif\n#ifdef USE_ALPHAMAP\n uniform sampler2D alphaMap;\n#en\
dif",ab="float metalnessFactor = metalness;\n#ifdef USE_METALNESSMAP\n vec4 texelMetalness = texture2D( metalnessMap, vMetalnessMapUv );\n metalnessFactor *= texel\
Metalness.b;\n#endif",lb="#ifdef USE_METALNESSMAP\n uniform sampler2D metalnessMap;\n#endif",cb="#ifdef USE_INSTANCING_MORPH\n float morphTargetInfluences[ MORPH\
TARGETS_COUNT ];\n float morphTargetBaseInfluence = texelFetch( morphTexture, ivec2( 0, gl_InstanceID ), 0 ).r;\n for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) \
{\n  morphTargetInfluences[i] =  texelFetch( morphTexture, ivec2( i + 1, gl_InstanceID ), 0 ).r;\n }\n#endif",hb="#if defined( USE_MORPHCOLORS )\n #if defined( U\
SE_COLOR_ALPHA )\n  vColor *= morphTargetBaseInfluence;\n #elif defined( USE_COLOR )\n  vColor.rgb *= morphTargetBaseInfluence;\n #endif\n for ( int i = 0; i < MORPH\
TARGETS_COUNT; i ++ ) {\n  #if defined( USE_COLOR_ALPHA )\n   if ( morphTargetInfluences[ i ] != 0.0 ) vColor += getMorph( gl_VertexID, i, 2 ) * morphTargetInflue\
nces[ i ];\n  #elif defined( USE_COLOR )\n   if ( morphTargetInfluences[ i ] != 0.0 ) vColor.rgb += getMorph( gl_VertexID, i, 2 ).rgb * morphTargetInfluences[ i ]\
;\n  #endif\n }\n#endif",ub="#ifdef USE_MORPHNORMALS\n objectNormal *= morphTargetBaseInfluence;\n for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {\n  if ( morphT\
argetInfluences[ i ] != 0.0 ) objectNormal += getMorph( gl_VertexID, i, 1 ).xyz * morphTargetInfluences[ i ];\n }\n#endif",db="#ifdef USE_MORPHTARGETS\n #ifndef \
USE_INSTANCING_MORPH\n  uniform float morphTargetBaseInfluence;\n  uniform float morphTargetInfluences[ MORPHTARGETS_COUNT ];\n #endif\n uniform sampler2DArray morp\
hTargetsTexture;\n uniform ivec2 morphTargetsTextureSize;\n vec4 getMorph( const in int vertexIndex, const in int morphTargetIndex, const in int offset ) {\n  int \
texelIndex = vertexIndex * MORPHTARGETS_TEXTURE_STRIDE + offset;\n  int y = texelIndex / morphTargetsTextureSize.x;\n  int x = texelIndex - y * morphTargetsTextur\
eSize.x;\n  ivec3 morphUV = ivec3( x, y, morphTargetIndex );\n  return texelFetch( morphTargetsTexture, morphUV, 0 );\n }\n#endif",fb="#ifdef USE_MORPHTARGETS\n \
transformed *= morphTargetBaseInfluence;\n for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {\n  if ( morphTargetInfluences[ i ] != 0.0 ) transformed += getMorph( \
gl_VertexID, i, 0 ).xyz * morphTargetInfluences[ i ];\n }\n#endif",pb="float faceDirection = gl_FrontFacing ? 1.0 : - 1.0;\n#ifdef FLAT_SHADED\n vec3 fdx = dFdx( \
vViewPosition );\n vec3 fdy = dFdy( vViewPosition );\n vec3 normal = normalize( cross( fdx, fdy ) );\n#else\n vec3 normal = normalize( vNormal );\n #ifdef DOUBLE_SID\
ED\n  normal *= faceDirection;\n #endif\n#endif\n#if defined( USE_NORMALMAP_TANGENTSPACE ) || defined( USE_CLEARCOAT_NORMALMAP ) || defined( USE_ANISOTROPY )\n #ifde\
f USE_TANGENT\n  mat3 tbn = mat3( normalize( vTangent ), normalize( vBitangent ), normal );\n #else\n  mat3 tbn = getTangentFrame( - vViewPosition, normal,\n  #if d\
efined( USE_NORMALMAP )\n   vNormalMapUv\n  #elif defined( USE_CLEARCOAT_NORMALMAP )\n   vClearcoatNormalMapUv\n  #else\n   vUv\n  #endif\n  );\n #endif\n #ifdef DOUBLE_\
SIDED\n  tbn[0] *= faceDirection;\n  tbn[1] *= faceDirection;\n #endif\n#endif\n#ifdef USE_CLEARCOAT_NORMALMAP\n #ifdef USE_TANGENT\n  mat3 tbn2 = mat3( normalize( vTa\
ngent ), normalize( vBitangent ), normal );\n #else\n  mat3 tbn2 = getTangentFrame( - vViewPosition, normal, vClearcoatNormalMapUv );\n #endif\n #ifdef DOUBLE_SIDED\
\n  tbn2[0] *= faceDirection;\n  tbn2[1] *= faceDirection;\n #endif\n#endif\nvec3 nonPerturbedNormal = normal;",mb="#ifdef USE_NORMALMAP_OBJECTSPACE\n normal = t\
exture2D( normalMap, vNormalMapUv ).xyz * 2.0 - 1.0;\n #ifdef FLIP_SIDED\n  normal = - normal;\n #endif\n #ifdef DOUBLE_SIDED\n  normal = normal * faceDirection;\n #e\
ndif\n normal = normalize( normalMatrix * normal );\n#elif defined( USE_NORMALMAP_TANGENTSPACE )\n vec3 mapN = texture2D( normalMap, vNormalMapUv ).xyz * 2.0 - 1.0\
;\n #if defined( USE_PACKED_NORMALMAP )\n  mapN = vec3( mapN.xy, sqrt( saturate( 1.0 - dot( mapN.xy, mapN.xy ) ) ) );\n #endif\n mapN.xy *= normalScale;\n normal = n\
ormalize( tbn * mapN );\n#elif defined( USE_BUMPMAP )\n normal = perturbNormalArb( - vViewPosition, normal, dHdxy_fwd(), faceDirection );\n#endif",gb="#ifndef F\
LAT_SHADED\n varying vec3 vNormal;\n #ifdef USE_TANGENT\n  varying vec3 vTangent;\n  varying vec3 vBitangent;\n #endif\n#endif",_b="#ifndef FLAT_SHADED\n varying\
 vec3 vNormal;\n #ifdef USE_TANGENT\n  varying vec3 vTangent;\n  varying vec3 vBitangent;\n #endif\n#endif",xb="#ifndef FLAT_SHADED\n vNormal = normalize( transf\
ormedNormal );\n #ifdef USE_TANGENT\n  vTangent = normalize( transformedTangent );\n  vBitangent = normalize( cross( vNormal, vTangent ) * tangent.w );\n  #ifdef FL\
IP_SIDED\n   vBitangent = - vBitangent;\n  #endif\n #endif\n#endif",yb="#ifdef USE_NORMALMAP\n uniform sampler2D normalMap;\n uniform vec2 normalScale;\n#endif\n#if\
def USE_NORMALMAP_OBJECTSPACE\n uniform mat3 normalMatrix;\n#endif\n#if ! defined ( USE_TANGENT ) && ( defined ( USE_NORMALMAP_TANGENTSPACE ) || defined ( USE_CLEA\
RCOAT_NORMALMAP ) || defined( USE_ANISOTROPY ) )\n mat3 getTangentFrame( vec3 eye_pos, vec3 surf_norm, vec2 uv ) {\n  vec3 q0 = dFdx( eye_pos.xyz );\n  vec3 q1 = d\
Fdy( eye_pos.xyz );\n  vec2 st0 = dFdx( uv.st );\n  vec2 st1 = dFdy( uv.st );\n  vec3 N = surf_norm;\n  vec3 q1perp = cross( q1, N );\n  vec3 q0perp = cross( N, q0 )\
;\n  vec3 T = q1perp * st0.x + q0perp * st1.x;\n  vec3 B = q1perp * st0.y + q0perp * st1.y;\n  float det = max( dot( T, T ), dot( B, B ) );\n  float scale = ( det =\
= 0.0 ) ? 0.0 : inversesqrt( det );\n  return mat3( T * scale, B * scale, N );\n }\n#endif",vb="#ifdef USE_CLEARCOAT\n vec3 clearcoatNormal = nonPerturbedNormal;\
\n#endif",bb="#ifdef USE_CLEARCOAT_NORMALMAP\n vec3 clearcoatMapN = texture2D( clearcoatNormalMap, vClearcoatNormalMapUv ).xyz * 2.0 - 1.0;\n clearcoatMapN.xy *= \
clearcoatNormalScale;\n clearcoatNormal = normalize( tbn2 * clearcoatMapN );\n#endif",Mb="#ifdef USE_CLEARCOATMAP\n uniform sampler2D clearcoatMap;\n#endif\n#ifdef\
 USE_CLEARCOAT_NORMALMAP\n uniform sampler2D clearcoatNormalMap;\n uniform vec2 clearcoatNormalScale;\n#endif\n#ifdef USE_CLEARCOAT_ROUGHNESSMAP\n uniform sampler2D \
clearcoatRoughnessMap;\n#endif",Sb="#ifdef USE_IRIDESCENCEMAP\n uniform sampler2D iridescenceMap;\n#endif\n#ifdef USE_IRIDESCENCE_THICKNESSMAP\n uniform sampler2D i\
ridescenceThicknessMap;\n#endif",wb="#ifdef OPAQUE\ndiffuseColor.a = 1.0;\n#endif\n#ifdef USE_TRANSMISSION\ndiffuseColor.a *= material.transmissionAlpha;\n#endif\ngl_\
FragColor = vec4( outgoingLight, diffuseColor.a );",Tb="vec3 packNormalToRGB( const in vec3 normal ) {\n return normalize( normal ) * 0.5 + 0.5;\n}\nvec3 unpackRGB\
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
far - near ) * depth - far );\n #endif\n}",Ab="#ifdef PREMULTIPLIED_ALPHA\n gl_FragColor.rgb *= gl_FragColor.a;\n#endif",Eb="vec4 mvPosition = vec4( transformed\
, 1.0 );\n#ifdef USE_BATCHING\n mvPosition = batchingMatrix * mvPosition;\n#endif\n#ifdef USE_INSTANCING\n mvPosition = instanceMatrix * mvPosition;\n#endif\nmvPositio\
n = modelViewMatrix * mvPosition;\ngl_Position = projectionMatrix * mvPosition;",Cb="#ifdef DITHERING\n gl_FragColor.rgb = dithering( gl_FragColor.rgb );\n#endif",
Rb="#ifdef DITHERING\n vec3 dithering( vec3 color ) {\n  float grid_position = rand( gl_FragCoord.xy );\n  vec3 dither_shift_RGB = vec3( 0.25 / 255.0, -0.25 / 255.\
0, 0.25 / 255.0 );\n  dither_shift_RGB = mix( 2.0 * dither_shift_RGB, -2.0 * dither_shift_RGB, grid_position );\n  return color + dither_shift_RGB;\n }\n#endif",
Pb="float roughnessFactor = roughness;\n#ifdef USE_ROUGHNESSMAP\n vec4 texelRoughness = texture2D( roughnessMap, vRoughnessMapUv );\n roughnessFactor *= texelRough\
ness.g;\n#endif",Ib="#ifdef USE_ROUGHNESSMAP\n uniform sampler2D roughnessMap;\n#endif",Lb="#if NUM_SPOT_LIGHT_COORDS > 0\n varying vec4 vSpotLightCoord[ NUM_SPO\
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
endif\n #endif\n#endif",Nb="#if NUM_SPOT_LIGHT_COORDS > 0\n uniform mat4 spotLightMatrix[ NUM_SPOT_LIGHT_COORDS ];\n varying vec4 vSpotLightCoord[ NUM_SPOT_LIGHT_\
COORDS ];\n#endif\n#ifdef USE_SHADOWMAP\n #if NUM_SUN_LIGHT_SHADOWS > 0\n  varying vec4 vSunShadowWorldPosition;\n  varying vec3 vSunShadowWorldNormal;\n #endif\n #if \
NUM_DIR_LIGHT_SHADOWS > 0\n  uniform mat4 directionalShadowMatrix[ NUM_DIR_LIGHT_SHADOWS ];\n  varying vec4 vDirectionalShadowCoord[ NUM_DIR_LIGHT_SHADOWS ];\n  st\
ruct DirectionalLightShadow {\n   float shadowIntensity;\n   float shadowBias;\n   float shadowNormalBias;\n   float shadowRadius;\n   vec2 shadowMapSize;\n  };\n  uni\
form DirectionalLightShadow directionalLightShadows[ NUM_DIR_LIGHT_SHADOWS ];\n #endif\n #if NUM_SPOT_LIGHT_SHADOWS > 0\n  struct SpotLightShadow {\n   float shadow\
Intensity;\n   float shadowBias;\n   float shadowNormalBias;\n   float shadowRadius;\n   vec2 shadowMapSize;\n  };\n  uniform SpotLightShadow spotLightShadows[ NUM_SP\
OT_LIGHT_SHADOWS ];\n #endif\n #if NUM_POINT_LIGHT_SHADOWS > 0\n  uniform mat4 pointShadowMatrix[ NUM_POINT_LIGHT_SHADOWS ];\n  varying vec4 vPointShadowCoord[ NUM_\
POINT_LIGHT_SHADOWS ];\n  struct PointLightShadow {\n   float shadowIntensity;\n   float shadowBias;\n   float shadowNormalBias;\n   float shadowRadius;\n   vec2 shad\
owMapSize;\n   float shadowCameraNear;\n   float shadowCameraFar;\n  };\n  uniform PointLightShadow pointLightShadows[ NUM_POINT_LIGHT_SHADOWS ];\n #endif\n#endif",
Db="#if ( defined( USE_SHADOWMAP ) && ( NUM_DIR_LIGHT_SHADOWS > 0 || NUM_SUN_LIGHT_SHADOWS > 0 || NUM_POINT_LIGHT_SHADOWS > 0 ) ) || ( NUM_SPOT_LIGHT_COORDS > 0\
 )\n #ifdef HAS_NORMAL\n  vec3 shadowWorldNormal = transformNormalByInverseViewMatrix( transformedNormal, viewMatrix );\n #else\n  vec3 shadowWorldNormal = vec3( 0.\
0 );\n #endif\n vec4 shadowWorldPosition;\n#endif\n#if defined( USE_SHADOWMAP )\n #if NUM_SUN_LIGHT_SHADOWS > 0\n  vSunShadowWorldPosition = vec4( worldPosition.xyz, \
- mvPosition.z );\n  vSunShadowWorldNormal = shadowWorldNormal;\n #endif\n #if NUM_DIR_LIGHT_SHADOWS > 0\n  #pragma unroll_loop_start\n  for ( int i = 0; i < NUM_DIR\
_LIGHT_SHADOWS; i ++ ) {\n   shadowWorldPosition = worldPosition + vec4( shadowWorldNormal * directionalLightShadows[ i ].shadowNormalBias, 0 );\n   vDirectionalS\
hadowCoord[ i ] = directionalShadowMatrix[ i ] * shadowWorldPosition;\n  }\n  #pragma unroll_loop_end\n #endif\n #if NUM_POINT_LIGHT_SHADOWS > 0\n  #pragma unroll_lo\
op_start\n  for ( int i = 0; i < NUM_POINT_LIGHT_SHADOWS; i ++ ) {\n   shadowWorldPosition = worldPosition + vec4( shadowWorldNormal * pointLightShadows[ i ].shad\
owNormalBias, 0 );\n   vPointShadowCoord[ i ] = pointShadowMatrix[ i ] * shadowWorldPosition;\n  }\n  #pragma unroll_loop_end\n #endif\n#endif\n#if NUM_SPOT_LIGHT_COO\
RDS > 0\n #pragma unroll_loop_start\n for ( int i = 0; i < NUM_SPOT_LIGHT_COORDS; i ++ ) {\n  shadowWorldPosition = worldPosition;\n  #if ( defined( USE_SHADOWMAP )\
 && UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )\n   shadowWorldPosition.xyz += shadowWorldNormal * spotLightShadows[ i ].shadowNormalBias;\n  #endif\n  vSpotLig\
htCoord[ i ] = spotLightMatrix[ i ] * shadowWorldPosition;\n }\n #pragma unroll_loop_end\n#endif",Ub="float getShadowMask() {\n float shadow = 1.0;\n #ifdef USE_S\
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
ow;\n}",Fb="#ifdef USE_SKINNING\n mat4 boneMatX = getBoneMatrix( skinIndex.x );\n mat4 boneMatY = getBoneMatrix( skinIndex.y );\n mat4 boneMatZ = getBoneMatrix( sk\
inIndex.z );\n mat4 boneMatW = getBoneMatrix( skinIndex.w );\n#endif",Ob="#ifdef USE_SKINNING\n uniform mat4 bindMatrix;\n uniform mat4 bindMatrixInverse;\n unifor\
m highp sampler2D boneTexture;\n mat4 getBoneMatrix( const in float i ) {\n  int size = textureSize( boneTexture, 0 ).x;\n  int j = int( i ) * 4;\n  int x = j % siz\
e;\n  int y = j / size;\n  vec4 v1 = texelFetch( boneTexture, ivec2( x, y ), 0 );\n  vec4 v2 = texelFetch( boneTexture, ivec2( x + 1, y ), 0 );\n  vec4 v3 = texelFe\
tch( boneTexture, ivec2( x + 2, y ), 0 );\n  vec4 v4 = texelFetch( boneTexture, ivec2( x + 3, y ), 0 );\n  return mat4( v1, v2, v3, v4 );\n }\n#endif",Bb="#ifde\
f USE_SKINNING\n vec4 skinVertex = bindMatrix * vec4( transformed, 1.0 );\n vec4 skinned = vec4( 0.0 );\n skinned += boneMatX * skinVertex * skinWeight.x;\n skinned\
 += boneMatY * skinVertex * skinWeight.y;\n skinned += boneMatZ * skinVertex * skinWeight.z;\n skinned += boneMatW * skinVertex * skinWeight.w;\n transformed = ( b\
indMatrixInverse * skinned ).xyz;\n#endif",kb="#ifdef USE_SKINNING\n mat4 skinMatrix = mat4( 0.0 );\n skinMatrix += skinWeight.x * boneMatX;\n skinMatrix += skinWe\
ight.y * boneMatY;\n skinMatrix += skinWeight.z * boneMatZ;\n skinMatrix += skinWeight.w * boneMatW;\n skinMatrix = bindMatrixInverse * skinMatrix * bindMatrix;\n o\
bjectNormal = vec4( skinMatrix * vec4( objectNormal, 0.0 ) ).xyz;\n #ifdef USE_TANGENT\n  objectTangent = vec4( skinMatrix * vec4( objectTangent, 0.0 ) ).xyz;\n #e\
ndif\n#endif",zb="float specularStrength;\n#ifdef USE_SPECULARMAP\n vec4 texelSpecular = texture2D( specularMap, vSpecularMapUv );\n specularStrength = texelSpecul\
ar.r;\n#else\n specularStrength = 1.0;\n#endif",Vb="#ifdef USE_SPECULARMAP\n uniform sampler2D specularMap;\n#endif",Gb="#if defined( TONE_MAPPING )\n gl_FragCol\
or.rgb = toneMapping( gl_FragColor.rgb );\n#endif",Hb="#ifndef saturate\n#define saturate( a ) clamp( a, 0.0, 1.0 )\n#endif\nuniform float toneMappingExposure;\nvec\
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
 color; }",Wb="#ifdef USE_TRANSMISSION\n material.transmission = transmission;\n material.transmissionAlpha = 1.0;\n material.thickness = thickness;\n material.atte\
nuationDistance = attenuationDistance;\n material.attenuationColor = attenuationColor;\n #ifdef USE_TRANSMISSIONMAP\n  material.transmission *= texture2D( transmis\
sionMap, vTransmissionMapUv ).r;\n #endif\n #ifdef USE_THICKNESSMAP\n  material.thickness *= texture2D( thicknessMap, vThicknessMapUv ).g;\n #endif\n vec3 pos = vWor\
ldPosition;\n vec3 v = normalize( cameraPosition - pos );\n vec3 n = transformNormalByInverseViewMatrix( normal, viewMatrix );\n vec4 transmitted = getIBLVolumeRef\
raction(\n  n, v, material.roughness, material.diffuseContribution, material.specularColorBlended, material.specularF90,\n  pos, modelMatrix, viewMatrix, projecti\
onMatrix, material.dispersion, material.ior, material.thickness,\n  material.attenuationColor, material.attenuationDistance );\n material.transmissionAlpha = mix(\
 material.transmissionAlpha, transmitted.a, material.transmission );\n totalDiffuse = mix( totalDiffuse, transmitted.rgb, material.transmission );\n#endif",Xb="\
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
 ( 1.0 - F ) * attenuatedColor, 1.0 - ( 1.0 - transmittedLight.a ) * transmittanceFactor );\n }\n#endif",$b="#if defined( USE_UV ) || defined( USE_ANISOTROPY )\n\
 varying vec2 vUv;\n#endif\n#ifdef USE_MAP\n varying vec2 vMapUv;\n#endif\n#ifdef USE_ALPHAMAP\n varying vec2 vAlphaMapUv;\n#endif\n#ifdef USE_LIGHTMAP\n varying vec2 vL\
ightMapUv;\n#endif\n#ifdef USE_AOMAP\n varying vec2 vAoMapUv;\n#endif\n#ifdef USE_BUMPMAP\n varying vec2 vBumpMapUv;\n#endif\n#ifdef USE_NORMALMAP\n varying vec2 vNormal\
MapUv;\n#endif\n#ifdef USE_EMISSIVEMAP\n varying vec2 vEmissiveMapUv;\n#endif\n#ifdef USE_METALNESSMAP\n varying vec2 vMetalnessMapUv;\n#endif\n#ifdef USE_ROUGHNESSMAP\n\
 varying vec2 vRoughnessMapUv;\n#endif\n#ifdef USE_DIFFUSE_ROUGHNESSMAP\n varying vec2 vDiffuseRoughnessMapUv;\n#endif\n#ifdef USE_ANISOTROPYMAP\n varying vec2 vAniso\
tropyMapUv;\n#endif\n#ifdef USE_CLEARCOATMAP\n varying vec2 vClearcoatMapUv;\n#endif\n#ifdef USE_CLEARCOAT_NORMALMAP\n varying vec2 vClearcoatNormalMapUv;\n#endif\n#ifd\
ef USE_CLEARCOAT_ROUGHNESSMAP\n varying vec2 vClearcoatRoughnessMapUv;\n#endif\n#ifdef USE_IRIDESCENCEMAP\n varying vec2 vIridescenceMapUv;\n#endif\n#ifdef USE_IRIDES\
CENCE_THICKNESSMAP\n varying vec2 vIridescenceThicknessMapUv;\n#endif\n#ifdef USE_SHEEN_COLORMAP\n varying vec2 vSheenColorMapUv;\n#endif\n#ifdef USE_SHEEN_ROUGHNESSM\
AP\n varying vec2 vSheenRoughnessMapUv;\n#endif\n#ifdef USE_SPECULARMAP\n varying vec2 vSpecularMapUv;\n#endif\n#ifdef USE_SPECULAR_COLORMAP\n varying vec2 vSpecularCo\
lorMapUv;\n#endif\n#ifdef USE_SPECULAR_INTENSITYMAP\n varying vec2 vSpecularIntensityMapUv;\n#endif\n#ifdef USE_TRANSMISSIONMAP\n uniform mat3 transmissionMapTransfor\
m;\n varying vec2 vTransmissionMapUv;\n#endif\n#ifdef USE_THICKNESSMAP\n uniform mat3 thicknessMapTransform;\n varying vec2 vThicknessMapUv;\n#endif",qb="#if de\
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
g vec2 vTransmissionMapUv;\n#endif\n#ifdef USE_THICKNESSMAP\n uniform mat3 thicknessMapTransform;\n varying vec2 vThicknessMapUv;\n#endif",Yb="#if defined( USE_\
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
hicknessMapUv = ( thicknessMapTransform * vec3( THICKNESSMAP_UV, 1 ) ).xy;\n#endif",Zb="#if defined( USE_ENVMAP ) || defined( DISTANCE ) || defined ( USE_SHADOW\
MAP ) || defined ( USE_TRANSMISSION ) || NUM_SPOT_LIGHT_COORDS > 0\n vec4 worldPosition = vec4( transformed, 1.0 );\n #ifdef USE_BATCHING\n  worldPosition = batchi\
ngMatrix * worldPosition;\n #endif\n #ifdef USE_INSTANCING\n  worldPosition = instanceMatrix * worldPosition;\n #endif\n worldPosition = modelMatrix * worldPosition;\
\n#endif",Jb="varying vec2 vUv;\nuniform mat3 uvTransform;\nvoid main() {\n vUv = ( uvTransform * vec3( uv, 1 ) ).xy;\n gl_Position = vec4( position.xy, 1.0, 1.0 );\
\n}",Kb="uniform sampler2D t2D;\nuniform float backgroundIntensity;\nvarying vec2 vUv;\nvoid main() {\n vec4 texColor = texture2D( t2D, vUv );\n #ifdef DECODE_VIDEO_\
TEXTURE\n  texColor = vec4( mix( pow( texColor.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), texColor.rgb * 0.0773993808, vec3( lessThanEqual( texCol\
or.rgb, vec3( 0.04045 ) ) ) ), texColor.w );\n #endif\n texColor.rgb *= backgroundIntensity;\n gl_FragColor = texColor;\n #include <tonemapping_fragment>\n #include \
<colorspace_fragment>\n}",jb="varying vec3 vWorldDirection;\n#include <common>\nvoid main() {\n vWorldDirection = transformDirection( position, modelMatrix );\n #in\
clude <begin_vertex>\n #include <project_vertex>\n gl_Position.z = gl_Position.w;\n}",Qb="uniform float backgroundBlurriness;\nuniform float backgroundIntensity;\
\nuniform mat3 backgroundRotation;\nvarying vec3 vWorldDirection;\n#include <envmap_common_pars_fragment>\nvoid main() {\n #ifdef ENVMAP_TYPE_PMREM\n  vec4 texColor =\
 textureLod( envMap, backgroundRotation * vWorldDirection, roughnessToMip( backgroundBlurriness ) );\n #else\n  vec4 texColor = textureCube( envMap, backgroundRot\
ation * vWorldDirection );\n #endif\n texColor.rgb *= backgroundIntensity;\n gl_FragColor = texColor;\n #include <tonemapping_fragment>\n #include <colorspace_fragme\
nt>\n}",eM="varying vec3 vWorldDirection;\n#include <common>\nvoid main() {\n vWorldDirection = transformDirection( position, modelMatrix );\n #include <begin_verte\
x>\n #include <project_vertex>\n gl_Position.z = gl_Position.w;\n}",tM="uniform samplerCube tCube;\nuniform float tFlip;\nuniform float opacity;\nvarying vec3 vWor\
ldDirection;\nvoid main() {\n vec4 texColor = textureCube( tCube, vec3( tFlip * vWorldDirection.x, vWorldDirection.yz ) );\n gl_FragColor = texColor;\n gl_FragColor\
.a *= opacity;\n #include <tonemapping_fragment>\n #include <colorspace_fragment>\n}",nM="#include <common>\n#include <batching_pars_vertex>\n#include <uv_pars_ve\
rtex>\n#include <displacementmap_pars_vertex>\n#include <morphtarget_pars_vertex>\n#include <skinning_pars_vertex>\n#include <logdepthbuf_pars_vertex>\n#include <cli\
pping_planes_pars_vertex>\nvarying vec2 vHighPrecisionZW;\nvoid main() {\n #include <uv_vertex>\n #include <batching_vertex>\n #include <skinbase_vertex>\n #include <\
morphinstance_vertex>\n #ifdef USE_DISPLACEMENTMAP\n  #include <beginnormal_vertex>\n  #include <morphnormal_vertex>\n  #include <skinnormal_vertex>\n #endif\n #inclu\
de <begin_vertex>\n #include <morphtarget_vertex>\n #include <skinning_vertex>\n #include <displacementmap_vertex>\n #include <project_vertex>\n #include <logdepthbu\
f_vertex>\n #include <clipping_planes_vertex>\n vHighPrecisionZW = gl_Position.zw;\n}",iM="#if DEPTH_PACKING == 3200\n uniform float opacity;\n#endif\n#include <co\
mmon>\n#include <packing>\n#include <uv_pars_fragment>\n#include <map_pars_fragment>\n#include <alphamap_pars_fragment>\n#include <alphatest_pars_fragment>\n#include \
<alphahash_pars_fragment>\n#include <logdepthbuf_pars_fragment>\n#include <clipping_planes_pars_fragment>\nvarying vec2 vHighPrecisionZW;\nvoid main() {\n vec4 diffu\
seColor = vec4( 1.0 );\n #include <clipping_planes_fragment>\n #if DEPTH_PACKING == 3200\n  diffuseColor.a = opacity;\n #endif\n #include <map_fragment>\n #include <a\
lphamap_fragment>\n #include <alphatest_fragment>\n #include <alphahash_fragment>\n #include <logdepthbuf_fragment>\n #ifdef USE_REVERSED_DEPTH_BUFFER\n  float fragC\
oordZ = vHighPrecisionZW[ 0 ] / vHighPrecisionZW[ 1 ];\n #else\n  float fragCoordZ = 0.5 * vHighPrecisionZW[ 0 ] / vHighPrecisionZW[ 1 ] + 0.5;\n #endif\n #if DEPTH\
_PACKING == 3200\n  gl_FragColor = vec4( vec3( 1.0 - fragCoordZ ), opacity );\n #elif DEPTH_PACKING == 3201\n  gl_FragColor = packDepthToRGBA( fragCoordZ );\n #elif\
 DEPTH_PACKING == 3202\n  gl_FragColor = vec4( packDepthToRGB( fragCoordZ ), 1.0 );\n #elif DEPTH_PACKING == 3203\n  gl_FragColor = vec4( packDepthToRG( fragCoordZ\
 ), 0.0, 1.0 );\n #endif\n}",sM="#define DISTANCE\nvarying vec3 vWorldPosition;\n#include <common>\n#include <batching_pars_vertex>\n#include <uv_pars_vertex>\n#incl\
ude <displacementmap_pars_vertex>\n#include <morphtarget_pars_vertex>\n#include <skinning_pars_vertex>\n#include <clipping_planes_pars_vertex>\nvoid main() {\n #incl\
ude <uv_vertex>\n #include <batching_vertex>\n #include <skinbase_vertex>\n #include <morphinstance_vertex>\n #ifdef USE_DISPLACEMENTMAP\n  #include <beginnormal_ver\
tex>\n  #include <morphnormal_vertex>\n  #include <skinnormal_vertex>\n #endif\n #include <begin_vertex>\n #include <morphtarget_vertex>\n #include <skinning_vertex>\n\
 #include <displacementmap_vertex>\n #include <project_vertex>\n #include <worldpos_vertex>\n #include <clipping_planes_vertex>\n vWorldPosition = worldPosition.xyz\
;\n}",rM="#define DISTANCE\nuniform vec3 referencePosition;\nuniform float nearDistance;\nuniform float farDistance;\nvarying vec3 vWorldPosition;\n#include <common>\
\n#include <uv_pars_fragment>\n#include <map_pars_fragment>\n#include <alphamap_pars_fragment>\n#include <alphatest_pars_fragment>\n#include <alphahash_pars_fragment\
>\n#include <clipping_planes_pars_fragment>\nvoid main() {\n vec4 diffuseColor = vec4( 1.0 );\n #include <clipping_planes_fragment>\n #include <map_fragment>\n #inclu\
de <alphamap_fragment>\n #include <alphatest_fragment>\n #include <alphahash_fragment>\n float dist = length( vWorldPosition - referencePosition );\n dist = ( dist \
- nearDistance ) / ( farDistance - nearDistance );\n dist = saturate( dist );\n gl_FragColor = vec4( dist, 0.0, 0.0, 1.0 );\n}",oM="varying vec3 vWorldDirection\
;\n#include <common>\nvoid main() {\n vWorldDirection = transformDirection( position, modelMatrix );\n #include <begin_vertex>\n #include <project_vertex>\n}",aM="\
uniform sampler2D tEquirect;\nvarying vec3 vWorldDirection;\n#include <common>\nvoid main() {\n vec3 direction = normalize( vWorldDirection );\n vec2 sampleUV = equi\
rectUv( direction );\n gl_FragColor = texture2D( tEquirect, sampleUV );\n #include <tonemapping_fragment>\n #include <colorspace_fragment>\n}",lM="uniform float\
 scale;\nattribute float lineDistance;\nvarying float vLineDistance;\n#include <common>\n#include <uv_pars_vertex>\n#include <color_pars_vertex>\n#include <fog_pars_v\
ertex>\n#include <morphtarget_pars_vertex>\n#include <logdepthbuf_pars_vertex>\n#include <clipping_planes_pars_vertex>\nvoid main() {\n vLineDistance = scale * lineD\
istance;\n #include <uv_vertex>\n #include <color_vertex>\n #include <morphinstance_vertex>\n #include <morphcolor_vertex>\n #include <begin_vertex>\n #include <morph\
target_vertex>\n #include <project_vertex>\n #include <logdepthbuf_vertex>\n #include <clipping_planes_vertex>\n #include <fog_vertex>\n}",cM="uniform vec3 diff\
use;\nuniform float opacity;\nuniform float dashSize;\nuniform float totalSize;\nvarying float vLineDistance;\n#include <common>\n#include <color_pars_fragment>\n#incl\
ude <uv_pars_fragment>\n#include <map_pars_fragment>\n#include <fog_pars_fragment>\n#include <logdepthbuf_pars_fragment>\n#include <clipping_planes_pars_fragment>\nv\
oid main() {\n vec4 diffuseColor = vec4( diffuse, opacity );\n #include <clipping_planes_fragment>\n if ( mod( vLineDistance, totalSize ) > dashSize ) {\n  discard;\
\n }\n vec3 outgoingLight = vec3( 0.0 );\n #include <logdepthbuf_fragment>\n #include <map_fragment>\n #include <color_fragment>\n outgoingLight = diffuseColor.rgb;\n \
#include <opaque_fragment>\n #include <tonemapping_fragment>\n #include <colorspace_fragment>\n #include <fog_fragment>\n #include <premultiplied_alpha_fragment>\n}",
hM="#include <common>\n#include <batching_pars_vertex>\n#include <uv_pars_vertex>\n#include <envmap_pars_vertex>\n#include <color_pars_vertex>\n#include <fog_pars_ve\
rtex>\n#include <morphtarget_pars_vertex>\n#include <skinning_pars_vertex>\n#include <logdepthbuf_pars_vertex>\n#include <clipping_planes_pars_vertex>\nvoid main() {\
\n #include <uv_vertex>\n #include <color_vertex>\n #include <morphinstance_vertex>\n #include <morphcolor_vertex>\n #include <batching_vertex>\n #if defined ( USE_EN\
VMAP ) || defined ( USE_SKINNING )\n  #include <beginnormal_vertex>\n  #include <morphnormal_vertex>\n  #include <skinbase_vertex>\n  #include <skinnormal_vertex>\n \
 #include <defaultnormal_vertex>\n #endif\n #include <begin_vertex>\n #include <morphtarget_vertex>\n #include <skinning_vertex>\n #include <project_vertex>\n #includ\
e <logdepthbuf_vertex>\n #include <clipping_planes_vertex>\n #include <worldpos_vertex>\n #include <envmap_vertex>\n #include <fog_vertex>\n}",uM="uniform vec3 \
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
ent>\n}",dM="#define LAMBERT\nvarying vec3 vViewPosition;\n#include <common>\n#include <batching_pars_vertex>\n#include <uv_pars_vertex>\n#include <displacementmap_p\
ars_vertex>\n#include <envmap_pars_vertex>\n#include <color_pars_vertex>\n#include <fog_pars_vertex>\n#include <normal_pars_vertex>\n#include <morphtarget_pars_verte\
x>\n#include <skinning_pars_vertex>\n#include <shadowmap_pars_vertex>\n#include <logdepthbuf_pars_vertex>\n#include <clipping_planes_pars_vertex>\nvoid main() {\n #in\
clude <uv_vertex>\n #include <color_vertex>\n #include <morphinstance_vertex>\n #include <morphcolor_vertex>\n #include <batching_vertex>\n #include <beginnormal_ver\
tex>\n #include <morphnormal_vertex>\n #include <skinbase_vertex>\n #include <skinnormal_vertex>\n #include <defaultnormal_vertex>\n #include <normal_vertex>\n #inclu\
de <begin_vertex>\n #include <morphtarget_vertex>\n #include <skinning_vertex>\n #include <displacementmap_vertex>\n #include <project_vertex>\n #include <logdepthbu\
f_vertex>\n #include <clipping_planes_vertex>\n vViewPosition = - mvPosition.xyz;\n #include <worldpos_vertex>\n #include <envmap_vertex>\n #include <shadowmap_verte\
x>\n #include <fog_vertex>\n}",fM="#define LAMBERT\nuniform vec3 diffuse;\nuniform vec3 emissive;\nuniform float opacity;\n#include <common>\n#include <dithering_par\
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
 <premultiplied_alpha_fragment>\n #include <dithering_fragment>\n}",pM="#define MATCAP\nvarying vec3 vViewPosition;\n#include <common>\n#include <batching_pars_ver\
tex>\n#include <uv_pars_vertex>\n#include <color_pars_vertex>\n#include <displacementmap_pars_vertex>\n#include <fog_pars_vertex>\n#include <normal_pars_vertex>\n#inc\
lude <morphtarget_pars_vertex>\n#include <skinning_pars_vertex>\n#include <logdepthbuf_pars_vertex>\n#include <clipping_planes_pars_vertex>\nvoid main() {\n #include\
 <uv_vertex>\n #include <color_vertex>\n #include <morphinstance_vertex>\n #include <morphcolor_vertex>\n #include <batching_vertex>\n #include <beginnormal_vertex>\n\
 #include <morphnormal_vertex>\n #include <skinbase_vertex>\n #include <skinnormal_vertex>\n #include <defaultnormal_vertex>\n #include <normal_vertex>\n #include <b\
egin_vertex>\n #include <morphtarget_vertex>\n #include <skinning_vertex>\n #include <displacementmap_vertex>\n #include <project_vertex>\n #include <logdepthbuf_ver\
tex>\n #include <clipping_planes_vertex>\n #include <fog_vertex>\n vViewPosition = - mvPosition.xyz;\n}",mM="#define MATCAP\nuniform vec3 diffuse;\nuniform float \
opacity;\nuniform sampler2D matcap;\nvarying vec3 vViewPosition;\n#include <common>\n#include <dithering_pars_fragment>\n#include <color_pars_fragment>\n#include <uv_\
pars_fragment>\n#include <map_pars_fragment>\n#include <alphamap_pars_fragment>\n#include <alphatest_pars_fragment>\n#include <alphahash_pars_fragment>\n#include <fo\
g_pars_fragment>\n#include <normal_pars_fragment>\n#include <bumpmap_pars_fragment>\n#include <normalmap_pars_fragment>\n#include <logdepthbuf_pars_fragment>\n#inclu\
de <clipping_planes_pars_fragment>\nvoid main() {\n vec4 diffuseColor = vec4( diffuse, opacity );\n #include <clipping_planes_fragment>\n #include <logdepthbuf_frag\
ment>\n #include <map_fragment>\n #include <color_fragment>\n #include <alphamap_fragment>\n #include <alphatest_fragment>\n #include <alphahash_fragment>\n #include \
<normal_fragment_begin>\n #include <normal_fragment_maps>\n vec3 viewDir = normalize( vViewPosition );\n vec3 x = normalize( vec3( viewDir.z, 0.0, - viewDir.x ) );\
\n vec3 y = cross( viewDir, x );\n vec2 uv = vec2( dot( x, normal ), dot( y, normal ) ) * 0.495 + 0.5;\n #ifdef USE_MATCAP\n  vec4 matcapColor = texture2D( matcap, \
uv );\n #else\n  vec4 matcapColor = vec4( vec3( mix( 0.2, 0.8, uv.y ) ), 1.0 );\n #endif\n vec3 outgoingLight = diffuseColor.rgb * matcapColor.rgb;\n #include <opaqu\
e_fragment>\n #include <tonemapping_fragment>\n #include <colorspace_fragment>\n #include <fog_fragment>\n #include <premultiplied_alpha_fragment>\n #include <dither\
ing_fragment>\n}",gM="#define NORMAL\n#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )\n varying vec3 vViewPosition;\n\
#endif\n#include <common>\n#include <batching_pars_vertex>\n#include <uv_pars_vertex>\n#include <displacementmap_pars_vertex>\n#include <normal_pars_vertex>\n#include\
 <morphtarget_pars_vertex>\n#include <skinning_pars_vertex>\n#include <logdepthbuf_pars_vertex>\n#include <clipping_planes_pars_vertex>\nvoid main() {\n #include <uv\
_vertex>\n #include <batching_vertex>\n #include <beginnormal_vertex>\n #include <morphinstance_vertex>\n #include <morphnormal_vertex>\n #include <skinbase_vertex>\n\
 #include <skinnormal_vertex>\n #include <defaultnormal_vertex>\n #include <normal_vertex>\n #include <begin_vertex>\n #include <morphtarget_vertex>\n #include <skin\
ning_vertex>\n #include <displacementmap_vertex>\n #include <project_vertex>\n #include <logdepthbuf_vertex>\n #include <clipping_planes_vertex>\n#if defined( FLAT_S\
HADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )\n vViewPosition = - mvPosition.xyz;\n#endif\n}",_M="#define NORMAL\nuniform float opac\
ity;\n#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )\n varying vec3 vViewPosition;\n#endif\n#include <uv_pars_fragmen\
t>\n#include <normal_pars_fragment>\n#include <bumpmap_pars_fragment>\n#include <normalmap_pars_fragment>\n#include <logdepthbuf_pars_fragment>\n#include <clipping_p\
lanes_pars_fragment>\nvoid main() {\n vec4 diffuseColor = vec4( 0.0, 0.0, 0.0, opacity );\n #include <clipping_planes_fragment>\n #include <logdepthbuf_fragment>\n #\
include <normal_fragment_begin>\n #include <normal_fragment_maps>\n gl_FragColor = vec4( normalize( normal ) * 0.5 + 0.5, diffuseColor.a );\n #ifdef OPAQUE\n  gl_Fr\
agColor.a = 1.0;\n #endif\n}",xM="#define PHONG\nvarying vec3 vViewPosition;\n#include <common>\n#include <batching_pars_vertex>\n#include <uv_pars_vertex>\n#include\
 <displacementmap_pars_vertex>\n#include <envmap_pars_vertex>\n#include <color_pars_vertex>\n#include <fog_pars_vertex>\n#include <normal_pars_vertex>\n#include <mor\
phtarget_pars_vertex>\n#include <skinning_pars_vertex>\n#include <shadowmap_pars_vertex>\n#include <logdepthbuf_pars_vertex>\n#include <clipping_planes_pars_vertex>\
\nvoid main() {\n #include <uv_vertex>\n #include <color_vertex>\n #include <morphcolor_vertex>\n #include <batching_vertex>\n #include <beginnormal_vertex>\n #include\
 <morphinstance_vertex>\n #include <morphnormal_vertex>\n #include <skinbase_vertex>\n #include <skinnormal_vertex>\n #include <defaultnormal_vertex>\n #include <nor\
mal_vertex>\n #include <begin_vertex>\n #include <morphtarget_vertex>\n #include <skinning_vertex>\n #include <displacementmap_vertex>\n #include <project_vertex>\n #\
include <logdepthbuf_vertex>\n #include <clipping_planes_vertex>\n vViewPosition = - mvPosition.xyz;\n #include <worldpos_vertex>\n #include <envmap_vertex>\n #inclu\
de <shadowmap_vertex>\n #include <fog_vertex>\n}",yM="#define PHONG\nuniform vec3 diffuse;\nuniform vec3 emissive;\nuniform vec3 specular;\nuniform float shininess;\
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
#include <dithering_fragment>\n}",vM="#define STANDARD\nvarying vec3 vViewPosition;\n#ifdef USE_TRANSMISSION\n varying vec3 vWorldPosition;\n#endif\n#include <common\
>\n#include <batching_pars_vertex>\n#include <uv_pars_vertex>\n#include <displacementmap_pars_vertex>\n#include <color_pars_vertex>\n#include <fog_pars_vertex>\n#incl\
ude <normal_pars_vertex>\n#include <morphtarget_pars_vertex>\n#include <skinning_pars_vertex>\n#include <shadowmap_pars_vertex>\n#include <logdepthbuf_pars_vertex>\n\
#include <clipping_planes_pars_vertex>\nvoid main() {\n #include <uv_vertex>\n #include <color_vertex>\n #include <morphinstance_vertex>\n #include <morphcolor_verte\
x>\n #include <batching_vertex>\n #include <beginnormal_vertex>\n #include <morphnormal_vertex>\n #include <skinbase_vertex>\n #include <skinnormal_vertex>\n #include\
 <defaultnormal_vertex>\n #include <normal_vertex>\n #include <begin_vertex>\n #include <morphtarget_vertex>\n #include <skinning_vertex>\n #include <displacementmap\
_vertex>\n #include <project_vertex>\n #include <logdepthbuf_vertex>\n #include <clipping_planes_vertex>\n vViewPosition = - mvPosition.xyz;\n #include <worldpos_ver\
tex>\n #include <shadowmap_vertex>\n #include <fog_vertex>\n#ifdef USE_TRANSMISSION\n vWorldPosition = worldPosition.xyz;\n#endif\n}",bM="#define STANDARD\n#ifde\
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
>\n #include <fog_fragment>\n #include <premultiplied_alpha_fragment>\n #include <dithering_fragment>\n}",MM="#define TOON\nvarying vec3 vViewPosition;\n#include \
<common>\n#include <batching_pars_vertex>\n#include <uv_pars_vertex>\n#include <displacementmap_pars_vertex>\n#include <color_pars_vertex>\n#include <fog_pars_vertex\
>\n#include <normal_pars_vertex>\n#include <morphtarget_pars_vertex>\n#include <skinning_pars_vertex>\n#include <shadowmap_pars_vertex>\n#include <logdepthbuf_pars_v\
ertex>\n#include <clipping_planes_pars_vertex>\nvoid main() {\n #include <uv_vertex>\n #include <color_vertex>\n #include <morphinstance_vertex>\n #include <morphcolo\
r_vertex>\n #include <batching_vertex>\n #include <beginnormal_vertex>\n #include <morphnormal_vertex>\n #include <skinbase_vertex>\n #include <skinnormal_vertex>\n #\
include <defaultnormal_vertex>\n #include <normal_vertex>\n #include <begin_vertex>\n #include <morphtarget_vertex>\n #include <skinning_vertex>\n #include <displace\
mentmap_vertex>\n #include <project_vertex>\n #include <logdepthbuf_vertex>\n #include <clipping_planes_vertex>\n vViewPosition = - mvPosition.xyz;\n #include <world\
pos_vertex>\n #include <shadowmap_vertex>\n #include <fog_vertex>\n}",SM="#define TOON\nuniform vec3 diffuse;\nuniform vec3 emissive;\nuniform float opacity;\n#incl\
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
agment>\n #include <premultiplied_alpha_fragment>\n #include <dithering_fragment>\n}",wM="uniform float size;\nuniform float scale;\n#include <common>\n#include <c\
olor_pars_vertex>\n#include <fog_pars_vertex>\n#include <morphtarget_pars_vertex>\n#include <logdepthbuf_pars_vertex>\n#include <clipping_planes_pars_vertex>\n#ifdef\
 USE_POINTS_UV\n varying vec2 vUv;\n uniform mat3 uvTransform;\n#endif\nvoid main() {\n #ifdef USE_POINTS_UV\n  vUv = ( uvTransform * vec3( uv, 1 ) ).xy;\n #endif\n #in\
clude <color_vertex>\n #include <morphinstance_vertex>\n #include <morphcolor_vertex>\n #include <begin_vertex>\n #include <morphtarget_vertex>\n #include <project_v\
ertex>\n gl_PointSize = size;\n #ifdef USE_SIZEATTENUATION\n  bool isPerspective = isPerspectiveMatrix( projectionMatrix );\n  if ( isPerspective ) gl_PointSize *= \
( scale / - mvPosition.z );\n #endif\n #include <logdepthbuf_vertex>\n #include <clipping_planes_vertex>\n #include <worldpos_vertex>\n #include <fog_vertex>\n}",
TM="uniform vec3 diffuse;\nuniform float opacity;\n#include <common>\n#include <color_pars_fragment>\n#include <map_particle_pars_fragment>\n#include <alphatest_pars\
_fragment>\n#include <alphahash_pars_fragment>\n#include <fog_pars_fragment>\n#include <logdepthbuf_pars_fragment>\n#include <clipping_planes_pars_fragment>\nvoid ma\
in() {\n vec4 diffuseColor = vec4( diffuse, opacity );\n #include <clipping_planes_fragment>\n vec3 outgoingLight = vec3( 0.0 );\n #include <logdepthbuf_fragment>\n \
#include <map_particle_fragment>\n #include <color_fragment>\n #include <alphatest_fragment>\n #include <alphahash_fragment>\n outgoingLight = diffuseColor.rgb;\n #i\
nclude <opaque_fragment>\n #include <tonemapping_fragment>\n #include <colorspace_fragment>\n #include <fog_fragment>\n #include <premultiplied_alpha_fragment>\n}",
AM="#include <common>\n#include <batching_pars_vertex>\n#include <fog_pars_vertex>\n#include <morphtarget_pars_vertex>\n#include <skinning_pars_vertex>\n#include <lo\
gdepthbuf_pars_vertex>\n#include <shadowmap_pars_vertex>\nvoid main() {\n #include <batching_vertex>\n #include <beginnormal_vertex>\n #include <morphinstance_vertex\
>\n #include <morphnormal_vertex>\n #include <skinbase_vertex>\n #include <skinnormal_vertex>\n #include <defaultnormal_vertex>\n #include <begin_vertex>\n #include <\
morphtarget_vertex>\n #include <skinning_vertex>\n #include <project_vertex>\n #include <logdepthbuf_vertex>\n #include <worldpos_vertex>\n #include <shadowmap_verte\
x>\n #include <fog_vertex>\n}",EM="uniform vec3 color;\nuniform float opacity;\n#include <common>\n#include <fog_pars_fragment>\n#include <bsdfs>\n#include <lights_p\
ars_begin>\n#include <logdepthbuf_pars_fragment>\n#include <shadowmap_pars_fragment>\n#include <shadowmask_pars_fragment>\nvoid main() {\n #include <logdepthbuf_frag\
ment>\n gl_FragColor = vec4( color, opacity * ( 1.0 - getShadowMask() ) );\n #include <tonemapping_fragment>\n #include <colorspace_fragment>\n #include <fog_fragme\
nt>\n #include <premultiplied_alpha_fragment>\n}",CM="uniform float rotation;\nuniform vec2 center;\n#include <common>\n#include <uv_pars_vertex>\n#include <fog_par\
s_vertex>\n#include <logdepthbuf_pars_vertex>\n#include <clipping_planes_pars_vertex>\nvoid main() {\n #include <uv_vertex>\n vec4 mvPosition = modelViewMatrix[ 3 ];\
\n vec2 scale = vec2( length( modelMatrix[ 0 ].xyz ), length( modelMatrix[ 1 ].xyz ) );\n #ifndef USE_SIZEATTENUATION\n  bool isPerspective = isPerspectiveMatrix( \
projectionMatrix );\n  if ( isPerspective ) scale *= - mvPosition.z;\n #endif\n vec2 alignedPosition = ( position.xy - ( center - vec2( 0.5 ) ) ) * scale;\n vec2 ro\
tatedPosition;\n rotatedPosition.x = cos( rotation ) * alignedPosition.x - sin( rotation ) * alignedPosition.y;\n rotatedPosition.y = sin( rotation ) * alignedPos\
ition.x + cos( rotation ) * alignedPosition.y;\n mvPosition.xy += rotatedPosition;\n gl_Position = projectionMatrix * mvPosition;\n #include <logdepthbuf_vertex>\n \
#include <clipping_planes_vertex>\n #include <fog_vertex>\n}",RM="uniform vec3 diffuse;\nuniform float opacity;\n#include <common>\n#include <uv_pars_fragment>\n#in\
clude <map_pars_fragment>\n#include <alphamap_pars_fragment>\n#include <alphatest_pars_fragment>\n#include <alphahash_pars_fragment>\n#include <fog_pars_fragment>\n#\
include <logdepthbuf_pars_fragment>\n#include <clipping_planes_pars_fragment>\nvoid main() {\n vec4 diffuseColor = vec4( diffuse, opacity );\n #include <clipping_pl\
anes_fragment>\n vec3 outgoingLight = vec3( 0.0 );\n #include <logdepthbuf_fragment>\n #include <map_fragment>\n #include <alphamap_fragment>\n #include <alphatest_f\
ragment>\n #include <alphahash_fragment>\n outgoingLight = diffuseColor.rgb;\n #include <opaque_fragment>\n #include <tonemapping_fragment>\n #include <colorspace_fr\
agment>\n #include <fog_fragment>\n}",ht={alphahash_fragment:Ky,alphahash_pars_fragment:jy,alphamap_fragment:Qy,alphamap_pars_fragment:ev,alphatest_fragment:tv,
alphatest_pars_fragment:nv,aomap_fragment:iv,aomap_pars_fragment:sv,batching_pars_vertex:rv,batching_vertex:ov,begin_vertex:av,beginnormal_vertex:lv,bsdfs:cv,iridescence_fragment:hv,
bumpmap_pars_fragment:uv,clipping_planes_fragment:dv,clipping_planes_pars_fragment:fv,clipping_planes_pars_vertex:pv,clipping_planes_vertex:mv,color_fragment:gv,
color_pars_fragment:_v,color_pars_vertex:xv,color_vertex:yv,common:vv,defaultnormal_vertex:bv,displacementmap_pars_vertex:Mv,displacementmap_vertex:Sv,emissivemap_fragment:wv,
emissivemap_pars_fragment:Tv,colorspace_fragment:Av,colorspace_pars_fragment:Ev,envmap_fragment:Cv,envmap_common_pars_fragment:Rv,envmap_pars_fragment:Pv,envmap_pars_vertex:Iv,
envmap_physical_pars_fragment:Gv,envmap_vertex:Lv,fog_vertex:Nv,fog_pars_vertex:Dv,fog_fragment:Uv,fog_pars_fragment:Fv,gradientmap_pars_fragment:Ov,lightmap_pars_fragment:Bv,
lights_lambert_fragment:kv,lights_lambert_pars_fragment:zv,lights_pars_begin:Vv,lights_toon_fragment:Hv,lights_toon_pars_fragment:Wv,lights_phong_fragment:Xv,lights_phong_pars_fragment:$v,
lights_physical_fragment:qv,lights_physical_pars_fragment:Yv,lights_fragment_begin:Zv,lights_fragment_maps:Jv,lights_fragment_end:Kv,lightprobes_pars_fragment:jv,
logdepthbuf_fragment:Qv,logdepthbuf_pars_fragment:eb,logdepthbuf_pars_vertex:tb,logdepthbuf_vertex:nb,map_fragment:ib,map_pars_fragment:sb,map_particle_fragment:rb,
map_particle_pars_fragment:ob,metalnessmap_fragment:ab,metalnessmap_pars_fragment:lb,morphinstance_vertex:cb,morphcolor_vertex:hb,morphnormal_vertex:ub,morphtarget_pars_vertex:db,
morphtarget_vertex:fb,normal_fragment_begin:pb,normal_fragment_maps:mb,normal_pars_fragment:gb,normal_pars_vertex:_b,normal_vertex:xb,normalmap_pars_fragment:yb,
clearcoat_normal_fragment_begin:vb,clearcoat_normal_fragment_maps:bb,clearcoat_pars_fragment:Mb,iridescence_pars_fragment:Sb,opaque_fragment:wb,packing:Tb,premultiplied_alpha_fragment:Ab,
project_vertex:Eb,dithering_fragment:Cb,dithering_pars_fragment:Rb,roughnessmap_fragment:Pb,roughnessmap_pars_fragment:Ib,shadowmap_pars_fragment:Lb,shadowmap_pars_vertex:Nb,
shadowmap_vertex:Db,shadowmask_pars_fragment:Ub,skinbase_vertex:Fb,skinning_pars_vertex:Ob,skinning_vertex:Bb,skinnormal_vertex:kb,specularmap_fragment:zb,specularmap_pars_fragment:Vb,
tonemapping_fragment:Gb,tonemapping_pars_fragment:Hb,transmission_fragment:Wb,transmission_pars_fragment:Xb,uv_pars_fragment:$b,uv_pars_vertex:qb,uv_vertex:Yb,worldpos_vertex:Zb,
background_vert:Jb,background_frag:Kb,backgroundCube_vert:jb,backgroundCube_frag:Qb,cube_vert:eM,cube_frag:tM,depth_vert:nM,depth_frag:iM,distance_vert:sM,distance_frag:rM,
equirect_vert:oM,equirect_frag:aM,linedashed_vert:lM,linedashed_frag:cM,meshbasic_vert:hM,meshbasic_frag:uM,meshlambert_vert:dM,meshlambert_frag:fM,meshmatcap_vert:pM,
meshmatcap_frag:mM,meshnormal_vert:gM,meshnormal_frag:_M,meshphong_vert:xM,meshphong_frag:yM,meshphysical_vert:vM,meshphysical_frag:bM,meshtoon_vert:MM,meshtoon_frag:SM,
points_vert:wM,points_frag:TM,shadow_vert:AM,shadow_frag:EM,sprite_vert:CM,sprite_frag:RM},Le={common:{diffuse:{value:new rt(16777215)},opacity:{value:1},map:{value:null},
mapTransform:{value:new Qe},alphaMap:{value:null},alphaMapTransform:{value:new Qe},alphaTest:{value:0}},specularmap:{specularMap:{value:null},specularMapTransform:{
value:new Qe}},envmap:{envMap:{value:null},envMapRotation:{value:new Qe},reflectivity:{value:1},ior:{value:1.5},refractionRatio:{value:.98},dfgLUT:{value:null}},
aomap:{aoMap:{value:null},aoMapIntensity:{value:1},aoMapTransform:{value:new Qe}},lightmap:{lightMap:{value:null},lightMapIntensity:{value:1},lightMapTransform:{
value:new Qe}},bumpmap:{bumpMap:{value:null},bumpMapTransform:{value:new Qe},bumpScale:{value:1}},normalmap:{normalMap:{value:null},normalMapTransform:{value:new Qe},
normalScale:{value:new st(1,1)}},displacementmap:{displacementMap:{value:null},displacementMapTransform:{value:new Qe},displacementScale:{value:1},displacementBias:{
value:0}},emissivemap:{emissiveMap:{value:null},emissiveMapTransform:{value:new Qe}},metalnessmap:{metalnessMap:{value:null},metalnessMapTransform:{value:new Qe}},
roughnessmap:{roughnessMap:{value:null},roughnessMapTransform:{value:new Qe}},gradientmap:{gradientMap:{value:null}},fog:{fogDensity:{value:25e-5},fogNear:{value:1},
fogFar:{value:2e3},fogColor:{value:new rt(16777215)}},lights:{ambientLightColor:{value:[]},lightProbe:{value:[]},sunLights:{value:[],properties:{direction:{},color:{}}},
sunLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},sunShadowMatrix:{value:[]},sunShadowCascade:{
value:[]},directionalLights:{value:[],properties:{direction:{},color:{}}},directionalLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},
shadowRadius:{},shadowMapSize:{}}},directionalShadowMatrix:{value:[]},spotLights:{value:[],properties:{color:{},position:{},direction:{},distance:{},coneCos:{},
penumbraCos:{},decay:{}}},spotLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},spotLightMap:{
value:[]},spotLightMatrix:{value:[]},pointLights:{value:[],properties:{color:{},position:{},decay:{},distance:{}}},pointLightShadows:{value:[],properties:{shadowIntensity:1,
shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{},shadowCameraNear:{},shadowCameraFar:{}}},pointShadowMatrix:{value:[]},hemisphereLights:{value:[],
properties:{direction:{},skyColor:{},groundColor:{}}},rectAreaLights:{value:[],properties:{color:{},position:{},width:{},height:{}}},ltc_1:{value:null},ltc_2:{value:null},
probesSH:{value:[]},probesMin:{value:[]},probesMax:{value:[]},probesResolution:{value:[]}},points:{diffuse:{value:new rt(16777215)},opacity:{value:1},size:{value:1},
scale:{value:1},map:{value:null},alphaMap:{value:null},alphaMapTransform:{value:new Qe},alphaTest:{value:0},uvTransform:{value:new Qe}},sprite:{diffuse:{value:new rt(
16777215)},opacity:{value:1},center:{value:new st(.5,.5)},rotation:{value:0},map:{value:null},mapTransform:{value:new Qe},alphaMap:{value:null},alphaMapTransform:{
value:new Qe},alphaTest:{value:0}}},Xi={basic:{uniforms:Rn([Le.common,Le.specularmap,Le.envmap,Le.aomap,Le.lightmap,Le.fog]),vertexShader:ht.meshbasic_vert,fragmentShader:ht.
meshbasic_frag},lambert:{uniforms:Rn([Le.common,Le.specularmap,Le.envmap,Le.aomap,Le.lightmap,Le.emissivemap,Le.bumpmap,Le.normalmap,Le.displacementmap,Le.fog,Le.
lights,{emissive:{value:new rt(0)},envMapIntensity:{value:1}}]),vertexShader:ht.meshlambert_vert,fragmentShader:ht.meshlambert_frag},phong:{uniforms:Rn([Le.common,
Le.specularmap,Le.envmap,Le.aomap,Le.lightmap,Le.emissivemap,Le.bumpmap,Le.normalmap,Le.displacementmap,Le.fog,Le.lights,{emissive:{value:new rt(0)},specular:{value:new rt(
1118481)},shininess:{value:30},envMapIntensity:{value:1}}]),vertexShader:ht.meshphong_vert,fragmentShader:ht.meshphong_frag},standard:{uniforms:Rn([Le.common,Le.
envmap,Le.aomap,Le.lightmap,Le.emissivemap,Le.bumpmap,Le.normalmap,Le.displacementmap,Le.roughnessmap,Le.metalnessmap,Le.fog,Le.lights,{emissive:{value:new rt(0)},
roughness:{value:1},metalness:{value:0},envMapIntensity:{value:1}}]),vertexShader:ht.meshphysical_vert,fragmentShader:ht.meshphysical_frag},toon:{uniforms:Rn([Le.
common,Le.aomap,Le.lightmap,Le.emissivemap,Le.bumpmap,Le.normalmap,Le.displacementmap,Le.gradientmap,Le.fog,Le.lights,{emissive:{value:new rt(0)}}]),vertexShader:ht.
meshtoon_vert,fragmentShader:ht.meshtoon_frag},matcap:{uniforms:Rn([Le.common,Le.bumpmap,Le.normalmap,Le.displacementmap,Le.fog,{matcap:{value:null}}]),vertexShader:ht.
meshmatcap_vert,fragmentShader:ht.meshmatcap_frag},points:{uniforms:Rn([Le.points,Le.fog]),vertexShader:ht.points_vert,fragmentShader:ht.points_frag},dashed:{uniforms:Rn(
[Le.common,Le.fog,{scale:{value:1},dashSize:{value:1},totalSize:{value:2}}]),vertexShader:ht.linedashed_vert,fragmentShader:ht.linedashed_frag},depth:{uniforms:Rn(
[Le.common,Le.displacementmap]),vertexShader:ht.depth_vert,fragmentShader:ht.depth_frag},normal:{uniforms:Rn([Le.common,Le.bumpmap,Le.normalmap,Le.displacementmap,
{opacity:{value:1}}]),vertexShader:ht.meshnormal_vert,fragmentShader:ht.meshnormal_frag},sprite:{uniforms:Rn([Le.sprite,Le.fog]),vertexShader:ht.sprite_vert,fragmentShader:ht.
sprite_frag},background:{uniforms:{uvTransform:{value:new Qe},t2D:{value:null},backgroundIntensity:{value:1}},vertexShader:ht.background_vert,fragmentShader:ht.
background_frag},backgroundCube:{uniforms:{envMap:{value:null},backgroundBlurriness:{value:0},backgroundIntensity:{value:1},backgroundRotation:{value:new Qe}},vertexShader:ht.
backgroundCube_vert,fragmentShader:ht.backgroundCube_frag},cube:{uniforms:{tCube:{value:null},tFlip:{value:-1},opacity:{value:1}},vertexShader:ht.cube_vert,fragmentShader:ht.
cube_frag},equirect:{uniforms:{tEquirect:{value:null}},vertexShader:ht.equirect_vert,fragmentShader:ht.equirect_frag},distance:{uniforms:Rn([Le.common,Le.displacementmap,
{referencePosition:{value:new V},nearDistance:{value:1},farDistance:{value:1e3}}]),vertexShader:ht.distance_vert,fragmentShader:ht.distance_frag},shadow:{uniforms:Rn(
[Le.lights,Le.fog,{color:{value:new rt(0)},opacity:{value:1}}]),vertexShader:ht.shadow_vert,fragmentShader:ht.shadow_frag}};Xi.physical={uniforms:Rn([Xi.standard.
uniforms,{clearcoat:{value:0},clearcoatMap:{value:null},clearcoatMapTransform:{value:new Qe},clearcoatNormalMap:{value:null},clearcoatNormalMapTransform:{value:new Qe},
clearcoatNormalScale:{value:new st(1,1)},clearcoatRoughness:{value:0},clearcoatRoughnessMap:{value:null},clearcoatRoughnessMapTransform:{value:new Qe},diffuseRoughness:{
value:0},diffuseRoughnessMap:{value:null},diffuseRoughnessMapTransform:{value:new Qe},dispersion:{value:0},retroreflectivity:{value:0},iridescence:{value:0},iridescenceMap:{
value:null},iridescenceMapTransform:{value:new Qe},iridescenceIOR:{value:1.3},iridescenceThicknessMinimum:{value:100},iridescenceThicknessMaximum:{value:400},iridescenceThicknessMap:{
value:null},iridescenceThicknessMapTransform:{value:new Qe},sheen:{value:0},sheenColor:{value:new rt(0)},sheenColorMap:{value:null},sheenColorMapTransform:{value:new Qe},
sheenRoughness:{value:1},sheenRoughnessMap:{value:null},sheenRoughnessMapTransform:{value:new Qe},transmission:{value:0},transmissionMap:{value:null},transmissionMapTransform:{
value:new Qe},transmissionSamplerSize:{value:new st},transmissionSamplerMap:{value:null},thickness:{value:0},thicknessMap:{value:null},thicknessMapTransform:{value:new Qe},
attenuationDistance:{value:0},attenuationColor:{value:new rt(0)},specularColor:{value:new rt(1,1,1)},specularColorMap:{value:null},specularColorMapTransform:{value:new Qe},
specularIntensity:{value:1},specularIntensityMap:{value:null},specularIntensityMapTransform:{value:new Qe},anisotropyVector:{value:new st},anisotropyMap:{value:null},
anisotropyMapTransform:{value:new Qe}}]),vertexShader:ht.meshphysical_vert,fragmentShader:ht.meshphysical_frag};var Gc={r:0,b:0,g:0},PM=new xt,Ng=new Qe;Ng.set(
-1,0,0,0,1,0,0,0,1);function IM(i,e,t,n,s,r){let o=new rt(0),a=s===!0?0:1,l,c,d=null,u=0,h=null;function f(y){let S=y.isScene===!0?y.background:null;if(S&&S.isTexture){
let b=y.backgroundBlurriness>0;S=e.get(S,b)}return S}function p(y){let S=!1,b=f(y);b===null?m(o,a):b&&b.isColor&&(m(b,1),S=!0);let C=i.xr.getEnvironmentBlendMode();
C==="additive"?t.buffers.color.setClear(0,0,0,1,r):C==="alpha-blend"&&t.buffers.color.setClear(0,0,0,0,r),(i.autoClear||S)&&(t.buffers.depth.setTest(!0),t.buffers.
depth.setMask(!0),t.buffers.color.setMask(!0),i.clear(i.autoClearColor,i.autoClearDepth,i.autoClearStencil))}function x(y,S){let b=f(S);b&&b.isCubeTexture?(c===
void 0&&(c=new ui(new Ds(1,1,1),new Vi({name:"BackgroundCubeMaterial",uniforms:cr(Xi.backgroundCube.uniforms),vertexShader:Xi.backgroundCube.vertexShader,fragmentShader:Xi.
backgroundCube.fragmentShader,side:zn,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),c.geometry.deleteAttribute("normal"),c.geometry.deleteAttribute("uv"),
c.onBeforeRender=function(C,w,_){this.matrixWorld.copyPosition(_.matrixWorld)},Object.defineProperty(c.material,"envMap",{get:function(){return this.uniforms.envMap.
value}}),n.update(c)),c.material.uniforms.envMap.value=b,c.material.uniforms.backgroundBlurriness.value=S.backgroundBlurriness,c.material.uniforms.backgroundIntensity.
value=S.backgroundIntensity,c.material.uniforms.backgroundRotation.value.setFromMatrix4(PM.makeRotationFromEuler(S.backgroundRotation)).transpose(),b.isRenderTargetTexture===
!1&&c.material.uniforms.backgroundRotation.value.premultiply(Ng),c.material.toneMapped=_t.getTransfer(b.colorSpace)!==At,(d!==b||u!==b.version||h!==i.toneMapping)&&
(c.material.needsUpdate=!0,d=b,u=b.version,h=i.toneMapping),c.layers.enableAll(),y.unshift(c,c.geometry,c.material,0,0,null)):b&&b.isTexture&&(l===void 0&&(l=new ui(
new na(2,2),new Vi({name:"BackgroundMaterial",uniforms:cr(Xi.background.uniforms),vertexShader:Xi.background.vertexShader,fragmentShader:Xi.background.fragmentShader,
side:ks,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),l.geometry.deleteAttribute("normal"),Object.defineProperty(l.material,"map",{get:function(){return this.
uniforms.t2D.value}}),n.update(l)),l.material.uniforms.t2D.value=b,l.material.uniforms.backgroundIntensity.value=S.backgroundIntensity,l.material.toneMapped=_t.
getTransfer(b.colorSpace)!==At,b.matrixAutoUpdate===!0&&b.updateMatrix(),l.material.uniforms.uvTransform.value.copy(b.matrix),(d!==b||u!==b.version||h!==i.toneMapping)&&
(l.material.needsUpdate=!0,d=b,u=b.version,h=i.toneMapping),l.layers.enableAll(),y.unshift(l,l.geometry,l.material,0,0,null))}function m(y,S){y.getRGB(Gc,sd(i)),
t.buffers.color.setClear(Gc.r,Gc.g,Gc.b,S,r)}function g(){c!==void 0&&(c.geometry.dispose(),c.material.dispose(),c=void 0),l!==void 0&&(l.geometry.dispose(),l.material.
dispose(),l=void 0)}return{getClearColor:function(){return o},setClearColor:function(y,S=1){o.set(y),a=S,m(o,a)},getClearAlpha:function(){return a},setClearAlpha:function(y){
a=y,m(o,a)},render:p,addToRenderList:x,dispose:g}}function LM(i,e){let t=i.getParameter(i.MAX_VERTEX_ATTRIBS),n={},s=h(null),r=s,o=!1;function a(I,F,z,D,G){let Y=!1,
W=u(I,D,z,F);r!==W&&(r=W,c(r.object)),Y=f(I,D,z,G),Y&&p(I,D,z,G),G!==null&&e.update(G,i.ELEMENT_ARRAY_BUFFER),(Y||o)&&(o=!1,b(I,F,z,D),G!==null&&i.bindBuffer(i.
ELEMENT_ARRAY_BUFFER,e.get(G).buffer))}function l(){return i.createVertexArray()}function c(I){return i.bindVertexArray(I)}function d(I){return i.deleteVertexArray(
I)}function u(I,F,z,D){let G=D.wireframe===!0,Y=n[F.id];Y===void 0&&(Y={},n[F.id]=Y);let W=I.isInstancedMesh===!0?I.id:0,ce=Y[W];ce===void 0&&(ce={},Y[W]=ce);let K=ce[z.
id];K===void 0&&(K={},ce[z.id]=K);let Q=K[G];return Q===void 0&&(Q=h(l()),K[G]=Q),Q}function h(I){let F=[],z=[],D=[];for(let G=0;G<t;G++)F[G]=0,z[G]=0,D[G]=0;return{
geometry:null,program:null,wireframe:!1,newAttributes:F,enabledAttributes:z,attributeDivisors:D,object:I,attributes:{},index:null}}function f(I,F,z,D){let G=r.attributes,
Y=F.attributes,W=0,ce=z.getAttributes();for(let K in ce)if(ce[K].location>=0){let se=G[K],de=Y[K];if(de===void 0&&(K==="instanceMatrix"&&I.instanceMatrix&&(de=I.
instanceMatrix),K==="instanceColor"&&I.instanceColor&&(de=I.instanceColor)),se===void 0||se.attribute!==de||de&&se.data!==de.data)return!0;W++}return r.attributesNum!==
W||r.index!==D}function p(I,F,z,D){let G={},Y=F.attributes,W=0,ce=z.getAttributes();for(let K in ce)if(ce[K].location>=0){let se=Y[K];se===void 0&&(K==="instanc\
eMatrix"&&I.instanceMatrix&&(se=I.instanceMatrix),K==="instanceColor"&&I.instanceColor&&(se=I.instanceColor));let de={};de.attribute=se,se&&se.data&&(de.data=se.
data),G[K]=de,W++}r.attributes=G,r.attributesNum=W,r.index=D}function x(){let I=r.newAttributes;for(let F=0,z=I.length;F<z;F++)I[F]=0}function m(I){g(I,0)}function g(I,F){
let z=r.newAttributes,D=r.enabledAttributes,G=r.attributeDivisors;z[I]=1,D[I]===0&&(i.enableVertexAttribArray(I),D[I]=1),G[I]!==F&&(i.vertexAttribDivisor(I,F),G[I]=
F)}function y(){let I=r.newAttributes,F=r.enabledAttributes;for(let z=0,D=F.length;z<D;z++)F[z]!==I[z]&&(i.disableVertexAttribArray(z),F[z]=0)}function S(I,F,z,D,G,Y,W){
W===!0?i.vertexAttribIPointer(I,F,z,G,Y):i.vertexAttribPointer(I,F,z,D,G,Y)}function b(I,F,z,D){x();let G=D.attributes,Y=z.getAttributes(),W=F.defaultAttributeValues;
for(let ce in Y){let K=Y[ce];if(K.location>=0){let Q=G[ce];if(Q===void 0&&(ce==="instanceMatrix"&&I.instanceMatrix&&(Q=I.instanceMatrix),ce==="instanceColor"&&I.
instanceColor&&(Q=I.instanceColor)),Q!==void 0){let se=Q.normalized,de=Q.itemSize,ue=e.get(Q);if(ue===void 0)continue;let ee=ue.buffer,me=ue.type,xe=ue.bytesPerElement,
Ee=me===i.INT||me===i.UNSIGNED_INT||Q.gpuType===sc;if(Q.isInterleavedBufferAttribute){let Me=Q.data,He=Me.isInterleavedBuffer===!0?Me.stride:Me.itemSize,nt=Q.offset;
if(Me.isInstancedInterleavedBuffer||Me.isInstancedBufferAttribute){for(let Ve=0;Ve<K.locationSize;Ve++)g(K.location+Ve,Me.meshPerAttribute);I.isInstancedMesh!==
!0&&D._maxInstanceCount===void 0&&(D._maxInstanceCount=Me.meshPerAttribute*Me.count)}else for(let Ve=0;Ve<K.locationSize;Ve++)m(K.location+Ve);i.bindBuffer(i.ARRAY_BUFFER,
ee);for(let Ve=0;Ve<K.locationSize;Ve++)S(K.location+Ve,de/K.locationSize,me,se,He*xe,(nt+de/K.locationSize*Ve)*xe,Ee)}else{if(Q.isInstancedBufferAttribute){for(let Me=0;Me<
K.locationSize;Me++)g(K.location+Me,Q.meshPerAttribute);I.isInstancedMesh!==!0&&D._maxInstanceCount===void 0&&(D._maxInstanceCount=Q.meshPerAttribute*Q.count)}else
for(let Me=0;Me<K.locationSize;Me++)m(K.location+Me);i.bindBuffer(i.ARRAY_BUFFER,ee);for(let Me=0;Me<K.locationSize;Me++)S(K.location+Me,de/K.locationSize,me,se,
de*xe,de/K.locationSize*Me*xe,Ee)}}else if(W!==void 0){let se=W[ce];if(se!==void 0)switch(se.length){case 2:i.vertexAttrib2fv(K.location,se);break;case 3:i.vertexAttrib3fv(
K.location,se);break;case 4:i.vertexAttrib4fv(K.location,se);break;default:i.vertexAttrib1fv(K.location,se)}}}}y()}function C(){R();for(let I in n){let F=n[I];for(let z in F){
let D=F[z];for(let G in D){let Y=D[G];for(let W in Y)d(Y[W].object),delete Y[W];delete D[G]}}delete n[I]}}function w(I){if(n[I.id]===void 0)return;let F=n[I.id];
for(let z in F){let D=F[z];for(let G in D){let Y=D[G];for(let W in Y)d(Y[W].object),delete Y[W];delete D[G]}}delete n[I.id]}function _(I){for(let F in n){let z=n[F];
for(let D in z){let G=z[D];if(G[I.id]===void 0)continue;let Y=G[I.id];for(let W in Y)d(Y[W].object),delete Y[W];delete G[I.id]}}}function M(I){for(let F in n){let z=n[F],
D=I.isInstancedMesh===!0?I.id:0,G=z[D];if(G!==void 0){for(let Y in G){let W=G[Y];for(let ce in W)d(W[ce].object),delete W[ce];delete G[Y]}delete z[D],Object.keys(
z).length===0&&delete n[F]}}}function R(){P(),o=!0,r!==s&&(r=s,c(r.object))}function P(){s.geometry=null,s.program=null,s.wireframe=!1}return{setup:a,reset:R,resetDefaultState:P,
dispose:C,releaseStatesOfGeometry:w,releaseStatesOfObject:M,releaseStatesOfProgram:_,initAttributes:x,enableAttribute:m,disableUnusedAttributes:y}}function NM(i,e,t){
let n;function s(l){n=l}function r(l,c){i.drawArrays(n,l,c),t.update(c,n,1)}function o(l,c,d){d!==0&&(i.drawArraysInstanced(n,l,c,d),t.update(c,n,d))}function a(l,c,d){
if(d===0)return;e.get("WEBGL_multi_draw").multiDrawArraysWEBGL(n,l,0,c,0,d);let h=0;for(let f=0;f<d;f++)h+=c[f];t.update(h,n,1)}this.setMode=s,this.render=r,this.
renderInstances=o,this.renderMultiDraw=a}function DM(i,e,t,n){let s;function r(){if(s!==void 0)return s;if(e.has("EXT_texture_filter_anisotropic")===!0){let _=e.
get("EXT_texture_filter_anisotropic");s=i.getParameter(_.MAX_TEXTURE_MAX_ANISOTROPY_EXT)}else s=0;return s}function o(_){return!(_!==Ti&&n.convert(_)!==i.getParameter(
i.IMPLEMENTATION_COLOR_READ_FORMAT))}function a(_){let M=_===wi&&(e.has("EXT_color_buffer_half_float")||e.has("EXT_color_buffer_float"));return!(_!==Wn&&_!==di&&
!M&&n.convert(_)!==i.getParameter(i.IMPLEMENTATION_COLOR_READ_TYPE))}function l(_){if(_==="highp"){if(i.getShaderPrecisionFormat(i.VERTEX_SHADER,i.HIGH_FLOAT).precision>
0&&i.getShaderPrecisionFormat(i.FRAGMENT_SHADER,i.HIGH_FLOAT).precision>0)return"highp";_="mediump"}return _==="mediump"&&i.getShaderPrecisionFormat(i.VERTEX_SHADER,
i.MEDIUM_FLOAT).precision>0&&i.getShaderPrecisionFormat(i.FRAGMENT_SHADER,i.MEDIUM_FLOAT).precision>0?"mediump":"lowp"}let c=t.precision!==void 0?t.precision:"h\
ighp",d=l(c);d!==c&&(qe("WebGLRenderer:",c,"not supported, using",d,"instead."),c=d);let u=t.reversedDepthBuffer===!0&&e.has("EXT_clip_control"),h=t.logarithmicDepthBuffer===
!0&&u===!1;t.reversedDepthBuffer===!0&&u===!1&&qe("WebGLRenderer: Unable to use reversed depth buffer due to missing EXT_clip_control extension. Fallback to def\
ault depth buffer."),t.logarithmicDepthBuffer===!0&&u===!0&&qe("WebGLRenderer: Logarithmic depth buffer is ignored when reversed depth buffer is enabled.");let f=i.
getParameter(i.MAX_TEXTURE_IMAGE_UNITS),p=i.getParameter(i.MAX_VERTEX_TEXTURE_IMAGE_UNITS),x=i.getParameter(i.MAX_TEXTURE_SIZE),m=i.getParameter(i.MAX_CUBE_MAP_TEXTURE_SIZE),
g=i.getParameter(i.MAX_VERTEX_ATTRIBS),y=i.getParameter(i.MAX_VERTEX_UNIFORM_VECTORS),S=i.getParameter(i.MAX_VARYING_VECTORS),b=i.getParameter(i.MAX_FRAGMENT_UNIFORM_VECTORS),
C=i.getParameter(i.MAX_SAMPLES),w=i.getParameter(i.SAMPLES);return{isWebGL2:!0,getMaxAnisotropy:r,getMaxPrecision:l,textureFormatReadable:o,textureTypeReadable:a,
precision:c,logarithmicDepthBuffer:h,reversedDepthBuffer:u,maxTextures:f,maxVertexTextures:p,maxTextureSize:x,maxCubemapSize:m,maxAttributes:g,maxVertexUniforms:y,
maxVaryings:S,maxFragmentUniforms:b,maxSamples:C,samples:w}}function UM(i){let e=this,t=null,n=0,s=!1,r=!1,o=new ti,a=new Qe,l={value:null,needsUpdate:!1};this.
uniform=l,this.numPlanes=0,this.numIntersection=0,this.init=function(u,h){let f=u.length!==0||h||n!==0||s;return s=h,n=u.length,f},this.beginShadows=function(){
r=!0,d(null)},this.endShadows=function(){r=!1},this.setGlobalState=function(u,h){t=d(u,h,0)},this.setState=function(u,h,f){let p=u.clippingPlanes,x=u.clipIntersection,
m=u.clipShadows,g=i.get(u);if(!s||p===null||p.length===0||r&&!m)r?d(null):c();else{let y=r?0:n,S=y*4,b=g.clippingState||null;l.value=b,b=d(p,h,S,f);for(let C=0;C!==
S;++C)b[C]=t[C];g.clippingState=b,this.numIntersection=x?this.numPlanes:0,this.numPlanes+=y}};function c(){l.value!==t&&(l.value=t,l.needsUpdate=n>0),e.numPlanes=
n,e.numIntersection=0}function d(u,h,f,p){let x=u!==null?u.length:0,m=null;if(x!==0){if(m=l.value,p!==!0||m===null){let g=f+x*4,y=h.matrixWorldInverse;a.getNormalMatrix(
y),(m===null||m.length<g)&&(m=new Float32Array(g));for(let S=0,b=f;S!==x;++S,b+=4)o.copy(u[S]).applyMatrix4(y,a),o.normal.toArray(m,b),m[b+3]=o.constant}l.value=
m,l.needsUpdate=!0}return e.numPlanes=x,e.numIntersection=0,m}}var Ta=class extends ni{constructor(e=1,t={}){super(e,e,t),this.isWebGLCubeRenderTarget=!0;let n={
width:e,height:e,depth:1},s=[n,n,n,n,n,n];this.texture=new Ko(s),this._setTextureOptions(t),this.texture.isRenderTargetTexture=!0}fromEquirectangularTexture(e,t){
this.texture.type=t.type,this.texture.colorSpace=t.colorSpace,this.texture.generateMipmaps=t.generateMipmaps,this.texture.minFilter=t.minFilter,this.texture.magFilter=
t.magFilter;let n={uniforms:{tEquirect:{value:null}},vertexShader:"\n\n    varying vec3 vWorldDirection;\n\n    vec3 transformDirection( in vec3 dir, in mat4 matrix\
 ) {\n\n     return normalize( ( matrix * vec4( dir, 0.0 ) ).xyz );\n\n    }\n\n    void main() {\n\n     vWorldDirection = transformDirection( position, modelMatrix );\
\n\n     #include <begin_vertex>\n     #include <project_vertex>\n\n    }\n   ",fragmentShader:"\n\n    uniform sampler2D tEquirect;\n\n    varying vec3 vWorldDirec\
tion;\n\n    #include <common>\n\n    void main() {\n\n     vec3 direction = normalize( vWorldDirection );\n\n     vec2 sampleUV = equirectUv( direction );\n\n     gl_Fra\
gColor = texture2D( tEquirect, sampleUV );\n\n    }\n   "},s=new Ds(5,5,5),r=new Vi({name:"CubemapFromEquirect",uniforms:cr(n.uniforms),vertexShader:n.vertexShader,
fragmentShader:n.fragmentShader,side:zn,blending:rr});r.uniforms.tEquirect.value=t;let o=new ui(s,r),a=t.minFilter;return t.minFilter===ds&&(t.minFilter=Bn),new oo(
1,10,this).update(e,o),t.minFilter=a,o.geometry.dispose(),o.material.dispose(),this}clear(e,t=!0,n=!0,s=!0){let r=e.getRenderTarget();for(let o=0;o<6;o++)e.setRenderTarget(
this,o),e.clear(t,n,s);e.setRenderTarget(r)}},ug=256,FM=3,OM=20,Dg=256,Ug=16,BM=3,kM=new V,zM=new rt,Wc=class i{constructor(e){this._renderer=e,this._cubeSize=0,
this._sourceTarget=null,this._cubeCamera=new oo(1,10,null),this._boxMesh=new ui(new Ds(5,5,5),null),this._cubemapMaterial=null,this._equirectMaterial=null,this.
_blurMaterial=null,this._ggxMaterial=null,this._integrationMaterial=null}fromScene(e,t=0,n=.1,s=100,r={}){let{size:o=256,position:a=kM}=r,l=this._renderer;this.
_setSize(o);let c=this._allocateTarget(),d=this._getSourceTarget(!0);t>0&&(d.texture.mipmapsAutoUpdate=!1);let u=l.autoClear,h=l.autoClearColor,f=l.autoClearDepth,
p=l.autoClearStencil,x=e.background;l.autoClear=!0,l.autoClearColor=!0,l.autoClearDepth=!0,l.autoClearStencil=!0,x===null&&(e.background=l.getClearColor(zM));let m=new oo(
n,s,d);return m.position.copy(a),m.update(l,e),l.autoClear=u,l.autoClearColor=h,l.autoClearDepth=f,l.autoClearStencil=p,e.background=x,t>0&&(d.texture.mipmapsAutoUpdate=
!0,this._blur(c,t)),this._applyPMREM(c),c}fromEquirectangular(e,t=null){return this._fromTexture(e,t)}fromCubemap(e,t=null){return this._fromTexture(e,t)}compileCubemapShader(){
this._cubemapMaterial===null&&(this._cubemapMaterial=pg(),this._compileMaterial(this._cubemapMaterial))}compileEquirectangularShader(){this._equirectMaterial===
null&&(this._equirectMaterial=fg(),this._compileMaterial(this._equirectMaterial))}dispose(){this._sourceTarget!==null&&this._sourceTarget.dispose(),this._cubemapMaterial!==
null&&this._cubemapMaterial.dispose(),this._equirectMaterial!==null&&this._equirectMaterial.dispose(),this._blurMaterial!==null&&this._blurMaterial.dispose(),this.
_ggxMaterial!==null&&this._ggxMaterial.dispose(),this._integrationMaterial!==null&&this._integrationMaterial.dispose(),this._boxMesh.geometry.dispose()}static lodToRoughness(e,t){
return t>0?1-Math.sqrt(1-e/t):0}_setSize(e){this._cubeSize=Math.max(ug,og(e))}_fromTexture(e,t){e.mapping===ar||e.mapping===co?this._setSize(e.image.length===0?
ug:e.image[0].width||e.image[0].image.width):this._setSize(e.image.width/4);let n=t||this._allocateTarget();return this._textureToCubemap(e),this._applyPMREM(n),
n}_allocateTarget(){let e=this._cubeSize,t=dg(e,!1,!1),n=Math.log2(e)-FM;for(let s=0;s<=n;s++)t.texture.mipmaps.push({width:e>>s,height:e>>s});return t.texture.
name="PMREM",t.texture.isPMREMTexture=!0,t}_getSourceTarget(e=!1){let t=this._cubeSize,n=this._sourceTarget;return(n===null||n.width!==t||e&&n.depthBuffer===!1)&&
(n!==null&&n.dispose(),this._sourceTarget=dg(t,!0,e)),this._sourceTarget}_compileMaterial(e){this._boxMesh.material=e,this._renderer.compile(this._boxMesh,this.
_cubeCamera.children[0])}_renderCube(e,t,n){let s=this._boxMesh,r=this._cubeCamera;s.material=n,r.renderTarget=e,r.activeMipmapLevel=t;let o=e.width>>t;e.viewport.
set(0,0,o,o),r.update(this._renderer,s),e.viewport.set(0,0,e.width,e.height)}_textureToCubemap(e){let t;e.mapping===ar||e.mapping===co?(this._cubemapMaterial===
null&&(this._cubemapMaterial=pg()),t=this._cubemapMaterial,t.uniforms.flipEnvMap.value=e.isRenderTargetTexture===!1?-1:1):(this._equirectMaterial===null&&(this.
_equirectMaterial=fg()),t=this._equirectMaterial),t.uniforms.envMap.value=e,this._renderCube(this._getSourceTarget(),0,t)}_applyPMREM(e){this._ggxMaterial===null&&
(this._ggxMaterial=VM(),this._integrationMaterial=GM());let t=this._cubeSize,n=e.texture.mipmaps.length-1,s=this._ggxMaterial.uniforms;s.envMap.value=this._sourceTarget.
texture;let r=this._integrationMaterial.uniforms;r.envMap.value=this._sourceTarget.texture,r.sourceLod.value=Math.log2(t/Ug);for(let o=0;o<=n;o++){let a=i.lodToRoughness(
o,n);if(o>n-BM)r.roughness.value=a,this._renderCube(e,o,this._integrationMaterial);else{let l=a>0?Math.log2(t)+.5*Math.log2(6/(Dg*Math.pow(a,4)))+.5:0;s.roughness.
value=a,s.lodBias.value=l,this._renderCube(e,o,this._ggxMaterial)}}}_blur(e,t){this._blurMaterial===null&&(this._blurMaterial=HM());let n=this._blurMaterial,s=n.
uniforms,r=this._sourceTarget;s.sigma.value=Math.min(t,Math.PI)/Math.SQRT2,s.envMap.value=r.texture,this._renderCube(e,0,n),s.envMap.value=e.texture,this._renderCube(
r,0,n)}};function dg(i,e,t){return new Ta(i,{minFilter:ds,generateMipmaps:e,type:wi,colorSpace:Go,depthBuffer:t})}function Aa(i,e,t){return new Vi({name:i,uniforms:e,
vertexShader:ht.cube_vert,fragmentShader:t,side:zn,blending:rr,depthTest:!1,depthWrite:!1})}function VM(){return Aa("PMREMGGXConvolution",{envMap:{value:null},roughness:{
value:0},lodBias:{value:0}},"\n\n  #define GGX_SAMPLES ".concat(Dg,"u\n\n  varying vec3 vWorldDirection;\n\n  uniform samplerCube envMap;\n  uniform float roughness;\
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
function GM(){return Aa("PMREMGGXIntegration",{envMap:{value:null},roughness:{value:0},sourceLod:{value:0},sourceSize:{value:Ug}},"\n\n  varying vec3 vWorldDirect\
ion;\n\n  uniform samplerCube envMap;\n  uniform float roughness;\n  uniform float sourceLod;\n  uniform int sourceSize;\n\n  void main() {\n\n   vec3 N = normalize( vWo\
rldDirection );\n\n   float alpha = roughness * roughness;\n   float alpha2 = alpha * alpha;\n\n   float texelSize = 2.0 / float( sourceSize );\n\n   vec3 prefilteredC\
olor = vec3( 0.0 );\n   float totalWeight = 0.0;\n\n   // Pair opposite texels: only the one in N's hemisphere contributes.\n   for ( int face = 0; face < 3; face +\
+ ) {\n\n    for ( int y = 0; y < sourceSize; y ++ ) {\n\n     for ( int x = 0; x < sourceSize; x ++ ) {\n\n      vec2 uv = ( vec2( x, y ) + 0.5 ) * texelSize - 1.0;\n\
      vec3 texelDirection = face == 0 ? vec3( 1.0, uv ) : ( face == 1 ? vec3( uv.x, 1.0, uv.y ) : vec3( uv, 1.0 ) );\n\n      float invDistance = inversesqrt( 1.0\
 + dot( uv, uv ) );\n      float NdotL = dot( N, texelDirection );\n      texelDirection *= NdotL < 0.0 ? - 1.0 : 1.0;\n      NdotL = abs( NdotL ) * invDistance;\n\n\
      // With V = N, NdotH squared is ( 1 + NdotL ) / 2. Common factors\n      // in the GGX distribution and texel solid angle cancel when normalized.\n      flo\
at d = 1.0 + alpha2 + ( alpha2 - 1.0 ) * NdotL;\n      float weight = NdotL * invDistance * invDistance * invDistance / ( d * d );\n\n      prefilteredColor += tex\
tureLod( envMap, texelDirection, sourceLod ).rgb * weight;\n      totalWeight += weight;\n\n     }\n\n    }\n\n   }\n\n   gl_FragColor = vec4( prefilteredColor / totalWe\
ight, 1.0 );\n\n  }\n ")}function HM(){return Aa("PMREMSphericalGaussianBlur",{envMap:{value:null},sigma:{value:0}},"\n\n  #define SAMPLES ".concat(OM,"\n  #defi\
ne GOLDEN_ANGLE 2.39996322973\n\n  varying vec3 vWorldDirection;\n\n  uniform samplerCube envMap;\n  uniform float sigma;\n\n  #include <common>\n\n  void main() {\n\n   v\
ec3 outputDirection = normalize( vWorldDirection );\n\n   vec3 up = abs( outputDirection.z ) < 0.999 ? vec3( 0.0, 0.0, 1.0 ) : vec3( 1.0, 0.0, 0.0 );\n   vec3 tang\
ent = normalize( cross( up, outputDirection ) );\n   vec3 bitangent = cross( outputDirection, tangent );\n\n   // Truncate the kernel at three standard deviations \
or at the antipode.\n   float thetaMax = min( 3.0 * sigma, PI );\n   float truncation = 1.0 - exp( - 0.5 * thetaMax * thetaMax / ( sigma * sigma ) );\n\n   vec3 acc\
umColor = vec3( 0.0 );\n   float accumWeight = 0.0;\n\n   for ( int i = 0; i < SAMPLES; i ++ ) {\n\n    // Stratified inverse-CDF sampling of the Gaussian, placed on\
 a golden-angle spiral.\n    float stratum = ( float( i ) + 0.5 ) / float( SAMPLES );\n    float theta = sigma * sqrt( - 2.0 * log( 1.0 - stratum * truncation ) )\
;\n    float phi = float( i ) * GOLDEN_ANGLE;\n\n    vec3 offset = cos( phi ) * tangent + sin( phi ) * bitangent;\n    vec3 sampleDirection = cos( theta ) * outputD\
irection + sin( theta ) * offset;\n\n    // Correct the planar sample density to solid angle.\n    float weight = sin( theta ) / theta;\n\n    accumColor += weight *\
 textureLod( envMap, sampleDirection, 0.0 ).rgb;\n    accumWeight += weight;\n\n   }\n\n   gl_FragColor = vec4( accumColor / accumWeight, 1.0 );\n\n  }\n "))}function fg(){
return Aa("PMREMEquirectangularToCubemap",{envMap:{value:null}},"\n\n  varying vec3 vWorldDirection;\n\n  uniform sampler2D envMap;\n\n  #include <common>\n\n  void mai\
n() {\n\n   // Average four subpixel samples to preserve small, bright features.\n   vec3 direction = normalize( vWorldDirection );\n   vec3 dx = dFdx( direction ) \
* 0.25;\n   vec3 dy = dFdy( direction ) * 0.25;\n\n   vec3 color = textureLod( envMap, equirectUv( normalize( direction - dx - dy ) ), 0.0 ).rgb;\n   color += textu\
reLod( envMap, equirectUv( normalize( direction + dx - dy ) ), 0.0 ).rgb;\n   color += textureLod( envMap, equirectUv( normalize( direction - dx + dy ) ), 0.0 ).\
rgb;\n   color += textureLod( envMap, equirectUv( normalize( direction + dx + dy ) ), 0.0 ).rgb;\n   gl_FragColor = vec4( color * 0.25, 1.0 );\n\n  }\n ")}function pg(){
return Aa("PMREMCubemapToCubemap",{envMap:{value:null},flipEnvMap:{value:-1}},"\n\n  varying vec3 vWorldDirection;\n\n  uniform samplerCube envMap;\n  uniform float \
flipEnvMap;\n\n  void main() {\n\n   gl_FragColor = vec4( textureCube( envMap, vec3( flipEnvMap * vWorldDirection.x, vWorldDirection.yz ) ).rgb, 1.0 );\n\n  }\n ")}
function WM(i){let e=new WeakMap,t=new WeakMap,n=null;function s(h,f=!1){return h==null?null:f?o(h):r(h)}function r(h){if(h&&h.isTexture){let f=h.mapping;if(f===
tc||f===nc)if(e.has(h)){let p=e.get(h).texture;return a(p,h.mapping)}else{let p=h.image;if(p&&p.height>0){let x=new Ta(p.height);return x.fromEquirectangularTexture(
i,h),e.set(h,x),h.addEventListener("dispose",c),a(x.texture,h.mapping)}else return null}}return h}function o(h){if(h&&h.isTexture&&h.isPMREMTexture!==!0){let f=h.
mapping,p=f===tc||f===nc,x=f===ar||f===co;if(p||x){let m=t.get(h),g=m!==void 0?m.texture.pmremVersion:0;if(h.isRenderTargetTexture&&h.pmremVersion!==g)return n===
null&&(n=new Wc(i)),m=p?n.fromEquirectangular(h,m):n.fromCubemap(h,m),m.texture.pmremVersion=h.pmremVersion,t.set(h,m),m.texture;if(m!==void 0)return m.texture;
{let y=h.image;return p&&y&&y.height>0||x&&y&&l(y)?(n===null&&(n=new Wc(i)),m=p?n.fromEquirectangular(h):n.fromCubemap(h),m.texture.pmremVersion=h.pmremVersion,
t.set(h,m),h.addEventListener("dispose",d),m.texture):null}}}return h}function a(h,f){return f===tc?h.mapping=ar:f===nc&&(h.mapping=co),h}function l(h){let f=0,
p=6;for(let x=0;x<p;x++)h[x]!==void 0&&f++;return f===p}function c(h){let f=h.target;f.removeEventListener("dispose",c);let p=e.get(f);p!==void 0&&(e.delete(f),
p.dispose())}function d(h){let f=h.target;f.removeEventListener("dispose",d);let p=t.get(f);p!==void 0&&(t.delete(f),p.dispose())}function u(){e=new WeakMap,t=new WeakMap,
n!==null&&(n.dispose(),n=null)}return{get:s,dispose:u}}function XM(i){let e={};function t(n){if(e[n]!==void 0)return e[n];let s=i.getExtension(n);return e[n]=s,
s}return{has:function(n){return t(n)!==null},init:function(){t("EXT_color_buffer_float"),t("WEBGL_clip_cull_distance"),t("OES_texture_float_linear"),t("EXT_colo\
r_buffer_half_float"),t("WEBGL_multisampled_render_to_texture"),t("WEBGL_render_shared_exponent")},get:function(n){let s=t(n);return s===null&&zo("WebGLRenderer\
: "+n+" extension not supported."),s}}}function $M(i,e,t,n){let s={},r=new WeakMap,o=new FinalizationRegistry(p=>delete s[p]);function a(p){l(p.target)}function l(p){
p.index!==null&&e.remove(p.index);for(let m in p.attributes)e.remove(p.attributes[m]);p.removeEventListener("dispose",a),delete s[p.id],o.unregister(p);let x=r.
get(p);x&&(e.remove(x),r.delete(p)),n.releaseStatesOfGeometry(p),p.isInstancedBufferGeometry===!0&&delete p._maxInstanceCount,t.memory.geometries--}function c(p,x){
return s[x.id]!==void 0||(x.addEventListener("dispose",a),s[x.id]=new WeakRef(x),o.register(x,x.id,x),t.memory.geometries++),x}function d(p){let x=p.attributes;
for(let m in x)e.update(x[m],i.ARRAY_BUFFER)}function u(p){let x=p.index,m=p.attributes.position,g=0;if(m===void 0)return;let y=x!==null?x.array.length:m.array.
length/3-1,S=m.count>=65535?Yo:qo,b=new S(Math.ceil(y/3)*6,1),C=b.array;if(x!==null){let _=x.array;g=x.version;for(let M=0,R=0;M<y;M+=3){let P=_[M+0],I=_[M+1],F=_[M+
2];C[R++]=P,C[R++]=I,C[R++]=I,C[R++]=F,C[R++]=F,C[R++]=P}}else{g=m.version;for(let _=0,M=0;_<y;_+=3){let R=_+0,P=_+1,I=_+2;C[M++]=R,C[M++]=P,C[M++]=P,C[M++]=I,C[M++]=
I,C[M++]=R}}b.version=g;let w=r.get(p);w&&e.remove(w),r.set(p,b)}function h(p){let x=r.get(p);if(x){let m=p.index;m!==null&&x.version<m.version&&u(p)}else u(p);
return r.get(p)}function f(){for(let p in s){let x=s[p].deref();x!==void 0&&l(x)}}return{get:c,update:d,getWireframeAttribute:h,dispose:f}}function qM(i,e,t){let n;
function s(u){n=u}let r,o;function a(u){r=u.type,o=u.bytesPerElement}function l(u,h){i.drawElements(n,h,r,u*o),t.update(h,n,1)}function c(u,h,f){f!==0&&(i.drawElementsInstanced(
n,h,r,u*o,f),t.update(h,n,f))}function d(u,h,f){if(f===0)return;e.get("WEBGL_multi_draw").multiDrawElementsWEBGL(n,h,0,r,u,0,f);let x=0;for(let m=0;m<f;m++)x+=h[m];
t.update(x,n,1)}this.setMode=s,this.setIndex=a,this.render=l,this.renderInstances=c,this.renderMultiDraw=d}function YM(i){let e={geometries:0,textures:0},t={frame:0,
calls:0,triangles:0,points:0,lines:0};function n(r,o,a){switch(t.calls++,o){case i.TRIANGLES:t.triangles+=a*(r/3);break;case i.LINES:t.lines+=a*(r/2);break;case i.
LINE_STRIP:t.lines+=a*(r-1);break;case i.LINE_LOOP:t.lines+=a*r;break;case i.POINTS:t.points+=a*r;break;default:Ke("WebGLInfo: Unknown draw mode:",o);break}}function s(){
t.calls=0,t.triangles=0,t.points=0,t.lines=0}return{memory:e,render:t,programs:null,autoReset:!0,reset:s,update:n}}function ZM(i,e,t){let n=new WeakMap,s=new Wt;
function r(o,a,l){let c=o.morphTargetInfluences,d=a.morphAttributes.position||a.morphAttributes.normal||a.morphAttributes.color,u=d!==void 0?d.length:0,h=n.get(
a);if(h===void 0||h.count!==u){let R=function(){_.dispose(),n.delete(a),a.removeEventListener("dispose",R)};h!==void 0&&h.texture.dispose();let f=a.morphAttributes.
position!==void 0,p=a.morphAttributes.normal!==void 0,x=a.morphAttributes.color!==void 0,m=a.morphAttributes.position||[],g=a.morphAttributes.normal||[],y=a.morphAttributes.
color||[],S=0;f===!0&&(S=1),p===!0&&(S=2),x===!0&&(S=3);let b=a.attributes.position.count*S,C=1;b>e.maxTextureSize&&(C=Math.ceil(b/e.maxTextureSize),b=e.maxTextureSize);
let w=new Float32Array(b*C*4*u),_=new Xo(w,b,C,u);_.type=di,_.needsUpdate=!0;let M=S*4;for(let P=0;P<u;P++){let I=m[P],F=g[P],z=y[P],D=b*C*4*P;for(let G=0;G<I.count;G++){
let Y=G*M;f===!0&&(s.fromBufferAttribute(I,G),w[D+Y+0]=s.x,w[D+Y+1]=s.y,w[D+Y+2]=s.z,w[D+Y+3]=0),p===!0&&(s.fromBufferAttribute(F,G),w[D+Y+4]=s.x,w[D+Y+5]=s.y,w[D+
Y+6]=s.z,w[D+Y+7]=0),x===!0&&(s.fromBufferAttribute(z,G),w[D+Y+8]=s.x,w[D+Y+9]=s.y,w[D+Y+10]=s.z,w[D+Y+11]=z.itemSize===4?s.w:1)}}h={count:u,texture:_,size:new st(
b,C)},n.set(a,h),a.addEventListener("dispose",R)}if(o.isInstancedMesh===!0&&o.morphTexture!==null)l.getUniforms().setValue(i,"morphTexture",o.morphTexture,t);else{
let f=0;for(let x=0;x<c.length;x++)f+=c[x];let p=a.morphTargetsRelative?1:1-f;l.getUniforms().setValue(i,"morphTargetBaseInfluence",p),l.getUniforms().setValue(
i,"morphTargetInfluences",c)}l.getUniforms().setValue(i,"morphTargetsTexture",h.texture,t),l.getUniforms().setValue(i,"morphTargetsTextureSize",h.size)}return{update:r}}
function JM(i,e,t,n,s){let r=new WeakMap;function o(c){let d=s.render.frame,u=c.geometry,h=e.get(c,u);if(r.get(h)!==d&&(e.update(h),r.set(h,d)),c.isInstancedMesh&&
(c.hasEventListener("dispose",l)===!1&&c.addEventListener("dispose",l),r.get(c)!==d&&(t.update(c.instanceMatrix,i.ARRAY_BUFFER),c.instanceColor!==null&&t.update(
c.instanceColor,i.ARRAY_BUFFER),r.set(c,d))),c.isSkinnedMesh){let f=c.skeleton;r.get(f)!==d&&(f.update(),r.set(f,d))}return h}function a(){r=new WeakMap}function l(c){
let d=c.target;d.removeEventListener("dispose",l),n.releaseStatesOfObject(d),t.remove(d.instanceMatrix),d.instanceColor!==null&&t.remove(d.instanceColor)}return{
update:o,dispose:a}}var KM={[Bu]:"LINEAR_TONE_MAPPING",[ku]:"REINHARD_TONE_MAPPING",[zu]:"CINEON_TONE_MAPPING",[Vu]:"ACES_FILMIC_TONE_MAPPING",[Hu]:"AGX_TONE_MA\
PPING",[Wu]:"NEUTRAL_TONE_MAPPING",[Gu]:"CUSTOM_TONE_MAPPING"};function jM(i,e,t,n,s,r){let o=new ni(e,t,{type:i,depthBuffer:s,stencilBuffer:r,samples:n?4:0,storeMultisampledDepthBuffer:!1,
storeMultisampledStencilBuffer:!1,resolveDepthBuffer:!1,resolveStencilBuffer:!1}),a=null,l=null,c=null,d=new ln;d.setAttribute("position",new yt([-1,3,0,-1,-1,0,
3,-1,0],3)),d.setAttribute("uv",new yt([0,2,0,0,2,0],2));let u=new kl({uniforms:{tDiffuse:{value:null}},vertexShader:"\n   precision highp float;\n\n   uniform mat\
4 modelViewMatrix;\n   uniform mat4 projectionMatrix;\n\n   attribute vec3 position;\n   attribute vec2 uv;\n\n   varying vec2 vUv;\n\n   void main() {\n    vUv = uv;\n  \
  gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );\n   }",fragmentShader:"\n   precision highp float;\n\n   uniform sampler2D tDiffuse;\n\n \
  varying vec2 vUv;\n\n   #include <tonemapping_pars_fragment>\n   #include <colorspace_pars_fragment>\n\n   void main() {\n    gl_FragColor = texture2D( tDiffuse, vU\
v );\n\n    #ifdef LINEAR_TONE_MAPPING\n     gl_FragColor.rgb = LinearToneMapping( gl_FragColor.rgb );\n    #elif defined( REINHARD_TONE_MAPPING )\n     gl_FragColor\
.rgb = ReinhardToneMapping( gl_FragColor.rgb );\n    #elif defined( CINEON_TONE_MAPPING )\n     gl_FragColor.rgb = CineonToneMapping( gl_FragColor.rgb );\n    #eli\
f defined( ACES_FILMIC_TONE_MAPPING )\n     gl_FragColor.rgb = ACESFilmicToneMapping( gl_FragColor.rgb );\n    #elif defined( AGX_TONE_MAPPING )\n     gl_FragColor\
.rgb = AgXToneMapping( gl_FragColor.rgb );\n    #elif defined( NEUTRAL_TONE_MAPPING )\n     gl_FragColor.rgb = NeutralToneMapping( gl_FragColor.rgb );\n    #elif d\
efined( CUSTOM_TONE_MAPPING )\n     gl_FragColor.rgb = CustomToneMapping( gl_FragColor.rgb );\n    #endif\n\n    #ifdef SRGB_TRANSFER\n     gl_FragColor = sRGBTransf\
erOETF( gl_FragColor );\n    #endif\n   }",depthTest:!1,depthWrite:!1}),h=new ui(d,u),f=new ha(-1,1,1,-1,0,1),p=null,x=null,m=!1,g,y=null,S=[],b=!1;this.setSize=
function(C,w){o.setSize(C,w),a!==null&&a.setSize(C,w),l!==null&&l.setSize(C,w);for(let _=0;_<S.length;_++){let M=S[_];M.setSize&&M.setSize(C,w)}},this.setEffects=
function(C){S=C,b=S.length>0&&S[0].isRenderPass===!0;let w=o.width,_=o.height;S.length>0&&a===null&&(a=new ni(w,_,{type:wi,depthBuffer:!1,stencilBuffer:!1}),l=new ni(
w,_,{type:wi,depthBuffer:!1,stencilBuffer:!1}));let M=s===!0&&S.some(R=>R.needsDepthTexture===!0);M!==(o.depthTexture!==null)&&(M===!0&&c===null&&(c=new us(w,_),
r===!0&&(c.format=fs,c.type=lr)),o.dispose(),o.depthTexture=M?c:null,o.resolveDepthBuffer=M,o.storeMultisampledDepthBuffer=M);for(let R=0;R<S.length;R++){let P=S[R];
P.setSize&&P.setSize(w,_),M&&P.needsDepthTexture===!0&&P.setDepthTexture&&P.setDepthTexture(c)}},this.begin=function(C,w){if(m||C.toneMapping===Hi&&S.length===0)
return!1;if(y=w,w!==null){let _=w.width,M=w.height;(o.width!==_||o.height!==M)&&this.setSize(_,M)}return b===!1&&C.setRenderTarget(o),g=C.toneMapping,C.toneMapping=
Hi,!0},this.hasRenderPass=function(){return b},this.end=function(C,w){C.toneMapping=g,m=!0;let _=o,M=a;for(let R=0;R<S.length;R++){let P=S[R];P.enabled!==!1&&(P.
render(C,M,_,w),P.needsSwap!==!1&&(_=M,M=M===a?l:a))}if(p!==C.outputColorSpace||x!==C.toneMapping){p=C.outputColorSpace,x=C.toneMapping,u.defines={},_t.getTransfer(
p)===At&&(u.defines.SRGB_TRANSFER="");let R=KM[x];R&&(u.defines[R]=""),u.needsUpdate=!0}u.uniforms.tDiffuse.value=_.texture,C.setRenderTarget(y),C.render(h,f),y=
null,m=!1},this.isCompositing=function(){return m},this.dispose=function(){o.dispose(),a!==null&&a.dispose(),l!==null&&l.dispose(),d.dispose(),u.dispose()}}var Fg=new Hn,
Og=new us(1,1),Bg=new jo(1),kg=new Xo,zg=new Nl,Vg=new Ko,mg=[],gg=[],_g=new Float32Array(16),xg=new Float32Array(9),yg=new Float32Array(4);function fo(i,e,t){let n=i[0];
if(n<=0||n>0)return i;let s=e*t,r=mg[s];if(r===void 0&&(r=new Float32Array(s),mg[s]=r),e!==0){n.toArray(r,0);for(let o=1,a=0;o!==e;++o)a+=t,i[o].toArray(r,a)}return r}
function pn(i,e){if(i.length!==e.length)return!1;for(let t=0,n=i.length;t<n;t++)if(i[t]!==e[t])return!1;return!0}function mn(i,e){for(let t=0,n=e.length;t<n;t++)
i[t]=e[t]}function $c(i,e){let t=gg[e];t===void 0&&(t=new Int32Array(e),gg[e]=t);for(let n=0;n!==e;++n)t[n]=i.allocateTextureUnit();return t}function QM(i,e){let t=this.
cache;t[0]!==e&&(i.uniform1f(this.addr,e),t[0]=e)}function eS(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(i.uniform2f(this.addr,e.x,e.y),t[0]=
e.x,t[1]=e.y);else{if(pn(t,e))return;i.uniform2fv(this.addr,e),mn(t,e)}}function tS(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&
(i.uniform3f(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else if(e.r!==void 0)(t[0]!==e.r||t[1]!==e.g||t[2]!==e.b)&&(i.uniform3f(this.addr,e.r,e.g,e.b),t[0]=
e.r,t[1]=e.g,t[2]=e.b);else{if(pn(t,e))return;i.uniform3fv(this.addr,e),mn(t,e)}}function nS(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==
e.z||t[3]!==e.w)&&(i.uniform4f(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(pn(t,e))return;i.uniform4fv(this.addr,e),mn(t,e)}}function iS(i,e){
let t=this.cache,n=e.elements;if(n===void 0){if(pn(t,e))return;i.uniformMatrix2fv(this.addr,!1,e),mn(t,e)}else{if(pn(t,n))return;yg.set(n),i.uniformMatrix2fv(this.
addr,!1,yg),mn(t,n)}}function sS(i,e){let t=this.cache,n=e.elements;if(n===void 0){if(pn(t,e))return;i.uniformMatrix3fv(this.addr,!1,e),mn(t,e)}else{if(pn(t,n))
return;xg.set(n),i.uniformMatrix3fv(this.addr,!1,xg),mn(t,n)}}function rS(i,e){let t=this.cache,n=e.elements;if(n===void 0){if(pn(t,e))return;i.uniformMatrix4fv(
this.addr,!1,e),mn(t,e)}else{if(pn(t,n))return;_g.set(n),i.uniformMatrix4fv(this.addr,!1,_g),mn(t,n)}}function oS(i,e){let t=this.cache;t[0]!==e&&(i.uniform1i(this.
addr,e),t[0]=e)}function aS(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(i.uniform2i(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(pn(t,e))return;
i.uniform2iv(this.addr,e),mn(t,e)}}function lS(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(i.uniform3i(this.addr,e.x,e.y,e.z),t[0]=
e.x,t[1]=e.y,t[2]=e.z);else{if(pn(t,e))return;i.uniform3iv(this.addr,e),mn(t,e)}}function cS(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==
e.z||t[3]!==e.w)&&(i.uniform4i(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(pn(t,e))return;i.uniform4iv(this.addr,e),mn(t,e)}}function hS(i,e){
let t=this.cache;t[0]!==e&&(i.uniform1ui(this.addr,e),t[0]=e)}function uS(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(i.uniform2ui(this.addr,
e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(pn(t,e))return;i.uniform2uiv(this.addr,e),mn(t,e)}}function dS(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||
t[2]!==e.z)&&(i.uniform3ui(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else{if(pn(t,e))return;i.uniform3uiv(this.addr,e),mn(t,e)}}function fS(i,e){let t=this.
cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(i.uniform4ui(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(pn(
t,e))return;i.uniform4uiv(this.addr,e),mn(t,e)}}function qc(i){return i.version===0&&(i.compareFunction=ed,i.needsUpdate=!0),i}function pS(i,e,t){let n=this.cache,
s=t.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s);let r;this.type===i.SAMPLER_2D_SHADOW?r=qc(Og):r=Fg,t.setTexture2D(e||r,s)}function mS(i,e,t){
let n=this.cache,s=t.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s),t.setTexture3D(e||zg,s)}function gS(i,e,t){let n=this.cache,s=t.allocateTextureUnit();
n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s);let r;this.type===i.SAMPLER_CUBE_SHADOW?r=qc(Bg):r=Vg,t.setTextureCube(e||r,s)}function _S(i,e,t){let n=this.cache,s=t.
allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s),t.setTexture2DArray(e||kg,s)}function xS(i){switch(i){case 5126:return QM;case 35664:return eS;case 35665:
return tS;case 35666:return nS;case 35674:return iS;case 35675:return sS;case 35676:return rS;case 5124:case 35670:return oS;case 35667:case 35671:return aS;case 35668:case 35672:
return lS;case 35669:case 35673:return cS;case 5125:return hS;case 36294:return uS;case 36295:return dS;case 36296:return fS;case 35678:case 36198:case 36298:case 36306:case 35682:
return pS;case 35679:case 36299:case 36307:return mS;case 35680:case 36300:case 36308:case 36293:return gS;case 36289:case 36303:case 36311:case 36292:return _S}}
function yS(i,e){i.uniform1fv(this.addr,e)}function vS(i,e){let t=fo(e,this.size,2);i.uniform2fv(this.addr,t)}function bS(i,e){let t=fo(e,this.size,3);i.uniform3fv(
this.addr,t)}function MS(i,e){let t=fo(e,this.size,4);i.uniform4fv(this.addr,t)}function SS(i,e){let t=fo(e,this.size,4);i.uniformMatrix2fv(this.addr,!1,t)}function wS(i,e){
let t=fo(e,this.size,9);i.uniformMatrix3fv(this.addr,!1,t)}function TS(i,e){let t=fo(e,this.size,16);i.uniformMatrix4fv(this.addr,!1,t)}function AS(i,e){i.uniform1iv(
this.addr,e)}function ES(i,e){i.uniform2iv(this.addr,e)}function CS(i,e){i.uniform3iv(this.addr,e)}function RS(i,e){i.uniform4iv(this.addr,e)}function PS(i,e){i.
uniform1uiv(this.addr,e)}function IS(i,e){i.uniform2uiv(this.addr,e)}function LS(i,e){i.uniform3uiv(this.addr,e)}function NS(i,e){i.uniform4uiv(this.addr,e)}function DS(i,e,t){
let n=this.cache,s=e.length,r=$c(t,s);pn(n,r)||(i.uniform1iv(this.addr,r),mn(n,r));let o;this.type===i.SAMPLER_2D_SHADOW?o=qc(Og):o=Fg;for(let a=0;a!==s;++a)t.setTexture2D(
e[a]||o,r[a])}function US(i,e,t){let n=this.cache,s=e.length,r=$c(t,s);pn(n,r)||(i.uniform1iv(this.addr,r),mn(n,r));for(let o=0;o!==s;++o)t.setTexture3D(e[o]||zg,
r[o])}function FS(i,e,t){let n=this.cache,s=e.length,r=$c(t,s);pn(n,r)||(i.uniform1iv(this.addr,r),mn(n,r));let o;this.type===i.SAMPLER_CUBE_SHADOW?o=qc(Bg):o=Vg;
for(let a=0;a!==s;++a)t.setTextureCube(e[a]||o,r[a])}function OS(i,e,t){let n=this.cache,s=e.length,r=$c(t,s);pn(n,r)||(i.uniform1iv(this.addr,r),mn(n,r));for(let o=0;o!==
s;++o)t.setTexture2DArray(e[o]||kg,r[o])}function BS(i){switch(i){case 5126:return yS;case 35664:return vS;case 35665:return bS;case 35666:return MS;case 35674:
return SS;case 35675:return wS;case 35676:return TS;case 5124:case 35670:return AS;case 35667:case 35671:return ES;case 35668:case 35672:return CS;case 35669:case 35673:
return RS;case 5125:return PS;case 36294:return IS;case 36295:return LS;case 36296:return NS;case 35678:case 36198:case 36298:case 36306:case 35682:return DS;case 35679:case 36299:case 36307:
return US;case 35680:case 36300:case 36308:case 36293:return FS;case 36289:case 36303:case 36311:case 36292:return OS}}var hd=class{constructor(e,t,n){this.id=e,
this.addr=n,this.cache=[],this.type=t.type,this.setValue=xS(t.type)}},ud=class{constructor(e,t,n){this.id=e,this.addr=n,this.cache=[],this.type=t.type,this.size=
t.size,this.setValue=BS(t.type)}},dd=class{constructor(e){this.id=e,this.seq=[],this.map={}}setValue(e,t,n){let s=this.seq;for(let r=0,o=s.length;r!==o;++r){let a=s[r];
a.setValue(e,t[a.id],n)}}},ld=/(\w+)(\])?(\[|\.)?/g;function vg(i,e){i.seq.push(e),i.map[e.id]=e}function kS(i,e,t){let n=i.name,s=n.length;for(ld.lastIndex=0;;){
let r=ld.exec(n),o=ld.lastIndex,a=r[1],l=r[2]==="]",c=r[3];if(l&&(a=a|0),c===void 0||c==="["&&o+2===s){vg(t,c===void 0?new hd(a,i,e):new ud(a,i,e));break}else{let u=t.
map[a];u===void 0&&(u=new dd(a),vg(t,u)),t=u}}}var uo=class{constructor(e,t){this.seq=[],this.map={};let n=e.getProgramParameter(t,e.ACTIVE_UNIFORMS);for(let o=0;o<
n;++o){let a=e.getActiveUniform(t,o),l=e.getUniformLocation(t,a.name);kS(a,l,this)}let s=[],r=[];for(let o of this.seq)o.type===e.SAMPLER_2D_SHADOW||o.type===e.
SAMPLER_CUBE_SHADOW||o.type===e.SAMPLER_2D_ARRAY_SHADOW?s.push(o):r.push(o);s.length>0&&(this.seq=s.concat(r))}setValue(e,t,n,s){let r=this.map[t];r!==void 0&&r.
setValue(e,n,s)}setOptional(e,t,n){let s=t[n];s!==void 0&&this.setValue(e,n,s)}static upload(e,t,n,s){for(let r=0,o=t.length;r!==o;++r){let a=t[r],l=n[a.id];l.needsUpdate!==
!1&&a.setValue(e,l.value,s)}}static seqWithValue(e,t){let n=[];for(let s=0,r=e.length;s!==r;++s){let o=e[s];o.id in t&&n.push(o)}return n}};function bg(i,e,t){let n=i.
createShader(e);return i.shaderSource(n,t),i.compileShader(n),n}var zS=37297,VS=0;function GS(i,e){let t=i.split("\n"),n=[],s=Math.max(e-6,0),r=Math.min(e+6,t.length);
for(let o=s;o<r;o++){let a=o+1;n.push("".concat(a===e?">":" "," ").concat(a,": ").concat(t[o]))}return n.join("\n")}var Mg=new Qe;function HS(i){_t._getMatrix(Mg,
_t.workingColorSpace,i);let e="mat3( ".concat(Mg.elements.map(t=>t.toFixed(4))," )");switch(_t.getTransfer(i)){case Ho:return[e,"LinearTransferOETF"];case At:return[
e,"sRGBTransferOETF"];default:return qe("WebGLProgram: Unsupported color space: ",i),[e,"LinearTransferOETF"]}}function Sg(i,e,t){let n=i.getShaderParameter(e,i.
COMPILE_STATUS),r=(i.getShaderInfoLog(e)||"").trim();if(n&&r==="")return"";let o=/ERROR: 0:(\d+)/.exec(r);if(o){let a=parseInt(o[1]);return t.toUpperCase()+"\n\n"+
r+"\n\n"+GS(i.getShaderSource(e),a)}else return r}function WS(i,e){let t=HS(e);return["vec4 ".concat(i,"( vec4 value ) {")," return ".concat(t[1],"( vec4( ").concat(
t[0]," * value.rgb, value.a ) );"),"}"].join("\n")}var XS={[Bu]:"Linear",[ku]:"Reinhard",[zu]:"Cineon",[Vu]:"ACESFilmic",[Hu]:"AgX",[Wu]:"Neutral",[Gu]:"Custom"};
function $S(i,e){let t=XS[e];return t===void 0?(qe("WebGLProgram: Unsupported toneMapping:",e),"vec3 "+i+"( vec3 color ) { return LinearToneMapping( color ); }"):
"vec3 "+i+"( vec3 color ) { return "+t+"ToneMapping( color ); }"}var Hc=new V;function qS(){_t.getLuminanceCoefficients(Hc);let i=Hc.x.toFixed(4),e=Hc.y.toFixed(
4),t=Hc.z.toFixed(4);return["float luminance( const in vec3 rgb ) {"," const vec3 weights = vec3( ".concat(i,", ").concat(e,", ").concat(t," );")," return dot( \
weights, rgb );","}"].join("\n")}function YS(i){return[i.extensionClipCullDistance?"#extension GL_ANGLE_clip_cull_distance : require":"",i.extensionMultiDraw?"#\
extension GL_ANGLE_multi_draw : require":""].filter(wa).join("\n")}function ZS(i){let e=[];for(let t in i){let n=i[t];n!==!1&&e.push("#define "+t+" "+n)}return e.
join("\n")}function JS(i,e){let t={},n=i.getProgramParameter(e,i.ACTIVE_ATTRIBUTES);for(let s=0;s<n;s++){let r=i.getActiveAttrib(e,s),o=r.name,a=1;r.type===i.FLOAT_MAT2&&
(a=2),r.type===i.FLOAT_MAT3&&(a=3),r.type===i.FLOAT_MAT4&&(a=4),t[o]={type:r.type,location:i.getAttribLocation(e,o),locationSize:a}}return t}function wa(i){return i!==
""}function wg(i,e){let t=e.numSpotLightShadows+e.numSpotLightMaps-e.numSpotLightShadowsWithMaps;return i.replace(/NUM_SUN_LIGHTS/g,e.numSunLights).replace(/NUM_DIR_LIGHTS/g,
e.numDirLights).replace(/NUM_SPOT_LIGHTS/g,e.numSpotLights).replace(/NUM_SPOT_LIGHT_MAPS/g,e.numSpotLightMaps).replace(/NUM_SPOT_LIGHT_COORDS/g,t).replace(/NUM_RECT_AREA_LIGHTS/g,
e.numRectAreaLights).replace(/NUM_POINT_LIGHTS/g,e.numPointLights).replace(/NUM_HEMI_LIGHTS/g,e.numHemiLights).replace(/NUM_SUN_LIGHT_SHADOWS/g,e.numSunLightShadows).
replace(/NUM_DIR_LIGHT_SHADOWS/g,e.numDirLightShadows).replace(/NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS/g,e.numSpotLightShadowsWithMaps).replace(/NUM_SPOT_LIGHT_SHADOWS/g,
e.numSpotLightShadows).replace(/NUM_POINT_LIGHT_SHADOWS/g,e.numPointLightShadows).replace(/NUM_LIGHT_PROBE_GRIDS/g,e.numLightProbeGrids)}function Tg(i,e){return i.
replace(/NUM_CLIPPING_PLANES/g,e.numClippingPlanes).replace(/UNION_CLIPPING_PLANES/g,e.numClippingPlanes-e.numClipIntersection)}var KS=/^[ \t]*#include +<([\w\d./]+)>/gm;
function fd(i){return i.replace(KS,jS)}function jS(i,e){let t=ht[e];if(t===void 0)throw new Error("THREE.WebGLProgram: Can not resolve #include <"+e+">");return fd(
t)}var QS=/#pragma unroll_loop_start\s+for\s*\(\s*int\s+i\s*=\s*(\d+)\s*;\s*i\s*<\s*(\d+)\s*;\s*i\s*\+\+\s*\)\s*{([\s\S]+?)}\s+#pragma unroll_loop_end/g;function Ag(i){
return i.replace(QS,ew)}function ew(i,e,t,n){let s="";for(let r=parseInt(e);r<parseInt(t);r++)s+=n.replace(/\[\s*i\s*\]/g,"[ "+r+" ]").replace(/UNROLLED_LOOP_INDEX/g,
r);return s}function Eg(i){let e="precision ".concat(i.precision," float;\n precision ").concat(i.precision," int;\n precision ").concat(i.precision," sampler2D\
;\n precision ").concat(i.precision," samplerCube;\n precision ").concat(i.precision," sampler3D;\n precision ").concat(i.precision," sampler2DArray;\n precision\
 ").concat(i.precision," sampler2DShadow;\n precision ").concat(i.precision," samplerCubeShadow;\n precision ").concat(i.precision," sampler2DArrayShadow;\n prec\
ision ").concat(i.precision," isampler2D;\n precision ").concat(i.precision," isampler3D;\n precision ").concat(i.precision," isamplerCube;\n precision ").concat(
i.precision," isampler2DArray;\n precision ").concat(i.precision," usampler2D;\n precision ").concat(i.precision," usampler3D;\n precision ").concat(i.precision,
" usamplerCube;\n precision ").concat(i.precision," usampler2DArray;\n ");return i.precision==="highp"?e+="\n#define HIGH_PRECISION":i.precision==="mediump"?e+=
"\n#define MEDIUM_PRECISION":i.precision==="lowp"&&(e+="\n#define LOW_PRECISION"),e}var tw={[pa]:"SHADOWMAP_TYPE_PCF",[ao]:"SHADOWMAP_TYPE_VSM"};function nw(i){
return tw[i.shadowMapType]||"SHADOWMAP_TYPE_BASIC"}var iw={[co]:"ENVMAP_MODE_REFRACTION"};function sw(i){return i.envMap===!1?"ENVMAP_MODE_REFLECTION":iw[i.envMapMode]||
"ENVMAP_MODE_REFLECTION"}var rw={[ec]:"ENVMAP_BLENDING_MULTIPLY",[Wm]:"ENVMAP_BLENDING_MIX",[Xm]:"ENVMAP_BLENDING_ADD"};function ow(i){return i.envMap===!1?"ENV\
MAP_BLENDING_NONE":rw[i.combine]||"ENVMAP_BLENDING_NONE"}function aw(i,e,t,n){let s=i.getContext(),r=t.defines,o=t.vertexShader,a=t.fragmentShader,l=nw(t),c=t.envMapPMREM===
!0?"ENVMAP_TYPE_PMREM":"ENVMAP_TYPE_CUBE",d=sw(t),u=ow(t),h=YS(t),f=ZS(r),p=s.createProgram(),x,m,g=t.glslVersion?"#version "+t.glslVersion+"\n":"";t.isRawShaderMaterial?
(x=["#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,f].filter(wa).join("\n"),x.length>0&&(x+="\n"),m=["#define SHADER_TYPE "+t.shaderType,
"#define SHADER_NAME "+t.shaderName,f].filter(wa).join("\n"),m.length>0&&(m+="\n")):(x=[Eg(t),"#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,
f,t.extensionClipCullDistance?"#define USE_CLIP_DISTANCE":"",t.batching?"#define USE_BATCHING":"",t.batchingColor?"#define USE_BATCHING_COLOR":"",t.instancing?"\
#define USE_INSTANCING":"",t.instancingColor?"#define USE_INSTANCING_COLOR":"",t.instancingMorph?"#define USE_INSTANCING_MORPH":"",t.useFog&&t.fog?"#define USE_\
FOG":"",t.useFog&&t.fogExp2?"#define FOG_EXP2":"",t.map?"#define USE_MAP":"",t.envMap?"#define USE_ENVMAP":"",t.envMap?"#define "+d:"",t.lightMap?"#define USE_L\
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
"#define USE_SHADOWMAP":"",t.shadowMapEnabled?"#define "+l:"",t.sizeAttenuation?"#define USE_SIZEATTENUATION":"",t.numLightProbes>0?"#define USE_LIGHT_PROBES":"",
t.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",t.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 modelMatrix;","uni\
form mat4 modelViewMatrix;","uniform mat4 projectionMatrix;","uniform mat4 viewMatrix;","uniform mat3 normalMatrix;","uniform vec3 cameraPosition;","uniform boo\
l isOrthographic;","#ifdef USE_INSTANCING"," attribute mat4 instanceMatrix;","#endif","#ifdef USE_INSTANCING_COLOR"," attribute vec3 instanceColor;","#endif","#\
ifdef USE_INSTANCING_MORPH"," uniform sampler2D morphTexture;","#endif","attribute vec3 position;","attribute vec3 normal;","attribute vec2 uv;","#ifdef USE_UV1",
" attribute vec2 uv1;","#endif","#ifdef USE_UV2"," attribute vec2 uv2;","#endif","#ifdef USE_UV3"," attribute vec2 uv3;","#endif","#ifdef USE_TANGENT"," attribu\
te vec4 tangent;","#endif","#if defined( USE_COLOR_ALPHA )"," attribute vec4 color;","#elif defined( USE_COLOR )"," attribute vec3 color;","#endif","#ifdef USE_\
SKINNING"," attribute vec4 skinIndex;"," attribute vec4 skinWeight;","#endif","\n"].filter(wa).join("\n"),m=[Eg(t),"#define SHADER_TYPE "+t.shaderType,"#define \
SHADER_NAME "+t.shaderName,f,t.useFog&&t.fog?"#define USE_FOG":"",t.useFog&&t.fogExp2?"#define FOG_EXP2":"",t.alphaToCoverage?"#define ALPHA_TO_COVERAGE":"",t.map?
"#define USE_MAP":"",t.matcap?"#define USE_MATCAP":"",t.envMap?"#define USE_ENVMAP":"",t.envMap?"#define "+c:"",t.envMap?"#define "+d:"",t.envMap?"#define "+u:"",
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
DED":"",t.shadowMapEnabled?"#define USE_SHADOWMAP":"",t.shadowMapEnabled?"#define "+l:"",t.premultipliedAlpha?"#define PREMULTIPLIED_ALPHA":"",t.numLightProbes>
0?"#define USE_LIGHT_PROBES":"",t.decodeVideoTexture?"#define DECODE_VIDEO_TEXTURE":"",t.decodeVideoTextureEmissive?"#define DECODE_VIDEO_TEXTURE_EMISSIVE":"",t.
logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",t.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 viewMatrix;","unifor\
m vec3 cameraPosition;","uniform bool isOrthographic;",t.toneMapping!==Hi?"#define TONE_MAPPING":"",t.toneMapping!==Hi?ht.tonemapping_pars_fragment:"",t.toneMapping!==
Hi?$S("toneMapping",t.toneMapping):"",t.dithering?"#define DITHERING":"",t.opaque?"#define OPAQUE":"",ht.colorspace_pars_fragment,WS("linearToOutputTexel",t.outputColorSpace),
qS(),t.useDepthPacking?"#define DEPTH_PACKING "+t.depthPacking:"","\n"].filter(wa).join("\n")),o=fd(o),o=wg(o,t),o=Tg(o,t),a=fd(a),a=wg(a,t),a=Tg(a,t),o=Ag(o),a=
Ag(a),t.isRawShaderMaterial!==!0&&(g="#version 300 es\n",x=[h,"#define attribute in","#define varying out","#define texture2D texture"].join("\n")+"\n"+x,m=["#d\
efine varying in",t.glslVersion===td?"":"layout(location = 0) out highp vec4 pc_fragColor;",t.glslVersion===td?"":"#define gl_FragColor pc_fragColor","#define g\
l_FragDepthEXT gl_FragDepth","#define texture2D texture","#define textureCube texture","#define texture2DProj textureProj","#define texture2DLodEXT textureLod",
"#define texture2DProjLodEXT textureProjLod","#define textureCubeLodEXT textureLod","#define texture2DGradEXT textureGrad","#define texture2DProjGradEXT texture\
ProjGrad","#define textureCubeGradEXT textureGrad"].join("\n")+"\n"+m);let y=g+x+o,S=g+m+a,b=bg(s,s.VERTEX_SHADER,y),C=bg(s,s.FRAGMENT_SHADER,S);s.attachShader(
p,b),s.attachShader(p,C),t.index0AttributeName!==void 0?s.bindAttribLocation(p,0,t.index0AttributeName):t.hasPositionAttribute===!0&&s.bindAttribLocation(p,0,"p\
osition"),s.linkProgram(p);function w(P){if(i.debug.checkShaderErrors){let I=s.getProgramInfoLog(p)||"",F=s.getShaderInfoLog(b)||"",z=s.getShaderInfoLog(C)||"",
D=I.trim(),G=F.trim(),Y=z.trim(),W=!0,ce=!0;if(s.getProgramParameter(p,s.LINK_STATUS)===!1)if(W=!1,typeof i.debug.onShaderError=="function")i.debug.onShaderError(
s,p,b,C);else{let K=Sg(s,b,"vertex"),Q=Sg(s,C,"fragment");Ke("WebGLProgram: Shader Error "+s.getError()+" - VALIDATE_STATUS "+s.getProgramParameter(p,s.VALIDATE_STATUS)+
"\n\nMaterial Name: "+P.name+"\nMaterial Type: "+P.type+"\n\nProgram Info Log: "+D+"\n"+K+"\n"+Q)}else D!==""?qe("WebGLProgram: Program Info Log:",D):(G===""||Y===
"")&&(ce=!1);ce&&(P.diagnostics={runnable:W,programLog:D,vertexShader:{log:G,prefix:x},fragmentShader:{log:Y,prefix:m}})}s.deleteShader(b),s.deleteShader(C),_=new uo(
s,p),M=JS(s,p)}let _;this.getUniforms=function(){return _===void 0&&w(this),_};let M;this.getAttributes=function(){return M===void 0&&w(this),M};let R=t.rendererExtensionParallelShaderCompile===
!1;return this.isReady=function(){return R===!1&&(R=s.getProgramParameter(p,zS)),R},this.destroy=function(){n.releaseStatesOfProgram(this),s.deleteProgram(p),this.
program=void 0},this.type=t.shaderType,this.name=t.shaderName,this.id=VS++,this.cacheKey=e,this.usedTimes=1,this.program=p,this.vertexShader=b,this.fragmentShader=
C,this}var lw=0,pd=class{constructor(){this.shaderCache=new Map,this.materialCache=new Map}update(e,t,n){let s=this._getShaderCacheForMaterial(e);return s.has(t)===
!1&&(s.add(t),t.usedTimes++),s.has(n)===!1&&(s.add(n),n.usedTimes++),this}remove(e){let t=this.materialCache.get(e);for(let n of t)n.usedTimes--,n.usedTimes===0&&
this.shaderCache.delete(n.code);return this.materialCache.delete(e),this}getVertexShaderStage(e){return this._getShaderStage(e.vertexShader)}getFragmentShaderStage(e){
return this._getShaderStage(e.fragmentShader)}dispose(){this.shaderCache.clear(),this.materialCache.clear()}_getShaderCacheForMaterial(e){let t=this.materialCache,
n=t.get(e);return n===void 0&&(n=new Set,t.set(e,n)),n}_getShaderStage(e){let t=this.shaderCache,n=t.get(e);return n===void 0&&(n=new md(e),t.set(e,n)),n}},md=class{constructor(e){
this.id=lw++,this.code=e,this.usedTimes=0}};function cw(i){return i===zs||i===va||i===ba}function hw(i,e,t,n,s,r){let o=new eo,a=new pd,l=new Set,c=[],d=new Map,
u=n.logarithmicDepthBuffer,h={MeshDepthMaterial:"depth",MeshDistanceMaterial:"distance",MeshNormalMaterial:"normal",MeshBasicMaterial:"basic",MeshLambertMaterial:"\
lambert",MeshPhongMaterial:"phong",MeshToonMaterial:"toon",MeshStandardMaterial:"physical",MeshPhysicalMaterial:"physical",MeshMatcapMaterial:"matcap",LineBasicMaterial:"\
basic",LineDashedMaterial:"dashed",PointsMaterial:"points",ShadowMaterial:"shadow",SpriteMaterial:"sprite"};function f(_){return l.add(_),_===0?"uv":"uv".concat(
_)}function p(_,M,R,P,I,F){let z=P.fog,D=I.geometry,G=_.isMeshStandardMaterial||_.isMeshLambertMaterial||_.isMeshPhongMaterial?P.environment:null,Y=_.isMeshStandardMaterial||
_.isMeshLambertMaterial&&!_.envMap||_.isMeshPhongMaterial&&!_.envMap,W=e.get(_.envMap||G,Y),ce=h[_.type],K=n.precision;_.precision!==null&&(K=n.getMaxPrecision(
_.precision),K!==_.precision&&qe("WebGLProgram.getParameters:",_.precision,"not supported, using",K,"instead."));let Q=D.morphAttributes.position||D.morphAttributes.
normal||D.morphAttributes.color,se=Q!==void 0?Q.length:0,de=0;D.morphAttributes.position!==void 0&&(de=1),D.morphAttributes.normal!==void 0&&(de=2),D.morphAttributes.
color!==void 0&&(de=3);let ue,ee,me,xe;if(ce){let Ce=Xi[ce];ue=Ce.vertexShader,ee=Ce.fragmentShader}else{ue=_.vertexShader,ee=_.fragmentShader;let Ce=a.getVertexShaderStage(
_),ot=a.getFragmentShaderStage(_);a.update(_,Ce,ot),me=Ce.id,xe=ot.id}let Ee=i.getRenderTarget(),Me=i.state.buffers.depth.getReversed(),He=I.isInstancedMesh===!0,
nt=I.isBatchedMesh===!0,Ve=!!_.map,ut=!!_.matcap,lt=!!W,et=lt&&W.isPMREMTexture===!0,Gt=!!_.aoMap,Ut=!!_.lightMap,Qt=!!_.bumpMap&&_.wireframe===!1,Pt=!!_.normalMap,
gn=!!_.displacementMap,vt=!!_.emissiveMap,cn=!!_.metalnessMap,$t=!!_.roughnessMap,en=_.anisotropy>0,B=_.clearcoat>0,Re=_.diffuseRoughness>0,$e=_.dispersion>0,it=_.
retroreflectivity>0,Se=_.iridescence>0,Lt=_.sheen>0,ze=_.transmission>0,Xe=en&&!!_.anisotropyMap,L=B&&!!_.clearcoatMap,T=B&&!!_.clearcoatNormalMap,$=B&&!!_.clearcoatRoughnessMap,
he=Re&&!!_.diffuseRoughnessMap,oe=Se&&!!_.iridescenceMap,_e=Se&&!!_.iridescenceThicknessMap,ye=Lt&&!!_.sheenColorMap,te=Lt&&!!_.sheenRoughnessMap,ie=!!_.specularMap,
pe=!!_.specularColorMap,O=!!_.specularIntensityMap,re=ze&&!!_.transmissionMap,ne=ze&&!!_.thicknessMap,we=!!_.gradientMap,ge=!!_.alphaMap,be=_.alphaTest>0,Ge=!!_.
alphaHash,Ze=!!_.extensions,le=Hi;_.toneMapped&&(Ee===null||Ee.isXRRenderTarget===!0)&&(le=i.toneMapping);let Oe=et?W.isCompressedCubeTexture?W.image[0].mipmaps:
W.mipmaps:null,Je={shaderID:ce,shaderType:_.type,shaderName:_.name,vertexShader:ue,fragmentShader:ee,defines:_.defines,customVertexShaderID:me,customFragmentShaderID:xe,
isRawShaderMaterial:_.isRawShaderMaterial===!0,glslVersion:_.glslVersion,precision:K,batching:nt,batchingColor:nt&&I._colorsTexture!==null,instancing:He,instancingColor:He&&
I.instanceColor!==null,instancingMorph:He&&I.morphTexture!==null,outputColorSpace:Ee===null?i.outputColorSpace:Ee.isXRRenderTarget===!0?Ee.texture.colorSpace:_t.
workingColorSpace,alphaToCoverage:!!_.alphaToCoverage,map:Ve,matcap:ut,envMap:lt,envMapMode:lt&&W.mapping,envMapPMREM:et,envMapMaxLod:et?Oe.length-1:null,envMapSize:et?
Oe[0].width:null,aoMap:Gt,lightMap:Ut,bumpMap:Qt,normalMap:Pt,displacementMap:gn,emissiveMap:vt,normalMapObjectSpace:Pt&&_.normalMapType===Ym,normalMapTangentSpace:Pt&&
_.normalMapType===Vc,packedNormalMap:Pt&&_.normalMapType===Vc&&cw(_.normalMap.format),metalnessMap:cn,roughnessMap:$t,anisotropy:en,anisotropyMap:Xe,clearcoat:B,
clearcoatMap:L,clearcoatNormalMap:T,clearcoatRoughnessMap:$,diffuseRoughness:Re,diffuseRoughnessMap:he,dispersion:$e,retroreflection:it,iridescence:Se,iridescenceMap:oe,
iridescenceThicknessMap:_e,sheen:Lt,sheenColorMap:ye,sheenRoughnessMap:te,specularMap:ie,specularColorMap:pe,specularIntensityMap:O,transmission:ze,transmissionMap:re,
thicknessMap:ne,gradientMap:we,opaque:_.transparent===!1&&_.blending===lo&&_.alphaToCoverage===!1,alphaMap:ge,alphaTest:be,alphaHash:Ge,combine:_.combine,mapUv:Ve&&
f(_.map.channel),aoMapUv:Gt&&f(_.aoMap.channel),lightMapUv:Ut&&f(_.lightMap.channel),bumpMapUv:Qt&&f(_.bumpMap.channel),normalMapUv:Pt&&f(_.normalMap.channel),displacementMapUv:gn&&
f(_.displacementMap.channel),emissiveMapUv:vt&&f(_.emissiveMap.channel),metalnessMapUv:cn&&f(_.metalnessMap.channel),roughnessMapUv:$t&&f(_.roughnessMap.channel),
anisotropyMapUv:Xe&&f(_.anisotropyMap.channel),clearcoatMapUv:L&&f(_.clearcoatMap.channel),clearcoatNormalMapUv:T&&f(_.clearcoatNormalMap.channel),clearcoatRoughnessMapUv:$&&
f(_.clearcoatRoughnessMap.channel),diffuseRoughnessMapUv:he&&f(_.diffuseRoughnessMap.channel),iridescenceMapUv:oe&&f(_.iridescenceMap.channel),iridescenceThicknessMapUv:_e&&
f(_.iridescenceThicknessMap.channel),sheenColorMapUv:ye&&f(_.sheenColorMap.channel),sheenRoughnessMapUv:te&&f(_.sheenRoughnessMap.channel),specularMapUv:ie&&f(_.
specularMap.channel),specularColorMapUv:pe&&f(_.specularColorMap.channel),specularIntensityMapUv:O&&f(_.specularIntensityMap.channel),transmissionMapUv:re&&f(_.
transmissionMap.channel),thicknessMapUv:ne&&f(_.thicknessMap.channel),alphaMapUv:ge&&f(_.alphaMap.channel),vertexTangents:!!D.attributes.tangent&&(Pt||en),vertexNormals:!!D.
attributes.normal,vertexColors:_.vertexColors,vertexAlphas:_.vertexColors===!0&&!!D.attributes.color&&D.attributes.color.itemSize===4,pointsUvs:I.isPoints===!0&&
!!D.attributes.uv&&(Ve||ge),fog:!!z,useFog:_.fog===!0,fogExp2:!!z&&z.isFogExp2,flatShading:_.wireframe===!1&&(_.flatShading===!0||D.attributes.normal===void 0&&
Pt===!1&&(_.isMeshLambertMaterial||_.isMeshPhongMaterial||_.isMeshStandardMaterial||_.isMeshPhysicalMaterial)),sizeAttenuation:_.sizeAttenuation===!0,logarithmicDepthBuffer:u,
reversedDepthBuffer:Me,skinning:I.isSkinnedMesh===!0,hasPositionAttribute:D.attributes.position!==void 0,morphTargets:D.morphAttributes.position!==void 0,morphNormals:D.
morphAttributes.normal!==void 0,morphColors:D.morphAttributes.color!==void 0,morphTargetsCount:se,morphTextureStride:de,numSunLights:M.sun.length,numDirLights:M.
directional.length,numPointLights:M.point.length,numSpotLights:M.spot.length,numSpotLightMaps:M.spotLightMap.length,numRectAreaLights:M.rectArea.length,numHemiLights:M.
hemi.length,numSunLightShadows:M.sunShadowMap.length,numDirLightShadows:M.directionalShadowMap.length,numPointLightShadows:M.pointShadowMap.length,numSpotLightShadows:M.
spotShadowMap.length,numSpotLightShadowsWithMaps:M.numSpotLightShadowsWithMaps,numLightProbes:M.numLightProbes,numLightProbeGrids:F.filter(Ce=>Ce.texture!==null).
length,numClippingPlanes:r.numPlanes,numClipIntersection:r.numIntersection,dithering:_.dithering,shadowMapEnabled:i.shadowMap.enabled&&R.length>0,shadowMapType:i.
shadowMap.type,toneMapping:le,decodeVideoTexture:Ve&&_.map.isVideoTexture===!0&&_t.getTransfer(_.map.colorSpace)===At,decodeVideoTextureEmissive:vt&&_.emissiveMap.
isVideoTexture===!0&&_t.getTransfer(_.emissiveMap.colorSpace)===At,premultipliedAlpha:_.premultipliedAlpha,doubleSided:_.side===Gi,flipSided:_.side===zn,useDepthPacking:_.
depthPacking>=0,depthPacking:_.depthPacking||0,index0AttributeName:_.index0AttributeName,extensionClipCullDistance:Ze&&_.extensions.clipCullDistance===!0&&t.has(
"WEBGL_clip_cull_distance"),extensionMultiDraw:(Ze&&_.extensions.multiDraw===!0||nt)&&t.has("WEBGL_multi_draw"),rendererExtensionParallelShaderCompile:t.has("KH\
R_parallel_shader_compile"),customProgramCacheKey:_.customProgramCacheKey()};return Je.vertexUv1s=l.has(1),Je.vertexUv2s=l.has(2),Je.vertexUv3s=l.has(3),l.clear(),
Je}function x(_){let M=[];if(_.shaderID?M.push(_.shaderID):(M.push(_.customVertexShaderID),M.push(_.customFragmentShaderID)),_.defines!==void 0)for(let R in _.defines)
M.push(R),M.push(_.defines[R]);return _.isRawShaderMaterial===!1&&(m(M,_),g(M,_),M.push(i.outputColorSpace)),M.push(_.customProgramCacheKey),M.join()}function m(_,M){
_.push(M.precision),_.push(M.outputColorSpace),_.push(M.envMapMode),_.push(M.envMapPMREM),_.push(M.envMapMaxLod),_.push(M.envMapSize),_.push(M.mapUv),_.push(M.alphaMapUv),
_.push(M.lightMapUv),_.push(M.aoMapUv),_.push(M.bumpMapUv),_.push(M.normalMapUv),_.push(M.displacementMapUv),_.push(M.emissiveMapUv),_.push(M.metalnessMapUv),_.
push(M.roughnessMapUv),_.push(M.anisotropyMapUv),_.push(M.clearcoatMapUv),_.push(M.clearcoatNormalMapUv),_.push(M.clearcoatRoughnessMapUv),_.push(M.diffuseRoughnessMapUv),
_.push(M.iridescenceMapUv),_.push(M.iridescenceThicknessMapUv),_.push(M.sheenColorMapUv),_.push(M.sheenRoughnessMapUv),_.push(M.specularMapUv),_.push(M.specularColorMapUv),
_.push(M.specularIntensityMapUv),_.push(M.transmissionMapUv),_.push(M.thicknessMapUv),_.push(M.combine),_.push(M.fogExp2),_.push(M.sizeAttenuation),_.push(M.morphTargetsCount),
_.push(M.numSunLights),_.push(M.numDirLights),_.push(M.numPointLights),_.push(M.numSpotLights),_.push(M.numSpotLightMaps),_.push(M.numHemiLights),_.push(M.numRectAreaLights),
_.push(M.numSunLightShadows),_.push(M.numDirLightShadows),_.push(M.numPointLightShadows),_.push(M.numSpotLightShadows),_.push(M.numSpotLightShadowsWithMaps),_.push(
M.numLightProbes),_.push(M.numLightProbeGrids),_.push(M.shadowMapType),_.push(M.toneMapping),_.push(M.numClippingPlanes),_.push(M.numClipIntersection),_.push(M.
depthPacking)}function g(_,M){o.disableAll(),M.instancing&&o.enable(0),M.instancingColor&&o.enable(1),M.instancingMorph&&o.enable(2),M.matcap&&o.enable(3),M.envMap&&
o.enable(4),M.normalMapObjectSpace&&o.enable(5),M.normalMapTangentSpace&&o.enable(6),M.clearcoat&&o.enable(7),M.iridescence&&o.enable(8),M.alphaTest&&o.enable(9),
M.vertexColors&&o.enable(10),M.vertexAlphas&&o.enable(11),M.vertexUv1s&&o.enable(12),M.vertexUv2s&&o.enable(13),M.vertexUv3s&&o.enable(14),M.vertexTangents&&o.enable(
15),M.anisotropy&&o.enable(16),M.alphaHash&&o.enable(17),M.batching&&o.enable(18),M.dispersion&&o.enable(19),M.retroreflection&&o.enable(24),M.diffuseRoughness&&
o.enable(25),M.batchingColor&&o.enable(20),M.gradientMap&&o.enable(21),M.packedNormalMap&&o.enable(22),M.vertexNormals&&o.enable(23),_.push(o.mask),o.disableAll(),
M.fog&&o.enable(0),M.useFog&&o.enable(1),M.flatShading&&o.enable(2),M.logarithmicDepthBuffer&&o.enable(3),M.reversedDepthBuffer&&o.enable(4),M.skinning&&o.enable(
5),M.morphTargets&&o.enable(6),M.morphNormals&&o.enable(7),M.morphColors&&o.enable(8),M.premultipliedAlpha&&o.enable(9),M.shadowMapEnabled&&o.enable(10),M.doubleSided&&
o.enable(11),M.flipSided&&o.enable(12),M.useDepthPacking&&o.enable(13),M.dithering&&o.enable(14),M.transmission&&o.enable(15),M.sheen&&o.enable(16),M.opaque&&o.
enable(17),M.pointsUvs&&o.enable(18),M.decodeVideoTexture&&o.enable(19),M.decodeVideoTextureEmissive&&o.enable(20),M.alphaToCoverage&&o.enable(21),M.numLightProbeGrids>
0&&o.enable(22),M.hasPositionAttribute&&o.enable(23),_.push(o.mask)}function y(_){let M=h[_.type],R;if(M){let P=Xi[M];R=lg.clone(P.uniforms)}else R=_.uniforms;return R}
function S(_,M){let R=d.get(M);return R!==void 0?++R.usedTimes:(R=new aw(i,M,_,s),c.push(R),d.set(M,R)),R}function b(_){if(--_.usedTimes===0){let M=c.indexOf(_);
c[M]=c[c.length-1],c.pop(),d.delete(_.cacheKey),_.destroy()}}function C(_){a.remove(_)}function w(){a.dispose()}return{getParameters:p,getProgramCacheKey:x,getUniforms:y,
acquireProgram:S,releaseProgram:b,releaseShaderCache:C,programs:c,dispose:w}}function uw(){let i=new WeakMap;function e(o){return i.has(o)}function t(o){let a=i.
get(o);return a===void 0&&(a={},i.set(o,a)),a}function n(o){i.delete(o)}function s(o,a,l){i.get(o)[a]=l}function r(){i=new WeakMap}return{has:e,get:t,remove:n,update:s,
dispose:r}}function dw(i,e){return i.groupOrder!==e.groupOrder?i.groupOrder-e.groupOrder:i.renderOrder!==e.renderOrder?i.renderOrder-e.renderOrder:i.material.id!==
e.material.id?i.material.id-e.material.id:i.materialVariant!==e.materialVariant?i.materialVariant-e.materialVariant:i.z!==e.z?i.z-e.z:i.id-e.id}function Cg(i,e){
return i.groupOrder!==e.groupOrder?i.groupOrder-e.groupOrder:i.renderOrder!==e.renderOrder?i.renderOrder-e.renderOrder:i.z!==e.z?e.z-i.z:i.id-e.id}function Rg(){
let i=[],e=0,t=[],n=[],s=[];function r(){e=0,t.length=0,n.length=0,s.length=0}function o(h){let f=0;return h.isInstancedMesh&&(f+=2),h.isSkinnedMesh&&(f+=1),f}function a(h,f,p,x,m,g){
let y=i[e];return y===void 0?(y={id:h.id,object:h,geometry:f,material:p,materialVariant:o(h),groupOrder:x,renderOrder:h.renderOrder,z:m,group:g},i[e]=y):(y.id=h.
id,y.object=h,y.geometry=f,y.material=p,y.materialVariant=o(h),y.groupOrder=x,y.renderOrder=h.renderOrder,y.z=m,y.group=g),e++,y}function l(h,f,p,x,m,g,y){y.reversedDepth===
!0&&(m=-m);let S=a(h,f,p,x,m,g);p.transmission>0?n.push(S):p.transparent===!0?s.push(S):t.push(S)}function c(h,f,p,x,m,g){let y=a(h,f,p,x,m,g);p.transmission>0?
n.unshift(y):p.transparent===!0?s.unshift(y):t.unshift(y)}function d(h,f){t.length>1&&t.sort(h||dw),n.length>1&&n.sort(f||Cg),s.length>1&&s.sort(f||Cg)}function u(){
for(let h=e,f=i.length;h<f;h++){let p=i[h];if(p.id===null)break;p.id=null,p.object=null,p.geometry=null,p.material=null,p.group=null}}return{opaque:t,transmissive:n,
transparent:s,init:r,push:l,unshift:c,finish:u,sort:d}}function fw(){let i=new WeakMap;function e(n,s){let r=i.get(n),o;return r===void 0?(o=new Rg,i.set(n,[o])):
s>=r.length?(o=new Rg,r.push(o)):o=r[s],o}function t(){i=new WeakMap}return{get:e,dispose:t}}function pw(){let i={};return{get:function(e){if(i[e.id]!==void 0)return i[e.
id];let t;switch(e.type){case"SunLight":case"DirectionalLight":t={direction:new V,color:new rt};break;case"SpotLight":t={position:new V,direction:new V,color:new rt,
distance:0,coneCos:0,penumbraCos:0,decay:0};break;case"PointLight":t={position:new V,color:new rt,distance:0,decay:0};break;case"HemisphereLight":t={direction:new V,
skyColor:new rt,groundColor:new rt};break;case"RectAreaLight":t={color:new rt,position:new V,halfWidth:new V,halfHeight:new V};break}return i[e.id]=t,t}}}function mw(){
let i={};return{get:function(e){if(i[e.id]!==void 0)return i[e.id];let t;switch(e.type){case"SunLight":case"DirectionalLight":t={shadowIntensity:1,shadowBias:0,
shadowNormalBias:0,shadowRadius:1,shadowMapSize:new st};break;case"SpotLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new st};
break;case"PointLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new st,shadowCameraNear:1,shadowCameraFar:1e3};break}return i[e.
id]=t,t}}}var gw=0;function _w(i,e){return(e.castShadow?2:0)-(i.castShadow?2:0)+(e.map?1:0)-(i.map?1:0)}function xw(i){let e=new pw,t=mw(),n={version:0,hash:{sunLength:-1,
directionalLength:-1,pointLength:-1,spotLength:-1,rectAreaLength:-1,hemiLength:-1,numSunShadows:-1,numDirectionalShadows:-1,numPointShadows:-1,numSpotShadows:-1,
numSpotMaps:-1,numLightProbes:-1},ambient:[0,0,0],probe:[],sun:[],sunShadow:[],sunShadowMap:[],sunShadowMatrix:[],sunShadowCascade:[],directional:[],directionalShadow:[],
directionalShadowMap:[],directionalShadowMatrix:[],spot:[],spotLightMap:[],spotShadow:[],spotShadowMap:[],spotLightMatrix:[],rectArea:[],rectAreaLTC1:null,rectAreaLTC2:null,
point:[],pointShadow:[],pointShadowMap:[],pointShadowMatrix:[],hemi:[],numSpotLightShadowsWithMaps:0,numLightProbes:0};for(let c=0;c<9;c++)n.probe.push(new V);let s=new V,
r=new xt,o=new xt;function a(c){let d=0,u=0,h=0;for(let F=0;F<9;F++)n.probe[F].set(0,0,0);let f=0,p=0,x=0,m=0,g=0,y=0,S=0,b=0,C=0,w=0,_=0,M=0,R=0,P=0;c.sort(_w);
for(let F=0,z=c.length;F<z;F++){let D=c[F],G=D.color,Y=D.intensity,W=D.distance,ce=null;if(D.shadow&&D.shadow.map&&(D.shadow.map.texture.format===zs?ce=D.shadow.
map.texture:ce=D.shadow.map.depthTexture||D.shadow.map.texture),D.isAmbientLight)d+=G.r*Y,u+=G.g*Y,h+=G.b*Y;else if(D.isLightProbe){for(let K=0;K<9;K++)n.probe[K].
addScaledVector(D.sh.coefficients[K],Y);P++}else if(D.isSunLight){let K=e.get(D);if(K.color.copy(D.color).multiplyScalar(D.intensity),D.castShadow){let Q=D.shadow,
se=t.get(D);se.shadowIntensity=Q.intensity,se.shadowBias=Q.bias,se.shadowNormalBias=Q.normalBias,se.shadowRadius=Q.radius,se.shadowMapSize.copy(Q.mapSize).multiply(
Q.getFrameExtents()),n.sunShadow[p]=se,n.sunShadowMap[p]=ce;let de=Q.getViewportCount();for(let ue=0;ue<de;ue++)n.sunShadowMatrix[x+ue]=Q.getMatrix(ue),n.sunShadowCascade[x+
ue]=Q._cascadeData[ue];x+=de,p++}n.sun[f]=K,f++}else if(D.isDirectionalLight){let K=e.get(D);if(K.color.copy(D.color).multiplyScalar(D.intensity),D.castShadow){
let Q=D.shadow,se=t.get(D);se.shadowIntensity=Q.intensity,se.shadowBias=Q.bias,se.shadowNormalBias=Q.normalBias,se.shadowRadius=Q.radius,se.shadowMapSize=Q.mapSize,
n.directionalShadow[m]=se,n.directionalShadowMap[m]=ce,n.directionalShadowMatrix[m]=D.shadow.matrix,C++}n.directional[m]=K,m++}else if(D.isSpotLight){let K=e.get(
D);K.position.setFromMatrixPosition(D.matrixWorld),K.color.copy(G).multiplyScalar(Y),K.distance=W,K.coneCos=Math.cos(D.angle),K.penumbraCos=Math.cos(D.angle*(1-
D.penumbra)),K.decay=D.decay,n.spot[y]=K;let Q=D.shadow;if(D.map&&(n.spotLightMap[M]=D.map,M++,Q.updateMatrices(D),D.castShadow&&R++),n.spotLightMatrix[y]=Q.matrix,
D.castShadow){let se=t.get(D);se.shadowIntensity=Q.intensity,se.shadowBias=Q.bias,se.shadowNormalBias=Q.normalBias,se.shadowRadius=Q.radius,se.shadowMapSize=Q.mapSize,
n.spotShadow[y]=se,n.spotShadowMap[y]=ce,_++}y++}else if(D.isRectAreaLight){let K=e.get(D);K.color.copy(G).multiplyScalar(Y),K.halfWidth.set(D.width*.5,0,0),K.halfHeight.
set(0,D.height*.5,0),n.rectArea[S]=K,S++}else if(D.isPointLight){let K=e.get(D);if(K.color.copy(D.color).multiplyScalar(D.intensity),K.distance=D.distance,K.decay=
D.decay,D.castShadow){let Q=D.shadow,se=t.get(D);se.shadowIntensity=Q.intensity,se.shadowBias=Q.bias,se.shadowNormalBias=Q.normalBias,se.shadowRadius=Q.radius,se.
shadowMapSize=Q.mapSize,se.shadowCameraNear=Q.camera.near,se.shadowCameraFar=Q.camera.far,n.pointShadow[g]=se,n.pointShadowMap[g]=ce,n.pointShadowMatrix[g]=D.shadow.
matrix,w++}n.point[g]=K,g++}else if(D.isHemisphereLight){let K=e.get(D);K.skyColor.copy(D.color).multiplyScalar(Y),K.groundColor.copy(D.groundColor).multiplyScalar(
Y),n.hemi[b]=K,b++}}S>0&&(i.has("OES_texture_float_linear")===!0?(n.rectAreaLTC1=Le.LTC_FLOAT_1,n.rectAreaLTC2=Le.LTC_FLOAT_2):(n.rectAreaLTC1=Le.LTC_HALF_1,n.rectAreaLTC2=
Le.LTC_HALF_2)),n.ambient[0]=d,n.ambient[1]=u,n.ambient[2]=h;let I=n.hash;(I.sunLength!==f||I.directionalLength!==m||I.pointLength!==g||I.spotLength!==y||I.rectAreaLength!==
S||I.hemiLength!==b||I.numSunShadows!==p||I.numDirectionalShadows!==C||I.numPointShadows!==w||I.numSpotShadows!==_||I.numSpotMaps!==M||I.numLightProbes!==P)&&(n.
sun.length=f,n.directional.length=m,n.spot.length=y,n.rectArea.length=S,n.point.length=g,n.hemi.length=b,n.sunShadow.length=p,n.sunShadowMap.length=p,n.sunShadowMatrix.
length=x,n.sunShadowCascade.length=x,n.directionalShadow.length=C,n.directionalShadowMap.length=C,n.directionalShadowMatrix.length=C,n.pointShadow.length=w,n.pointShadowMap.
length=w,n.pointShadowMatrix.length=w,n.spotShadow.length=_,n.spotShadowMap.length=_,n.spotLightMatrix.length=_+M-R,n.spotLightMap.length=M,n.numSpotLightShadowsWithMaps=
R,n.numLightProbes=P,I.sunLength=f,I.directionalLength=m,I.pointLength=g,I.spotLength=y,I.rectAreaLength=S,I.hemiLength=b,I.numSunShadows=p,I.numDirectionalShadows=
C,I.numPointShadows=w,I.numSpotShadows=_,I.numSpotMaps=M,I.numLightProbes=P,n.version=gw++)}function l(c,d){let u=0,h=0,f=0,p=0,x=0,m=0,g=d.matrixWorldInverse;for(let y=0,
S=c.length;y<S;y++){let b=c[y];if(b.isSunLight){let C=n.sun[u];C.direction.setFromMatrixPosition(b.matrixWorld),C.direction.transformDirection(g),u++}else if(b.
isDirectionalLight){let C=n.directional[h];C.direction.setFromMatrixPosition(b.matrixWorld),s.setFromMatrixPosition(b.target.matrixWorld),C.direction.sub(s),C.direction.
transformDirection(g),h++}else if(b.isSpotLight){let C=n.spot[p];C.position.setFromMatrixPosition(b.matrixWorld),C.position.applyMatrix4(g),C.direction.setFromMatrixPosition(
b.matrixWorld),s.setFromMatrixPosition(b.target.matrixWorld),C.direction.sub(s),C.direction.transformDirection(g),p++}else if(b.isRectAreaLight){let C=n.rectArea[x];
C.position.setFromMatrixPosition(b.matrixWorld),C.position.applyMatrix4(g),o.identity(),r.copy(b.matrixWorld),r.premultiply(g),o.extractRotation(r),C.halfWidth.
set(b.width*.5,0,0),C.halfHeight.set(0,b.height*.5,0),C.halfWidth.applyMatrix4(o),C.halfHeight.applyMatrix4(o),x++}else if(b.isPointLight){let C=n.point[f];C.position.
setFromMatrixPosition(b.matrixWorld),C.position.applyMatrix4(g),f++}else if(b.isHemisphereLight){let C=n.hemi[m];C.direction.setFromMatrixPosition(b.matrixWorld),
C.direction.transformDirection(g),m++}}}return{setup:a,setupView:l,state:n}}function Pg(i){let e=new xw(i),t=[],n=[],s=[];function r(u){d.camera=u,t.length=0,n.
length=0,s.length=0}function o(u){u.isLightProbeGrid?s.push(u):t.push(u)}function a(u){n.push(u)}function l(){e.setup(t),s.sort((u,h)=>u.priority-h.priority||u.
id-h.id)}function c(u){e.setupView(t,u)}let d={lightsArray:t,shadowsArray:n,lightProbeGridArray:s,camera:null,lights:e,transmissionRenderTarget:{},textureUnits:0};
return{init:r,state:d,setupLights:l,setupLightsView:c,pushLight:o,pushShadow:a}}function yw(i){let e=new WeakMap;function t(s,r=0){let o=e.get(s),a;return o===void 0?
(a=new Pg(i),e.set(s,[a])):r>=o.length?(a=new Pg(i),o.push(a)):a=o[r],a}function n(){e=new WeakMap}return{get:t,dispose:n}}var vw="void main() {\n gl_Position = \
vec4( position, 1.0 );\n}",bw="uniform sampler2D shadow_pass;\nuniform vec2 resolution;\nuniform float radius;\nvoid main() {\n const float samples = float( VSM_SAM\
PLES );\n float mean = 0.0;\n float squared_mean = 0.0;\n float uvStride = samples <= 1.0 ? 0.0 : 2.0 / ( samples - 1.0 );\n float uvStart = samples <= 1.0 ? 0.0 : \
- 1.0;\n for ( float i = 0.0; i < samples; i ++ ) {\n  float uvOffset = uvStart + i * uvStride;\n  #ifdef HORIZONTAL_PASS\n   vec2 distribution = texture2D( shadow_\
pass, ( gl_FragCoord.xy + vec2( uvOffset, 0.0 ) * radius ) / resolution ).rg;\n   mean += distribution.x;\n   squared_mean += distribution.y * distribution.y + di\
stribution.x * distribution.x;\n  #else\n   float depth = texture2D( shadow_pass, ( gl_FragCoord.xy + vec2( 0.0, uvOffset ) * radius ) / resolution ).r;\n   mean +\
= depth;\n   squared_mean += depth * depth;\n  #endif\n }\n mean = mean / samples;\n squared_mean = squared_mean / samples;\n float std_dev = sqrt( max( 0.0, squared_\
mean - mean * mean ) );\n gl_FragColor = vec4( mean, std_dev, 0.0, 1.0 );\n}",Mw=[new V(1,0,0),new V(-1,0,0),new V(0,1,0),new V(0,-1,0),new V(0,0,1),new V(0,0,-1)],
Sw=[new V(0,-1,0),new V(0,-1,0),new V(0,0,1),new V(0,0,-1),new V(0,-1,0),new V(0,-1,0)],Ig=new xt,Sa=new V,cd=new V;function ww(i,e,t){let n=new Ls,s=new st,r=new st,
o=new Wt,a=new zl,l=new Vl,c={},d=t.maxTextureSize,u={[ks]:zn,[zn]:ks,[Gi]:Gi},h=new Vi({defines:{VSM_SAMPLES:8},uniforms:{shadow_pass:{value:null},resolution:{
value:new st},radius:{value:4}},vertexShader:vw,fragmentShader:bw}),f=h.clone();f.defines.HORIZONTAL_PASS=1;let p=new ln;p.setAttribute("position",new Mi(new Float32Array(
[-1,-1,.5,3,-1,.5,-1,3,.5]),3));let x=new ui(p,h),m=this;this.enabled=!1,this.autoUpdate=!0,this.needsUpdate=!1,this.type=pa;let g=this.type;this.render=function(w,_,M){
if(m.enabled===!1||m.autoUpdate===!1&&m.needsUpdate===!1||w.length===0)return;this.type===Tm&&(qe("WebGLShadowMap: PCFSoftShadowMap has been removed. Using PCFS\
hadowMap instead."),this.type=pa);let R=i.getRenderTarget(),P=i.getActiveCubeFace(),I=i.getActiveMipmapLevel(),F=i.state;F.setBlending(rr),F.buffers.depth.getReversed()===
!0?F.buffers.color.setClear(0,0,0,0):F.buffers.color.setClear(1,1,1,1),F.buffers.depth.setTest(!0),F.setScissorTest(!1);let z=g!==this.type;z&&_.traverse(function(D){
D.material&&(Array.isArray(D.material)?D.material.forEach(G=>G.needsUpdate=!0):D.material.needsUpdate=!0)});for(let D=0,G=w.length;D<G;D++){let Y=w[D],W=Y.shadow;
if(W===void 0){qe("WebGLShadowMap:",Y,"has no shadow.");continue}if(W.autoUpdate===!1&&W.needsUpdate===!1)continue;s.copy(W.mapSize);let ce=W.getFrameExtents();
s.multiply(ce),r.copy(W.mapSize),(s.x>d||s.y>d)&&(s.x>d&&(r.x=Math.floor(d/ce.x),s.x=r.x*ce.x,W.mapSize.x=r.x),s.y>d&&(r.y=Math.floor(d/ce.y),s.y=r.y*ce.y,W.mapSize.
y=r.y));let K=i.state.buffers.depth.getReversed();if(W.camera._reversedDepth=K,W.map===null||z===!0){if(W.map!==null&&(W.map.depthTexture!==null&&(W.map.depthTexture.
dispose(),W.map.depthTexture=null),W.map.dispose()),this.type===ao){if(Y.isPointLight){qe("WebGLShadowMap: VSM shadow maps are not supported for PointLights. Us\
e PCF or BasicShadowMap instead.");continue}W.map=new ni(s.x,s.y,{format:zs,type:wi,minFilter:Bn,magFilter:Bn,generateMipmaps:!1}),W.map.texture.name=Y.name+".s\
hadowMap",W.map.depthTexture=new us(s.x,s.y,di),W.map.depthTexture.name=Y.name+".shadowMapDepth",W.map.depthTexture.format=os,W.map.depthTexture.compareFunction=
null,W.map.depthTexture.minFilter=Mn,W.map.depthTexture.magFilter=Mn}else Y.isPointLight?(W.map=new Ta(s.x),W.map.depthTexture=new jo(s.x,Si)):(W.map=new ni(s.x,
s.y),W.map.depthTexture=new us(s.x,s.y,Si)),W.map.depthTexture.name=Y.name+".shadowMap",W.map.depthTexture.format=os,this.type===pa?(W.map.depthTexture.compareFunction=
K?Qu:ju,W.map.depthTexture.minFilter=Bn,W.map.depthTexture.magFilter=Bn):(W.map.depthTexture.compareFunction=null,W.map.depthTexture.minFilter=Mn,W.map.depthTexture.
magFilter=Mn);W.camera.updateProjectionMatrix()}W.map.isWebGLCubeRenderTarget!==!0&&(W.map.width!==s.x||W.map.height!==s.y)&&W.map.setSize(s.x,s.y);let Q=W.map.
isWebGLCubeRenderTarget?6:W.getViewportCount();Y.isPointLight!==!0&&W.updateMatrices(Y,M);let se=(W.camera.layers.mask&4294967294)!==0?W.camera.layers:M.layers;
for(let de=0;de<Q;de++){let ue=W.getCamera(de);if(Y.isPointLight){let ee=W.camera,me=W.matrix,xe=Y.distance||ee.far;xe!==ee.far&&(ee.far=xe,ee.updateProjectionMatrix()),
Sa.setFromMatrixPosition(Y.matrixWorld),ee.position.copy(Sa),cd.copy(ee.position),cd.add(Mw[de]),ee.up.copy(Sw[de]),ee.lookAt(cd),ee.updateMatrixWorld(),me.makeTranslation(
-Sa.x,-Sa.y,-Sa.z),Ig.multiplyMatrices(ee.projectionMatrix,ee.matrixWorldInverse),W._frustum.setFromProjectionMatrix(Ig,ee.coordinateSystem,ee.reversedDepth)}if(W.
map.isWebGLCubeRenderTarget)i.setRenderTarget(W.map,de),i.clear();else{de===0&&(i.setRenderTarget(W.map),i.clear());let ee=W.getViewport(de);o.set(r.x*ee.x,r.y*
ee.y,r.x*ee.z,r.y*ee.w),F.viewport(o)}n=W.getFrustum(de),b(_,M,ue,Y,se,this.type)}W.isPointLightShadow!==!0&&this.type===ao&&y(W,M),W.needsUpdate=!1}g=this.type,
m.needsUpdate=!1,i.setRenderTarget(R,P,I)};function y(w,_){let M=e.update(x);h.defines.VSM_SAMPLES!==w.blurSamples&&(h.defines.VSM_SAMPLES=w.blurSamples,f.defines.
VSM_SAMPLES=w.blurSamples,h.needsUpdate=!0,f.needsUpdate=!0),w.mapPass===null?w.mapPass=new ni(s.x,s.y,{format:zs,type:wi}):(w.mapPass.width!==w.map.width||w.mapPass.
height!==w.map.height)&&w.mapPass.setSize(w.map.width,w.map.height),h.uniforms.shadow_pass.value=w.map.depthTexture,h.uniforms.resolution.value.set(w.map.width,
w.map.height),h.uniforms.radius.value=w.radius,i.setRenderTarget(w.mapPass),i.clear(),i.renderBufferDirect(_,null,M,h,x,null),f.uniforms.shadow_pass.value=w.mapPass.
texture,f.uniforms.resolution.value.set(w.map.width,w.map.height),f.uniforms.radius.value=w.radius,i.setRenderTarget(w.map),i.clear(),i.renderBufferDirect(_,null,
M,f,x,null)}function S(w,_,M,R){let P=null,I=M.isPointLight===!0?w.customDistanceMaterial:w.customDepthMaterial;if(I!==void 0)P=I;else if(P=M.isPointLight===!0?
l:a,i.localClippingEnabled&&_.clipShadows===!0&&Array.isArray(_.clippingPlanes)&&_.clippingPlanes.length!==0||_.displacementMap&&_.displacementScale!==0||_.alphaMap&&
_.alphaTest>0||_.map&&_.alphaTest>0||_.alphaToCoverage===!0){let F=P.uuid,z=_.uuid,D=c[F];D===void 0&&(D={},c[F]=D);let G=D[z];G===void 0&&(G=P.clone(),D[z]=G,_.
addEventListener("dispose",C)),P=G}if(P.visible=_.visible,P.wireframe=_.wireframe,R===ao?P.side=_.shadowSide!==null?_.shadowSide:_.side:P.side=_.shadowSide!==null?
_.shadowSide:u[_.side],P.alphaMap=_.alphaMap,P.alphaTest=_.alphaToCoverage===!0?.5:_.alphaTest,P.map=_.map,P.clipShadows=_.clipShadows,P.clippingPlanes=_.clippingPlanes,
P.clipIntersection=_.clipIntersection,P.displacementMap=_.displacementMap,P.displacementScale=_.displacementScale,P.displacementBias=_.displacementBias,P.wireframeLinewidth=
_.wireframeLinewidth,P.linewidth=_.linewidth,M.isPointLight===!0&&P.isMeshDistanceMaterial===!0){let F=i.properties.get(P);F.light=M}return P}function b(w,_,M,R,P,I){
if(w.visible===!1)return;if(w.layers.test(P)&&(w.isMesh||w.isLine||w.isPoints)&&(w.castShadow||w.receiveShadow&&I===ao)&&(!w.frustumCulled||w.intersectsFrustum(
n))){w.modelViewMatrix.multiplyMatrices(M.matrixWorldInverse,w.matrixWorld);let D=e.update(w),G=w.material;if(Array.isArray(G)){let Y=D.groups;for(let W=0,ce=Y.
length;W<ce;W++){let K=Y[W],Q=G[K.materialIndex];if(Q&&Q.visible){let se=S(w,Q,R,I);w.onBeforeShadow(i,w,_,M,D,se,K),i.renderBufferDirect(M,null,D,se,w,K),w.onAfterShadow(
i,w,_,M,D,se,K)}}}else if(G.visible){let Y=S(w,G,R,I);w.onBeforeShadow(i,w,_,M,D,Y,null),i.renderBufferDirect(M,null,D,Y,w,null),w.onAfterShadow(i,w,_,M,D,Y,null)}}
let z=w.children;for(let D=0,G=z.length;D<G;D++)b(z[D],_,M,R,P,I)}function C(w){w.target.removeEventListener("dispose",C);for(let M in c){let R=c[M],P=w.target.
uuid;P in R&&(R[P].dispose(),delete R[P])}}}function Tw(i,e){function t(){let O=!1,re=new Wt,ne=null,we=new Wt(0,0,0,0);return{setMask:function(ge){ne!==ge&&!O&&
(i.colorMask(ge,ge,ge,ge),ne=ge)},setLocked:function(ge){O=ge},setClear:function(ge,be,Ge,Ze,le){le===!0&&(ge*=Ze,be*=Ze,Ge*=Ze),re.set(ge,be,Ge,Ze),we.equals(re)===
!1&&(i.clearColor(ge,be,Ge,Ze),we.copy(re))},reset:function(){O=!1,ne=null,we.set(-1,0,0,0)}}}function n(){let O=!1,re=!1,ne=null,we=null,ge=null;return{setReversed:function(be){
if(re!==be){let Ge=e.get("EXT_clip_control");be?Ge.clipControlEXT(Ge.LOWER_LEFT_EXT,Ge.ZERO_TO_ONE_EXT):Ge.clipControlEXT(Ge.LOWER_LEFT_EXT,Ge.NEGATIVE_ONE_TO_ONE_EXT),
re=be;let Ze=ge;ge=null,this.setClear(Ze)}},getReversed:function(){return re},setTest:function(be){be?Me(i.DEPTH_TEST):He(i.DEPTH_TEST)},setMask:function(be){ne!==
be&&!O&&(i.depthMask(be),ne=be)},setFunc:function(be){if(re&&(be=rg[be]),we!==be){switch(be){case vl:i.depthFunc(i.NEVER);break;case bl:i.depthFunc(i.ALWAYS);break;case Ml:
i.depthFunc(i.LESS);break;case Jr:i.depthFunc(i.LEQUAL);break;case Sl:i.depthFunc(i.EQUAL);break;case wl:i.depthFunc(i.GEQUAL);break;case Tl:i.depthFunc(i.GREATER);
break;case Al:i.depthFunc(i.NOTEQUAL);break;default:i.depthFunc(i.LEQUAL)}we=be}},setLocked:function(be){O=be},setClear:function(be){ge!==be&&(ge=be,re&&(be=1-be),
i.clearDepth(be))},reset:function(){O=!1,ne=null,we=null,ge=null,re=!1}}}function s(){let O=!1,re=null,ne=null,we=null,ge=null,be=null,Ge=null,Ze=null,le=null;return{
setTest:function(Oe){O||(Oe?Me(i.STENCIL_TEST):He(i.STENCIL_TEST))},setMask:function(Oe){re!==Oe&&!O&&(i.stencilMask(Oe),re=Oe)},setFunc:function(Oe,Je,Ce){(ne!==
Oe||we!==Je||ge!==Ce)&&(i.stencilFunc(Oe,Je,Ce),ne=Oe,we=Je,ge=Ce)},setOp:function(Oe,Je,Ce){(be!==Oe||Ge!==Je||Ze!==Ce)&&(i.stencilOp(Oe,Je,Ce),be=Oe,Ge=Je,Ze=
Ce)},setLocked:function(Oe){O=Oe},setClear:function(Oe){le!==Oe&&(i.clearStencil(Oe),le=Oe)},reset:function(){O=!1,re=null,ne=null,we=null,ge=null,be=null,Ge=null,
Ze=null,le=null}}}let r=new t,o=new n,a=new s,l={},c=new WeakMap,d={},u={},h={},f=new WeakMap,p=[],x=null,m=!1,g=null,y=null,S=null,b=null,C=null,w=null,_=null,
M=new rt(0,0,0),R=0,P=!1,I=null,F=null,z=null,D=null,G=null,Y=i.getParameter(i.MAX_COMBINED_TEXTURE_IMAGE_UNITS),W=!1,ce=0,K=i.getParameter(i.VERSION);K.indexOf(
"WebGL")!==-1?(ce=parseFloat(/^WebGL (\d)/.exec(K)[1]),W=ce>=1):K.indexOf("OpenGL ES")!==-1&&(ce=parseFloat(/^OpenGL ES (\d)/.exec(K)[1]),W=ce>=2);let Q=null,se={},
de=i.getParameter(i.SCISSOR_BOX),ue=i.getParameter(i.VIEWPORT),ee=new Wt().fromArray(de),me=new Wt().fromArray(ue);function xe(O,re,ne,we){let ge=new Uint8Array(
4),be=i.createTexture();i.bindTexture(O,be),i.texParameteri(O,i.TEXTURE_MIN_FILTER,i.NEAREST),i.texParameteri(O,i.TEXTURE_MAG_FILTER,i.NEAREST);for(let Ge=0;Ge<
ne;Ge++)O===i.TEXTURE_3D||O===i.TEXTURE_2D_ARRAY?i.texImage3D(re,0,i.RGBA,1,1,we,0,i.RGBA,i.UNSIGNED_BYTE,ge):i.texImage2D(re+Ge,0,i.RGBA,1,1,0,i.RGBA,i.UNSIGNED_BYTE,
ge);return be}let Ee={};Ee[i.TEXTURE_2D]=xe(i.TEXTURE_2D,i.TEXTURE_2D,1),Ee[i.TEXTURE_CUBE_MAP]=xe(i.TEXTURE_CUBE_MAP,i.TEXTURE_CUBE_MAP_POSITIVE_X,6),Ee[i.TEXTURE_2D_ARRAY]=
xe(i.TEXTURE_2D_ARRAY,i.TEXTURE_2D_ARRAY,1,1),Ee[i.TEXTURE_3D]=xe(i.TEXTURE_3D,i.TEXTURE_3D,1,1),r.setClear(0,0,0,1),o.setClear(1),a.setClear(0),Me(i.DEPTH_TEST),
o.setFunc(Jr),Qt(!1),Pt(Lu),Me(i.CULL_FACE),Gt(rr);function Me(O){d[O]!==!0&&(i.enable(O),d[O]=!0)}function He(O){d[O]!==!1&&(i.disable(O),d[O]=!1)}function nt(O,re){
return h[O]!==re?(i.bindFramebuffer(O,re),h[O]=re,O===i.DRAW_FRAMEBUFFER&&(h[i.FRAMEBUFFER]=re),O===i.FRAMEBUFFER&&(h[i.DRAW_FRAMEBUFFER]=re),!0):!1}function Ve(O,re){
let ne=p,we=!1;if(O){ne=f.get(re),ne===void 0&&(ne=[],f.set(re,ne));let ge=O.textures;if(ne.length!==ge.length||ne[0]!==i.COLOR_ATTACHMENT0){for(let be=0,Ge=ge.
length;be<Ge;be++)ne[be]=i.COLOR_ATTACHMENT0+be;ne.length=ge.length,we=!0}}else ne[0]!==i.BACK&&(ne[0]=i.BACK,we=!0);we&&i.drawBuffers(ne)}function ut(O){return x!==
O?(i.useProgram(O),x=O,!0):!1}let lt={[or]:i.FUNC_ADD,[Em]:i.FUNC_SUBTRACT,[Cm]:i.FUNC_REVERSE_SUBTRACT};lt[Rm]=i.MIN,lt[Pm]=i.MAX;let et={[Im]:i.ZERO,[Lm]:i.ONE,
[Nm]:i.SRC_COLOR,[Fu]:i.SRC_ALPHA,[km]:i.SRC_ALPHA_SATURATE,[Om]:i.DST_COLOR,[Um]:i.DST_ALPHA,[Dm]:i.ONE_MINUS_SRC_COLOR,[Ou]:i.ONE_MINUS_SRC_ALPHA,[Bm]:i.ONE_MINUS_DST_COLOR,
[Fm]:i.ONE_MINUS_DST_ALPHA,[zm]:i.CONSTANT_COLOR,[Vm]:i.ONE_MINUS_CONSTANT_COLOR,[Gm]:i.CONSTANT_ALPHA,[Hm]:i.ONE_MINUS_CONSTANT_ALPHA};function Gt(O,re,ne,we,ge,be,Ge,Ze,le,Oe){
if(O===rr){m===!0&&(He(i.BLEND),m=!1);return}if(m===!1&&(Me(i.BLEND),m=!0),O!==Am){if(O!==g||Oe!==P){if((y!==or||C!==or)&&(i.blendEquation(i.FUNC_ADD),y=or,C=or),
Oe)switch(O){case lo:i.blendFuncSeparate(i.ONE,i.ONE_MINUS_SRC_ALPHA,i.ONE,i.ONE_MINUS_SRC_ALPHA);break;case Nu:i.blendFunc(i.ONE,i.ONE);break;case Du:i.blendFuncSeparate(
i.ZERO,i.ONE_MINUS_SRC_COLOR,i.ZERO,i.ONE);break;case Uu:i.blendFuncSeparate(i.DST_COLOR,i.ONE_MINUS_SRC_ALPHA,i.ZERO,i.ONE);break;default:Ke("WebGLState: Inval\
id blending: ",O);break}else switch(O){case lo:i.blendFuncSeparate(i.SRC_ALPHA,i.ONE_MINUS_SRC_ALPHA,i.ONE,i.ONE_MINUS_SRC_ALPHA);break;case Nu:i.blendFuncSeparate(
i.SRC_ALPHA,i.ONE,i.ONE,i.ONE);break;case Du:Ke("WebGLState: SubtractiveBlending requires material.premultipliedAlpha = true");break;case Uu:Ke("WebGLState: Mul\
tiplyBlending requires material.premultipliedAlpha = true");break;default:Ke("WebGLState: Invalid blending: ",O);break}S=null,b=null,w=null,_=null,M.set(0,0,0),
R=0,g=O,P=Oe}return}ge=ge||re,be=be||ne,Ge=Ge||we,(re!==y||ge!==C)&&(i.blendEquationSeparate(lt[re],lt[ge]),y=re,C=ge),(ne!==S||we!==b||be!==w||Ge!==_)&&(i.blendFuncSeparate(
et[ne],et[we],et[be],et[Ge]),S=ne,b=we,w=be,_=Ge),(Ze.equals(M)===!1||le!==R)&&(i.blendColor(Ze.r,Ze.g,Ze.b,le),M.copy(Ze),R=le),g=O,P=!1}function Ut(O,re){O.side===
Gi?He(i.CULL_FACE):Me(i.CULL_FACE);let ne=O.side===zn;re&&(ne=!ne),Qt(ne),O.blending===lo&&O.transparent===!1?Gt(rr):Gt(O.blending,O.blendEquation,O.blendSrc,O.
blendDst,O.blendEquationAlpha,O.blendSrcAlpha,O.blendDstAlpha,O.blendColor,O.blendAlpha,O.premultipliedAlpha),o.setFunc(O.depthFunc),o.setTest(O.depthTest),o.setMask(
O.depthWrite),r.setMask(O.colorWrite);let we=O.stencilWrite;a.setTest(we),we&&(a.setMask(O.stencilWriteMask),a.setFunc(O.stencilFunc,O.stencilRef,O.stencilFuncMask),
a.setOp(O.stencilFail,O.stencilZFail,O.stencilZPass)),vt(O.polygonOffset,O.polygonOffsetFactor,O.polygonOffsetUnits),O.alphaToCoverage===!0?Me(i.SAMPLE_ALPHA_TO_COVERAGE):
He(i.SAMPLE_ALPHA_TO_COVERAGE)}function Qt(O){I!==O&&(O?i.frontFace(i.CW):i.frontFace(i.CCW),I=O)}function Pt(O){O!==Sm?(Me(i.CULL_FACE),O!==F&&(O===Lu?i.cullFace(
i.BACK):O===wm?i.cullFace(i.FRONT):i.cullFace(i.FRONT_AND_BACK))):He(i.CULL_FACE),F=O}function gn(O){O!==z&&(W&&i.lineWidth(O),z=O)}function vt(O,re,ne){O?(Me(i.
POLYGON_OFFSET_FILL),(D!==re||G!==ne)&&(D=re,G=ne,o.getReversed()&&(re=-re,ne=-ne),i.polygonOffset(re,ne))):He(i.POLYGON_OFFSET_FILL)}function cn(O){O?Me(i.SCISSOR_TEST):
He(i.SCISSOR_TEST)}function $t(O){O===void 0&&(O=i.TEXTURE0+Y-1),Q!==O&&(i.activeTexture(O),Q=O)}function en(O,re,ne){ne===void 0&&(Q===null?ne=i.TEXTURE0+Y-1:ne=
Q);let we=se[ne];we===void 0&&(we={type:void 0,texture:void 0},se[ne]=we),(we.type!==O||we.texture!==re)&&(Q!==ne&&(i.activeTexture(ne),Q=ne),i.bindTexture(O,re||
Ee[O]),we.type=O,we.texture=re)}function B(){let O=se[Q];O!==void 0&&O.type!==void 0&&(i.bindTexture(O.type,null),O.type=void 0,O.texture=void 0)}function Re(){
try{i.compressedTexImage2D(...arguments)}catch(O){Ke("WebGLState:",O)}}function $e(){try{i.compressedTexImage3D(...arguments)}catch(O){Ke("WebGLState:",O)}}function it(){
try{i.texSubImage2D(...arguments)}catch(O){Ke("WebGLState:",O)}}function Se(){try{i.texSubImage3D(...arguments)}catch(O){Ke("WebGLState:",O)}}function Lt(){try{
i.compressedTexSubImage2D(...arguments)}catch(O){Ke("WebGLState:",O)}}function ze(){try{i.compressedTexSubImage3D(...arguments)}catch(O){Ke("WebGLState:",O)}}function Xe(){
try{i.texStorage2D(...arguments)}catch(O){Ke("WebGLState:",O)}}function L(){try{i.texStorage3D(...arguments)}catch(O){Ke("WebGLState:",O)}}function T(){try{i.texImage2D(
...arguments)}catch(O){Ke("WebGLState:",O)}}function $(){try{i.texImage3D(...arguments)}catch(O){Ke("WebGLState:",O)}}function he(O){return u[O]!==void 0?u[O]:i.
getParameter(O)}function oe(O,re){u[O]!==re&&(i.pixelStorei(O,re),u[O]=re)}function _e(O){ee.equals(O)===!1&&(i.scissor(O.x,O.y,O.z,O.w),ee.copy(O))}function ye(O){
me.equals(O)===!1&&(i.viewport(O.x,O.y,O.z,O.w),me.copy(O))}function te(O,re){let ne=c.get(re);ne===void 0&&(ne=new WeakMap,c.set(re,ne));let we=ne.get(O);we===
void 0&&(we=i.getUniformBlockIndex(re,O.name),i.uniformBlockBinding(re,we,we),ne.set(O,we))}function ie(O,re,ne){let ge=c.get(re).get(O);l[ge]!==ne&&(i.bindBufferBase(
i.UNIFORM_BUFFER,ge,ne),l[ge]=ne)}function pe(){i.disable(i.BLEND),i.disable(i.CULL_FACE),i.disable(i.DEPTH_TEST),i.disable(i.POLYGON_OFFSET_FILL),i.disable(i.SCISSOR_TEST),
i.disable(i.STENCIL_TEST),i.disable(i.SAMPLE_ALPHA_TO_COVERAGE),i.blendEquation(i.FUNC_ADD),i.blendFunc(i.ONE,i.ZERO),i.blendFuncSeparate(i.ONE,i.ZERO,i.ONE,i.ZERO),
i.blendColor(0,0,0,0),i.colorMask(!0,!0,!0,!0),i.clearColor(0,0,0,0),i.depthMask(!0),i.depthFunc(i.LESS),o.setReversed(!1),i.clearDepth(1),i.stencilMask(4294967295),
i.stencilFunc(i.ALWAYS,0,4294967295),i.stencilOp(i.KEEP,i.KEEP,i.KEEP),i.clearStencil(0),i.cullFace(i.BACK),i.frontFace(i.CCW),i.polygonOffset(0,0),i.activeTexture(
i.TEXTURE0),i.bindFramebuffer(i.FRAMEBUFFER,null),i.bindFramebuffer(i.DRAW_FRAMEBUFFER,null),i.bindFramebuffer(i.READ_FRAMEBUFFER,null),i.useProgram(null),i.lineWidth(
1),i.scissor(0,0,i.canvas.width,i.canvas.height),i.viewport(0,0,i.canvas.width,i.canvas.height),i.pixelStorei(i.PACK_ALIGNMENT,4),i.pixelStorei(i.UNPACK_ALIGNMENT,
4),i.pixelStorei(i.UNPACK_FLIP_Y_WEBGL,!1),i.pixelStorei(i.UNPACK_PREMULTIPLY_ALPHA_WEBGL,!1),i.pixelStorei(i.UNPACK_COLORSPACE_CONVERSION_WEBGL,i.BROWSER_DEFAULT_WEBGL),
i.pixelStorei(i.PACK_ROW_LENGTH,0),i.pixelStorei(i.PACK_SKIP_PIXELS,0),i.pixelStorei(i.PACK_SKIP_ROWS,0),i.pixelStorei(i.UNPACK_ROW_LENGTH,0),i.pixelStorei(i.UNPACK_IMAGE_HEIGHT,
0),i.pixelStorei(i.UNPACK_SKIP_PIXELS,0),i.pixelStorei(i.UNPACK_SKIP_ROWS,0),i.pixelStorei(i.UNPACK_SKIP_IMAGES,0),d={},u={},Q=null,se={},h={},l={},f=new WeakMap,
p=[],x=null,m=!1,g=null,y=null,S=null,b=null,C=null,w=null,_=null,M=new rt(0,0,0),R=0,P=!1,I=null,F=null,z=null,D=null,G=null,ee.set(0,0,i.canvas.width,i.canvas.
height),me.set(0,0,i.canvas.width,i.canvas.height),r.reset(),o.reset(),a.reset()}return{buffers:{color:r,depth:o,stencil:a},enable:Me,disable:He,bindFramebuffer:nt,
drawBuffers:Ve,useProgram:ut,setBlending:Gt,setMaterial:Ut,setFlipSided:Qt,setCullFace:Pt,setLineWidth:gn,setPolygonOffset:vt,setScissorTest:cn,activeTexture:$t,
bindTexture:en,unbindTexture:B,compressedTexImage2D:Re,compressedTexImage3D:$e,texImage2D:T,texImage3D:$,pixelStorei:oe,getParameter:he,updateUBOMapping:te,uniformBlockBinding:ie,
texStorage2D:Xe,texStorage3D:L,texSubImage2D:it,texSubImage3D:Se,compressedTexSubImage2D:Lt,compressedTexSubImage3D:ze,scissor:_e,viewport:ye,reset:pe}}function Aw(i,e,t,n,s,r,o){
let a=e.has("WEBGL_multisampled_render_to_texture")?e.get("WEBGL_multisampled_render_to_texture"):null,l=typeof navigator>"u"?!1:/OculusBrowser/g.test(navigator.
userAgent),c=new st,d=new WeakMap,u=new Set,h,f=new WeakMap,p=new Set,x=new FinalizationRegistry(L=>p.delete(L)),m=!1;try{m=typeof OffscreenCanvas<"u"&&new OffscreenCanvas(
1,1).getContext("2d")!==null}catch{}function g(L,T){return m?new OffscreenCanvas(L,T):Wo("canvas")}function y(L,T,$){let he=1,oe=Xe(L);if((oe.width>$||oe.height>
$)&&(he=$/Math.max(oe.width,oe.height)),he<1)if(typeof HTMLImageElement<"u"&&L instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&L instanceof HTMLCanvasElement||
typeof ImageBitmap<"u"&&L instanceof ImageBitmap||typeof VideoFrame<"u"&&L instanceof VideoFrame){let _e=Math.floor(he*oe.width),ye=Math.floor(he*oe.height);h===
void 0&&(h=g(_e,ye));let te=T?g(_e,ye):h;return te.width=_e,te.height=ye,te.getContext("2d").drawImage(L,0,0,_e,ye),qe("WebGLRenderer: Texture has been resized \
from ("+oe.width+"x"+oe.height+") to ("+_e+"x"+ye+")."),te}else return"data"in L&&qe("WebGLRenderer: Image in DataTexture is too big ("+oe.width+"x"+oe.height+"\
)."),L;return L}function S(L){return L.generateMipmaps}function b(L){i.generateMipmap(L)}function C(L){return L.isWebGLCubeRenderTarget?i.TEXTURE_CUBE_MAP:L.isWebGL3DRenderTarget?
i.TEXTURE_3D:L.isWebGLArrayRenderTarget||L.isCompressedArrayTexture?i.TEXTURE_2D_ARRAY:i.TEXTURE_2D}function w(L,T,$,he,oe,_e=!1){if(L!==null){if(i[L]!==void 0)
return i[L];qe("WebGLRenderer: Attempt to use non-existing WebGL internal format '"+L+"'")}let ye;he&&(ye=e.get("EXT_texture_norm16"),ye||qe("WebGLRenderer: Una\
ble to use normalized textures without EXT_texture_norm16 extension"));let te=T;if(T===i.RED&&($===i.FLOAT&&(te=i.R32F),$===i.HALF_FLOAT&&(te=i.R16F),$===i.UNSIGNED_BYTE&&
(te=i.R8),$===i.UNSIGNED_SHORT&&ye&&(te=ye.R16_EXT),$===i.SHORT&&ye&&(te=ye.R16_SNORM_EXT)),T===i.RED_INTEGER&&($===i.UNSIGNED_BYTE&&(te=i.R8UI),$===i.UNSIGNED_SHORT&&
(te=i.R16UI),$===i.UNSIGNED_INT&&(te=i.R32UI),$===i.BYTE&&(te=i.R8I),$===i.SHORT&&(te=i.R16I),$===i.INT&&(te=i.R32I)),T===i.RG&&($===i.FLOAT&&(te=i.RG32F),$===i.
HALF_FLOAT&&(te=i.RG16F),$===i.UNSIGNED_BYTE&&(te=i.RG8),$===i.UNSIGNED_SHORT&&ye&&(te=ye.RG16_EXT),$===i.SHORT&&ye&&(te=ye.RG16_SNORM_EXT)),T===i.RG_INTEGER&&($===
i.UNSIGNED_BYTE&&(te=i.RG8UI),$===i.UNSIGNED_SHORT&&(te=i.RG16UI),$===i.UNSIGNED_INT&&(te=i.RG32UI),$===i.BYTE&&(te=i.RG8I),$===i.SHORT&&(te=i.RG16I),$===i.INT&&
(te=i.RG32I)),T===i.RGB_INTEGER&&($===i.UNSIGNED_BYTE&&(te=i.RGB8UI),$===i.UNSIGNED_SHORT&&(te=i.RGB16UI),$===i.UNSIGNED_INT&&(te=i.RGB32UI),$===i.BYTE&&(te=i.RGB8I),
$===i.SHORT&&(te=i.RGB16I),$===i.INT&&(te=i.RGB32I)),T===i.RGBA_INTEGER&&($===i.UNSIGNED_BYTE&&(te=i.RGBA8UI),$===i.UNSIGNED_SHORT&&(te=i.RGBA16UI),$===i.UNSIGNED_INT&&
(te=i.RGBA32UI),$===i.BYTE&&(te=i.RGBA8I),$===i.SHORT&&(te=i.RGBA16I),$===i.INT&&(te=i.RGBA32I)),T===i.RGB&&($===i.UNSIGNED_SHORT&&ye&&(te=ye.RGB16_EXT),$===i.SHORT&&
ye&&(te=ye.RGB16_SNORM_EXT),$===i.UNSIGNED_INT_5_9_9_9_REV&&(te=i.RGB9_E5),$===i.UNSIGNED_INT_10F_11F_11F_REV&&(te=i.R11F_G11F_B10F)),T===i.RGBA){let ie=_e?Ho:_t.
getTransfer(oe);$===i.FLOAT&&(te=i.RGBA32F),$===i.HALF_FLOAT&&(te=i.RGBA16F),$===i.UNSIGNED_BYTE&&(te=ie===At?i.SRGB8_ALPHA8:i.RGBA8),$===i.UNSIGNED_SHORT&&ye&&
(te=ye.RGBA16_EXT),$===i.SHORT&&ye&&(te=ye.RGBA16_SNORM_EXT),$===i.UNSIGNED_SHORT_4_4_4_4&&(te=i.RGBA4),$===i.UNSIGNED_SHORT_5_5_5_1&&(te=i.RGB5_A1)}return(te===
i.R16F||te===i.R32F||te===i.RG16F||te===i.RG32F||te===i.RGBA16F||te===i.RGBA32F)&&e.get("EXT_color_buffer_float"),te}function _(L,T){let $;return L?T===null||T===
Si||T===lr?$=i.DEPTH24_STENCIL8:T===di?$=i.DEPTH32F_STENCIL8:T===ho&&($=i.DEPTH24_STENCIL8,qe("DepthTexture: 16 bit depth attachment is not supported with stenc\
il. Using 24-bit attachment.")):T===null||T===Si||T===lr?$=i.DEPTH_COMPONENT24:T===di?$=i.DEPTH_COMPONENT32F:T===ho&&($=i.DEPTH_COMPONENT16),$}function M(L,T){return S(
L)===!0||L.isFramebufferTexture&&L.minFilter!==Mn&&L.minFilter!==Bn?Math.log2(Math.max(T.width,T.height))+1:L.mipmaps.length>0?L.mipmaps.length:L.isCompressedTexture&&
Array.isArray(L.image)?T.mipmaps.length:1}function R(L){let T=new WeakRef(L);n.get(L).__ref=T,p.add(T),x.register(L,T,T)}function P(L){let T=n.get(L).__ref;T!==
void 0&&(p.delete(T),x.unregister(T))}function I(L){z(L.target)}function F(L){D(L.target)}function z(L){L.removeEventListener("dispose",I),P(L),Y(L),L.isVideoTexture&&
d.delete(L),L.isHTMLTexture&&u.delete(L)}function D(L){L.removeEventListener("dispose",F),P(L),ce(L)}function G(){for(let L of p){let T=L.deref();T!==void 0&&(T.
isRenderTarget===!0?D(T):z(T))}p.clear(),u.clear()}function Y(L){let T=n.get(L);if(T.__webglInit===void 0)return;let $=L.source,he=f.get($);if(he){let oe=he[T.__cacheKey];
oe.usedTimes--,oe.usedTimes===0&&W(L),Object.keys(he).length===0&&f.delete($)}n.remove(L)}function W(L){let T=n.get(L);i.deleteTexture(T.__webglTexture);let $=L.
source,he=f.get($);delete he[T.__cacheKey],o.memory.textures--}function ce(L){let T=n.get(L);T.__depthDisposeCallback&&T.__depthDisposeCallback();let $=L.depthTexture;
if($&&$.renderTarget===L&&z($),L.isWebGLCubeRenderTarget)for(let oe=0;oe<6;oe++){if(Array.isArray(T.__webglFramebuffer[oe]))for(let _e=0;_e<T.__webglFramebuffer[oe].
length;_e++)i.deleteFramebuffer(T.__webglFramebuffer[oe][_e]);else i.deleteFramebuffer(T.__webglFramebuffer[oe]);T.__webglDepthbuffer&&i.deleteRenderbuffer(T.__webglDepthbuffer[oe])}else{
if(Array.isArray(T.__webglFramebuffer))for(let oe=0;oe<T.__webglFramebuffer.length;oe++)i.deleteFramebuffer(T.__webglFramebuffer[oe]);else i.deleteFramebuffer(T.
__webglFramebuffer);if(T.__webglDepthbuffer&&i.deleteRenderbuffer(T.__webglDepthbuffer),T.__webglMultisampledFramebuffer&&i.deleteFramebuffer(T.__webglMultisampledFramebuffer),
T.__webglColorRenderbuffer)for(let oe=0;oe<T.__webglColorRenderbuffer.length;oe++)T.__webglColorRenderbuffer[oe]&&i.deleteRenderbuffer(T.__webglColorRenderbuffer[oe]);
T.__webglDepthRenderbuffer&&i.deleteRenderbuffer(T.__webglDepthRenderbuffer)}let he=L.textures;for(let oe=0,_e=he.length;oe<_e;oe++){let ye=n.get(he[oe]);ye.__webglTexture&&
(i.deleteTexture(ye.__webglTexture),o.memory.textures--),n.remove(he[oe])}n.remove(L)}let K=0;function Q(){K=0}function se(){return K}function de(L){K=L}function ue(){
let L=K;return L>=s.maxTextures&&qe("WebGLTextures: Trying to use "+(L+1)+" texture units while this GPU supports only "+s.maxTextures),K+=1,L}function ee(L){let T=[];
return T.push(L.wrapS),T.push(L.wrapT),T.push(L.wrapR||0),T.push(L.magFilter),T.push(L.minFilter),T.push(L.anisotropy),T.push(L.internalFormat),T.push(L.format),
T.push(L.type),T.push(L.generateMipmaps),T.push(L.mipmapsAutoUpdate),T.push(L.premultiplyAlpha),T.push(L.flipY),T.push(L.unpackAlignment),T.push(L.colorSpace),T.
join()}function me(L,T){let $=n.get(L);if(L.isVideoTexture&&Lt(L),L.isRenderTargetTexture===!1&&L.isExternalTexture!==!0&&L.version>0&&$.__version!==L.version){
let he=L.image;if(he===null)qe("WebGLRenderer: Texture marked for update but no image data found.");else if(he.complete===!1)qe("WebGLRenderer: Texture marked f\
or update but image is incomplete");else{Ut($,L,T);return}}else L.isExternalTexture&&($.__webglTexture=L.sourceTexture?L.sourceTexture:null);t.bindTexture(i.TEXTURE_2D,
$.__webglTexture,i.TEXTURE0+T)}function xe(L,T){let $=n.get(L);if(L.isRenderTargetTexture===!1&&L.version>0&&$.__version!==L.version){Ut($,L,T);return}else L.isExternalTexture&&
($.__webglTexture=L.sourceTexture?L.sourceTexture:null);t.bindTexture(i.TEXTURE_2D_ARRAY,$.__webglTexture,i.TEXTURE0+T)}function Ee(L,T){let $=n.get(L);if(L.isRenderTargetTexture===
!1&&L.version>0&&$.__version!==L.version){Ut($,L,T);return}t.bindTexture(i.TEXTURE_3D,$.__webglTexture,i.TEXTURE0+T)}function Me(L,T){let $=n.get(L);if(L.version>
0&&$.__version!==L.version){Qt($,L,T);return}t.bindTexture(i.TEXTURE_CUBE_MAP,$.__webglTexture,i.TEXTURE0+T)}let He={[El]:i.REPEAT,[Bi]:i.CLAMP_TO_EDGE,[Cl]:i.MIRRORED_REPEAT},
nt={[Mn]:i.NEAREST,[$m]:i.NEAREST_MIPMAP_NEAREST,[ma]:i.NEAREST_MIPMAP_LINEAR,[Bn]:i.LINEAR,[ic]:i.LINEAR_MIPMAP_NEAREST,[ds]:i.LINEAR_MIPMAP_LINEAR},Ve={[Jm]:i.
NEVER,[ed]:i.ALWAYS,[Km]:i.LESS,[ju]:i.LEQUAL,[jm]:i.EQUAL,[Qu]:i.GEQUAL,[Qm]:i.GREATER,[eg]:i.NOTEQUAL};function ut(L,T){if(T.type===di&&e.has("OES_texture_flo\
at_linear")===!1&&(T.magFilter===Bn||T.magFilter===ic||T.magFilter===ma||T.magFilter===ds||T.minFilter===Bn||T.minFilter===ic||T.minFilter===ma||T.minFilter===ds)&&
qe("WebGLRenderer: Unable to use linear filtering with floating point textures. OES_texture_float_linear not supported on this device."),i.texParameteri(L,i.TEXTURE_WRAP_S,
He[T.wrapS]),i.texParameteri(L,i.TEXTURE_WRAP_T,He[T.wrapT]),(L===i.TEXTURE_3D||L===i.TEXTURE_2D_ARRAY)&&i.texParameteri(L,i.TEXTURE_WRAP_R,He[T.wrapR]),i.texParameteri(
L,i.TEXTURE_MAG_FILTER,nt[T.magFilter]),i.texParameteri(L,i.TEXTURE_MIN_FILTER,nt[T.minFilter]),T.compareFunction&&(i.texParameteri(L,i.TEXTURE_COMPARE_MODE,i.COMPARE_REF_TO_TEXTURE),
i.texParameteri(L,i.TEXTURE_COMPARE_FUNC,Ve[T.compareFunction])),e.has("EXT_texture_filter_anisotropic")===!0){if(T.magFilter===Mn||T.minFilter!==ma&&T.minFilter!==
ds||T.type===di&&e.has("OES_texture_float_linear")===!1)return;if(T.anisotropy>1||n.get(T).__currentAnisotropy){let $=e.get("EXT_texture_filter_anisotropic");i.
texParameterf(L,$.TEXTURE_MAX_ANISOTROPY_EXT,Math.min(T.anisotropy,s.getMaxAnisotropy())),n.get(T).__currentAnisotropy=T.anisotropy}}}function lt(L,T){let $=!1;
L.__webglInit===void 0&&(L.__webglInit=!0,T.addEventListener("dispose",I),R(T));let he=T.source,oe=f.get(he);oe===void 0&&(oe={},f.set(he,oe));let _e=ee(T);if(_e!==
L.__cacheKey){oe[_e]===void 0&&(oe[_e]={texture:i.createTexture(),usedTimes:0},o.memory.textures++,$=!0),oe[_e].usedTimes++;let ye=oe[L.__cacheKey];ye!==void 0&&
(oe[L.__cacheKey].usedTimes--,ye.usedTimes===0&&W(T)),L.__cacheKey=_e,L.__webglTexture=oe[_e].texture}return $}function et(L,T,$){return Math.floor(Math.floor(L/
$)/T)}function Gt(L,T,$,he){let _e=L.updateRanges;if(_e.length===0)t.texSubImage2D(i.TEXTURE_2D,0,0,0,T.width,T.height,$,he,T.data);else{_e.sort((O,re)=>O.start-
re.start);let ye=0;for(let O=1;O<_e.length;O++){let re=_e[ye],ne=_e[O],we=re.start+re.count,ge=et(ne.start,T.width,4),be=et(re.start,T.width,4);ne.start<=we+1&&
ge===be&&et(ne.start+ne.count-1,T.width,4)===ge?re.count=Math.max(re.count,ne.start+ne.count-re.start):(++ye,_e[ye]=ne)}_e.length=ye+1;let te=t.getParameter(i.UNPACK_ROW_LENGTH),
ie=t.getParameter(i.UNPACK_SKIP_PIXELS),pe=t.getParameter(i.UNPACK_SKIP_ROWS);t.pixelStorei(i.UNPACK_ROW_LENGTH,T.width);for(let O=0,re=_e.length;O<re;O++){let ne=_e[O],
we=Math.floor(ne.start/4),ge=Math.ceil(ne.count/4),be=we%T.width,Ge=Math.floor(we/T.width),Ze=ge,le=1;t.pixelStorei(i.UNPACK_SKIP_PIXELS,be),t.pixelStorei(i.UNPACK_SKIP_ROWS,
Ge),t.texSubImage2D(i.TEXTURE_2D,0,be,Ge,Ze,le,$,he,T.data)}L.clearUpdateRanges(),t.pixelStorei(i.UNPACK_ROW_LENGTH,te),t.pixelStorei(i.UNPACK_SKIP_PIXELS,ie),t.
pixelStorei(i.UNPACK_SKIP_ROWS,pe)}}function Ut(L,T,$){let he=i.TEXTURE_2D;(T.isDataArrayTexture||T.isCompressedArrayTexture)&&(he=i.TEXTURE_2D_ARRAY),T.isData3DTexture&&
(he=i.TEXTURE_3D);let oe=lt(L,T),_e=T.source;t.bindTexture(he,L.__webglTexture,i.TEXTURE0+$);let ye=n.get(_e);if(_e.version!==ye.__version||oe===!0){if(t.activeTexture(
i.TEXTURE0+$),(typeof ImageBitmap<"u"&&T.image instanceof ImageBitmap)===!1){let le=_t.getPrimaries(_t.workingColorSpace),Oe=T.colorSpace===ps?null:_t.getPrimaries(
T.colorSpace),Je=T.colorSpace===ps||le===Oe?i.NONE:i.BROWSER_DEFAULT_WEBGL;t.pixelStorei(i.UNPACK_FLIP_Y_WEBGL,T.flipY),t.pixelStorei(i.UNPACK_PREMULTIPLY_ALPHA_WEBGL,
T.premultiplyAlpha),t.pixelStorei(i.UNPACK_COLORSPACE_CONVERSION_WEBGL,Je)}t.pixelStorei(i.UNPACK_ALIGNMENT,T.unpackAlignment);let ie=y(T.image,!1,s.maxTextureSize);
ie=ze(T,ie);let pe=r.convert(T.format,T.colorSpace),O=r.convert(T.type),re=w(T.internalFormat,pe,O,T.normalized,T.colorSpace,T.isVideoTexture);ut(he,T);let ne,we=T.
mipmaps,ge=T.isVideoTexture!==!0,be=ye.__version===void 0||oe===!0,Ge=_e.dataReady,Ze=M(T,ie);if(T.isDepthTexture)re=_(T.format===fs,T.type),be&&(ge?t.texStorage2D(
i.TEXTURE_2D,1,re,ie.width,ie.height):t.texImage2D(i.TEXTURE_2D,0,re,ie.width,ie.height,0,pe,O,null));else if(T.isDataTexture)if(we.length>0){ge&&be&&t.texStorage2D(
i.TEXTURE_2D,Ze,re,we[0].width,we[0].height);for(let le=0,Oe=we.length;le<Oe;le++)ne=we[le],ge?Ge&&t.texSubImage2D(i.TEXTURE_2D,le,0,0,ne.width,ne.height,pe,O,ne.
data):t.texImage2D(i.TEXTURE_2D,le,re,ne.width,ne.height,0,pe,O,ne.data);T.generateMipmaps=!1}else ge?(be&&t.texStorage2D(i.TEXTURE_2D,Ze,re,ie.width,ie.height),
Ge&&Gt(T,ie,pe,O)):t.texImage2D(i.TEXTURE_2D,0,re,ie.width,ie.height,0,pe,O,ie.data);else if(T.isCompressedTexture)if(T.isCompressedArrayTexture){ge&&be&&t.texStorage3D(
i.TEXTURE_2D_ARRAY,Ze,re,we[0].width,we[0].height,ie.depth);for(let le=0,Oe=we.length;le<Oe;le++)if(ne=we[le],T.format!==Ti)if(pe!==null)if(ge){if(Ge)if(T.layerUpdates.
size>0){let Je=ad(ne.width,ne.height,T.format,T.type);for(let Ce of T.layerUpdates){let ot=ne.data.subarray(Ce*Je/ne.data.BYTES_PER_ELEMENT,(Ce+1)*Je/ne.data.BYTES_PER_ELEMENT);
t.compressedTexSubImage3D(i.TEXTURE_2D_ARRAY,le,0,0,Ce,ne.width,ne.height,1,pe,ot)}}else t.compressedTexSubImage3D(i.TEXTURE_2D_ARRAY,le,0,0,0,ne.width,ne.height,
ie.depth,pe,ne.data)}else t.compressedTexImage3D(i.TEXTURE_2D_ARRAY,le,re,ne.width,ne.height,ie.depth,0,ne.data,0,0);else qe("WebGLRenderer: Attempt to load uns\
upported compressed texture format in .uploadTexture()");else ge?Ge&&t.texSubImage3D(i.TEXTURE_2D_ARRAY,le,0,0,0,ne.width,ne.height,ie.depth,pe,O,ne.data):t.texImage3D(
i.TEXTURE_2D_ARRAY,le,re,ne.width,ne.height,ie.depth,0,pe,O,ne.data);T.layerUpdates.size>0&&T.clearLayerUpdates()}else{ge&&be&&t.texStorage2D(i.TEXTURE_2D,Ze,re,
we[0].width,we[0].height);for(let le=0,Oe=we.length;le<Oe;le++)ne=we[le],T.format!==Ti?pe!==null?ge?Ge&&t.compressedTexSubImage2D(i.TEXTURE_2D,le,0,0,ne.width,ne.
height,pe,ne.data):t.compressedTexImage2D(i.TEXTURE_2D,le,re,ne.width,ne.height,0,ne.data):qe("WebGLRenderer: Attempt to load unsupported compressed texture for\
mat in .uploadTexture()"):ge?Ge&&t.texSubImage2D(i.TEXTURE_2D,le,0,0,ne.width,ne.height,pe,O,ne.data):t.texImage2D(i.TEXTURE_2D,le,re,ne.width,ne.height,0,pe,O,
ne.data)}else if(T.isDataArrayTexture)if(ge){if(be&&t.texStorage3D(i.TEXTURE_2D_ARRAY,Ze,re,ie.width,ie.height,ie.depth),Ge)if(T.layerUpdates.size>0){let le=ad(
ie.width,ie.height,T.format,T.type);for(let Oe of T.layerUpdates){let Je=ie.data.subarray(Oe*le/ie.data.BYTES_PER_ELEMENT,(Oe+1)*le/ie.data.BYTES_PER_ELEMENT);t.
texSubImage3D(i.TEXTURE_2D_ARRAY,0,0,0,Oe,ie.width,ie.height,1,pe,O,Je)}T.clearLayerUpdates()}else t.texSubImage3D(i.TEXTURE_2D_ARRAY,0,0,0,0,ie.width,ie.height,
ie.depth,pe,O,ie.data)}else t.texImage3D(i.TEXTURE_2D_ARRAY,0,re,ie.width,ie.height,ie.depth,0,pe,O,ie.data);else if(T.isData3DTexture)ge?(be&&t.texStorage3D(i.
TEXTURE_3D,Ze,re,ie.width,ie.height,ie.depth),Ge&&t.texSubImage3D(i.TEXTURE_3D,0,0,0,0,ie.width,ie.height,ie.depth,pe,O,ie.data)):t.texImage3D(i.TEXTURE_3D,0,re,
ie.width,ie.height,ie.depth,0,pe,O,ie.data);else if(T.isFramebufferTexture){if(be)if(ge)t.texStorage2D(i.TEXTURE_2D,Ze,re,ie.width,ie.height);else{let le=ie.width,
Oe=ie.height;for(let Je=0;Je<Ze;Je++)t.texImage2D(i.TEXTURE_2D,Je,re,le,Oe,0,pe,O,null),le>>=1,Oe>>=1}}else if(T.isHTMLTexture){if("texElementImage2D"in i){let le=i.
canvas;if(le.hasAttribute("layoutsubtree")||le.setAttribute("layoutsubtree","true"),ie.parentNode!==le){le.appendChild(ie),u.add(T),le.onpaint=Oe=>{let Je=Oe.changedElements;
for(let Ce of u)Je.includes(Ce.image)&&(Ce.needsUpdate=!0)},le.requestPaint();return}if(i.texElementImage2D.length===3)i.texElementImage2D(i.TEXTURE_2D,i.RGBA8,
ie);else{let Je=i.RGBA,Ce=i.RGBA,ot=i.UNSIGNED_BYTE;i.texElementImage2D(i.TEXTURE_2D,0,Je,Ce,ot,ie)}i.texParameteri(i.TEXTURE_2D,i.TEXTURE_MIN_FILTER,i.LINEAR),
i.texParameteri(i.TEXTURE_2D,i.TEXTURE_WRAP_S,i.CLAMP_TO_EDGE),i.texParameteri(i.TEXTURE_2D,i.TEXTURE_WRAP_T,i.CLAMP_TO_EDGE)}}else if(we.length>0){if(ge&&be){let le=Xe(
we[0]);t.texStorage2D(i.TEXTURE_2D,Ze,re,le.width,le.height)}for(let le=0,Oe=we.length;le<Oe;le++)ne=we[le],ge?Ge&&t.texSubImage2D(i.TEXTURE_2D,le,0,0,pe,O,ne):
t.texImage2D(i.TEXTURE_2D,le,re,pe,O,ne);T.generateMipmaps=!1}else if(ge){if(be){let le=Xe(ie);t.texStorage2D(i.TEXTURE_2D,Ze,re,le.width,le.height)}Ge&&t.texSubImage2D(
i.TEXTURE_2D,0,0,0,pe,O,ie)}else t.texImage2D(i.TEXTURE_2D,0,re,pe,O,ie);S(T)&&T.mipmapsAutoUpdate===!0&&b(he),ye.__version=_e.version,T.onUpdate&&T.onUpdate(T)}
L.__version=T.version}function Qt(L,T,$){if(T.image.length!==6)return;let he=lt(L,T),oe=T.source;t.bindTexture(i.TEXTURE_CUBE_MAP,L.__webglTexture,i.TEXTURE0+$);
let _e=n.get(oe);if(oe.version!==_e.__version||he===!0){t.activeTexture(i.TEXTURE0+$);let ye=_t.getPrimaries(_t.workingColorSpace),te=T.colorSpace===ps?null:_t.
getPrimaries(T.colorSpace),ie=T.colorSpace===ps||ye===te?i.NONE:i.BROWSER_DEFAULT_WEBGL;t.pixelStorei(i.UNPACK_FLIP_Y_WEBGL,T.flipY),t.pixelStorei(i.UNPACK_PREMULTIPLY_ALPHA_WEBGL,
T.premultiplyAlpha),t.pixelStorei(i.UNPACK_ALIGNMENT,T.unpackAlignment),t.pixelStorei(i.UNPACK_COLORSPACE_CONVERSION_WEBGL,ie);let pe=T.isCompressedTexture||T.image[0].
isCompressedTexture,O=T.image[0]&&T.image[0].isDataTexture,re=[];for(let Ce=0;Ce<6;Ce++)!pe&&!O?re[Ce]=y(T.image[Ce],!0,s.maxCubemapSize):re[Ce]=O?T.image[Ce].image:
T.image[Ce],re[Ce]=ze(T,re[Ce]);let ne=re[0],we=r.convert(T.format,T.colorSpace),ge=r.convert(T.type),be=w(T.internalFormat,we,ge,T.normalized,T.colorSpace),Ge=T.
isVideoTexture!==!0,Ze=_e.__version===void 0||he===!0,le=oe.dataReady,Oe=M(T,ne);ut(i.TEXTURE_CUBE_MAP,T);let Je;if(T.isDepthTexture){if(be=_(T.format===fs,T.type),
Ze)if(Ge)t.texStorage2D(i.TEXTURE_CUBE_MAP,1,be,ne.width,ne.height);else for(let Ce=0;Ce<6;Ce++)t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,0,be,ne.width,ne.height,
0,we,ge,null)}else if(pe){Ge&&Ze&&t.texStorage2D(i.TEXTURE_CUBE_MAP,Oe,be,ne.width,ne.height);for(let Ce=0;Ce<6;Ce++){Je=re[Ce].mipmaps;for(let ot=0;ot<Je.length;ot++){
let Ft=Je[ot];T.format!==Ti?we!==null?Ge?le&&t.compressedTexSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,ot,0,0,Ft.width,Ft.height,we,Ft.data):t.compressedTexImage2D(
i.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,ot,be,Ft.width,Ft.height,0,Ft.data):qe("WebGLRenderer: Attempt to load unsupported compressed texture format in .setTextureCube\
()"):Ge?le&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,ot,0,0,Ft.width,Ft.height,we,ge,Ft.data):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,ot,be,Ft.width,
Ft.height,0,we,ge,Ft.data)}}}else{if(Je=T.mipmaps,Ge&&Ze){Je.length>0&&Oe++;let Ce=Xe(re[0]);t.texStorage2D(i.TEXTURE_CUBE_MAP,Oe,be,Ce.width,Ce.height)}for(let Ce=0;Ce<
6;Ce++)if(O){Ge?le&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,0,0,0,re[Ce].width,re[Ce].height,we,ge,re[Ce].data):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+
Ce,0,be,re[Ce].width,re[Ce].height,0,we,ge,re[Ce].data);for(let ot=0;ot<Je.length;ot++){let In=Je[ot].image[Ce].image;Ge?le&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+
Ce,ot+1,0,0,In.width,In.height,we,ge,In.data):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,ot+1,be,In.width,In.height,0,we,ge,In.data)}}else{Ge?le&&t.texSubImage2D(
i.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,0,0,0,we,ge,re[Ce]):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,0,be,we,ge,re[Ce]);for(let ot=0;ot<Je.length;ot++){let Ft=Je[ot];
Ge?le&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,ot+1,0,0,we,ge,Ft.image[Ce]):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,ot+1,be,we,ge,Ft.image[Ce])}}}
S(T)&&T.mipmapsAutoUpdate===!0&&b(i.TEXTURE_CUBE_MAP),_e.__version=oe.version,T.onUpdate&&T.onUpdate(T)}L.__version=T.version}function Pt(L,T,$,he,oe,_e){let ye=r.
convert($.format,$.colorSpace),te=r.convert($.type),ie=w($.internalFormat,ye,te,$.normalized,$.colorSpace),pe=n.get(T),O=n.get($);if(O.__renderTarget=T,!pe.__hasExternalTextures){
let re=Math.max(1,T.width>>_e),ne=Math.max(1,T.height>>_e);oe===i.TEXTURE_3D||oe===i.TEXTURE_2D_ARRAY?t.texImage3D(oe,_e,ie,re,ne,T.depth,0,ye,te,null):t.texImage2D(
oe,_e,ie,re,ne,0,ye,te,null)}t.bindFramebuffer(i.FRAMEBUFFER,L),Se(T)?a.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,he,oe,O.__webglTexture,0,it(T)):(oe===i.
TEXTURE_2D||oe>=i.TEXTURE_CUBE_MAP_POSITIVE_X&&oe<=i.TEXTURE_CUBE_MAP_NEGATIVE_Z)&&i.framebufferTexture2D(i.FRAMEBUFFER,he,oe,O.__webglTexture,_e),t.bindFramebuffer(
i.FRAMEBUFFER,null)}function gn(L,T,$){if(i.bindRenderbuffer(i.RENDERBUFFER,L),T.depthBuffer){let he=T.depthTexture,oe=he&&he.isDepthTexture?he.type:null,_e=_(T.
stencilBuffer,oe),ye=T.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT;Se(T)?a.renderbufferStorageMultisampleEXT(i.RENDERBUFFER,it(T),_e,T.width,T.height):
$?i.renderbufferStorageMultisample(i.RENDERBUFFER,it(T),_e,T.width,T.height):i.renderbufferStorage(i.RENDERBUFFER,_e,T.width,T.height),i.framebufferRenderbuffer(
i.FRAMEBUFFER,ye,i.RENDERBUFFER,L)}else{let he=T.textures;for(let oe=0;oe<he.length;oe++){let _e=he[oe],ye=r.convert(_e.format,_e.colorSpace),te=r.convert(_e.type),
ie=w(_e.internalFormat,ye,te,_e.normalized,_e.colorSpace);Se(T)?a.renderbufferStorageMultisampleEXT(i.RENDERBUFFER,it(T),ie,T.width,T.height):$?i.renderbufferStorageMultisample(
i.RENDERBUFFER,it(T),ie,T.width,T.height):i.renderbufferStorage(i.RENDERBUFFER,ie,T.width,T.height)}}i.bindRenderbuffer(i.RENDERBUFFER,null)}function vt(L,T,$){
let he=T.isWebGLCubeRenderTarget===!0;if(t.bindFramebuffer(i.FRAMEBUFFER,L),!(T.depthTexture&&T.depthTexture.isDepthTexture))throw new Error("THREE.WebGLTexture\
s: renderTarget.depthTexture must be an instance of THREE.DepthTexture.");let oe=n.get(T.depthTexture);oe.__renderTarget=T;let _e=he?T.depthTexture.image[0]:T.depthTexture.
image;(!oe.__webglTexture||_e.width!==T.width||_e.height!==T.height)&&(_e.width=T.width,_e.height=T.height,T.depthTexture.needsUpdate=!0),he?Me(T.depthTexture,0):
me(T.depthTexture,0);let ye=oe.__webglTexture,te=it(T),ie=he?i.TEXTURE_CUBE_MAP_POSITIVE_X+$:i.TEXTURE_2D,pe=T.depthTexture.format===fs?i.DEPTH_STENCIL_ATTACHMENT:
i.DEPTH_ATTACHMENT;if(T.depthTexture.format===os)Se(T)?a.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,pe,ie,ye,0,te):i.framebufferTexture2D(i.FRAMEBUFFER,pe,
ie,ye,0);else if(T.depthTexture.format===fs)Se(T)?a.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,pe,ie,ye,0,te):i.framebufferTexture2D(i.FRAMEBUFFER,pe,ie,ye,
0);else throw new Error("THREE.WebGLTextures: Unknown depthTexture format.")}function cn(L){let T=n.get(L),$=L.isWebGLCubeRenderTarget===!0;if(T.__boundDepthTexture!==
L.depthTexture){let he=L.depthTexture;if(T.__depthDisposeCallback&&T.__depthDisposeCallback(),he){let oe=()=>{delete T.__boundDepthTexture,delete T.__depthDisposeCallback,
he.removeEventListener("dispose",oe)};he.addEventListener("dispose",oe),T.__depthDisposeCallback=oe}T.__boundDepthTexture=he}if(L.depthTexture&&!T.__autoAllocateDepthBuffer)
if($)for(let he=0;he<6;he++)vt(T.__webglFramebuffer[he],L,he);else L.texture.mipmaps.length>0?vt(T.__webglFramebuffer[0],L,0):vt(T.__webglFramebuffer,L,0);else if($){
T.__webglDepthbuffer=[];for(let he=0;he<6;he++)if(t.bindFramebuffer(i.FRAMEBUFFER,T.__webglFramebuffer[he]),T.__webglDepthbuffer[he]===void 0)T.__webglDepthbuffer[he]=
i.createRenderbuffer(),gn(T.__webglDepthbuffer[he],L,!1);else{let oe=L.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,_e=T.__webglDepthbuffer[he];i.
bindRenderbuffer(i.RENDERBUFFER,_e),i.framebufferRenderbuffer(i.FRAMEBUFFER,oe,i.RENDERBUFFER,_e)}}else if(L.texture.mipmaps.length>0?t.bindFramebuffer(i.FRAMEBUFFER,
T.__webglFramebuffer[0]):t.bindFramebuffer(i.FRAMEBUFFER,T.__webglFramebuffer),T.__webglDepthbuffer===void 0)T.__webglDepthbuffer=i.createRenderbuffer(),gn(T.__webglDepthbuffer,
L,!1);else{let oe=L.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,_e=T.__webglDepthbuffer;i.bindRenderbuffer(i.RENDERBUFFER,_e),i.framebufferRenderbuffer(
i.FRAMEBUFFER,oe,i.RENDERBUFFER,_e)}t.bindFramebuffer(i.FRAMEBUFFER,null)}function $t(L,T,$){let he=n.get(L);T!==void 0&&Pt(he.__webglFramebuffer,L,L.texture,i.
COLOR_ATTACHMENT0,i.TEXTURE_2D,0),$!==void 0&&cn(L)}function en(L){let T=L.texture,$=n.get(L),he=n.get(T);L.addEventListener("dispose",F),R(L);let oe=L.textures,
_e=L.isWebGLCubeRenderTarget===!0,ye=oe.length>1;if(ye||(he.__webglTexture===void 0&&(he.__webglTexture=i.createTexture()),he.__version=T.version,o.memory.textures++),
_e){$.__webglFramebuffer=[];for(let te=0;te<6;te++)if(T.mipmaps.length>0){$.__webglFramebuffer[te]=[];for(let ie=0;ie<T.mipmaps.length;ie++)$.__webglFramebuffer[te][ie]=
i.createFramebuffer()}else $.__webglFramebuffer[te]=i.createFramebuffer()}else{if(T.mipmaps.length>0){$.__webglFramebuffer=[];for(let te=0;te<T.mipmaps.length;te++)
$.__webglFramebuffer[te]=i.createFramebuffer()}else $.__webglFramebuffer=i.createFramebuffer();if(ye)for(let te=0,ie=oe.length;te<ie;te++){let pe=n.get(oe[te]);
pe.__webglTexture===void 0&&(pe.__webglTexture=i.createTexture(),o.memory.textures++)}if(L.samples>0&&Se(L)===!1){$.__webglMultisampledFramebuffer=i.createFramebuffer(),
$.__webglColorRenderbuffer=[],t.bindFramebuffer(i.FRAMEBUFFER,$.__webglMultisampledFramebuffer);for(let te=0;te<oe.length;te++){let ie=oe[te];$.__webglColorRenderbuffer[te]=
i.createRenderbuffer(),i.bindRenderbuffer(i.RENDERBUFFER,$.__webglColorRenderbuffer[te]);let pe=r.convert(ie.format,ie.colorSpace),O=r.convert(ie.type),re=w(ie.
internalFormat,pe,O,ie.normalized,ie.colorSpace,L.isXRRenderTarget===!0),ne=it(L);i.renderbufferStorageMultisample(i.RENDERBUFFER,ne,re,L.width,L.height),i.framebufferRenderbuffer(
i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+te,i.RENDERBUFFER,$.__webglColorRenderbuffer[te])}i.bindRenderbuffer(i.RENDERBUFFER,null),L.depthBuffer&&($.__webglDepthRenderbuffer=
i.createRenderbuffer(),gn($.__webglDepthRenderbuffer,L,!0)),t.bindFramebuffer(i.FRAMEBUFFER,null)}}if(_e){t.bindTexture(i.TEXTURE_CUBE_MAP,he.__webglTexture),ut(
i.TEXTURE_CUBE_MAP,T);for(let te=0;te<6;te++)if(T.mipmaps.length>0)for(let ie=0;ie<T.mipmaps.length;ie++)Pt($.__webglFramebuffer[te][ie],L,T,i.COLOR_ATTACHMENT0,
i.TEXTURE_CUBE_MAP_POSITIVE_X+te,ie);else Pt($.__webglFramebuffer[te],L,T,i.COLOR_ATTACHMENT0,i.TEXTURE_CUBE_MAP_POSITIVE_X+te,0);S(T)?b(i.TEXTURE_CUBE_MAP):T.mipmaps.
length>0&&i.texParameteri(i.TEXTURE_CUBE_MAP,i.TEXTURE_MAX_LEVEL,T.mipmaps.length-1),t.unbindTexture()}else if(ye){for(let te=0,ie=oe.length;te<ie;te++){let pe=oe[te],
O=n.get(pe),re=i.TEXTURE_2D;(L.isWebGL3DRenderTarget||L.isWebGLArrayRenderTarget)&&(re=L.isWebGL3DRenderTarget?i.TEXTURE_3D:i.TEXTURE_2D_ARRAY),t.bindTexture(re,
O.__webglTexture),ut(re,pe),Pt($.__webglFramebuffer,L,pe,i.COLOR_ATTACHMENT0+te,re,0),S(pe)&&b(re)}t.unbindTexture()}else{let te=i.TEXTURE_2D;if((L.isWebGL3DRenderTarget||
L.isWebGLArrayRenderTarget)&&(te=L.isWebGL3DRenderTarget?i.TEXTURE_3D:i.TEXTURE_2D_ARRAY),t.bindTexture(te,he.__webglTexture),ut(te,T),T.mipmaps.length>0)for(let ie=0;ie<
T.mipmaps.length;ie++)Pt($.__webglFramebuffer[ie],L,T,i.COLOR_ATTACHMENT0,te,ie);else Pt($.__webglFramebuffer,L,T,i.COLOR_ATTACHMENT0,te,0);S(T)?b(te):T.mipmaps.
length>0&&i.texParameteri(te,i.TEXTURE_MAX_LEVEL,T.mipmaps.length-1),t.unbindTexture()}L.depthBuffer&&cn(L)}function B(L){let T=L.textures;for(let $=0,he=T.length;$<
he;$++){let oe=T[$];if(S(oe)&&oe.mipmapsAutoUpdate===!0){let _e=C(L),ye=n.get(oe).__webglTexture;t.bindTexture(_e,ye),b(_e),t.unbindTexture()}}}let Re=[];function $e(L){
if(L.samples>0){if(Se(L)===!1){let T=L.textures,$=L.width,he=L.height,oe=i.COLOR_BUFFER_BIT,_e=L.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,ye=n.
get(L),te=T.length>1;if(te)for(let pe=0;pe<T.length;pe++)t.bindFramebuffer(i.FRAMEBUFFER,ye.__webglMultisampledFramebuffer),i.framebufferRenderbuffer(i.FRAMEBUFFER,
i.COLOR_ATTACHMENT0+pe,i.RENDERBUFFER,null),t.bindFramebuffer(i.FRAMEBUFFER,ye.__webglFramebuffer),i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0+
pe,i.TEXTURE_2D,null,0);t.bindFramebuffer(i.READ_FRAMEBUFFER,ye.__webglMultisampledFramebuffer),L.texture.mipmaps.length>0?t.bindFramebuffer(i.DRAW_FRAMEBUFFER,
ye.__webglFramebuffer[0]):t.bindFramebuffer(i.DRAW_FRAMEBUFFER,ye.__webglFramebuffer);for(let pe=0;pe<T.length;pe++){if(L.resolveDepthBuffer&&(L.depthBuffer&&(oe|=
i.DEPTH_BUFFER_BIT),L.stencilBuffer&&L.resolveStencilBuffer&&(oe|=i.STENCIL_BUFFER_BIT)),te){i.framebufferRenderbuffer(i.READ_FRAMEBUFFER,i.COLOR_ATTACHMENT0,i.
RENDERBUFFER,ye.__webglColorRenderbuffer[pe]);let O=n.get(T[pe]).__webglTexture;i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0,i.TEXTURE_2D,O,0)}
i.blitFramebuffer(0,0,$,he,0,0,$,he,oe,i.NEAREST),l===!0&&(Re.length=0,Re.push(i.COLOR_ATTACHMENT0+pe),L.depthBuffer&&L.storeMultisampledDepthBuffer===!1&&Re.push(
_e),i.invalidateFramebuffer(i.READ_FRAMEBUFFER,Re))}if(t.bindFramebuffer(i.READ_FRAMEBUFFER,null),t.bindFramebuffer(i.DRAW_FRAMEBUFFER,null),te)for(let pe=0;pe<
T.length;pe++){t.bindFramebuffer(i.FRAMEBUFFER,ye.__webglMultisampledFramebuffer),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+pe,i.RENDERBUFFER,
ye.__webglColorRenderbuffer[pe]);let O=n.get(T[pe]).__webglTexture;t.bindFramebuffer(i.FRAMEBUFFER,ye.__webglFramebuffer),i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,
i.COLOR_ATTACHMENT0+pe,i.TEXTURE_2D,O,0)}t.bindFramebuffer(i.DRAW_FRAMEBUFFER,ye.__webglMultisampledFramebuffer)}else if(L.depthBuffer&&L.storeMultisampledDepthBuffer===
!1&&l){let T=L.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT;i.invalidateFramebuffer(i.DRAW_FRAMEBUFFER,[T])}}}function it(L){return Math.min(s.maxSamples,
L.samples)}function Se(L){let T=n.get(L);return L.samples>0&&e.has("WEBGL_multisampled_render_to_texture")===!0&&T.__useRenderToTexture!==!1}function Lt(L){let T=o.
render.frame;d.get(L)!==T&&(d.set(L,T),L.update())}function ze(L,T){let $=L.colorSpace,he=L.format,oe=L.type;return L.isCompressedTexture===!0||L.isVideoTexture===
!0||$!==Go&&$!==ps&&(_t.getTransfer($)===At?(he!==Ti||oe!==Wn)&&qe("WebGLTextures: sRGB encoded textures have to use RGBAFormat and UnsignedByteType."):Ke("WebG\
LTextures: Unsupported texture color space:",$)),T}function Xe(L){return typeof HTMLImageElement<"u"&&L instanceof HTMLImageElement?(c.width=L.naturalWidth||L.width,
c.height=L.naturalHeight||L.height):typeof VideoFrame<"u"&&L instanceof VideoFrame?(c.width=L.displayWidth,c.height=L.displayHeight):(c.width=L.width,c.height=L.
height),c}this.allocateTextureUnit=ue,this.resetTextureUnits=Q,this.getTextureUnits=se,this.setTextureUnits=de,this.setTexture2D=me,this.setTexture2DArray=xe,this.
setTexture3D=Ee,this.setTextureCube=Me,this.rebindTextures=$t,this.setupRenderTarget=en,this.updateRenderTargetMipmap=B,this.updateMultisampleRenderTarget=$e,this.
setupDepthRenderbuffer=cn,this.setupFrameBufferTexture=Pt,this.useMultisampledRTT=Se,this.dispose=G}function Ew(i,e){function t(n,s=ps){let r,o=_t.getTransfer(s);
if(n===Wn)return i.UNSIGNED_BYTE;if(n===rc)return i.UNSIGNED_SHORT_4_4_4_4;if(n===oc)return i.UNSIGNED_SHORT_5_5_5_1;if(n===Yu)return i.UNSIGNED_INT_5_9_9_9_REV;
if(n===Zu)return i.UNSIGNED_INT_10F_11F_11F_REV;if(n===$u)return i.BYTE;if(n===qu)return i.SHORT;if(n===ho)return i.UNSIGNED_SHORT;if(n===sc)return i.INT;if(n===
Si)return i.UNSIGNED_INT;if(n===di)return i.FLOAT;if(n===wi)return i.HALF_FLOAT;if(n===Ju)return i.ALPHA;if(n===Ku)return i.RGB;if(n===Ti)return i.RGBA;if(n===os)
return i.DEPTH_COMPONENT;if(n===fs)return i.DEPTH_STENCIL;if(n===ac)return i.RED;if(n===lc)return i.RED_INTEGER;if(n===zs)return i.RG;if(n===cc)return i.RG_INTEGER;
if(n===hc)return i.RGBA_INTEGER;if(n===ga||n===_a||n===xa||n===ya)if(o===At)if(r=e.get("WEBGL_compressed_texture_s3tc_srgb"),r!==null){if(n===ga)return r.COMPRESSED_SRGB_S3TC_DXT1_EXT;
if(n===_a)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT1_EXT;if(n===xa)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT3_EXT;if(n===ya)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT5_EXT}else
return null;else if(r=e.get("WEBGL_compressed_texture_s3tc"),r!==null){if(n===ga)return r.COMPRESSED_RGB_S3TC_DXT1_EXT;if(n===_a)return r.COMPRESSED_RGBA_S3TC_DXT1_EXT;
if(n===xa)return r.COMPRESSED_RGBA_S3TC_DXT3_EXT;if(n===ya)return r.COMPRESSED_RGBA_S3TC_DXT5_EXT}else return null;if(n===uc||n===dc||n===fc||n===pc)if(r=e.get(
"WEBGL_compressed_texture_pvrtc"),r!==null){if(n===uc)return r.COMPRESSED_RGB_PVRTC_4BPPV1_IMG;if(n===dc)return r.COMPRESSED_RGB_PVRTC_2BPPV1_IMG;if(n===fc)return r.
COMPRESSED_RGBA_PVRTC_4BPPV1_IMG;if(n===pc)return r.COMPRESSED_RGBA_PVRTC_2BPPV1_IMG}else return null;if(n===mc||n===gc||n===_c||n===xc||n===yc||n===va||n===vc)
if(r=e.get("WEBGL_compressed_texture_etc"),r!==null){if(n===mc||n===gc)return o===At?r.COMPRESSED_SRGB8_ETC2:r.COMPRESSED_RGB8_ETC2;if(n===_c)return o===At?r.COMPRESSED_SRGB8_ALPHA8_ETC2_EAC:
r.COMPRESSED_RGBA8_ETC2_EAC;if(n===xc)return r.COMPRESSED_R11_EAC;if(n===yc)return r.COMPRESSED_SIGNED_R11_EAC;if(n===va)return r.COMPRESSED_RG11_EAC;if(n===vc)
return r.COMPRESSED_SIGNED_RG11_EAC}else return null;if(n===bc||n===Mc||n===Sc||n===wc||n===Tc||n===Ac||n===Ec||n===Cc||n===Rc||n===Pc||n===Ic||n===Lc||n===Nc||
n===Dc)if(r=e.get("WEBGL_compressed_texture_astc"),r!==null){if(n===bc)return o===At?r.COMPRESSED_SRGB8_ALPHA8_ASTC_4x4_KHR:r.COMPRESSED_RGBA_ASTC_4x4_KHR;if(n===
Mc)return o===At?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x4_KHR:r.COMPRESSED_RGBA_ASTC_5x4_KHR;if(n===Sc)return o===At?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x5_KHR:r.COMPRESSED_RGBA_ASTC_5x5_KHR;
if(n===wc)return o===At?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x5_KHR:r.COMPRESSED_RGBA_ASTC_6x5_KHR;if(n===Tc)return o===At?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x6_KHR:r.COMPRESSED_RGBA_ASTC_6x6_KHR;
if(n===Ac)return o===At?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x5_KHR:r.COMPRESSED_RGBA_ASTC_8x5_KHR;if(n===Ec)return o===At?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x6_KHR:r.COMPRESSED_RGBA_ASTC_8x6_KHR;
if(n===Cc)return o===At?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x8_KHR:r.COMPRESSED_RGBA_ASTC_8x8_KHR;if(n===Rc)return o===At?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x5_KHR:r.
COMPRESSED_RGBA_ASTC_10x5_KHR;if(n===Pc)return o===At?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x6_KHR:r.COMPRESSED_RGBA_ASTC_10x6_KHR;if(n===Ic)return o===At?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x8_KHR:
r.COMPRESSED_RGBA_ASTC_10x8_KHR;if(n===Lc)return o===At?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x10_KHR:r.COMPRESSED_RGBA_ASTC_10x10_KHR;if(n===Nc)return o===At?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x10_KHR:
r.COMPRESSED_RGBA_ASTC_12x10_KHR;if(n===Dc)return o===At?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x12_KHR:r.COMPRESSED_RGBA_ASTC_12x12_KHR}else return null;if(n===Uc||n===
Fc||n===Oc)if(r=e.get("EXT_texture_compression_bptc"),r!==null){if(n===Uc)return o===At?r.COMPRESSED_SRGB_ALPHA_BPTC_UNORM_EXT:r.COMPRESSED_RGBA_BPTC_UNORM_EXT;
if(n===Fc)return r.COMPRESSED_RGB_BPTC_SIGNED_FLOAT_EXT;if(n===Oc)return r.COMPRESSED_RGB_BPTC_UNSIGNED_FLOAT_EXT}else return null;if(n===Bc||n===kc||n===ba||n===
zc)if(r=e.get("EXT_texture_compression_rgtc"),r!==null){if(n===Bc)return r.COMPRESSED_RED_RGTC1_EXT;if(n===kc)return r.COMPRESSED_SIGNED_RED_RGTC1_EXT;if(n===ba)
return r.COMPRESSED_RED_GREEN_RGTC2_EXT;if(n===zc)return r.COMPRESSED_SIGNED_RED_GREEN_RGTC2_EXT}else return null;return n===lr?i.UNSIGNED_INT_24_8:i[n]!==void 0?
i[n]:null}return{convert:t}}var Cw="\nvoid main() {\n\n gl_Position = vec4( position, 1.0 );\n\n}",Rw="\nuniform sampler2DArray depthColor;\nuniform float depthWi\
dth;\nuniform float depthHeight;\n\nvoid main() {\n\n vec2 coord = vec2( gl_FragCoord.x / depthWidth, gl_FragCoord.y / depthHeight );\n\n if ( coord.x >= 1.0 ) {\n\n  gl\
_FragDepth = texture( depthColor, vec3( coord.x - 1.0, coord.y, 1 ) ).r;\n\n } else {\n\n  gl_FragDepth = texture( depthColor, vec3( coord.x, coord.y, 0 ) ).r;\n\n }\n\
\n}",gd=class{constructor(){this.texture=null,this.mesh=null,this.depthNear=0,this.depthFar=0}init(e,t){if(this.texture===null){let n=new Qo(e.texture);(e.depthNear!==
t.depthNear||e.depthFar!==t.depthFar)&&(this.depthNear=e.depthNear,this.depthFar=e.depthFar),this.texture=n}}getMesh(e){if(this.texture!==null&&this.mesh===null){
let t=e.cameras[0].viewport,n=new Vi({vertexShader:Cw,fragmentShader:Rw,uniforms:{depthColor:{value:this.texture},depthWidth:{value:t.z},depthHeight:{value:t.w}}});
this.mesh=new ui(new na(20,20),n)}return this.mesh}reset(){this.texture=null,this.mesh=null}getDepthTexture(){return this.texture}},_d=class extends ki{constructor(e,t){
super();let n=this,s=null,r=1,o=null,a="local-floor",l=1,c=null,d=null,u=null,h=null,f=null,p=null,x=typeof XRWebGLBinding<"u",m=new gd,g={},y=t.getContextAttributes(),
S=null,b=null,C=[],w=[],_=new st,M=null,R=null,P=new On;P.viewport=new Wt;let I=new On;I.viewport=new Wt;let F=[P,I],z=new Ql,D=null,G=null;this.cameraAutoUpdate=
!0,this.enabled=!1,this.isPresenting=!1,this.getController=function(ee){let me=C[ee];return me===void 0&&(me=new to,C[ee]=me),me.getTargetRaySpace()},this.getControllerGrip=
function(ee){let me=C[ee];return me===void 0&&(me=new to,C[ee]=me),me.getGripSpace()},this.getHand=function(ee){let me=C[ee];return me===void 0&&(me=new to,C[ee]=
me),me.getHandSpace()};function Y(ee){let me=w.indexOf(ee.inputSource);if(me===-1)return;let xe=C[me];xe!==void 0&&(xe.update(ee.inputSource,ee.frame,c||o),xe.dispatchEvent(
{type:ee.type,data:ee.inputSource}))}function W(){s.removeEventListener("select",Y),s.removeEventListener("selectstart",Y),s.removeEventListener("selectend",Y),
s.removeEventListener("squeeze",Y),s.removeEventListener("squeezestart",Y),s.removeEventListener("squeezeend",Y),s.removeEventListener("end",W),s.removeEventListener(
"inputsourceschange",ce);for(let ee=0;ee<C.length;ee++){let me=w[ee];me!==null&&(w[ee]=null,C[ee].disconnect(me))}D=null,G=null,m.reset();for(let ee in g)delete g[ee];
if(e.setRenderTarget(S),f=null,h=null,u=null,s=null,b=null,ue.stop(),n.isPresenting=!1,e.setPixelRatio(M),e.setSize(_.width,_.height,!1),R!==null){let ee=R.camera;
ee.fov=R.fov,ee.zoom=R.zoom,ee.updateProjectionMatrix(),R=null}n.dispatchEvent({type:"sessionend"})}this.setFramebufferScaleFactor=function(ee){r=ee,n.isPresenting===
!0&&qe("WebXRManager: Cannot change framebuffer scale while presenting.")},this.setReferenceSpaceType=function(ee){a=ee,n.isPresenting===!0&&qe("WebXRManager: C\
annot change reference space type while presenting.")},this.getReferenceSpace=function(){return c||o},this.setReferenceSpace=function(ee){c=ee},this.getBaseLayer=
function(){return h!==null?h:f},this.getBinding=function(){return u===null&&x&&(u=new XRWebGLBinding(s,t)),u},this.getFrame=function(){return p},this.getSession=
function(){return s},this.setSession=async function(ee){if(s=ee,s!==null){if(S=e.getRenderTarget(),s.addEventListener("select",Y),s.addEventListener("selectstar\
t",Y),s.addEventListener("selectend",Y),s.addEventListener("squeeze",Y),s.addEventListener("squeezestart",Y),s.addEventListener("squeezeend",Y),s.addEventListener(
"end",W),s.addEventListener("inputsourceschange",ce),y.xrCompatible!==!0&&await t.makeXRCompatible(),M=e.getPixelRatio(),e.getSize(_),x&&"createProjectionLayer"in
XRWebGLBinding.prototype){let xe=null,Ee=null,Me=null;y.depth&&(Me=y.stencil?t.DEPTH24_STENCIL8:t.DEPTH_COMPONENT24,xe=y.stencil?fs:os,Ee=y.stencil?lr:Si);let He={
colorFormat:t.RGBA8,depthFormat:Me,scaleFactor:r};u=this.getBinding(),h=u.createProjectionLayer(He),s.updateRenderState({layers:[h]}),e.setPixelRatio(1),e.setSize(
h.textureWidth,h.textureHeight,!1),b=new ni(h.textureWidth,h.textureHeight,{format:Ti,type:Wn,depthTexture:new us(h.textureWidth,h.textureHeight,Ee,void 0,void 0,
void 0,void 0,void 0,void 0,xe),stencilBuffer:y.stencil,colorSpace:e.outputColorSpace,samples:y.antialias?4:0,resolveDepthBuffer:h.ignoreDepthValues===!1,resolveStencilBuffer:h.
ignoreDepthValues===!1,storeMultisampledDepthBuffer:h.ignoreDepthValues===!1,storeMultisampledStencilBuffer:h.ignoreDepthValues===!1})}else{let xe={antialias:y.
antialias,alpha:!0,depth:y.depth,stencil:y.stencil,framebufferScaleFactor:r};f=new XRWebGLLayer(s,t,xe),s.updateRenderState({baseLayer:f}),e.setPixelRatio(1),e.
setSize(f.framebufferWidth,f.framebufferHeight,!1),b=new ni(f.framebufferWidth,f.framebufferHeight,{format:Ti,type:Wn,colorSpace:e.outputColorSpace,stencilBuffer:y.
stencil,resolveDepthBuffer:f.ignoreDepthValues===!1,resolveStencilBuffer:f.ignoreDepthValues===!1,storeMultisampledDepthBuffer:f.ignoreDepthValues===!1,storeMultisampledStencilBuffer:f.
ignoreDepthValues===!1})}b.isXRRenderTarget=!0,this.setFoveation(l),c=null,o=await s.requestReferenceSpace(a),ue.setContext(s),ue.start(),n.isPresenting=!0,n.dispatchEvent(
{type:"sessionstart"})}},this.getEnvironmentBlendMode=function(){if(s!==null)return s.environmentBlendMode},this.getDepthTexture=function(){return m.getDepthTexture()};
function ce(ee){for(let me=0;me<ee.removed.length;me++){let xe=ee.removed[me],Ee=w.indexOf(xe);Ee>=0&&(w[Ee]=null,C[Ee].disconnect(xe))}for(let me=0;me<ee.added.
length;me++){let xe=ee.added[me],Ee=w.indexOf(xe);if(Ee===-1){for(let He=0;He<C.length;He++)if(He>=w.length){w.push(xe),Ee=He;break}else if(w[He]===null){w[He]=
xe,Ee=He;break}if(Ee===-1)break}let Me=C[Ee];Me&&Me.connect(xe)}}function K(ee,me){me===null?ee.matrixWorld.copy(ee.matrix):ee.matrixWorld.multiplyMatrices(me.matrixWorld,
ee.matrix),ee.matrixWorldInverse.copy(ee.matrixWorld).invert()}this.updateCamera=function(ee){if(s===null)return;let me=ee.near,xe=ee.far;m.texture!==null&&(m.depthNear>
0&&(me=m.depthNear),m.depthFar>0&&(xe=m.depthFar)),z.near=I.near=P.near=me,z.far=I.far=P.far=xe,(D!==z.near||G!==z.far)&&(s.updateRenderState({depthNear:z.near,
depthFar:z.far}),D=z.near,G=z.far),z.layers.mask=ee.layers.mask|6,P.layers.mask=z.layers.mask&-5,I.layers.mask=z.layers.mask&-3;let Ee=ee.parent,Me=z.cameras;K(
z,Ee);for(let He=0;He<Me.length;He++)K(Me[He],Ee);z.projectionMatrix.copy(P.projectionMatrix),z.projectionMatrixInverse.copy(P.projectionMatrixInverse),R===null&&
ee.isPerspectiveCamera&&(R={camera:ee,fov:ee.fov,zoom:ee.zoom}),Q(ee,z,Ee)};function Q(ee,me,xe){xe===null?ee.matrix.copy(me.matrixWorld):(ee.matrix.copy(xe.matrixWorld),
ee.matrix.invert(),ee.matrix.multiply(me.matrixWorld)),ee.matrix.decompose(ee.position,ee.quaternion,ee.scale),ee.updateMatrixWorld(!0),ee.projectionMatrix.copy(
me.projectionMatrix),ee.projectionMatrixInverse.copy(me.projectionMatrixInverse),ee.isPerspectiveCamera&&(ee.fov=Pl*2*Math.atan(1/ee.projectionMatrix.elements[5]),
ee.zoom=1)}this.getCamera=function(){return z},this.getFoveation=function(){if(!(h===null&&f===null))return l},this.setFoveation=function(ee){l=ee,h!==null&&(h.
fixedFoveation=ee),f!==null&&f.fixedFoveation!==void 0&&(f.fixedFoveation=ee)},this.hasDepthSensing=function(){return m.texture!==null},this.getDepthSensingMesh=
function(){return m.getMesh(z)},this.getCameraTexture=function(ee){return g[ee]};let se=null;function de(ee,me){if(d=me.getViewerPose(c||o),p=me,d!==null){let xe=d.
views;f!==null&&(e.setRenderTargetFramebuffer(b,f.framebuffer),e.setRenderTarget(b));let Ee=!1;xe.length!==z.cameras.length&&(z.cameras.length=0,Ee=!0);for(let Ve=0;Ve<
xe.length;Ve++){let ut=xe[Ve],lt=null;if(f!==null)lt=f.getViewport(ut);else{let Gt=u.getViewSubImage(h,ut);lt=Gt.viewport,Ve===0&&(e.setRenderTargetTextures(b,Gt.
colorTexture,Gt.depthStencilTexture),e.setRenderTarget(b))}let et=F[Ve];et===void 0&&(et=new On,et.layers.enable(Ve),et.viewport=new Wt,F[Ve]=et),et.matrix.fromArray(
ut.transform.matrix),et.matrix.decompose(et.position,et.quaternion,et.scale),et.projectionMatrix.fromArray(ut.projectionMatrix),et.projectionMatrixInverse.copy(
et.projectionMatrix).invert(),et.viewport.set(lt.x,lt.y,lt.width,lt.height),Ve===0&&(z.matrix.copy(et.matrix),z.matrix.decompose(z.position,z.quaternion,z.scale)),
Ee===!0&&z.cameras.push(et)}let Me=s.enabledFeatures;if(Me&&Me.includes("depth-sensing")&&s.depthUsage=="gpu-optimized"&&x){u=n.getBinding();let Ve=u.getDepthInformation(
xe[0]);Ve&&Ve.isValid&&Ve.texture&&m.init(Ve,s.renderState)}if(Me&&Me.includes("camera-access")&&x){e.state.unbindTexture(),u=n.getBinding();for(let Ve=0;Ve<xe.
length;Ve++){let ut=xe[Ve].camera;if(ut){let lt=g[ut];lt||(lt=new Qo,g[ut]=lt);let et=u.getCameraImage(ut);lt.sourceTexture=et}}}}for(let xe=0;xe<C.length;xe++){
let Ee=w[xe],Me=C[xe];Ee!==null&&Me!==void 0&&Me.update(Ee,me,c||o)}se&&se(ee,me),me.detectedPlanes&&n.dispatchEvent({type:"planesdetected",data:me}),p=null}let ue=new Lg;
ue.setAnimationLoop(de),this.setAnimationLoop=function(ee){se=ee},this.dispose=function(){}}},Pw=new xt,Gg=new Qe;Gg.set(-1,0,0,0,1,0,0,0,1);function Iw(i,e){function t(m,g){
m.matrixAutoUpdate===!0&&m.updateMatrix(),g.value.copy(m.matrix)}function n(m,g){g.color.getRGB(m.fogColor.value,sd(i)),g.isFog?(m.fogNear.value=g.near,m.fogFar.
value=g.far):g.isFogExp2&&(m.fogDensity.value=g.density)}function s(m,g,y,S,b){g.isNodeMaterial?g.uniformsNeedUpdate=!1:g.isMeshBasicMaterial?r(m,g):g.isMeshLambertMaterial?
(r(m,g),g.envMap&&(m.envMapIntensity.value=g.envMapIntensity)):g.isMeshToonMaterial?(r(m,g),u(m,g)):g.isMeshPhongMaterial?(r(m,g),d(m,g),g.envMap&&(m.envMapIntensity.
value=g.envMapIntensity)):g.isMeshStandardMaterial?(r(m,g),h(m,g),g.isMeshPhysicalMaterial&&f(m,g,b)):g.isMeshMatcapMaterial?(r(m,g),p(m,g)):g.isMeshDepthMaterial?
r(m,g):g.isMeshDistanceMaterial?(r(m,g),x(m,g)):g.isMeshNormalMaterial?r(m,g):g.isLineBasicMaterial?(o(m,g),g.isLineDashedMaterial&&a(m,g)):g.isPointsMaterial?l(
m,g,y,S):g.isSpriteMaterial?c(m,g):g.isShadowMaterial?(m.color.value.copy(g.color),m.opacity.value=g.opacity):g.isShaderMaterial&&(g.uniformsNeedUpdate=!1)}function r(m,g){
m.opacity.value=g.opacity,g.color&&m.diffuse.value.copy(g.color),g.emissive&&m.emissive.value.copy(g.emissive).multiplyScalar(g.emissiveIntensity),g.map&&(m.map.
value=g.map,t(g.map,m.mapTransform)),g.alphaMap&&(m.alphaMap.value=g.alphaMap,t(g.alphaMap,m.alphaMapTransform)),g.bumpMap&&(m.bumpMap.value=g.bumpMap,t(g.bumpMap,
m.bumpMapTransform),m.bumpScale.value=g.bumpScale,g.side===zn&&(m.bumpScale.value*=-1)),g.normalMap&&(m.normalMap.value=g.normalMap,t(g.normalMap,m.normalMapTransform),
m.normalScale.value.copy(g.normalScale),g.side===zn&&m.normalScale.value.negate()),g.displacementMap&&(m.displacementMap.value=g.displacementMap,t(g.displacementMap,
m.displacementMapTransform),m.displacementScale.value=g.displacementScale,m.displacementBias.value=g.displacementBias),g.emissiveMap&&(m.emissiveMap.value=g.emissiveMap,
t(g.emissiveMap,m.emissiveMapTransform)),g.specularMap&&(m.specularMap.value=g.specularMap,t(g.specularMap,m.specularMapTransform)),g.alphaTest>0&&(m.alphaTest.
value=g.alphaTest);let y=e.get(g),S=y.envMap,b=y.envMapRotation;S&&(m.envMap.value=S,m.envMapRotation.value.setFromMatrix4(Pw.makeRotationFromEuler(b)).transpose(),
S.isCubeTexture&&S.isRenderTargetTexture===!1&&m.envMapRotation.value.premultiply(Gg),m.reflectivity.value=g.reflectivity,m.ior.value=g.ior,m.refractionRatio.value=
g.refractionRatio),g.lightMap&&(m.lightMap.value=g.lightMap,m.lightMapIntensity.value=g.lightMapIntensity,t(g.lightMap,m.lightMapTransform)),g.aoMap&&(m.aoMap.value=
g.aoMap,m.aoMapIntensity.value=g.aoMapIntensity,t(g.aoMap,m.aoMapTransform))}function o(m,g){m.diffuse.value.copy(g.color),m.opacity.value=g.opacity,g.map&&(m.map.
value=g.map,t(g.map,m.mapTransform))}function a(m,g){m.dashSize.value=g.dashSize,m.totalSize.value=g.dashSize+g.gapSize,m.scale.value=g.scale}function l(m,g,y,S){
m.diffuse.value.copy(g.color),m.opacity.value=g.opacity,m.size.value=g.size*y,m.scale.value=S*.5,g.map&&(m.map.value=g.map,t(g.map,m.uvTransform)),g.alphaMap&&(m.
alphaMap.value=g.alphaMap,t(g.alphaMap,m.alphaMapTransform)),g.alphaTest>0&&(m.alphaTest.value=g.alphaTest)}function c(m,g){m.diffuse.value.copy(g.color),m.opacity.
value=g.opacity,m.rotation.value=g.rotation,g.map&&(m.map.value=g.map,t(g.map,m.mapTransform)),g.alphaMap&&(m.alphaMap.value=g.alphaMap,t(g.alphaMap,m.alphaMapTransform)),
g.alphaTest>0&&(m.alphaTest.value=g.alphaTest)}function d(m,g){m.specular.value.copy(g.specular),m.shininess.value=Math.max(g.shininess,1e-4)}function u(m,g){g.
gradientMap&&(m.gradientMap.value=g.gradientMap)}function h(m,g){m.metalness.value=g.metalness,g.metalnessMap&&(m.metalnessMap.value=g.metalnessMap,t(g.metalnessMap,
m.metalnessMapTransform)),m.roughness.value=g.roughness,g.roughnessMap&&(m.roughnessMap.value=g.roughnessMap,t(g.roughnessMap,m.roughnessMapTransform)),g.envMap&&
(m.envMapIntensity.value=g.envMapIntensity)}function f(m,g,y){m.ior.value=g.ior,g.diffuseRoughness>0&&(m.diffuseRoughness.value=g.diffuseRoughness,g.diffuseRoughnessMap&&
(m.diffuseRoughnessMap.value=g.diffuseRoughnessMap,t(g.diffuseRoughnessMap,m.diffuseRoughnessMapTransform))),g.sheen>0&&(m.sheenColor.value.copy(g.sheenColor).multiplyScalar(
g.sheen),m.sheenRoughness.value=g.sheenRoughness,g.sheenColorMap&&(m.sheenColorMap.value=g.sheenColorMap,t(g.sheenColorMap,m.sheenColorMapTransform)),g.sheenRoughnessMap&&
(m.sheenRoughnessMap.value=g.sheenRoughnessMap,t(g.sheenRoughnessMap,m.sheenRoughnessMapTransform))),g.clearcoat>0&&(m.clearcoat.value=g.clearcoat,m.clearcoatRoughness.
value=g.clearcoatRoughness,g.clearcoatMap&&(m.clearcoatMap.value=g.clearcoatMap,t(g.clearcoatMap,m.clearcoatMapTransform)),g.clearcoatRoughnessMap&&(m.clearcoatRoughnessMap.
value=g.clearcoatRoughnessMap,t(g.clearcoatRoughnessMap,m.clearcoatRoughnessMapTransform)),g.clearcoatNormalMap&&(m.clearcoatNormalMap.value=g.clearcoatNormalMap,
t(g.clearcoatNormalMap,m.clearcoatNormalMapTransform),m.clearcoatNormalScale.value.copy(g.clearcoatNormalScale),g.side===zn&&m.clearcoatNormalScale.value.negate())),
g.dispersion>0&&(m.dispersion.value=g.dispersion),g.retroreflectivity>0&&(m.retroreflectivity.value=g.retroreflectivity),g.iridescence>0&&(m.iridescence.value=g.
iridescence,m.iridescenceIOR.value=g.iridescenceIOR,m.iridescenceThicknessMinimum.value=g.iridescenceThicknessMinimum,m.iridescenceThicknessMaximum.value=g.iridescenceThicknessMaximum,
g.iridescenceMap&&(m.iridescenceMap.value=g.iridescenceMap,t(g.iridescenceMap,m.iridescenceMapTransform)),g.iridescenceThicknessMap&&(m.iridescenceThicknessMap.
value=g.iridescenceThicknessMap,t(g.iridescenceThicknessMap,m.iridescenceThicknessMapTransform))),g.transmission>0&&(m.transmission.value=g.transmission,m.transmissionSamplerMap.
value=y.texture,m.transmissionSamplerSize.value.set(y.width,y.height),g.transmissionMap&&(m.transmissionMap.value=g.transmissionMap,t(g.transmissionMap,m.transmissionMapTransform)),
m.thickness.value=g.thickness,g.thicknessMap&&(m.thicknessMap.value=g.thicknessMap,t(g.thicknessMap,m.thicknessMapTransform)),m.attenuationDistance.value=g.attenuationDistance,
m.attenuationColor.value.copy(g.attenuationColor)),g.anisotropy>0&&(m.anisotropyVector.value.set(g.anisotropy*Math.cos(g.anisotropyRotation),g.anisotropy*Math.sin(
g.anisotropyRotation)),g.anisotropyMap&&(m.anisotropyMap.value=g.anisotropyMap,t(g.anisotropyMap,m.anisotropyMapTransform))),m.specularIntensity.value=g.specularIntensity,
m.specularColor.value.copy(g.specularColor),g.specularColorMap&&(m.specularColorMap.value=g.specularColorMap,t(g.specularColorMap,m.specularColorMapTransform)),
g.specularIntensityMap&&(m.specularIntensityMap.value=g.specularIntensityMap,t(g.specularIntensityMap,m.specularIntensityMapTransform))}function p(m,g){g.matcap&&
(m.matcap.value=g.matcap)}function x(m,g){let y=e.get(g).light;m.referencePosition.value.setFromMatrixPosition(y.matrixWorld),m.nearDistance.value=y.shadow.camera.
near,m.farDistance.value=y.shadow.camera.far}return{refreshFogUniforms:n,refreshMaterialUniforms:s}}function Lw(i,e,t,n){let s={},r={};function o(y,S){let b=S.program;
n.uniformBlockBinding(y,b,s[y.id])}function a(y,S){let b=s[y.id];b===void 0&&(p(y),b=l(y),s[y.id]=b,y.addEventListener("dispose",m));let C=S.program;n.updateUBOMapping(
y,C);let w=e.render.frame;r[y.id]!==w&&(c(y),r[y.id]=w)}function l(y){let S=i.createBuffer(),b=y.__size,C=y.usage;return i.bindBuffer(i.UNIFORM_BUFFER,S),i.bufferData(
i.UNIFORM_BUFFER,b,C),i.bindBuffer(i.UNIFORM_BUFFER,null),S}function c(y){let S=s[y.id],b=y.uniforms,C=y.__cache;i.bindBuffer(i.UNIFORM_BUFFER,S);for(let w=0,_=b.
length;w<_;w++){let M=b[w];if(Array.isArray(M))for(let R=0,P=M.length;R<P;R++)d(M[R],w,R,C);else d(M,w,0,C)}i.bindBuffer(i.UNIFORM_BUFFER,null)}function d(y,S,b,C){
if(h(y,S,b,C)===!0){let w=y.__offset,_=y.value;if(Array.isArray(_)){let M=0;for(let R=0;R<_.length;R++){let P=_[R],I=x(P,!0);u(P,y.__data,M),M+=I.storage/Float32Array.
BYTES_PER_ELEMENT}}else u(_,y.__data,0);i.bufferSubData(i.UNIFORM_BUFFER,w,y.__data)}}function u(y,S,b){typeof y=="number"||typeof y=="boolean"?S[b]=y:y.isMatrix3?
(S[b]=y.elements[0],S[b+1]=y.elements[1],S[b+2]=y.elements[2],S[b+3]=0,S[b+4]=y.elements[3],S[b+5]=y.elements[4],S[b+6]=y.elements[5],S[b+7]=0,S[b+8]=y.elements[6],
S[b+9]=y.elements[7],S[b+10]=y.elements[8],S[b+11]=0):ArrayBuffer.isView(y)?S.set(y.subarray(0,S.length-b),b):y.toArray(S,b)}function h(y,S,b,C){let w=y.value,_=S+
"_"+b;if(Array.isArray(w)){C[_]===void 0&&(C[_]=[]);let M=C[_],R=!1;for(let P=0;P<w.length;P++)f(w[P],M,P)===!0&&(R=!0);return R}return f(w,C,_)}function f(y,S,b){
if(S[b]===void 0)return typeof y=="number"||typeof y=="boolean"?S[b]=y:ArrayBuffer.isView(y)?S[b]=y.slice():S[b]=y.clone(),!0;{let C=S[b];if(typeof y=="number"||
typeof y=="boolean"){if(C!==y)return S[b]=y,!0}else{if(ArrayBuffer.isView(y))return!0;if(C.equals(y)===!1)return C.copy(y),!0}}return!1}function p(y){let S=y.uniforms,
b=0,C=16;for(let _=0,M=S.length;_<M;_++){let R=Array.isArray(S[_])?S[_]:[S[_]];for(let P=0,I=R.length;P<I;P++){let F=R[P],z=Array.isArray(F.value)?F.value:[F.value],
D=Array.isArray(S[_])||Array.isArray(F.value),G=b;for(let W=0,ce=z.length;W<ce;W++){let K=z[W],Q=x(K,D),se=b%C,de=se%Q.boundary,ue=se+de;b+=de,ue!==0&&C-ue<Q.storage&&
(b+=C-ue),W===0&&(G=b),b+=Q.storage}let Y=F.type==="int"?Int32Array:F.type==="uint"?Uint32Array:Float32Array;F.__data=new Y((b-G)/Float32Array.BYTES_PER_ELEMENT),
F.__offset=G}}let w=b%C;return w>0&&(b+=C-w),y.__size=b,y.__cache={},this}function x(y,S){let b={boundary:0,storage:0};return typeof y=="number"||typeof y=="boo\
lean"?(b.boundary=4,b.storage=4):y.isVector2?(b.boundary=8,b.storage=8):y.isVector3||y.isColor?(b.boundary=16,b.storage=12):y.isVector4?(b.boundary=16,b.storage=
16):y.isMatrix3?(b.boundary=16,b.storage=48):y.isMatrix4?(b.boundary=16,b.storage=64):y.isTexture?qe("WebGLRenderer: Texture samplers can not be part of an unif\
orms group."):ArrayBuffer.isView(y)?(b.boundary=16,b.storage=y.byteLength):qe("WebGLRenderer: Unsupported uniform value type.",y),S===!0&&(b.boundary=16,b.storage=
Math.ceil(b.storage/16)*16),b}function m(y){let S=y.target;S.removeEventListener("dispose",m),i.deleteBuffer(s[S.id]),delete s[S.id],delete r[S.id]}function g(){
for(let y in s)i.deleteBuffer(s[y]);s={},r={}}return{bind:o,update:a,dispose:g}}var Nw=new Uint16Array([12469,15057,12620,14925,13266,14620,13807,14376,14323,13990,
14545,13625,14713,13328,14840,12882,14931,12528,14996,12233,15039,11829,15066,11525,15080,11295,15085,10976,15082,10705,15073,10495,13880,14564,13898,14542,13977,
14430,14158,14124,14393,13732,14556,13410,14702,12996,14814,12596,14891,12291,14937,11834,14957,11489,14958,11194,14943,10803,14921,10506,14893,10278,14858,9960,
14484,14039,14487,14025,14499,13941,14524,13740,14574,13468,14654,13106,14743,12678,14818,12344,14867,11893,14889,11509,14893,11180,14881,10751,14852,10428,14812,
10128,14765,9754,14712,9466,14764,13480,14764,13475,14766,13440,14766,13347,14769,13070,14786,12713,14816,12387,14844,11957,14860,11549,14868,11215,14855,10751,
14825,10403,14782,10044,14729,9651,14666,9352,14599,9029,14967,12835,14966,12831,14963,12804,14954,12723,14936,12564,14917,12347,14900,11958,14886,11569,14878,11247,
14859,10765,14828,10401,14784,10011,14727,9600,14660,9289,14586,8893,14508,8533,15111,12234,15110,12234,15104,12216,15092,12156,15067,12010,15028,11776,14981,11500,
14942,11205,14902,10752,14861,10393,14812,9991,14752,9570,14682,9252,14603,8808,14519,8445,14431,8145,15209,11449,15208,11451,15202,11451,15190,11438,15163,11384,
15117,11274,15055,10979,14994,10648,14932,10343,14871,9936,14803,9532,14729,9218,14645,8742,14556,8381,14461,8020,14365,7603,15273,10603,15272,10607,15267,10619,
15256,10631,15231,10614,15182,10535,15118,10389,15042,10167,14963,9787,14883,9447,14800,9115,14710,8665,14615,8318,14514,7911,14411,7507,14279,7198,15314,9675,15313,
9683,15309,9712,15298,9759,15277,9797,15229,9773,15166,9668,15084,9487,14995,9274,14898,8910,14800,8539,14697,8234,14590,7790,14479,7409,14367,7067,14178,6621,15337,
8619,15337,8631,15333,8677,15325,8769,15305,8871,15264,8940,15202,8909,15119,8775,15022,8565,14916,8328,14804,8009,14688,7614,14569,7287,14448,6888,14321,6483,14088,
6171,15350,7402,15350,7419,15347,7480,15340,7613,15322,7804,15287,7973,15229,8057,15148,8012,15046,7846,14933,7611,14810,7357,14682,7069,14552,6656,14421,6316,14251,
5948,14007,5528,15356,5942,15356,5977,15353,6119,15348,6294,15332,6551,15302,6824,15249,7044,15171,7122,15070,7050,14949,6861,14818,6611,14679,6349,14538,6067,14398,
5651,14189,5311,13935,4958,15359,4123,15359,4153,15356,4296,15353,4646,15338,5160,15311,5508,15263,5829,15188,6042,15088,6094,14966,6001,14826,5796,14678,5543,14527,
5287,14377,4985,14133,4586,13869,4257,15360,1563,15360,1642,15358,2076,15354,2636,15341,3350,15317,4019,15273,4429,15203,4732,15105,4911,14981,4932,14836,4818,14679,
4621,14517,4386,14359,4156,14083,3795,13808,3437,15360,122,15360,137,15358,285,15355,636,15344,1274,15322,2177,15281,2765,15215,3223,15120,3451,14995,3569,14846,
3567,14681,3466,14511,3305,14344,3121,14037,2800,13753,2467,15360,0,15360,1,15359,21,15355,89,15346,253,15325,479,15287,796,15225,1148,15133,1492,15008,1749,14856,
1882,14685,1886,14506,1783,14324,1608,13996,1398,13702,1183]),Wi=null;function Dw(){return Wi===null&&(Wi=new Zo(Nw,16,16,zs,wi),Wi.name="DFG_LUT",Wi.minFilter=
Bn,Wi.magFilter=Bn,Wi.wrapS=Bi,Wi.wrapT=Bi,Wi.generateMipmaps=!1,Wi.needsUpdate=!0),Wi}var Xc=class{constructor(e={}){let{canvas:t=ng(),context:n=null,depth:s=!0,
stencil:r=!1,alpha:o=!1,antialias:a=!1,premultipliedAlpha:l=!0,preserveDrawingBuffer:c=!1,powerPreference:d="default",failIfMajorPerformanceCaveat:u=!1,reversedDepthBuffer:h=!1,
outputBufferType:f=Wn}=e;this.isWebGLRenderer=!0;let p;if(n!==null){if(typeof WebGLRenderingContext<"u"&&n instanceof WebGLRenderingContext)throw new Error("THR\
EE.WebGLRenderer: WebGL 1 is not supported since r163.");p=n.getContextAttributes().alpha}else p=o;let x=f,m=new Set([hc,cc,lc]),g=new Set([Wn,Si,ho,lr,rc,oc]),
y=new Uint32Array(4),S=new Int32Array(4),b={textures:[],min:[],max:[],resolution:[]},C=null,w=null,_=[],M=[],R=null;this.domElement=t,this.debug={checkShaderErrors:!0,
diagnostics:{keywords:!1},onShaderError:null},this.autoClear=!0,this.autoClearColor=!0,this.autoClearDepth=!0,this.autoClearStencil=!0,this.sortObjects=!0,this.
clippingPlanes=[],this.localClippingEnabled=!1,this.toneMapping=Hi,this.toneMappingExposure=1,this.transmissionResolutionScale=1;let P=this,I=!1,F=null,z=null,D=null,
G=null;this._outputColorSpace=ei;let Y=0,W=0,ce=null,K=-1,Q=null,se=new Wt,de=new Wt,ue=null,ee=new rt(0),me=0,xe=t.width,Ee=t.height,Me=1,He=null,nt=null,Ve=new Wt(
0,0,xe,Ee),ut=new Wt(0,0,xe,Ee),lt=!1,et=new Ls,Gt=new Dl,Ut=!1,Qt=!1,Pt=new xt,gn=new V,vt=new Wt,cn={background:null,fog:null,environment:null,overrideMaterial:null,
isScene:!0},$t=!1;function en(){return ce===null?Me:1}let B=n;function Re(E,k){return t.getContext(E,k)}let $e,it,Se,Lt,ze,Xe,L,T,$,he,oe,_e,ye,te,ie,pe,O,re,ne,
we,ge,be,Ge;try{let E={alpha:!0,depth:s,stencil:r,antialias:a,premultipliedAlpha:l,preserveDrawingBuffer:c,powerPreference:d,failIfMajorPerformanceCaveat:u};if("\
setAttribute"in t&&t.setAttribute("data-engine","three.js r".concat("187")),t.addEventListener("webglcontextlost",Oe,!1),t.addEventListener("webglcontextrestore\
d",Je,!1),t.addEventListener("webglcontextcreationerror",Ce,!1),B===null){let k="webgl2";if(B=Re(k,E),B===null)throw Re(k)?new Error("THREE.WebGLRenderer: Error\
 creating WebGL context with your selected attributes."):new Error("THREE.WebGLRenderer: Error creating WebGL context.")}Ze()}catch(E){throw t.removeEventListener(
"webglcontextlost",Oe,!1),t.removeEventListener("webglcontextrestored",Je,!1),t.removeEventListener("webglcontextcreationerror",Ce,!1),Ke("WebGLRenderer: "+E.message),
E}function Ze(){$e=new XM(B),$e.init(),ge=new Ew(B,$e),it=new DM(B,$e,e,ge),Se=new Tw(B,$e),it.reversedDepthBuffer&&h&&Se.buffers.depth.setReversed(!0),z=B.createFramebuffer(),
D=B.createFramebuffer(),G=B.createFramebuffer(),Lt=new YM(B),ze=new uw,Xe=new Aw(B,$e,Se,ze,it,ge,Lt),L=new WM(P),T=new Jy(B),be=new LM(B,T),$=new $M(B,T,Lt,be),
he=new JM(B,$,T,be,Lt),re=new ZM(B,it,Xe),ie=new UM(ze),oe=new hw(P,L,$e,it,be,ie),_e=new Iw(P,ze),ye=new fw,te=new yw($e),O=new IM(P,L,Se,he,p,l),pe=new ww(P,he,
it),Ge=new Lw(B,Lt,it,Se),ne=new NM(B,$e,Lt),we=new qM(B,$e,Lt),Lt.programs=oe.programs,P.capabilities=it,P.extensions=$e,P.properties=ze,P.renderLists=ye,P.shadowMap=
pe,P.state=Se,P.info=Lt}x!==Wn&&(R=new jM(x,t.width,t.height,a,s,r));let le=new _d(P,B);this.xr=le,this.getContext=function(){return B},this.getContextAttributes=
function(){return B.getContextAttributes()},this.forceContextLoss=function(){let E=$e.get("WEBGL_lose_context");E&&E.loseContext()},this.forceContextRestore=function(){
let E=$e.get("WEBGL_lose_context");E&&E.restoreContext()},this.getPixelRatio=function(){return Me},this.setPixelRatio=function(E){E!==void 0&&(Me=E,this.setSize(
xe,Ee,!1))},this.getSize=function(E){return E.set(xe,Ee)},this.setSize=function(E,k,j=!0){if(le.isPresenting){qe("WebGLRenderer: Can't change size while VR devi\
ce is presenting.");return}xe=E,Ee=k,t.width=Math.floor(E*Me),t.height=Math.floor(k*Me),j===!0&&(t.style.width=E+"px",t.style.height=k+"px"),R!==null&&R.setSize(
t.width,t.height),this.setViewport(0,0,E,k)},this.getDrawingBufferSize=function(E){return E.set(xe*Me,Ee*Me).floor()},this.setDrawingBufferSize=function(E,k,j){
xe=E,Ee=k,Me=j,t.width=Math.floor(E*j),t.height=Math.floor(k*j),this.setViewport(0,0,E,k)},this.setEffects=function(E){if(x===Wn){Ke("WebGLRenderer: setEffects(\
) requires outputBufferType set to HalfFloatType or FloatType.");return}if(E){for(let k=0;k<E.length;k++)if(E[k].isOutputPass===!0){qe("WebGLRenderer: OutputPas\
s is not needed in setEffects(). Tone mapping and color space conversion are applied automatically.");break}}R.setEffects(E||[])},this.getCurrentViewport=function(E){
return E.copy(se)},this.getViewport=function(E){return E.copy(Ve)},this.setViewport=function(E,k,j,q){E.isVector4?Ve.set(E.x,E.y,E.z,E.w):Ve.set(E,k,j,q),Se.viewport(
se.copy(Ve).multiplyScalar(en()).round())},this.getScissor=function(E){return E.copy(ut)},this.setScissor=function(E,k,j,q){E.isVector4?ut.set(E.x,E.y,E.z,E.w):
ut.set(E,k,j,q),Se.scissor(de.copy(ut).multiplyScalar(en()).round())},this.getScissorTest=function(){return lt},this.setScissorTest=function(E){Se.setScissorTest(
lt=E)},this.setOpaqueSort=function(E){He=E},this.setTransparentSort=function(E){nt=E},this.getClearColor=function(E){return E.copy(O.getClearColor())},this.setClearColor=
function(){O.setClearColor(...arguments)},this.getClearAlpha=function(){return O.getClearAlpha()},this.setClearAlpha=function(){O.setClearAlpha(...arguments)},this.
clear=function(E=!0,k=!0,j=!0){let q=0;if(E){let Z=!1;if(ce!==null){let Te=ce.texture.format;Z=m.has(Te)}if(Z){let Te=ce.texture.type,Pe=g.has(Te),Ae=O.getClearColor(),
Ie=O.getClearAlpha(),ke=Ae.r,je=Ae.g,dt=Ae.b;Pe?(y[0]=ke,y[1]=je,y[2]=dt,y[3]=Ie,B.clearBufferuiv(B.COLOR,0,y)):(S[0]=ke,S[1]=je,S[2]=dt,S[3]=Ie,B.clearBufferiv(
B.COLOR,0,S))}else q|=B.COLOR_BUFFER_BIT}k&&(q|=B.DEPTH_BUFFER_BIT,this.state.buffers.depth.setMask(!0)),j&&(q|=B.STENCIL_BUFFER_BIT,this.state.buffers.stencil.
setMask(4294967295)),q!==0&&B.clear(q)},this.clearColor=function(){this.clear(!0,!1,!1)},this.clearDepth=function(){this.clear(!1,!0,!1)},this.clearStencil=function(){
this.clear(!1,!1,!0)},this.setNodesHandler=function(E){E.setRenderer(this),F=E},this.dispose=function(){t.removeEventListener("webglcontextlost",Oe,!1),t.removeEventListener(
"webglcontextrestored",Je,!1),t.removeEventListener("webglcontextcreationerror",Ce,!1),O.dispose(),ye.dispose(),te.dispose(),Xe.dispose(),ze.dispose(),L.dispose(),
he.dispose(),$.dispose(),be.dispose(),Ge.dispose(),oe.dispose(),le.dispose(),le.removeEventListener("sessionstart",Ca),le.removeEventListener("sessionend",Ei),$i.
stop()};function Oe(E){E.preventDefault(),nd("WebGLRenderer: Context Lost."),I=!0}function Je(){nd("WebGLRenderer: Context Restored."),I=!1;let E=Lt.autoReset,k=pe.
enabled,j=pe.autoUpdate,q=pe.needsUpdate,Z=pe.type;Ze(),Lt.autoReset=E,pe.enabled=k,pe.autoUpdate=j,pe.needsUpdate=q,pe.type=Z}function Ce(E){Ke("WebGLRenderer:\
 A WebGL context could not be created. Reason: ",E.statusMessage)}function ot(E){let k=E.target;k.removeEventListener("dispose",ot),Ft(k)}function Ft(E){In(E),ze.
remove(E)}function In(E){let k=ze.get(E).programs;k!==void 0&&(k.forEach(function(j){oe.releaseProgram(j)}),E.isShaderMaterial&&oe.releaseShaderCache(E))}this.renderBufferDirect=
function(E,k,j,q,Z,Te){k===null&&(k=cn);let Pe=Z.isMesh&&Z.matrixWorld.determinantAffine()<0,Ae=vo(E,k,j,q,Z);Se.setMaterial(q,Pe);let Ie=j.index,ke=1;if(q.wireframe===
!0){if(Ie=$.getWireframeAttribute(j),Ie===void 0)return;ke=2}let je=j.drawRange,dt=j.attributes.position,Be=je.start*ke,ft=(je.start+je.count)*ke;Te!==null&&(Be=
Math.max(Be,Te.start*ke),ft=Math.min(ft,(Te.start+Te.count)*ke)),Ie!==null?(Be=Math.max(Be,0),ft=Math.min(ft,Ie.count)):dt!=null&&(Be=Math.max(Be,0),ft=Math.min(
ft,dt.count));let Xt=ft-Be;if(Xt<0||Xt===1/0)return;be.setup(Z,q,Ae,j,Ie);let Et,Ct=ne;if(Ie!==null&&(Et=T.get(Ie),Ct=we,Ct.setIndex(Et)),Z.isMesh)q.wireframe===
!0?(Se.setLineWidth(q.wireframeLinewidth*en()),Ct.setMode(B.LINES)):Ct.setMode(B.TRIANGLES);else if(Z.isLine){let hn=q.linewidth;hn===void 0&&(hn=1),Se.setLineWidth(
hn*en()),Z.isLineSegments?Ct.setMode(B.LINES):Z.isLineLoop?Ct.setMode(B.LINE_LOOP):Ct.setMode(B.LINE_STRIP)}else Z.isPoints?Ct.setMode(B.POINTS):Z.isSprite&&Ct.
setMode(B.TRIANGLES);if(Z.isBatchedMesh)if($e.get("WEBGL_multi_draw"))Ct.renderMultiDraw(Z._multiDrawStarts,Z._multiDrawCounts,Z._multiDrawCount);else{let hn=Z.
_multiDrawStarts,Ue=Z._multiDrawCounts,tn=Z._multiDrawCount,mt=Ie?T.get(Ie).bytesPerElement:1,Yi=ze.get(q).currentProgram.getUniforms();for(let nn=0;nn<tn;nn++)
Yi.setValue(B,"_gl_DrawID",nn),Ct.render(hn[nn]/mt,Ue[nn])}else if(Z.isInstancedMesh)Ct.renderInstances(Be,Xt,Z.count);else if(j.isInstancedBufferGeometry){let hn=j.
_maxInstanceCount!==void 0?j._maxInstanceCount:1/0,Ue=Math.min(j.instanceCount,hn);Ct.renderInstances(Be,Xt,Ue)}else Ct.render(Be,Xt)};function _o(E,k,j,q){F!==
null&&E.isNodeMaterial&&F.setObject(q,E),Ut===!0&&ie.setState(E,j,!1),E.transparent===!0&&E.side===Gi&&E.forceSinglePass===!1?(E.side=zn,E.needsUpdate=!0,Ci(E,k,
q),E.side=ks,E.needsUpdate=!0,Ci(E,k,q),E.side=Gi):Ci(E,k,q)}this.compile=function(E,k,j=null){j===null&&(j=E),F!==null&&F.renderStart(E,k,j),w=te.get(j),w.init(
k),M.push(w),j.traverseVisible(function(Z){Z.isLight&&Z.layers.test(k.layers)&&(w.pushLight(Z),Z.castShadow&&w.pushShadow(Z))}),E!==j&&E.traverseVisible(function(Z){
Z.isLight&&Z.layers.test(k.layers)&&(w.pushLight(Z),Z.castShadow&&w.pushShadow(Z))}),w.setupLights(),F!==null&&F.updateLights(w.state.lightsArray),Qt=this.localClippingEnabled,
Ut=ie.init(this.clippingPlanes,Qt),Ut===!0&&ie.setGlobalState(this.clippingPlanes,k),F!==null&&pe.render(w.state.shadowsArray,j,k);let q=new Set;return E.traverse(
function(Z){if(!(Z.isMesh||Z.isPoints||Z.isLine||Z.isSprite))return;let Te=Z.material;if(Te)if(Array.isArray(Te))for(let Pe=0;Pe<Te.length;Pe++){let Ae=Te[Pe];_o(
Ae,j,k,Z),q.add(Ae)}else _o(Te,j,k,Z),q.add(Te)}),w=M.pop(),F!==null&&F.renderEnd(),q},this.compileAsync=function(E,k,j=null){let q=this.compile(E,k,j);return new Promise(
Z=>{function Te(){if(q.forEach(function(Pe){let Ie=ze.get(Pe).currentProgram;(Ie===void 0||Ie.isReady())&&q.delete(Pe)}),q.size===0){Z(E);return}setTimeout(Te,10)}
$e.get("KHR_parallel_shader_compile")!==null?Te():setTimeout(Te,10)})};let dr=null;function uh(E){dr&&dr(E)}function Ca(){$i.stop()}function Ei(){$i.start()}let $i=new Lg;
$i.setAnimationLoop(uh),typeof self<"u"&&$i.setContext(self),this.setAnimationLoop=function(E){dr=E,le.setAnimationLoop(E),E===null?$i.stop():$i.start()},le.addEventListener(
"sessionstart",Ca),le.addEventListener("sessionend",Ei),this.render=function(E,k){if(k!==void 0&&k.isCamera!==!0){Ke("WebGLRenderer.render: camera is not an ins\
tance of THREE.Camera.");return}if(I===!0)return;F!==null&&F.renderStart(E,k);let j=le.enabled===!0&&le.isPresenting===!0,q=R!==null&&(ce===null||j)&&R.begin(P,
ce);if(E.matrixWorldAutoUpdate===!0&&E.updateMatrixWorld(),k.parent===null&&k.matrixWorldAutoUpdate===!0&&k.updateMatrixWorld(),le.enabled===!0&&le.isPresenting===
!0&&(R===null||R.isCompositing()===!1)&&(le.cameraAutoUpdate===!0&&le.updateCamera(k),k=le.getCamera()),E.isScene===!0&&E.onBeforeRender(P,E,k,ce),w=te.get(E,M.
length),w.init(k),w.state.textureUnits=Xe.getTextureUnits(),M.push(w),Pt.multiplyMatrices(k.projectionMatrix,k.matrixWorldInverse),k.isArrayCamera?Gt.setFromArrayCamera(
k):et.setFromProjectionMatrix(Pt,hi,k.reversedDepth),Qt=this.localClippingEnabled,Ut=ie.init(this.clippingPlanes,Qt),C=ye.get(E,_.length),C.init(),_.push(C),this.
info.render.frame++,le.enabled===!0&&le.isPresenting===!0){let Pe=P.xr.getDepthSensingMesh();Pe!==null&&qi(Pe,k,-1/0,P.sortObjects)}qi(E,k,0,P.sortObjects),C.finish(),
F!==null&&F.updateLights(w.state.lightsArray),P.sortObjects===!0&&C.sort(He,nt),$t=le.enabled===!1||le.isPresenting===!1||le.hasDepthSensing()===!1,$t&&O.addToRenderList(
C,E),this.info.autoReset===!0&&this.info.reset(),Ut===!0&&ie.beginShadows();let Z=w.state.shadowsArray;if(pe.render(Z,E,k),Ut===!0&&ie.endShadows(),(q&&R.hasRenderPass())===
!1){let Pe=C.opaque,Ae=C.transmissive;if(w.setupLights(),k.isArrayCamera){let Ie=k.cameras;if(Ae.length>0)for(let ke=0,je=Ie.length;ke<je;ke++){let dt=Ie[ke];fi(
Pe,Ae,E,dt)}$t&&O.render(E);for(let ke=0,je=Ie.length;ke<je;ke++){let dt=Ie[ke];xo(C,E,dt,dt.viewport)}}else Ae.length>0&&fi(Pe,Ae,E,k),$t&&O.render(E),xo(C,E,k)}
ce!==null&&W===0&&(Xe.updateMultisampleRenderTarget(ce),Xe.updateRenderTargetMipmap(ce)),q&&R.end(P),E.isScene===!0&&E.onAfterRender(P,E,k),be.resetDefaultState(),
K=-1,Q=null,M.pop(),M.length>0?(w=M[M.length-1],Xe.setTextureUnits(w.state.textureUnits),Ut===!0&&ie.setGlobalState(P.clippingPlanes,w.state.camera)):w=null,_.pop(),
_.length>0?C=_[_.length-1]:C=null,F!==null&&F.renderEnd()};function qi(E,k,j,q){if(E.visible===!1)return;if(E.layers.test(k.layers)){if(E.isGroup)j=E.renderOrder;else if(E.
isLOD)E.autoUpdate===!0&&E.update(k);else if(E.isLight)w.pushLight(E),E.castShadow&&w.pushShadow(E);else if(E.isSprite){let Pe=k.isArrayCamera?Gt:et;if(!E.frustumCulled||
E.intersectsFrustum(Pe)){q&&vt.setFromMatrixPosition(E.matrixWorld).applyMatrix4(Pt);let Ae=he.update(E),Ie=E.material;Ie.visible&&C.push(E,Ae,Ie,j,vt.z,null,k)}}else if(E.
isMesh||E.isLine||E.isPoints){let Pe=k.isArrayCamera?Gt:et;if(!E.frustumCulled||E.intersectsFrustum(Pe)){let Ae=he.update(E),Ie=E.material;if(q&&(E.boundingSphere!==
void 0?(E.boundingSphere===null&&E.computeBoundingSphere(),vt.copy(E.boundingSphere.center)):(Ae.boundingSphere===null&&Ae.computeBoundingSphere(),vt.copy(Ae.boundingSphere.
center)),vt.applyMatrix4(E.matrixWorld).applyMatrix4(Pt)),Array.isArray(Ie)){let ke=Ae.groups;for(let je=0,dt=ke.length;je<dt;je++){let Be=ke[je],ft=Ie[Be.materialIndex];
ft&&ft.visible&&C.push(E,Ae,ft,j,vt.z,Be,k)}}else Ie.visible&&C.push(E,Ae,Ie,j,vt.z,null,k)}}}let Te=E.children;for(let Pe=0,Ae=Te.length;Pe<Ae;Pe++)qi(Te[Pe],k,
j,q)}function xo(E,k,j,q){let{opaque:Z,transmissive:Te,transparent:Pe}=E;w.setupLightsView(j),Ut===!0&&ie.setGlobalState(P.clippingPlanes,j),q&&Se.viewport(se.copy(
q)),Z.length>0&&qt(Z,k,j),Te.length>0&&qt(Te,k,j),Pe.length>0&&qt(Pe,k,j),Se.buffers.depth.setTest(!0),Se.buffers.depth.setMask(!0),Se.buffers.color.setMask(!0),
Se.setPolygonOffset(!1)}function fi(E,k,j,q){if((j.isScene===!0?j.overrideMaterial:null)!==null)return;if(w.state.transmissionRenderTarget[q.id]===void 0){let Be=$e.
has("EXT_color_buffer_half_float")||$e.has("EXT_color_buffer_float");w.state.transmissionRenderTarget[q.id]=new ni(1,1,{generateMipmaps:!0,type:Be?wi:Wn,minFilter:ds,
samples:Math.max(4,it.samples),stencilBuffer:r,resolveDepthBuffer:!1,resolveStencilBuffer:!1,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,colorSpace:_t.
workingColorSpace})}let Te=w.state.transmissionRenderTarget[q.id],Pe=q.viewport||se;Te.setSize(Pe.z*P.transmissionResolutionScale,Pe.w*P.transmissionResolutionScale);
let Ae=P.getRenderTarget(),Ie=P.getActiveCubeFace(),ke=P.getActiveMipmapLevel();P.setRenderTarget(Te),P.getClearColor(ee),me=P.getClearAlpha(),me<1&&P.setClearColor(
16777215,.5),P.clear(),$t&&O.render(j);let je=P.toneMapping;P.toneMapping=Hi;let dt=q.viewport;if(q.viewport!==void 0&&(q.viewport=void 0),w.setupLightsView(q),
Ut===!0&&ie.setGlobalState(P.clippingPlanes,q),qt(E,j,q),Xe.updateMultisampleRenderTarget(Te),Xe.updateRenderTargetMipmap(Te),$e.has("WEBGL_multisampled_render_\
to_texture")===!1){let Be=!1;for(let ft=0,Xt=k.length;ft<Xt;ft++){let Et=k[ft],{object:Ct,geometry:hn,material:Ue,group:tn}=Et;if(Ue.side===Gi&&Ct.layers.test(q.
layers)){let mt=Ue.side;Ue.side=zn,Ue.needsUpdate=!0,Kt(Ct,j,q,hn,Ue,tn),Ue.side=mt,Ue.needsUpdate=!0,Be=!0}}Be===!0&&(Xe.updateMultisampleRenderTarget(Te),Xe.updateRenderTargetMipmap(
Te))}P.setRenderTarget(Ae,Ie,ke),P.setClearColor(ee,me),dt!==void 0&&(q.viewport=dt),P.toneMapping=je}function qt(E,k,j){let q=k.isScene===!0?k.overrideMaterial:
null;for(let Z=0,Te=E.length;Z<Te;Z++){let Pe=E[Z],{object:Ae,geometry:Ie,group:ke}=Pe,je=Pe.material;je.allowOverride===!0&&q!==null&&(je=q),Ae.layers.test(j.layers)&&
Kt(Ae,k,j,Ie,je,ke)}}function Kt(E,k,j,q,Z,Te){F!==null&&Z.isNodeMaterial&&F.setObject(E,Z),E.onBeforeRender(P,k,j,q,Z,Te),E.modelViewMatrix.multiplyMatrices(j.
matrixWorldInverse,E.matrixWorld),E.normalMatrix.getNormalMatrix(E.modelViewMatrix),Z.onBeforeRender(P,k,j,q,E,Te),Z.transparent===!0&&Z.side===Gi&&Z.forceSinglePass===
!1?(Z.side=zn,Z.needsUpdate=!0,P.renderBufferDirect(j,k,q,Z,E,Te),Z.side=ks,Z.needsUpdate=!0,P.renderBufferDirect(j,k,q,Z,E,Te),Z.side=Gi):P.renderBufferDirect(
j,k,q,Z,E,Te),E.onAfterRender(P,k,j,q,Z,Te)}function jt(E){let k=0;for(let j of E)j.texture!==null&&k++;return k}function Ci(E,k,j){k.isScene!==!0&&(k=cn);let q=ze.
get(E),Z=w.state.lights,Te=w.state.shadowsArray,Pe=Z.state.version,Ae=oe.getParameters(E,Z.state,Te,k,j,w.state.lightProbeGridArray),Ie=oe.getProgramCacheKey(Ae),
ke=q.programs;q.environment=E.isMeshStandardMaterial||E.isMeshLambertMaterial||E.isMeshPhongMaterial?k.environment:null,q.fog=k.fog;let je=E.isMeshStandardMaterial||
E.isMeshLambertMaterial&&!E.envMap||E.isMeshPhongMaterial&&!E.envMap;q.envMap=L.get(E.envMap||q.environment,je),q.envMapRotation=q.environment!==null&&E.envMap===
null?k.environmentRotation:E.envMapRotation,ke===void 0&&(E.addEventListener("dispose",ot),ke=new Map,q.programs=ke,q.programVariants=new Map);let dt=ke.get(Ie);
if(dt!==void 0){if(q.currentProgram===dt&&q.lightsStateVersion===Pe)return yo(E,Ae),dt}else Ae.uniforms=oe.getUniforms(E),F!==null&&E.isNodeMaterial&&F.build(E,
j,Ae),E.onBeforeCompile(Ae,P),dt=oe.acquireProgram(Ae,Ie),ke.set(Ie,dt),q.uniforms=Ae.uniforms;let Be=q.uniforms;return(!E.isShaderMaterial&&!E.isRawShaderMaterial||
E.clipping===!0)&&(Be.clippingPlanes=ie.uniform),yo(E,Ae),q.needsLights=ys(E),q.lightsStateVersion=Pe,q.needsLights&&(Be.ambientLightColor.value=Z.state.ambient,
Be.lightProbe.value=Z.state.probe,Be.sunLights.value=Z.state.sun,Be.sunLightShadows.value=Z.state.sunShadow,Be.directionalLights.value=Z.state.directional,Be.directionalLightShadows.
value=Z.state.directionalShadow,Be.spotLights.value=Z.state.spot,Be.spotLightShadows.value=Z.state.spotShadow,Be.rectAreaLights.value=Z.state.rectArea,Be.ltc_1.
value=Z.state.rectAreaLTC1,Be.ltc_2.value=Z.state.rectAreaLTC2,Be.pointLights.value=Z.state.point,Be.pointLightShadows.value=Z.state.pointShadow,Be.hemisphereLights.
value=Z.state.hemi,Be.sunShadowMatrix.value=Z.state.sunShadowMatrix,Be.sunShadowCascade.value=Z.state.sunShadowCascade,Be.directionalShadowMatrix.value=Z.state.
directionalShadowMatrix,Be.spotLightMatrix.value=Z.state.spotLightMatrix,Be.spotLightMap.value=Z.state.spotLightMap,Be.pointShadowMatrix.value=Z.state.pointShadowMatrix),
q.numLightProbeGrids=jt(w.state.lightProbeGridArray),q.currentProgram=dt,q.uniformsList=null,dt}function Xn(E,k,j,q,Z){let Te=ze.get(E),Pe=Te.currentProgram.id+
","+q+","+Z,Ae=Te.programVariants.get(Pe);return Ae===void 0?(Ae=Ci(E,k,j),Te.programVariants.set(Pe,Ae)):(Te.currentProgram=Ae,Te.uniformsList=null,Te.outputColorSpace=
q,Te.toneMapping=Z),Ae}function xs(E){if(E.uniformsList===null){let k=E.currentProgram.getUniforms();E.uniformsList=uo.seqWithValue(k.seq,E.uniforms)}return E.uniformsList}
function yo(E,k){let j=ze.get(E);j.outputColorSpace=k.outputColorSpace,j.batching=k.batching,j.batchingColor=k.batchingColor,j.instancing=k.instancing,j.instancingColor=
k.instancingColor,j.instancingMorph=k.instancingMorph,j.skinning=k.skinning,j.morphTargets=k.morphTargets,j.morphNormals=k.morphNormals,j.morphColors=k.morphColors,
j.morphTargetsCount=k.morphTargetsCount,j.numClippingPlanes=k.numClippingPlanes,j.numIntersection=k.numClipIntersection,j.vertexAlphas=k.vertexAlphas,j.vertexTangents=
k.vertexTangents,j.toneMapping=k.toneMapping}function vo(E,k,j,q,Z){k.isScene!==!0&&(k=cn),Xe.resetTextureUnits();let Te=k.fog,Pe=q.isMeshStandardMaterial||q.isMeshLambertMaterial||
q.isMeshPhongMaterial?k.environment:null,Ae=ce===null?P.outputColorSpace:ce.isXRRenderTarget===!0?ce.texture.colorSpace:_t.workingColorSpace,Ie=q.isMeshStandardMaterial||
q.isMeshLambertMaterial&&!q.envMap||q.isMeshPhongMaterial&&!q.envMap,ke=L.get(q.envMap||Pe,Ie),je=q.vertexColors===!0&&!!j.attributes.color&&j.attributes.color.
itemSize===4,dt=!!j.attributes.tangent&&(!!q.normalMap||q.anisotropy>0),Be=!!j.morphAttributes.position,ft=!!j.morphAttributes.normal,Xt=!!j.morphAttributes.color,
Et=Hi;q.toneMapped&&(ce===null||ce.isXRRenderTarget===!0)&&(Et=P.toneMapping);let Ct=j.morphAttributes.position||j.morphAttributes.normal||j.morphAttributes.color,
hn=Ct!==void 0?Ct.length:0,Ue=ze.get(q),tn=w.state.lights;if(Ut===!0&&(Qt===!0||E!==Q)){let Rt=E===Q&&q.id===K;ie.setState(q,E,Rt)}let mt=!1,Yi=!1;q.version===Ue.
__version?Ue.needsLights&&Ue.lightsStateVersion!==tn.state.version||Z.isBatchedMesh&&Ue.batching===!1||!Z.isBatchedMesh&&Ue.batching===!0||Z.isBatchedMesh&&Ue.batchingColor===
!0&&Z._colorsTexture===null||Z.isBatchedMesh&&Ue.batchingColor===!1&&Z._colorsTexture!==null||Z.isInstancedMesh&&Ue.instancing===!1||!Z.isInstancedMesh&&Ue.instancing===
!0||Z.isSkinnedMesh&&Ue.skinning===!1||!Z.isSkinnedMesh&&Ue.skinning===!0||Z.isInstancedMesh&&Ue.instancingColor===!0&&Z.instanceColor===null||Z.isInstancedMesh&&
Ue.instancingColor===!1&&Z.instanceColor!==null||Z.isInstancedMesh&&Ue.instancingMorph===!0&&Z.morphTexture===null||Z.isInstancedMesh&&Ue.instancingMorph===!1&&
Z.morphTexture!==null||Ue.envMap!==ke||q.fog===!0&&Ue.fog!==Te||Ue.numClippingPlanes!==void 0&&(Ue.numClippingPlanes!==ie.numPlanes||Ue.numIntersection!==ie.numIntersection)||
Ue.vertexAlphas!==je||Ue.vertexTangents!==dt||Ue.morphTargets!==Be||Ue.morphNormals!==ft||Ue.morphColors!==Xt||Ue.morphTargetsCount!==hn||Ue.numLightProbeGrids!==
jt(w.state.lightProbeGridArray)?mt=!0:(Ue.outputColorSpace!==Ae||Ue.toneMapping!==Et)&&(Yi=!0):(mt=!0,Ue.__version=q.version);let nn=Ue.currentProgram;(mt===!0||
Yi===!0)&&(nn=Yi===!0?Xn(q,k,Z,Ae,Et):Ci(q,k,Z),F&&q.isNodeMaterial&&F.onUpdateProgram(q,nn,Ue));let mr=!1,Ri=!1,Zi=!1,ct=nn.getUniforms(),Yt=Ue.uniforms;if(Se.
useProgram(nn.program)&&(mr=!0,Ri=!0,Zi=!0),q.id!==K&&(K=q.id,Ri=!0),mr||Q!==E){Se.buffers.depth.getReversed()&&E.reversedDepth!==!0&&(E._reversedDepth=!0,E.updateProjectionMatrix()),
ct.setValue(B,"projectionMatrix",E.projectionMatrix),ct.setValue(B,"viewMatrix",E.matrixWorldInverse);let sn=ct.map.cameraPosition;sn!==void 0&&sn.setValue(B,gn.
setFromMatrixPosition(E.matrixWorld)),it.logarithmicDepthBuffer&&ct.setValue(B,"logDepthBufFC",2/(Math.log(E.far+1)/Math.LN2)),(q.isMeshPhongMaterial||q.isMeshToonMaterial||
q.isMeshLambertMaterial||q.isMeshBasicMaterial||q.isMeshStandardMaterial||q.isShaderMaterial)&&ct.setValue(B,"isOrthographic",E.isOrthographicCamera===!0),Q!==E&&
(Q=E,Ri=!0,Zi=!0)}if(Ue.needsLights&&(tn.state.sunShadowMap.length>0&&ct.setValue(B,"sunShadowMap",tn.state.sunShadowMap,Xe),tn.state.directionalShadowMap.length>
0&&ct.setValue(B,"directionalShadowMap",tn.state.directionalShadowMap,Xe),tn.state.spotShadowMap.length>0&&ct.setValue(B,"spotShadowMap",tn.state.spotShadowMap,
Xe),tn.state.pointShadowMap.length>0&&ct.setValue(B,"pointShadowMap",tn.state.pointShadowMap,Xe)),Z.isSkinnedMesh){ct.setOptional(B,Z,"bindMatrix"),ct.setOptional(
B,Z,"bindMatrixInverse");let Rt=Z.skeleton;Rt&&(Rt.boneTexture===null&&Rt.computeBoneTexture(),ct.setValue(B,"boneTexture",Rt.boneTexture,Xe))}Z.isBatchedMesh&&
(ct.setOptional(B,Z,"batchingTexture"),ct.setValue(B,"batchingTexture",Z._matricesTexture,Xe),ct.setOptional(B,Z,"batchingIdTexture"),ct.setValue(B,"batchingIdT\
exture",Z._indirectTexture,Xe),ct.setOptional(B,Z,"batchingColorTexture"),Z._colorsTexture!==null&&ct.setValue(B,"batchingColorTexture",Z._colorsTexture,Xe));let Ln=j.
morphAttributes;if((Ln.position!==void 0||Ln.normal!==void 0||Ln.color!==void 0)&&re.update(Z,j,nn),(Ri||Ue.receiveShadow!==Z.receiveShadow)&&(Ue.receiveShadow=
Z.receiveShadow,ct.setValue(B,"receiveShadow",Z.receiveShadow)),(q.isMeshStandardMaterial||q.isMeshLambertMaterial||q.isMeshPhongMaterial)&&q.envMap===null&&k.environment!==
null&&(Yt.envMapIntensity.value=k.environmentIntensity),Yt.dfgLUT!==void 0&&(Yt.dfgLUT.value=Dw()),Ri){if(ct.setValue(B,"toneMappingExposure",P.toneMappingExposure),
Ue.needsLights&&fr(Yt,Zi),Te&&q.fog===!0&&_e.refreshFogUniforms(Yt,Te),_e.refreshMaterialUniforms(Yt,q,Me,Ee,w.state.transmissionRenderTarget[E.id]),Ue.needsLights&&
Ue.numLightProbeGrids>0){let Rt=b,sn=0;for(let Tn of w.state.lightProbeGridArray)Tn.texture!==null&&(Rt.textures[sn]=Tn.texture,Rt.min[sn]=Tn.boundingBox.min,Rt.
max[sn]=Tn.boundingBox.max,Rt.resolution[sn]=Tn.resolution,sn++);for(let Tn in Rt)Rt[Tn].length=sn;Yt.probesSH.value=Rt.textures,Yt.probesMin.value=Rt.min,Yt.probesMax.
value=Rt.max,Yt.probesResolution.value=Rt.resolution}uo.upload(B,xs(Ue),Yt,Xe)}if(q.isShaderMaterial&&q.uniformsNeedUpdate===!0&&(uo.upload(B,xs(Ue),Yt,Xe),q.uniformsNeedUpdate=
!1),q.isSpriteMaterial&&ct.setValue(B,"center",Z.center),ct.setValue(B,"modelViewMatrix",Z.modelViewMatrix),ct.setValue(B,"normalMatrix",Z.normalMatrix),ct.setValue(
B,"modelMatrix",Z.matrixWorld),q.uniformsGroups!==void 0){let Rt=q.uniformsGroups;for(let sn=0,Tn=Rt.length;sn<Tn;sn++){let Ra=Rt[sn];Ge.update(Ra,nn),Ge.bind(Ra,
nn)}}return nn}function fr(E,k){E.ambientLightColor.needsUpdate=k,E.lightProbe.needsUpdate=k,E.sunLights.needsUpdate=k,E.sunLightShadows.needsUpdate=k,E.directionalLights.
needsUpdate=k,E.directionalLightShadows.needsUpdate=k,E.pointLights.needsUpdate=k,E.pointLightShadows.needsUpdate=k,E.spotLights.needsUpdate=k,E.spotLightShadows.
needsUpdate=k,E.rectAreaLights.needsUpdate=k,E.hemisphereLights.needsUpdate=k}function ys(E){return E.isMeshLambertMaterial||E.isMeshToonMaterial||E.isMeshPhongMaterial||
E.isMeshStandardMaterial||E.isShadowMaterial||E.isShaderMaterial&&E.lights===!0}this.getActiveCubeFace=function(){return Y},this.getActiveMipmapLevel=function(){
return W},this.getRenderTarget=function(){return ce},this.setRenderTargetTextures=function(E,k,j){let q=ze.get(E);q.__autoAllocateDepthBuffer=E.resolveDepthBuffer===
!1,q.__autoAllocateDepthBuffer===!1&&(q.__useRenderToTexture=!1),ze.get(E.texture).__webglTexture=k,ze.get(E.depthTexture).__webglTexture=q.__autoAllocateDepthBuffer?
void 0:j,q.__hasExternalTextures=!0},this.setRenderTargetFramebuffer=function(E,k){let j=ze.get(E);j.__webglFramebuffer=k,j.__useDefaultFramebuffer=k===void 0},
this.setRenderTarget=function(E,k=0,j=0){ce=E,Y=k,W=j;let q=null,Z=!1,Te=!1;if(E){let Ae=ze.get(E);if(Ae.__useDefaultFramebuffer!==void 0){Se.bindFramebuffer(B.
FRAMEBUFFER,Ae.__webglFramebuffer),se.copy(E.viewport),de.copy(E.scissor),ue=E.scissorTest,Se.viewport(se),Se.scissor(de),Se.setScissorTest(ue),K=-1;return}else if(Ae.
__webglFramebuffer===void 0)Xe.setupRenderTarget(E);else if(Ae.__hasExternalTextures)Xe.rebindTextures(E,ze.get(E.texture).__webglTexture,ze.get(E.depthTexture).
__webglTexture);else if(E.depthBuffer){let je=E.depthTexture;if(Ae.__boundDepthTexture!==je){if(je!==null&&ze.has(je)&&(E.width!==je.image.width||E.height!==je.
image.height))throw new Error("THREE.WebGLRenderer: Attached DepthTexture is initialized to the incorrect size.");Xe.setupDepthRenderbuffer(E)}}let Ie=E.texture;
(Ie.isData3DTexture||Ie.isDataArrayTexture||Ie.isCompressedArrayTexture)&&(Te=!0);let ke=ze.get(E).__webglFramebuffer;E.isWebGLCubeRenderTarget?(Array.isArray(ke[k])?
q=ke[k][j]:q=ke[k],Z=!0):E.samples>0&&Xe.useMultisampledRTT(E)===!1?q=ze.get(E).__webglMultisampledFramebuffer:Array.isArray(ke)?q=ke[j]:q=ke,se.copy(E.viewport),
de.copy(E.scissor),ue=E.scissorTest}else se.copy(Ve).multiplyScalar(Me).floor(),de.copy(ut).multiplyScalar(Me).floor(),ue=lt;if(j!==0&&(q=z),Se.bindFramebuffer(
B.FRAMEBUFFER,q)&&Se.drawBuffers(E,q),Se.viewport(se),Se.scissor(de),Se.setScissorTest(ue),Z){let Ae=ze.get(E.texture);B.framebufferTexture2D(B.FRAMEBUFFER,B.COLOR_ATTACHMENT0,
B.TEXTURE_CUBE_MAP_POSITIVE_X+k,Ae.__webglTexture,j)}else if(Te){let Ae=k;for(let Ie=0;Ie<E.textures.length;Ie++){let ke=ze.get(E.textures[Ie]);B.framebufferTextureLayer(
B.FRAMEBUFFER,B.COLOR_ATTACHMENT0+Ie,ke.__webglTexture,j,Ae)}}else if(E!==null&&j!==0){let Ae=ze.get(E.texture);B.framebufferTexture2D(B.FRAMEBUFFER,B.COLOR_ATTACHMENT0,
B.TEXTURE_2D,Ae.__webglTexture,j)}K=-1};function pr(E){let k=ze.get(E);return(k.__readFormat!==E.format||k.__readType!==E.type)&&(k.__readFormat=E.format,k.__readType=
E.type,k.__formatReadable=it.textureFormatReadable(E.format),k.__typeReadable=it.textureTypeReadable(E.type)),k}this.readRenderTargetPixels=function(E,k,j,q,Z,Te,Pe,Ae=0){
if(!(E&&E.isWebGLRenderTarget)){Ke("WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");return}let Ie=ze.get(E).__webglFramebuffer;
if(E.isWebGLCubeRenderTarget&&Pe!==void 0&&(Ie=Ie[Pe],Array.isArray(Ie)&&(Ie=Ie[0])),Ie){Se.bindFramebuffer(B.FRAMEBUFFER,Ie);try{let ke=E.textures[Ae],je=ke.format,
dt=ke.type;E.textures.length>1&&B.readBuffer(B.COLOR_ATTACHMENT0+Ae);let Be=pr(ke);if(Be.__formatReadable===!1){Ke("WebGLRenderer.readRenderTargetPixels: render\
Target is not in RGBA or implementation defined format.");return}if(Be.__typeReadable===!1){Ke("WebGLRenderer.readRenderTargetPixels: renderTarget is not in Uns\
ignedByteType or implementation defined type.");return}k>=0&&k<=E.width-q&&j>=0&&j<=E.height-Z&&B.readPixels(k,j,q,Z,ge.convert(je),ge.convert(dt),Te)}finally{let ke=ce!==
null?ze.get(ce).__webglFramebuffer:null;Se.bindFramebuffer(B.FRAMEBUFFER,ke)}}},this.readRenderTargetPixelsAsync=async function(E,k,j,q,Z,Te,Pe,Ae=0){if(!(E&&E.
isWebGLRenderTarget))throw new Error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");let Ie=ze.get(E).__webglFramebuffer;
if(E.isWebGLCubeRenderTarget&&Pe!==void 0&&(Ie=Ie[Pe],Array.isArray(Ie)&&(Ie=Ie[0])),Ie)if(k>=0&&k<=E.width-q&&j>=0&&j<=E.height-Z){Se.bindFramebuffer(B.FRAMEBUFFER,
Ie);let ke=E.textures[Ae],je=ke.format,dt=ke.type;E.textures.length>1&&B.readBuffer(B.COLOR_ATTACHMENT0+Ae);let Be=pr(ke);if(Be.__formatReadable===!1)throw new Error(
"THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in RGBA or implementation defined format.");if(Be.__typeReadable===!1)throw new Error("THR\
EE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in UnsignedByteType or implementation defined type.");let ft=B.createBuffer();B.bindBuffer(B.PIXEL_PACK_BUFFER,
ft),B.bufferData(B.PIXEL_PACK_BUFFER,Te.byteLength,B.STREAM_READ),B.readPixels(k,j,q,Z,ge.convert(je),ge.convert(dt),0),B.bindBuffer(B.PIXEL_PACK_BUFFER,null);let Xt=ce!==
null?ze.get(ce).__webglFramebuffer:null;Se.bindFramebuffer(B.FRAMEBUFFER,Xt);let Et=B.fenceSync(B.SYNC_GPU_COMMANDS_COMPLETE,0);return B.flush(),await sg(B,Et,4),
B.bindBuffer(B.PIXEL_PACK_BUFFER,ft),B.getBufferSubData(B.PIXEL_PACK_BUFFER,0,Te),B.bindBuffer(B.PIXEL_PACK_BUFFER,null),B.deleteBuffer(ft),B.deleteSync(Et),Te}else
throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: requested read bounds are out of range.")},this.copyFramebufferToTexture=function(E,k=null,j=0){
let q=Math.pow(2,-j),Z=Math.floor(E.image.width*q),Te=Math.floor(E.image.height*q),Pe=k!==null?k.x:0,Ae=k!==null?k.y:0;Xe.setTexture2D(E,0),B.copyTexSubImage2D(
B.TEXTURE_2D,j,0,0,Pe,Ae,Z,Te),Se.unbindTexture()},this.copyTextureToTexture=function(E,k,j=null,q=null,Z=0,Te=0){let Pe,Ae,Ie,ke,je,dt,Be,ft,Xt,Et=E.isCompressedTexture?
E.mipmaps[Te]:E.image;if(j!==null)Pe=j.max.x-j.min.x,Ae=j.max.y-j.min.y,Ie=j.isBox3?j.max.z-j.min.z:1,ke=j.min.x,je=j.min.y,dt=j.isBox3?j.min.z:0;else{let ct=Math.
pow(2,-Z);Pe=Math.floor(Et.width*ct),Ae=Math.floor(Et.height*ct),E.isDataArrayTexture?Ie=Et.depth:E.isData3DTexture?Ie=Math.floor(Et.depth*ct):Ie=1,ke=0,je=0,dt=
0}q!==null?(Be=q.x,ft=q.y,Xt=q.z):(Be=0,ft=0,Xt=0);let Ct=ge.convert(k.format),hn=ge.convert(k.type),Ue;k.isData3DTexture?(Xe.setTexture3D(k,0),Ue=B.TEXTURE_3D):
k.isDataArrayTexture||k.isCompressedArrayTexture?(Xe.setTexture2DArray(k,0),Ue=B.TEXTURE_2D_ARRAY):(Xe.setTexture2D(k,0),Ue=B.TEXTURE_2D),Se.activeTexture(B.TEXTURE0),
Se.pixelStorei(B.UNPACK_FLIP_Y_WEBGL,k.flipY),Se.pixelStorei(B.UNPACK_PREMULTIPLY_ALPHA_WEBGL,k.premultiplyAlpha),Se.pixelStorei(B.UNPACK_ALIGNMENT,k.unpackAlignment);
let tn=Se.getParameter(B.UNPACK_ROW_LENGTH),mt=Se.getParameter(B.UNPACK_IMAGE_HEIGHT),Yi=Se.getParameter(B.UNPACK_SKIP_PIXELS),nn=Se.getParameter(B.UNPACK_SKIP_ROWS),
mr=Se.getParameter(B.UNPACK_SKIP_IMAGES);Se.pixelStorei(B.UNPACK_ROW_LENGTH,Et.width),Se.pixelStorei(B.UNPACK_IMAGE_HEIGHT,Et.height),Se.pixelStorei(B.UNPACK_SKIP_PIXELS,
ke),Se.pixelStorei(B.UNPACK_SKIP_ROWS,je),Se.pixelStorei(B.UNPACK_SKIP_IMAGES,dt);let Ri=E.isDataArrayTexture||E.isData3DTexture,Zi=k.isDataArrayTexture||k.isData3DTexture;
if(E.isDepthTexture){let ct=ze.get(E),Yt=ze.get(k),Ln=ze.get(ct.__renderTarget),Rt=ze.get(Yt.__renderTarget);Se.bindFramebuffer(B.READ_FRAMEBUFFER,Ln.__webglFramebuffer),
Se.bindFramebuffer(B.DRAW_FRAMEBUFFER,Rt.__webglFramebuffer);for(let sn=0;sn<Ie;sn++)Ri&&(B.framebufferTextureLayer(B.READ_FRAMEBUFFER,B.COLOR_ATTACHMENT0,ze.get(
E).__webglTexture,Z,dt+sn),B.framebufferTextureLayer(B.DRAW_FRAMEBUFFER,B.COLOR_ATTACHMENT0,ze.get(k).__webglTexture,Te,Xt+sn)),B.blitFramebuffer(ke,je,ke+Pe,je+
Ae,Be,ft,Be+Pe,ft+Ae,B.DEPTH_BUFFER_BIT,B.NEAREST);Se.bindFramebuffer(B.READ_FRAMEBUFFER,null),Se.bindFramebuffer(B.DRAW_FRAMEBUFFER,null)}else if(Z!==0||E.isRenderTargetTexture||
ze.has(E)){let ct=ze.get(E),Yt=ze.get(k);Se.bindFramebuffer(B.READ_FRAMEBUFFER,D),Se.bindFramebuffer(B.DRAW_FRAMEBUFFER,G);for(let Ln=0;Ln<Ie;Ln++)Ri?B.framebufferTextureLayer(
B.READ_FRAMEBUFFER,B.COLOR_ATTACHMENT0,ct.__webglTexture,Z,dt+Ln):B.framebufferTexture2D(B.READ_FRAMEBUFFER,B.COLOR_ATTACHMENT0,B.TEXTURE_2D,ct.__webglTexture,Z),
Zi?B.framebufferTextureLayer(B.DRAW_FRAMEBUFFER,B.COLOR_ATTACHMENT0,Yt.__webglTexture,Te,Xt+Ln):B.framebufferTexture2D(B.DRAW_FRAMEBUFFER,B.COLOR_ATTACHMENT0,B.
TEXTURE_2D,Yt.__webglTexture,Te),Z!==0?B.blitFramebuffer(ke,je,ke+Pe,je+Ae,Be,ft,Be+Pe,ft+Ae,B.COLOR_BUFFER_BIT,B.NEAREST):Zi?B.copyTexSubImage3D(Ue,Te,Be,ft,Xt+
Ln,ke,je,Pe,Ae):B.copyTexSubImage2D(Ue,Te,Be,ft,ke,je,Pe,Ae);Se.bindFramebuffer(B.READ_FRAMEBUFFER,null),Se.bindFramebuffer(B.DRAW_FRAMEBUFFER,null)}else Zi?E.isDataTexture||
E.isData3DTexture?B.texSubImage3D(Ue,Te,Be,ft,Xt,Pe,Ae,Ie,Ct,hn,Et.data):k.isCompressedArrayTexture?B.compressedTexSubImage3D(Ue,Te,Be,ft,Xt,Pe,Ae,Ie,Ct,Et.data):
B.texSubImage3D(Ue,Te,Be,ft,Xt,Pe,Ae,Ie,Ct,hn,Et):E.isDataTexture?B.texSubImage2D(B.TEXTURE_2D,Te,Be,ft,Pe,Ae,Ct,hn,Et.data):E.isCompressedTexture?B.compressedTexSubImage2D(
B.TEXTURE_2D,Te,Be,ft,Et.width,Et.height,Ct,Et.data):B.texSubImage2D(B.TEXTURE_2D,Te,Be,ft,Pe,Ae,Ct,hn,Et);Se.pixelStorei(B.UNPACK_ROW_LENGTH,tn),Se.pixelStorei(
B.UNPACK_IMAGE_HEIGHT,mt),Se.pixelStorei(B.UNPACK_SKIP_PIXELS,Yi),Se.pixelStorei(B.UNPACK_SKIP_ROWS,nn),Se.pixelStorei(B.UNPACK_SKIP_IMAGES,mr),Te===0&&k.generateMipmaps===
!0&&k.mipmapsAutoUpdate===!0&&B.generateMipmap(Ue),Se.unbindTexture()},this.initRenderTarget=function(E){ze.get(E).__webglFramebuffer===void 0&&Xe.setupRenderTarget(
E)},this.initTexture=function(E){E.isCubeTexture?Xe.setTextureCube(E,0):E.isData3DTexture?Xe.setTexture3D(E,0):E.isDataArrayTexture||E.isCompressedArrayTexture?
Xe.setTexture2DArray(E,0):Xe.setTexture2D(E,0),Se.unbindTexture()},this.resetState=function(){Y=0,W=0,ce=null,Se.reset(),be.reset()},typeof __THREE_DEVTOOLS__<"\
u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}get coordinateSystem(){return hi}get outputColorSpace(){return this._outputColorSpace}set outputColorSpace(e){
this._outputColorSpace=e;let t=this.getContext();t.drawingBufferColorSpace=_t._getDrawingBufferColorSpace(e),t.unpackColorSpace=_t._getUnpackColorSpace()}};var Zc=0,Uw=1,Fw=new V,Hg=new da,xd=new ti,Wg=new V,Yc=new Oi,Jc=class{constructor(){this.tolerance=-1,this.faces=[],this.newFaces=[],this.assigned=new Kc,this.
unassigned=new Kc,this.vertices=[]}setFromPoints(e){if(e.length>=4){this.makeEmpty();for(let t=0,n=e.length;t<n;t++)this.vertices.push(new yd(e[t]));this._compute()}
return this}setFromObject(e){let t=[];return e.updateMatrixWorld(!0),e.traverse(function(n){let s=n.geometry;if(s!==void 0){let r=s.attributes.position;if(r!==void 0)
for(let o=0,a=r.count;o<a;o++){let l=new V;l.fromBufferAttribute(r,o).applyMatrix4(n.matrixWorld),t.push(l)}}}),this.setFromPoints(t)}containsPoint(e){let t=this.
faces;for(let n=0,s=t.length;n<s;n++)if(t[n].distanceToPoint(e)>this.tolerance)return!1;return!0}intersectRay(e,t){let n=this.faces,s=-1/0,r=1/0;for(let o=0,a=n.
length;o<a;o++){let l=n[o],c=l.distanceToPoint(e.origin),d=l.normal.dot(e.direction);if(c>0&&d>=0)return null;let u=d!==0?-c/d:0;if(!(u<=0)&&(d>0?r=Math.min(u,r):
s=Math.max(u,s),s>r))return null}return s!==-1/0?e.at(s,t):e.at(r,t),t}intersectsRay(e){return this.intersectRay(e,Fw)!==null}makeEmpty(){return this.faces=[],this.
vertices=[],this}_addVertexToFace(e,t){return e.face=t,t.outside===null?this.assigned.append(e):this.assigned.insertBefore(t.outside,e),t.outside=e,this}_removeVertexFromFace(e,t){
return e===t.outside&&(e.next!==null&&e.next.face===t?t.outside=e.next:t.outside=null),this.assigned.remove(e),this}_removeAllVerticesFromFace(e){if(e.outside!==
null){let t=e.outside,n=e.outside;for(;n.next!==null&&n.next.face===e;)n=n.next;return this.assigned.removeSubList(t,n),t.prev=n.next=null,e.outside=null,t}}_deleteFaceVertices(e,t){
let n=this._removeAllVerticesFromFace(e);if(n!==void 0)if(t===void 0)this.unassigned.appendChain(n);else{let s=n;do{let r=s.next;t.distanceToPoint(s.point)>this.
tolerance?this._addVertexToFace(s,t):this.unassigned.append(s),s=r}while(s!==null)}return this}_resolveUnassignedPoints(e){if(this.unassigned.isEmpty()===!1){let t=this.
unassigned.first();do{let n=t.next,s=this.tolerance,r=null;for(let o=0;o<e.length;o++){let a=e[o];if(a.mark===Zc){let l=a.distanceToPoint(t.point);if(l>s&&(s=l,
r=a),s>1e3*this.tolerance)break}}r!==null&&this._addVertexToFace(t,r),t=n}while(t!==null)}return this}_computeExtremes(){let e=new V,t=new V,n=[],s=[];for(let r=0;r<
3;r++)n[r]=s[r]=this.vertices[0];e.copy(this.vertices[0].point),t.copy(this.vertices[0].point);for(let r=0,o=this.vertices.length;r<o;r++){let a=this.vertices[r],
l=a.point;for(let c=0;c<3;c++)l.getComponent(c)<e.getComponent(c)&&(e.setComponent(c,l.getComponent(c)),n[c]=a);for(let c=0;c<3;c++)l.getComponent(c)>t.getComponent(
c)&&(t.setComponent(c,l.getComponent(c)),s[c]=a)}return this.tolerance=3*Number.EPSILON*(Math.max(Math.abs(e.x),Math.abs(t.x))+Math.max(Math.abs(e.y),Math.abs(t.
y))+Math.max(Math.abs(e.z),Math.abs(t.z))),{min:n,max:s}}_computeInitialHull(){let e=this.vertices,t=this._computeExtremes(),n=t.min,s=t.max,r=0,o=0;for(let h=0;h<
3;h++){let f=s[h].point.getComponent(h)-n[h].point.getComponent(h);f>r&&(r=f,o=h)}let a=n[o],l=s[o],c,d;r=0,Hg.set(a.point,l.point);for(let h=0,f=this.vertices.
length;h<f;h++){let p=e[h];if(p!==a&&p!==l){Hg.closestPointToPoint(p.point,!0,Wg);let x=Wg.distanceToSquared(p.point);x>r&&(r=x,c=p)}}r=-1,xd.setFromCoplanarPoints(
a.point,l.point,c.point);for(let h=0,f=this.vertices.length;h<f;h++){let p=e[h];if(p!==a&&p!==l&&p!==c){let x=Math.abs(xd.distanceToPoint(p.point));x>r&&(r=x,d=
p)}}let u=[];if(xd.distanceToPoint(d.point)<0){u.push(Ai.create(a,l,c),Ai.create(d,l,a),Ai.create(d,c,l),Ai.create(d,a,c));for(let h=0;h<3;h++){let f=(h+1)%3;u[h+
1].getEdge(2).setTwin(u[0].getEdge(f)),u[h+1].getEdge(1).setTwin(u[f+1].getEdge(0))}}else{u.push(Ai.create(a,c,l),Ai.create(d,a,l),Ai.create(d,l,c),Ai.create(d,
c,a));for(let h=0;h<3;h++){let f=(h+1)%3;u[h+1].getEdge(2).setTwin(u[0].getEdge((3-h)%3)),u[h+1].getEdge(0).setTwin(u[f+1].getEdge(1))}}for(let h=0;h<4;h++)this.
faces.push(u[h]);for(let h=0,f=e.length;h<f;h++){let p=e[h];if(p!==a&&p!==l&&p!==c&&p!==d){r=this.tolerance;let x=null;for(let m=0;m<4;m++){let g=this.faces[m].
distanceToPoint(p.point);g>r&&(r=g,x=this.faces[m])}x!==null&&this._addVertexToFace(p,x)}}return this}_reindexFaces(){let e=[];for(let t=0;t<this.faces.length;t++){
let n=this.faces[t];n.mark===Zc&&e.push(n)}return this.faces=e,this}_nextVertexToAdd(){if(this.assigned.isEmpty()===!1){let e,t=0,n=this.assigned.first().face,s=n.
outside;do{let r=n.distanceToPoint(s.point);r>t&&(t=r,e=s),s=s.next}while(s!==null&&s.face===n);return e}}_computeHorizon(e,t,n,s){this._deleteFaceVertices(n),n.
mark=Uw;let r;t===null?r=t=n.getEdge(0):r=t.next;do{let o=r.twin,a=o.face;a.mark===Zc&&(a.distanceToPoint(e)>this.tolerance?this._computeHorizon(e,o,a,s):s.push(
r)),r=r.next}while(r!==t);return this}_addAdjoiningFace(e,t){let n=Ai.create(e,t.tail(),t.head());return this.faces.push(n),n.getEdge(-1).setTwin(t.twin),n.getEdge(
0)}_addNewFaces(e,t){this.newFaces=[];let n=null,s=null;for(let r=0;r<t.length;r++){let o=t[r],a=this._addAdjoiningFace(e,o);n===null?n=a:a.next.setTwin(s),this.
newFaces.push(a.face),s=a}return n.next.setTwin(s),this}_addVertexToHull(e){let t=[];return this.unassigned.clear(),this._removeVertexFromFace(e,e.face),this._computeHorizon(
e.point,null,e.face,t),this._addNewFaces(e,t),this._resolveUnassignedPoints(this.newFaces),this}_cleanup(){return this.assigned.clear(),this.unassigned.clear(),
this.newFaces=[],this}_compute(){let e;for(this._computeInitialHull();(e=this._nextVertexToAdd())!==void 0;)this._addVertexToHull(e);return this._reindexFaces(),
this._cleanup(),this}},Ai=class i{constructor(){this.normal=new V,this.midpoint=new V,this.area=0,this.constant=0,this.outside=null,this.mark=Zc,this.edge=null}static create(e,t,n){
let s=new i,r=new Ea(e,s),o=new Ea(t,s),a=new Ea(n,s);return r.next=a.prev=o,o.next=r.prev=a,a.next=o.prev=r,s.edge=r,s.compute()}getEdge(e){let t=this.edge;for(;e>
0;)t=t.next,e--;for(;e<0;)t=t.prev,e++;return t}compute(){let e=this.edge.tail(),t=this.edge.head(),n=this.edge.next.head();return Yc.set(e.point,t.point,n.point),
Yc.getNormal(this.normal),Yc.getMidpoint(this.midpoint),this.area=Yc.getArea(),this.constant=this.normal.dot(this.midpoint),this}distanceToPoint(e){return this.
normal.dot(e)-this.constant}},Ea=class{constructor(e,t){this.vertex=e,this.prev=null,this.next=null,this.twin=null,this.face=t}head(){return this.vertex}tail(){
return this.prev?this.prev.vertex:null}length(){let e=this.head(),t=this.tail();return t!==null?t.point.distanceTo(e.point):-1}lengthSquared(){let e=this.head(),
t=this.tail();return t!==null?t.point.distanceToSquared(e.point):-1}setTwin(e){return this.twin=e,e.twin=this,this}},yd=class{constructor(e){this.point=e,this.prev=
null,this.next=null,this.face=null}},Kc=class{constructor(){this.head=null,this.tail=null}first(){return this.head}last(){return this.tail}clear(){return this.head=
this.tail=null,this}insertBefore(e,t){return t.prev=e.prev,t.next=e,t.prev===null?this.head=t:t.prev.next=t,e.prev=t,this}insertAfter(e,t){return t.prev=e,t.next=
e.next,t.next===null?this.tail=t:t.next.prev=t,e.next=t,this}append(e){return this.head===null?this.head=e:this.tail.next=e,e.prev=this.tail,e.next=null,this.tail=
e,this}appendChain(e){for(this.head===null?this.head=e:this.tail.next=e,e.prev=this.tail;e.next!==null;)e=e.next;return this.tail=e,this}remove(e){return e.prev===
null?this.head=e.next:e.prev.next=e.next,e.next===null?this.tail=e.prev:e.next.prev=e.prev,this}removeSubList(e,t){return e.prev===null?this.head=t.next:e.prev.
next=t.next,t.next===null?this.tail=e.prev:t.next.prev=e.prev,this}isEmpty(){return this.head===null}};var jc=class extends ln{constructor(e=[]){super();let t=[],n=[],r=new Jc().setFromPoints(e).faces;for(let o=0;o<r.length;o++){let a=r[o],l=a.edge;do{let c=l.head().
point;t.push(c.x,c.y,c.z),n.push(a.normal.x,a.normal.y,a.normal.z),l=l.next}while(l!==a.edge)}this.setAttribute("position",new yt(t,3)),this.setAttribute("norma\
l",new yt(n,3))}};var Qc=24,vd=.1;function Xg(i,e){return i===0?e.rotateZ(-Math.PI/2):i===2?e.rotateX(Math.PI/2):e}var Ow=i=>Array.from({length:i.length/3},(e,t)=>new V().fromArray(
i,3*t));function Bw({points:i,triangles:e}){let t=new ln;t.setAttribute("position",new yt(i,3)),t.setIndex(e);let n=t.toNonIndexed();return n.computeVertexNormals(),
n}var bd=Ui({box:{geometry:()=>new Ds,has_edges:!0},sphere:{geometry:({radius:i})=>new ia(i,Qc,Qc/2)},capsule:{geometry:i=>Xg(i.axis,new ea(i.radius,2*i.half_length,
8,Qc))},cylinder:{geometry:i=>Xg(i.axis,new Us(i.radius,i.radius,2*i.half_length,Qc))},hull:{geometry:({points:i})=>new jc(Ow(i))},mesh:{geometry:Bw}}),Md=i=>i.
shape!=="box"&&i.shape in bd,$g=i=>Md(i)?bd[i.shape]:bd.box,qg=i=>Md(i)?"".concat(i.shape," ").concat(i.index):"box",Sd=i=>i.size[0]>0?i.size:[vd,vd,vd],Yg=i=>Md(
i)?[1,1,1]:Sd(i);var ms=0;var Zg=2,eh=3,kw=32767,zw=new xt().makeScale(0,0,0);function Vw(i){return i.defines={USE_UV:""},i.onBeforeCompile=e=>{e.fragmentShader=e.fragmentShader.replace(
"#include <color_fragment>",["#include <color_fragment>","vec2 toEdge = min(vUv, 1.0 - vUv) / max(fwidth(vUv), vec2(1e-6));","float flatness = clamp(3.0 * max(f\
width(vUv).x, fwidth(vUv).y), 0.0, 1.0);","diffuseColor.rgb *= mix(mix(0.5, 1.0, flatness), 1.0, smoothstep(0.4, 1.6, min(toEdge.x, toEdge.y)));"].join("\n"))},
i}function Gw(i,e){if(i==="marks")return new hs({wireframe:!0,depthTest:!1});let t=new sa;return e?Vw(t):t}function Jg(i,e,t){let n=new Gn,s=new Gn,r=[],o={count:0},
a=null,l=h=>{for(let{mesh:f}of r)f.material.transparent=h,f.material.opacity=h?.45:1,f.material.depthWrite=!h,f.material.needsUpdate=!0,f.renderOrder=h?1:0},c=()=>{
for(let{mesh:f}of r)n.remove(f),f.geometry.dispose(),f.material.dispose(),f.dispose();let h=new Map;for(let f=0;f<o.count;++f){let p=o.body(f),x=i==="marks"?"ma\
rks":qg(p);h.has(x)||h.set(x,{body:p,rows:[]}),h.get(x).rows.push(f)}r=[...h.values()].map(({body:f,rows:p})=>{let x=$g(f),m=i==="marks"?new so(.5):x.geometry(f),
g=new Is(m,Gw(i,x.has_edges),p.length);return g.frustumCulled=!1,i==="marks"&&(g.renderOrder=2),n.add(g),{mesh:g,rows:p}}),i==="ghost"&&l(!0)},d=new rt(e);n.add(
s);let u={group:n,set_ghost:l,describe(h){o=h,c(),a&&u.show(...a)},show(h,f={}){a=[h,f];let p=new xt,x=new V,m=new kn,g=new V,y=new rt;for(let{mesh:S,rows:b}of r)
b.forEach((C,w)=>{if(!(h&&C<h.rows&&h.mark[C]!==ms&&h.mark[C]!==eh)||f.hidden?.(C))S.setMatrixAt(w,zw);else{let M=o.body(C),R=h.rows;x.set(h.x[C],h.y[C],h.z[C]),
i==="marks"?(g.setScalar(Math.min(...Sd(M))),m.identity()):(g.set(...Yg(M)),m.set(h.turn[R+C],h.turn[2*R+C],h.turn[3*R+C],h.turn[C]).normalize()),S.setMatrixAt(
w,p.compose(x,m,g))}y.copy(d),f.colour?.(C,y,h),S.setColorAt(w,y)}),S.instanceMatrix.needsUpdate=!0,S.instanceColor&&(S.instanceColor.needsUpdate=!0),S.boundingSphere=
null;u.mark_lost(f.lost??[])},mark_lost(h){for(let x of[...s.children])s.remove(x),x.geometry.dispose(),x.material.dispose();if(h.length===0)return;let f=new Is(
new so(.7),new hs({color:t.bad,wireframe:!0,depthTest:!1}),h.length);f.frustumCulled=!1,f.renderOrder=4;let p=new xt;h.forEach(({at:x,size:m},g)=>{f.setMatrixAt(
g,p.compose(new V(...x),new kn,new V().setScalar(m)))}),s.add(f)},hits(h){return r.flatMap(({mesh:f,rows:p})=>{let x=[];return f.raycast(h,x),x.map(m=>({distance:m.
distance,row:p[m.instanceId]}))})}};return u}function Kg(i,e){let t=new Int16Array(4*i);for(let n=0;n<i;++n)e(n).forEach((s,r)=>{t[r*i+n]=Math.round(kw*s)});return t}var jg=1e3/30,Hw=[.05,.1,.25,.5,1,2,4,8,16],Ww={first:"M5 4v12M16 4l-8 6 8 6z",back:"M15 4l-9 6 9 6z",less:"M12 5l-6 5 6 5",more:"M8 5l6 5-6 5",play:"M6 4l9 6-9\
 6z",last:"M15 4v12M4 4l8 6-8 6z",pause:"M6 4v12M13 4v12"};function Qg(i){let e=document.createElement("span");return e.className="icon",e.innerHTML='<svg viewB\
ox="0 0 20 20" aria-hidden="true" fill="none" stroke="currentColor" stroke-width="2" '+'stroke-linejoin="round" stroke-linecap="round"><path d="'.concat(Ww[i],'\
"/></svg>'),e}function Vs(i,e,t){let n=X("button",{type:"button",className:i,title:e},Qg(i));return n.setAttribute("aria-label",e),n.addEventListener("click",t),
n}var hr=class{constructor(e,t,n=null){this.first=e,this.last=t,this.list=n}at_or_before(e){let t=Math.min(this.last,Math.max(this.first,Math.round(e)));return this.
list?this.list[Math.max(0,this.rank(t))]:t}rank(e){let t=0,n=this.list.length;for(;t<n;){let s=t+n>>1;this.list[s]<=e?t=s+1:n=s}return t-1}beside(e,t){return this.
list?this.list[Math.min(this.list.length-1,Math.max(0,this.rank(e)+t))]:this.at_or_before(e+t)}};function th({steps:i,dt:e,show:t,label:n="step shown",full:s=!0,
played:r=()=>{}}){let o=i.first,a=null,l=0,c=o,d=performance.now(),u=X("input",{type:"range",className:"scrubber",min:i.first,max:i.last,value:o});u.setAttribute(
"aria-label",n);let h=X("select",{className:"speed"},...Hw.map(R=>X("option",{value:R,textContent:"\xD7".concat(R),selected:R===1})));h.setAttribute("aria-label",
"speed of playing");let f=X("input",{type:"number",className:"step",min:i.first,max:i.last,value:o});f.setAttribute("aria-label","step");let p=()=>{u.value=o,document.
activeElement!==f&&(f.value=o),t(o)},x=()=>{clearInterval(a),a=null;let R=l!==0;l=0,w(),R&&r(0)},m=R=>{let P=i.at_or_before(R);if(P===o){u.value=o;return}o=P,p()},
g=R=>{x(),m(R)},y=()=>{let R=performance.now();c+=l*Number(h.value)*Math.min(.25,(R-d)/1e3)/Math.max(e(),1e-9),d=R,m(c),(l>0?c>=i.last:c<=i.first)&&x()},S=R=>{if(l===
R)return x();x(),l=R,R>0&&o>=i.at_or_before(i.last)&&m(i.first),R<0&&o<=i.first&&m(i.last),c=o,d=performance.now(),a=setInterval(y,jg),w(),r(R)},b=Vs("play","pl\
ay",()=>S(1)),C=Vs("back","play backwards",()=>S(-1));function w(){for(let[R,P,I,F]of[[b,1,"play","play"],[C,-1,"back","play backwards"]]){let z=l===P;R.replaceChildren(
Qg(z?"pause":I)),R.setAttribute("aria-label",z?"pause":F),R.title=z?"pause":F}}let _=R=>{x(),m(i.beside(o,R))};return u.addEventListener("input",()=>g(Number(u.
value))),u.addEventListener("keydown",R=>{let P={ArrowLeft:-1,ArrowDown:-1,ArrowRight:1,ArrowUp:1,PageUp:10,PageDown:-10}[R.key];P===void 0||R.ctrlKey||R.metaKey||
R.altKey||(R.preventDefault(),R.stopPropagation(),_(R.shiftKey?10*P:P))}),f.addEventListener("change",()=>{g(Number(f.value)),f.value=o}),{bar:s?X("div",{className:"\
player"},Vs("first","first step",()=>g(i.first)),C,Vs("less","one step back",()=>_(-1)),Vs("more","one step on",()=>_(1)),b,Vs("last","last step",()=>g(i.last)),
h,u,f):X("div",{className:"player"},C,Vs("less","one step back",()=>_(-1)),Vs("more","one step on",()=>_(1)),b,u),slider:u,seek:g,move:_,play:S,stop:x,get step(){
return o},get direction(){return l},get stride(){return Math.max(1,Number(h.value)*jg/1e3/Math.max(e(),1e-9))},set_last(R){let P=o===i.last;return i.last=R,u.max=
f.max=R,P},refresh:p}}function nh(i,e,t=null){let n=0,s=new Map,r=()=>{let[l,c]=[...s.values()];return Math.hypot(l.x-c.x,l.y-c.y)};i.addEventListener("pointerdown",l=>{i.setPointerCapture(
l.pointerId),i.focus({preventScroll:!0}),s.set(l.pointerId,{x:l.clientX,y:l.clientY}),n=0}),i.addEventListener("pointermove",l=>{if(l.buttons!==0){if(n+=Math.abs(
l.movementX)+Math.abs(l.movementY),s.size===2){let c=r();s.set(l.pointerId,{x:l.clientX,y:l.clientY}),e.zoom(c/Math.max(1,r()))}else l.shiftKey||l.buttons!==1?e.
pan(l.movementX/i.clientHeight,l.movementY/i.clientHeight):e.turn(-.008*l.movementX,.008*l.movementY);s.has(l.pointerId)&&s.set(l.pointerId,{x:l.clientX,y:l.clientY})}});
let o=l=>s.delete(l.pointerId);i.addEventListener("pointerup",l=>{if(o(l),n>4||l.button!==0||!t)return;let c=i.getBoundingClientRect();t((l.clientX-c.left)/c.width,
(l.clientY-c.top)/c.height)}),i.addEventListener("pointercancel",o),i.addEventListener("contextmenu",l=>l.preventDefault()),i.addEventListener("wheel",l=>{document.
activeElement===i&&(l.preventDefault(),e.zoom(Math.exp(l.deltaY/800)))},{passive:!1});let a={ArrowLeft:l=>l?e.pan(.05,0):e.turn(-.12,0),ArrowRight:l=>l?e.pan(-.05,
0):e.turn(.12,0),ArrowUp:l=>l?e.pan(0,.05):e.turn(0,.12),ArrowDown:l=>l?e.pan(0,-.05):e.turn(0,-.12),"+":()=>e.zoom(.85),"=":()=>e.zoom(.85),"-":()=>e.zoom(1/.85)};
i.addEventListener("keydown",l=>{!(l.key in a)||l.ctrlKey||l.metaKey||l.altKey||(l.preventDefault(),l.stopPropagation(),a[l.key](l.shiftKey))})}function ih(i,e,t=!1){
let n=i.map(a=>{let l=a.filter(c=>Number.isFinite(c)).sort((c,d)=>c-d);return l.length===0?[0,0]:[l[Math.floor(.05*(l.length-1))],l[Math.ceil(.95*(l.length-1))]]}),
s=n[2][0];t&&s>2*e&&s<10*Math.max(e,...n.map(([a,l])=>l-a))&&(n[2][0]=0);let r=n.map(([a,l])=>(a+l)/2),o=Math.hypot(...n.map(([a,l])=>l-a));return{centre:r,radius:Math.
max(o/2+Math.min(Math.max(e,.1),4),.001)}}var Xw=.07,$w=.25;function wd(i,e){let t=new Gn,n=new Us(.5,.5,1,6).translate(0,.5,0),s=new ta(.5,1,10).translate(0,.5,0),r=new hs({color:i,depthTest:!1,transparent:!0,
opacity:.9}),o=[];return{group:t,show(a,l){for(let x of o)t.remove(x),x.dispose();if(o=[],a.length===0)return;let[c,d]=o=[n,s].map(x=>new Is(x,r,a.length)),u=Xw*
l,h=Vn([...a.map(x=>x.impulse),1e-30]),f=new V(0,1,0),p=new xt;a.forEach(({at:x,normal:m,impulse:g},y)=>{let S=u*Math.max($w,Math.sqrt(Math.max(0,g)/h)),b=new kn().
setFromUnitVectors(f,new V(...m).normalize()),C=new V(...x),w=u*.05*e;c.setMatrixAt(y,p.compose(C,b,new V(w,S*.7,w)));let _=new V(0,S*.7,0).applyQuaternion(b).add(
C);d.setMatrixAt(y,p.compose(_,b,new V(w*3.4,S*.3,w*3.4)))});for(let x of o)x.frustumCulled=!1,x.renderOrder=3,t.add(x)}}}var Ad=40,qw=2;function Yw(i,e){let t=new ln;t.setAttribute("position",new yt(i,3));let n=new io(t,e);return n.frustumCulled=!1,e.isLineDashedMaterial&&n.computeLineDistances(),
n}function Td(i){i.traverse?.(e=>{e.geometry?.dispose(),e.material?.dispose(),e.dispose?.()}),i.removeFromParent()}function Zw(i,e){let t={around:-.9,up:.45,distance:.82*
i/Math.sin(Ad/2*Math.PI/180),centre:new V};if(e){let n=new V(...e.position).sub(new V(...e.target));t.around=Math.atan2(n.y,n.x),t.up=Math.min(1.5,Math.max(-.3,
Math.asin(n.z/n.length())))}return t}function sh(i,{hue:e,box:t,camera:n,ground:s=!0}){let r=new Xc({canvas:i,antialias:!0,alpha:!0});r.setPixelRatio(Math.min(devicePixelRatio,
qw));let{radius:o}=t,a=new $o,l=new On(Ad,1,o/200,o*200);l.up.set(0,0,1);let c=new ro("#ffffff",2.2);c.position.set(.45,-.7,1);let d=new ro("#ffffff",.7);if(d.position.
set(-.8,.3,.4),a.add(new la("#ffffff","#c9d1da",1.9),c,d),s){let _=new fa(8*o,40,e.line,e.line);_.rotation.x=Math.PI/2,_.position.set(t.centre[0],t.centre[1],0),
a.add(_)}let u=Zw(o,n);u.centre.set(...t.centre);let h=[],f=new Gn;a.add(f);let p=[wd(e.contact,1),wd(e.expected,.7)];for(let{group:_}of p)a.add(_);let x=new Map,
m=!1,g=!1,y=0,S=()=>{let _=u.distance*Math.max(1,.95/l.aspect),M=Math.cos(u.up)*_;l.position.set(u.centre.x+M*Math.cos(u.around),u.centre.y+M*Math.sin(u.around),
u.centre.z+_*Math.sin(u.up)),l.lookAt(u.centre)},b=()=>m&&h.length===2?2:1,C=()=>{cancelAnimationFrame(y),y=0,g=!0;let _=r.getSize(new st),M=b();l.aspect=_.x/M/
Math.max(1,_.y),l.updateProjectionMatrix(),S(),r.setScissorTest(M===2);for(let R=0;R<M;++R){let P=Math.round(R*_.x/M);r.setViewport(P,0,_.x/M,_.y),r.setScissor(
P,0,_.x/M,_.y),h.forEach((I,F)=>{I.group.visible=M===1||F===R}),p.forEach(({group:I},F)=>{I.visible=M===1||F===R});for(let{session:I,line:F}of x.values())F.visible=
M===1||I===R;r.render(a,l)}},w=()=>{y||=requestAnimationFrame(C)};return{view:u,draw:w,draw_now:C,add_session(_,M){let R=Jg(_,M,e);return h.push(R),a.add(R.group),
{describe(P){R.describe(P),w()},show(P,I){R.show(P,I),w()}}},set_side_by_side(_){m=_,h[1]?.set_ghost(!_),w()},set_lines(_,M){if(x.has(_)&&Td(x.get(_).line),x.delete(
_),M&&M.points.length>0){let{points:R,colour:P,dash:I,on_top:F}=M,z={color:P,depthTest:!F,transparent:!0,opacity:M.opacity??1},D=I?new ra({...z,dashSize:I,gapSize:.7*
I}):new Ns(z),G=Yw(R,D);G.renderOrder=F?2:1,f.add(G),x.set(_,{line:G,session:M.session??0})}w()},set_arrows(_,M=0){p[M].show(_,u.distance),w()},pick(_,M){let R=b(),
P=Math.min(R-1,Math.floor(_*R));S(),l.updateMatrixWorld();let I=new ua;I.setFromCamera(new st(2*(_*R-P)-1,1-2*M),l);let F=h.flatMap((z,D)=>R===2&&D!==P?[]:z.hits(
I).map(G=>({...G,session:D})));return F.sort((z,D)=>z.distance-D.distance),F[0]??null},turn(_,M){u.around+=_,u.up=Math.min(1.55,Math.max(-.3,u.up+M)),w()},zoom(_){
u.distance=Math.min(40*o,Math.max(o/100,u.distance*_)),w()},pan(_,M){S(),l.updateMatrixWorld();let R=2*u.distance*Math.tan(Ad/2*Math.PI/180),P=new V().setFromMatrixColumn(
l.matrixWorld,0).multiplyScalar(-_*R);u.centre.add(P.add(new V().setFromMatrixColumn(l.matrixWorld,1).multiplyScalar(M*R))),w()},look_at(_){u.centre.set(..._),w()},
resize(_,M){let R=r.getSize(new st);R.x===_&&R.y===M||(r.setSize(_,M,!1),g?C():w())},dispose(){for(let _ of h)Td(_.group);Td(f),a.traverse(_=>{_.geometry?.dispose(),
_.material?.dispose()}),r.dispose(),r.forceContextLoss()}}}var Cd=2,Jw=.05,Rd=40,Kw=.15,Gs=(i,e)=>{let t=i===null?[null]:i.slice(3*e,3*e+3);return t.includes(null)?null:t.map(n=>n/1e3)};function jw(i){let{actual_mm:e,expected_mm:t}=i.
frames;return e.map((n,s)=>i.bodies.id.map((r,o)=>{let a=Gs(n,o),l=Gs(t[s],o);return a&&l?1e3*Math.hypot(a[0]-l[0],a[1]-l[1],a[2]-l[2]):null}))}function Qw(i,e){
let t=Vn([0,...e.flat()]);return i.bodies.id.map((n,s)=>{let r=1e3*Math.min(...i.bodies.size.slice(3*s,3*s+3));return Math.max(Cd,Jw*Math.min(t,r>0?r:t))})}function e0(i,e,t){
let n=i.bodies.id.length,s={rows:n,x:new Float32Array(n),y:new Float32Array(n),z:new Float32Array(n),mark:new Uint8Array(n),turn:Kg(n,r=>{let o=t?.slice(4*r,4*r+
4)??[];return o.length===4&&!o.includes(null)?o:[1,0,0,0]})};for(let r=0;r<n;++r){let o=Gs(e,r);o&&([s.x[r],s.y[r],s.z[r]]=o,s.mark[r]=1)}return s}function t0(i,e,t){
let n=i.bodies.id.map((o,a)=>Vn(t.map(l=>l[a]??0))),s=n.map((o,a)=>a).sort((o,a)=>n[a]-n[o]).slice(0,Rd),r=[];for(let o of s)for(let a=1;a<e.length;++a){let l=Gs(
e[a-1],o),c=Gs(e[a],o);l&&c&&r.push(...l,...c)}return r}var Ed=(i,e)=>{let t=X("span",{className:"key"});return t.innerHTML='<svg viewBox="0 0 36 16" aria-hidde\
n="true" fill="none" stroke-width="2">'.concat(i,"</svg>"),t.append(e),t};function e1(){return X("p",{},Ed('<path d="M0 8H36" stroke="var(--actual)"/><rect x="1\
2" y="2" width="12" height="12" fill="var(--actual)"/>',"this run"),Ed('<path d="M0 8H36" stroke="var(--expected)" stroke-dasharray="5 4"/>\n      <path d="M18 1\
l7 7-7 7-7-7z" stroke="var(--expected)"/>',"expected, if to be seen elsewhere"),Ed('<path d="M0 8H36" stroke="var(--bad)"/>',"from one to the other"))}function t1(i,e,t){
let n=e[t].map((c,d)=>({value:c,id:i.bodies.id[d]})).filter(({value:c})=>c!==null),s="step ".concat(i.frames.step[t]),r=i.bodies.id.filter((c,d)=>!Gs(i.frames.actual_mm[t],
d)),o=r.length===0?"":"; body ".concat(r[0]).concat(r.length>1?" and ".concat(r.length-1," more"):""," without a place (gone, or not finite)");if(n.length===0)return"".
concat(s,": nothing to compare here").concat(o);let a=n.reduce((c,d)=>d.value>c.value?d:c),l=n.filter(({value:c})=>c>Cd).length;return l===0?"".concat(s,": ever\
y body within ").concat(Cd," mm of where it was expected").concat(o):"".concat(s,": ").concat(l," of ").concat(n.length," bodies elsewhere, the furthest is body\
 ").concat(a.id,", ")+"".concat(An(a.value/1e3)," away").concat(o)}function n1(i){return{count:i.bodies.id.length,body:e=>({shape:"box",size:i.bodies.size.slice(
3*e,3*e+3)})}}function i1(i){let e=[...i.frames.actual_mm,...i.frames.expected_mm].filter(n=>n!==null),t=[0,1,2].map(n=>e.flatMap(s=>s.filter((r,o)=>o%3===n&&r!==
null)).map(s=>s/1e3));return ih(t,Vn([...i.bodies.size,.1]))}var Pd=class{constructor(e,t,n){Object.assign(this,{place:e,data:t,apart:n,frame:0,stage:null,last_view:null}),
this.limits=Qw(t,n),new IntersectionObserver(s=>{s.at(-1).isIntersecting?this.open():this.close()},{rootMargin:"100px"}).observe(e)}open(){if(this.stage)return;
let e=X("canvas",{tabIndex:0});e.setAttribute("role","img"),e.setAttribute("aria-label","The bodies in three dimensions. Arrow keys turn the view, with Shift th\
ey move it, + and - zoom."),this.place.replaceChildren(e);let t=Qi(),n=i1(this.data);try{this.stage=sh(e,{hue:t,box:n})}catch{this.place.textContent="This brows\
er has no WebGL, so there is no view; the words below say the same.";return}this.last_view&&Object.assign(this.stage.view,this.last_view),this.actual=this.stage.
add_session("solid",t.actual),this.expected=this.stage.add_session("marks",t.expected);for(let s of[this.actual,this.expected])s.describe(n1(this.data));this.stage.
set_lines("actual",{points:t0(this.data,this.data.frames.actual_mm,this.apart),colour:t.actual}),this.stage.set_lines("expected",{points:t0(this.data,this.data.
frames.expected_mm,this.apart),colour:t.expected,dash:n.radius/40}),nh(e,this.stage),this.resize(),this.show(this.frame)}close(){this.stage&&(this.last_view={...this.
stage.view},this.stage.dispose(),this.stage=null,this.place.replaceChildren())}show(e){if(this.frame=e,!this.stage)return;let{frames:t,bodies:n}=this.data,s=o=>this.
apart[e][o]!==null&&this.apart[e][o]<=this.limits[o];this.actual.show(e0(this.data,t.actual_mm[e],t.actual_turn[e]),{colour:(o,a)=>a.offsetHSL(0,0,.035*(o%5-2))}),
this.expected.show(e0(this.data,t.expected_mm[e],null),{hidden:s});let r=n.id.flatMap((o,a)=>{let l=Gs(t.actual_mm[e],a),c=Gs(t.expected_mm[e],a);return l&&c&&!s(
a)?[...l,...c]:[]});this.stage.set_lines("links",{points:r,colour:Qi().bad,on_top:!0}),this.stage.draw_now()}resize(){let{clientWidth:e,clientHeight:t}=this.place;
e>0&&this.stage?.resize(e,t)}};function n0(i,e,t){let n=e.frames.step.length-1;if(n<0||e.bodies.id.length===0)return null;let s=jw(e),r=X("div",{className:"view\
3d"}),o=X("output"),a=new Pd(r,e,s),l=th({steps:new hr(0,n),dt:()=>Kw,full:!1,show:d=>{let u=t1(e,s,d);l.slider.setAttribute("aria-valuetext",u),o.value=u,a.show(
d),t(e.frames.step[d])}});i.append(X("h3",{textContent:"Where the bodies went"}),e1(),r,X("div",{className:"controls"},l.bar,o),X("p",{className:"soft",textContent:"\
Drag or use the arrow keys to turn, + and - to zoom. "+"Lines: the ways of ".concat(e.bodies.id.length>Rd?"the ".concat(Rd," of ").concat(e.bodies.id.length," b\
odies that went furthest astray"):"the bodies",".")}));let c=s.map(d=>Vn(d.map(u=>u??0)));return l.seek(c.indexOf(Vn(c))),l.refresh(),{resize:()=>a.resize(),redraw(){
a.close(),a.open()}}}var i0=5e-4,s0=24,oh=50,s1={crate:"#c99a5b",brick:"#b8573f",wood:"#b58550",concrete:"#98a2ad",white:"#dfe4e8"},r0=(i,e)=>e.setHSL(.62*(1-Math.min(1,Math.max(0,i))),
.75,.5),rh=class{constructor(e,t,n){Object.assign(this,{place:e,sessions:t,picked:n,frames:[null,null],selected:null,paint:"material",contacts:[null,null],with_contacts:!1,
with_ways:!1,side_by_side:!1,following:!1,ways:new Map,lost_places:new Map,ways_said:[],top_speed:1,focus:null}),this.open()}open(){let e=X("canvas",{tabIndex:0});
e.setAttribute("role","img"),e.setAttribute("aria-label","The bodies in three dimensions. Arrow keys turn the view, with Shift they move it, + and - zoom."),this.
canvas=e,this.tags=this.sessions.map((t,n)=>X("span",{className:"tag",hidden:this.sessions.length<2,textContent:n===0?"A":"B, ghost"})),this.over=X("p",{className:"\
over-view",hidden:!0}),this.place.replaceChildren(e,...this.tags,this.over),this.stage=null}start(){this.hue=Qi();let e=this.frames.find(a=>a&&a.rows>0),t=a=>e?
Array.from(e[a]).filter((l,c)=>e.mark[c]!==ms):[],n=this.sessions[0].bodies,s=.1;for(let a=0;a<n.count;++a)n.is_static(a)||(s=Math.max(s,...n.size(a)));let{camera:r,
ground:o}=this.sessions[0].head;this.box=ih(["x","y","z"].map(t),s,o??!0);try{this.stage=sh(this.canvas,{hue:this.hue,box:this.box,camera:r,ground:o})}catch{this.
place.textContent="This browser has no WebGL, so there is no view; timeline, search and numbers work.";return}this.bodies=this.sessions.map((a,l)=>{let c=this.stage.
add_session(l===0?"solid":"ghost",l===0?this.hue.actual:this.hue.expected);return c.describe(a.bodies),c}),nh(this.canvas,this.stage,(a,l)=>{let c=this.stage.pick(
a,l);this.picked(c?this.sessions[c.session].bodies.id(c.row):null)}),this.set_side_by_side(this.side_by_side),this.resize()}describe(){this.sessions.forEach((e,t)=>this.
bodies?.[t].describe(e.bodies))}restart(){if(!this.stage)return;let e={...this.stage.view};this.stage.dispose(),this.open(),this.start(),this.stage&&Object.assign(
this.stage.view,e),this.show()}reset_view(){let{stage:e}=this;e&&(e.dispose(),this.open(),this.following=!1,this.start(),this.show())}set_side_by_side(e){this.side_by_side=
e,this.place.classList.toggle("halves",e),this.tags[1]&&(this.tags[1].textContent=e?"B":"B, ghost"),this.stage?.set_side_by_side(e),this.show()}place_of(e,t){let n=this.
frames[e],s=this.sessions[e]?.bodies.row(t);return!n||s===void 0||s>=n.rows||n.mark[s]===ms||n.mark[s]===eh?null:[n.x[s],n.y[s],n.z[s]]}apart(e){let[t,n]=[this.
place_of(0,e),this.place_of(1,e)];return t&&n?Math.hypot(t[0]-n[0],t[1]-n[1],t[2]-n[2]):null}only_in(e){let[t,n]=[this.frames[e],this.frames[1-e]];if(!t||!n||t.
status!==0||n.status!==0||t.step!==n.step)return new Set;let{bodies:s}=this.sessions[1-e],r=a=>{let l=s.row(a);return l!==void 0&&l<n.rows&&n.mark[l]!==ms},o=this.
sessions[e].bodies.json.id.filter((a,l)=>l<t.rows&&t.mark[l]!==ms&&!r(a));return new Set(o)}only_in_words(){return["A","B"].flatMap((e,t)=>{let n=this.only_in(t).
size;return n===0?[]:["".concat(n," bod").concat(n===1?"y":"ies"," only in ").concat(e)]})}colour_of(e,t){let{bodies:n}=e,s=this.only_in(this.sessions.indexOf(e));
return(r,o)=>{let a=n.id(r);if(a===this.selected)return o.set(this.hue.select);if(s.has(a))return o.set(this.hue.bad);if(this.paint==="speed")return r0(t.speed[r]/
this.top_speed,o);if(this.paint==="apart")return r0(Math.log10(Math.max(1e-9,this.apart(a)??0)/1e-9)/9,o);let l=t.mark[r]===Zg;return this.paint==="state"?o.set(
n.is_static(r)?this.hue.soft:l?this.hue.asleep:this.hue.actual):(o.set(s1[n.texture(r)]??this.hue.actual),l&&o.offsetHSL(0,-.12,-.05)),o.offsetHSL(0,0,.022*(r%5-
2))}}lost_in(e,t){let n=[];for(let s=0;s<t.rows&&n.length<oh;++s){if(t.mark[s]!==eh)continue;let r=e.bodies.id(s),o="".concat(this.sessions.indexOf(e)," ").concat(
r);this.lost_places.has(o)||(this.lost_places.set(o,null),e.way(r).then(l=>{let c=null;l.step.forEach((d,u)=>{let h=l.at.slice(3*u,3*u+3);!h.includes(null)&&(c===
null||d<=t.step)&&(c=h)}),this.lost_places.set(o,c),this.show()}).catch(()=>{}));let a=this.lost_places.get(o);a&&n.push({at:a,size:Math.max(.2,...e.bodies.size(
s))})}return n}show(){if(!this.stage)return;this.sessions.forEach((n,s)=>{let r=this.frames[s],o=r&&r.status===0?r:null,a=o?{colour:this.colour_of(n,o),lost:this.
lost_in(n,o)}:{};if(o&&s===1&&!this.side_by_side){let l=this.only_in(1);a.colour=(c,d)=>{let u=n.bodies.id(c);return(u===this.selected||l.has(u))&&d.set(u===this.
selected?this.hue.select:this.hue.bad)},a.hidden=c=>(this.apart(n.bodies.id(c))??1)<i0}this.bodies[s].show(o,a)});let e=[];if(this.sessions.length===2&&!this.side_by_side)
for(let n of this.sessions[0].bodies.json.id)(this.apart(n)??0)>=i0&&e.push(...this.place_of(0,n),...this.place_of(1,n));this.stage.set_lines("links",{points:e,
colour:this.hue.bad,on_top:!0}),this.show_contacts();let t=this.following&&this.selected!==null?this.place_of(0,this.selected)??this.place_of(1,this.selected):null;
t&&this.stage.look_at(t),this.stage.draw()}show_contacts(){this.sessions.forEach((e,t)=>this.show_contacts_of(t))}show_contacts_of(e){let t=this.contacts[e],s=t&&
this.frames[e]&&t.step===this.frames[e].step?t.rows??[]:[],r=([l,c])=>l===this.selected||c===this.selected,a=(this.selected!==null?s.filter(r):this.with_contacts?
s:[]).filter(l=>l[9]>0&&!l.includes(null));this.stage.set_arrows(a.map(l=>{let c=l[7]<0?-1:1;return{at:l.slice(2,5),normal:l.slice(5,8).map(d=>c*d),impulse:l[9]}}),
e)}ways_chosen(){if(this.selected!==null)return{ids:[this.selected],said:[]};let{bodies:e}=this.sessions[0],t=[...e.json.id.keys()].filter(a=>!e.is_static(a)),n=t.
filter(a=>e.name(a)==="thrown"),s=n.length>0?n:t,r=n.length>0?1:Math.max(1,Math.ceil(t.length/s0)),o=s.filter((a,l)=>l%r===0).slice(0,s0).map(a=>e.id(a));return{
ids:o,said:o.length<s.length?["ways of ".concat(o.length," of ").concat(s.length," bodies").concat(n.length>0?" thrown in":"")]:[]}}ways_words(){return this.with_ways?
this.ways_said:[]}async show_ways(){if(!this.stage)return;let{ids:e,said:t}=this.with_ways||this.selected!==null?this.ways_chosen():{ids:[],said:[]};this.ways_said=
t;let n=await Promise.all(this.sessions.map(async s=>{let r=[];for(let o of e){if(s.bodies.row(o)===void 0)continue;let a=await s.way(o);for(let l=1;l<a.step.length;++l){
let c=a.at.slice(3*l-3,3*l+3);c.includes(null)||r.push(...c)}}return r}));this.stage&&(this.stage.set_lines("ways A",{points:n[0],colour:this.hue.way,opacity:.9}),
this.stage.set_lines("ways B",n[1]?{points:n[1],colour:this.hue.expected,dash:this.box.radius/40,session:1}:null))}resize(){let{clientWidth:e,clientHeight:t}=this.
place;e>0&&this.stage?.resize(e,t)}};var Hs=(i,e="")=>X("span",{className:"chip ".concat(e),textContent:i});function r1(i){let{head:e,bodies:t,rows:n}=i,s=e.last-e.first,r=[Hs(e.engine??"method ".concat(
e.method)),Hs("".concat(s," step").concat(s===1?"":"s")),Hs("".concat(Number(i.time_of(e.last).toPrecision(4))," s")),Hs("".concat(t.count," bod").concat(t.count===
1?"y":"ies"))];return e.finished?(!e.sound||i.gaps().length>0)&&r.push(Hs("damaged","fail")):r.push(Hs(i.thin?"not finished: shown to its last chunk":"not finis\
hed: followed to its last chunk","warn")),e.cut_short&&r.push(Hs("cut short","warn")),n.lost.some(o=>o>0)&&r.push(Hs("bodies lost","fail")),r}function o1(i){let e=[],
t=i.sessions.length===2;i.sessions.forEach((s,r)=>{let o=t?"".concat("AB"[r],": "):"",{head:a,thin:l}=s;!a.sound&&a.finished&&e.push(["fail","".concat(o).concat(
a.summary)]),a.cut_short&&e.push(["warn","".concat(o,"The session may have gone on: ").concat(a.cut_short)]);for(let[f,p,x]of s.gaps())e.push(["fail","".concat(
o,"steps ").concat(f," to ").concat(p,": ").concat(x)]);if(s.note&&e.push(["fail","".concat(o).concat(s.note)]),s.unread&&s.unread!==s.note&&e.push(["fail","".concat(
o,"The timeline was not read: ").concat(s.unread)]),a.axes&&e.push(["","".concat(o,"the engine has other axes (").concat(a.axes,"); this page shows places in m,\
 z up").concat(t?", and names the first difference by the engine's axes":"")]),!l)return;let c=l.every>1,d=c?"is thinned: it has ".concat(l.steps.length," of ").
concat(a.last-a.first+1," states").concat(l.every<a.last-a.first?" (one in ".concat(l.every,", and those of inputs)"):""):s.gaps().length>0?"has every state tha\
t could be read":"has every state",u=s.rows.without_contacts()?"":", with the contacts of ".concat(l.contact_steps," state").concat(l.contact_steps===1?"":"s"),
h=l.rows_run>1?"; its timeline has the largest values of ".concat(l.rows_run," steps each"):"";e.push([c?"warn":"","".concat(o,"This page ").concat(d,", rounded\
 to 0.1 mm").concat(u).concat(h,". Served by tumble view it has every bit.")])});let n=i.sessions[0].rows.begun_why_not;return n&&e.push(["","Contacts begun are\
 counted no further: ".concat(n)]),e}function o0(i){let e=X("h1"),t=X("div",{className:"facts"}),n=X("div",{className:"notices"}),s=X("p",{className:"trouble",hidden:!0});
s.setAttribute("role","status");let r=a=>a.slice(a.lastIndexOf("/")+1),o=()=>{let{sessions:a}=i;e.replaceChildren(...a.flatMap(({head:l},c)=>{let d=X("span",{textContent:r(
l.path),title:l.path});return a.length===1?[d]:[X("span",{className:"side side-".concat("ab"[c]),textContent:"AB"[c]}),d," "]})),t.replaceChildren(...a.flatMap(
(l,c)=>[...c>0?[X("span",{className:"side side-b",textContent:"B"})]:[],...l.head.title&&c===0?[X("span",{className:"soft scene",textContent:l.head.title})]:[],
...r1(l)])),n.replaceChildren(...o1(i).map(([l,c])=>X("p",{className:l,textContent:c})))};return o(),{place:X("header",{},e,t,n,s),show:o,trouble(a){s.hidden=a===
null,s.textContent=a===null?"":"The server does not answer as it should (".concat(a.message,"). ")+"If tumble view was ended, start it again."}}}var a1=12,Ws=i=>String(typeof i=="number"?i:i??"\u2013"),gs=(i,e="")=>X("td",{textContent:i,className:e}),ur=(...i)=>X("tr",{},...i);function Pn(i,e,t="",n=null){
let s=X("button",{type:"button",className:"link",textContent:i,title:t});return n!==null&&s.setAttribute("aria-label",n),s.addEventListener("click",e),s}function Xs(i,{
open:e=!0,id:t=""}={}){let n=X("div",{className:"inside"});return{place:X("details",{open:e,className:"panel",id:t},X("summary",{},X("h2",{textContent:i})),n),body:n}}
function l1(i,e,t,n){let s=[],r=i.map(({field:o,value:a,channel:l,with:c})=>{let d=c===null?o:"".concat(o," with ").concat(t.label(c)),u=gs("","number");if(l!==
null&&n){let h=X("button",{type:"button",className:"link",textContent:"plot"}),f=()=>h.setAttribute("aria-pressed",String(n.has(l,e,c??0)));h.setAttribute("aria\
-label","plot ".concat(d," in the timeline")),h.addEventListener("click",()=>{n.flip(l,e,c??0);for(let p of s)p()}),s.push(f),f(),u.append(h)}return ur(X("th",{
scope:"row",textContent:d}),gs(a,"number"),u)});return X("div",{className:"scroll"},X("table",{className:"numbers"},X("caption",{textContent:"Channels"}),X("tbo\
dy",{},...r)))}function l0(i,{id:e,label:t,name:n,shape:s,answers:r,actions:o,bodies:a,plots:l=null,asked:c=null}){let d=r.length===2,u=r.find(m=>m.why_not),h=X(
"table",{className:"numbers",ariaLabel:"values of ".concat(t)});h.append(X("thead",{},ur(X("th",{scope:"col",textContent:"field",colSpan:d?2:1}),X("th",{scope:"\
col",textContent:"value",className:"number"}))));let f=r.find(m=>m.fields);for(let[m,{field:g}]of(f?.fields??[]).entries()){let y=r.map(C=>C.fields?.[m]),S=y.map(
C=>C?.hex??String(C?.value)),b=y.map((C,w)=>{let _=gs("","number");C&&c?_.append(Pn(Ws(C.value),()=>c(g),"".concat(C.hex??""," \u2013 where does it come from?"),
"".concat(g," ").concat(Ws(C.value),": where does it come from?"))):_.textContent=Ws(C?.value),C?.hex&&(_.title=C.hex);let M=w>0?[]:[X("th",{scope:d?"rowgroup":
"row",rowSpan:r.length,textContent:g})];d&&M.push(X("th",{scope:"row",textContent:"AB"[w]}));let R=ur(...M,_);return R.classList.toggle("differs",S.length===2&&
S[0]!==S[1]),R});h.append(X("tbody",{className:d?"pair":""},...b))}let p=[...t.includes(n)||s.startsWith(n)?[]:[n],s];if(f&&p.push(f.frozen?"asleep":"awake"),r.
filter(m=>m.fields).length===1&&d&&r.some(({absent:m})=>m)&&p.push("only in ".concat(f===r[0]?"A":"B")),i.replaceChildren(X("p",{},X("strong",{textContent:t.replace(
/^body /,"Body ")})," ".concat(p.join(" \xB7 "))),o),f&&i.append(X("div",{className:"scroll"},h)),f?.channels?.length>0){i.append(l1(f.channels,e,a,l));let m=f.
channels.filter(({with:g})=>g!==null).length;f.pairs>m&&i.append(X("p",{className:"soft",textContent:"".concat(m," of ").concat(f.pairs," values of pairs are li\
sted; tumble dump has all of them.")}))}u&&i.append(X("p",{className:"soft",textContent:"".concat(d?"".concat(r.indexOf(u)===0?"A":"B",": "):"").concat(u.why_not)})),
f?.rounded&&i.append(X("p",{className:"soft",textContent:"Rounded in this page; tumble dump prints every bit."}))}function c0(i,e,{selected:t,bodies:n,select:s,
go:r}){if(!e)return i.replaceChildren(X("p",{className:"soft",textContent:"\u2026"}));if(e.why_not){i.replaceChildren(X("p",{className:"soft",textContent:e.why_not})),
e.near!==null&&e.near!==void 0&&i.append(X("p",{},"The nearest with contacts: ",Pn("step ".concat(e.near),()=>r(e.near))));return}let o=e.rows.filter(([h,f])=>t===
null||h===t||f===t),a=[...o].sort((h,f)=>(f[9]??0)-(h[9]??0)).slice(0,a1),l="".concat(o.length," contact point").concat(o.length===1?"":"s").concat(t===null?"":
" of ".concat(n.label(t))),c=o.reduce((h,f)=>Math.max(h,f[8]??0),0);if(i.replaceChildren(X("p",{textContent:"".concat(l).concat(o.length>0?", deepest ".concat(An(
c)):"")})),a.length===0)return;let d=X("tbody",{},...a.map(h=>{let f=gs(""),p=x=>Pn(n.short(x),()=>s(x),"",n.label(x));return f.append(p(h[0])," \u2013 ",h[1]===
0?"ground":p(h[1])),ur(f,gs("".concat(Number((h[9]??0).toPrecision(3))," N s"),"number"),gs(An(h[8]),"number"))})),u=X("table",{className:"numbers",ariaLabel:"c\
ontacts, the strongest first"},X("thead",{},ur(X("th",{scope:"col",textContent:"bodies"}),X("th",{scope:"col",textContent:"impulse",className:"number"}),X("th",
{scope:"col",textContent:"depth",className:"number"}))),d);i.append(X("div",{className:"scroll"},u)),o.length>a.length&&i.append(X("p",{className:"soft",textContent:"\
The ".concat(a.length," strongest are listed.")}))}function h0(i,e,t,n,s,r){if(!e)return i.replaceChildren(X("p",{className:"soft",textContent:"Taking the steps\
 again \u2026"}));if(e.why_not)return i.replaceChildren(X("p",{className:"soft",textContent:e.why_not}));let o=X("p",{},Pn(t.label(e.body).replace(/^body /,"Bod\
y "),()=>s(e.body)),", ".concat(e.field," after step ").concat(e.step,": ").concat(Ws(e.value)," ").concat(e.unit)),a=X("ol",{className:"blame"},...e.answers.map(
l=>{let c=l.substep===null?l.phase:"".concat(l.phase,", substep ").concat(l.substep),d=X("li",{},Pn("step ".concat(l.step),()=>n(l.step))," \xB7 ",X("strong",{textContent:c}),
X("p",{textContent:l.text}));return l.shares.length>0&&d.append(X("ul",{className:"shares"},...l.shares.map(u=>{let h=X("li",{},"".concat(u.kind));return u.kind===
"contact"&&h.append(" with ",u.with===null?"the ground":Pn(t.label(u.with),()=>s(u.with))),h.append(": ".concat(Ws(u.amount)," ").concat(l.unit)),h}))),d}));i.replaceChildren(
o,a),e.ends&&i.append(X("p",{className:"soft",textContent:e.ends}));for(let l of e.notes??[])i.append(X("p",{className:"soft",textContent:l}));if(!e.complete){let l=X(
"button",{type:"button",textContent:"Further back"});l.addEventListener("click",()=>r(e.answers.length+5)),i.append(X("p",{},l))}}var a0=(i,e)=>"".concat(Ws(i)).
concat(e?" (".concat(e,")"):"");function c1(i,e){if(i.why_not)return X("p",{className:"soft",textContent:"Phases: ".concat(i.why_not)});let t=X("tbody",{},...i.
rows.map(s=>{let r=gs("","number");s.step===null?r.textContent="never":r.append(Pn(String(s.step),()=>e(s.step),"","step ".concat(s.step)));let o=ur(X("th",{scope:"\
row",textContent:s.phase}),r,gs(s.step===null?"":String(s.substep),"number"),gs(String(s.steps),"number"));return o.classList.toggle("differs",s.step===i.from),
o})),n=["phase","from step","substep","steps"];return X("div",{className:"scroll"},X("table",{className:"numbers phases"},X("caption",{textContent:"Phases in wh\
ich the two part, steps ".concat(i.from," to ").concat(i.last)}),X("thead",{},ur(...n.map((s,r)=>X("th",{scope:"col",textContent:s,className:r>0?"number":""})))),
t))}function Id(i){if(!i||i.state==="working")return"";if(i.state==="failed")return i.why;let{first:e}=i;if(!e){let[n,s]=i.last;return i.identical?"Identical: ".
concat(i.steps," steps, the same in ").concat(i.every_bit,"."):n===s?"Different: ".concat(i.unequal,"; the ").concat(i.steps," steps of both are the same in all\
 else that was compared."):"The ".concat(i.steps," steps of both are the same; A ends with step ").concat(n,", B with step ").concat(s,".")}let t=["step ".concat(
e.step),"phase ".concat(e.phase)];return e.substep!==null&&t.push("substep ".concat(e.substep)),"First difference: ".concat(t.join(", "))}function u0(i,e,t,n,s){
if(!e||e.state==="working"){let l=e?" (".concat(Math.floor(100*e.done)," %)"):"";return i.replaceChildren(X("p",{textContent:"Comparing every byte of both".concat(
l," \u2026")}))}let r=Id(e);if(e.state==="failed")return i.replaceChildren(X("p",{className:"bad",textContent:r}));let o=[],a=e.first;if(!a)o.push(X("p",{className:e.
identical?"good":"bad",textContent:r})),o.push(X("p",{textContent:"Compared: ".concat((e.compared??[]).join(", "),".")}),X("p",{className:"soft",textContent:"No\
t compared: ".concat((e.not_compared??[]).join("; "),".")}));else{o.push(X("p",{},X("strong",{textContent:r}))),e.cause&&o.push(X("p",{textContent:"Cause: ".concat(
e.cause)}));let l=e.effect??a,c=l.step!==a.step,d=X("p",{className:"effect"});(c||l.phase!==a.phase)&&d.append("Effect: ",Pn("step ".concat(l.step),()=>n(l.step)),
", phase ".concat(l.phase,", ")),l.body!==null&&d.append(Pn(t(l.body),()=>s(l.body)),", "),l.field==="body"?d.append("only in ".concat(l.actual===null?"A":"B")):
d.append("".concat(l.field,": ").concat(a0(l.expected,l.expected_hex)," \u2192 ").concat(a0(l.actual,l.actual_hex)));let u=l.ulps>Number.MAX_SAFE_INTEGER?"about\
 ".concat(l.ulps.toPrecision(3)):l.ulps;u!==null&&d.append(", ".concat(u," ").concat(u===1?"ULP":"ULPs"," apart")),o.push(d);let h=X("button",{type:"button",className:"\
jump",textContent:"Go to the first difference"});if(h.addEventListener("click",()=>n(a.step)),o.push(X("p",{},h)),c){let p=X("button",{type:"button",className:"\
jump",textContent:"Go to the first state that differs"});p.addEventListener("click",()=>n(l.step)),o.at(-1).append(" ",p)}let f=e.aftermath?.marks??[];f.length>
0?o.push(X("ul",{className:"marks"},...f.map(({above:p,step:x,body:m})=>X("li",{},"more than ".concat(An(p)," apart from "),Pn("step ".concat(x),()=>n(x)),", ",
Pn(t(m),()=>s(m)))))):e.growth_unknown&&o.push(X("p",{className:"soft",textContent:"Its growth is not known: ".concat(e.growth_unknown)})),e.partings&&o.push(c1(
e.partings,n))}for(let l of e.notes??[])o.push(X("p",{className:"soft",textContent:l}));return i.replaceChildren(...o)}var h1=[["Space","play, or stop"],["J  K  L","play backwards, stop, play"],["\u2190 \u2192","one step back, on; with Shift ten"],["Home End","first, last step"],
["[  ]","the input, difference, gap or break of a bound before, after"],["d  D","the first difference, the first state that differs"],["/","search"],["n  N","ne\
xt run of steps found, the one before"],["c  w  s  f  r","contacts, ways, side by side, follow, whole scene"],["Esc","let the body go"],["arrows, + \u2212","in \
the view: turn, with Shift move; zoom. Drag turns, with Shift moves; the wheel zooms once the view has the focus"]];function d0(i,e){let{inputs:t,gaps:n,first_difference:s,
first_effect:r}=i.marks(),o=[...i.sessions[0].rows.breaks(),...t.map(({step:c})=>c),...n.flatMap(([c,d])=>[c,d])];o.push(...[s,r].filter(c=>c!==null));let{step:a}=i.
player,l=o.filter(c=>e>0?c>a:c<a).sort((c,d)=>e*(c-d));l.length>0&&i.player.seek(l[0])}function f0(i){let e={" ":()=>i.player.play(i.player.direction||1),j:()=>i.
player.play(-1),k:()=>i.player.stop(),l:()=>i.player.play(1),ArrowLeft:s=>i.player.move(s?-10:-1),ArrowRight:s=>i.player.move(s?10:1),Home:()=>i.player.seek(i.steps.
first),End:()=>i.player.seek(i.steps.last),"[":()=>d0(i,-1),"]":()=>d0(i,1),d:()=>i.go_to_first_difference(),D:()=>i.go_to_first_effect(),"/":()=>i.search.focus(),
n:()=>i.next_hit(1),N:()=>i.next_hit(-1),Escape:()=>i.select(null),...i.toolbar.flip};document.addEventListener("keydown",s=>{if(s.ctrlKey||s.metaKey||s.altKey||
s.target.closest("input:not([type=range]), select, textarea")||s.target.closest("button, summary, a")!==null&&(s.key===" "||s.key==="Enter"))return;let o=e[s.key]??
(s.shiftKey?null:e[s.key.toLowerCase()]);o&&(s.preventDefault(),o(s.shiftKey))});let{place:t,body:n}=Xs("Keys",{open:!1});return n.append(X("dl",{className:"key\
s"},...h1.flatMap(([s,r])=>[X("dt",{},X("kbd",{textContent:s})),X("dd",{textContent:r})]))),{place:t}}var Ld=i=>i==null?"\u2013":String(i),p0=i=>i==null?"\u2013":"".concat(Number(i.toPrecision(4))," m/s"),Nd=(i,e,t=6)=>i===null?"\u2013":Number.isFinite(i)?"".concat(
Number(i.toPrecision(t))).concat(e?" ".concat(e):""):"".concat(i<0?"\u2212":"","infinite"),u1=(i,e)=>i.read[e]?"".concat(i.sleeping[e]," of ").concat(i.bodies[e]):
"\u2013",d1=[{name:"sleeping",kind:"area",of:(i,e)=>i.read[e]?i.sleeping[e]:null,words:u1,top:i=>Vn([1,...p1(i.bodies)])},{name:"contacts",kind:"line",of:(i,e)=>i.
contacts_told(e),words:(i,e)=>Ld(i.contacts_told(e)),late:!0},{name:"contacts begun",kind:"bars",of:(i,e)=>i.begun[e]??null,words:(i,e)=>Ld(i.begun[e]),late:!0},
{name:"energy",kind:"line",of:(i,e)=>i.energy(e),words:(i,e)=>Lo(i.energy(e)),fit:!0},{name:"kinetic energy",kind:"area",of:(i,e)=>i.kinetic[e],words:(i,e)=>Lo(
i.kinetic[e])},{name:"highest speed",kind:"line",of:(i,e)=>i.speed[e],words:(i,e)=>i.speed[e]>0?"".concat(p0(i.speed[e]),", ").concat(i.label(i.speed_body[e])):
p0(i.speed[e])},{name:"deepest overlap",kind:"line",of:(i,e)=>i.overlap[e],words:(i,e)=>An(i.overlap[e])},{name:"bodies lost",kind:"bars",of:(i,e)=>i.lost[e]||null,
words:(i,e)=>Ld(i.lost[e]),bad:!0,only_if_any:!0}],f1={name:"collisions resolved",title:"collisions resolved in all substeps of a step"},m0=i=>d1.map(e=>e.name===
"contacts"&&i.counts_collisions?{...e,...f1}:e);function p1(i){let e=Math.ceil(i.length/5e3)||1;return i.filter((t,n)=>n%e===0&&t!==null)}var g0=i=>i.map((e,t)=>({
name:e,kind:"line",title:"up to each step, ".concat(e),broken:(n,s)=>n.bounds[t]?.broken[s]===1,of:(n,s)=>n.bounds[t]?.value[s]??null,words:(n,s)=>{let r=n.bounds[t]?.
broken[s]??null;if(r===null)return"not judged";let o=n.bounds[t].value[s];return"".concat(o===null?"no value":Nd(o,"",4),", ").concat(r?"\u2715 broken":"\u2713 holds")}})),
_0=i=>i.channel_heads.map(({name:e,unit:t,of:n})=>{let s=(a,l)=>a.channels[e]?.[l]??null,r=(a,l)=>Nd(s(a,l),t),o=n==="step"?"":", largest of ".concat(n);return{
name:"".concat(e).concat(o),kind:"line",fit:!0,parts:!0,title:"channel ".concat(e).concat(o),of:s,words:r}});function x0(i,e,t){let n=new Map,s=(o,a)=>{for(;n.size<
t.step.length;)n.set(t.step[n.size],t.value[n.size]);return n.get(o.step[a])??null},r=(o,a)=>Nd(s(o,a),e);return{name:i,kind:"line",fit:!0,parts:!0,title:"chann\
el ".concat(i),of:s,words:r}}function y0(i){let e=new Map(i.step.map((t,n)=>[t,n]));return{name:"separation",kind:"line",log:!0,of:(t,n)=>e.has(t.step[n])?i.metres[e.
get(t.step[n])]:null,words:(t,n)=>{let s=e.get(t.step[n]);return s===void 0?"none":i.metres[s]===null?"infinite":An(i.metres[s])}}}var v0=8,ah=class{constructor(e){this.page=e,this.chosen=new Map}key(e,t,n){return"".concat(e," ").concat(Math.min(t,n||t)," ").concat(n?Math.max(t,n):0)}has(e,t,n){
return this.chosen.has(this.key(e,t,n))}lanes(){return[...this.chosen.values()].map(({lane:e})=>e)}flip(e,t,n){let s=this.key(e,t,n);if(!this.chosen.delete(s)){
let[{rows:r,bodies:o}]=this.page.sessions,{name:a,unit:l}=r.channel_heads[e],c=n?"".concat(o.label(t)," and ").concat(o.label(n)):o.label(t),d={step:[],value:[]};
if(this.chosen.set(s,{channel:e,a:t,b:n,history:d,lane:x0("".concat(a," of ").concat(c),l,d)}),this.chosen.size>v0){let[[u,{lane:h}]]=this.chosen;this.chosen.delete(
u),this.page.tell("".concat(v0," channels are plotted at most; gone is ").concat(h.title))}this.read(s)}this.page.set_lanes()}async read(e){let{channel:t,a:n,b:s,
history:r}=this.chosen.get(e),o=a=>(Object.assign(r,{step:a.step,value:a.value}),this.page.timeline.draw(),this.chosen.has(e));try{o(await this.page.sessions[0].
channel_history(t,n,s,o))}catch(a){this.page.header.trouble(a)}}again(){for(let e of this.chosen.keys())this.read(e)}};var lh=class{constructor(e){this.page=e,this.sessions=e.sessions,this.body_panel=Xs("Body"),this.blame_panel=Xs("Where it comes from"),this.blame_panel.place.hidden=
!0,this.contact_panel=Xs("Contacts"),this.input_panel=Xs("Inputs",{open:!1}),this.difference_panel=Xs("Comparison"),this.places=[...this.sessions.length===2?[this.
difference_panel.place]:[],this.body_panel.place,this.blame_panel.place,this.contact_panel.place,this.input_panel.place]}settled(e){return this.next_contacts=e,
this.asking_contacts??=this.ask_contacts().finally(()=>{this.asking_contacts=null}),Promise.all([this.asking_contacts,this.show_body(e)])}async ask_contacts(){for(;this.
next_contacts!==null;){let e=this.next_contacts;this.next_contacts=null,await this.show_contacts(e)}}async show_contacts(e){let t=await Promise.all(this.sessions.
map(async n=>e<n.head.first||e>n.head.last?{step:e,why_not:"the log has no such step"}:n.contacts_at(n.steps?this.page.own_step(n,e):e)));this.page.player.step===
e&&(this.page.drawing.contacts=t,this.page.drawing.show(),this.draw_contacts())}draw_contacts(){let{contacts:e}=this.page.drawing,t=this.sessions.length===2;this.
contact_panel.body.replaceChildren(...this.sessions.flatMap(({bodies:n},s)=>{let r=X("div",{className:"contacts"});return c0(r,e[s],{selected:this.page.selected,
bodies:n,select:o=>this.page.select(o),go:o=>this.page.player.seek(o)}),t?[X("h3",{},X("span",{className:"side side-".concat("ab"[s]),textContent:"AB"[s]})),r]:
[r]}))}show_selection(){this.page.selected===null&&this.body_panel.body.replaceChildren(X("p",{className:"soft",textContent:"Press a body in the view, or search\
 for its id or name."}))}async show_body(e){let t=this.page.selected;if(t===null)return;let n=await Promise.all(this.sessions.map(a=>a.body_at(a.steps?this.page.
own_step(a,e):e,t)));if(this.page.selected!==t||this.page.player.step!==e)return;let s=this.sessions.find(a=>a.bodies.row(t)!==void 0)??this.sessions[0],r=s.bodies.
row(t),o=X("p",{className:"actions"},...[["Follow",()=>{this.page.drawing.following=!this.page.drawing.following,this.page.toolbar.show(),this.page.drawing.show()}],
["Look at",()=>{let a=this.page.drawing.place_of(0,t)??this.page.drawing.place_of(1,t);a&&this.page.drawing.stage?.look_at(a)}],["Let go",()=>this.page.select(null)]].
map(([a,l])=>{let c=X("button",{type:"button",textContent:a});return c.addEventListener("click",l),c}));l0(this.body_panel.body,{id:t,label:s.bodies.label(t),name:r===
void 0?"":s.bodies.name(r),shape:r===void 0?"size unknown":s.bodies.shape_words(r),answers:n,actions:o,bodies:s.bodies,plots:s===this.sessions[0]?this.page.plots:
null,asked:this.sessions[0].head.blames&&this.sessions[0].blame?a=>this.show_blame(e,t,a):null})}async show_blame(e,t,n,s=5){this.blame_panel.place.hidden=!1,this.
blame_panel.place.open=!0;let r=this.blamed={},o=a=>h0(this.blame_panel.body,a,this.sessions[0].bodies,l=>this.page.player.seek(l),l=>this.page.select(l),l=>this.
show_blame(e,t,n,l));o(null);try{let a=await this.sessions[0].blame(e,t,n,s);if(this.blamed!==r)return;o(a);let[l]=a.answers??[];this.page.tell(a.why_not??"".concat(
a.field," ").concat(Ws(a.value)," comes from step ").concat(l.step,", ").concat(l.phase,": ").concat(l.text))}catch(a){this.blamed===r&&o({why_not:a.message})}}show_difference(){
u0(this.difference_panel.body,this.page.difference,e=>this.label(e),e=>this.page.player.seek(e),e=>this.page.select(e)),this.page.tell(Id(this.page.difference))}label(e){
return(this.sessions.find(({bodies:t})=>t.row(e)!==void 0)??this.sessions[0]).bodies.label(e)}show_inputs(){let{events:e}=this.sessions[0].rows;if(this.inputs_shown===
e.length)return;this.inputs_shown=e.length;let t=e.slice(0,200);this.input_panel.body.replaceChildren(e.length===0?X("p",{className:"soft",textContent:"None."}):
X("ol",{className:"inputs"},...t.map(({step:n,kind:s,body:r,text:o})=>{let a=X("button",{type:"button",className:"link",textContent:"step ".concat(n)});return a.
addEventListener("click",()=>this.page.player.seek(n)),X("li",{},a," ".concat(s).concat(r===null?"":" ".concat(this.sessions[0].bodies.short(r))," ").concat(o))}))),
e.length>t.length&&this.input_panel.body.append(X("p",{className:"soft",textContent:"and ".concat(e.length-t.length," more")}))}};var ch=Ui({speed:{of:(i,e)=>i.speed[e],unit:"m/s",body:(i,e)=>i.speed_body[e]},overlap:{of:(i,e)=>i.overlap[e],unit:"m"},height:{of:(i,e)=>i.height[e],unit:"m"},
kinetic:{of:(i,e)=>i.kinetic[e],unit:"J"},potential:{of:(i,e)=>i.potential[e],unit:"J"},energy:{of:(i,e)=>i.energy(e),unit:"J"},contacts:{of:(i,e)=>i.contacts_told(
e),unit:""},begun:{of:(i,e)=>i.begun[e]??null,unit:""},sleeping:{of:(i,e)=>i.sleeping[e],unit:""},bodies:{of:(i,e)=>i.bodies[e],unit:""},lost:{of:(i,e)=>i.lost[e],
unit:""},broken:{of:(i,e)=>i.bounds.length>0?i.broken(e):null,unit:""},separation:{of:(i,e,t)=>t?.(i.step[e])??null,unit:"m"}}),hh=Ui({speed:{of:(i,e)=>i.speed[e],
unit:"m/s"},spin:{of:(i,e)=>i.spin?.[e]??null,unit:"rad/s"},height:{of:(i,e)=>i.z[e],unit:"m"},x:{of:(i,e)=>i.x[e],unit:"m"},y:{of:(i,e)=>i.y[e],unit:"m"},z:{of:(i,e)=>i.
z[e],unit:"m"},asleep:{of:(i,e)=>i.asleep[e],unit:""},separation:{of:(i,e,t)=>m1(i,e,t),unit:"m"}});function m1(i,e,t){if(!t)return null;t.rows??=new Map(t.step.
map((r,o)=>[r,o]));let n=t.rows.get(i.step[e]),s=n===void 0?[null]:["x","y","z"].map(r=>i[r][e]===null||t[r][n]===null?null:i[r][e]-t[r][n]);return s.includes(null)?
null:Math.hypot(...s)}var g1=Ui({"<":(i,e)=>i<e,"<=":(i,e)=>i<=e,">":(i,e)=>i>e,">=":(i,e)=>i>=e,"=":(i,e)=>i===e}),_1=Ui({"\u2265":">=","\u2264":"<=","==":"="});
function x1(i,e,t){let n=/^([-+]?(?:\d+\.?\d*|\.\d+)(?:e[-+]?\d+)?)\s*(.*)$/i.exec(i),s=Number(n?.[1]);return Number.isFinite(s)?n[2]===""||n[2]===t?{bound:s}:{
kind:"wrong",words:'"'.concat(n[2],'" is not the unit of ').concat(e,", which ").concat(t?"is in ".concat(t):"has none")}:{kind:"wrong",words:'"'.concat(i,'" is\
 no number')}}function b0(i,e){let t=/^channel\.(.+)$/i.exec(i)?.[1];return t!==void 0&&!(i in e)&&t in e?t:null}function M0(i,e){let t=i.split(/(\s+and\s+)/i),
n=[];for(let s=1;s<t.length;s+=2)n.push([t.slice(0,s).join(""),t.slice(s+1).join("")]);return n.find(s=>s.every(e))??n[0]??[i]}function S0(i,e=[]){let t=Ui(Object.
fromEntries(e.map(({name:f,unit:p})=>[f,p]))),n=i.trim();if(n==="")return{kind:"none"};let s=/^step\s+([-+]?\d+)$/i.exec(n);if(s)return{kind:"step",step:Number(
s[1])};let r=/^(.+?)\s*(<=|>=|==|[<>=≥≤])\s*(.*)$/.exec(n);if(!r)return{kind:"body",text:n};let o=r[1].trim(),a=o.toLowerCase(),l=_1[r[2]]??r[2],c=(f,p,x,m={})=>{
let{bound:g,...y}=x1(r[3],p,x);return g===void 0?y:{kind:f,quantity:p,unit:x,comparison:l,bound:g,...m}},d=(f,p,x)=>({kind:"wrong",words:'"'.concat(f,'" is no q\
uantity').concat(p,"; there are ").concat(x.flatMap(Object.keys).join(", "))}),u=b0(o,t);if(u!==null)return c("steps",u,t[u],{channel:u});let h=o in t?null:/^(.+?)\s+of\s+(.+)$/i.
exec(o);if(h){let f=h[1].toLowerCase(),p=b0(h[1],t);return p!==null?c("channel steps",p,t[p],{body:h[2]}):f in hh?c("body steps",f,hh[f].unit,{body:h[2]}):h[1]in
t?c("channel steps",h[1],t[h[1]],{body:h[2]}):d(h[1]," of a body",[hh,t])}return a in ch?c("steps",a,ch[a].unit):o in t?c("steps",o,t[o]):d(o,"",[ch,t])}function w0(i,e,t){
let{of:n,body:s}=(i.channel===void 0?ch[i.quantity]:void 0)??{of:(r,o)=>e.channels[i.quantity]?.[o]??null};return Ud(i,e.step,r=>n(e,r,t),r=>s?.(e,r)??null)}function T0(i,e,t){
let{of:n}=hh[i.quantity];return Ud(i,e.step,s=>n(e,s,t),()=>null)}function Dd(i,e){return Ud(i,e.step,t=>e.value[t],()=>null)}function Ud(i,e,t,n){let s=g1[i.comparison],
r=[],o=0,a=null;for(let l=0;l<e.length;++l){let c=t(l),d=c!=null;if(d&&++o,!(d&&s(c,i.bound))){a=null;continue}a||(a={first:e[l],last:e[l],peak:c,at:e[l],body:n(
l)},r.push(a)),a.last=e[l],Math.abs(c-i.bound)>Math.abs(a.peak-i.bound)&&Object.assign(a,{peak:c,at:e[l],body:n(l)})}return{runs:r,judged:o}}var po=12,y1={">":": up to ",">=":": up to ","<":": down to ","<=":": down to ","=":": "};function v1(i,e){return Number.isFinite(i)?e==="m"?An(i):"".concat(Number(
i.toPrecision(4))).concat(e?" ".concat(e):""):i<0?"\u2212infinite":"infinite"}function b1({thin:i}){return i&&i.rows_run>1?"; of each ".concat(i.rows_run," step\
s only the largest value was searched"):""}function M1({head:i,thin:e},t){if(!e)return"";let n=e.every>1?"; ".concat(e.steps.length," of ").concat(i.last-i.first+
1," states were searched"):"";return t===""?n:n+(t==="m"?"; places are rounded to ".concat(An(e.quantum)):"; speeds are made of places rounded to ".concat(An(e.
quantum)))}function S1({head:i},e){return e==="contacts"&&i.counts_collisions?"; contacts are the collisions resolved in all substeps":""}function Fd(i,e){if(i<
e.first||i>e.last)return{step:null,words:"no step ".concat(i,": the session has steps ").concat(e.first," to ").concat(e.last)};let t=e.at_or_before(i);return{step:t,
words:"Enter goes to step ".concat(t).concat(t===i?"":", the last before step ".concat(i," that this page has"))}}function A0(i){let e=X("input",{type:"search",
placeholder:"speed > 5, wall 0, step 120",autocomplete:"off",spellcheck:!1});e.setAttribute("aria-label","search for steps by a condition, or for a body by id o\
r name");let t=X("output",{ariaLabel:"what the search found"}),n=X("ul",{className:"hits"}),s={kind:"none"},r=[],o=()=>{let{bodies:p}=i.sessions[0],x=p.find(s.text);
return t.value=x.length===0?"no such body":"".concat(x.length," bod").concat(x.length===1?"y":"ies"),n.replaceChildren(...x.slice(0,po).map(m=>X("li",{},Pn(p.label(
p.id(m)),()=>i.select(p.id(m))),p.label(p.id(m)).includes(p.name(m))?"":" ".concat(p.name(m))))),x.length>po&&n.append(X("li",{className:"soft",textContent:"and\
 ".concat(x.length-po," more")})),i.set_hits([]),x},a=()=>{let{rows:p,timeline_done:x,unread:m}=i.sessions[0];return m?(t.value="the timeline was not read: ".concat(
m),r=[],n.replaceChildren(),i.set_hits([]),[]):u(w0(s,p,g=>i.separation_at(g)),s.unit,x,S1(i.sessions[0],s.quantity)+b1(i.sessions[0]))},l=p=>i.sessions.slice(0,
p?2:1).every(({head:x})=>x.finished||!i.served),c=async p=>{let x=s,m=i.sessions.map(({bodies:_})=>_.find(x.body).map(M=>_.id(M))),g=[...new Set(m.flat())];if(g.
length!==1)return t.value=g.length===0?'no body "'.concat(x.body,'"'):"".concat(g.length,' bodies answer to "').concat(x.body,'"; wanted one'),n.replaceChildren(),
i.set_hits([]),[];let{unit:y}=x,S=x.quantity==="separation"&&i.sessions.length===2,b=[null,null],C=[],w=_=>s!==x?!1:(b[0]&&(!S||b[1])&&(C=u(T0(x,...b),y,_,M1(i.
sessions[0],y))),!0);try{for(let _ of S?[1,0]:[0]){let M=_===0;if(b[_]=await i.sessions[_].history(g[0],R=>(b[_]=R,w(!1)&&s===x)),!w(M&&l(S)))return[]}p&&i.selected!==
g[0]&&i.select(g[0])}catch(_){s===x&&(t.value=_.message)}return C},d=async()=>{let p=s,[x]=i.sessions,m=x.rows.channel_heads.findIndex(({name:M})=>M===p.quantity),
{of:g,unit:y}=x.rows.channel_heads[m],S=M=>{t.value=M,n.replaceChildren(),i.set_hits([])},b=g==="pairs"?M0(p.body,M=>x.bodies.find(M).length===1):[p.body];if(g===
"step")return S('"'.concat(p.quantity,'" is a channel of the step, not of a body'));if(g==="pairs"&&b.length!==2)return S('"'.concat(p.quantity,'" is a channel \
of pairs: ').concat(p.quantity," of 1 and 2 > 0"));if(!x.channel_history)return S("this page has no channels of single bodies; a served page (tumble view withou\
t -o) has");let C=b.map(M=>x.bodies.find(M));for(let[M,R]of C.entries())if(R.length!==1)return S(R.length===0?'no body "'.concat(b[M],'"'):"".concat(R.length,' \
bodies answer to "').concat(b[M],'"; wanted one'));let[w,_]=C.map(([M])=>x.bodies.id(M));try{let M=await x.channel_history(m,w,_??0,R=>(s===p&&u(Dd(p,R),y,!1),s===
p));s===p&&u(Dd(p,M),y,l(!1))}catch(M){s===p&&S(M.message)}},u=({runs:p,judged:x},m,g,y="")=>{let S=g?"":" so far",b=i.sessions[0].rows.unread_count(),C=x===0?"\
no step has a value of it".concat(S):"in no step".concat(S);return t.value=(p.length===0?C:"".concat(p.length," run").concat(p.length===1?"":"s"," of steps").concat(
S,", the first at ").concat(p[0].first))+(b===0?"":b===1?"; 1 step was not read":"; ".concat(b," steps were not read"))+y,r=p.slice(0,po).map(w=>{let _=w.first===
w.last?"step ".concat(w.first):"steps ".concat(w.first," to ").concat(w.last),M=X("li",{},Pn(_,()=>i.player.seek(w.first)),y1[s.comparison],Pn("".concat(v1(w.peak,
m)),()=>i.player.seek(w.at),"at step ".concat(w.at)));return w.body&&M.append(", ",Pn(i.sessions[0].bodies.label(w.body),()=>i.select(w.body))),M}),n.replaceChildren(
...r),p.length>po&&n.append(X("li",{className:"soft",textContent:"and ".concat(p.length-po," more")})),i.set_hits(p),p},h=()=>(r=[],s=S0(e.value,i.sessions[0].rows.
channel_heads),s.kind==="body"?o():s.kind==="steps"?a():s.kind==="body steps"||s.kind==="channel steps"?(t.value="\u2026",s.kind==="body steps"?c(!0):d(),[]):(t.
value=s.kind==="wrong"?s.words:s.kind==="step"?Fd(s.step,i.steps).words:"",n.replaceChildren(),i.set_hits([]),[]));e.addEventListener("input",h),e.addEventListener(
"keydown",p=>{if(p.key==="Escape"&&e.blur(),p.key==="Enter"){if(p.preventDefault(),s.kind==="step"){let{step:x}=Fd(s.step,i.steps);x!==null&&i.player.seek(x)}if(s.
kind==="steps"||s.kind==="body steps"||s.kind==="channel steps")i.next_hit(p.shiftKey?-1:1);else if(s.kind==="body"){let[x]=h();x!==void 0&&i.select(i.sessions[0].
bodies.id(x))}}});let f=(p,x,m)=>{let g=X("button",{type:"button",textContent:p,title:x});return g.setAttribute("aria-label",x),g.addEventListener("click",()=>i.
next_hit(m)),g};return{place:X("div",{className:"search"},X("div",{className:"search-row"},e,f("\u2039","the run of steps before (N)",-1),f("\u203A","the next r\
un of steps (n)",1)),t,n),focus:()=>e.focus(),at(p){r.forEach((x,m)=>x.classList.toggle("at",m===p))},again(){if(s.kind==="steps"){let p=i.hit;a(),i.hit=p}else s.
kind==="step"?t.value=Fd(s.step,i.steps).words:s.kind==="body steps"?c(!1):s.kind==="channel steps"&&d()}}}var w1=["box","grid","tower","pyramid","wall","pile","thrown"];var T1=["crate","brick","wood","concrete","white"],mo=class{constructor(e){this.update(e)}update(e){this.json=e,this.count=e.id.length,this.rows=new Map(e.id.map(
(t,n)=>[t,n]))}get version(){return this.json.version}id(e){return this.json.id[e]}row(e){return this.rows.get(e)}size(e){return this.json.size.slice(3*e,3*e+3)}is_static(e){
return this.json.static[e]===1}texture(e){return T1[this.json.texture[e]]??""}shape_words(e){let t=this.size(e),n=t[0]>0?"".concat(t.map(r=>Number(r.toPrecision(
4))).join(" \xD7 ")," m"):"size unknown",s=this.json.shapes?.[this.json.shape?.[e]??-1];return s?s.points.length>0?"".concat(s.words,", ").concat(n):s.words:n}body(e){
let t=this.json.shape?.[e]??-1,n=t<0?{kind:"box"}:this.json.shapes[t];return{...n,shape:n.kind,index:t,size:this.size(e)}}name(e){let t=this.json.name?.[e];if(t)
return t;let[n,s,r,o]=this.json.origin.slice(4*e,4*e+4),a=this.json.shapes?.[this.json.shape?.[e]??-1],l=n===0&&a?a.kind:w1[n]??"body";return n===0||n===6?l:"".
concat(l," ").concat(s,", row ").concat(r,", column ").concat(o)}label(e){let t=this.rows.get(e),n=t===void 0?"":this.json.name?.[t]??"";return n===""?"body ".concat(
e):e>=4503599627370496?n:"body ".concat(e," (").concat(n,")")}short(e){let t=this.rows.get(e),n=t===void 0?"":this.json.name?.[t]??"";return n!==""&&e>=4503599627370496?
n:String(e)}find(e){let t=e.trim().toLowerCase().replace(/^(body|#)\s*/,"");if(/^\d+$/.test(t)){let r=this.row(Number(t));return r===void 0?[]:[r]}let n=[...this.
rows.values()].filter(r=>this.json.name?.[r]?.toLowerCase()===t);if(n.length>0)return n;let s=[];for(let r=0;r<this.count;++r)this.name(r).toLowerCase().includes(
t)&&s.push(r);return s}};var E0=["step","time","read","kinetic","potential","inputs","contacts","bodies","sleeping","lost","speed","speed_body","height","overlap"];function _s(i,e){for(let t of e)
i.push(typeof t=="string"?Number(t):t)}var go=class{constructor(e=[],t=!1){this.channel_heads=e;for(let n of E0)this[n]=[];this.begun=[],this.of_another=t,this.
may_lack_contacts=t,this.contacts_seen=0,this.label=n=>"body ".concat(n),this.events=[],this.begun_why_not="",this.channels=Ui(),this.bounds=[]}get count(){return this.
step.length}append(e){for(let t of E0)_s(this[t],e[t]);e.bounds.forEach(({value:t,broken:n},s)=>{let r=this.bounds[s]??={value:new Array(this.count-t.length).fill(
null),broken:new Array(this.count-t.length).fill(null)};_s(r.value,t),_s(r.broken,n)}),e.channels.forEach((t,n)=>{let{name:s}=this.channel_heads[n],r=this.channels[s]??=
[];for(;r.length<this.count-t.length;)r.push(null);_s(r,t)})}index(e){let{count:t}=this;if(t===0||e<this.step[0])return-1;let n=t>1?this.step[1]-this.step[0]:1,
s=Math.min(t-1,Math.max(0,Math.floor((e-this.step[0])/n)));for(;s>0&&this.step[s]>e;)--s;for(;s+1<t&&this.step[s+1]<=e;)++s;return s}reaches(e){let t=this.count>
1?this.step[1]-this.step[0]:1;return this.count>0&&e<this.step[this.count-1]+t}unread(){let e=[];for(let t=0;t<this.count;++t){if(this.read[t]!==0)continue;let n=e.
at(-1),s=t+1<this.count?this.step[t+1]-1:this.step[t];n&&t>0&&this.read[t-1]===0?n[1]=s:e.push([this.step[t],s,"the record with it is damaged"])}return e}unread_count(){
return this.unread().reduce((e,[t,n])=>e+n-t+1,0)}broken(e){return this.bounds.reduce((t,{broken:n})=>t+(n[e]??0),0)}breaks(){return this.bounds.map(({broken:e})=>e.
indexOf(1)).filter(e=>e>=0).map(e=>this.step[e])}without_contacts(){for(;this.may_lack_contacts&&this.contacts_seen<this.count;)this.contacts[this.contacts_seen++]>
0&&(this.may_lack_contacts=!1);return this.may_lack_contacts}contacts_told(e){return this.without_contacts()?null:this.contacts[e]}why_no_contacts(e){let t="the\
 log of another engine holds no contacts";return this.without_contacts()?t:this.of_another&&this.contacts[Math.max(0,this.index(e))]===0?"".concat(t," of step ").
concat(e):"this page has no contacts of this state; a served page (tumble view without -o) has all"}energy(e){return this.kinetic[e]===null||this.potential[e]===
null?null:this.kinetic[e]+this.potential[e]}};var A1=i=>{let e=document.getElementById(i).textContent;return Uint8Array.from(atob(e),t=>t.charCodeAt(0))};async function P0(i){if(!("DecompressionStream"in window))
throw new Error("this browser is too old to unpack the page (no DecompressionStream)");let e=new Blob([A1(i)]).stream().pipeThrough(new DecompressionStream("def\
late"));return new Response(e).arrayBuffer()}var C0=async i=>JSON.parse(new TextDecoder().decode(await P0(i))),R0=i=>i>>>1^-(i&1);function E1(i,e,t,n){let s=e*t,
r={place:[],turn:new Int16Array(4*s),mark:new Uint8Array(s)},o=0;for(let a=0;a<3;++a){let l=new Float32Array(s);for(let c=0,d=0;c<t;++c){let u=0,h=0;for(let f=0;f<
e;++f,++d){let p=o+d,x=i[p]|i[p+s]<<8|i[p+2*s]<<16|i[p+3*s]<<24,m=R0(x)+2*u-h|0;h=u,u=m,l[f*t+c]=m*n}}r.place.push(l),o+=4*s}for(let a=0;a<4;++a){for(let l=0,c=0;l<
t;++l){let d=0,u=0;for(let h=0;h<e;++h,++c){let f=i[o+c]|i[o+s+c]<<8,p=R0(f)+2*d-u<<16>>16;u=d,d=p,r.turn[(4*h+a)*t+l]=p}}o+=2*s}for(let a=0,l=0;a<t;++a)for(let c=0;c<
e;++c,++l)r.mark[c*t+a]=i[o+l];return r}var Od=class{constructor(e,t,n){this.head=e,this.thin=e.thin,this.bodies=new mo(t.bodies),this.rows=new go(e.channels,!e.
ours),this.rows.append(t.timeline),this.rows.events=t.inputs,this.rows.begun=t.timeline.begun.length>0?[0,...t.timeline.begun]:[],this.rows.begun_why_not=t.timeline.
begun_why_not,this.contacts=t.contacts,this.steps=e.thin.steps,this.columns=E1(new Uint8Array(n),this.steps.length,this.bodies.count,e.thin.quantum),this.index=
new Map(this.steps.map((s,r)=>[s,r])),this.timeline_done=!0}gaps(){let e=this.head.gaps;return[...e,...this.rows.unread().filter(([t])=>!e.some(([n,s])=>t>=n&&t<=
s))]}gap_at(e){return this.gaps().find(([t,n])=>e>=t&&e<=n)??null}frame(e){let t=this.index.get(e);if(t===void 0)return null;let n=this.bodies.count,s=l=>l.subarray(
t*n,(t+1)*n),[r,o,a]=this.columns.place.map(s);return{step:e,status:0,rows:n,x:r,y:o,z:a,turn:this.columns.turn.subarray(4*t*n,4*(t+1)*n),mark:s(this.columns.mark),
speed:this.speeds(t,r,o,a)}}speeds(e,...t){let n=this.bodies.count,s=new Float32Array(n),[r,o]=e>0?[e-1,e]:[e,e+1];if(o>=this.steps.length)return s;let a=this.time_of(
this.steps[o])-this.time_of(this.steps[r]),l=this.columns.place.map(d=>d.subarray((e>0?r:o)*n)),c=this.columns.mark.subarray((e>0?r:o)*n);for(let d=0;d<n;++d)c[d]!==
ms&&(s[d]=Math.hypot(...t.map((u,h)=>u[d]-l[h][d]))/Math.max(a,1e-9));return s}time_of(e){let t=this.rows.index(e);return t<0?0:this.rows.time[t]+(e-this.rows.step[t])*
this.head.dt}async frame_soon(e){return this.frame(e)}prefetch(){}async contacts_at(e){let t=this.contacts[e];return t?{step:e,rows:t}:{step:e,why_not:this.rows.
why_no_contacts(e),near:this.near_contacts(e)}}near_contacts(e){let t=Object.keys(this.contacts).map(Number);return t.length===0?null:t.reduce((n,s)=>Math.abs(s-
e)<Math.abs(n-e)?s:n)}async way(e){let t=this.bodies.row(e),n=this.bodies.count,s=[],r=[];return this.steps.forEach((o,a)=>{let l=this.columns.mark[a*n+t];s.push(
o);for(let c of this.columns.place)r.push(l===1||l===2?c[a*n+t]:null)}),{id:e,step:s,at:r}}async history(e){let t=this.bodies.row(e),n={id:e,step:[],x:[],y:[],z:[],
speed:[],asleep:[]};for(let s of t===void 0?[]:this.steps){let r=this.frame(s),o=r.mark[t]===1||r.mark[t]===2;n.step.push(s);for(let a of["x","y","z","speed"])n[a].
push(o?r[a][t]:null);n.asleep.push(o?+(r.mark[t]===2):null)}return n}async body_at(e,t){let n=this.bodies.row(t),s=this.frame(e);if(!s||n===void 0||s.mark[n]===
ms)return{why_not:"not there in this state",absent:!0};if(s.mark[n]===3)return{why_not:"a value of its state is no number"};let r=32767,o=["w","x","y","z"].map(
(a,l)=>({field:"orientation.".concat(a),value:Number((s.turn[l*s.rows+n]/r).toFixed(4))}));return{id:t,step:e,frozen:s.mark[n]===2,rounded:!0,fields:[...["x","y",
"z"].map(a=>({field:"position.".concat(a),value:Number(s[a][n].toFixed(4))})),...o,{field:"speed, about",value:Number(s.speed[n].toPrecision(3))}]}}};async function I0(i){
let e=[];for(let[n,s]of i.logs.entries()){let[r,o]=await Promise.all([C0("session-".concat(n,"-details")),P0("session-".concat(n,"-frames"))]);e.push(new Od(s,r,
o))}let t=document.getElementById("session-0-difference")?await C0("session-0-difference"):null;return{sessions:e,difference:t,served:!1,follow(){}}}var C1=16e7,Bd=24,R1=700,P1=120;async function L0(i,e={}){let t=new URLSearchParams(e).toString(),n=await fetch(t?"".concat(i,"?").concat(t):i,{cache:"no-store"});
if(!n.ok)throw new Error("".concat(i,": ").concat((await n.text()).slice(0,200)));return n}var si=async(i,e)=>(await L0(i,e)).json();function I1(i){let e=new DataView(
i),t=[];for(let n=0;n+16<=i.byteLength;){let[s,r,o,a]=[0,4,8,12].map(x=>e.getUint32(n+x,!0));n+=16;let l=[0,1,2,3].map(x=>new Float32Array(i,n+4*x*o,o));n+=16*o;
let c=new Int16Array(i,n,4*o);n+=8*o;let d=new Uint8Array(i,n,o);n+=o+(4-o%4)%4;let[u,h,f,p]=l;t.push({step:s,status:r,rows:o,version:a,x:u,y:h,z:f,speed:p,turn:c,
mark:d})}return t}var kd=class{constructor(e,t,n){this.log=e,this.head=t,this.thin=null,this.bodies=new mo(n),this.rows=new go(t.channels,!t.ours),this.steps=null,
this.timeline_done=!1,this.note="",this.unread="",this.cache=new Map,this.cache_bytes=0,this.asked=new Set,this.contact_cache=new Map}gaps(){let e=this.head.gaps;
return[...e,...this.rows.unread().filter(([t])=>!e.some(([n,s])=>t>=n&&t<=s))]}gap_at(e){return this.gaps().find(([t,n])=>e>=t&&e<=n)??null}time_of(e){let t=this.
rows.index(e);return t<0?(e-this.head.first)*this.head.dt:this.rows.time[t]+(e-this.rows.step[t])*this.head.dt}frame(e){return this.cache.get(e)??null}keep(e){let t=29*
e.rows+64;this.cache.set(e.step,e),this.cache_bytes+=t;for(let[n,s]of this.cache){if(this.cache_bytes<=C1)break;this.cache.delete(n),this.cache_bytes-=29*s.rows+
64}}async fetch(e,t,n){let s=await L0("frames",{log:this.log,first:e,count:t,stride:n}),r=I1(await s.arrayBuffer());for(let a of r)this.keep(a);Vn(r.map(a=>a.version))>
this.bodies.version&&await this.fetch_bodies()}async fetch_bodies(){this.bodies.update(await si("bodies",{log:this.log})),this.on_bodies?.()}async frame_soon(e){
return this.cache.has(e)||await this.fetch(e,1,1),this.frame(e)}prefetch(e,t){let n=Math.max(1,Math.round(Math.abs(t)))*Math.sign(t),s=e+n;for(let o=0;o<Bd/2&&this.
cache.has(s);++o)s+=n;if(this.asked.size>1)return;let r=n>0?s:Math.max(this.head.first,s+(Bd-1)*n);r>this.head.last||r<this.head.first||this.asked.has(r)||(this.
asked.add(r),this.fetch(r,Bd,Math.abs(n)).catch(()=>{}).finally(()=>this.asked.delete(r)))}async contacts_at(e){return this.contact_cache.has(e)||(this.contact_cache.
size>64&&this.contact_cache.clear(),this.contact_cache.set(e,await si("contacts",{log:this.log,step:e}))),this.contact_cache.get(e)}async history(e,t){this.histories??=
new Map;let n=this.histories.get(e)??{id:e,next:this.head.first,step:[],x:[],y:[],z:[],speed:[],spin:[],asleep:[]};for(this.histories.size>16&&this.histories.clear(),
this.histories.set(e,n);n.next<=this.head.last;){let s=n.next,r=await si("history",{log:this.log,id:e,from:s});if(r.why_not)throw new Error(r.why_not);if(n.next===
s){for(let o of["step","x","y","z","speed","spin","asleep"])_s(n[o],r[o]);if(n.next=r.next,n.rows=void 0,r.next===s||!t(n))break}}return n}async channel_history(e,t,n,s){
this.channel_histories??=new Map;let r="".concat(e," ").concat(t," ").concat(n),o=this.channel_histories.get(r)??{next:this.head.first,step:[],value:[]};for(this.
channel_histories.size>16&&this.channel_histories.clear(),this.channel_histories.set(r,o);o.next<=this.head.last;){let a=o.next,l=await si("channel",{log:this.log,
channel:e,a:t,b:n,from:a});if(l.why_not)throw new Error(l.why_not);if(o.next===a){for(let c of["step","value"])_s(o[c],l[c]);if(o.next=l.next,l.next===a||!s(o))
break}}return o}way(e){return si("way",{log:this.log,id:e})}body_at(e,t){return si("body",{log:this.log,step:e,id:t})}blame(e,t,n,s){return si("blame",{log:this.
log,step:e,id:t,field:n,back:s})}async take_news(){let e=await si("news",{log:this.log}),t=e.last>this.head.last||e.finished!==this.head.finished;t&&(this.head=
await si("head",{log:this.log})),e.version>this.bodies.version&&await this.fetch_bodies();let n=t;for(;this.rows.count<e.rows;){let s=await si("timeline",{log:this.
log,from:this.rows.count});if(s.step.length===0||(this.rows.append(s),_s(this.rows.events,s.more_inputs),n=!0,s.step.length<4e3))break}for(;this.rows.begun.length<
Math.min(e.begun,this.rows.count);){let s=await si("begun",{log:this.log,from:this.rows.begun.length});if(s.length===0)break;_s(this.rows.begun,s),n=!0}for(let s of[
"note","unread"])e[s]!==this[s]&&(n=!0),this[s]=e[s];return e.contacts_why_not!==this.rows.begun_why_not&&(n=!0),this.rows.begun_why_not=e.contacts_why_not,this.
timeline_done=e.timeline_done,this.busy=!e.timeline_done||!e.contacts_done,n}};async function N0(i){let e=await Promise.all(i.logs.map(async(n,s)=>new kd(s,n,await si(
"bodies",{log:s}))));return{sessions:e,difference:null,served:!0,follow:(n,s)=>{let r=null,o=e.length<2,a=async()=>{let l=!1;try{for(let u of e)l=await u.take_news()||
l;o||(r=await si("difference"),o=r.state!=="working",l=!0),s(null)}catch(u){s(u)}l&&n(r);let c=e.some(u=>!u.head.finished),d=!o||e.some(u=>!u.timeline_done||u.busy);
(c||d)&&setTimeout(a,d&&!c?P1:R1)};a()}}}var L1=30,N1=22,D0=i=>{let e=X("canvas",{});return e.setAttribute("aria-hidden","true"),e.style.height="".concat(i,"px"),e};function U0(i){let e=Math.min(devicePixelRatio,
2),t=i.clientWidth,n=i.clientHeight;(i.width!==Math.round(t*e)||i.height!==Math.round(n*e))&&(i.width=Math.round(t*e),i.height=Math.round(n*e));let s=i.getContext(
"2d",{willReadFrequently:!0});return s.setTransform(e,0,0,e,0,0),s.clearRect(0,0,t,n),{context:s,width:t,height:n}}function D1(i,e,t,n){let s=new Float64Array(Math.
ceil(n)+1).fill(1/0),r=new Float64Array(Math.ceil(n)+1).fill(-1/0),o=new Uint8Array(s.length);for(let a=0;a<i.count;++a){let l=e.of(i,a),c=Math.min(s.length-1,Math.
max(0,Math.round(t(i.step[a]))));if(l==null||!Number.isFinite(l)){(e.parts||i.read[a]===0)&&(o[c]=1);continue}l<s[c]&&(s[c]=l),l>r[c]&&(r[c]=l)}return{low:s,high:r,
none:o}}function U1({high:i,none:e}){let t=[],n=!1;for(let s=0;s<i.length;++s){if(i[s]===-1/0){e[s]&&(n=!1);continue}n||t.push([]),n=!0,t.at(-1).push(s)}return t}
function F1({low:i,high:e},t,n){let s=1/0,r=-1/0;for(let o=0;o<i.length;++o)i[o]<s&&(s=i[o]),e[o]>r&&(r=e[o]);return s===1/0?null:(t.top&&(r=t.top(n)),!t.fit&&!t.
log&&(s=Math.min(0,s)),t.log&&(s=Math.max(s,1e-18)),r<=s&&(r=s+(s===0?1:Math.abs(s))),{bottom:s,top:r})}function O1(i,e,t,n,s,r){let{context:o,width:a,height:l}=U0(
i),c=D1(t,e,n,a),d=F1(c,e,t);if(!d)return!1;let u=e.log?x=>Math.log(Math.max(x,1e-18)):x=>x,[h,f]=[u(d.bottom),u(d.top)],p=x=>l-2-(l-5)*(u(x)-h)/Math.max(f-h,1e-300);
if(o.fillStyle=o.strokeStyle=s,e.broken){o.fillStyle=r.bad;for(let x=0;x<t.count;++x)e.broken(t,x)&&o.fillRect(n(t.step[x]),l-4,2,4);o.fillStyle=s}if(e.kind==="\
bars"){for(let x=0;x<c.high.length;++x)c.high[x]>0&&o.fillRect(x,p(c.high[x]),1.2,l-1-p(c.high[x]));return!0}o.lineWidth=1.4,o.lineJoin="round";for(let x of U1(
c)){o.beginPath(),o.moveTo(x[0],p(c.high[x[0]]));for(let m of x)o.lineTo(m,p(c.high[m])),c.low[m]!==c.high[m]&&o.lineTo(m,p(c.low[m]));x.length===1&&o.lineTo(x[0]+
1.4,p(c.low[x[0]])),o.stroke(),e.kind==="area"&&(o.lineTo(x.at(-1),l),o.lineTo(x[0],l),o.globalAlpha=.25,o.fill(),o.globalAlpha=1)}return!0}function F0({rows:i,
range:e,seek:t,marks:n,hues:s}){let r=X("div",{className:"timeline",role:"group",ariaLabel:"timeline: values at the step shown"}),o=X("div",{className:"cursor"}),
a=D0(N1),l=X("span",{className:"value"}),c=[],d=0,u=y=>S=>(S-e().first)/Math.max(1,e().last-e().first)*(y-1),h=(y,S,b,C="")=>X("div",{className:"lane",title:C},
X("div",{className:"label"},X("span",{textContent:y}),S),b),f=y=>{c=y.map(S=>{let b=D0(L1),C=X("span",{className:"value"});return{lane:S,canvas:b,value:C,row:h(
S.name,C,b,S.title??"")}}),r.replaceChildren(h("events",l,a),...c.map(({row:S})=>S),o)},p=()=>{let{context:y,width:S,height:b}=U0(a),C=s(),{gaps:w,inputs:_,hits:M,
first_difference:R}=n(),P=u(S);y.fillStyle=C.line,y.fillRect(0,b/2-1,S,2);for(let[I,F]of w)y.fillStyle=C.bad,y.globalAlpha=.35,y.fillRect(P(I),2,Math.max(2,P(F)-
P(I)),b-4),y.globalAlpha=1;y.fillStyle=C.select;for(let I of M)y.fillRect(P(I.first),b-7,Math.max(2,P(I.last)-P(I.first)),6);y.fillStyle=C.ink;for(let{step:I}of _){
let F=P(I);y.beginPath(),y.moveTo(F-4,1),y.lineTo(F+4,1),y.lineTo(F,9),y.fill()}R!==null&&(y.fillStyle=C.bad,y.fillRect(P(R)-1,0,2,b),y.beginPath(),y.moveTo(P(R)+
1,0),y.lineTo(P(R)+9,4),y.lineTo(P(R)+1,8),y.fill())},x=()=>{let y=i.index(d),S=i.reaches(d)?y:-1;for(let{lane:w,value:_}of c)_.textContent=S<0||i.step[S]===void 0?
"\u2013":w.words(i,S);let b=n().inputs.filter(w=>w.step===d);l.textContent=b.length>0?b.map(({kind:w,body:_})=>"".concat(w).concat(_?" ".concat(_):"")).join(", "):
"".concat(n().inputs.length," input").concat(n().inputs.length===1?"":"s");let C=a.offsetLeft+u(a.clientWidth)(d);o.style.transform="translateX(".concat(C,"px)")},
m=()=>{if(a.clientWidth===0)return;let y=s();p(),c.forEach(({lane:S,canvas:b,row:C},w)=>{let _=O1(b,S,i,u(b.clientWidth),S.bad?y.bad:y.lanes[w%y.lanes.length],y);
C.hidden=!_&&(S.only_if_any||S.late)}),x()},g=y=>{if(y.buttons===0)return;let S=a.getBoundingClientRect(),b=Math.min(1,Math.max(0,(y.clientX-S.left)/Math.max(1,
S.width-1)));t(Math.round(e().first+b*(e().last-e().first)))};return r.addEventListener("pointerdown",y=>{y.target.tagName==="CANVAS"&&(r.setPointerCapture(y.pointerId),
g(y))}),r.addEventListener("pointermove",g),new ResizeObserver(m).observe(r),{place:r,draw:m,set_lanes:f,show(y){d=y,x()}}}function O0(i){let{drawing:e}=i,t=i.sessions.length===2,n=(h,f,p,x)=>{let m=X("button",{type:"button",textContent:h,title:"".concat(h," (").concat(f,")")});return m.
addEventListener("click",()=>{x(),u()}),{made:m,is_on:p}},s=X("select",{},...[["material","material"],["state","asleep or awake"],["speed","speed"],...t?[["apar\
t","distance A to B"]]:[]].map(([h,f])=>X("option",{value:h,textContent:f})));s.addEventListener("change",()=>{e.paint=s.value;let{rows:h}=i.sessions[0];e.top_speed=
Vn([.1,...h.speed.map(f=>Math.min(f??0,50))]),e.show()});let r=()=>{e.with_contacts=!e.with_contacts,e.show()},o=()=>{e.with_ways=!e.with_ways,e.show_ways(),i.refresh()},
a=()=>{t&&e.set_side_by_side(!e.side_by_side)},l=()=>{i.selected!==null&&(e.following=!e.following,e.show())},c=[n("Contacts","c",()=>e.with_contacts,r),n("Ways",
"w",()=>e.with_ways,o),...t?[n("Side by side","s",()=>e.side_by_side,a)]:[],n("Follow","f",()=>e.following,l)],d=X("button",{type:"button",textContent:"Whole sc\
ene",title:"Whole scene (r)"});d.addEventListener("click",()=>e.reset_view());function u(){for(let{made:h,is_on:f}of c)h.setAttribute("aria-pressed",String(f()));
c.at(-1).made.disabled=i.selected===null}return u(),{place:X("div",{className:"toolbar",role:"group",ariaLabel:"what is drawn"},X("label",{},"Colour by ",s),...c.
map(({made:h})=>h),d),show:u,flip:{c:()=>{r(),u()},w:()=>{o(),u()},s:()=>{a(),u()},f:()=>{l(),u()},r:()=>e.reset_view()}}}var B1=60,zd=class{constructor(e,t){Object.assign(this,t,{place:e,selected:null,hits:[],hit:-1,settle:null,asked:0});let[n]=this.sessions;for(let{rows:s,bodies:r}of this.
sessions)s.label=o=>r.label(o);this.steps=new hr(Math.min(...this.sessions.map(({head:s})=>s.first)),Math.max(...this.sessions.map(({head:s})=>s.last)),this.union_of_steps()),
this.player=th({steps:this.steps,dt:()=>n.head.dt,show:s=>this.show(s),played:s=>this.said_playing(s)}),this.header=o0(this),this.view=X("div",{className:"view3\
d"}),this.said=X("output",{className:"said"}),this.told=X("output",{className:"told",ariaLabel:"what has happened"}),this.drawing=new rh(this.view,this.sessions,
s=>this.select(s)),this.timeline=F0({rows:n.rows,range:()=>this.steps,seek:s=>this.player.seek(s),hues:Qi,marks:()=>this.marks()}),this.plots=this.sessions[0].channel_history?
new ah(this):null,this.search=A0(this),this.side=new lh(this),this.toolbar=O0(this),this.keys=f0(this),e.replaceChildren(this.header.place,X("div",{className:"w\
ork"},X("section",{className:"shown",ariaLabel:"the state shown"},this.toolbar.place,this.view,this.said,this.told,this.player.bar,this.timeline.place),X("aside",
{ariaLabel:"search and numbers"},this.search.place,...this.side.places,this.keys.place))),this.set_lanes(),this.side.show_inputs(),this.side.show_selection(),this.
sessions.length===2&&this.side.show_difference()}union_of_steps(){return this.sessions.some(e=>e.steps)?[...new Set(this.sessions.flatMap(e=>e.steps))].sort((e,t)=>e-
t):null}addressed(){let[e,t]=["step","body"].map(n=>new RegExp("(?:^#|&)".concat(n,"=(\\d+)")).exec(location.hash));return{step:e&&this.steps.at_or_before(Number(
e[1])),body:Number(t?.[1]??0)||null}}go_to_address(){let{step:e,body:t}=this.addressed();e!==null&&this.player.seek(e),t!==null&&this.select(t)}async start(){let{
step:e,body:t}=this.addressed(),n=e??this.steps.first;this.drawing.frames=await Promise.all(this.sessions.map(s=>s.frame_soon(n).catch(()=>null))),this.drawing.
start(),this.player.seek(n),this.player.refresh(),t!==null&&this.select(t),addEventListener("hashchange",()=>this.go_to_address());for(let s of this.sessions)s.
on_bodies=()=>{this.drawing.describe(),this.refresh()};new ResizeObserver(()=>this.drawing.resize()).observe(this.view),qa(()=>{this.drawing.restart(),this.timeline.
draw()}),this.follow(s=>this.changed(s),s=>this.header.trouble(s)),this.place.dataset.ready="true"}marks(){let[{rows:e}]=this.sessions;return{gaps:this.sessions.
flatMap(t=>t.gaps()),inputs:e.events,hits:this.hits,first_difference:this.difference?.first?.step??null,first_effect:this.difference?.effect?.step??null}}set_lanes(){
let{head:e,rows:t}=this.sessions[0],n=[...this.plots?.lanes()??[],...g0(this.bounds),...m0(e),..._0(t)];this.difference?.separation&&n.unshift(y0(this.difference.
separation)),this.timeline.set_lanes(n),this.timeline.draw()}separation_at(e){let t=this.difference?.separation;return t?(this.separations??=new Map(t.step.map(
(n,s)=>[n,t.metres[s]??1/0])),this.separations.get(e)??null):null}changed(e){let{head:t}=this.sessions[0],n=Math.max(...this.sessions.map(s=>s.head.last));if(e&&
e!==this.difference){let s=!!this.difference?.separation;this.difference=e,this.side.show_difference(),!s&&e.separation&&this.set_lanes()}n!==this.steps.last&&this.
player.set_last(n)&&!t.finished&&this.player.seek(n),this.header.show(),this.side.show_inputs(),this.search.again(),this.plots?.again(),this.timeline.draw()}show(e){
this.timeline.show(e);let t=++this.asked,n=this.sessions.map(s=>s.frame(s.steps?this.own_step(s,e):e));if(this.player.direction!==0)for(let s of this.sessions)s.
prefetch(e,this.player.direction*this.player.stride);n.every(s=>s!==null)?this.show_frames(e,n):this.fetch_frames(e,t),clearTimeout(this.settle),this.settle=setTimeout(
()=>this.settled(e),B1)}own_step(e,t){return new hr(e.head.first,e.head.last,e.steps).at_or_before(t)}async fetch_frames(e,t){if(this.fetching){this.wanted=[e,t];
return}this.fetching=!0;try{let s=performance.now(),r=await Promise.all(this.sessions.map(o=>e<o.head.first||e>o.head.last?null:o.frame_soon(o.steps?this.own_step(
o,e):e)));this.seek_ms=performance.now()-s,(t===this.asked||this.player.direction!==0)&&this.show_frames(e,r),this.header.trouble(null)}catch(s){this.header.trouble(
s)}this.fetching=!1;let{wanted:n}=this;this.wanted=null,n&&this.fetch_frames(...n)}show_frames(e,t){this.drawing.frames=t,this.drawing.show(),this.shown=e;let n=this.
words(e,t);this.said.value=n,this.player.slider.setAttribute("aria-valuetext",n);let s=t[0]&&t[0].status!==0?this.sessions[0].gap_at(e):null,r=t.every(o=>o===null||
o.status!==0);this.drawing.over.hidden=!r,this.drawing.over.textContent=r?s?"Step ".concat(e," is not here: ").concat(s[2],"."):"The state of step ".concat(e," \
cannot be read."):""}words(e,t){let[n]=this.sessions,[s]=t,r=["step ".concat(e),"".concat(n.time_of(e).toFixed(3)," s")];if(s&&s.status===0){let o=[0,0,0,0];for(let l of s.
mark)++o[l];let a=o[1]+o[2]+o[3];if(r.push("".concat(a," bod").concat(a===1?"y":"ies",", ").concat(o[2]," asleep")),o[3]>0){let l=s.mark.indexOf(3);r.push("".concat(
n.bodies.label(n.bodies.id(l))).concat(o[3]>1?" and ".concat(o[3]-1," more"):""," lost: no numbers").concat(o[3]>oh?", ".concat(oh," of them marked"):""))}s.step!==
e&&r.push("A shows step ".concat(s.step))}else n.gap_at(e)&&r.push(n.gap_at(e)[2]);if(r.push(...this.drawing.ways_words()),this.sessions.length===2){let o=this.
difference?.first?.step,a=this.separation_at(e);o!==void 0&&e<o?r.push("the same in both"):a!==null&&r.push(a===1/0?"infinitely far apart":"at most ".concat(a.toPrecision(
3)," m apart")),r.push(...this.drawing.only_in_words())}return r.join(" \xB7 ")}async settled(e){let t="#step=".concat(e).concat(this.selected===null?"":"&body=".
concat(this.selected));try{history.replaceState(null,"",t)}catch{}this.player.direction!==0&&this.served||await this.side.settled(e).catch(n=>this.header.trouble(
n))}refresh(){this.player.refresh()}tell(e){e&&this.told.value!==e&&(this.told.value=e)}said_playing(e){this.said.setAttribute("aria-live",e===0?"polite":"off"),
this.tell(e===0?"stopped at ".concat(this.said.value):e>0?"playing":"playing backwards")}select(e){e!==this.selected&&this.tell(e===null?"no body is chosen":"".
concat(this.side.label(e)," is chosen")),this.selected=e,this.drawing.selected=e,e===null&&(this.drawing.following=!1),this.toolbar.show(),this.drawing.show(),this.
drawing.show_ways().catch(t=>this.header.trouble(t)),this.side.show_selection(),this.side.draw_contacts(),this.settled(this.player.step)}go_to_first_difference(){
let e=this.difference?.first?.step;e!==void 0&&this.player.seek(e)}go_to_first_effect(){let e=this.difference?.effect?.step;e!==void 0&&this.player.seek(e)}set_hits(e){
this.hits=e,this.hit=-1,this.timeline.draw()}next_hit(e){if(this.hits.length===0)return;this.hit=(this.hit+e+this.hits.length)%this.hits.length;let t=this.hits[this.
hit];this.player.seek(e>0||this.steps.list===null?t.first:t.at),this.search.at(this.hit)}};async function B0(i){try{let e=JSON.parse(document.getElementById("se\
ssion-head").textContent),t=await(e.mode==="sent"?I0:N0)(e);await new zd(i,{...t,bounds:e.bounds??[]}).start()}catch(e){throw i.append(X("p",{className:"bad",textContent:"\
This cannot be drawn: ".concat(e.message)})),e}}function k1(i){let e=JSON.parse(i.querySelector("script").textContent);i.replaceChildren();let t=i.dataset.first===void 0?null:Number(i.dataset.first),n=(i.dataset.
groups??"").split(" "),s=Bp(i,e,{first:t,groups:n}),r=n0(i,e,s.show_step);qa(()=>{s.redraw(),r?.redraw()}),new ResizeObserver(()=>{s.resize(),r?.resize()}).observe(
i)}function z1(i,e){let t=new IntersectionObserver(n=>{n.some(s=>s.isIntersecting)&&(t.disconnect(),e(i))},{rootMargin:"200px"});t.observe(i)}function Vd(i){return e=>{
try{i(e)}catch(t){let n=document.createElement("p");throw n.textContent="This cannot be drawn: ".concat(t.message),e.append(n),t}}}var z0=document.createElement(
"style");z0.textContent=lf+cf+hf;document.head.append(z0);for(let i of document.querySelectorAll("table.glance"))Vd(Wp)(i);for(let i of document.querySelectorAll(
".drawing"))i.querySelector("p").textContent="Plots and trajectories are drawn once they are in view.",z1(i,Vd(k1));for(let i of document.querySelectorAll(".pic\
tures"))Vd(kp)(i);var k0=document.getElementById("session");k0&&B0(k0);})();
/*! Bundled license information:

three/build/three.core.js:
three/build/three.module.js:
  (**
   * @license
   * Copyright 2010-2026 Three.js Authors
   * SPDX-License-Identifier: MIT
   *)
*/
