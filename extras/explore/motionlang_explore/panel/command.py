"""`motionlang panel`: operate the machine of a program in a browser."""

from __future__ import annotations

import os
import sys
import webbrowser
from collections.abc import Mapping
from dataclasses import dataclass
from threading import Thread
from typing import ClassVar

from motionlang.cli.command import Refused, WrongOption, argument, flag, option
from motionlang.cli.readers import whole
from motionlang.cli.run_command import Prepared
from motionlang.kernel import STDIN, CheckedSettings, Diagnostic, Program, Terminated
from motionlang.kernel.files import reason
from motionlang.processes.workers import Workers
from motionlang_explore.panel.roles import roles_of


@dataclass
class PanelCommand(Prepared):
    """Operate the machine of a program in a browser."""

    title: ClassVar[str] = "page"
    epilog: ClassVar[str] = """\
The page has a switch for each input, a lamp for each output, a bar for each
axis and the terminal of the program, shows the line that runs, and says which
input the program waits for. "Save" writes what was done by hand as a scenario
into FILE.scenarios, which motionlang verify runs again. Only this computer can
open the address. Ctrl-C ends it.

exit status: 0 ended by Ctrl-C; 1 the program has an error, or the port is in
use; 2 the command line is invalid

examples:
  motionlang panel packer.prg --open
  motionlang panel packer.prg --port 8080 --input 2=out4+0.3
"""
    file: str = argument("FILE", "the program")
    open: bool = flag("open the page in the browser")
    port: int = option(
        "N",
        "the port of the page; default: any free one",
        read=whole("a port from 0 to 65535", 0, 65535),
        default=0,
    )

    def check(self) -> None:
        super().check()
        if self.file == STDIN:
            raise WrongOption("panel reads a file, which it watches for changes: save the program first")

    def run(self) -> int:
        from motionlang_explore.panel.server import PanelServer  # needs numpy, which the help does not
        from motionlang_explore.panel.session import PanelSession

        machine = self.machine_path()
        watched = [self.file, machine or os.path.splitext(self.file)[0] + ".machine.toml"]
        workers = Workers(1)
        session = PanelSession(
            self._load,
            self.file,
            watched,
            self.overrides(),
            lambda source, settings: workers.submit(roles_of, source, settings),
        )
        try:
            server = PanelServer(session, self.port)
        except OSError as error:
            session.close()
            hint = "leave out --port, which takes any free one"
            found = Diagnostic("address", f"port {self.port} cannot be used: {reason(error)}", hint=hint)
            raise Refused([found]) from None
        sys.stdout.write(f"{server.address}\nopen this address in a browser; Ctrl-C ends the panel\n")
        sys.stdout.flush()
        if self.open and not (_has_display() and webbrowser.open(server.address)):
            sys.stderr.write("note: --open finds no browser here\n")
        thread = Thread(target=server.serve, daemon=True)
        thread.start()
        try:
            while thread.is_alive():
                thread.join(0.5)  # a wait without an end would not notice Ctrl-C on Windows
        except (KeyboardInterrupt, Terminated):
            pass
        server.stop()
        workers.stop()
        return 0

    def _load(self) -> tuple[Program, Mapping[str, object]]:
        """Return the program and the settings of its machine, with the model that its text is written for."""
        program, settings = self.prepared(is_debug=True)
        model = program.target.model
        if model and "controller.model" not in settings:
            settings = CheckedSettings({**settings, "controller.model": model})
            program = program.on(settings)
        if program.errors:
            raise Refused(program.errors, file=self.file, source=program.source)
        return program, settings


def _has_display() -> bool:
    """True if a browser could have a window; without one, Python would start a browser in the terminal."""
    return sys.platform in ("win32", "darwin") or any(map(os.environ.get, ("DISPLAY", "WAYLAND_DISPLAY")))
