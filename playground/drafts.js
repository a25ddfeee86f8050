// The reader's own programs of this tab: examples and links that were changed. They outlive another choice and a
// reload, and end with the tab.

const KEY = "motionlang drafts";
const FIELDS = ["name", "dialect", "program", "machine"];

export const same = (one, other) => FIELDS.every((field) => one[field] === other[field]);

export class Drafts {
  constructor() {
    this.all = [];
    this.number = null; // the draft that is shown, null if it is none
    this.opened = null; // the text as it was opened
  }

  // A text is shown: that of a draft, or null for another one.
  open(file, number = null) {
    [this.opened, this.number] = [file, number];
  }

  // Keep the text that is shown if the reader has changed it; returns its name if so.
  keep(file) {
    if (this.opened === null || same(file, this.opened)) return null;
    if (this.number === null) this.number = this.all.push({ label: this.free(file.name) }) - 1;
    this.all[this.number] = { ...this.all[this.number], ...file };
    this.opened = file;
    return this.all[this.number].label;
  }

  free(name) {
    const taken = new Set(this.all.map(({ label }) => label));
    let label = `${name} (changed)`;
    for (let k = 2; taken.has(label); k++) label = `${name} (changed ${k})`;
    return label;
  }

  // For a reload of the page. A browser may refuse to store anything.
  save(file) {
    this.keep(file);
    const { all, number } = this;
    if (!all.length) return;
    try {
      sessionStorage.setItem(KEY, JSON.stringify({ all, number }));
    } catch {
      // the tab has them as long as it is open
    }
  }

  restore() {
    try {
      const { all, number } = JSON.parse(sessionStorage.getItem(KEY)) ?? { all: [], number: null };
      this.all = all;
      return number;
    } catch {
      return null;
    }
  }
}
