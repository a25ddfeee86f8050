"""The record of an assumption, and of the probe that tests it."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

# Printed facts are not open, nor are those shown by running code.
SETTLED = ("manual", "code")
# The answers of a separate program that prints nothing: the compiler rejects it, or it ends with an error,
# which the handler of the program reports.
REFUSED, ERROR = "refused", "an error"


class Probe:
    """A question that the owner of a controller can answer by a program.

    `before`, `ask` and `after` are lines of the language; Mint's `ask` has the operands of PRINT. `{a}` is the
    axis and `{d}` a distance, for a probe that needs `motion`. `answers` are the possible replies of a
    controller: first the one for the chosen assumption, then those for the alternatives. A text that begins
    with `re:` is a pattern. If the answer is a number, `form` is the pattern around it, and `scale` its factor.
    A question that writes settings, may be rejected or may end with an error is asked `alone`, in a program of
    its own. The lines `behind` that program's End are subs, tasks and handlers, and `error` has the operands of
    PRINT for an error. `needs` states the wiring or preparation, and `machine` is a machine file that provides
    it to the virtual controller.
    """

    def __init__(
        self,
        language: str,
        ask: str,
        *,
        before: Sequence[str] = (),
        after: Sequence[str] = (),
        answers: Sequence[str] = (),
        form: str = "",
        scale: float = 1.0,
        motion: bool = False,
        alone: bool = False,
        behind: Sequence[str] = (),
        error: str = "",
        needs: str = "",
        machine: str = "",
    ) -> None:
        assert answers, ask
        assert alone or not (behind or needs), ask
        self.language, self.ask, self.before, self.after = language, ask, tuple(before), tuple(after)
        self.answers, self.form, self.scale, self.motion = tuple(answers), form, scale, motion
        self.alone, self.behind, self.needs = alone, tuple(behind), needs
        self.machine = machine
        self.error = error or f'"{ERROR}"' * (ERROR in self.answers)


@dataclass(eq=False, slots=True)
class Assumption:
    """A question that the sources leave open, and the chosen answer.

    `name` is the key in the machine file's `[assumptions]`. `alternatives` are the other answers, `why` is the
    reason for the `chosen` one, and `strength` one of `facts.STRENGTHS`. `words` are the keywords whose use
    makes a program depend on it, in the spelling of the language, `@motor` for a machine with a simulated motor
    and `@always` for any. `probe` is the question for a controller, None if there is none. `key` is the
    machine-file key that sets the assumption, "" if it is not a value that can be set. If it is `own`, it is a
    choice of this program, such as the form of a report, for which a controller has no answer.
    """

    name: str
    question: str
    chosen: str
    strength: str
    why: str = ""
    words: tuple[str, ...] = ()
    alternatives: tuple[str, ...] = ()
    probe: Probe | None = None
    key: str = ""
    own: bool = False

    @property
    def is_open(self) -> bool:
        """True if another answer is equally possible, as no manual or code confirms this."""
        return self.strength not in SETTLED
