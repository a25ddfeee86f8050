// Highlighting of Mint and MCCL by the tables of the package, which keywords.json has (python -m tools.derived).

import { StreamLanguage } from "@codemirror/language";
import { tags } from "@lezer/highlight";
import tables from "./keywords.json";

// The kinds of keywords.json, and those of the texts below, as CodeMirror names them.
export const TAGS = {
  move: tags.function(tags.variableName),
  keyword: tags.propertyName,
  "not-simulated": tags.deleted,
  control: tags.keyword,
  axis: tags.labelName,
  register: tags.special(tags.variableName),
  number: tags.number,
  string: tags.string,
  comment: tags.comment,
  name: tags.variableName,
};

function kinds(table) {
  const found = new Map();
  for (const [kind, words] of Object.entries(table)) for (const word of words.split(" ")) found.set(word, kind);
  return found;
}

const MINT = kinds(tables.mint);
const MCCL = kinds(tables.mccl);

function mintToken(stream, state) {
  const begins = state.begins;
  if (stream.eatSpace()) return null;
  state.begins = false;
  if (stream.peek() === "'") return stream.skipToEnd(), "comment";
  if (begins && stream.match(/rem\b/i)) return stream.skipToEnd(), "comment";
  if (stream.match(/"(?:[^"\\]|\\.)*(?:"|$)/) || stream.match(/`(?:[^`\\]|\\.)`/)) return "string";
  if (stream.match(/0[xX][0-9a-fA-F]+|0[bB][01]+|(?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d+)?/)) return "number";
  const word = stream.match(/([A-Za-z_]\w*)(?:\.\d+)*/); // POS.0 of Mint v4 is the keyword POS
  if (word) return MINT.get(word[1].toLowerCase()) ?? "name";
  state.begins = stream.next() === ":";
  return null;
}

function mcclToken(stream, state) {
  if (stream.sol()) {
    state.inside = false;
    if (stream.match(/\s*#.*/)) return "comment";
  }
  if (stream.match(/;.*/)) return "comment";
  if (stream.match(/[, \t]+/)) return (state.inside = false), null;
  if (!state.inside) {
    if (stream.match(/\d+(?=[A-Za-z])/)) return "axis";
    const word = stream.match(/[A-Za-z]{2}/);
    if (word) return (state.inside = true), MCCL.get(word[0].toLowerCase()) ?? "name";
  }
  state.inside = true;
  if (stream.match(/"[^"]*(?:"|$)/)) return "string";
  if (stream.match(/@\w*/)) return "register";
  if (stream.match(/[^;, \t"]+/)) return "number";
  stream.next();
  return null;
}

export const LANGUAGES = {
  mint: StreamLanguage.define({
    name: "mint",
    startState: () => ({ begins: true }),
    token: (stream, state) => {
      if (stream.sol()) state.begins = true;
      return mintToken(stream, state);
    },
    tokenTable: TAGS,
    languageData: { commentTokens: { line: "'" } },
  }),
  mccl: StreamLanguage.define({
    name: "mccl",
    startState: () => ({ inside: false }),
    token: mcclToken,
    tokenTable: TAGS,
    languageData: { commentTokens: { line: ";" } },
  }),
};
