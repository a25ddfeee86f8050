"""The distributions of the folder extras: the commands and the names that each brings, found by its entry points."""

from __future__ import annotations

# The commands, by distribution; one that motionlang has itself is extended.
COMMANDS = {
    "explore": ("cover", "diff", "improve", "init", "map", "panel"),
    "mcapi": ("mcapi",),
    "copley": ("copley",),
    "lsp": ("lsp",),
}
# The distribution of each name of the package `motionlang` that is elsewhere.
NAMES = dict.fromkeys(("cover", "explore", "improve", "map", "ways_of"), "explore")


def installation(folder: str) -> str:
    """Return the command that installs a distribution."""
    return f"python -m pip install ./extras/{folder}"


def brought(name: str, user: str = "") -> object:
    """Return a name of `NAMES`, which a `user` needs; ImportError if its distribution is not installed."""
    from importlib.metadata import entry_points  # as slow as a tenth of a short run, which needs none

    folder = NAMES[name]
    for each in entry_points(group="motionlang.names", name=name):
        if each.dist is not None and each.dist.name == f"motionlang-{folder}":
            found: object = each.load()
            return found
    raise ImportError(f"{user or name} needs motionlang-{folder}: {installation(folder)}")
