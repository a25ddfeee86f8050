"""Further checks of `motionlang verify`: the text, expectations, scenarios, sweep, limits."""

from __future__ import annotations

import csv
import io
import json
import os

from motionlang.cli.complaints import unwritten
from motionlang.cli.crash import crash
from motionlang.cli.signals import SIGNALS
from motionlang.commands.certify.command import certify
from motionlang.commands.check.command import findings_of
from motionlang.commands.diff.golden import differences, golden_files, same, update
from motionlang.commands.scenarios import Scenario, scenario_files, unmet
from motionlang.commands.sweep import Sweep
from motionlang.commands.sweep.variants import Variants
from motionlang.commands.sweep.worlds import SUFFIX as SWEEP_SUFFIX
from motionlang.commands.verify.verdict import Verdict
from motionlang.kernel import ProgramError, Run, machine_of, run, settings_next_to
from motionlang.kernel.files import replacing


def further_files(program: str) -> list[str]:
    """Return the files that are verified with a program: its scenarios and its sweep."""
    sweep = os.path.splitext(program)[0] + SWEEP_SUFFIX
    return [*scenario_files(program), *([sweep] if os.path.isfile(sweep) else ())]


def further_check(program: str, path: str, rewrite: bool) -> Verdict:
    """Check, or rewrite, a scenario or the sweep of a program; it fails if a file is unreadable or invalid."""
    is_sweep = path.endswith(SWEEP_SUFFIX)
    verdict = Verdict(path, "sweep" if is_sweep else "scenario")
    try:
        with verdict.reading():
            (_sweep if is_sweep else _scenario)(program, verdict, rewrite)
    except ValueError as error:
        verdict.fail(str(error))
    return verdict


def compare(verdict: Verdict, result: Run, found: list[str]) -> None:
    """Report what was `found` and how a run differs from its golden files; an OSError names the file."""
    try:
        changes = differences(verdict.name, result)
    except ValueError as error:
        what = "is not JSON" if isinstance(error, json.JSONDecodeError) else "cannot be compared"
        verdict.is_outdated = True
        verdict.fail(f"{os.path.basename(golden_files(verdict.name)[0])} {what}: {error}")
    else:
        verdict.is_outdated = bool(changes)
        verdict.report(found + changes)


def rewrite_golden(verdict: Verdict, result: Run) -> None:
    """Rewrite the golden files if the run differs from them."""
    try:
        if update(verdict.name, result):
            verdict.lines.append(f"{verdict.name}: written")
    except OSError as error:
        verdict.refuse([unwritten(str(error.filename), error)])


def check_text(program: str) -> Verdict:
    """Check the text of a program, as `motionlang check` does; warnings are no failure."""
    found = findings_of(program)
    verdict = Verdict(program, "check")
    verdict.refuse(list(found.diagnostics), found.source, found.path)
    verdict.failed = found.is_wrong
    return verdict


def check_limits(program: str) -> Verdict:
    """Certify the limits of a program's machine, as `motionlang certify` does."""
    verdict = Verdict(program, "certificate")
    result = ran(verdict)
    if result is not None:
        certify(result, machine_of(program))
        errors = [each for each in result.diagnostics if each.severity == "error"]
        if errors:
            verdict.refuse(errors, result.source)
    return verdict


def has_limits(program: str) -> bool:
    """True if the machine file of a program has limits; False if it cannot be read, which the run reports."""
    try:
        return any(".limits." in key for key in settings_next_to(program))
    except (OSError, ProgramError):
        return False


def ran(verdict: Verdict) -> Run | None:
    """Return the run of a program; None if it or its machine file cannot be read."""
    try:
        with verdict.reading():
            result = run(verdict.name)
            SIGNALS.end_with(result)
            return result
    except Exception as error:  # an internal error must not skip the programs after it
        verdict.refuse([crash(error, (verdict.name,))])
    return None


def expectations(result: Run) -> list[str]:
    """Return the machine file's expectations that a run does not meet."""
    expected = result.machine.settings.get("expect", [])
    return unmet(result, expected) if expected else []  # type: ignore[arg-type]


def _scenario(program: str, verdict: Verdict, rewrite: bool) -> None:
    """Check a scenario against its expectations and its golden files, if any."""
    path = verdict.name
    scenario = Scenario(program, path)
    result = scenario.run()
    SIGNALS.end_with(result)
    found = unmet(result, scenario.expected)
    if rewrite:
        rewrite_golden(verdict, result)
    elif os.path.exists(golden_files(path)[0]):
        compare(verdict, result, found)
        return
    elif not scenario.expected:
        verdict.is_outdated = True
        found.append(
            "it has neither [[expect]] entries nor a golden file; add [[expect]] or run with --update"
        )
    verdict.report(found)


def _sweep(program: str, verdict: Verdict, rewrite: bool) -> None:
    """Check the rows of a sweep against its golden file."""
    path = verdict.name
    variants = Variants.of_file(path)
    worlds = variants.worlds()
    sweep = Sweep(
        program,
        variants.space(worlds),
        keep=variants.keep,
        worlds=worlds,
        until=variants.until,
        certify=variants.certify,
        allow=variants.allow,
    )
    names = ["variant", *sweep.space.names, *sweep.job.keep, "problem"]
    rows = [
        [str(cell) for cell in (index, *sweep.space[index], *results, problem["message"] if problem else "")]
        for index, results, problem in sorted(sweep.results(), key=lambda row: row[0])
    ]
    golden = sweep_golden(path)
    if rewrite:
        _write(verdict, golden, names, rows)
        return
    if not os.path.exists(golden):
        verdict.is_outdated = True
        verdict.report([f"no {os.path.basename(golden)} next to it; --update writes one"])
        return
    with open(golden, encoding="utf-8", newline="") as file:
        expected = list(csv.reader(file))
    found = [] if expected[:1] == [names] else [f"its columns are {', '.join(names)}"]
    if len(expected) - 1 != len(rows):
        found.append(f"it has {len(rows)} variants instead of {len(expected) - 1}")
    for old, new in zip(expected[1:], rows, strict=False):
        for name, was, is_ in zip(names, old, new, strict=False):
            if not _same(was, is_):
                found.append(f"variant {new[0]}: {name} is {is_} instead of {was}")
    verdict.is_outdated = bool(found)
    verdict.report(found)


def _same(was: str, found: str) -> bool:
    try:
        return same(float(was), float(found))
    except ValueError:
        return was == found


def sweep_golden(path: str) -> str:
    """Return the path of the golden file of a sweep's rows."""
    return path.removesuffix(".toml") + ".golden.csv"


def _write(verdict: Verdict, golden: str, names: list[str], rows: list[list[str]]) -> None:
    text = io.StringIO()
    csv.writer(text, lineterminator="\n").writerows([names, *rows])
    try:
        if os.path.exists(golden):
            with open(golden, encoding="utf-8", newline="") as file:
                if file.read() == text.getvalue():
                    return
        with replacing(golden, only_copy=True) as out:
            out.write(text.getvalue().encode())
    except OSError as error:
        verdict.refuse([unwritten(str(error.filename), error)])
        return
    verdict.lines.append(f"{golden}: written")
