"""What somebody may have meant by two letters that are no command."""

from __future__ import annotations

from motionlang.mccl.keywords import TABLE

# Words of English, and of Mint, that people type where MCCL wants two letters.
_WORDS = {
    "MOVE": "MA or MR", "MOVEA": "MA", "MOVER": "MR", "SPEED": "SV", "VEL": "SV", "ACCEL": "SA", "DECEL": "DS",
    "STOP": "ST", "ABORT": "AB", "HOME": "GH, FI or FE", "WAIT": "WA, WS or WT", "SCALE": "US", "ON": "MN",
    "OFF": "MF", "ENABLE": "MN", "DISABLE": "MF", "POS": "TP", "PRINT": "TP or TR", "REPEAT": "RP", "RESET": "RT",
    "STATUS": "TS", "HELP": "HE", "IDLE": "WS",
}  # fmt: skip


def hint(word: str) -> str:
    """A sentence that helps, or nothing."""
    upper = word.upper()
    if upper in _WORDS:
        return f"did you mean {_WORDS[upper]}?"
    if len(upper) > 2:
        return "a command is two letters and its parameter; commands are separated by commas"
    swapped = TABLE.get(upper[::-1])
    if swapped is not None and upper[0] != upper[1]:
        return f"did you mean {swapped.name}? {swapped.help}"
    alike = [row.name for row in TABLE if row.name[0] == upper[0]]
    return f"the commands that begin with {upper[0]} are {', '.join(sorted(alike))}" if alike else ""
