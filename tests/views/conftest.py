"""Pictures that are not written to a file."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from typing import TYPE_CHECKING

import pytest

if TYPE_CHECKING:
    from matplotlib.figure import Figure


@pytest.fixture
def figures(monkeypatch: pytest.MonkeyPatch) -> list[Figure]:
    """Return the pictures that a test draws of sweeps and notes; no files are written."""
    pytest.importorskip("matplotlib")
    from matplotlib.figure import Figure

    from motionlang.views import an00115_plot, servo_plot, sweep_plot

    drawn: list[Figure] = []

    @contextmanager
    def drawing(path: str, width: float, height: float) -> Iterator[Figure]:
        drawn.append(Figure(figsize=(width, height)))
        yield drawn[-1]

    for module in (an00115_plot, servo_plot, sweep_plot):
        monkeypatch.setattr(module, "drawing", drawing)
    return drawn
