// Jobs: each job is one request to the server, which waits for its answer. Closing the request ends the job. A page
// without a server defines answerHere, which answers in place of the server (tools/webassembly).
"use strict";

const nameOfPage = crypto.getRandomValues(new Uint32Array(3)).join("-");
let jobs = 0;

/** Returns the answer to a job. Shows the job's place in the server's queue until the answer arrives. */
async function answerOf(job, signal, says = () => {}) {
  if (globalThis.answerHere)
    return answerHere(job, signal, says);
  const name = `${nameOfPage}-${++jobs}`;
  let ended = false;
  const watch = setInterval(async () => {
    const place = await fetch(`/place?${name}`).then(answer => answer.json()).catch(() => ({}));
    if (ended)
      return;
    if (place.place > 0)
      says(`Waiting in the queue at place ${place.place}.`);
    else if (place.place === 0)
      says("Running.");
  }, 700);
  try {
    const response = await fetch(`/job?${name}`, {
      method: "POST", headers: { "Content-Type": "application/json" }, body: JSON.stringify(job), signal,
    });
    if (!response.ok)
      throw new Error((await response.text()).trim());
    return await response.json();
  } finally {
    ended = true;
    clearInterval(watch);
  }
}

let checking = null, lastCheck = 0;

/** Checks the files a short time after the last change. */
function checkSoon() {
  clearTimeout(lastCheck);
  lastCheck = setTimeout(checkNow, 300);
}

async function checkNow() {
  checking?.abort();
  checking = new AbortController();
  const files = filesOfPage(), main = mainFile(), { signal } = checking;
  if (!files[main])
    return showFaults([]);
  // Files in occam that the netlist does not use are checked alone.
  const alone = Object.keys(files).filter(name => name !== main && name.endsWith(".occ"));
  try {
    const answers = await Promise.all([main, ...alone].map(name => answerOf({ do: "check", main: name, files }, signal)));
    const failed = answers.find(answer => answer.refused);
    if (failed)
      byId("status").textContent = `The program cannot be checked: ${failed.refused}`;
    const found = new Map();
    for (const fault of answers.flatMap(answer => answer.faults ?? []))
      found.set(JSON.stringify([fault.file, fault.line, fault.column, fault.message]), fault);
    showFaults([...found.values()]);
  } catch (error) {
    if (error.name !== "AbortError")
      byId("status").textContent = `The program cannot be checked: ${error.message}`;
  }
}

for (const editor of Object.values(editors))
  editor.on("change", checkSoon);
