// The page of a panel: it shows the state that comes from the server, and sends what a person does.
//
// `show` takes all that comes. The elements of inputs, outputs and axes are made once for each run (`build`), and
// changed with each state (`update`). Every text of the program is shown as text, never as HTML.

const SPEEDS = [0.1, 0.2, 0.5, 1, 2, 5, 10, 20, 50, 100];
const SPAN = 20; // seconds of the chart
const MAX_ROWS = 2000; // rows of the terminal that stay
const REPEAT = 80; // ms between two presses of a key that is held, which lasts 100 ms
const PATIENCE = 1000; // ms until a page says that it has no answer
const NOTICE = 10000; // ms for which a notice stays
const NO_ANSWER = "no answer yet: motionlang panel is busy";
const GONE = "motionlang panel does not answer: see whether it still runs";
const find = (id) => document.getElementById(id);

let contents = null; // of the program
let state = null; // the last one
let views = new Map(); // of the channels, by table and number
let axisViews = [];
let rules = {}; // by the number of an input: how it follows an output
let samples = []; // [time, position, …] of the axes
let marked = []; // the lines that are marked in the program
let shownLine = 0;
let answered = -Infinity; // when a question was answered last: the second click of a double click is for that one

// Requests are sent one after another, since those of one browser may overtake each other.
let sent = Promise.resolve();
let unanswered = 0;

function send(request) {
  unanswered += 1;
  const late = setTimeout(() => say(NO_ANSWER), PATIENCE);
  sent = sent.then(() => post(request)).finally(() => {
    unanswered -= 1;
    clearTimeout(late);
    if (find("notice").textContent === NO_ANSWER) say("");
  });
}

async function post(request) {
  try {
    const answer = await fetch("act", { method: "POST", headers: { "Content-Type": "application/json" }, body: JSON.stringify(request), keepalive: true });
    if (!answer.ok) say((await answer.json()).error);
  } catch {
    say(GONE);
  }
}

let said = null; // the timer of the notice

function say(text) {
  find("notice").textContent = text;
  clearTimeout(said);
  said = setTimeout(() => (find("notice").textContent = ""), NOTICE);
}

function element(tag, text = "", attributes = {}) {
  const made = document.createElement(tag);
  made.textContent = text;
  for (const [name, value] of Object.entries(attributes)) made.setAttribute(name, value);
  return made;
}

// ------------------------------------------------------------------------------------------------------- terminal

// The screen of a terminal: rows, and the sequences that CLS, LOCATE and a backspace write.
export class Screen {
  constructor() {
    this.rows = [""];
    this.top = this.row = this.column = 0; // the first row of the screen, and where the next character goes
    this.rest = ""; // of a sequence that has not come whole
  }

  write(text) {
    const parts = (this.rest + text).split(/(\x1b\[[0-9;?]*[A-Za-z]|[\n\r\b\x07])/);
    const last = parts.length - 1;
    const begun = /\x1b(?:\[[0-9;?]*)?$/.exec(parts[last]);
    this.rest = begun ? begun[0] : "";
    if (begun) parts[last] = parts[last].slice(0, begun.index);
    for (const part of parts) this.take(part);
    const extra = this.rows.length - MAX_ROWS;
    if (extra > 0) {
      this.rows.splice(0, extra);
      this.top = Math.max(0, this.top - extra);
      this.row = Math.max(0, this.row - extra);
    }
  }

  take(part) {
    const sequence = /^\x1b\[([0-9;?]*)([A-Za-z])$/.exec(part);
    if (sequence) {
      const [row = 1, column = 1] = sequence[1].split(";").map((each) => Number(each) || 1);
      if (sequence[2] === "H") [this.row, this.column] = [this.top + row - 1, column - 1];
      else if (sequence[2] === "J") this.clear();
    } else if (part === "\n") [this.row, this.column] = [this.row + 1, 0];
    else if (part === "\r") this.column = 0;
    else if (part === "\b") this.column = Math.max(0, this.column - 1);
    else if (part && part !== "\x07") this.put(part);
    while (this.rows.length <= this.row) this.rows.push("");
  }

  clear() {
    this.top = this.row = this.rows.length;
    this.column = 0;
  }

  put(text) {
    while (this.rows.length <= this.row) this.rows.push("");
    const before = this.rows[this.row].padEnd(this.column);
    this.rows[this.row] = before.slice(0, this.column) + text + before.slice(this.column + text.length);
    this.column += text.length;
  }

  get text() {
    return this.rows.slice(this.top > 0 ? this.top : 0).join("\n");
  }
}

let screen = new Screen();

function print(text) {
  const terminal = find("terminal");
  const isAtEnd = terminal.scrollTop + terminal.clientHeight > terminal.scrollHeight - 30;
  screen.write(text);
  terminal.textContent = screen.text;
  if (isAtEnd) terminal.scrollTop = terminal.scrollHeight;
}

// ------------------------------------------------------------------------------------------------------- channels

const name = (row) => (row.name ? `${row.title} ${row.name}` : row.title);
const key = (row) => `${row.table} ${row.number}`;

function change(row, value) {
  send({ do: "change", table: row.table, number: row.number, value });
}

function level(row) {
  return Number(state?.inputs[row.number] ?? 0);
}

// The level that stays when no hand presses the input any more.
const latched = (row) => (state?.pressed.includes(row.number) ? 0 : level(row));

function toggle(label, row) {
  const made = element("button", label, { role: "switch", "aria-checked": "false", "aria-label": `${name(row)}${label === "hold" ? ", hold" : ""}` });
  made.addEventListener("click", () => change(row, latched(row) ? 0 : 1));
  return made;
}

const release = (row) => send({ do: "change", table: "release", number: row.number });

// What this page presses: the number of each input, with the pointers and the key that are on its button. A message has
// all of it and is numbered, so none is needed but the last; it is repeated, and a page that is gone presses nothing.
const page = crypto.randomUUID();
const hands = new Map();
let messages = 0;

const pressed = () => ({ do: "press", page, message: ++messages, numbers: [...hands.keys()] });

function lay(number, hand) {
  const isDown = hands.has(number);
  hands.set(number, (hands.get(number) ?? new Set()).add(hand));
  if (!isDown) send(pressed());
}

function lift(number, hand) {
  if (!hands.get(number)?.delete(hand) || hands.get(number).size) return;
  hands.delete(number);
  send(pressed());
}

// Release all at once, also while the page goes: this message does not wait for those before it.
function liftAll() {
  if (!hands.size) return;
  hands.clear();
  post(pressed());
}

// A button that is on as long as it is pressed, by pointers or a key.
function push(row) {
  const made = element("button", name(row), { class: "push", "aria-pressed": "false", title: "on as long as it is pressed" });
  made.addEventListener("pointerdown", (event) => event.button === 0 && (made.setPointerCapture(event.pointerId), lay(row.number, event.pointerId)));
  made.addEventListener("keydown", (event) => {
    if (event.key === " " || event.key === "Enter") (event.preventDefault(), event.repeat || lay(row.number, "key"));
  });
  made.addEventListener("blur", () => lift(row.number, "key"));
  made.addEventListener("contextmenu", (event) => event.preventDefault());
  return made;
}

function digital(row) {
  const place = element("div", "", { class: "channel" });
  const main = row.kind === "button" ? push(row) : toggle(name(row), row);
  const hold = row.kind === "button" ? toggle("hold", row) : null;
  const other = row.kind === "button" ? "switch" : "button";
  const turn = element("button", "⇄", { class: "kind", title: `make it a ${other}`, "aria-label": `make ${row.title} a ${other}` });
  turn.addEventListener("click", () => send({ do: "kind", number: row.number, kind: other }));
  const stops = element("small", "stops this move", { class: "stops" });
  const by = element("small");
  const words = element("span", row.driven ?? "");
  const free = element("button", "let go", { "aria-label": `let go of ${name(row)}` });
  free.addEventListener("click", () => release(row));
  const rule = element("button");
  rule.addEventListener("click", () => send({ do: "rule", number: row.number }));
  by.append(words, " ", free, rule);
  place.append(main, ...(hold ? [hold] : []), turn, stops, by);
  return {
    place,
    update() {
      const isOn = String(Boolean(level(row)));
      if (main.getAttribute("role") === "switch") main.setAttribute("aria-checked", isOn);
      else main.setAttribute("aria-pressed", isOn);
      hold?.setAttribute("aria-checked", String(Boolean(latched(row))));
      stops.hidden = !state.moving.some((line) => contents.stops[line]?.includes(row.number));
      place.classList.toggle("stopping", !stops.hidden);
      const isHeld = state.held.includes(row.number);
      words.textContent = isHeld ? "by hand" : (row.driven ?? "");
      free.hidden = !isHeld;
      const follows = rules[row.number];
      put(rule, follows ? `as a rule: ${follows}` : "");
      rule.hidden = !follows;
      by.hidden = !row.driven && !isHeld && !follows;
    },
  };
}

function analogue(row) {
  const place = element("div", "", { class: "channel" });
  const label = element("label", name(row));
  const slider = element("input", "", { type: "range", min: 0, max: 100, step: 0.5, "aria-label": `${name(row)}, percent` });
  const field = element("input", "", { type: "number", min: -100, max: 100, step: "any", "aria-label": `${name(row)}, percent, as a number` });
  let isDragged = false;
  slider.addEventListener("pointerdown", () => (isDragged = true));
  slider.addEventListener("pointerup", () => (isDragged = false));
  slider.addEventListener("input", () => change(row, Number(slider.value)));
  field.addEventListener("change", () => field.value !== "" && change(row, Number(field.value)));
  place.append(label, slider, field, "%");
  return {
    place,
    update() {
      const value = state.values[key(row)];
      if (!isDragged) slider.value = value;
      if (document.activeElement !== field) field.value = value;
    },
  };
}

function memory(row) {
  const place = element("div", "", { class: "channel" });
  const form = element("form");
  const label = element("label");
  const field = element("input", "", { type: "number", step: "any", "aria-label": `new value of ${name(row)}` });
  const now = element("output");
  label.append(element("span", name(row)), now);
  form.append(label, field, element("button", "write", { "aria-label": `write ${name(row)}` }));
  form.addEventListener("submit", (event) => {
    event.preventDefault();
    if (field.value !== "") change(row, Number(field.value));
  });
  place.append(form);
  return { place, update: () => (now.textContent = state.values[key(row)] ?? "") };
}

const MAKERS = { switch: digital, button: digital, slider: analogue, field: memory };

function add(row) {
  const view = MAKERS[row.kind](row);
  views.set(key(row), { row, ...view });
  find("inputs").append(view.place);
}

function lamp(row) {
  const made = element("li", `output ${row.number} ${row.name}`.trim(), { class: "channel lamp" });
  const words = element("b", "off");
  made.append(words);
  return {
    place: made,
    update() {
      const isOn = state.outputs.includes(row.number);
      made.classList.toggle("on", isOn);
      words.textContent = isOn ? "on" : "off";
    },
  };
}

// ----------------------------------------------------------------------------------------------------------- axes

const figure = (value) => (value === null ? "–" : value.toFixed(Math.abs(value) >= 1000 ? 1 : 2));

function axis(row, index) {
  const place = element("div", "", { class: "axis" });
  const line = element("p");
  const [position, target, speed, words] = ["span", "span", "span", "span"].map((tag) => element(tag));
  const title = element("span", `axis ${row.number} ${row.name}`.trim());
  const colour = element("i", "", { class: "colour", "aria-hidden": "true" }); // of its line in the chart
  colour.style.background = COLOURS[index % COLOURS.length];
  title.prepend(colour);
  line.append(title, position, target, speed, words);
  const range = element("small", row.range ? `limits ${row.range.join(" to ")}` : "");
  line.append(range);
  const track = element("div", "", { class: "track", "aria-hidden": "true" });
  const fill = element("i");
  const aim = element("b");
  track.append(fill, aim);
  const give = element("button", "give it a switch", { "aria-label": `axis ${row.number} finds no switch or mark: give it one` });
  give.addEventListener("click", () => send({ do: "switch" }));
  place.append(line, track, give);
  let [low, high] = row.range ?? [0, 0];
  return {
    place,
    update() {
      const [at, velocity, end, what] = state.axes[index];
      if (!row.range) for (const each of [at, end]) if (each !== null) [low, high] = [Math.min(low, each), Math.max(high, each)];
      if (!row.range) put(range, `so far ${figure(low)} to ${figure(high)}`);
      const share = (value) => `${Math.min(100, Math.max(0, (100 * (value - low)) / (high - low || 1)))}%`;
      fill.style.width = share(at ?? low);
      aim.hidden = end === null;
      aim.style.left = share(end ?? low);
      position.textContent = `at ${figure(at)}`;
      target.textContent = end === null ? "" : `to ${figure(end)}`;
      speed.textContent = velocity ? `${figure(velocity)}/s` : "at rest";
      words.textContent = what;
      words.classList.toggle("fault", what.includes("error"));
      give.hidden = !state.homing.includes(row.number);
    },
  };
}

const COLOURS = ["#1f77b4", "#d95f02", "#1b9e77", "#a6519b", "#b58900", "#c0392b", "#5b6ee1", "#607d3b"];

// The positions over the last seconds, each axis in its own scale.
function draw() {
  const chart = find("chart");
  const [width, height] = [chart.clientWidth, chart.clientHeight];
  const ratio = window.devicePixelRatio || 1;
  if (chart.width !== width * ratio) [chart.width, chart.height] = [width * ratio, height * ratio];
  const pen = chart.getContext("2d");
  pen.setTransform(ratio, 0, 0, ratio, 0, 0);
  pen.clearRect(0, 0, width, height);
  const end = samples.at(-1)?.[0] ?? 0;
  contents.axes.forEach((row, k) => {
    let [low, high] = [Infinity, -Infinity];
    for (const each of samples) [low, high] = [Math.min(low, each[k + 1]), Math.max(high, each[k + 1])];
    const scale = high > low ? (height - 10) / (high - low) : 0;
    pen.beginPath();
    for (const each of samples) pen.lineTo(width * (1 - (end - each[0]) / SPAN), height - 5 - (each[k + 1] - low) * scale);
    pen.strokeStyle = COLOURS[k % COLOURS.length];
    pen.lineWidth = 1.5;
    pen.stroke();
  });
  starts(pen, width, height, end);
}

// The starts of moves, each with its line, in the colour of its axis; a line that is too close to the last is left out.
function starts(pen, width, height, end) {
  pen.font = "11px system-ui, sans-serif";
  pen.globalAlpha = 0.7;
  let free = -Infinity;
  for (const [time, number, line] of state.moves) {
    const x = width * (1 - (end - time) / SPAN);
    if (time < samples[0][0]) continue;
    pen.fillStyle = COLOURS[Math.max(0, contents.axes.findIndex((row) => row.number === number)) % COLOURS.length];
    pen.fillRect(x, 0, 1, height);
    if (x < free) continue;
    pen.fillText(line, x + 3, 10);
    free = x + 6 + pen.measureText(line).width;
  }
  pen.globalAlpha = 1;
}

function sample() {
  const last = samples.at(-1);
  if (last && last[0] === state.t) return;
  samples.push([state.t, ...state.axes.map(([position]) => position ?? 0)]);
  while (samples[0][0] < state.t - SPAN) samples.shift();
  draw();
}

// -------------------------------------------------------------------------------------------------------- program

function mark() {
  const lines = new Map();
  for (const [task, line] of state.tasks) if (line > 0) lines.set(line, [...(lines.get(line) ?? []), task]);
  for (const line of state.stopped) lines.set(line, ["next"]);
  const rows = find("program").children;
  for (const line of marked) if (!lines.has(line)) rows[line - 1]?.classList.remove("at");
  for (const [line, tasks] of lines) {
    rows[line - 1]?.classList.add("at");
    rows[line - 1]?.setAttribute("data-tasks", state.tasks.length > 1 ? tasks.join(", ") : "");
  }
  marked = [...lines.keys()];
  const wanted = state.stopped[0] ?? state.waits[0]?.[2] ?? marked[0] ?? 0;
  if (find("follow").checked && wanted && wanted !== shownLine) {
    const program = find("program");
    const row = rows[(shownLine = wanted) - 1];
    const above = row.offsetTop - program.offsetTop;
    if (above < program.scrollTop || above > program.scrollTop + program.clientHeight - 40) program.scrollTop = above - program.clientHeight / 2;
  }
}

// "waits for input 1 (start), line 62", and what else keeps the program from going on.
function waiting() {
  if (state.mode === "asks") return `the program asks: ${state.question.trim()}; machine time stops until you answer`;
  if (state.end) return state.end;
  const lines = new Map();
  for (const [table, number, line] of state.waits) {
    const row = views.get(`${table} ${number}`)?.row;
    const what = row ? row.title + (row.name ? ` (${row.name})` : "") : table === "key" ? "a key" : `${table} ${number}`;
    lines.set(line, [...(lines.get(line) ?? []), what]);
  }
  const found = [...lines].map(([line, what]) => `${what.join(", ")}, line ${line}`);
  return [
    state.pending.length ? `when it goes on: ${state.pending.join(", ")}` : "",
    state.homing.length ? `axis ${state.homing.join(" and axis ")} finds no switch or index mark: give it one` : "",
    found.length ? `waits for ${found.join("; ")}` : "",
  ].filter(Boolean).join("; ");
}

const MODES = { runs: "runs", paused: "paused", asks: "asks", ended: "ended", fault: "fault", replays: "replays", starts: "starts" };

// ----------------------------------------------------------------------------------------------------- all of it

function build() {
  document.title = `${contents.file} · panel`;
  find("file").textContent = contents.file;
  views = new Map();
  find("inputs").replaceChildren();
  contents.inputs.forEach(add);
  axisViews = contents.axes.map(axis);
  find("axes").replaceChildren(...axisViews.map(({ place }) => place));
  const lamps = contents.outputs.map(lamp);
  find("outputs").replaceChildren(...lamps.map(({ place }) => place));
  axisViews.push(...lamps);
  find("program").replaceChildren(...contents.lines.map((line) => element("li", line)));
  find("keys").hidden = !contents.keys;
  for (const id of ["axes", "outputs"]) find(id).parentElement.hidden = !contents[id].length;
  marked = [];
  shownLine = 0;
}

function update() {
  find("time").textContent = `${state.t.toFixed(2)} s`;
  const isOver = state.mode === "ended" || state.mode === "fault";
  const late = state.late ? ", slower than real time" : "";
  put(find("mode"), MODES[state.mode] + late);
  find("mode").className = state.mode;
  put(find("run"), state.mode === "paused" ? "run" : "pause");
  for (const id of ["run", "step", "rest"]) find(id).disabled = isOver || state.mode === "asks";
  if (document.activeElement !== find("speed")) find("speed").value = String(state.speed);
  for (const channel of state.read) {
    if (!views.has(`input ${channel}`)) add({ table: "input", number: channel, title: `input ${channel}`, name: "", kind: "switch", lines: [] });
  }
  for (const view of views.values()) view.update();
  for (const view of axisViews) view.update();
  const waits = new Set(state.waits.map(([table, number]) => `${table} ${number}`));
  for (const [name, { place }] of views) place.classList.toggle("waiting", waits.has(name));
  put(find("waits"), waiting());
  find("waits").classList.toggle("fault", state.mode === "fault");
  const asks = state.mode === "asks" ? String(state.asks) : "";
  if (asks !== find("answer").dataset.number) {
    if (find("answer").dataset.number) answered = performance.now();
    find("answer").dataset.number = asks;
    find("answer").hidden = !asks;
    find("question").textContent = state.question ?? "";
    find("line").value = "";
    if (asks) find("line").focus();
  }
  sample();
  mark();
}

// Change a text only if it differs, so that a screen reader reads it once.
function put(place, text) {
  if (place.textContent !== text) place.textContent = text;
}

function show(data) {
  if (data.begins) {
    screen = new Screen();
    find("terminal").textContent = "";
    samples = [];
  }
  if (data.contents) {
    const isSame = contents && JSON.stringify(contents) === JSON.stringify(data.contents);
    contents = data.contents;
    if (!isSame) build();
  }
  if (data.text) print(data.text);
  if (data.rules) rules = data.rules;
  if (data.record) record(data.record);
  if (data.notice !== undefined) say(data.notice);
  find("changed").hidden = !data.changed;
  state = data.state;
  if (state.mode !== "starts") update();
}

function record(entries) {
  const made = entries.map(([time, words]) => {
    const row = element("li");
    const button = element("button", `${time.toFixed(2)} s ${words}`, { title: "go back to just before" });
    button.addEventListener("click", () => send({ do: "back", time: Math.max(0, time - 0.02) }));
    row.append(button);
    return row;
  });
  find("record").replaceChildren(...made.reverse());
}

// ---------------------------------------------------------------------------------------------------------- keys

const NAMED = { Enter: "{Enter}", Escape: "\x1b", Backspace: "\b" };
let heldKey = null; // the timer of a key that is held

function typed(event) {
  const text = event.key.length === 1 ? event.key : NAMED[event.key];
  if (text === undefined || event.ctrlKey || event.metaKey || event.altKey || !contents || event.repeat) return;
  event.preventDefault();
  if (state.mode === "asks") {
    find("line").focus();
    if (event.key.length === 1) find("line").value += text;
    return;
  }
  const press = () => send({ do: "change", table: "key", number: 0, value: text });
  press();
  clearInterval(heldKey);
  if (contents.holds) heldKey = setInterval(press, REPEAT);
}

const released = () => clearInterval(heldKey);

function listen() {
  for (const speed of SPEEDS) find("speed").append(element("option", `${speed} ×`, { value: speed }));
  find("speed").value = "1";
  find("speed").addEventListener("change", () => send({ do: "speed", speed: Number(find("speed").value) }));
  find("run").addEventListener("click", () => send({ do: state?.mode === "paused" ? "run" : "pause" }));
  for (const id of ["step", "rest", "save"]) find(id).addEventListener("click", () => send({ do: id }));
  find("back").addEventListener("click", () => send({ do: "back", time: Number(find("moment").value) }));
  find("restart").addEventListener("click", () => send({ do: "restart", keep: false }));
  find("again").addEventListener("click", () => send({ do: "restart", keep: true }));
  find("answer").addEventListener("submit", (event) => {
    event.preventDefault();
    if (performance.now() - answered < PATIENCE / 2) say("the question has just changed: read it, and answer again");
    else send({ do: "reply", question: Number(find("answer").dataset.number), text: find("line").value });
  });
  // A key that is held would answer the next question.
  find("answer").addEventListener("keydown", (event) => event.repeat && event.key === "Enter" && event.preventDefault());
  find("keys").addEventListener("submit", (event) => {
    event.preventDefault();
    for (const letter of find("typed").value) send({ do: "change", table: "key", number: 0, value: letter });
    find("typed").value = "";
  });
  find("enter").addEventListener("click", () => send({ do: "change", table: "key", number: 0, value: "{Enter}" }));
  find("terminal").addEventListener("keydown", typed);
  document.addEventListener("keydown", (event) => event.target === document.body && typed(event));
  document.addEventListener("keyup", released);
  // On the window: a button that is pressed may be replaced by another.
  for (const end of ["pointerup", "pointercancel", "keyup"]) {
    window.addEventListener(end, (event) => [...hands.keys()].forEach((number) => lift(number, event.pointerId ?? "key")));
  }
  document.addEventListener("visibilitychange", () => (document.hidden ? (liftAll(), state && events.close()) : connect()));
  window.addEventListener("resize", () => samples.length && draw());
  for (const end of ["blur", "pagehide"]) window.addEventListener(end, () => (released(), liftAll()));
  setInterval(() => hands.size && !unanswered && send(pressed()), PATIENCE / 2);
  connect();
}

// A browser has six connections to a server, so a page that is hidden gives its own back.
let events = null;

function connect() {
  events?.close();
  events = new EventSource(`events?page=${page}`);
  events.addEventListener("message", (event) => {
    show(JSON.parse(event.data));
    if (document.hidden) events.close();
  });
  events.addEventListener("error", async () => {
    events.close();
    if (document.hidden && state) return;
    put(find("mode"), "not connected");
    const answers = await fetch("style.css").catch(() => null);
    say(answers ? "too many pages of this panel are visible: close or hide one" : GONE);
    setTimeout(() => document.hidden && state || connect(), PATIENCE);
  });
}

listen();
