"""Compile loops and the statements that leave them.

The cost of an iteration is added once, at its end, and compared with the horizon there. So a loop can neither
delay the machine nor hang. `Next`, `End While`, `Until` and `End Loop` cost one statement each.
"""

from __future__ import annotations

from motionlang.mint.compile import loop_times, polling, stops
from motionlang.mint.compile.body import Body
from motionlang.mint.compile.expressions import condition
from motionlang.mint.compile.lines import BREAK, LOOP
from motionlang.mint.compile.polling import Poll
from motionlang.mint.syntax import nodes

COMPARISONS = {"=": "==", "<>": "!=", "<": "<", ">": ">", "<=": "<=", ">=": ">="}


def body_of(b: Body, kind: str, body: list[nodes.Stmt], flag: str) -> None:
    """Write the statements of a loop."""
    from motionlang.mint.compile.statements import block

    b.loops.append((kind, flag))
    if b.whole.debugging is not None:
        stops.in_empty_loop(b, body)
    block(b, body)
    b.loops.pop()


def end_iteration(b: Body, poll: Poll | None = None, cost: int = 1) -> None:
    """Write the end of an iteration: pay for it, and let others run if they are due."""
    b.pending += cost
    if poll is None:
        b.horizon()
    else:
        poll.end_iteration(b)
        b.watching -= 1


def flag_for(b: Body, kind: str, body: list[nodes.Stmt]) -> str:
    """Create a flag for an Exit that must first leave inner loops; "" if none does."""
    if not (b.function.exits and leaves(body, kind, inside=True)):
        return ""
    flag = b.temp()
    b.emit(f"{flag} = False")
    return flag


def go_on_leaving(b: Body) -> None:
    """Write the code after a loop that continues an Exit from an outer loop."""
    for _, flag in b.loops:
        if flag:
            b.emit(f"if {flag}: break", BREAK)


def _opened(b: Body, kind: str, body: list[nodes.Stmt], *conditions: nodes.Expr) -> tuple[str, Poll | None]:
    """Write the code before a loop; return the flag of an Exit and any polling watch."""
    b.flush()
    flag = flag_for(b, kind, body)
    loop_times.begin(b)
    return flag, polling.watched(b, body, *conditions)


def _forever(b: Body) -> None:
    """Write the head of a loop that is left from within."""
    b.emit("while True:", LOOP)
    b.indent += 1


def _iteration(b: Body, kind: str, body: list[nodes.Stmt], flag: str, poll: Poll | None) -> None:
    """Write the statements of an iteration, and its end with the loop's source offset."""
    at = b.at
    body_of(b, kind, body, flag)
    b.at = at
    _closed(b, poll)


def _closed(b: Body, poll: Poll | None, cost: int = 1) -> None:
    end_iteration(b, poll, cost)
    b.indent -= 1
    loop_times.end(b)
    go_on_leaving(b)


def while_(b: Body, node: nodes.While) -> None:
    """Compile `While condition … End While`."""
    test = condition(b, node.condition)
    observes, calls = b.observes, b.calls
    b.pending += 1
    flag, poll = _opened(b, "while", node.body, node.condition)
    if observes or calls:
        _forever(b)
        b.settle()
        b.emit(f"if not ({test}): break", BREAK)
    else:
        b.emit(f"while {test}:", LOOP)
        b.indent += 1
    _iteration(b, "while", node.body, flag, poll)


def repeat(b: Body, node: nodes.Repeat) -> None:
    """Compile `Repeat … Until condition`."""
    flag, poll = _opened(b, "repeat", node.body, node.condition)
    _forever(b)
    body_of(b, "repeat", node.body, flag)
    b.at = node.condition.start
    b.begin()
    test = condition(b, node.condition)
    b.settle()
    b.pending += 1
    b.flush()
    b.emit(f"if {test}: break", BREAK)
    _closed(b, poll, 0)


def endless(b: Body, node: nodes.Loop) -> None:
    """Compile `Loop … End Loop`."""
    flag, poll = _opened(b, "loop", node.body)
    _forever(b)
    _iteration(b, "loop", node.body, flag, poll)


# ---------------------------------------------------------------------------------------------------- Exit


def leave_loop(b: Body, node: nodes.Exit, kind: str) -> None:
    """Compile `Exit` and `Exit For …`: leave the innermost loop or block of that kind."""
    name = f"Exit {kind.capitalize()}".rstrip()
    around = [(k, flag) for k, flag in b.loops if k]
    if not kind:
        inner = [k for k, _ in around if k not in ("select", "if")]
        if not inner:
            b.problem(
                "stray-end", "Exit outside a loop", node, "Exit Sub leaves a sub, Exit Function a function"
            )
            return
        kind = inner[-1]
    if all(k != kind for k, _ in around):
        b.problem("stray-end", f"{name} outside a {kind.capitalize()}", node)
        return
    b.flush()
    b.noted = True
    innermost, _ = around[-1]
    if innermost != kind:
        flag = next(flag for k, flag in reversed(around) if k == kind)
        b.emit(f"{flag} = True")
    b.emit("break", BREAK)


def leaves(body: list[nodes.Stmt], kind: str, inside: bool = False) -> bool:
    """True if an Exit in `body` leaves a block of `kind` around it.

    `inside`: only an Exit from within an inner Python loop counts.
    """
    return any(_leaves(node, kind, inside, False, False) for node in body)


# Python's own parser recurses at every `elif`. A Select with more cases than this is written as separate
# tests.
MANY_CASES = 100


def branches(node: nodes.If) -> list[nodes.If]:
    """Return an If and its ElseIfs, without recursion."""
    found = [node]
    while len(node.orelse) == 1 and type(node.orelse[0]) is nodes.If:
        node = node.orelse[0]
        found.append(node)
    return found


def is_long(node: nodes.If) -> bool:
    """True if an If with many ElseIfs becomes a Python loop of one iteration.

    A long Select becomes one, too.
    """
    count = 0
    while len(node.orelse) == 1 and type(node.orelse[0]) is nodes.If and count <= MANY_CASES:
        node, count = node.orelse[0], count + 1
    return count > MANY_CASES


def is_loop(node: nodes.Select) -> bool:
    """True if a Select becomes a Python loop of one iteration, which `break` leaves."""
    return len(node.cases) > MANY_CASES or any(leaves(case.body, "select") for case in node.cases)


_KINDS: dict[type, str] = {nodes.For: "for", nodes.While: "while", nodes.Repeat: "repeat", nodes.Loop: "loop"}


def _leaves(node: nodes.Stmt, kind: str, inside: bool, in_loop: bool, nested: bool) -> bool:
    """True if an Exit in a statement leaves a block of `kind`.

    `in_loop`: the Exit is in an inner Mint loop. `nested`: it is in an inner Python loop, which may also come
    from a Select.
    """
    if type(node) is nodes.Exit:
        wanted = node.kind or ("" if in_loop or kind == "select" else kind)
        return wanted == kind and (nested or not inside)
    if type(node) is nodes.Select:
        if kind == "select":
            return False
        nested = nested or is_loop(node)
        return any(_leaves(each, kind, inside, in_loop, nested) for case in node.cases for each in case.body)
    if type(node) in _KINDS:
        if _KINDS[type(node)] == kind:
            return False
        in_loop = nested = True
    if type(node) is nodes.If:
        nested = nested or is_long(node)
        chain = branches(node)
        bodies = [*(branch.body for branch in chain), chain[-1].orelse]
        return any(_leaves(each, kind, inside, in_loop, nested) for body in bodies for each in body)
    body: list[nodes.Stmt] = getattr(node, "body", None) or []
    return any(_leaves(each, kind, inside, in_loop, nested) for each in body)
