"""`motionlang serve` for hosts on lines: addresses, output and the end."""

from __future__ import annotations

import signal
import sys
from dataclasses import dataclass
from types import FrameType
from typing import ClassVar, Protocol, TextIO

from motionlang.cli.command import Command, WrongOption, flag, option
from motionlang.cli.complaints import complain
from motionlang.cli.option_groups import ProgramOptions
from motionlang.cli.readers import real, whole
from motionlang.hosts.address import is_loopback, parse, shown
from motionlang.hosts.serve import Server
from motionlang.hosts.serve.server import MakeHost
from motionlang.kernel import Diagnostic

Address = tuple[str, int]


class Stoppable(Protocol):
    """A server that runs until it is stopped."""

    def run(self) -> None: ...

    def stop(self) -> None: ...


@dataclass
class Addresses(Command):
    """The addresses of ASCII hosts."""

    title: ClassVar[str] = "addresses"
    tcp: list[Address] = option(
        "HOST:PORT",
        "listen here; without HOST only this computer can connect, port 0 is any free port; may be repeated",
        read=parse,
        many=True,
    )
    pty: bool = flag("create a serial device, not on Windows, and print its path")
    max_hosts: int = option(
        "N",
        "maximum number of simultaneous connections (64)",
        read=whole("a number of connections from 1 to 1000", 1, 1000),
        default=64,
    )


@dataclass
class Time(Command):
    """The time of a served controller."""

    title: ClassVar[str] = "time"
    clock: str = option(
        "",
        "machine time passes in real time (the default), or only while a host waits",
        choices=("real", "lockstep"),
        default="real",
    )
    factor: float | None = option(
        "X",
        "run at X × real time, with --clock real (1)",
        read=real("a factor from 0.000001 to 1000000", 1e-6, 1e6),
    )
    step: float | None = option(
        "S",
        "machine time of a line, frame or request in lock step (0.01 s), or, on an MCCL board, the least of a line "
        "(0.001 s)",
        read=real("a time from 0 to 3600 seconds", 0.0, 3600.0),
    )

    def check(self) -> None:
        super().check()
        if self.factor is not None and self.clock != "real":
            raise WrongOption("--factor needs --clock real")
        if self.step is not None and self.clock != "lockstep":
            raise WrongOption("--step needs --clock lockstep")


@dataclass
class Lines(Command):
    """The lines of hosts."""

    title: ClassVar[str] = "lines"
    echo: bool | None = flag(
        "echo what hosts send; default: off for TCP, as the board for a serial device",
        default=None,
    )
    log: bool = flag("log commands and answers to standard error")


@dataclass
class Served(Addresses, Time, Lines, ProgramOptions):
    """A controller that is served to hosts."""

    def greet(self, title: str, axes: int) -> None:
        """Print what is served, and the time scale."""
        time = "in lock step" if self.clock == "lockstep" else "in real time"
        if self.factor:
            time += f", {self.factor:.10g} × real time"
        say(f"{title}, {axes} axes, {time}; Ctrl-C ends it\n")

    def open_lines(self, server: Server) -> str | None:
        """Open the lines for hosts and return what to print; None if one cannot be opened."""
        opened = ""
        for host, port in self.tcp:
            line = listen(server, host, port, echo=bool(self.echo))
            if line is None:
                return None
            opened += line
        if self.pty:
            try:
                opened += f"serial device {server.device(echo=self.echo)}\n"
            except ImportError as error:
                cannot("this system has no pseudo-terminals; use --tcp", error)
                return None
            except OSError as error:
                cannot("cannot create a serial device", error)
                return None
        return opened


def listen(
    server: Server, host: str, port: int, *, echo: bool = False, make: MakeHost | None = None, what: str = ""
) -> str | None:
    """Listen on an address and return what to print, with `what`; None if it cannot be used."""
    try:
        found, port = server.listen(host, port, echo, make)
    except (OSError, UnicodeError) as error:
        cannot(f"cannot listen on {shown(host, port)}", error)
        return None
    if not is_loopback(found):
        warn(
            f"warning: any computer that can reach this one can connect to {shown(found, port)}; there is "
            "no password"
        )
    return f"listening on {shown(found, port)}{what}\n"


def until_signal(server: Stoppable) -> None:
    """Serve until Ctrl-C or SIGTERM; both are a normal end."""

    def stop(number: int, frame: FrameType | None) -> None:
        server.stop()

    before = {number: signal.signal(number, stop) for number in (signal.SIGINT, signal.SIGTERM)}
    try:
        server.run()
    finally:
        for number, handler in before.items():
            signal.signal(number, handler)


def cannot(what: str, error: Exception, hint: str = "") -> None:
    """Report an address that cannot be served."""
    reason = getattr(error, "strerror", None) or str(error)
    complain([Diagnostic("address", f"{what}: {reason.lower()}", hint=hint)], None, "")


def say(text: str) -> None:
    """Write to standard output."""
    _write(sys.stdout, text)


def remark(text: str) -> None:
    """Write to standard error."""
    _write(sys.stderr, text)


def _write(stream: TextIO, text: str) -> None:
    """Write a text at once; ignore a closed pipe."""
    try:
        stream.write(text)
        stream.flush()
    except (OSError, ValueError):
        pass


def warn(text: str) -> None:
    """Write a remark of the command to standard error."""
    remark(f"motionlang serve: {text}\n")
