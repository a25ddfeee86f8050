"""Random choices for both languages: settings by keyword row, and values by unit."""

from __future__ import annotations

from functools import cache
from random import Random

from motionlang.kernel import Keyword, dialect

# Plausible values by unit: motions of some units, which last from milliseconds to seconds.
_UNITS = {
    "uu": (-60.0, 60.0),
    "uu/s": (5.0, 100.0),
    "uu/s2": (20.0, 1500.0),
    "uu/s3": (200.0, 20000.0),
    "ms": (5.0, 400.0),
    "%": (0.0, 150.0),
}
# Plausible values of settings whose unit does not suffice.
_NAMED: dict[str, tuple[float, ...]] = {
    "SCALEFACTOR": (1, 2.5, 4, 10, 100, 400),
    "POSSCALEFACTOR": (1, 2.5, 10),
    "MOVEBUFFERSIZE": (2, 4, 20, 20, 20, 20),
    "FEEDRATEOVERRIDE": (0, 10, 50, 80, 100, 120, 200),
    "CONTOURANGLE": (0, 5, 30, 60, 90, 180),
    "MASTERDISTANCE": (2, 5, 10, 20, 40),
    "CAMAMPLITUDE": (-1, 0.5, 1, 2),
    "CAMSTART": (1, 2),
    "CAMEND": (0, 2, 3),
    "SPLINESTART": (1, 2),
    "SPLINEEND": (0, 2, 3),
    "SPLINETIME": (20, 50, 100, 300),
    "FOLLOW": (-2, -1, -0.5, 0, 0.5, 1, 2, 3),
    "GEARING": (0, 50, 100, 200),
    "FOLLOWNUMERATOR": (-1, 1, 2),
    "FOLLOWDENOM": (1, 2, 3),
    "OFFSETDISTANCE": (0, 5, 20, 40),
    "MASTERCHANNEL": (0, 1, 2),
    "MASTERSOURCE": (0, 1),
    "TRIGGERMODE": (0, 1, 1, 1),
    "DRIVEENABLE": (0, 1, 1),
    "POSWRAP": (0, 10, 360),
    "BACKLASH": (0, 0.5, 2),
    "HOMEBACKOFF": (2, 5, 10),
    "SRAMP": (0, 20, 50, 100),
    "HOME": tuple(range(10)),
    "HOMETYPE": tuple(range(10)),
    "TORQUE": (0, 5, 20),
}


@cache
def table(language: str) -> dict[str, Keyword]:
    """Return the rows of a language by name."""
    return {row.name: row for row in dialect(language).table()}


@cache
def axis_settings(language: str) -> tuple[Keyword, ...]:
    """Return every simulated setting of one axis that a program may write."""
    return tuple(
        row
        for row in table(language).values()
        if row.simulated and row.kind == "setting" and "W" in row.access and row.index in ("axis", "axes")
    )


class Draw(Random):
    """A random generator with the choices that motion programs need."""

    def real(self, low: float, high: float) -> float:
        """Return a value in a range, mostly a round one, as users write them."""
        value = self.uniform(low, high)
        return round(value) if self.random() < 0.6 and high - low >= 10.0 else round(value, 3)

    def chance(self, share: float) -> bool:
        """Return True with the probability `share`."""
        return self.random() < share

    def value(self, row: Keyword) -> str:
        """Return a random value that the row accepts and that causes plausible motion."""
        if row.name in _NAMED:
            value = float(self.choice(_NAMED[row.name]))
        elif row.unit in _UNITS:
            value = self.real(*_UNITS[row.unit])
        elif row.unit in ("bool", "bits", "integer"):
            value = float(self.randrange(6))
        else:
            value = self.real(0.0, 20.0)
        low = value if row.low is None else max(float(row.low), value)
        return f"{low if row.high is None else min(float(row.high), low):.10g}"

    def pick(self, weighted: dict[str, int]) -> str:
        """Return a random key; each value is the weight of its key."""
        return self.choices(tuple(weighted), tuple(weighted.values()))[0]
