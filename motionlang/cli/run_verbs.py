"""`profile`, `certify`, `prove`, `plot` and `trace`: `run` with that option.

Each command has the options of `run` and calls the same code.
"""

from __future__ import annotations

from motionlang.cli.options import PLOTS, TRACES
from motionlang.cli.parser import Commands, either
from motionlang.cli.run_options import add_run


def profile(commands: Commands, summary: str) -> None:
    """Add `motionlang profile`."""
    epilog = "examples:\n  motionlang profile pick.mnt\n  motionlang profile pick.mnt --all\n"
    add_run(commands, "profile", summary, epilog).set_defaults(profile=True)


def certify(commands: Commands, summary: str) -> None:
    """Add `motionlang certify`."""
    epilog = "examples:\n  motionlang certify pick.mnt\n  motionlang certify scripts/mint\n"
    parser = add_run(commands, "certify", summary, epilog, what="the program, or a folder with programs")
    parser.set_defaults(certify=True)


def prove(commands: Commands, summary: str) -> None:
    """Add `motionlang prove`."""
    epilog = "examples:\n  motionlang prove pick.mnt\n"
    add_run(commands, "prove", summary, epilog).set_defaults(prove=True)


def plot(commands: Commands, summary: str) -> None:
    """Add `motionlang plot`, whose second argument is the file to draw."""
    epilog = (
        "examples:\n  motionlang plot pick.mnt pick.html\n  motionlang plot pick.mnt path.svg --path 0,1\n"
    )
    out = ("plot", f"the file to draw: {either(PLOTS)}")
    add_run(commands, "plot", summary, epilog, out=out).set_defaults(format="none")


def trace(commands: Commands, summary: str) -> None:
    """Add `motionlang trace`, whose second argument is the file to write."""
    epilog = "examples:\n  motionlang trace pick.mnt pick.csv --rate 500 --columns position,velocity.0\n"
    out = ("trace", f"the file to write: {either(TRACES)}")
    add_run(commands, "trace", summary, epilog, out=out).set_defaults(format="none")
