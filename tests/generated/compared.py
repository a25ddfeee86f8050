"""The command line of a family of programs that are run in two ways and compared."""

from __future__ import annotations

import argparse
import sys
from collections.abc import Callable


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
