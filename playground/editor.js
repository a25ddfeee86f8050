// An editor of one file. It lives in a shadow root, where CodeMirror uses constructed style sheets instead of
// style elements, which the policy of the page forbids.

import { closeBrackets, closeBracketsKeymap } from "@codemirror/autocomplete";
import { defaultKeymap, history, historyKeymap } from "@codemirror/commands";
import { HighlightStyle, bracketMatching, syntaxHighlighting } from "@codemirror/language";
import { forEachDiagnostic, lintKeymap, setDiagnostics } from "@codemirror/lint";
import { highlightSelectionMatches, searchKeymap } from "@codemirror/search";
import { Compartment, EditorState } from "@codemirror/state";
import { EditorView, highlightActiveLine, keymap, lineNumbers } from "@codemirror/view";
import { tags } from "@lezer/highlight";

// The colours are those of style.css, which has them for light and dark.
const COLOURS = HighlightStyle.define([
  { tag: tags.function(tags.variableName), color: "var(--move)" },
  { tag: tags.propertyName, color: "var(--keyword)" },
  { tag: tags.deleted, color: "var(--absent)", textDecoration: "underline dotted" },
  { tag: tags.keyword, color: "var(--control)", fontWeight: "600" },
  { tag: tags.labelName, color: "var(--axis)" },
  { tag: tags.special(tags.variableName), color: "var(--axis)" },
  { tag: tags.number, color: "var(--number)" },
  { tag: tags.string, color: "var(--string)" },
  { tag: tags.comment, color: "var(--comment)" },
  { tag: tags.atom, color: "var(--control)" },
]);

const LOOK = EditorView.theme({
  "&": { color: "var(--ink)", backgroundColor: "var(--paper)", fontSize: "14px" },
  ".cm-scroller": { fontFamily: "var(--mono)", lineHeight: "1.5", overflowX: "auto" },
  ".cm-content, .cm-gutter": { minHeight: "min(26rem, 50vh)" },
  ".cm-content": { caretColor: "var(--ink)" },
  ".cm-cursor": { borderLeftColor: "var(--ink)" },
  ".cm-gutters": { backgroundColor: "var(--paper)", color: "var(--faint)", border: "none" },
  ".cm-activeLine, .cm-activeLineGutter": { backgroundColor: "var(--line)" },
  "&.cm-focused": { outline: "2px solid var(--accent)", outlineOffset: "-2px" },
  "&.cm-focused .cm-selectionBackground, .cm-selectionBackground": { backgroundColor: "var(--selection) !important" },
  ".cm-panels, .cm-tooltip": { backgroundColor: "var(--chip)", color: "var(--ink)", borderColor: "var(--rule)" },
  // Instead of pictures in data: addresses, which the policy of the page forbids.
  ".cm-lintRange": { backgroundImage: "none !important", textDecoration: "underline wavy var(--wrong)", textUnderlineOffset: "3px" },
  ".cm-lintRange-warning": { textDecorationColor: "var(--number)" },
  ".cm-matchingBracket, &.cm-focused .cm-matchingBracket": { backgroundColor: "var(--selection)" },
});

// True if none of an earlier text is left.
function replaced({ startState, changes }) {
  const { length } = startState.doc;
  let all = false;
  changes.iterChangedRanges((from, to) => (all = length > 0 && from === 0 && to === length));
  return all;
}

export class Editor {
  // `file` is its name in the page. `changed` is called after each change of the text, with true if all of it was replaced, `marked` with the marks of the server whenever they change.
  constructor(parent, label, { file, keys = [], changed = () => {}, marked = () => {} }) {
    this.file = file;
    const root = parent.attachShadow({ mode: "open" });
    this.language = new Compartment();
    this.server = new Compartment();
    this.marked = marked;
    this.extensions = [
      lineNumbers(),
      history(),
      highlightActiveLine(),
      highlightSelectionMatches(),
      bracketMatching(),
      closeBrackets(),
      syntaxHighlighting(COLOURS),
      LOOK,
      EditorView.contentAttributes.of({ "aria-label": label, tabindex: "0", spellcheck: "false", autocapitalize: "off" }),
      EditorView.updateListener.of((update) => update.docChanged && changed(replaced(update))),
      keymap.of([...keys, ...closeBracketsKeymap, ...searchKeymap, ...historyKeymap, ...lintKeymap, ...defaultKeymap]),
    ];
    this.mode = [];
    this.client = [];
    this.view = new EditorView({ root, parent: root });
    this.text = "";
  }

  get text() {
    return this.view.state.doc.toString();
  }

  // A new text has no history: undo does not bring back another program.
  set text(text) {
    const extensions = [this.extensions, this.language.of(this.mode), this.server.of(this.client)];
    this.view.setState(EditorState.create({ doc: text, extensions }));
    this.marked(this, []);
  }

  set syntax(mode) {
    this.mode = mode;
    this.view.dispatch({ effects: this.language.reconfigure(mode) });
  }

  // The client of a language server, as extensions of CodeMirror; [] for none.
  connect(client) {
    this.client = client;
    this.view.dispatch({ effects: this.server.reconfigure(client) });
  }

  // Marks of a run: line and column count from 1, line 0 is the whole file.
  markRun(marks) {
    const { doc } = this.view.state;
    const found = marks.map(({ line, column, length, severity, message, hint }) => {
      const { from, to } = doc.line(Math.min(Math.max(line, 1), doc.lines));
      const begin = Math.min(from + Math.max(column - 1, 0), to);
      const end = column ? Math.min(begin + length, to) : to;
      return { from: begin, to: end, severity, message: hint ? `${message}\nhint: ${hint}` : message };
    });
    this.mark(found, this.marks.server);
  }

  // Marks of the language server, which has read the present text.
  markServer(marks) {
    this.mark(this.marks.run, marks);
    this.marked(this, this.marks.server);
  }

  // The marks at their present positions. Those of the server have a `fixes`.
  get marks() {
    const found = { run: [], server: [] };
    forEachDiagnostic(this.view.state, (mark, from, to) => found["fixes" in mark ? "server" : "run"].push({ ...mark, from, to }));
    return found;
  }

  // What both report is marked once.
  mark(run, server) {
    const known = new Set(server.map(({ from, message }) => `${from} ${message}`));
    const own = run.filter(({ from, message }) => !known.has(`${from} ${message}`));
    this.view.dispatch(setDiagnostics(this.view.state, [...own, ...server]));
  }

  lineOf(offset) {
    return this.view.state.doc.lineAt(Math.min(offset, this.view.state.doc.length)).number;
  }

  get line() {
    return this.lineOf(this.view.state.selection.main.head);
  }

  goTo(line) {
    const { doc } = this.view.state;
    const { from } = doc.line(Math.min(line, doc.lines));
    this.view.dispatch({ selection: { anchor: from }, effects: EditorView.scrollIntoView(from, { y: "center" }) });
    this.view.focus();
  }
}
