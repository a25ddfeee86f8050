"""`python -m motionlang`, and the entry point of the command `motionlang`.

Until `main` handles signals, Ctrl-C ends the process silently: there is nothing to report, and Python would show a
traceback through its imports. The same applies after `main`.
"""

import signal

if signal.getsignal(signal.SIGINT) is signal.default_int_handler:
    signal.signal(signal.SIGINT, signal.SIG_DFL)

import os
import sys

# numpy's matrices are small here, and its other threads would only wait for them, using a core.
os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")


def main() -> int:
    """Run one command and exit; return the status if the process must exit normally."""
    from motionlang.cli import main as command

    status = command()
    _leave(status)
    return status


def _leave(status: int) -> None:
    """Exit without finalisation, which takes a fifth of the time of an empty Python.

    With exit handlers, a tracer or other threads, the exit is normal.
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
        return  # Python reports it itself as it ends
    os._exit(status)


if __name__ == "__main__":
    sys.exit(main())
