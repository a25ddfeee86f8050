"""A compilable program of any size, in Mint and statement for statement in Python.

Equal seeds give equal programs.
"""

from __future__ import annotations

from random import Random

NAMES = ["x", "y", "count", "goal", "ref", "n", "gap", "most", "moment", "gain", "rate", "zHome"]
SETTINGS = ["MOVEA", "MOVER", "POS", "ENCODER"]
# Settings with a limited range: they are given a number, not a term that may exceed it.
BOUNDED = ["SPEED", "ACCEL", "DECEL", "JOG"]
READ_KEYWORDS = ["POS", "VEL", "FOLERROR", "IDLE", "AXISMODE", "ENCODER"]
COMPARISONS = {"<": "<", ">": ">", "<=": "<=", ">=": ">=", "<>": "!=", "=": "=="}
Pair = tuple[str, str]  # equal programs in Mint and in Python


def program(size: int, seed: int = 1) -> Pair:
    """Return a program of about `size` characters of Mint, with its Python equivalent."""
    writer = _Writer(Random(seed))
    number = 0
    writer.line(0, f"Dim {', '.join(NAMES)}", f"{' = '.join(NAMES)} = 0.0")
    while writer.size < size:
        writer.line(0, f"Sub proc{number}(a, b)", f"def proc{number}(a, b):\n  global {', '.join(NAMES)}")
        writer.block(1)
        writer.line(0, "End Sub", "")
        number += 1
    return "\n".join(writer.mint) + "\n", "\n".join(writer.python) + "\n"


class _Writer:
    def __init__(self, random: Random) -> None:
        self.random = random
        self.mint: list[str] = []
        self.python: list[str] = []
        self.size = 0

    def line(self, depth: int, mint: str, python: str) -> None:
        self.mint.append("  " * depth + mint)
        self.python.append("  " * depth + python if python else "")
        self.size += len(self.mint[-1]) + 1

    def number(self) -> str:
        kind = self.random.random()
        if kind < 0.6:
            return str(self.random.randint(1, 9999))
        return f"{self.random.random() * 1000:.{self.random.randint(1, 4)}f}"

    def value(self, depth: int = 0) -> Pair:
        kind = self.random.random()
        if depth > 2 or kind < 0.35:
            return self.operand()
        left, right = self.value(depth + 1), self.value(depth + 1)
        if kind < 0.9:
            sign = self.random.choice("++-**/")
            return f"{left[0]} {sign} {right[0]}", f"{left[1]} {sign} {right[1]}"
        return f"({left[0]})", f"({left[1]})"

    def operand(self) -> Pair:
        kind = self.random.random()
        if kind < 0.5:
            text = self.number()
        elif kind < 0.9:
            text = self.random.choice(NAMES)
        else:
            text = f"{self.random.choice(READ_KEYWORDS)}({self.random.randint(0, 7)})"
        return text, text

    def condition(self) -> Pair:
        left, right = self.value(1), self.value(1)
        mint, python = self.random.choice(list(COMPARISONS.items()))
        one = f"{left[0]} {mint} {right[0]}", f"{left[1]} {python} {right[1]}"
        if self.random.random() < 0.8:
            return one
        other = self.condition()
        return f"{one[0]} And {other[0]}", f"{one[1]} and {other[1]}"

    def simple(self) -> Pair:
        kind, value, axis = self.random.random(), self.value(), self.random.randint(0, 6)
        if kind < 0.4:
            name = self.random.choice(NAMES)
            return f"{name} = {value[0]}", f"{name} = {value[1]}"
        if kind < 0.58:
            setting = self.random.choice(SETTINGS)
            return f"{setting}({axis}) = {value[0]}", f"{setting}[{axis}] = {value[1]}"
        if kind < 0.75:
            setting, number = self.random.choice(BOUNDED), self.number()
            return f"{setting}({axis}) = {number}", f"{setting}[{axis}] = {number}"
        if kind < 0.85:
            return f"GO({axis})", f"GO({axis})"
        if kind < 0.92:
            return f'Print "pos "; {value[0]}', f'print("pos ", {value[1]})'
        both = self.value()
        targets = f"{axis}, {axis + 1}"
        return f"VECTORR({targets}) = {value[0]}, {both[0]}", f"VECTORR[{targets}] = {value[1]}, {both[1]}"

    def block(self, depth: int) -> None:
        for _ in range(self.random.randint(2, 7)):
            self.statement(depth)
        self.line(depth, "x = x", "x = x")

    def statement(self, depth: int) -> None:
        kind = self.random.random()
        if kind < 0.76 or depth > 4:
            pairs = [self.simple() for _ in range(1 if self.random.random() < 0.75 else 2)]
            self.line(depth, " : ".join(pair[0] for pair in pairs), "; ".join(pair[1] for pair in pairs))
        elif kind < 0.82:
            test, pair = self.condition(), self.simple()
            self.line(depth, f"If {test[0]} Then {pair[0]}", f"if {test[1]}: {pair[1]}")
        elif kind < 0.88:
            test = self.condition()
            self.wrapped(depth, (f"If {test[0]} Then", f"if {test[1]}:"), "End If")
        elif kind < 0.95:
            name, low, high = self.random.choice(NAMES), self.number(), self.number()
            self.wrapped(
                depth, (f"For {name} = {low} To {high}", f"for {name} in range({low}, {high}):"), "Next"
            )
        else:
            test = self.condition()
            self.wrapped(depth, (f"While {test[0]}", f"while {test[1]}:"), "End While")

    def wrapped(self, depth: int, opener: Pair, closer: str) -> None:
        self.line(depth, "' wait until the axis is idle", "# wait until the axis is idle")
        self.line(depth, *opener)
        self.block(depth + 1)
        self.line(depth, closer, "")
