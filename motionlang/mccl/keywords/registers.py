"""Registers, the accumulator (register 0) and the controller's variables."""

from __future__ import annotations

from motionlang.mccl.keywords.row import Group

_G = Group("registers")
_row, _known = _G.row, _G.known


ROWS = (
    _row("AL", "command", "W", "none", "number", "load", "Load the accumulator.", "AL5,TR0"),
    _row("AR", "command", "W", "none", "number", "store", "Copy the accumulator to register n.", "AL5,AR10,TR10",
         low=0, high=255),
    _row("RA", "command", "W", "none", "number", "recall", "Copy register n to the accumulator.", "RA10,TR0",
         low=0, high=255),
    _row("AA", "command", "W", "none", "number", "add", "Add to the accumulator.", "AL5,AA3,TR0"),
    _row("AS", "command", "W", "none", "number", "subtract", "Subtract from the accumulator.", "AL5,AS3,TR0"),
    _row("AM", "command", "W", "none", "number", "multiply", "Multiply the accumulator.", "AL246,AM2,TR0"),
    _row("AD", "command", "W", "none", "number", "divide",
         "Divide the accumulator; whole numbers give a whole number.",
         "AL7,AD2,TR0"),
    _row("AN", "command", "W", "none", "bits", "bit_and", "Bitwise and with the accumulator.", "AL12,AN10,TR0"),
    _row("AO", "command", "W", "none", "bits", "bit_or", "Bitwise or with the accumulator.", "AL12,AO10,TR0"),
    _row("AX", "command", "W", "none", "bits", "bit_xor", "Bitwise exclusive or with the accumulator.",
         "AL12,AX10,TR0"),
    _row("AE", "command", "W", "none", "bits", "bit_xor",
         "The same as AX; which of the two names is right is not known.", "AL12,AE10,TR0"),
    _row("AC", "command", "C", "none", "bits", "bit_not", "Complement the accumulator.", "AL5,AC,TR0"),
    _row("SL", "command", "W", "none", "number", "shift_left", "Shift the accumulator left by n bits.", "AL1,SL4,TR0",
         low=0, high=31),
    _row("SR", "command", "W", "none", "number", "shift_right",
         "Shift the accumulator right by n bits; the sign bit stays.", "AL16,SR4,TR0", low=0, high=31),
    _row("AV", "command", "W", "none", "number", "evaluate",
         "Evaluate a function of the accumulator: 0 change of sign, 1 absolute value, 2 sine, 3 cosine, 4 tangent, "
         "5 arc sine, 6 arc cosine, 7 arc tangent (all in degrees), 8 square root, 9 power of e, 10 natural "
         "logarithm, 11 whole part, 12 as a real number. The numbers are ours.", "AL30,AV2,TR0", low=0, high=12),
    _row("LU", "command", "W", "none", "text", "look_up",
         "Look a variable of the controller up by name; its address comes into the accumulator.",
         'LU"STATUS",1RL@0,TR0'),
    _row("RB", "reading", "W", "axis", "number", "read_byte", "Read the low byte of a variable into the accumulator.",
         'LU"STATUS",1RB@0'),
    _row("RW", "reading", "W", "axis", "number", "read_word", "Read the low word of a variable into the accumulator.",
         'LU"STATUS",1RW@0'),
    _row("RL", "reading", "W", "axis", "number", "read_long",
         "Read a variable as a whole number into the accumulator.",
         'LU"STATUS",1RL@0', solved=True),
    _row("RV", "reading", "W", "axis", "number", "read_float",
         "Read a variable as a real number into the accumulator.",
         'LU"POSITION",1RV@0', solved=True),
    _row("RD", "reading", "W", "axis", "number", "read_double",
         "Read a variable as a double into the accumulator.", 'LU"POSITION",1RD@0', solved=True),
    _row("WB", "command", "W", "axis", "number", "write_byte",
         "Write the low byte of the accumulator into that of a variable.",
         'LU"DEADBAND",AR10,AL5,1WB@10'),
    _row("WW", "command", "W", "axis", "number", "write_word",
         "Write the low word of the accumulator into that of a variable.", 'LU"SPEED",AR10,AL5000,1WW@10'),
    _row("WL", "command", "W", "axis", "number", "write_long", "Write the accumulator as a whole number to a variable.",
         'LU"SPEED",AR10,AL5000,1WL@10,1RL@10,TR0'),
    _row("WV", "command", "W", "axis", "number", "write_float", "Write the accumulator as a real number to a variable.",
         'LU"ACCEL",AR10,AL5000,1WV@10'),
    _row("WD", "command", "W", "axis", "number", "write_double", "Write the accumulator as a double to a variable.",
         'LU"ACCEL",AR10,AL5000,1WD@10'),
    _known("GU", "command", "axis", "Get a user register; only the name is known."),
    _row("GX", "command", "C", "axis", "bits", "get_auxiliary", "Get the auxiliary status word into the accumulator.",
         "1GX,TR0"),
)  # fmt: skip
