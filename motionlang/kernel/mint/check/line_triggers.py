"""Report when the program reaches a line with a fault of the machine file.

A call of a hidden keyword, which no program can write, is inserted before the first statement of such a line.
To the later stages it is a command like any other, so it is executed between statements, at its own time.
"""

from __future__ import annotations

from collections.abc import Mapping

from motionlang.kernel.errors import Diagnostic
from motionlang.kernel.lang.syntax.word import Word
from motionlang.kernel.mint.resolve.problems import Problems
from motionlang.kernel.mint.syntax import nodes
from motionlang.kernel.mint.syntax.traversal import walk

WORD = "(line)"


def mark(module: nodes.Module, settings: Mapping[str, object], problems: Problems) -> None:
    """Insert the calls of the hidden keyword into the tree.

    A line without a statement is reported as an error of the machine file.
    """
    faults: list[Mapping[str, int]] = settings.get("fault", [])  # type: ignore[assignment]
    wanted = {entry["line"] for entry in faults if "line" in entry}
    if not wanted:
        return
    missing = set(wanted)
    for body in _bodies(module):
        _mark_body(module, body, wanted, missing)
    for line in sorted(missing):
        message = f"the machine file has a fault at line {line}, where no statement begins"
        found = Diagnostic("machine-file", message, line, hint="give a line on which a statement begins")
        problems.add_to_line(line, found)


def _bodies(module: nodes.Module) -> list[list[nodes.Stmt]]:
    """Return every list of statements, including the nested ones."""
    roots = [value for name in type(module).__slots__ if isinstance(value := getattr(module, name), list)]
    found = [root for root in roots if root and isinstance(root[0], nodes.Stmt)]
    for node in walk([each for root in roots for each in root]):
        for slot in type(node).__slots__:
            value = getattr(node, slot)
            if isinstance(value, list) and value and isinstance(value[0], nodes.Stmt):
                found.append(value)
    return found


def _mark_body(module: nodes.Module, body: list[nodes.Stmt], wanted: set[int], missing: set[int]) -> None:
    position = 0
    while position < len(body):
        node = body[position]
        line = module.line(node.start)
        if line in wanted and line in missing:
            missing.discard(line)
            name = nodes.Name(node.start, node.end, Word(WORD), [nodes.Number(node.start, node.end, line)])
            body.insert(position, nodes.Call(node.start, node.end, name))
            position += 1
        position += 1
