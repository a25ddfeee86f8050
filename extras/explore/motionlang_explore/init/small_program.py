"""`motionlang init --new FILE`: a small commented program with its machine file."""

from __future__ import annotations

import os
import sys

from motionlang.cli.command import Refused, WrongOption
from motionlang.cli.complaints import unwritten
from motionlang.kernel import MACHINE_SUFFIX, Diagnostic, dialect_of
from motionlang.kernel.files import create

MINT = """\
' Axis 0 feeds a part by 200 mm and returns; output 1 opens a gripper in between.
SCALE(0) = 1000                         ' counts per mm: from here on lengths are mm
SPEED(0) = 250                          ' mm/s
ACCEL(0) = 1250 : DECEL(0) = 1250       ' mm/s²

PAUSE INX(2)                            ' start button: the machine file presses it
MOVEA(0) = 200 : GO(0)                  ' load a move to 200 mm, and start it
PAUSE IDLE(0)                           ' wait until the axis is at rest
OUTX(1) = 1 : WAIT = 100 : OUTX(1) = 0  ' open the gripper for 100 ms
MOVEA(0) = 0 : GO(0)
PAUSE IDLE(0)
PRINT "back at "; POS(0); " mm"
"""
MCCL = """\
; Axis 1 feeds a part by 200 mm and returns; channel 9 opens a gripper in between.
1US1000,1MN             ; counts per mm, motor on: from here on lengths are mm
CT9                     ; channel 9 is an output
1SV250,1SA1250,1DS1250  ; mm/s, mm/s²
WN2                     ; start button: the machine file presses it
1MA200,1WS              ; move to 200 mm, and wait until the axis is at rest
CN9,WA0.1,CF9           ; open the gripper for 100 ms
1MA0,1WS
1TP                     ; print the position
"""
MACHINE = """\
# The machine of {program}. docs/machine-file.md lists all keys.

[axis.{axis}]
travel = [-5.0, 350.0]          # mm: the limit switches

[axis.{axis}.limits]            # motionlang certify {program} compares the motion with these
speed = 300                     # mm/s
acceleration = 2000             # mm/s²

[[input]]                       # the start button, pressed after 0.5 s
channel = 2
at = 0.5
"""
TEXTS = {"mint": (MINT, 0), "mccl": (MCCL, 1)}


def write(file: str, lang: str | None) -> None:
    """Write both files and print the next steps; Refused if one exists or cannot be written."""
    if os.path.basename(file)[:1] in ("", "."):
        raise WrongOption("FILE needs a name, such as feed")
    name = file if os.path.splitext(file)[1] else file + (".mcl" if lang == "mccl" else ".mnt")
    language = dialect_of(name)
    if language is None:
        raise WrongOption(f"{name} is neither Mint (.mnt) nor MCCL (.mcl) by its extension")
    if lang not in (None, language.name):
        raise WrongOption(f"{name} is {language.title} by its extension")
    text, axis = TEXTS[language.name]
    machine = os.path.splitext(name)[0] + MACHINE_SUFFIX
    for path in (name, machine):
        if os.path.lexists(path):
            hint = f"motionlang run {path} runs it" if path == name else "take another name"
            raise Refused([Diagnostic("file", f"{path} exists, and is not overwritten", hint=hint)])
    files = {name: text, machine: MACHINE.format(program=os.path.basename(name), axis=axis)}
    for path, content in files.items():
        try:
            create(path, content.encode())
        except OSError as error:
            raise Refused([unwritten(path, error)]) from None
    sys.stdout.write(f"{name}, {machine}: written\n")
    program, picture = (
        f'"{each}"' if " " in each else each for each in (name, f"{os.path.splitext(name)[0]}.html")
    )
    for verb in (f"run {program}", f"check {program}", f"plot {program} {picture}"):
        sys.stdout.write(f"  motionlang {verb}\n")
