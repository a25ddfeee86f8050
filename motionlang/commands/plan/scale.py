"""Counts per user unit for `motionlang plan`: given, or from the mechanics.

The mechanics are encoder, gear and screw, or a linear scale.
"""

from __future__ import annotations

from dataclasses import dataclass
from math import isfinite
from typing import ClassVar

from motionlang.cli.command import Command, WrongOption, flag, option
from motionlang.cli.readers import integer, number

MIN_VALUE, MAX_VALUE = 1e-6, 1e12


def _ratio(text: str) -> float:
    """Parse a ratio in usual notation: 3, 3:1 or 7:2."""
    above, _, below = text.partition(":")
    try:
        return float(above) / float(below or 1)
    except (ValueError, ZeroDivisionError):
        raise ValueError(f"{text!r} is not a ratio such as 3 or 7:2") from None


@dataclass
class ScaleOptions(Command):
    """The counts per user unit."""

    title: ClassVar[str] = "scale"
    scale: float | None = option("COUNTS", "counts per user unit (1)", read=number)
    encoder_lines: float | None = option("N", "encoder lines per motor revolution", read=number)
    quadrature: int | None = option("N", "counts per encoder line: 1, 2 or 4 (4)", read=integer)
    gear: float | None = option("N[:M]", "motor revolutions per load revolution (1)", read=_ratio)
    pitch: float | None = option("X", "user units per load revolution", read=number)
    degrees: bool = flag("user units are degrees, 360 per load revolution")
    resolution: float | None = option("X", "user units per count of a linear encoder", read=number)

    def counts(self) -> tuple[float, str]:
        """Return counts per user unit and their derivation; WrongOption or ValueError if unknown."""
        of_scale = {
            "--scale": self.scale, "--encoder-lines": self.encoder_lines, "--resolution": self.resolution,
        }  # fmt: skip
        given = [name for name, value in of_scale.items() if value is not None]
        if len(given) > 1:
            raise WrongOption(f"{given[0]} and {given[1]} both set the scale")
        of_lines = {"--quadrature": self.quadrature, "--gear": self.gear, "--pitch": self.pitch}
        factors = [name for name, value in of_lines.items() if value is not None]
        if self.encoder_lines is None and (factors or self.degrees):
            raise WrongOption(f"{factors[0] if factors else '--degrees'} needs --encoder-lines")
        if self.resolution is not None:
            scale, how = linear_scale(self.resolution), f"1/{self.resolution:.10g}"
        elif self.encoder_lines is not None:
            scale, how = self._rotary(self.encoder_lines)
        else:
            scale, how = (1.0 if self.scale is None else self.scale), ""
        if not MIN_VALUE <= scale <= MAX_VALUE:
            raise WrongOption(f"--scale must be a number of counts from {MIN_VALUE:.10g} to {MAX_VALUE:.10g}")
        return scale, how

    def _rotary(self, lines: float) -> tuple[float, str]:
        per_turn = 360.0 if self.degrees else self.pitch
        if per_turn is None or (self.degrees and self.pitch is not None):
            raise WrongOption("--encoder-lines needs either --pitch or --degrees")
        gear = 1.0 if self.gear is None else self.gear
        quadrature = 4 if self.quadrature is None else self.quadrature
        factor = f" · {gear:.10g}" if gear != 1.0 else ""
        how = f"{lines:.10g} lines · {quadrature}{factor} / {per_turn:.10g}"
        return rotary_scale(lines, per_turn, gear, quadrature), how


def rotary_scale(lines: float, per_turn: float, gear: float = 1.0, quadrature: int = 4) -> float:
    """Return the counts per unit of a rotary encoder with `lines` lines.

    The motor makes `gear` revolutions for `per_turn` units.
    """
    _positive(lines=lines, per_turn=per_turn, gear=gear)
    if quadrature not in (1, 2, 4):
        raise ValueError(f"a line gives 1, 2 or 4 counts, not {quadrature}")
    return lines * quadrature * gear / per_turn


def linear_scale(resolution: float) -> float:
    """Return the counts per unit of a linear encoder with a count every `resolution`.

    Quadrature is not applied.
    """
    _positive(resolution=resolution)
    return 1.0 / resolution


def _positive(**values: float) -> None:
    for name, value in values.items():
        if not (isfinite(value) and value > 0.0):
            raise ValueError(f"{name.replace('_', ' ')} must be greater than zero")
