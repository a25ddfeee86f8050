"""NVLONG and NVFLOAT: words that outlive a run."""

from __future__ import annotations

from motionlang.lang.machine.nonvolatile import LAST_WORD
from motionlang.mint.keywords.io_inputs import checked
from motionlang.mint.runtime.changes import repeatable

TYPE_CHECKING = False
if TYPE_CHECKING:
    from motionlang.mint.runtime.binding import Operation, Row
    from motionlang.mint.runtime.environment import Environment


def _address(address: int) -> int:
    return checked(address, LAST_WORD, "address in non-volatile memory,")


def read_word(environment: Environment, row: Row) -> Operation:
    kept = environment.machine.kept
    return lambda address: kept.word(_address(address))


@repeatable
def write_word(environment: Environment, row: Row) -> Operation:
    kept = environment.machine.kept
    return lambda address, value: kept.set_word(_address(address), value)


def read_real(environment: Environment, row: Row) -> Operation:
    kept = environment.machine.kept
    return lambda address: kept.real(_address(address))


@repeatable
def write_real(environment: Environment, row: Row) -> Operation:
    kept = environment.machine.kept
    return lambda address, value: kept.set_real(_address(address), value)


OPERATIONS = {
    "nonvolatile.word": {"read": read_word, "write": write_word},
    "nonvolatile.real": {"read": read_real, "write": write_real},
}
