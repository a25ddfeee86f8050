"""The virtual controller through its verbs, in counts and seconds; no language."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

from motionlang.kernel import Controller, Rejected
from tests.operations import OPERATIONS

PACKAGE = Path(__file__).parents[3] / "motionlang"
# 8 counts/s, 16 counts/s²: the first worked example of AN00115.
# An operation that is called, and the name of one that a row or a reader refers to.
_USES = re.compile(r"\b_?(?:controller|made|virtual|c)\.(\w+)|\"(\w+)\"")
EXAMPLE = {"speed": 8.0, "accel": 16.0, "decel": 16.0}


def machine(axes: int = 2, **settings: float | str) -> Controller:
    controller = Controller(axes)
    for axis in controller.axes:
        for name, value in {**EXAMPLE, **settings}.items():
            controller.configure(axis, name, value)
    return controller


def test_every_verb_is_a_method_of_the_controller() -> None:
    for operation in OPERATIONS:
        assert callable(getattr(Controller, operation))


@pytest.mark.parametrize(
    "folder", ["kernel/lang", "kernel/mint", "kernel/mccl", "commands/check", "hosts", "lab/pvt"]
)
def test_the_dialects_call_no_other_method(folder: str) -> None:
    methods = {name for name in dir(Controller) if not name.startswith("_")}
    for path in sorted((PACKAGE / folder).rglob("*.py")):
        called = set(re.findall(r"\bcontroller\.(\w+)\(", path.read_text(encoding="utf-8")))
        assert called & methods <= set(OPERATIONS), path


def test_every_verb_is_used() -> None:
    """A language calls each operation, or a row or a reader names it."""
    texts = [path.read_text("utf-8") for path in PACKAGE.rglob("*.py")]
    used = {name for text in texts for pair in _USES.findall(text) for name in pair}
    assert set(OPERATIONS) - used == set()


@pytest.mark.parametrize(
    ("name", "code"),
    [("accel", "zero-acceleration"), ("decel", "zero-acceleration")],
)
def test_a_move_with_a_zero_is_refused_with_its_name(name: str, code: str) -> None:
    c = machine()
    c.configure(0, name, 0.0)
    c.load_by(0, 12.0, "MOVER", 7)
    with pytest.raises(Rejected) as rejected:
        c.go([0])
    assert (rejected.value.code, rejected.value.line) == (code, 7)
