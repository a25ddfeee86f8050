"""MCAPI, the library by which hosts drive PMC boards, for virtual boards.

A host reaches a board through the C library, through the port of `motionlang serve --mcapi`, or from Python:

    host = Mcapi.virtual({"controller.model": "dcx-pci100"})
    host.Open(0, MC_OPEN_BINARY)
    host.EnableAxis(1, True)
    host.MoveAbsolute(1, 5000.0)
    host.IsStopped(1, 10.0)          # 1
    host.GetPositionEx(1)            # 5000.0

All functions are implemented here: the C library only transports calls. An ordinary run imports nothing of this
package.
"""

from __future__ import annotations

from importlib import import_module

TYPE_CHECKING = False
if TYPE_CHECKING:
    from motionlang.mcapi.binding import *  # noqa: F403
    from motionlang.mcapi.client import McapiException as McapiException
    from motionlang.mcapi.client import VirtualBoard as VirtualBoard
    from motionlang.mcapi.constants import *  # noqa: F403


def __getattr__(name: str) -> object:
    """Return the class, a structure or a constant of MCAPI, imported on first use."""
    if name[:1].isupper():
        for module in ("constants", "binding", "client"):
            found = vars(import_module(f"motionlang.mcapi.{module}"))
            if name in found:
                return found[name]
    raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
