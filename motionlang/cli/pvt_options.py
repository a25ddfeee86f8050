"""The options of `motionlang pvt`, and the parsing of their values."""

from __future__ import annotations

import argparse
from collections.abc import Callable

from motionlang.cli.format_options import add_format
from motionlang.cli.numbers import real, whole
from motionlang.cli.options import REPORTS
from motionlang.cli.parser import add_all, flag, option
from motionlang.planners.pvt.velocities import METHODS


def _numbers(text: str) -> list[float]:
    """Parse numbers with commas between them.

    `check_points` validates them and reports the index.
    """
    try:
        return [float(item) for item in text.split(",")]
    except ValueError:
        raise _refused(text, "numbers with commas between them") from None


_POSITIVE = real("a number greater than zero", 0.0, 1e300, above=True)
_NUMBER = real("a number from -1e300 to 1e300", -1e300, 1e300)
_COUNT = whole("a whole number from 1 to 1000", 1, 1000)
_NODE = whole("a node from 1 to 127", 1, 127)


def _times(text: str) -> list[float]:
    return [_POSITIVE(item) for item in text.split(",")]


def _counts(text: str) -> list[int]:
    return [_COUNT(item) for item in text.split(",")]


def _picture(text: str) -> str:
    if not text.lower().endswith((".png", ".svg")):
        raise _refused(text, "a .png or an .svg file")
    return text


def _refused(text: str, wanted: str) -> Exception:
    return argparse.ArgumentTypeError(f"{text!r} is not {wanted}")


# The source of points: a file, positions, an S-curve or a program.
INPUT = (
    option("file", "FILE", "points (.csv: position, velocity, time), or a program whose motion is to be fitted",
           nargs="?"),
    option("--positions", "P,P,…", "points in counts, instead of a file", _numbers),
    option("--time", "MS[,MS…]", "time between points, ms: one for all, or one for each segment", _times),
    option("--scurve", "COUNTS", "an S-curve of this distance, counts, instead of a file", _NUMBER),
    option("--jerk", "J", "jerk of the S-curve, counts/s³ (or --time for its four segments)", _POSITIVE),
    option("--accel", "A", "acceleration limit of the S-curve, counts/s²", _POSITIVE),
    option("--speed", "V", "velocity limit of the S-curve, counts/s", _POSITIVE),
    option("--velocities", None, "how to choose the velocities", choices=["given", *METHODS]),
    option("--sweeps", "N", "passes over the points by refine", _COUNT),
    flag("--linear", "omit the velocities and interpolate linearly"),
    option("--start", "COUNTS", "position of the motor before the move", _NUMBER),
    option("--axis", "N", "the axis of the program to fit", int),
    option("--tolerance", "COUNTS", "the tolerance of the fit to a program", _POSITIVE),
    option("--dialect --lang", None, "the language of the program", choices=["mint", "mccl"]),
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
    parser.add_argument("--node", type=_NODE, default=1, metavar="ID", help="CANopen node of the drive (1)")
    parser.add_argument("-o", "--output", metavar="FILE", help="write to a file instead of standard output")


_STREAM = (
    option("--transfer", None, "how to send the points: by PDO or SDO to object 0x2010, or in a sub-mode",
           default="pdo", choices=["pdo", "sdo", "0", "-1", "-2", "-3"]),
    option("--node", "ID", "CANopen node of the drive (1)", _NODE, default=1),
    option("--poll-interval", "MS", "polling interval of the master, ms (1; with --transfer 0, the time between "
           "points)", _POSITIVE),
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
