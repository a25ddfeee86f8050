"""Build and test the playground and the site: `python -m tests.site [FOLDER]`.

The built site remains in FOLDER (default build/site). It is tested below a path of a plain file server, without
network access.
"""

from __future__ import annotations

import filecmp
import gzip
import os
import shutil
import subprocess
import sys
import threading
from functools import partial
from http.server import SimpleHTTPRequestHandler, ThreadingHTTPServer
from pathlib import Path

from tests.site import pages
from tests.site.check import problems
from tests.site.pages import build_name

ROOT = Path(__file__).parents[2]
PLAYGROUND = ROOT / "playground"
# How each of the two generators is started, and the path on the server below which its site is.
GENERATORS = {
    "zensical": ("zensical", "build", "--strict"),
    "mkdocs": ("mkdocs", "build", "--strict", "--quiet"),
}
BELOW = {"zensical": "some/path", "mkdocs": "other"}
MAX_MB, MAX_GZIP_MB = 17.0, 8.5


class Quiet(SimpleHTTPRequestHandler):
    """A plain file server that writes no log."""

    def log_message(self, *_: object) -> None:
        """Write nothing."""


class Server(ThreadingHTTPServer):
    """A file server that ignores a page that is closed while it loads."""

    def handle_error(self, *_: object) -> None:
        """Write nothing."""


def playground() -> None:
    """Install the packages of the lock file and build the playground."""
    for command in (["npm", "ci", "--no-audit", "--no-fund", "--loglevel=error"], ["npm", "run", "build"]):
        subprocess.run(
            command,
            cwd=PLAYGROUND,
            env={**os.environ, "PYTHON": sys.executable},
            check=True,
            stdout=subprocess.DEVNULL,
        )


def megabytes(folder: Path) -> tuple[float, float]:
    """Return the total size of a folder's files, plain and compressed by gzip, MB."""
    contents = [path.read_bytes() for path in folder.rglob("*") if path.is_file()]
    return sum(map(len, contents)) / 1e6, sum(len(gzip.compress(each, 9)) for each in contents) / 1e6


def build(folder: Path, *command: str) -> None:
    """Build the site with one of its generators into `folder`."""
    html = ROOT / "build" / "html"
    shutil.rmtree(html, ignore_errors=True)
    began = process_time_of_children()
    environment = {**os.environ, "MOTIONLANG_BUILD": build_name(), "NO_MKDOCS_2_WARNING": "1"}
    subprocess.run(
        [sys.executable, "-m", *command], cwd=ROOT, env=environment, check=True, stdout=subprocess.DEVNULL
    )
    print(f"{command[0]}: {process_time_of_children() - began:.1f} s of CPU time")
    shutil.copytree(html, folder)


def process_time_of_children() -> float:
    """Return the CPU time, s, of all child processes that have ended."""
    times = os.times()
    return times.children_user + times.children_system


def wrong_site(folder: Path) -> list[str]:
    """Return all errors in the links and files of a built site."""
    found = list(problems(folder))
    compared = filecmp.dircmp(PLAYGROUND / "dist", folder / "playground")
    found += [
        f"playground/{name} differs from the built one" for name in compared.left_only + compared.diff_files
    ]
    return found


def main(folder: Path) -> int:
    """Build and test everything; 1 if anything failed."""
    shutil.rmtree(folder, ignore_errors=True)
    print("== playground", flush=True)
    playground()
    plain, packed = megabytes(PLAYGROUND / "dist")
    print(f"{plain:.1f} MB, {packed:.1f} MB gzip")
    failed = plain > MAX_MB or packed > MAX_GZIP_MB
    print("== site", flush=True)
    pages.main()
    for name, command in GENERATORS.items():
        target = folder / BELOW[name]
        target.parent.mkdir(parents=True, exist_ok=True)
        build(target, *command)
        wrong = wrong_site(target)
        print("".join(f"{name}: {each}\n" for each in wrong), end="", flush=True)
        failed |= bool(wrong)
    print("== browsers", flush=True)
    return 1 if browsers(folder) or failed else 0


def browsers(folder: Path) -> bool:
    """Test the site in `folder` with the installed browsers; True if a test failed."""
    native = folder / "native.json"
    subprocess.run([sys.executable, "-m", "tests.site.native", str(native)], cwd=ROOT, check=True)
    with Server(("127.0.0.1", 0), partial(Quiet, directory=str(folder))) as server:
        threading.Thread(target=server.serve_forever, daemon=True).start()
        site = f"http://127.0.0.1:{server.server_port}/{BELOW['zensical']}/"
        environment = {
            **os.environ, "SITE": site, "PLAYGROUND": f"{site}playground/index.html", "NATIVE": str(native),
            "FOLDER": str(folder), "PYTHON": sys.executable,
        }  # fmt: skip
        tests = sorted(str(path) for path in (ROOT / "tests/site").glob("*.test.mjs"))
        command = ["node", "--test", "--test-concurrency=1", "--test-reporter=spec", *tests]
        status = subprocess.run(command, env=environment, check=False).returncode
        server.shutdown()
    return bool(status)


if __name__ == "__main__":
    sys.exit(main(Path(sys.argv[1] if len(sys.argv) > 1 else ROOT / "build" / "site").resolve()))
