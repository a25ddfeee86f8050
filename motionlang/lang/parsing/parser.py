"""The table parser, which runs the LALR tables that `generate` writes.

Lark's own driver is exact, but ten times slower, and it adds 40 ms to start-up. Lark still decides which
states there are, what they shift and what they reduce. This module does the rest:

* One `re.findall` splits the text; the kind of a token is looked up once for every distinct text.
* A state is read from its row of the table on the first visit; from then on each of its actions is a dict lookup.
* A sequence of symbols that are only renamed (an operand climbs eleven levels of operators) is resolved once for
  each (state, kind, state below) and is one dict lookup from then on.
* The loop itself is generated for the grammar (`motionlang.lang.parsing.driver`). The value of a token is its
  ordinal, so that every node knows its position at no cost; its text is `texts[ordinal]`.
"""

from __future__ import annotations

import re

from motionlang.lang.collector import CollectorOff

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable, Iterable, Iterator
    from typing import Any

    Moves = dict[str, Any]
    # The stack below its topmost value, the moves of its state, and that value. None is the stack below the
    # first.
    Stack = Any
    # Takes the stack, the moves of its top state, the topmost value and the texts of the tokens; returns the
    # stack and the new topmost value.
    Reducer = Callable[[Stack, Moves, Any, list[str]], tuple[Stack, Any]]
    # Number of symbols, name of the left side, and the reducer: None if the value stays unchanged, a code if
    # the driver has inlined the reduction.
    Rule = tuple[int, str, Reducer | int | None]
    Driver = Callable[[Moves, list[str], list[str]], Any]

END = "$END"  # Lark's name for the end of the text
BAD = "BAD"  # the kind of a token that is in no grammar
CONTINUING = (
    "_ ",
    "_\t",
    "_\n",
    "_'",
)  # how a line continuation may begin, apart from a backslash
new = object.__new__  # for the reducers, which fill in the nodes that they make

# The action of a state on a kind of token is a code with an argument:
SHIFT = -1  # the argument is the moves of the next state
LEAF = (
    -2
)  # a shift where the next token may show that this one is a value by itself; the argument is for `leaf`
CALL = 99  # call a reducer; the argument is the reduction's key. Lower codes are reductions inlined in the driver


class Stuck(Exception):
    """Raised if no action exists for a token, so that the text has a mistake."""


class TooDeep(Exception):
    """Raised if blocks are nested deeper than later stages can handle."""


class State:
    """The actions on each kind of token, and the transitions after reductions.

    `moves` caches those that the driver has met so far. It is a plain dict, because the driver reads it at
    every token. The action on a kind is stored under that kind, the transition after a reduction that began
    here under the key of the reduction, and the state itself under "".
    """

    __slots__ = ("_actions", "_row", "default", "moves", "number", "tables")

    def __init__(self, tables: Automaton, number: int, row: str) -> None:
        self.tables, self.number, self._row = tables, number, row
        self._actions: dict[str, State | Rule | None] = {BAD: None}
        self.default: Rule | None = None
        self.moves: Moves = {"": self}

    def step(self, kind: str) -> State | Rule | None:
        """Return the state to shift to, the rule to reduce by, or None if neither exists."""
        if self._row:
            self._fill()
        return self._actions.get(kind, self.default)

    def after(self, rule: Rule) -> State:
        """Return the state after a reduction by a rule that began here."""
        return self._actions[rule[1]]  # type: ignore[return-value]  # the beginning of the rule has been read

    def end(self) -> None:
        """Shift the end of the text like any other token."""
        self._actions[END] = self

    def _fill(self) -> None:
        """Read the row: `target=kind,kind …`.

        A target is a state, a rule such as `r5`, or the default rule, such as `d5`.
        """
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


# The driver calls these three functions when it meets a case for the first time.


def move(moves: Moves, kind: str) -> tuple[int, Any]:
    """Return the action on a kind; a kind that does not fit leads to a dead state."""
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
    """Keep the value; this is the reducer of a symbol that is only renamed."""
    return stack, top


def goto(below: Moves, key: str) -> tuple[Moves, int, Any]:
    """Return the state after a reduction and its action, past all renamed symbols."""
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
    """Return the value that a token forms by itself, if the kind after it allows that.

    Returns the number of the value or 0, the state after it and the action of that state.
    """
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
    """Map from the text of a token to its kind, computed once per text."""

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
        """Clear the map if it is too large.

        A long session that parses many programs would otherwise retain every number it ever saw.
        """
        if len(self) > self.limit:
            self.clear()


class Automaton:
    """The LALR(1) table of a grammar: its states and kinds of token."""

    def __init__(self, kinds: Iterable[str], rules: Iterable[Rule], rows: Iterable[str], finish: int) -> None:
        self.kinds = {*kinds, END}
        self.rules = tuple(rules)
        self.states = [State(self, number, row) for number, row in enumerate(rows)]
        self.start = self.states[0]
        self.states[finish].end()
        # The kinds of token that may be values by themselves, with the number and the reducer of each.
        self.leaves: dict[str, tuple[int, Reducer]] = {}
        # The reductions that the driver has met, by key: a rule on a kind of token.
        self.reductions: dict[str, tuple[Rule, str]] = {}


class Tables(Automaton):
    """A grammar ready to run: its table, its token patterns and its reducers."""

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
        self._continues = "", False  # the last argument of `continues`, and its result

    def continues(self, text: str) -> bool:
        """True if lines of the text may continue on the next line.

        The pattern for continued lines is slower.
        """
        if text is not self._continues[0]:
            found = "\\" in text or text.endswith("_") or any(sign in text for sign in CONTINUING)
            self._continues = text, found
        return self._continues[1]

    def pattern(self, text: str) -> re.Pattern[str]:
        """Return the pattern that splits a text into tokens."""
        if self.continues(text):
            if self._continued is None:
                self._continued = re.compile(self.continued, re.ASCII)
            return self._continued
        if self._token is None:
            self._token = re.compile(self.token, re.ASCII)
        return self._token

    def end(self, text: str) -> str:
        """Return the text that ends the last line, even if that line is continued."""
        return "\n\n" if self.continues(text) else "" if text.endswith("\n") else "\n"

    def matches(self, text: str) -> Iterator[re.Match[str]]:
        """Iterate over the tokens; group 1 is the text of each."""
        return self.pattern(text).finditer(text + self.end(text))

    def texts(self, text: str) -> list[str]:
        """Return the texts of the tokens, with an empty one for the end.

        The last line need not end with a line break.
        """
        texts: list[str] = self.pattern(text).findall(text + self.end(text))
        texts.append("")
        return texts

    def spans(self, text: str) -> list[tuple[int, int]]:
        """Return the offsets of the tokens of `texts`, except those added for the end."""
        return [match.span(1) for match in self.matches(text)]

    def kinds_of(self, texts: list[str]) -> list[str]:
        """Return the kinds of the tokens `texts`."""
        self.kind_of.trim()
        return [*map(self.kind_of.__getitem__, texts)]

    def parse(self, texts: list[str], kinds: list[str]) -> Any:
        """Return the value of the start rule; raise `Stuck` or `TooDeep`."""
        with CollectorOff():  # a tree has no cycles
            return self._driver(self.start.moves, [*kinds, END], texts)
