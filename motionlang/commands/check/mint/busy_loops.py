"""The check for endless loops that compute and never wait.

Such a loop takes all the time of its task, and nothing outside the program can influence it.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING

from motionlang.kernel.mint.resolve.flowgraph import END, Graph, Step
from motionlang.kernel.mint.resolve.symbols import TIME, Function
from motionlang.kernel.mint.syntax import nodes
from motionlang.kernel.mint.syntax.traversal import walk

if TYPE_CHECKING:
    from motionlang.commands.check.mint.effects import Facts

Add = Callable[..., None]

# Statements that let time pass or start another task.
_TAKES_TIME = (nodes.Pause, nodes.Input, nodes.Run)


def check_busy_loops(facts: Facts, add: Add) -> None:
    """Report each endless loop that only computes.

    Programs with tasks, event handlers or a host are not checked, because these may use or change its variables.
    """
    if len([each for each in facts.functions if each.kind != "sub"]) != 1 or facts.hosted:
        return
    for function in facts.functions:
        graph = facts.graphs[function]
        if graph.handlers:
            return
        for region in _endless(graph):
            steps = _with_subs(facts, region)
            if any(_computes(step) for step in steps) and all(_is_quiet(facts, step) for step in steps):
                message = "this loop computes forever: it never waits, and nothing can end it"
                add("busy-loop", message, _first(function, region), "add a WAIT, a PAUSE or an Exit to it")


def _endless(graph: Graph) -> list[set[Step]]:
    """Return the loops that are never left, each as the set of its steps."""
    leaves = graph.backward(1, 1, lambda step, bits: bits)
    found: list[set[Step]] = []
    for step in graph.reached():
        for after in step.next:
            if after.number <= step.number and not leaves[after] and not any(after in each for each in found):
                region = graph.reached(after)
                if region == _leading(region, after):
                    found.append(region)
    return found


def _leading(region: set[Step], to: Step) -> set[Step]:
    """Return the steps of a region from which a path leads to the step `to`."""
    before: dict[Step, list[Step]] = {step: [] for step in region}
    for step in region:
        for after in step.next:
            before[after].append(step)
    found: set[Step] = set()
    stack = [to]
    while stack:
        step = stack.pop()
        if step not in found:
            found.add(step)
            stack.extend(before[step])
    return found


def _computes(step: Step) -> bool:
    return isinstance(step.node, nodes.Assign | nodes.Call | nodes.Print)


def _is_quiet(facts: Facts, step: Step) -> bool:
    """True if a step only computes or prints values that the program sets."""
    node = step.node
    if isinstance(node, _TAKES_TIME) or step.kind == END:
        return False
    if any(act.callee is None for act in facts.acts[step]):
        return False
    for each in walk([node] if node is not None else []):
        if type(each) is nodes.Name:
            if each.row is not None and each.row.changes == "always":
                return False
            if each.symbol is not None and each.symbol.type.name == TIME:
                return False
    return True


def _with_subs(facts: Facts, region: set[Step]) -> set[Step]:
    """Return the steps of a loop and of all subs that it calls."""
    callees = [act.callee for step in region for act in facts.acts[step] if act.callee is not None]
    called = [each for callee in callees for each in facts.called(callee)]
    return region.union(*(facts.graphs[each].steps for each in called))


def _first(function: Function, region: set[Step]) -> int:
    """Return the first offset of a loop."""
    inside = {id(step.node) for step in region}
    whiles = [
        each for each in walk(function.body) if type(each) is nodes.While and id(each.condition) in inside
    ]
    return min(each.start for each in [*whiles, *(step.node for step in region if step.node is not None)])
