"""Cautions before a program is changed: what starts the cycle, what cuts off moves, alarms, endless waits.

An input cuts off a move if the exploration has seen it: the input changed in the middle of the move. A wait has no
time-out if nothing came by itself while it lasted.
"""

from __future__ import annotations

import re
from collections import defaultdict
from collections.abc import Collection, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass

from motionlang.kernel.lang import WRITE, Statement, Structure
from motionlang.kernel.tools import ranges
from motionlang_explore.exploration import (
    Change,
    Exploration,
    is_reset,
    is_wrong,
)
from motionlang_explore.map.ends import Ends, Steps
from motionlang_explore.map.names import ReaderNames, is_alarm
from motionlang_explore.map.reasons import DIRECT, MAX_REASONS, QUOTED, Reason, Reasons
from motionlang_explore.map.starts import starts_of
from motionlang_explore.map.stops import stops_of

# The values with which an output is switched off.
_OFF = ("0", "_off", "_false")
# The code of a character is nothing that is said.
_CODE = re.compile(r"""\b(?:Asc\(|INKEY\s*=\s*)["'][^"']*["']""", re.IGNORECASE)
_TEXT = re.compile(r'"([^"]*)"')
_AFTER = re.compile(r"[\d.]+ s ")
# What holds where there is no alarm, as (fault = 0).
_IS_NONE = re.compile(r"= 0\)?$|^not ", re.IGNORECASE)
_NAME = re.compile(r"[A-Za-z_]\w*")


@dataclass(eq=False, slots=True)
class CautionRow:
    """A caution: its kind, the channel or "waits", and what it does, with its lines in words."""

    kind: str
    what: str
    why: str


def cautions(exploration: Exploration, structure: Structure, names: ReaderNames) -> list[CautionRow]:
    """Return the cautions of a machine."""
    reasons = Reasons(structure, names, exploration.world.run.controller.inputs.active_low)
    rows = list(_start(exploration, names))
    if exploration.axes and exploration.channels:
        rows += _stops(exploration, structure, names)
    rows += _alarms(exploration, structure, names, reasons)
    waits = {
        structure.line(at)
        for node in exploration.nodes
        if node.state is not None and all(each.causes for each in node.transitions)
        for place in node.state
        for at in place.statements
        if reasons.waits(at) and not reasons.has_clock(at)
    }
    return [*rows, CautionRow("waits", "waits", f"of {_lines(waits)} have no time-out")] if waits else rows


def _start(exploration: Exploration, names: ReaderNames) -> Iterator[CautionRow]:
    """Yield what starts the cycle, with what else it needs and was played with."""
    starts = starts_of(exploration, names)
    if starts is None:
        return
    what = " and ".join(map(names.of, starts.by)) or "power-up"
    why = f" with {_listed(starts.held, names)}" if starts.held else ""
    following = ", ".join(names[each.subject] for each in starts.following)
    played = [f"with {following} behind an output or an axis"] if following else []
    played += [f"with {_listed(starts.others, names)}"] if starts.others else []
    why += f"; played {' and '.join(played)}" if played else ""
    left = ", ".join(names[each.subject] for each in starts.left)
    why += f"; whether it needs {left} was not played" if left else ""
    yield CautionRow("starts", what, f"start{'' if len(starts.by) > 1 else 's'} the cycle{why}")


def _listed(changes: Iterable[Change], names: ReaderNames) -> str:
    """Return changes in words, the names of the inputs that come on first."""
    on = [names[each.subject] for each in changes if each.table == "input" and each.value]
    return ", ".join(
        [f"{', '.join(on)} on"] * bool(on)
        + [names.of(each) for each in changes if not (each.table == "input" and each.value)]
    )


def _alarms(
    exploration: Exploration, structure: Structure, names: ReaderNames, reasons: Reasons
) -> Iterator[CautionRow]:
    """Yield what says that something is wrong or is said only where the cycle is left, why, and what ends it."""
    found: dict[tuple[bool, object], tuple[dict[str, None], list[str], list[Statement]]] = {}
    usual = _printed(exploration)
    for each in (each for at, each in sorted(structure.statements.items()) if reasons.knows(at)):
        written = [use for use in each.channels if use.access == WRITE]
        causes = reasons.of(each.at) or [
            Reason(f"`{use.value}`", each.line) for use in written if " " in use.value
        ]
        lamps = [names[title] for use in written if (title := f"{use.channel} {use.number}") in names.alarms]
        is_on = any(use.value.lower() not in _OFF for use in written)
        is_question = any(use.channel == "answer" for use in each.channels)
        said = [] if is_question else map(str.strip, _TEXT.findall(_CODE.sub("", each.text)))
        texts = list(filter(None, said))
        shown = [*_NAME.findall(_TEXT.sub("", each.text)), *(use.value for use in written)]
        known = [reasons.values(one, each.at) for one in shown]
        values = next((one for one in known if len(one) > 1), {})
        # Behind the branches of the other numbers there is one left.
        left = [only for one in known if len(one) == 1 for only in one.values()]
        words = {one.words for one in causes}
        causes = next((only for only in left if only and {one.words for one in only} < words), causes)
        # What is said when a fault is reset has no causes of its own.
        is_over = any(map(is_reset, (one.words for one in causes if one.rank == DIRECT)))
        is_number = bool(values) and any(map(is_alarm, (*shown, *texts))) and not is_over
        values = values if is_number else {}  # a step or a count in a text is no number of an alarm
        is_told = min((one.rank for one in causes), default=QUOTED) > QUOTED
        is_left = is_told and each.at not in usual | exploration.world.cycle.begun
        says_wrong = bool(texts) and (is_wrong(" ".join(texts)) or each.at in exploration.trouble)
        says_wrong &= not is_over and each.at not in usual
        is_trouble = is_number or bool(lamps) or says_wrong
        causes = causes or (reasons.waited(each.at) if is_trouble else [])
        if texts and (is_trouble or is_left):
            what = [repr(" ... ".join(texts) + " ..." * bool(values))]
        else:
            hosts = [
                names[f"{use.channel} {use.number}"]
                for use in written
                if is_number and not _IS_NONE.search(use.value)
            ]
            what = lamps if lamps and is_on else hosts
        if what:
            by = [one for some in values.values() for one in some] or causes
            key = frozenset(one.text for one in by) or tuple(what)
            row = found.setdefault((not is_trouble, key), ({}, [], []))
            row[0].update(dict.fromkeys(what))
            why = "; ".join(f"{value}: {_by(reasons_of)}" for value, reasons_of in values.items())
            row[1].append(f"with {why}" if values else _by(causes))
            row[2].append(each)
    ends = Ends(
        exploration,
        [each for (is_only_said, _), row in found.items() if not is_only_said for each in row[2]],
        names,
    )
    for (is_only_said, _), (told, whys, signs) in sorted(found.items(), key=lambda pair: pair[0][0]):
        played = "" if any(each.at in exploration.begun for each in signs) else " (not played)"
        steps = () if played or is_only_said else ends.of(signs, "; ".join(whys))
        is_one = len({*whys}) == 1 and " or " not in whys[0] and not whys[0].startswith("with ")
        back = f"{'' if is_one else 'as it was played, it '}ends by {_joined(steps, names)}" if steps else ""
        back = "what ends it was not played" if steps is None else back
        why = max(whys, key=lambda text: text.startswith("with "))
        verb = (
            ("are printed" if len(told) > 1 else "is printed")
            if is_only_said
            else "come" + "s" * (len(told) < 2)
        )
        yield CautionRow(
            "said" if is_only_said else "alarm",
            " and ".join(told),
            f"{verb} {why}{played}{'; ' if back else ''}{back}",
        )


def _joined(steps: Steps, names: ReaderNames) -> str:
    return ", then ".join(" and ".join(map(names.of, step)) for step in steps)


def _printed(exploration: Exploration) -> frozenset[int]:
    """Return the statements that print in the good cycle of the world; none if it is no good one."""
    run = exploration.world.run
    if run.cycle is None or exploration.fault_of(run):
        return frozenset()
    begin, end = run.cycle.span
    return frozenset(each.at for each in run.machine.log.prints if begin <= each.time < end)


def _by(reasons: Sequence[Reason]) -> str:
    """Return some reasons in words, those with the same words once with all their lines."""
    lines: dict[str, set[int]] = defaultdict(set)
    for each in reasons:
        lines[each.words].add(each.line)
    texts = [f"{words}, {_lines(at)}" if any(at) else words for words, at in lines.items()]
    text = " or ".join(texts[:MAX_REASONS] + ["others"] * (len(texts) > MAX_REASONS))
    after = (
        "" if _AFTER.match(text) or text.startswith("without ") else "after " if text[:1].isdigit() else "by "
    )
    return f"{after}{text}" if text else "by a condition that is not known"


def _stops(exploration: Exploration, structure: Structure, names: ReaderNames) -> Iterator[CautionRow]:
    """Yield what cuts off moves, with their lines and the handler, and what stops the machine between its moves."""
    cut_off, stops = exploration.cut_off(), stops_of(exploration, names)
    for change in stops.cuts:
        cut_off.setdefault(change, set()).add(stops.move)
    yield from _cuts(cut_off, structure, names)
    ways = (each for node in exploration.nodes for each in node.transitions)
    if not cut_off and not any(ended for each in ways for _, ended in each.does.moves):
        yield CautionRow("stops", "nothing that was played", "cuts off a move to a target")
    found: dict[int, list[str]] = defaultdict(list)
    for change, line in stops.lines:
        if change not in cut_off:
            found[line].append(names.of(change))
    for line, changes in sorted(found.items()):
        where = f"behind line {line}" if line else "at the end of its cycle"
        what = " or ".join(changes)
        yield CautionRow("stops", what, f"in the move of line {stops.move} stops the machine {where}")
    if stops.left:
        what = ", ".join(map(names.of, stops.left))
        yield CautionRow("stops", "whether the machine stops", f"by {what} was not played")


def _cuts(
    cut_off: Mapping[Change, Collection[int]], structure: Structure, names: ReaderNames
) -> Iterator[CautionRow]:
    units = {
        f"{each.channel} {each.number}": unit.title for unit in structure.units for each in unit.triggers
    }
    channels: dict[str, list[Change]] = defaultdict(list)
    for one in sorted(cut_off, key=lambda each: (each.table, each.number, each.value)):
        channels[one.subject].append(one)
    found: dict[str, list[str]] = defaultdict(list)
    for subject, (first, *others) in channels.items():
        cuts = [f"cuts off moves of {_lines(cut_off[first])}"]
        cuts += [
            f"{names.of(one).removeprefix(names[subject]).strip()} those of {_lines(cut_off[one])}"
            for one in others
        ]
        found[", ".join(cuts) + (f" by {units[subject]}" if subject in units else "")].append(names.of(first))
    yield from (CautionRow("stops", " or ".join(changes), cuts) for cuts, changes in found.items())


def _lines(lines: Collection[int]) -> str:
    return f"line{'s' if len(lines) > 1 else ''} {ranges(lines)}"
