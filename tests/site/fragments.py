"""A program as the fragment of a link (after `#`), as in `playground/share.js`."""

from __future__ import annotations

import base64
import json
import zlib


def fragment(dialect: str, program: str, name: str = "", machine: str = "") -> str:
    """Return the fragment of a program."""
    name = name or ("example.mnt" if dialect == "mint" else "example.mcl")
    shared = {"name": name, "dialect": dialect, "program": program, "machine": machine}
    packed = zlib.compressobj(9, wbits=-zlib.MAX_WBITS)
    data = packed.compress(json.dumps(shared, ensure_ascii=False).encode()) + packed.flush()
    return "v1." + base64.urlsafe_b64encode(data).decode().rstrip("=")
