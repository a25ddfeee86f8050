"""Public names of a package, imported on first use."""

from __future__ import annotations

from collections.abc import Callable, Mapping


def lazy_names(package: str, modules: Mapping[str, str]) -> Callable[[str], object]:
    """Return the `__getattr__` of a package that imports each of its names on first use.

    `modules` has the names of each module below the package, separated by spaces. Hide the result from type checkers,
    for which every name would exist.
    """
    homes = {name: module for module, names in modules.items() for name in names.split()}

    def opened(name: str) -> object:
        if name not in homes:
            raise AttributeError(f"module {package!r} has no attribute {name!r}")
        # Like `import_module`, whose package takes longer to import than most of these modules.
        return getattr(__import__(f"{package}.{homes[name]}", fromlist=[name]), name)

    return opened
