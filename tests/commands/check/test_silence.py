"""Hosts that a comment names, and the inputs that a machine file drives."""

from __future__ import annotations

from motionlang.commands.check.mint import COMMENT
from motionlang.commands.check.silence import driven_inputs, has_host
from motionlang.kernel import Source
from tests.cases import cases


def test_a_program_that_a_host_uses_says_so() -> None:
    for text, expected in (
        ("a\nb ' lint: host", True),
        ("a\nb ' LINT:HOST reads all", True),
        ('a\nPRINT "lint: host"', False),
        ("a\nb ' lint: hosts", False),
        ("a\nb ' a host", False),
    ):
        assert has_host(Source("a", text), COMMENT) is expected, text


@cases(
    "settings, inputs",
    [
        ({}, None),
        ({"controller.axes": 4, "run.until": 1.0}, None),
        ({"controller.axes": 4, "axis.0.travel": [0, 1]}, set()),
        ({"input": [{"channel": 3}, {"channel": 5}], "axis.0.home_input": 7}, {3, 5, 7}),
    ],
)
def test_the_inputs_that_a_machine_file_drives(settings: dict[str, object], inputs: set[int] | None) -> None:
    """Without a file any input may change."""
    assert driven_inputs(settings) == inputs
