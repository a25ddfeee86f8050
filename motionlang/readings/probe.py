"""A probe: a program that asks a controller which readings hold, to be run by the controller's owner.

It moves nothing and writes no setting, unless it is asked for motion. Each question prints one answer, marked with the
name of its reading, so that the answers can be told from whatever else a terminal shows.
"""

from __future__ import annotations

import tomllib
from typing import TYPE_CHECKING
from zlib import crc32

from motionlang.readings.entries import ROOT, readings

if TYPE_CHECKING:
    from collections.abc import Collection, Iterator, Sequence

    from motionlang.readings.entries import Probe, Reading

# What a probe of MCCL tells before an answer: a register with this number, and one of its own for each name.
FIRST_MARK = 731_000_000
MARKS = 1_000_000
BEGIN, END, NEXT = "probe", "end", "next"
# What a question with motion does takes no more than so many of its steps of the distance.
STEPS = 4


class Motion:
    """What the owner allows: `distance` in user units, over which an axis may move to and fro."""

    __slots__ = ("axis", "distance")

    def __init__(self, axis: int, distance: float) -> None:
        self.axis, self.distance = axis, distance

    @property
    def step(self) -> float:
        """The `{d}` of a question."""
        return self.distance / STEPS


def asked(language: str, *, motion: bool, without: Collection[str] = ()) -> list[Reading]:
    """The readings of a language that a probe asks about; those that need motion only where it is allowed."""
    found = [
        each
        for each in readings().values()
        if each.probe is not None
        and each.probe.language == language
        and (motion or not each.probe.motion)
        and each.name not in without
    ]
    return sorted(found, key=_moves)


def _moves(reading: Reading) -> bool:
    """What moves, or writes a setting, comes last: settings are asked for as they are at power-up."""
    return reading.probe is not None and reading.probe.motion


def written(language: str, axis: int, motion: Motion | None = None, without: Collection[str] = ()) -> str:
    """The text of a probe."""
    found = asked(language, motion=motion is not None, without=without)
    lines = _mint(found, axis, motion) if language == "mint" else _mccl(found, axis, motion)
    return "\n".join(lines) + "\n"


def mark(name: str) -> int:
    """The number that a probe of MCCL tells before the answer to a question."""
    return FIRST_MARK + crc32(name.encode()) % MARKS


def lines_of(probe: Probe, axis: int, step: float) -> tuple[list[str], str, list[str]]:
    """What is done before a question, the question, and what is done after it."""

    def filled(text: str) -> str:
        return text.replace("{a}", str(axis)).replace("{2d}", f"{2 * step:g}").replace("{d}", f"{step:g}")

    return [filled(each) for each in probe.before], filled(probe.ask), [filled(each) for each in probe.after]


def _promise(language: str, motion: Motion | None) -> str:
    if motion is None:
        return "It moves nothing and writes no setting. It can be stopped at any time."
    within = f"It moves axis {motion.axis} within {motion.distance:g} user units of where it stands"
    if language == "mint":
        return f"{within}, and puts back what it writes. The axis must be enabled. Stop it as any motion."
    speed = f"leaves its velocity at {motion.distance / 2:g}"
    return f"{within}, which is 0 afterwards, switches it on and {speed}. Stop it as any motion."


def _mint(found: Sequence[Reading], axis: int, motion: Motion | None) -> Iterator[str]:
    yield f"' {len(found)} questions of motionlang about this controller, one line of answer each."
    yield f"' {_promise('mint', motion)}"
    yield "' Run it after power-up, with the settings of the factory. A line that does not compile may be deleted."
    yield "' Then: motionlang probe --answers LOG, where LOG is what the terminal showed."
    yield "Dim fa As Float, fb As Float, ia As Integer, ib As Integer"
    yield f'PRINT "<{BEGIN}|mint {len(found)}>"'
    slow = False
    for each in found:
        assert each.probe is not None
        if motion is not None and each.probe.motion and not slow:
            slow = True
            yield "Dim fs As Float"
            yield f"fs = SPEED({axis})"
            yield f"SPEED({axis}) = {motion.distance / 2:g}"
        before, ask, after = lines_of(each.probe, axis, motion.step if motion is not None else 0.0)
        yield from before
        yield f'PRINT "<{each.name}|"; {ask}; ">"'
        yield from after
    if slow:
        yield f"SPEED({axis}) = fs"
    yield f'PRINT "<{END}|mint {len(found)}>"'
    yield "End"


def _mccl(found: Sequence[Reading], axis: int, motion: Motion | None) -> Iterator[str]:
    yield f"; {len(found)} questions of motionlang about this controller, one line each."
    yield f"; {_promise('mccl', motion)}"
    yield "; Send it line by line after power-up, and keep what the terminal shows."
    yield "; Then: motionlang probe --answers LOG"
    frame = tomllib.loads((ROOT / "mccl" / "evidence" / "probe.toml").read_text(encoding="utf-8"))

    def marked(name: str) -> str:
        said: str = frame["mark"].format(mark=mark(name))
        return said

    yield frame["begin"].format(mark=mark(BEGIN), count=len(found))
    if motion is not None:
        yield frame["slow"].format(a=axis, speed=f"{motion.distance / 2:g}")
    for each in found:
        assert each.probe is not None
        before, ask, after = lines_of(each.probe, axis, motion.step if motion is not None else 0.0)
        if before:
            yield marked(NEXT)
            yield from before
        yield marked(each.name)
        yield ask
        if after:
            yield marked(NEXT)
            yield from after
    yield marked(END)
