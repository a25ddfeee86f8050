"""The memory that a controller shares with its host: the comms array and NetData.

Each element is one 32-bit word that can be read as an integer or as a float. The two views share its bits
without conversion (ABB AN00198 p. 14). For Modbus, the low half of element n is register 2n, the high half is
2n + 1 (AN00198 p. 5). A text has four characters per element, the first one in the highest byte, and ends at
a zero byte (AN00200 p. 8).
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from math import inf, nan
from typing import TYPE_CHECKING, Any

from motionlang.kernel import controller as controllers
from motionlang.kernel.controller.io.reads import ReadObserver
from motionlang.kernel.errors import Rejected
from motionlang.kernel.tools import signed
from motionlang.kernel.traced import reading

if TYPE_CHECKING:
    from motionlang.kernel.controller.io.asking import AskedRule, Asking
    from motionlang.kernel.controller.state import ControllerState

Listener = Callable[[str, int, bool], None]

# Area -> (first element, last element).
AREAS = {"comms": (1, 99), "netdata": (0, 999)}
# By how much the integer of an element changes with a number that a host writes as an integer; NaN if as a float.
_WHOLE = {"comms": nan, "netdata": 1.0}
# Their printed names.
_CALLED = {"comms": "the comms array", "netdata": "NetData"}
_KINDS = {"comms": "comms element", "netdata": "network data"}
# How a model's name begins after its family, and the area that its Modbus clients see (AN00198 p. 5).
PRODUCTS = {"es": "comms", "e150": "netdata", "e180": "netdata", "e190": "netdata", "e100": "netdata"}
_LARGEST_FLOAT = 3.4028235677973366e38  # larger numbers round to infinity in 32 bits


class HostMemory:
    """The comms array and NetData.

    `listeners` are called with (area, element, changed) for every element that the host writes. Writes by the
    program itself do not call them, because the documents mention the client's writes only; they call `written`
    with (area, element, value) if they change it. `mapping` is the area that a Modbus client sees.
    """

    def __init__(
        self,
        mapping: str = "netdata",
        written: Callable[[str, int, float], object] = lambda area, element, value: None,
    ) -> None:
        self._words = {
            area: memoryview(bytearray(4 * (last + 1))).cast("i") for area, (_, last) in AREAS.items()
        }
        self._floats = {area: memoryview(words).cast("B").cast("f") for area, words in self._words.items()}
        self.listeners: list[Listener] = []
        self._written = written
        self.mapping = mapping
        self.observer: ReadObserver | None = None
        self.traces = False

    # ------------------------------------------------------------------------------------- the program's side

    def integer(self, area: str, element: int) -> int:
        if self.observer is not None:
            self.observer(area, element)
        word = self._words[area][_checked(area, element)]
        return reading(word, area, element, factor=_WHOLE[area]) if self.traces else word

    def set_integer(self, area: str, element: int, value: int) -> None:
        self._set(self._words, area, element, value)

    def real(self, area: str, element: int) -> float:
        if self.observer is not None:
            self.observer(area, element)
        value = self._floats[area][_checked(area, element)]
        return reading(value, area, element) if self.traces else value

    def set_real(self, area: str, element: int, value: float) -> None:
        if not abs(value) < _LARGEST_FLOAT:
            value = inf if value > 0 else -inf if value < 0 else value
        self._set(self._floats, area, element, value)

    def _set(self, view: Mapping[str, Any], area: str, element: int, value: float) -> None:
        words, before = self._words[area], self._words[area][_checked(area, element)]
        view[area][element] = value
        if words[element] != before:
            self._written(area, element, value)

    # ------------------------------------------------------------------------------------------ the host's side

    def write(self, area: str, first: int, words: Sequence[int]) -> None:
        """Write elements from the host, given as signed 32-bit integers."""
        changed = [self._words[area][_checked(area, first + k)] != word for k, word in enumerate(words)]
        for k, word in enumerate(words):
            self._words[area][first + k] = word
        for k, each in enumerate(changed):
            for listener in tuple(self.listeners):
                listener(area, first + k, each)

    def registers(self, area: str, first: int, count: int) -> list[int]:
        """Return Modbus registers of 16 bits each."""
        words = self._words[area]
        return [words[n >> 1] >> 16 * (n & 1) & 0xFFFF for n in range(first, first + count)]

    def write_registers(self, area: str, first: int, values: Sequence[int]) -> None:
        """Write registers from the host; the other half of an element keeps its value."""
        low, high = first >> 1, first + len(values) - 1 >> 1
        halves = self.registers(area, 2 * low, 2 * (high - low + 1))
        halves[first - 2 * low : first - 2 * low + len(values)] = values
        pairs = zip(halves[::2], halves[1::2], strict=True)
        self.write(area, low, [signed(half | other << 16) for half, other in pairs])

    def has_registers(self, area: str, first: int, count: int) -> bool:
        """True if all registers of a range belong to existing elements."""
        low, high = AREAS[area]
        return 2 * low <= first and first + count <= 2 * high + 2

    def schedule(
        self, controller: ControllerState, area: str, entry: Mapping[str, object], since: float = 0.0
    ) -> None:
        """Schedule one `[[comms]]` or `[[netdata]]` of the machine file; its times count from `since`."""
        words, element = _words(area, entry), int(entry["element"])  # type: ignore[call-overload]
        if "asked" in entry:
            self._answer(controller.answering(), area, element, entry, since)
            return
        controller.stimuli.add(area, entry, lambda: self.write(area, element, words), since)

    def _answer(
        self, asking: Asking, area: str, element: int, entry: Mapping[str, object], since: float
    ) -> None:
        """Write an entry when the program asks for its element and it has another value."""

        def current() -> list[int]:
            return self._words[area][element : element + 1].tolist()

        def other(rule: AskedRule) -> list[int] | None:
            words = _words(area, rule.stimulus.entry)
            return None if words[:1] == current() else words

        def put(rule: AskedRule, words: object) -> None:
            self.write(area, element, words)  # type: ignore[arg-type]

        def name(rule: AskedRule, words: object) -> str:
            given = rule.stimulus.entry
            shown = repr(given["text"]) if "text" in given else f"{given['value']:.10g}"
            return f"{_KINDS[area]} {element} = {shown}"

        asking.add(area, element, entry, since, controllers.Responder(name, current, other, put))


def product(model: str) -> str:
    """Return the product of `PRODUCTS` that a model names; the NextMove e100 if none.

    ES and ESB are "es".
    """
    return named_product(model) or "e100"


def named_product(model: str) -> str | None:
    name = "".join(letter for letter in model.lower() if letter.isalnum())
    for family in ("nextmove", "microflex", "motiflex"):
        name = name.removeprefix(family)
    return next((each for each in PRODUCTS if name.startswith(each)), None)


def packed(text: str) -> list[int]:
    """Return the 32-bit words that represent a text, with zeros after its end."""
    raw = text.encode("latin-1", "replace")
    raw += bytes(-len(raw) % 4)
    return [int.from_bytes(raw[k : k + 4], "big", signed=True) for k in range(0, len(raw), 4)]


def _words(area: str, entry: Mapping[str, object]) -> list[int]:
    if "text" in entry:
        return packed(str(entry["text"]))
    value: float = entry["value"]  # type: ignore[assignment]
    view = entry.get("as", "integer" if area != "comms" and isinstance(value, int) else "float")
    if view == "integer":
        return [signed(int(value))]
    scratch = HostMemory()
    scratch.set_real(area, 1, value)
    return [scratch.integer(area, 1)]


def _checked(area: str, element: int) -> int:
    first, last = AREAS[area]
    if not first <= element <= last:
        raise Rejected(
            "channel", f"{_CALLED[area]} has no element {element}", f"its elements are {first} to {last}"
        )
    return element
