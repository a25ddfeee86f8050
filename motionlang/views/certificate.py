"""The limit certificate on a terminal: a table with a signature line."""

from __future__ import annotations

from collections.abc import Sequence
from hashlib import sha256
from math import inf

from motionlang import __version__
from motionlang.analysis.certificate import Limit
from motionlang.analysis.proof.checker import Proof
from motionlang.errors import count_of
from motionlang.result import Run
from motionlang.views.grid import Column, grid
from motionlang.views.terminal import styled
from motionlang.views.words import figure

COLUMNS = (
    Column("axis"), Column("limit", align="<"), Column("", align="<"), Column("allowed"), Column("reached"),
    Column("at", "s", drop=2), Column("line", drop=1), Column("margin"), Column("", align="<"),
)  # fmt: skip


def certificate_lines(
    run: Run, lines: Sequence[Limit], proof: Proof | None, machine: str, *, width: int, colour: bool = False
) -> list[str]:
    """Return the certificate as lines.

    It has the table, the proof of the motion, the digests of the certified inputs and a signature line.
    """
    rows = [_row(line) for line in lines]
    styles = ["" if line.verdict == "within" else "error" for line in lines]
    within = sum(line.verdict == "within" for line in lines)
    out = [styled(f"limits of {run.source.name}", "bold", colour)]
    out += grid(COLUMNS, rows, width=width, colour=colour, styles=styles)
    out += ["", f"{within} of {len(lines)} limits met"]
    if proof is not None:
        broken = len(proof.violations)
        checked = ", ".join(count_of(count, name[:-1]) for name, count in proof.counts.items() if count)
        out.append(f"motion verified: {checked or 'nothing moved'}" if not broken
                   else f"the motion differs from the commands: {count_of(broken, 'violation')}")  # fmt: skip
    out.append(
        f"program {_digest(run.source.text)}, machine file {_digest(machine)}, motionlang {__version__}"
    )
    out += ["", "checked by ______________________________   date ______________"]
    return out


def _row(line: Limit) -> list[str]:
    margin = ""
    if line.reached == inf:
        margin = "none"
    elif line.margin is not None:
        margin = f"{figure(line.margin)} uu" if "position" in line.name else f"{100.0 * line.margin:.1f} %"
    return [
        str(line.axis),
        line.name,
        line.unit,
        f"{line.limit:.6g}",
        "" if line.reached is None else f"{line.reached + 0.0:.6g}",
        "" if line.time is None else figure(line.time, 6),
        str(line.line) if line.line else "",
        margin,
        {"within": "", "exceeded": "exceeded", "unknown": "unknown: no motor is simulated"}[line.verdict],
    ]


def _digest(text: str) -> str:
    """Return the start of a text's SHA-256, which identifies it."""
    return f"sha256 {sha256(text.encode('utf-8', 'surrogatepass')).hexdigest()[:16]}"
