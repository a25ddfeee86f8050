"""`motionlang serve --can`: simulated drives on a CAN bus, and their EDS file."""

from __future__ import annotations

import logging
from typing import TYPE_CHECKING

from motionlang.cli.complaints import complain
from motionlang.cli.output_queue import dropped
from motionlang.cli.serve_hosts import say, until_signal, warn
from motionlang.errors import Diagnostic, need
from motionlang.files import reason, replacing

if TYPE_CHECKING:
    import argparse
    from collections.abc import Mapping

    from motionlang.cli.output_queue import OutputQueue
    from motionlang.copley.switches import Switches

AXIS = "axis.{}."
HINT = "choose an interface of python-can that this computer has; virtual works within one process"


def serve_can(args: argparse.Namespace, settings: Mapping[str, object], queues: list[OutputQueue]) -> int:
    """Serve until a signal; 1 if the EDS file or the bus cannot be opened.

    Raises MissingExtra without the CAN libraries. `queues` are those of standard output and standard error.
    """
    need("motionlang serve --can", "can", "canopen")
    from motionlang.copley.bus import BusError
    from motionlang.copley.served import DriveServer

    logging.getLogger("canopen").setLevel(logging.CRITICAL)
    if args.eds is not None and not _write_eds(args.eds):
        return 1
    interface, channel = args.can
    switches = [_switches(settings, number) for number in range(1, args.drives + 1)]
    try:
        server = DriveServer(
            interface, channel, args.drives, factor=args.factor or 1.0, switches=switches, complain=warn
        )
    except BusError as problem:
        complain([Diagnostic("address", str(problem), hint=HINT)], None, "")
        return 1
    with server:
        nodes = "node 1" if args.drives == 1 else f"nodes 1 to {args.drives}"
        say(f"CANopen drives, {nodes}, on {interface} {channel}; Ctrl-C ends it\n")
        say("units: positions in counts, speeds in 0.1 counts/s, rates in 10 counts/s²\n")
        if interface == "udp_multicast":
            say("a master gets its own frames back: give it the can_filters of docs/hosts-can.md\n")
        until_signal(server)
        say(f"received {server.frames} frames; machine time {server.now:.3f} s{dropped(queues)}\n")
    return 0


def _write_eds(path: str) -> bool:
    from motionlang.copley.eds import eds

    try:
        with replacing(path) as file:
            file.write(eds().encode("ascii"))
    except OSError as error:
        complain([Diagnostic("file", f"{path} cannot be written: {reason(error)}")], None, "")
        return False
    say(f"EDS file {path}\n")
    return True


def _switches(settings: Mapping[str, object], number: int) -> Switches:
    """Return the switches of a drive, as the machine file sets them for its axis."""
    from motionlang.copley.switches import Switches

    of_axis = AXIS.format(number)
    usual = Switches()
    negative, positive = settings.get(f"{of_axis}travel", (usual.negative, usual.positive))  # type: ignore[misc]
    home, _ = settings.get(f"{of_axis}home_switch", (usual.home, 0.0))  # type: ignore[misc]
    index = settings.get(f"{of_axis}index_every", usual.index)
    return Switches(*(float(each) for each in (negative, positive, home, index)))  # type: ignore[arg-type,has-type]
