"""Functions of commands by what they do, for several rules."""

# Commands that start a motion.
MOVES = frozenset(
    {
        "move_to", "move_by", "go_home", "go", "move_to_point", "find_index", "find_edge", "path", "slave", "jog_on",
    }
)  # fmt: skip
# Commands that repeat the line or jump within it, and those after which it does not continue.
REPEATS = frozenset({"repeat", "jump", "jump_by"})
LEAVES = frozenset({"jump_macro", "leave"})
