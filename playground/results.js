// What the page shows of a run. Everything a program prints is set as text, never as HTML.

const element = (id) => document.getElementById(id);
const CHUNK = 100_000;

function show(id, visible) {
  element(id).hidden = !visible;
}

function text(id, value) {
  show(id, value !== "");
  element(id).querySelector("pre").textContent = value;
}

function rows(id, cells) {
  show(id, cells.length > 0);
  element(id)
    .querySelector("tbody")
    .replaceChildren(
      ...cells.map((row) => {
        const made = document.createElement("tr");
        made.append(
          ...row.map((each) => {
            const cell = document.createElement("td");
            cell.append(each);
            return cell;
          }),
        );
        return made;
      }),
    );
}

export class Results {
  // `goTo` is called with "program" or "machine" and the line that a reader chooses.
  constructor(goTo) {
    this.goTo = goTo;
    this.pages = new Map(); // the frame that is shown, until it is ready for its page
    addEventListener("message", ({ source, data }) => data === "ready" && this.send(source));
    this.clear();
  }

  clear() {
    this.age(false);
    this.printed = "";
    for (const id of ["wrong", "output", "table"]) text(id, "");
    for (const id of ["events", "lines"]) rows(id, []);
    this.scope("", "");
  }

  // The results of an older text are grey, and a sentence says so.
  age(is) {
    document.body.classList.toggle("old", is);
    show("old", is && this.any);
  }

  get any() {
    return ["wrong", "output", "table", "events", "scope", "lines"].some((id) => !element(id).hidden);
  }

  // A long output is cut here; the whole of it would make the page slow.
  print(piece) {
    if (this.printed.length >= CHUNK) return;
    this.printed = (this.printed + piece).slice(0, CHUNK);
    text("output", this.printed);
  }

  result({ table, diagnostics, complaints = [], events = [], event_count = 0, dropped = 0 }) {
    if (dropped || this.printed.length >= CHUNK) {
      text("output", `${this.printed}\n… only the first ${CHUNK.toLocaleString("en")} characters are shown`);
    }
    text("wrong", [diagnostics, complaints.join("\n")].filter(Boolean).join("\n"));
    this.link(element("wrong").querySelector("pre"));
    text("table", table);
    const shown = events.map(({ time, line, kind, text }) => [
      String(Number(time.toPrecision(7))),
      this.line(line),
      text ? `${kind}: ${text}` : kind,
    ]);
    if (event_count > events.length) shown.push(["…", "", `${event_count - events.length} more`]);
    rows("events", shown);
  }

  details({ scope, no_scope, lines }) {
    this.scope(scope, no_scope);
    rows(
      "lines",
      lines.map(({ line, seconds, share, text }) => {
        const code = document.createElement("code");
        code.textContent = text;
        return [this.line(line), seconds.toFixed(4), `${(100 * share).toFixed(1)} %`, code];
      }),
    );
  }

  // Make a button of the file and line after each arrow: the text stays as it is.
  link(shown) {
    const parts = shown.textContent.split(/(?<=^ *--> )([^\s:]+:\d+)/m);
    shown.replaceChildren(
      ...parts.map((part, number) => {
        if (number % 2 === 0) return part;
        const [file, line] = part.split(":");
        return this.button(part, file.endsWith(".machine.toml") ? "machine" : "program", Number(line));
      }),
    );
  }

  line(number) {
    return number ? this.button(`${number}`, "program", number) : "";
  }

  button(shown, file, line) {
    const made = document.createElement("button");
    made.type = "button";
    made.textContent = shown;
    const target = `go to line ${line}${file === "machine" ? " of the machine file" : ""}`;
    // The name has the text that is seen, for those who speak it to press the button.
    made.setAttribute("aria-label", target.includes(shown) ? target : `${shown}, ${target}`);
    made.addEventListener("click", () => this.goTo(file, line));
    return made;
  }

  send(window) {
    for (const [frame, page] of this.pages) {
      if (window === null || frame.contentWindow !== window) continue;
      this.pages.delete(frame);
      window.postMessage(page, "*");
    }
  }

  // The scope page runs in a frame of its own origin without network, see scope.html.
  scope(page, instead) {
    show("scope", page !== "" || instead !== "");
    element("scope").querySelector("p").textContent = instead;
    this.pages.clear();
    if (!page) return element("frame").replaceChildren();
    const frame = document.createElement("iframe");
    frame.title = "Motion of the run";
    frame.setAttribute("sandbox", "allow-scripts allow-downloads");
    frame.src = new URL("scope.html", import.meta.url).href;
    this.pages.set(frame, page);
    element("frame").replaceChildren(frame);
  }
}
