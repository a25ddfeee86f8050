"""The table of functions: its size and its structures."""

from __future__ import annotations

import pytest

import motionlang.hosts.mcapi.calls  # noqa: F401
from motionlang.hosts.mcapi.registry import AT_ONCE, COMMANDS, POLLS, QUERIES
from motionlang.hosts.mcapi.table import FUNCTIONS, STRUCTURES

# The bytes of each structure in C, with four-byte packing, from PMC's header compiled on 64-bit Linux.
SIZES = {
    "MCAXISCONFIG": 104,
    "MCCOMMUTATION": 32,
    "MCCONTOUR": 32,
    "MCFILTEREX": 124,
    "MCFILTER": 64,
    "MCJOGEX": 48,
    "MCJOG": 40,
    "MCMOTIONEX": 100,
    "MCMOTION": 96,
    "MCPARAMEX": 128,
    "MCPARAM": 44,
    "MCSCALE": 48,
    "MCSTATUSEX": 36,
}
BYTES = {"i": 4, "s": 2, "d": 8, "D": 8}


def size(name: str) -> int:
    """Return the bytes of a structure; fields are aligned to at most four bytes."""
    at = 4 if STRUCTURES[name].has_size else 0
    for field in STRUCTURES[name].fields:
        each = BYTES[field.kind]
        step = min(each, 4)
        at = -(-at // step) * step + each * field.count
    return -(-at // 4) * 4


def test_it_has_all_functions() -> None:
    """There are 158 functions; at most 25 are unsupported."""
    assert len(FUNCTIONS) == 158
    assert sum(bool(each.unsupported) for each in FUNCTIONS.values()) <= 25


@pytest.mark.parametrize("name", FUNCTIONS)
def test_each_function_means_something_here(name: str) -> None:
    """A function has code in one of four tables, a command, or a reason for neither."""
    function = FUNCTIONS[name]
    implementations = [name in found for found in (AT_ONCE, COMMANDS, POLLS, QUERIES)]
    if not any(implementations) and not function.unsupported:
        head, _, parameter = function.mccl.partition("{")
        assert len(head.lstrip("a")) == 2
        assert not parameter or parameter.rstrip("}") in [each.name for each in function.arguments]
    assert sum(implementations) + bool(function.unsupported) <= 1
    assert bool(function.help) is not bool(function.unsupported)


def test_structures_have_the_size_of_c() -> None:
    assert {name: size(name) for name in STRUCTURES} == SIZES
