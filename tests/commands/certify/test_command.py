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


def test_the_report_has_the_lines(cell: Cell) -> None:
    jsonschema = pytest.importorskip("jsonschema")
    cell.write("stroke.mnt", STROKE)
    cell.write("stroke.machine.toml", f"{LIMITS}jerk = 1e6\ntorque = 1\n")
    report = json.loads(cell("certify", "stroke.mnt", "--format", "json").out)
    jsonschema.validate(report, json.loads(SCHEMA.read_text()))
    assert [
        (line["name"], line["reached"], line["line"], line["verdict"]) for line in report["certificate"]
    ] == [
        ("speed", 200.0, 3, "within"),
        ("acceleration", 1000.0, 3, "within"),
        ("jerk", None, 3, "exceeded"),
        ("torque", None, 0, "unknown"),
    ]
