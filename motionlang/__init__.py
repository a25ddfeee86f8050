"""motionlang: MCCL and Mint programs, run offline on a virtual controller.

    run = motionlang.run("pick.mnt")
    run.status, run.time, run.output, run.moves[0].duration

`__all__` is the complete interface. Each name is imported on first use.
"""

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from motionlang.commands.plan import Plan, plan
    from motionlang.commands.sweep import Row, sweep
    from motionlang.functions import (
        certify,
        check,
        compare,
        cover,
        diff,
        explore,
        improve,
        map,
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
    "cover": "functions",
    "dialect": "kernel",
    "diff": "functions",
    "explore": "functions",
    "hold": "kernel.planners",
    "improve": "functions",
    "map": "functions",
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
        if name not in _HOMES:
            raise AttributeError(f"module 'motionlang' has no attribute {name!r}")
        from importlib import import_module

        found: object = getattr(import_module(f"motionlang.{_HOMES[name]}"), name)
        globals()[name] = found
        return found


def __dir__() -> list[str]:
    return sorted(__all__)
