// The list below the editors: what the language server finds in the two texts, and its fixes as buttons.

const MAX_ROWS = 50;

export class Problems {
  // `goTo` is called with an editor and a line.
  constructor(section, goTo) {
    this.section = section;
    this.goTo = goTo;
    this.marks = new Map(); // of each editor
  }

  show(editor, marks) {
    this.marks.set(editor, marks);
    const rows = [...this.marks].flatMap(([one, found]) => found.map((mark) => this.row(one, mark)));
    const count = `${rows.length} ${rows.length === 1 ? "problem" : "problems"}`;
    this.section.hidden = rows.length === 0;
    this.section.querySelector("h2").textContent = count;
    this.section.querySelector("ul").replaceChildren(...rows.slice(0, MAX_ROWS));
  }

  row(editor, { from, severity, message, fixes }) {
    const line = editor.lineOf(from);
    const row = document.createElement("li");
    row.className = severity;
    row.dataset.at = `${editor.file} ${line}`;
    const text = document.createElement("span");
    text.textContent = `${severity}: ${message.replaceAll("\n", " — ")}`;
    const place = editor.file === "machine" ? `machine file, line ${line}` : `line ${line}`;
    row.append(button(place, `go to ${place}`, () => this.goTo(editor, line)), text);
    for (const fix of fixes) {
      row.append(button(fix.name, `fix in ${place}: ${fix.name}`, () => {
        fix.apply(editor.view);
        this.goTo(editor, line);
      }));
    }
    return row;
  }

  // Move to the first problem of a line, its fix if it has one; false if it has no problem.
  focus(editor) {
    const row = this.section.querySelector(`[data-at="${editor.file} ${editor.line}"]`);
    const buttons = row?.querySelectorAll("button") ?? [];
    (buttons[1] ?? buttons[0])?.focus();
    return buttons.length > 0;
  }
}

function button(text, label, pressed) {
  const made = document.createElement("button");
  made.type = "button";
  made.textContent = text;
  made.setAttribute("aria-label", label);
  made.addEventListener("click", pressed);
  return made;
}
