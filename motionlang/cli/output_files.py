"""The files of `--trace` and `--plot`, which are written after the run.

They are checked before it, so that the run is not wasted.
"""

from __future__ import annotations

import os
import sys
from typing import TYPE_CHECKING

from motionlang.cli.complaints import complain, unwritten
from motionlang.cli.options import PLOTS, PROFILES, TRACES
from motionlang.errors import Diagnostic, Terminated, need
from motionlang.execution import machine_of
from motionlang.files import same_file, unwritable
from motionlang.result import who_ended
from motionlang.source import STDIN
from motionlang.views.progress import Progress

if TYPE_CHECKING:
    from collections.abc import Callable

    from motionlang.cli.options import Options
    from motionlang.result import Run
    from motionlang.servo.trace import ServoTrace

# The optional library that writes a format.
_WRITERS = {".png": "matplotlib", ".svg": "matplotlib", ".parquet": "pyarrow", ".mcap": "mcap", ".vcd": "vcd"}


def wrong_target(option: str, path: str) -> str | None:
    """Return the error in the output file of `option`, if it is known before the run."""
    formats = {"--trace": TRACES, "--plot": PLOTS, "--profile-to": PROFILES}[option]
    suffix = os.path.splitext(path)[1].lower()
    known = f"{', '.join(formats[:-1])} and {formats[-1]}"
    if suffix not in formats:
        what = f"not {suffix} files" if suffix else "so the file needs one of these extensions"
        return f"{option} writes {known}, {what}"
    if option == "--trace" or (option == "--plot" and suffix != ".html"):
        need(option, "numpy")
    need_writer(option, path)
    return None


def need_writer(option: str, path: str) -> None:
    """Raise MissingExtra if the library that writes the format of `path` is missing."""
    suffix = os.path.splitext(path)[1].lower()
    if suffix in _WRITERS:
        need(f"{option} {suffix}", _WRITERS[suffix])


def write_files(result: Run, options: Options) -> int:
    """Write the requested files; 1 if one of them cannot be written."""
    status = 0
    if options.trace is not None:
        status = written(options.trace, lambda: _write_trace(result, options))
    if options.plot is not None:
        status = max(status, written(options.plot, lambda: _write_plot(result, options)))
    if options.profile_to is not None:
        status = max(status, written(options.profile_to, lambda: _write_profile(result, options)))
    return status


def refused(path: str, options: Options) -> Diagnostic | None:
    """Return the diagnostic of a path that is an input of the run or not writable.

    Only errors that can be detected beforehand are found.
    """
    inputs = {
        "the program": None if options.file == STDIN else options.file,
        "the machine file": machine_of(options.file, options.machine),
        "the nv data": options.nv,
    }
    for what, used in inputs.items():
        if used is not None and same_file(path, used):
            return Diagnostic("file", f"{path} is {what} of this run", hint="write to another file")
    problem = unwritable(path)
    return None if problem is None else Diagnostic("file", problem)


def written(path: str, write: Callable[[], None]) -> int:
    """Write a file and return the exit status: 1 if that failed, which is reported."""
    try:
        write()
    except BrokenPipeError:
        raise
    except (KeyboardInterrupt, Terminated) as error:
        complain(
            [Diagnostic("interrupted", f"{path} was not written: the command was ended {who_ended(error)}")],
            None,
            path,
        )
        raise
    except OSError as error:
        complain([unwritten(path, error)], None, path)
        return 1
    except ValueError as error:  # a window or a column that the run does not have, or too many samples
        complain([Diagnostic("window", f"{path} was not written: {error}")], None, path)
        return 1
    return 0


def _write_trace(result: Run, options: Options) -> None:
    from motionlang.views.export import write_trace

    assert options.trace is not None
    trace = result.trace if options.points is None else result.trace.as_controller(options.points)
    if options.columns is not None:
        trace.choose(options.columns)
    progress = Progress(sys.stderr, options.trace)
    try:
        write_trace(trace, options.trace, options.rate, progress)
    finally:
        progress.done()


def _write_plot(result: Run, options: Options) -> None:
    assert options.plot is not None
    from motionlang.views.window import Window

    servos, window = _motors(result), Window(*options.window)
    if options.plot.lower().endswith(".html"):
        from motionlang.views.scope import write_scope

        write_scope(result, options.plot, servos, window)
    else:
        from motionlang.views.plot import write_plot

        write_plot(result, options.plot, servos, window)


def _write_profile(result: Run, options: Options) -> None:
    from motionlang.analysis.cycle.export import write_profile
    from motionlang.analysis.cycle.profile import TimeProfile

    assert options.profile_to is not None
    write_profile(TimeProfile(result), options.profile_to)


def _motors(result: Run) -> dict[int, ServoTrace]:
    """Return the traces of the simulated motors of a run, by axis."""
    if all(axis.feedback is None for axis in result.controller.axes.values()):
        return {}
    from motionlang.log.history import servo_traces

    return servo_traces(result.controller)
