#include "monitor/service/page.hpp"

namespace placedpar::monitor {

const char* const page_html = R"page(<!DOCTYPE html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<title>placedpar monitor</title>
<link rel="icon" href="data:,">
<style>
:root { --paper: #fff; --ink: #1c2733; --faint: #667; --line: #d4d9df; --alarm: #b3261e; --good: #1b6e3c; color-scheme: light dark; }
@media (prefers-color-scheme: dark) { :root { --paper: #14191f; --ink: #e3e8ee; --faint: #98a5b3; --line: #38434f; --alarm: #ff8a80; --good: #7fd6a0; } }
body { background: var(--paper); color: var(--ink); font: 15px/1.4 sans-serif; margin: 0 auto; max-width: 72em; padding: 1em; }
h1 { font-size: 1.3em; margin: 0; } h2 { font-size: 1.1em; margin: 1.4em 0 .3em; }
table { border-collapse: collapse; width: 100%; }
th, td { border-bottom: 1px solid var(--line); padding: .25em .6em .25em 0; text-align: left; vertical-align: top; }
th { color: var(--faint); font-weight: normal; } td.number { font-variant-numeric: tabular-nums; }
tr.chosen td:first-child { font-weight: bold; } tr.machine { cursor: pointer; }
.alarm { color: var(--alarm); font-weight: bold; } .faint { color: var(--faint); } .good { color: var(--good); }
#load { color: var(--faint); } svg { width: 100%; height: auto; } svg text { font: 12px sans-serif; fill: var(--ink); }
@media (max-width: 45em) { /* a row is a list, of which each line says its head */
  table, tbody, tr, td { display: block; } tr:first-child { display: none; } td { border: 0; padding: 0; }
  tr { border-bottom: 1px solid var(--line); padding: .25em 0; } td:empty { display: none; }
  td:not([data-head=""])::before { color: var(--faint); content: attr(data-head) ": "; font-weight: normal; } }
</style>
</head>
<body>
<h1>placedpar monitor</h1>
<div id="load">asking the monitor ...</div>
<p><label><input type="checkbox" id="si"> SI units</label></p>
<h2>Alarms that hold</h2><div id="alarms"></div>
<h2>Machines</h2><div id="machines"></div>
<h2 id="title"></h2><div id="chart"></div><div id="past"></div>
<script>
"use strict";
const colours = matchMedia("(prefers-color-scheme: dark)").matches
  ? ["#6cb2ff", "#ffb366", "#7fd6a0", "#d59be6", "#ff9db8", "#a8c4d6"] : ["#0057b8", "#b35900", "#1b6e3c", "#7a2a8c", "#8c1d40", "#3d5a6c"];
const marks = ["circle", "square", "triangle"];
let chosen = null;
const by = id => document.getElementById(id);
function made(tag, text, kind) {
  const element = document.createElement(tag);
  if (text !== undefined) element.textContent = text;
  if (kind) element.className = kind;
  return element;
}
function table(heads, rows, none) {
  if (rows.length === 0) return made("p", none, "faint");
  const all = made("table"), head = made("tr");
  heads.forEach(text => head.append(made("th", text)));
  rows.forEach(tr => [...tr.cells].forEach((td, i) => { td.dataset.head = heads[i]; }));
  all.append(head, ...rows);
  return all;
}
function row(cells) {
  const all = made("tr");
  cells.forEach(cell => { const td = made("td"); td.append(cell); all.append(td); });
  return all;
}
const time = at => at === null ? "" : new Date(1000 * at).toLocaleString();
const unit = () => by("si").checked ? {name: "cm³/MPa", factor: 16.387064 / .006894757293} : {name: "in³/psi", factor: 1};
const compliance = c => c === null ? "" : (c * unit().factor).toPrecision(4);
const counted = (n, noun) => `${n} ${noun}${n === 1 ? "" : "s"}`;
function showLoad(d) {
  const line = made("span", `${counted(d.machines.length, "machine")}, ${counted(d.clients, "connection")}, ` +
    `${d.samples_per_s.toFixed(0)} samples/s, ${(100 * d.cpu_of_core).toFixed(1)} % of a core, ` +
    `longest turn ${(1000 * d.longest_turn_s).toFixed(1)} ms, up ${(d.uptime_s / 3600).toFixed(2)} h; `);
  by("load").replaceChildren(line, d.kept ? made("span", "all is kept", "good") : made("span", "not kept: " + d.trouble, "alarm"));
}
function alarmRow(a, now) {
  const state = [a.acknowledged_at ? "seen " + time(a.acknowledged_at) : "not acknowledged"];
  if (a.shelved_until && a.shelved_until > now) state.push("shelved until " + time(a.shelved_until));
  if (a.cleared_at) state.push("cleared " + time(a.cleared_at));
  return row([time(a.raised_at), a.machine, made("span", a.alarm, "alarm"), a.links.join(" "), a.text, state.join("; ")]);
}
const alarmHeads = ["raised", "machine", "alarm", "links", "", "state"];
function showMachines(d) {
  const rows = d.machines.map(m => {
    const found = m.estimates.filter(e => e.settled !== null).map(e => `${e.link} ${compliance(e.settled)} (${e.set})`);
    found.push(...m.netlist.map(n => `netlist: ${n.text.split("\n")[0]} (${n.set})`));
    const said = m.verdicts.map(v => `${v.link} ${v.verdict}${v.sure && ", "}${v.sure}`);
    const alarms = d.alarms.filter(a => a.machine === m.machine).length;
    const tr = row([m.machine, m.configuration ?? "", String(m.samples), said.join("; "), found.join(", "),
      alarms ? made("span", String(alarms), "alarm") : ""]);
    tr.classList.add("machine");
    if (m.machine === chosen) tr.classList.add("chosen");
    tr.onclick = () => { chosen = m.machine; refresh(); };
    return tr;
  });
  by("machines").replaceChildren(table(["machine", "configuration", "samples", "verdicts", `settled compliances [${unit().name}]`, "alarms"],
    rows, "no machine has sent hello yet"));
}
function svg(tag, attributes, text) {
  const element = document.createElementNS("http://www.w3.org/2000/svg", tag);
  for (const [name, value] of Object.entries(attributes)) element.setAttribute(name, value);
  if (text !== undefined) element.textContent = text;
  return element;
}
function mark(kind, x, y, colour) {
  if (kind === "square") return svg("rect", {x: x - 4, y: y - 4, width: 8, height: 8, fill: colour});
  if (kind === "triangle") return svg("path", {d: `M${x - 5} ${y + 4}h10l-5 -9z`, fill: colour});
  return svg("circle", {cx: x, cy: y, r: 4, fill: colour});
}
// Round numbers within the range, as many as there is room for, for compliances and for times.
function ticks(from, to, steps, most = 6) {
  const step = steps.find(s => (to - from) / s <= most) ?? steps.at(-1), all = [];
  for (let i = Math.ceil(from / step - 1e-9); i * step <= to + 1e-9 * step; ++i) all.push(i * step);
  return {all, step};
}
const decimal = Array.from({length: 36}, (_, i) => [1, 2, 5][i % 3] * 10 ** (Math.floor(i / 3) - 6));
const clock = [...decimal.filter(s => s < 5 && s > .0005), 5, 10, 15, 30, 60, 120, 300, 600, 900, 1800, 3600, 7200, 10800, 21600, 43200];
for (let days = 86400; days < 1e10; days *= 2) clock.push(days);
function timeText(at, step) {
  const t = new Date(1000 * at);
  if (step >= 86400) return t.toLocaleDateString();
  const text = t.toLocaleTimeString([], {hour: "2-digit", minute: "2-digit", ...(step < 60 ? {second: "2-digit"} : {}),
    ...(step < 1 ? {fractionalSecondDigits: 3} : {}), hourCycle: "h23"});
  return step >= 7200 ? t.toLocaleDateString([], {day: "numeric", month: "short"}) + " " + text : text;
}
function chart(points, alarms, healthy) {
  const factor = unit().factor;
  points = points.map(p => ({...p, compliance: p.compliance * factor, error: p.error === null ? null : p.error * factor}));
  const w = Math.min(900, by("chart").clientWidth), h = 320, left = 52, right = 84, top = 14, bottom = 34;
  const low = p => p.compliance - (p.error ?? 0), high = p => p.compliance + (p.error ?? 0);
  let from = Math.min(...points.map(p => p.at)), to = Math.max(...points.map(p => p.at));
  const margin = Math.max(.5, .03 * (to - from)); // no point is on the frame
  from -= margin; to += margin;
  const links = [...new Set(points.map(p => p.link))].filter(link => healthy[link]), known = links.map(link => healthy[link] * factor);
  const most = 1.1 * Math.max(...points.map(high), ...known), least = Math.min(0, ...points.map(low));
  const x = at => left + (w - left - right) * (at - from) / (to - from);
  const y = c => h - bottom - (h - top - bottom) * (c - least) / (most - least);
  const all = svg("svg", {role: "img"});
  all.append(svg("title", {}, "compliances over time"));
  const cs = ticks(least, most, decimal);
  for (const c of cs.all)
    all.append(svg("line", {x1: left, x2: w - right, y1: y(c), y2: y(c), style: "stroke:var(--line)"}),
      svg("text", {x: left - 6, y: y(c) + 4, "text-anchor": "end"}, c.toFixed(Math.max(0, -Math.floor(Math.log10(cs.step) + 1e-9)))));
  const zone = 60 * new Date(1000 * from).getTimezoneOffset(), times = ticks(from - zone, to - zone, clock, Math.min(6, (w - left - right) / 84));
  for (const local of times.all) {
    const at = local + zone;
    all.append(svg("line", {x1: x(at), x2: x(at), y1: h - bottom, y2: h - bottom + 4, style: "stroke:var(--faint)"}),
      svg("text", {x: x(at), y: h - 12, "text-anchor": "middle"}, timeText(at, times.step)));
  }
  all.append(svg("text", {x: left, y: top - 2}, unit().name));
  for (const a of alarms) if (a.raised_at >= from && a.raised_at <= to)
    all.append(svg("line", {x1: x(a.raised_at), x2: x(a.raised_at), y1: top, y2: h - bottom, style: "stroke:var(--alarm)", "stroke-dasharray": "4 3"}),
      svg("text", {x: x(a.raised_at) + 3, y: top + 10, style: "fill:var(--alarm)"}, a.alarm));
  const names = [...new Set(points.map(p => `${p.link} by ${p.set}`))].sort();
  let place = left, line = h; // position of the next name below the chart
  names.forEach((name, i) => {
    const colour = colours[i % colours.length], kind = marks[i % marks.length];
    const mine = points.filter(p => `${p.link} by ${p.set}` === name).sort((a, b) => a.at - b.at);
    all.append(svg("polyline", {points: mine.map(p => `${x(p.at)},${y(p.compliance)}`).join(" "), fill: "none", stroke: colour}));
    for (const p of mine) {
      if (p.error !== null)
        all.append(svg("path", {d: `M${x(p.at) - 4} ${y(low(p))}h8m-4 0V${y(high(p))}m-4 0h8`, fill: "none", stroke: colour}));
      all.append(mark(kind, x(p.at), y(p.compliance), colour));
    }
    const width = 30 + 8 * name.length;
    if (place > left && place + width > w) { place = left; line += 20; }
    all.append(mark(kind, place + 6, line + 6, colour), svg("text", {x: place + 16, y: line + 10}, name));
    place += width;
  });
  all.setAttribute("viewBox", `0 0 ${w} ${line + 20}`);
  const beside = [];
  links.forEach((link, i) => {
    let at = y(known[i]); // names do not overlap
    while (beside.some(other => Math.abs(other - at) < 12)) at -= 12;
    beside.push(at);
    all.append(svg("line", {x1: left, x2: w - right, y1: y(known[i]), y2: y(known[i]), "stroke-dasharray": "1 4", "stroke-width": 2, style: "stroke:var(--good)"}),
      svg("text", {x: w - right + 6, y: at + 4, style: "fill:var(--good)"}, `${link} in health`));
  });
  return all;
}
async function showPast(now, healthy) {
  by("title").textContent = chosen ? `${chosen}: compliances over time, with their standard errors` : "";
  if (!chosen) { by("chart").replaceChildren(); by("past").replaceChildren(); return; }
  const d = await ask("history?machine=" + encodeURIComponent(chosen));
  by("chart").replaceChildren(d.estimates.length ? chart(d.estimates, d.alarms, healthy)
    : made("p", "no transient has ended yet, or the monitor has no state file", "faint"));
  by("past").replaceChildren(table(alarmHeads, d.alarms.map(a => alarmRow(a, now)), "no alarm so far, or the monitor has no state file"));
}
async function ask(path) {
  const answer = await fetch(path, {cache: "no-store"});
  if (!answer.ok) throw new Error(await answer.text());
  return answer.json();
}
async function refresh() {
  try {
    const d = await ask("snapshot");
    if (chosen === null && d.machines.length) chosen = (d.alarms[0] ?? d.machines[0]).machine;
    showLoad(d);
    by("alarms").replaceChildren(table(alarmHeads, d.alarms.map(a => alarmRow(a, d.at)), "none"));
    showMachines(d);
    await showPast(d.at, d.machines.find(m => m.machine === chosen)?.healthy ?? {});
  } catch (error) {
    by("load").replaceChildren(made("span", "the monitor does not answer: " + error.message, "alarm"));
  }
}
by("si").checked = location.hash === "#si";
by("si").onchange = () => { history.replaceState(null, "", by("si").checked ? "#si" : " "); refresh(); };
refresh();
setInterval(refresh, 2000);
</script>
</body>
</html>
)page";

} // namespace placedpar::monitor
