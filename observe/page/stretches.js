// The slices and messages of a run, in stretches as the program packs them (stretch.hpp). The stretches of a short run
// are all read at once. The stretches of a long run are unpacked when they come into sight.

const mostEntries = { inSight: 400000, unpacked: 1000000 };
const elements = document.querySelectorAll("script.stretch");
const stretches = d3.range(elements.length).map(i => ({
  begin: run.stretches[3 * i], end: run.stretches[3 * i + 1], entries: run.stretches[3 * i + 2], element: elements[i], content: null, wantedAt: 0,
}));
const canUnpack = !run.deflated || "DecompressionStream" in window;
// The stretches that the page needs now (`at`), and those of them that are unpacked (`known`).
const looked = { at: [], known: new Set(), count: 0, unpacks: false };
let messages = [];

// Reads numbers that are stored with seven bits in each byte, the lowest bits first.
function readerOf(bytes) {
  let at = 0;
  const next = () => {
    let number = 0, scale = 1;
    for (; bytes[at] >= 128; scale *= 128) number += (bytes[at++] - 128) * scale;
    return number + bytes[at++] * scale;
  };
  return {
    next,
    column: length => { const all = new Float64Array(length); for (let i = 0; i < length; ++i) all[i] = next(); return all; },
    json: length => JSON.parse(new TextDecoder().decode(bytes.subarray(at, at += length))),
  };
}

// Returns {number of track: slices}.
function slicesOf(reader, begin, texts) {
  const counts = d3.range(reader.next()).map(() => [reader.next(), reader.next()]), all = d3.sum(counts, each => each[1]);
  const [gaps, lengths, doings, notes] = [0, 1, 2, 3].map(() => reader.column(all)), slices = {};
  let i = 0;
  for (const [track, count] of counts) {
    slices[track] = [];
    for (let at = begin, behind = i + count; i < behind; ++i) {
      const from = at + gaps[i], open = doings[i] >= 16;
      at = from + lengths[i];
      slices[track].push({ begin: from, end: open ? drawnEnd : at, doing: run.doing[doings[i] % 16], open, note: texts[notes[i]] });
    }
  }
  return slices;
}

function messagesOf(reader, begin, texts) {
  const [from, to, gaps, lengths, channels] = (count => [0, 1, 2, 3, 4].map(() => reader.column(count)))(reader.next()), all = [];
  for (let i = 0, left = begin; i < from.length; ++i) {
    left += gaps[i];
    all.push({ from: from[i], to: to[i], left, arrived: left + lengths[i], channel: texts[channels[i]] });
  }
  return all;
}

function contentOf(stretch, bytes) {
  const reader = readerOf(bytes), texts = reader.json(reader.next());
  return { slices: slicesOf(reader, stretch.begin, texts), messages: messagesOf(reader, stretch.begin, texts) };
}

function bytesOf(stretch) {
  const text = atob(stretch.element.textContent), bytes = new Uint8Array(text.length);
  for (let i = 0; i < text.length; ++i) bytes[i] = text.charCodeAt(i);
  return bytes;
}

async function inflated(bytes) {
  const stream = new DecompressionStream("deflate"), writer = stream.writable.getWriter(), reader = stream.readable.getReader(), pieces = [];
  const written = writer.write(bytes).then(() => writer.close());
  for (let piece; !(piece = await reader.read()).done;) pieces.push(piece.value);
  await written;
  const all = new Uint8Array(d3.sum(pieces, piece => piece.length));
  let at = 0;
  for (const piece of pieces) { all.set(piece, at); at += piece.length; }
  return all;
}

const liesIn = (stretch, from, to) => stretch.begin <= to && from <= stretch.end;

// Returns the stretches at the moment, and the stretches in sight, unless the latter have too many entries to be
// distinguished.
function stretchesAt(moment, from, to) {
  if (!run.deflated) return stretches;
  const inSight = stretches.filter(each => liesIn(each, from, to)), largest = d3.max(stretches, each => each.entries);
  const isNarrow = d3.sum(inSight, each => each.entries) <= Math.max(mostEntries.inSight, 3 * largest);
  return stretches.filter(each => liesIn(each, moment, moment) || (isNarrow && liesIn(each, from, to)));
}

// Discards the contents of stretches that were needed longest ago, if too many entries are unpacked.
function forget() {
  let entries = 0;
  for (const each of stretches.filter(each => each.content).sort((a, b) => b.wantedAt - a.wantedAt)) {
    entries += each.entries;
    if (entries > mostEntries.unpacked && !looked.at.includes(each)) each.content = null;
  }
}

// Gives the slices and messages of the unpacked stretches to the tracks and to `messages`.
function gather() {
  looked.known = new Set(looked.at.filter(each => each.content));
  const contents = [...looked.known].map(each => each.content);
  for (const track of tracks)
    track.slices = d3.merge(contents.map(each => each.slices[track.number] || [])).sort((a, b) => a.begin - b.begin);
  messages = d3.merge(contents.map(each => each.messages)).sort((a, b) => a.left - b.left);
}

// Unpacks the stretches that the page needs, and then calls `then`. Meanwhile the page may come to need other
// stretches.
async function unpack(then) {
  looked.unpacks = true;
  for (let next; (next = looked.at.find(each => !each.content));) {
    next.content = contentOf(next, await inflated(bytesOf(next)));
    forget();
  }
  looked.unpacks = false;
  gather();
  then();
}

// Selects the stretches for a moment and for the interval in sight. If some must be unpacked, calls `then` afterwards.
function lookInto(moment, from, to, then) {
  const before = looked.at;
  looked.at = stretchesAt(moment, from, to);
  looked.count += 1;
  looked.at.forEach(each => { each.wantedAt = looked.count; });
  if (!run.deflated) looked.at.filter(each => !each.content).forEach(each => { each.content = contentOf(each, bytesOf(each)); });
  if (before.length !== looked.at.length || before.some((each, i) => each !== looked.at[i])) gather();
  if (canUnpack && !looked.unpacks && looked.at.some(each => !each.content)) unpack(then);
}

// Returns whether all stretches at a moment are unpacked.
function isKnownAt(moment) {
  return !(run.lost && run.lost[0] <= moment && moment < run.lost[1]) && stretches.every(each => !liesIn(each, moment, moment) || looked.known.has(each));
}

// Divides an interval into pieces that are unpacked or not: [[from, to, whether it is unpacked], ...].
function piecesOf(from, to) {
  const unknown = stretches.filter(each => liesIn(each, from, to) && !looked.known.has(each)).map(each => [each.begin, each.end]);
  if (run.lost) unknown.push(run.lost);
  const pieces = [];
  let at = from;
  for (const [begin, end] of unknown.sort((a, b) => a[0] - b[0])) {
    if (begin > at) pieces.push([at, Math.min(begin, to), true]);
    if (end > at && begin < to) pieces.push([Math.max(at, begin), Math.min(end, to), false]);
    at = Math.max(at, Math.min(end, to));
  }
  if (at < to) pieces.push([at, to, true]);
  return pieces;
}
