"""Examples for the most frequent diagnostics.

Each is a pair: a program that gets the diagnostic, and the program without it. Each is Mint unless it begins
with a semicolon, which is a comment of MCCL. A test runs both.
"""

from __future__ import annotations

# By code: the program with the mistake, and the program after the fix.
EXAMPLES: dict[str, tuple[str, str]] = {
    "syntax": ("PAUSE IDLE(0\n", "PAUSE IDLE(0)\n"),
    "missing-end": ("If INX(1) Then\n  OUT(1) = 1\n", "If INX(1) Then\n  OUT(1) = 1\nEnd If\n"),
    "stray-end": ("OUT(1) = 1\nEnd If\n", "OUT(1) = 1\n"),
    "unknown-word": ("SPED(0) = 100\nMOVER(0) = 5 : GO(0)\n", "SPEED(0) = 100\nMOVER(0) = 5 : GO(0)\n"),
    "duplicate": ("Dim part = 1\nDim part = 2\nPRINT part\n", "Dim part = 1\npart = 2\nPRINT part\n"),
    "read-only": ("IDLE(0) = 1\n", "PAUSE IDLE(0)\n"),
    "range": ("SPEED(0) = -5\nMOVER(0) = 5 : GO(0)\n", "SPEED(0) = 5\nMOVER(0) = 5 : GO(0)\n"),
    "axis": ("SPEED(40) = 5\nMOVER(0) = 5 : GO(0)\n", "SPEED(0) = 5\nMOVER(0) = 5 : GO(0)\n"),
    "index": (
        "Dim a(3)\nDim i\ni = 9\na(i) = 1\nPRINT a(i)\n",
        "Dim a(3)\nDim i\ni = 3\na(i) = 1\nPRINT a(i)\n",
    ),
    "division-by-zero": ("Dim x\nPRINT 1 / x\n", "Dim x = 2\nPRINT 1 / x\n"),
    "zero-speed": (
        "SPEED(0) = 0\nMOVER(0) = 5 : GO(0)\n",
        "SPEED(0) = 10\nMOVER(0) = 5 : GO(0)\n",
    ),
    "never-started": ("MOVER(0) = 5\n", "MOVER(0) = 5\nGO(0)\n"),
    "in-motion": (
        "MOVER(0) = 5 : GO(0)\nPRINT POS(0)\n",
        "MOVER(0) = 5 : GO(0)\nPAUSE IDLE(0)\nPRINT POS(0)\n",
    ),
    "scale-after-speed": (
        "SPEED(0) = 250\nSCALE(0) = 1200\nMOVER(0) = 5 : GO(0)\n",
        "SCALE(0) = 1200\nSPEED(0) = 250\nMOVER(0) = 5 : GO(0)\n",
    ),
    "never": ("PAUSE INX(2)\nPRINT 1\n", "PAUSE IDLE(0)\nPRINT 1\n"),
    "endless-loop": (
        "Dim n\nWhile n < 5\n  OUT(1) = 1\nEnd While\n",
        "Dim n\nWhile n < 5\n  OUT(1) = 1\n  n = n + 1\nEnd While\n",
    ),
    "unused-variable": ("Dim part = 1\n", "Dim part = 1\nPRINT part\n"),
    "unused-setting": ("SPEED(0) = 100\n", "SPEED(0) = 100\nMOVER(0) = 5 : GO(0)\n"),
    "mixed-operators": (
        "If INX(1) = 1 & INX(2) = 1 Then PRINT 1\n",
        "If (INX(1) = 1) & (INX(2) = 1) Then PRINT 1\n",
    ),
    "motor-off": ("; MCCL\n1MR100\n", "; MCCL\n1MN,1MR100\n"),
    "nothing-to-wait-for": ("; MCCL\n1MN\n1WS\n", "; MCCL\n1MN,1MR100\n1WS\n"),
}
# By code: what to do where no program shows it.
ADVICE: dict[str, str] = {
    "never": "if a machine ends the wait, --input 2=1@0.5 or the machine file says when",
    "machine-file": "motionlang check names the line and the key; docs/machine-file.md lists all keys",
    "beyond-limit": "reduce the speed or the rate at the line that the certificate names, or correct the limit",
    "golden": "if the change is intended, motionlang verify --update FILE accepts it",
    "guess": "correct the entry in the machine file, and remove its guess = true",
    "extra": "the hint has the command that installs the library",
}
