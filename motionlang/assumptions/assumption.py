"""The record of an assumption, and of the probe that tests it."""

from __future__ import annotations

from collections.abc import Sequence

from motionlang.record import record

# Printed facts are not open, nor are those shown by running code.
SETTLED = ("manual", "code")
# The answers of a separate program that prints nothing: the compiler rejects it, or it ends with an error,
# which the handler of the program reports.
REFUSED, ERROR = "refused", "an error"


class Probe:
    """The question for the owner of a controller.

    `before`, `ask` and `after` are lines of the language, of Mint's `ask` the operands of PRINT; `{a}` is the
    axis and `{d}` a distance, for a probe that needs `motion`. `answers` are the controller's replies, that
    of the chosen assumption first, then those of the alternatives; a text that begins with `re:` is a
    pattern. If the answer is a number, `form` is the pattern around it, and `scale` its factor. A question
    that writes settings, may be rejected or may end with an error is asked `alone`, by a program of its own;
    lines `behind` its End are subs, tasks and handlers, `error` is the operands of PRINT for an error;
    `needs` states the wiring or preparation, and `machine` is a machine file that gives it to the virtual
    controller.
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


@record
class Assumption:
    """One question that the sources leave open, and the chosen answer.

    `name` is that of the machine file's `[assumptions]`, `alternatives` are the other answers, `why` the reason
    for the `chosen` one, `strength` one of `facts.STRENGTHS`. `words` are the keywords whose use makes a
    program depend on it, in the spelling of the language, `@motor` for a machine with a simulated motor and
    `@always` for any. `probe` is the question for a controller, None if there is none; `key` is that of the
    machine file which sets the assumption, "" if it is no value that could be set. An `own` one is a choice
    of this program, such as the form of a report: no controller has another answer.
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
        """True if another answer is equally possible: no manual or code confirms this one."""
        return self.strength not in SETTLED
