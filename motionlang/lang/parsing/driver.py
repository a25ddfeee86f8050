"""Generator of `_run`, the loop in a `tables` module that runs a grammar's table.

The loop is generated for one grammar, because a function call takes longer than the work of most reducers.
The most frequent reductions are inlined. So are tokens that usually form a value on their own; their nodes
are created when the token is shifted. Every other reduction calls its reducer. The stack is a linked list
with one tuple per symbol. The value of the topmost symbol is `top` and its state is `moves`, so few values
are pushed only to be popped again.
"""

from __future__ import annotations

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
    """Return the line that pops the values below the topmost of `length` off S.

    It assigns names to the values in `used` and drops the others.
    """
    if length < 2:
        return []
    names = [f"v{index}" if index in used else "_" for index in range(length - 1)]
    target = f"S, _, {names[0]}"
    for name in names[1:]:
        target = f"({target}), _, {name}"
    return [f"{target} = S"]


def loop(reductions: Iterable[list[str]], leaves: Iterable[list[str]]) -> str:
    """Return the text of `_run`.

    Each item of `reductions` and `leaves` has the lines that leave their result in S and `top`.
    """
    chosen = [("code", number, lines) for number, lines in enumerate(reductions)]
    made = [("made", number, lines) for number, lines in enumerate(leaves, 1)]
    return _LOOP.format(
        reductions=_indented([*_choice(chosen), "else:", *_within(_CALL.split("\n"))]),
        leaves=_indented(_choice(made)),
    )


def _choice(branches: list[tuple[str, int, list[str]]]) -> list[str]:
    lines = []
    for index, (name, number, inside) in enumerate(branches):
        lines += [f"{'elif' if index or name == 'code' else 'if'} {name} == {number}:", *_within(inside)]
    return lines


def _within(lines: list[str]) -> list[str]:
    return [f"    {line}" for line in lines]


def _indented(lines: list[str]) -> str:
    return "\n".join(" " * 12 + line for line in lines)
