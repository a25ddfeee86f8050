"""One machine file over another, and the axes that a machine file names."""

from __future__ import annotations

import pytest

from motionlang.kernel import ProgramError, missing_axes
from motionlang.kernel.lang import layered
from tests.cases import cases


@cases(
    "below, above, merged",
    [
        ({"controller.axes": 2, "run.until": 1.0}, {"run.until": 5.0}, {"controller.axes": 2, "run.until": 5.0}),
        # All entries of one channel are replaced; the others stay in front.
        (
            {"input": [{"channel": 1, "at": 1.0}, {"channel": 2, "at": 1.0}, {"channel": 1, "at": 2.0}]},
            {"input": [{"channel": 1, "at": 5.0}, {"channel": 3}]},
            {"input": [{"channel": 2, "at": 1.0}, {"channel": 1, "at": 5.0}, {"channel": 3}]},
        ),
        ({}, {"input": [{"channel": 1}]}, {"input": [{"channel": 1}]}),
        ({"input": [{"channel": 1}]}, {"analogue": [{"channel": 1}]},
         {"input": [{"channel": 1}], "analogue": [{"channel": 1}]}),
        # A subject has defaults: bus 1, sub-index 0, terminal 1.
        ({"bus": [{"event": "off"}]}, {"bus": [{"bus": 1, "event": "passive"}]},
         {"bus": [{"bus": 1, "event": "passive"}]}),
        ({"bus": [{"event": "off"}]}, {"bus": [{"bus": 2, "event": "passive"}]},
         {"bus": [{"event": "off"}, {"bus": 2, "event": "passive"}]}),
        # An answer without a prompt replaces all; one with a prompt those whose prompt contains it, or is in it.
        ({"answer": [{"text": "a"}, {"text": "b", "prompt": "x"}]}, {"answer": [{"text": "c"}]},
         {"answer": [{"text": "c"}]}),
        (
            {"answer": [{"text": "a"}, {"text": "b", "prompt": "How many"}, {"text": "c", "prompt": "many parts"}]},
            {"answer": [{"text": "d", "prompt": "Many"}]},
            {"answer": [{"text": "a"}, {"text": "d", "prompt": "Many"}]},
        ),
        (
            {"answer": [{"text": "a", "prompt": "many"}, {"text": "b", "prompt": "few"}]},
            {"answer": [{"text": "d", "prompt": "How many"}]},
            {"answer": [{"text": "b", "prompt": "few"}, {"text": "d", "prompt": "How many"}]},
        ),
        ({"answer": [{"text": "a", "terminal": 2}]}, {"answer": [{"text": "d"}]},
         {"answer": [{"text": "a", "terminal": 2}, {"text": "d"}]}),
        # A name is that of the file below, in any case.
        (
            {"input": [{"channel": 1}, {"channel": 3, "name": "Door", "at": 1.0}]},
            {"input": [{"name": "door", "at": 5.0}]},
            {"input": [{"channel": 1}, {"channel": 3, "name": "door", "at": 5.0}]},
        ),
    ],
)  # fmt: skip
def test_a_layer_replaces_entries_of_its_subjects(
    below: dict[str, object], above: dict[str, object], merged: dict[str, object]
) -> None:
    assert layered(below, above) == merged


@cases(
    "below, hint",
    [
        ([{"channel": 3, "name": "door"}, {"channel": 4}], "did you mean door?"),
        ([{"channel": 3, "name": "clamp"}, {"channel": 5, "name": "feed"}], "its names are clamp, feed"),
        ([{"channel": 3}], "write channel = N"),
        (None, "write channel = N"),
    ],
)
def test_a_name_that_is_not_there(below: object, hint: str) -> None:
    with pytest.raises(ProgramError) as wrong:
        layered({} if below is None else {"input": below}, {"input": [{"name": "doors", "at": 5.0}]})
    (found,) = wrong.value.diagnostics
    message = "no [[input]] of the machine file is named doors"
    assert (found.code, found.message, found.hint) == ("machine-file", message, hint)


def test_the_axes_that_a_machine_file_names() -> None:
    """Each is reported once per key, whatever the number of its settings."""
    settings: dict[str, object] = {
        "axis.0.travel": [0, 1],
        "axis.2.travel": [0, 1],
        "axis.2.limits.speed": 5,
        "axis.3": 5,
        "controller.axes": 9,
        "input": [{"channel": 9, "axis": 1}, {"channel": 9}, {"axis": -1}, 5],
        "fault": [{"axis": 4}, {"axis": "x"}],
        "run.until": 9,
    }
    assert [(each.code, each.message, each.hint) for each in missing_axes(settings, 2, 0)] == [
        ("machine-file", f"{where}", "the axes are 0 to 1; controller.axes sets their number")
        for where in (
            "axis.2: there is no axis 2",
            "[[input]]: there is no axis -1",
            "[[fault]]: there is no axis 4",
        )
    ]
    assert [each.message for each in missing_axes(settings, 4, 1)] == [
        "axis.0: there is no axis 0",
        "[[input]]: there is no axis -1",
    ]
    assert missing_axes(settings, 4, 1)[0].hint == "the axes are 1 to 4; controller.axes sets their number"
