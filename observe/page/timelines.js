// The timelines: a row for each track. The canvas shows the rows and the interval that are in sight.

const rowHeight = 17, headHeight = 22, most = { messages: 4000 };
const colours = { path: "#d6006c", running: "#1f4e79", ready: "#d98a1f", waiting: "#9aa7b4", stuck: "#b3261e", link: "#2f7d6b" };
const canvas = document.getElementById("canvas"), pen = canvas.getContext("2d"), scroller = document.getElementById("scroller");
const shown = { processors: true, processes: true, components: false, links: true, messages: true };
if (path.length) shown["critical path"] = true;
const whole = [run.begin, run.begin + span + drawnEnd - run.end];
const view = { label: 210, wanted: 210, sought: "", unfolded: new Set(), width: 0, height: 0, full: d3.scaleLinear().domain(whole), scale: d3.scaleLinear().domain(whole), rows: [], rowOf: new Map() };

// States can be distinguished without colour: running is full and dark, ready is half as high and hatched, waiting is a
// thin line.
const hatch = (() => {
  const tile = document.createElement("canvas"), line = tile.getContext("2d");
  tile.width = tile.height = 6;
  line.fillStyle = "#fff";
  line.fillRect(0, 0, 6, 6);
  line.strokeStyle = colours.ready;
  line.lineWidth = 2.4;
  for (const x of [-6, 0, 6]) { line.beginPath(); line.moveTo(x, 6); line.lineTo(x + 6, 0); line.stroke(); }
  return pen.createPattern(tile, "repeat");
})();

function isShown(track) {
  if (track.kind === "processor" || track.kind === "bus") return shown.processors;
  if (track.kind === "link") return shown.links && track.running.length > 1;
  return shown.processes && (track.outermost === track.number || isUnfolded(track.outermost));
}

// The components of a PAR are drawn in the row of their process, or, if the process is unfolded, in rows of their own.
const isUnfolded = number => shown.components || view.unfolded.has(number);
const isFoldable = track => track.outermost === track.number && (componentsOf[track.number] || []).length > 1;
const foldedIn = track => isFoldable(track) && !isUnfolded(track.number) ? componentsOf[track.number].filter(each => each !== track) : [];
const lanesOf = track => [track, ...foldedIn(track)];
const rowShare = (track, what, from, to) => shareOf(isUnfolded(track.number) ? track[what] : sumsTogether(track, what), from, to);
const isSought = track => (view.sought === "" ? true : `${track.name} ${run.nodes[track.node]}`.toLowerCase().includes(view.sought.toLowerCase()));

function fold(track) {
  if (!view.unfolded.delete(track.number)) view.unfolded.add(track.number);
  arrangeRows();
}

function arrangeRows() {
  view.rows = [];
  view.rowOf.clear();
  let node = -1;
  for (const track of drawnTracks.filter(each => isShown(each) && isSought(each))) {
    if (track.node !== node) view.rows.push({ heading: run.nodes[node = track.node] });
    view.rowOf.set(track.number, view.rows.length);
    foldedIn(track).forEach(each => view.rowOf.set(each.number, view.rows.length));
    view.rows.push({ track });
  }
  pen.font = "11px Helvetica, Arial, sans-serif";
  view.wanted = 20 + Math.max(80, d3.max(view.rows, row => pen.measureText(row.heading || labelOf(row.track)).width) || 0);
  document.getElementById("spacer").style.height = headHeight + view.rows.length * rowHeight + "px";
}

function fitCanvas() {
  const ratio = window.devicePixelRatio || 1;
  view.height = Math.min(headHeight + view.rows.length * rowHeight, Math.max(260, Math.round(window.innerHeight * 0.55)));
  scroller.style.height = view.height + 2 + "px"; // set before the width is read, since the height decides whether there is a scrollbar
  view.width = Math.max(scroller.clientWidth, 240);
  view.label = Math.min(view.wanted, Math.round(view.width * 0.4));
  canvas.width = view.width * ratio;
  canvas.height = view.height * ratio;
  canvas.style.width = view.width + "px";
  canvas.style.height = view.height + "px";
  pen.setTransform(ratio, 0, 0, ratio, 0, 0);
  view.full.range([view.label, view.width - 12]);
}

const lengthInSight = () => view.scale.domain()[1] - view.scale.domain()[0];
const topOf = row => headHeight + row * rowHeight - scroller.scrollTop;

function drawText(text, x, y, colour, width) {
  pen.fillStyle = colour;
  if (width === undefined || pen.measureText(text).width < width) pen.fillText(text, x, y);
}

function drawWait(slice, x, y, width) {
  const stuck = stateOf(slice) === "stuck";
  pen.fillStyle = stuck ? colours.stuck : colours.waiting;
  if (slice.doing === "delayed") for (let at = x; at < x + width; at += 5) pen.fillRect(at, y + 12, 2, 2);
  else pen.fillRect(x, y + (stuck ? 11 : 12), Math.max(width, 0.3), stuck ? 3 : 1.5);
  if (stuck) for (let at = x + 8; at < x + width; at += 14) drawCross(at, y + 12.5);
  if (width > 90 && slice.doing !== "joins") drawText(describe(slice), x + 4, y + 9, stuck ? colours.stuck : "#5a6876", width - 8);
}

function drawCross(x, y) {
  pen.strokeStyle = colours.stuck;
  pen.lineWidth = 1.4;
  pen.beginPath();
  pen.moveTo(x - 3, y - 3); pen.lineTo(x + 3, y + 3);
  pen.moveTo(x - 3, y + 3); pen.lineTo(x + 3, y - 3);
  pen.stroke();
}

// Returns the text; if it is too long, its beginning and its end with an ellipsis in between.
function shortened(text, width) {
  if (pen.measureText(text).width <= width) return text;
  let kept = text.length - 1;
  const short = () => text.slice(0, Math.ceil(kept / 2)) + "\u2026" + text.slice(text.length - Math.floor(kept / 2));
  while (kept > 2 && pen.measureText(short()).width > width) --kept;
  return short();
}

function drawSlice(track, slice, from, to) {
  const x = view.scale(Math.max(slice.begin, from)), width = view.scale(Math.min(slice.end, to)) - x, y = topOf(view.rowOf.get(track.number));
  const state = stateOf(slice);
  if (state === "running") {
    pen.fillStyle = track.kind === "link" ? colours.link : colours.running;
    pen.fillRect(x, y + 2, Math.max(width, 0.3), rowHeight - 4);
    if (width > 40 && slice.note) drawText(slice.note, x + 4, y + 12.5, "#fff", width - 6);
  } else if (state === "ready") {
    pen.fillStyle = width < 2 ? colours.ready : hatch;
    pen.fillRect(x, y + 7, Math.max(width, 0.3), 7);
  } else if (!foldedAway(track)) drawWait(slice, x, y, width);
}

// In the row of their process, folded components are drawn only while they compute or are ready, not while they wait.
const foldedAway = track => track.kind === "process" && track.outermost !== track.number && !isUnfolded(track.outermost);

// Draws in each column of pixels the share of running time and, above it, of ready time, including folded components.
function drawShares(track, from, to) {
  const y = topOf(view.rowOf.get(track.number)), high = rowHeight - 4;
  const x0 = Math.max(view.scale(from), view.label), x1 = Math.min(view.scale(to), view.width);
  if (isOfProcess(track)) { pen.fillStyle = colours.waiting; pen.fillRect(x0, y + 13, x1 - x0, 1); }
  for (let x = x0; x < x1; ++x) {
    const begin = view.scale.invert(x), end = view.scale.invert(Math.min(x + 1, x1));
    const running = rowShare(track, "running", begin, end) * high, ready = Math.min(rowShare(track, "ready", begin, end) * high, high - running);
    pen.fillStyle = track.kind === "link" ? colours.link : colours.running;
    pen.fillRect(x, y + 2 + high - running, 1, running);
    pen.fillStyle = hatch;
    pen.fillRect(x, y + 2 + high - running - ready, 1, ready);
  }
}

// Draws the slices of a piece if they are unpacked and not too many, otherwise shares.
function drawPiece(track, from, to, known) {
  const most = (view.scale(to) - view.scale(from)) / 1.5 + 3, slices = [];
  for (const lane of known ? lanesOf(track) : [])
    for (let i = sliceFrom(lane, from); i < lane.slices.length && lane.slices[i].begin < to && slices.length <= most; ++i) slices.push([lane, lane.slices[i]]);
  if (!known || slices.length > most) return drawShares(track, from, to);
  for (const [lane, slice] of slices) drawSlice(lane, slice, from, to);
}

function labelOf(track) {
  if (track.kind === "processor") return "processor";
  if (isFoldable(track)) return (isUnfolded(track.number) ? "\u25be " : "\u25b8 ") + track.name;
  return track.outermost === track.number ? track.name : "   " + track.name.slice(track.name.indexOf("/"));
}

function drawLabel(row, y, chosen) {
  pen.fillStyle = "#fff";
  pen.fillRect(0, y, view.label - 4, rowHeight);
  if (row.heading) {
    pen.font = "bold 11px Helvetica, Arial, sans-serif";
    drawText(shortened(row.heading, view.label - 12), 4, y + 13, "#16202a");
    pen.font = "11px Helvetica, Arial, sans-serif";
    return;
  }
  const isChosen = isOfProcess(row.track) && outermostName(row.track.name) === chosen;
  if (isChosen) { pen.fillStyle = "#dfe8f1"; pen.fillRect(6, y + 1, view.label - 12, rowHeight - 2); }
  drawText(shortened(labelOf(row.track), view.label - 18), 12, y + 12.5, isOfProcess(row.track) ? "#16202a" : "#5a6876");
}

function visibleMessages() {
  const [from, to] = view.scale.domain(), some = [];
  for (let i = byLeft(messages, from - (to - from)); i < messages.length && messages[i].left < to && some.length <= most.messages; ++i)
    if (messages[i].arrived > from && view.rowOf.has(messages[i].from) && view.rowOf.has(messages[i].to)) some.push(messages[i]);
  return some.length > most.messages ? [] : some;
}

function drawMessage(message, strong) {
  const y0 = topOf(view.rowOf.get(message.from)) + rowHeight / 2, y1 = topOf(view.rowOf.get(message.to)) + rowHeight / 2;
  if (Math.max(y0, y1) < headHeight || Math.min(y0, y1) > view.height) return;
  const x0 = view.scale(message.left), x1 = view.scale(message.arrived), angle = Math.atan2(y1 - y0, x1 - x0);
  pen.globalAlpha = strong ? 1 : 0.45;
  pen.strokeStyle = pen.fillStyle = "#000";
  pen.lineWidth = strong ? 1.6 : 0.8;
  pen.beginPath(); pen.moveTo(x0, y0); pen.lineTo(x1, y1); pen.stroke();
  pen.beginPath(); pen.moveTo(x1, y1);
  for (const side of [-0.4, 0.4]) pen.lineTo(x1 - 7 * Math.cos(angle + side), y1 - 7 * Math.sin(angle + side));
  pen.fill();
  pen.globalAlpha = 1;
}

function drawMessages(chosen) {
  if (!shown.messages) return;
  const some = visibleMessages();
  if (some.length > view.width / 2 && !chosen) return; // so many arrows would cover everything
  for (const message of some) {
    const strong = [message.from, message.to].some(number => outermostName(tracks[number].name) === chosen);
    if (strong || some.length <= view.width / 2) drawMessage(message, strong);
  }
}

// Draws the critical path as one line from the beginning of the run to its end.
function drawPath() {
  if (!shown["critical path"]) return;
  const [from, to] = view.scale.domain(), middle = part => topOf(view.rowOf.get(part.track)) + rowHeight / 2;
  pen.strokeStyle = colours.path;
  pen.lineWidth = 2.4;
  pen.lineJoin = "round";
  pen.beginPath();
  let begun = false;
  for (let i = byPathEnd(path, from); i < path.length && path[i].begin <= to; ++i) {
    if (!view.rowOf.has(path[i].track)) continue;
    pen[begun ? "lineTo" : "moveTo"](view.scale(path[i].begin), middle(path[i]));
    pen.lineTo(view.scale(path[i].end), middle(path[i]));
    begun = true;
  }
  pen.stroke();
}

// Returns the part of the critical path that is on the track at a moment; null if there is none.
function pathAt(track, moment) {
  const part = path[byPathEnd(path, moment)];
  return shown["critical path"] && part && part.track === track.number && part.begin <= moment ? part : null;
}

function drawAxis(moment) {
  pen.fillStyle = "#fff";
  pen.fillRect(0, 0, view.width, headHeight);
  const [from, to] = view.scale.domain(), [unit, size] = unitFor(Math.max(Math.abs(to), 1));
  const ticks = view.scale.ticks(Math.max(3, (view.width - view.label) / 130)), step = ticks.length > 1 ? ticks[1] - ticks[0] : size;
  const digits = Math.max(0, Math.ceil(Math.log10(size / step) - 1e-9));
  let free = 0;
  for (const tick of ticks) {
    pen.fillStyle = "#e3e7eb";
    pen.fillRect(view.scale(tick), headHeight - 5, 1, view.height);
    const text = `${(tick / size).toFixed(digits)} ${unit}`, wide = pen.measureText(text).width, right = view.scale(tick) + 3, x = right + wide > view.width ? right - wide - 6 : right;
    if (x < free) continue;
    drawText(text, x, 13, "#5a6876");
    free = x + wide + 8;
  }
  pen.fillStyle = "#16202a";
  if (moment >= from && moment <= to) pen.fillRect(view.scale(moment) - 0.5, 0, 1.4, view.height);
}

function drawTimelines(moment, chosen) {
  pen.clearRect(0, 0, view.width, view.height);
  pen.font = "11px Helvetica, Arial, sans-serif";
  drawAxis(moment);
  const first = Math.max(0, Math.floor(scroller.scrollTop / rowHeight)), last = Math.min(view.rows.length, first + Math.ceil(view.height / rowHeight) + 1);
  pen.save();
  pen.beginPath();
  pen.rect(view.label - 2, headHeight, view.width, view.height);
  pen.clip();
  const pieces = piecesOf(...view.scale.domain());
  for (const { track } of view.rows.slice(first, last)) if (track) pieces.forEach(([from, to, known]) => drawPiece(track, from, to, known));
  drawMessages(chosen);
  drawPath();
  pen.restore();
  for (let row = first; row < last; ++row) drawLabel(view.rows[row], topOf(row), chosen);
  pen.fillStyle = "#fff";
  pen.fillRect(0, 0, view.label - 4, headHeight);
}

// Returns the track and the moment at a point of the canvas. In the head of the canvas the track is null; in the labels
// the moment is null.
function placeAt([x, y]) {
  const row = view.rows[Math.floor((y - headHeight + scroller.scrollTop) / rowHeight)];
  return { track: row && row.track && y > headHeight ? row.track : null, moment: x >= view.label ? view.scale.invert(x) : null };
}

function textAt({ track, moment }) {
  if (!track || moment === null) return "";
  const slice = sliceAt(track, moment), precision = lengthInSight(), part = pathAt(track, moment);
  if (part) return `critical path, ${part.name}; from ${timeText(part.begin, precision)} to ${timeText(part.end, precision)}: ${timeText(part.end - part.begin, part.end - part.begin)}`;
  if (slice && slice.open) return `${track.name}: ${describe(slice)} since ${beginText(slice, precision)} ${endText(slice, precision)}`;
  if (slice) return `${track.name}: ${describe(slice)}; from ${timeText(slice.begin, precision)} to ${timeText(slice.end, precision)}: ${timeText(slice.end - slice.begin, slice.end - slice.begin)}`;
  const from = moment - run.bin / 2, share = what => (100 * rowShare(track, what, from, from + run.bin)).toFixed(0) + " %";
  return `${track.name} at ${timeText(moment, precision)}` + (isKnownAt(moment) ? "" : `, summarised: running ${share("running")}, ready ${share("ready")} of ${timeText(run.bin, run.bin)}`);
}
