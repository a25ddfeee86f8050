"""Worlds of programs from machines, for tests of other commands than `init`."""

from __future__ import annotations

from motionlang.kernel import Dialect, Source
from motionlang_explore.exploration import explore


def world_of(source: Source, language: Dialect) -> dict[str, object]:
    """Return the settings of a machine in which a program runs its likeliest cycle, as `init` finds them."""
    found = explore(language.program(source, is_debug=True))
    return {**found.switches.settings, **found.world.settings}
