// The worker that runs programs: started at once, ended by `stop`, and replaced by the next one.

const SECONDS = 20;

export class Python {
  // `hear` gets the messages of worker.js; a run that is ended is reported as {type: "ended", why}.
  constructor(hear) {
    this.hear = hear;
    this.running = false;
    this.start();
  }

  start() {
    this.ready = this.broken = false;
    const worker = new Worker(new URL("worker.js", import.meta.url), { type: "module" });
    this.worker = worker;
    worker.addEventListener("message", ({ data }) => worker === this.worker && this.take(data));
    worker.addEventListener("error", (event) => {
      event.preventDefault();
      if (worker === this.worker) this.take({ type: "failed", text: event.message || "the worker could not be started" });
    });
  }

  take(message) {
    if (message.type === "ready") {
      this.ready = true;
      if (this.running) this.limit();
    }
    const over = ["done", "failed"].includes(message.type);
    if (over) {
      clearTimeout(this.timer);
      this.running = false;
    }
    this.hear(message);
    // After a failure its memory may be full or inconsistent. If Python could not be loaded, the next run tries again.
    if (message.type === "failed" && this.ready) this.replace();
    else this.broken = message.type === "failed";
  }

  // The time limit counts from when Python is there.
  limit() {
    this.timer = setTimeout(() => this.stop(`The run took more than ${SECONDS} s and was ended.`), SECONDS * 1000);
  }

  run(request) {
    if (this.broken) this.replace();
    this.running = true;
    if (this.ready) this.limit();
    this.worker.postMessage(request);
  }

  stop(why) {
    if (!this.running) return;
    this.running = false;
    clearTimeout(this.timer);
    this.replace();
    this.hear({ type: "ended", why });
  }

  replace() {
    this.worker.terminate();
    this.start();
  }
}
