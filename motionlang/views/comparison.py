"""The comparison of a recording with a run, as text.

It shows the error of each signal, and each move with its lag and overshoot.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

from motionlang.views.grid import Column, decimals_of, grid
from motionlang.views.terminal import printable, styled
from motionlang.views.words import dialect_name, figure, outcome

if TYPE_CHECKING:
    from motionlang.analysis.compare.comparison import Comparison

Row = dict[str, Any]

# At most this many moves are shown with their phases; of more than `MAX_MOVES`, only the worst are shown.
WITH_PHASES, MAX_MOVES = 6, 40

_SIGNALS = (
    Column("signal", align="<", style="word"),
    Column("column", align="<", drop=2),
    Column("points", drop=3),
    Column("scale", drop=1),
    Column("offset", "uu", drop=1),
    Column("lag", "ms"),
    Column("largest", "uu"),
    Column("at", "s"),
    Column("RMS", "uu"),
    Column("", align="<"),
)
_MOVES = (
    Column("signal", align="<", style="word"),
    Column("move", align="<"),
    Column("line"),
    Column("start", "s", drop=1),
    Column("lag", "ms"),
    Column("largest", "uu"),
    Column("at", "s", drop=1),
    Column("RMS", "uu"),
    Column("overshoot", "uu"),
    Column("", align="<"),
)


def render_comparison(
    made: Comparison, *, width: int = 100, colour: bool = False, everything: bool = False
) -> str:
    """Return the comparison as text that ends with a newline.

    If there are very many moves, only the worst are shown, unless `everything` is set.
    """
    run = made.run
    head = f"{styled(printable(run.source.name), 'bold', colour)} · {dialect_name(run.dialect.name)} · {outcome(run)}"
    later = "later" if made.delay >= 0.0 else "earlier"
    sections = [[head, f"the recording is {abs(made.delay):.6f} s {later} than the run"]]
    sections.append(
        grid(_SIGNALS, [_signal(row, made.signals) for row in made.signals], width=width, colour=colour)
    )
    if made.moves:
        sections.append(_moves(made.moves, width, colour, everything))
    if made.is_within is not None:
        verdict = "every residual is within its tolerance" if made.is_within else _verdict(made)
        sections.append([styled(verdict, "note" if made.is_within else "error", colour)])
    return "\n\n".join("\n".join(section) for section in sections) + "\n"


def _verdict(made: Comparison) -> str:
    beyond = [row for row in made.moves if row["within"] is False]
    if not beyond:
        return "a residual exceeds its tolerance while nothing moved"
    if len(made.moves) == 1:
        return "the move exceeds its tolerance"
    return f"{len(beyond)} of {len(made.moves)} moves exceed their tolerance"


def _signal(row: Row, rows: Sequence[Row]) -> list[str]:
    return [
        row["signal"],
        printable(row["column"]),
        str(row["points"]),
        f"{row['scale']:.6g}",
        figure(row["offset"], 6),
        _lag(row["lag"]),
        *_peaks(row, rows),
    ]


def _peaks(row: Row, rows: Sequence[Row]) -> list[str]:
    """Return the largest residual, its time, the RMS and the verdict."""
    if row["peak"] is None:
        return ["", "", "", "not recorded"]
    decimals = decimals_of(
        [each[name] for each in rows for name in ("peak", "rms") if each["peak"] is not None]
    )
    verdict = {None: "", True: "within", False: "exceeded"}[row["within"]]
    return [figure(row["peak"], decimals), figure(row["peak_time"], 6), figure(row["rms"], decimals), verdict]


def _lag(seconds: float | None) -> str:
    return "" if seconds is None else f"{1000.0 * seconds:.3f}"


def _moves(rows: Sequence[Row], width: int, colour: bool, everything: bool) -> list[str]:
    shown = list(rows)
    if len(rows) > MAX_MOVES and not everything:
        worst = sorted(rows, key=lambda row: (-abs(row["peak"] or 0.0), row["start_time"]))[:MAX_MOVES]
        shown = sorted(worst, key=lambda row: row["start_time"])
    texts, styles = [], []
    for row in shown:
        texts.append(_move(row, shown))
        styles.append("")
        for k, phase in enumerate(row["phases"] if everything or len(rows) <= WITH_PHASES else []):
            mark = "└" if k == len(row["phases"]) - 1 else "├"
            peak, at, rms, verdict = _peaks(phase, shown)
            texts.append(["", f"{mark} {phase['name']}", "", "", "", peak, at, rms, "", verdict])
            styles.append(phase["name"])
    lines = grid(_MOVES, texts, width=width, colour=colour, styles=styles)
    if len(shown) < len(rows):
        lines.append(styled(f"the {len(shown)} worst of {len(rows)} moves; --all shows all", "dim", colour))
    return lines


def _move(row: Row, rows: Sequence[Row]) -> list[str]:
    overshoot = row.get("overshoot")
    peak, at, rms, verdict = _peaks(row, rows)
    return [
        row["signal"],
        printable(row["command"] or "move"),
        str(row["line"] or ""),
        figure(row["start_time"], 6),
        _lag(row["lag"]),
        peak,
        at,
        rms,
        "" if overshoot is None else figure(overshoot, 6),
        verdict,
    ]
