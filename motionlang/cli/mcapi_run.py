"""A host program run on a virtual board: its environment, end and recorded calls."""

from __future__ import annotations

import os
import shutil
import signal
import subprocess
import sys
import threading
from contextlib import ExitStack
from glob import glob
from typing import TYPE_CHECKING

from motionlang.cli.complaints import complain
from motionlang.cli.serve_board import mcapi_hosts, server_of
from motionlang.cli.serve_hosts import open_lines, remark, say
from motionlang.errors import Diagnostic
from motionlang.serve.address import LOOPBACK, shown
from motionlang.serve.spy import Spy

if TYPE_CHECKING:
    import argparse
    from collections.abc import Callable, Mapping
    from pathlib import Path

    from motionlang.cli.options import Options
    from motionlang.mcapi.call import Call
    from motionlang.serve import Server

# Exit statuses of a shell.
NOT_EXECUTABLE, NOT_FOUND, KILLED = 126, 127, 128
FAKETIME = (
    "/usr/lib/*/faketime/libfaketime.so.1",
    "/usr/*/lib/faketime/libfaketime.so.1",
    "/usr/lib/faketime/libfaketime.so.1",
)


def run_host(args: argparse.Namespace, options: Options, library: Path) -> int:
    """Serve a board on a free port to a program; return the program's exit status."""
    from motionlang.mcapi.log import Recorder

    spy = Spy(remark) if args.log else None
    made = server_of(args, None, options.settings, options.overrides, spy)
    if made is None:
        return 1
    server, console = made
    with server, ExitStack() as files:
        record: Callable[[Call], None] | None = None
        if args.record is not None:
            try:
                file = files.enter_context(open(args.record, "w", encoding="latin-1", newline="\n"))
            except OSError as error:
                return _cannot(f"cannot write {args.record}: {error.strerror or error}")
            record = Recorder(file.write, console.board.model.name)
        address = server.listen(LOOPBACK, 0, make=mcapi_hosts(server, console, record))
        opened = open_lines(server, args)
        if opened is None:
            return 1
        say(opened)
        host_environment = {**os.environ, **environment(os.environ, shown(*address), library, args.factor)}
        return _run(server, args, host_environment)


def environment(
    own: Mapping[str, str], address: str, library: Path, factor: float | None = None
) -> dict[str, str]:
    """Return the variables by which a program finds the board and the library; `own` has the present ones."""
    found: dict[str, str] = {"MCAPI_HOST": address} if address else {}
    preload = [str(library)]
    if factor is not None:
        fake = next((path for pattern in FAKETIME for path in sorted(glob(pattern))), None)
        if fake is None:
            print(
                "motionlang mcapi: libfaketime is not installed: the clock of the program runs at its own speed",
                file=sys.stderr,
            )
        else:
            preload.append(fake)
            found["FAKETIME"] = f"+0 x{factor:.10g}"
    found["LD_PRELOAD"] = ":".join([*preload, *filter(None, [own.get("LD_PRELOAD")])])
    found["LD_LIBRARY_PATH"] = ":".join([str(library.parent), *filter(None, [own.get("LD_LIBRARY_PATH")])])
    return found


def _run(server: Server, args: argparse.Namespace, environment: dict[str, str]) -> int:
    """Run the program and serve until it ends."""
    name = args.program[0]
    if shutil.which(name) is None:
        missing = not os.path.exists(name)
        _cannot(f"there is no program {name}" if missing else f"{name} is not a program that can be run")
        return NOT_FOUND if missing else NOT_EXECUTABLE
    try:
        child = subprocess.Popen(args.program, env=environment)
    except OSError as error:
        _cannot(f"cannot run {name}: {error.strerror or error}")
        return NOT_EXECUTABLE

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


def _cannot(message: str) -> int:
    complain([Diagnostic("mcapi", message)], None, "")
    return 1
