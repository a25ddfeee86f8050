"""Print what the work that an exploration counts costs.

Usage: `python -m benchmarks.exploring FILE …`. For each program it prints the processor seconds of an exploration, the
seconds of its budget that it has used, and how many of the first come to one of the second. The budget is fair if the
last figure is about the same for all programs.
"""

from __future__ import annotations

import sys
from collections.abc import Sequence
from time import process_time

from motionlang.kernel import Source
from motionlang_explore.exploration import SECOND, explored


def main(files: Sequence[str]) -> None:
    """Explore some programs, and print a line for each and the spread of all."""
    ratios = []
    for file in files:
        source = Source.read(file)
        began = process_time()
        counted = explored(source).work / SECOND
        used = process_time() - began
        ratios.append(used / counted)
        print(f"{used:6.2f} s for {counted:6.2f} s counted: {ratios[-1]:5.2f}  {file}", flush=True)
    print(f"the most is {max(ratios) / min(ratios):.2f} times the least")


if __name__ == "__main__":
    main(sys.argv[1:])
