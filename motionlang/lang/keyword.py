"""A keyword: one row of a dialect's vocabulary, from which everything else about the word derives.

Dispatch, diagnostics, did-you-mean, completion, `help`, highlighting, the linter and `docs/keywords/` read
these rows and nothing else. A row refers to the functions that carry it out (`Actions`), which its file defines.
"""

from __future__ import annotations

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable, Iterable, Iterator
    from typing import Any

# Units of what is read as a whole number. A time in ms may be written with a fraction all the same.
WHOLE_UNITS = frozenset(("integer", "bool", "bits", "counts", "ms"))

# What a statement with a word does to the axes it names. Of the first group a word has at most one, which is its role
# in a program that is followed step by step; the others say more of it.
ROLES = {
    "move": "puts a move into the buffer of its axis, of which it is known where it ends",
    "entry": "puts something else into the buffer: a dwell, an output",
    "course": "puts a motion into the buffer, of which nobody knows where it ends",
    "path": "puts a move of several axes together into the buffers, which the GO of the first one starts",
    "go": "starts what is in the buffer",
    "stop": "ends what the axis does and empties its buffer",
    "act": "moves the axis at once, without GO",
    "scale": "changes what a user unit is",
    "zero": "gives the present position another value",
}
TRAITS = {
    "relative": "what it is given is a distance, not a position",
    "line": "a path that ends where its values say",
    "endless": "the motion ends when something stops it",
    "abrupt": "the axis stands at once",
    "all": "it means every axis, whatever it names",
    "datum": "the axis has another zero afterwards",
    "follows": "the axis moves with its master, whatever it does itself",
    "hands-over": "from now on an input, a table or an analogue value moves the axis, too",
    "switch": "what the axis was doing may have ended",
}


class Actions:
    """The functions that carry a keyword out, None where there is none; each language says how they are called.

    `verb`       the name by which the controller, the compiler or the linter know what it does; "" where they need none
    `read`, `write`, `load`, `do`   read its value, write it, put a move into the buffer, carry out a command
    `held`       reads what a writing replaces, where `read` does not say
    `attribute`  the property that it reads and writes of its subject, such as the "edge" of a latch
    """

    __slots__ = ("attribute", "do", "held", "load", "read", "verb", "write")

    def __init__(
        self,
        verb: str = "",
        *,
        read: Callable[..., Any] | None = None,
        write: Callable[..., Any] | None = None,
        load: Callable[..., Any] | None = None,
        do: Callable[..., Any] | None = None,
        held: Callable[..., Any] | None = None,
        attribute: str = "",
    ) -> None:
        self.verb, self.attribute = verb, attribute
        self.read, self.write, self.load, self.do, self.held = read, write, load, do, held


class Keyword:
    """One word of a motion language.

    `kind`     "setting" | "reading" | "command" | "move" | "function" | "constant" | "statement"
    `access`   "R", "W", "RW" (values) or "C" (a command without a value)
    `index`    what stands in the brackets: "axis", "axes" (a list), "channel", "bank", "none"
    `unit`     "uu", "uu/s", "uu/s2", "uu/s3", "s", "ms", "counts", "%", "bool", "bits", "number", "text", ""
    `actions`  the functions that carry it out, or only a `verb`: the setting or the reading of the controller that it
               stands for, the value of a constant, the name of a function or a statement; "" where it is not simulated
    `low`…`high`  the accepted range, inclusive; None where open
    `solved`   its reading takes the level that it is compared with, and so can tell when it passes that
    `simulated`   False: recognised, documented, answered as "not simulated"
    `effect`   what writing the word, or carrying it out, does to its axes: words of `ROLES` and `TRAITS`
    `gives`    the property of moves that it sets: "speed", "accel", "decel jerk" …; the word written last counts
    `changes`  "motion": what is read changes only while the axis moves; "always": each reading gives another value
    `every`    read of several axes it is true where it is true of each
    `optional` the number of values that may be left out at the end of the brackets
    `tunes`    the quantity of the servo loop that it sets: one of the gains of its language in `servo.gains`
    `meant`    what people write for it where they do not know it
    `family`   the words that a controller lacks or limits together with it; `models.py` of a language says which do
    `driven`   the section of the machine file that says what is read, such as "input"
    """

    __slots__ = (
        "access",
        "actions",
        "changes",
        "default",
        "driven",
        "effect",
        "every",
        "example",
        "family",
        "gives",
        "group",
        "help",
        "high",
        "index",
        "kind",
        "low",
        "meant",
        "name",
        "optional",
        "short",
        "simulated",
        "solved",
        "tunes",
        "unit",
        "verb",
    )

    def __init__(
        self,
        name: str,
        short: str,
        kind: str,
        access: str,
        index: str,
        unit: str,
        actions: str | Actions,
        help: str,
        example: str = "",
        *,
        default: float | str | None = None,
        low: float | None = None,
        high: float | None = None,
        group: str = "",
        simulated: bool = True,
        solved: bool = False,
        effect: str = "",
        gives: str = "",
        changes: str = "",
        tunes: str = "",
        driven: str = "",
        meant: str = "",
        family: str = "",
        every: bool = False,
        optional: int = 0,
    ) -> None:
        self.name, self.short, self.kind, self.access, self.index = name, short, kind, access, index
        self.actions = actions if isinstance(actions, Actions) else Actions(actions)
        self.unit, self.verb, self.help, self.example = unit, self.actions.verb, help, example
        self.default, self.low, self.high = default, low, high
        self.group, self.simulated, self.solved = group, simulated, solved
        self.effect, self.gives, self.changes, self.driven = effect, gives, changes, driven
        self.tunes, self.meant, self.family = tunes, meant, family
        self.every, self.optional = every, optional

    @property
    def is_whole(self) -> bool:
        """True if its value is read as a whole number."""
        return self.unit in WHOLE_UNITS

    @property
    def takes_fractions(self) -> bool:
        """True if a value that is written keeps its fraction."""
        return self.unit not in WHOLE_UNITS or self.unit == "ms"

    @property
    def attribute(self) -> str:
        """The property of its subject that it reads and writes."""
        return self.actions.attribute

    def does(self, what: str) -> bool:
        """Whether its effect has a word of `ROLES` or `TRAITS`."""
        return what in self.effect.split()

    @property
    def role(self) -> str:
        """Its word of `ROLES`, "" where it has none."""
        return next((what for what in self.effect.split() if what in ROLES), "")

    def __repr__(self) -> str:
        return f"Keyword({self.name!r})"


class Table:
    """All words of a dialect, found by name or short form in any case; `hidden` ones only by their name."""

    __slots__ = ("_by_name", "rows")

    def __init__(self, rows: Iterable[Keyword], hidden: Iterable[Keyword] = ()) -> None:
        self.rows = tuple(rows)
        self._by_name: dict[str, Keyword] = {}
        for row in self.rows:
            for spelling in filter(None, (row.name, row.short)):
                key = spelling.lower()
                assert key not in self._by_name, f"{spelling} stands twice in the table"
                self._by_name[key] = row
        self._by_name.update((row.name, row) for row in hidden)

    def __iter__(self) -> Iterator[Keyword]:
        return iter(self.rows)

    def __len__(self) -> int:
        return len(self.rows)

    def get(self, word: str) -> Keyword | None:
        """The row of a word, by its name or its short form, in any case."""
        return self._by_name.get(word.lower())

    def doing(self, verb: str) -> str:
        """The name of the first word of a verb."""
        return next(row.name for row in self.rows if row.verb == verb)

    def names(self) -> list[str]:
        """Every name, in the order of the table."""
        return [row.name for row in self.rows]
