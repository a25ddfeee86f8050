"""The position of a moving axis is compared for equality, which is rarely true.

    PAUSE POS(0) = 100
    LU"POSITION",1RL@0,IE500,BK,NO,JR-4

The axis may pass a position between two readings. In Mint the analysis of the axes shows that it moves. In MCCL a line
that repeats and reads a position is assumed to wait for a move.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from motionlang.commands.check.axis_state import IDLE, MOVES
from motionlang.commands.check.mccl.loops import REPEATS
from motionlang.commands.check.mint.conditions import Unattainable, awaited
from motionlang.commands.check.rule import Rule, RuleCase, Warn
from motionlang.commands.check.rule_facts import spelt
from motionlang.kernel.mint.syntax import nodes
from motionlang.kernel.mint.syntax.traversal import meant, walk

if TYPE_CHECKING:
    from motionlang.commands.check.axis_state import AllAxes, AxisFacts
    from motionlang.commands.check.mccl.mccl_facts import MacroFacts
    from motionlang.commands.check.mint.mint_facts import MintFacts
    from motionlang.kernel.lang import AxisKey as Key

# Functions of Mint's keywords, names of MCCL's variables, and functions of the commands that read these and compare.
_POSITIONS = frozenset(("position", "demand"))
_VARIABLES = frozenset({"POSITION", "AUXPOSITION"})
_READS = frozenset({"read_word", "read_long", "read_float", "read_double"})
_EQUALITIES = {"if_equal": "IG{0} is true behind {0}, IB{0} before it",
               "if_unequal": "IB{0} is true before {0}, IG{0} behind it"}  # fmt: skip


def check_mint(facts: MintFacts, warn: Warn) -> None:
    unattainable = Unattainable(facts)
    for function in facts.functions:
        before = facts.axes.before[function]
        for p, node in facts.nodes_of(function):
            if p in before and facts.is_test(p):
                _equalities(facts, node, None, before[p], warn)
        for each in awaited(facts, function):
            if not each.polls or unattainable.why(each.condition, each.truth, each.state) is None:
                _equalities(facts, each.condition, each.truth, each.state, warn)


def _equalities(facts: MintFacts, node: nodes.Node, truth: bool | None, state: AllAxes, warn: Warn) -> None:
    """Report comparisons for equality of the position of a moving axis.

    `truth` is the value for which a program waits, None if it only branches.
    """
    for each in walk([node]):
        if type(each) is not nodes.Binary or each.op not in ("=", "<>"):
            continue
        for side, other in ((each.left, each.right), (each.right, each.left)):
            name = meant(side)
            if type(name) is not nodes.Name or name.row is None or name.row.function not in _POSITIONS:
                continue
            key = facts.key_of(name)
            axis = facts.axes.known(state, key)
            wanted = truth is not None and (each.op == "=") is truth
            if axis.motion == MOVES or (wanted and axis.motion != IDLE):
                what = f"{name.row.name}({spelt(key)})"
                number = facts.number(other) if name.row.function == "position" else None
                message = (
                    f"{what} is compared for equality while axis {spelt(key)} moves, which is rarely true"
                )
                warn(message, each.start, _instead(what, key, axis, number))
                break


def _instead(what: str, key: Key, axis: AxisFacts, number: float | None) -> str:
    """Return what to write in place of a comparison with a number."""
    if number is None:
        return "compare it with >= or <="
    if number == axis.target:
        return f"PAUSE IDLE({spelt(key)}) waits for the end of the move"
    if axis.span is not None and axis.target == axis.span[0] < axis.span[1]:
        return f"{what} <= {number:.10g} stays true from there on"
    if axis.span is not None and axis.target == axis.span[1] > axis.span[0]:
        return f"{what} >= {number:.10g} stays true from there on"
    return f"compare it with >= {number:.10g} or <= {number:.10g}, as the axis moves"


def check_mccl(facts: MacroFacts, warn: Warn) -> None:
    # What the registers hold: the name of a variable whose address LU has looked up. Register 0 is the accumulator.
    names: dict[int, str] = {}
    for line in facts.lines:
        polls = any(command.function in REPEATS | {"jump_macro"} for command in line.commands)
        position = False
        for command, at in zip(line.commands, line.offsets, strict=True):
            function = command.function
            if function in _EQUALITIES:
                if position and polls:
                    message = f"{command.text} compares a moving position for equality, which is rarely true"
                    warn(message, at, _EQUALITIES[function].format(f"{command.value:.10g}"))
                continue
            if function == "look_up":
                names[0] = str(command.value).upper()
            elif function == "store" and command.number is not None:
                names[command.number] = names.get(0, "")
            elif function in _READS:
                position = names.get(int(command.value), "") in _VARIABLES  # @n: its value is the register
                names[0] = ""
                continue
            elif command.axis == 0 and function not in REPEATS | {"jump_macro"}:
                names[0] = ""
            position = False


RULE = Rule(
    code="exact-position",
    text="""\
A wait or a loop goes on until POS equals a number, or an If compares POS for equality while the axis certainly moves.
A moving axis is at 100 for an instant, and the program reads its position before and after that. Compare with `>=` or
`<=`, or wait for the end of the move. In MCCL: IE or IU after a reading of `POSITION`, in a line that repeats itself.
""",
    fix="compare with >= or <=, or wait for the end of the move",
    mint=RuleCase(
        check_mint,
        wrong="MOVER(0) = 200 : GO(0)\nPAUSE POS(0) = 100\nOUTX(1) = 1\n",
        right="MOVER(0) = 200 : GO(0)\nPAUSE POS(0) >= 100\nOUTX(1) = 1\n",
    ),
    mccl=RuleCase(
        check_mccl,
        wrong='1MN\nMD3,LU"POSITION",1RL@0,IE500,BK,NO,RP\n',
        right='1MN\nMD3,LU"POSITION",1RL@0,IG500,BK,NO,RP\n',
    ),
)
