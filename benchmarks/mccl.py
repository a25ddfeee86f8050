"""Speed of MCCL: commands per second, polling for a shift, round trips of a host.

Prints `name value unit`.
"""

from __future__ import annotations

import gc
from os import environ
from time import process_time

from motionlang.execution import run
from motionlang.lang.machine.machine import Machine
from motionlang.mccl.hosts.console import Console
from motionlang.source import Source

SHIFT = 8 * 3600.0
# The best of two is enough for a figure that may miss its bar by a factor of two.
ROUNDS = 2 if environ.get("BENCHMARKS_HALFWAY") else 5


def commands() -> float:
    """Return commands per second, from the text of a file to the end of its run.

    In half of the commands the text occurs only once.
    """
    lines = [f"AL{k},AA2,AM3,AR10,IG{k},NO,NO,1SV{k % 9000 + 1},2SA5000,TR10" for k in range(4000)]
    text = "\n".join(lines)
    count = sum(line.count(",") + 1 for line in lines)
    best = float("inf")
    for _ in range(ROUNDS):
        begin = process_time()
        run(Source("commands.mcl", text), dialect="mccl", cache=False)
        best = min(best, process_time() - begin)
    return count / best


def looping() -> float:
    """Return commands per second in a macro that loops and counts."""
    text = "MD1,RA10,AA1,AR10,IB30000,MJ1,NO\nAL0,AR10,MC1"
    best = float("inf")
    for _ in range(ROUNDS):
        begin = process_time()
        run(Source("loop.mcl", text), dialect="mccl", cache=False)
        best = min(best, process_time() - begin)
    return 30000 * 5 / best


def polling() -> float:
    """Return the CPU seconds of a macro that polls the status word for a shift.

    The shift has eight machine hours; another task moves an axis meanwhile.
    """
    text = 'MD1,1MR1000,1WS4,RP7000\nMD2,1LU"STATUS",1RL@0,IC25,JR-3,NO\n1MN\nGT1\nMC2'
    begin = process_time()
    result = run(Source("poll.mcl", text), dialect="mccl", until=SHIFT, cache=False)
    spent = process_time() - begin
    assert result.time >= SHIFT
    return spent


def round_trips() -> float:
    """Return requests per second of one host, in process: text and machine time."""
    console = Console(Machine(first_axis=1))
    port = console.open(echo=False)
    port.take()
    best = float("inf")
    for _ in range(ROUNDS):
        begin = process_time()
        for _ in range(5000):
            port.feed(b"1TP\r")
            console.settle()
            assert port.take()
        best = min(best, process_time() - begin)
    return 5000 / best


def main() -> None:
    gc.collect()
    print(f"mccl_commands {commands():.0f} 1/s")
    print(f"mccl_macro_loop {looping():.0f} 1/s")
    print(f"mccl_poll_8_hours {polling():.3f} s")
    print(f"mccl_round_trips {round_trips():.0f} 1/s")


if __name__ == "__main__":
    main()
