"""The names in `grammars/mccl.lark` that the generator needs.

Only `lang/parsing/generate.py` reads this file.
"""

from __future__ import annotations

# The rule that one pattern matches, and its components that are groups of the pattern.
RULE = "command"
KEPT = ("word", "WHOLE", "REAL", "REGISTER", "TEXT")
# The terminal of a text in quotes, in which a separator ends no command.
QUOTED = "TEXT"
