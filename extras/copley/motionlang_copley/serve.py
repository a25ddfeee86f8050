"""`motionlang copley`: simulated drives on a CAN bus, their EDS file, and a master."""

from __future__ import annotations

import logging
from collections.abc import Mapping
from dataclasses import dataclass
from typing import ClassVar

from motionlang.cli.command import Command, Refused, WrongOption, argument, option
from motionlang.cli.complaints import unwritten
from motionlang.cli.option_groups import ProgramOptions
from motionlang.cli.readers import real, whole
from motionlang.hosts.commands.options import remark, say, until_signal
from motionlang.hosts.commands.output_queue import OutputQueue, dropped, never_waiting
from motionlang.kernel import Diagnostic
from motionlang.kernel.files import replacing
from motionlang_copley.stream import CopleyStream
from motionlang_copley.switches import Switches

AXIS = "axis.{}."
HINT = "choose an interface of python-can that this computer has; virtual works within one process"


def _bus(text: str) -> tuple[str, str]:
    interface, colon, channel = text.partition(":")
    if not (interface and colon and channel):
        raise ValueError(f"{text!r} is not INTERFACE:CHANNEL, such as socketcan:vcan0")
    return interface, channel


@dataclass
class CopleyServe(ProgramOptions):
    """Put simulated drives on a CAN bus."""

    title: ClassVar[str] = "CANopen drives"
    epilog: ClassVar[str] = """\
--set axis.1.travel=[-9000,9000] places the switches of drive 1, in counts.

examples:
  motionlang copley serve socketcan:vcan0 --drives 2 --eds drive.eds
"""
    bus: tuple[str, str] = argument("INTERFACE:CHANNEL", "the bus of python-can", read=_bus)
    drives: int | None = option(
        "N",
        "the number of drives, nodes 1 to N (1)",
        read=whole("a number of drives from 1 to 127", 1, 127),
    )
    eds: str | None = option("FILE", "write the EDS file of the drives", writes=True)
    factor: float = option(
        "X",
        "run at X × real time (1)",
        read=real("a factor from 0.000001 to 1000000", 1e-6, 1e6),
        default=1.0,
    )

    def check(self) -> None:
        super().check()
        names = self.overrides()
        if names:
            raise WrongOption(f"--set {next(iter(names))}: the drives run no program with names")

    def run(self) -> int:
        """Serve until a signal; Refused if the EDS file or the bus cannot be opened."""
        with never_waiting() as queues:
            return self._serve(queues)

    def _serve(self, queues: list[OutputQueue]) -> int:
        from motionlang_copley.bus import BusError
        from motionlang_copley.server import DriveServer

        logging.getLogger("canopen").setLevel(logging.CRITICAL)
        if self.eds is not None:
            _write_eds(self.eds)
        count = self.drives or 1
        settings = self.settings()
        switches = [_switches(settings, number) for number in range(1, count + 1)]
        try:
            server = DriveServer(*self.bus, count, factor=self.factor, switches=switches, complain=_warn)
        except BusError as problem:
            raise Refused([Diagnostic("address", str(problem), hint=HINT)]) from None
        with server:
            nodes = "node 1" if count == 1 else f"nodes 1 to {count}"
            say(f"CANopen drives, {nodes}, on {' '.join(self.bus)}; Ctrl-C ends it\n")
            say("units: positions in counts, speeds in 0.1 counts/s, rates in 10 counts/s²\n")
            if self.bus[0] == "udp_multicast":
                say("a master gets its own frames back: give it the can_filters of docs/hosts-can.md\n")
            until_signal(server)
            say(f"received {server.frames} frames; machine time {server.now:.3f} s{dropped(queues)}\n")
        return 0


def _warn(text: str) -> None:
    remark(f"motionlang copley serve: {text}\n")


def _write_eds(path: str) -> None:
    from motionlang_copley.eds import eds

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


class CopleyCommand(Command):
    """Simulate Copley drives on a CAN bus, and stream moves to them."""

    commands: ClassVar = {
        "serve": (CopleyServe, "put simulated drives on a CAN bus"),
        "stream": (CopleyStream, "send a move to a simulated drive over CANopen and compare the motion"),
    }
