"""`motionlang improve`: a shorter cycle within the limits of the machine."""

from __future__ import annotations

import os
import re
import sys
from dataclasses import dataclass
from typing import ClassVar

from motionlang.cli import option_groups as shared
from motionlang.cli.command import Refused, WrongOption, argument, option
from motionlang.cli.option_groups import OutputOptions, ProgramOptions, with_world
from motionlang.cli.output_files import written
from motionlang.cli.readers import machine_time, whole
from motionlang.commands.quantities import CYCLE, CYCLES
from motionlang.kernel import STDIN, CheckedSettings, Diagnostic, ProgramError
from motionlang.kernel.files import replacing
from motionlang.kernel.tools import count_of, need
from motionlang.views.progress import Progress
from motionlang.views.terminal import table_width, wants_colour
from motionlang_explore.improve import Edit, NotPossible, improver_of
from motionlang_explore.improve.view import difference, improvement_document, improvement_lines

# So many runs are the end of the progress line; a search may take fewer or more.
RUNS = 1000


def percent(text: str) -> float:
    """Return a percentage, such as 10 or 10%, as a share."""
    try:
        share = float(text.removesuffix("%")) / 100.0
    except ValueError:
        share = -1.0
    if not 0.0 < share < 1.0:
        raise ValueError(f"{text!r} is not a percentage such as 10%")
    return share


def names(text: str) -> tuple[str, ...]:
    """Return names that are separated by commas, none of which is within brackets."""
    found = re.split(r",(?![^\[(]*[\])])", text)
    return tuple(each.strip() for each in found if each.strip())


def cycle(text: str) -> str:
    """Return the name of a cycle."""
    if CYCLE.fullmatch(text) is None:
        raise ValueError(f"{text!r} is no cycle; write {CYCLES}")
    return text


@dataclass
class Improve(OutputOptions, shared.WorldOptions, ProgramOptions):
    """Find a shorter cycle within the limits of the machine."""

    title: ClassVar[str] = "improvement"
    epilog: ClassVar[str] = """\
Changed are the numbers that set speeds, rates and jerks of
axes with limits, as far as no limit is exceeded, each task does the same in the
same order, and no scenario fails. The speeds of the process stay, such as that
of a homing, a glue gun or a drill; --also SPEED[0]@9 tries one. The program
itself is not changed: apply the difference with patch.

exit status: 0 if the cycle is shorter, or as short as wanted; 1 if not

examples:
  motionlang improve pick.mnt --by 10%
  motionlang improve pick.mnt --edits 2 --patch faster.diff
  motionlang improve line.prg --cycle "cycle(output 3)"
"""
    file: str = argument("FILE", "the program")
    by: float | None = option("PERCENT", "the fewest edits that shorten the cycle by so much", read=percent)
    edits: int | None = option(
        "N",
        "the best edits, at most N; numbers that are scaled together are one",
        read=whole("a number from 1 to 8", 1, 8),
    )
    cycle: str | None = option(
        "NAME",
        "what repeats: cycle(12), cycle(output 3) …; default: the cycle that run names, or the whole run",
        read=cycle,
    )
    hold: tuple[str, ...] = option(
        "NAME,...",
        "keep these numbers: SPEED[0]@9, or the name of a constant",
        default=(),
        read=names,
    )
    also: tuple[str, ...] = option(
        "NAME,...",
        "change these numbers of the process, too: SPEED[0]@9; all for all of them",
        default=(),
        read=names,
    )
    patch: str | None = option("FILE", "also write the difference of the program", writes=True)
    allow: frozenset[str] = shared.accepted_events()
    until: float | None = option("S", "end each run after S seconds of machine time", read=machine_time)

    def check(self) -> None:
        super().check()
        if self.by is not None and self.edits is not None:
            raise WrongOption("give either --by or --edits, not both")
        if self.overrides():
            raise WrongOption(
                "--set takes keys of the machine only: improve changes the program's numbers itself"
            )

    def run(self) -> int:
        need("motionlang improve", "numpy")
        source, language = self.source(), self.known_language()
        settings = CheckedSettings(with_world(self.settings(), self.entries()))
        progress = Progress(sys.stderr, os.path.basename(self.file))
        try:
            improver = improver_of(
                source if self.file == STDIN else self.file,
                settings,
                dialect=language,
                cycle=self.cycle or "",
                until=self.until,
                progress=lambda runs, playing: progress(min(runs / RUNS, 1.0), playing),
                machine=self.machine_path(),
                hold=self.hold,
                also=self.also,
                allow=self.allow,
            )
            found = improver.improved(self.by or 0.0, self.edits or 0)
        except NotPossible as error:
            raise Refused([Diagnostic(error.code, error.message, hint=error.hint)], file=self.file) from None
        except ProgramError as error:
            raise Refused(error.diagnostics, source=source, file=self.file) from None
        finally:
            progress.done()
        lines = improvement_lines(
            found, self.file, width=table_width(sys.stdout), colour=wants_colour(sys.stdout)
        )
        self.show(improvement_document(found, self.file), "\n".join(lines) + "\n")
        if found.ways is not None and found.ways.refused:
            raise Refused([_refused_in_ways(found.ways.refused, found.edits[0])], file=self.file)
        wanted = found.before * (1.0 - (self.by or 0.0))
        if self.by is not None and found.after > wanted * (1.0 + 1e-9):
            sys.stderr.write(
                f"not {100.0 * self.by:.10g} %: this is all that the limits and the program allow\n"
            )
            return 1
        path = self.patch
        if path is None or not found.edits:
            return 0 if found.edits else 1
        text = "".join(difference(found, self.file))
        return written(path, lambda: _write(path, _as_in(self.file, text)))


def _refused_in_ways(ways: list[str], edit: Edit) -> Diagnostic:
    """Return the error that the edits, B, change an end or a printed line in some ways."""
    more = f", and {count_of(len(ways) - 1, 'other way')}" if len(ways) > 1 else ""
    hint = f"--hold {edit.literal.address} keeps that number; --edits and --by make fewer edits"
    return Diagnostic("beyond-limit", f"the edits change what the program does: {ways[0]}{more}", hint=hint)


def _as_in(program: str, text: str) -> bytes:
    """Return a difference with the line endings and the encoding of its program, as `patch` needs them."""
    if program == STDIN:
        return text.encode()
    with open(program, "rb") as file:
        data = file.read()
    try:
        data.decode("utf-8")
        encoding = "utf-8"
    except UnicodeDecodeError:
        encoding = "latin-1"
    lines = text.splitlines(keepends=True)
    if b"\r\n" in data:
        head = ("---", "+++", "@@")
        lines = [each if each.startswith(head) else each.replace("\n", "\r\n") for each in lines]
    return "".join(lines).encode(encoding)


def _write(path: str, data: bytes) -> None:
    with replacing(path) as file:
        file.write(data)
