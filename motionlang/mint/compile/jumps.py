"""Labels, Goto and Gosub: a dispatcher over the stretches between labels.

    def j_main(pc):
     while True:
      try:
       if pc == 0: …; pc = 1
       if pc == 1: …
      except J as jump: pc = jump.args[0]

A Goto sets `pc`, a Gosub calls the dispatcher at a label, and Return leaves that call. Labels are between
statements of the outermost level. A jump out of loops is an exception, because Python has no other way to leave
several loops at once.

CPython needs 10 to 25 kB to compile a stretch, and a jump tests `pc` against each earlier stretch. If there are
many, they are divided into groups, each a chunk of the function (`splitting.py`). The dispatcher calls the group
that contains `pc`. The group returns the number of the next stretch outside itself, or None for a Return:

    def q1(pc):
     while 0 <= pc < 60:
      if pc == 0: …; pc = 1
      …
     return pc
"""

from __future__ import annotations

from collections.abc import Callable

from motionlang.mint.compile import loop_times, polling
from motionlang.mint.compile.body import Body
from motionlang.mint.compile.calls import depth_below
from motionlang.mint.compile.expressions import condition
from motionlang.mint.compile.lines import LEAVES, Line
from motionlang.mint.compile.splitting import SIZE, dispatcher, split_off
from motionlang.mint.syntax import nodes

# In a function with more stretches than this, no jump is watched, no loop of jumps is logged, and the stretches are
# divided into groups.
MAX_STRETCHES = 200


def write(b: Body, block: Callable[[Body, list[nodes.Stmt]], None]) -> None:
    """Write the lines of the dispatcher, without its head."""
    _check(b)
    first = len(b.lines)
    is_short = len(b.stretches()) <= MAX_STRETCHES
    b.regions = loop_times.regions(b) if is_short else []
    b.emit("while True:")
    b.emit(" try:")
    b.indent += 2
    if is_short or b.whole.typed:
        for number in range(len(b.stretches())):
            _write_stretch(b, number, block)
    else:
        _write_groups(b, block)
    _end(b)
    b.indent -= 2
    b.emit(f" except {b.whole.use('env', 'Jump')} as jump:")
    b.indent += 2
    b.emit("pc = jump.args[0]")
    if b.thrown:
        loop_times.thrown(b)
    b.indent -= 2
    texts = [poll.first for poll in b.polls] + [f"r{region.at} = None" for region in b.regions]
    b.lines[first:first] = [Line(b.indent, text, b.function.at) for text in texts]


def _write_stretch(b: Body, number: int, block: Callable[[Body, list[nodes.Stmt]], None]) -> None:
    """Write the statements after a label, which run if `pc` is their stretch's number."""
    body = b.stretches()[number][1]
    b.stretch = number
    b.emit(f"if pc == {number}:")
    b.indent += 1
    loop_times.open_regions(b)
    done = 0
    for end in sorted({region.end for region in b.regions if region.last == number}):
        block(b, body[done:end])
        loop_times.close_regions(b, end)
        done = end
    block(b, body[done:])
    b.flush()
    b.emit(f"pc = {number + 1}")
    b.indent -= 1


def _write_groups(b: Body, block: Callable[[Body, list[nodes.Stmt]], None]) -> None:
    """Write groups of stretches as chunks, and the dispatcher's calls of them."""
    count, first, indent = len(b.stretches()), len(b.lines), b.indent
    groups: list[tuple[int, Line]] = []
    begin, b.indent = 0, 3  # in the loop of the part
    for end in range(1, count + 1):
        _write_stretch(b, end - 1, block)
        if len(b.lines) - first < SIZE and end < count:
            continue
        at = b.lines[first].at
        head = Line(2, f"while {begin} <= pc < {end}:", at)
        lines = [head, *b.lines[first:], Line(2, "return pc", at)]
        del b.lines[first:]
        groups.append((end, split_off(b, lines, 2, ["pc"])))
        begin = end
    b.indent = indent
    _write_choice(b, groups)
    b.emit("if pc is None: return")
    b.emit(f"if pc < {count}: continue")


def _write_choice(b: Body, groups: list[tuple[int, Line]]) -> None:
    """Write a binary search for the group of `pc`.

    A group is given by its end and the line that calls it.
    """
    if len(groups) == 1:
        call = groups[0][1]
        call.text, call.indent = f"pc = {call.text}", b.indent
        b.lines.append(call)
        return
    half = len(groups) // 2
    for test, rest in ((f"if pc < {groups[half - 1][0]}:", groups[:half]), ("else:", groups[half:])):
        b.emit(test)
        b.indent += 1
        _write_choice(b, rest)
        b.indent -= 1


def _end(b: Body) -> None:
    """Write the end of the program text; it ends the task even within a Gosub."""
    if b.function.kind in ("sub", "event"):
        b.emit("return")
    else:
        if b.whole.guarded and b.function.kind == "main":
            b.horizon()  # report an error of the last statement to ONERROR
        b.emit(f"{b.whole.use('env', 'end_main' if b.function.kind == 'main' else 'end_this')}(t)")


def _check(b: Body) -> None:
    """Report duplicate labels."""
    seen: set[str] = set()
    for node in b.function.body:
        if type(node) is not nodes.Label:
            continue
        if node.name.lower() in seen:
            b.problem("duplicate", f"there is already a label {node.name}", node)
        seen.add(node.name.lower())


def jump(b: Body, node: nodes.Jump) -> None:
    """Compile a Goto or a Gosub."""
    labels = b.labels()
    key = node.name.lower()
    if key not in labels:
        at = node.name.start
        symbol = b.scope.find(node.name)
        if symbol is not None and symbol.kind == "sub":
            hint = f"a sub is called by its name alone: {symbol.name}"
            b.whole.problems.add("unknown-word", f"{symbol.name} is a sub, not a label", at, hint)
            return
        b.whole.problems.unknown(
            f"there is no label {node.name}",
            node.name,
            lambda: filter(None, labels),
            at,
            f"a label has a line of its own: #{node.name}",
        )
        return
    number = labels[key]
    b.pending += node.kind in ("goto", "gosub")
    b.flush()
    b.noted = True
    leaves_loops = any(kind for kind, _ in b.loops)
    poll = None
    if node.kind != "gosub" and number <= b.stretch and not leaves_loops:
        if b.watched_iteration is None and len(b.stretches()) <= MAX_STRETCHES:
            b.watched_iteration = polling.left_behind(b, list(polling.reached(b, b.function.body))) or ()
        poll = polling.Poll(b, *b.watched_iteration) if b.watched_iteration else None
    if poll is None:
        if node.kind != "exit":
            b.horizon()
    else:
        b.polls.append(poll)
        poll.counted(b)
    unless = _unless(b, node)
    if leaves_loops and node.kind != "gosub":
        b.thrown.update(b.timed)
    elif node.kind != "gosub" and loop_times.left(b, number):
        if unless:
            b.emit(unless.rstrip())
            b.indent += 1
        loop_times.jump(b, number)
        b.emit(f"pc = {number}; continue", LEAVES)
        b.indent -= bool(unless)
        return
    if node.kind == "gosub":
        b.note_yield()
        b.names.append(dispatcher(b.function))
        depth = f", {depth_below(b)}" if b.function.counted else ""
        b.emit(f"yield from {dispatcher(b.function)}({number}{depth})")
    elif leaves_loops:
        b.emit(f"{unless}raise {b.whole.use('env', 'Jump')}({number})")
    else:
        b.emit(f"{unless}pc = {number}; continue", LEAVES)


def _unless(b: Body, node: nodes.Jump) -> str:
    """Return the `if` in front of a conditional jump, "" for an unconditional one."""
    if node.unless is None:
        return ""
    test = condition(b, node.unless)
    b.settle()
    return f"if not ({test}): "


def return_(b: Body, node: nodes.Return) -> None:
    """Compile a Return from a Gosub."""
    b.pending += 1
    b.flush()
    b.noted = True
    loop_times.leave(b)
    b.emit("return", LEAVES)


def label(b: Body, node: nodes.Label) -> None:
    """Write nothing: labels begin stretches, and misplaced ones have been reported."""
