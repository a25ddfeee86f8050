"""Find all syntax errors of a text in one pass, with position and suggested fix.

The text is parsed again with a stack that can be rolled back (`motionlang.kernel.lang.syntax.stack`). Each
faulty line is reported once. The line is then dropped, or replaced by the shortest line that opens or closes
the same block, so that one error gives one message. Missing and surplus closers are repaired in the same way. A block
that is still open when the block around it closes is reported at its opener and closed. A closer without an open block
is dropped. If a line has an error and none with a similar keyword in place of its first word, that word is the error.
"""

from __future__ import annotations

from math import inf

from motionlang.kernel.errors import Diagnostic, ProgramError
from motionlang.kernel.lang import typography
from motionlang.kernel.lang.syntax.grammar import BAD, END
from motionlang.kernel.mint.syntax import expectations
from motionlang.kernel.mint.syntax.blocks import (
    CLOSERS,
    DECLARATIONS,
    OPENERS,
    Block,
    closing,
    opened_blocks,
    plain_lines,
)
from motionlang.kernel.mint.syntax.build import number
from motionlang.kernel.mint.syntax.nesting import MAX_DEPTH
from motionlang.kernel.mint.syntax.tokens import TABLE, Tokens
from motionlang.kernel.source import Source
from motionlang.kernel.tools import nearest

AFTER_A_NAME = {"EQUAL", "DOT", "LPAR", "LSQB"}
KEYWORDS = {spelling: kind for kind, spelling in TABLE.spellings.items() if kind.isalpha()}
MAX_BACK = 2000  # a misspelt opener is looked for among so many tokens before its closer
MAX_ERRORS = 100  # more are not useful; a binary file has one on every line


def diagnose(source: Source) -> ProgramError:
    """Return all errors of a text."""
    reader = _Reader(source)
    reader.read()
    return ProgramError(reader.diagnostics)


def unfinished(text: str) -> bool:
    """True if the text ends inside a block and has no error before that."""
    top = TABLE.empty()
    for at, kind in enumerate(Tokens(text).kinds):
        top, fits = top.feed(kind, at)
        if not fits:
            return kind == END
    return False


class _Reader:
    """A pass through the tokens that finds errors.

    `top` is the present stack, `mark` the stack at the beginning of the statement.
    """

    def __init__(self, source: Source) -> None:
        self.source, self.tokens = source, Tokens(source.text)
        self.texts, self.kinds = self.tokens.texts, self.tokens.kinds
        self.diagnostics: list[Diagnostic] = []
        self.top = TABLE.empty()
        self.before = self.line = self.mark = self.top
        self.start = 0  # the token at which the statement began
        self.spent: dict[int, int] = {}  # maps an opener to the inner opener that took its closer
        self.misspelt: set[int] = set()  # the words that are reported as misspelt keywords

    def read(self) -> None:
        """Find the errors, up to `MAX_ERRORS`."""
        at = 0
        while at < len(self.kinds) and len(self.diagnostics) < MAX_ERRORS:
            closer = self._closer(at, at + 1) if at == self.start else ""
            if closer:
                self._watch_columns(closer)
            self.before = self.top
            self.top, fits = self.top.feed(self.kinds[at], at)
            if fits:
                self._check(at)
            at = self._after(at) if fits else self._mistake(at)
            if self.top.depth > 2 * MAX_DEPTH and self._is_too_deep():
                self._report_depth()
                break

    def _is_too_deep(self) -> bool:
        return self.top.symbol == "_NL" and sum(cell.symbol == "body" for cell in self.top) > MAX_DEPTH

    def _report_depth(self) -> None:
        """Report blocks that are nested too deeply."""
        blocks = opened_blocks(self.top)
        message = f"blocks are nested more than {MAX_DEPTH} deep here"
        hint = "move the inner ones into a Sub"
        # The last one has no body yet.
        self.report("syntax", message, blocks[min(1, len(blocks) - 1)].at, hint)

    def report(
        self, code: str, message: str, at: int, hint: str = "", last: int | None = None, candidate: str = ""
    ) -> None:
        """Record an error at token `at`, or from `at` to `last` on the same line.

        `candidate` is a text that may have been meant instead.
        """
        start, end = self.tokens.starts[at], self.tokens.ends[at if last is None else last]
        length = 1 if self.kinds[at] in ("_NL", END) else max(1, end - start)
        line, column = self.source.location(start)
        fix = ""
        if self.kinds[at] == BAD:
            replaced, fix = typography.plain(self.source.line(line)[column - 1 :])
            length = replaced or length
        candidates = (candidate,) if candidate else ()
        self.diagnostics.append(
            Diagnostic(code, message, line, column, length=length, hint=hint, fix=fix, candidates=candidates)
        )

    def _after(self, at: int) -> int:
        """Accept the token `at`, record where lines and statements begin, return the next."""
        kind = self.kinds[at]
        if kind == "_NL":
            self.line = self.top
        if kind in ("_NL", "COLON"):
            self.mark, self.start = self.top, at + 1
        return at + 1

    def _check(self, at: int) -> None:
        """Report errors in text that the grammar accepts.

        The parser raises Misuse for them (`motionlang.kernel.mint.syntax.build`).
        """
        text = self.texts[at]
        if self.kinds[at] == "NUMBER" and number(text) == inf:
            self.report("syntax", f"{expectations.found('', text)} is too large for a number", at)
        if self.kinds[self.start] == "NEXT" and self.kinds[at - 1] in ("NEXT", "COMMA") and at > self.start:
            self._check_next(at, text)

    def _check_next(self, at: int, text: str) -> None:
        """Check that a `Next` names the variables of its loops, innermost first."""
        if self.kinds[at] in ("_NL", "COLON"):
            return
        number = self.kinds[self.start : at].count("COMMA")
        variable = self.texts[opened_blocks(self.mark)[number].at + 1]
        if variable.lower() != text.lower():
            message = f"`Next {text}` ends the `For` of `{variable}`"
            self.report("syntax", message, at, f"write {variable}" if number else f"write Next {variable}")

    def _watch_columns(self, closer: str) -> None:
        """Record a closer that is aligned with an outer opener but closes an inner block.

        If a closer turns out to be missing, it is the closer of that inner block.
        """
        blocks = opened_blocks(self.mark)
        if not blocks or blocks[0].kind != closer or self._under(blocks[0]):
            return
        meant = next((block for block in blocks[1:] if block.kind == closer and self._under(block)), None)
        if meant:
            self.spent.setdefault(meant.at, blocks[0].at)

    def _under(self, block: Block) -> bool:
        """True if the statement is in the same column as the opener of a block."""
        return self._column(self.start) == self._column(block.at)

    def _line(self, at: int) -> int:
        return self.source.location(self.tokens.starts[at])[0]

    def _column(self, at: int) -> int:
        return self.source.location(self.tokens.starts[at])[1]

    # ------------------------------------------------------------------------------------------- mistakes

    def _mistake(self, at: int) -> int:
        """Report the unexpected token `at`, recover, and return the next token to read."""
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
        """Return the kind of block that these tokens close or continue, "" if none."""
        if self.kinds[first] == "END" and self.kinds[last : last + 1] and self.kinds[last] in OPENERS:
            return self.kinds[last]
        return CLOSERS.get(self.kinds[first], "")

    def _inline(self, first: int, blocks: list[Block]) -> bool:
        """True if the statement at `first` belongs to a one-line If."""
        return self.kinds[first - 1] in ("THEN", "ELSE") or any(block.inline for block in blocks)

    def _closes(self, closer: str, at: int, blocks: list[Block]) -> int:
        """Report a closer that does not fit, and return the token after it.

        Either inner blocks are still open, which are reported, too, or no block of that kind is open.
        """
        index = next((i for i, block in enumerate(blocks) if block.kind == closer), None)
        words = " ".join(self.texts[self.start : at + 1])
        name = OPENERS[closer]
        if index:
            for block in blocks[:index]:
                self._missing(block)
            if self._close(blocks[:index]):
                return self.start
        is_wrong_end = self.kinds[self.start] == "END" and closing(closer) != f"End {name}"
        if index is not None and not is_wrong_end:
            self.report("syntax", f"`{words}` is not allowed here", self.start, last=at)
        elif blocks and (index is not None or self._under(blocks[0])):
            message = f"`{words}` does not close `{OPENERS[blocks[0].kind]}`"
            self.report("stray-end", message, self.start, f"write {closing(blocks[0].kind)}", at)
            self._close(blocks[:1])
        elif not self._is_opener_misspelt(closer):
            message = f"`{words}` without {_article(name)}"
            hint = self._else_if(at) if closer == "IF" and self.kinds[self.start] in ("END", "ENDIF") else ""
            hint = hint or (self._one_line_if() if closer == "IF" else "")
            hint = hint or f"remove it, or add the {name} it belongs to"
            self.report("stray-end", message, self.start, hint, at)
        return self._skip(at)

    def _is_opener_misspelt(self, closer: str) -> bool:
        """True if the opener of a closer is misspelt; the word is then reported.

        The word was read as the name of a sub.
        """
        for token in range(self.start - 1, max(-1, self.start - MAX_BACK), -1):
            if self.kinds[token] in DECLARATIONS:
                return False
            if self.kinds[token - 1] not in ("_NL", "COLON") and token:
                continue
            if self._keyword(token, {OPENERS[closer]: closer}):
                self._report_misspelt(token, OPENERS[closer])
                return True
        return False

    def _keyword(self, at: int, keywords: dict[str, str]) -> str:
        """Return the keyword that a word was meant to be, "" if there is none.

        The word begins a statement that is valid with the keyword, and is not the name of a sub.
        """
        word = self.texts[at]
        is_name = self.kinds[at] == "NAME" and at not in self.misspelt
        found = nearest(word, keywords) if is_name else None
        if found is None or word.lower() in self._subs:
            return ""
        return found if self.mark.feed_all(self._with(at, keywords[found]), at) is not None else ""

    def _with(self, at: int, kind: str) -> tuple[str, ...]:
        """Return the rest of a line with another kind of token at its beginning."""
        return (kind, *self.kinds[at + 1 : self._line_end(at)], "_NL")

    @property
    def _subs(self) -> set[str]:
        """The names of the program's subs, in lower case."""
        return {name.lower() for kind, name in zip(self.kinds, self.texts[1:], strict=False) if kind == "SUB"}

    def _report_misspelt(self, at: int, keyword: str) -> None:
        self.misspelt.add(at)
        message = f"{self.texts[at]} is neither a keyword nor a sub of this program"
        self.report("unknown-word", message, at, f"did you mean {keyword}?", candidate=keyword)

    def _else_if(self, at: int) -> str:
        """Return a hint for a surplus `End If` if an `Else If` was read as ElseIf."""
        for token in range(at - 1, 1, -1):
            if self.kinds[token - 2 : token + 1] == ["_NL", "ELSE", "IF"]:
                line = self._line(token)
                return (
                    f"the `Else If` of line {line} is an ElseIf; write a separate If on the line below Else"
                )
            if self.kinds[token] in DECLARATIONS:
                break
        return ""

    def _one_line_if(self) -> str:
        """Return a hint for an Else or End If that follows a complete one-line If."""
        for token in range(self.start - 1, -1, -1):
            if self.kinds[token] in DECLARATIONS:
                break
            if self.kinds[token] == "IF" and (not token or self.kinds[token - 1] in ("_NL", "COLON")):
                line = self.kinds[token : self._line_end(token)]
                if "THEN" in line and line[-1] != "THEN":
                    number = self._line(token)
                    return f"the If of line {number} ends with its line; begin a new line after its Then"
                break
        return ""

    def _closes_inline(self, first: int, at: int) -> int:
        """Report a closer in a one-line If, which needs none because its line ends it."""
        words = " ".join(self.texts[first : at + 1])
        message = f"`{words}` is not allowed in an If of one line"
        self.report("stray-end", message, first, "remove it, or write each statement on its own line", at)
        return self._skip(at)

    def _declares(self, at: int) -> bool:
        """True if the statement begins a Sub or another declared block."""
        named = self.kinds[self.start + 1 : self.start + 2] in (["NAME"], ["_NL"])
        return self.kinds[self.start] in DECLARATIONS and named and at <= self.start + 1

    def _declared_inside(self, blocks: list[Block]) -> int:
        """Report and close the blocks still open before a `Sub` or another declared block."""
        kinds = tuple(self.kinds[self.start : self.start + 2])
        while blocks and self.mark.feed_all(kinds, self.start) is None:
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
        """Close blocks, innermost first, as if their closers preceded the statement.

        Returns False if a closer does not fit.
        """
        for block in blocks:
            top = self.mark.feed_all((*block.closing, "_NL"), self.start)
            if top is None:
                return False
            self.mark = self.top = top
        self.line = self.top
        return True

    def _wrong(self, at: int) -> int:
        """Report an error inside a statement that no other method has reported."""
        end = self._line_end(at)
        if keyword := self._keyword(self.start, KEYWORDS):
            self._report_misspelt(self.start, keyword)
            repaired = self.mark.feed_all(self._with(self.start, KEYWORDS[keyword]), self.start)
            assert repaired is not None
            self.top = repaired
            return self._after_line(end)
        kind, text = self.kinds[at], self.texts[at]
        before = self.texts[at - 1] if at else ""
        kinds = self.top.expected()
        if kinds <= AFTER_A_NAME:  # in `Run 3` the keyword was read as a name, which was not intended
            kinds = self.before.expected()
        hint = expectations.hint(kinds, before, text, self.kinds[self.start])
        self.report("syntax", expectations.message(kinds, kind, text), at, hint)
        for plain in plain_lines([*self.kinds[self.start : end], *_quoted(self.texts[end])]):
            if top := self.mark.feed_all(plain, self.start):
                self.top = top
                return self._after_line(end)
        return self._skip(at)

    # ------------------------------------------------------------------------------------------- recovery

    def _line_end(self, at: int) -> int:
        while self.kinds[at] not in ("_NL", END):
            at += 1
        return at

    def _skip(self, at: int) -> int:
        """Drop the rest of the line, and return the next token to read.

        The text before the error remains if the line may end there.
        """
        end = self._line_end(at)
        for top in (self.mark, self.line):
            after, fits = top.feed("_NL", end)
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


def _quoted(ending: str) -> list[str]:
    """Return the kinds of a line's rest that a single quote has made a comment, as if its quotes were double."""
    comment = ending.partition("\n")[0]
    return (
        Tokens(comment.replace("'", '"')).kinds[:-2] if comment.startswith("'") and "'" in comment[1:] else []
    )


def _article(name: str) -> str:
    return f"an {name}" if name[0] in "AEIOU" else f"a {name}"
