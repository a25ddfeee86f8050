"""Build and test the playground: `python -m tests.site [FOLDER]`.

What was built stays in FOLDER (build/site). Tests are run on it below a path of a plain file server, without a
network.
"""

from __future__ import annotations

import gzip
import os
import shutil
import subprocess
import sys
import threading
from functools import partial
from http.server import SimpleHTTPRequestHandler, ThreadingHTTPServer
from pathlib import Path

ROOT = Path(__file__).parents[2]
PLAYGROUND = ROOT / "playground"
# The path on the server below which the site is.
BELOW = "some/path"
MAX_MB, MAX_GZIP_MB = 17.0, 8.5


class Quiet(SimpleHTTPRequestHandler):
    """A plain file server without a log."""

    def log_message(self, *_: object) -> None:
        """Write nothing."""


class Server(ThreadingHTTPServer):
    """A file server that does not mind a page that is closed while it loads."""

    def handle_error(self, *_: object) -> None:
        """Write nothing."""


def playground() -> None:
    """Install what the lock file names and build the playground."""
    for command in (["npm", "ci", "--no-audit", "--no-fund", "--loglevel=error"], ["npm", "run", "build"]):
        subprocess.run(
            command,
            cwd=PLAYGROUND,
            env={**os.environ, "PYTHON": sys.executable},
            check=True,
            stdout=subprocess.DEVNULL,
        )


def megabytes(folder: Path) -> tuple[float, float]:
    """Return the size of all files of a folder, and that of each compressed by gzip."""
    contents = [path.read_bytes() for path in folder.rglob("*") if path.is_file()]
    return sum(map(len, contents)) / 1e6, sum(len(gzip.compress(each, 9)) for each in contents) / 1e6


def main(folder: Path) -> int:
    """Build and test everything; 1 if anything failed."""
    shutil.rmtree(folder, ignore_errors=True)
    below = folder / BELOW
    below.parent.mkdir(parents=True)
    print("== playground", flush=True)
    playground()
    plain, packed = megabytes(PLAYGROUND / "dist")
    print(f"{plain:.1f} MB, {packed:.1f} MB gzip")
    shutil.copytree(PLAYGROUND / "dist", below / "playground")
    failed = plain > MAX_MB or packed > MAX_GZIP_MB
    print("== browsers", flush=True)
    native = folder / "native.json"
    subprocess.run([sys.executable, "-m", "tests.site.native", str(native)], cwd=ROOT, check=True)
    with Server(("127.0.0.1", 0), partial(Quiet, directory=str(folder))) as server:
        threading.Thread(target=server.serve_forever, daemon=True).start()
        site = f"http://127.0.0.1:{server.server_port}/{BELOW}/"
        environment = {
            **os.environ, "SITE": site, "PLAYGROUND": f"{site}playground/index.html", "NATIVE": str(native),
            "FOLDER": str(folder),
        }  # fmt: skip
        tests = sorted(str(path) for path in (ROOT / "tests/site").glob("*.test.mjs"))
        command = ["node", "--test", "--test-concurrency=1", "--test-reporter=spec", *tests]
        failed |= bool(subprocess.run(command, env=environment, check=False).returncode)
        server.shutdown()
    print("== failed" if failed else "== all passed")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main(Path(sys.argv[1] if len(sys.argv) > 1 else ROOT / "build" / "site").resolve()))
