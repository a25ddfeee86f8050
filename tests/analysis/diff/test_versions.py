"""Reports and golden files of version 1 get the field names of version 2."""

from __future__ import annotations

import json
import re
from pathlib import Path
from typing import Any

import pytest

from motionlang.analysis.certificate import certificate, violations
from motionlang.analysis.diff.reports import difference
from motionlang.analysis.diff.versions import FIELDS, VALUES, current
from motionlang.execution import run
from motionlang.report import SCHEMA, build, rendered
from motionlang.source import Source

# The program of the stored report, which has every field that was renamed.
PRESS = """\
SPEED(0) = 200 : ACCEL(0) = 1000 : DECEL(0) = 1000
MOVEA(0) = 100 : GO(0)
WAIT(300)
STOP(0)
PAUSE IDLE(0)
REMOTEOBJECTFLOAT(1, 2, 7, 1) = 5
PRINT "stopped at ", POS(0)
"""
LIMITS = {"axis.0.limits.speed": 150.0}
PAGE = Path(__file__).parents[3] / "docs" / "report.md"


@pytest.fixture
def old() -> dict[str, Any]:
    made: dict[str, Any] = json.loads(Path(__file__).with_name("version1.json").read_text(encoding="utf-8"))
    return made


def new() -> dict[str, Any]:
    result = run(Source("press.mnt", PRESS), machine=LIMITS)
    result.certificate = certificate(result.controller, result.machine.settings, result.time)
    result.diagnostics += violations(result.certificate)
    return build(result)


def test_the_stored_report_has_every_renamed_field(old: dict[str, Any]) -> None:
    now = current(old)
    assert not FIELDS[""].keys() & now.keys()
    assert FIELDS[""].keys() <= old.keys()
    for name, was in (("moves", old["moves"]), ("events", old["events"]), ("device_writes", old["written"])):
        assert FIELDS[name].keys() <= was[0].keys()
        assert not FIELDS[name].keys() & now[name][0].keys()
    assert (old["certificate"][0]["verdict"], now["certificate"][0]["verdict"]) == ("beyond", "exceeded")


def test_a_report_of_version_1_equals_that_of_the_same_run(old: dict[str, Any]) -> None:
    assert current(old) == new()
    assert difference(old, new()).same
    assert difference(new(), old).same


def test_a_changed_speed_is_found_across_versions(old: dict[str, Any]) -> None:
    old["moves"][0]["asked_speed"] = 250.0
    (change,) = difference(old, new()).lines
    assert change.figures == {"commanded_speed": (250.0, 200.0)}


def test_a_report_of_another_version_is_refused(old: dict[str, Any]) -> None:
    with pytest.raises(ValueError, match=r"its schema is motionlang\.report/3"):
        difference(old | {"schema": "motionlang.report/3"}, new())


def test_a_report_of_version_1_may_be_rendered_as_version_2(old: dict[str, Any]) -> None:
    text = rendered(current(old))
    assert SCHEMA in text
    assert not re.search('asked_speed|not_counted|ordered_by|readings|beyond"', text)


def test_the_page_shows_the_table_of_names() -> None:
    of_reports = PAGE.read_text("utf-8").partition("## Other")[0]
    rows = {
        (cells[0], cells[1], cells[2])
        for cells in re.findall(r"^\| ([\w ]+) \| `([\w: ]+)` \| `([\w: ]+)` \|$", of_reports, re.M)
    }
    of = {
        "": "report",
        "moves": "move",
        "events": "event",
        "device_writes": "device write",
        "certificate": "limit",
    }
    named = {(of[name], a, b) for name, fields in FIELDS.items() for a, b in fields.items()}
    named |= {
        (of[name], f"{field}: {a}", f"{field}: {b}")
        for (name, field), values in VALUES.items()
        for a, b in values.items()
    }
    assert rows == named
