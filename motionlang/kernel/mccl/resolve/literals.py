"""The literals of a program: the numbers that follow its commands."""

from __future__ import annotations

from collections.abc import Collection

from motionlang.kernel.lang.literals import Literal, addressed
from motionlang.kernel.lang.syntax.word import Word
from motionlang.kernel.mccl.keywords import table
from motionlang.kernel.mccl.syntax import tree
from motionlang.kernel.source import Source


def literals(source: Source, module: tree.Module, jumps: Collection[str]) -> list[Literal]:
    """Return the parameters that are numbers, except those of commands whose function is one of `jumps`.

    A command that is not simulated has none either.
    """
    found = []
    for line in module.lines:
        for each in line.commands:
            if not isinstance(each, tree.Command) or not isinstance(each.argument, (int, float)):
                continue
            row = table().get(each.word)
            if row is not None and row.simulated and row.function not in jumps:
                at = parameter(each)
                base, text = source.text[each.start : at].upper(), source.text[at : each.end]
                number = source.before + line.number
                found.append(Literal("", base, number, at, text, each.argument, True, True))
    return addressed(found)


def parameter(command: tree.Command) -> int:
    """Return the offset of the parameter of a command, or of its end."""
    assert isinstance(command.word, Word)
    return command.word.end
