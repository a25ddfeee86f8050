// Drawing: the panels as SVG, the line of time below them, the cursors and what they read.

const NS = "http://www.w3.org/2000/svg";
const LEFT = 132, RIGHT = 8, GAP = 30;
const MOST_PHASES = 600;

const escaped = (text) => String(text).replace(/[&<>"]/g, (c) => ({ "&": "&amp;", "<": "&lt;", ">": "&gt;", '"': "&quot;" })[c]);
const n = (value) => value.toFixed(2);
const xOf = (time) => LEFT + ((time - view.begin) / (view.end - view.begin)) * width;
const timeOf = (x) => view.begin + ((x - LEFT) / width) * (view.end - view.begin);
const clamp = (value, low, high) => Math.min(Math.max(value, low), high);

function redraw() {
  if (pending) return;
  pending = true;
  requestAnimationFrame(() => {
    pending = false;
    draw();
  });
}

/** Draw what can be seen of the page; `whole` draws the panels too that are scrolled out of it. */
function draw(whole = false) {
  width = Math.max(200, scope.clientWidth - LEFT - RIGHT);
  panels = chosenPanels();
  const above = scope.getBoundingClientRect().top;
  const seen = (top, height) => whole || (above + top < innerHeight + 200 && above + top + height > -200);
  let top = 10;
  const parts = [`<defs><clipPath id="inside"><rect x="${LEFT}" y="0" width="${width}" height="100000"/></clipPath></defs>`];
  for (const panel of panels) {
    if (panel.head) {
      top += 22;
      parts.push(`<text class="axis" x="${LEFT}" y="${top - 20}">${escaped(panel.head)}</text>`);
      if (panel.axis && seen(top, 0)) parts.push(moveNames(panel.axis, top - 5));
    }
    panel.top = top;
    panel.drawn = seen(top, panel.height);
    if (panel.drawn) parts.push(groundOf(panel)(panel));
    top += panel.height + GAP;
  }
  parts.push(`<g id="over"></g>`);
  scope.setAttribute("height", top);
  scope.innerHTML = parts.join("");
  drawTime();
  drawCursor();
  drawPath();
}

function groundOf(panel) {
  if (panel.events) return eventsSvg;
  if (panel.bands) return bandsSvg;
  return panel.lanes ? lanesSvg : panelSvg;
}

function panelSvg(panel) {
  const { top, height } = panel;
  const found = panel.curves.map((curve) => ({ kind: curve.kind, points: curve.points(view.begin, view.end) }));
  let low = Infinity, high = -Infinity;
  for (const { points } of found) for (const [, value] of points) { low = Math.min(low, value); high = Math.max(high, value); }
  const own = found[found.length - 1].points.map(([, value]) => Math.abs(value));
  const peak = own.reduce((most, value) => Math.max(most, value), 0);
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
  const parts = [], short = [];
  let edge = -1;
  for (const move of inView(axis)) {
    let begin = move.start;
    for (const [name, duration] of move.phases) {
      const x = Math.max(LEFT, xOf(begin)), right = Math.min(LEFT + width, xOf(begin + duration));
      const rect = (wide) => `<rect class="phase-${data.phases.includes(name) ? name : "hold"}" x="${n(x)}" y="${top}" width="${n(wide)}" height="${height}"/>`;
      if (right >= x + 1) parts.push(rect(right - x));
      else if (right >= x && x + 1 - edge >= 0.5) {
        short.push(rect(1));
        edge = x + 1;
      }
      begin += duration;
    }
    if (parts.length > MOST_PHASES) return "";
  }
  return [...parts, ...short].join("");
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
    const spans = visibleSpans(spansOn(lane, END), view.begin, view.end, (view.end - view.begin) / width);
    const path = spans.map(([begin, end]) => `M${n(xOf(begin))} ${y + 18}V${y + 4}H${n(xOf(end))}V${y + 18}Z`).join("");
    if (path) parts.push(`<path class="on" d="${path}"/>`);
  });
  return parts.join("");
}

/** A row a task: what it waited for, a block each. */
function bandsSvg(panel) {
  const parts = [gridSvg(panel.top, panel.height)];
  panel.bands.forEach((band, i) => {
    const y = panel.top + i * LANE;
    parts.push(`<text class="name" x="0" y="${y + 14}">${escaped(band.name)}</text>`);
    parts.push(`<line class="off" x1="${LEFT}" x2="${LEFT + width}" y1="${y + 18}" y2="${y + 18}"/>`);
    let edge = -1;
    for (const [begin, end, what, line] of spansIn(band)) {
      const x = Math.max(LEFT, xOf(begin)), right = Math.max(x + 1, Math.min(LEFT + width, xOf(end)));
      if (right - edge < 0.5) continue;
      edge = right;
      parts.push(`<rect class="wait" x="${n(x)}" y="${y + 3}" width="${n(right - x)}" height="15"/>`);
      const text = [`${what} · line ${line}`, what].find((each) => each.length * 6.2 < right - x - 4);
      if (text) parts.push(`<text class="in" x="${n(x + 4)}" y="${y + 14}">${escaped(text)}</text>`);
    }
  });
  return parts.join("");
}

function spansIn(band) {
  return band.spans.filter(([begin, end]) => begin <= view.end && end >= view.begin);
}

function eventsSvg(panel) {
  const { top } = panel;
  const parts = [`<line class="off" x1="${LEFT}" x2="${LEFT + width}" y1="${top + 20}" y2="${top + 20}"/>`];
  let free = LEFT, edge = -1;
  for (const event of panel.events) {
    if (event.time < view.begin || event.time > view.end) continue;
    const x = xOf(event.time);
    if (x - edge >= 1) {
      edge = x;
      parts.push(`<path class="event event-${event.grave ? "grave" : "plain"}" d="M${n(x)} ${top + 20}l-4 -8h8z"/>`);
    }
    if (x > free && x + event.kind.length * 6.2 < LEFT + width) {
      parts.push(`<text x="${n(x)}" y="${top + 8}">${escaped(event.kind)}</text>`);
      free = x + event.kind.length * 6.2 + 6;
    }
  }
  return parts.join("");
}

function timeTicks() {
  return ticks(view.begin, view.end, width / 90);
}

function drawTime() {
  const scale = timeTicks();
  const parts = scale.values.map((time) => {
    const text = time.toFixed(scale.decimals);
    const x = Math.min(xOf(time), LEFT + width + RIGHT - text.length * 3.5); // the last one ends with the page
    return `<text x="${n(x)}" y="14" text-anchor="middle">${text}</text>`;
  });
  parts.push(`<text x="0" y="14">time, s</text>`);
  const left = LEFT + (view.begin / END) * width, wide = Math.max(6, ((view.end - view.begin) / END) * width);
  parts.push(`<rect class="track" x="${LEFT}" y="22" width="${width}" height="8" rx="4"/>`);
  parts.push(`<rect class="window" x="${n(Math.min(left, LEFT + width - wide))}" y="22" width="${n(wide)}" height="8" rx="4"/>`);
  bottom.setAttribute("height", 34);
  bottom.innerHTML = parts.join("");
}

// -------------------------------------------------------------------------------------------- cursors and readout

function drawCursor() {
  const over = document.getElementById("over");
  if (!over) return;
  const parts = [], bottomEdge = Number(scope.getAttribute("height")) - GAP + 6;
  const upright = (time, kind, name = "") => {
    const x = n(xOf(time));
    return `<line class="${kind}" x1="${x}" x2="${x}" y1="0" y2="${bottomEdge}"/>` + (name && `<text class="letter" x="${x}" y="10" dx="3">${name}</text>`);
  };
  if (drag && drag.kind === "zoom") {
    const [a, b] = [drag.from, drag.to].sort((one, other) => one - other);
    parts.push(`<rect class="chosen" x="${n(a)}" y="0" width="${n(b - a)}" height="${bottomEdge}"/>`);
  }
  marks.forEach((time, i) => {
    if (time >= view.begin && time <= view.end) parts.push(upright(time, "mark", "AB"[i]));
  });
  if (pointer !== null) parts.push(upright(pointer, "cursor"));
  for (const panel of panels) {
    if (!panel.curves || !panel.drawn) continue;
    const text = pointer === null && !marks.length ? panel.remark : panelReadout(panel);
    parts.push(`<text class="value" x="${LEFT + width}" y="${panel.top - (panel.head ? 20 : 4)}" text-anchor="end">${escaped(text)}</text>`);
    if (pointer !== null) {
      for (const curve of panel.curves) {
        const y = panel.yOf(curve.at(pointer));
        if (isFinite(y)) parts.push(`<circle class="curve curve-${curve.kind}" cx="${n(xOf(pointer))}" cy="${n(y)}" r="3"/>`);
      }
    }
  }
  over.innerHTML = parts.join("");
  drawReadout();
}

/** The times that are read, each with its name: the cursors that are set, and where the pointer is. */
function readings() {
  const found = marks.map((time, i) => ["AB"[i], time]);
  return pointer === null ? found : [...found, ["", pointer]];
}

function panelReadout(panel) {
  const several = panel.curves.length > 1;
  const texts = panel.curves.map((curve) => {
    const name = several ? `${curve.kind === panel.quantity ? "demand" : curve.kind} ` : "";
    const values = readings().map(([letter, time]) => `${letter && `${letter} `}${figure(curve.at(time))}`);
    if (marks.length === 2) values.splice(2, 0, `Δ ${figure(curve.at(marks[1]) - curve.at(marks[0]))}`);
    else if (marks.length && pointer !== null) values.push(`Δ ${figure(curve.at(pointer) - curve.at(marks[0]))}`);
    return name + values.join(" · ");
  });
  return `${texts.reverse().join("   ")} ${panel.unit}`;
}

function drawReadout() {
  const readout = document.getElementById("readout");
  const step = (view.end - view.begin) / width;
  const parts = marks.map((time, i) => `<span>${"AB"[i]} <b>${clock(time, step)}</b></span>`);
  const [from, to] = marks.length === 2 ? marks : [marks[0], pointer];
  if (marks.length && to !== null) parts.push(`<span>Δ <b>${clock(to - from, step)}</b></span>`);
  if (pointer === null) {
    parts.unshift(`<span><b>${clock(view.begin, step)}</b> to <b>${clock(view.end, step)}</b></span>`);
    readout.innerHTML = parts.join("");
    return;
  }
  parts.unshift(`<span><b>${clock(pointer, step)}</b></span>`);
  for (const event of data.events.filter((each) => Math.abs(xOf(each.time) - xOf(pointer)) < 4).slice(0, 3)) {
    parts.push(`<span class="${event.grave ? "grave" : ""}">${escaped(event.text)}</span>`);
  }
  for (const axis of data.axes) {
    const found = hidden.has(axis.name) ? undefined : moveAt(axis, pointer);
    if (!found) continue;
    const { move, phase } = found;
    parts.push(`<span>${escaped(axis.name)}: <b>${escaped(move.command)}</b> ${escaped(phase)}${lineText(move.line)}</span>`);
  }
  for (const band of hidden.has("waits") ? [] : data.bands) {
    const span = spansIn(band).find(([begin, end]) => begin <= pointer && pointer <= end);
    if (span) parts.push(`<span>${escaped(band.name)}: ${escaped(span[2])}${lineText(span[3])}</span>`);
  }
  readout.innerHTML = parts.join("");
}

/** A number of a line, and the line. */
function lineText(line) {
  if (!line) return "";
  const source = data.source[line];
  return `, line ${line}${source ? ` <code>${escaped(source)}</code>` : ""}`;
}
