// A Python of the page. It runs one program at a time; to stop one, the page ends this worker.
//
// From the page:
//   {type: "run", request}   run a program, see `start` of runner.py
//   {type: "warm"}           import what a run needs, before there is one
//   {type: "serve"}          start the language server
//   {type: "tell", text}     a message to the language server
// To the page: {type: "ready"}; for a run {type: "begins"}, the messages of runner.py, then {type: "done"};
// {type: "failed", text} if Python could not be started or ran out of memory; {type: "serves"} once the language
// server is there, {type: "told", text} with its messages, {type: "unserved", text} if it could not be started.

const NO_MEMORY = "the program needs more memory than the browser gives it";

// The program ends after so many seconds with what it has done until then; LIMIT of runner.py is the same.
const SECONDS = 20;
const SIGINT = 2;

const PYODIDE = ["pyodide.asm.mjs", "pyodide.asm.wasm", "python_stdlib.zip"];
// One move of each language; nothing of the runs is shown.
const WARM = [
  { name: "warm.mnt", dialect: "mint", program: "MOVER(0) = 1 : GO(0)\nPRINT 1\n", machine: "" },
  { name: "warm.mcl", dialect: "mccl", program: "1MR1\n", machine: "" },
];

const here = (name) => new URL(name, import.meta.url);

async function found(name, options) {
  const answer = await fetch(here(name), options);
  if (!answer.ok) throw new Error(`${name}: ${answer.status} ${answer.statusText}`);
  return answer;
}

async function bytes(name) {
  return (await found(name)).arrayBuffer();
}

// An archive that was compressed as a whole. Some servers and browsers undo that by themselves.
async function archive(name) {
  const packed = new Uint8Array(await bytes(name));
  if (packed[0] !== 0x1f || packed[1] !== 0x8b) return packed.buffer;
  return new Response(new Blob([packed]).stream().pipeThrough(new DecompressionStream("gzip"))).arrayBuffer();
}

const contents = found("contents.json").then((answer) => answer.json());

async function start() {
  const began = performance.now();
  const files = contents.then(({ wheel }) => Promise.all([archive(wheel), bytes("runner.py")]));
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
  unpack(python, wheel);
  python.FS.writeFile("/home/pyodide/runner.py", new Uint8Array(runner));
  const run = python.runPython("import importlib\nimportlib.invalidate_caches()\nimport runner\nlambda request, send, alarm: runner.start(request.to_py(), send, alarm)");
  python.setInterruptBuffer(clock);
  return { python, run, loaded };
}

async function serve(python) {
  const { server } = await contents;
  const [program, libraries] = await Promise.all([bytes("language.py"), archive(server)]);
  unpack(python, libraries);
  python.FS.writeFile("/home/pyodide/language.py", new Uint8Array(program));
  const begin = python.runPython("import importlib\nimportlib.invalidate_caches()\nimport language\nlanguage.serve");
  return begin((text) => postMessage({ type: "told", text }));
}

// Python reads the number of a signal from the first element of this buffer every now and then. The usual one is
// shared with the page, which most file servers do not allow; this one looks at the clock.
const clock = {
  end: Infinity,
  get 0() {
    if (performance.now() < this.end) return 0;
    this.end = Infinity;
    return SIGINT;
  },
  set 0(_) {},
};

function alarm(on) {
  clock.end = on ? performance.now() + 1000 * SECONDS : Infinity;
}

// An archive of the files of several wheels.
function unpack(python, files) {
  python.unpackArchive(files, "zip", { extractDir: python.runPython("import site\nsite.getsitepackages()[0]") });
}

const started = start();
let tell = Promise.resolve(() => {});
started.then(
  ({ loaded }) => postMessage({ type: "ready", loaded }),
  (error) => postMessage({ type: "failed", text: reason(error) }),
);

// What of a message of Python is of use: its last line.
function reason(error) {
  return String(error.message || error).trim().split("\n").at(-1);
}

const TODO = {
  run: ({ run }, { request }) => {
    postMessage({ type: "begins" });
    try {
      run(request, (message) => postMessage(message.toJs({ dict_converter: Object.fromEntries })), alarm);
      postMessage({ type: "done" });
    } catch (error) {
      const text = reason(error);
      postMessage({ type: "failed", text: text.startsWith("MemoryError") ? NO_MEMORY : text });
    }
  },
  warm: ({ run }) => {
    for (const request of WARM) run(request, () => {}, () => {});
  },
  serve: ({ python }) => {
    tell = serve(python);
    tell.then(
      () => postMessage({ type: "serves" }),
      (error) => postMessage({ type: "unserved", text: reason(error) }),
    );
  },
  tell: async (_, { text }) => (await tell)(text),
};

addEventListener("message", async ({ data }) => {
  let python;
  try {
    python = await started;
  } catch {
    return; // already reported
  }
  TODO[data.type](python, data);
});
