"""The tolerance of a check is in the units of the checked figure."""

from __future__ import annotations

import pytest

from motionlang import prove, run
from motionlang.commands.prove.axes import check_profile
from motionlang.commands.prove.checker import Proof
from motionlang.commands.prove.expected_motion import ExpectedMotion
from motionlang.kernel import Source, WholeTrack
from motionlang.kernel.planners import from_curve

SETTINGS = "SPEED(0) = 20 : ACCEL(0) = 100 : DECEL(0) = 100\nSCALEFACTOR(1) = 100\n"
JERKS = "PROFILEMODE(0) = 1 : ACCELJERK(0) = 1000 : DECELJERK(0) = 1000\n"


@pytest.mark.parametrize(("jump", "found"), [(0.005, []), (0.02, [True, True])])
def test_the_acceleration_of_an_axis_is_rounded_in_its_counts(jump: float, found: list[bool]) -> None:
    """At 100 counts per unit a rate of 100 is 10 000 counts/s²; a millionth is 0.01."""
    path = "VECTORR(0, 1) = 0, 29 : GO(0)\nPAUSE IDLE(0)\n"
    result = run(Source("found.mnt", SETTINGS + JERKS + path), prove=True)
    assert prove(result).holds
    expected, track = ExpectedMotion.of_run(result), WholeTrack(result.controller.axes[1])
    i = next(k for k, order in enumerate(expected.of[1]) if order.path is not None)
    order, planned = expected.of[1][i], track.profiles[i]
    first, (c0, c1, c2, c3, c4, c5, c6), *others = planned.pieces
    curve = planned.knots, (first, (c0, c1, c2 + 0.5 * jump, c3, c4, c5, c6), *others), ()
    track.profiles = [*track.profiles]
    track.profiles[i] = from_curve(planned.shape, planned.start, planned.end, curve, 0.0, 0.0)
    proof = Proof()
    check_profile(proof, track, i, order, order, planned.duration)
    assert [
        "acceleration" in each.message for each in proof.violations if "position" not in each.message
    ] == found
