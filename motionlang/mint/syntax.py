"""Every mistake of a text, in one pass: what is wrong, where, and what to do about it.

The text is read again with a stack that can go back (`motionlang.lang.tables_stack`). What is wrong with a
line is reported once; the line is dropped, or replaced by the plainest line that opens or closes the same
block, so that one mistake is one message. Blocks are repaired in the same way: a block that is still open
when its surroundings close is reported at its opener and closed; a closer that closes nothing is dropped.
"""

from __future__ import annotations

from motionlang.errors import Diagnostic, ProgramError
from motionlang.lang.places import Places
from motionlang.lang.tables import DEEPEST, END
from motionlang.lang.tables_stack import empty, expected, feed, feed_all
from motionlang.mint import wording
from motionlang.mint.blocks import CLOSERS, DECLARATIONS, OPENERS, closing, opened_blocks, plain_line
from motionlang.mint.build import Misuse
from motionlang.mint.tables import TABLES

TYPE_CHECKING = False
if TYPE_CHECKING:
    from motionlang.mint.blocks import Block
    from motionlang.source import Source

MOST = 100  # nobody reads more, and binary rubbish has one a line


def diagnose(source: Source, misuse: Misuse | None = None) -> ProgramError:
    """Every mistake of a text that cannot be parsed."""
    reader = _Reader(source)
    reader.read()
    if misuse and not reader.diagnostics:
        reader.report("syntax", misuse.message, misuse.at, misuse.hint)
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
    """Goes through the tokens once; `top` is the stack, `mark` where the statement began."""

    def __init__(self, source: Source) -> None:
        self.texts = TABLES.texts(source.text)
        self.kinds = [TABLES.kind_of[text] for text in self.texts]
        self.places = Places(source, TABLES, self.texts)
        self.diagnostics: list[Diagnostic] = []
        self.top = empty(TABLES)
        self.line = self.mark = self.top
        self.start = 0  # the token at which the statement began

    def read(self) -> None:
        at = 0
        while at < len(self.kinds) and len(self.diagnostics) < MOST:
            self.top, fits = feed(self.top, self.kinds[at], at)
            at = self._after(at) if fits else self._mistake(at)
            if self.top.depth > DEEPEST and not self._all_right(at):
                return

    def report(self, code: str, message: str, at: int, hint: str = "", last: int | None = None) -> None:
        """Write down a mistake at a token, or from one token to another of the same line."""
        start, end = self.places.span(at)
        line, column = self.places.source.place(start)
        if last is not None:
            end = self.places.span(last)[1]
        length = 1 if self.kinds[at] in ("_NL", END) else end - start
        self.diagnostics.append(Diagnostic(code, message, line, column, length=max(1, length), hint=hint))

    def _after(self, at: int) -> int:
        """The token `at` is in its place; note where lines and statements begin."""
        kind = self.kinds[at]
        if kind == "_NL":
            self.line = self.top
        if kind in ("_NL", "COLON"):
            self.mark, self.start = self.top, at + 1
        return at + 1

    def _all_right(self, at: int) -> bool:
        """Blocks nested too deeply end the reading: what follows would only repeat it."""
        block = next(iter(opened_blocks(self.mark)), None)
        if block is None:
            return True
        self.report("syntax", "blocks are nested too deeply", block.at, "move the inner ones into a Sub")
        return False

    # ------------------------------------------------------------------------------------------- mistakes

    def _mistake(self, at: int) -> int:
        """The token `at` does not fit: say so, mend it, and return the token to go on with."""
        blocks = opened_blocks(self.mark)
        if self.kinds[at] == END:
            return self._file_ends(at, blocks)
        closer = self._closer(at)
        if closer:
            inline = any(block.inline for block in blocks)
            return self._closes_inline(at) if inline else self._closes(closer, at, blocks)
        if self._declares(at) and blocks and not blocks[0].inline:
            return self._declared_inside(blocks)
        return self._wrong(at)

    def _closer(self, at: int) -> str:
        """The kind of block that the statement up to `at` wants to close, "" for none."""
        first = self.kinds[self.start]
        if at == self.start:
            return CLOSERS.get(first, "")
        if first == "END" and at == self.start + 1 and self.kinds[at] in OPENERS:
            return self.kinds[at]
        return ""

    def _closes(self, closer: str, at: int, blocks: list[Block]) -> int:
        """A closer that does not fit: the blocks inside the one it closes are still open, or there is none."""
        place = next((i for i, block in enumerate(blocks) if block.kind == closer), None)
        words = " ".join(self.texts[self.start : at + 1])
        if place:
            for block in blocks[:place]:
                self._missing(block)
            if self._close(blocks[:place]):
                return self.start
        if blocks and place is None and self._same_column(blocks[0]):
            name = OPENERS[blocks[0].kind]
            end = closing(blocks[0].kind)
            self.report("stray-end", f"`{words}` does not close `{name}`", self.start, f"write {end}", at)
            self._close(blocks[:1])
        elif place == 0:
            self.report("syntax", f"`{words}` cannot stand here", self.start, last=at)
        else:
            hint = f"remove it, or add the {OPENERS[closer]} it belongs to"
            self.report("stray-end", f"`{words}` without {_article(OPENERS[closer])}", self.start, hint, at)
        return self._skip(at)

    def _closes_inline(self, at: int) -> int:
        """A closer in an If of one line, which ends with its line."""
        words = " ".join(self.texts[self.start : at + 1])
        message = f"`{words}` cannot stand in an If of one line"
        self.report("stray-end", message, self.start, "remove it, or give each part a line of its own", at)
        return self._skip(at)

    def _same_column(self, block: Block) -> bool:
        """Does the statement stand under the opener, as if it were to close it?"""
        return self.places.column(self.start) == self.places.column(block.at)

    def _declared_inside(self, blocks: list[Block]) -> int:
        """A `Sub` or the like begins where blocks are open: they should have ended before."""
        kinds = tuple(self.kinds[self.start : self.start + 2])
        while blocks and feed_all(self.mark, kinds, self.start) is None:
            self._missing(blocks[0])
            if not self._close(blocks[:1]):
                break
            blocks = blocks[1:]
        return self.start

    def _declares(self, at: int) -> bool:
        first = self.kinds[self.start]
        named = self.kinds[self.start + 1 : self.start + 2] in (["NAME"], ["_NL"])
        return first in DECLARATIONS and named and at <= self.start + 1

    def _file_ends(self, at: int, blocks: list[Block]) -> int:
        for block in blocks:
            self._missing(block)
        return at + 1

    def _missing(self, block: Block) -> None:
        name, end = OPENERS[block.kind], closing(block.kind)
        self.report("missing-end", f"`{name}` is never closed", block.at, f"add {end}")

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
        self.report("syntax", wording.message(kinds, kind, text), at, wording.hint(kinds, before, text))
        end = self._line_end(at)
        plain = plain_line(self.kinds[self.start : end])
        if plain and (top := feed_all(self.mark, plain, self.start)):
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
