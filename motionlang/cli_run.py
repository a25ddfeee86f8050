"""`motionlang run`: a program from its file to its report, its trace and its picture."""

from __future__ import annotations

import os
import sys

from motionlang.execution import dialect, dialect_of, machine_of, run
from motionlang.source import STDIN, STDIN_NAME, Source, contents, name_of

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable, Sequence

    from motionlang.errors import Diagnostic
    from motionlang.execution import Run
    from motionlang.lang.machine import Machine
    from motionlang.lang.scheduler import Outside

REPORTS = ("table", "json", "none")
TRACES = (".csv", ".npz", ".parquet", ".vcd")
PLOTS = (".png", ".svg", ".html")
RATE = 1000.0
# TN1069: trajectory points a second, and samples of the loop that goes from one to the next in a straight line.
TRAJECTORY_RATE, SERVO_RATE = 1000.0, 4000.0
# The width of a table that goes into a file or a pipe: wide enough for every column.
PIPED_WIDTH = 160


class Options:
    """What the command line asks of a run."""

    __slots__ = (
        "cache",
        "dialect",
        "file",
        "machine",
        "nv",
        "overrides",
        "plot",
        "points",
        "rate",
        "realtime",
        "report",
        "settings",
        "trace",
        "until",
    )

    def __init__(self, file: str) -> None:
        self.file = file
        self.dialect: str | None = None
        self.machine: str | None = None
        self.report = "table"
        self.until: float | None = None
        self.realtime: float | None = None
        self.trace: str | None = None
        self.rate = RATE
        # Trajectory points a second where the trace is to be as the controller computes it.
        self.points: float | None = None
        self.plot: str | None = None
        # `--set` by what it names: keys of the machine file, and names of the program.
        self.settings: dict[str, object] = {}
        self.overrides: dict[str, float | str] = {}
        self.nv: str | None = None
        self.cache = True

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Options) and all(
            getattr(self, name) == getattr(other, name) for name in Options.__slots__
        )

    __hash__ = None  # type: ignore[assignment]


def run_command(options: Options) -> int:
    """Run a program and show what it did; answers with the exit status."""
    try:
        source = read_source(options.file)
    except OSError as error:
        return refuse(options, [unreadable(options.file, error)], None, 1)
    if options.dialect is None and dialect_of(options.file) is None:
        return refuse(options, [no_dialect(options.file)], None, 2)
    settings = dict(options.settings)
    options.machine = machine_of(options.file, options.machine)
    if options.machine is not None:
        status = read_machine_file(options, settings)
        if status:
            return status
    missing = _missing_axes(options, settings) if settings else []
    if missing:
        return refuse(options, missing, Source(options.machine, "") if options.machine else None, 1)
    if options.realtime is not None and options.file != STDIN and sys.stdin.isatty():
        from motionlang.cli_keyboard import run_live

        result = run_live(lambda keyboard: _run(options, source, settings, keyboard), options.realtime)
    else:
        result = _run(options, source, settings)
    _report(result, options)
    status = _write_files(result, options)
    complain(result.diagnostics, result.source, options.file)
    if result.status == "interrupted":
        return 130
    wrong = result.status == "fault" or any(each.severity == "error" for each in result.diagnostics)
    return 1 if wrong else status


def _missing_axes(options: Options, settings: dict[str, object]) -> list[Diagnostic]:
    from motionlang.lang.machine import DEFAULT_AXES
    from motionlang.lang.machine_axes import missing_axes

    language = dialect(options.dialect) if options.dialect else dialect_of(options.file)
    assert language is not None
    axes: int = settings.get("controller.axes", DEFAULT_AXES)  # type: ignore[assignment]
    return missing_axes(settings, axes, language.first_axis)


def _run(
    options: Options, source: Source, settings: dict[str, object], outside: Outside | None = None
) -> Run:
    if sys.stderr.isatty():
        from motionlang.cli_watch import watched

        return watched(lambda show, begun: _run_unwatched(options, source, settings, outside, show, begun))
    return _run_unwatched(options, source, settings, outside, _show, None)


def _run_unwatched(
    options: Options,
    source: Source,
    settings: dict[str, object],
    outside: Outside | None,
    show: Callable[[str], None],
    begun: Callable[[Machine], None] | None,
) -> Run:
    return run(
        source,
        dialect=options.dialect or dialect_of(options.file),
        machine=settings,
        until=options.until,
        overrides=options.overrides,
        show=None if options.report == "json" else show,
        pace=None if options.realtime is None else pacer(options.realtime),
        outside=outside,
        begun=begun,
        nv=options.nv,
        cache=options.cache,
    )


def _show(text: str) -> None:
    sys.stdout.write(text)


def read_source(file: str) -> Source:
    """The program of a file, or of standard input for `-`; OSError where it cannot be read."""
    if file == STDIN:
        return Source.from_bytes(STDIN_NAME, contents(sys.stdin.buffer))
    return Source.read(file)


def pacer(factor: float) -> Callable[[float], None]:
    """What holds a run to the wall clock, `factor` machine seconds a second; output appears when it happens."""
    from time import monotonic, sleep

    began = monotonic()

    def pace(time: float) -> None:
        ahead = time / factor - (monotonic() - began)
        if ahead > 0.0:
            sys.stdout.flush()
            sleep(ahead)

    return pace


def unreadable(file: str, error: OSError) -> Diagnostic:
    """The diagnostic of a file that cannot be read."""
    from motionlang.errors import Diagnostic
    from motionlang.files import reason

    return Diagnostic("file", f"{file} cannot be read: {reason(error)}")


def unwritten(file: str, error: OSError) -> Diagnostic:
    """The diagnostic of a file that cannot be written."""
    from motionlang.errors import Diagnostic
    from motionlang.files import reason

    return Diagnostic("file", f"{file} cannot be written: {reason(error)}")


def no_dialect(file: str) -> Diagnostic:
    """The diagnostic of a file whose name does not say its language."""
    from motionlang.errors import Diagnostic

    name = "standard input" if file == STDIN else file
    suffix = os.path.splitext(file)[1]
    what = f"its suffix {suffix} belongs to no dialect" if suffix else "it has no suffix"
    if file == STDIN:
        what = "it has no name"
    hint = "say --dialect mint or --dialect mccl; .mnt .mntx .prg are Mint, .mcl .mccl MCCL"
    return Diagnostic("file", f"the language of {name} is unknown: {what}", hint=hint)


def complain(diagnostics: Sequence[Diagnostic], source: Source | None, file: str) -> None:
    """Show diagnostics on standard error, after everything that standard output has so far."""
    if not diagnostics:
        return
    from motionlang.views.diagnostics import render_all
    from motionlang.views.terminal import wants_colour, width_of

    sys.stdout.flush()
    name = STDIN_NAME if file == STDIN else file
    colour, width = wants_colour(sys.stderr), width_of(sys.stderr)
    sys.stderr.write(render_all(diagnostics, source, name=name, colour=colour, width=width))
    sys.stderr.flush()


def refuse(options: Options, diagnostics: Sequence[Diagnostic], source: Source | None, status: int) -> int:
    """Say why nothing was run, in JSON too where that was asked for."""
    if options.report == "json":
        from motionlang.report import failure

        sys.stdout.write(failure(name_of(options.file), options.dialect or "", diagnostics))
    complain(diagnostics, source, source.name if source is not None else options.file)
    return status


def read_machine_file(options: Options, settings: dict[str, object]) -> int:
    """Put the machine file's settings below those of `--set`."""
    from motionlang.errors import ProgramError
    from motionlang.lang.machine_file import read_machine

    assert options.machine is not None
    try:
        source = Source.read(options.machine)
    except OSError as error:
        return refuse(options, [unreadable(options.machine, error)], None, 1)
    try:
        for key, value in read_machine(source).items():
            settings.setdefault(key, value)
    except ProgramError as error:
        return refuse(options, error.diagnostics, source, 1)
    return 0


def _report(result: Run, options: Options) -> None:
    if options.report == "json":
        from motionlang.report import text

        sys.stdout.write(text(result))
        return
    began = result.status != "fault" or result.time or result.controller.moves
    if options.report == "none" or not began:
        return
    from motionlang.views.table import render
    from motionlang.views.terminal import draws, is_terminal, plain, wants_colour, width_of

    seen, drawn = is_terminal(sys.stdout), draws(sys.stdout)
    width = width_of(sys.stdout) if seen else PIPED_WIDTH
    table = render(result, width=width, colour=wants_colour(sys.stdout), charts=seen and drawn)
    if result.output:
        table = "\n" + table
    sys.stdout.write(table if drawn else plain(table))


def _write_files(result: Run, options: Options) -> int:
    """The trace and the picture, where they were asked for; 1 when one could not be written."""
    if options.trace is None and options.plot is None:
        return 0
    from motionlang.cli_files import write_files

    sys.stdout.flush()
    return write_files(result, options)
