// The editor gives every word of the gallery the kind that the package gives it.

import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { createRequire } from "node:module";
import { test } from "node:test";

const require = createRequire(new URL("../../playground/package.json", import.meta.url));
const native = JSON.parse(readFileSync(process.env.NATIVE, "utf-8"));

// What the page has in its bundle, with the highlighter of CodeMirror.
const { outputFiles } = await require("esbuild").build({
  stdin: {
    contents: `export { LANGUAGES, TAGS } from "./highlight.js"; export { highlightTree, tagHighlighter } from "@lezer/highlight";`,
    resolveDir: new URL("../../playground", import.meta.url).pathname,
  },
  bundle: true,
  format: "esm",
  write: false,
});
const { LANGUAGES, TAGS, highlightTree, tagHighlighter } = await import(
  `data:text/javascript;base64,${Buffer.from(outputFiles[0].contents).toString("base64")}`
);
const KINDS = tagHighlighter(Object.entries(TAGS).map(([name, tag]) => ({ tag, class: name })));

function kinds(dialect, text) {
  const found = [];
  highlightTree(LANGUAGES[dialect].parser.parse(text), KINDS, (from, to, kind) => {
    if (kind !== "name") found.push([from, kind, text.slice(from, to)]);
  });
  return found;
}

for (const [name, { text, tokens }] of Object.entries(native.kinds)) {
  test(`the kinds of ${name}`, () => assert.deepEqual(kinds(name.split("/")[0], text), tokens));
}
