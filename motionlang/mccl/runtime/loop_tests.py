"""The tests that an iteration of a polling loop makes on the values it reads.

A value is in the accumulator until a command sets the accumulator again. If the commands in between only
compare it with numbers or test its bits, the iteration depends on the results of these tests, and not on the
value itself.
"""

from __future__ import annotations

from motionlang.mccl.resolve.command import REGISTER, TEXT

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Sequence

    from motionlang.mccl.resolve.command import Command

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


def tests_of(commands: Sequence[Command], governs: int) -> Tests | None:
    """Return the tests of each value that an iteration reads.

    A condition governs `governs` commands. None if the iteration may use the accumulator of the one
    before, or does more than read and test.
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
    first = next((k for k, verb in enumerate(verbs) if verb not in NEUTRAL), len(verbs))
    pure = all(each.pure for each in commands) and not LEAVES.intersection(verbs[:-1])
    if not pure or first == len(verbs) or not certain[first]:
        return None
    found: Tests = {}
    for here, verb in enumerate(verbs):
        if verb in SETS:
            end = next((k for k in range(here + 1, len(verbs)) if certain[k] and straight), len(verbs))
            uses = [k for k in range(here + 1, end) if verbs[k] not in NEUTRAL]
            allowed = BIT_TESTS if verb in LOW_BITS else COMPARES | BIT_TESTS
            is_tested = all(verbs[k] in allowed for k in uses)
            is_tested = is_tested and not any(map(_takes_accumulator, commands[here + 1 : end]))
            found[here] = tuple([commands[k] for k in uses]) if is_tested else None
    return found


def _takes_accumulator(command: Command) -> bool:
    """True if a command takes the accumulator as its parameter: RL@0, RA0."""
    return command.value == 0 and (
        command.kind == REGISTER or (command.verb == "recall" and command.kind != TEXT)
    )
