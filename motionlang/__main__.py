"""`python -m motionlang`, and the entry point of the command `motionlang`.

Until `main` handles signals, Ctrl-C ends the process silently: there is nothing to report, and Python would show a
traceback through its imports. The same applies after `main`.
"""

import signal

if signal.getsignal(signal.SIGINT) is signal.default_int_handler:
    signal.signal(signal.SIGINT, signal.SIG_DFL)

import gc
import os
import sys

# numpy's matrices are small here, and its other threads would only wait for them, using a core.
os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")


def main() -> int:
    """Run one command; return the exit status."""
    # Nearly all objects of a command stay until it ends. To examine them again and again takes a tenth of its time, and
    # once more at the end twice as long as an empty Python. PyPy's garbage collector has neither setting.
    if hasattr(gc, "set_threshold"):
        gc.set_threshold(200_000)
    from motionlang.cli import main as command

    status = command()
    if hasattr(gc, "freeze"):
        gc.freeze()
    return status


if __name__ == "__main__":
    sys.exit(main())
