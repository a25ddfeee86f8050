"""What a person would guess of an input: the rules that its name and its place in the text suggest.

A sensor follows the output whose name shares a word with its own (`probe down` – `probe`), or the output that the text
switches last before it looks at the input. A start button is pushed, a guard is on, a full box is not there. The words
(`words.py`) are only a first guess: what is played decides.
"""

from __future__ import annotations

import re
from collections import defaultdict
from collections.abc import Callable, Iterable, Iterator, Mapping, Set
from typing import TYPE_CHECKING

from motionlang.kernel import Source
from motionlang.kernel.lang import NAME, PRINTS, WRITE, Named, Structure
from motionlang_explore.exploration.states import DELAY
from motionlang_explore.exploration.words import (
    ABSENT,
    BACK,
    BAD,
    BY_HAND,
    COMMON,
    GOOD,
    RESET,
    SHOWN,
    STEADY,
    is_right,
    names_alarm,
)
from motionlang_explore.identification import Entry

if TYPE_CHECKING:
    from motionlang_explore.exploration.trials import Trial

# A sensor behind an output takes so long, s, and a push of a button.
SOON, PUSH = 0.1, 1.0
# An input that is on from the start, a person or a host that answers, a button that is pushed, and a sensor of which
# nothing is known: it answers within the time-outs of programs.
ON: Entry = {"at": 0.0}
ASKED: Entry = {"asked": DELAY}
PUSHED: Entry = {**ASKED, "for": PUSH}
QUICK: Entry = {"asked": 0.02}
# The values with which an output is switched off.
OFF = ("0", "_off", "_false")
# What a remark behind a name says of a level, such as (0 = shut).
_LEVELS = re.compile(
    r"\W{1,3}(?:([01]|low|high) *= *([^\W\d]+)|([^\W\d]+) *= *([01])\b)(?:\W{1,3}([01]|low|high) *= *([^\W\d]+))?",
    re.IGNORECASE,
)
# A remark in brackets right behind a name, but for what it says of levels.
_MORE = re.compile(r"^ *\(([^()=]*)\)")
# The names of a program in the form of a statement.
_NAMES = re.compile(rf"{NAME}(\w+)")
# Where a word of doorClosed or di_Door begins.
_WORD = re.compile(r"(?<=[a-z])(?=[A-Z])|_")


class Likely:
    """The rules that are likely for the inputs of a program, the likeliest first."""

    def __init__(self, structure: Structure, named: Iterable[Named], source: Source) -> None:
        names = defaultdict[tuple[str, int], str](str)
        self._steady: dict[int, Entry] = {}
        for each in named:
            remark = source.line(each.line).partition(each.name)[2] if each.line else ""
            more = "".join(_MORE.findall(remark))
            names[each.kind, each.number] += f" {_WORD.sub(' ', each.name)}{more}"
            if each.kind in ("input", "channel") and (level := _good_level(remark)) is not None:
                self._steady[each.number] = {**ON} if level else {}
        # The channels of a controller with one series are inputs or outputs.
        switched = set[int]().union(*(each.outputs for each in structure.statements.values()))
        for kind, number in [each for each in names if each[0] == "channel"]:
            one = "output" if number in switched else "input"
            names[one, number] = names[one, number].strip() or names[kind, number]
        self._names: Mapping[tuple[str, int], str] = dict(names)
        self._before = _switched_before(structure, names)
        inputs = ((number, name) for (kind, number), name in names.items() if kind == "input")
        # A button that starts as well has other pieces.
        resets = {number for number, name in inputs if RESET.search(name) and "start" not in name.lower()}
        self._resets = set(map(str, resets))
        # The statements that print how much was bad, and how much was good.
        self._bad = frozenset(_counting(structure, names_alarm))
        self.right = frozenset(_counting(structure, is_right))
        self._loops = {structure.points[p].at for p in structure.graph.closing}
        # What was seen before a wait for a reset, and what before anything else, with True for a text.
        self._led, self._passed = set[tuple[int, bool]](), set[tuple[int, bool]]()

    def note(self, trial: Trial, structure: Structure) -> None:
        """Take note of what a trial prints last, or switches, before a wait for a reset, and before anything else."""
        for begun in trial.statements.values() if self._resets else ():
            text, switched = set[tuple[int, bool]](), set[tuple[int, bool]]()
            for at in (each.at for each in begun):
                statement = structure.statements.get(at)
                if statement is None:
                    continue
                inputs = {use.number for use in statement.channels if use.channel == "input"}
                if statement.waits == "time":
                    switched.clear()  # the text alone may have been printed some passes before
                elif statement.moves or statement.waits or (inputs and at in self._loops):
                    (self._passed if inputs.isdisjoint(self._resets) else self._led).update(text, switched)
                    text, switched = set(), set()
                elif '"' in statement.text:
                    text = {(at, True)}
                elif statement.outputs:
                    switched.add((at, False))

    @property
    def trouble(self) -> frozenset[int]:
        """The statements that print how much was bad, and what always prints, or else switches, before a reset."""
        led = self._led - self._passed
        return self._bad.union({at for at, is_text in led if is_text} or (at for at, _ in led))

    def rules(self, number: int, *, by_name: bool = True, by_place: bool = True) -> list[Entry]:
        """Return the rules of an input that its name and the outputs before it suggest, which come first without.

        Not `by_place` what has no output by its name is on.
        """
        name = self._names.get(("input", number), "")
        before = self._before.get(number, {})
        shares = [
            output
            for (kind, output), other in self._names.items()
            if kind == "output" and not (SHOWN.search(other) or _stems(other).isdisjoint(_stems(name)))
        ]
        shares.sort(key=lambda output: output not in before)
        behind = _behind(name, shares[:2], before)
        by_word: tuple[tuple[re.Pattern[str], Entry], ...] = ((ABSENT, {}), (STEADY, ON), (BY_HAND, PUSHED))
        said = [self._steady[number]] if number in self._steady else []
        said += [{**rule} for words, rule in by_word if words.search(name)]
        others = _behind(name, [each for each in before if each not in shares] if by_place else [], before)
        found = [*behind, *said, *others] if by_name else [*said, *others, *behind]
        found += [{**ON}, {**QUICK}, {**PUSHED}]
        return [each for k, each in enumerate(found) if each not in found[:k]]


def _behind(name: str, outputs: Iterable[int], before: Mapping[int, Set[bool]]) -> list[Entry]:
    """Return the rules of an input behind outputs: first on without one that its name or the text before it has off."""
    found = list[Entry]()
    for each in outputs:
        is_back = bool(BACK.search(name)) or True not in before.get(each, {True})
        levels: list[Entry] = [{"value": 0}, {}] if is_back else [{}, {"value": 0}]
        found += [{"output": each, "delay": SOON, **level} for level in levels]
    return found


def _good_level(remark: str) -> bool | None:
    """Return the level of a good machine of which a remark behind a name speaks, None if it speaks of none."""
    found = _LEVELS.match(remark)
    said = [] if found is None else [found.group(1, 2), found.group(4, 3), found.group(5, 6)]
    for level, word in said:
        for words, is_good in ((GOOD, True), (BAD, False)):
            if level and words.match(word):
                return (level.lower() in ("1", "high")) is is_good
    return None


def _switched_before(
    structure: Structure, names: Mapping[tuple[str, int], str]
) -> Mapping[int, Mapping[int, Set[bool]]]:
    """Return the outputs that are switched last before each input is read, by the order of the text, but for lamps.

    They come with what was written last, True unless it is off.
    """
    owners, last = structure.owners(), dict[str, tuple[int, bool]]()
    found = defaultdict[int, dict[int, set[bool]]](dict)
    for at, each in sorted(structure.statements.items()):
        unit = owners.get(at, "")
        for use in (one for one in each.channels if one.number.isdecimal()):
            number = int(use.number)
            if (use.channel, use.access) == ("input", "read") and unit in last:
                output, is_on = last[unit]
                found[number].setdefault(output, set()).add(is_on)
        switched = [
            (int(use.number), use.value.lower() not in OFF)
            for use in each.channels
            if (use.channel, use.access) == ("output", WRITE) and use.number.isdecimal()
        ]
        shown = [one for one in switched if not SHOWN.search(names.get(("output", one[0]), ""))]
        if shown:
            last[unit] = shown[-1]
        elif each.moves:
            last.pop(unit, None)
    return found


def _counting(structure: Structure, means: Callable[[str], bool]) -> Iterator[int]:
    """Yield the statements that print numbers, all with names of the same meaning, such as `bad`."""
    for at, each in structure.statements.items():
        names = _NAMES.findall(each.form) if each.effect == PRINTS else ()
        if names and all(means(_WORD.sub(" ", name)) for name in names):
            yield at


def _stems(name: str) -> set[str]:
    words = re.findall(r"[a-zà-ÿ]{3,}", name.lower())
    return {each[:4] for each in words if not COMMON.fullmatch(each)}
