"""How the cost of a proof grows with the run: 41 and 84 arcs that are blended.

The arcs have S-ramps and follow one another every 19 ms. The figures are CPU time, the best of several
interleaved rounds. `proof_168_over_82` is the time for 168 entries of the log over that for 82: linear cost
gives 2.05.
"""

from __future__ import annotations

import gc
from time import process_time

from motionlang.execution import run
from motionlang.result import Run
from motionlang.source import Source

ROUNDS = 3
# Jerk 200000 and acceleration 1000 take the arc of 0.05 in 4 * 5 ms. The next one begins 1 ms before its end,
# when 200000 * 0.001³ / 6 is left of it.
PROGRAM = """SPEED(0) = 40 : ACCEL(0) = 1000 : DECEL(0) = 1000
PROFILEMODE(0) = 1 : ACCELJERK(0) = 200000 : DECELJERK(0) = 200000
MOVEBUFFERSIZE(0) = 100 : MOVEBUFFERSIZE(1) = 100
BLENDMODE(0) = 1 : BLENDDISTANCE(0) = 0.0000333333
{}
GO(0)
PAUSE IDLE(0)
"""


def ran(paths: int) -> Run:
    """Return a run of `paths` paths; each has two entries in the log."""
    text = PROGRAM.format("\n".join(["CIRCLER(0, 1) = 0.05, 0, 57.29578"] * paths))
    return run(Source("blends.mnt", text), cache=False, prove=True)


def main() -> None:
    """Print `name value unit` lines."""
    runs = {paths: ran(paths) for paths in (41, 84)}
    best = dict.fromkeys(runs, float("inf"))
    for _ in range(ROUNDS):
        for paths, each in runs.items():
            gc.collect()
            gc.disable()
            begun = process_time()
            proof = each.proof()
            best[paths] = min(best[paths], process_time() - begun)
            gc.enable()
            assert proof.holds, [violation.message for violation in proof.violations]
            assert proof.counts["moves"] == 2 * paths
    print(f"proof_168_entries {best[84]:.3f} s")
    print(f"proof_168_over_82 {best[84] / best[41]:.2f} x")


if __name__ == "__main__":
    main()
