"""`python -m motionlang`, and where the command `motionlang` begins.

Until `main` listens to signals, Ctrl-C ends the process without a word, as it ends any other: there is nothing to
report, and Python would show a traceback through its imports. After `main` it is so again.
"""

from __future__ import annotations

import _signal  # type: ignore[import-not-found]  # signal itself imports enum

if _signal.getsignal(_signal.SIGINT) is _signal.default_int_handler:
    _signal.signal(_signal.SIGINT, _signal.SIG_DFL)

import os
import sys

# numpy's matrices are small here, and its other threads would only wait for them, which takes a core.
os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")

from motionlang.cli import main

__all__ = ["main"]

if __name__ == "__main__":
    sys.exit(main())
