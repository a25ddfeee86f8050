"""`python -m motionlang`, and where the command `motionlang` begins.

Until `main` listens to signals, Ctrl-C ends the process without a word, as it ends any other: there is nothing to
report, and Python would show a traceback through its imports. After `main` it is so again.
"""

import _signal  # type: ignore[import-not-found]  # signal itself imports enum

if _signal.getsignal(_signal.SIGINT) is _signal.default_int_handler:
    _signal.signal(_signal.SIGINT, _signal.SIG_DFL)

import os
import sys

# numpy's matrices are small here, and its other threads would only wait for them, which takes a core.
os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")

from motionlang.bytecode import install


def main() -> int:
    """Run one command and leave; the exit status where somebody waits for the end of the process."""
    finder = install()
    from motionlang.cli import main as command

    status = command()
    if finder is not None and finder.lacks:
        from motionlang.bytecode_writing import keep

        keep(finder)
    _leave(status)
    return status


def _leave(status: int) -> None:
    """Leave without taking everything apart first, which takes a fifth of the time of an empty Python.

    Not so where somebody has asked to be called at the end, looks on, or where threads are at work.
    """
    import atexit

    waiting = getattr(atexit, "_ncallbacks", None)
    if waiting is None or waiting() or "threading" in sys.modules or sys.flags.inspect:
        return
    if sys.gettrace() is not None or sys.getprofile() is not None:
        return
    try:
        sys.stdout.flush()
        sys.stderr.flush()
    except (OSError, ValueError):
        return  # Python says so itself as it ends
    os._exit(status)


if __name__ == "__main__":
    sys.exit(main())
