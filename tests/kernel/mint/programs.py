"""Random programs that only compute: integers, Floats, arrays, branches and loops.

Every program ends.
"""

from __future__ import annotations

from random import Random

_WHOLE = (0, 1, 2, 3, 7, 10, 100, 1000, 65535, 2147483647, -1, -2, -50)
_REAL = (0.5, 1.5, -2.25, 1e6, 1e15, 3.0)
_ARITHMETIC = ("+", "+", "-", "-", "*", "*", "/", "\\", "Mod", "&", "|", "Xor", "<<", ">>")
_COMPARE = ("=", "<>", "<", ">", "<=", ">=")


class Writer:
    """Writer of one random program; `random` makes every choice."""

    def __init__(self, random: Random) -> None:
        self.random = random
        self.lines: list[str] = []
        self.depth = 0
        self.counters = 0
        self.loops: list[str] = []

    def program(self) -> str:
        self.lines = [
            "Dim n As Integer, m As Integer, k As Integer, x As Float",
            "Dim a(5) As Integer, f(4) As Float",
        ]
        for _ in range(self.random.randint(2, 6)):
            self.statement()
        for name in ("n", "m", "k", "x", "u", "v", "a(1)", "a(5)", "f(1)"):
            self.lines.append(f"PRINT {name}")
        return "\n".join(["u = 0 : v = 0 : i = 0 : j = 0", *self.lines])

    def statement(self) -> None:
        kinds = ["assign"] * 5 + ["print"]
        if self.depth < 3:
            kinds += ["if", "for", "while", "repeat", "select"]
        if self.loops:
            kinds.append("exit")
        getattr(self, "write_" + self.random.choice(kinds))()

    def emit(self, text: str) -> None:
        self.lines.append(" " * self.depth + text)

    def block(self, least: int = 1) -> None:
        self.depth += 1
        for _ in range(self.random.randint(least, 3)):
            self.statement()
        self.depth -= 1

    def write_assign(self) -> None:
        self.emit(f"{self.target()} = {self.value(3)}")

    def write_print(self) -> None:
        self.emit(f"PRINT {self.value(2)}")

    def write_if(self) -> None:
        self.emit(f"If {self.condition()} Then")
        self.block()
        if self.random.random() < 0.5:
            self.emit("Else")
            self.block()
        self.emit("End If")

    def write_for(self) -> None:
        name = self.random.choice(("i", "j", "k", "u", "n"))
        step = self.random.choice(("", "", "", " Step 2", " Step -1", " Step 0.5", " Step m", " Step -3"))
        self.emit(f"For {name} = {self.leaf()} To {self.random.choice((3, 5, 'n', 10))}{step}")
        self.guarded("for")
        self.emit("Next")

    def write_while(self) -> None:
        self.emit(f"While {self.condition()}")
        self.guarded("while")
        self.emit("End While")

    def write_repeat(self) -> None:
        self.emit("Repeat")
        self.guarded("repeat")
        self.emit(f"Until {self.condition()}")

    def guarded(self, kind: str) -> None:
        """Write the body of a loop, with a counter of its own so that the loop ends."""
        self.counters += 1
        counter = f"c{self.counters}"
        self.loops.append(kind)
        self.emit(f" {counter} = {counter} + 1")
        self.emit(f" If {counter} > {self.random.choice((3, 12, 40))} Then Exit {kind.capitalize()}")
        self.block()
        self.loops.pop()

    def write_select(self) -> None:
        self.emit(f"Select Case {self.value(1)}")
        self.emit(f"Case {self.leaf()}, {self.leaf()}")
        self.block()
        self.emit(f"Case {self.random.randint(-5, 3)} To {self.random.randint(3, 50)}")
        self.block()
        if self.random.random() < 0.5:
            self.emit("Case Else")
            self.block()
        self.emit("End Select")

    def write_exit(self) -> None:
        self.emit(f"If {self.condition()} Then Exit {self.random.choice(self.loops).capitalize()}")

    # -------------------------------------------------------------------------------------- expressions

    def target(self) -> str:
        array = (
            f"a({self.random.randint(1, 5)})"
            if self.random.random() < 0.5
            else f"f({self.random.randint(1, 4)})"
        )
        return self.random.choice(("n", "m", "k", "x", "u", "v", array, "n", "x", "u"))

    def leaf(self) -> str:
        kind = self.random.random()
        if kind < 0.35:
            return str(self.random.choice(_WHOLE))
        if kind < 0.42:
            return str(self.random.choice(_REAL))
        if kind < 0.5:
            return self.random.choice(("a", "f")) + f"({self.random.choice((1, 2, 4, 'n', 'i'))})"
        return self.random.choice(("n", "m", "k", "x", "u", "v"))

    def value(self, depth: int) -> str:
        kind = self.random.random()
        if depth == 0 or kind < 0.2:
            return self.leaf()
        if kind < 0.3:
            return (
                f"Abs({self.value(depth - 1)})"
                if kind < 0.25
                else f"Min({self.leaf()}, {self.value(depth - 1)})"
            )
        if kind < 0.36:
            return f"(-{self.value(depth - 1)})"
        return f"({self.value(depth - 1)} {self.random.choice(_ARITHMETIC)} {self.value(depth - 1)})"

    def condition(self) -> str:
        test = f"{self.value(1)} {self.random.choice(_COMPARE)} {self.value(1)}"
        kind = self.random.random()
        if kind < 0.2:
            return f"{test} And {self.leaf()} {self.random.choice(_COMPARE)} {self.leaf()}"
        if kind < 0.3:
            return f"{test} Or {self.leaf()} > {self.leaf()}"
        return f"Not ({test})" if kind < 0.4 else test
