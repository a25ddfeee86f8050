"""Settings that are stored and read back but have no effect on a run.

They concern motors, drives, feedback, gains, ports, tests and presets. The program of a real machine begins
with pages of them. The program runs unchanged, and the report lists those that it wrote. A setting that was
not written reads 0 or an empty string, which the report also states. `type_library/values.txt` marks them as
"kept". This file has the constants that programs write to them.
"""

from __future__ import annotations

from motionlang.kernel.lang.keyword import Actions, Keyword, constant
from motionlang.kernel.mint.keywords.machine_readings import SuppliedValues
from motionlang.kernel.mint.runtime.binding import Operation
from motionlang.kernel.mint.runtime.changes import repeatable
from motionlang.kernel.mint.runtime.environment import Environment


class StoredValues:
    """The stored values by keyword and indices, from the program or the machine file."""

    def __init__(self, environment: Environment) -> None:
        self.values: dict[tuple[object, ...], object] = {}
        self.supplied = SuppliedValues(environment.machine.settings)

    def find(self, row: Keyword, where: tuple[object, ...]) -> object | None:
        """Return the value of a keyword, None if neither source has one."""
        found = self.values.get((row.name, *where))
        return self.supplied.find(row.name, row.unit, where) if found is None else found


def note(words: dict[str, list[int]], name: str, line: int) -> None:
    """Record that the program used a keyword in a line."""
    lines = words.setdefault(name, [])
    if line not in lines:
        lines.append(line)


def read_value(environment: Environment, row: Keyword) -> Operation:
    """Make an operation that reads the stored value, by default 0 or an empty string."""
    stored, name, assumed = environment.component(StoredValues), row.name, environment.machine.assumed
    nothing: object = "" if row.unit == "text" else 0.0 if row.unit == "number" else 0

    def read(*given: object) -> object:
        *where, line = given
        found = stored.find(row, tuple(where))
        if found is None:
            note(assumed, name, line)  # type: ignore[arg-type]
            return nothing
        return found

    return read


def stored_value(environment: Environment, row: Keyword) -> Operation:
    """Make an operation that returns the stored value before a write.

    It receives the same arguments as the write.
    """
    find = environment.component(StoredValues).find
    return lambda *given: find(row, given[:-2])


@repeatable
def write_value(environment: Environment, row: Keyword) -> Operation:
    """Make an operation that stores a value; the report states that it has no effect."""
    values = environment.component(StoredValues).values
    name = row.name
    without_effect = environment.machine.without_effect

    def write(*given: object) -> None:
        *where, value, line = given
        note(without_effect, name, line)  # type: ignore[arg-type]
        values[name, *where] = value

    return write


# ------------------------------------------------------------------------------------------------- keywords

VERB = "no_effect.value"
STORED = Actions(VERB, read=read_value, write=write_value, replaced=stored_value)
# Settings that end the motion of the axis on a controller.
SWITCHES = frozenset(("CONFIG",))
# Settings that `motionlang servo` uses as a quantity of the servo loop. They have no effect in a run.
TUNES = {"DACLIMITMAX": "output_limit"}
_TYPES = (("OFF", "no axis"), ("SERVO", "a servo"), ("STEPPER", "a stepper"), ("VIRTUAL", "a virtual axis"))


ROWS = (
    *(constant(f"_cf{name}", value, f"CONFIG: {help}.") for value, (name, help) in enumerate(_TYPES)),
)  # fmt: skip
