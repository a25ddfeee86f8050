"""A program as a list of steps: both languages become the same few kinds.

What a step computes is a function of `values`, the variables of the running call; where the program goes next is an
integer. So the state of a task is three things, which can be copied, compared, stored and shown, and a task goes on
from any copy of them:

    pc        the index of its next step, in a list of steps
    calls     for each call it is in: where that continues, and with which values
    values    the variables of the innermost call

Time. Each statement takes the same time, so a task counts statements and the time is base + count × cost, never a
running sum (`statement_time.py`). MCCL pays for a statement before it (COMMAND), Mint after it (`cost`).

Invariants
- Only COMMAND, NOW and jumps back know of time. Nothing else happens between two of them.
- A step has no memory: all that it changes is in `values`, in shared variables, or in the machine.
- What a step does with variables is in its `Uses`, which may have too many reads and too few sets, never the reverse.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Iterable
from typing import Any, NamedTuple

# The values of a call.
Values = list[Any]

# The kinds of step. `do` is what it computes, `to` another step.
DO = 0  # do it
NOW = 1  # let happen what is due by now, then set the clock
COMMAND = 2  # a statement begins: let other tasks that are ready go first, then pay its time; then do it
BRANCH = 3  # go on if `do` is true, else at `to`
JUMP = 4  # go on at `to`
BACK = 5  # the end of an iteration: let happen what is due, then go back to `to`; with `do`, go back if that is true
GO = 6  # `do` returns the index of the next step
WAIT = 7  # `do` returns what to wait for, or None
TRY = 8  # like WAIT, but it is done again after the wait
TURN = 9  # let other tasks go at the next step that knows of time
CALL = 10  # `do` returns the steps of a call and its values
ENTER = 11  # the same, without return
RETURN = 12  # let other tasks go first, do it, and go back to the caller; `do` returns the result
END = 13  # do it; the task ends
NOTE = 14  # do it, for the log: a loop begins or ends
BEGIN = 15  # a statement begins, before which a debugger may stop

# What the kinds are called in a list of steps.
NAMES = {
    DO: "do",
    NOW: "now",
    COMMAND: "command",
    BRANCH: "branch",
    JUMP: "jump",
    BACK: "back",
    GO: "go",
    WAIT: "wait",
    TRY: "try",
    TURN: "turn",
    CALL: "call",
    ENTER: "enter",
    RETURN: "return",
    END: "end",
    NOTE: "note",
    BEGIN: "begin",
}

# The roles of steps that a reader of the flow has to know; any other step has none.
TEST = "test"  # the condition of an If or of a loop: it goes on if that is true,
UNTIL = "until"  # or if it is false
ENDLESS = "endless"  # the condition of a loop that is written to run forever, such as While 1
HEAD = "head"  # the limit of a counting loop,
NEXT = "next"  # and where it counts
STOP = "stop"  # the end of the program, where it is a statement


class Step(NamedTuple):
    """One step.

    `at` is the offset of its statement in the text, -1 if it has none; `cost` is the number of statements that it pays.
    """

    kind: int
    do: Callable[[Values], Any] | None = None
    to: int = -1
    at: int = -1
    cost: float = 0.0


class Uses(NamedTuple):
    """The variables that a step uses: those of a call have numbers from -1 down, shared ones from 0 up."""

    reads: frozenset[int] = frozenset()
    sets: frozenset[int] = frozenset()
    # Those among `reads` that it uses for more than sums and comparisons,
    nonlinear: frozenset[int] = frozenset()
    # and those that it only tests: a test of a reading says itself when its result changes.
    tests: frozenset[int] = frozenset()
    # Those among `reads` that it only takes from a clock, which says itself when a test of the difference turns.
    spans: frozenset[int] = frozenset()
    # The variables that it changes in part: an element or a member.
    parts: frozenset[int] = frozenset()
    # Those among `sets` that it sets to a reading, which says so.
    copies: frozenset[int] = frozenset()


NOTHING = Uses()


class Steps(list[Step]):
    """The steps of a program, or of a part of it that is called.

    `uses` has what each step does with variables, None if that is unknown.
    """

    def __init__(self) -> None:
        super().__init__()
        self.uses: list[Uses | None] = []
        # What loops do with variables, by their first and last step; worked out on demand.
        self.bodies: dict[tuple[int, int], Any] = {}
        # The roles of steps that have one.
        self.roles: dict[int, str] = {}
        # The names of labels, by their steps.
        self.labels: dict[int, str] = {}
        # The statements of loops, by their last step.
        self.loops: dict[int, Any] = {}
        # What they were written from: only positions in the same text can be compared.
        self.origin: object = None
        # The unit that they are, unique in a program: two writings of one program have steps of the same names.
        self.name = ""
        # Its name for people, and the line of steps without a statement; 0 if they are of no line.
        self.title, self.line_number = "", 0
        # The steps that a CALL or an ENTER leads to, and the first of them, by its index, if known before the run.
        self.called: dict[int, tuple[Steps, int]] = {}
        # The step after each statement whose failure the program handles, by the steps of the statement.
        self.behind: dict[int, int] = {}

    def add(
        self,
        kind: int,
        do: Callable[[Values], Any] | None = None,
        to: int = -1,
        at: int = -1,
        uses: Uses | None = NOTHING,
        cost: float = 0.0,
        role: str = "",
    ) -> int:
        """Append a step and return its index."""
        self.append(Step(kind, do, to, at, cost))
        self.uses.append(uses)
        if role:
            self.roles[len(self) - 1] = role
        return len(self) - 1

    def following(self, pc: int) -> list[int]:
        """Return the steps of the list that may follow a step, that of a true condition first.

        A call is passed over, and the step after a return and that of a computed jump are unknown.
        """
        kind, do, to, _, _ = self[pc]
        is_endless = self.roles.get(pc) == ENDLESS
        if kind in (RETURN, END, ENTER):
            return []
        if kind in (JUMP, GO):
            return [to] if to >= 0 else []
        if kind == BACK:
            return [to] if do is None or is_endless else [to, pc + 1]
        if kind == BRANCH and not is_endless:
            return [pc + 1, to]
        return [pc + 1]

    def set_target(self, index: int, to: int) -> None:
        """Set the step to which a step jumps."""
        self[index] = self[index]._replace(to=to)

    def guard(self, first: int, end: int) -> None:
        """Let the program go on at `end` if a step from `first` on fails; inner statements come first."""
        for index in range(first, end):
            self.behind.setdefault(index, end)


def own(number: int) -> int:
    """Return the number in `Uses` of a variable of a call."""
    return -1 - number


def conditions(steps: Iterable[Step]) -> list[tuple[int, int]]:
    """Return the index of each step that tests a condition, and its number among those of its statement."""
    numbers: Counter[int] = Counter()
    found = []
    for pc, step in enumerate(steps):
        if step.kind == BRANCH or (step.kind == BACK and step.do is not None):
            found.append((pc, numbers[step.at]))
            numbers[step.at] += 1
    return found
