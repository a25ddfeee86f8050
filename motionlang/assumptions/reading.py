"""What an open reading is, and how a controller is asked which of its answers holds."""

from __future__ import annotations

from collections.abc import Sequence

from motionlang.record import record

# What a source prints is not open, nor what running code shows.
SETTLED = ("manual", "code")
# What answers a question that a program of its own asks, where nothing is printed: the compiler takes no such program,
# or it ends with an error, which the handler of the program tells.
REFUSED, ERROR = "refused", "an error"


class Probe:
    """How the owner of a controller asks it.

    `before`, `ask` and `after` are lines of the language, of Mint's `ask` what a PRINT shows; `{a}` is the axis and
    `{d}` a distance, of a probe that needs `motion`. `answers` are what a controller says to it, that of the reading
    chosen first, then those of the alternatives; a text that begins with `re:` is a pattern. Where a number is asked
    for, `form` is the pattern around it, and `scale` what it is multiplied with. What writes settings, may be refused
    or may end with an error is asked `alone`, by a program of its own; lines `behind` its End are subs, tasks and
    handlers, `error` is what a PRINT shows of an error; `needs` says what must be wired or done first, and `machine` is
    a machine file that gives it to the virtual controller.
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
class Reading:
    """One question that somebody had to answer, and the answer.

    `name` is that of the machine file's `[assumptions]`, `alternatives` are the other answers, `why` the reason for the
    one `chosen`, `strength` one of `facts.STRENGTHS`; `words` are those whose use makes a program depend on it,
    in the spelling of the language, `@motor` for a machine with a simulated motor and `@always` for any. `probe` is how
    a controller is asked, None where it cannot be; `key` is that of the machine file which sets the reading, "" where
    it is no value that could be set. What is `own` is this program's own matter, such as the form of a report: no
    controller has another answer.
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
        """Whether another answer is as possible: no manual prints this one, and no code shows it."""
        return self.strength not in SETTLED
