"""`motionlang mcapi`: build PMC's host library, serve hosts, run programs, log, replay."""

from __future__ import annotations

import os
import shlex
import sys
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path
from typing import BinaryIO, ClassVar

from motionlang.cli.command import Command, WrongOption, argument, option
from motionlang.cli.option_groups import ProgramOptions
from motionlang.cli.readers import real
from motionlang.hosts.address import parse, shown
from motionlang.hosts.commands.board import ServedBoard
from motionlang.hosts.commands.options import Address, listen
from motionlang.hosts.commands.output_queue import never_waiting
from motionlang.hosts.mccl.console import Console
from motionlang.hosts.serve import Server
from motionlang.kernel import STDIN, Rejected
from motionlang_mcapi.build import TARGETS, CannotBuild, build
from motionlang_mcapi.host import mcapi_hosts
from motionlang_mcapi.listing import CallListing
from motionlang_mcapi.log import BadLog, model_of, read
from motionlang_mcapi.replay import call_of, replay_file
from motionlang_mcapi.run import McapiRun, environment, library, refused

_NOT_NEGATIVE = real("a number, 0 or more", 0.0, 1e6)


@dataclass
class TargetOptions(Command):
    """The system of the library."""

    target: str = option(
        "", "the system that the library is for (linux)", choices=tuple(TARGETS), default="linux"
    )


@dataclass
class McapiBuild(TargetOptions):
    """Compile the C library into the user's cache."""

    out: str | None = option("DIR", "put the library into this folder instead")

    def run(self) -> int:
        """Compile the library and print its path."""
        try:
            path = build(TARGETS[self.target], Path(self.out) if self.out is not None else None)
        except CannotBuild as problem:
            raise refused(str(problem), problem.hint) from None
        print(path)
        return 0


@dataclass
class McapiPath(TargetOptions):
    """Print where the compiled C library is."""

    epilog: ClassVar[str] = """\
examples:
  motionlang mcapi path
  eval "$(motionlang mcapi path --env 127.0.0.1:4410)"     then: ./host
"""
    env: Address | None = option(
        "HOST:PORT",
        "print the exports by which a host that you start finds the library and, if its address is given, the board",
        read=parse,
        const=("", 0),
    )

    def check(self) -> None:
        super().check()
        if self.env is not None and self.target != "linux":
            raise WrongOption("--env is for Linux; on Windows copy the DLL next to the program")

    def run(self) -> int:
        """Print the path of the library, or the exports for a host."""
        path = library(self.target)
        if self.env is None:
            print(path)
            return 0
        host, port = self.env
        for name, value in environment(os.environ, shown(host, port) if host else "", path).items():
            print(f"export {name}={shlex.quote(value)}")
        return 0


@dataclass
class McapiLog(Command):
    """Print a log of calls as MCCL with times."""

    file: str = argument("FILE", "the log")

    def run(self) -> int:
        """Print a log as MCCL."""
        with _opened(self.file) as file:
            listing = CallListing(model_of(file))
            file.seek(0)
            for entry in read(file):
                sys.stdout.write(listing.line(entry) + "\n")
        return 0


@dataclass
class McapiReplay(ProgramOptions):
    """Carry out a log of calls in virtual time and compare the answers."""

    title: ClassVar[str] = "comparison"
    file: str = argument("FILE", "the log")
    skew: float = option(
        "S",
        "how far the times of the log may be from those here, in seconds (0.01)",
        read=_NOT_NEGATIVE,
        default=0.01,
    )
    tolerance: float = option(
        "COUNTS",
        "how far a position may be from the one here, in counts (0)",
        read=_NOT_NEGATIVE,
        default=0.0,
    )

    def run(self) -> int:
        """Replay a log; 1 if it differs."""
        settings = self.settings()
        with _opened(self.file) as file:
            model = model_of(file)
            own = settings.get("controller.model", model)
            if model and own != model:
                print(f"note: the log is of a {model}, this board is a {own}", file=sys.stderr)
            try:
                replay = replay_file(self.file, settings, self.skew, self.tolerance)
            except Rejected as rejected:
                raise refused(rejected.message, rejected.hint) from None
        first = replay.first
        if first is not None:
            name = os.path.basename(self.file)
            print(f"{name}:{first.entry.line}: at {first.entry.begin:.6f} s: {first.text}")
            print(f"  {call_of(first.entry)}")
        print(replay.summary)
        return 1 if first is not None else 0


@dataclass
class McapiServe(ServedBoard):
    """Let hosts that call MCAPI talk to a virtual board."""

    title: ClassVar[str] = "addresses"
    epilog: ClassVar[str] = """\
The board gets FILE first. ASCII hosts may talk to it, too.

examples:
  motionlang mcapi serve --port 4410                then: ./host
  motionlang mcapi serve macros.mcl --port 4410 --tcp 5010 --log
"""
    file: str = argument("FILE", "commands for the board; - reads standard input", default="")
    port: Address | None = option(
        "HOST:PORT",
        "listen here for hosts that call MCAPI; without HOST only this computer can connect, port 0 is any free port",
        read=parse,
    )

    def check(self) -> None:
        super().check()
        if self.port is None:
            raise WrongOption("no address for hosts: give --port HOST:PORT")
        if self.language is not None and self.language.name == "mint":
            raise WrongOption("mcapi serves an MCCL board; motionlang serve has the line of a Mint program")

    def open_board(self, server: Server, console: Console) -> str | None:
        assert self.port is not None
        opened = self.open_lines(server)
        if opened is None:
            return None
        line = listen(server, *self.port, make=mcapi_hosts(server, console), what=" for MCAPI")
        return None if line is None else opened + line

    def run(self) -> int:
        """Serve until a signal; return 0, 1 (an error) or 2 (wrong command line)."""
        if self.file not in ("", STDIN):
            self.known_language()
        with never_waiting() as queues:
            return self.serve_board(self.source() if self.file else None, queues)


class McapiCommand(Command):
    """Run hosts of PMC boards as they are: build MCAPI, record and replay calls."""

    commands: ClassVar = {
        "build": (McapiBuild, "compile the C library into the user's cache"),
        "path": (McapiPath, "print where the compiled C library is"),
        "serve": (McapiServe, "let hosts that call MCAPI talk to a virtual board"),
        "run": (McapiRun, "run a host program as it is on a virtual board"),
        "log": (McapiLog, "print a log of calls as MCCL with times"),
        "replay": (McapiReplay, "carry out a log of calls in virtual time and compare the answers"),
    }


@contextmanager
def _opened(log: str) -> Iterator[BinaryIO]:
    """Open a log; Refused if it cannot be read."""
    try:
        with open(log, "rb") as file:
            yield file
    except BadLog as problem:
        raise refused(f"{log}:{problem.line}: {problem}", "record it again") from None
    except OSError as error:
        if error.filename is None:  # of standard output: `main` reports it
            raise
        raise refused(f"{log}: {error.strerror or error}", "name a log that --record has written") from None
