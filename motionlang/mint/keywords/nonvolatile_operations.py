"""NVLONG and NVFLOAT: words that outlive a run."""

from __future__ import annotations

from motionlang.lang.machine.nonvolatile import LAST_WORD
from motionlang.mint.keywords.io_inputs import checked
from motionlang.mint.runtime.binding import of
from motionlang.mint.runtime.changes import repeatable
from motionlang.mint.runtime.environment import Environment


def _address(address: int) -> int:
    return checked(address, LAST_WORD, "address in non-volatile memory,")


def write_word(environment: Environment, address: int, value: int) -> None:
    environment.machine.kept.set_word(_address(address), value)


def write_real(environment: Environment, address: int, value: float) -> None:
    environment.machine.kept.set_real(_address(address), value)


OPERATIONS = {
    "nonvolatile.word": {
        "read": of(Environment, lambda e, address: e.machine.kept.word(_address(address))),
        "write": repeatable(of(Environment, write_word)),
    },
    "nonvolatile.real": {
        "read": of(Environment, lambda e, address: e.machine.kept.real(_address(address))),
        "write": repeatable(of(Environment, write_real)),
    },
}
