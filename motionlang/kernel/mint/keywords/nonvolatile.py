"""Non-volatile memory, addressed by number."""

from __future__ import annotations

from motionlang.kernel.lang.keyword import Actions, Keyword
from motionlang.kernel.lang.machine.nonvolatile import LAST_WORD
from motionlang.kernel.mint.keywords.io_inputs import checked
from motionlang.kernel.mint.runtime.binding import of
from motionlang.kernel.mint.runtime.changes import repeatable
from motionlang.kernel.mint.runtime.environment import Environment


def _address(address: int) -> int:
    return checked(address, LAST_WORD, "non-volatile memory at address")


def write_word(environment: Environment, address: int, value: int) -> None:
    environment.machine.nonvolatile.set_word(_address(address), value)


def write_real(environment: Environment, address: int, value: float) -> None:
    environment.machine.nonvolatile.set_real(_address(address), value)


# ------------------------------------------------------------------------------------------------- keywords

_WORD = Actions(
    read=of(Environment, lambda e, address: e.machine.nonvolatile.word(_address(address))),
    write=repeatable(of(Environment, write_word)),
)
_REAL = Actions(
    read=of(Environment, lambda e, address: e.machine.nonvolatile.real(_address(address))),
    write=repeatable(of(Environment, write_real)),
)


ROWS = (
    Keyword("NVLONG", "", "setting", "RW", "address", "integer", _WORD,
            "A whole number in non-volatile memory, addresses 0 to 1023; `run --nv FILE` keeps it from run to run.",
            "NVLONG(5) = NVLONG(5) + 1\nPRINT NVLONG(5)", default=0.0, group="control", channel="nv word"),
    Keyword("NVFLOAT", "", "setting", "RW", "address", "number", _REAL,
            "NVLONG's memory as single-precision numbers: NVLONG and NVFLOAT of one address share their "
            "bits.",
            "NVFLOAT(7) = 2.5\nPRINT NVFLOAT(7)", default=0.0, group="control", channel="nv word"),
)  # fmt: skip
