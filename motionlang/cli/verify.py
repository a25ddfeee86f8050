"""`motionlang verify`: run programs and compare them with their golden files."""

from __future__ import annotations

import argparse
import json
import os
import sys
from collections.abc import Sequence
from functools import partial

from motionlang.analysis.scenarios import Scenario, unmet
from motionlang.cli.complaints import complain, no_dialect, unreadable, unwritten
from motionlang.cli.crash import crash
from motionlang.cli.findings_options import add_form
from motionlang.cli.golden import differences, golden_files, update
from motionlang.cli.parallel import add_jobs, in_parallel
from motionlang.cli.parser import Commands, add_all, add_command, arrange, flag, option
from motionlang.cli.program_files import programs
from motionlang.cli.review import NoAnswer, Quit, ask, review
from motionlang.cli.signals import SIGNALS
from motionlang.cli.verdict import Verdict
from motionlang.cli.verify_further import expectations, further_checks
from motionlang.cli.verify_log import verify_log
from motionlang.errors import ProgramError
from motionlang.execution import dialect_of, machine_of, run
from motionlang.result import Run
from motionlang.source import Source
from motionlang.views.findings import Found, written

SCHEMA = "motionlang.verify/2"
KINDS = ("program", "scenario", "sweep", "log")
LOG_SUFFIX = ".mcapi-log"
GROUPS = {"checks": "update review", "report": "format quiet output jobs"}
NO_ANSWER = """\
--review needs answers, but standard input is at its end. Run it in a terminal, pipe the answers, one per line, or
accept all changes with --update. The golden files of this program are unchanged.
"""


_OPTIONS = (
    option("paths", "PATH", "programs, or folders of programs; default: this folder; the golden files of pick.mnt are "
           "pick.golden.json, with its report, and pick.golden.txt, with its output; a log of calls, host.mcapi-log, "
           "must replay without a difference", nargs="*", default=["."]),
    flag("--update", "rewrite the golden files that differ"),
    flag("--review", "ask whether to accept each change"),
)  # fmt: skip


def add_parser(commands: Commands, summary: str) -> None:
    """Add `motionlang verify` and its options."""
    parser = add_command(commands, "verify", summary, _verify_all)
    add_all(parser, _OPTIONS)
    add_form(parser, "print only what differs")
    add_jobs(parser)
    arrange(parser, GROUPS)


def _verify_all(arguments: argparse.Namespace) -> int:
    if arguments.review and (arguments.update or arguments.format != "text"):
        arguments.parser.error("--review cannot be combined with --update or --format")
    return verify_command(
        arguments.paths,
        arguments.update,
        arguments.format,
        arguments.jobs,
        arguments.review,
        quiet=arguments.quiet,
    )


def verify_command(
    paths: Sequence[str],
    rewrite: bool,
    form: str = "text",
    jobs: int = 0,
    asks: bool = False,
    *,
    quiet: bool = False,
) -> int:
    """Verify programs, or rewrite their golden files; 1 on a difference or an error.

    A missing golden file is an error. `quiet` omits the count at the end.
    """
    found = programs(paths, LOG_SUFFIX)
    if not found:
        sys.stderr.write(f"no programs in {', '.join(paths)}\n")
        return 1
    verdicts: list[Verdict] = []
    quits = False
    for each in in_parallel(partial(_verdicts_of, rewrite), found, jobs):
        for verdict in each:
            verdicts.append(verdict)
            if form in ("text", "json"):
                complain(verdict.diagnostics, verdict.source, verdict.path)
            if form == "text":
                sys.stdout.writelines(f"{line}\n" for line in verdict.lines)
            if asks and verdict.failed and verdict.lines and not quits:
                try:
                    _review(each[0].name, verdict)
                except Quit:
                    quits = True
                except NoAnswer:
                    sys.stderr.write(NO_ANSWER)
                    return 2
    if form == "text" and not quiet:
        good = ", ".join(filter(None, (_count(verdicts, kind) for kind in KINDS)))
        sys.stdout.write(f"{good} {'have current golden files' if rewrite else 'match their golden files'}\n")
    elif form == "json":
        sys.stdout.write(
            json.dumps({"schema": SCHEMA, "programs": list(map(_row, verdicts))}, indent=1) + "\n"
        )
    elif form != "text":
        document = [Found(each.name, each.findings(), each.source, each.path) for each in verdicts]
        sys.stdout.write(written(document, form, "verify"))
    return 1 if any(each.failed for each in verdicts) else 0


def _review(program: str, verdict: Verdict) -> None:
    """Ask about each change; failures unrelated to golden files remain."""
    sys.stdout.flush()
    try:
        if verdict.kind == "sweep":
            _review_rows(program, verdict)
        elif verdict.kind == "log":
            sys.stderr.write(
                f"{verdict.name}: a log is recorded, not accepted: motionlang mcapi run --record\n"
            )
        elif verdict.kind == "program":
            result = run(program)
            SIGNALS.end_with(result)
            matches = review(program, result)
            verdict.failed = not matches or bool(expectations(result))
        elif os.path.exists(golden_files(verdict.name)[0]):
            scenario = Scenario(program, verdict.name)
            result = scenario.run()
            SIGNALS.end_with(result)
            matches = review(verdict.name, result)
            verdict.failed = not matches or bool(unmet(result, scenario.expected))
    except (OSError, ValueError, ProgramError) as error:
        sys.stderr.write(f"{verdict.name}: nothing written: {error}\n")


def _review_rows(program: str, verdict: Verdict) -> None:
    answer = ask(f"{verdict.name}: accept these rows?", "ynq")
    if answer == "q":
        raise Quit
    if answer == "y":
        (again,) = further_checks(program, True, verdict.name)
        verdict.failed = again.failed
        complain(again.diagnostics, again.source, again.path)


def _count(verdicts: Sequence[Verdict], kind: str) -> str:
    """Return how many verdicts of a kind passed, as text; "" if there are none."""
    of_kind = [each for each in verdicts if each.kind == kind]
    well = [each for each in of_kind if not each.failed]
    return f"{len(well)} of {len(of_kind)} {kind}s" if of_kind else ""


def _row(verdict: Verdict) -> dict[str, object]:
    found = [each.as_dict() for each in verdict.findings()]
    return {verdict.kind: verdict.name, "matches_golden": not verdict.failed, "diagnostics": found}


def _verdicts_of(rewrite: bool, program: str) -> list[Verdict]:
    """Return the verdicts of a program, its scenarios and its sweep, or that of a log."""
    if program.endswith(LOG_SUFFIX):
        return [verify_log(program)]
    verdict = Verdict(program)
    if _is_readable(verdict):
        (_update if rewrite else _verify)(verdict)
    return [verdict, *further_checks(program, rewrite)]


def _verify(verdict: Verdict) -> None:
    report, _ = golden_files(verdict.name)
    if not os.path.exists(report):
        verdict.fail(f"no {os.path.basename(report)} next to it; --update writes one")
        return
    result = _ran(verdict)
    if result is None:
        return
    try:
        found = differences(verdict.name, result)
    except OSError as error:
        verdict.refuse([unreadable(str(error.filename), error)])
    except ValueError as error:
        what = "is not JSON" if isinstance(error, json.JSONDecodeError) else "cannot be compared with"
        verdict.fail(f"{os.path.basename(report)} {what}: {error}")
    else:
        verdict.report(expectations(result) + found)
        if verdict.failed and result.diagnostics:  # for example of a program that no longer compiles
            verdict.diagnostics, verdict.source = result.diagnostics, result.source


def _update(verdict: Verdict) -> None:
    result = _ran(verdict)
    if result is None:
        return
    try:
        if update(verdict.name, result):
            verdict.lines.append(f"{verdict.name}: written")
    except OSError as error:
        verdict.refuse([unwritten(str(error.filename), error)])


def _ran(verdict: Verdict) -> Run | None:
    """Return the run of a program; None if it or its machine file cannot be read."""
    program = verdict.name
    try:
        result = run(program)
    except OSError as error:
        verdict.refuse([unreadable(str(error.filename or program), error)])
    except ProgramError as error:
        machine = machine_of(program)
        verdict.refuse(error.diagnostics, Source.read(machine) if machine else None, machine or "")
    except Exception as error:  # an internal error must not skip the programs after it
        verdict.refuse([crash(error, (program,))])
    else:
        SIGNALS.end_with(result)
        return result
    return None


def _is_readable(verdict: Verdict) -> bool:
    program = verdict.name
    if not os.path.exists(program):
        verdict.refuse([unreadable(program, FileNotFoundError(2, "no such file or directory"))])
    elif dialect_of(program) is None:
        verdict.refuse([no_dialect(program)])
    return not verdict.failed
