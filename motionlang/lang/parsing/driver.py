"""Writes the loop that runs the table of a grammar, `_run` of its `tables` module.

The loop is written for the grammar, since a call takes longer than most of what reducers do: the reductions that are
met most often stand in it, as do the tokens that are mostly values by themselves, which are made as they are shifted.
Every other reduction is a call of its reducer. The stack is a linked list, one tuple for every symbol; of the topmost
symbol the value is `top` and the state `moves`, so that little is put there to be taken off again.
"""

from __future__ import annotations

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Iterable

_LOOP = """

def _run(moves, kinds, T):
    following = iter(kinds)
    code, target = move(moves, next(following))
    S = top = None
    for at, kind in enumerate(following):
        while True:
            if code < 0:
                break
{reductions}
            try:
                moves, code, target = S[1][target]
            except KeyError:
                moves, code, target = goto(S[1], target)
        S = S, moves, top
        if code == -1:
            top, moves = at, target
            try:
                code, target = moves[kind]
            except KeyError:
                code, target = move(moves, kind)
        else:
            try:
                made, moves, code, target = target[kind]
            except KeyError:
                made, moves, code, target = leaf(target, kind)
{leaves}
            else:
                top = at
    return S[2]
"""
_CALL = """\
reducer, target = target
S, top = reducer(S, moves, top, T)"""


def popped(length: int, used: set[int]) -> list[str]:
    """The line that takes the values below the topmost of `length` off the stack S, naming those in use."""
    if length < 2:
        return []
    names = [f"v{place}" if place in used else "_" for place in range(length - 1)]
    target = f"S, _, {names[0]}"
    for name in names[1:]:
        target = f"({target}), _, {name}"
    return [f"{target} = S"]


def loop(reductions: Iterable[list[str]], leaves: Iterable[list[str]]) -> str:
    """The text of `_run`; each of both is the lines that put what they make of S and `top` there."""
    chosen = [("code", number, lines) for number, lines in enumerate(reductions)]
    made = [("made", number, lines) for number, lines in enumerate(leaves, 1)]
    return _LOOP.format(
        reductions=_indented([*_choice(chosen), "else:", *_within(_CALL.split("\n"))], 3),
        leaves=_indented(_choice(made), 3),
    )


def _choice(branches: list[tuple[str, int, list[str]]]) -> list[str]:
    lines = []
    for place, (name, number, inside) in enumerate(branches):
        lines += [f"{'elif' if place or name == 'code' else 'if'} {name} == {number}:", *_within(inside)]
    return lines


def _within(lines: list[str]) -> list[str]:
    return [f"    {line}" for line in lines]


def _indented(lines: list[str], depth: int) -> str:
    return "\n".join("    " * depth + line for line in lines)
