"""`motionlang certify`: a table to sign, JSON, a folder, and a sweep."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from tests.cli.programs import Cell

SCHEMA = Path(__file__).parents[3] / "docs" / "report.schema.json"
STROKE = """\
Const rate = 1000
SPEED(0) = 200 : ACCEL(0) = rate : DECEL(0) = rate
MOVEA(0) = 100 : GO(0) : PAUSE IDLE(0)
"""
LIMITS = "[axis.0.limits]\nspeed = 250\nacceleration = 1500\n"


def test_limits_that_are_met_and_exceeded(cell: Cell) -> None:
    cell.write("stroke.mnt", STROKE)
    cell.write("stroke.machine.toml", LIMITS)
    ran = cell("certify", "stroke.mnt")
    assert (ran.status, ran.err) == (0, "")
    for line in ("2 of 2 limits met", "   0  speed         uu/s       250      200", "checked by ____"):
        assert line in ran.out
    ran = cell("certify", "stroke.mnt", "--set", "rate=1600", "--format", "none")
    assert ran.status == 1
    assert "the acceleration of axis 0 reaches 1600 uu/s² at" in ran.err
    assert "stroke.mnt:3" in ran.err


def test_what_has_no_bound_is_infinite_and_where_limits_belong_is_named(cell: Cell) -> None:
    cell.write("stroke.mnt", STROKE)
    ran = cell("certify", "stroke.mnt", "--format", "none")
    assert ran.status == 1
    assert "hint: add a section such as [axis.0.limits]" in ran.err
    cell.write("stroke.machine.toml", "[axis.0.limits]\njerk = 1e6\n")
    ran = cell("certify", "stroke.mnt")
    assert ran.status == 1
    # From the start; there is no margin for an infinite value.
    assert "   0  jerk   uu/s³    1e+06      inf  0.000040     3    none  exceeded" in ran.out
    assert "the jerk of axis 0 is infinite at 0.000040 s, because its acceleration jumps" in ran.err


def test_the_report_has_the_lines(cell: Cell) -> None:
    jsonschema = pytest.importorskip("jsonschema")
    cell.write("stroke.mnt", STROKE)
    cell.write("stroke.machine.toml", f"{LIMITS}jerk = 1e6\ntorque = 1\n")
    report = json.loads(cell("certify", "stroke.mnt", "--format", "json").out)
    jsonschema.validate(report, json.loads(SCHEMA.read_text()))
    assert [(line["name"], line["reached"], line["verdict"]) for line in report["certificate"]] == [
        ("speed", 200.0, "within"),
        ("acceleration", 1000.0, "within"),
        ("jerk", None, "exceeded"),
        ("torque", None, "unknown"),
    ]


def test_a_folder_and_a_sweep(cell: Cell) -> None:
    cell.write("stroke.mnt", STROKE)
    cell.write("stroke.machine.toml", LIMITS)
    cell.write("other.mnt", STROKE)
    for name in ("wrong.mcl", "jog.mcl", "ballscrew.mcl"):
        (cell.folder / name).unlink()
    ran = cell("certify", ".")
    assert (ran.status, ran.err) == (0, "")
    assert ran.out.endswith("1 of 1 machines within their limits\nno limits given for 1: other.mnt\n")
    (cell.folder / "stroke.machine.toml").unlink()
    assert cell("certify", ".").status == 1
    cell.write("stroke.machine.toml", LIMITS)
    ran = cell("sweep", "stroke.mnt", "--vary", "rate=1000:2000:5", "--certify", "--keep", "margin")
    assert ran.status == 1
    assert "2 of 5 variants failed\n  beyond-limit: the acceleration of axis 0 reaches 1750" in ran.err
    assert [line.split() for line in ran.out.splitlines()[2:]] == [
        ["1000", "0.2"],
        ["1250", "0.166667"],
        ["1500", "0"],
    ]
    ran = cell("certify", "stroke.mnt", "--set", "axis.0.limits.speed=-3")
    assert ran.status == 2
    assert "axis.0.limits.speed must be a number above 0" in ran.err
