"""What is kept of a command of `grammars/mccl.lark`; read by `lang/parsing/generate.py` alone."""

from __future__ import annotations

# The rule that one pattern matches, and its parts that the pattern has groups for.
RULE = "command"
KEPT = ("word", "WHOLE", "REAL", "REGISTER", "TEXT")
# What is to match it: all up to a separator, a comment or the end of the line, quotes protecting these.
PIECE = r'(?:[^, \t\n;"]++|"[^"\n]*+(?:"|$))++'
