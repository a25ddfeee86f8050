"""The commands' JSON documents use the names that docs/report.md lists."""

from __future__ import annotations

import json
import re
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest

from tests.cli.programs import Cell

PAGE = (Path(__file__).parents[2] / "docs" / "report.md").read_text(encoding="utf-8")
SCHEMAS = re.findall(r"^\| `(motionlang\.\w+/\d)` \| `motionlang ([\w ]+?)[` -]", PAGE, re.MULTILINE)
START = "SPEED(0) = {speed} : ACCEL(0) = 1000 : DECEL(0) = 1000\nMOVER(0) = 100 : GO(0) : PAUSE IDLE(0)\n"
# It prints, exceeds a limit and ends with an error.
PROGRAM = START.format(speed=100) + (
    'PRINT "a"\nSOFTLIMITFORWARD(0) = 150\nMOVER(0) = 100 : GO(0) : PAUSE IDLE(0)\nn = 0 : PRINT 1 / n\n'
)
OTHER = START.format(speed=120) + 'PRINT "b"\n'
COMMANDS = {
    "check": "check --evidence --format json {folder}/a.mnt",
    "compare": "compare {folder}/b.mnt {folder}/b.csv --map position.0=p --format json",
    "cycle": "profile {folder}/b.mnt --format json",
    "diff": "diff {folder}/a.mnt {folder}/b.mnt --format json",
    "keywords": "help HOMESPEED --format json",
    "plan": "plan --distance 20 --time 0.6 --rule third --format json",
    "pvt": "pvt stream --scurve 1000 --time 100 --format json",
    "servo": "servo step --format json",
    "sweep": "sweep {folder}/b.mnt --vary SPEED[0]@1=100,120 --format json",
    "verify": "verify {folder}/b.mnt --update --format json",
}


def document(cell: Cell, name: str) -> Any:
    """Return the output of a command that prints a document with a schema."""
    cell.write("a.mnt", PROGRAM)
    cell.write("b.mnt", OTHER)
    positions = (f"{time / 100},{min(time, 95)}\n" for time in range(120))
    cell.write("b.csv", "time,p\n" + "".join(positions))
    return json.loads(cell(*COMMANDS[name].format(folder=cell.folder).split()).out)


def names(value: Any) -> Iterator[str]:
    """Yield the names of all fields of a document."""
    if isinstance(value, dict):
        yield from value
        value = list(value.values())
    if isinstance(value, list):
        for each in value:
            yield from names(each)


@pytest.mark.parametrize(("schema", "command"), SCHEMAS)
def test_a_command_prints_the_schema_that_the_page_names(cell: Cell, schema: str, command: str) -> None:
    name = schema.split(".")[1].partition("/")[0]
    assert command.split()[0] == COMMANDS[name].split()[0]
    assert document(cell, name)["schema"] == schema


def test_the_page_has_every_document() -> None:
    assert [schema.split(".")[1].partition("/")[0] for schema, _ in SCHEMAS] == list(COMMANDS)
