// The parts of the page that are text, tables and charts: the chosen process, measures, the deadlock, convergence.

const escaped = text => String(text).replace(/[&<>"]/g, each => `&#${each.charCodeAt(0)};`);
// A process without a track, such as a router's process on an infinitely fast processor, gets no link.
const processLink = name => trackNamed.has(outermostName(name)) ? `<a class="to" data-process="${escaped(outermostName(name))}">${escaped(name)}</a>` : escaped(name);

function waitText({ slice, channel, partner }, moment) {
  const who = partner ? processLink(partner) : "none yet";
  const what = channel ? `${slice.doing} ${slice.doing === "outputs" ? "to" : "from"} ${who} on <i>${escaped(channel)}</i>` : describe(slice);
  return `<li>${what}, since ${beginText(slice, lengthInSight())} ${endText(slice, lengthInSight())}</li>`;
}

function stateText(track, moment) {
  const state = stateOfProcess(track, moment);
  const words = { running: "running", ready: "ready: another process has its processor", waiting: "waiting", stuck: "waiting for ever",
    gone: "not there: the process has not begun, or has ended", unknown: "only summarised here: see its share below" };
  return `<b class="${state === "stuck" ? "bad" : ""}">${words[state]}</b>`;
}

function chainText(name, moment) {
  const chain = chainFrom(name, moment);
  if (chain.length < 2) return "";
  return `<p>Chain of waiting processes: ${[name, ...chain.map(([, to]) => to)].map(processLink).join(" &rarr; ")}</p>`;
}

function sharesText(track, from, to) {
  const running = runningShare(track, from, to), all = runningShare(track, run.begin, run.end);
  return `<p>Running ${(100 * running).toFixed(0)} % of the time around this moment, ${(100 * all).toFixed(0)} % of ${run.begin > 0 || run.end < report.time_ps ? "all that is shown" : "the run"}.</p>`;
}

function showChosen(name, moment, from, to) {
  const track = name && trackNamed.get(name), process = processNamed.get(name) || { kind: track && track.kind === "program" ? "a process of the booted program" : "a process of the machine", place: "", line: "", node: "" };
  const panel = d3.select("#chosen");
  if (!track) return panel.html(`<h2>A process</h2><p class="faint">Click a process, in the drawing or on its timeline: this panel shows what the process does at the moment of the slider, which process it waits for, and where the netlist declares it.</p>`);
  const waits = waitsOf(track, moment);
  panel.html(`<h2>${escaped(name)}</h2><p>${escaped(process.kind)}${process.node ? " on " + escaped(process.node) : ""}</p>` +
    `<p>At ${timeText(moment, lengthInSight())}: ${stateText(track, moment)}</p>` +
    (waits.length ? `<ul>${waits.map(wait => waitText(wait, moment)).join("")}</ul>` : "") + chainText(name, moment) + sharesText(track, from, to) +
    (process.place ? `<p class="faint">${escaped(process.place)}</p><pre>${escaped(process.line.trim())}</pre>` : "") + measuresOf(name) +
    (run.lost ? "<p class=\"faint\">The single steps of this process are kept only for the beginning and the end of the run.</p>" : ""));
  panel.selectAll("a.to").on("click", function () { choose(this.dataset.process); });
}

const numberText = value => typeof value === "number" ? Number(value.toPrecision(6)).toString() : escaped(value);
const percent = share => typeof share === "number" ? (100 * share).toFixed(1) + " %" : "";

// Returns the share of the run's time; after a deadlock, which has no such share, the time itself.
const shareText = (share, ps) => typeof share === "number" ? percent(share) : timeText(ps || 0, span);

function waitingText(process) {
  if (process.waits_since_ps === undefined) return percent(process.waiting);
  const since = timeText(process.waits_since_ps, report.time_ps);
  return report.deadlock ? `for ever, from ${since} on` : `${percent(process.waiting)}, the last wait since ${since}`;
}

function tableOf(heading, heads, rows) {
  if (!rows || !rows.length) return "";
  const cell = value => `<td class="${/^[-\d. %]*$/.test(value) ? "number" : ""}">${value}</td>`;
  return `<div><h2>${heading}</h2><table><tr>${heads.map(head => `<th>${head}</th>`).join("")}</tr>` +
    rows.map(row => `<tr>${row.map(cell).join("")}</tr>`).join("") + "</table></div>";
}

function measuresOf(name) {
  const own = (report.measurements || []).filter(each => each.process === name);
  return tableOf("", ["measured", "", ""], own.map(each => [escaped(each.name), numberText(each.value), escaped(each.unit)]));
}

function showMeasures() {
  const rows = (list, row) => (list || []).map(row);
  d3.select("#measures").html("<div class=\"tables\">" +
    tableOf("Measured", ["process", "what", "value", "unit"], rows(report.measurements, each => [processLink(each.process), escaped(each.name), numberText(each.value), escaped(each.unit)])) +
    tableOf("Booted transputers", ["name", "instructions", "requests", "its program"], rows(report.programs, each => [escaped(each.name), each.instructions, each.requests, escaped(each.state)])) +
    tableOf("Processors", ["name", "type", "busy"], rows(report.processors, each => [escaped(each.name), escaped(each.type), shareText(each.busy, each.busy_ps)])) +
    tableOf("Links", ["from", "to", "bytes", "occupied"], rows((report.links || []).filter(each => each.bytes), each => [escaped(each.from), escaped(each.to), each.bytes, shareText(each.occupied, each.occupied_ps)])) +
    tableOf("Processes", ["name", "on", "waiting"], rows(report.processes, each => [processLink(each.name), escaped(each.processor || each.on || ""), waitingText(each)])) + "</div>");
  d3.selectAll("#measures a.to").on("click", function () { choose(this.dataset.process); });
}

// Returns the text that says where slices and messages of a long run are shown one by one.
function extentText() {
  const count = number => d3.format(",")(number), bins = `summarised, in bins of ${timeText(run.bin, run.bin)}`;
  if (!canUnpack) return ` This browser cannot unpack its slices and messages (it has no DecompressionStream): all are ${bins}.`;
  const all = run.deflated ? ` Zoom in to see its ${count(d3.sum(stretches, each => each.entries))} slices and messages one by one.` : "";
  return all + (run.lost ? ` ${count(run.left_out)} more, in the middle of the run, are ${bins}.` : "");
}

// Returns the warning that the timelines show only a part of the run, while tables and curves show the whole run.
function partText() {
  if (run.begin <= 0 && run.end >= report.time_ps) return "";
  const why = run.end < report.time_ps ? ` They end there: ${escaped(run.why)}.` : "";
  if (run.begin >= run.end) return "<b>Nothing of the run</b> is in the timelines and the drawing: the run was over before the part that they show. Tables and curves show the whole run.";
  return `<b>A part of the run</b> is in the timelines and the drawing: from ${run.begin && timeText(run.begin, span)} to ${timeText(run.end, span)}, of ${timeText(report.time_ps, span)}.${why} Tables and curves show the whole run.`;
}

// Returns the text that says how well the clocks of ranks are known.
function clocksText() {
  const clocks = report.clocks || [];
  return clocks.length ? ` Times are by the clock of rank 0; the clocks of the other ranks were compared with it, with an error of at most ${timeText(d3.max(clocks, each => each.error_ps), 1e3)}.` : "";
}

function showOutcome() {
  document.getElementById("heading").textContent = report.manifest.netlist;
  const well = report.outcome === "completed" || report.outcome === "stopped at the time limit";
  d3.select("#outcome").html(`<span class="${well ? "" : "bad"}">${escaped(report.outcome)}</span> at ${timeText(report.time_ps, span)}, ` +
    `seed ${report.manifest.seed}, placedpar ${escaped(report.manifest.version)}.${clocksText()}${extentText()}`);
  const part = partText();
  if (part) d3.select("#part").attr("hidden", null).html(part);
  if (!report.deadlock) return;
  const cycle = report.deadlock.cycle, why = cycle.length ? "Each waits for the next: " + [...cycle, cycle[0]].map(processLink).join(" &rarr; ") : "No processes wait for each other in a cycle: a partner has ended, or there never was a partner.";
  d3.select("#deadlock").attr("hidden", null).html(`<b>Deadlock.</b> ${why}`)
    .selectAll("a.to").on("click", function () { choose(this.dataset.process); });
}

const chart = { width: 460, height: 220, bottom: 34, top: 22, right: 26 }, mostCurves = 12;
const strokes = ["none", "6 3", "2 2", "9 3 2 3"], bands = [[0.05, 0.95, 0.18], [0.25, 0.75, 0.3]];

// Returns, for each generation, the sorted values of all searches, column by column. A search that has ended keeps the
// values of its last generation.
function sortedValues() {
  const generations = d3.set(d3.merge(data.searches.map(search => search.generations.map(row => row[0])))).values().map(Number).sort(d3.ascending);
  const next = data.searches.map(() => 0);
  return generations.map(generation => {
    const rows = data.searches.map(({ generations }, i) => {
      while (next[i] < generations.length && generations[next[i]][0] <= generation) ++next[i];
      return generations[next[i] - 1];
    }).filter(Boolean);
    return [generation, ...[1, 2, 3, 4].map(column => rows.map(row => row[column]).filter(value => value !== null).sort(d3.ascending))];
  });
}

// Returns a quantile of the searches over the generations, in rows like the rows of a search.
const quantileCurves = new Map();
function quantileCurve(part) {
  if (!quantileCurves.has("values")) quantileCurves.set("values", sortedValues());
  if (!quantileCurves.has(part)) quantileCurves.set(part, quantileCurves.get("values").map(([generation, ...columns]) =>
    [generation, ...columns.map(values => values.length ? d3.quantile(values, part) : null)]));
  return quantileCurves.get(part);
}

const areBanded = () => data.searches.length > mostCurves;
const curvesDrawn = () => areBanded() ? [quantileCurve(0.5)] : data.searches.map(search => search.generations);

function drawBands(svg, x, y, column) {
  for (const [low, high, opacity] of bands) {
    const above = quantileCurve(high).filter(row => row[column] !== null), below = quantileCurve(low).filter(row => row[column] !== null);
    const area = d3.area().x(row => x(row[0])).y0(row => y(row[column])).y1((row, i) => y(above[i][column]));
    svg.append("path").attr("class", "band").attr("d", area(below)).attr("fill-opacity", opacity);
  }
}

// Draws a curve for each search, with four patterns of strokes in turn. Many searches are drawn as bands around their
// median, and the chosen search as a curve.
function drawChart(title, label, column) {
  const { width, height, bottom, top, right } = chart;
  const curves = curvesDrawn().map(rows => rows.filter(row => row[column] !== null)).filter(rows => rows.length);
  if (!curves.length) return;
  const values = (areBanded() ? d3.merge([0.05, 0.95].map(quantileCurve)) : d3.merge(curves)).map(row => row[column]).filter(value => value !== null), low = d3.quantile(values.slice().sort(d3.ascending), 0.02);
  const x = d3.scaleLinear().domain([1, d3.max(d3.merge(curves), row => row[0])]).range([0, width - right]);
  const y = d3.scaleLinear().domain([low, d3.max(values)]).nice().range([height - bottom, top]).clamp(true);
  const numbers = y.ticks(5).map(numberText), left = Math.max(30, 16 + 6.5 * d3.max(numbers, each => each.length));
  x.range([left, width - right]);
  const svg = d3.select("#convergence .charts").append("svg").attr("viewBox", `0 0 ${width} ${height}`).attr("width", width);
  svg.append("text").attr("x", left).attr("y", 12).attr("font-weight", "bold").text(title);
  svg.append("g").attr("transform", `translate(0 ${height - bottom})`).call(d3.axisBottom(x).ticks(6));
  svg.append("g").attr("transform", `translate(${left} 0)`).call(d3.axisLeft(y).ticks(5).tickFormat(numberText));
  svg.append("text").attr("x", width - right).attr("y", height - 4).attr("text-anchor", "end").text(label);
  const line = d3.line().x(row => x(row[0])).y(row => y(row[column]));
  if (areBanded()) drawBands(svg, x, y, column);
  svg.selectAll(".curve").data(curves).enter().append("path").attr("class", "curve").attr("d", line).attr("fill", "none")
    .attr("stroke", (rows, i) => d3.schemeDark2[i % 8]).attr("stroke-width", 1.5).attr("stroke-dasharray", (rows, i) => strokes[i % 4]);
  if (areBanded()) svg.append("path").attr("class", "chosen-curve").attr("fill", "none").attr("stroke", colours.path).attr("stroke-width", 1.5)
    .each(function () { this.dataOf = rows => line(rows.filter(row => row[column] !== null)); });
  svg.selectAll(".moment").data(curves).enter().append("circle").attr("class", "moment").attr("r", 4).attr("fill", "#fff").attr("stroke", "#16202a")
    .attr("stroke-width", 1.6).each(function (rows) { Object.assign(this, { rows, place: row => [x(row[0]), y(row[column])] }); });
}

function showConvergence() {
  if (!data.searches.some(search => search.generations.length)) return;
  d3.select("#convergence").html(`<h2>Convergence</h2><p id="curves"></p><div class="charts"></div>`);
  const band = opacity => `<svg width="34" height="10"><rect width="28" height="10" fill="#1f4e79" fill-opacity="${opacity}"/></svg>`;
  if (areBanded()) d3.select("#curves").html(`Of ${data.searches.length} searches: <svg width="34" height="8"><path d="M0 4 L28 4" stroke="${d3.schemeDark2[0]}" stroke-width="2"/></svg>the median &nbsp; ` +
    `${band(0.45)}half of them &nbsp; ${band(0.18)}nine of ten &nbsp; <svg width="34" height="8"><path d="M0 4 L28 4" stroke="${colours.path}" stroke-width="2"/></svg>the chosen process`);
  else d3.select("#curves").selectAll("span").data(data.searches).enter().append("span").html((search, i) =>
    `<svg width="34" height="8"><path d="M0 4 L28 4" stroke="${d3.schemeDark2[i % 8]}" stroke-width="2" stroke-dasharray="${strokes[i % 4]}"/></svg>${processLink(search.name)} &nbsp; `);
  const what = data.searches.some(search => search.objective) ? "objective" : "fitness";
  drawChart(`Best ${what} so far`, "generation", 2);
  drawChart(`Mean ${what}`, "generation", 3);
  drawChart("Diversity: mean distance / greatest", "generation", 4);
  d3.selectAll("#convergence a.to").on("click", function () { choose(this.dataset.process); });
}

// Marks the generations of the searches at a moment. Among many searches, shows the curve of the chosen search.
function markGenerations(moment, chosen) {
  const search = data.searches.find(each => outermostName(each.name) === chosen);
  d3.selectAll("#convergence .chosen-curve").attr("d", function () { return search ? this.dataOf(search.generations) : null; });
  d3.selectAll("#convergence .moment").each(function () {
    const done = this.rows.filter(row => row[1] !== null && row[1] <= moment), last = done[done.length - 1];
    d3.select(this).attr("visibility", last ? "visible" : "hidden");
    if (last) d3.select(this).attr("cx", this.place(last)[0]).attr("cy", this.place(last)[1]);
  });
}
