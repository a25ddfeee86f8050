"""What a proof finds in a forged run: its log, its tracks, its trace, or what was ordered of it.

Statements take next to no time. A move of 10 counts at 20 counts/s and 100 counts/s² takes 0.7 s, its ramps 0.2 s each.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import pytest

from motionlang.kernel import Source
from motionlang.kernel import run as run_plainly
from motionlang.kernel.planners import Profile, hold, plan
from motionlang.kernel.tracks import Samples
from tests.cases import cases
from tests.proof import prove, run

Forge = Callable[[Any], None]

SETTINGS = "SPEED(0) = 20 : ACCEL(0) = 100 : DECEL(0) = 100\n"
ONE = "MOVER(0) = 100 : GO(0)\nPAUSE IDLE(0)\n"
TWO = (
    "MOVER(0) = 10 : GO(0) : PAUSE IDLE(0)\nWAIT = 1000\nMOVER(0) = 10 : GO(0) : PAUSE IDLE(0)\nWAIT = 500\n"
)
CANCELLED = "MOVER(0) = 100 : GO(0)\nWAIT = 1000\nCANCEL(0)\n"
JERKS = "PROFILEMODE(0) = 1 : ACCELJERK(0) = 400 : DECELJERK(0) = 400\n"
SHIFTED = (
    "SPEED(1) = 80 : ACCEL(1) = 300 : DECEL(1) = 400 : MASTERSOURCE(1) = _msPOS : MASTERCHANNEL(1) = 0\n"
    "FOLLOW(1) = 0.5\nJOG(0) = 20\nWAIT = 500\nOFFSET(1) = 10 : GO(1)\nWAIT = 2000\nSTOP(1)\nSTOP(0)\n"
)
CAM = (
    "Dim rise(3) As Float = 2, 5, 9\nMASTERSOURCE(1) = _msPOS : MASTERDISTANCE(1) = 10\nCAMTABLE(1, rise)\n"
    "CAM(1) = 0 : GO(1) : JOG(0) = 20\nWAIT = 2000\nSTOP(0)\nPAUSE IDLE(0)\n"
)
FLY = (
    "MASTERSOURCE(1) = _msPOS : MASTERDISTANCE(1) = 10\nMOVEBUFFERSIZE(1) = 5\nFLY(1) = 5 : FLY(1) = 10 : FLY(1) = 5\n"
    "GO(1) : JOG(0) = 20\nWAIT = 2000\nSTOP(0)\nPAUSE IDLE(0)\n"
)
CORNER = (
    "CONTOURMODE(0) = 1 : CONTOURANGLE(0) = 50\nVECTORR(0, 1) = 28, 0\nVECTORR(0, 1) = 20, 20\n"
    "GO(0)\nPAUSE IDLE(0)\n"
)


def entry(k: int, **fields: object) -> Forge:
    """Change fields of an entry of the log."""

    def forge(ran: Any) -> None:
        for name, value in fields.items():
            setattr(ran.controller.log.moves[k], name, value)

    return forge


def logged(k: int, made: Callable[[Profile], Profile]) -> Forge:
    """Change the motion that an entry of the log tells of."""

    def forge(ran: Any) -> None:
        move = ran.controller.log.moves[k]
        move.profile = made(move.profile)

    return forge


def moved(k: int, made: Callable[[Profile], Profile]) -> Forge:
    """Change a profile of axis 0."""

    def forge(ran: Any) -> None:
        profiles = ran.controller.axes[0].profiles
        profiles[k] = made(profiles[k])

    return forge


def ordered(axis: int, made: Callable[[Any], Any]) -> Forge:
    """Change what was ordered of an axis."""

    def forge(ran: Any) -> None:
        expected = ran.controller.motion_listener
        expected.of[axis] = [made(order) for order in expected.of[axis]]

    return forge


def tied(**fields: object) -> Forge:
    """Change the tie of axis 1 to its master."""
    return ordered(1, lambda o: o if o.tie is None else o._replace(tie=o.tie._replace(**fields)))


def tabled(*table: object) -> Forge:
    """Change the table of axis 1."""
    return tied(table=table)


def untabled(order: Any) -> Any:
    """Return an order without the table of a segment of 5."""
    tie = order.tie
    return order if tie is None or tie.table[1][1] != 5.0 else order._replace(tie=tie._replace(table=None))


def joined(first: float, second: float) -> str:
    """Return a contour of two lines of axes with 4 and 2 counts per unit, 0.6 and 0.8 of these lengths."""
    lines = [f"VECTORR(0, 1) = {0.6 * length}, {0.8 * length}\n" for length in (first, second)]
    return (
        f"SCALE(0) = 4 : SCALE(1) = 2\n{SETTINGS}CONTOURMODE(0) = 1\n{''.join(lines)}GO(0)\nPAUSE IDLE(0)\n"
    )


def slower_at_last(order: Any) -> Any:
    """Return the order of the second line of a contour as one at 15."""
    return order._replace(speed=15.0) if order.path is not None and order.path.begun > 0.1 else order


def trapezoid(end: float, speed: float, accel: float, decel: float) -> Callable[[Profile], Profile]:
    return lambda _: plan("trapezoid", 0.0, end, speed, accel, decel)


# A program, what is forged, and the violations.
FORGED: dict[str, tuple[str, Forge, list[str]]] = {
    "another target by rounding": (TWO, entry(0, target=10.000_009), []),
    "another target by little": (TWO, entry(0, target=10.000_011), [
            "2: axis 0 from 0.000000 s: it ends at 10, commanded 10",
        ]),
    "an offset from elsewhere by rounding": (SHIFTED, logged(2, lambda p: p.shifted(0.9e-6)), []),
    "it goes farther by rounding": (TWO, logged(0, lambda p: p.scaled(0.0, 1.000_000_9)), []),
    "it goes farther by little": (TWO, logged(0, lambda p: p.scaled(0.0, 1.000_001_1)), [
            "2: axis 0 from 0.000000 s: the report has it at 10 at 0.700000 s, the track at 10",
            "2: axis 0 from 0.000000 s: the report has a peak of 20, the track 20",
            "2: axis 0 from 0.000000 s: it ends at 10, commanded 10",
            "2: axis 0 from 0.000000 s: the log has it at 9.29196 at 0.581000 s, the track at 9.29195",
        ]),
    "it moves in no time": (
        TWO, logged(0, lambda _: Profile("trapezoid", 0.0, 10.0, 0.0, (0.0, 0.0, 0.0, 0.0))), [
            "2: axis 0 from 0.000000 s: the report has it at 10 at 0.000000 s, the track at 0",
            "2: axis 0 from 0.000000 s: 10 counts in no time",
            "2: axis 0 from 0.000000 s: the phases cover 0 counts, the move 10",
            "2: axis 0 from 0.000000 s: the log has it at 10 at 0.000000 s, the track at 0",
            "2: axis 0 from 0.000000 s: it moves without an entry in the log",
        ],
    ),
    "it ends after the run": (CANCELLED, logged(0, trapezoid(100.0, 20.0, 100.0, 100.0)), [
            "2: axis 0 from 0.000000 s: the report has it end at 5.2 s, the run at 1 s",
            "2: axis 0 from 0.000000 s: its entry ends at 5.2 s, the run at 1 s",
        ]),
    "the axis lies farther on": (TWO, moved(1, lambda p: p.shifted(1.0)), [
            "2: axis 0 from 0.000000 s: the report has it at 0 at 0.000000 s, the track at 1",
            "2: axis 0 from 0.000000 s: the report has it at 10 at 0.700000 s, the track at 11",
            "2: axis 0 at 0.000000 s: the position jumps by 1 counts",
            "4: axis 0 at 1.700000 s: the position jumps by 1 counts",
            "2: axis 0 from 0.000000 s: the log has it at 0 at 0.000000 s, the track at 1",
        ]),
    "the axis lies farther on by rounding": (TWO, moved(1, lambda p: p.shifted(0.9e-6)), []),
    "the axis lies farther on by little": (TWO, moved(1, lambda p: p.shifted(1.1e-6)), [
            "2: axis 0 from 0.000000 s: the report has it at 0 at 0.000000 s, the track at 1.1e-06",
            "2: axis 0 at 0.000000 s: the position jumps by 1.1e-06 counts",
            "4: axis 0 at 1.700000 s: the position jumps by 1.1e-06 counts",
        ]),
    "the axis is faster": (TWO, moved(1, trapezoid(10.0, 25.0, 100.0, 100.0)), [
            "2: axis 0 from 0.000000 s: the report has a peak of 20, the track 25",
            "2: axis 0 from 0.000000 s: the speed reaches 25 counts, above 20",
            "2: axis 0 from 0.000000 s: the log has it at 5 at 0.350000 s, the track at 5.625",
            "2: axis 0 from 0.000000 s: it ends at 0.700000 s, its motion at 0.650000 s",
        ]),
    "the axis is slower": (TWO, moved(1, trapezoid(10.0, 15.0, 100.0, 100.0)), [
            "2: axis 0 from 0.000000 s: the report has it at 10 at 0.700000 s, the track at 9.31944",
            "2: axis 0 from 0.000000 s: the report has a peak of 20, the track 15",
            "2: axis 0 from 0.000000 s: the log has it at 5 at 0.350000 s, the track at 4.125",
            "2: axis 0 from 0.000000 s: it ends at 0.700000 s, its motion at 0.816667 s",
            "2: axis 0 from 0.700000 s: it moves without an entry in the log",
        ]),
    "the axis speeds up harder": (TWO, moved(1, trapezoid(10.0, 20.0, 130.0, 100.0)), [
            "2: axis 0 from 0.000000 s: the acceleration reaches 130 counts, above 100",
            "2: axis 0 from 0.000000 s: the log has it at 1.08045 at 0.147000 s, the track at 1.40458",
            "2: axis 0 from 0.000000 s: it ends at 0.700000 s, its motion at 0.676923 s",
        ]),
    "the axis slows down harder": (TWO, moved(1, trapezoid(10.0, 20.0, 100.0, 130.0)), [
            "2: axis 0 from 0.000000 s: the deceleration reaches 130 counts, above 100",
            "2: axis 0 from 0.000000 s: the log has it at 9.29195 at 0.581000 s, the track at 9.40192",
            "2: axis 0 from 0.000000 s: it ends at 0.700000 s, its motion at 0.676923 s",
        ]),
    "the axis goes elsewhere": (TWO, moved(1, trapezoid(11.0, 20.0, 100.0, 100.0)), [
            "2: axis 0 from 0.000000 s: the report has it at 10 at 0.700000 s, the track at 10.875",
            "4: axis 0 at 1.700000 s: the position jumps by 1 counts",
            "2: axis 0 from 0.000000 s: the log has it at 9.29195 at 0.581000 s, the track at 9.57195",
            "2: axis 0 from 0.000000 s: it ends at 0.700000 s, its motion at 0.750000 s",
            "2: axis 0 from 0.700000 s: it moves without an entry in the log",
        ]),
    "the axis is elsewhere at last": (TWO, moved(-1, lambda _: hold(21.0)), [
            "4: axis 0 at 2.400000 s: the position jumps by 1 counts",
            "4: axis 0 from 1.700000 s: the last entry ends at 20, the axis is at 21",
        ]),
    "the axis has a higher jerk": (
        JERKS + ONE, moved(1, lambda _: plan("scurve", 0.0, 100.0, 20.0, 100.0, 100.0, 0.0, 0.0, 900.0, 400.0)), [
            "3: axis 0 from 0.000000 s: the jerk reaches 900 counts, above 400",
            "3: axis 0 from 0.000000 s: the log has it at 18.4062 at 1.143915 s, the track at 19.7672",
            "3: axis 0 from 0.000000 s: it ends at 5.447214 s, its motion at 5.379162 s",
        ],
    ),
    "a cam over another table": (CAM, tabled((0.0, 10.0), (0.0, 2.1), "linear"), [
            "5: axis 1 from 0.000000 s: its curve has 5 at 10 of its master, commanded 2.1",
            "5: axis 1 from 0.000000 s: its curve has 5 at 10 of its master, commanded 2.1",
            "5: axis 1 from 0.000000 s: at 0.070000 s it is at 0.1225, its master requires 0.0529",
        ]),
    "a cam over a shorter table": (CAM, tabled((0.0, 9.0), (0.0, 4.5), "linear"), [
            "5: axis 1 from 0.000000 s: its curve rises by 14, commanded 4.5",
            "5: axis 1 from 0.000000 s: its curve is 20 long, commanded 9",
            "5: axis 1 from 0.000000 s: its curve rises by 14, commanded 4.5",
            "5: axis 1 from 0.000000 s: its curve is 20 long, commanded 9",
            "5: axis 1 from 0.000000 s: at 0.625000 s it is at 5.45, its master requires 5.25",
        ]),
    "a cam that is not straight": (CAM, tabled((0.0, 20.0), (0.0, 14.0), "linear"), [
            "5: axis 1 from 0.000000 s: its curve is not straight from 0 to 20 of its master",
            "5: axis 1 from 0.000000 s: its curve is not straight from 0 to 20 of its master",
            "5: axis 1 from 0.000000 s: at 0.070000 s it is at 0.1225, its master requires 0.1705",
        ]),
    "a cam from elsewhere": (CAM, tied(origin=0.5), [
            "5: axis 1 from 0.000000 s: at 0.625000 s it is at 5.45, its master requires 5.25",
        ]),
    "a cam of a master that goes back": (CAM, tied(direction=-1), [
            "5: axis 1 from 0.000000 s: at 0.070000 s it is at 0.1225, its master requires -0.1175",
        ]),
    "a segment over another distance": (FLY, tabled((0.0, 10.0), (0.0, 6.0), "even"), [
            "4: axis 1 from 0.000000 s: its curve has 5 at 10 of its master, commanded 6",
            "4: axis 1 from 0.000000 s: its curve has 5 at 10 of its master, commanded 6",
            "4: axis 1 from 0.600000 s: its curve has 10 at 10 of its master, commanded 6",
            "4: axis 1 from 1.100000 s: its curve has 5 at 10 of its master, commanded 6",
        ]),
    "a path that sped up for the next one, too fast": (
        joined(2, 2), ordered(0, slower_at_last), [
            "6: path from 0.200000 s: the path speed reaches 20, above 15",
        ],
    ),
    "a path that slows down from the one before": (
        joined(7, 1.5), ordered(0, slower_at_last), [],
    ),
    "segments without a table": (FLY, tied(table=None), []),
    "a segment behind another ratio": (
        FLY, ordered(1, untabled), [
            "4: axis 1 from 0.600000 s: its segment begins at a ratio of 1, expected 0",
        ],
    ),
    "a corner above CONTOURANGLE": (
        CORNER, ordered(0, lambda o: o if o.path is None else o._replace(path=o.path._replace(angle_into=44.9))), [
            "4: axis 0 at 1.500000 s: the velocity jumps by 5.85786 counts/s",
        ],
    ),
}  # fmt: skip


def found(program: str, forge: Forge) -> list[str]:
    ran = run(Source("a.mnt", SETTINGS + program), machine={"controller.instruction_time": 1e-9})
    assert [each.message for each in ran.diagnostics + prove(ran).violations] == []
    forge(ran)
    return [f"{each.line}: {each.message}" for each in prove(ran).violations]


@pytest.mark.parametrize("name", FORGED)
def test_what_is_forged_is_found(name: str) -> None:
    program, forge, expected = FORGED[name]
    assert found(program, forge) == expected


# How far the trace is off from 2.05 s on; 40 rows of 5.2 s are 0.13 s apart, the row behind it is at 2.08 s.
@cases(
    "off, expected",
    [
        (0.01, ["0: axis 0 at 2.080000 s: the trace has it at 39.61, the track at 39.6"]),
        (0.000_03, []),
        (0.000_05, ["0: axis 0 at 2.080000 s: the trace has it at 39.6, the track at 39.6"]),
    ],
)
def test_a_trace_that_is_off_its_track_is_found(off: float, expected: list[str]) -> None:
    def forge(ran: Any) -> None:
        samples = ran.trace.sample(40.0 / ran.time)
        times, positions, *others = samples.data
        made = Samples(samples.columns, (times, positions + off * (times > 2.05), *others))
        patched.setattr(type(ran.trace), "sample", lambda trace, rate: made)

    with pytest.MonkeyPatch.context() as patched:
        assert found(ONE, forge) == expected


def test_a_run_without_expected_motion_cannot_be_proved() -> None:
    with pytest.raises(ValueError, match="no motion is expected"):
        prove(run_plainly(Source("a.mnt", ONE)))
