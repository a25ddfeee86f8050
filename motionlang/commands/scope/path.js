// The path of two or three axes through the plane or space, in the window of time that is shown; its colour is the speed.

const PATH_POINTS = 1500, PATH_HEIGHT = 420, PATH_COLOURS = 24;
const wayAxes = ["", "", ""];

/** A direction of space on the paper: a plane as it is, three axes from above one corner. */
function onPaper([x, y, z]) {
  return z === undefined ? [x, y] : [(x - y) * 0.866, (x + y) * 0.5 + z];
}

function drawPath() {
  const box = document.getElementById("way");
  const axes = wayAxes.filter(Boolean).map((name) => data.axes.find((axis) => axis.name === name));
  box.toggleAttribute("hidden", axes.length < 2);
  if (axes.length < 2) return;
  const points = [];
  for (let i = 0; i <= PATH_POINTS; i += 1) {
    const time = view.begin + ((view.end - view.begin) * i) / PATH_POINTS;
    const speeds = axes.map((axis) => valueAt(axis.track, time, 1));
    points.push({ at: onPaper(axes.map((axis) => valueAt(axis.track, time, 0))), speed: Math.hypot(...speeds) });
  }
  const most = points.reduce((high, { speed }) => Math.max(high, speed), 0) || 1;
  const [xs, ys] = [0, 1].map((k) => points.map(({ at }) => at[k]));
  const reach = (values) => values.reduce(([low, high], value) => [Math.min(low, value), Math.max(high, value)], [Infinity, -Infinity]);
  const [[left, right], [down, up]] = [reach(xs), reach(ys)];
  const high = PATH_HEIGHT - 40, across = Math.max(200, width);
  const scale = 0.92 * Math.min(across / (right - left || 1), high / (up - down || 1));
  const x = (value) => LEFT + across / 2 + (value - (left + right) / 2) * scale;
  const y = (value) => 20 + high / 2 - (value - (down + up) / 2) * scale;
  const parts = [`<text class="axis" x="0" y="14">${axes.map((axis) => escaped(axis.name)).join(", ")}</text>`];
  parts.push(`<text x="0" y="32">${figure(right - left)} by ${figure(up - down)} uu</text>`);
  for (let i = 0, begin = 0; i < points.length; i += 1) {
    const shade = (point) => Math.round((point.speed / most) * PATH_COLOURS);
    if (i + 1 < points.length && shade(points[i + 1]) === shade(points[begin]) && i - begin < 200) continue;
    const stretch = points.slice(begin, i + 2).map(({ at }) => `${n(x(at[0]))} ${n(y(at[1]))}`).join("L");
    parts.push(`<path class="way" style="stroke:${speedColour(shade(points[begin]) / PATH_COLOURS)}" d="M${stretch}"/>`);
    begin = i + 1;
  }
  for (let k = 0; k <= 10; k += 1) parts.push(`<rect x="${k * 10}" y="${PATH_HEIGHT - 30}" width="10" height="8" style="fill:${speedColour(k / 10)}"/>`);
  parts.push(`<text x="0" y="${PATH_HEIGHT - 6}">0 to ${figure(most)} uu/s</text>`);
  if (pointer !== null) {
    const [px, py] = onPaper(axes.map((axis) => valueAt(axis.track, pointer, 0)));
    parts.push(`<circle class="here" cx="${n(x(px))}" cy="${n(y(py))}" r="4"/>`);
  }
  box.setAttribute("height", PATH_HEIGHT);
  box.innerHTML = parts.join("");
}

/** From blue, standing, over green to red, the highest speed. */
function speedColour(part) {
  return `hsl(${n(230 - 230 * part)} 75% 48%)`;
}

function wayChoice() {
  const choices = wayAxes.map((_, k) => {
    const choice = document.createElement("select");
    choice.setAttribute("aria-label", `axis ${"XYZ"[k]} of the path`);
    choice.append(new Option(`${"XYZ"[k]}: none`, ""), ...data.axes.map((axis) => new Option(`${"XYZ"[k]}: ${axis.name}`, axis.name)));
    choice.value = wayAxes[k];
    choice.addEventListener("change", () => {
      wayAxes[k] = choice.value;
      drawPath();
    });
    return choice;
  });
  return choices;
}
