"""The comparison of a recording with a run, as text.

It shows the error of each signal, and each move with its lag and overshoot.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from functools import partial
from typing import TYPE_CHECKING, Any

from motionlang.views.diagnostics import diagnostics_table
from motionlang.views.formatting import dialect_name, figure, formatter, line_number, outcome
from motionlang.views.report import with_phases
from motionlang.views.table import Column, Document, Table
from motionlang.views.terminal import printable, styled

if TYPE_CHECKING:
    from motionlang.commands.compare.comparison import Comparison

Row = dict[str, Any]

# At most this many moves are shown with their phases; of more than `MAX_MOVES`, only the worst are shown.
WITH_PHASES, MAX_MOVES = 6, 40


_LAG = Column("lag", unit="ms", text=lambda seconds: f"{round(1000.0 * seconds, 3) + 0.0:.3f}")


def _verdict_on(row: Row) -> str:
    if row["peak"] is None:
        return "not recorded"
    return {None: "", True: "within", False: "exceeded"}[row["within"]]


_VERDICT = (Column("within", data=True), Column("", get=_verdict_on, left=True))


def comparison_document(made: Comparison, recording: str) -> Document:
    """Return the comparison with the file `recording` as data; phases of moves have a table of their own."""
    phases = [
        {**phase, "signal": move["signal"], "move": number}
        for number, move in enumerate(made.moves)
        for phase in move["phases"]
    ]
    columns = (Column("signal"), Column("move"), Column("name"), *_peaks(phases), *_VERDICT)
    values: dict[str, object] = {"program": made.baseline.name, "read": made.recording.sentence}
    values |= {"delay": made.delay, "within": made.is_within}
    tables = [moves_table(made.moves), signals_table(made.signals), Table("phases", columns, phases)]
    return Document([*tables, diagnostics_table((recording, each) for each in made.remarks)], values)


def render_comparison(
    made: Comparison, *, width: int = 100, colour: bool = False, everything: bool = False
) -> str:
    """Return the comparison as text that ends with a newline.

    If there are very many moves, only the worst are shown, unless `everything` is set.
    """
    run, baseline = made.baseline.run, made.baseline
    name = styled(printable(baseline.name), "bold", colour)
    head = printable(baseline.sentence)
    if run is not None:
        head = f"{name} · {dialect_name(run.dialect.name)} · {outcome(run)}"
    sections = [[printable(made.recording.sentence), head, _delay_text(made.delay, baseline.noun)]]
    sections.append(signals_table(made.signals).lines(width, colour=colour))
    if made.moves:
        sections.append(_moves(made.moves, everything).lines(width, colour=colour))
    if made.is_within is not None:
        verdict = "every residual is within its tolerance" if made.is_within else _verdict(made)
        sections.append([styled(verdict, "note" if made.is_within else "error", colour)])
    return "\n\n".join("\n".join(section) for section in sections) + "\n"


def _delay_text(delay: float, noun: str) -> str:
    size = f"{abs(delay):.6f}"
    if not float(size):
        return f"the recording starts with {noun}"
    return f"the recording is {size} s {'later' if delay > 0.0 else 'earlier'} than {noun}"


def signals_table(rows: Sequence[Row]) -> Table:
    """Return the table of the signals of a recording."""
    columns = (
        Column("signal", left=True, style="word"),
        Column("column", left=True, drop=2),
        Column("points", drop=3),
        Column("scale", text="{:.6g}".format, drop=1),
        Column("offset", unit="uu", text="{:z.6f}".format, drop=1),
        Column("moves", data=True),
        _LAG,
        *_peaks(rows),
        *_VERDICT,
    )
    return Table("signals", columns, rows)


def moves_table(rows: Sequence[Row]) -> Table:
    """Return the table of the moves; a row without a command is a phase."""
    six = partial(figure, decimals=6)
    largest, at, rms = _peaks([row for row in rows if "phase" not in row])
    columns = (
        Column("signal", left=True, style="word"),
        Column("axis", data=True),
        Column("command", "move", left=True, text=lambda command: printable(command or "move")),
        Column("line", text=line_number),
        Column("start_time", "start", "s", text=six, drop=1),
        Column("duration", data=True),
        _LAG,
        largest,
        replace(at, drop=1),
        rms,
        Column("overshoot", unit="uu", text=six),
        *_VERDICT,
    )
    return Table("moves", columns, rows, style=lambda row: row.get("phase", ""))


def _peaks(rows: Sequence[Row]) -> tuple[Column, Column, Column]:
    """Return the columns of the largest residual, its time and the RMS, of the same decimals."""
    size = formatter(row[name] for row in rows for name in ("peak", "rms") if row["peak"] is not None)
    return (
        Column("peak", "largest", "uu", text=size),
        Column("peak_time", "at", "s", text=partial(figure, decimals=6)),
        Column("rms", "RMS", "uu", text=size),
    )


def _verdict(made: Comparison) -> str:
    beyond = [row for row in made.moves if row["within"] is False]
    if not beyond:
        return "a residual exceeds its tolerance while nothing moved"
    if len(made.moves) == 1:
        return "the move exceeds its tolerance"
    return f"{len(beyond)} of {len(made.moves)} moves exceed their tolerance"


def _moves(rows: Sequence[Row], everything: bool) -> Table:
    shown = list(rows)
    if len(rows) > MAX_MOVES and not everything:
        worst = sorted(rows, key=lambda row: (-abs(row["peak"] or 0.0), row["start_time"]))[:MAX_MOVES]
        shown = sorted(worst, key=lambda row: row["start_time"])
    table = moves_table(with_phases(shown) if everything or len(rows) <= WITH_PHASES else shown)
    if len(shown) < len(rows):
        table.notes.append(f"the {len(shown)} worst of {len(rows)} moves; --all shows all")
    return table
