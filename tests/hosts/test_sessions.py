r"""What hosts send to a controller or a board, and what comes back: `sessions_mint.txt`, `sessions_mccl.txt`.

`== title` begins a session. In it, `: ` is a line of the program, `@ ` the model and the echo, `> ` what a host sends
until the line is carried out, `+ ` what it sends meanwhile, `~ ` the seconds that pass, `. ` that the host leaves, and
`< ` what it receives. Characters are escaped as in Python, `\x20` is a blank at an end, and a number in front is that
of another host. `pytest --update` rewrites what is received.
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from functools import partial
from pathlib import Path
from typing import Any

from motionlang.hosts.mccl.console import Console
from motionlang.hosts.mint.console import MintConsole
from motionlang.kernel import Machine, Source
from tests.cases import repeat, sessions

FILES = sorted(Path(__file__).parent.glob("sessions_*.txt"))
MODELS = {"mint": "NextMove ESB-2", "mccl": "multiflex"}
LINE = re.compile(r"(\d*)([:@>+~.<]) ?(.*)")


class Hosts:
    """A console and its hosts by name; "" is the first one, which is there from the beginning."""

    def __init__(self, language: str, program: str, model: str, echo: bool | None) -> None:
        self.console: Any
        if language == "mint":
            self.console = MintConsole({"controller.model": model})
            if program:
                self.console.load(Source("served.mnt", program))
        else:
            self.console = Console(Machine({"controller.model": model}, first_axis=1))
        self.echo = echo
        self.ports: dict[str, Any] = {}
        self.port("")

    def port(self, host: str) -> Any:
        if host not in self.ports:
            self.ports[host] = self.console.open(self.echo)
        return self.ports[host]

    def do(self, host: str, mark: str, text: str) -> None:
        if mark == "~":
            self.console.run(self.console.now + float(text))
        elif mark == ".":
            self.console.close(self.ports.pop(host))
        else:
            self.port(host).feed(text.encode().decode("unicode_escape").encode("latin-1"))
            if mark == ">":
                self.console.settle(self.console.now + 10.0)

    def received(self) -> Iterator[str]:
        for host, port in self.ports.items():
            text = port.take().decode("latin-1").encode("unicode_escape").decode()
            if text:
                text = re.sub(" $", r"\\x20", text)
                yield f"{host}< {text}\n"


def replayed(language: str, session: str) -> str:
    """Return a session with what its hosts receive now."""
    lines = [LINE.fullmatch(line) for line in session.splitlines()]
    program = "\n".join(line[3] for line in lines if line and line[2] == ":")
    options = [line[3] for line in lines if line and line[2] == "@"]
    echo = True if "echo" in options else None if "its own echo" in options else False
    models = [each for each in options if "echo" not in each]
    hosts = Hosts(language, program, models[0] if models else MODELS[language], echo)
    shown = []
    for text, line in zip(session.splitlines(), lines, strict=True):
        if line is None or line[2] != "<":
            shown.append(text + "\n")
        if line is not None and line[2] in ">+~.":
            hosts.do(line[1], line[2], line[3])
            shown.extend(hosts.received())
    return "".join(shown)


@sessions(*FILES)
def test_hosts_receive_what_is_written(path: Path, session: str, update: bool) -> None:
    repeat(path, session, partial(replayed, path.stem.partition("_")[2]), update)
