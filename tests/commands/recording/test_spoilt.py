"""Recordings that are damaged: an answer or a sentence, and never an internal error."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from contextlib import suppress
from pathlib import Path
from random import Random

import pytest

from motionlang.commands.compare.baseline import baseline_of, read_compared
from motionlang.commands.compare.comparison import compare
from motionlang.commands.recording import read_file
from motionlang.kernel import ProgramError
from tests.cli.programs import Cell
from tests.commands.recording.spelled import PROGRAM, machine, moments, spellings, write

TABLE = spellings(Path(__file__).parent / "spellings.txt")

# Cells that are no number, or none of a measurement.
WRONG = [*b'1e308 -1e308 inf nan " 12:00:00 1.1.1 99:99:99 \xb2 0x1F'.split(), b"", b"9" * 30]


def spoilt(data: bytes, chance: Random) -> bytes:
    """Return a file with bytes changed, rows cut or repeated, columns swapped, or an end that is missing."""
    kind = chance.choice(("bytes", "rows", "columns", "cells", "end", "begin"))
    if kind == "bytes":
        changed = bytearray(data)
        for _ in range(chance.choice((1, 5, 50, 500))):
            changed[chance.randrange(len(changed))] = chance.randrange(256)
        return bytes(changed)
    if kind in ("end", "begin"):
        at = chance.randrange(len(data))
        return data[:at] if kind == "end" else data[at:]
    lines = data.split(b"\n")
    if kind == "rows":
        for _ in range(chance.choice((1, 20, 200))):
            at = chance.randrange(len(lines))
            put = chance.choice(([], [lines[at][: chance.randrange(9)]], [lines[at]] * 3))
            lines[at : at + chance.randrange(3)] = put
            lines = lines or [b""]
        return b"\n".join(lines)
    sign = chance.choice((b",", b";", b"\t", b" "))
    since = chance.randrange(len(lines))
    for at in range(since, len(lines)):
        cells = lines[at].split(sign)
        if kind == "columns":
            first, second = chance.randrange(len(cells)), chance.randrange(len(cells))
            cells[first], cells[second] = cells[second], cells[first]
        elif chance.random() < 0.1:
            cells[chance.randrange(len(cells))] = chance.choice(WRONG)
        lines[at] = sign.join(cells)
    return b"\n".join(lines)


def read(path: Path) -> None:
    """Read a file as `compare` does; an answer and a ProgramError are the same to this test."""
    baseline = baseline_of(machine())
    with suppress(ProgramError, OSError):
        recording = read_compared(read_file(str(path)), [], baseline)
        compare(baseline, recording)
        compare(baseline_of(recording), recording)


# The seeds of damage, and the rows of each recording.
DAMAGE = [
    pytest.param(range(30), 100, id="30"),
    pytest.param(range(100, 900), 400, id="800", marks=pytest.mark.slow),
]


@pytest.mark.parametrize(("seeds", "rows"), DAMAGE)
@pytest.mark.filterwarnings("error")
def test_a_spoilt_file_is_no_internal_error(seeds: range, rows: int, tmp_path: Path) -> None:
    read_spoilt(read, seeds, rows, tmp_path)


def read_spoilt(read: Callable[[Path], None], seeds: range, rows: int, folder: Path) -> None:
    """Read a spoilt recording for each seed; an exception names the seed."""
    files = [write(each, folder, moments()[:rows]).read_bytes() for each in TABLE]
    for seed in seeds:
        chance = Random(seed)
        number = chance.randrange(len(TABLE))
        path = folder / f"spoilt.{TABLE[number].options.get('format', 'csv')}"
        path.write_bytes(spoilt(files[number], chance))
        try:
            read(path)
        except Exception as error:
            raise AssertionError(f"seed {seed}, {TABLE[number].title}") from error


@pytest.mark.slow
def test_the_command_refuses_or_answers(cell: Cell) -> None:
    refuse_or_answer(("compare machine.mnt {} --until 9", "compare {0} {0}"), cell)


def refuse_or_answer(commands: Sequence[str], cell: Cell) -> None:
    """Check that commands end with 0 or 1 for spoilt recordings, without an internal error."""
    cell.write("machine.mnt", PROGRAM)
    files = [(each, write(each, cell.folder).read_bytes()) for each in TABLE]
    for seed in range(40):
        chance = Random(10_000 + seed)
        spelling, data = chance.choice(files)
        name = f"spoilt.{spelling.options.get('format', 'csv')}"
        cell.write(name, spoilt(data, chance))
        for command in commands:
            ran = cell(*command.format(name).split())
            assert ran.status in (0, 1), (seed, command, ran.err)
            assert "internal error" not in ran.err, (seed, command, ran.err)
        (cell.folder / "machine.machine.toml").unlink(missing_ok=True)
