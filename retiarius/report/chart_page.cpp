#include "retiarius/report/chart_page.hpp"

namespace retiarius {

// The variables --ink, --soft, --grid, --card and --c0 ... --c6 colour the charts
// (chart_paint.hpp).
const char* const kChartPageStyle = R"css(
:root{color-scheme:light dark;--paper:#f6f7f9;--card:#fff;--ink:#1b2330;--soft:#5b6675;
--line:#dfe3e9;--grid:#e3e7ec;--good:#0b7a55;--bad:#b3261b;--badcard:#fdeceb;
--c0:#0072b2;--c1:#d55e00;--c2:#009e73;--c3:#b0578d;--c4:#a87500;--c5:#3a96cf;--c6:#1b2330}
@media(prefers-color-scheme:dark){:root{--paper:#11151b;--card:#1a2029;--ink:#e6eaf0;
--soft:#9aa6b5;--line:#2d3642;--grid:#2a323e;--good:#3ecf9b;--bad:#ff8f80;--badcard:#3a1c1a;
--c0:#56b4e9;--c1:#ff8a3d;--c2:#2fcf9f;--c3:#e39ac6;--c4:#f0c04a;--c5:#8fb8ff;--c6:#e6eaf0}}
*{box-sizing:border-box}
html{scroll-behavior:smooth;scroll-padding-top:12px}
body{margin:0;background:var(--paper);color:var(--ink);
font:16px/1.55 system-ui,-apple-system,"Segoe UI",Roboto,"Helvetica Neue",Arial,sans-serif}
main{max-width:1120px;margin:0 auto;padding:40px 24px 64px}
a{color:var(--c0)}
.brand{margin:0;color:var(--soft);font-size:.8rem;letter-spacing:.14em;text-transform:uppercase}
h1{margin:.15em 0 .3em;font-size:clamp(1.7rem,4.5vw,2.5rem);line-height:1.15;letter-spacing:-.015em}
h2{margin:2.4em 0 .8em;font-size:1.35rem}
h3{margin:0 0 .3em;font-size:1.12rem;line-height:1.3}
.lead{max-width:46em;margin:0 0 1.4em}
.soft{color:var(--soft)}
.verdict,article,nav{background:var(--card);border:1px solid var(--line);border-radius:10px;
padding:18px 20px}
.verdict{border-left:8px solid var(--good)}
.verdict.bad{border-color:var(--bad);background:var(--badcard)}
.verdict p,.verdict ul{margin:.2em 0}
.big{font-size:1.5rem;font-weight:700;color:var(--good)}.bad>.big{color:var(--bad)}
nav{margin-top:16px;columns:340px auto;column-gap:32px}
nav h2{margin:0 0 .4em;font-size:1.1rem;column-span:all}
nav h3{margin:.7em 0 .2em;font-size:.92rem;color:var(--soft);font-weight:600;break-after:avoid}
nav ul{margin:0;padding:0;list-style:none}
nav li{margin:.15em 0;padding-left:5.2em;text-indent:-5.2em;break-inside:avoid}
.badge{display:inline-block;min-width:4.9em;margin-right:.7em;padding:.05em .5em;border-radius:5px;
font-size:.75rem;font-weight:600;text-align:center;text-indent:0;color:var(--good);
border:1px solid currentColor}
.badge.drawn{color:var(--soft)}
.badge.miss{background:var(--bad);border-color:var(--bad);color:var(--card)}
article{margin-bottom:20px}
article.bad{border:2px solid var(--bad)}
.tags{display:flex;flex-wrap:wrap;gap:4px 14px;align-items:center;margin:.1em 0 .6em}
.tags .badge{margin:0}
.fig{font-weight:600}
.failure{padding:.7em 1em;background:var(--badcard);border-left:5px solid var(--bad);
overflow-wrap:anywhere}
article>p{max-width:52em}
.note{padding-left:1em;border-left:3px solid var(--line)}
.charts{display:grid;gap:18px;grid-template-columns:repeat(auto-fit,minmax(min(100%,420px),1fr));
margin:14px 0}
figure{margin:0;min-width:0;max-width:640px}
h4{margin:0 0 .3em;font-size:.98rem}
figcaption{font-size:.88rem;line-height:1.45;margin-top:.3em}
.chart{display:block;width:100%;height:auto;
font-family:system-ui,-apple-system,"Segoe UI",Roboto,"Helvetica Neue",Arial,sans-serif}
details{margin:10px 0}
summary{cursor:pointer;font-weight:500}
summary b,.missed b{color:var(--bad)}
.source{margin:.6em 0;font-size:.9rem;color:var(--soft)}
.table{overflow-x:auto;margin-top:8px}
table{width:100%;border-collapse:collapse;font-size:.88rem;font-variant-numeric:tabular-nums}
th,td{padding:.38em .8em .38em 0;text-align:left;border-top:1px solid var(--grid);
vertical-align:top}
td{white-space:nowrap}td:last-child{white-space:normal}
thead th{color:var(--soft);font-weight:500;border-top:0}
tbody th{font-weight:500}
.missed{background:var(--badcard)}.missed th{color:var(--bad);font-weight:700}
.why{margin-left:.4em;font-size:.8em;text-decoration:none;vertical-align:.2em}
.whys{margin:.3em 0;padding-left:1.6em;font-size:.9rem;max-width:56em}
.whys :target,.whys li:target{background:var(--grid)}
code{font:13px/1.5 ui-monospace,SFMono-Regular,Menlo,Consolas,"DejaVu Sans Mono",monospace}
@media(max-width:700px){main{padding:24px 12px 40px}.verdict,article,nav{padding:14px 13px}
thead{display:none}tbody tr{display:block;padding:.5em 0;border-top:1px solid var(--line)}
tbody th,td{display:block;border:0;padding:.06em 0;white-space:normal}
td{display:flex;gap:.8em}td::before{content:attr(data-l);flex:0 0 5.6em;color:var(--soft)}
.missed{padding:.5em!important}}
@media print{body{background:#fff}figure,tr{break-inside:avoid}
details::details-content{content-visibility:visible;height:auto}}
)css";

}  // namespace retiarius
