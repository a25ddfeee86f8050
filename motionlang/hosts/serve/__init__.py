"""A board that serves several real hosts at once, over TCP or a serial device.

An ordinary run imports nothing of this package.

    with Server(Console(Machine(first_axis=1))) as server:
        server.listen("127.0.0.1", 5010)
        server.run()      # until stop(), from a signal or another thread
"""

from __future__ import annotations

from motionlang.hosts.serve.limits import Limits
from motionlang.hosts.serve.pace import LockStep, RealTime
from motionlang.hosts.serve.server import Server

__all__ = ["Limits", "LockStep", "RealTime", "Server"]
