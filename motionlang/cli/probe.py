"""`motionlang probe`: a program that asks a controller which readings hold, and what its answers say."""

from __future__ import annotations

import argparse
import math
import sys
import textwrap
from typing import TYPE_CHECKING

from motionlang.cli.complaints import complain, unreadable
from motionlang.cli.input_files import read_source
from motionlang.cli.parser import add_command
from motionlang.errors import nearest
from motionlang.execution import dialect, dialects
from motionlang.readings.answers import HOLDS, OTHER, UNKNOWN, counted, machine_text, read
from motionlang.readings.probe import Motion, asked, written
from motionlang.source import STDIN, STDIN_NAME, name_of

if TYPE_CHECKING:
    from motionlang.cli.parser import Commands
    from motionlang.readings.answers import Answers, Verdict

EPILOG = """\
The probe goes to standard output. It moves nothing and writes no setting, prints one answer a question, and can be
stopped at any time. Run it on the controller after power-up, keep what the terminal shows, and let --answers read it:
it says which readings hold and which do not, on standard error, and prints the [readings] of a machine file that make
the virtual controller answer alike. A probe of Mint is for MintMT. docs/fidelity.md lists the readings.

exit status: 0 all answers could be read; 1 some are missing, cut off or contradict one another; 2 the command line is
wrong

examples:
  motionlang probe mint > probe.mnt                        questions that move nothing
  motionlang probe mint --motion 20 --axis 1 > probe.mnt   also those that move axis 1, within 20 user units
  motionlang probe --answers log.txt > cell.machine.toml   what the controller said
"""


def add_parser(commands: Commands, summary: str) -> None:
    """`motionlang probe` and its options."""
    parser = add_command(commands, "probe", summary, _probe, EPILOG)
    add = parser.add_argument
    add(
        "language",
        metavar="mint|mccl",
        nargs="?",
        choices=dialects(),
        help="the language that the controller speaks",
    )
    add("--answers", metavar="LOG", help="what the controller's terminal showed; - reads standard input")
    add(
        "--motion",
        type=_distance,
        metavar="DISTANCE",
        help="ask also what needs motion: the axis moves within so many user units of where it stands",
    )
    add("--axis", type=int, metavar="N", help="the axis that is asked; without it the first one")
    add(
        "--without", action="append", default=[], metavar="NAME", help="leave a question out; may be repeated"
    )


def _distance(text: str) -> float:
    try:
        value = float(text)
    except ValueError:
        value = math.nan
    if not 0 < value < math.inf:
        raise argparse.ArgumentTypeError(f"{text!r} is no distance above 0")
    return value


def _probe(arguments: argparse.Namespace) -> int:
    parser: argparse.ArgumentParser = arguments.parser
    if arguments.answers is not None:
        if arguments.motion is not None or arguments.axis is not None or arguments.without:
            parser.error("--answers reads what a probe was answered; the other options write one")
        return _answers(arguments.answers, arguments.language or "")
    if arguments.language is None:
        parser.error("say which language the controller speaks, mint or mccl, or give --answers LOG")
    axis = dialect(arguments.language).first_axis if arguments.axis is None else arguments.axis
    if not 0 <= axis < 100:
        parser.error(f"--axis {axis}: there is no such axis")
    names = [each.name for each in asked(arguments.language, motion=True)]
    for name in arguments.without:
        if name not in names:
            near = nearest(name, names)
            parser.error(
                f"--without {name}: there is no such question" + (f"; did you mean {near}?" if near else "")
            )
    motion = None if arguments.motion is None else Motion(axis, arguments.motion)
    sys.stdout.write(written(arguments.language, axis, motion, arguments.without))
    return 0


def _answers(path: str, language: str) -> int:
    try:
        source = read_source(path)
    except OSError as error:
        complain([unreadable(path, error)], None, path)
        return 1
    found = read(source.text, language)
    complain(found.problems, source, STDIN_NAME if path == STDIN else path)
    if found.verdicts:
        sys.stderr.write(_told(found))
        sys.stderr.flush()
        sys.stdout.write(machine_text(found, STDIN_NAME if path == STDIN else name_of(path)))
    return 1 if any(each.severity == "error" for each in found.problems) else 0


def _told(found: Answers) -> str:
    """What the answers say, for a person."""
    lines: list[str] = []
    by_status = {
        status: [each for each in found.verdicts if each.status == status]
        for status in (HOLDS, OTHER, UNKNOWN)
    }
    if by_status[HOLDS]:
        names = ", ".join(each.reading.name for each in by_status[HOLDS])
        lines += [f"{counted(len(by_status[HOLDS]), 'reading holds', 'readings hold')}:"]
        lines += textwrap.wrap(names, 98, initial_indent="  ", subsequent_indent="  ", break_on_hyphens=False)
    if by_status[OTHER]:
        lines += [f"{counted(len(by_status[OTHER]), 'does', 'do')} not:", *map(_other, by_status[OTHER])]
    if by_status[UNKNOWN]:
        lines += ["answered as nothing that is known would, so that nothing is set:"]
        lines += [f"  {each.reading.name}: {each.answer!r}" for each in by_status[UNKNOWN]]
    return "\n".join(lines) + "\n"


def _other(verdict: Verdict) -> str:
    reading = verdict.reading
    how = "" if verdict.can_be_set else "; it cannot be set"
    return f"  {reading.name}: {reading.question}: {verdict.what}, not {reading.chosen}{how}"
