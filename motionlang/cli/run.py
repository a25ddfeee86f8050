"""`motionlang run`: run a program file; write report, trace and picture."""

from __future__ import annotations

import sys

from motionlang.cli.input_files import read_machine_file, read_source
from motionlang.cli.signals import SIGNALS, status_of
from motionlang.errors import Diagnostic, ProgramError, Terminated
from motionlang.execution import Checked, dialect_of, language_of, machine_of, run
from motionlang.source import STDIN, Source

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable, Sequence

    from motionlang.analysis.proof.checker import Proof
    from motionlang.cli.options import Options
    from motionlang.lang.machine.machine import Machine
    from motionlang.lang.scheduler import Outside
    from motionlang.result import Run

# The exit status after an internal error, as in sysexits, and without a library that the package depends on.
CRASHED = 70
UNAVAILABLE = 69
# Profiles of an interrupted run up to which it is still proved: a report comes within a second of the signal.
PROVED_IN_TIME = 10_000


def run_command(options: Options) -> int:
    """Run a program, show its results, and return the exit status.

    There is exactly one complete report, however the run ends: a signal during its output waits until it is
    written.
    """
    is_reported = False
    try:
        SIGNALS.deliver()
        result = _result(options)
        if isinstance(result, int):
            return result
        with SIGNALS.deferred:
            status = _report_outcome(result, options)
            is_reported = True
        return _write_files(result, options) or status
    except (KeyboardInterrupt, Terminated) as error:
        if is_reported:
            raise
        from motionlang.result import who_ended

        SIGNALS.defer()
        ended = [Diagnostic("interrupted", f"the run was ended {who_ended(error)}")]
        return _refuse(options, ended, None, status_of(error), "interrupted")
    except (OSError, ProgramError):
        raise
    except Exception as error:
        if is_reported:
            raise
        found = _crash(error, options)
        return _refuse(options, [found], None, UNAVAILABLE if found.code == "extra" else CRASHED)


def _crash(error: Exception, options: Options, source: Source | None = None) -> Diagnostic:
    from motionlang.cli.crash import crash

    return crash(error, options.given, source)


def _result(options: Options) -> Run | int:
    """Return the run, or the exit status if it failed, which has been reported."""
    try:
        source = read_source(options.file)
    except OSError as error:
        from motionlang.cli.complaints import unreadable

        return _refuse(options, [unreadable(options.file, error)], None, 1)
    language = language_of(options.dialect, options.file)
    if language is None:
        from motionlang.cli.complaints import no_dialect

        return _refuse(options, [no_dialect(options.file)], None, 2)
    settings = Checked(options.settings)  # those of `--set` were checked with the command line
    options.machine = machine_of(options.file, options.machine)
    if options.machine is not None:
        status = read_machine_file(options, settings)
        if status:
            return status
    if options.world:
        from motionlang.lang.machine.entries import WrongEntry, check_inputs_are_read, entries, with_entries

        try:
            check_inputs_are_read(source, language, settings, entries(settings, **options.world))
            settings = Checked(with_entries(settings, **options.world))
        except WrongEntry as error:
            return _refuse(options, [Diagnostic("option", error.message, hint=error.hint)], None, 2)
    missing = _missing_axes(options, settings) if settings else []
    if missing:
        return _refuse(options, missing, Source(options.machine, "") if options.machine else None, 1)
    if options.show_tree:
        from motionlang.cli.show_tree import show_tree

        return show_tree(options, source)
    if options.realtime is not None and options.file != STDIN and sys.stdin.isatty():
        from motionlang.cli.keyboard import run_live

        return run_live(lambda keyboard: _run(options, source, settings, keyboard), options.realtime)
    return _run(options, source, settings)


def _report_outcome(result: Run, options: Options) -> int:
    """Print report and complaints, and return the exit status."""
    if isinstance(result.crash, OSError):  # of the program's output, which `main` handles
        raise result.crash
    if result.crash is not None:
        result.diagnostics.append(
            _crash(result.crash, options, result.source if options.file == STDIN else None)
        )
    if options.keep:
        from motionlang.analysis.quantities import values_of

        result.quantities = values_of(result, options.keep)
    proof = _proof(result)
    if proof is not None:
        result.diagnostics += proof.violations
    if options.certify and proof is not None:
        from motionlang.cli.certify import certify

        result.certificate = certify(result, options.machine)
    _report(result, options)
    if proof is not None and options.report != "json":
        sys.stdout.write("\n" if options.report == "table" else "")
        if result.certificate and options.report == "table":
            from motionlang.cli.certify import print_certificate

            print_certificate(result, result.certificate, proof, options.machine)
        else:
            sys.stdout.write("\n".join(proof.lines()) + "\n")
    if result.diagnostics:
        from motionlang.cli.complaints import complain

        warned = result.machine.warned
        left = [each for each in result.diagnostics if not any(each is other for other in warned)]
        complain(left, result.source, options.file)
        if any(each.code == "never" and "the machine file" in each.hint for each in left):
            _point_to_init(options)
    sys.stdout.flush()
    if result.crash is not None:
        return UNAVAILABLE if result.diagnostics[-1].code == "extra" else CRASHED
    if result.status == "interrupted":
        return SIGNALS.status
    met = _complain_of_events(result, options) if result.machine.log.events else False
    wrong = result.status == "fault" or any(each.severity == "error" for each in result.diagnostics)
    return 1 if wrong or met else 0


def _proof(result: Run) -> Proof | None:
    """Return the proof of a run, if requested and possible.

    A run that has crashed, or was interrupted after long motion, has no proof.
    """
    if result.expected_motion is None or result.crash is not None:
        return None
    profiles = sum(len(axis.profiles) for axis in result.controller.axes.values())
    if result.status == "interrupted" and profiles > PROVED_IN_TIME:
        message = f"the run was not verified: it ended after {profiles} profiles of motion"
        hint = (
            f"at most {PROVED_IN_TIME} are verified after a signal; a run that --until ends is always "
            "verified"
        )
        result.diagnostics.append(Diagnostic("proof", message, hint=hint))
        return None
    return result.proof()


def _point_to_init(options: Options) -> None:
    """Name `init` after a run whose machine nothing describes."""
    if options.machine is None and not options.settings and not options.world and options.file != STDIN:
        sys.stderr.write(f"note: motionlang init {options.file} writes a first machine file\n")


def _complain_of_events(result: Run, options: Options) -> bool:
    """Report limits, following errors and faults that make the exit status 1.

    Returns True if there are any.
    """
    from motionlang.cli.event_status import complaints
    from motionlang.views.terminal import printable

    found = complaints(result, options.allow)
    for each in found:
        sys.stderr.write(f"{printable(each)}\n")
    return bool(found)


def _refuse(
    options: Options,
    diagnostics: Sequence[Diagnostic],
    source: Source | None,
    status: int,
    outcome: str = "fault",
) -> int:
    from motionlang.cli.complaints import refuse

    return refuse(options, diagnostics, source, status, outcome)


def _missing_axes(options: Options, settings: dict[str, object]) -> list[Diagnostic]:
    from motionlang.lang.machine.axes import missing_axes
    from motionlang.lang.machine.machine import DEFAULT_AXES

    language = language_of(options.dialect, options.file)
    assert language is not None
    axes: int = settings.get("controller.axes", DEFAULT_AXES)  # type: ignore[assignment]
    return missing_axes(settings, axes, language.first_axis)


def _run(
    options: Options, source: Source, settings: dict[str, object], outside: Outside | None = None
) -> Run:
    def warn(diagnostic: Diagnostic) -> None:
        from motionlang.cli.complaints import complain

        complain([diagnostic], source, options.file)

    if sys.stderr.isatty():
        from motionlang.cli.run_progress import watched

        return watched(
            lambda show, begun: _run_unwatched(options, source, settings, outside, show, begun), warn
        )
    from motionlang.views.terminal import shower

    def begun(machine: Machine) -> None:
        machine.warn = warn

    return _run_unwatched(options, source, settings, outside, shower(sys.stdout), begun)


def _run_unwatched(
    options: Options,
    source: Source,
    settings: dict[str, object],
    outside: Outside | None,
    show: Callable[[str], object],
    begun: Callable[[Machine], None],
) -> Run:
    def prepare(machine: Machine) -> None:
        begun(machine)
        if outside is None and options.file != STDIN:
            machine.ask = lambda: _ask(machine)

    is_endless = options.until is None and "run.until" not in settings
    with SIGNALS.limited(options.cpu if is_endless else 0.0):
        return run(
            source,
            dialect=options.dialect or dialect_of(options.file),
            machine=settings,
            until=options.until,
            overrides=options.overrides,
            show=None if options.report == "json" else show,
            pace=None if options.realtime is None else pacer(options.realtime),
            outside=outside,
            begun=prepare,
            nv=options.nv,
            keep_crash=True,
            prove=options.prove,
            log_size=options.log_size,
        )


def _ask(machine: Machine) -> str | None:
    """Ask the user for the line of an INPUT without an answer; None if there is none."""
    from motionlang.views.questions import ask

    return ask(machine)


def pacer(factor: float) -> Callable[[float], None]:
    """Return a function that waits until a machine time at `factor` × real time.

    It flushes the output, even if the program is too slow for a wait.
    """
    from time import monotonic, sleep

    began = monotonic()

    def pace(time: float) -> None:
        sys.stdout.flush()
        ahead = time / factor - (monotonic() - began)
        if ahead > 0.0:
            sleep(ahead)

    return pace


def _report(result: Run, options: Options) -> None:
    if options.report == "json" and options.profile:
        from motionlang.analysis.cycle.export import json_pieces
        from motionlang.analysis.cycle.profile import TimeProfile

        sys.stdout.writelines(json_pieces(TimeProfile(result).report()))
        return
    if options.report == "json":
        from motionlang.report import pieces

        sys.stdout.writelines(pieces(result))
        return
    began = result.status != "fault" or result.time or result.controller.log.moves
    if options.report == "none" or not began:
        return
    from motionlang.views.table import render
    from motionlang.views.terminal import draws, is_terminal, plain, table_width, wants_colour

    seen, drawn = is_terminal(sys.stdout), draws(sys.stdout)
    width = table_width(sys.stdout)
    table = render(
        result,
        width=width,
        colour=wants_colour(sys.stdout),
        charts=seen and drawn,
        everything=options.everything,
    )
    if options.paths:
        from motionlang.log.paths import paths
        from motionlang.views.paths import render_paths

        rows = paths(result.trace)
        colour = wants_colour(sys.stdout)
        table += "\n" + render_paths(rows, width=width, colour=colour, everything=options.everything)
    if options.profile:
        from motionlang.analysis.cycle.profile import TimeProfile
        from motionlang.views.cycle import render_profile

        colour = wants_colour(sys.stdout)
        made = TimeProfile(result)
        table += "\n" + render_profile(made, width=width, colour=colour, everything=options.everything)
    if options.everything:
        table += _assumptions_of(result, options)
    if result.machine.log.prints:
        table = "\n" + table
    sys.stdout.write(table if drawn else plain(table))


def _assumptions_of(result: Run, options: Options) -> str:
    """Return the number of open assumptions of the run, for a complete report only.

    Every program depends on some.
    """
    from motionlang.report import assumptions

    count = len(assumptions(result))
    note = f"{count} unconfirmed assumptions; motionlang check --evidence {options.file} lists them"
    return f"\nnote: depends on {note}\n"


def _write_files(result: Run, options: Options) -> int:
    """Write the requested trace and picture; 1 if one of them cannot be written."""
    if options.trace is None and options.plot is None and options.profile_to is None:
        return 0
    from motionlang.cli.output_files import write_files

    sys.stdout.flush()
    return write_files(result, options)
