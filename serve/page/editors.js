// The two editors, their files, and the underlines of errors.
"use strict";

const byId = id => document.getElementById(id);

function makeEditor(id, mode, label, placeholder) {
  const editor = CodeMirror(byId(id), {
    mode, lineNumbers: true, matchBrackets: true, indentUnit: 2, tabSize: 8, indentWithTabs: false, inputStyle: "contenteditable",
    screenReaderLabel: label, placeholder, viewportMargin: 200, gutters: ["CodeMirror-linenumbers", "signs"],
  });
  // Tab indents, as users of occam expect. After Escape, Tab leaves the editor.
  const keys = {
    "Ctrl-Space": () => editor.showHint({ hint: completeAt, completeSingle: false }),
    "Ctrl-Enter": () => (exercise ? byId("check") : byId("run")).click(),
    "F8": () => nextFault(editor),
    "Esc": () => editor.setOption("extraKeys", { ...keys, "Tab": false, "Shift-Tab": false }),
    "Tab": () => editor.somethingSelected() ? editor.indentSelection("add") : editor.replaceSelection("  ", "end"),
    "Shift-Tab": () => editor.indentSelection("subtract"),
  };
  editor.setOption("extraKeys", keys);
  editor.getInputField().setAttribute("role", "textbox");
  editor.getInputField().setAttribute("aria-multiline", "true");
  editor.on("focus", () => editor.setOption("extraKeys", keys));
  return editor;
}

const editors = {
  netlist: makeEditor("netlist", "netlist", "Netlist", "A netlist, which says which processes run on which machine.\nWithout a netlist, the program in occam runs on a T800."),
  occam: makeEditor("occam", "occam", "Program in occam", "A program in occam. A netlist refers to it by its name."),
};
const names = { netlist: "network.cfs", occam: "program.occ" };
const stored = new Map(); // texts of files in occam that are not in the editor at present

/** Returns the files of the page that are not empty, by name. */
function filesOfPage() {
  const files = Object.fromEntries(stored);
  for (const side of ["netlist", "occam"])
    files[names[side]] = editors[side].getValue();
  return Object.fromEntries(Object.entries(files).filter(([, text]) => text.trim()));
}

/** Returns the name of the file that is run: the netlist, or the program in occam if there is no netlist. */
const mainFile = () => editors.netlist.getValue().trim() ? names.netlist : names.occam;

function putText(side, name, text) {
  names[side] = name;
  byId(`${side}-name`).textContent = name;
  editors[side].setOption("mode", name.endsWith(".cfs") || name.endsWith(".inc") ? "netlist" : "occam");
  editors[side].setValue(text);
  editors[side].clearHistory();
}

/** Shows one of several files in occam; the others are kept. */
function putOccam(name, files) {
  stored.clear();
  for (const [each, text] of Object.entries(files))
    if (each !== name)
      stored.set(each, text);
  putText("occam", name, files[name] ?? "");
  const choice = byId("occam-files");
  choice.replaceChildren(...Object.keys(files).map(each => new Option(each, each, false, each === name)));
  choice.hidden = choice.length < 2;
  byId("occam-name").hidden = !choice.hidden;
}

byId("occam-files").addEventListener("change", event => {
  putOccam(event.target.value, { ...Object.fromEntries(stored), [names.occam]: editors.occam.getValue() });
});

/** Converts a column in bytes to CodeMirror's column, which counts units of UTF-16. */
function position(text, column) {
  const bytes = new TextEncoder().encode(text).slice(0, column - 1);
  return new TextDecoder().decode(bytes).length;
}

let marks = [], faults = [];

function markFault(side, fault) {
  const editor = editors[side];
  const line = Math.min(fault.line ?? 1, editor.lineCount()) - 1;
  const text = editor.getLine(line);
  const begin = Math.min(position(text, fault.column ?? 1), Math.max(text.length - 1, 0));
  const end = fault.end_line === fault.line ? position(text, fault.end_column ?? 1) : text.length;
  const title = fault.hint ? `${fault.message}\n${fault.hint}` : fault.message;
  const to = { line, ch: Math.max(end, begin + 1) };
  marks.push(editor.markText({ line, ch: begin }, to, { className: `fault ${fault.severity}`, attributes: { title } }));
  const sign = document.createElement("span");
  sign.className = `sign ${fault.severity}`;
  sign.title = title;
  sign.textContent = fault.severity === "error" ? "✖" : "▲";
  editor.setGutterMarker(line, "signs", sign);
  return { line, ch: begin };
}

const sideOf = fault => ["netlist", "occam"].find(side => names[side] === fault.file);

function goTo(fault) {
  const side = sideOf(fault);
  if (!side)
    return;
  editors[side].focus();
  editors[side].setCursor(fault.at);
}

/** Underlines the faults, and lists them below the editors. */
function showFaults(found) {
  marks.forEach(mark => mark.clear());
  marks = [];
  for (const editor of Object.values(editors))
    editor.clearGutter("signs");
  faults = found;
  byId("faults").replaceChildren(...found.map(fault => {
    const side = sideOf(fault);
    if (side)
      fault.at = markFault(side, fault);
    const item = document.createElement("li"), place = document.createElement("button");
    item.className = fault.severity;
    place.textContent = fault.line ? `${fault.file}:${fault.line}:${fault.column}` : fault.file;
    place.disabled = !side;
    place.addEventListener("click", () => goTo(fault));
    item.append(place, ` ${fault.severity}: ${fault.message}${fault.hint ? " — " + fault.hint : ""}`);
    return item;
  }));
}

function nextFault(editor) {
  const side = editor === editors.netlist ? "netlist" : "occam", cursor = editor.getCursor();
  const here = faults.filter(fault => sideOf(fault) === side);
  const next = here.find(fault => CodeMirror.cmpPos(fault.at, cursor) > 0) ?? here[0];
  if (next)
    goTo(next);
}
