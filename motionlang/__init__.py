"""motionlang: MCCL and Mint programs, run offline on a virtual controller.

    run = motionlang.run("pick.mnt")
    run.status, run.time, run.output, run.moves[0].duration

`__all__` is the complete interface. Each name is imported on first use.
"""

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from motionlang.analysis.planning import Plan, plan
    from motionlang.analysis.sweeps import Row, sweep
    from motionlang.errors import Diagnostic, ProgramError
    from motionlang.lang.dialect import parse
    from motionlang.lang.machine.machine import Machine
    from motionlang.library.functions import (
        certify,
        check,
        compare,
        cover,
        diff,
        improve,
        map,
        profile,
        prove,
        run,
    )
    from motionlang.library.moves import Move, Moves
    from motionlang.library.report_types import Report
    from motionlang.log.trace import Trace
    from motionlang.result import Run
    from motionlang.source import Source

__version__ = "0.2.0"
__all__ = [
    "Diagnostic",
    "Machine",
    "Move",
    "Moves",
    "Plan",
    "ProgramError",
    "Report",
    "Row",
    "Run",
    "Source",
    "Trace",
    "__version__",
    "certify",
    "check",
    "compare",
    "cover",
    "diff",
    "improve",
    "map",
    "parse",
    "plan",
    "profile",
    "prove",
    "run",
    "sweep",
]

# The module of each name below this package.
_HOMES = {
    "Diagnostic": "errors",
    "Machine": "lang.machine.machine",
    "Move": "library.moves",
    "Moves": "library.moves",
    "Plan": "analysis.planning",
    "ProgramError": "errors",
    "Report": "library.report_types",
    "Row": "analysis.sweeps",
    "Run": "result",
    "Source": "source",
    "Trace": "log.trace",
    "certify": "library.functions",
    "check": "library.functions",
    "compare": "library.functions",
    "cover": "library.functions",
    "diff": "library.functions",
    "improve": "library.functions",
    "map": "library.functions",
    "parse": "lang.dialect",
    "plan": "analysis.planning",
    "profile": "library.functions",
    "prove": "library.functions",
    "run": "library.functions",
    "sweep": "analysis.sweeps",
}

if not TYPE_CHECKING:
    # Not for type checkers, for which every name would exist then.
    def __getattr__(name: str) -> object:
        """Import a name on first use."""
        if name not in _HOMES:
            raise AttributeError(f"module 'motionlang' has no attribute {name!r}")
        from importlib import import_module

        found: object = getattr(import_module(f"motionlang.{_HOMES[name]}"), name)
        globals()[name] = found
        return found


def __dir__() -> list[str]:
    return sorted({*__all__, *globals()})
