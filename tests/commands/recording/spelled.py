"""One recording of one machine, and how it is written in a file."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field
from datetime import UTC, datetime, timedelta
from functools import cache
from pathlib import Path
from random import Random
from typing import NamedTuple

import numpy as np

from motionlang.commands.compare.baseline import baseline_of, read_compared
from motionlang.commands.compare.comparison import compare
from motionlang.commands.recording import RecordedTable
from motionlang.kernel import Run, Source, run

STEP = 0.02
PROGRAM = """\
SPEED(0) = 100 : ACCEL(0) = 1000 : DECEL(0) = 1000
WAIT(100)
For i = 1 To 4
  OUTX(1) = 1
  PAUSE INX(1)
  OUTX(1) = 0
  MOVER(0) = 30 : GO(0) : PAUSE IDLE(0)
  OUTX(2) = 1
  PAUSE INX(1) = 0
  OUTX(2) = 0
  MOVER(0) = -20 : GO(0) : PAUSE IDLE(0)
Next
WAIT(400)
"""
WORLD = {"input": [{"channel": 1, "output": 1, "delay": 0.35, "for": 1.2}]}
BEGIN = "2024-05-06 07:58:59"


class Level(int):
    """A level that is written as a number, or as a word or a voltage."""

    def __format__(self, form: str) -> str:
        words = {"w": ("FALSE", "TRUE"), "o": ("off", "on"), "v": ("0.04", "23.9"), "m": ("0", "-1")}
        return words[form][self] if form in words else str(int(self))


class Moment(NamedTuple):
    """A row: seconds, position, and the levels of input 1 and of outputs 1 and 2."""

    t: float
    x: float
    a: Level
    b: Level
    c: Level


@dataclass
class Spelling:
    """A section of the table: the head, the form of a row, options, and the warnings that it leads to."""

    title: str
    lines: list[str] = field(default_factory=list)
    options: dict[str, str] = field(default_factory=dict)
    warnings: list[str] = field(default_factory=list)


def spellings(path: Path) -> list[Spelling]:
    """Return the sections of a table of spellings."""
    found: list[Spelling] = []
    for line in path.read_text(encoding="utf-8").splitlines():
        if line.startswith("== "):
            found.append(Spelling(line[3:]))
        elif found and line.startswith("@ "):
            name, _, value = line[2:].partition(" ")
            found[-1].options[name] = value
        elif found and line.startswith("! "):
            found[-1].warnings.append(line[2:])
        elif found and line.strip():
            found[-1].lines.append(line)
    return found


@cache
def machine() -> Run:
    """Return the run of the machine that is recorded."""
    return run(Source("machine.mnt", PROGRAM), dialect="mint", machine=WORLD)


@cache
def moments() -> tuple[Moment, ...]:
    """Return the rows of the recording."""
    result = machine()
    times = np.arange(int(result.time / STEP), dtype=np.float64) * STEP
    positions = result.trace.at(0, "position", times).tolist()
    levels = []
    log = result.machine.log
    for changes in (
        [(each.time, each.value) for each in log.inputs if each.channel == 1],
        *([(each.time, each.value) for each in log.outputs if each.channel == n] for n in (1, 2)),
    ):
        at = np.searchsorted([time for time, _ in changes], times, "right") - 1
        levels.append([Level(bool(changes[k][1])) if k >= 0 else Level(0) for k in at.tolist()])
    return tuple(map(Moment, times.tolist(), positions, *levels))


def text_of(spelling: Spelling, rows: Sequence[Moment] | None = None) -> str:
    """Return the recording in a spelling."""
    *head, form = spelling.lines
    zero = datetime.fromisoformat(spelling.options.get("begin", BEGIN)).replace(tzinfo=UTC)
    jump = int(spelling.options.get("jump", 0))
    lines = []
    for k, each in enumerate(moments() if rows is None else rows):
        date = zero + timedelta(milliseconds=round(1000.0 * each.t))
        if jump and each.t >= 3.0:
            date += timedelta(seconds=jump)
        epoch = round(1000.0 * (zero.timestamp() + each.t))
        ms = round(1000.0 * each.t)
        fields = {
            **each._asdict(), "ms": ms, "us": 1000 * ms, "ns": 1_000_000 * ms, "d": date, "k": k,
            "epoch": epoch / 1000.0, "epoch_ms": epoch, "thousandth": date.microsecond // 1000,
            "days": 25569.0 + epoch / 86_400_000.0, "whole": ms // 1000,
            "tc": f"{each.t:.3f}".replace(".", ","), "xc": f"{each.x:.4f}".replace(".", ","),
        }  # fmt: skip
        lines.append(form.format(**fields))
    lines = ordered(lines, spelling.options.get("order", ""))
    if "holes" in spelling.options:
        lines = with_holes(lines, int(spelling.options["holes"]))
    if "footer" in spelling.options:
        lines.append(spelling.options["footer"])
    return "\n".join([*head, *lines, ""])


def ordered(lines: list[str], order: str) -> list[str]:
    """Return lines as a logger of some order writes them."""
    if order == "newest":
        return lines[::-1]
    if order == "shuffled":
        return Random(5).sample(lines, len(lines))
    if order == "restarted":
        return [*lines[20:120], *lines]
    if order == "swapped":
        for k in range(1, len(lines) - 1, 10):
            lines[k], lines[k + 1] = lines[k + 1], lines[k]
    if order == "doubled":
        return [line for k, line in enumerate(lines) for _ in range(1 + (k % 9 == 0))]
    if order == "outlier":
        time, _, rest = lines[90].partition(",")
        lines[90] = f"{float(time) + 900.0},{rest}"
    return lines


def with_holes(lines: list[str], seed: int) -> list[str]:
    """Return lines in which a few positions are missing."""
    chance = Random(seed)
    for k in range(40, len(lines), 50):
        cells = lines[k].split(",")
        cells[1] = chance.choice(["", "NaN", "---"])
        lines[k] = ",".join(cells)
    return lines


def write(spelling: Spelling, folder: Path, rows: Sequence[Moment] | None = None) -> Path:
    """Write the recording in a spelling, and return its file."""
    text, form = text_of(spelling, rows), spelling.options.get("format", "csv")
    path = folder / f"rec.{form}"
    if form == "csv":
        newline = "\r\n" if spelling.options.get("newline") == "crlf" else "\n"
        path.write_bytes(text.replace("\n", newline).encode(spelling.options.get("encoding", "utf-8")))
        return path
    head, *lines = text.splitlines()
    columns = dict(zip(head.split(","), zip(*(row.split(",") for row in lines), strict=True), strict=True))
    write_parquet(columns, path)
    return path


def write_parquet(columns: dict[str, tuple[str, ...]], path: Path) -> None:
    """Write columns with the types that their cells have."""
    import pyarrow as pa  # type: ignore[import-untyped]
    from pyarrow.parquet import write_table  # type: ignore[import-untyped]

    made = {}
    for name, cells in columns.items():
        if ":" in cells[0]:
            made[name] = pa.array([datetime.fromisoformat(cell) for cell in cells], pa.timestamp("us"))
        elif cells[0] in ("TRUE", "FALSE"):
            made[name] = pa.array([cell == "TRUE" for cell in cells])
        else:
            made[name] = pa.array([float(cell) for cell in cells])
    write_table(pa.table(made), path, row_group_size=100)


class Answer(NamedTuple):
    """What `compare` says about a recording: delay, largest residual, points, and remarks."""

    delay: float
    residual: float
    points: int
    remarks: list[str]


def answer(table: RecordedTable) -> Answer:
    """Return what `compare` says about a recording."""
    baseline = baseline_of(machine())
    made = compare(baseline, read_compared(table, [], baseline))
    (signal,) = made.signals
    remarks = list(dict.fromkeys(each.message for each in made.recording.remarks))
    return Answer(made.delay, abs(signal["peak"]), signal["points"], remarks)
