#pragma once

namespace tumble::golden {

/// The look of index.html: light and dark, from a phone's width up, and never by colour alone.
inline constexpr const char* kReportStyle = R"(
:root { color-scheme: light dark; --paper: #fff; --ink: #1c2024; --soft: #5b6570; --line: #d5dae0; --panel: #f5f7f9;
  --good: #17692f; --good-panel: #e4f4e8; --bad: #a8201a; --bad-panel: #fdeceb; --code: #eef1f4; }
@media (prefers-color-scheme: dark) { :root { --paper: #14171a; --ink: #e6e9ec; --soft: #9aa5b1; --line: #333a42;
  --panel: #1c2126; --good: #7fd895; --good-panel: #17301d; --bad: #ff9d95; --bad-panel: #3b1a18; --code: #22282e; } }
* { box-sizing: border-box; }
body { margin: 0 auto; max-width: 72rem; padding: 1.25rem; background: var(--paper); color: var(--ink);
  font: 1rem/1.5 system-ui, "DejaVu Sans", sans-serif; }
h1 { margin: 0; font-size: 1.6rem; line-height: 1.25; }
h2 { margin: 2rem 0 .75rem; font-size: 1.2rem; }
h3 { margin: 1.25rem 0 .4rem; font-size: 1rem; }
p, ul { margin: .3rem 0; }
p, li, h1, h2, h3, td { overflow-wrap: break-word; }
.soft { color: var(--soft); }
.banner { padding: 1rem 1.25rem; border-radius: .5rem; border-left: .5rem solid; }
.banner.pass { background: var(--good-panel); border-color: var(--good); }
.banner.none { background: var(--panel); border-color: var(--soft); }
.banner.fail { background: var(--bad-panel); border-color: var(--bad); }
.tiles { display: grid; grid-template-columns: repeat(auto-fit, minmax(11rem, 1fr)); gap: .75rem; margin: 1rem 0; padding: 0;
  list-style: none; }
.tiles li { padding: .6rem .9rem; border: 1px solid var(--line); border-radius: .5rem; background: var(--panel); }
.tiles strong { display: block; font-size: 1.15rem; }
details { margin: .5rem 0; border: 1px solid var(--line); border-radius: .5rem; }
details.fail { border-left: .5rem solid var(--bad); }
summary { display: flex; flex-wrap: wrap; gap: .25rem .9rem; align-items: baseline; padding: .6rem .9rem; cursor: pointer; }
summary:focus-visible, a:focus-visible, pre:focus-visible { outline: 3px solid #3b82f6; outline-offset: 2px; }
summary::before { content: "\25B8"; color: var(--soft); }
details[open] > summary::before { content: "\25BE"; }
summary h3 { margin: 0; font-size: 1.05rem; }
summary h3, summary span { min-width: 0; overflow-wrap: anywhere; }
.inside { padding: 0 .9rem .9rem; border-top: 1px solid var(--line); }
.chips { display: flex; flex-wrap: wrap; gap: .4rem; margin-left: auto; }
.chip { padding: .05rem .6rem; border: 1px solid; border-radius: 1rem; font-size: .85rem; white-space: nowrap; }
.pass > .mark, .chip.pass { color: var(--good); }
.fail > .mark, .chip.fail { color: var(--bad); font-weight: 600; }
td.mark, .glance .chip { white-space: nowrap; }
.glance code { user-select: all; font: .82rem/1.4 ui-monospace, "DejaVu Sans Mono", monospace; overflow-wrap: anywhere; }
a { color: inherit; overflow-wrap: anywhere; }
.glance a { overflow-wrap: break-word; }
.pictures { display: flex; flex-wrap: wrap; gap: .75rem; }
.pictures figure { margin: 0; }
.pictures img { max-width: 100%; height: auto; }
.filters { display: flex; flex-wrap: wrap; gap: .5rem 1rem; align-items: baseline; margin: .5rem 0; }
.filters label { display: inline-flex; gap: .4rem; align-items: baseline; }
.filters select, .filters input, th button { padding: .2rem .5rem; border: 1px solid var(--soft); border-radius: .4rem;
  background: var(--panel); color: var(--ink); font: inherit; }
th button { border: 0; padding: 0; background: none; font-weight: 600; cursor: pointer; text-align: left; }
.chip.none { color: var(--soft); }
.scroll { overflow-x: auto; }
table { width: 100%; border-collapse: collapse; font-size: .92rem; }
th, td { padding: .35rem .6rem; border-bottom: 1px solid var(--line); text-align: left; vertical-align: top; }
td.number, th.number { text-align: right; font-variant-numeric: tabular-nums; white-space: nowrap; }
tr.fail { background: var(--bad-panel); }
pre { margin: .3rem 0; padding: .6rem .8rem; border-radius: .4rem; background: var(--code); overflow-x: auto; user-select: all;
  font: .88rem/1.45 ui-monospace, "DejaVu Sans Mono", monospace; }
@media (max-width: 44rem) {
  body { padding: .75rem; } .chips { margin-left: 0; }
  thead { position: absolute; left: -9999px; } table, tbody, tr, td { display: block; }
  tr { padding: .4rem 0; border-bottom: 1px solid var(--line); } td, td.number { border: 0; padding: .1rem .5rem; text-align: left;
    white-space: normal; } td[data-name]::before { content: attr(data-name) ": "; color: var(--soft); }
}
)";

}  // namespace tumble::golden
