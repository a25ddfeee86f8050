// The page: what is shown, and what the mouse and the keys do to it.

const data = expand(JSON.parse(document.getElementById("data").textContent));
const END = Math.max(data.end, data.against ? data.against.end : 0) || 1;
const SHORTEST = Math.max(END * 1e-9, 1e-6);
const NEAR = 5;

const scope = document.getElementById("scope"), bottom = document.getElementById("time");
const view = { begin: data.first.begin, end: data.first.end === null ? END : data.first.end };
const hidden = new Set(data.first.hidden);
const marks = [];
let pointer = null, drag = null, panels = [], width = 0, pending = false, before = [];

function show(begin, end) {
  const length = clamp(end - begin, SHORTEST, END);
  const middle = (begin + end) / 2;
  view.begin = clamp(middle - length / 2, 0, END - length);
  view.end = view.begin + length;
  if (pointer !== null && (pointer < view.begin || pointer > view.end)) pointer = null;
  redraw();
}

function zoom(factor, around) {
  show(around - (around - view.begin) * factor, around + (view.end - around) * factor);
}

function pan(seconds) {
  const length = view.end - view.begin, begin = clamp(view.begin + seconds, 0, END - length);
  show(begin, begin + length);
}

const place = (event) => clamp(event.clientX - scope.getBoundingClientRect().left, LEFT, LEFT + width);
const markNear = (x) => marks.findIndex((time) => Math.abs(xOf(time) - x) < NEAR);

scope.addEventListener("pointerdown", (event) => {
  if (event.button !== 0) return;
  scope.setPointerCapture(event.pointerId);
  const x = place(event), mark = markNear(x);
  const pans = event.shiftKey || event.pointerType === "touch";
  drag = { kind: mark >= 0 ? "mark" : pans ? "pan" : "zoom", mark, from: x, to: x, moved: false };
});

scope.addEventListener("pointermove", (event) => {
  const x = place(event);
  pointer = timeOf(x);
  if (drag) {
    drag.moved = drag.moved || Math.abs(x - drag.from) > NEAR;
    if (drag.kind === "pan") {
      pan(timeOf(drag.to) - timeOf(x));
      drag.to = x;
      return;
    }
    if (drag.kind === "mark" && drag.moved) marks[drag.mark] = pointer;
    drag.to = x;
  }
  drawCursor();
  drawPath();
});

scope.addEventListener("pointerup", () => {
  const done = drag;
  drag = null;
  if (done && done.kind === "zoom" && done.moved) show(...[timeOf(done.from), timeOf(done.to)].sort((a, b) => a - b));
  else drawCursor();
  scope.dragged = Boolean(done && done.moved);
});

// One click sets the first cursor, another one the second, a third one moves the second; on a cursor it takes that away.
scope.addEventListener("click", (event) => {
  if (scope.dragged) return;
  if (event.detail > 1) {
    marks.splice(0, marks.length, ...before);
  } else {
    before = [...marks];
    const x = place(event), mark = markNear(x);
    if (mark >= 0) marks.splice(mark, 1);
    else if (marks.length < 2) marks.push(timeOf(x));
    else marks[1] = timeOf(x);
  }
  drawCursor();
});

scope.addEventListener("pointercancel", () => { drag = null; drawCursor(); });
scope.addEventListener("pointerleave", () => { if (!drag) { pointer = null; drawCursor(); } });
scope.addEventListener("dblclick", () => show(0, END));
scope.addEventListener("wheel", (event) => {
  if (event.deltaX && Math.abs(event.deltaX) > Math.abs(event.deltaY)) pan((event.deltaX / width) * (view.end - view.begin));
  else zoom(Math.exp(event.deltaY * 0.0015), timeOf(place(event)));
  event.preventDefault();
}, { passive: false });

const slide = (event) => {
  const rect = bottom.getBoundingClientRect();
  const time = clamp((event.clientX - rect.left - LEFT) / width, 0, 1) * END, half = (view.end - view.begin) / 2;
  show(time - half, time + half);
};
bottom.addEventListener("pointerdown", (event) => { bottom.setPointerCapture(event.pointerId); slide(event); });
bottom.addEventListener("pointermove", (event) => { if (event.buttons & 1) slide(event); });

const field = document.getElementById("search"), help = document.getElementById("help");
const middle = () => (pointer === null ? (view.begin + view.end) / 2 : pointer);
const KEYS = {
  ArrowLeft: () => pan((view.begin - view.end) / 8),
  ArrowRight: () => pan((view.end - view.begin) / 8),
  "+": () => zoom(0.5, middle()),
  "-": () => zoom(2, middle()),
  0: () => show(0, END),
  "/": () => field.focus(),
  n: () => searchFor(field.value, 1),
  N: () => searchFor(field.value, -1),
  "?": () => (help.open ? help.close() : help.showModal()),
  Escape: () => { marks.length = 0; drawCursor(); },
};
document.addEventListener("keydown", (event) => {
  if (event.target === field || event.target instanceof HTMLSelectElement) return;
  if (help.open && event.key !== "?") return;
  const act = event.ctrlKey || event.metaKey || event.altKey ? undefined : KEYS[event.key];
  if (act) { act(); event.preventDefault(); }
});
field.addEventListener("keydown", (event) => {
  if (event.key === "Enter") searchFor(field.value, event.shiftKey ? -1 : 1);
  else if (event.key === "Escape") field.blur();
});
// A program that shows this page, such as an editor with a debugger, sends a time for cursor A.
addEventListener("message", ({ data: sent }) => {
  if (typeof sent?.time === "number") goTo(clamp(sent.time, 0, END));
});
field.addEventListener("input", () => { if (!field.value) searchFor("", 1); });

function chip(name) {
  const button = document.createElement("button");
  button.textContent = name;
  button.setAttribute("aria-pressed", String(!hidden.has(name)));
  button.addEventListener("click", () => {
    if (!hidden.delete(name)) hidden.add(name);
    button.setAttribute("aria-pressed", String(!hidden.has(name)));
    redraw();
  });
  return button;
}

function begin() {
  document.getElementById("program").textContent = data.program;
  document.getElementById("outcome").textContent = data.outcome;
  const against = document.getElementById("against");
  if (data.against) against.textContent = `against ${data.against.program} · ${data.against.outcome}`;
  const chips = document.getElementById("chips"), { groups, quantities } = switches();
  const gap = Object.assign(document.createElement("span"), { className: "gap" });
  chips.append(...groups.map(chip), gap, ...quantities.map(chip));
  data.first.path.forEach((name, k) => { wayAxes[k] = name; });
  if (data.axes.length > 1) document.getElementById("ways").append(...wayChoice());
  for (const [name, act] of Object.entries(EXPORTS)) {
    const button = Object.assign(document.createElement("button"), { textContent: name, title: `export the view as a ${name} file` });
    button.addEventListener("click", act);
    document.getElementById("exports").append(button);
  }
  document.getElementById("keys").addEventListener("click", () => help.showModal());
  fillLists();
  addEventListener("scroll", redraw, { passive: true });
  new ResizeObserver(redraw).observe(scope);
  redraw();
}

begin();
