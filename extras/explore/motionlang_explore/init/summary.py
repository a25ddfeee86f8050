"""Lines for the engineer about a run with guesses: which input leads on from where, and what never happened."""

from __future__ import annotations

from bisect import bisect_right
from collections.abc import Collection, Iterator

from motionlang.commands.channels import channels_of, only_named
from motionlang.kernel import Run
from motionlang.kernel.lang import HOST_CHANNELS, WRITE, Structure, names_in_comments
from motionlang.kernel.tools import count_of, numbered
from motionlang_explore.exploration import SHORTEST_MOVE, Change, Exploration, StateNode, is_probe
from motionlang_explore.init import Draft
from motionlang_explore.init.file import leading, quoted, standstill
from motionlang_explore.map.behaviour import never_run

# So much of what was not reached is shown.
SHOWN = 5


def _move_lines(structure: Structure) -> set[int]:
    return {each.line for each in structure.statements.values() if each.moves}


def motionless(structure: Structure, result: Run) -> str:
    """Return what moved in a run that did no motion of its program, in words; "" if it did, or has none.

    A homing is none if the program commands more, nor is a move of no distance, or one that is cut off at once.
    """
    homes, homed = result.dialect.table().homes, set[int]()
    for move in result.machine.log.moves:
        profile = move.profile
        if profile is None or not profile.peak_speed or (move.ended and profile.duration < SHORTEST_MOVE):
            continue
        if not homes(move.command):
            return ""
        homed.add(move.line)
    if not _move_lines(structure) - homed:
        return ""
    return "no axis moved but for a homing" if homed else "no axis moved"


def notes(structure: Structure, draft: Draft) -> list[str]:
    """Return one line for each thing that an engineer checks first."""
    result, exploration = draft.run, draft.exploration
    guessed = sorted({int(str(each["channel"])) for each in draft.entries("input")})
    leads = leading(exploration)
    found = [
        f"input {each} leads on from {numbered('line', leads[each])}" for each in guessed if each in leads
    ]
    never = _never_on(structure, result)
    if never:
        found.append(f"{numbered('output', never)} {'were' if len(never) > 1 else 'was'} never switched on")
    found += [f"cycle: {result.cycle}"] if result.cycle is not None else []
    still = motionless(structure, result)
    found += [] if still else _unmoved(structure, result)
    found += _unused(result)
    if not exploration.is_whole:
        found.append(
            f"{count_of(exploration.trials, 'trial')} played, and more could be tried: --seconds 120 plays on"
        )
    if what := exploration.fault_of(result):
        found.append(f"no good piece was found: the best cycle {what}")
        missed = list(_not_reached(structure, exploration))
        found += [text for _, text in missed[:SHOWN]]
        name = exploration.program.source.name
        read = _read_before(structure, result, min((line for line, _ in missed), default=0))
        first = next((f", that of input {each} first" for each in read if each in guessed), "")
        found.append(
            f"to find by hand what leads there: motionlang panel {name}; or correct an entry{first}, remove its "
            f"guess = true, and let motionlang init {name} --update search the rest"
        )
    if still:
        moved = {each.line for each in result.machine.log.moves}
        line = min(_move_lines(structure) - moved or _move_lines(structure))
        found.append(f"{still}, and line {line} commands motion")
        found += _stays(exploration)
    if stands := standstill(result):
        found.append(stands)
    return found


def _read_before(structure: Structure, result: Run, line: int) -> Iterator[int]:
    """Yield the inputs for which a run waits, and those that the lines before a line read, the nearest first."""
    scheduler = result.machine.scheduler
    waits = [task.wait for task in scheduler.tasks if not task.done] if scheduler is not None else []
    yield from (each for wait in waits if wait is not None and wait.cause == "input" for each in wait.what)
    for each in sorted(structure.statements.values(), key=lambda each: -each.line):
        uses = each.channels if each.line <= line else ()
        yield from (int(use.number) for use in uses if use.channel == "input" and use.number.isdecimal())


def _not_reached(structure: Structure, exploration: Exploration) -> Iterator[tuple[int, str]]:
    """Yield the lines of what no trial has printed, moved or sent to a host, with the condition on the way there."""
    rows = list(never_run(exploration, structure))
    firsts, begun = [each.first for each in rows], exploration.begun
    for each in structure.statements.values() if rows else ():
        row = rows[max(bisect_right(firsts, each.line) - 1, 0)]
        sends = any(use.access == WRITE and use.channel in HOST_CHANNELS for use in each.channels)
        if (
            row.first <= each.line <= row.last
            and each.at not in begun
            and (sends or each.moves or '"' in each.text)
        ):
            why = f" ({row.why})" if row.why else ""
            yield each.line, f"not reached: line {each.line}, {quoted(each.text)}{why}"


def _stays(exploration: Exploration) -> list[str]:
    """Return where the program stays: the states that it comes to with the most changes, and what was tried there."""
    lasting = [each for each in exploration.nodes if each.state is not None and each.first.lasts]
    most = max((len(each.first.timeline) for each in lasting), default=0)
    found = []
    for node in lasting:
        if len(node.first.timeline) < most or node.state is None:
            continue
        lines = sorted({exploration.line(at) for place in node.state for at in place.statements})
        reads = exploration.reads(node.state)
        if node.first.question is not None:
            reads.append(f"an answer to {node.first.question!r}")
        text = f"waits in {numbered('line', lines)}" + (f" for {' or '.join(reads)}" if reads else "")
        # An answer that is taken leads on, be it to the same question.
        is_taken = node.first.question is None or bool(node.transitions)
        tried = f"tried {_tried(node, reads)}" if is_taken else "no answer was taken"
        found.append(text if tried == "tried " else f"{text}; {tried}")
    return found


def _tried(node: StateNode, reads: Collection[str]) -> str:
    values: dict[str, dict[str, None]] = {}
    for change in (each for causes in node.tried for each in causes):
        if change.subject in reads and not is_probe(change):
            values.setdefault(change.subject, {})[_value(change)] = None
    parts = []
    for subject, texts in values.items():
        digits = [each for each in "0123456789" if each in texts]
        others = [each for each in texts if each not in digits or len(digits) < 10]
        shown = ", ".join([*(["0 to 9"] if len(digits) == 10 else []), *others])
        parts.append(shown if len(values) == 1 else f"{subject} {shown}")
    return "; ".join(parts)


def _value(change: Change) -> str:
    if change.table == "input":
        return "on" if change.value else "off"
    if change.table == "key":
        return str(change).removeprefix("key ")
    return change.value if isinstance(change.value, str) else f"{change.value:.10g}"


def _unmoved(structure: Structure, result: Run) -> list[str]:
    """Return the lines that command motion and moved no axis, in a run that moved any."""
    moved = {each.line for each in result.machine.log.moves}
    lines = sorted(_move_lines(structure) - moved) if moved else []
    verb = "commands" if len(lines) == 1 else "command"
    return [f"{numbered('line', lines)} {verb} motion and moved no axis"] if lines else []


def _unused(result: Run) -> list[str]:
    """Return the inputs and outputs that comments name and the program does not use, a sentence each."""
    program = result.program or result.dialect.program(result.source)
    return [
        f"{each.kind} {each.number} ({each.name}): named in the comment of line {each.line}, never used"
        for each in only_named(
            names_in_comments(result.source, result.dialect), channels_of(program, result.dialect)
        )
    ]


def _never_on(structure: Structure, result: Run) -> list[int]:
    """Return the outputs that the program switches and that stayed off."""
    switched = set[int]().union(*(each.outputs for each in structure.statements.values()))
    return sorted(switched - {each.channel for each in result.machine.log.outputs if each.value})
