#include "retiarius/report/report_html.hpp"

namespace retiarius {

// The colours of the lines are those of Okabe and Ito, which colour-blind readers tell apart;
// dashes tell them apart without colour.
const char* const kReportStyle = R"css(
:root{color-scheme:light dark;--paper:#f6f7f9;--card:#fff;--ink:#1b2330;--soft:#5b6675;
--line:#dfe3e9;--grid:#e9ecf1;--good:#0b7a55;--bad:#b3361b;--warn:#8a5a00;
--c0:#0072b2;--c1:#d55e00;--c2:#009e73;--c3:#b0578d;--c4:#a87500;--c5:#3a96cf;--c6:#1b2330;
--net:#0b5a8f;--b0:#59636f;--b1:#67727f;--b2:#76818f;--b3:#86919f;--b4:#97a2af;--b5:#a9b3bf;
--b6:#bcc5cf;--b7:#d0d7df}
@media(prefers-color-scheme:dark){:root{--paper:#11151b;--card:#1a2029;--ink:#e6eaf0;
--soft:#9aa6b5;--line:#2d3642;--grid:#262e39;--good:#3ecf9b;--bad:#ff8f70;--warn:#f0b94a;
--c0:#56b4e9;--c1:#ff8a3d;--c2:#2fcf9f;--c3:#e39ac6;--c4:#f0c04a;--c5:#8fb8ff;--c6:#e6eaf0;
--net:#7cc4f2;--b0:#2a313a;--b1:#333b46;--b2:#3d4652;--b3:#48525f;--b4:#535e6c;--b5:#5f6b7a;
--b6:#6c7989;--b7:#7b8899}}
*{box-sizing:border-box}
body{margin:0;background:var(--paper);color:var(--ink);
font:16px/1.55 system-ui,-apple-system,"Segoe UI",Roboto,"Helvetica Neue",Arial,sans-serif}
main{max-width:1120px;margin:0 auto;padding:40px 24px 64px}
.brand{margin:0;color:var(--soft);font-size:.8rem;letter-spacing:.14em;text-transform:uppercase}
h1{margin:.15em 0 .6em;font-size:clamp(1.6rem,4.5vw,2.4rem);line-height:1.15;
letter-spacing:-.015em;overflow-wrap:anywhere}
h2{margin:2.6em 0 .9em;font-size:1.2rem;letter-spacing:-.005em}
.outcome{display:flex;gap:.7em;align-items:baseline;flex-wrap:wrap;padding:.8em 1.1em;
background:var(--card);border:1px solid var(--line);border-left:5px solid var(--tone);
border-radius:10px}
.outcome b{color:var(--tone);font-size:1.1rem}
.finished{--tone:var(--good)}.failed,.broke{--tone:var(--bad)}.interrupted{--tone:var(--warn)}
.cards{display:grid;grid-template-columns:repeat(auto-fit,minmax(150px,1fr));gap:12px;
margin-top:16px}
.cards div{background:var(--card);border:1px solid var(--line);border-radius:10px;
padding:.75em 1em}
.cards dt,.cards dd{margin:0}.cards dl{margin:0}
.cards dt{color:var(--soft);font-size:.82rem}
.cards dd{font-size:1.35rem;font-weight:600;font-variant-numeric:tabular-nums;line-height:1.3}
.cards small,td small{color:var(--soft);font-weight:400;font-size:.8em}
.story,.plots{display:grid;gap:16px;grid-template-columns:repeat(auto-fill,minmax(min(100%,300px),1fr))}
.plots{grid-template-columns:repeat(auto-fill,minmax(min(100%,430px),1fr))}
figure{margin:0;padding:14px 14px 10px;background:var(--card);border:1px solid var(--line);
border-radius:10px;min-width:0}
figcaption{font-size:.95rem;font-weight:600}
.story figcaption{display:flex;justify-content:space-between;gap:1em;font-variant-numeric:tabular-nums}
.story figcaption span:last-child{color:var(--soft);font-weight:400}
.story figcaption b{margin-right:.5em;color:var(--soft);font-weight:400}
figure>svg{display:block;width:100%;height:auto;margin-top:6px}
svg text{fill:var(--soft);font:11.5px system-ui,-apple-system,"Segoe UI",Roboto,Arial,sans-serif;
font-variant-numeric:tabular-nums}
svg path{fill:none}
.grid{stroke:var(--grid)}.zero,.axis{stroke:var(--soft);stroke-opacity:.6}
.mark{stroke:var(--soft);stroke-opacity:.75;stroke-dasharray:1.5 3.5}
.line{stroke-width:1.7;stroke-linejoin:round;stroke-linecap:round}
.s0{stroke:var(--c0)}.s1{stroke:var(--c1);stroke-dasharray:7 3}
.s2{stroke:var(--c2);stroke-dasharray:2.5 3}.s3{stroke:var(--c3);stroke-dasharray:9 3 2 3}
.s4{stroke:var(--c4);stroke-dasharray:4 3}.s5{stroke:var(--c5);stroke-dasharray:12 4}
.s6{stroke:var(--c6);stroke-dasharray:1.5 4}
.dot{stroke:none}.dot.s0{fill:var(--c0)}.dot.s1{fill:var(--c1)}.dot.s2{fill:var(--c2)}
.dot.s3{fill:var(--c3)}.dot.s4{fill:var(--c4)}.dot.s5{fill:var(--c5)}.dot.s6{fill:var(--c6)}
.legend{display:flex;flex-wrap:wrap;gap:2px 16px;margin-top:4px;color:var(--soft);font-size:.82rem}
.legend svg{width:22px;height:8px;margin-right:6px;vertical-align:middle}
.scene .net{stroke:var(--net);stroke-width:.75;stroke-linecap:round}
.scene .border{stroke-width:1.5}
.scene .b0{fill:var(--b0);stroke:var(--b0)}.scene .b1{fill:var(--b1);stroke:var(--b1)}
.scene .b2{fill:var(--b2);stroke:var(--b2)}.scene .b3{fill:var(--b3);stroke:var(--b3)}
.scene .b4{fill:var(--b4);stroke:var(--b4)}.scene .b5{fill:var(--b5);stroke:var(--b5)}
.scene .b6{fill:var(--b6);stroke:var(--b6)}.scene .b7{fill:var(--b7);stroke:var(--b7)}
.scene [class^=b]{stroke-width:.4;stroke-linejoin:round}
.table{overflow-x:auto;background:var(--card);border:1px solid var(--line);border-radius:10px}
table{width:100%;border-collapse:collapse;font-size:.93rem;font-variant-numeric:tabular-nums}
th,td{padding:.5em 1em;text-align:left;border-top:1px solid var(--grid);vertical-align:top}
tr:first-child>*{border-top:0}
thead th{color:var(--soft);font-weight:500;font-size:.82rem}
tbody th{font-weight:500}.num{text-align:right;white-space:nowrap}
code,pre{font:13px/1.5 ui-monospace,SFMono-Regular,Menlo,Consolas,"DejaVu Sans Mono",monospace}
details{margin-top:12px;background:var(--card);border:1px solid var(--line);border-radius:10px}
summary{padding:.7em 1em;cursor:pointer;font-weight:500}
pre{margin:0;padding:1em;border-top:1px solid var(--grid);overflow-x:auto}
.note{color:var(--soft);font-size:.88rem}
.columns{display:grid;gap:16px;grid-template-columns:repeat(auto-fit,minmax(min(100%,360px),1fr));
align-items:start}
@media(max-width:560px){main{padding:24px 14px 40px}th,td{padding:.45em .7em}
.cards{grid-template-columns:1fr 1fr}.cards dd{font-size:1.15rem}}
@media print{body{background:#fff}figure,.table{break-inside:avoid}}
)css";

}  // namespace retiarius
