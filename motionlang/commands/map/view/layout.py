"""A layered layout of a graph, for pictures where Graphviz is not installed.

Sugiyama's four steps, each in its simplest form:
1. Edges that lead back are turned, so that there is no cycle. Each node gets a layer below those before it.
2. An edge becomes a chain through a bend in each layer between; the bend in the middle carries the label, with its
   size, so that labels never overlap nodes.
3. Nodes of a layer are ordered by the mean place of their neighbours, in sweeps down and up.
4. Each node moves towards the median of its neighbours in the layer before, as far as those beside it allow.

Crossings of dense graphs remain, since the order is only as good as its sweeps.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from itertools import pairwise
from math import fsum
from statistics import median

from motionlang.commands.map.paths import ordered

GAP_X, GAP_Y = 24.0, 26.0
SWEEPS = 12
Size = tuple[float, float]
Place = tuple[float, float]


@dataclass(eq=False, slots=True)
class Layout:
    """The centres of nodes, and for each edge its bends in its own direction and the centre of its label."""

    width: float = 0.0
    height: float = 0.0
    nodes: dict[str, Place] = field(default_factory=dict)
    edges: list[tuple[list[Place], Place]] = field(default_factory=list)


def layout(sizes: Mapping[str, Size], edges: Sequence[tuple[str, str, Size]]) -> Layout:
    """Place nodes of given sizes; an edge has the ids of its ends and the size of its label."""
    return _Layered(sizes, edges).placed()


class _Layered:
    """The graph with its bends, in layers; a node is an integer."""

    def __init__(self, sizes: Mapping[str, Size], edges: Sequence[tuple[str, str, Size]]) -> None:
        self.names = list(sizes)
        number = {name: k for k, name in enumerate(self.names)}
        self.sizes: list[Size] = list(sizes.values())
        self.given = [(number[a], number[b], size) for a, b, size in edges]
        for a, b, (width, height) in self.given:
            if a == b:  # room for a loop and its label
                own = self.sizes[a]
                self.sizes[a] = max(own[0], sizes[self.names[a]][0] + 2 * (width + GAP_X)), own[1] + height
        self.turned = self._turned(len(self.names))
        self.layer = self._layers(len(self.names))
        # The bends of each edge from its upper end to its lower one; the middle one has the label.
        self.chains: list[list[int]] = []
        self.links: list[tuple[int, int]] = []
        for k, (a, b, size) in enumerate(self.given):
            upper, lower = (b, a) if k in self.turned else (a, b)
            self.chains.append(self._chain(upper, lower, size) if a != b else [])
        self.rows: list[list[int]] = [[] for _ in range(max(self.layer, default=0) + 1)]
        for node, row in enumerate(self.layer):
            self.rows[row].append(node)
        self.above, self.below = ([list[int]() for _ in self.sizes] for _ in range(2))
        for a, b in self.links:
            self.below[a].append(b)
            self.above[b].append(a)
        self._order()

    def _turned(self, count: int) -> set[int]:
        """Return the numbers of the edges that lead back."""
        leaving: list[list[int]] = [[] for _ in range(count)]
        for a, b, _ in self.given:
            leaving[a].append(b)
        back = set(ordered(range(count), leaving.__getitem__)[1])
        return {k for k, (a, b, _) in enumerate(self.given) if (a, b) in back}

    def _layers(self, count: int) -> list[int]:
        """Return the layers: a node is two below each node before it, because of the label between."""
        layer, changed = [0] * count, True
        while changed:
            changed = False
            for k, (a, b, _) in enumerate(self.given):
                upper, lower = (b, a) if k in self.turned else (a, b)
                if upper != lower and layer[lower] < layer[upper] + 2:
                    layer[lower], changed = layer[upper] + 2, True
        return layer

    def _chain(self, upper: int, lower: int, label: Size) -> list[int]:
        rows = range(self.layer[upper] + 1, self.layer[lower])
        chain = []
        for row in rows:
            self.sizes.append(label if row == rows[len(rows) // 2] else (6.0, 0.0))
            self.layer.append(row)
            chain.append(len(self.sizes) - 1)
        self.links += pairwise([upper, *chain, lower])
        return chain

    def _order(self) -> None:
        place = {node: k for row in self.rows for k, node in enumerate(row)}
        for sweep in range(SWEEPS):
            rows, near = (self.rows, self.above) if sweep % 2 == 0 else (self.rows[::-1], self.below)
            for row in rows:
                means = {
                    n: fsum(place[m] for m in near[n]) / len(near[n]) if near[n] else place[n] for n in row
                }
                row.sort(key=means.__getitem__)
                place.update((node, k) for k, node in enumerate(row))

    def placed(self) -> Layout:
        x = [0.0] * len(self.sizes)
        for row in self.rows:
            at = 0.0
            for node in row:
                x[node] = at + self.sizes[node][0] / 2
                at += self.sizes[node][0] + GAP_X
        for sweep in range(2 * SWEEPS):
            rows, near = (self.rows[::-1], self.below) if sweep % 2 == 0 else (self.rows, self.above)
            for row in rows:
                self._align(row, x, near)
        left = min((x[n] - self.sizes[n][0] / 2 for n in range(len(x))), default=0.0)
        heights = [max((self.sizes[n][1] for n in row), default=0.0) for row in self.rows]
        tops = [fsum(heights[:k]) + GAP_Y * k for k in range(len(heights))]
        places = [(x[n] - left, tops[self.layer[n]] + heights[self.layer[n]] / 2) for n in range(len(x))]
        found = Layout(max((places[n][0] + self.sizes[n][0] / 2 for n in range(len(x))), default=0.0),
                       tops[-1] + heights[-1] if tops else 0.0)  # fmt: skip
        found.nodes = {name: places[k] for k, name in enumerate(self.names)}
        for k, chain in enumerate(self.chains):
            bends = [places[n] for n in (reversed(chain) if k in self.turned else chain)]
            middle = chain[len(chain) // 2] if chain else self.given[k][0]
            found.edges.append((bends, places[middle]))
        return found

    def _align(self, row: list[int], x: list[float], near: list[list[int]]) -> None:
        """Move the nodes of a row towards those in the row before, without changing their order."""
        wanted = [median(x[m] for m in near[node]) if near[node] else x[node] for node in row]
        # From the left each node is at least beside the one before it; then from the right at most; the mean of both.
        right, left = list(wanted), list(wanted)
        for k in range(1, len(row)):
            right[k] = max(right[k], right[k - 1] + self._distance(row[k - 1], row[k]))
        for k in range(len(row) - 2, -1, -1):
            left[k] = min(left[k], left[k + 1] - self._distance(row[k], row[k + 1]))
        for k, node in enumerate(row):
            x[node] = (right[k] + left[k]) / 2

    def _distance(self, one: int, other: int) -> float:
        return (self.sizes[one][0] + self.sizes[other][0]) / 2 + GAP_X
