"""MCAPI, the library by which hosts drive PMC boards, for virtual boards.

A host reaches a board through the C library, through the port of `motionlang mcapi serve`, or from Python:

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

from motionlang_mcapi.binding import Mcapi as Mcapi
from motionlang_mcapi.binding import McapiException as McapiException
from motionlang_mcapi.client import VirtualBoard as VirtualBoard
from motionlang_mcapi.table import *  # noqa: F403
