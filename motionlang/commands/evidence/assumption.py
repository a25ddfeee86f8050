"""The record of an assumption."""

from __future__ import annotations

from dataclasses import dataclass

# Printed facts are not open, nor are those shown by running code.
SETTLED = ("manual", "code")


@dataclass(eq=False, slots=True)
class Assumption:
    """A question that the sources leave open, and the chosen answer.

    `name` is the key in the machine file's `[assumptions]`. `alternatives` are the other answers, `why` is the
    reason for the `chosen` one, and `strength` one of `facts.STRENGTHS`. `words` are the keywords whose use
    makes a program depend on it, in the spelling of the language, `@motor` for a machine with a simulated motor
    and `@always` for any. `key` is the machine-file key that sets the assumption, "" if it is not a value that can be
    set. If it is `own`, it is a choice of this program, such as the form of a report, for which a controller has no
    answer.
    """

    name: str
    question: str
    chosen: str
    strength: str
    why: str = ""
    words: tuple[str, ...] = ()
    alternatives: tuple[str, ...] = ()
    key: str = ""
    own: bool = False

    @property
    def is_open(self) -> bool:
        """True if another answer is equally possible, as no manual or code confirms this."""
        return self.strength not in SETTLED
