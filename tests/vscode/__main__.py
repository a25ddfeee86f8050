"""Use the extension in a real VS Code: `python -m tests.vscode [FOLDER]`.

VS Code is npm's code-server; playwright-core drives it in Chromium. `python -m tests.vscode --install` installs both
in FOLDER (default build/vscode) once, with the tools that package the extension. The pictures of the session remain
in FOLDER/pictures. If anything is not installed, the session is skipped and the reason is printed.
"""

from __future__ import annotations

import argparse
import json
import os
import shutil
import socket
import subprocess
import sys
import tempfile
import time
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

ROOT = Path(__file__).parents[2]
EXTENSION = ROOT / "editors" / "vscode"
# Later versions of code-server need Node 24.
PACKAGES = ("code-server@4.100.3", "playwright-core@1.63.0")
QUIET = ("--no-audit", "--no-fund", "--loglevel=error")
# The native modules that VS Code needs here: passwords, terminals, its log, the end of its parent.
NATIVE = ("node-pty", "@vscode/spdlog", "native-watchdog")
BROWSERS = ("chromium", "chromium-browser", "google-chrome")
SERVER = Path("node_modules", "code-server")
PROGRAM = ROOT / "scripts" / "mint" / "limit-recovery.mnt"
# How long VS Code may take to start, s.
PATIENCE = 120.0


def npm(folder: Path, *words: str, required: bool = True) -> None:
    subprocess.run(["npm", *words, *QUIET], cwd=folder, check=required, stdout=subprocess.DEVNULL)


def install(folder: Path) -> None:
    """Install code-server and build the packages that it needs.

    Its own scripts download files from elsewhere, so they are not run.
    """
    folder.mkdir(parents=True, exist_ok=True)
    (folder / "package.json").write_text('{"private": true}')
    npm(folder, "install", "--ignore-scripts", *PACKAGES)
    npm(folder, "rebuild", "argon2")
    server = folder / SERVER / "lib" / "vscode"
    for package in (server, server / "extensions"):
        npm(package, "install", "--ignore-scripts", "--omit=dev")
    npm(server, "rebuild", "--yes", *NATIVE)
    extension = folder / "extension"
    shutil.copytree(EXTENSION, extension, ignore=shutil.ignore_patterns("node_modules"), dirs_exist_ok=True)
    npm(extension, "install")


def browser() -> str:
    """Return the path of an installed Chromium; "" for none."""
    return next(filter(None, map(shutil.which, BROWSERS)), "")


def missing(folder: Path) -> str:
    """Return the reason why the session cannot run; "" if it can."""
    if shutil.which("node") is None:
        return "node is not installed"
    if not browser():
        return "Chromium is not installed"
    if not (folder / "extension" / "node_modules").is_dir():
        return f"there is no code-server in {folder}: python -m tests.vscode --install"
    return ""


def package(folder: Path) -> Path:
    """Package the present extension; return the VSIX."""
    extension = folder / "extension"
    shutil.copytree(EXTENSION, extension, ignore=shutil.ignore_patterns("node_modules"), dirs_exist_ok=True)
    npm(extension, "run", "package")
    npm(extension, "run", "test")
    return extension / "motionlang.vsix"


def workspace(home: Path) -> Path:
    """Write a program with a misspelt keyword, and the settings of the user."""
    folder = home / "gantry"
    folder.mkdir()
    wrong = PROGRAM.read_text(encoding="utf-8").replace("SPEED(0) = 300", "SPEDE(0) = 300")
    (folder / PROGRAM.name).write_text(wrong, encoding="utf-8")
    shutil.copy(PROGRAM.with_suffix(".machine.toml"), folder)
    settings = {
        "motionlang.python": sys.executable,
        "workbench.startupEditor": "none",
        "workbench.tips.enabled": False,
        "git.enabled": False,
        "files.autoSave": "off",
        "terminal.integrated.gpuAcceleration": "off",  # so that its text is in the page
    }
    user = home / "data" / "User"
    user.mkdir(parents=True)
    (user / "settings.json").write_text(json.dumps(settings), encoding="utf-8")
    return folder


@contextmanager
def running(folder: Path, home: Path, vsix: Path) -> Iterator[int]:
    """Yield the port of a running VS Code with the extension."""
    with socket.create_server(("127.0.0.1", 0)) as free:
        port: int = free.getsockname()[1]
    environment = {**os.environ, "XDG_CONFIG_HOME": str(home), "PYTHONPATH": str(ROOT)}
    command = [
        "node",
        str(folder / SERVER / "out" / "node" / "entry.js"),
        "--user-data-dir",
        str(home / "data"),
    ]
    command += ["--extensions-dir", str(home / "extensions")]
    pipe = subprocess.DEVNULL
    subprocess.run([*command, "--install-extension", str(vsix)], env=environment, stdout=pipe, check=True)
    command += ["--auth", "none", "--bind-addr", f"127.0.0.1:{port}", "--disable-telemetry"]
    command += ["--disable-update-check", "--disable-workspace-trust"]
    with subprocess.Popen(command, env=environment, stdout=pipe, stderr=pipe) as server:
        try:
            _wait_for(port)
            yield port
        finally:
            server.terminate()


def _wait_for(port: int) -> None:
    end = time.monotonic() + PATIENCE
    while time.monotonic() < end:
        try:
            with socket.create_connection(("127.0.0.1", port), 1.0):
                return
        except OSError:
            time.sleep(0.1)
    raise SystemExit(f"VS Code does not answer within {PATIENCE:g} s")


def main() -> int:
    """Install, or run the session; return 1 if it failed."""
    parser = argparse.ArgumentParser(prog="tests.vscode", description=__doc__)
    parser.add_argument("folder", nargs="?", type=Path, default=ROOT / "build" / "vscode")
    parser.add_argument("--install", action="store_true")
    arguments = parser.parse_args()
    folder = arguments.folder.resolve()
    if arguments.install:
        install(folder)
        return 0
    why = missing(folder)
    if why:
        print(f"skipped: {why}")
        return 0
    vsix = package(folder)
    with tempfile.TemporaryDirectory() as home:
        program = workspace(Path(home))
        with running(folder, Path(home), vsix) as port:
            environment = {
                **os.environ,
                "CHROMIUM": browser(),
                "FOLDER": str(folder),
                "PROGRAM": str(program / PROGRAM.name),
                "URL": f"http://127.0.0.1:{port}/?folder={program}",
            }
            script = Path(__file__).with_name("session.test.mjs")
            command = ["node", "--test", "--test-reporter=spec", str(script)]
            return subprocess.run(command, env=environment, check=False).returncode


if __name__ == "__main__":
    sys.exit(main())
