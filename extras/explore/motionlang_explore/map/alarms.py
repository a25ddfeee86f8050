"""What says that something is wrong, or is said only where the cycle is left, and why.

An alarm comes by what was changed alone in the good cycle when it came (`faults.py`); else as the exploration has seen
it; what no trial has reached is quoted from the text.
"""

from __future__ import annotations

import re
from collections import defaultdict
from collections.abc import Callable, Collection, Mapping, Sequence
from functools import partial
from typing import NamedTuple

from motionlang.kernel.lang import PRINTS, WRITE, Statement, Structure
from motionlang_explore.exploration import OFF, Change, Exploration, Transition, is_reset, is_wrong, lines_of
from motionlang_explore.map.faults import SAID, SWITCHED, WRITTEN, Begin, Fault, Sign, faults_of
from motionlang_explore.map.guards import Guards
from motionlang_explore.map.names import ReaderNames, is_alarm
from motionlang_explore.map.plays import Plays
from motionlang_explore.map.state_names import MAX_RANGES
from motionlang_explore.map.stops import Stops

# The code of a character is nothing that is said.
_CODE = re.compile(r"""\b(?:Asc\(|INKEY\s*=\s*)["'][^"']*["']""", re.IGNORECASE)
_TEXT = re.compile(r'"([^"]*)"')
# So many causes of one thing are told.
MAX_CAUSES = 6


class Alarm(NamedTuple):
    """What says that something is wrong, or is only said, and why in words, with how it begins as it was played.

    `ends` is False of a lamp that comes with several texts, of what others follow, and of what is quoted from the text,
    `is_rare` True of what comes after some good cycles, and `is_unplayed` of what no trial has reached. `lamps` come
    with it and with others.
    """

    signs: Sequence[Sign]
    why: str
    is_trouble: bool = True
    begins: Sequence[Begin] = ()
    ends: bool = True
    is_rare: bool = False
    is_unplayed: bool = False
    lamps: Sequence[Sign] = ()

    def what(self, names: ReaderNames) -> list[str]:
        """Return what the machine says in quotes, and the names of what it switches or writes."""
        return list(dict.fromkeys(shown(each, names) for each in self.signs))


def alarms_of(
    exploration: Exploration, structure: Structure, names: ReaderNames, guards: Guards
) -> tuple[list[Alarm], Stops, Sequence[Change]]:
    """Return the alarms of a machine, what stops it, and the changes that were not played."""
    is_trouble = partial(_is_trouble, exploration, names)
    plays = Plays(exploration, names)
    stops = Stops(exploration, plays)
    faults = faults_of(exploration, plays, is_trouble, stops)
    alarms = _played(exploration, faults.of, names, is_trouble)
    for sign, (count, begin) in faults.rare.items():
        if count and (is_trouble(sign) or sign.kind == SAID):
            why = f"after {count} cycle{'s' * (count > 1)}, line {exploration.line(sign.at)}"
            alarms.append(Alarm([sign], why, is_trouble(sign), [begin], is_rare=True))
    told = {sign.at for each in alarms for sign in each.signs}
    told |= frozenset() if exploration.fault_of(exploration.world.run) else faults.seen
    return [*alarms, *_others(exploration, structure, names, guards, told)], stops, plays.left


def shown(sign: Sign, names: ReaderNames) -> str:
    """Return what a machine says in quotes, or the name of what it switches or writes."""
    if sign.kind == SAID:
        return repr(sign.what)
    channel, equal, value = sign.what.partition(" = ")
    return f"{names[channel]}{equal}{value}"


def _is_trouble(exploration: Exploration, names: ReaderNames, sign: Sign) -> bool:
    """True if a sign says that something is wrong."""
    if sign.kind == SWITCHED:
        return sign.what in names.alarms
    if sign.kind == WRITTEN:
        return is_alarm(names[sign.what.partition(" = ")[0]])
    return is_wrong(sign.what) or sign.at in exploration.trouble


def _played(
    exploration: Exploration,
    faults: Mapping[Sign, Sequence[Fault]],
    names: ReaderNames,
    is_trouble: Callable[[Sign], bool],
) -> list[Alarm]:
    """Return the alarms that came by faults: what has the same ones in the same plays is one.

    A lamp of several texts, or numbers for a host, comes with them, and such a number ends with its lamp.
    """
    same = defaultdict[frozenset[tuple[Change, float, int, int]], list[Sign]](list)
    for sign in sorted(faults, key=lambda each: each.at):
        same[frozenset((each.change, each.time, each.line, each.times) for each in faults[sign])].append(sign)
    # Of what is told in one play the text.
    telling = (
        [each for each in signs if each.kind != SWITCHED and is_trouble(each)] for signs in same.values()
    )
    texts = [min(signs, key=lambda each: each.kind != SAID) for signs in telling if signs]
    with_texts = {id(signs): _with(signs, texts, faults) for signs in same.values()}
    found = list[Alarm]()
    for signs in same.values():
        is_shown, others = all(each.kind != SAID for each in signs), with_texts[id(signs)]
        covered = {each.change for sign in others for each in faults[sign]}
        causes = [each for each in faults[signs[0]] if each.change not in covered]
        why = _caused(causes, names, exploration.line(signs[0].at)) if causes else ""
        if covered:
            told = _told(others, names)
            why = f"with {told} or {why}" if why else f"with {told}"
        is_wrong_here = bool(others) or any(map(is_trouble, signs))
        if is_wrong_here or not is_shown:
            ends = not others and not all(each.goes_on for sign in signs for each in faults[sign])
            begins = [each.begin for each in faults[signs[0]]]
            lamps = [each for some in same.values() if signs[0] in with_texts[id(some)] for each in some]
            lamps = [each for each in lamps if is_shown and each.kind == SWITCHED]
            found.append(Alarm(signs, why, is_wrong_here, begins, ends, lamps=lamps))
    return found


def _with(signs: Sequence[Sign], texts: Sequence[Sign], faults: Mapping[Sign, Sequence[Fault]]) -> list[Sign]:
    """Return the texts with which a lamp comes in each of their plays, if there are several."""
    others = [
        each for each in texts if each not in signs and all(signs[0] in one.together for one in faults[each])
    ]
    return others if len(others) > 1 and all(each.kind != SAID for each in signs) else []


def _told(signs: Sequence[Sign], names: ReaderNames) -> str:
    """Return texts and numbers for a host in words, the numbers of one channel together."""
    found = defaultdict[str, list[str]](list)
    for text in sorted(shown(each, names) for each in signs):
        head, equal, value = text.partition(" = ") if not text.startswith(("'", '"')) else (text, "", "")
        found[head + equal].append(value)
    return _listing([head + _listing(values, "and") for head, values in found.items()], "and")


def _caused(faults: Sequence[Fault], names: ReaderNames, line: int) -> str:
    """Return faults in words, the levels and values of a channel together, with the line of their sign."""
    found = defaultdict[tuple[str, str], list[Change]](list)
    for each in faults:
        time = f" {_seconds(each.seconds)} after line {each.line}" if each.seconds else ""
        behind = f" after {shown(each.behind, names)} {each.times} times" if each.behind is not None else ""
        found[names[each.change.subject], time + behind].append(each.change)
    texts = [f"{in_row(changes, names)}{when}" for (_, when), changes in list(found.items())[:MAX_CAUSES]]
    texts += ["others"] * (len(found) > MAX_CAUSES)
    return f"by {' or '.join(texts)}, line {line}"


def _seconds(seconds: float) -> str:
    return f"{seconds:.2g} s" if seconds < 100.0 else f"{seconds:.0f} s"


def in_row(changes: Sequence[Change], names: ReaderNames) -> str:
    """Return the changes of one channel in words, such as "input 3 (air) off or on" and "key 1 or 2"."""
    subject = "key" if changes[0].table == "key" else names[changes[0].subject]
    levels = [names.of(each).removeprefix(subject).strip() for each in sorted(changes)]
    equal = "= " if levels[0].startswith("= ") else ""
    return f"{subject} {equal}{_listing([each.removeprefix(equal) for each in levels], 'or')}"


def _listing(texts: Sequence[str], word: str) -> str:
    """Return texts in a row, the last one behind a word."""
    return f"{', '.join(texts[:-1])} {word} {texts[-1]}" if len(texts) > 1 else texts[0]


def _others(
    exploration: Exploration,
    structure: Structure,
    names: ReaderNames,
    guards: Guards,
    told: Collection[int],
) -> list[Alarm]:
    """Return the alarms that came by no fault in the good cycle, as they were seen, or as the text says."""
    found, ways, seen = list[Alarm](), dict[int, Transition](), set[int]()
    for way in (each for node in exploration.nodes for each in node.transitions):
        seen |= way.begun
        # What is said at a reset is no alarm.
        on = [number for number, level in way.visit.levels.items() if level]
        on += [each.number for each in way.causes if each.table == "input"]
        for at in () if any(is_reset(names[f"input {each}"]) for each in on) else way.begun:
            ways[at] = min(ways.get(at, way), way, key=lambda one: (len(one.causes), len(one.visit.timeline)))
    for at, each in sorted(structure.statements.items()):
        signs = [] if at in told or not guards.knows(at) else _signs_of(exploration, each, names)
        if signs and at not in seen:
            why = " or ".join(f"{words}, line {line}" for words, line in guards.of(at)[:MAX_CAUSES])
            why = f"by {why}" if why else f"at line {each.line}"
            found.append(Alarm(signs, why, ends=False, is_unplayed=at not in exploration.begun))
        elif signs and at in ways and _says_wrong(exploration, signs[-1], ways[at]):
            found.append(Alarm(signs, f"{_seen(ways[at], structure, names)}, line {each.line}"))
    return found


def _says_wrong(exploration: Exploration, sign: Sign, way: Transition) -> bool:
    """True if what a statement says was wrong on a way: of a number of bad parts it says 0 as well."""
    return sign.kind != SAID or sign.at in exploration.trouble or any(map(is_wrong, way.said))


def _signs_of(exploration: Exploration, statement: Statement, names: ReaderNames) -> list[Sign]:
    """Return what a statement says or switches on in trouble, by its text."""
    written = [use for use in statement.channels if use.access == WRITE and use.value.lower() not in OFF]
    outputs = [f"{use.channel} {use.number}" for use in written]
    signs = [Sign(SWITCHED, statement.at, each) for each in outputs if each in names.alarms]
    is_said = statement.effect == PRINTS and all(use.channel != "answer" for use in statement.channels)
    said = map(str.strip, _TEXT.findall(_CODE.sub("", statement.text))) if is_said else ()
    text = " ... ".join(filter(None, said))
    if text and (is_wrong(text) or statement.at in exploration.trouble):
        signs.append(Sign(SAID, statement.at, text))
    return signs


def _seen(way: Transition, structure: Structure, names: ReaderNames) -> str:
    """Return how the exploration has seen a transition."""
    by = f"by {' and '.join(map(names.of, way.causes)) or 'itself'}"
    where = "at power-up" if way.source is None else f"in {lines_of(way.source, structure.line, MAX_RANGES)}"
    return f"{by} {where}"
