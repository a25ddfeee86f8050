"""What the tests of MCCL share: a text in, a run out."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from motionlang import Run, run
from motionlang.source import Source

Runner = Callable[..., Run]


@pytest.fixture
def mccl() -> Runner:
    """Run a text as an MCCL file; keyword arguments as of `motionlang.run`."""

    def start(text: str, **options: object) -> Run:
        return run(Source("test.mcl", text), dialect="mccl", **options)  # type: ignore[arg-type]

    return start


@pytest.fixture
def update(request: pytest.FixtureRequest) -> bool:
    """Whether golden files are to be written anew."""
    return bool(request.config.getoption("--update"))
