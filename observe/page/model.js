"use strict";
// The run: what each track did, and when. Times are in picoseconds.

const data = JSON.parse(document.getElementById("data").textContent);
const run = data.timeline, report = data.report;
const levelDigits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
const runningWork = new Set(["executes", "carries", "computes"]);

// Returns, for each bin, how long the track was in the state (running or ready) before this bin, in bins. The time in
// the state between two moments is then the difference of two sums.
function sumsOf(levels) {
  const sums = new Float64Array(levels.length + 1);
  for (let i = 0; i < levels.length; ++i) sums[i + 1] = sums[i] + levelDigits.indexOf(levels[i]) / 63;
  return sums;
}

const span = Math.max(run.end - run.begin, 1);
// In a deadlock, waits that never end are drawn beyond the end of the run.
const endsInDeadlock = report.deadlock && run.end >= report.time_ps;
const drawnEnd = run.end + (endsInDeadlock ? 0.06 * span : 0);

function pathOf(flat) {
  const parts = [];
  for (let i = 0; i < flat.length; i += 4)
    parts.push({ track: flat[i], begin: flat[i + 1], end: flat[i + 1] + flat[i + 2], name: run.texts[flat[i + 3]] });
  return parts;
}

const tracks = run.tracks.map((track, number) => ({
  number, name: track.name, node: track.node, kind: track.kind, outermost: track.outermost, place: track.place,
  running: sumsOf(track.running), ready: sumsOf(track.ready), slices: [], // slices of the unpacked stretches: see stretches.js
}));
const drawnTracks = tracks.slice().sort((a, b) => a.place - b.place);
const trackNamed = new Map(tracks.map(track => [(track.kind === "processor" ? "processor " : "") + track.name, track]));
const path = pathOf(run.path);
const processNamed = new Map(data.processes.map(process => [process.name, process]));
const componentsOf = d3.nest().key(track => track.outermost).object(tracks.filter(isOfProcess));

function isOfProcess(track) { return track.kind === "process" || track.kind === "machine process" || track.kind === "program"; }

function stateOf(slice) {
  if (runningWork.has(slice.doing)) return "running";
  if (slice.doing === "ready") return "ready";
  return slice.open && slice.doing !== "delayed" && endsInDeadlock ? "stuck" : "waiting";
}

// A slice at the beginning or the end of the traced time may have begun earlier, and may continue afterwards.
const beginText = (slice, precision) => timeText(slice.begin, precision) + (slice.begin <= run.begin && run.begin > 0 ? " or before" : "");

function endText(slice, precision) {
  if (!slice.open) return "until " + timeText(slice.end, precision);
  return stateOf(slice) === "stuck" ? "and for ever" : `until ${timeText(run.end, precision)} at least`;
}

function sumUntil(sums, moment) {
  const at = Math.max(0, Math.min((moment - run.begin) / run.bin, sums.length - 1)), whole = Math.floor(at);
  return whole + 1 < sums.length ? sums[whole] + (at - whole) * (sums[whole + 1] - sums[whole]) : sums[whole];
}

// Returns the share of the time between two moments in which a track was running or ready; `sums` is from sumsOf().
function shareOf(sums, from, to) {
  return to > from ? Math.min(1, (sumUntil(sums, to) - sumUntil(sums, from)) * run.bin / (to - from)) : 0;
}

// Returns the sums of all components of a process together; for other tracks, the track's own sums. The result is kept,
// because a process may have thousands of components.
function sumsTogether(track, what) {
  const lanes = componentsOf[track.number] || [track], name = what + " together";
  if (lanes.length === 1) return track[what];
  if (!track[name]) {
    track[name] = new Float64Array(d3.max(lanes, lane => lane[what].length));
    for (const lane of lanes) for (let i = 0; i < track[name].length; ++i) track[name][i] += lane[what][Math.min(i, lane[what].length - 1)];
  }
  return track[name];
}

const bySliceEnd = d3.bisector(slice => slice.end).right;
const byPathEnd = d3.bisector(part => part.end).right;
const byLeft = d3.bisector(message => message.left).left;

// Returns the index of the first slice that ends after a moment.
function sliceFrom(track, moment) { return bySliceEnd(track.slices, moment); }

function sliceAt(track, moment) {
  const slice = track.slices[Math.min(sliceFrom(track, moment), track.slices.length - 1)];
  return slice && slice.begin <= moment && moment <= slice.end ? slice : null;
}

function stateOfTrack(track, moment) {
  const slice = sliceAt(track, moment);
  if (slice) return stateOf(slice);
  return isKnownAt(moment) ? "gone" : "unknown";
}

// Returns the first of these states that the process or one of its components has: running, ready, stuck, waiting.
function stateOfProcess(track, moment) {
  const states = (componentsOf[track.number] || [track]).map(each => stateOfTrack(each, moment));
  return ["running", "ready", "stuck", "waiting", "unknown"].find(state => states.includes(state)) || "gone";
}

const outermostName = path => path.replace(/ \(has ended\)$/, "").split("/")[0];

// Returns [{channel, partner}] for a wait: its channels and the partners at their other ends.
function awaitedIn(slice) {
  return slice.note.split("\n").filter(line => line.includes("\t")).map(line => {
    const [channel, partner] = line.split("\t");
    return { channel, partner };
  });
}

// Returns the waits of a process and its components at a moment: [{slice, channel, partner}]. A router's sender waits
// on no channel; its result is [{slice}].
function waitsOf(track, moment) {
  const waits = [];
  for (const each of componentsOf[track.number] || [track]) {
    const slice = sliceAt(each, moment);
    if (!slice || (stateOf(slice) !== "waiting" && stateOf(slice) !== "stuck")) continue;
    if (slice.doing === "inputs" && !slice.note) waits.push({ slice });
    awaitedIn(slice).forEach(({ channel, partner }) => waits.push({ slice, channel, partner }));
  }
  return waits;
}

// Returns the chain of waits from a process: to its partner, to the partner's partner and so on, as [[from, to], ...].
function chainFrom(name, moment) {
  const links = [], seen = new Set();
  for (let at = name; at && !seen.has(at);) {
    seen.add(at);
    const track = trackNamed.get(at), state = track && stateOfProcess(track, moment);
    if (state !== "waiting" && state !== "stuck") break;
    const wait = waitsOf(track, moment).find(each => each.partner && outermostName(each.partner) !== at);
    if (!wait) break;
    links.push([at, outermostName(wait.partner)]);
    at = outermostName(wait.partner);
  }
  return links;
}

function describe(slice) {
  const awaited = awaitedIn(slice), mostNamed = 3;
  const partners = awaited.map(each => each.partner || each.channel).join(" or ");
  switch (slice.doing) {
  case "executes": return "executes " + slice.note;
  case "carries": return "carries " + slice.note;
  case "ready": return "ready: waits for its processor";
  case "delayed": return "waits for its timer";
  case "outputs": return "outputs to " + partners;
  case "inputs": return partners ? "inputs from " + partners : "waits for packets to send";
  case "alternates": return awaited.length > mostNamed ? `alternates between ${awaited.length} channels`
    : "alternates: input from " + (partners || "its timer");
  case "joins": return "waits for its components";
  case "after work": return "waits until the work is over";
  case "stopped": return "has stopped: does nothing any more";
  default: return slice.doing;
  }
}

const timeUnits = [["s", 1e12], ["ms", 1e9], ["us", 1e6], ["ns", 1e3], ["ps", 1]];
const unitFor = length => timeUnits.find(([, size]) => Math.abs(length) >= size) || timeUnits[4];

// Returns the time as text, exact to about a thousandth of `precision`.
function timeText(moment, precision) {
  const [unit, size] = unitFor(moment), digits = Math.max(0, Math.min(9, Math.ceil(Math.log10(size / Math.max(precision / 1000, 1)))));
  return (moment / size).toFixed(digits) + " " + unit;
}
