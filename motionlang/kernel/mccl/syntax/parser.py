"""From MCCL text to its tree, by Lark with `grammars/mccl.lark`.

This module contains no mnemonic.
"""

from __future__ import annotations

from bisect import bisect_right
from functools import cache
from itertools import accumulate
from typing import cast

from lark import Lark, Token, Transformer

from motionlang.kernel.lang.syntax.grammar import load
from motionlang.kernel.lang.syntax.word import Word
from motionlang.kernel.mccl.syntax.tree import Command, Line, Module, Register, Wrong


class Builder(Transformer[Token, Module]):
    """Builds the node of each rule from its tokens and nodes; a symbol that is missing is None."""

    def start(self, lines: list[Line]) -> Module:
        return Module(lines, start=0, end=lines[-1].end if lines else 0)

    def line(self, commands: list[Command | Wrong]) -> Line:
        first, last = commands[0], commands[-1]
        return Line(0, commands, start=first.start, end=last.end)

    def command(self, found: list[Token | None]) -> Command:
        axis, word, argument = found
        assert word is not None
        start, end = _extent(found)
        return Command(_number(axis), _word(word), _argument(argument), start=start, end=end)

    def wrong(self, found: list[Token | None]) -> Wrong:
        """Build the node of a text that is no command."""
        axis, word, rest = found
        assert rest is not None
        start, end = _extent(found)
        text = "".join(each for each in found if each is not None)
        mistake = rest.start_pos or 0
        return Wrong(text, _number(axis), _word(word) if word else "", start=start, end=end, mistake=mistake)


def _extent(tokens: list[Token | None]) -> tuple[int, int]:
    given = [each for each in tokens if each is not None]
    return cast(int, given[0].start_pos), cast(int, given[-1].end_pos)


def _number(axis: Token | None) -> int | None:
    return None if axis is None else int(axis[:9])  # enough for any axis that there is


def _word(mnemonic: Token) -> Word:
    return Word(mnemonic.upper(), cast(int, mnemonic.start_pos), cast(int, mnemonic.end_pos))


def _argument(token: Token | None) -> int | float | str | Register | None:
    if token is None:
        return None
    match token.type:
        case "WHOLE":
            return int(token)
        case "REAL":
            return float(token)
        case "REGISTER":
            return Register(int(token[1:]), start=token.start_pos or 0, end=token.end_pos or 0)
    return str(token[1:-1])


# What a text means depends on what is before it: `1` may be an axis or a number.
OPTIONS: dict[str, object] = {"lexer": "contextual", "keep_all_tokens": False, "postlex": None}
# The controller's input buffer, in characters.
MAX_LINE = 255


@cache
def parser() -> Lark:
    """Return the parser of the grammar."""
    return load("mccl", Builder(), **OPTIONS)


def parse(text: str) -> Module:
    """Return the tree of a text; what is no command is in it as `Wrong`."""
    module = cast(Module, parser().parse(text))
    ends = list(accumulate(len(each) + 1 for each in text.split("\n")))
    for line in module.lines:
        line.number = bisect_right(ends, line.start) + 1
    return module


def mistake(text: str) -> int:
    """Return the length of the valid beginning of a text that should be a command."""
    for line in parse(text).lines:
        for command in line.commands:
            return command.mistake if isinstance(command, Wrong) else command.end
    return 0
