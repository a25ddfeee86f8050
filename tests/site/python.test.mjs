// The two workers and the time limit, with workers that answer as a test says.

import assert from "node:assert/strict";
import { beforeEach, mock, test } from "node:test";
import { Python } from "../../playground/python.js";

const REQUEST = { name: "a.mnt", dialect: "mint", program: "PRINT 1\n", machine: "" };

// The workers that were started, in their order.
let workers = [];

globalThis.Worker = class extends EventTarget {
  constructor() {
    super();
    this.ended = false;
    workers.push(this);
  }

  postMessage() {}

  terminate() {
    this.ended = true;
  }

  answer(...messages) {
    for (const data of messages) this.dispatchEvent(Object.assign(new Event("message"), { data }));
  }
};

// A page with both workers ready; `heard` has the types of what it hears, `servers` what it gets as a server.
function page() {
  const [heard, servers] = [[], []];
  const python = new Python(({ type }) => heard.push(type));
  workers[0].answer({ type: "ready", loaded: 1 });
  python.serve((server) => servers.push(server));
  workers[1].answer({ type: "ready", loaded: 1 });
  return { python, heard, servers };
}

beforeEach(() => {
  workers = [];
  mock.timers.reset();
  mock.timers.enable({ apis: ["setTimeout"] });
});

test("the time limit counts from the start of the program", () => {
  const { python, heard } = page();
  python.run(REQUEST);
  mock.timers.tick(60_000); // the worker is still busy with something else
  assert.deepEqual([heard.at(-1), workers[0].ended], ["ready", false]);
  workers[0].answer({ type: "begins" });
  mock.timers.tick(39_999);
  assert.ok(!workers[0].ended);
  mock.timers.tick(1);
  assert.deepEqual([heard.at(-1), workers[0].ended], ["ended", true]);
});

test("a run that is over has no time limit", () => {
  const { python, heard } = page();
  python.run(REQUEST);
  workers[0].answer({ type: "begins" }, { type: "done" });
  mock.timers.tick(60_000);
  assert.deepEqual([heard.at(-1), workers[0].ended], ["done", false]);
});

test("after Stop the other worker runs the next program, and gives it back", () => {
  const { python } = page();
  python.run(REQUEST);
  workers[0].answer({ type: "begins" });
  python.stop("");
  python.run(REQUEST);
  assert.equal(python.active.worker, workers[1]);
  workers[2].answer({ type: "ready", loaded: 1 });
  workers[1].answer({ type: "begins" }, { type: "done" });
  python.run(REQUEST);
  assert.equal(python.active.worker, workers[2]);
});

test("a language server that cannot be started leaves a page that runs programs", () => {
  const { python, heard, servers } = page();
  python.run(REQUEST);
  python.stop("");
  python.run(REQUEST); // in the second worker
  workers[1].answer({ type: "unserved", text: "404" }, { type: "begins" }, { type: "done" });
  assert.deepEqual([servers, heard], [[null], ["ready", "ended", "done"]]);
});
