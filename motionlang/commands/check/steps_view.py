"""The steps of a program beside its lines, for `check --steps`."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from motionlang.kernel import Dialect
from motionlang.kernel.lang import ListedStep, ListedUnit
from motionlang.views.highlight import pieces
from motionlang.views.table import Column, Table
from motionlang.views.terminal import printable, styled

# The styles of the tokens of a program's line, by kind.
_STYLES = {"move": "word", "keyword": "word", "not-simulated": "warning", "comment": "dim"}


def render_steps(dialect: Dialect, units: Sequence[ListedUnit], *, colour: bool) -> Iterator[str]:
    """Return the lines of a list of steps, those of the program with their numbers."""
    for unit in units:
        if unit.name:
            yield styled(unit.name, "bold", colour) + "\n"
        for line in unit.lines:
            if line.line:
                yield f"{line.line:>4}  {_highlighted(dialect, line.text, colour)}\n"
            yield from (f"{_step(each)}\n" for each in line.steps)


def steps_table(found: Sequence[tuple[str, Sequence[ListedUnit]]]) -> Table:
    """Return the steps of files as data; those without a target or a cost have none."""
    rows = [
        {
            "file": file,
            "unit": unit.name,
            "line": line.line,
            "index": step.index,
            "kind": step.kind,
            "target": step.target if step.target >= 0 else None,
            "cost": step.cost or None,
        }
        for file, units in found
        for unit in units
        for line in unit.lines
        for step in line.steps
    ]
    columns = tuple(map(Column, ("file", "unit", "line", "index", "kind", "target", "cost")))
    return Table("steps", columns, rows)


def _highlighted(dialect: Dialect, text: str, colour: bool) -> str:
    text = printable(text.expandtabs().rstrip())
    return "".join(styled(piece, _STYLES.get(kind, ""), colour) for _, kind, piece in pieces(dialect, text))


def _step(step: ListedStep) -> str:
    does = f"{step.kind} to {step.target}" if step.target >= 0 else step.kind
    pays = f"{step.cost:g} statement{'' if step.cost == 1.0 else 's'}" if step.cost else ""
    return f"{step.index:>9}  {does:<18}{pays}".rstrip()
