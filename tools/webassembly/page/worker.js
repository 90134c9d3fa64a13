// Executes one job. The message to this worker has the compiled program and the job; the reply has the answer as text,
// or says why there is none.
"use strict";

onmessage = ({ data: { module, job } }) => {
  const bytes = new TextEncoder().encode(job), errors = [];
  let next = 0;
  const failed = reason => postMessage({ failed: [...errors, reason].join("\n") });
  self.Module = {
    stdin: () => next < bytes.length ? bytes[next++] : null,
    print: answer => postMessage({ answer }),
    printErr: line => errors.push(line),
    onAbort: failed,
    instantiateWasm(imports, done) {
      WebAssembly.instantiate(module, imports).then(instance => done(instance, module), error => failed(error.message));
      return {};
    },
  };
  importScripts("job.js");
};
