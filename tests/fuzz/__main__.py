"""`python -m tests.fuzz mint 1000000 [SEED]` runs a million inputs.

A count of 0 runs every keyword. Each kind of failure is printed once.
"""

from __future__ import annotations

import sys
from time import monotonic

from tests.fuzz.guard import trouble
from tests.fuzz.inputs import WORDS, inputs


def main(name: str, count: int, seed: int) -> int:
    """Run the inputs; return 1 if one of them fails."""
    seen: dict[str, str] = {}
    begun, done = monotonic(), 0
    for text in WORDS[name]() if count == 0 else inputs(name, count, seed):
        finding = trouble(name, text)
        done += 1
        kind = finding.partition(" at ")[2] or finding
        if finding and len(text) < len(seen.get(kind, text + " ")):
            if kind not in seen:
                print(f"{done}: {finding}\n---\n{text}\n---", flush=True)
            seen[kind] = text
    print(
        f"{name}: {done} inputs, seed {seed}: {len(seen)} kinds of trouble, {monotonic() - begun:.0f} s",
        flush=True,
    )
    return 1 if seen else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1], int(sys.argv[2]), int(sys.argv[3]) if len(sys.argv) > 3 else 0))
