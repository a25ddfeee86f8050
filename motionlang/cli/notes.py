"""`motionlang notes`: the figures of the vendors' application notes."""

from __future__ import annotations

import argparse
import sys

from motionlang.cli import profiles, servo
from motionlang.cli.parser import Commands, Parser, add_command

NOTES = {
    "tn1069": "PMC's TN1069: one move in four velocity profiles",
    "an00115": "ABB's AN00115: the formulas of a trapezoidal move",
    "chapter12": "chapter 12 of PMC's manual: figures 12.1 to 12.11",
}


def add_parser(commands: Commands, summary: str) -> None:
    """Add `motionlang notes` and a command for each note."""
    parser = add_command(commands, "notes", summary, _notes)
    assert isinstance(parser, Parser)
    parser.noun = "note"
    found: Commands = parser.add_subparsers(metavar=" | ".join(NOTES), parser_class=Parser)
    profiles.add_options(found, "tn1069", NOTES["tn1069"])
    add_command(found, "an00115", NOTES["an00115"], _an00115)
    servo.add_one(found, "figure", "chapter12", NOTES["chapter12"])


def _notes(arguments: argparse.Namespace) -> int:
    sys.stdout.writelines(f"  motionlang notes {name:<12}{what}\n" for name, what in NOTES.items())
    return 0


def _an00115(arguments: argparse.Namespace) -> int:
    """Print the formulas of the note, each with the name of its result."""
    from motionlang.notes.an00115 import FORMULAS

    lines = [f"{name.replace('_', ' '):<12}{formula}\n" for name, _, formula, _ in FORMULAS]
    sys.stdout.writelines(lines)
    sys.stdout.write("\nmotionlang plan --distance 20 --time 0.6 --rule third works out a move\n")
    return 0
