"""Clients for PMC controllers (MCCL) and for the line of a Mint controller.

The controller is real, served, or virtual in this process.

    from motionlang.client import Client

    with Client.open("192.168.1.20:5010") as board:   # or "/dev/ttyUSB0", or Client.virtual()
        board.send("1MN,1SV20000,1MR5000")
        board.wait_for_stop(1, timeout=10)
        print(board.position(1))
"""

from __future__ import annotations

from motionlang.hosts.client.client import Client
from motionlang.hosts.client.mint import MintClient
from motionlang.hosts.client.status import Status
from motionlang.hosts.errors import (
    AxisFault,
    ClientError,
    CommandError,
    ConnectionLost,
    FrameRejected,
    LineRejected,
    NoReply,
)

__all__ = [
    "AxisFault",
    "Client",
    "ClientError",
    "CommandError",
    "ConnectionLost",
    "FrameRejected",
    "LineRejected",
    "MintClient",
    "NoReply",
    "Status",
]
