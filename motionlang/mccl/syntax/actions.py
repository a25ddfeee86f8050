"""The parts of a command of `grammars/mccl.lark` that the parser returns.

Only `lang/parsing/generate.py` reads this file.
"""

from __future__ import annotations

# The rule that one pattern matches, and the parts that are groups of the pattern.
RULE = "command"
KEPT = ("word", "WHOLE", "REAL", "REGISTER", "TEXT")
# The text to match: all up to a separator, a comment or the end of the line, unless in quotes.
PIECE = r'(?:[^, \t\n;"]++|"[^"\n]*+(?:"|$))++'
