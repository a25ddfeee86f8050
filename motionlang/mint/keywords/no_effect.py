"""Settings that are kept and read back but have no effect: of motors, drives, feedback, gains, ports, tests, presets.

The program of a real machine begins with pages of them. They are not simulated, and the report says which ones the
program wrote; it runs unchanged all the same. Until they are written they read 0 or an empty text, which the report
says, too. They stand in `type_library/values.txt` as "kept"; here are the constants that are written into them.
"""

from __future__ import annotations

from motionlang.lang.keyword import Actions, Keyword
from motionlang.mint.keywords.machine_readings import Told
from motionlang.mint.runtime.changes import repeatable

TYPE_CHECKING = False
if TYPE_CHECKING:
    from motionlang.mint.runtime.binding import Operation
    from motionlang.mint.runtime.environment import Environment


class Kept:
    """What the program has written, by keyword and indices, and what the machine file says."""

    def __init__(self, environment: Environment) -> None:
        self.values: dict[tuple[object, ...], object] = {}
        self.told = Told(environment.machine.settings)

    def find(self, row: Keyword, where: tuple[object, ...]) -> object | None:
        """The value of a word, None where nobody has said it."""
        found = self.values.get((row.name, *where))
        return self.told.find(row.name, row.unit, where) if found is None else found


def note(words: dict[str, list[int]], name: str, line: int) -> None:
    """Remember that the program came to a word in a line."""
    lines = words.setdefault(name, [])
    if line not in lines:
        lines.append(line)


def read_value(environment: Environment, row: Keyword) -> Operation:
    """The value, and until there is one, 0 or an empty text."""
    kept, name, assumed = environment.part(Kept), row.name, environment.machine.assumed
    nothing: object = "" if row.unit == "text" else 0.0 if row.unit == "number" else 0

    def read(*given: object) -> object:
        *where, line = given
        found = kept.find(row, tuple(where))
        if found is None:
            note(assumed, name, line)  # type: ignore[arg-type]
            return nothing
        return found

    return read


def held_value(environment: Environment, row: Keyword) -> Operation:
    """What is kept where a writing puts its value; called with all that the writing is, the line last."""
    find = environment.part(Kept).find
    return lambda *given: find(row, given[:-2])


@repeatable
def write_value(environment: Environment, row: Keyword) -> Operation:
    """A setting that is kept and changes nothing here; the report tells that it was written."""
    values, name, without_effect = environment.part(Kept).values, row.name, environment.machine.without_effect

    def write(*given: object) -> None:
        *where, value, line = given
        note(without_effect, name, line)  # type: ignore[arg-type]
        values[name, *where] = value

    return write


# ------------------------------------------------------------------------------------------------- keywords

VERB = "no_effect.value"
KEPT = Actions(VERB, read=read_value, write=write_value, held=held_value)
# Those of them that on a controller end what the axis was doing.
SWITCHES = frozenset(("CONFIG",))
# Those that set a quantity of the servo loop where `motionlang servo` is given them, and none in a run.
TUNES = {"DACLIMITMAX": "output_limit"}
_TYPES = (("OFF", "no axis"), ("SERVO", "a servo"), ("STEPPER", "a stepper"), ("VIRTUAL", "a virtual axis"))


ROWS = (
    *(
        Keyword(f"_cf{name}", "", "constant", "R", "none", "integer", str(value), f"CONFIG: {help}.",
                f"PRINT _cf{name}", group="constants")
        for value, (name, help) in enumerate(_TYPES)
    ),
)  # fmt: skip
