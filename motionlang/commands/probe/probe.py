"""A probe: a program that tests assumptions on a real controller.

The owner of the controller runs it. It moves nothing and writes no setting, unless motion is allowed. Each question
prints one answer, marked with the name of its assumption, so that answers can be found in a terminal's output. A
question that writes settings, or may end with an error, has a program of its own.
"""

from __future__ import annotations

import re
import textwrap
import tomllib
from collections.abc import Collection, Iterator, Sequence
from dataclasses import dataclass
from zlib import crc32

from motionlang.commands.probe.assumption import REFUSED, Assumption, Probe
from motionlang.commands.probe.entries import assumptions
from motionlang.kernel.files import package_text
from motionlang.kernel.tools import count_of

# The number that a probe of MCCL prints before an answer, from a register; each name has its own.
FIRST_MARK = 731_000_000
MARKS = 1_000_000
BEGIN, END, NEXT = "probe", "end", "next"
# A longer answer has a line of its own.
WIDE = 24
# The display of a pattern: signs and their replacements, one after the other.
PLAIN = (
    (r"0\??\\d\+?", "01"),
    (r"\\\?", "\0"),
    (r"\(\?!\\1.*?\$\)", "another "),
    (r"\[01\]", "0 or 1"),
    (r"\\1", "the same"),
    (r"\(\?i\)|-\?|\(\?[!:][^()]*(?:\([^()]*\)[^()]*)*\)\??", ""),
    (r"\((?:[^()|]|\([^()]*\))*\)[?*]", ""),
    (r"(?<!\\)\.\*|\\S\+", "…"),
    (r"\[[-0-9.]+\][+*]?|\\d(?:[+*]|\{\d\})?", "n"),
    (r"\\\.", "."),
    (r"0[+*]", "0"),
    (r"\((.*)\|(.*)\)", r"\1 or \2"),
    (r"[()\\?$^]", ""),
    ("\0", "?"),
)
# The maximum travel of a question with motion, in its steps of the distance.
STEPS = 4


@dataclass(eq=False, slots=True)
class MotionPermission:
    """The owner's permission to move an axis by up to `distance` user units."""

    axis: int
    distance: float

    @property
    def step(self) -> float:
        """The value of `{d}` in a question; an integer if possible.

        A board without a scale needs an integer.
        """
        return float(self.distance // STEPS) or self.distance / STEPS


def asked(language: str, *, motion: bool, without: Collection[str] = ()) -> list[Assumption]:
    """Return the assumptions of a language that a probe tests.

    Those that need motion are included only if motion is allowed.
    """
    found = [
        each
        for each in assumptions().values()
        if each.probe is not None
        and not each.probe.alone
        and each.probe.language == language
        and (motion or not each.probe.motion)
        and each.name not in without
    ]
    return sorted(found, key=_moves)


def _moves(assumption: Assumption) -> bool:
    """True if the question moves an axis or writes a setting, and so comes last.

    Settings are read in their state at power-up.
    """
    return assumption.probe is not None and assumption.probe.motion


def written(
    language: str, axis: int, motion: MotionPermission | None = None, without: Collection[str] = ()
) -> str:
    """Return the text of a probe."""
    found = asked(language, motion=motion is not None, without=without)
    head, maker, sign = (_mint_head, _mint, "'") if language == "mint" else (_mccl_head, _mccl, ";")
    lines = [*(f"{sign} {line}" for line in head(found, motion)), *maker(found, axis, motion)]
    return "\n".join(lines) + "\n"


def alone(assumption: Assumption, axis: int, motion: MotionPermission | None = None) -> str:
    """Return the text of a probe with one question, and the meanings of its answers."""
    assert assumption.probe is not None
    maker, sign = (_mint, "'") if assumption.probe.language == "mint" else (_mccl, ";")
    needs = assumption.probe.needs.replace("{a}", str(axis)).replace("{b}", str(axis + 1))
    first = [f"First: {needs}."] if needs else []
    if motion is not None and assumption.probe.motion:
        first.append(_reach(assumption.probe, motion))
    above = [f"{assumption.name}: {assumption.question}", *first, *meanings(assumption)]
    last = ["Then: motionlang probe --answers LOG, where LOG is what the terminal showed."]
    if REFUSED in assumption.probe.answers:
        last[0] += f" Of a program that is refused, LOG is <{assumption.name}|{REFUSED}>."
    lines = [sign + f" {line}".rstrip() for each in (*above, *last) for line in _wrapped(each)]
    return "\n".join((*lines, *maker([assumption], axis, motion))) + "\n"


def _wrapped(line: str) -> list[str]:
    return [line] if line.startswith("  ") else textwrap.wrap(line, 110)


def meanings(assumption: Assumption, most: int = 110) -> list[str]:
    """Return the possible answers and their meanings, one per line."""
    probe = assumption.probe
    assert probe is not None
    chosen = f"{assumption.chosen} (chosen here)"
    pairs = [(probe.answers[0], chosen), *zip(probe.answers[1:], assumption.alternatives, strict=False)]
    shown = [(as_shown(answer), meaning) for answer, meaning in pairs]
    if probe.form:
        shown.append(("another number", "that is it"))
    width = min(WIDE, max(len(answer) for answer, _ in shown))
    lines = ["What it shows, and what that says of the controller:"]
    for answer, meaning in shown:
        begin, indent = f"  {answer:<{width}}  ", " " * (width + 4)
        if len(answer) > WIDE:
            lines.append(f"  {answer}")
            begin = indent
        lines += textwrap.wrap(meaning, most, initial_indent=begin, subsequent_indent=indent)
    return lines


def as_shown(answer: str) -> str:
    """Return an answer for display: a pattern without special characters, or an event."""
    if answer == REFUSED:
        return "(the compiler refuses it)"
    if not answer:
        return "(nothing)"
    if not answer.startswith("re:"):
        return answer
    text = answer.removeprefix("re:")
    for pattern, instead in PLAIN:
        text = re.sub(pattern, instead, text)
    return text


def mark(name: str) -> int:
    """Return the number that a probe of MCCL prints before the answer to a question."""
    return FIRST_MARK + crc32(name.encode()) % MARKS


def lines_of(probe: Probe, axis: int, step: float) -> tuple[list[str], str, list[str]]:
    """Return the lines before a question, the question, and the lines after it."""

    def filled(text: str) -> str:
        text = text.replace("{a}", str(axis)).replace("{b}", str(axis + 1))
        return text.replace("{2d}", f"{2 * step:.10g}").replace("{d}", f"{step:.10g}")

    return [filled(each) for each in probe.before], filled(probe.ask), [filled(each) for each in probe.after]


def _reach(probe: Probe, motion: MotionPermission) -> str:
    """Return a sentence that names the axes a question moves, and the distance."""
    both = any("{b}" in line for line in (*probe.before, probe.ask, *probe.after))
    axes = f"axes {motion.axis} and {motion.axis + 1}" if both else f"axis {motion.axis}"
    where = "their positions" if both else "its position"
    within = f"within {motion.distance:.10g} user units of {where}"
    return f"It moves {axes} {within}. Enable what moves; stop it as any motion."


def _promise(language: str, motion: MotionPermission | None) -> str:
    if motion is None:
        return "It moves nothing and writes no setting. It can be stopped at any time."
    within = f"It moves axis {motion.axis} within {motion.distance:.10g} user units of its position"
    if language == "mint":
        return f"{within}, and puts back what it writes. The axis must be enabled. Stop it as any motion."
    speed = f"leaves its velocity at {motion.distance / 2:.10g}"
    return f"{within}, which is 0 afterwards, switches it on and {speed}. Stop it as any motion."


def _mint_head(found: Sequence[Assumption], motion: MotionPermission | None) -> Iterator[str]:
    yield f"{count_of(len(found), 'question')} of motionlang about this controller, one line of answer each."
    yield _promise("mint", motion)
    yield "Run it after power-up, with the settings of the factory. A line that does not compile may be deleted."
    yield "Then: motionlang probe --answers LOG, where LOG is what the terminal showed."


def _mccl_head(found: Sequence[Assumption], motion: MotionPermission | None) -> Iterator[str]:
    yield f"{count_of(len(found), 'question')} of motionlang about this controller, one line each."
    yield _promise("mccl", motion)
    yield "Send it line by line after power-up, and keep what the terminal shows."
    yield "Then: motionlang probe --answers LOG"


def _mint(found: Sequence[Assumption], axis: int, motion: MotionPermission | None) -> Iterator[str]:
    yield "Dim fa As Float, fb As Float, ia As Integer, ib As Integer"
    yield f'PRINT "<{BEGIN}|mint {len(found)}>"'
    slow = False
    for each in found:
        assert each.probe is not None
        if motion is not None and each.probe.motion and not slow:
            slow = True
            yield "Dim fs As Float"
            yield f"fs = SPEED({axis})"
            yield f"SPEED({axis}) = {motion.distance / 2:.10g}"
        before, ask, after = lines_of(each.probe, axis, motion.step if motion is not None else 0.0)
        yield from before
        yield f'PRINT "<{each.name}|"; {ask}; ">"'
        yield from after
    if slow:
        yield f"SPEED({axis}) = fs"
    yield f'PRINT "<{END}|mint {len(found)}>"'
    yield "End"
    for each in found:
        yield from _behind(each, axis)


def _behind(assumption: Assumption, axis: int) -> Iterator[str]:
    """Yield the lines after the End of a program: from the probe, and error output."""
    assert assumption.probe is not None
    for line in assumption.probe.behind:
        yield line.replace("{a}", str(axis))
    if assumption.probe.error:
        command = assumption.probe.error.replace("{a}", str(axis))
        yield "Event ONERROR"
        yield f'  PRINT "<{assumption.name}|"; {command}; ">"'
        yield f'  PRINT "<{END}|mint 1>"'
        yield "  End"
        yield "End Event"


def _mccl(found: Sequence[Assumption], axis: int, motion: MotionPermission | None) -> Iterator[str]:
    frame = tomllib.loads(package_text("commands/probe/evidence/mccl/probe.toml"))

    def marked(name: str) -> str:
        text: str = frame["mark"].format(mark=mark(name))
        return text

    yield frame["begin"].format(mark=mark(BEGIN), count=len(found))
    if motion is not None:
        yield frame["slow"].format(a=axis, speed=f"{motion.distance / 2:.10g}")
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
