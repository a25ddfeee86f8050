"""Read a text with syntax errors: all of them in one pass, with position and suggested fix, and a tree.

Lark's parser reads the tokens up to one that does not fit, and reports which would (`kernel/lang/syntax/stack.py`).
Each faulty line is reported once. The statement and the rest of its line become a `Wrong`, or are replaced by the
shortest line that opens or closes the same block, so that one error gives one message. Missing and surplus closers are
repaired in the same way. A block that is still open when the block around it closes is reported at its opener and
closed. A closer without an open block is a `Wrong`. If a line has an error and none with a similar keyword in place of
its first word, that word is the error; so is a word that resembles a closer of the innermost block. The parser accepts
the tokens that result, so every text has a tree.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from functools import cached_property
from math import inf

from motionlang.kernel.errors import Diagnostic, ProgramError
from motionlang.kernel.lang import typography
from motionlang.kernel.lang.syntax.grammar import BAD, END, Token, lex
from motionlang.kernel.lang.syntax.stack import Stack
from motionlang.kernel.mint.syntax import expectations
from motionlang.kernel.mint.syntax.blocks import (
    CLOSERS,
    DECLARATIONS,
    OPENERS,
    WRONG,
    OpenBlock,
    block_words,
    closers,
    closing,
    opened_blocks,
)
from motionlang.kernel.mint.syntax.build import number
from motionlang.kernel.mint.syntax.nesting import MAX_DEPTH
from motionlang.kernel.mint.syntax.nodes import Module
from motionlang.kernel.mint.syntax.tokens import PARSER, SPELLINGS, ended
from motionlang.kernel.source import Source
from motionlang.kernel.tools import nearest

AFTER_A_NAME = {"EQUAL", "DOT", "LPAR", "LSQB"}
KEYWORDS = {spelling: (kind,) for kind, spelling in SPELLINGS.items() if spelling.isalpha()}
# What the shortest line of each block consists of behind its first word; what ends a line soonest comes first.
_IN_LINES = ("_NL", WRONG, "NAME", "THEN", "TO", "CASE", "EQUAL")
MAX_BACK = 2000  # a misspelt opener is looked for among so many tokens before its closer
MAX_ERRORS = 100  # more are not useful; a binary file has one on every line


def recovered(source: Source) -> Module:
    """Return the tree of a text that does not follow the grammar, with its syntax errors."""
    reader = _Reader(source)
    reader.read()
    parser = PARSER.parse_interactive("")
    for token in reader.kept:
        parser.feed_token(token)
    module: Module = parser.feed_eof()  # type: ignore[no-untyped-call]
    module.source, module.errors, module.tokens = source, ProgramError(reader.diagnostics).diagnostics, []
    return module


def unfinished(text: str) -> bool:
    """True if the text ends inside a block and has no error before that."""
    stack = Stack(PARSER)
    return all(map(stack.feed, lex(PARSER, ended(text)))) and not stack.feed(Token(END, ""))


class _Reader:
    """A pass through the tokens that finds errors.

    `stack` is the parser's present one, `mark` the one at the beginning of the statement. `kept` are the tokens that
    it has read, of which `kept_before` precede the statement.
    """

    def __init__(self, source: Source) -> None:
        self.source, size = source, len(source.text)
        self.tokens: list[Token] = [
            *lex(PARSER, ended(source.text)),
            Token(END, "", start_pos=size, end_pos=size),
        ]
        self.kinds = [token.type for token in self.tokens]
        self.diagnostics: list[Diagnostic] = []
        self.stack = Stack(PARSER)
        self.kept: list[Token] = []
        self._begin(0)
        self.spent: dict[int, Token] = {}  # maps an opener's offset to the inner opener that took its closer
        self.misspelt: set[int] = set()  # the words that are reported as misspelt keywords

    def read(self) -> None:
        """Find the errors, up to `MAX_ERRORS`, and close the blocks that are open."""
        at = 0
        while len(self.diagnostics) < MAX_ERRORS:
            if self.kinds[at] == END:
                for block in opened_blocks(self.mark):
                    self._missing(block)
                break
            if at == self.start:
                self._correct_closer()
            closer = self._closer(at, at + 1) if at == self.start else ""
            if closer:
                self._watch_columns(closer)
            at = self._after(at) if self.stack.feed(self.tokens[at]) else self._mistake(at)
            if (at == self.start or self.kinds[at - 1] == "THEN") and self._is_too_deep():
                self._report_depth()
                del self.kept[self.kept_before :]
                break
        self._close(list(opened_blocks(self.mark)))

    def _begin(self, at: int) -> None:
        """Begin a statement at a token."""
        self.mark, self.kept_before, self.start = self.stack.copy(), len(self.kept), at

    def _is_too_deep(self) -> bool:
        if len(self.stack) <= 2 * MAX_DEPTH:
            return False
        symbols = [symbol for symbol, _ in self.stack]
        of_a_line = symbols.count("line_then") + (symbols[0] == "THEN")
        return max(symbols.count("body"), of_a_line) > MAX_DEPTH

    def _report_depth(self) -> None:
        """Report blocks that are nested too deeply."""
        blocks = list(opened_blocks(self.stack))
        message = f"blocks are nested more than {MAX_DEPTH} deep here"
        hint = "move the inner ones into a Sub"
        # The last one has no body yet.
        self.report("syntax", message, blocks[min(1, len(blocks) - 1)].token, hint)

    def report(
        self, code: str, message: str, token: Token, hint: str = "", last: Token | None = None
    ) -> None:
        """Record an error at a token, or from it to the `last` one on the same line."""
        start, end = token.start_pos, (last or token).end_pos
        length = 1 if token.type == "_NL" else max(1, end - start)
        line, column = self.source.location(start)
        fix = ""
        if token.type == BAD:
            replaced, fix = typography.plain(self.source.line(line)[column - 1 :])
            length = replaced or length
        self.diagnostics.append(Diagnostic(code, message, line, column, length=length, hint=hint, fix=fix))

    def _after(self, at: int) -> int:
        """Keep the token `at`, record where statements begin, return the next."""
        self.kept.append(self._corrected(at))
        if self.kinds[at] in expectations.SEPARATORS:
            self._begin(at + 1)
        return at + 1

    def _corrected(self, at: int) -> Token:
        """Return a token that the grammar accepts, or one in its place if the builder raises Misuse for it."""
        token = self.tokens[at]
        if token.type == "NUMBER" and number(token) == inf:
            self.report("syntax", f"{expectations.found('', token)} is too large for a number", token)
            return _as(WRONG, token)
        if token.type == "DOTTED" and inf in map(number, token.split(".")[1:]):
            self.report("syntax", f"{expectations.found('', token)} has a number that is too large", token)
            return Token.new_borrow_pos("NAME", token.split(".")[0], token)
        if self.kinds[self.start] == "NEXT" and self.kinds[at - 1] in ("NEXT", "COMMA") and at > self.start:
            return self._named_as_its_loop(at, token)
        return token

    def _named_as_its_loop(self, at: int, token: Token) -> Token:
        """Return the name in a `Next`; it is that of a loop, of which the innermost is first."""
        if token.type in expectations.SEPARATORS:
            return token
        number = self.kinds[self.start : at].count("COMMA")
        variable = list(opened_blocks(self.mark))[number].name
        if variable.lower() == token.lower():
            return token
        if variable:
            message = f"`Next {token}` ends the `For` of `{variable}`"
            self.report("syntax", message, token, f"write {variable}" if number else f"write Next {variable}")
        return Token.new_borrow_pos(token.type, variable, token)

    def _watch_columns(self, closer: str) -> None:
        """Record a closer that is aligned with an outer opener but closes an inner block.

        If a closer turns out to be missing, it is the closer of that inner block.
        """
        blocks = list(opened_blocks(self.mark))
        if not blocks or blocks[0].kind != closer or self._under(blocks[0]):
            return
        meant = next((block for block in blocks[1:] if block.kind == closer and self._under(block)), None)
        if meant:
            self.spent.setdefault(meant.token.start_pos, blocks[0].token)

    def _under(self, block: OpenBlock) -> bool:
        """True if the statement is in the same column as the opener of a block."""
        return self._column(self.tokens[self.start]) == self._column(block.token)

    def _line(self, token: Token) -> int:
        return self.source.location(token.start_pos)[0]

    def _column(self, token: Token) -> int:
        return self.source.location(token.start_pos)[1]

    # ------------------------------------------------------------------------------------------- mistakes

    def _mistake(self, at: int) -> int:
        """Report the unexpected token `at`, recover, and return the next token to read."""
        blocks = list(opened_blocks(self.mark))
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

    def _inline(self, first: int, blocks: list[OpenBlock]) -> bool:
        """True if the statement at `first` belongs to a one-line If."""
        return self.kinds[first - 1] in ("THEN", "ELSE") or any(block.inline for block in blocks)

    def _closes(self, closer: str, at: int, blocks: list[OpenBlock]) -> int:
        """Report a closer that does not fit, and return the token after it.

        Either inner blocks are still open, which are reported, too, or no block of that kind is open.
        """
        index = next((i for i, block in enumerate(blocks) if block.kind == closer), None)
        words = " ".join(self.tokens[self.start : at + 1])
        name = OPENERS[closer]
        if index:
            for block in blocks[:index]:
                self._missing(block)
            if self._close(blocks[:index]):
                return self.start
        is_wrong_end = self.kinds[self.start] == "END" and closing(closer) != f"End {name}"
        first, last = self.tokens[self.start], self.tokens[at]
        if index is not None and not is_wrong_end:
            self.report("syntax", f"`{words}` is not allowed here", first, last=last)
        elif blocks and (index is not None or self._under(blocks[0])):
            message = f"`{words}` does not close `{OPENERS[blocks[0].kind]}`"
            self.report("stray-end", message, first, f"write {closing(blocks[0].kind)}", last)
            self._close(blocks[:1])
        elif not self._is_opener_misspelt(closer):
            message = f"`{words}` without {_article(name)}"
            hint = self._else_if(at) if closer == "IF" and self.kinds[self.start] in ("END", "ENDIF") else ""
            hint = hint or (self._one_line_if() if closer == "IF" else "")
            hint = hint or f"remove it, or add the {name} it belongs to"
            self.report("stray-end", message, first, hint, last)
        return self._skip(at)

    def _is_opener_misspelt(self, closer: str) -> bool:
        """True if the opener of a closer is misspelt; the word is then reported.

        The word was read as the name of a sub.
        """
        for token in range(self.start - 1, max(-1, self.start - MAX_BACK), -1):
            if self.kinds[token] in DECLARATIONS:
                return False
            if self.kinds[token - 1] not in expectations.SEPARATORS and token:
                continue
            if self._keywords(token, 1, {OPENERS[closer]: (closer,)}):
                self._report_misspelt(token, 1, OPENERS[closer])
                return True
        return False

    def _correct_closer(self) -> None:
        """Correct the words of a statement that were meant to close or continue the innermost block."""
        at = self.start
        if self.kinds[at] not in ("NAME", "END", "LOOP"):
            return
        block = next(opened_blocks(self.mark), None)
        if block is None:
            return
        if self.kinds[at] == "LOOP" and _is_do(block):
            end = self._line_end(at)
            self.tokens[at:end] = [_as(kind, self.tokens[at]) for kind in block.closing]
            self.kinds[at:end] = block.closing
        for count in (1, 2):
            if self._correct(count, closers(block.kind)):
                break

    def _correct(self, count: int, keywords: Mapping[str, Sequence[str]]) -> bool:
        """Put keywords in place of the first words of the statement if these are misspelt, and report them."""
        at = self.start
        meant = self._keywords(at, count, keywords)
        if meant:
            self._report_misspelt(at, count, meant)
            self.tokens[at : at + count] = self._corrected_words(at, count, keywords[meant])
            self.kinds[at : at + count] = keywords[meant]
        return bool(meant)

    def _keywords(self, at: int, count: int, keywords: Mapping[str, Sequence[str]]) -> str:
        """Return the keywords that some words were meant to be, "" if there are none.

        The words begin a statement that is valid with the keywords, and are not the name of a sub or task, nor a label.
        """
        words, kinds = self.tokens[at : at + count], self.kinds[at : at + 3]
        if "NAME" not in kinds[:count] or at in self.misspelt or not all(map(str.isidentifier, words)):
            return ""
        found = nearest(" ".join(words), keywords)
        is_label = kinds[1:] == ["COLON", "_NL"]
        if found is None or is_label or not self._declared.isdisjoint(word.lower() for word in words):
            return ""
        rest = self.tokens[at + count : self._line_end(at) + 1]
        line = self.mark.after([*self._corrected_words(at, count, keywords[found]), *rest])
        return found if line is not None else ""

    def _corrected_words(self, at: int, count: int, kinds: Sequence[str]) -> list[Token]:
        words = self.tokens[at : at + count]
        return [_as(kind, words[min(i, count - 1)]) for i, kind in enumerate(kinds)]

    @cached_property
    def _declared(self) -> set[str]:
        """The names of the program's subs and tasks, in lower case."""
        pairs = zip(self.kinds, self.tokens[1:], strict=False)
        return {name.lower() for kind, name in pairs if kind in DECLARATIONS}

    def _report_misspelt(self, at: int, count: int, keywords: str) -> None:
        self.misspelt.add(at)
        words = self.tokens[at : at + count]
        message = f"{' '.join(words)} is neither a keyword nor a sub of this program"
        self.report("unknown-word", message, words[0], f"did you mean {keywords}?", words[-1])
        self.diagnostics[-1].candidates = (keywords,)

    def _else_if(self, at: int) -> str:
        """Return a hint for a surplus `End If` if an `Else If` was read as ElseIf."""
        for token in range(at - 1, 1, -1):
            if self.kinds[token - 2 : token + 1] == ["_NL", "ELSE", "IF"]:
                line = self._line(self.tokens[token])
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
            if self.kinds[token] == "IF" and (not token or self.kinds[token - 1] in expectations.SEPARATORS):
                line = self.kinds[token : self._line_end(token)]
                if "THEN" in line and line[-1] != "THEN":
                    number = self._line(self.tokens[token])
                    return f"the If of line {number} ends with its line; begin a new line after its Then"
                break
        return ""

    def _closes_inline(self, first: int, at: int) -> int:
        """Report a closer in a one-line If, which needs none because its line ends it."""
        words = " ".join(self.tokens[first : at + 1])
        message = f"`{words}` is not allowed in an If of one line"
        hint = "remove it, or write each statement on its own line"
        self.report("stray-end", message, self.tokens[first], hint, self.tokens[at])
        return self._skip(at)

    def _declares(self, at: int) -> bool:
        """True if the statement begins a Sub or another declared block."""
        named = self.kinds[self.start + 1 : self.start + 2] in (["NAME"], ["_NL"])
        return self.kinds[self.start] in DECLARATIONS and named and at <= self.start + 1

    def _declared_inside(self, blocks: list[OpenBlock]) -> int:
        """Report and close the blocks still open before a `Sub` or another declared block."""
        while blocks and self.mark.after(self.tokens[self.start : self.start + 2]) is None:
            self._missing(blocks[0])
            if not self._close(blocks[:1]):
                return self._skip(self.start)
            blocks = blocks[1:]
        return self.start

    def _missing(self, block: OpenBlock) -> None:
        if _is_do(block):
            return
        token = block.token
        while token.start_pos in self.spent:
            token = self.spent.pop(token.start_pos)
        self.report(
            "missing-end", f"`{OPENERS[block.kind]}` is never closed", token, f"add {closing(block.kind)}"
        )

    def _wrong(self, at: int) -> int:
        """Report an error inside a statement that no other method has reported."""
        end = self._line_end(at)
        if self._correct(1, KEYWORDS):
            self._replace((), self.start)  # the statement is read again
            return self.start
        token = self.tokens[at]
        before = self.tokens[at - 1] if at else ""
        if before in ("+", "-") and self.tokens[at - 2] == before != self.tokens[at - 3]:
            before *= 2
        kinds = self.stack.reduced().accepts() - {WRONG}
        if token.type == BAD or kinds <= AFTER_A_NAME:  # in `Run 3` the keyword was not intended as a name
            kinds = self.stack.accepts() - {WRONG}
        behind = at  # where the rest of an If of one line would begin
        if "THEN" in kinds and self.kinds[at] == "NAME" and nearest(token, ("Then",)) is not None:
            self._report_misspelt(at, 1, "Then")
            behind = at + 1
        else:
            hint = self._continued(at) if "_NL" in kinds else ""
            hint = hint or self._event_name(at) or self._without_brackets(end)
            hint = hint or expectations.hint(kinds, before, token, self.kinds[self.start])
            self.report("syntax", expectations.message(kinds, token.type, token), token, hint)
        if "THEN" in kinds and self._is_of_one_line(behind, end) and self._add_then(behind, end):
            return behind
        for words in block_words([*self.kinds[self.start : end], *_quoted(self.tokens[end])]):
            line = self._shortest(words)
            if line and self._replace(self._written(line, end), end + 1):
                return self.start
        return self._skip(at)

    def _continued(self, at: int) -> str:
        """Return a hint for the first token of a line that continues the line before, "" for others."""
        before, token = self.tokens[at - 1], self.tokens[at]
        mark = self.source.text[before.end_pos : token.start_pos].strip()[:1]
        if at == self.start or mark not in ("\\", "_"):
            return ""
        return f"line {self._line(before)} goes on here; remove the {mark} at its end"

    def _event_name(self, at: int) -> str:
        """Return a hint for the number of an event apart from its name, as in `Event IN(3)`."""
        number = at + (self.kinds[at] == "LPAR")
        if self.kinds[self.start] != "EVENT" or at != self.start + 2 or self.kinds[number] != "NUMBER":
            return ""
        name = f"{self.tokens[at - 1]}{self.tokens[number]}"
        return f"an event has no parameters; one with a number is written Event {name}"

    def _without_brackets(self, end: int) -> str:
        """Return a hint for a statement that is right without the brackets behind its word, as in `Run(Feeder)`."""
        kinds = self.kinds[self.start : end]
        if kinds[0] == "NAME" or kinds[1:2] != ["LPAR"] or "RPAR" not in kinds:
            return ""
        word, closing = self.tokens[self.start], self.start + kinds.index("RPAR")
        inside = self.tokens[self.start + 2 : closing]
        if self.mark.after([word, *inside, *self.tokens[closing + 1 : end + 1]]) is None:
            return ""
        return f"write {' '.join([word, *inside])}"

    def _is_of_one_line(self, at: int, end: int) -> bool:
        """True if the line has tokens from `at` to its end, and the next line is not indented as a body is."""
        column, following = self._column(self.tokens[self.start]), self.tokens[end + 1]
        return at < end and (following.type == END or self._column(following) <= column)

    # ------------------------------------------------------------------------------------------- recovery

    def _add_then(self, at: int, end: int) -> bool:
        """Add a Then before the token `at`; return False if the rest of the line, up to `end`, does not fit."""
        (then,) = self._made(("THEN",))
        if self.stack.after([then, *self.tokens[at : end + 1]]) is None:
            return False
        self.kept.append(then)
        return self.stack.feed(then)

    def _line_end(self, at: int) -> int:
        while self.kinds[at] != "_NL":
            at += 1
        return at

    def _skip(self, at: int) -> int:
        """Put a Wrong in place of the statement and the rest of its line; return the next token to read.

        Before the first Case of a Select there is no statement.
        """
        end = self._line_end(at)
        if not self._replace(self._written((WRONG, "_NL"), end), end + 1):
            self._replace(self._written(("_NL",), end), end + 1)
        return self.start

    def _close(self, blocks: list[OpenBlock]) -> bool:
        """Close blocks, innermost first, as if their closers preceded the statement.

        Returns False if a closer does not fit.
        """
        return all(self._replace(self._made((*block.closing, "_NL")), self.start) for block in blocks)

    def _replace(self, tokens: Sequence[Token], at: int) -> bool:
        """Read other tokens in place of the statement and go on at the token `at`; return False if they do not fit."""
        stack = self.mark.after(tokens)
        if stack is None:
            return False
        self.stack = stack
        self.kept[self.kept_before :] = tokens
        self._begin(at)
        return True

    def _shortest(self, words: Sequence[str]) -> list[str]:
        """Return the kinds of the shortest line that begins with some words, these alone if they do not fit.

        It is empty if no such line has an end.
        """
        line, stack = list(words), self.mark.after(Token(word, "") for word in words)
        while stack is not None and line[-1] != "_NL":
            kind = next((kind for kind in _IN_LINES if stack.feed(Token(kind, ""))), "")
            if not kind:  # as in `Type(0) =`
                return []
            line.append(kind)
        return line

    def _written(self, kinds: Sequence[str], end: int) -> list[Token]:
        """Return tokens of these kinds in place of the statement and the rest of its line, which ends at `end`.

        Those that the line has at the same position are its own. The names in a `Next` are left out.
        """
        first, last = self.tokens[self.start], self.tokens[end - 1]
        made = []
        for at, kind in enumerate(kinds, self.start):
            if kind == "_NL":
                made.append(self.tokens[end])
            elif kind == WRONG:
                made.append(Token(WRONG, "", start_pos=first.start_pos, end_pos=last.end_pos))
            elif at < end and self.kinds[at] == kind and (kind != "NAME" or kinds[0] != "NEXT"):
                made.append(self.tokens[at])
            else:
                made.append(Token(kind, "", start_pos=first.start_pos, end_pos=first.start_pos))
        return made

    def _made(self, kinds: Iterable[str]) -> list[Token]:
        """Return tokens of these kinds that are not in the text, behind the statement before."""
        at = next(
            (token.end_pos for token in reversed(self.kept) if token.type not in expectations.SEPARATORS), 0
        )
        return [Token(kind, "", start_pos=at, end_pos=at) for kind in kinds]


def _as(kind: str, token: Token) -> Token:
    return Token.new_borrow_pos(kind, token, token)


def _is_do(block: OpenBlock) -> bool:
    """True if a block was opened in place of a `Do`, which is reported, so its `Loop` ends it."""
    return block.kind == "LOOP" and not block.token


def _quoted(ending: str) -> list[str]:
    """Return the kinds of a line's rest that a single quote has made a comment, as if its quotes were double."""
    comment = ending.partition("\n")[0]
    if not (comment.startswith("'") and "'" in comment[1:]):
        return []
    return [token.type for token in lex(PARSER, comment.replace("'", '"'))]


def _article(name: str) -> str:
    return f"an {name}" if name[0] in "AEIOU" else f"a {name}"
