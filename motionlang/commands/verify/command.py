"""`motionlang verify`: run programs and compare them with their golden files."""

from __future__ import annotations

import os
import sys
from collections.abc import Collection, Sequence
from dataclasses import dataclass
from functools import partial
from typing import ClassVar

from motionlang.cli.command import WrongOption, argument, flag, option
from motionlang.cli.complaints import complain, no_dialect, unreadable
from motionlang.cli.option_groups import Findings, Jobs
from motionlang.cli.program_files import programs
from motionlang.cli.readers import among
from motionlang.commands.check.findings import Found, written
from motionlang.commands.diff.golden import golden_files
from motionlang.commands.profile.budget import within_budget
from motionlang.commands.sweep.worlds import SUFFIX as SWEEP_SUFFIX
from motionlang.commands.verify.further import (
    check_limits,
    check_text,
    compare,
    expectations,
    further_check,
    further_files,
    has_limits,
    ran,
    rewrite_golden,
)
from motionlang.commands.verify.verdict import Verdict
from motionlang.kernel import (
    ProgramError,
    Run,
    dialect_of,
    settings_next_to,
)
from motionlang.kernel.tools import count_of, listed, need
from motionlang.processes.parallel import in_parallel
from motionlang.views.diagnostics import diagnostics_table
from motionlang.views.table import Column, Document, Table

KINDS = ("check", "program", "scenario", "sweep", "certificate")
# The commands whose findings another format names in place of verify.
COMMANDS = {"check": "check", "certificate": "certify"}
NO_ANSWER = """\
--review needs answers, but standard input is at its end. Run it in a terminal, pipe the answers, one per line, or
rewrite all golden files with --update. Those of this program are unchanged.
"""
# Explains the answers to the question of --review.
ANSWERS = """\
y  write the golden files
n  leave the golden files as they are
q  quit, and leave all others as they are, too
"""


class NoAnswer(Exception):
    """Standard input has ended or is missing, so no golden file is written."""


@dataclass
class Verify(Jobs, Findings):
    """Compare programs with their golden files."""

    title: ClassVar[str] = "checks"
    epilog: ClassVar[str] = """\
The golden files of pick.mnt are pick.golden.json, with its report, and
pick.golden.txt, with its output. Without golden files, [[expect]] entries,
scenarios and a sweep are checked; a program with nothing to check is an error.

With --also check,certify one command does what a pipeline needs: the errors and
warnings of each text, the golden files and scenarios, and the certificate of
each machine with limits.

exit status: 0 all pass; 1 something differs, is missing or has an error;
2 the command line is invalid, or --review got no answer

examples:
  motionlang verify programs
  motionlang verify --also check,certify programs --format github
"""
    paths: list[str] = argument(
        "PATH", "programs, or folders of programs; default: this folder", many=True, default=["."]
    )
    also: frozenset[str] = option(
        "WHAT,…",
        "check: report errors and warnings of the text; certify: certify the programs whose machine has limits",
        read=among("check", "certify"),
        default=frozenset(),
    )
    update: bool = flag("rewrite the golden files that differ")
    review: bool = flag("ask whether to rewrite the golden files of each program that differs")

    def check(self) -> None:
        super().check()
        if self.review and (self.update or self.format != "text"):
            raise WrongOption("--review cannot be combined with --update or --format")
        if self.also and (self.review or self.update):
            raise WrongOption("--also cannot be combined with --review or --update, which write golden files")

    def run(self) -> int:
        if "certify" in self.also:
            need("motionlang verify --also certify", "numpy")
        found = programs(self.paths)
        if not found:
            sys.stderr.write(f"no programs in {', '.join(self.paths)}\n")
            return 1
        form, verdicts, quits = self.format, list[Verdict](), False
        for each in in_parallel(partial(_verdicts_of, self.update, self.also), found, self.jobs):
            for verdict in each:
                self._print(verdict)
                if self.review and verdict.is_outdated and not quits:
                    try:
                        answer = _ask(f"{verdict.name}: write its golden files?")
                    except NoAnswer:
                        sys.stderr.write(NO_ANSWER)
                        return 2
                    quits = answer == "q"
                    if answer == "y":
                        verdict = _rewritten(each[0].name, verdict)
                        self._print(verdict)
                verdicts.append(verdict)
        if form == "text" and not self.quiet:
            good = ", ".join(filter(None, (_count(verdicts, kind) for kind in KINDS)))
            what = (
                "pass"
                if self.also or not all(each.has_golden for each in verdicts)
                else "match their golden files"
            )
            what = "have current golden files" if self.update else what
            sys.stdout.write(f"{good} {what}\n")
        elif form in ("json", "csv"):
            self.show(_document(verdicts), "")
        elif form not in ("text", "none"):
            document = [
                Found(each.name, each.findings(), each.source, each.path, command=COMMANDS.get(each.kind, ""))
                for each in verdicts
            ]
            sys.stdout.write(written(document, form, "verify"))
        return 1 if any(each.failed for each in verdicts) else 0

    def _print(self, verdict: Verdict) -> None:
        if self.format in ("text", "json", "csv"):
            complain(verdict.diagnostics, verdict.source, verdict.path)
        if self.format == "text":
            sys.stdout.writelines(f"{line}\n" for line in verdict.lines)


def _ask(question: str) -> str:
    """Ask for "y", "n" or "q" on a terminal or a pipe; "?" explains them.

    Raises `NoAnswer` if neither provides an answer.
    """
    while True:
        sys.stdout.write(f"{question} [y,n,q,?] ")
        sys.stdout.flush()
        try:
            line = sys.stdin.readline() if sys.stdin is not None else ""
        except (OSError, ValueError):
            line = ""
        if not line:
            sys.stdout.write("\n")
            raise NoAnswer
        if not sys.stdin.isatty():
            sys.stdout.write(line if line.endswith("\n") else f"{line}\n")  # what a terminal would show
        answer = line.strip().lower()[:1]
        if answer and answer in "ynq":
            return answer
        sys.stdout.write(ANSWERS)


def _rewritten(program: str, verdict: Verdict) -> Verdict:
    """Rewrite the golden files of a program, a scenario or a sweep; return its verdict."""
    if verdict.kind != "program":
        return further_check(program, verdict.name, True)
    again = Verdict(program)
    result = _update(again)
    if result is not None:
        again.report(expectations(result))
    return again


def _count(verdicts: Sequence[Verdict], kind: str) -> str:
    """Return how many verdicts of a kind passed, as text; "" if there are none."""
    of_kind = [each for each in verdicts if each.kind == kind]
    well = [each for each in of_kind if not each.failed]
    return f"{len(well)} of {len(of_kind)} {kind}s" if of_kind else ""


def _document(verdicts: Sequence[Verdict]) -> Document:
    columns = (
        Column("file", get=lambda verdict: verdict.name),
        Column("kind"),
        Column("matches_golden", get=lambda verdict: not verdict.failed),
    )
    findings = ((verdict.name, each) for verdict in verdicts for each in verdict.findings())
    return Document([Table("verdicts", columns, verdicts), diagnostics_table(findings)])


def _verdicts_of(rewrite: bool, also: Collection[str], program: str) -> list[Verdict]:
    """Return the verdicts of a program, its scenarios and its sweep.

    `also` may have "check" and "certify". A text with errors is not run.
    """
    verdict, found = Verdict(program), list[Verdict]()
    if _is_readable(verdict):
        found = [check_text(program)] if "check" in also else []
        if any(each.failed for each in found):
            verdict.fail("not run, since its text or its machine file has errors")
            return [*found, verdict]
        if rewrite:
            _update(verdict)
        else:
            _verify(verdict, also)
    found += [verdict, *(further_check(program, path, rewrite) for path in further_files(program))]
    return [*found, check_limits(program)] if "certify" in also and has_limits(program) else found


def _verify(verdict: Verdict, also: Collection[str]) -> None:
    report, _ = golden_files(verdict.name)
    is_golden = os.path.exists(report)
    result = _ran(verdict) if is_golden or _expects(verdict.name) else None
    if not is_golden:
        missing = f"no {os.path.basename(report)} next to it"
        checked = ["its text"] * ("check" in also) + ["its [[expect]] entries"] * (result is not None)
        further = further_files(verdict.name)
        scenarios = [each for each in further if not each.endswith(SWEEP_SUFFIX)]
        checked += [count_of(len(scenarios), "scenario")] * bool(scenarios)
        checked += ["a sweep"] * (len(further) > len(scenarios))
        checked += ["its limits"] * ("certify" in also and has_limits(verdict.name))
        verdict.has_golden = not checked
        if checked:
            are = "is" if checked in (["its text"], ["1 scenario"], ["a sweep"]) else "are"
            verdict.lines.append(f"{verdict.name}: {missing}; only {listed(checked)} {are} checked")
        elif not verdict.failed:
            verdict.is_outdated = True
            verdict.fail(f"{missing}; --update writes one")
        if result is not None:
            verdict.report(expectations(result))
        return
    if result is None:
        return
    with verdict.reading():
        compare(verdict, result, expectations(result))
        if verdict.failed and result.diagnostics:  # for example of a program that no longer compiles
            verdict.diagnostics, verdict.source = result.diagnostics, result.source


def _expects(program: str) -> bool:
    """True if the machine file of a program has [[expect]] entries, or cannot be read, which the run reports."""
    try:
        return bool(settings_next_to(program).get("expect"))
    except (OSError, ProgramError):
        return True


def _update(verdict: Verdict) -> Run | None:
    result = _ran(verdict)
    if result is not None:
        rewrite_golden(verdict, result)
    return result


def _ran(verdict: Verdict) -> Run | None:
    """Return the run of a program within the budget of its machine file; None if it cannot be read."""
    result = ran(verdict)
    return None if result is None else within_budget(result)


def _is_readable(verdict: Verdict) -> bool:
    program = verdict.name
    if not os.path.exists(program):
        verdict.refuse([unreadable(program, FileNotFoundError(2, "no such file or directory"))])
    elif dialect_of(program) is None:
        verdict.refuse([no_dialect(program)])
    return not verdict.failed
