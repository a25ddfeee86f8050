"""`&` or `|` is an operand of a comparison, without brackets that say which of them comes first.

Languages differ in precedence: in some of them the comparison binds more tightly. The hint shows the line with brackets
for both interpretations.
"""

from __future__ import annotations

from bisect import bisect_left
from collections.abc import Iterable
from typing import TYPE_CHECKING

from motionlang.commands.check.mint.conditions import COMPARISONS
from motionlang.commands.check.rule import Rule, RuleCase, Warn
from motionlang.kernel.mint.resolve.symbols import STRING
from motionlang.kernel.mint.syntax import nodes
from motionlang.kernel.mint.syntax.traversal import walk

if TYPE_CHECKING:
    from motionlang.commands.check.mint.mint_facts import MintFacts
    from motionlang.kernel.mint.syntax.tokens import Tokens

_BITS = frozenset("&|")
_OPEN, _CLOSED = frozenset("(["), frozenset(")]")


def check(facts: MintFacts, warn: Warn) -> None:
    # Here, since it loads the grammar of Mint, which programs in MCCL do not need.
    from motionlang.kernel.mint.syntax.tokens import Tokens

    text = facts.module.source.text
    tokens: Tokens | None = None
    inner: set[int] = set()
    for node in facts.of_kind(nodes.Binary):  # a node comes before its children
        if node.op not in COMPARISONS or id(node) in inner:
            continue
        if not any(type(each) is nodes.Binary and each.op in _BITS for each in walk([node])):
            continue
        tokens = tokens or Tokens(text, facts.module.tokens)
        chain = _Chain(text, tokens, node)
        inner |= chain.inner
        bits = [op for op in chain.ops if tokens.texts[op] in _BITS]
        if bits and chain.is_written and not any(_is_text(each) for each in chain.operands):
            warn(
                f"{tokens.texts[bits[0]]} binds tighter than a comparison here, unlike in other languages",
                tokens.starts[bits[0]],
                f"add brackets: {chain.line(_BITS)}, as it is read here, or {chain.line(COMPARISONS)}",
            )


def _is_text(node: nodes.Expr) -> bool:
    """True if an operand is certainly a string.

    `&` joins strings, so only one interpretation makes sense.
    """
    if type(node) is nodes.Name:
        symbol = node.symbol
        return symbol is not None and symbol.type.name == STRING
    return type(node) is nodes.String


class _Chain:
    """A comparison with all operations in it that are not in brackets.

    `operands` are its operands and `ops` the tokens of its operators. `inner` holds the identities of the
    operations inside it. `is_written` is False if the comparison was generated for a statement, such as the
    limit of a For.
    """

    def __init__(self, text: str, tokens: Tokens, node: nodes.Binary) -> None:
        self.text, self.tokens, self.texts = text, tokens, tokens.texts
        self.inner: set[int] = set()
        self.operands: list[nodes.Expr] = []
        self.ops: list[int] = []
        self._add(node)
        self.is_written = self.texts[self._operator(node)] == node.op

    def _token(self, node: nodes.Node) -> int:
        return bisect_left(self.tokens.starts, node.start)

    def _add(self, node: nodes.Binary) -> None:
        op = self._operator(node)
        self._side(node.left, op)
        self.ops.append(op)
        self._side(node.right, op)

    def _side(self, node: nodes.Expr, outer: int) -> None:
        if type(node) is nodes.Binary and node.op in COMPARISONS | _BITS and not self._bracketed(node, outer):
            self.inner.add(id(node))
            self._add(node)
        else:
            self.operands.append(node)

    def _operator(self, node: nodes.Binary) -> int:
        """Return the token of an operator, found before the brackets of its right operand."""
        at = self._token(node.right) - 1
        while self.texts[at] == "(":
            at -= 1
        return at

    def _bracketed(self, node: nodes.Binary, outer: int) -> bool:
        """True if an operation is in brackets within the operation around it."""
        inner = self._operator(node)
        depth = least = 0
        for at in range(min(inner, outer) + 1, max(inner, outer)):
            depth += self._depth(at)
            least = min(least, depth)
        return depth != 0 or least != 0

    def _depth(self, at: int) -> int:
        text = self.texts[at]
        return (text in _OPEN) - (text in _CLOSED)

    # ----------------------------------------------------------------------------------------------- readings

    def line(self, tight: Iterable[str]) -> str:
        """Return the source line with the operands of the `tight` operators in brackets."""
        opened, closed = set(), set()
        starts = [self._start(), *(op + 1 for op in self.ops)]
        ends = [*(op - 1 for op in self.ops), self._end()]
        joined = [self.texts[op] in tight for op in self.ops]
        for number, (start, end) in enumerate(zip(starts, ends, strict=True)):
            before = number > 0 and joined[number - 1]
            after = number < len(joined) and joined[number]
            if after and not before:
                opened.add(start)
            if before and not after:
                closed.add(end)
        return self._written(opened, closed)

    def _start(self) -> int:
        """Return the first token of the first operand, including its opening brackets."""
        first = min(self._token(each) for each in walk([self.operands[0]]))
        depth = sum(map(self._depth, range(first, self.ops[0])))
        while depth < 0:
            first -= 1
            depth += self._depth(first)
        return first

    def _end(self) -> int:
        """Return the last token of the last operand, including its brackets and members."""
        last = max(self._token(each) for each in walk([self.operands[-1]]))
        depth = sum(map(self._depth, range(self.ops[-1] + 1, last + 1)))
        while depth > 0 or self.texts[last + 1] in _OPEN or self.texts[last + 1] == ".":
            last += 1
            depth += self._depth(last)
            if self.texts[last] == ".":
                last += 1
        return last

    def _written(self, opened: set[int], closed: set[int]) -> str:
        """Return the text of the line or lines with brackets inserted at some tokens."""
        tokens = self.tokens
        at = self._start()
        while at and "\n" not in self.texts[at - 1]:
            at -= 1
        texts: list[str] = []
        before = tokens.starts[at]
        while (text := self.texts[at]) and "\n" not in text:
            start, end = tokens.starts[at], tokens.ends[at]
            between = self.text[before:start]
            texts.append(" " if "\n" in between else between)
            texts.append("(" * (at in opened) + text + ")" * (at in closed))
            before = end
            at += 1
        return "".join(texts)


RULE = Rule(
    code="mixed-operators",
    text="""\
`&` or `|` is used with a comparison, without brackets that say which comes first. In Mint, `If a & 2 = 2 Then` tests
`(a & 2) = 2`; in C and similar languages it would be `a & (2 = 2)`. The hint shows the line both ways. There is no
warning for an `&` that joins texts.
""",
    fix="add brackets",
    mint=RuleCase(
        check,
        wrong="If INX(1) = 1 & INX(2) = 1 Then PRINT 1\n",
        right="If (INX(1) = 1) & (INX(2) = 1) Then PRINT 1\n",
    ),
)
