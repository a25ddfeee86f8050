// The Python of the page. It runs one program at a time; to stop one, the page ends this worker.
//
// From the page: a request, see `start` of runner.py. To the page: {type: "ready"}, then the messages of
// runner.py, then {type: "done"}; or {type: "failed", text} if Python could not be started or ran out of memory.

const NO_MEMORY = "the program needs more memory than the browser gives it";

const PYODIDE = ["pyodide.asm.mjs", "pyodide.asm.wasm", "python_stdlib.zip"];

const here = (name) => new URL(name, import.meta.url);

async function found(name, options) {
  const answer = await fetch(here(name), options);
  if (!answer.ok) throw new Error(`${name}: ${answer.status} ${answer.statusText}`);
  return answer;
}

async function bytes(name) {
  return (await found(name)).arrayBuffer();
}

async function start() {
  const began = performance.now();
  const contents = found("contents.json").then((answer) => answer.json());
  const files = contents.then(({ wheel }) => Promise.all([bytes(wheel), bytes("runner.py")]));
  // Pyodide waits for ever for a file that it cannot load, so a missing one is found out here.
  const there = PYODIDE.map((name) => found(`pyodide/${name}`, { method: "HEAD" }));
  const missing = new Promise((_, reject) => Promise.all([files, ...there]).catch(reject));
  const load = async () => {
    const { loadPyodide } = await import(here("pyodide/pyodide.mjs").href);
    return loadPyodide({ indexURL: here("pyodide/").href });
  };
  const python = await Promise.race([load(), missing]);
  const loaded = performance.now() - began;
  const [wheel, runner] = await files;
  python.unpackArchive(wheel, "wheel");
  python.FS.writeFile("/home/pyodide/runner.py", new Uint8Array(runner));
  const run = python.runPython("import runner\nlambda request, send: runner.start(request.to_py(), send)");
  return { run, loaded };
}

const started = start();
started.then(
  ({ loaded }) => postMessage({ type: "ready", loaded }),
  (error) => postMessage({ type: "failed", text: String(error.message || error) }),
);

addEventListener("message", async ({ data }) => {
  let run;
  try {
    ({ run } = await started);
  } catch {
    return; // already reported
  }
  try {
    run(data, (message) => postMessage(message.toJs({ dict_converter: Object.fromEntries })));
    postMessage({ type: "done" });
  } catch (error) {
    const text = String(error.message || error).trim().split("\n").at(-1);
    postMessage({ type: "failed", text: text.startsWith("MemoryError") ? NO_MEMORY : text });
  }
});
