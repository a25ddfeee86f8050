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


def test_a_loaded_move_waits_for_go() -> None:
    c = machine()
    c.load_by(0, 12.0)
    c.clock.advance(1.0)
    assert c.is_idle(0)
    assert c.position(0) == 0.0
    c.go([0])
    assert not c.is_idle(0)
    assert c.idle_time(0) == 3.0


def test_go_starts_several_axes_in_the_same_instant() -> None:
    c = machine()
    c.load_by(0, 12.0)
    c.load_by(1, -12.0)
    c.go([0, 1])
    c.clock.advance(1.0)
    assert (c.position(0), c.position(1)) == (6.0, -6.0)
    assert [move.start_time for move in c.log.moves] == [0.0, 0.0]


def test_buffered_moves_follow_one_another_with_a_stop_between() -> None:
    c = machine()
    c.load_by(0, 12.0)
    c.load_by(0, -12.0)
    c.go([0])
    c.clock.advance(2.0)
    assert (c.position(0), c.velocity(0)) == (12.0, 0.0)
    c.clock.advance(4.0)
    assert c.position(0) == 0.0
    assert [move.start_time for move in c.log.moves] == [0.0, 2.0]


def test_a_move_loaded_after_go_waits_for_its_own_go() -> None:
    c = machine()
    c.load_by(0, 12.0)
    c.go([0])
    c.load_by(0, 12.0)
    c.clock.advance(5.0)
    assert c.position(0) == 12.0
    c.go([0])
    c.clock.advance(7.0)
    assert c.position(0) == 24.0


def test_a_new_target_replaces_the_old_one_in_motion() -> None:
    c = machine()
    c.move_to(0, 12.0)
    c.clock.advance(1.0)
    c.move_to(0, 0.0)
    c.clock.advance(20.0)
    assert c.position(0) == 0.0
    assert [move.ended for move in c.log.moves] == ["retarget", ""]


def test_a_relative_move_counts_from_the_target_not_from_where_the_axis_is() -> None:
    c = machine()
    c.move_by(0, 12.0)
    c.clock.advance(1.0)
    c.move_by(0, 12.0)
    c.clock.advance(20.0)
    assert c.position(0) == 24.0


def test_define_position_at_rest_and_in_motion() -> None:
    c = machine()
    c.define_position(0, 100.0)
    assert (c.position(0), c.target(0)) == (100.0, 100.0)
    c.move_by(0, 12.0)
    c.clock.advance(1.0)
    c.define_position(0, 0.0)
    assert c.position(0) == 0.0
    c.clock.advance(2.0)
    assert c.position(0) == 6.0
    assert c.log.moves[0].profile is not None
    assert c.log.moves[0].profile.end == 112.0


def test_an_axis_that_is_off_refuses_to_move() -> None:
    c = machine()
    c.disable(0)
    with pytest.raises(Rejected) as rejected:
        c.move_to(0, 1.0)
    assert rejected.value.code == "disabled-axis"


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
