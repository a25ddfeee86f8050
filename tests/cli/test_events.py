"""The events of a run, and the exit status that they cause."""

from __future__ import annotations

import json
import re
from typing import Any

import pytest

from motionlang.kernel import Source, run
from motionlang.kernel.report import build
from tests.cli.programs import Cell
from tests.test_docs import ROOT

TRAVEL: dict[str, object] = {"axis.0.travel": [-100.0, 100.0]}
SETTINGS = "SPEED(0) = 50 : ACCEL(0) = 500 : DECEL(0) = 500 : ERRORDECEL(0) = 500\n"


def events(
    program: str, machine: dict[str, object] | None = None, name: str = "a.mnt"
) -> list[dict[str, Any]]:
    result = run(Source(name, program), machine=machine or {}, until=20.0)
    found: list[dict[str, Any]] = build(result)["events"]  # type: ignore[assignment]
    return found


# A program, its machine, and the kinds of its events with value, limit, line, and line of the motion.
CASES: dict[str, tuple[str, dict[str, object], list[tuple[object, ...]]]] = {
    "a limit switch": (
        SETTINGS + "MOVER(0) = 200 : GO(0)\nPAUSE IDLE(0)\n",
        TRAVEL,
        [("limit", 100.0, 100.0, 3, 2), ("velocity jump", 50.0, 0.0, 3, 2)],
    ),
    "a soft limit": (
        SETTINGS + "SOFTLIMITFORWARD(0) = 20\nMOVER(0) = 200 : GO(0)\nPAUSE IDLE(0)\nRESET(0)\n",
        {},
        [
            ("soft limit", 20.0, 20.0, 4, 3),
            ("velocity jump", 50.0, 0.0, 4, 3),
            ("cleared", None, None, 5, None),
        ],
    ),
    "a clamp, once": (
        "MAXSPEED(0) = 30\n" + SETTINGS + "JOG(0) = 80\nJOG(0) = 80\nWAIT 100\nSTOP(0)\n",
        {},
        [("clamp", 80.0, 30.0, 3, 3), ("stop", 30.0, None, 6, 3)],
    ),
    "a limit lowered during a jog": (
        "MAXSPEED(0) = 60\n" + SETTINGS + "JOG(0) = 50\nWAIT 500\nMAXSPEED(0) = 30\nWAIT 500\nSTOP(0)\n",
        {},
        [("clamp", 50.0, 30.0, 5, 3), ("stop", 30.0, None, 7, 3)],
    ),
    "a stop in no time": (
        SETTINGS + "JOG(0) = 50\nWAIT 500\nCANCEL(0)\n",
        {},
        [("cancel", 50.0, None, 4, 2), ("velocity jump", 50.0, 0.0, 4, 2)],
    ),
    "another override": (
        SETTINGS
        + "FEEDRATEMODE(0) = 2\nMOVER(0) = 50 : GO(0)\nWAIT 300\nFEEDRATEOVERRIDE(0) = 50\nPAUSE IDLE(0)\n",
        {},
        [("override", 0.5, None, 5, 3)],
    ),
    "a full buffer": (
        SETTINGS + "MOVER(0) = 5 : GO(0)\n" * 4 + "PAUSE IDLE(0)\n",
        {},
        [("buffer full", None, None, 5, None)],
    ),
    "a fault and its handler": (
        SETTINGS + "MOVER(0) = 50 : GO(0)\nPAUSE IDLE(0)\nEnd\nEvent ONERROR\nRESET(0)\nEnd Event\n",
        {"fault": [{"axis": 0, "kind": "drive", "at": 0.5}]},
        [
            ("fault", None, None, 3, 2),
            ("velocity jump", 50.0, 0.0, 3, 2),
            ("handler", None, None, 3, None),
            ("cleared", None, None, 6, None),
        ],
    ),
    "a wait that runs out": ("PAUSE IN(3)\n", {"run.until": 5.0}, [("wait", None, None, 1, None)]),
}


@pytest.mark.parametrize("case", CASES)
def test_what_happened(case: str) -> None:
    program, machine, expected = CASES[case]
    found = events(program, machine)
    reported = [
        (
            each["kind"],
            None if "value" not in each else pytest.approx(each["value"], abs=1e-3),
            each.get("limit"),
            each["line"],
            each.get("commanded_by"),
        )
        for each in found
    ]
    assert expected == reported


def test_a_limit_that_a_homing_meets_is_no_matter(cell: Cell) -> None:
    """The switch is beyond the travel limit, so the homing ends at the limit.

    Any other motion into the limit causes status 1.
    """
    cell.write("home.machine.toml", "[axis.0]\ntravel = [-10.0, 100.0]\nhome_switch = [-22.0, -20.0]\n")
    for word, text, status in (
        ("HOMESPEED(0) = 20\nHOME(0) = _hmNEGATIVE_SWITCH", "homing", 0),
        ("MOVER(0) = -20 : GO(0)", "reverse limit, abort", 1),
    ):
        cell.write("home.mnt", f"{SETTINGS}{word}\nPAUSE IDLE(0)\n")
        ran = cell("run", "home.mnt", "--format", "json")
        limits = [each for each in json.loads(ran.out)["events"] if each["kind"] == "limit"]
        assert [(each["text"], round(each["value"], 9), each["limit"]) for each in limits] == [
            (text, -10.0, -10.0)
        ], word
        assert (ran.status, "--allow limit" in ran.err) == (status, status == 1), word


def test_the_exit_status_is_that_of_the_events_and_allow_takes_them_off(cell: Cell) -> None:
    cell.write("a.mnt", CASES["a limit switch"][0])
    cell.write("a.machine.toml", "[axis.0]\ntravel = [-100.0, 100.0]\n")
    ran = cell("run", "a.mnt", "--format", "none")
    assert (ran.status, ran.out) == (1, "")
    assert "a.mnt:2: limit on axis 0 at 2.05005 s (forward limit, abort); --allow limit accepts it" in ran.err
    for allowed, status in (("limit", 0), ("all", 0), ("soft-limit,fault", 1), ("fault, limit", 0)):
        assert cell("run", "a.mnt", "--format", "none", "--allow", allowed).status == status, allowed
    wrong = cell("run", "a.mnt", "--allow", "limits")
    assert (
        wrong.status,
        "'limits' is no event that a run can accept: choose from limit, soft-limit" in wrong.err,
    ) == (
        2,
        True,
    )


def test_a_fault_that_is_handled_is_no_matter(cell: Cell) -> None:
    cell.write("a.machine.toml", '[[fault]]\naxis = 0\nkind = "drive"\nat = 0.5\n')
    program = CASES["a fault and its handler"][0]
    for text, status in ((program, 0), (program.partition("Event")[0], 1)):
        cell.write("a.mnt", text)
        assert cell("run", "a.mnt", "--format", "none").status == status, text


def test_the_table_has_them_and_the_commanded_speed(cell: Cell) -> None:
    cell.write("a.mnt", CASES["a clamp, once"][0])
    ran = cell("run", "a.mnt")
    assert re.search(r"peak +commanded", ran.out)
    assert re.search(r"clamp +0 +80\S* +30", ran.out)
    many = (
        "JOG(0) = 10\nDim n As Integer\nFor n = 1 To 60\nJOG(0) = 10 + n\nWAIT 1\nSTOP(0)\nNext\nCANCEL(0)\n"
    )
    cell.write("many.mnt", many)
    ran = cell("run", "many.mnt")
    assert "stop 60" in ran.out
    assert "--all shows all" in ran.out


def test_every_kind_has_its_row_on_the_page() -> None:
    page = (ROOT / "docs" / "events.md").read_text(encoding="utf-8")
    schema = json.loads((ROOT / "docs" / "report.schema.json").read_text(encoding="utf-8"))
    for kind in schema["$defs"]["event"]["properties"]["kind"]["enum"]:
        assert f"`{kind}`" in page, kind


def test_an_event_before_the_first_statement_has_no_line(cell: Cell) -> None:
    """The enable input is off at power-up, before any statement has run."""
    cell.write("a.machine.toml", "[axis.0]\nenable_input = 2\n[[input]]\nchannel = 2\nat = 0.5\nvalue = 1\n")
    cell.write("a.mnt", "PAUSE INX(2)\nDRIVEENABLE(0) = 1\nMOVER(0) = 5 : GO(0)\n")
    ran = cell("run", "a.mnt", "--format", "none")
    assert ran.status == 1
    assert ran.err == "a.mnt: e-stop on axis 0 at 0 s (input 2 is off); --allow fault accepts it\n"
