"""Parse Mint text into its syntax tree."""

from __future__ import annotations

import re
from typing import cast

from lark import UnexpectedInput

from motionlang.kernel.errors import ProgramError
from motionlang.kernel.lang.syntax.grammar import Token, lex
from motionlang.kernel.mint import syntax
from motionlang.kernel.mint.syntax.build import Misuse
from motionlang.kernel.mint.syntax.nesting import (
    MAX_DEPTH,
    MAX_EXPRESSION_DEPTH,
    bodies,
    cut_too_deep,
    flatten_chains,
)
from motionlang.kernel.mint.syntax.nodes import Call, Label, Module
from motionlang.kernel.mint.syntax.tokens import PARSER, ended
from motionlang.kernel.source import Source

# `NAME:` on a line of its own. The grammar takes it for a call.
_LABEL = re.compile(r"^[ \t]*+([A-Za-z_][A-Za-z0-9_]*+)[ \t]*+:[ \t]*+(?:'.*)?$", re.MULTILINE)
# How a line may end that continues on the next one.
_CONTINUED = re.compile(r"[\\_][ \t]*(?:'.*)?$", re.MULTILINE)


def parse(source: Source) -> Module:
    """Return the tree of a program; raise ProgramError with all syntax errors of the text."""
    module = read(source)
    if module.errors:
        raise ProgramError(module.errors)
    return module


def read(source: Source) -> Module:
    """Return the tree of a text, which has its syntax errors, and a `Wrong` in place of what has one."""
    try:
        parser = PARSER.parse_interactive(ended(source.text))
        tokens = parser.exhaust_lexer()
        module = cast(Module, parser.feed_eof(tokens[-1]))  # type: ignore[no-untyped-call]
        module.source, module.errors, module.tokens = source, [], cast("list[Token]", tokens)
    except (UnexpectedInput, Misuse):
        module = syntax.recovered(source)
    else:
        if max(depth for _, depth in bodies(module)) > MAX_DEPTH:
            module = syntax.recovered(source)
    _mark_labels(module)
    if not _is_short(source.text):
        flatten_chains(module)
        cut_too_deep(module)
    return module


def _mark_labels(module: Module) -> None:
    """Put a Label in place of each call that is `NAME:` on a line of its own."""
    text = module.source.text
    labels = {match.start(1) for match in _LABEL.finditer(text) if _begins_line(text, match.start())}
    for body, _ in bodies(module) if labels else ():
        for i, each in enumerate(body):
            if type(each) is Call and each.start in labels and each.target.args is None:
                body[i] = Label(each.start, each.end, each.target.name)


def _begins_line(text: str, at: int) -> bool:
    """True if the line at an offset does not continue the line before."""
    before = text[text.rfind("\n", 0, max(at - 1, 0)) + 1 : at]
    return not before or [token.type for token in lex(PARSER, before)][-1:] == ["_NL"]


def _is_short(text: str) -> bool:
    """True if all lines are too short for an expression to be nested too deeply.

    A level takes at least one character, as in `---1`.
    """
    return max(map(len, text.split("\n"))) <= MAX_EXPRESSION_DEPTH and not _CONTINUED.search(text)


def is_complete(text: str) -> bool:
    """True if the text is complete, so that it may end here.

    It is incomplete inside an open block and after a line continuation.
    """
    return not (text.rstrip(" \t\n").endswith(("\\", " _")) or syntax.unfinished(text))
