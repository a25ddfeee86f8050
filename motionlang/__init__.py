"""motionlang: MCCL and Mint programs, run offline on a virtual controller.

`run` is the complete interface; its result has the report, the trace and the output.
"""

TYPE_CHECKING = False
if TYPE_CHECKING:
    from motionlang.analysis.sweeps import sweep
    from motionlang.execution import run
    from motionlang.lang.dialect import parse
    from motionlang.result import Run

__version__ = "0.1.0"
__all__ = ["Run", "__version__", "parse", "run", "sweep"]


def __getattr__(name: str) -> object:
    """Import `run`, `Run`, `sweep` and `parse` on first use: importing a part does not import the whole package."""
    if name in ("run", "Run"):
        from importlib import import_module

        module = import_module("motionlang.execution")
        globals().update(run=module.run, Run=module.Run)
        return globals()[name]
    if name == "sweep":
        from importlib import import_module

        globals()["sweep"] = import_module("motionlang.analysis.sweeps").sweep
        return globals()["sweep"]
    if name == "parse":
        from importlib import import_module

        globals()["parse"] = import_module("motionlang.lang.dialect").parse
        return globals()["parse"]
    raise AttributeError(name)
