"""Relations for single moves, for contours with and without events, and for masters and slaves.

`MOTIONLANG_LONG=500` runs that many random programs per relation and kind.
"""

from __future__ import annotations

import math
import os
import re
from collections.abc import Callable
from functools import cache
from random import Random

import pytest

from motionlang.kernel import Run
from tests.metamorphic.jobs import Contour, Moves, Train
from tests.metamorphic.runs import grid, proved

SEEDS = range(int(os.environ.get("MOTIONLANG_LONG", "6")))
KINDS: dict[str, Callable[[int], Moves | Contour | Train]] = {
    "moves": Moves,
    "contours": lambda seed: Contour(seed, events=False),
    "contours with events": lambda seed: Contour(seed, events=True),
    "masters and slaves": Train,
}
AXES = (0, 1, 2)
ARGUMENTS = re.compile(r"\b([A-Z]{2,})\((\d(?:, \d)*)")
POLLED = re.compile(r"PAUSE (IDLE\(\d\)(?: And IDLE\(\d\))?)(?: : )?")
SCALED = re.compile(r"SCALEFACTOR\((\d)\) = ([\d.]+)")


def text(kind: str, seed: int) -> str:
    return KINDS[kind](seed).text


@cache
def whole(kind: str, seed: int) -> Run:
    """Return the run of a program as it is, which the relations only read."""
    return proved(text(kind, seed))


def positions(result: Run, times: list[float], first: int = 0) -> list[list[float]]:
    axes = [result.controller.axes[first + axis] for axis in AXES]
    return [[a.position(time) for time in times] for a in axes]


def scaled(program: str, factor: float) -> str:
    """Return the program with the same user units, but `factor` times the counts."""
    given = {int(axis): float(k) for axis, k in SCALED.findall(program)}
    lines = [line for line in program.split("\n") if not SCALED.match(line)]
    return "\n".join([f"SCALEFACTOR({axis}) = {given.get(axis, 1.0) * factor!r}" for axis in AXES] + lines)


def elsewhere(program: str, by: int) -> str:
    """Return the program with all axis numbers increased by `by`."""

    def moved(found: re.Match[str]) -> str:
        return f"{found[1]}({', '.join(str(int(axis) + by) for axis in found[2].split(', '))}"

    channel = re.sub(r"(MASTERCHANNEL\(\d\) = )(\d)", lambda m: f"{m[1]}{int(m[2]) + by}", program)
    return ARGUMENTS.sub(moved, channel)


def near(found: list[list[float]], wanted: list[list[float]], within: float = 1e-6) -> None:
    for one, other in zip(found, wanted, strict=True):
        assert one == pytest.approx(other, rel=within, abs=within)


def mirrored(program: str) -> str:
    """Return moves in the other direction, or a contour rotated by 180 degrees."""

    def negated(found: re.Match[str]) -> str:
        values = found[3].split(", ")
        unsigned = {2} if found[2].startswith(("CIRCLE", "HELIX")) else set()
        signed = [value if k in unsigned else repr(-float(value)) for k, value in enumerate(values)]
        return f"{found[1]}{', '.join(signed)}"

    words = r"((MOVER|VECTOR[RA]|CIRCLER|HELIXR)\([\d, ]+\) = )([-\d., ]*\d)"
    return re.sub(words, negated, program)


@pytest.mark.parametrize("kind", ["moves", "contours", "contours with events"])
def test_the_mirrored_program_does_the_mirrored_motion(kind: str) -> None:
    for seed in SEEDS:
        program = text(kind, seed)
        one, other = whole(kind, seed), proved(mirrored(program))
        assert other.time == pytest.approx(one.time, rel=1e-12), program
        near(positions(other, grid(one)), [[-p for p in row] for row in positions(one, grid(one))], 1e-9)


SIGNS = {
    "all axes": (-1.0, -1.0, -1.0),
    "slaves alone": (1.0, -1.0, -1.0),
    "the last alone": (1.0, 1.0, -1.0),
}


def signed(program: str, signs: tuple[float, ...]) -> str | None:
    """Return masters and slaves with each axis in the direction of its sign.

    Return None if a program cannot be reversed: a cam whose master reverses, and a table that two slaves read in
    opposite directions.
    """
    master = {int(slave): int(m) for slave, m in re.findall(r"MASTERCHANNEL\((\d)\) = (\d)", program)}
    cams = {
        (int(axis), signs[int(axis)], signs[master[int(axis)]])
        for axis in re.findall(r"CAM\((\d)\)", program)
    }
    if any(before < 0.0 for _, _, before in cams) or len({sign for _, sign, _ in cams}) > 1:
        return None
    of_cams = min((sign for _, sign, _ in cams), default=1.0)
    flies = r"MASTERDISTANCE\((\d)\) = (\S+) : FLY\(\d\) = (\S+)"

    def fly(found: re.Match[str]) -> str:
        slave = int(found[1])
        over, distance = float(found[2]) * signs[master[slave]], float(found[3]) * signs[slave]
        return f"MASTERDISTANCE({slave}) = {over!r} : FLY({slave}) = {distance!r}"

    def with_sign(found: re.Match[str]) -> str:
        word, axis = found[1], int(found[2])
        sign = signs[axis] * (signs[master[axis]] if word == "FOLLOW" else 1.0)
        return f"{word}({axis}) = {float(found[3]) * sign!r}"

    def limits(found: re.Match[str]) -> str:
        axis, forward, reverse = int(found[1]), float(found[2]), float(found[3])
        if signs[axis] < 0.0:
            forward, reverse = -reverse, -forward
        return f"SOFTLIMITFORWARD({axis}) = {forward!r} : SOFTLIMITREVERSE({axis}) = {reverse!r}"

    def table(found: re.Match[str]) -> str:
        count, *values = found[2].split(", ")
        return found[1] + ", ".join([count, *(repr(float(value) * of_cams) for value in values)])

    program = re.sub(flies, fly, program)
    program = re.sub(r"\b(FOLLOW|MOVER|JOG|OFFSET)\((\d)\) = (-?[\d.]+)", with_sign, program)
    program = re.sub(r"SOFTLIMITFORWARD\((\d)\) = (\S+) : SOFTLIMITREVERSE\(\d\) = (\S+)", limits, program)
    return re.sub(r"(Dim \w\(\d\) As Float = )(.*)", table, program)


@pytest.mark.parametrize("name", SIGNS)
def test_masters_and_slaves_in_reverse_do_the_mirrored_motion(name: str) -> None:
    done = {"FOLLOW": 0, "FLY": 0, "SOFTLIMIT": 0}
    for seed in range(4 * len(SEEDS)):
        program = text("masters and slaves", seed)
        mirror = signed(program, SIGNS[name])
        if mirror is None:
            continue
        one, other = whole("masters and slaves", seed), proved(mirror)
        assert other.time == pytest.approx(one.time, rel=1e-12), program
        expected = [
            [sign * p for p in row] for sign, row in zip(SIGNS[name], positions(one, grid(one)), strict=True)
        ]
        near(positions(other, grid(one)), expected, 1e-9)
        done = {word: count + (word in program) for word, count in done.items()}
    assert all(done.values())


@pytest.mark.parametrize("kind", KINDS)
def test_a_power_of_two_of_counts_a_unit_is_that_many_counts(kind: str) -> None:
    for seed in SEEDS:
        program = text(kind, seed)
        one, other = proved(scaled(program, 1.0)), proved(scaled(program, 8.0))
        assert other.time == pytest.approx(one.time, rel=1e-9), program
        near(positions(other, grid(one)), [[8.0 * p for p in row] for row in positions(one, grid(one))])


@pytest.mark.parametrize("kind", KINDS)
def test_other_axes_do_the_same(kind: str) -> None:
    for seed in SEEDS:
        program = text(kind, seed)
        one, other = whole(kind, seed), proved(elsewhere(program, 4))
        assert other.time == one.time, program
        assert positions(other, grid(one), 4) == positions(one, grid(one)), program


@pytest.mark.parametrize("kind", KINDS)
def test_what_begins_later_is_the_same_later(kind: str) -> None:
    for seed in SEEDS:
        program = text(kind, seed)
        one, other = proved("WAIT 1\n" + program), proved("WAIT 501\n" + program)
        times = grid(one)
        assert other.time == pytest.approx(one.time + 0.5, abs=1e-7), program
        near(positions(other, [time + 0.5 for time in times]), positions(one, times), 1e-5)


@pytest.mark.parametrize("kind", KINDS)
def test_a_run_that_is_cut_is_the_beginning_of_the_whole(kind: str) -> None:
    for seed in SEEDS:
        program = text(kind, seed)
        complete = whole(kind, seed)
        for share in (0.13, 0.5, 0.91):
            until = share * complete.time
            prefix = proved(program, until=until)
            times = [until * k / 19 for k in range(20)]
            assert positions(prefix, times) == positions(complete, times), program


@pytest.mark.parametrize("kind", KINDS)
def test_a_skipped_loop_ends_like_one_that_runs_each_iteration(kind: str) -> None:
    """A loop with a counter runs every iteration; a polling loop is skipped."""
    for seed in SEEDS:
        program = text(kind, seed)
        runs = []
        for body in ("", "n = n + 1\nIF n > 30000 THEN\nn = 0\nEND IF\n"):
            loop = rf"WHILE NOT (\1)\n{body}ENDWHILE\n"
            polled = POLLED.sub(loop, program.replace(" : PAUSE", "\nPAUSE"))
            runs.append(proved("Dim n As Integer = 0\n" + polled, fine=1e-3))
        ends = [positions(each, [each.time]) for each in runs]
        # The motion of slaves between two waits depends on the end of these, which a longer iteration delays.
        if kind != "masters and slaves":
            near(ends[1], ends[0], 1e-9)


def absolute(program: str) -> str:
    """Return the same contour with absolute instead of relative paths."""
    here = [0.0, 0.0, 0.0]
    lines = []
    for line in program.split("\n"):
        found = re.match(r"(.*)(VECTOR|CIRCLE|HELIX)([RA])\((.*?)\) = (.*)", line)
        if found is None:
            lines.append(line)
            continue
        speed, word, mode, axes, values = found.groups()
        numbers = [float(value) for value in values.split(", ")]
        if word == "VECTOR":
            base = here if mode == "R" else [0.0] * 3
            here = [b + n for b, n in zip(base, [*numbers, *[0.0] * (3 - len(numbers))], strict=True)][
                : len(numbers)
            ] + here[len(numbers) :]
            ends = here[: len(numbers)]
        else:
            x, y, angle, *rest = numbers
            centre = here[0] + x, here[1] + y
            radians = math.radians(angle)
            c, s = math.cos(radians), math.sin(radians)
            here = [centre[0] - x * c + y * s, centre[1] - x * s - y * c, here[2] + sum(rest)]
            ends = [*centre, angle, *([here[2]] if rest else [])]
        lines.append(f"{speed}{word}A({axes}) = {', '.join(map(repr, ends))}")
    return "\n".join(lines)


def test_relative_paths_and_absolute_ones_come_to_the_same() -> None:
    for seed in SEEDS:
        program = text("contours", seed)
        one, other = whole("contours", seed), proved(absolute(program))
        assert other.time == pytest.approx(one.time, abs=1e-6), program
        near(positions(other, grid(one)), positions(one, grid(one)), 1e-5)


def languages(seed: int) -> tuple[str, str]:
    """Return the same contour in Mint and in MCCL: lines and arcs at one speed.

    The ramps are trapezoids. Lines connect whole counts; arcs are given by their angle.
    """
    choose = Random(seed)
    speed, accel, decel = (
        round(choose.uniform(*range_)) for range_ in ((500, 5000), (2000, 50000), (2000, 50000))
    )
    mint = [f"MOVEBUFFERSIZE({axis}) = 20" for axis in (0, 1)]
    mint += [
        f"SPEED(0) = {speed} : ACCEL(0) = {accel} : DECEL(0) = {decel}",
        "CONTOURMODE(0) = 1 : CONTOURANGLE(0) = 0.001",
    ]
    mccl = ["1MN,2MN,1CM1,2CM1,1SN", f"1VV{speed},1VA{accel},1VD{decel}"]
    vector = 100 * choose.randrange(-9, 10), 100 * choose.randrange(1, 10)
    for _ in range(choose.randrange(3, 9)):
        kind = choose.random()
        if kind < 0.25:
            x, y = (100 * choose.randrange(-9, 10) or 100 for _ in range(2))
            angle = choose.choice((-1, 1)) * choose.randrange(20, 340)
            mint.append(f"CIRCLER(0, 1) = {x}, {y}, {angle}")
            mccl.append(f"1CP{3 if angle > 0 else 2},1CR{x},2CR{y},1ER{abs(angle)}")
            continue
        if kind < 0.6:  # another corner; without it straight on
            vector = 100 * choose.randrange(-9, 10), 100 * choose.randrange(1, 10)
        mint.append(f"VECTORR(0, 1) = {vector[0]}, {vector[1]}")
        mccl.append(f"1CP1,1MR{vector[0]},2MR{vector[1]}")
    mint += ["GO(0)", "PAUSE IDLE(0)", "PAUSE IDLE(1)"]
    mccl += ["1GO", "1WS,2WS"]
    return "\n".join(mint) + "\n", "\n".join(mccl) + "\n"


def test_the_same_contours_in_both_languages() -> None:
    for seed in SEEDS:
        mint, mccl = languages(seed)
        one, other = proved(mint), proved(mccl, name="job.mcl")
        begins = [next(move.start_time for move in each.controller.log.moves) for each in (one, other)]
        times = [begins[0] + (one.time - begins[0]) * k / 60 for k in range(61)]
        assert other.time - begins[1] == pytest.approx(one.time - begins[0], abs=1e-6), mint
        for axis in (0, 1):
            ours = [one.controller.axes[axis].position(time) for time in times]
            theirs = [
                other.controller.axes[axis + 1].position(time - begins[0] + begins[1]) for time in times
            ]
            assert theirs == pytest.approx(ours, abs=1e-3), mint
