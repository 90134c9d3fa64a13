// The page as a whole: the moment at the slider, the chosen process, and the parts of the page that show them.

const now = { moment: run.begin, chosen: null, timer: null };
const views = ["machine", "software"], slider = document.getElementById("slider"), steps = Number(slider.max);

// Returns the interval around a moment over which loads are shown: a fortieth of the interval in the timelines.
function around(moment) {
  const [from, to] = view.scale.domain(), half = Math.max((to - from) / 80, run.bin / 2);
  const begin = Math.max(run.begin, Math.min(moment - half, run.end - 2 * half));
  return [begin, Math.min(run.end, begin + 2 * half)];
}

function showMoment() {
  lookInto(now.moment, ...view.scale.domain(), showMoment);
  const [from, to] = around(now.moment);
  document.getElementById("now").textContent = timeText(now.moment, lengthInSight());
  showNetwork(now.moment, from, to, now.chosen);
  showChosen(now.chosen, now.moment, from, to);
  markGenerations(now.moment, now.chosen);
  drawTimelines(now.moment, now.chosen);
}

function goTo(moment) {
  now.moment = Math.max(run.begin, Math.min(moment, run.end));
  slider.value = Math.round((now.moment - run.begin) / span * steps);
  showMoment();
}

function choose(name) {
  now.chosen = name && trackNamed.has(outermostName(name)) ? outermostName(name) : null;
  showMoment();
}

// Makes a step of the animation: a two-hundredth of the interval in the timelines.
function advance() {
  if (looked.unpacks) return;
  const [from, to] = view.scale.domain();
  goTo(now.moment + (to - from) / 200);
  if (now.moment >= Math.min(run.end, to)) stopPlaying();
}

function stopPlaying() {
  clearInterval(now.timer);
  now.timer = null;
}

function play() {
  if (now.timer) return stopPlaying();
  const [from, to] = view.scale.domain();
  if (now.moment < from || now.moment >= Math.min(to, run.end)) goTo(from);
  now.timer = setInterval(advance, 60);
}

const zoom = d3.zoom().scaleExtent([1, Math.max(1, span / 100)])
  .filter(() => d3.event.type === "wheel" ? d3.event.ctrlKey || d3.event.metaKey : !d3.event.button)
  .on("zoom", () => { view.scale = d3.event.transform.rescaleX(view.full); showMoment(); });

function lookAt(from, to) {
  const scale = (whole[1] - whole[0]) / (to - from), left = view.full.range()[0];
  d3.select(canvas).call(zoom.transform, d3.zoomIdentity.translate(left - scale * view.full(from), 0).scale(scale));
}

// D3's zoom is in pixels, so it must change with the width to keep the same moments in sight.
function resize() {
  const [from, to] = view.scale.domain();
  fitCanvas();
  zoom.extent([[view.label, 0], [view.width - 12, view.height]]).translateExtent([[view.label, 0], [view.width - 12, view.height]]);
  lookAt(from, to);
}

function addLaneChoices() {
  const lanes = d3.select("#lanes");
  lanes.append("input").attr("type", "search").attr("id", "search").attr("placeholder", "search a row").attr("aria-label", "search a row")
    .on("input", function () { view.sought = this.value; arrangeRows(); resize(); })
    .on("change", function () { const found = view.rows.find(row => row.track && isOfProcess(row.track)); if (this.value && found) choose(found.track.name); });
  for (const name of Object.keys(shown))
    lanes.append("label").text(" " + name).insert("input", ":first-child").attr("type", "checkbox").property("checked", shown[name])
      .on("change", function () { shown[name] = this.checked; arrangeRows(); resize(); });
  const scaled = by => () => zoom.scaleBy(d3.select(canvas), by, [view.scale(now.moment), 0]);
  for (const [text, act] of [["+", scaled(3)], ["\u2212", scaled(1 / 3)], ["all", () => d3.select(canvas).call(zoom.transform, d3.zoomIdentity)]])
    lanes.append("button").text(text).on("click", act);
  lanes.append("span").attr("class", "faint").text("Ctrl and the wheel zoom, dragging moves, a click chooses, a double click zooms in");
}

function addKey() {
  const sign = (state, text) => `<svg class="key-sign" viewBox="0 0 22 12">${state}</svg> ${text} &nbsp; `;
  document.getElementById("key").innerHTML =
    sign(`<rect width="20" height="12" fill="${colours.running}"/>`, "running") +
    sign(`<defs><pattern id="key-hatched" width="4" height="4" patternUnits="userSpaceOnUse" patternTransform="rotate(45)"><rect width="4" height="4" fill="#fff"/><rect width="2" height="4" fill="${colours.ready}"/></pattern></defs><rect y="4" width="20" height="8" fill="url(#key-hatched)"/>`, "ready") +
    sign(`<rect y="9" width="20" height="2" fill="${colours.waiting}"/>`, "waiting") +
    (report.deadlock ? sign(`<rect y="8" width="20" height="3" fill="${colours.stuck}"/><path d="M7 6 L13 12 M7 12 L13 6" stroke="${colours.stuck}" stroke-width="1.4"/>`, "waiting for ever") : "") +
    sign(`<rect width="20" height="12" fill="${colours.link}"/>`, "bytes on a link") +
    (pictures.some(each => each.large) ? sign(`<defs><linearGradient id="key-heat"><stop stop-color="${heatColour(0)}"/><stop offset="1" stop-color="${heatColour(1)}"/></linearGradient></defs><rect width="20" height="12" fill="url(#key-heat)"/>`, "load, from 0 to 100 %: zoom in for names") : "") +
    (path.length ? sign(`<rect y="4" width="20" height="3" fill="${colours.path}"/>`, "critical path") : "");
}

function listen() {
  slider.addEventListener("input", () => goTo(run.begin + slider.value / steps * span));
  document.getElementById("play").addEventListener("click", play);
  d3.selectAll("#views button").on("click", function () { showView(this.dataset.view); });
  scroller.addEventListener("scroll", () => drawTimelines(now.moment, now.chosen));
  window.addEventListener("resize", resize);
  window.addEventListener("hashchange", followAddress);
  d3.select(canvas).call(zoom)
    .on("mousemove.under", () => { document.getElementById("under").textContent = textAt(placeAt(d3.mouse(canvas))); })
    .on("click", () => {
      const { track, moment } = placeAt(d3.mouse(canvas));
      if (track && isOfProcess(track)) now.chosen = outermostName(track.name);
      if (track && moment === null && isFoldable(track)) { fold(track); resize(); }
      goTo(moment === null ? now.moment : moment);
    });
}

const numbersSaid = ["at", "from", "to"];

// Shows an error for each part of the address that the page cannot follow.
function sayWhatIsUnknown(said) {
  const faults = [];
  if (views.includes(said.get("view")) && !pictures.some(each => each.view === said.get("view"))) faults.push(`This page has no drawing for the view "${said.get("view")}".`);
  if (said.has("view") && !views.includes(said.get("view"))) faults.push(`There is no view "${said.get("view")}": write view=machine or view=software.`);
  if (said.has("process") && !trackNamed.has(outermostName(said.get("process")))) faults.push(`No process of this page is called "${said.get("process")}".`);
  for (const name of numbersSaid) if (said.has(name) && !(said.get(name) !== "" && Number(said.get(name)) >= 0 && Number(said.get(name)) <= 1)) faults.push(`"${said.get(name)}" is not a part of the run: write ${name}=NUMBER with a number from 0 to 1.`);
  for (const name of said.keys()) if (![...numbersSaid, "view", "process"].includes(name)) faults.push(`The address contains "${name}", which the page does not know: it knows view, process, at, from and to.`);
  d3.select("#address").attr("hidden", faults.length ? null : "").text(faults.join(" "));
}

// Scrolls to the row of a process.
function bringIntoView(name) {
  const track = name && trackNamed.get(name), row = track ? view.rowOf.get(track.number) : undefined;
  if (row === undefined) return;
  scroller.scrollTop = headHeight + row * rowHeight - view.height / 2;
  scroller.scrollIntoView({ block: "nearest" });
}

function addJumps() {
  const to = (id, text) => document.getElementById(id).childElementCount ? [[id, text]] : [];
  d3.select("#jumps").selectAll("a").data([...to("measures", "Results"), ...to("convergence", "Convergence")]).enter()
    .append("a").attr("class", "to").attr("tabindex", 0).text(each => each[1]).on("click", ([id]) => document.getElementById(id).scrollIntoView());
}

// Shows what the address selects: run.html#at=0.5&process=master[0]&view=software&from=0.2&to=0.3. Times are fractions
// of the run.
function followAddress() {
  const said = new URLSearchParams(location.hash.slice(1));
  sayWhatIsUnknown(said);
  if (views.includes(said.get("view"))) showView(said.get("view"));
  if (said.has("process")) {
    choose(said.get("process"));
    bringIntoView(now.chosen);
  }
  const isSaid = name => said.has(name) && Number.isFinite(Number(said.get(name)));
  if (isSaid("from") && isSaid("to")) {
    const from = Number(said.get("from")), to = Math.max(Number(said.get("to")), from + 1e-9), momentAt = part => whole[0] + part * (whole[1] - whole[0]);
    lookAt(momentAt(from), momentAt(to));
  }
  if (!isSaid("at")) return;
  goTo(run.begin + Number(said.get("at")) * span); // more exact than the slider, which has 10,000 steps
}

function begin() {
  pictures.forEach(makePicture);
  if (!pictures.length) document.getElementById("machine").innerHTML = "<p>The network is too large to be drawn here.</p>";
  d3.selectAll("#views button").attr("hidden", function () { return pictures.some(each => each.view === this.dataset.view) ? null : ""; });
  showView(report.deadlock && pictures.length > 1 ? "software" : "machine");
  addKey();
  addLaneChoices();
  showOutcome();
  showMeasures();
  showConvergence();
  addJumps();
  arrangeRows();
  listen();
  resize();
  goTo(report.deadlock ? run.end : run.begin + span / 2);
  followAddress();
  document.documentElement.dataset.loaded = "yes";
}

begin();
