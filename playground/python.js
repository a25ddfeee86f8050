// The two workers with Python. One runs programs; `stop` ends it, and a new one takes its place. The other is
// started when the page is at rest. It has the language server, and runs a program while the first one loads.

// A program ends by itself after 20 s, see worker.js, and shows what it has done. This limit is for what does not
// look at the clock, such as a long computation of the browser, and for the pictures of such a run.
const SECONDS = 40;

// One worker, and how far it is. `take` gets its messages.
class Interpreter {
  constructor(take) {
    this.ready = this.broken = false;
    this.worker = new Worker(new URL("worker.js", import.meta.url), { type: "module" });
    this.worker.addEventListener("message", ({ data }) => {
      if (data.type === "ready") this.ready = true;
      if (data.type === "failed") this.broken = !this.ready;
      take(this, data);
    });
    this.worker.addEventListener("error", (event) => {
      event.preventDefault();
      this.broken = true;
      take(this, { type: "failed", text: event.message || "the worker could not be started" });
    });
  }

  post(message) {
    this.worker.postMessage(message);
  }
}

export class Python {
  // `hear` gets the messages of worker.js about runs; a run that is ended is reported as {type: "ended", why}.
  constructor(hear) {
    this.hear = hear;
    this.active = null; // the interpreter of the present run
    this.first = new Interpreter((from, message) => this.take(from, message));
    this.second = null;
  }

  get running() {
    return this.active !== null;
  }

  // True if a run begins at once.
  get ready() {
    return this.chosen.ready;
  }

  get chosen() {
    return this.active ?? (!this.first.ready && this.second?.ready ? this.second : this.first);
  }

  // Start the second worker with the language server. `served` is called with each one that has it, as
  // {send, subscribe, unsubscribe}, and with null when it is gone.
  serve(served) {
    this.served = served;
    this.startSecond();
  }

  startSecond() {
    this.handlers = new Set();
    this.second = new Interpreter((from, message) => this.take(from, message));
    this.second.post({ type: "warm" });
    this.second.post({ type: "serve" });
  }

  take(from, message) {
    if (from !== this.first && from !== this.second) return; // ended, and this was on its way
    if (message.type === "serves") {
      this.served({
        send: (text) => from.post({ type: "tell", text }),
        subscribe: (handler) => this.handlers.add(handler),
        unsubscribe: (handler) => this.handlers.delete(handler),
      });
    } else if (message.type === "told") {
      for (const handler of this.handlers) handler(message.text);
    } else if (message.type === "ready") {
      if (from === this.first) this.hear(message);
    } else if (message.type === "begins") {
      if (from === this.active) this.limit();
    } else if (message.type === "unserved") {
      this.served(null);
    } else if (from === this.active || (from === this.first && !this.running && !this.second?.ready)) {
      this.heardOfRun(from, message);
    } else if (from === this.second && message.type === "failed") {
      this.served(null); // the page works without it
      this.second.worker.terminate();
      this.second = null;
    }
  }

  // A failure without a run is that of a worker that could not be started; the next run tries again.
  heardOfRun(from, message) {
    if (["done", "failed"].includes(message.type)) {
      clearTimeout(this.timer);
      this.active = null;
    }
    this.hear(message.type === "failed" ? { ...message, loaded: from.ready } : message);
    // After a failure its memory may be full or inconsistent.
    if (message.type === "failed" && from.ready) this.replace(from);
  }

  // The time limit counts from the start of the program: the worker may first have to load Python, warm up or
  // answer a request to the language server.
  limit() {
    this.timer = setTimeout(() => this.stop(`The run took more than ${SECONDS} s and was ended.`), SECONDS * 1000);
  }

  run(request) {
    if (this.first.broken) this.replace(this.first);
    this.active = this.chosen;
    this.active.post({ type: "run", request });
  }

  stop(why) {
    if (!this.running) return;
    const ended = this.active;
    this.active = null;
    clearTimeout(this.timer);
    this.replace(ended);
    this.hear({ type: "ended", why });
  }

  replace(interpreter) {
    interpreter.worker.terminate();
    if (interpreter === this.second) {
      this.served(null);
      this.startSecond();
    } else {
      this.first = new Interpreter((from, message) => this.take(from, message));
      if (this.second) this.first.post({ type: "warm" });
    }
  }
}
