"""What families of programs share that are run with identical iterations skipped and with none skipped."""

from __future__ import annotations

import argparse
import sys
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from typing import Any

from motionlang.kernel.lang.loops import Loops


@contextmanager
def _fitting(replacement: Callable[..., Any]) -> Iterator[None]:
    found = Loops._fitting
    Loops._fitting = replacement  # type: ignore[method-assign]
    try:
        yield
    finally:
        Loops._fitting = found  # type: ignore[method-assign]


def every_iteration() -> Any:
    """Return a context in which every iteration of a loop is carried out."""
    return _fitting(lambda loops, now, last, until, most: (0, now.base))


def counting_skips(skips: list[int]) -> Any:
    """Return a context that appends to a list how many iterations are skipped at a time."""
    fitting = Loops._fitting

    def counted(*given: Any) -> Any:
        found = fitting(*given)
        if found[0]:
            skips.append(found[0])
        return found

    return _fitting(counted)


def is_equal_without_skipping(shown: Callable[[], str]) -> bool:
    """True if a run shows the same with iterations skipped and with none skipped."""
    skipped = shown()
    with every_iteration():
        return shown() == skipped


def compare(family: str, is_equal: Callable[[int], bool], count: int = 3000) -> int:
    """Compare the programs that the command line asks for; return 1 if one differs."""
    parser = argparse.ArgumentParser(prog=f"tests.generated.{family}")
    parser.add_argument("count", nargs="?", type=int, default=count)
    parser.add_argument("--seed", type=int, default=1)
    given = parser.parse_args(sys.argv[1:])
    different = [seed for seed in range(given.seed, given.seed + given.count) if not is_equal(seed)]
    print(*(f"seed {seed} differs" for seed in different), sep="\n", end="\n" if different else "")
    print(f"{given.count} programs from seed {given.seed}: {len(different)} differ")
    return 1 if different else 0
