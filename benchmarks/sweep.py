"""A sweep: the cost of a variant against its bare run, a shell loop, and Dask.

Memory is measured, too. The program has 100 lines and 48 moves. All ratios are taken within one run of this
file. `--many` adds 100 000 variants, `--dask` a cluster of two processes on this machine.
"""

from __future__ import annotations

import os
import resource
import subprocess
import sys
from importlib import import_module
from pathlib import Path
from tempfile import TemporaryDirectory
from time import perf_counter, process_time
from typing import Any

from motionlang.analysis.sweeps import Sweep
from motionlang.analysis.sweeps.job import worker_of
from motionlang.execution import run
from motionlang.source import Source

ROUNDS, RUNS, LOOPS = 5, 100, 12
KEEP = ("time", "peak.0", "prints")
HEAD = ["Const rate = 500", "Const gain = 2", "SPEED(0) = 200 : ACCEL(0) = rate : DECEL(0) = rate"]
MOVES = [line for n in range(48) for line in (f"MOVER(0) = {10 + n % 7} * gain : GO(0)", "PAUSE IDLE(0)")]
PROGRAM = "\n".join([*HEAD, *MOVES, 'PRINT "done at ", TIME'])


def sweep_of(count: int) -> Sweep:
    """Return the sweep with `count` variants."""
    grid = {"rate": f"500:5000:{count // 4}", "gain": [1, 2, 3, 4]}
    return Sweep(Source("sweep.mnt", PROGRAM), grid, keep=KEEP)


def variant() -> None:
    """Compare a variant with a bare run of the same compiled program and values."""
    sweep = sweep_of(1000)
    worker = worker_of(sweep.job)
    variants = [(n, sweep.space[n]) for n in range(0, 1000, 1000 // RUNS)]
    overrides = [{"rate": float(rate), "gain": float(gain)} for _, (rate, gain) in variants]  # type: ignore[arg-type]
    program = worker._program(worker.source, {}, overrides[0])  # type: ignore[arg-type]
    bare = with_sweep = float("inf")
    for _ in range(ROUNDS):
        began = process_time()
        for values in overrides:
            run(worker.source, dialect="mint", machine={}, overrides=values, cache=False, compiled=program)
        bare = min(bare, process_time() - began)
        began = process_time()
        for each in variants:
            worker.result(each)
        with_sweep = min(with_sweep, process_time() - began)
    print(f"sweep_bare_run {bare / len(variants) * 1e3:.3f} ms")
    print(f"sweep_variant {with_sweep / len(variants) * 1e3:.3f} ms")
    print(f"sweep_variant_by_bare_run {with_sweep / bare:.2f} x")


def thousand() -> None:
    """Compare a thousand variants on two workers with a shell loop of processes."""
    best = float("inf")
    for _ in range(ROUNDS):
        began = perf_counter()
        assert len(list(sweep_of(1000).results(jobs=2))) == 1000
        best = min(best, perf_counter() - began)
    with TemporaryDirectory() as folder:
        program = Path(folder) / "sweep.mnt"
        program.write_text(PROGRAM)
        command = [sys.executable, "-m", "motionlang", "run", str(program), "--format", "json", "--set"]
        began = perf_counter()
        for n in range(LOOPS):
            subprocess.run([*command, f"rate={500 + n}"], check=True, capture_output=True)
        loop = (perf_counter() - began) / LOOPS
    print(f"sweep_thousand {best:.2f} s")
    print(f"sweep_shell_loop_of_thousand {loop * 1000:.1f} s")
    print(f"sweep_faster_than_shell {loop * 1000 / best:.0f} x")


def many(count: int) -> None:
    """Measure the memory per variant; only a row of each is stored."""
    list(sweep_of(1000).results(jobs=2))
    before = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
    rows = list(sweep_of(count).results(jobs=2))
    grown = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss - before
    print(f"sweep_memory_of_{len(rows)} {grown / 1024:.1f} MB")
    print(f"sweep_worker_memory {resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss / 1024:.0f} MB")


def dask() -> None:
    """Measure the overhead of Dask against the local pool, both with two processes."""
    import logging

    distributed: Any = import_module("dask.distributed")
    logging.disable(logging.CRITICAL)
    os.environ["PYTHONPATH"] = str(Path(__file__).parent.parent)
    count, best = 4000, {"pool": float("inf"), "dask": float("inf")}
    cluster = distributed.LocalCluster(n_workers=2, threads_per_worker=1, dashboard_address=None)
    with cluster, distributed.Client(cluster) as client:
        for _ in range(3):
            for name, executor in (("pool", None), ("dask", client.get_executor())):
                began = perf_counter()
                assert len(list(sweep_of(count).results(executor, 2))) == count
                best[name] = min(best[name], perf_counter() - began)
    print(f"sweep_dask_overhead {(best['dask'] - best['pool']) / count * 2e6:.0f} us/variant")
    print(f"sweep_dask_by_pool {best['dask'] / best['pool']:.2f} x")


def main() -> None:
    """Print `name value unit` lines; the best of some rounds."""
    variant()
    thousand()
    many(100_000 if "--many" in sys.argv else 4_000)
    if "--dask" in sys.argv:
        dask()


if __name__ == "__main__":
    main()
