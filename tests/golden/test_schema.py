"""`motionlang.report/3`: reports match its JSON Schema, and its page is complete."""

from __future__ import annotations

import json
import re
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest

from motionlang.cli.program_files import programs
from motionlang.kernel import Run, Source, run
from motionlang.kernel.controller import fault_names
from motionlang.kernel.report import failure, text
from tests.cases import cases
from tests.views.runs import ballscrew, ended, new_run, pick, shift

jsonschema = pytest.importorskip("jsonschema")

ROOT = Path(__file__).parents[2]
SCHEMA: dict[str, Any] = json.loads((ROOT / "docs" / "report.schema.json").read_text(encoding="utf-8"))
PAGE = (ROOT / "docs" / "report.md").read_text(encoding="utf-8")
GALLERY = programs([str(ROOT / "scripts")])


def check(document: str) -> None:
    jsonschema.Draft202012Validator(SCHEMA).validate(json.loads(document))


@cases("program", GALLERY, ids=lambda path: str(Path(path).relative_to(ROOT / "scripts")))
def test_every_golden_report_keeps_to_the_schema(program: str) -> None:
    """Another test compares the golden files with the programs' present reports."""
    check(Path(program).with_suffix(".golden.json").read_text(encoding="utf-8"))


def runs() -> Iterator[Run]:
    yield from (ballscrew(), pick(), shift(60))
    still, _ = new_run("hello.mnt")
    yield ended(still, "open")
    huge, controller = new_run()
    controller.set_scale(0, 5e-324)
    controller.move_by(0, 1e12, "MOVER", 1)
    controller.clock.advance(1.0)
    yield ended(huge)
    for program, dialect in (
        ("MOVR(0) = 1\n", "mint"),
        ("PRINT 1 / 0\n", "mint"),
        ("PRINT #2, 5\nMODBUSTCP32(4, 6) = -1\nREMOTEOUTX(1, 2, 3) = 1\nREMOTEDAC(1, 2, 3) = -5\n", "mint"),
        ("1XX\n9MR5\n", "mccl"),
        ("", "mccl"),
    ):
        yield run(Source("x", program), dialect=dialect)


def test_whatever_happens_a_report_keeps_to_the_schema() -> None:
    for each in runs():
        check(text(each))
    check(failure("x.txt", "", []))


def test_an_overflow_is_null() -> None:
    documents = [json.loads(text(each)) for each in runs()]
    assert None in [move["distance"] for document in documents for move in document["moves"]]


def tables() -> Iterator[tuple[str, list[str]]]:
    """Yield the heading and the first column of every table on the page."""
    for found in re.finditer(r"^\| (.*?) \|.*\n\|[-|]+\n((?:\|.*\n)+)", PAGE, re.MULTILINE):
        yield (
            found[1],
            [name for row in found[2].splitlines() for name in re.findall(r"`([\w-]+)`", row.split("|")[1])],
        )


def test_the_page_names_every_field_in_the_order_of_the_schema() -> None:
    explained = [names for head, names in tables() if head == "field"]
    definitions = SCHEMA["$defs"]
    names = (
        "move",
        "dropped",
        "phase",
        "move_motor",
        "printed",
        "switched",
        "written",
        "event",
        "axis",
        "motor",
        "diagnostic",
        "terminal",
        "device_write",
    )
    objects = [SCHEMA, *(definitions[name] for name in names)]
    assert explained == [list(each["properties"]) for each in objects]


def test_the_page_names_every_value() -> None:
    found = {head: names for head, names in tables() if head not in ("field", "command") and names}
    assert found == {
        "`status`": SCHEMA["properties"]["status"]["enum"],
        "`ended`": SCHEMA["$defs"]["move"]["properties"]["ended"]["enum"],
        "`kind`": SCHEMA["$defs"]["device_write"]["properties"]["kind"]["enum"],
    }


def test_the_page_tells_every_bit_of_an_axis_s_error() -> None:
    bits = ", ".join(f"{1 << k} {fault_names(1 << k)}" for k in range(32) if fault_names(1 << k))
    assert f"its faults as bits: {bits} |" in PAGE
