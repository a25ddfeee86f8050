"""The output of `motionlang` without a command: next steps for this folder."""

from __future__ import annotations

import os
from shlex import quote

from motionlang.kernel import MACHINE_SUFFIX, dialect_of
from motionlang.views.terminal import printable

# The most programs that are named, and the most files that are read.
MAX_NAMED, MAX_FILES = 3, 10_000


def welcome() -> str:
    """Return the text; in a folder with programs it has commands for the first one."""
    found = _programs()
    lines = ["motionlang runs Mint and MCCL motion programs without the controller.", ""]
    if found:
        first = _quoted(found[0])
        more = f" and {len(found) - MAX_NAMED} more" if len(found) > MAX_NAMED else ""
        lines += [f"this folder has {', '.join(map(printable, found[:MAX_NAMED]))}{more}", ""]
        steps = [(f"run {first}", "run it and report what it did"), (f"check {first}", "find its errors")]
        if not os.path.exists(os.path.splitext(found[0])[0] + MACHINE_SUFFIX):
            steps.append((f"init {first}", "write a machine file for it"))
    else:
        steps = [
            ("init --new feed", "write a small program with its machine file"),
            ("init OLD.PRG", "write a machine file for a program that you have"),
            ("run PICK.MNT", "run a program"),
        ]
    steps += [("repl", "type a program line by line"), ("--help", "list all commands")]
    width = max(len(step) for step, _ in steps)
    lines += [f"  motionlang {step:<{width}}  {what}" for step, what in steps]
    return "\n".join(lines) + "\n"


def _programs() -> list[str]:
    """Return the programs of this folder by name; none if it cannot be read."""
    try:
        with os.scandir() as entries:
            names = sorted(entry.name for entry, _ in zip(entries, range(MAX_FILES), strict=False))
    except OSError:
        return []
    return [name for name in names if dialect_of(name) is not None and os.path.isfile(name)]


def _quoted(name: str) -> str:
    return quote(printable(name))
