// The page: editors, gallery, buttons, and what happens with a run.

import { StreamLanguage } from "@codemirror/language";
import { toml } from "@codemirror/legacy-modes/mode/toml";
import { Drafts } from "./drafts.js";
import { Editor } from "./editor.js";
import { LANGUAGES } from "./highlight.js";
import { Problems } from "./problems.js";
import { Python } from "./python.js";
import { Results } from "./results.js";
import { BadLink, fromFragment, toFragment } from "./share.js";

const element = (id) => document.getElementById(id);
const FILES = ["program", "machine"];
const SUFFIX = { mint: ".mnt", mccl: ".mcl" };
const LOADING = "Loading Python …"; // as in index.html
const READY = "Ready. Press Run, or Ctrl-Enter.";
const HOW = { ended: "The program has ended.", until: "The time of the run was up.", fault: "The program did not end as it should; see the errors.",
  interrupted: "The run took more than 20 s and was ended. The results are those up to there." };

const problems = new Problems(element("problems"), (editor, line) => {
  choose(editor.file);
  editor.goTo(line);
});
const results = new Results((file, line) => {
  choose(file);
  editors[file].goTo(line);
});
const editors = {
  program: newEditor("program", "Program"),
  machine: newEditor("machine", "Machine file"),
};
editors.machine.syntax = StreamLanguage.define(toml);
const drafts = new Drafts();

let name = "program.mnt";
let answers = [];
let first = "";
let shared = "";
let python = null;
let runs = 0;
let began = 0;
let server = null;

// ---------------------------------------------------------------------- the files

function say(text) {
  element("status").textContent = text;
}

// A figure for tests, as an attribute of the page: milliseconds, or the number of runs.
function measure(what, value) {
  document.documentElement.dataset[what] = String(Math.round(10 * value) / 10);
}

function request() {
  const dialect = element("dialect").value;
  return { name, dialect, program: editors.program.text, machine: editors.machine.text };
}

// The switches of the inputs that the program reads; one that stays keeps its level.
function showInputs(channels) {
  const on = new Set(switchedOn());
  const switches = channels.map((channel) => {
    const [label, box] = [document.createElement("label"), document.createElement("input")];
    Object.assign(box, { type: "checkbox", value: `${channel}`, checked: on.has(channel) });
    box.setAttribute("role", "switch");
    label.append(box, ` input ${channel}`);
    return label;
  });
  element("switches").replaceChildren(...switches);
  element("inputs").hidden = !channels.length;
}

function switchedOn() {
  return [...element("switches").querySelectorAll("input:checked")].map(({ value }) => Number(value));
}

// Show a program; `draft` is its number if it is one of the reader's own.
function open(file, draft = null) {
  stop("");
  name = named(file);
  element("dialect").value = file.dialect;
  editors.machine.text = file.machine;
  editors.program.text = file.program;
  editors.program.syntax = LANGUAGES[file.dialect];
  server?.open(request());
  results.clear();
  showInputs([]); // those of another program are off
  showInputs(file.inputs ?? []);
  choose("program");
  drafts.open(request(), draft);
}

// Keep what the reader has written before another program is shown.
function keep() {
  const label = drafts.keep(request());
  listDrafts();
  return label === null ? "" : ` What you wrote is kept as ${label}, under Example.`;
}

// Another program than the one that was chosen: it keeps neither the name of that one nor its place in the list.
function rename(plain) {
  name = named({ name: plain, dialect: element("dialect").value });
  element("gallery").value = "";
  server?.open(request());
}

// The name of a file without folders, with a suffix of its language.
function named({ name, dialect }) {
  const plain = name.replace(/[^\w.-]/g, "").slice(0, 60).replace(/\.\w*$/, "") || "program";
  const suffix = /\.\w+$/.exec(name)?.[0] ?? "";
  const known = { mint: [".mnt", ".mntx", ".prg"], mccl: [".mcl", ".mccl"] }[dialect];
  return plain + (known.includes(suffix) ? suffix : SUFFIX[dialect]);
}

function newEditor(file, label) {
  const line = () => {
    if (!problems.focus(editors[file])) say(server === null ? "Problems are looked for once the first run is over." : "No problem is known in this line.");
    return true;
  };
  const keys = [
    { key: "Ctrl-Enter", mac: "Cmd-Enter", run: () => (start(), true) },
    { key: "Mod-.", run: line },
  ];
  const changed = (all) => {
    results.age(true);
    // The editor takes no other change before this one is complete.
    if (all && file === "program") queueMicrotask(() => rename("program"));
  };
  return new Editor(element(`panel-${file}`), label, { file, keys, changed, marked: (editor, marks) => problems.show(editor, marks) });
}

function choose(file) {
  for (const each of FILES) {
    const tab = element(`tab-${each}`);
    tab.setAttribute("aria-selected", String(each === file));
    tab.tabIndex = each === file ? 0 : -1;
    element(`panel-${each}`).hidden = each !== file;
  }
}

// ---------------------------------------------------------------------- a run

function start(given = []) {
  if (python === null || python.running) return;
  answers = given;
  results.clear();
  for (const editor of Object.values(editors)) editor.markRun([]);
  element("ask").hidden = true;
  busy(true);
  say(python.ready ? "Running …" : "Loading Python; the program runs as soon as it is there …");
  began = performance.now();
  python.run({ ...request(), answers, inputs: switchedOn() });
}

function stop(why) {
  element("ask").hidden = true;
  python?.stop(why);
}

// Of Run and Stop one is enabled, and gets the focus if the other one has it.
function busy(is) {
  const [on, off] = is ? ["stop", "run"] : ["run", "stop"];
  const focused = document.activeElement === element(off);
  element(on).disabled = false;
  if (focused) element(on).focus();
  element(off).disabled = true;
}

const HEARD = {
  ready: ({ loaded }) => {
    if (!("loaded" in document.documentElement.dataset)) measure("loaded", loaded);
    if (python.running) say("Running …");
    // Any other sentence stays, such as why a run was ended or what is wrong with a link.
    else if (element("status").textContent === LOADING) say(READY);
  },
  output: ({ text }) => results.print(text),
  asks: ({ question }) => {
    element("question").textContent = question;
    element("answer").value = "";
    element("ask").hidden = false;
    element("answer").focus();
    say("The program asks for INPUT.");
  },
  result: (result) => {
    results.result(result);
    showInputs(result.inputs ?? []);
    for (const file of FILES) editors[file].markRun(result.marks.filter(({ tab }) => tab === file));
    if (result.marks.some(({ tab }) => tab === "machine")) choose("machine");
    measure("table", performance.now() - began);
    if (!("first" in document.documentElement.dataset)) measure("first", performance.now());
    say(HOW[result.status] ?? `The run is over: ${result.status}.`);
  },
  details: (details) => results.details(details),
  done: () => {
    busy(false);
    measure("runs", ++runs);
    // What follows takes seconds of the processor, so the page is painted first.
    if (runs === 1) requestAnimationFrame(() => setTimeout(() => python.serve(served)));
  },
  failed: ({ text, loaded }) => {
    busy(false);
    say(loaded ? `The program could not be run: ${text}.` : `Python could not be loaded: ${text}. Run tries again.`);
  },
  ended: ({ why }) => {
    busy(false);
    if (why) say(why);
  },
};

// ---------------------------------------------------------------------- the language server

// A server is there, or null: it is gone.
async function served(transport) {
  server?.close();
  server = null;
  for (const editor of Object.values(editors)) editor.markServer([]);
  element("keys").hidden = true;
  if (transport === null) return;
  const { connect } = await import("./lsp.js");
  server = connect(transport, editors);
  server.open(request());
  element("keys").hidden = false;
}

// ---------------------------------------------------------------------- links

async function share() {
  try {
    shared = await toFragment(request());
  } catch (error) {
    return say(error instanceof BadLink ? error.message : "This browser cannot make a link.");
  }
  history.replaceState(null, "", `#${shared}`);
  try {
    await navigator.clipboard.writeText(location.href);
    say("The link is in the address bar and on the clipboard. The program is in the link, and on no server.");
  } catch {
    say("The link is in the address bar. The program is in the link, and on no server.");
  }
}

// True if the address has a program; it is shown, and runs only when the reader says so.
async function openLink() {
  const fragment = location.hash.slice(1);
  if (!fragment || fragment === shared) return false;
  let kept;
  try {
    const file = await fromFragment(fragment);
    kept = keep();
    open(file);
  } catch (error) {
    say(error instanceof BadLink ? error.message : "This browser cannot read the link.");
    return false;
  }
  element("gallery").value = "";
  say(`This program came with the link. Press Run to run it.${kept}`);
  return true;
}

// ---------------------------------------------------------------------- the page

function listen() {
  element("bar").addEventListener("submit", (event) => {
    event.preventDefault();
    start();
  });
  element("stop").addEventListener("click", () => stop("The run was ended."));
  element("share").addEventListener("click", share);
  element("dialect").addEventListener("change", ({ target }) => {
    name = named({ name, dialect: target.value });
    results.age(true);
    editors.program.syntax = LANGUAGES[target.value];
    server?.open(request());
  });
  element("ask").addEventListener("submit", (event) => {
    event.preventDefault();
    start([...answers, element("answer").value]);
  });
  element("switches").addEventListener("change", () => results.age(true));
  element("tabs").addEventListener("click", ({ target }) => choose(target.id.slice("tab-".length)));
  element("tabs").addEventListener("keydown", ({ key, target }) => {
    if (key !== "ArrowLeft" && key !== "ArrowRight") return;
    const other = target.id === "tab-program" ? "machine" : "program";
    choose(other);
    element(`tab-${other}`).focus();
  });
  addEventListener("keydown", (event) => {
    if (event.key !== "Enter" || !(event.ctrlKey || event.metaKey) || event.defaultPrevented) return;
    event.preventDefault(); // Firefox would go on to press the button that has the focus now, which is Stop
    start();
  });
  addEventListener("hashchange", openLink);
  addEventListener("pagehide", () => drafts.save(request()));
}

// The reader's own programs, above the examples.
function listDrafts() {
  const list = element("gallery");
  list.querySelector("#yours")?.remove();
  if (!drafts.all.length) return;
  const group = document.createElement("optgroup");
  group.id = "yours";
  group.label = "Yours";
  group.append(...drafts.all.map(({ label }, number) => new Option(label, `${number}`)));
  list.firstElementChild.after(group);
}

function fillGallery(gallery) {
  const groups = { mint: "Mint", mccl: "MCCL" };
  for (const [dialect, label] of Object.entries(groups)) {
    const group = document.createElement("optgroup");
    group.label = label;
    for (const each of gallery.filter((one) => one.dialect === dialect)) {
      const option = new Option(each.needs ? `${each.name} (needs ${each.needs})` : each.name, each.name);
      group.append(option);
    }
    element("gallery").append(group);
  }
  element("gallery").addEventListener("change", ({ target: { value } }) => {
    const number = /^\d+$/.test(value) ? Number(value) : null;
    const chosen = number === null ? gallery.find((one) => one.name === value) : drafts.all[number];
    if (!chosen) return;
    const kept = keep();
    history.replaceState(null, "", location.pathname + location.search);
    open(number === null ? chosen : drafts.all[number], number);
    element("gallery").value = value;
    if (chosen.needs) say(`This program needs ${chosen.needs}, which a browser does not have: install motionlang to run it.${kept}`);
    else say(kept.trim() || READY);
  });
}

// The results of the first example, from when the page was built.
async function showFirst() {
  const messages = await (await fetch(new URL("first.json", import.meta.url))).json();
  if (runs || python.running || element("gallery").value !== first || results.any) return;
  for (const message of messages) {
    if (message.type === "output") results.print(message.text);
    else if (message.type === "result") results.result(message);
    else if (message.type === "details") results.details(message);
  }
}

async function begin() {
  listen();
  editors.program.syntax = LANGUAGES.mint;
  const [contents, linked] = await Promise.all([
    fetch(new URL("contents.json", import.meta.url)).then((answer) => answer.json()),
    openLink(),
  ]);
  element("version").textContent = `motionlang ${contents.version}, commit ${contents.commit}`;
  // The pages of the documentation, which the playground is part of, link here with ?docs.
  element("docs").hidden = !new URLSearchParams(location.search).has("docs");
  fillGallery(contents.gallery);
  const number = drafts.restore();
  listDrafts();
  if (linked || editors.program.text) return;
  const draft = number === null ? undefined : drafts.all[number];
  first = contents.first;
  open(draft ?? contents.gallery.find((one) => one.name === first), draft ? number : null);
  element("gallery").value = draft ? `${number}` : first;
  if (!draft) await showFirst();
}

if (typeof WebAssembly !== "object") {
  say("This page needs WebAssembly, which this browser does not have or has disabled.");
} else {
  python = new Python((message) => HEARD[message.type](message));
  element("run").disabled = false;
  begin().catch((error) => say(`The page is incomplete: ${error.message || error}.`));
}
