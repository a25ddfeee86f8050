"""The virtual multi-axis controller: counts and seconds, no language and no user units.

Start with `controller.Controller`; its public methods, listed in `verbs.VERBS`, are all that a language may do.
"""

from __future__ import annotations

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable
    from types import ModuleType


def door(family: str, *modules: str) -> Callable[[str], ModuleType]:
    """What brings in a module of a family when it is first asked for by `family.module`: `__getattr__` of the family.

    From then on it stands there under its name, as everything that has been imported does.
    """

    def opened(name: str) -> ModuleType:
        if name not in modules:
            raise AttributeError(f"module {family!r} has no attribute {name!r}")
        return __import__(f"{family}.{name}", fromlist=[name])

    return opened
