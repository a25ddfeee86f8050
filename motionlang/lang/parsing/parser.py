"""The table parser: runs the LALR tables that `motionlang.lang.parsing.generate` made from a `.lark` file.

It exists because Lark's own driver, exact as it is, is ten times slower and costs 40 ms at start-up. Lark
still decides everything: which states there are, what they shift and what they reduce. What is done here:

* the text is cut up by one `re.findall`; a token's kind is looked up once for every distinct text;
* a state is read from its row of the table when first visited, and what it does is a look into a dict from then on;
* a run of symbols that are only renamed (an operand climbs eleven levels of operators) is worked out once for each
  (state, kind, state below) and is one dict lookup from then on;
* the loop itself is written for the grammar (`motionlang.lang.parsing.driver`). The value of a token is its ordinal, so
  that every node knows where it stands at no cost; its text is `texts[ordinal]`.
"""

from __future__ import annotations

import gc
import re

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable, Iterable, Iterator
    from typing import Any

    Moves = dict[str, Any]
    # The stack below its topmost value, the moves of the state there, and that value: None below the first.
    Stack = Any
    # From the stack, the moves of the state on it, the topmost value and the texts of the tokens to stack and value.
    Reducer = Callable[[Stack, Moves, Any, list[str]], tuple[Stack, Any]]
    # Number of symbols, name of the left side, reducer: None where the value stays as it is, a code where the driver
    # makes it itself.
    Rule = tuple[int, str, Reducer | int | None]
    Driver = Callable[[Moves, list[str], list[str]], Any]

END = "$END"  # Lark's name for the end of the text
BAD = "BAD"  # the kind of a token that no grammar knows
CONTINUING = (
    "_ ",
    "_\t",
    "_\n",
    "_'",
)  # what the end of a line that goes on may begin with, besides a backslash
new = object.__new__  # for the reducers, which fill in what they make

# What a state does on a kind of token is a code and what goes with it:
SHIFT = -1  # the moves of the state that follows
LEAF = -2  # a shift to what the token after it may show to be a value by itself: what `leaf` knows of that
CALL = 99  # a reducer to be called, and the key of the reduction; the codes below it are reductions of the driver's own


class Stuck(Exception):
    """No action for a token: a mistake in the text."""


class TooDeep(Exception):
    """The blocks of the program are nested deeper than later stages can follow."""


class State:
    """What to do on a kind of token, and where to go after a reduction.

    `moves` is what the driver has met of both by now, a plain dict, as it is looked into at every token: what is done
    on a kind under the kind, what comes after a reduction that began here under its key, and the state itself under "".
    """

    __slots__ = ("_actions", "_row", "default", "moves", "number", "tables")

    def __init__(self, tables: Automaton, number: int, row: str) -> None:
        self.tables, self.number, self._row = tables, number, row
        self._actions: dict[str, State | Rule | None] = {BAD: None}
        self.default: Rule | None = None
        self.moves: Moves = {"": self}

    def step(self, kind: str) -> State | Rule | None:
        """The state that a kind of token is shifted to, the rule that is reduced on it, None where it does not fit."""
        if self._row:
            self._fill()
        return self._actions.get(kind, self.default)

    def after(self, rule: Rule) -> State:
        """The state after a reduction by a rule that began here."""
        return self._actions[rule[1]]  # type: ignore[return-value]  # what began here has been read

    def end(self) -> None:
        """Shift the end of the text like any token."""
        self._actions[END] = self

    def _fill(self) -> None:
        """Read the row: `target=kind,kind …`, a target being a state, a rule `r5` or the default rule `d5`."""
        row, self._row = self._row, ""
        tables, actions = self.tables, self._actions
        for entry in row.split():
            target, _, kinds = entry.partition("=")
            if target[0] == "d":
                self.default = tables.rules[int(target[1:])]
            elif target[0] == "r":
                actions.update(dict.fromkeys(kinds.split(","), tables.rules[int(target[1:])]))
            else:
                actions.update(dict.fromkeys(kinds.split(","), tables.states[int(target)]))


# The driver calls these three where it meets something for the first time.


def move(moves: Moves, kind: str) -> tuple[int, Any]:
    """What to do on a kind; what does not fit is shifted to where nothing fits."""
    if not moves:
        raise Stuck
    state: State = moves[""]
    action = state.step(kind)
    if action is None:
        return SHIFT, {}
    if isinstance(action, State):
        found = (LEAF, {"": (state, action, kind)}) if kind in state.tables.leaves else (SHIFT, action.moves)
    else:
        found = _reduction(state.tables, action, kind)
    moves[kind] = found
    return found


def _reduction(tables: Automaton, rule: Rule, kind: str) -> tuple[int, Any]:
    key = f"{id(rule):x} {kind}"
    tables.reductions[key] = rule, kind
    reducer = rule[2]
    return (reducer, key) if isinstance(reducer, int) else (CALL, (reducer or _same, key))


def _same(stack: Stack, moves: Moves, top: Any, texts: list[str]) -> tuple[Stack, Any]:
    """The reducer of a symbol that is only renamed."""
    return stack, top


def goto(below: Moves, key: str) -> tuple[Moves, int, Any]:
    """The state after a reduction and what it does, past all symbols that are only renamed."""
    state: State = below[""]
    rule, kind = state.tables.reductions[key]
    while True:
        after = state.after(rule)
        action = after.step(kind)
        if action.__class__ is not tuple or action[0] != 1 or action[2] is not None:
            break
        rule = action
    below[key] = found = after.moves, *(after.moves.get(kind) or move(after.moves, kind))
    return found


def leaf(target: dict[str, Any], kind: str) -> tuple[int, Moves, int, Any]:
    """What the kind after a token shows: which value it is by itself, or 0, the state after it and what that does."""
    state, action, own = target[""]
    number, reducer = state.tables.leaves[own]
    rule = action.step(kind)
    if isinstance(rule, tuple) and rule[2] is reducer:
        found = number, *goto(state.moves, _reduction(state.tables, rule, kind)[1][1])
    else:
        found = 0, action.moves, *(action.moves.get(kind) or move(action.moves, kind))
    target[kind] = found
    return found


class Kinds(dict[str, str]):
    """From the text of a token to its kind; a text is looked at once."""

    __slots__ = ("_classes", "_literals", "limit")

    def __init__(self, literals: dict[str, str], classes: dict[str, str]) -> None:
        self._literals = literals
        self._classes = [(name, re.compile(pattern, re.ASCII)) for name, pattern in classes.items()]
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
        self.start = self.states[0]
        self.states[finish].end()
        # The kinds of token that may be a value by themselves: the number and the reducer of that.
        self.leaves: dict[str, tuple[int, Reducer]] = {}
        # The reductions that the driver has met, each a rule on a kind of token, by their keys.
        self.reductions: dict[str, tuple[Rule, str]] = {}


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
        leaves: dict[str, tuple[int, Reducer]],
        driver: Driver,
    ) -> None:
        super().__init__({*literals.values(), *classes}, rules, rows, finish)
        self.leaves, self._driver = leaves, driver
        self.token, self.continued = token, continued
        self._token: re.Pattern[str] | None = None
        self._continued: re.Pattern[str] | None = None
        self.kind_of = Kinds(literals, classes)
        self._asked = "", False  # the last text that `continues` was asked for, and the answer

    def continues(self, text: str) -> bool:
        """May the text have lines that go on in the next one? The pattern that knows of them is slower."""
        if text is not self._asked[0]:
            found = "\\" in text or text.endswith("_") or any(sign in text for sign in CONTINUING)
            self._asked = text, found
        return self._asked[1]

    def pattern(self, text: str) -> re.Pattern[str]:
        """What cuts up a text."""
        if self.continues(text):
            if self._continued is None:
                self._continued = re.compile(self.continued, re.ASCII)
            return self._continued
        if self._token is None:
            self._token = re.compile(self.token, re.ASCII)
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

    def kinds_of(self, texts: list[str]) -> list[str]:
        """The kinds of the tokens of a text."""
        self.kind_of.trim()
        return [*map(self.kind_of.__getitem__, texts)]

    def parse(self, texts: list[str], kinds: list[str]) -> Any:
        """The value of the start rule; raises `Stuck` or `TooDeep`."""
        collecting = gc.isenabled()
        gc.disable()  # a tree has no cycles, and the collector would look at it again and again
        try:
            return self._driver(self.start.moves, [*kinds, END], texts)
        finally:
            if collecting:
                gc.enable()
