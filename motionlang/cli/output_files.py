"""Files that a command writes at its end, with the errors reported."""

from __future__ import annotations

from collections.abc import Callable

from motionlang import kernel
from motionlang.cli.complaints import complain, unwritten
from motionlang.kernel import Diagnostic, Terminated


def written(path: str, write: Callable[[], None]) -> int:
    """Write a file and return the exit status: 1 if that failed, which is reported."""
    try:
        write()
    except BrokenPipeError:
        raise
    except (KeyboardInterrupt, Terminated) as error:
        complain(
            [
                Diagnostic(
                    "interrupted", f"{path} was not written: the command was ended {kernel.who_ended(error)}"
                )
            ],
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
