"""A newcomer's trial: `python -m tests.release.trial FOLDER WHEELS [SITE]`, without network access.

FOLDER is new. WHEELS has the wheel and those that it needs, SITE is the built site. Each step is printed as a line of
JSON with its time. The parent starts it in a network namespace of its own, where it has only the loopback
interface.
"""

from __future__ import annotations

import json
import os
import shutil
import socket
import struct
import subprocess
import sys
import tempfile
import threading
import time
from collections.abc import Callable, Iterator, Mapping
from functools import partial
from pathlib import Path

from tests.built import ROOT
from tests.release.artefacts import Row
from tests.site.__main__ import Quiet, Server

UNSHARE = ("unshare", "--net", "--map-root-user")
# ioctl requests and flags of Linux that switch an interface on.
SIOCGIFFLAGS, SIOCSIFFLAGS, IFF_UP = 0x8913, 0x8914, 1
INITIALIZE = {"jsonrpc": "2.0", "id": 1, "method": "initialize", "params": {"capabilities": {}}}
SHUTDOWN = {"jsonrpc": "2.0", "id": 2, "method": "shutdown"}
EXIT = {"jsonrpc": "2.0", "method": "exit"}


def check(folder: Path, wheel: Path, site: Path | None) -> Iterator[Row]:
    """Collect the wheels, then take the steps without network access, if this system can do that."""
    wheels = folder / "wheels"
    pip = [sys.executable, "-m", "pip", "wheel", "--quiet", "--disable-pip-version-check"]
    built = [str(wheel), *(str(next(folder.glob(f"motionlang_{name}-*.whl"))) for name in ("explore", "lsp"))]
    subprocess.run([*pip, "--wheel-dir", str(wheels), *built], check=True, stderr=subprocess.DEVNULL)
    alone = shutil.which("unshare") and not subprocess.run([*UNSHARE, "true"], check=False).returncode
    command = [*(UNSHARE if alone else ()), sys.executable, "-m", "tests.release.trial"]
    with tempfile.TemporaryDirectory() as scratch:
        places = [scratch, str(wheels), *([str(site)] if site else [])]
        ran = subprocess.run([*command, *places], cwd=ROOT, capture_output=True, text=True, check=False)
    for line in ran.stdout.splitlines():
        step, seconds = json.loads(line)
        yield Row(f"trial: {step}", "network off" if alone else "network on", None, seconds)
    assert ran.returncode == 0, ran.stderr


def loopback() -> None:
    """Switch on the loopback interface of a new network namespace."""
    from fcntl import ioctl

    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as anything:
        request = struct.pack("16sh14x", b"lo", 0)
        flags = struct.unpack("16sh14x", ioctl(anything, SIOCGIFFLAGS, request))[1]
        ioctl(anything, SIOCSIFFLAGS, struct.pack("16sh14x", b"lo", flags | IFF_UP))


def framed(*messages: Mapping[str, object]) -> str:
    """Return messages in the form of the language server protocol."""
    texts = [json.dumps(each) for each in messages]
    return "".join(f"Content-Length: {len(text)}\r\n\r\n{text}" for text in texts)


class Newcomer:
    """A user with a new home, who types commands in a new folder."""

    def __init__(self, folder: Path) -> None:
        self.work = folder / "work"
        self.work.mkdir()
        self.programs = folder / "env" / ("Scripts" if os.name == "nt" else "bin")
        kept = {name: os.environ[name] for name in ("PATH", "SYSTEMROOT", "TEMP") if name in os.environ}
        self.environment = {**kept, "HOME": str(folder), "PYTHONUTF8": "1"}

    def types(self, *words: str, given: str = "") -> str:
        """Return what a command prints; it must end with 0."""
        found = shutil.which(words[0], path=str(self.programs)) or words[0]
        ran = subprocess.run(
            [found, *words[1:]], cwd=self.work, env=self.environment, input=given, capture_output=True,
            text=True, encoding="utf-8", check=False,
        )  # fmt: skip
        assert ran.returncode == 0, (words, ran.stdout, ran.stderr)
        return ran.stdout

    def sees(self, shown: str, *words: str, given: str = "") -> None:
        """Check that a command prints a text."""
        printed = self.types("motionlang", *words, given=given)
        assert shown in printed, (words, printed)


def page(site: Path) -> None:
    """Run the first program of the playground in Chromium, from a plain file server below a path."""
    with tempfile.TemporaryDirectory() as name:
        Path(name, "some").mkdir()
        Path(name, "some", "path").symlink_to(site.resolve())
        with Server(("127.0.0.1", 0), partial(Quiet, directory=name)) as server:
            threading.Thread(target=server.serve_forever, daemon=True).start()
            address = f"http://127.0.0.1:{server.server_port}/some/path/"
            environment = os.environ | {"SITE": address, "PLAYGROUND": f"{address}playground/index.html"}
            script = str(Path(__file__).with_name("playground.mjs"))
            subprocess.run(["node", script], env=environment, check=True, stdout=sys.stderr)
            server.shutdown()


def steps(folder: Path, wheels: str, site: str = "") -> dict[str, Callable[[], object]]:
    """Return what the newcomer does, in order."""
    user = Newcomer(folder)
    pip = ("python", "-m", "pip", "install", "--quiet", "--disable-pip-version-check", "--no-index")
    move = "SPEED(0) = 50\nMOVER(0) = 5 : GO(0)\n.settle\nPRINT POS(0)\n"
    found: dict[str, Callable[[], object]] = {
        "python -m venv": lambda: user.types(sys.executable, "-m", "venv", str(folder / "env")),
        "pip install motionlang-explore motionlang-lsp": lambda: user.types(
            *pip, "--find-links", wheels, "motionlang-explore", "motionlang-lsp"
        ),
        "motionlang init --new feed": lambda: user.sees("feed.mnt", "init", "--new", "feed"),
        "motionlang run feed.mnt": lambda: user.sees("back at 0.0000 mm", "run", "feed.mnt"),
        "motionlang plot feed.mnt feed.html": lambda: user.types(
            "motionlang", "plot", "feed.mnt", "feed.html"
        ),
        "motionlang map feed.mnt -o map.html": lambda: user.types(
            "motionlang", "map", "feed.mnt", "-o", "map.html"
        ),
        "motionlang repl": lambda: user.sees("5.0000", "repl", given=move),
        "motionlang lsp, initialize": lambda: user.sees(
            '"capabilities"', "lsp", given=framed(INITIALIZE, SHUTDOWN, EXIT)
        ),
    }
    if site and shutil.which("node") and shutil.which("chromium"):
        found["the playground runs its program"] = lambda: page(Path(site))
    return found


def main(folder: str, *places: str) -> None:
    """Take the steps and print their times."""
    if os.name == "posix" and sys.platform == "linux" and os.getuid() == 0:
        loopback()
    for name, step in steps(Path(folder), *places).items():
        began = time.perf_counter()
        step()
        print(json.dumps([name, time.perf_counter() - began]), flush=True)


if __name__ == "__main__":
    main(*sys.argv[1:])
