// Searching, and what can be taken away: the window as CSV, SVG and PNG.

const CSV_ROWS = 2000;

/** Everything that has a time and a text, in the order of time. */
function findable() {
  if (findable.all) return findable.all;
  const all = data.events.map(({ time, text, line }) => ({ time, line, text }));
  for (const axis of data.axes) {
    for (const move of axis.moves) all.push({ time: move.start, line: move.line, text: `${axis.name} ${move.command}` });
  }
  for (const band of data.bands) for (const [begin, , what, line] of band.spans) all.push({ time: begin, line, text: `${band.name} ${what}` });
  findable.all = all.sort((one, other) => one.time - other.time);
  return findable.all;
}

/** What holds every word of `text`: of its own, of its line, or "line 12". */
function found(text) {
  const words = text.toLowerCase().split(/\s+/).filter(Boolean);
  if (!words.length) return [];
  const line = /^\s*(?:line\s*)?(\d+)\s*$/i.exec(text);
  if (line) return findable().filter((each) => each.line === Number(line[1]));
  return findable().filter((each) => {
    const whole = `${each.text} ${data.source[each.line] || ""}`.toLowerCase();
    return words.every((word) => whole.includes(word));
  });
}

const search = { text: "", hits: [], at: -1 };

function searchFor(text, step) {
  if (text !== search.text) Object.assign(search, { text, hits: found(text), at: step > 0 ? -1 : 0 });
  const count = search.hits.length, told = document.getElementById("hits");
  if (!count) {
    told.textContent = text.trim() ? "nothing found" : "";
    return;
  }
  search.at = (search.at + step + count) % count;
  told.textContent = `${search.at + 1} of ${count}`;
  goTo(search.hits[search.at].time);
}

/** Bring a time into the middle of the window, and set cursor A on it. */
function goTo(time) {
  marks.splice(0, marks.length, time);
  const half = (view.end - view.begin) / 2;
  if (time < view.begin || time > view.end) show(time - half, time + half);
  else redraw();
}

/** The curves of the window as rows of numbers, CSV_ROWS steps of equal length. */
function windowCsv() {
  const curves = panels.filter((panel) => panel.curves).flatMap((panel) => panel.curves.map((curve) => ({ panel, curve })));
  const names = curves.map(({ panel, curve }) => {
    const own = curve.kind === panel.quantity || panel.curves.length === 1;
    return [panel.axis && panel.axis.name, own ? "" : curve.kind, panel.quantity, `(${panel.unit})`].filter(Boolean).join(" ");
  });
  const rows = [["time (s)", ...names].join(",")];
  for (let i = 0; i <= CSV_ROWS; i += 1) {
    const time = view.begin + ((view.end - view.begin) * i) / CSV_ROWS;
    rows.push([time, ...curves.map(({ curve }) => curve.at(time))].map((value) => Number(value.toPrecision(12))).join(","));
  }
  return rows.join("\n") + "\n";
}

/** The panels and the line of time as one picture that needs no style sheet but its own. */
function windowSvg() {
  draw(true);
  const high = Number(scope.getAttribute("height")), wide = LEFT + width + RIGHT;
  const style = getComputedStyle(document.documentElement);
  const css = document.querySelector("style").textContent.replace(/var\((--[\w-]+)\)/g, (_, name) => style.getPropertyValue(name).trim());
  const title = `<text class="axis" x="0" y="16">${escaped(data.program)} · ${escaped(data.outcome)}</text>`;
  const rules = css.split("}").filter((rule) => !/@media|:root|^\s*(\*|body|header|button)/.test(rule)).join("}");
  return (
    `<svg xmlns="${NS}" width="${wide}" height="${high + 60}" font-family="system-ui, sans-serif" font-size="11">` +
    `<style>${escaped(rules)}</style><rect width="100%" height="100%" fill="${style.getPropertyValue("--paper").trim()}"/>` +
    `${title}<g transform="translate(0 22)">${scope.innerHTML}</g><g transform="translate(0 ${high + 24})">${bottom.innerHTML}</g></svg>`
  );
}

function save(content, type, suffix) {
  const link = document.createElement("a");
  link.href = URL.createObjectURL(content instanceof Blob ? content : new Blob([content], { type }));
  link.download = `${data.program.replace(/\.[^.]*$/, "")}.${suffix}`;
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 10000);
}

const EXPORTS = {
  CSV: () => save(windowCsv(), "text/csv", "csv"),
  SVG: () => save(windowSvg(), "image/svg+xml", "svg"),
  PNG: () => {
    const picture = new Image(), sharp = 2;
    picture.onload = () => {
      const canvas = document.createElement("canvas");
      canvas.width = picture.width * sharp;
      canvas.height = picture.height * sharp;
      canvas.getContext("2d").drawImage(picture, 0, 0, canvas.width, canvas.height);
      canvas.toBlob((blob) => save(blob, "image/png", "png"));
    };
    picture.src = `data:image/svg+xml;charset=utf-8,${encodeURIComponent(windowSvg())}`;
  },
};

/** A row of a list that leads to a time. */
function rowTo(time, texts, kind = "") {
  const row = document.createElement("tr");
  row.className = kind;
  row.tabIndex = 0;
  for (const text of texts) row.insertCell().textContent = text;
  row.addEventListener("click", () => goTo(time));
  row.addEventListener("keydown", (key) => { if (key.key === "Enter") goTo(time); });
  return row;
}

/** What happened, and which lines take the time: a row each, and a way to its moment. */
function fillLists() {
  const most = 1000, code = (line) => data.source[line] || "", number = (line) => (line ? `line ${line}` : "");
  document.getElementById("list").toggleAttribute("hidden", !data.events.length);
  document.getElementById("count").textContent = `${data.events.length} event${data.events.length === 1 ? "" : "s"}`;
  const events = data.events.slice(0, most).map((event) =>
    rowTo(event.time, [clock(event.time, 1e-6), event.text, number(event.line), code(event.line)], event.grave ? "grave" : ""));
  document.getElementById("events").append(...events);
  document.getElementById("profile").toggleAttribute("hidden", !data.lines.length);
  const lines = data.lines.slice(0, most).map(({ line, seconds, time }) =>
    rowTo(time, [`${seconds.toFixed(4)} s`, `${((100 * seconds) / END).toFixed(1)} %`, number(line), code(line)]));
  document.getElementById("lines").append(...lines);
}
