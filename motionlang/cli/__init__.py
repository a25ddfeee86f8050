"""The command line: selection of the command, closed pipes and Ctrl-C.

The most frequent command lines, `run FILE` with at most a format, a dialect and `--profile`, are parsed
here without argparse, whose import alone takes as long as such a run. A test checks that both parsers
agree.
"""

from __future__ import annotations

import gc
import sys

from motionlang.cli.signals import SIGNALS, status_of
from motionlang.cli.standard_streams import prepare, silence
from motionlang.errors import Diagnostic, Terminated

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Sequence

    from motionlang.cli.options import Options

# The exit status if the reader of standard output has gone: 128 and SIGPIPE's number, like in shells.
PIPE_CLOSED = 141


def main(arguments: Sequence[str] | None = None) -> int:
    """Run one command and return its exit status.

    0 is success, 1 means that the program is wrong or faulted, and 2 that the command line is wrong;
    docs/cli.md lists the others. No error ends in a traceback.
    """
    given = sys.argv[1:] if arguments is None else list(arguments)
    try:
        with SIGNALS:
            return _guarded(given)
    except (KeyboardInterrupt, Terminated) as error:
        return status_of(error)
    finally:
        if arguments is None and hasattr(gc, "freeze"):
            gc.freeze()  # the process ends, so the collector need not examine the remaining objects


def _guarded(given: list[str]) -> int:
    prepare()
    try:
        status = _command(given)
        sys.stdout.flush()
    except BrokenPipeError:
        silence()
        return PIPE_CLOSED
    except OSError as error:
        # Every other file has reported its errors by now: this is standard output, for example on a full
        # disk.
        sys.stderr.write(f"motionlang: cannot write the output: {(error.strerror or str(error)).lower()}\n")
        silence()
        return 1
    except Exception as error:
        from motionlang.cli.complaints import complain
        from motionlang.cli.crash import crash
        from motionlang.cli.run import CRASHED, UNAVAILABLE
        from motionlang.errors import missing

        lacking = missing(error, " ".join(["motionlang", *given[:1]]))
        if lacking is not None:
            complain([Diagnostic("extra", lacking.message, hint=lacking.hint)], None, "")
            return UNAVAILABLE if lacking.is_required else 2 if lacking.is_option else 1
        complain([crash(error, given)], None, "")
        return CRASHED
    return status


def quick_options(given: Sequence[str]) -> Options | None:
    """Return the options of a plain `run` line; None for lines that need argparse."""
    if not given or given[0] != "run":
        return None
    from motionlang.cli.options import REPORTS, Options

    options = Options("")
    rest = iter(given[1:])
    for word in rest:
        if word == "--profile":
            options.profile = True
        elif word == "--format":
            options.report = next(rest, "")
            if options.report not in REPORTS:
                return None
        elif word in ("--dialect", "--lang"):
            options.dialect = next(rest, "")
            if options.dialect not in ("mint", "mccl"):
                return None
        elif (word[:1] == "-" and word != "-") or options.file:
            return None
        else:
            options.file = word
    if options.profile and options.report == "none":
        return None
    return options if options.file else None


def _command(given: Sequence[str]) -> int:
    if not given:
        from motionlang.cli.welcome import welcome

        sys.stderr.write(welcome())
        return 2
    gc.disable()  # loaded objects stay, and need no collection; a run collects for itself
    try:
        if given[:1] == ["run"]:
            SIGNALS.defer()  # until the run can report how it ended
        options = quick_options(given)
        if options is not None:
            from motionlang.cli.run import run_command

            options.given = list(given)
            return run_command(options)
    finally:
        gc.enable()
    from motionlang.cli.commands import parse

    return parse(given)
