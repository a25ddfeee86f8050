"""The tests that an iteration of a polling loop makes on the values it reads.

A value is in the accumulator until a command sets the accumulator again. If the commands in between only
compare it with numbers or test its bits, the iteration depends on the results of these tests, and not on the
value itself.

A command that does more than read, such as 1ST, is left out: the iterations that are compared had no effect, so a
condition has skipped it, and does so until the result of a test changes.
"""

from __future__ import annotations

from collections.abc import Sequence
from math import ceil, floor

from motionlang.mccl.resolve.command import NUMBER, REGISTER, TEXT, Command
from motionlang.record import record

# By the index of a command that reads: the commands that test its value; None if it is used for anything else.
Tests = dict[int, tuple[Command, ...] | None]

# Commands that compare the whole accumulator with a number, those that test one of its bits, and commands without
# effect on it.
COMPARES = frozenset(("if_below", "if_equal", "if_greater", "if_unequal"))
BIT_TESTS = frozenset(("if_set", "if_clear"))
JUMPS = frozenset(("jump", "jump_by", "repeat"))
# Commands that leave the accumulator alone, those that set it, and those that govern the next ones.
NEUTRAL = JUMPS | {"nothing", "channel_on", "channel_off", "do_if_on", "do_if_off", "if_on", "if_off"}
SETS = frozenset(
    (
        "load",
        "recall",
        "look_up",
        "get_analog",
        "read_byte",
        "read_word",
        "read_long",
        "read_float",
        "read_double",
    )
)
# Commands that read the low bits of a value, which pass a number each time they wrap.
LOW_BITS = frozenset(("read_byte", "read_word"))
CONDITIONS = COMPARES | BIT_TESTS | {"if_on", "if_off"}
# Commands that continue somewhere else or later.
LEAVES = frozenset(("call_macro", "jump_macro", "leave", "wait"))
_LEAVES_LINE = LEAVES - {"wait"}


def tests_of(commands: Sequence[Command], governs: int) -> Tests | None:
    """Return the tests of each value that an iteration without effects reads.

    A condition governs `governs` commands. None if the iteration may use the accumulator of the one
    before, or leaves its line.
    """
    verbs = [each.verb for each in commands]
    # Commands that set the accumulator in every iteration, unless a jump skips some of them.
    certain = [
        verb in SETS
        and not _takes_accumulator(commands[k])
        and not CONDITIONS.intersection(verbs[max(0, k - governs) : k])
        for k, verb in enumerate(verbs)
    ]
    straight = not {"jump", "jump_by"}.intersection(verbs[:-1])
    uses = [k for k, each in enumerate(commands) if each.pure and _concerns_accumulator(each)]
    if _LEAVES_LINE.intersection(verbs[:-1]) or not uses or not certain[uses[0]]:
        return None
    found: Tests = {}
    for here, verb in enumerate(verbs):
        if verb in SETS:
            end = next((k for k in range(here + 1, len(verbs)) if certain[k] and straight), len(verbs))
            after = [k for k in uses if here < k < end]
            allowed = BIT_TESTS if verb in LOW_BITS else COMPARES | BIT_TESTS
            is_tested = all(verbs[k] in allowed and not _takes_accumulator(commands[k]) for k in after)
            found[here] = tuple([commands[k] for k in after]) if is_tested else None
    return found


@record
class Reading:
    """The tests of a value that a loop reads.

    `bits` are the bits that it tests, None if it also compares the value. `levels` are those at which the result of a
    comparison with a number changes, None if there are tests of other kinds. `by_register` are the comparisons with
    registers.
    """

    verb: str
    bits: tuple[int, ...] | None
    levels: tuple[float, ...] | None
    by_register: tuple[Command, ...]


def readings_of(commands: Sequence[Command], governs: int) -> dict[int, Reading | None] | None:
    """Return the values that an iteration reads, by index, as in `tests_of`."""
    found = tests_of(commands, governs)
    if found is None:
        return None
    return {k: None if tests is None else _reading(commands[k].verb, tests) for k, tests in found.items()}


def _reading(verb: str, tests: Sequence[Command]) -> Reading:
    bits = [int(each.value) for each in tests if each.verb in BIT_TESTS and each.kind == NUMBER]
    numbers = [each for each in tests if each.kind == NUMBER]
    compared = {level for each in numbers for level in levels(each, float(each.value), verb)}
    compares = all(each.verb in COMPARES for each in tests)
    return Reading(
        verb,
        tuple(bits) if len(bits) == len(tests) else None,
        tuple(sorted(compared)) if compares else None,
        tuple([each for each in tests if each.kind != NUMBER]),
    )


def levels(test: Command, limit: float, reading: str) -> tuple[float, ...]:
    """Return the levels at which the result of comparing a value with `limit` changes.

    `reading` is the verb of the command that reads the value. RL cuts its fraction off.
    """
    if reading != "read_long":
        return (limit,)
    if test.verb == "if_greater":
        firsts = [floor(limit) + 1]
    elif test.verb == "if_below":
        firsts = [ceil(limit)]
    else:
        firsts = [int(limit), int(limit) + 1] if limit == floor(limit) else []
    # A whole number above 0 is read from itself on, one up to 0 from above the number before it on.
    return tuple([float(first if first > 0 else first - 1) for first in firsts])


def _concerns_accumulator(command: Command) -> bool:
    return (command.verb not in NEUTRAL and command.verb != "wait") or _takes_accumulator(command)


def _takes_accumulator(command: Command) -> bool:
    """True if a command takes the accumulator as its parameter: RL@0, RA0."""
    return command.value == 0 and (
        command.kind == REGISTER or (command.verb == "recall" and command.kind != TEXT)
    )
