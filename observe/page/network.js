// The drawn network: loads and states at a moment, the chosen process, what it waits for, and a deadlock's cycle.

const pictures = ["machine", "software"].map(view => ({ view, svg: d3.select("#" + view + " > svg") })).filter(each => !each.svg.empty());
const loadColour = d3.interpolateRgb("#ffffff", "#8db7dd"), heatColour = d3.interpolateRgb("#f4f6f8", "#0b3a66"), wireColour = d3.interpolateRgb("#8da2b5", "#1f4e79");
const largePicture = 200, legible = 0.45; // a picture with this many nodes is a map of loads, with texts only above this scale
const drawnProcess = name => name.replace(/ !$/, ""); // " !" marks high priority

// Puts everything that is drawn into one group, so that zooming moves all of it.
function wrapPicture(picture) {
  const svg = picture.svg, all = document.createElementNS("http://www.w3.org/2000/svg", "g");
  svg.attr("width", null).attr("height", null);
  while (svg.node().firstChild) all.appendChild(svg.node().firstChild);
  svg.node().appendChild(all);
  picture.all = d3.select(all);
  picture.large = all.querySelectorAll("g.node").length >= largePicture;
  const extent = svg.node().viewBox.baseVal, fit = svg.node().getBoundingClientRect();
  picture.scale = Math.min(fit.width / extent.width, fit.height / extent.height);
  svg.call(d3.zoom().scaleExtent([0.3, Math.max(20, 2 / picture.scale)]).on("zoom", () => zoomPicture(picture, d3.event.transform)));
  picture.over = picture.all.append("g");
  all.querySelectorAll(":scope > .link, :scope > .channels").forEach(label => all.appendChild(label)); // labels are above the arrows
  zoomPicture(picture, d3.zoomIdentity);
  addDefinitions(svg, picture.view);
}

// A large network is a map of loads without texts until the user zooms in far enough to read the texts.
function zoomPicture(picture, transform) {
  picture.all.attr("transform", transform);
  const far = picture.large && transform.k * picture.scale < legible, changed = far !== picture.far;
  picture.far = far;
  picture.svg.classed("far", far);
  if (changed && picture.meters) showMoment();
}

function addDefinitions(svg, view) {
  const definitions = svg.append("defs");
  const hatched = definitions.append("pattern").attr("id", "hatched").attr("width", 4).attr("height", 4).attr("patternUnits", "userSpaceOnUse").attr("patternTransform", "rotate(45)");
  hatched.append("rect").attr("width", 4).attr("height", 4).attr("fill", "#fff");
  hatched.append("rect").attr("width", 2).attr("height", 4).attr("fill", "#d98a1f");
  for (const [name, colour] of [["cycle", "#b3261e"], ["now", "#16202a"]])
    definitions.append("marker").attr("id", `${view}-${name}`).attr("viewBox", "0 0 10 10").attr("refX", 9).attr("refY", 5)
      .attr("markerUnits", "userSpaceOnUse").attr("markerWidth", 16).attr("markerHeight", 16).attr("orient", "auto-start-reverse")
      .append("path").attr("d", "M0 0 L10 5 L0 10 Z").attr("fill", colour);
}

// Returns the track of a node: of its processor in the view of the machine, of its process in the view of the software.
function trackOfNode(view, name) {
  return view === "machine" ? trackNamed.get("processor " + name) || trackNamed.get(name) : trackNamed.get(drawnProcess(name));
}

function addMeter({ view, large }, element) {
  const node = d3.select(element), track = trackOfNode(view, node.attr("data-node"));
  if (!track) return null;
  node.on("click", () => choose(view === "software" ? track.name : firstProcessOn(track.node)));
  if (large) return { track, frame: node.select(".frame") };
  const box = element.getBBox();
  const meter = { track, frame: node.select(".frame"), width: box.width, isProcess: isOfProcess(track) };
  node.append("rect").attr("class", "load-frame").attr("x", box.x).attr("y", box.y + box.height - 6).attr("width", box.width).attr("height", 6);
  meter.bar = node.append("rect").attr("class", "load").attr("x", box.x).attr("y", box.y + box.height - 6).attr("height", 6);
  meter.percent = node.append("text").attr("class", "percent").attr("x", box.x + box.width + 3).attr("y", box.y + box.height).text("100 %"); // the longest text, for the space that it needs
  if (meter.isProcess) meter.sign = addSign(node, box.x + 5, box.y + 5);
  return meter;
}

// Widens the drawing if the percentage beside its last box would be cut off.
function makeRoomForShares({ svg, meters }) {
  const extent = svg.node().viewBox.baseVal, shares = meters.filter(each => each.percent).map(each => each.percent.node().getBBox());
  extent.width = Math.max(extent.width, d3.max(shares, box => box.x + box.width - extent.x + 2) || 0);
}

function addSign(parent, x, y) {
  return parent.append("rect").attr("class", "state").attr("x", x).attr("y", y).attr("width", 9).attr("height", 9);
}

function firstProcessOn(node) {
  const track = drawnTracks.find(each => each.node === node && each.kind === "process");
  return track ? track.name : null;
}

function addProcessSign({ large }, element) {
  const placed = d3.select(element), track = trackNamed.get(placed.attr("data-process"));
  if (!track) return null;
  placed.on("click", () => choose(track.name));
  if (large) return null;
  const box = element.getBBox();
  return { track, sign: addSign(placed, box.x - 10.5, box.y + box.height / 2 - 4.5) };
}

function addWire(view, element) {
  const [a, b] = element.getAttribute("data-wire").split(" - ");
  return { a: drawnProcess(a), b: drawnProcess(b), path: d3.select(element), data: element.getAttribute("d"),
    directions: view === "machine" ? [`${a} -> ${b}`, `${b} -> ${a}`].map(name => trackNamed.get(name)).filter(Boolean) : [] };
}

function makePicture(picture) {
  const element = document.getElementById(picture.view), hidden = element.hidden;
  element.hidden = false; // a hidden element has no size
  wrapPicture(picture);
  const found = selector => picture.all.selectAll(selector).nodes();
  picture.meters = found("g.node[data-node]").map(node => addMeter(picture, node)).filter(Boolean);
  makeRoomForShares(picture);
  found(".texts").forEach(texts => { texts.style.pointerEvents = picture.view === "software" ? "none" : null; });
  picture.signs = found(".placed").map(placed => addProcessSign(picture, placed)).filter(Boolean);
  picture.wires = found("path.wire[data-wire]").map(wire => addWire(picture.view, wire));
  element.hidden = hidden;
}

// Returns the share of a track's running time; for a process, with all components of its PARs.
const runningShare = (track, from, to) => shareOf(sumsTogether(track, "running"), from, to);

function showMeter(meter, moment, from, to, far) {
  const share = runningShare(meter.track, from, to);
  if (!meter.bar) return meter.frame.style("fill", (far ? heatColour : loadColour)(share));
  meter.bar.attr("width", meter.width * share);
  meter.percent.text(Math.round(100 * share) + " %");
  meter.frame.style("fill", loadColour(share));
  if (meter.sign) meter.sign.attr("class", "state " + stateOfProcess(meter.track, moment));
}

function showWire(wire, from, to) {
  if (!wire.directions.length) return;
  const share = d3.max(wire.directions, track => shareOf(track.running, from, to));
  wire.path.style("stroke-width", 1.6 + 6 * share).style("stroke", wireColour(Math.sqrt(share)));
}

function drawArrow(picture, from, to, kind) {
  const wire = picture.wires.find(each => (each.a === from && each.b === to) || (each.a === to && each.b === from));
  if (!wire) return;
  picture.over.append("path").attr("class", "arrow " + kind).attr("d", wire.data)
    .attr(wire.a === from ? "marker-end" : "marker-start", `url(#${picture.view}-${kind})`);
}

function cycleLinks() {
  const cycle = ((report.deadlock || {}).cycle || []).map(outermostName);
  return cycle.map((name, i) => [name, cycle[(i + 1) % cycle.length]]).filter(([a, b]) => a !== b);
}

function drawChosenBox(picture, name) {
  const node = picture.all.selectAll("g.node[data-node], g.placed").nodes().find(each =>
    drawnProcess(each.getAttribute("data-node") || each.getAttribute("data-process")) === name);
  if (!node) return;
  const box = (node.querySelector(".frame") || node).getBBox();
  picture.over.append("rect").attr("class", "chosen-box").attr("x", box.x - 3).attr("y", box.y - 3).attr("width", box.width + 6).attr("height", box.height + 6).attr("rx", 4);
}

function drawOver(picture, moment, name) {
  picture.over.selectAll("*").remove();
  if (name) drawChosenBox(picture, name);
  if (picture.view !== "software") return;
  const cycle = moment >= run.end ? cycleLinks() : [], isInCycle = ([from, to]) => cycle.some(each => each[0] === from && each[1] === to);
  cycle.forEach(([from, to]) => drawArrow(picture, from, to, "cycle"));
  if (name) chainFrom(name, moment).filter(link => !isInCycle(link)).forEach(([from, to]) => drawArrow(picture, from, to, "now"));
}

function showNetwork(moment, from, to, name) {
  for (const picture of pictures) {
    picture.meters.forEach(meter => showMeter(meter, moment, from, to, picture.far));
    picture.signs.forEach(({ track, sign }) => sign.attr("class", "state " + stateOfProcess(track, moment)));
    if (!picture.far) picture.wires.forEach(wire => showWire(wire, from, to));
    drawOver(picture, moment, name);
  }
}

function showView(view) {
  if (!pictures.some(each => each.view === view)) view = "machine";
  for (const each of ["machine", "software"]) document.getElementById(each).hidden = each !== view;
  d3.selectAll("#views button").classed("on", function () { return this.dataset.view === view; });
}
