"""Lark's parser for a text with mistakes: its stack can be copied and read, and it builds no tree.

A stack is copied before a token that may not fit, and the copy is used if it does not.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Iterator
from copy import copy
from typing import Any

from lark import Lark, UnexpectedToken
from lark.grammar import Rule

from motionlang.kernel.lang.syntax.grammar import END, Token


class Stack:
    """The symbols that the parser has read and not yet put into a rule that is complete."""

    def __init__(self, parser: Lark) -> None:
        state = parser.parse_interactive("").parser_state
        conf = copy(state.parse_conf)
        rules = {rule for actions in conf.states.values() for _, rule in actions.values()}
        conf.callbacks = dict.fromkeys(rules, _firsts)
        self._state = type(state)(conf, state.lexer)
        # The symbol with which a state is entered.
        self._symbols: dict[Any, str] = {
            target: symbol
            for actions in conf.states.values()
            for symbol, (_, target) in actions.items()
            if not isinstance(target, Rule)
        }

    def copy(self) -> Stack:
        made: Stack = object.__new__(Stack)
        state = self._state
        made._symbols = self._symbols
        made._state = type(state)(state.parse_conf, state.lexer, state.state_stack[:], state.value_stack[:])
        return made

    def feed(self, token: Token) -> bool:
        """Read a token; return False if it does not fit.

        The stack accepts the same kinds after one that does not fit.
        """
        try:
            self._state.feed_token(token, token.type == END)
        except UnexpectedToken:
            return False
        return True

    def after(self, tokens: Iterable[Token]) -> Stack | None:
        """Return the stack after tokens, None if they do not fit."""
        made = self.copy()
        return made if all(map(made.feed, tokens)) else None

    def accepts(self) -> set[str]:
        """Return the kinds of token that may come next."""
        return {kind for kind in self._actions if kind.isupper() and self.copy().feed(Token(kind, ""))}

    def reduced(self) -> Stack:
        """Return the stack whose last rules are complete, as far as they can be.

        If several rules could be the last one, it is that which most kinds of token complete. A reader would list the
        kinds that are accepted then: after `x = 1` the end of the line, and no operators.
        """
        made = self.copy()
        while (rule := made._likely_rule()) is not None:
            made._reduce(rule)
        return made

    @property
    def _actions(self) -> dict[str, tuple[Any, Any]]:
        actions: dict[str, tuple[Any, Any]] = self._state.parse_conf.states[self._state.position]
        return actions

    def _likely_rule(self) -> Rule | None:
        counts = Counter(rule for _, rule in self._actions.values() if isinstance(rule, Rule))
        return min(counts, key=lambda rule: (-counts[rule], str(rule)), default=None)

    def _reduce(self, rule: Rule) -> None:
        states, values, size = self._state.state_stack, self._state.value_stack, len(rule.expansion)
        value = _firsts(values[len(values) - size :])
        del states[len(states) - size :], values[len(values) - size :]
        _, state = self._actions[rule.origin.name]
        states.append(state)
        values.append(value)

    def __len__(self) -> int:
        return len(self._state.value_stack)

    def __iter__(self) -> Iterator[tuple[str, list[Token]]]:
        """Iterate over the symbols from the top down.

        A symbol is a kind of token, with the token, or a rule, with the first token of each of its symbols that has
        one.
        """
        states, values = self._state.state_stack, self._state.value_stack
        for state, value in zip(states[:0:-1], reversed(values), strict=True):
            yield self._symbols[state], value if isinstance(value, list) else [value]


def _firsts(values: list[list[Token] | Token]) -> list[Token]:
    """Return the value of a rule from those of its symbols."""
    return [value[0] if isinstance(value, list) else value for value in values if value != []]
