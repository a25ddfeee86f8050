"""motionlang: MCCL and Mint programs, run offline on a virtual controller.

`run` is the complete interface; its result has the report, the trace and the output.
"""

TYPE_CHECKING = False
if TYPE_CHECKING:
    from motionlang.analysis.sweeps import sweep
    from motionlang.execution import run
    from motionlang.result import Run

__version__ = "0.1.0"
__all__ = ["Run", "__version__", "run", "sweep"]


def __getattr__(name: str) -> object:
    """`run`, `Run` or `sweep` on first use, to keep imports of the package small."""
    if name in ("run", "Run"):
        from importlib import import_module

        module = import_module("motionlang.execution")
        globals().update(run=module.run, Run=module.Run)
        return globals()[name]
    if name == "sweep":
        from importlib import import_module

        globals()["sweep"] = import_module("motionlang.analysis.sweeps").sweep
        return globals()["sweep"]
    raise AttributeError(name)
