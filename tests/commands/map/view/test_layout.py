"""The layout of a diagram: nodes, and labels of transitions."""

from __future__ import annotations

from motionlang.commands.map.view.layout import layout


def test_the_layout_has_no_overlapping_nodes_or_labels() -> None:
    """Boxes of a layer are beside each other, and layers are below each other."""
    sizes = {f"n{k}": (60.0 + 7 * (k % 5), 20.0 + 3 * (k % 4)) for k in range(20)}
    edges = [(f"n{k}", f"n{(k * 7 + 3) % 20}", (30.0, 12.0)) for k in range(20)]
    edges += [(f"n{k}", f"n{k + 1}", (44.0, 24.0)) for k in range(19)]
    placed = layout(sizes, edges)
    boxes = [(*placed.nodes[name], *size) for name, size in sizes.items()]
    boxes += [(*place, *size) for (a, b, size), (_, place) in zip(edges, placed.edges, strict=True) if a != b]
    for k, (x, y, width, height) in enumerate(boxes):
        for other_x, other_y, other_width, other_height in boxes[:k]:
            beside = abs(x - other_x) >= (width + other_width) / 2 - 1e-6
            below = abs(y - other_y) >= (height + other_height) / 2 - 1e-6
            assert beside or below
        assert x - width / 2 + 1e-6 >= 0
        assert x + width / 2 <= placed.width + 1e-6
