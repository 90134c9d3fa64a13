// Answers the page's jobs in the browser, in place of the server. Each job runs in its own worker with new memory.
"use strict";

const compiled = (async () => WebAssembly.compile(await (await fetch("job.wasm")).arrayBuffer()))();
const examplesOfPage = (async () => (await fetch("examples")).json())();

/** Returns the answer to a job. `says` shows what the page waits for. */
globalThis.answerHere = async (job, signal, says = () => {}) => {
  const loading = setTimeout(() => says("Loading PlacedPar. This takes some seconds."), 300);
  const [module, examples] = await Promise.all([compiled, examplesOfPage]);
  clearTimeout(loading);
  signal.throwIfAborted();
  says("Running.");
  const text = JSON.stringify({ ...job, files: { ...examples, ...job.files } }), worker = new Worker("worker.js");
  const answer = new Promise((resolve, reject) => {
    worker.onmessage = ({ data }) => data.answer ? resolve(JSON.parse(data.answer)) : reject(new Error(data.failed));
    worker.onerror = event => reject(new Error(event.message));
    signal.addEventListener("abort", () => reject(signal.reason));
  });
  worker.postMessage({ module, job: text });
  return answer.finally(() => worker.terminate());
};
