"""`motionlang probe`: write a test program for assumptions, evaluate its answers."""

from __future__ import annotations

import sys
import textwrap
from collections.abc import Iterable
from dataclasses import dataclass
from typing import ClassVar

from motionlang.cli.command import Command, WrongOption, argument, flag, option
from motionlang.cli.complaints import complain
from motionlang.cli.option_groups import read as read_file
from motionlang.cli.readers import integer, real
from motionlang.commands.probe.answers import (
    HOLDS,
    OTHER,
    UNKNOWN,
    Answers,
    AnswerVerdict,
    machine_text,
    read,
)
from motionlang.commands.probe.assumption import Assumption, Probe
from motionlang.commands.probe.probe import MotionPermission, alone, asked, written
from motionlang.commands.probe.questions import of_word, questions
from motionlang.kernel import STDIN, STDIN_NAME, dialect, dialects, name_of
from motionlang.kernel.tools import count_of, nearest

# The suffix of assumptions about power-up, and how many of them are named.
DEFAULT, SHOWN = "-default", 6


@dataclass
class ProbeCommand(Command):
    """Write a test program that settles open questions on a real controller."""

    title: ClassVar[str] = "questions"
    epilog: ClassVar[str] = """\
The test program (the probe) goes to standard output. It moves nothing, writes
no settings, prints one answer per question, and can be stopped at any time. Run
it on the controller after power-up, save the terminal output, and read it with
--answers. That lists the confirmed and the refuted assumptions on standard
error and prints the [assumptions] of a machine file that make the virtual
controller give the same answers. Mint probes are for MintMT.

Questions that write settings or may end with an error have programs of their
own, by name; comments in the program say what to do first and what each answer
means. --list shows all questions, or those about a keyword. docs/fidelity.md
says what is confirmed, docs/contributing/assumptions.md lists every assumption.

exit status: 0 every answer was read; 1 answers are missing, cut off or
contradictory; 2 the command line is invalid

examples:
  motionlang probe mint > probe.mnt            questions that need no motion
  motionlang probe mint --motion 20 --axis 1   include motion within 20 uu
  motionlang probe --answers log.txt > cell.machine.toml    read the answers
  motionlang probe mint.integer-overflow > probe.mnt        one question
  motionlang probe HOMESPEED --list            the questions about a keyword
"""
    what: str | None = argument(
        "mint|mccl|NAME", "the language of the controller, or the name of one question", default=None
    )
    list_: bool = flag("list the questions of a language or about a keyword, one per line")
    answers: str | None = option("LOG", "read the controller's terminal output; - reads standard input")
    motion: float | None = option(
        "DISTANCE",
        "include questions that need motion; the axis moves at most this far, in user units, from its position",
        read=real("a distance above 0", 0.0, above=True),
    )
    axis: int | None = option("N", "the axis to test; default: the first", read=integer)
    skip: list[str] = option("NAME", "leave a question out; may be repeated", many=True)

    def run(self) -> int:
        what = self.what
        if self.answers is not None:
            if self.motion is not None or self.axis is not None or self.skip or self.list_:
                raise WrongOption("--answers reads answers; the other options write a probe")
            if what is not None and what not in dialects():
                problem = f"{what!r} is not one of {', '.join(dialects())}"
                is_question = what in questions()
                raise WrongOption(
                    f"{problem}; --answers reports every question in the log" if is_question else problem
                )
            return _answers(self.answers, what or "")
        if self.list_:
            return _list(what)
        if what is None:
            raise WrongOption("give the language of the controller, mint or mccl, or --answers LOG")
        language = what if what in dialects() else _named(what).language
        axis = dialect(language).first_axis if self.axis is None else self.axis
        if not 0 <= axis < 100:
            raise WrongOption(f"--axis {axis}: no such axis")
        motion = None if self.motion is None else MotionPermission(axis, self.motion)
        if what not in dialects():
            if self.skip:
                raise WrongOption(f"--skip leaves questions out of a list, but {what} is a single question")
            if _named(what).motion and motion is None:
                raise WrongOption(f"{what} needs motion: give the distance, such as --motion 20")
            sys.stdout.write(alone(questions()[what], axis, motion))
            return 0
        names = [each.name for each in asked(language, motion=True)]
        for name in self.skip:
            if name not in names:
                near = nearest(name, names)
                raise WrongOption(
                    f"--skip {name}: no such question" + (f"; did you mean {near}?" if near else "")
                )
        sys.stdout.write(written(language, axis, motion, self.skip))
        return 0


def _named(name: str) -> Probe:
    """Return the probe with a name; WrongOption, with the alternatives, for an unknown one."""
    found = questions().get(name)
    if found is not None and found.probe is not None:
        return found.probe
    if found is not None:
        others = "".join(f"; or: {each}" for each in found.alternatives)
        problem = f"no program can settle {name}. {found.question}: {found.chosen}{others}"
    elif _about(name):
        problem = f"{name} is a keyword: motionlang probe {name} --list shows the questions about it"
    else:
        near = nearest(name, (*dialects(), *questions()))
        problem = f"{name!r} is neither mint, mccl nor a question" + (
            f"; did you mean {near}?" if near else "; motionlang probe --list shows the questions"
        )
    raise WrongOption(problem)


def _about(word: str) -> list[Assumption]:
    """Return the open assumptions about a keyword, in any language."""
    rows = ((each, dialect(each).table().get(word)) for each in dialects())
    return [found for language, row in rows if row is not None for found in of_word(language, row)]


def _list(what: str | None) -> int:
    """Print the available questions, one per line, with their requirements."""
    if what is None or what in dialects():
        known = [
            each
            for each in questions().values()
            if what is None or (each.probe and each.probe.language == what)
        ]
    else:
        known = _about(what) or [each for each in questions().values() if each.name == what]
        if not known:
            raise WrongOption(f"{what} is not a keyword, or has no open question")
    found = [each for each in known if each.probe is not None]
    width = max((len(each.name) for each in found), default=0)
    for each in found:
        assert each.probe is not None
        marks = (
            ["motion"] * each.probe.motion + ["by name"] * each.probe.alone + ["can be set"] * bool(each.key)
        )
        end = f"  ({', '.join(marks)})" if marks else ""
        sys.stdout.write(f"{each.name:<{width}}  {each.question}{end}\n")
    if len(found) < len(known) and what not in dialects() and what is not None:
        sys.stdout.write("not settled by a program:\n")
        for each in known:
            if each.probe is None:
                sys.stdout.write(f"{each.name:<{width}}  {each.question}\n")
    return 0


def _answers(path: str, language: str) -> int:
    source = read_file(path)
    found = read(source.text, language)
    complain(found.problems, source, STDIN_NAME if path == STDIN else path)
    if found.verdicts:
        sys.stderr.write(_summary(found))
        sys.stderr.flush()
        sys.stdout.write(machine_text(found, STDIN_NAME if path == STDIN else name_of(path)))
    return 1 if any(each.severity == "error" for each in found.problems) else 0


def _summary(found: Answers) -> str:
    """Return the evaluation of the answers as text."""
    lines: list[str] = []
    by_status = {
        status: [each for each in found.verdicts if each.status == status]
        for status in (HOLDS, OTHER, UNKNOWN)
    }
    if by_status[HOLDS]:
        names = ", ".join(_names(each.assumption for each in by_status[HOLDS]))
        lines += [f"{count_of(len(by_status[HOLDS]), 'assumption confirmed', 'assumptions confirmed')}:"]
        lines += textwrap.wrap(names, 98, initial_indent="  ", subsequent_indent="  ", break_on_hyphens=False)
    if by_status[OTHER]:
        lines += [f"{len(by_status[OTHER])} refuted:", *map(_other, by_status[OTHER])]
    if by_status[UNKNOWN]:
        lines += ["unknown answers, which set nothing:"]
        lines += [f"  {each.assumption.name}: {each.answer!r}" for each in by_status[UNKNOWN]]
    return "\n".join(lines) + "\n"


def _names(found: Iterable[Assumption]) -> list[str]:
    """Return the names of assumptions; if many are about power-up, only their number."""
    names = [each.name for each in found]
    rest = [name for name in names if not name.endswith(DEFAULT)]
    many = len(names) - len(rest)
    return [*rest, f"and {many} settings at power-up"] if many > SHOWN else names


def _other(verdict: AnswerVerdict) -> str:
    assumption = verdict.assumption
    how = "" if verdict.can_be_set else "; it cannot be set"
    return f"  {assumption.name}: {assumption.question}: {verdict.what}, not {assumption.chosen}{how}"
