// Completions at the cursor, from the program's catalogue of kinds and devices and from the text itself.
"use strict";

let catalogue = { processes: [], devices: [] };

const kindNamed = name => catalogue.processes.find(kind => kind.name === name);
const entry = (text, about = "") => ({ text, displayText: about ? `${text}  ${about}` : text });

/** Returns {process: kind} of the statements `use "KIND" for PROCESS`. */
function kindsInUse(text) {
  const found = new Map();
  for (const [, kind, process] of text.matchAll(/\buse\s+"([^"]+)"\s+for\s+(\w+)/g))
    found.set(process, kindNamed(kind));
  return found;
}

/** Returns the entries for a netlist whose current line is `line` up to the word at the cursor. */
function netlistEntries(line, text) {
  if (/\buse\s+"[^"]*$/.test(line))
    return catalogue.processes.map(kind => entry(kind.name, kind.about));
  const owner = line.match(/(\w+)(?:\[[^\]]*\])?\.$/);
  if (owner) {
    const kind = kindsInUse(text).get(owner[1]);
    return kind ? kind.ports.map(port => entry(port.name, `${port.direction}: ${port.about}`)) : [entry("link")];
  }
  const list = line.match(/(\w+)(?:\[[^\]]*\])?\s*\([^()]*$/);
  if (list) {
    const kind = kindsInUse(text).get(list[1]);
    const device = catalogue.devices.find(each => each.models.some(model => model.name === list[1]));
    return (kind ? kind.parameters : device ? device.attributes : []).map(each => entry(each.name, each.about));
  }
  const models = catalogue.devices.flatMap(device => device.models.map(model => entry(model.name, device.about)));
  return [...netlistWords.map(word => entry(word)), ...models, ...namesIn(text)];
}

const namesIn = text => [...new Set(text.match(/[A-Za-z][\w.]{2,}/g) || [])].map(name => entry(name));

/** Returns the completions at the cursor of an editor, in the form that show-hint.js requires. */
function completeAt(editor) {
  const cursor = editor.getCursor();
  const before = editor.getLine(cursor.line).slice(0, cursor.ch);
  const isNetlist = editor.getOption("mode") === "netlist";
  const word = before.match(isNetlist && !/"[^"]*$/.test(before) ? /\w*$/ : /[\w.]*$/)[0];
  const line = before.slice(0, before.length - word.length);
  const entries = isNetlist ? netlistEntries(line, editor.getValue())
    : [...occamWords.map(each => entry(each)), ...namesIn(editor.getValue())];
  const unique = new Map(entries.filter(each => each.text !== word && each.text.toLowerCase().startsWith(word.toLowerCase()))
    .map(each => [each.text, each]));
  return { list: [...unique.values()], from: { line: cursor.line, ch: cursor.ch - word.length }, to: cursor };
}
