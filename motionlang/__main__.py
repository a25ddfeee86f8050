"""`python -m motionlang`, and where the command `motionlang` begins.

Until `main` listens to signals, Ctrl-C ends the process without a word, as it ends any other: there is nothing to
report, and Python would show a traceback through its imports. After `main` it is so again.
"""

import signal

if signal.getsignal(signal.SIGINT) is signal.default_int_handler:
    signal.signal(signal.SIGINT, signal.SIG_DFL)

import os
import sys

# numpy's matrices are small here, and its other threads would only wait for them, which takes a core.
os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")


def main() -> int:
    """Run one command and leave; the exit status where somebody waits for the end of the process."""
    from motionlang.cli import main as command

    status = command()
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
