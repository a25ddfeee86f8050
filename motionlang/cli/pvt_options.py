"""The options of `motionlang pvt`, and the parsing of their values."""

from __future__ import annotations

import argparse
from collections.abc import Callable
from typing import TypeVar

from motionlang.cli.format_options import add_format
from motionlang.cli.options import REPORTS
from motionlang.planners.pvt.velocities import METHODS

_N = TypeVar("_N", int, float)


def add_input(parser: argparse.ArgumentParser) -> None:
    """Add the options for the source of points: a file, positions, S-curve or program."""
    add = parser.add_argument
    add(
        "file",
        metavar="FILE",
        nargs="?",
        help="points (.csv: position, velocity, time), or a program whose motion is to be fitted",
    )
    add("--positions", type=_numbers, metavar="P,P,…", help="points in counts, instead of a file")
    add(
        "--time",
        type=_numbers,
        metavar="MS[,MS…]",
        help="time between points, ms: one for all, or one for each segment",
    )
    add(
        "--scurve",
        type=_number,
        metavar="COUNTS",
        help="an S-curve of this distance, counts, instead of a file",
    )
    add(
        "--jerk",
        type=_positive,
        metavar="J",
        help="jerk of the S-curve, counts/s³ (or --time for its four segments)",
    )
    add("--accel", type=_positive, metavar="A", help="acceleration limit of the S-curve, counts/s²")
    add("--speed", type=_positive, metavar="V", help="velocity limit of the S-curve, counts/s")
    add("--velocities", choices=["given", *METHODS], help="how to choose the velocities")
    add("--sweeps", type=_count, metavar="N", help="passes over the points by refine")
    add("--linear", action="store_true", help="omit the velocities and interpolate linearly")
    add("--start", type=_number, metavar="COUNTS", help="position of the motor before the move")
    add("--axis", type=int, metavar="N", help="the axis of the program to fit")
    add(
        "--tolerance",
        type=_positive,
        metavar="COUNTS",
        help="the tolerance of the fit to a program",
    )
    add("--dialect", choices=["mint", "mccl"], help="the language of the program")
    add(
        "--plot", type=_picture, metavar="OUT", help="draw the motion with its knots into a .png or .svg file"
    )


def _add_plot(parser: argparse.ArgumentParser) -> None:
    _add_report(parser)


def _add_refine(parser: argparse.ArgumentParser) -> None:
    add_format(parser, REPORTS, has_output=True)
    parser.add_argument(
        "--compare",
        type=_counts,
        default=[1, 2],
        metavar="N,N…",
        help="show the result after these numbers of passes",
    )
    parser.add_argument(
        "-o", "--output", metavar="FILE", help="write the points with their velocities as CSV"
    )


def _add_export(parser: argparse.ArgumentParser) -> None:
    formats = ["csv", "serial", "pdo", "sdo", "record"]
    parser.add_argument("--format", choices=formats, default="csv", help="the output format (csv)")
    parser.add_argument("--relative", action="store_true", help="write distances instead of positions")
    parser.add_argument("--node", type=_node, default=1, metavar="ID", help="CANopen node of the drive (1)")
    parser.add_argument("-o", "--output", metavar="FILE", help="write to a file instead of standard output")


def _add_stream(parser: argparse.ArgumentParser) -> None:
    add = parser.add_argument
    _add_report(parser)
    add(
        "--transfer",
        default="pdo",
        choices=["pdo", "sdo", "0", "-1", "-2", "-3"],
        help="how to send the points: by PDO or SDO to object 0x2010, or in a sub-mode",
    )
    add("--node", type=_node, default=1, metavar="ID", help="CANopen node of the drive (1)")
    add(
        "--poll-interval",
        type=_positive,
        metavar="MS",
        help="polling interval of the master, ms (1; with --transfer 0, the time between points)",
    )
    add("--relative", action="store_true", help="send distances instead of positions")
    add("--interface", default="virtual", metavar="NAME", help="python-can interface (virtual)")
    add("--channel", default="", metavar="NAME", help="channel of the interface, such as vcan0")
    add("--real", action="store_true", help="stream to a real drive on the bus and move it; simulate none")


def _add_report(parser: argparse.ArgumentParser) -> None:
    add_format(parser, REPORTS)


OPTIONS: dict[str, Callable[[argparse.ArgumentParser], None]] = {
    "plot": _add_plot,
    "refine": _add_refine,
    "export": _add_export,
    "stream": _add_stream,
}


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
    from argparse import ArgumentTypeError

    return ArgumentTypeError(f"{text!r} is not {wanted}")
