"""The commands' documents have the tables and values that docs/report.md lists, and CSV has the first of the tables."""

from __future__ import annotations

import csv
import json
import re
from pathlib import Path

import pytest

from tests.cli.programs import Cell
from tests.extras import INSTALLED, MISSING

REPORT = Path(__file__).parents[2] / "docs" / "report.md"
PAGES = [REPORT, *(page for each in INSTALLED for page in each.glob("docs/commands/*.md"))]
PAGE = "".join(page.read_text(encoding="utf-8") for page in PAGES)
# The command, the table, "" for single values, and the fields.
ROWS = re.findall(r"^\| `([a-z -]+)` \| (?:`(\w+)`)? ?\| (.+) \|$", PAGE, re.MULTILINE)
START = "SPEED(0) = {speed} : ACCEL(0) = 1000 : DECEL(0) = 1000\nMOVER(0) = 100 : GO(0) : PAUSE IDLE(0)\n"
# It prints, exceeds a limit and ends with an error.
PROGRAM = START.format(speed=100) + (
    'PRINT "a"\nSOFTLIMITFORWARD(0) = 150\nMOVER(0) = 100 : GO(0) : PAUSE IDLE(0)\nn = 0 : PRINT 1 / n\n'
)
OTHER = START.format(speed=120) + 'PRINT "b"\n'
COMMANDS = {
    "check": "check a.mnt",
    "compare": "compare b.mnt b.csv --map position.0=p",
    "diff": "diff a.mnt b.mnt",
    "help": "help HOMESPEED",
    "plan": "plan --distance 20 --time 0.6 --rule third",
    "profile": "profile b.mnt",
    "pvt plot": "pvt plot --scurve 1000 --time 100",
    "pvt refine": "pvt refine --positions=0,200,900,500 --time 20",
    "servo compare": "servo compare --speed 100 --accel 1000 --distance 50",
    "servo run": "servo run b.mnt",
    "servo step": "servo step",
    "servo tune": "servo tune",
    "sweep": "sweep b.mnt --vary SPEED[0]@1=100,120",
    "verify": "verify b.mnt",
}
EXTRAS = {
    "copley": {"copley stream": "copley stream --scurve 1000 --time 100"},
    "explore": {"cover": "cover a.mnt", "map": "map a.mnt", "improve": "improve c.mnt"},
}
COMMANDS |= {name: line for each in INSTALLED for name, line in EXTRAS.get(each.name, {}).items()}


@pytest.fixture
def files(cell: Cell) -> Cell:
    cell.write("a.mnt", PROGRAM)
    cell.write("b.mnt", OTHER)
    cell.write("c.mnt", OTHER)
    cell.write("c.machine.toml", "[axis.0.limits]\nspeed = 200.0\nacceleration = 2000.0\n")
    cell.write("b.csv", "time,p\n" + "".join(f"{time / 100},{min(time, 95)}\n" for time in range(120)))
    return cell


def fields_of(command: str) -> dict[str, list[str]]:
    """Return the fields that the page names, by table."""
    found = {table: fields.split(", ") for name, table, fields in ROWS if name == command}
    if command == "sweep":
        found["rows"] = ["variant", "SPEED[0]@1", "time", "problem"]
    return found


def test_the_page_has_every_document() -> None:
    assert {name.split(" --")[0] for name, _, _ in ROWS} - MISSING == {*COMMANDS, "certify"} - MISSING


@pytest.mark.parametrize("command", COMMANDS)
def test_a_command_prints_the_tables_that_the_page_names(command: str, files: Cell) -> None:
    fields = fields_of(command)
    document = json.loads(files(*COMMANDS[command].split(), "--format", "json").out)
    assert list(document) == ["schema", *fields.pop("", []), *fields]
    assert document["schema"] == "motionlang/1"
    for table, names in fields.items():
        assert not document[table] or list(document[table][0]) == names


@pytest.mark.parametrize("command", COMMANDS)
def test_csv_has_the_first_table(command: str, files: Cell) -> None:
    fields = fields_of(command)
    fields.pop("", None)
    table = next(iter(fields))
    rows = json.loads(files(*COMMANDS[command].split(), "--format", "json").out)[table]
    printed = files(*COMMANDS[command].split(), "--format", "csv").out
    assert [row.keys() for row in csv.DictReader(printed.splitlines())] == [row.keys() for row in rows]
    assert printed.splitlines()[0] == ",".join(fields[table])


def test_the_rows_of_a_run_as_csv(files: Cell) -> None:
    """The output of the program is not among them."""
    assert (
        files("run", "b.mnt", "--format", "csv").out
        == """\
axis,command,line,profile,start_time,duration,start,end,distance,peak_speed,commanded_speed,ended
0,MOVER,2,trapezoid,4e-05,0.9533333333333333,0.0,100.0,100.0,120.0,120.0,
"""
    )
