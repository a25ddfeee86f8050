"""The options of `motionlang pvt`, and the parsing of their values."""

from __future__ import annotations

import argparse
from collections.abc import Callable
from typing import TypeVar

from motionlang.cli.format_options import add_format
from motionlang.cli.options import REPORTS
from motionlang.cli.parser import add_all, flag, option
from motionlang.planners.pvt.velocities import METHODS

_N = TypeVar("_N", int, float)


def _numbers(text: str) -> list[float]:
    """Parse comma-separated numbers; `points` validates them and reports the index."""
    try:
        return [float(item) for item in text.split(",")]
    except ValueError:
        raise _refused(text, "numbers with commas between them") from None


def _number(text: str) -> float:
    return _between(text, float, -1e300, 1e300)


def _positive(text: str) -> float:
    return _between(text, float, 1e-9, 1e300)


def _picture(text: str) -> str:
    if not text.lower().endswith((".png", ".svg")):
        raise _refused(text, "a .png or an .svg file")
    return text


def _counts(text: str) -> list[int]:
    return [_count(item) for item in text.split(",")]


def _count(text: str) -> int:
    return _between(text, int, 1, 1000)


def _node(text: str) -> int:
    return _between(text, int, 1, 127)


def _between(text: str, kind: Callable[[str], _N], least: _N, most: _N) -> _N:
    try:
        value = kind(text)
    except ValueError:
        raise _refused(text, "a number") from None
    if not least <= value <= most:
        raise _refused(text, f"from {least:g} to {most:g}")
    return value


def _refused(text: str, wanted: str) -> Exception:
    return argparse.ArgumentTypeError(f"{text!r} is not {wanted}")


# The source of points: a file, positions, an S-curve or a program.
INPUT = (
    option("file", "FILE", "points (.csv: position, velocity, time), or a program whose motion is to be fitted",
           nargs="?"),
    option("--positions", "P,P,…", "points in counts, instead of a file", _numbers),
    option("--time", "MS[,MS…]", "time between points, ms: one for all, or one for each segment", _numbers),
    option("--scurve", "COUNTS", "an S-curve of this distance, counts, instead of a file", _number),
    option("--jerk", "J", "jerk of the S-curve, counts/s³ (or --time for its four segments)", _positive),
    option("--accel", "A", "acceleration limit of the S-curve, counts/s²", _positive),
    option("--speed", "V", "velocity limit of the S-curve, counts/s", _positive),
    option("--velocities", None, "how to choose the velocities", choices=["given", *METHODS]),
    option("--sweeps", "N", "passes over the points by refine", _count),
    flag("--linear", "omit the velocities and interpolate linearly"),
    option("--start", "COUNTS", "position of the motor before the move", _number),
    option("--axis", "N", "the axis of the program to fit", int),
    option("--tolerance", "COUNTS", "the tolerance of the fit to a program", _positive),
    option("--dialect", None, "the language of the program", choices=["mint", "mccl"]),
    option("--plot", "OUT", "draw the motion with its knots into a .png or .svg file", _picture),
)  # fmt: skip


_REFINE = (
    option("--compare", "N,N…", "show the result after these numbers of passes", _counts, default=[1, 2]),
    option("-o --output", "FILE", "write the points with their velocities as CSV"),
)  # fmt: skip


def _add_refine(parser: argparse.ArgumentParser) -> None:
    add_format(parser, REPORTS, has_output=True)
    add_all(parser, _REFINE)


def _add_export(parser: argparse.ArgumentParser) -> None:
    formats = ["csv", "serial", "pdo", "sdo", "record"]
    parser.add_argument("--format", choices=formats, default="csv", help="the output format (csv)")
    parser.add_argument("--relative", action="store_true", help="write distances instead of positions")
    parser.add_argument("--node", type=_node, default=1, metavar="ID", help="CANopen node of the drive (1)")
    parser.add_argument("-o", "--output", metavar="FILE", help="write to a file instead of standard output")


_STREAM = (
    option("--transfer", None, "how to send the points: by PDO or SDO to object 0x2010, or in a sub-mode",
           default="pdo", choices=["pdo", "sdo", "0", "-1", "-2", "-3"]),
    option("--node", "ID", "CANopen node of the drive (1)", _node, default=1),
    option("--poll-interval", "MS", "polling interval of the master, ms (1; with --transfer 0, the time between "
           "points)", _positive),
    flag("--relative", "send distances instead of positions"),
    option("--interface", "NAME", "python-can interface (virtual)", default="virtual"),
    option("--channel", "NAME", "channel of the interface, such as vcan0", default=""),
    flag("--real", "stream to a real drive on the bus and move it; simulate none"),
)  # fmt: skip


def _add_stream(parser: argparse.ArgumentParser) -> None:
    _add_report(parser)
    add_all(parser, _STREAM)


def _add_report(parser: argparse.ArgumentParser) -> None:
    add_format(parser, REPORTS)


OPTIONS: dict[str, Callable[[argparse.ArgumentParser], None]] = {
    "plot": _add_report,
    "refine": _add_refine,
    "export": _add_export,
    "stream": _add_stream,
}
