// The page: panels drawn from the model, and what the mouse and the keys do to them.

const data = JSON.parse(document.getElementById("data").textContent);
const NS = "http://www.w3.org/2000/svg";
const LEFT = 132, RIGHT = 8, GAP = 30, LANE = 22;
const HEIGHTS = { position: 118, velocity: 118, acceleration: 96, jerk: 84, "following error": 96, output: 96 };
const END = data.end || 1;
const SHORTEST = Math.max(END * 1e-9, 1e-6);
const MOST_PHASES = 600;

const scope = document.getElementById("scope"), bottom = document.getElementById("time");
const view = { begin: 0, end: END };
const hidden = new Set();
let cursor = null, mark = null, drag = null, panels = [], width = 0, pending = false;

const escaped = (text) => String(text).replace(/[&<>"]/g, (c) => ({ "&": "&amp;", "<": "&lt;", ">": "&gt;", '"': "&quot;" })[c]);
const n = (value) => value.toFixed(2);
const xOf = (time) => LEFT + ((time - view.begin) / (view.end - view.begin)) * width;
const timeOf = (x) => view.begin + ((x - LEFT) / width) * (view.end - view.begin);
const clamp = (value, low, high) => Math.min(Math.max(value, low), high);

// ------------------------------------------------------------------------------------------ what there is to see

/** Every panel that is switched on, from the top down. */
function chosenPanels() {
  const made = [];
  for (const axis of data.axes) {
    if (hidden.has(axis.name)) continue;
    const group = data.quantities.map((quantity) => motionPanel(axis, quantity)).concat(axis.servo.map(servoPanel));
    const shown = group.filter((panel) => panel && !hidden.has(panel.quantity));
    if (shown.length) shown[0].head = axis.name;
    for (const panel of shown) made.push({ ...panel, axis });
  }
  if (hidden.has("channels")) return made;
  const analogue = data.lanes.filter((lane) => !lane.digital).map(analoguePanel);
  const digital = data.lanes.filter((lane) => lane.digital);
  if (digital.length) analogue.push({ lanes: digital, height: LANE * digital.length });
  if (analogue.length) analogue[0].head = "channels";
  return made.concat(analogue);
}

function motionPanel(axis, [quantity, unit]) {
  if (quantity === "jerk" && !axis.jerks) return null;
  const order = ORDERS[quantity];
  const demand = {
    kind: quantity,
    points: (begin, end) => trackPoints(axis.track, order, begin, end, width),
    at: (time) => valueAt(axis.track, time, order),
  };
  const curves = quantity === "position" && axis.motor ? [seriesCurve(axis.motor, "motor"), demand] : [demand];
  return { quantity, unit, height: HEIGHTS[quantity], curves, zero: quantity !== "position" };
}

function servoPanel(series) {
  const kind = series.quantity === "output" ? "output" : "error";
  return { quantity: series.quantity, unit: series.unit, height: HEIGHTS[series.quantity], curves: [seriesCurve(series, kind, kind === "output")], zero: true };
}

function analoguePanel(lane) {
  return { quantity: lane.name, unit: "%", height: 70, curves: [seriesCurve(lane, "analogue", true)] };
}

function seriesCurve({ times, values }, kind, isStepped = false) {
  return {
    kind,
    points: (begin, end) => seriesPoints(times, values, isStepped, begin, end, width),
    at: (time) => seriesAt(times, values, isStepped, time),
  };
}

// ------------------------------------------------------------------------------------------------------- drawing

function redraw() {
  if (pending) return;
  pending = true;
  requestAnimationFrame(() => {
    pending = false;
    draw();
  });
}

function draw() {
  width = Math.max(200, scope.clientWidth - LEFT - RIGHT);
  panels = chosenPanels();
  let top = 10;
  const parts = [`<defs><clipPath id="inside"><rect x="${LEFT}" y="0" width="${width}" height="100000"/></clipPath></defs>`];
  for (const panel of panels) {
    if (panel.head) {
      top += 22;
      parts.push(`<text class="axis" x="${LEFT}" y="${top - 20}">${escaped(panel.head)}</text>`);
      if (panel.axis) parts.push(moveNames(panel.axis, top - 5));
    }
    panel.top = top;
    parts.push(panel.lanes ? lanesSvg(panel) : panelSvg(panel));
    top += panel.height + GAP;
  }
  parts.push(`<g id="over"></g>`);
  scope.setAttribute("height", top);
  scope.innerHTML = parts.join("");
  drawTime();
  drawCursor();
}

function panelSvg(panel) {
  const { top, height } = panel;
  const found = panel.curves.map((curve) => ({ kind: curve.kind, points: curve.points(view.begin, view.end) }));
  let low = Infinity, high = -Infinity;
  for (const { points } of found) for (const [, value] of points) { low = Math.min(low, value); high = Math.max(high, value); }
  const peak = Math.max(Math.abs(low), Math.abs(high));
  const room = 0.08 * (high - low || Math.abs(high) || 1);
  panel.low = low - room;
  panel.high = high + room;
  const yOf = (value) => top + ((panel.high - value) / (panel.high - panel.low)) * height;
  panel.yOf = yOf;
  const parts = [phasesSvg(panel), gridSvg(top, height)];
  const scale = ticks(panel.low, panel.high, height / 22);
  for (const value of scale.values) {
    const y = n(yOf(value));
    parts.push(`<line class="rule" x1="${LEFT}" x2="${LEFT + width}" y1="${y}" y2="${y}"/>`);
    parts.push(`<text x="${LEFT - 6}" y="${y}" dy="0.35em" text-anchor="end">${tickText(value, scale.decimals)}</text>`);
  }
  if (panel.zero && panel.low < 0 && panel.high > 0) parts.push(`<line class="zero" x1="${LEFT}" x2="${LEFT + width}" y1="${n(yOf(0))}" y2="${n(yOf(0))}"/>`);
  for (const { kind, points } of found) {
    const path = points.map(([time, value]) => `${n(xOf(time))} ${n(yOf(value))}`).join("L");
    parts.push(`<path class="curve curve-${kind}" clip-path="url(#inside)" d="M${path}"/>`);
  }
  parts.push(`<path class="frame" d="M${LEFT} ${top}V${top + height}H${LEFT + width}"/>`);
  parts.push(`<text class="name" x="0" y="${top + 10}">${escaped(panel.quantity)}</text>`);
  parts.push(`<text x="0" y="${top + 25}">${escaped(panel.unit)}</text>`);
  panel.remark = panel.zero ? `peak ${figure(peak)} ${panel.unit}` : "";
  return parts.join("");
}

function tickText(value, decimals) {
  if (Math.abs(value) >= 1e6 || (value && decimals > 6)) return value.toExponential(2);
  return (value + 0).toFixed(decimals);
}

function phasesSvg({ axis, top, height }) {
  if (!axis) return "";
  const parts = [];
  for (const move of inView(axis)) {
    let begin = move.start;
    for (const [name, duration] of move.phases) {
      const x = Math.max(LEFT, xOf(begin)), right = Math.min(LEFT + width, xOf(begin + duration));
      if (right > x + 0.5) parts.push(`<rect class="phase-${data.phases.includes(name) ? name : "hold"}" x="${n(x)}" y="${top}" width="${n(right - x)}" height="${height}"/>`);
      begin += duration;
    }
    if (parts.length > MOST_PHASES) return "";
  }
  return parts.join("");
}

/** The moves of an axis that can be seen. */
function inView(axis) {
  return axis.moves.filter((move) => move.start <= view.end && move.start + move.duration >= view.begin);
}

function moveNames(axis, y) {
  const parts = [];
  let free = LEFT;
  for (const move of inView(axis)) {
    const left = Math.max(LEFT, xOf(move.start)), right = Math.min(LEFT + width, xOf(move.start + move.duration));
    const names = [`${move.command} · line ${move.line}`, `${move.command} ${move.line}`, `${move.line}`];
    const name = names.find((each) => each.length * 6.2 < right - left);
    const middle = (left + right) / 2;
    if (!name || middle - name.length * 3.1 < free) continue;
    free = middle + name.length * 3.1 + 6;
    parts.push(`<text x="${n(middle)}" y="${y}" text-anchor="middle">${escaped(name)}</text>`);
  }
  return parts.join("");
}

function gridSvg(top, height) {
  return timeTicks().values
    .map((time) => `<line class="rule" x1="${n(xOf(time))}" x2="${n(xOf(time))}" y1="${top}" y2="${top + height}"/>`)
    .join("");
}

function lanesSvg(panel) {
  const parts = [gridSvg(panel.top, panel.height)];
  panel.lanes.forEach((lane, i) => {
    const y = panel.top + i * LANE;
    parts.push(`<text class="name" x="0" y="${y + 14}">${escaped(lane.name)}</text>`);
    parts.push(`<line class="off" x1="${LEFT}" x2="${LEFT + width}" y1="${y + 18}" y2="${y + 18}"/>`);
    const points = seriesPoints(lane.times, lane.values.map((value) => (value ? 1 : 0)), true, view.begin, view.end, width);
    const path = points.map(([time, value]) => `${n(xOf(time))} ${y + 18 - 14 * value}`).join("L");
    parts.push(`<path class="on" d="M${LEFT} ${y + 18}L${path}L${LEFT + width} ${y + 18}Z"/>`);
  });
  return parts.join("");
}

function timeTicks() {
  return ticks(view.begin, view.end, width / 90);
}

function drawTime() {
  const scale = timeTicks();
  const parts = scale.values.map(
    (time) => `<text x="${n(xOf(time))}" y="14" text-anchor="middle">${time.toFixed(scale.decimals)}</text>`,
  );
  parts.push(`<text x="0" y="14">time, s</text>`);
  const left = LEFT + (view.begin / END) * width, wide = Math.max(6, ((view.end - view.begin) / END) * width);
  parts.push(`<rect class="track" x="${LEFT}" y="22" width="${width}" height="8" rx="4"/>`);
  parts.push(`<rect class="window" x="${n(Math.min(left, LEFT + width - wide))}" y="22" width="${n(wide)}" height="8" rx="4"/>`);
  bottom.setAttribute("height", 34);
  bottom.innerHTML = parts.join("");
}

// -------------------------------------------------------------------------------------------- cursor and readout

function drawCursor() {
  const over = document.getElementById("over");
  if (!over) return;
  const parts = [], bottomEdge = Number(scope.getAttribute("height")) - GAP + 6;
  const upright = (time, kind) => {
    const x = n(xOf(time));
    return `<line class="${kind}" x1="${x}" x2="${x}" y1="0" y2="${bottomEdge}"/>`;
  };
  if (drag && drag.kind === "zoom") {
    const [a, b] = [drag.from, drag.to].sort((one, other) => one - other);
    parts.push(`<rect class="chosen" x="${n(a)}" y="0" width="${n(b - a)}" height="${bottomEdge}"/>`);
  }
  if (mark !== null && mark >= view.begin && mark <= view.end) parts.push(upright(mark, "mark"));
  if (cursor !== null) parts.push(upright(cursor, "cursor"));
  for (const panel of panels) {
    if (panel.lanes) continue;
    const text = cursor === null ? panel.remark : panelReadout(panel);
    parts.push(`<text class="value" x="${LEFT + width}" y="${panel.top - (panel.head ? 20 : 4)}" text-anchor="end">${escaped(text)}</text>`);
    if (cursor !== null) {
      const x = xOf(cursor);
      for (const curve of panel.curves) {
        const y = panel.yOf(curve.at(cursor));
        if (isFinite(y)) parts.push(`<circle class="curve curve-${curve.kind}" cx="${n(x)}" cy="${n(y)}" r="3"/>`);
      }
    }
  }
  over.innerHTML = parts.join("");
  drawReadout();
}

function panelReadout(panel) {
  const values = panel.curves.map((curve) => {
    const value = curve.at(cursor);
    const name = panel.curves.length > 1 ? `${curve.kind === panel.quantity ? "demand" : curve.kind} ` : "";
    const change = mark === null ? "" : `  (Δ ${figure(value - curve.at(mark))})`;
    return `${name}${figure(value)}${change}`;
  });
  return `${values.reverse().join("   ")} ${panel.unit}`;
}

function drawReadout() {
  const readout = document.getElementById("readout");
  const step = (view.end - view.begin) / width;
  if (cursor === null) {
    readout.innerHTML = `<span><b>${clock(view.begin, step)}</b> to <b>${clock(view.end, step)}</b></span>`;
    return;
  }
  const parts = [`<span><b>${clock(cursor, step)}</b></span>`];
  if (mark !== null) parts.push(`<span>Δ <b>${clock(cursor - mark, step)}</b> from the mark</span>`);
  for (const axis of data.axes) {
    const found = hidden.has(axis.name) ? undefined : moveAt(axis, cursor);
    if (!found) continue;
    const { move, phase } = found;
    const source = data.source[move.line];
    parts.push(
      `<span>${escaped(axis.name)}: <b>${escaped(move.command)}</b> ${escaped(phase)}${move.line ? `, line ${move.line}` : ""}` +
        `${source ? ` <code>${escaped(source)}</code>` : ""}</span>`,
    );
  }
  readout.innerHTML = parts.join("");
}

// ------------------------------------------------------------------------------------------------- mouse and keys

function show(begin, end) {
  const length = clamp(end - begin, SHORTEST, END);
  const middle = (begin + end) / 2;
  view.begin = clamp(middle - length / 2, 0, END - length);
  view.end = view.begin + length;
  if (cursor !== null && (cursor < view.begin || cursor > view.end)) cursor = null;
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

scope.addEventListener("pointerdown", (event) => {
  if (event.button !== 0) return;
  scope.setPointerCapture(event.pointerId);
  const x = place(event);
  drag = { kind: event.shiftKey || event.pointerType === "touch" ? "pan" : "zoom", from: x, to: x, moved: false };
});

scope.addEventListener("pointermove", (event) => {
  const x = place(event);
  cursor = timeOf(x);
  if (drag) {
    drag.moved = drag.moved || Math.abs(x - drag.from) > 4;
    if (drag.kind === "pan") {
      pan(timeOf(drag.to) - timeOf(x));
      drag.to = x;
      return;
    }
    drag.to = x;
  }
  drawCursor();
});

scope.addEventListener("pointerup", (event) => {
  const done = drag;
  drag = null;
  if (!done) return;
  if (done.kind === "zoom" && done.moved) show(...[timeOf(done.from), timeOf(done.to)].sort((a, b) => a - b));
  else if (!done.moved) {
    const time = timeOf(place(event));
    mark = mark !== null && Math.abs(xOf(mark) - xOf(time)) < 5 ? null : time;
    drawCursor();
  }
});

scope.addEventListener("pointercancel", () => { drag = null; drawCursor(); });
scope.addEventListener("pointerleave", () => { if (!drag) { cursor = null; drawCursor(); } });
scope.addEventListener("dblclick", () => { mark = null; show(0, END); });
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

const KEYS = {
  ArrowLeft: () => pan((view.begin - view.end) / 8),
  ArrowRight: () => pan((view.end - view.begin) / 8),
  "+": () => zoom(0.5, cursor === null ? (view.begin + view.end) / 2 : cursor),
  "-": () => zoom(2, cursor === null ? (view.begin + view.end) / 2 : cursor),
  0: () => show(0, END),
  Escape: () => { mark = null; drawCursor(); },
};
document.addEventListener("keydown", (event) => {
  const act = event.ctrlKey || event.metaKey || event.altKey ? undefined : KEYS[event.key];
  if (act) { act(); event.preventDefault(); }
});

function chip(name, text) {
  const button = document.createElement("button");
  button.textContent = text;
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
  const chips = document.getElementById("chips");
  const gap = () => Object.assign(document.createElement("span"), { className: "gap" });
  for (const axis of data.axes) chips.append(chip(axis.name, axis.name));
  if (data.lanes.length) chips.append(chip("channels", "channels"));
  chips.append(gap());
  const quantities = data.quantities.map(([quantity]) => quantity).filter((each) => each !== "jerk" || data.axes.some((axis) => axis.jerks));
  for (const axis of data.axes) for (const { quantity } of axis.servo) if (!quantities.includes(quantity)) quantities.push(quantity);
  for (const quantity of quantities) chips.append(chip(quantity, quantity));
  new ResizeObserver(redraw).observe(scope);
  redraw();
}

begin();
