"""`motionlang serve`: a virtual controller on TCP, a serial device or Modbus.

The controller is an MCCL board, or it runs a Mint program. Modbus requires a Mint program.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import ClassVar

from motionlang.cli.command import WrongOption, argument
from motionlang.hosts.commands.board import ServedBoard
from motionlang.hosts.commands.line import ServedLine
from motionlang.hosts.commands.output_queue import never_waiting
from motionlang.kernel import STDIN


@dataclass
class Serve(ServedBoard, ServedLine):
    """Let hosts talk to a virtual controller, or to a Mint program over Modbus."""

    removed: ClassVar[Mapping[str, str]] = {
        "can": "motionlang copley serve INTERFACE:CHANNEL puts drives on a bus",
        "mcapi": "motionlang mcapi serve --port HOST:PORT serves hosts that call MCAPI",
    }
    epilog: ClassVar[str] = """\
The board is a PMC controller with ASCII MCCL, which gets FILE first. A Mint
program has the serial line of its controller, without FILE after --lang mint.
Element n of a Mint program's memory is registers 2n (low half) and 2n + 1.

examples:
  motionlang serve --tcp 127.0.0.1:5010             then: nc 127.0.0.1 5010
  motionlang serve macros.mcl --tcp 5010 --pty --log
  motionlang serve packer.mnt --modbus 127.0.0.1:5020 --unit 1
  motionlang serve --tcp 0 --clock lockstep --set controller.model=dcx-pci300
"""
    file: str = argument(
        "FILE", "commands for the board, or a Mint program; - reads standard input", default=""
    )

    def check(self) -> None:
        """Raise WrongOption if what is served does not fit the addresses."""
        if not (self.tcp or self.pty or self.modbus):
            raise WrongOption("no address for hosts: give --tcp or --modbus with HOST:PORT, or --pty")
        super().check()
        if self.modbus is not None:
            self._check_modbus()

    def _check_modbus(self) -> None:
        lines = self.tcp or self.pty
        if (self.echo is not None or self.log) and not lines:
            raise WrongOption("--echo and --log need --tcp or --pty")
        if not self.file and not (lines and self._speaks_mint):
            raise WrongOption("--modbus needs a Mint program: motionlang serve FILE --modbus HOST:PORT")
        if not self._speaks_mint:
            raise WrongOption(
                "--modbus serves a Mint program; for a file with another extension add --lang mint"
            )

    @property
    def _speaks_mint(self) -> bool:
        return self.language is not None and self.language.name == "mint"

    def run(self) -> int:
        """Serve until a signal; return 0, 1 (an error) or 2 (wrong command line)."""
        if self.file not in ("", STDIN):
            self.known_language()
        source = self.source() if self.file else None
        with never_waiting() as queues:
            if self._speaks_mint and (self.tcp or self.pty):
                return self.serve_line(source, queues)
            if self.modbus is not None:
                assert source is not None
                return self.serve_modbus(source, queues)
            return self.serve_board(source, queues)
