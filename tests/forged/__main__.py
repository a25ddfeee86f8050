"""`python -m tests.forged [COUNT]` lists forged planners that pass the proof and the tests of planners.

It counts those that change the motion. `--only TEXT` selects changes whose names contain the text.
"""

from __future__ import annotations

import argparse
import sys
from collections import Counter

from tests.forged.changes import changes, chosen, forged
from tests.forged.plugin import rejected_by
from tests.forged.verdicts import honest, verdict


def main(count: int, only: str) -> int:
    """Print a line per planner; return 1 if one changes the motion and passes."""
    motions = honest()
    every = [each for each in changes() if only in str(each)] if only else chosen(count)
    kinds: Counter[str] = Counter()
    passed = []
    for each in every:
        with forged(each):
            found = verdict(motions, each.function)
        kind, message = found.kind, found.message
        if kind == "passed":
            message = rejected_by(each)
            kind = "tested" if message else kind
        kinds[kind] += 1
        if kind == "passed":
            passed.append(each)
        print(f"{kind}: {each}: {found.program} {message}", flush=True)
    print(f"{len(every)} forged planners: {dict(sorted(kinds.items()))}; passed:")
    print(*passed, sep="\n")
    return 1 if passed else 0


if __name__ == "__main__":
    parser = argparse.ArgumentParser(prog="python -m tests.forged", description=__doc__)
    parser.add_argument("count", type=int, nargs="?", default=300)
    parser.add_argument("--only", metavar="TEXT", default="")
    given = parser.parse_args()
    sys.exit(main(given.count, given.only))
