"""The motion that `certify` verifies: each forged run that breaks continuity, an end or a limit is rejected."""

from __future__ import annotations

import pytest

from motionlang import certify
from motionlang.commands.certify.motion import verify_motion
from motionlang.kernel import Run, Source
from motionlang.kernel.planners import plan
from tests.proof import prove, run
from tests.proof.forged.logs import chosen, forge
from tests.proof.test_forged import FORGED, SETTINGS, TWO

# Changes that break neither continuity, nor an end, nor a limit, nor the distances of the log: the proof of the tests
# finds them, since it knows what the program commanded.
ONLY_PROVED = {
    "a cam over another table", "a cam over a shorter table", "a cam that is not straight", "a cam from elsewhere",
    "a cam of a master that goes back", "a segment over another distance",
    "a path that sped up for the next one, too fast", "a segment behind another ratio", "a corner above CONTOURANGLE",
}  # fmt: skip
# The same of `proof/forged/logs.py`. Others are accepted where the change is none: the entry of an offset, a stop.
KINDS_ONLY_PROVED = {
    "goes on", "has another scale", "has another zero", "has run out", "is cancelled", "is ended by a fault",
    "is of another line", "is replaced", "is stopped",
}  # fmt: skip
ACCEPTED = {
    "begins in the middle": "dwell", "is of another axis": "offset gears", "is there twice": "offset gears dwell",
    "is told with the next": "jogs PMC velocity contour",
    "begins later": "offset gears", "begins sooner": "offset gears dwell",
    "is missing": "offset gears",
}  # fmt: skip


def ran(program: str) -> Run:
    limits = {f"axis.0.limits.{name}": 1e9 for name in ("speed", "acceleration")}
    return run(Source("a.mnt", SETTINGS + program), machine={"controller.instruction_time": 1e-9, **limits})


@pytest.mark.parametrize("name", FORGED)
def test_a_forged_run_is_rejected(name: str) -> None:
    program, change, expected = FORGED[name]
    machine = {"controller.instruction_time": 1e-9}
    result = run(Source("a.mnt", SETTINGS + program), machine=machine)
    change(result)
    found = verify_motion(result.controller, [], result.time).violations
    assert bool(found) == bool(expected and name not in ONLY_PROVED), found


@pytest.mark.slow
def test_a_forged_log_is_rejected() -> None:
    accepted = []
    for each in chosen(150):
        result, differs = forge(each)
        if differs and not verify_motion(result.controller, [], result.time).violations:
            accepted.append(each)
    wrong = [each for each in accepted if each.kind not in KINDS_ONLY_PROVED]
    assert [
        str(each)
        for each in wrong
        if not any(word in each.program for word in ACCEPTED.get(each.kind, "").split())
    ] == []


# What the extremes of the certificate would miss: the peak of a profile that is not that of its pieces.
@pytest.mark.parametrize(
    ("forged", "message"),
    [
        ((25.0, 100.0, 100.0), "at 0.250000 s: the speed reaches 25 uu/s, beyond 20 of the certificate"),
        (
            (20.0, 130.0, 100.0),
            "at 0.000000 s: the acceleration reaches 130 uu/s², beyond 100 of the certificate",
        ),
    ],
)
def test_a_figure_beyond_the_extremes_is_rejected(forged: tuple[float, float, float], message: str) -> None:
    result = ran(TWO)
    lines = certify(result)
    result.controller.axes[0].profiles[1] = plan("trapezoid", 0.0, 10.0, *forged)
    found = verify_motion(result.controller, lines, result.time).violations
    assert any(message in each.message for each in found), found


def test_an_axis_that_moves_slowly_and_is_at_rest_in_the_certificate_is_rejected() -> None:
    result = ran("WAIT = 2000\n")
    lines = certify(result)
    result.controller.axes[0].profiles[0] = plan("trapezoid", 0.0, 0.5, 0.5, 1.0, 1.0)
    found = verify_motion(result.controller, lines, result.time).violations
    message = "axis 0 at 0.500000 s: the speed reaches 0.5 uu/s, beyond 0 of the certificate"
    assert message in [each.message for each in found]


@pytest.mark.parametrize(
    "program",
    [
        "JOG(0) = 20\nWAIT = 500\nPOS(0) = 3\nWAIT = 500\nCANCEL(0)\n",
        "MOVER(0) = 10 : GO(0)\nWAIT = 300\nSPEED(0) = 10 : ACCEL(0) = 50\nPAUSE IDLE(0)\n",
        "DECELTIME(0) = 100\nMOVER(0) = 10 : GO(0)\nWAIT = 100\nFEEDRATEMODE(0) = 0\nPAUSE IDLE(0)\n",
    ],
)
def test_right_motion_is_verified(program: str) -> None:
    result = ran(program)
    assert verify_motion(result.controller, certify(result), result.time).violations == []


def test_the_proof_finds_what_is_only_proved() -> None:
    """The list has no name that the proof does not find."""
    for name in ONLY_PROVED:
        program, change, _ = FORGED[name]
        machine = {"controller.instruction_time": 1e-9}
        result = run(Source("a.mnt", SETTINGS + program), machine=machine)
        change(result)
        assert prove(result).violations, name
