"""Drawing of docs/images/scope.png: `python -m tools.scope_picture`.

It needs Chromium. The picture shows the scope page of a gallery program with two cursors. It contains a
digest of the program, so that a test detects a picture of an older version.
"""

from __future__ import annotations

import hashlib
import os
import shutil
import struct
import subprocess
import sys
import tempfile
import zlib
from pathlib import Path

ROOT = Path(__file__).parent.parent
PICTURE = ROOT / "docs" / "images" / "scope.png"
PROGRAM = ROOT / "scripts" / "mint" / "pick-and-place.mnt"
WIDTH, HEIGHT = 1300, 816
# Seconds of the cursors and of the pointer.
CURSORS, POINTER = (0.7, 3.85), 5.0
BROWSERS = ("chromium", "chromium-browser", "google-chrome")
KEYWORD = b"Program digest"
_SIGNATURE = b"\x89PNG\r\n\x1a\n"


def digest() -> bytes:
    """Return the digest of the program in the form that the picture stores."""
    return hashlib.sha256(PROGRAM.read_text(encoding="utf-8").encode()).hexdigest().encode()


def recorded(png: bytes) -> bytes | None:
    """Return the digest stored in a picture, or None."""
    assert png.startswith(_SIGNATURE)
    start = len(_SIGNATURE)
    while start < len(png):
        length, kind = struct.unpack(">I4s", png[start : start + 8])
        body = png[start + 8 : start + 8 + length]
        if kind == b"tEXt" and body.startswith(KEYWORD + b"\0"):
            return body.removeprefix(KEYWORD + b"\0")
        start += 12 + length
    return None


def with_digest(png: bytes) -> bytes:
    """Return a picture with the digest of the program inserted after its header."""
    body = b"tEXt" + KEYWORD + b"\0" + digest()
    chunk = struct.pack(">I", len(body) - 4) + body + struct.pack(">I", zlib.crc32(body))
    head = len(_SIGNATURE) + 25
    return png[:head] + chunk + png[head:]


def main() -> int:
    """Draw the picture; return 1 if there is no browser."""
    browser = next(filter(None, map(shutil.which, BROWSERS)), None)
    if browser is None:
        print("no Chromium is installed", file=sys.stderr)
        return 1
    with tempfile.TemporaryDirectory() as folder:
        page, png = Path(folder) / "page.html", Path(folder) / "page.png"
        command = [
            sys.executable,
            "-m",
            "motionlang",
            "plot",
            PROGRAM.name,
            str(page),
        ]
        subprocess.run(
            command,
            check=True,
            capture_output=True,
            cwd=PROGRAM.parent,
            env=os.environ | {"PYTHONPATH": str(ROOT)},
        )
        script = f"<script>marks.push{CURSORS}; pointer = {POINTER}; drawCursor();</script>"
        page.write_text(page.read_text(encoding="utf-8") + script, encoding="utf-8")
        how = ("--headless=new", "--no-sandbox", "--disable-gpu", "--hide-scrollbars")
        size = f"--window-size={WIDTH},{HEIGHT}"
        command = [browser, *how, size, f"--screenshot={png}", page.as_uri()]
        subprocess.run(command, check=True, capture_output=True, timeout=120)
        PICTURE.write_bytes(with_digest(png.read_bytes()))
    return 0


if __name__ == "__main__":
    sys.exit(main())
