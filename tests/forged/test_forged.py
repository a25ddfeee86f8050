"""A sample of the forged planners, each with the program that exposes it.

`-m long` runs all of them.
"""

from __future__ import annotations

import pytest

from tests.forged.changes import FILES, PACKAGE, Change, changes, chosen, forged
from tests.forged.plugin import rejected_by
from tests.forged.verdicts import honest, ran, verdict
from tests.proof import prove

_AT = "INFINITY if ramp else 0.0"
# Module, function, original text, forged text, and program.
SLICE: tuple[tuple[str, str, str, str, str], ...] = (
    ("kernel.planners.target", "approach", "target - start", "target + start", "moves.mnt"),
    ("kernel.planners.target", "_up_and_down", "size - ramp_distance(u, *first, v)",
     "size + ramp_distance(u, *first, v)", "moves.mnt"),
    ("kernel.planners.ramps", "ramp_distance", "v_from + 2.0 * v_to", "v_from", "parabolas of PMC.mcl"),
    ("kernel.planners.ramps", "ramp_distance", "0.5 * (v_from + v_to)", "0.5 / (v_from + v_to)", "moves.mnt"),
    ("kernel.planners.shapes", "ramps_of", "1.0 - ramp", "1.0 + ramp", "S-curves of PMC.mcl"),
    ("kernel.planners.shapes", "ramp_to", "change / accel + rise", "change / accel", "moves in S-ramps.mnt"),
    ("kernel.planners.target", "_travel", "left / v", "left * v", "moves in S-ramps.mnt"),
    ("kernel.planners.transition", "initial_steps", "0.5 * a0", "0.5", "jogs in S-ramps.mnt"),
    ("kernel.planners.transition", "distance_of_steps", "0.5", "0.55", "events in S-ramps.mnt"),
    ("kernel.planners.ramp_down", "_on_slope", "index + 1", "index - 1", "S-curves of PMC.mcl"),
    ("kernel.planners.stop", "plan_velocity", "sign * after", "sign / after", "jogs in S-ramps.mnt"),
    ("kernel.planners.target", "JerkLimited.__init__", "1", "2", "targets in S-ramps.mnt"),
    ("kernel.planners.target", "_continued", "sign * a0", "sign / a0", "events in S-ramps.mnt"),
    ("kernel.planners.segment_speed", "_top", "max(speed, v1)", "min(speed, v1)", "paths.mnt"),
    ("kernel.planners.lookahead", "plan_course", "max(0.0, length - passed)", "0.0", "paths.mnt"),
    ("kernel.planners.reparametrised", "_straight", "piece[1] * (along.start - begin)", "piece[1]", "a contour.mnt"),
    ("kernel.planners.curve", "Profile.after", "knot - time", "knot + time", "a contour.mnt"),
    ("kernel.planners.curve", "Profile.piece_at", "1", "2", "moves.mnt"),
    ("kernel.planners.arc", "arc_over", "angle + (0.5 * pi if cosine else 0.0)", "angle", "a contour.mnt"),
    ("kernel.planners.arc", "arc_over", "-1.0 if half_turn % 2 else 1.0", "1.0 if half_turn % 2 else -1.0",
     "a contour.mnt"),
    ("kernel.planners.pieces", "position_in", "(c3 * x + c2) * x", "(c3 * x + c2) / x", "moves.mnt"),
    ("kernel.planners.pieces", "velocity_in", "c1 + amplitude * omega * cos(omega * x + phase)", "c1", "a contour.mnt"),
    ("kernel.planners.crossing", "_first", "begin + x", "begin - x", "a contour.mnt"),
    ("kernel.planners.lookahead", "plan_course", "min(a.speed, b.speed)", "a.speed", "a contour.mnt"),
    ("kernel.controller.moves.course", "Course.braking", "room + segment.length", "room - segment.length",
     "held paths.mnt"),
    ("kernel.controller.motion.offset", "offset", "left + distance", "left - distance", "two offsets.mnt"),
    ("kernel.planners.lookahead", "_ramps_of", "len(lengths) + 1", "len(lengths) - 1", "held paths in S-ramps.mnt"),
    ("kernel.controller.motion.offset", "offset", "left + distance", "left", "two offsets.mnt"),
    ("kernel.controller.motion.follow", "Gear._geared", "self.ratio", "self.locked", "gears of PMC.mcl"),
    ("kernel.controller.motion.follow", "Gear.set_ratio", _AT, "0.0 if ramp else INFINITY", "gears.mnt"),
    ("kernel.controller.motion.follow", "FollowMove.until", "time - self.start_time", "time", "gears.mnt"),
)  # fmt: skip


# Those that observe all limits and ends but are slow.
SLOW: tuple[tuple[str, str, str, str, str], ...] = (
    ("kernel.planners.shapes", "Proportional.down", "v - u", "v", "events.mnt"),
    ("kernel.planners.shapes", "Proportional.peak", "self.mean / self.accel", "self.mean * self.accel", "moves.mnt"),
    ("kernel.planners.shapes", "ramps_of", "0.5 * accel", "0.5 / accel", "parabolas of PMC.mcl"),
    ("kernel.planners.segment_speed", "between", "length - used", "length + used", "events in S-ramps.mnt"),
    ("kernel.planners.arc", "arc_over", "half_turn * pi - phase", "half_turn * pi", "a contour.mnt"),
    ("kernel.controller.queue.stop", "stop", "a.error_decel", "a.decel", "a limit.mnt"),
)  # fmt: skip


def named(module: str, function: str, before: str, after: str) -> Change:
    """Return a change by its names."""
    wanted = (f"motionlang.{module}", function, before, after)
    found = changes(module.replace(".", "/") + ".py")
    return next(each for each in found if (each.module, each.function, each.before, each.after) == wanted)


def test_the_files_that_can_be_changed_exist() -> None:
    assert [name for name in FILES if not (PACKAGE / name).exists()] == []


@pytest.mark.parametrize(("module", "function", "before", "after", "program"), SLICE)
def test_a_forged_planner_is_rejected(
    module: str, function: str, before: str, after: str, program: str
) -> None:
    change, motions = named(module, function, before, after), honest([program])
    with forged(change):
        assert verdict(motions).kind == "rejected"
    assert verdict(motions).kind == "same"


@pytest.mark.long
@pytest.mark.parametrize(("module", "function", "before", "after", "program"), SLOW)
def test_a_slow_planner_is_rejected_by_the_tests_of_planners(
    module: str, function: str, before: str, after: str, program: str
) -> None:
    change, motions = named(module, function, before, after), honest([program])
    with forged(change):
        assert verdict(motions).kind == "passed"
    assert rejected_by(change)


def test_the_programs_of_the_honest_planners_are_proved() -> None:
    from tests.forged.programs import PROGRAMS

    for name in PROGRAMS:
        assert [each.message for each in prove(ran(name)).violations] == [], name


@pytest.mark.long
def test_no_forged_planner_that_changes_the_motion_passes() -> None:
    """300 changes, evenly spaced."""
    motions = honest()
    passed = []
    for change in chosen(300):
        with forged(change):
            found = verdict(motions, change.function)
        if found.kind == "passed" and not rejected_by(change):
            passed.append(str(change))
    assert passed == []
