"""motionlang: MCCL and Mint programs, run offline on a virtual controller.

    run = motionlang.run("pick.mnt")
    run.status, run.time, run.output, run.moves[0].duration

`__all__` is the complete interface. Each name is imported on first use. Those that explore a program are in
motionlang-explore, a distribution of its own.
"""

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from collections.abc import Callable
    from typing import Any

    from motionlang.commands.plan import Plan, plan
    from motionlang.commands.sweep import Row, sweep
    from motionlang.functions import (
        certify,
        check,
        compare,
        diff,
        profile,
        run,
    )
    from motionlang.kernel import (
        Diagnostic,
        Machine,
        Move,
        Moves,
        ProgramError,
        Report,
        Run,
        Source,
        Trace,
        dialect,
        parse,
    )
    from motionlang.kernel.planners import hold, plan_trapezoid
    from motionlang.kernel.servo import Loop, Motor, Servo, Track, simulate
    from motionlang.kernel.version import __version__
    from motionlang.repl.session import Session

    cover: Callable[..., Any]
    explore: Callable[..., Any]
    improve: Callable[..., Any]
    map: Callable[..., Any]

__all__ = [
    "Diagnostic",
    "Loop",
    "Machine",
    "Motor",
    "Move",
    "Moves",
    "Plan",
    "ProgramError",
    "Report",
    "Row",
    "Run",
    "Servo",
    "Session",
    "Source",
    "Trace",
    "Track",
    "__version__",
    "certify",
    "check",
    "compare",
    "cover",
    "dialect",
    "diff",
    "explore",
    "hold",
    "improve",
    "map",
    "parse",
    "plan",
    "plan_trapezoid",
    "profile",
    "run",
    "simulate",
    "sweep",
]

# The module of each name below this package.
_HOMES = {
    "Diagnostic": "kernel",
    "Loop": "kernel.servo",
    "Machine": "kernel",
    "Motor": "kernel.servo",
    "Move": "kernel",
    "Moves": "kernel",
    "Plan": "commands.plan",
    "ProgramError": "kernel",
    "Report": "kernel",
    "Row": "commands.sweep",
    "Run": "kernel",
    "Servo": "kernel.servo",
    "Session": "repl.session",
    "Source": "kernel",
    "Trace": "kernel",
    "Track": "kernel.servo",
    "__version__": "kernel.version",
    "certify": "functions",
    "check": "functions",
    "compare": "functions",
    "dialect": "kernel",
    "diff": "functions",
    "hold": "kernel.planners",
    "parse": "kernel",
    "plan": "commands.plan",
    "plan_trapezoid": "kernel.planners",
    "profile": "functions",
    "run": "functions",
    "simulate": "kernel.servo",
    "sweep": "commands.sweep",
}

if not TYPE_CHECKING:
    # Not for type checkers, for which every name would exist then.
    def __getattr__(name: str) -> object:
        """Import a name on first use."""
        if name not in __all__:
            raise AttributeError(f"module 'motionlang' has no attribute {name!r}")
        from importlib import import_module

        home = _HOMES.get(name)
        if home is None:
            found = import_module("motionlang.extras").brought(name)
        else:
            found = getattr(import_module(f"motionlang.{home}"), name)
        globals()[name] = found
        return found  # type: ignore[no-any-return]


def __dir__() -> list[str]:
    return sorted(__all__)
