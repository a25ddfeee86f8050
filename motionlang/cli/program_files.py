"""The programs that a command line names: files, and folders of files."""

from __future__ import annotations

import os
from collections.abc import Sequence

from motionlang.kernel import dialect, dialects

# What a command line may name, for help.
PATHS = "programs, or folders of programs; default: this folder"


def programs(paths: Sequence[str]) -> list[str]:
    """Return the programs among the paths; those of a folder by extension, in order.

    One of several folders is returned itself if it has no programs, so that the command names it.
    """
    found: list[str] = []
    suffixes = tuple(suffix for name in dialects() for suffix in dialect(name).suffixes)
    for path in paths:
        if not os.path.isdir(path):
            found.append(path)
            continue
        before = len(found)
        for folder, folders, files in os.walk(path):
            folders.sort()
            found += [os.path.join(folder, name) for name in sorted(files) if name.lower().endswith(suffixes)]
        if len(found) == before and len(paths) > 1:
            found.append(path)
    return found
