"""The cost of typing in an editor: `name value unit` lines, relative to parsing.

    python benchmarks/editor.py [LINES [KEYS]]

The text is a program of 10 000 lines; the time of parsing it once is 1. A check after a key can reuse the
previous check, and the key changes one sub. A key is a change and a completion, as messages of the protocol in
this process: JSON in, JSON out. There is no pause between keys, so no names are searched for and no check begins: the
names are those of the text before the first key, moved. The formatting is one after another of nearly the same text.
Memory is that of this process after KEYS keys (default 3000), relative to that after the first hundred.
"""

from __future__ import annotations

import asyncio
import json
import sys
from pathlib import Path
from statistics import median
from time import process_time

from parse_program import program
from timing import seconds

from motionlang.editor.formatting import format
from motionlang.editor.page import Page
from motionlang.editor.tokens import tokens
from motionlang.lang.dialect import dialect
from motionlang.lsp.server import Server, prepare
from motionlang.lsp.workers import Inline
from motionlang.mint.syntax.parser import parse
from motionlang.source import Source

ROUNDS = 5
KEYS = 3_000
FIRST = 100
URI = "file:///nowhere/a.mnt"
TYPED = "movea(0) = pos(0)"


def main(arguments: list[str]) -> int:
    """Measure and print."""
    count = int(arguments[0]) if arguments else 10_000
    typed = int(arguments[1]) if len(arguments) > 1 else KEYS
    lines = program(count * 60)[0].split("\n")[:count]
    while lines and lines[-1] != "End Sub":
        lines.pop()
    text = "\n".join(lines) + "\n"
    source, language = Source("a.mnt", text), dialect("mint")
    prepare()
    parses, names, checks, shown = [], [], [], []
    for _ in range(ROUNDS):
        parses.append(seconds(lambda: parse(source)))
        names.append(seconds(lambda: language.names(source)) / parses[-1])
        page = Page(source, language)
        assert page.names.complete
        shown.append(seconds(lambda page=page: list(tokens(page, 5000, 5059))) / parses[-1])  # type: ignore[misc]
    again, laid_out = [], []
    format(Page(source, language))
    known: dict[object, object] = {}
    for number in range(ROUNDS):
        checks.append(seconds(lambda: language.check(source)) / median(parses))
        edited = Source("a.mnt", "\n".join([*lines[:-1], f"  x = {number}", lines[-1]]) + "\n")
        laid_out.append(seconds(lambda edited=edited: format(Page(edited, language))) / median(parses))  # type: ignore[misc]
        language.check(source, None, known)
        again.append(seconds(lambda edited=edited: language.check(edited, None, known)) / median(parses))  # type: ignore[misc]
    print(f"editor_lines {len(lines)} lines")
    print(f"editor_parse {median(parses) * 1e3:.0f} ms")
    print(f"editor_names {median(names):.2f} parses")
    print(f"editor_check {median(checks):.1f} parses")
    print(f"editor_check_after_a_key {median(again):.1f} parses")
    print(f"editor_formatting {median(laid_out):.3f} parses")
    print(f"editor_tokens_of_60_lines {median(shown):.3f} parses")
    keys, memory = asyncio.run(type_keys(text, len(lines), typed))
    keys = sorted(key / median(parses) for key in keys)
    print(f"editor_key {median(keys):.3f} parses")
    print(f"editor_key_95 {keys[int(0.95 * len(keys))]:.3f} parses")
    if memory:
        print(f"editor_memory {memory:.3f} of_that_at_first")
    return 0


class Typist:
    """An editor that types the same line repeatedly and asks for completion."""

    def __init__(self, text: str) -> None:
        self.server = Server(Inline())
        self.server.protocol.set_writer(self, include_headers=False)
        self.version = self.written = 0
        self._send(
            {
                "id": 1,
                "method": "initialize",
                "params": {"processId": None, "rootUri": None, "capabilities": {}},
            }
        )
        item = {"uri": URI, "languageId": "mint", "version": 0, "text": text}
        self._send({"method": "textDocument/didOpen", "params": {"textDocument": item}})

    def write(self, data: bytes) -> None:
        self.written += len(data)

    def close(self) -> None:
        """Do nothing."""

    def key(self, line: int, column: int, sign: str) -> None:
        """Type a character, or delete the line if `sign` is empty; ask for completion."""
        self.version += 1
        begin, end = (
            {"line": line, "character": 0 if not sign else column},
            {"line": line, "character": column},
        )
        change = {"range": {"start": begin, "end": end}, "text": sign}
        document = {"uri": URI, "version": self.version}
        self._send(
            {
                "method": "textDocument/didChange",
                "params": {"textDocument": document, "contentChanges": [change]},
            }
        )
        if not sign.isalnum():
            return  # an editor asks within a word
        position = {
            "textDocument": {"uri": URI},
            "position": {"line": line, "character": column + 1 if sign else 0},
        }
        self._send({"id": self.version + 1, "method": "textDocument/completion", "params": position})

    def _send(self, message: dict[str, object]) -> None:
        protocol = self.server.protocol
        protocol.handle_message(
            json.loads(json.dumps({"jsonrpc": "2.0", **message}), object_hook=protocol.structure_message)
        )


async def type_keys(text: str, count: int, typed: int) -> tuple[list[float], float]:
    """Return the seconds of each key, and the memory afterwards in pages (0: unknown)."""
    typist = Typist(text + "\n")
    known = typist.server.session.known(URI)
    assert known is not None
    await typist.server.session.named(known, known.document.source)
    taken, first = [], 0
    for number in range(typed):
        column = number % (len(TYPED) + 1)
        sign = TYPED[column] if column < len(TYPED) else ""
        began = process_time()
        typist.key(count, column, sign)
        taken.append(process_time() - began)
        if number == FIRST:
            first = resident()
    return taken, resident() / first if first else 0.0


def resident() -> int:
    """Return the memory of this process in pages; 0 if there is no `/proc`."""
    try:
        return int(Path("/proc/self/statm").read_text(encoding="ascii").split()[1])
    except OSError:
        return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
