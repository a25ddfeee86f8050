"""Register requests of the Modbus application protocol (V1.1b3), and responses.

A request is checked in the order of the specification: the function code (exception 01), the quantities and
lengths (03), then the addresses (02). A `Request` has passed the first two checks. The memory performs the
third.
"""

from __future__ import annotations

from collections.abc import Callable
from struct import pack, unpack
from typing import NamedTuple

ILLEGAL_FUNCTION, ILLEGAL_ADDRESS, ILLEGAL_VALUE, DEVICE_FAILURE = 1, 2, 3, 4
MAX_READ, MAX_WRITTEN, MAX_WRITTEN_WITH_READ = 125, 123, 121


# Function 43 with this type reads the identification, in one of these categories or a single object.
IDENTIFY, IDENTIFICATION = 0x2B, 0x0E
BASIC, REGULAR, EXTENDED, SINGLE = 1, 2, 3, 4
# Categories up to this one and single objects can be read.
CONFORMITY = 0x82
# The last object of each category.
_LAST = {BASIC: 2, REGULAR: 6, EXTENDED: 6}


class RequestRejected(Exception):
    """A request that is answered with an exception `code`."""

    def __init__(self, code: int) -> None:
        self.code = code
        super().__init__(code)


class Request(NamedTuple):
    """Write `values` from register `into` on, then read `quantity` from `start` on.

    `masks` (and, or) change the register `into` instead, to (old and AND) or (OR and not AND).
    """

    function: int
    start: int = 0
    quantity: int = 0
    into: int = 0
    values: tuple[int, ...] = ()
    masks: tuple[int, int] | None = None

    @property
    def spans(self) -> tuple[tuple[int, int], ...]:
        """The areas that are accessed: the first register and the number of registers."""
        written = 1 if self.masks is not None else len(self.values)
        return tuple(span for span in ((self.start, self.quantity), (self.into, written)) if span[1])

    def answer(self, registers: list[int]) -> bytes:
        """Return the response that contains `registers`, the values read."""
        if self.quantity:
            return pack(f">BB{self.quantity}H", self.function, 2 * self.quantity, *registers)
        if self.masks is not None:
            return pack(">BHHH", self.function, self.into, *self.masks)
        last = self.values[0] if self.function == 6 else len(self.values)
        return pack(">BHH", self.function, self.into, last)


class Identity(NamedTuple):
    """The identification of a device: its maker, product and version."""

    vendor: str
    product: str
    version: str

    @property
    def objects(self) -> dict[int, bytes]:
        """The objects of the identification by number."""
        texts = {0: self.vendor, 1: self.product, 2: self.version, 4: self.product}
        return {number: text.encode("ascii", "replace")[:60] for number, text in texts.items()}

    def answer(self, data: bytes) -> bytes:
        """Return the identification; raise Rejected for an invalid request."""
        if len(data) < 2 or data[1] != IDENTIFICATION:
            raise RequestRejected(ILLEGAL_FUNCTION)
        if len(data) != 4 or not BASIC <= data[2] <= SINGLE:
            raise RequestRejected(ILLEGAL_VALUE)
        category, first = data[2:]
        objects = self.objects
        if category == SINGLE:
            if first not in objects:
                raise RequestRejected(ILLEGAL_ADDRESS)
            chosen = [first]
        else:
            # The specification: an object that does not exist means the first one.
            first = first if first in objects else 0
            chosen = [number for number in objects if first <= number <= _LAST[category]]
        listed = b"".join(bytes((number, len(objects[number]))) + objects[number] for number in chosen)
        return bytes((IDENTIFY, IDENTIFICATION, category, CONFORMITY, 0, 0, len(chosen))) + listed


def parse(request: bytes) -> Request:
    """Return the request in a protocol data unit; raise Rejected if it is invalid."""
    reader = _READERS.get(request[0])
    if reader is None:
        raise RequestRejected(ILLEGAL_FUNCTION)
    return reader(request[0], request[1:])


def exception(function: int, code: int) -> bytes:
    """Return the response that rejects a request."""
    return bytes((function | 0x80, code))


def _read(function: int, data: bytes) -> Request:
    start, count = _words(data, 2)
    return Request(function, start, _quantity(count, MAX_READ))


def _write_one(function: int, data: bytes) -> Request:
    into, value = _words(data, 2)
    return Request(function, into=into, values=(value,))


def _write(function: int, data: bytes) -> Request:
    into, count = _words(data[:4], 2)
    return Request(function, into=into, values=_values(data[4:], _quantity(count, MAX_WRITTEN)))


def _write_masked(function: int, data: bytes) -> Request:
    into, keep, add = _words(data, 3)
    return Request(function, into=into, masks=(keep, add))


def _write_and_read(function: int, data: bytes) -> Request:
    start, count, into, written = _words(data[:8], 4)
    values = _values(data[8:], _quantity(written, MAX_WRITTEN_WITH_READ))
    return Request(function, start, _quantity(count, MAX_READ), into, values)


def _words(data: bytes, count: int) -> tuple[int, ...]:
    if len(data) != 2 * count:
        raise RequestRejected(ILLEGAL_VALUE)
    return unpack(f">{count}H", data)


def _values(data: bytes, count: int) -> tuple[int, ...]:
    if not data or data[0] != 2 * count:
        raise RequestRejected(ILLEGAL_VALUE)
    return _words(data[1:], count)


def _quantity(count: int, most: int) -> int:
    if not 1 <= count <= most:
        raise RequestRejected(ILLEGAL_VALUE)
    return count


_READERS: dict[int, Callable[[int, bytes], Request]] = {
    3: _read,
    4: _read,
    6: _write_one,
    16: _write,
    22: _write_masked,
    23: _write_and_read,
}
