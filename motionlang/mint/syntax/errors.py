"""Every mistake of a text, in one pass: what is wrong, where, and what to do about it.

The text is read again with a stack that can go back (`motionlang.lang.parsing.linked_stack`). What is wrong with a
line is reported once; the line is dropped, or replaced by the plainest line that opens or closes the same
block, so that one mistake is one message. Blocks are repaired in the same way: a block that is still open
when its surroundings close is reported at its opener and closed; a closer that closes nothing is dropped.
"""

from __future__ import annotations

from motionlang.errors import Diagnostic, ProgramError
from motionlang.lang.parsing.linked_stack import empty, expected, feed, feed_all
from motionlang.lang.parsing.parser import END
from motionlang.lang.parsing.places import Places
from motionlang.mint.syntax import expectations
from motionlang.mint.syntax.blocks import CLOSERS, DECLARATIONS, OPENERS, closing, opened_blocks, plain_lines
from motionlang.mint.syntax.build import DEEPEST, INFINITE, number
from motionlang.mint.syntax.tables import TABLES

TYPE_CHECKING = False
if TYPE_CHECKING:
    from motionlang.mint.syntax.blocks import Block
    from motionlang.source import Source

AFTER_A_NAME = {"EQUAL", "DOT", "LPAR", "LSQB"}
MOST = 100  # nobody reads more, and binary rubbish has one a line


def diagnose(source: Source) -> ProgramError:
    """Every mistake of a text that cannot be parsed."""
    reader = _Reader(source)
    reader.read()
    return ProgramError(reader.diagnostics)


def unfinished(texts: list[str]) -> bool:
    """Does the text end inside a block, with nothing wrong before?"""
    top = empty(TABLES)
    for at, text in enumerate(texts):
        kind = TABLES.kind_of[text]
        top, fits = feed(top, kind, at)
        if not fits:
            return kind == END
    return False


class _Reader:
    """Goes through the tokens once; `top` is the stack, `mark` the stack where the statement began."""

    def __init__(self, source: Source) -> None:
        self.texts = TABLES.texts(source.text)
        self.kinds = TABLES.kinds_of(self.texts)
        self.places = Places(source, TABLES, self.texts, self.kinds)
        self.diagnostics: list[Diagnostic] = []
        self.top = self.deepest = empty(TABLES)
        self.before = self.line = self.mark = self.top
        self.start = 0  # the token at which the statement began
        self.spent: dict[int, int] = {}  # an opener, and the inner one that its closer was spent on

    def read(self) -> None:
        """Find the mistakes, up to as many as are of use."""
        at = 0
        while at < len(self.kinds) and len(self.diagnostics) < MOST:
            closer = self._closer(at, at + 1) if at == self.start else ""
            if closer:
                self._watch_columns(closer)
            self.before = self.top
            self.top, fits = feed(self.top, self.kinds[at], at)
            if fits:
                self._check(at)
            at = self._after(at) if fits else self._mistake(at)
            if self.top.depth > self.deepest.depth:
                self.deepest = self.top
            if self.top.depth > 2 * DEEPEST and self._is_too_deep():
                self.deepest = self.top
                break
        if not self.diagnostics or at < len(self.kinds):
            self._report_depth()

    def _is_too_deep(self) -> bool:
        return self.top.symbol == "_NL" and sum(cell.symbol == "body" for cell in self.top) > DEEPEST

    def _report_depth(self) -> None:
        """The blocks are nested too deeply: what else could be wrong with a text that cannot be parsed?"""
        blocks = opened_blocks(self.deepest)
        if blocks and len(self.diagnostics) < MOST:
            message = f"blocks are nested more than {DEEPEST} deep here"
            hint = "move the inner ones into a Sub"
            self.report(
                "syntax", message, blocks[min(1, len(blocks) - 1)].at, hint
            )  # the last one has no body yet

    def report(self, code: str, message: str, at: int, hint: str = "", last: int | None = None) -> None:
        """Write down a mistake at a token, or from one token to another of the same line."""
        start, end = self.places.span(at)
        if last is not None:
            end = self.places.span(last)[1]
        length = 1 if self.kinds[at] in ("_NL", END) else max(1, end - start)
        line, column = self.places.line(at), self.places.column(at)
        self.diagnostics.append(Diagnostic(code, message, line, column, length=length, hint=hint))

    def _after(self, at: int) -> int:
        """The token `at` is in its place; note where lines and statements begin."""
        kind = self.kinds[at]
        if kind == "_NL":
            self.line = self.top
        if kind in ("_NL", "COLON"):
            self.mark, self.start = self.top, at + 1
        return at + 1

    def _check(self, at: int) -> None:
        """What the grammar accepts and the language does not; `motionlang.mint.syntax.build` raises Misuse for it."""
        text = self.texts[at]
        if self.kinds[at] == "NUMBER" and number(text) == INFINITE:
            self.report("syntax", f"{expectations.found('', text)} is too large for a number", at)
        if self.kinds[self.start] == "NEXT" and self.kinds[at - 1] in ("NEXT", "COMMA") and at > self.start:
            self._check_next(at, text)

    def _check_next(self, at: int, text: str) -> None:
        """The variables after a `Next` are those of the loops it closes, from the innermost."""
        if self.kinds[at] in ("_NL", "COLON"):
            return
        number = self.kinds[self.start : at].count("COMMA")
        variable = self.texts[opened_blocks(self.mark)[number].at + 1]
        if variable.lower() != text.lower():
            message = f"`Next {text}` ends the `For` of `{variable}`"
            self.report("syntax", message, at, f"write {variable}" if number else f"write Next {variable}")

    def _watch_columns(self, closer: str) -> None:
        """A closer that stands under an outer opener and closes an inner one: if one is missing, it is the inner's."""
        blocks = opened_blocks(self.mark)
        if not blocks or blocks[0].kind != closer or self._under(blocks[0]):
            return
        meant = next((block for block in blocks[1:] if block.kind == closer and self._under(block)), None)
        if meant:
            self.spent.setdefault(meant.at, blocks[0].at)

    def _under(self, block: Block) -> bool:
        """Does the statement stand under the opener of a block?"""
        return self.places.column(self.start) == self.places.column(block.at)

    # ------------------------------------------------------------------------------------------- mistakes

    def _mistake(self, at: int) -> int:
        """The token `at` does not fit: say so, mend it, and return the token to go on with."""
        blocks = opened_blocks(self.mark)
        if self.kinds[at] == END:
            return self._file_ends(at, blocks)
        first = at - 1 if self.kinds[at - 1] == "END" and self.kinds[at] in OPENERS else at
        closer = self._closer(first, at)
        if closer and first == self.start and not any(block.inline for block in blocks):
            return self._closes(closer, at, blocks)
        if closer and self.kinds[at] != "ELSE" and self._inline(first, blocks):
            return self._closes_inline(first, at)
        if self._declares(at) and blocks and not blocks[0].inline:
            return self._declared_inside(blocks)
        return self._wrong(at)

    def _closer(self, first: int, last: int) -> str:
        """The kind of block that the tokens from `first` to `last` close or go on with, "" for none."""
        if self.kinds[first] == "END" and self.kinds[last : last + 1] and self.kinds[last] in OPENERS:
            return self.kinds[last]
        return CLOSERS.get(self.kinds[first], "")

    def _inline(self, first: int, blocks: list[Block]) -> bool:
        """Does the statement at `first` belong to an If of one line?"""
        return self.kinds[first - 1] in ("THEN", "ELSE") or any(block.inline for block in blocks)

    def _closes(self, closer: str, at: int, blocks: list[Block]) -> int:
        """A closer that does not fit: blocks inside the one it closes are still open, or there is none."""
        place = next((i for i, block in enumerate(blocks) if block.kind == closer), None)
        words = " ".join(self.texts[self.start : at + 1])
        name = OPENERS[closer]
        if place:
            for block in blocks[:place]:
                self._missing(block)
            if self._close(blocks[:place]):
                return self.start
        if place is not None:
            self.report("syntax", f"`{words}` cannot stand here", self.start, last=at)
        elif blocks and self._under(blocks[0]):
            message = f"`{words}` does not close `{OPENERS[blocks[0].kind]}`"
            self.report("stray-end", message, self.start, f"write {closing(blocks[0].kind)}", at)
            self._close(blocks[:1])
        else:
            message = f"`{words}` without {_article(name)}"
            hint = self._else_if(at) if closer == "IF" and self.kinds[self.start] in ("END", "ENDIF") else ""
            hint = hint or f"remove it, or add the {name} it belongs to"
            self.report("stray-end", message, self.start, hint, at)
        return self._skip(at)

    def _else_if(self, at: int) -> str:
        """A hint for an `End If` too many, where an `Else If` has been read as an ElseIf."""
        for place in range(at - 1, 1, -1):
            if self.kinds[place - 2 : place + 1] == ["_NL", "ELSE", "IF"]:
                line = self.places.line(place)
                return f"the `Else If` of line {line} is an ElseIf; an If of its own stands on the line below Else"
            if self.kinds[place] in DECLARATIONS:
                break
        return ""

    def _closes_inline(self, first: int, at: int) -> int:
        """A closer in an If of one line, which ends with its line."""
        words = " ".join(self.texts[first : at + 1])
        message = f"`{words}` cannot stand in an If of one line"
        self.report("stray-end", message, first, "remove it, or give each part a line of its own", at)
        return self._skip(at)

    def _declares(self, at: int) -> bool:
        """Does the statement begin a Sub or the like?"""
        named = self.kinds[self.start + 1 : self.start + 2] in (["NAME"], ["_NL"])
        return self.kinds[self.start] in DECLARATIONS and named and at <= self.start + 1

    def _declared_inside(self, blocks: list[Block]) -> int:
        """A `Sub` or the like begins where blocks are open: they should have ended before."""
        kinds = tuple(self.kinds[self.start : self.start + 2])
        while blocks and feed_all(self.mark, kinds, self.start) is None:
            self._missing(blocks[0])
            if not self._close(blocks[:1]):
                return self._skip(self.start)
            blocks = blocks[1:]
        self.top = self.mark
        return self.start

    def _file_ends(self, at: int, blocks: list[Block]) -> int:
        for block in blocks:
            self._missing(block)
        return at + 1

    def _missing(self, block: Block) -> None:
        at = block.at
        while at in self.spent:
            at = self.spent.pop(at)
        self.report(
            "missing-end", f"`{OPENERS[block.kind]}` is never closed", at, f"add {closing(block.kind)}"
        )

    def _close(self, blocks: list[Block]) -> bool:
        """Close blocks, from the innermost, as if their ends stood before the statement."""
        for block in blocks:
            top = feed_all(self.mark, (*block.closing, "_NL"), self.start)
            if top is None:
                return False
            self.mark = self.top = top
        self.line = self.top
        return True

    def _wrong(self, at: int) -> int:
        """An ordinary mistake inside a statement."""
        kind, text = self.kinds[at], self.texts[at]
        before = self.texts[at - 1] if at else ""
        kinds = expected(TABLES, self.top)
        if kinds <= AFTER_A_NAME:  # `Run 3`: the word has been taken for a name, which nobody meant
            kinds = expected(TABLES, self.before)
        self.report(
            "syntax", expectations.message(kinds, kind, text), at, expectations.hint(kinds, before, text)
        )
        end = self._line_end(at)
        for plain in plain_lines(self.kinds[self.start : end]):
            if top := feed_all(self.mark, plain, self.start):
                self.top = top
                return self._after_line(end)
        return self._skip(at)

    # ------------------------------------------------------------------------------------------- recovery

    def _line_end(self, at: int) -> int:
        while self.kinds[at] not in ("_NL", END):
            at += 1
        return at

    def _skip(self, at: int) -> int:
        """Drop the rest of the line; what stood before the statement stays, if it may end there."""
        end = self._line_end(at)
        for top in (self.mark, self.line):
            after, fits = feed(top, "_NL", end)
            if fits:
                self.top = after
                break
        else:
            self.top = self.line
        return self._after_line(end)

    def _after_line(self, end: int) -> int:
        self.line = self.mark = self.top
        at = end + 1 if self.kinds[end] == "_NL" else end
        self.start = at
        return at


def _article(name: str) -> str:
    return f"an {name}" if name[0] in "AEIOU" else f"a {name}"
