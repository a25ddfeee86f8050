"""A wait for a condition that cannot change, or that the motion of the axes never makes true.

Nothing changes a variable that no other task and no event sets, the position of an axis at rest, or an input that no
entry of the machine file drives. Motion never leads to standstill in a jog that nothing stops, nor to a position beyond
the ends of all moves so far.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from motionlang.commands.check.mint.changes import at_rest, unchanging, unchanging_loops
from motionlang.commands.check.mint.conditions import MARGIN, Unattainable, awaited
from motionlang.commands.check.rule import Rule, RuleCase, Warn
from motionlang.kernel.mint.syntax import nodes

if TYPE_CHECKING:
    from motionlang.commands.check.axis_state import AllAxes, AxisFacts
    from motionlang.commands.check.mccl.mccl_facts import MacroFacts
    from motionlang.commands.check.mint.mint_facts import MintFacts
    from motionlang.kernel.lang import Use

_WHEN_ENDS = {True: "ends at once or never", False: "never ends"}
_ENTRY = "; add an [[input]] entry"
# Verbs of MCCL's commands with which a channel without a signal is on.
_POLARITIES = frozenset({"channel_low"})
# Waits of MCCL for an input, and for a position.
_INPUT_WAITS = frozenset({"wait_on", "wait_off"})
_POSITION_WAITS = frozenset({"wait_relative", "wait_position"})


def check_mint(facts: MintFacts, warn: Warn) -> None:
    unattainable = Unattainable(facts)
    for function in facts.functions:
        reached = facts.reached(function)
        for p, node in facts.nodes_of(function):
            state = facts.axes.before[function].get(p)
            if p in reached and state is not None and type(node) is nodes.Pause:
                _pause(facts, node, state, warn)
        for loop, inputs in unchanging_loops(facts, function):
            goes_on = at_rest(facts, loop.condition)
            if inputs and (goes_on is None or bool(goes_on) is (type(loop) is nodes.While)):
                word = "While" if type(loop) is nodes.While else "Repeat"
                why = "no entry of the machine file drives it"
                message = f"this {word} waits for a condition that cannot change: {why}"
                warn(message, loop.condition.start, f"it {_WHEN_ENDS[goes_on is None]}{_ENTRY}")
        for each in awaited(facts, function):
            found = unattainable.why(each.condition, each.truth, each.state) if each.polls else None
            if found is not None:
                warn(f"this waits for a condition that cannot change: {found[0]}", each.at, found[1])


def _pause(facts: MintFacts, node: nodes.Pause, state: AllAxes, warn: Warn) -> None:
    """Report a PAUSE if nothing that its condition depends on may change."""
    found = unchanging(facts, node, state)
    if found is None:
        return
    value = at_rest(facts, node.condition)
    if value:
        return
    moving = [number for kind, number in found if kind == "position"]
    if not found:
        why = "no other task and no event changes it"
    elif moving:
        why = f"axis {moving[0]} is at rest"
    else:
        why = "no entry of the machine file drives it"
    hint = "it continues at once or never" if value is None else f"it never continues{_ENTRY}"
    warn(f"this waits for a condition that cannot change: {why}", node.start, hint)


def check_mccl(facts: MacroFacts, warn: Warn) -> None:
    _check_inputs(facts, warn)
    for part, states in facts.axes.before.items():
        for p, statement in facts.statements_of(part):
            for use in statement.uses if p in states else ():
                if use.row is not None and use.row.function in _POSITION_WAITS and use.number(0) is not None:
                    axis = facts.axes.known(states[p], use.axes[0])
                    _check_position(use, statement.text, axis, warn)


def _check_position(use: Use, text: str, axis: AxisFacts, warn: Warn) -> None:
    """Report a WR for more than the only move since standstill, and a WP beyond the ends of all moves so far."""
    key, number = use.axes[0], use.number(0)
    assert use.row is not None
    assert number is not None
    if use.row.function == "wait_relative" and axis.distance and abs(number) > axis.distance:
        message = f"{text} never ends: axis {key} moves only {axis.distance:.10g}"
        warn(message, use.at, f"wait for less, or for the end of the move with {key}WS")
    if use.row.function == "wait_position" and axis.span is not None:
        low, high = axis.span
        margin = MARGIN * (high - low)
        if low < high and not low - margin <= number <= high + margin:
            message = f"{text} never ends: axis {key} moves between {low:.10g} and {high:.10g}"
            warn(message, use.at, "wait for a position that a move reaches")


def _check_inputs(facts: MacroFacts, warn: Warn) -> None:
    """Report waits for inputs that no entry of the machine file drives."""
    driven = facts.driven_inputs()
    inverted = any(command.function in _POLARITIES for command, _ in facts.commands)
    outputs = {command.number for command, _ in facts.commands if command.function == "channel_output"}
    if driven is None or None in outputs:
        return
    for command, at in facts.commands:
        channel = command.number
        if command.function not in _INPUT_WAITS or channel is None or channel in outputs | driven:
            continue
        if channel not in facts.model.outputs and (inverted or command.function == "wait_on"):
            message = f"{command.text} waits for channel {channel}, which no entry of the machine file drives"
            when = "it continues at once or never" if inverted else "it never continues"
            warn(message, at, f"{when}{_ENTRY}")


RULE = Rule(
    code="endless-wait",
    text="""\
PAUSE waits for a value that cannot change meanwhile: a variable that no other task and no event sets, the position of
an axis at rest, or an input that no entry of the machine file drives. The wait ends at once or never; an input that
nothing drives is off, so a wait for off is no mistake. The warning also covers a While or Repeat that only polls such
an input, and WN in MCCL. If there is no machine file, or it has only `controller` and `run` keys, every input may
change, and there is no warning for inputs.

Two more waits never end. One is for standstill while the axis jogs and nothing stops it: no input, limit, error or
handler of the program, and no machine file. The other is for a position that no move so far leads to, such as
`PAUSE POS(0) > 300` after a move from 0 to 200; in MCCL, a WR for more than the distance of its move, and a WP for a
position that no move leads to.
""",
    fix="wait for something that changes, or stop the axis first",
    mint=RuleCase(
        check_mint,
        wrong="JOG(0) = 5\nPAUSE IDLE(0)\n",
        right="JOG(0) = 5\nWAIT = 100\nSTOP(0)\nPAUSE IDLE(0)\n",
    ),
    mccl=RuleCase(check_mccl, wrong="1MN,1MR100,1WR200\n", right="1MN,1MR100,1WR50\n"),
)
