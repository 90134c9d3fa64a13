// The page as a whole: examples, exercises, buttons, and the program in the address.
"use strict";

const beginning = "csp/commstime/commstime.cfs";
let examples = {}, exercises = [], exercise = null, running = null;

const says = text => { byId("status").textContent = text; };
const folderOf = name => name.slice(0, name.lastIndexOf("/") + 1);

/** Ends the current job, because its answer would belong to a program that is no longer shown. */
function abandon() {
  running?.abort();
  running = null;
  byId("stop").hidden = true;
}

/** Shows programs: {netlist: [name, text], occam: name, files: {name: text of occam}, exercise: number}. */
function show(state) {
  abandon();
  putText("netlist", ...state.netlist);
  putOccam(state.occam, state.files);
  exercise = state.exercise || null;
  byId("exercises").value = exercise ?? "";
  for (const [id, hidden] of [["check", !exercise], ["run", false], ["explain", false], ["listing", false]])
    byId(id).hidden = hidden;
  byId("run").classList.toggle("first", !exercise);
  byId("results").hidden = true;
  says("");
}

const state = () => ({
  netlist: [names.netlist, editors.netlist.getValue()], occam: names.occam, exercise,
  files: { ...Object.fromEntries(stored), [names.occam]: editors.occam.getValue() },
});

/** Shows an example: a netlist with the files in occam that it names, or a program in occam. */
function showExample(path) {
  const folder = folderOf(path);
  if (path.endsWith(".occ"))
    return show({ netlist: [folder + "network.cfs", ""], occam: path, files: { [path]: examples[path] } });
  const files = {};
  for (const [, name] of examples[path].matchAll(/"([^"#]+\.occ)(?:#[^"]*)?"/g))
    if (examples[folder + name])
      files[folder + name] = examples[folder + name];
  const [first = folder + "program.occ"] = Object.keys(files);
  show({ netlist: [path, examples[path]], occam: first, files: Object.keys(files).length ? files : { [first]: "" } });
}

function showExercise(number) {
  const { start } = exercises.find(each => each.number === number);
  show({ netlist: ["network.cfs", ""], occam: "solution.occ", files: { "solution.occ": start }, exercise: number });
}

function listExamples() {
  const groups = new Map();
  for (const path of Object.keys(examples).sort()) {
    const topic = path.slice(0, path.indexOf("/"));
    if (path.endsWith(".inc") || isPart(path))
      continue;
    if (!groups.has(topic))
      groups.set(topic, Object.assign(document.createElement("optgroup"), { label: topic }));
    groups.get(topic).append(new Option(path.slice(topic.length + 1), path));
  }
  byId("examples").append(...groups.values());
}

/** Returns whether a file in occam is only used by a netlist or a configuration beside it. */
function isPart(path) {
  const folder = folderOf(path), name = path.slice(folder.length);
  return path.endsWith(".occ") && Object.keys(examples).some(other =>
    folderOf(other) === folder && /\.(cfs|pgm)$/.test(other) && examples[other].includes(`"${name}`));
}

async function work(task) {
  abandon();
  const own = running = new AbortController(), isOwn = () => running === own;
  byId("stop").hidden = false;
  says("Running.");
  const job = { do: task, main: task === "exercise" ? names.occam : mainFile(), files: filesOfPage(), seed: Number(byId("seed").value) || 0,
    keys: byId("keys").value, exercise: exercise ?? "" };
  if (!job.files[job.main])
    return finish("There is no program: write a netlist or a program in occam, or choose an example.");
  try {
    const answer = await answerOf(job, own.signal, text => isOwn() && says(text));
    if (!isOwn())
      return;
    showAnswer(answer, { explain: "explanation", listing: "listing", exercise: "verdict" }[task]);
    finish(sentenceOn(answer));
  } catch (error) {
    if (isOwn())
      finish(error.name === "AbortError" ? "Stopped." : `There is no answer: ${error.message}`);
  }
}

function finish(sentence) {
  byId("stop").hidden = true;
  says(sentence);
}

async function copyLink() {
  history.replaceState(null, "", await fragmentOf(state()));
  await navigator.clipboard?.writeText(location.href).catch(() => {});
  says(`The address of this page now contains the program (${location.href.length} characters).`);
}

for (const task of ["run", "explain", "listing"])
  byId(task).addEventListener("click", () => work(task));
byId("check").addEventListener("click", () => work("exercise"));
byId("stop").addEventListener("click", () => running?.abort());
byId("link").addEventListener("click", copyLink);
byId("new").addEventListener("click", () => {
  show({ netlist: ["network.cfs", ""], occam: "program.occ", files: { "program.occ": "" } });
  editors.netlist.focus();
});
byId("examples").addEventListener("change", event => event.target.value && showExample(event.target.value));
byId("exercises").addEventListener("change", event => event.target.value && showExercise(event.target.value));
document.addEventListener("keydown", event => {
  if (event.ctrlKey && event.key === "Enter" && !event.defaultPrevented)
    (exercise ? byId("check") : byId("run")).click();
});

/** Shows the program in the address. If the address is damaged, calls `otherwise` and shows an error. */
async function showLink(otherwise = () => {}) {
  try {
    show(await stateOf(location.hash));
  } catch {
    otherwise();
    says("The link is damaged: its program cannot be read.");
  }
}

async function begin() {
  const get = path => fetch(path).then(answer => answer.json());
  [examples, exercises, catalogue] = await Promise.all(["examples", "exercises", "catalogue"].map(get));
  listExamples();
  byId("exercises").append(...exercises.map(each => new Option(`${each.number} ${each.title}`, each.number)));
  if (location.hash.length > 1)
    await showLink(() => showExample(beginning));
  else
    showExample(beginning);
}

window.addEventListener("hashchange", () => location.hash.length > 1 && showLink());
begin();
