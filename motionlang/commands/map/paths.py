"""Order, components and postdominators of a graph whose nodes are integers.

All functions take `following`, which returns the nodes after a node, and are iterative, because a program may have any
length.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence

Following = Callable[[int], Sequence[int]]


def ordered(roots: Iterable[int], following: Following) -> tuple[list[int], list[tuple[int, int]]]:
    """Return the nodes that roots lead to, each before those after it, and the edges that lead back.

    Without the edges that lead back the graph has no cycle.
    """
    done: dict[int, bool] = {}
    finished: list[int] = []
    back: list[tuple[int, int]] = []
    for root in roots:
        if root in done:
            continue
        done[root] = False
        stack = [(root, iter(following(root)))]
        while stack:
            node, rest = stack[-1]
            for each in rest:
                if each not in done:
                    done[each] = False
                    stack.append((each, iter(following(each))))
                    break
                if not done[each]:
                    back.append((node, each))
            else:
                done[node] = True
                finished.append(node)
                stack.pop()
    return finished[::-1], back


def components(order: Sequence[int], following: Following) -> dict[int, int]:
    """Return a number for each node, the same for nodes that lead to one another.

    `order` is that of `ordered`. No node leads to one with a lower number.
    """
    comes_from: dict[int, list[int]] = {node: [] for node in order}
    for node in order:
        for each in following(node):
            comes_from[each].append(node)
    found: dict[int, int] = {}
    for number, node in enumerate(order):
        stack = [node]
        while stack:
            each = stack.pop()
            if each not in found:
                found[each] = number
                stack += comes_from[each]
    return found


def postdominators(
    order: Sequence[int], back: Iterable[tuple[int, int]], following: Following
) -> dict[int, int]:
    """Return for each node the first one that every path from it passes, -1 if that is the end.

    `order` and `back` are those of `ordered`. A loop that nothing leaves ends where it leads back.
    """
    ends = -1
    leads_to: dict[int, list[int]] = {node: list(following(node)) or [ends] for node in order}
    comes_from: dict[int, list[int]] = {ends: []}
    for node in order:
        for each in leads_to[node]:
            comes_from.setdefault(each, []).append(node)
    reached, _ = ordered([ends], lambda node: comes_from.get(node, ()))
    ending = set(reached)
    leads_back: dict[int, list[int]] = {}
    for node, head in back:
        leads_back.setdefault(head, []).append(node)
    for last in reversed(order):
        # The last node that leads to no end leads back in a loop that nothing leaves.
        for head in [] if last in ending else list(leads_to[last]):
            stack = [node for node in leads_back[head] if node not in ending]
            for node in stack:
                leads_to[node].append(ends)
                comes_from[ends].append(node)
            while stack:
                each = stack.pop()
                if each not in ending:
                    ending.add(each)
                    stack += comes_from.get(each, ())
    reached, _ = ordered([ends], lambda node: comes_from.get(node, ()))
    number = {node: k for k, node in enumerate(reached)}
    found: dict[int, int] = {ends: ends}
    changed = True
    while changed:
        changed = False
        for node in reached[1:]:
            new: int | None = None
            for each in leads_to[node]:
                if each in found:
                    new = each if new is None else _common(found, number, new, each)
            if new is not None and found.get(node) != new:
                found[node] = new
                changed = True
    return found


def _common(found: dict[int, int], number: dict[int, int], one: int, other: int) -> int:
    """Return the first node that two nodes are followed by on every path."""
    while one != other:
        while number[one] > number[other]:
            one = found[one]
        while number[other] > number[one]:
            other = found[other]
    return one
