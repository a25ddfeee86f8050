"""The table parser: runs the LALR tables that `motionlang.lang.parsing.generate` made from a `.lark` file.

It exists because Lark's own driver, exact as it is, is ten times slower and costs 40 ms at start-up. Lark
still decides everything: which states there are, what they shift and what they reduce. What is done here:

* the text is cut up by one `re.findall`; a token's kind is looked up once for every distinct text;
* a state is a dict from kind to action, filled from its row of the table when first visited;
* a run of one-symbol reductions (an operand climbs eleven levels of operators) is worked out once for each
  (state, kind, state below) and is one dict lookup from then on;
* reducers work in place on the stack of values. The value of a token is its ordinal, so that every node knows
  where it stands at no cost; its text is `texts[ordinal]`.
"""

from __future__ import annotations

import gc

from motionlang.lang.parsing.patterns import compiled

TYPE_CHECKING = False
if TYPE_CHECKING:
    import re
    from collections.abc import Callable, Iterable, Iterator
    from typing import Any

    Reducer = Callable[[list[Any], list[str]], None]
    # Number of symbols, name of the left side, reducer (None where the value stays as it is).
    Rule = tuple[int, str, Reducer | None]

END = "$END"  # Lark's name for the end of the text
BAD = "BAD"  # the kind of a token that no grammar knows
CONTINUING = (
    "_ ",
    "_\t",
    "_\n",
    "_'",
)  # what the end of a line that goes on may begin with, besides a backslash
new = object.__new__  # for the reducers, which fill in what they make


class Stuck(Exception):
    """No action for a token, whose ordinal it carries: a mistake in the text."""


class TooDeep(Exception):
    """The blocks of the program are nested deeper than later stages can follow."""


class State(dict[str, "State | Action"]):
    """What to do on a kind of token, and where to go after a reduction."""

    __slots__ = ("default", "number", "row", "tables")

    def __init__(self, tables: Automaton, number: int, row: str) -> None:
        self.tables, self.number, self.row = tables, number, row
        self.default: Rule | None = None

    __hash__ = object.__hash__  # type: ignore[assignment]  # a state is a key by what it is, not holds
    __eq__ = object.__eq__

    def __missing__(self, kind: str) -> State | Action:
        """Find the action when it is first wanted; `NOTHING`, which is not kept, where there is none."""
        if self.row:
            self._fill()
            if kind in self:
                return self[kind]
        if self.default is None or kind not in self.tables.kinds:
            return NOTHING
        action = self[kind] = Action(self.default, kind)
        return action

    def _fill(self) -> None:
        """Read the row: `target=kind,kind …`, a target being a state, a rule `r5` or the default rule `d5`."""
        row, self.row = self.row, ""
        tables = self.tables
        for entry in row.split():
            target, _, kinds = entry.partition("=")
            if target[0] == "d":
                self.default = tables.rules[int(target[1:])]
            elif target[0] == "r":
                rule = tables.rules[int(target[1:])]
                for kind in kinds.split(","):
                    self[kind] = Action(rule, kind)
            else:
                state = tables.states[int(target)]
                for kind in kinds.split(","):
                    self[kind] = state

    def step(self, kind: str) -> State | Action | None:
        """The action on a kind, None where there is none."""
        action = self[kind]
        return None if action is NOTHING else action


class Action(dict[State, "tuple[Reducer, tuple[Reducer, ...], State, State | Action]"]):
    """A reduction on one kind: from the state below to the reducers to call, the state to go to, its action.

    One reducer is all there is, mostly: the first stands apart from the others.
    """

    __slots__ = ("kind", "length", "rule")

    def __init__(self, rule: Rule, kind: str) -> None:
        self.rule, self.kind = rule, kind
        self.length = rule[0]

    def __missing__(self, below: State) -> tuple[Reducer, tuple[Reducer, ...], State, State | Action]:
        """Follow the reductions of one symbol that come next, as far as they go."""
        reducers: list[Reducer] = []
        rule = self.rule
        while True:
            if rule[2] is not None:
                reducers.append(rule[2])
            state = below[rule[1]]
            assert isinstance(state, State)
            action = state[self.kind]
            if not isinstance(action, Action) or action.length != 1:
                break
            rule = action.rule
        first, *others = reducers or (_nothing,)
        self[below] = found = first, tuple(others), state, action
        return found


def _nothing(values: list[Any], texts: list[str]) -> None:
    """The reducer of a symbol that is only renamed."""


# What a state has to do on a kind that does not fit.
NOTHING = Action((-1, "", None), BAD)


class Kinds(dict[str, str]):
    """From the text of a token to its kind; a text is looked at once."""

    __slots__ = ("_classes", "_literals", "limit")

    def __init__(self, literals: dict[str, str], classes: dict[str, str]) -> None:
        self._literals = literals
        self._classes = [(name, compiled(pattern)) for name, pattern in classes.items()]
        self.limit = 50_000

    def __missing__(self, text: str) -> str:
        kind = self[text] = self._literals.get(text.lower()) or self._class(text)
        return kind

    def _class(self, text: str) -> str:
        for name, pattern in self._classes:
            if pattern.fullmatch(text):
                return name
        return BAD if text else END

    def trim(self) -> None:
        """Forget, lest a long session that parses many programs keep every number it ever saw."""
        if len(self) > self.limit:
            self.clear()


class Automaton:
    """The LALR(1) table of a grammar: its states, and the kinds of token that they tell apart."""

    def __init__(self, kinds: Iterable[str], rules: Iterable[Rule], rows: Iterable[str], finish: int) -> None:
        self.kinds = {*kinds, END}
        self.rules = tuple(rules)
        self.states = [State(self, number, row) for number, row in enumerate(rows)]
        self.start, self.finish = self.states[0], self.states[finish]
        self.finish[END] = self.finish  # the end of the text is shifted like any token


class Tables(Automaton):
    """A grammar at work: the table, what cuts a text into tokens, and what the rules make of them."""

    def __init__(
        self,
        token: str,
        continued: str,
        literals: dict[str, str],
        classes: dict[str, str],
        rules: Iterable[Rule],
        rows: Iterable[str],
        finish: int,
    ) -> None:
        super().__init__({*literals.values(), *classes}, rules, rows, finish)
        self.token, self.continued = token, continued
        self._token: re.Pattern[str] | None = None
        self._continued: re.Pattern[str] | None = None
        self.kind_of = Kinds(literals, classes)

    def continues(self, text: str) -> bool:
        """May the text have lines that go on in the next one? The pattern that knows of them is slower."""
        return "\\" in text or text.endswith("_") or any(sign in text for sign in CONTINUING)

    def pattern(self, text: str) -> re.Pattern[str]:
        """What cuts up a text."""
        if self.continues(text):
            if self._continued is None:
                self._continued = compiled(self.continued)
            return self._continued
        if self._token is None:
            self._token = compiled(self.token)
        return self._token

    def end(self, text: str) -> str:
        """What ends the last line of a text, even if that would go on in a next one."""
        return "\n\n" if self.continues(text) else "" if text.endswith("\n") else "\n"

    def matches(self, text: str) -> Iterator[re.Match[str]]:
        """The tokens one by one; the text of each is group 1."""
        return self.pattern(text).finditer(text + self.end(text))

    def texts(self, text: str) -> list[str]:
        """The tokens of a text, with an empty one for its end; the last line need not be ended."""
        texts: list[str] = self.pattern(text).findall(text + self.end(text))
        texts.append("")
        return texts

    def spans(self, text: str) -> list[tuple[int, int]]:
        """The offsets of the tokens that `texts` returns, those made up for the end left out."""
        return [match.span(1) for match in self.matches(text)]

    def parse(self, texts: list[str]) -> Any:
        """The value of the start rule; raises `Stuck` or `TooDeep`."""
        self.kind_of.trim()
        collecting = gc.isenabled()
        gc.disable()  # a tree has no cycles, and the collector would look at it again and again
        try:
            kinds = [*map(self.kind_of.__getitem__, texts)]  # all at once: the memory is read in its order
            return _run(self.start, kinds, texts)
        finally:
            if collecting:
                gc.enable()


def _run(state: State, kinds: Iterable[str], texts: list[str]) -> Any:
    """The shift-reduce loop; long, because a call for each token would cost more than the work itself.

    The top of the stack is `state`, and `states` what lies below it.
    """
    states: list[Any] = []
    values: list[Any] = []
    push, pop, push_value = states.append, states.pop, values.append
    action: Any
    for at, kind in enumerate(kinds):
        action = state[kind]
        while action.__class__ is not State:
            length = action.length
            if length == 3:
                pop()
                pop()
            elif length > 3:
                del states[1 - length :]
            elif length == 2:
                pop()
            elif length == 0:
                push(state)
            elif length < 0:
                raise Stuck(at)
            reduce, others, state, action = action[states[-1]]
            reduce(values, texts)
            if others:
                for reduce in others:
                    reduce(values, texts)
        push(state)
        push_value(at)
        state = action
    return values[0]
