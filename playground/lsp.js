// The client of the language server: what it says about the two texts while they are typed. The page loads this
// module once the first run is over.

import { hoverTooltips, LSPClient, LSPPlugin, serverCompletion, signatureHelp } from "@codemirror/lsp-client";
import { StateEffect, StateField } from "@codemirror/state";
import { EditorView, keymap, showTooltip } from "@codemirror/view";
import { clean } from "./clean.js";
import { LANGUAGES } from "./highlight.js";

// A request may wait for the end of a run, which the worker of the server does while the other one is loading.
const TIMEOUT = 30_000;
// Milliseconds after which a change is sent; the server waits for a pause, too.
const PAUSE = 150;
const SEVERITIES = ["error", "error", "warning", "info", "hint"];
const MAX_MARKS = 100;

// ---------------------------------------------------------------------- changes

const sending = EditorView.updateListener.of(({ docChanged, view }) => {
  if (docChanged) setTimeout(() => LSPPlugin.get(view)?.client.sync(), PAUSE);
});

// ---------------------------------------------------------------------- marks and fixes

// The editor of a text and its plugin, if `version` is that of its present text.
function current(editors, { uri, version }) {
  for (const editor of editors) {
    const plugin = LSPPlugin.get(editor.view);
    if (plugin?.uri !== uri) continue;
    const same = plugin.client.workspace.getFile(uri)?.version === version && plugin.unsyncedChanges.empty;
    return same ? { editor, plugin } : null;
  }
  return null;
}

async function mark(editors, params) {
  const found = current(editors, params);
  if (!found) return;
  const { doc } = found.plugin.view.state;
  const whole = { start: found.plugin.toPosition(0), end: found.plugin.toPosition(doc.length) };
  const actions = params.diagnostics.length
    ? await found.plugin.client.request("textDocument/codeAction", {
        textDocument: { uri: params.uri },
        range: whole,
        context: { diagnostics: [], only: ["quickfix"] },
      })
    : [];
  // The text may have changed since.
  if (current(editors, params)?.plugin.view.state.doc !== doc) return;
  const { editor, plugin } = found;
  const of = (item) => (action) => JSON.stringify(action.diagnostics) === JSON.stringify([item]);
  editor.markServer(
    params.diagnostics.slice(0, MAX_MARKS).map((item) => {
      const fixes = (actions ?? []).filter(of(item)).map(({ title, edit }) => {
        const edits = edit.changes?.[params.uri] ?? edit.documentChanges.flatMap((each) => each.edits);
        const changes = edits.map(({ range, newText }) => ({
          from: plugin.fromPosition(range.start),
          to: plugin.fromPosition(range.end),
          insert: newText,
        }));
        // Of no use for a changed text, whose marks and fixes are on their way.
        return { name: title, apply: (view) => view.state.doc === doc && view.dispatch({ changes, userEvent: "input.fix" }) };
      });
      return {
        from: plugin.fromPosition(item.range.start),
        to: plugin.fromPosition(item.range.end),
        severity: SEVERITIES[item.severity ?? 1],
        message: item.message,
        actions: fixes,
        fixes,
      };
    }),
  );
}

// ---------------------------------------------------------------------- help by a key

const setHelp = StateEffect.define();
const help = StateField.define({
  create: () => null,
  update(shown, transaction) {
    for (const effect of transaction.effects) if (effect.is(setHelp)) return effect.value;
    return transaction.docChanged || transaction.selection ? null : shown;
  },
  provide: (field) => showTooltip.from(field),
});

// What the pointer shows when it rests on a word, at the cursor; a screen reader gets it as text.
function showHelp(view) {
  const plugin = LSPPlugin.get(view);
  if (!plugin) return false;
  plugin.client.sync();
  const at = view.state.selection.main.head;
  plugin.client
    .request("textDocument/hover", { position: plugin.toPosition(at), textDocument: { uri: plugin.uri } })
    .then((found) => {
      const dom = document.createElement("div");
      dom.className = "cm-lsp-hover-tooltip cm-lsp-documentation";
      if (found) dom.innerHTML = plugin.docToHTML(found.contents);
      else dom.textContent = "Nothing is known about this word.";
      const tooltip = { pos: at, above: true, create: () => ({ dom }) };
      view.dispatch({ effects: [setHelp.of(tooltip), EditorView.announce.of(dom.textContent)] });
    });
  return true;
}

const hideHelp = (view) => view.state.field(help) !== null && (view.dispatch({ effects: setHelp.of(null) }), true);

// ---------------------------------------------------------------------- the connection

// Connect the editors to a server; returns a function that gives the two texts their names, and one that ends it.
export function connect(transport, { program, machine }) {
  const client = new LSPClient({
    timeout: TIMEOUT,
    sanitizeHTML: clean,
    highlightLanguage: (name) => LANGUAGES[name] ?? null,
    notificationHandlers: {
      "textDocument/publishDiagnostics": (_, params) => (mark([program, machine], params).catch(() => {}), true),
    },
    extensions: [
      {
        clientCapabilities: { textDocument: { publishDiagnostics: { versionSupport: true } } },
        editorExtension: [
          sending,
          serverCompletion(),
          hoverTooltips(),
          signatureHelp(),
          help,
          keymap.of([{ key: "Shift-F1", run: showHelp }, { key: "Escape", run: hideHelp }]),
        ],
      },
    ],
  });
  client.connect(transport);
  return {
    open({ name, dialect }) {
      const base = `file:///${encodeURIComponent(name.replace(/\.\w*$/, ""))}`;
      const suffix = /\.\w+$/.exec(name)[0];
      for (const editor of [program, machine]) editor.connect([]);
      // The program is checked with the machine file, which is there first.
      machine.connect(client.plugin(`${base}.machine.toml`, "toml"));
      program.connect(client.plugin(`${base}${suffix}`, dialect));
    },
    close() {
      for (const editor of [program, machine]) editor.connect([]);
      client.disconnect();
    },
  };
}
