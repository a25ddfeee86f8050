"""Verbs of commands by what they do, for several rules."""

# Commands that start a motion, and those of them that move to a position.
MOVES = frozenset(
    {
        "move_to", "move_by", "go_home", "go", "move_to_point", "find_index", "find_edge", "path", "slave", "jog_on",
    }
)  # fmt: skip
POSITIONING = frozenset({"move_to", "move_by", "go_home", "move_to_point"})
# Commands that wait for the end of a motion.
WAITS = frozenset({"wait_stop", "wait_target"})
# Commands that repeat the line or jump within it, those after which it does not continue, and calls of macros.
REPEATS = frozenset({"repeat", "jump", "jump_by"})
LEAVES = frozenset({"jump_macro", "leave"})
CALLS = frozenset({"call_macro", "jump_macro", "start_task"})
_CONDITIONS = frozenset(
    {
        "if_below", "if_equal", "if_greater", "if_unequal", "if_set", "if_clear", "if_on", "if_off", "do_if_on",
        "do_if_off",
    }
)  # fmt: skip
# A line with one of these may continue anywhere. Macros are not followed, so the state of an axis after such a line
# is unknown.
ELSEWHERE = REPEATS | LEAVES | CALLS | _CONDITIONS | {"define_macro"}
