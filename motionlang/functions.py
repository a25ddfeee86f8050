"""The functions for other Python programs: `motionlang.run`, `check` and others.

Each function only checks its arguments and calls the layer that does the work, which is imported on use.
"""

from __future__ import annotations

import os
from collections.abc import Callable, Mapping
from typing import TYPE_CHECKING, Any, Literal, cast, overload

from motionlang.extras import brought
from motionlang.kernel import (
    DEFAULT_AXES,
    Diagnostic,
    ProgramError,
    Run,
    Source,
    checked_settings,
    dialect_for,
    missing_axes,
    settings_next_to,
    unknown_model,
)
from motionlang.kernel import run as run_program
from motionlang.kernel.lang import Given, one_sentence

if TYPE_CHECKING:
    from motionlang.commands.certify import CertifiedLimit
    from motionlang.commands.compare.comparison import Comparison
    from motionlang.commands.diff.runs import RunsCompared
    from motionlang.commands.profile.profile import TimeProfile

Program = str | os.PathLike[str] | Source

Settings = Mapping[str, object] | str | os.PathLike[str]


def run(
    program: Program,
    *,
    dialect: str | None = None,
    machine: Settings | None = None,
    until: float | None = None,
    overrides: Mapping[str, float | str] | None = None,
    inputs: Given = (),
    analog: Given = (),
    answers: Given = (),
    keys: Given = (),
    show: Callable[[str], object] | None = None,
    nv: str | None = None,
) -> Run:
    """Run a program on the virtual controller and return its `Run`.

    `program` is a path, or a `Source` with its text. `dialect` is "mint" or "mccl"; without it the file extension
    decides. `machine` is the path of a machine file, or has settings by its dotted keys, such as
    {"controller.axes": 2}; without it the machine file next to the program counts. `until` is the machine
    time in seconds at which the run ends at the latest, by default the file's `run.until` or 8 hours,
    or for a program that never ends ten cycles and at least 60 s.
    `overrides` has values for constants and variables of the program. `inputs`, `analog`, `answers` and `keys` are
    events of the simulated world, in the form of `--input` and the other options: {2: "1@0.5"}. `show` is called with
    each text that the program prints. `nv` is a file that stores nonvolatile data between runs.

    Errors in the program are in `Run.diagnostics` and never raised. Raises OSError if the file cannot be read,
    ProgramError if the machine file is wrong, and ValueError, with the choices, for a wrong argument.
    """
    if until is not None and not until >= 0.0:
        raise ValueError(f"until must be a number of 0 or more, not {until!r}")
    made = run_program(
        _checked(program),
        dialect=dialect,
        machine=machine,
        until=until,
        overrides=overrides,
        inputs=inputs,
        analog=analog,
        answers=answers,
        keys=keys,
        show=show,
        nv=nv,
    )
    if any(key.startswith("budget.") for key in made.machine.settings):
        from motionlang.commands.profile.budget import within_budget

        within_budget(made)
    return made


def check(
    program: Program,
    *,
    dialect: str | None = None,
    machine: Settings | None = None,
    model: str | None = None,
) -> list[Diagnostic]:
    """Return all errors and warnings of a program, in order of line; nothing is run.

    `dialect` and `machine` are those of `run`. `model` is the controller that the program is for, such as
    "mintmt". A diagnostic has `code`, `message`, `line`, `hint` and `severity`, "error" or "warning". Raises
    OSError if the file cannot be read, ProgramError if the machine file is wrong, and ValueError, with the
    choices, for an unknown model or language.
    """
    from motionlang.commands.check import check as check_program

    program = _checked(program)
    source = program if isinstance(program, Source) else Source.read(program)
    language = dialect_for(source, dialect)
    problem = None if model is None else unknown_model(model, language)
    if problem is not None:
        raise ValueError("; ".join(problem))
    settings = settings_next_to(program) if machine is None else checked_settings(machine)
    axes: int = settings.get("controller.axes", DEFAULT_AXES)  # type: ignore[assignment]
    wrong = missing_axes(settings, axes, language.first_axis)
    if wrong:
        raise ProgramError(wrong)
    if model is not None:
        settings["controller.model"] = model
    return one_sentence(language, source, check_program(language.program(source, settings)))


def profile(program: Program | Run) -> TimeProfile:
    """Return how the time of a run is spent, along the critical path.

    The time is split by line, sub, cause and axis. `program` is a `Run`, or a program to run first. All times are
    seconds. Raises ProgramError for a program with errors, and the errors of `run`.
    """
    from motionlang.commands.profile.profile import TimeProfile

    return TimeProfile(_run_of(program))


def source_of(program: Program) -> Source:
    """Return the text of a program."""
    return program if isinstance(program, Source) else Source.read(os.fspath(program))


@overload
def diff(
    old: Program | Run, new: Program | Run, *tolerances: str, explore: Literal[False] = False
) -> RunsCompared: ...
@overload
def diff(old: Program, new: Program, *, explore: Literal[True]) -> Any: ...
def diff(
    old: Program | Run, new: Program | Run, *tolerances: str, explore: bool = False
) -> RunsCompared | Any:
    """Return the difference between what the tasks of two runs do.

    Each side is a `Run`, or a program to run first. The result has `same`, `differences`, `later` for what comes at
    another time, `charges` for the lines that take it, and `apart` for the largest difference of a position.
    `tolerances` are texts such as "time=1ms", "position=0.01uu" or "speed=2%". With `explore` two programs are compared
    in all ways that an exploration of either finds: the result also has `cycles`, and `left`, the ways that were not
    compared; that needs motionlang-explore, and raises ImportError without it. Raises ValueError for a wrong tolerance,
    ProgramError for a program with errors, and the errors of `run`.
    """
    if explore:
        if tolerances or not all(isinstance(side, str | os.PathLike | Source) for side in (old, new)):
            raise ValueError("explore=True needs two programs, and no tolerances")
        ways_of = cast("Callable[..., Any]", brought("ways_of", "diff with explore=True"))
        return ways_of(*(source_of(side) for side in (old, new)))  # type: ignore[arg-type]
    from motionlang.commands.diff.runs import compared_runs
    from motionlang.comparison.tolerance import Tolerance

    return compared_runs(_run_of(old), _run_of(new), Tolerance(*tolerances))


def compare(
    program: Program | Run,
    recording: Program,
    mapping: Mapping[str, str] | None = None,
    *,
    tolerances: Mapping[str, float] | None = None,
    delay: float | None = None,
) -> Comparison:
    """Compare a recording of a real controller with a run.

    The result has residuals, lag and overshoot, move by move. `program` is a `Run`, or a program to run first;
    `recording` is the path of a text file with a table. `mapping` gives columns a meaning: {"time": "t*0.001",
    "position.0": "PosAct"}; a factor converts their numbers to seconds or user units (uu). `tolerances` are the
    largest residuals allowed, uu, by "position" or "position.0". `delay` is the delay of the recording relative to the
    run, in seconds; without it the delay is determined from the data. Raises ProgramError for a program with errors, or
    if there is nothing to compare, ValueError for a wrong mapping, OSError if a file cannot be read, and the errors of
    `run`.
    """
    from motionlang.commands.compare.baseline import baseline_of, read_compared
    from motionlang.commands.compare.comparison import compare
    from motionlang.commands.recording import mapped, read_file, table_of

    made = [mapped(f"{target}={column}") for target, column in (mapping or {}).items()]
    baseline = baseline_of(_run_of(program))
    table = table_of(recording) if isinstance(recording, Source) else read_file(os.fspath(recording))
    return compare(baseline, read_compared(table, made, baseline), tolerances=tolerances, delay=delay)


def certify(program: Program | Run) -> list[CertifiedLimit]:
    """Return how far a run used each limit of its machine file.

    The result has an entry for each limit of each axis. `program` is a `Run`, or a program to run first. An entry has
    `reached`, `time` (s), `line`, `margin` and `verdict`: "within", "exceeded" or "unknown". An axis without limits has
    no entry. The motion is verified, too: `Run.diagnostics` gets its violations. Raises ValueError if the machine
    file has no limits, ProgramError for a program with errors, and the errors of `run`.
    """
    from motionlang.commands.certify import LIMITS, certificate
    from motionlang.commands.certify.motion import verify_motion

    result = _run_of(program)
    lines = certificate(result.controller, result.machine.settings, result.time)
    if not lines:
        raise ValueError(f"the machine has no limits: axis.N.limits with {', '.join(LIMITS)}")
    known = {each.message for each in result.diagnostics}
    found = verify_motion(result.controller, lines, result.time).violations
    result.diagnostics += [each for each in found if each.message not in known]
    return lines


def _run_of(program: Program | Run) -> Run:
    """Return a run, or that of a program; ProgramError if the program has errors, so that there is nothing to run."""
    if isinstance(program, Run):
        return program
    result = run(program)
    errors = [each for each in result.diagnostics if each.severity == "error"]
    if result.program is None and errors:
        raise ProgramError(errors)
    return result


def _checked(program: Program) -> Program:
    """Return a program; ValueError for program text, which must be in a `Source`."""
    if isinstance(program, str) and "\n" in program:
        raise ValueError('this is the text of a program: pass Source("name.mnt", text), or a path')
    return program
