"""`motionlang cover`: what the runs of programs reach, and what they do not."""

from __future__ import annotations

import sys
from collections import Counter
from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from functools import partial
from itertools import count
from typing import ClassVar

from motionlang.cli.command import Refused, WrongOption, argument, flag, option
from motionlang.cli.complaints import complain, no_dialect, unreadable
from motionlang.cli.option_groups import Jobs, Language, OutputOptions, read
from motionlang.cli.output_files import written
from motionlang.cli.program_files import PATHS, programs
from motionlang.cli.readers import machine_time, real
from motionlang.cli.signals import SIGNALS
from motionlang.kernel import STDIN, Diagnostic, ProgramError, Source, Terminated, language_of
from motionlang.kernel.files import replacing
from motionlang.kernel.tools import count_of, lines_words
from motionlang.processes.parallel import in_parallel
from motionlang.views.terminal import table_width, wants_colour
from motionlang_explore.cover import Coverage, covered, worlds_of
from motionlang_explore.cover.suggestions import Search, SuggestedWorld
from motionlang_explore.cover.view import coverage_document, files_table, lcov, listing, page, percentage
from motionlang_explore.cover.worlds import CutOff, Event, Worlds
from motionlang_explore.exploration import explore, without_world
from motionlang_explore.playing import play_time, played_lines, playing, seconds_option
from motionlang_explore.scenario_text import write_scenario


@dataclass
class Cover(OutputOptions, Jobs, Language):
    """Show which statements and conditions of programs their runs reach."""

    title: ClassVar[str] = "coverage"
    epilog: ClassVar[str] = f"""\
Each program runs in its own world, that of the machine file next to it, and in
all its scenarios. A condition is covered if it was both true and false.

exit status: 0 if enough is covered; 1 if less, or a program cannot run;
2 the command line is invalid

{played_lines()}
examples:
  motionlang cover pick.mnt --all
  motionlang cover programs --fail-under 90 --lcov coverage.info
"""
    files: list[str] = argument("FILE", f"{PATHS}; - reads standard input", many=True, default=["."])
    all: bool = flag("list each program with the count of every line")
    fail_under: float | None = option(
        "PERCENT",
        "exit with 1 if less is covered, of statements and outcomes of all programs together",
        read=real("a percentage from 0 to 100", 0.0, 100.0),
    )
    suggest: bool = flag(
        "write scenarios that reach more, with their results as expectations to review, next to each program"
    )
    until: float | None = option("S", "end each run after S seconds of machine time", read=machine_time)
    seconds: float | None = seconds_option(before="with --suggest, ")
    html: str | None = option("PAGE", "also write a page with the listings", suffixes=(".html",))
    lcov: str | None = option("FILE", "also write a tracefile of lcov, for other tools", writes=True)

    def check(self) -> None:
        if self.format is None and not self.html and (self.output or "").lower().endswith(".html"):
            self.html, self.output, self.quiet = self.output, None, True
        super().check()
        given = [name for name in ("all", "fail_under", "html", "lcov") if getattr(self, name)]
        if self.suggest and given:
            raise WrongOption(
                f"--suggest writes scenarios; run cover again for --{given[0].replace('_', '-')}"
            )
        if not self.suggest and "seconds" in self.typed:
            raise WrongOption("--seconds limits the search of --suggest")
        if self.suggest and STDIN in self.files:
            raise WrongOption("--suggest writes scenarios next to a program, not next to -")

    def run(self) -> int:
        files = programs(self.files)
        if not files:
            sys.stderr.write(f"no programs in {', '.join(self.files)}\n")
            return 1
        if self.suggest:
            return max(map(self._suggest, files))
        found, failed, is_cut = list[Coverage](), False, False
        work = partial(_covered, replace(self))  # a copy without its parser, for other processes
        made = zip(files, in_parallel(work, files, self.jobs), strict=True)
        try:
            for file, result in made:
                if isinstance(result, Coverage):
                    found.append(result)
                    is_cut |= bool(result.cut)
                else:
                    failed = True
                    complain(result, _named(result, file), file)
                if is_cut:
                    break
        except (KeyboardInterrupt, Terminated):
            is_cut = True
        lines = self._lines(found)
        self.show(coverage_document(found), "\n".join(lines) + "\n" if found else "")
        status = self._write(found)
        if is_cut:
            left = [*(each.file for each in found if each.cut), *files[len(found) :]]
            sys.stderr.write(f"note: cut off, so what it reaches is not known: {', '.join(left)}\n")
            return SIGNALS.status
        share = percentage(found)
        if self.fail_under is not None and share < self.fail_under:
            sys.stderr.write(f"{share:.1f} % is covered, less than {self.fail_under:.10g} %\n")
            return 1
        return 1 if failed else status

    def _suggest(self, file: str) -> int:
        """Write scenarios for what no run of a program reaches; return the exit status."""
        language = language_of(self.lang, file)
        if language is None:
            raise Refused([no_dialect(file)], file=file, status=2)
        source = read(file)
        ended = False
        scenarios: dict[str, str] = {}
        try:
            with playing(file) as progress:
                all_own = worlds_of(file)
                own = all_own[""]
                program = language.program(source, own, is_debug=True)
                program.require()
                runs = Worlds(program, language)
                before: Counter[Event] = Counter()
                for settings in all_own.values():
                    before += runs.run(settings, self.until).events
                exploration = explore(
                    program,
                    without_world(own),
                    progress=progress,
                    **play_time(self.seconds),
                )
                search = Search(runs, exploration, own, before, self.until)
                was = search.coverage
                try:
                    for world in search.run():
                        scenarios |= self._write_scenario(file, world)
                except (CutOff, KeyboardInterrupt, Terminated):
                    ended = True
        except CutOff as at:
            SIGNALS.end_with(at.result)
            raise
        except ProgramError as error:
            raise Refused(error.diagnostics, source=source, file=file) from None
        found = replace(search.coverage, file=file, worlds=[*all_own, *scenarios])
        shares = " → ".join(f"{percentage([each]):.0f} %" for each in (was, found))
        text = f"{file}: {shares} with {count_of(len(scenarios), 'scenario')}\n"
        text += "".join(f"  {name}: {about}\n" for name, about in scenarios.items())
        begun = {each.line for each in found.statements if each.count}
        parts = {
            "not reached": found.missed.keys() - begun,
            "reached only in part": found.missed.keys() & begun,
        }
        text += "".join(f"  {words}: {lines_words(lines)}\n" for words, lines in parts.items() if lines)
        if found.missed:
            more = "" if exploration.is_whole else ", and more could be tried: --seconds 60 plays on"
            text += f"  {count_of(exploration.trials, 'trial')} played{more}\n"
        self.show(coverage_document([found]), text)
        return SIGNALS.status if ended else 0

    def _write_scenario(self, file: str, world: SuggestedWorld) -> dict[str, str]:
        """Write the scenario of a world that was found; return what the file is about, by its name."""
        names = (f"{world.name}{'' if n == 1 else f'-{n}'}" for n in count(1))
        path = write_scenario(file, names, world.text)
        return {path: f"reaches {lines_words(world.reaches) or 'more of some lines'}"}

    def _lines(self, found: Sequence[Coverage]) -> list[str]:
        colour = wants_colour(sys.stdout)
        lines = [line for each in found for line in [*listing(each, colour), ""]] if self.all else []
        lines += files_table(found).lines(table_width(sys.stdout), colour=colour)
        if len(found) > 1:
            lines += ["", f"{percentage(found):.0f} % of {len(found)} programs"]
        return lines

    def _write(self, found: Sequence[Coverage]) -> int:
        """Write the page and the tracefile; return the exit status."""
        texts: dict[str | None, Callable[[], str]] = {
            self.html: lambda: page(found),
            self.lcov: lambda: "\n".join(lcov(found)) + "\n",
        }
        return max((_write(path, text) for path, text in texts.items() if path is not None), default=0)


def _write(path: str, text: Callable[[], str]) -> int:
    def write() -> None:
        with replacing(path) as file:
            file.write(text().encode())

    return written(path, write)


def _covered(options: Cover, file: str) -> Coverage | list[Diagnostic]:
    """Return the coverage of a program, or why it has none."""
    language = language_of(options.lang, file)
    if language is None:
        return [no_dialect(file)]
    try:
        return covered(read(file) if file == STDIN else file, dialect=language, until=options.until)
    except OSError as error:
        return [unreadable(str(error.filename or file), error)]
    except ProgramError as error:
        return list(error.diagnostics)


def _named(found: Sequence[Diagnostic], file: str) -> Source | None:
    """Return the text that diagnostics are about; None if it cannot be read."""
    try:
        return Source.read(file) if any(each.line for each in found) else None
    except OSError:
        return None
