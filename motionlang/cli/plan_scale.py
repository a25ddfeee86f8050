"""Counts per user unit for `motionlang plan`: given, or from the mechanics.

The mechanics are encoder, gear and screw, or a linear scale.
"""

from __future__ import annotations

import argparse

from motionlang.cli.parser import add_all, flag, option
from motionlang.planners.counts import linear_scale, rotary_scale

MIN_VALUE, MAX_VALUE = 1e-6, 1e12


def _ratio(text: str) -> float:
    """Parse a ratio in usual notation: 3, 3:1 or 7:2."""
    above, _, below = text.partition(":")
    try:
        return float(above) / float(below or 1)
    except ZeroDivisionError:
        raise ValueError(text) from None


_ARGUMENTS = (
    option("--scale", "COUNTS", "counts per user unit (1)", float),
    option("--encoder-lines", "N", "encoder lines per motor revolution, to compute the scale", float),
    option("--quadrature", "N", "counts per encoder line: 1, 2 or 4 (4)", int),
    option("--gear", "N[:M]", "motor revolutions per load revolution (1)", _ratio),
    option("--pitch", "X", "user units per load revolution", float),
    flag("--degrees", "user units are degrees, 360 per load revolution"),
    option("--resolution", "X", "user units per count of a linear encoder", float),
)  # fmt: skip


def add_scale_arguments(parser: argparse.ArgumentParser) -> None:
    """Add the options for the counts per user unit."""
    add_all(parser, _ARGUMENTS)


def scale_of(arguments: argparse.Namespace) -> tuple[float, str]:
    """Return counts per user unit and their derivation; ValueError if unknown."""
    lines, resolution = arguments.encoder_lines, arguments.resolution
    options = [
        name for name in ("scale", "encoder_lines", "resolution") if getattr(arguments, name) is not None
    ]
    if len(options) > 1:
        one, other = (f"--{name.replace('_', '-')}" for name in options[:2])
        raise ValueError(f"{one} and {other} both set the scale")
    factors = [name for name in ("quadrature", "gear", "pitch") if getattr(arguments, name) is not None]
    if lines is None and (factors or arguments.degrees):
        raise ValueError(f"--{factors[0] if factors else 'degrees'} needs --encoder-lines")
    if resolution is not None:
        scale, how = linear_scale(resolution), f"1/{resolution:.10g}"
    elif lines is not None:
        scale, how = _rotary(arguments)
    else:
        scale, how = (1.0 if arguments.scale is None else arguments.scale), ""
    if not MIN_VALUE <= scale <= MAX_VALUE:
        raise ValueError(f"--scale must be a number of counts from {MIN_VALUE:.10g} to {MAX_VALUE:.10g}")
    return scale, how


def _rotary(arguments: argparse.Namespace) -> tuple[float, str]:
    if arguments.degrees == (arguments.pitch is not None):
        raise ValueError("--encoder-lines needs either --pitch or --degrees")
    lines, gear = arguments.encoder_lines, 1.0 if arguments.gear is None else arguments.gear
    quadrature = 4 if arguments.quadrature is None else arguments.quadrature
    per_turn = 360.0 if arguments.degrees else arguments.pitch
    how = (
        f"{lines:.10g} lines · {quadrature}"
        + (f" · {gear:.10g}" if gear != 1.0 else "")
        + f" / {per_turn:.10g}"
    )
    return rotary_scale(lines, per_turn, gear, quadrature), how
