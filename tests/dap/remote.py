"""A client of `motionlang dap` as a process whose engine makes many copies.

    python -m tests.dap.remote

runs this process.
"""

from __future__ import annotations

import subprocess
import sys
import threading
from typing import Any

from motionlang.dap.framing import read, written
from motionlang.dap.server import serve_stdio
from motionlang.debug import checkpoints
from tests.dap.client import PATIENCE, Client


class Remote(Client):
    """A client of a process; `process` is the front end."""

    def __init__(self) -> None:
        super().__init__()
        pipe = subprocess.PIPE
        self.process = subprocess.Popen(
            [sys.executable, "-m", "tests.dap.remote"], stdin=pipe, stdout=pipe, stderr=pipe
        )
        self.adapter: Any = self
        self._reader = threading.Thread(target=self._read, daemon=True)
        self._reader.start()

    def handle(self, message: dict[str, Any]) -> None:
        """Send a message to the process, like to an adapter."""
        assert self.process.stdin is not None
        self.process.stdin.write(written(message))
        self.process.stdin.flush()

    def _read(self) -> None:
        assert self.process.stdout is not None
        while (message := read(self.process.stdout)) is not None:
            self._receive(message)

    def close(self) -> None:
        """Disconnect; the process must end without an error."""
        super().close()
        assert self.finish() == (0, b"")

    def finish(self) -> tuple[int, bytes]:
        """Close the stream to the process; return its exit status and error output."""
        process = self.process
        assert process.stdin is not None
        assert process.stdout is not None
        assert process.stderr is not None
        process.stdin.close()
        self._reader.join(PATIENCE)
        errors = process.stderr.read()
        for stream in (process.stdout, process.stderr):
            stream.close()
        return process.wait(PATIENCE), errors


if __name__ == "__main__":
    # A copy every millisecond, so that quick programs have some.
    checkpoints.INTERVAL = 0.001
    checkpoints.SLOW = 1
    serve_stdio()
