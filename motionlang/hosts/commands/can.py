"""`motionlang serve --can`: simulated drives on a CAN bus, and their EDS file."""

from __future__ import annotations

import logging
from collections.abc import Mapping
from dataclasses import dataclass
from typing import ClassVar

from motionlang.cli.command import Refused, WrongOption, option
from motionlang.cli.complaints import unwritten
from motionlang.cli.readers import whole
from motionlang.hosts.commands.options import Served, say, until_signal, warn
from motionlang.hosts.commands.output_queue import OutputQueue, dropped
from motionlang.kernel import Diagnostic
from motionlang.kernel.files import replacing
from motionlang.kernel.tools import need
from motionlang.lab.pvt.drive.switches import Switches

AXIS = "axis.{}."
HINT = "choose an interface of python-can that this computer has; virtual works within one process"


def _bus(text: str) -> tuple[str, str]:
    interface, colon, channel = text.partition(":")
    if not (interface and colon and channel):
        raise ValueError(f"{text!r} is not INTERFACE:CHANNEL, such as socketcan:vcan0")
    return interface, channel


@dataclass
class ServedDrives(Served):
    """Drives on a CAN bus."""

    title: ClassVar[str] = "CANopen drives"
    can: tuple[str, str] | None = option(
        "INTERFACE:CHANNEL",
        "put simulated drives on a bus of python-can",
        read=_bus,
    )
    drives: int | None = option(
        "N",
        "the number of drives, nodes 1 to N (1)",
        read=whole("a number of drives from 1 to 127", 1, 127),
    )
    eds: str | None = option("FILE", "write the EDS file of the drives", writes=True)

    def check(self) -> None:
        super().check()
        if self.can is None and (self.drives is not None or self.eds is not None):
            raise WrongOption("--drives and --eds need --can INTERFACE:CHANNEL")

    def serve_drives(self, queues: list[OutputQueue]) -> int:
        """Serve until a signal; Refused if the EDS file or the bus cannot be opened.

        Raises MissingExtra without the CAN libraries. `queues` are those of standard output and standard error.
        """
        need("motionlang serve --can", "can", "canopen")
        from motionlang.hosts.can import DriveServer
        from motionlang.lab.pvt.drive.bus import BusError

        logging.getLogger("canopen").setLevel(logging.CRITICAL)
        if self.eds is not None:
            _write_eds(self.eds)
        assert self.can is not None
        count = self.drives or 1
        settings = self.settings()
        switches = [_switches(settings, number) for number in range(1, count + 1)]
        try:
            server = DriveServer(
                *self.can, count, factor=self.factor or 1.0, switches=switches, complain=warn
            )
        except BusError as problem:
            raise Refused([Diagnostic("address", str(problem), hint=HINT)]) from None
        with server:
            nodes = "node 1" if count == 1 else f"nodes 1 to {count}"
            say(f"CANopen drives, {nodes}, on {' '.join(self.can)}; Ctrl-C ends it\n")
            say("units: positions in counts, speeds in 0.1 counts/s, rates in 10 counts/s²\n")
            if self.can[0] == "udp_multicast":
                say("a master gets its own frames back: give it the can_filters of docs/hosts-can.md\n")
            until_signal(server)
            say(f"received {server.frames} frames; machine time {server.now:.3f} s{dropped(queues)}\n")
        return 0


def _write_eds(path: str) -> None:
    from motionlang.lab.pvt.drive.eds import eds

    try:
        with replacing(path) as file:
            file.write(eds().encode("ascii"))
    except OSError as error:
        raise Refused([unwritten(path, error)]) from None
    say(f"EDS file {path}\n")


def _switches(settings: Mapping[str, object], number: int) -> Switches:
    """Return the switches of a drive, as the machine file sets them for its axis."""
    of_axis = AXIS.format(number)
    usual = Switches()
    negative, positive = settings.get(f"{of_axis}travel", (usual.negative, usual.positive))  # type: ignore[misc]
    home, _ = settings.get(f"{of_axis}home_switch", (usual.home, 0.0))  # type: ignore[misc]
    index = settings.get(f"{of_axis}index_every", usual.index)
    return Switches(*(float(each) for each in (negative, positive, home, index)))  # type: ignore[arg-type,has-type]
