"""The limit certificate on a terminal: a table with a signature line."""

from __future__ import annotations

from collections.abc import Sequence
from hashlib import sha256
from math import inf

from motionlang.commands.certify import CertifiedLimit, omissions
from motionlang.commands.certify.motion import VerifiedMotion
from motionlang.kernel import Run
from motionlang.kernel.tools import count_of
from motionlang.kernel.version import __version__
from motionlang.views.formatting import figure, line_number
from motionlang.views.table import Column, Table
from motionlang.views.terminal import styled


def limits_table(lines: Sequence[CertifiedLimit]) -> Table:
    """Return the limits of a certificate, each with its verdict."""
    columns = (
        Column("axis"),
        Column("name", "limit", left=True),
        Column("unit", "", left=True),
        Column("limit", "allowed", text="{:.6g}".format),
        Column("reached", text=lambda reached: f"{reached + 0.0:.6g}"),
        Column("time", "at", "s", text=lambda time: figure(time, 6), drop=2),
        Column("line", text=line_number, drop=1),
        Column("", "margin", get=_margin),
        Column("margin", data=True),
        Column("verdict", "", text=VERDICTS.__getitem__, left=True),
    )
    return Table("limits", columns, lines, style=lambda line: "" if line.verdict == "within" else "error")


VERDICTS = {"within": "", "exceeded": "exceeded", "unknown": "unknown: no motor is simulated"}


def certificate_lines(
    run: Run,
    lines: Sequence[CertifiedLimit],
    motion: VerifiedMotion,
    machine: str,
    *,
    width: int,
    colour: bool = False,
) -> list[str]:
    """Return the certificate as lines.

    It has the table, the verified motion, the digests of the certified inputs and a signature line, or, if the run
    does not cover all motion, what is missing.
    """
    within = sum(line.verdict == "within" for line in lines)
    out = [styled(f"limits of {run.source.name}", "bold", colour)]
    out += limits_table(lines).lines(width, colour=colour)
    out += ["", *_zeros(run, lines), f"{within} of {len(lines)} limits met"]
    out.append(conclusion_of(motion))
    out.append(
        f"program {_digest(run.source.text)}, machine file {_digest(machine)}, motionlang {__version__}"
    )
    missing = [f"not complete: {each}" for each in omissions(run, lines)]
    return [*out, "", *(missing or ["checked by ______________________________   date ______________"])]


def conclusion_of(motion: VerifiedMotion) -> str:
    """Return how much motion is verified, or the number of violations."""
    if motion.violations:
        return f"motion not verified: {count_of(len(motion.violations), 'violation')}"
    checked = f"{count_of(motion.moves, 'move')}, {count_of(motion.pieces, 'piece')}"
    return f"motion verified: {checked if motion.moves else 'nothing moved'}"


def _zeros(run: Run, lines: Sequence[CertifiedLimit]) -> list[str]:
    """Return from where the positions of each axis count that was homed or given another zero."""
    out, log = [], run.machine.log
    changed = {each.axis for each in log.zeros}
    for number in dict.fromkeys(line.axis for line in lines if "position" in line.name):
        a = run.controller.axes[number]
        if a.home is not None:
            zero = f"homing, {figure(a.scale.to_user(a.home))} uu from that of power-up"
            out.append(f"positions of axis {number}: from the zero of its last {zero}")
        elif number in changed:
            out.append(f"positions of axis {number}: from the zero of power-up, since the axis is not homed")
    return out


def _margin(line: CertifiedLimit) -> str:
    if line.reached == inf:
        return "none"
    if line.margin is None:
        return ""
    return f"{figure(line.margin)} uu" if "position" in line.name else f"{100.0 * line.margin:.1f} %"


def _digest(text: str) -> str:
    """Return the start of a text's SHA-256, which identifies it."""
    return f"sha256 {sha256(text.encode('utf-8', 'surrogatepass')).hexdigest()[:16]}"
