"""Types and known values of expressions."""

from __future__ import annotations

from dataclasses import dataclass
from math import inf, isnan

from motionlang.kernel.lang.keyword import Keyword
from motionlang.kernel.mint.resolve.symbols import FLOAT, INTEGER, NUMERIC, SEMAPHORE, STRING, TIME, Type

INT_LOW, INT_HIGH = -(2**31), 2**31 - 1
# Up to this, integers and doubles give the same results.
EXACT = 2**53


@dataclass(eq=False, slots=True)
class KnownValue:
    """The type of an expression, and its value if that is known before the program runs."""

    type: str
    const: float | str | None = None

    @property
    def is_number(self) -> bool:
        return self.type in NUMERIC


# Replaces a wrong value, which has been reported, so that other errors are found. Its type is no error.
NOTHING = KnownValue(FLOAT)


def literal(known: float | str) -> KnownValue:
    """Return a known value; an integer of more than 32 bits is a Float."""
    if isinstance(known, str):
        return KnownValue(STRING, known)
    if isnan(known) or known in (inf, -inf):
        return KnownValue(FLOAT)
    if type(known) is not int:
        return KnownValue(FLOAT, known)
    if INT_LOW <= known <= INT_HIGH:
        return KnownValue(INTEGER, known)
    return KnownValue(FLOAT, known if abs(known) <= EXACT else float(known))


def read_from(kind: Type) -> KnownValue:
    """Return the value of a variable of a type: a Time or a Semaphore is read as an Integer."""
    return KnownValue(INTEGER if kind.name in (TIME, SEMAPHORE) else str(kind))


def type_of(row: Keyword) -> str:
    """Return the Mint type of a keyword's value."""
    return INTEGER if row.is_whole else STRING if row.unit == "text" else FLOAT


def article(type: str) -> str:
    """Return the name of a type with its indefinite article."""
    return f"an {type}" if type[:1] in "AEIOaeio" else f"a {type}"
