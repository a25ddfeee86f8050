"""The rules of the inputs together: the run judges which of those that may explain an input are right.

Problem. Several rules explain the recorded changes of an input, and some are false: a valve that a button switches
explains the button, too, if the presses come at regular times. No form of a rule tells a cause from its effect.

Idea. The program runs. A rule is right if the run with it switches the recorded outputs and changes the input as it was
recorded. A rule that makes an input follow what the input itself leads to never begins.

    the likeliest rule of each input      if all of it agrees, that is it
    all inputs as recorded                what the program does with what was recorded
    one input after the other             its rules in their order, until one agrees as well as its recorded changes

If the recording begins while the machine runs, the second step is left out, and a rule must agree better than others:
marks are matched in their order, wherever the run has them.

So the suspect is always the one input whose rule has changed. If a cause had no effect at a time, a rule is judged up
to there. Times count from the mark before, so that an entry that comes late moves what follows, and does not spoil it.

Cost: a run for each rule that is tried, `MAX_RUNS` at most, each as long as the recording.
"""

from __future__ import annotations

from bisect import bisect_left, bisect_right
from collections import defaultdict
from collections.abc import Callable, Mapping, Sequence
from math import inf
from typing import NamedTuple

from motionlang.kernel import Run
from motionlang_explore.identification import (
    Digital,
    Entry,
    LevelChange,
    MeasuredRule,
    as_recorded,
    channels,
    rules_of,
)
from motionlang_explore.init.recorded.levels import levels_of
from motionlang_explore.init.recorded.outcome import SWAPPED, Label, OutcomeMark, matched, near
from motionlang_explore.init.recorded.recording import MeasuredRecording
from motionlang_explore.scenario_text import inline

# Runs that are tried, and rules of one input.
MAX_RUNS, MAX_RULES = 60, 8
# A time since the mark before may differ by this share of it.
SHARE = 0.01
# So large a share of the outputs may differ, since marks in the same row have no order.
OUTPUTS = 0.02

# A rule is clearly better if so many more marks agree, as a share.
BETTER = 0.1
# A rule is confirmed if this share of the recorded changes is in the run.
CONFIRMED = 0.5

Play = Callable[[Mapping[str, object]], Run]
Rules = dict[int, MeasuredRule]


class JudgedRules(NamedTuple):
    """The rules with which the run agrees best, this run, and the rules that the run has refuted."""

    rules: Rules
    run: Run
    refuted: tuple[MeasuredRule, ...]


class _Attempt(NamedTuple):
    """A run with some rules."""

    rules: Rules
    run: Run

    def agreement(self, recording: MeasuredRecording, until: float = inf) -> _Agreement:
        return _agreement(self.run, recording, self.rules, until)

    @property
    def until(self) -> float:
        """The first time at which a cause had no effect, s."""
        return min((each for rule in self.rules.values() for each in rule.missed), default=inf)


class _Agreement(NamedTuple):
    """How many recorded marks and changes of inputs a run has at the right time, less those that it has besides."""

    outputs: int
    inputs: dict[int, int]

    @property
    def total(self) -> int:
        return self.outputs + sum(self.inputs.values())


def judged(recording: MeasuredRecording, play: Play) -> JudgedRules:
    """Return the rules of the inputs with which the run agrees best; `play` runs the program with settings."""
    candidates = {
        number: rules_of(number, each, recording) for number, each in sorted(recording.inputs.items())
    }

    def attempt(rules: Rules) -> _Attempt:
        return _Attempt(rules, play(settings_of(rules, recording)[0]))

    best = attempt({number: rules[0] for number, rules in candidates.items()})
    refuted: list[MeasuredRule] = []
    count = 1
    if not _is_whole(best, recording):
        if not recording.is_late:  # else the program is elsewhere when the recording begins
            replayed = attempt(recorded_rules(recording))
            if not replayed.agreement(
                recording
            ).outputs:  # a homing without a switch: nothing can be judged yet
                return JudgedRules(_confirmed(best, recording), best.run, ())
            best = max(replayed, best, key=lambda each: each.agreement(recording).total)
        for number in sorted(candidates, key=lambda each: _begin(recording.inputs[each])):
            for rule in candidates[number][:MAX_RULES]:
                if (rule == best.rules[number] and not recording.is_late) or count >= MAX_RUNS:
                    break
                count += 1
                other = attempt({**best.rules, number: rule})
                if _is_as_good(other, best, number, recording):
                    best = other
                    if not recording.is_late:
                        break
                else:
                    refuted.append(rule)
    return JudgedRules(_confirmed(best, recording), best.run, tuple(refuted))


def _confirmed(attempt: _Attempt, recording: MeasuredRecording) -> Rules:
    """Return rules, as guesses those with which most changes of the input are not in the run."""
    until = attempt.until
    found = attempt.agreement(recording, until).inputs
    return {
        number: rule._replace(
            is_confirmed=found[number]
            >= CONFIRMED * sum(each.time < until for each in recording.inputs[number].changes)
        )
        for number, rule in attempt.rules.items()
    }


def recorded_rules(recording: MeasuredRecording) -> Rules:
    """Return the changes of all inputs as recorded."""
    return {
        number: as_recorded(number, each) if each.changes else rules_of(number, each, recording)[0]
        for number, each in sorted(recording.inputs.items())
    }


def settings_of(
    rules: Mapping[int, MeasuredRule], recording: MeasuredRecording
) -> tuple[dict[str, object], dict[str, str]]:
    """Return the settings with the rules of the inputs and the levels of a recording, and a comment of each entry."""
    comments: dict[str, str] = {}
    inputs: list[Entry] = []
    for rule in rules.values():
        for entry, text in zip(rule.entries, rule.comments, strict=True):
            made = {**entry, "guess": True} if rule.is_guess else entry
            inputs.append(made)
            comments[inline(made)] = text + missed_text(rule)
    levels = [
        each for number, series in sorted(recording.analogue.items()) for each in levels_of(number, series)
    ]
    comments |= {inline(entry): text for entry, text in levels}
    given: dict[str, object] = {"input": inputs} if inputs else {}
    if levels:
        given["analogue"] = [entry for entry, _ in levels]
    return given, comments


def missed_text(rule: MeasuredRule) -> str:
    if not rule.missed:
        return ""
    times = ", ".join(f"{each:.4g}" for each in rule.missed[:3])
    more = f" and {len(rule.missed) - 3} more" if len(rule.missed) > 3 else ""
    return f"; not after {rule.subject} at {times} s{more}"


def _begin(channel: Digital) -> float:
    return channel.changes[0].time if channel.changes else inf


def _is_whole(attempt: _Attempt, recording: MeasuredRecording) -> bool:
    """True if a run has all recorded marks but for those whose order is not known, and all changes of the inputs."""
    until = attempt.until
    found = attempt.agreement(recording, until)
    theirs = [each for each in matched(attempt.run, recording).theirs if each.time < until]
    return found.outputs >= (1.0 - OUTPUTS) * len(theirs) - SWAPPED and all(
        found.inputs[number] >= sum(each.time < until for each in channel.changes)
        for number, channel in recording.inputs.items()
    )


def _is_as_good(other: _Attempt, best: _Attempt, number: int, recording: MeasuredRecording) -> bool:
    """True if a run with another rule of an input agrees as well with the recording as the best one.

    If the recording begins late, the best one is no replay, and the other must be clearly better.
    """
    until = min(other.until, best.until)
    mine, theirs = other.agreement(recording, until), best.agreement(recording, until)
    if recording.is_late:
        is_placed = other.rules[number].is_explained  # in time, which is not that of the run
        return is_placed and mine.total > theirs.total + max(SWAPPED, BETTER * theirs.total)
    return mine.inputs[number] >= theirs.inputs[number] and mine.total >= (
        1.0 - OUTPUTS
    ) * theirs.total - min(SWAPPED, OUTPUTS * theirs.total)


def _agreement(run: Run, recording: MeasuredRecording, rules: Rules, until: float) -> _Agreement:
    """Return how far a run agrees with a recording up to a time."""
    found = matched(run, recording)
    pairs = [(found.mine[a], found.theirs[b]) for a, b in found.pairs]
    pairs = [each for each in pairs if each[1].label[0] == "output"] or pairs
    clock = _Clock([(mine.time, theirs.time) for mine, theirs in pairs])
    marks: dict[Label, tuple[list[OutcomeMark], list[OutcomeMark]]] = defaultdict(lambda: ([], []))
    for mine in sorted(found.mine):
        marks[mine.label][0].append(mine)
    for theirs in sorted(found.theirs):
        marks[theirs.label][1].append(theirs)
    outputs = sum(
        _agreeing(
            [LevelChange(each.time, 1) for each in right],
            [LevelChange(each.time, 1) for each in own],
            clock,
            near(recording),
            recording,
            until,
        )
        for own, right in marks.values()
    )
    made = channels((each.channel, each.time, each.value) for each in run.machine.log.inputs)
    inputs = {
        number: _agreeing(
            channel.changes,
            made[number].changes if number in made else (),
            clock,
            near(recording) + rules[number].spread,
            recording,
            until,
        )
        for number, channel in recording.inputs.items()
    }
    return _Agreement(outputs, inputs)


class _Clock:
    """The time of a run at a time of the recording, by the mark before that both have."""

    def __init__(self, pairs: list[tuple[float, float]]) -> None:
        self._pairs = [(0.0, 0.0), *pairs]
        self._theirs = [each[1] for each in self._pairs]

    def time(self, theirs: float) -> float:
        return theirs + self._pair(theirs)[0] - self._pair(theirs)[1]

    def since(self, theirs: float) -> float:
        """The time since that mark, s."""
        return theirs - self._pair(theirs)[1]

    def _pair(self, theirs: float) -> tuple[float, float]:
        return self._pairs[max(bisect_right(self._theirs, theirs) - 1, 0)]


def _agreeing(
    recorded: Sequence[LevelChange],
    changes: Sequence[LevelChange],
    clock: _Clock,
    tolerance: float,
    recording: MeasuredRecording,
    until: float,
) -> int:
    """Return how many recorded changes a run has, less those that it has besides."""
    times = [each.time for each in changes]
    used: set[int] = set()
    for theirs, level, _ in recorded:
        apart = tolerance + SHARE * clock.since(theirs)
        close = (
            k
            for expected in (theirs, clock.time(theirs))
            for k in range(bisect_left(times, expected - apart), bisect_right(times, expected + apart))
        )
        found = next((k for k in close if k not in used and changes[k].level == level), None)
        if found is not None and theirs < until:
            used.add(found)
    end = clock.time(min(until, recording.end)) - tolerance
    besides = (time for k, time in enumerate(times) if k not in used and tolerance < time < end)
    return len(used) - sum(not recording.has_gap(time - tolerance, time + tolerance) for time in besides)
