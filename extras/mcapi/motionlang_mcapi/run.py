"""A host program run on a virtual board: its environment, end and recorded calls."""

from __future__ import annotations

import os
import shutil
import signal
import subprocess
import threading
from collections.abc import Callable, Mapping
from contextlib import ExitStack
from dataclasses import dataclass
from pathlib import Path
from typing import ClassVar

from motionlang.cli.command import Refused, argument, option
from motionlang.hosts.address import LOOPBACK, shown
from motionlang.hosts.commands.board import server_of
from motionlang.hosts.commands.options import Served, remark, say
from motionlang.hosts.serve import Server
from motionlang.hosts.serve.spy import Spy
from motionlang.kernel import Diagnostic
from motionlang_mcapi.build import TARGETS, default_path
from motionlang_mcapi.call import ApiCall
from motionlang_mcapi.host import mcapi_hosts
from motionlang_mcapi.log import CallRecorder

# Exit statuses of a shell.
NOT_EXECUTABLE, NOT_FOUND, KILLED = 126, 127, 128


@dataclass
class McapiRun(Served):
    """Run a host program as it is on a virtual board."""

    title: ClassVar[str] = "host"
    epilog: ClassVar[str] = """\
PROGRAM runs with MCAPI_HOST, LD_PRELOAD and LD_LIBRARY_PATH set, so that it
finds the library as it is. The exit status is that of PROGRAM.

examples:
  motionlang mcapi build
  motionlang mcapi run -- ./host
  motionlang mcapi run --record a.log -- yaqd-pmc --config stages.toml
"""
    program: list[str] = argument("PROGRAM", "the host program and its arguments, after --", many=True)
    record: str | None = option("FILE", "write every call with its answer into FILE", writes=True)

    def run(self) -> int:
        """Serve a board on a free port to a program; return the program's exit status."""
        server, console = server_of(self, None, Spy(remark) if self.log else None)
        with server, ExitStack() as files:
            path = library()
            record: Callable[[ApiCall], None] | None = None
            if self.record is not None:
                try:
                    file = files.enter_context(open(self.record, "w", encoding="latin-1", newline="\n"))
                except OSError as error:
                    raise refused(f"cannot write {self.record}: {error.strerror or error}") from None
                record = CallRecorder(file.write, console.board.model.name)
            address = server.listen(LOOPBACK, 0, make=mcapi_hosts(server, console, record))
            opened = self.open_lines(server)
            if opened is None:
                return 1
            say(opened)
            own = {**os.environ, **environment(os.environ, shown(*address), path)}
            return _run(server, self.program, own)


def refused(message: str, hint: str = "", status: int = 1) -> Refused:
    """Return the reason why a command of `mcapi` did nothing."""
    return Refused([Diagnostic("mcapi", message, hint=hint)], status=status)


def library(target: str = "linux") -> Path:
    """Return the path of the library; Refused if it has not been built."""
    found = default_path(TARGETS[target])
    if found is not None and found.exists():
        return found
    option = "" if target == "linux" else f" --target {target}"
    raise refused(
        "the library of this version has not been built", f"motionlang mcapi build{option} compiles it"
    )


def environment(own: Mapping[str, str], address: str, library: Path) -> dict[str, str]:
    """Return the variables by which a program finds the board and the library; `own` has the present ones."""
    found: dict[str, str] = {"MCAPI_HOST": address} if address else {}
    found["LD_PRELOAD"] = ":".join([str(library), *filter(None, [own.get("LD_PRELOAD")])])
    found["LD_LIBRARY_PATH"] = ":".join([str(library.parent), *filter(None, [own.get("LD_LIBRARY_PATH")])])
    return found


def _run(server: Server, program: list[str], environment: dict[str, str]) -> int:
    """Run the program and serve until it ends."""
    name = program[0]
    if shutil.which(name) is None:
        if os.path.exists(name):
            raise refused(f"{name} is not a program that can be run", status=NOT_EXECUTABLE)
        raise refused(f"there is no program {name}", status=NOT_FOUND)
    try:
        child = subprocess.Popen(program, env=environment)
    except OSError as error:
        raise refused(f"cannot run {name}: {error.strerror or error}", status=NOT_EXECUTABLE) from None

    def wait() -> None:
        child.wait()
        server.stop()

    def forward(number: int, frame: object) -> None:
        if child.poll() is None:
            child.send_signal(number)

    # Ctrl-C reaches the program by itself; the board is served until the program has ended.
    before = {
        signal.SIGINT: signal.signal(signal.SIGINT, signal.SIG_IGN),
        signal.SIGTERM: signal.signal(signal.SIGTERM, forward),
    }
    watcher = threading.Thread(target=wait, daemon=True)
    watcher.start()
    try:
        server.run()
    finally:
        for number, handler in before.items():
            signal.signal(number, handler)
    watcher.join()
    status = child.returncode
    return status if status >= 0 else KILLED - status
