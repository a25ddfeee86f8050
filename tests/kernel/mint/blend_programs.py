"""Random Mint programs with blended paths that are changed and ended in every way.

Each program is from a seed.
"""

from __future__ import annotations

import random

ENDS = (
    "",
    "SUSPEND(0) = 0 : FEEDRATEOVERRIDE(0) = 100 : PAUSE IDLE(0)",
    "STOP(0) : PAUSE IDLE(0)",
    "STOP(1) : WAIT 20 : CANCEL(0)",
    "CANCEL(1)",
    "DRIVEENABLE(1) = 0",
    "ABORT",
    "PRINT 1 / (POS(0) - POS(0))",
    "SUSPEND(0) = 1 : WAIT 3000",
    "SUSPEND(0) = 1 : WAIT 100 : STOP(0)",
    "STOP(0) : WAIT 30 : BLEND(0) : WAIT 2000",
    "ERRORDECEL(0) = 600 : SOFTLIMITFORWARD(0) = POS(0) + 0.5 : WAIT 3000",
    "SOFTLIMITMODE(1) = 2 : SOFTLIMITFORWARD(1) = POS(1) + 0.2 : WAIT 3000",
)


class _Choices(random.Random):
    """Random numbers with two decimals."""

    def real(self, low: float, high: float) -> float:
        return round(self.uniform(low, high), 2)

    def one_in(self, count: int) -> bool:
        return self.randrange(count) == 0


def program(seed: int) -> str:
    """Return a program of two to five blended lines and arcs of axes 0 and 1.

    Up to five changes happen in motion, and the program ends the paths in a random way.
    """
    r = _Choices(seed)
    lines = ["MOVEBUFFERSIZE(0) = 20 : MOVEBUFFERSIZE(1) = 20", *_settings(r)]
    lines += [_path(r) for _ in range(r.randrange(2, 6))]
    lines.append("GO(0)")
    for _ in range(r.randrange(1, 6)):
        lines += [f"WAIT {r.randrange(5, 400)}", _change(r)]
    lines += [f"WAIT {r.randrange(5, 200)}", r.choice(ENDS)]
    return "\n".join(lines) + "\n"


def _settings(r: _Choices) -> list[str]:
    found = [f"SPEED(0) = {r.real(5, 60)} : ACCEL(0) = {r.real(20, 500)} : DECEL(0) = {r.real(20, 500)}"]
    if r.one_in(3):
        found.append(
            f"PROFILEMODE(0) = 1 : ACCELJERK(0) = {r.real(200, 8000)} : DECELJERK(0) = {r.real(200, 8000)}"
        )
    found.append(f"FEEDRATEMODE(0) = {r.choice((0, 2))}")
    for axis in (0, 1):
        if r.one_in(5):
            found.append(f"SCALEFACTOR({axis}) = {r.choice((10, 100, 2.5))}")
        for word, low, high in (("MAXSPEED", 5, 60), ("MAXACCEL", 20, 300), ("MAXDECEL", 20, 300)):
            if r.one_in(7):
                found.append(f"{word}({axis}) = {r.real(low, high)}")
    if not r.one_in(3):
        found.append(f"BLENDMODE(0) = 1 : BLENDDISTANCE(0) = {r.real(0.1, r.choice((2, 30)))}")
    return found


def _path(r: _Choices) -> str:
    if r.one_in(3):
        angle = r.choice((-1, 1)) * r.real(10, 400)
        return f"CIRCLE{r.choice('RA')}(0, 1) = {r.real(-20, 20)}, {r.real(1, 20)}, {angle}"
    size = r.choice((0.5, 5, 40))
    return f"VECTOR{r.choice('RRA')}(0, 1) = {r.real(-size, size)}, {r.real(-size, size)}"


def _change(r: _Choices) -> str:
    return r.choice(
        (
            "BLEND(0)",
            "BLEND(0)",
            "BLEND(0)",
            "SUSPEND(0) = 1",
            "SUSPEND(0) = 0",
            f"FEEDRATEOVERRIDE(0) = {r.choice((0, 10, 50, 100, 150))}",
            f"SPEED(0) = {r.real(5, 60)}",
            f"MAXSPEED({r.randrange(2)}) = {r.real(3, 60)}",
            f"ACCEL(0) = {r.real(20, 500)}",
            f"DECEL(0) = {r.real(20, 500)}",
            f"BLENDDISTANCE(0) = {r.real(0.1, 30)}",
            f"FEEDRATEMODE(0) = {r.choice((0, 2))}",
            f"{_path(r)} : GO(0)",
        )
    )
