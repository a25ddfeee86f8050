"""A slow and simple second interpreter of Mint that checks every operation.

It walks the syntax tree and uses no ranges. Integers are Python ints that must fit 32 bits after every
operation; Floats are always Python floats. Checks that the compiler omits, and its representation of values,
must make no difference to the output.
"""

from __future__ import annotations

from collections.abc import Callable

from motionlang.kernel import Rejected
from motionlang.kernel.mint.runtime import functions
from motionlang.kernel.mint.runtime.printing import show_float, show_integer
from motionlang.kernel.mint.syntax import nodes

LOW, HIGH = -(2**31), 2**31 - 1


class Leave(Exception):
    """Control flow of an Exit in progress."""

    def __init__(self, kind: str) -> None:
        self.kind = kind


class Reference:
    """Interpreter of the parent task of a program that only computes.

    `printed` is its output, and `trouble` the fault that ended it, if any.
    """

    def __init__(self, module: nodes.Module) -> None:
        self.types: dict[str, str] = {}
        self.values: dict[str, float] = {}
        self.arrays: dict[str, list[float]] = {}
        self.printed: list[str] = []
        self.trouble = ""
        self.fuel = 20_000
        try:
            self.block(module.body)
        except (Rejected, ZeroDivisionError, OverflowError) as error:
            self.trouble = error.code if isinstance(error, Rejected) else type(error).__name__

    # --------------------------------------------------------------------------------------- statements

    def block(self, body: list[nodes.Stmt]) -> None:
        for node in body:
            self.fuel -= 1
            if self.fuel < 0:
                raise Rejected("limit", "out of fuel")
            getattr(self, "do_" + type(node).__name__.lower())(node)

    def do_dim(self, node: nodes.Dim) -> None:
        for variable in node.variables:
            name = variable.name.lower()
            self.types[name] = variable.type.name if variable.type else "Float"
            if variable.dimensions:
                size = variable.dimensions[0]
                assert isinstance(size, nodes.Number)
                self.arrays[name] = [0] * (int(size.value) + 1)
            elif variable.values:
                self.store(name, self.value(variable.values[0])[1])

    def do_assign(self, node: nodes.Assign) -> None:
        assert isinstance(node.target, nodes.Name)
        name = node.target.name.lower()
        if node.target.args is None:
            self.store(name, self.value(node.values[0])[1])
            return
        value = self.value(node.values[0])[1]
        index = functions.subscript(self.value(node.target.args[0])[1], len(self.arrays[name]) - 1)
        self.arrays[name][index] = self.as_type(self.types[name], value)

    def store(self, name: str, value: float) -> None:
        self.values[name] = self.as_type(self.types.get(name, "Float"), value)

    def as_type(self, kind: str, value: float) -> float:
        return functions.integer(value) if kind == "Integer" else float(value)

    def do_print(self, node: nodes.Print) -> None:
        kind, value = self.value(node.items[0].value)
        self.printed.append(show_integer(value) if kind == "Integer" else show_float(value))

    def do_if(self, node: nodes.If) -> None:
        self.block(node.body if self.value(node.condition)[1] else node.orelse)

    def do_for(self, node: nodes.For) -> None:
        name = node.variable.name.lower()
        start = self.value(node.first)[1]
        stop = self.value(node.stop)
        step = self.value(node.step) if node.step is not None else ("Integer", 1.0)
        step = (step[0], int(step[1]) if step[0] == "Integer" else step[1])
        self.store(name, start)
        while self.values[name] <= stop[1] if step[1] >= 0 else self.values[name] >= stop[1]:
            try:
                self.block(node.body)
            except Leave as leave:
                if leave.kind not in ("", "for"):
                    raise
                break
            here = (self.types.get(name, "Float"), self.values[name])
            self.store(name, self.operate("+", here, step)[1])

    def do_while(self, node: nodes.While) -> None:
        while self.value(node.condition)[1]:
            try:
                self.block(node.body)
            except Leave as leave:
                if leave.kind not in ("", "while"):
                    raise
                break

    def do_repeat(self, node: nodes.Repeat) -> None:
        while True:
            try:
                self.block(node.body)
            except Leave as leave:
                if leave.kind not in ("", "repeat"):
                    raise
                break
            if self.value(node.condition)[1]:
                break

    def do_exit(self, node: nodes.Exit) -> None:
        raise Leave(node.kind)

    def do_select(self, node: nodes.Select) -> None:
        subject = self.value(node.subject)[1]
        for case in node.cases:
            if not case.tests or any(self.fits(test, subject) for test in case.tests):
                self.block(case.body)
                return

    def fits(self, test: nodes.CaseTest, subject: float) -> bool:
        value = self.value(test.value)[1]
        if test.op == "To":
            assert test.high is not None
            return value <= subject <= self.value(test.high)[1]
        return bool(self.operate(test.op, ("Float", subject), ("Float", value))[1])

    # -------------------------------------------------------------------------------------- expressions

    def value(self, node: nodes.Expr) -> tuple[str, float]:
        if isinstance(node, nodes.Number):
            whole = isinstance(node.value, int) and LOW <= node.value <= HIGH
            return ("Integer", node.value) if whole else ("Float", float(node.value))
        if isinstance(node, nodes.Name):
            return self.name(node)
        if isinstance(node, nodes.Unary):
            kind, value = self.value(node.operand)
            if node.op == "-":
                return (
                    self.operate("-", ("Integer", 0), (kind, value)) if kind == "Integer" else (kind, -value)
                )
            if node.op == "Not":
                return "Integer", int(not value)
            return ("Integer", ~functions.integer(value)) if node.op == "~" else (kind, value)
        assert isinstance(node, nodes.Binary)
        left = self.value(node.left)
        if node.op in ("And", "Or"):
            if bool(left[1]) is (node.op == "Or"):
                return "Integer", int(bool(left[1]))
            return "Integer", int(bool(self.value(node.right)[1]))
        return self.operate(node.op, left, self.value(node.right))

    def name(self, node: nodes.Name) -> tuple[str, float]:
        name = node.name.lower()
        if node.args is None:
            kind = self.types.get(name, "Float")
            return kind, self.values.get(name, 0 if kind == "Integer" else 0.0)
        if name in self.arrays:
            index = functions.subscript(self.value(node.args[0])[1], len(self.arrays[name]) - 1)
            return self.types[name], self.arrays[name][index]
        found = [self.value(each) for each in node.args]
        kind = "Float" if any(each[0] == "Float" for each in found) else "Integer"
        value = {"abs": functions.absolute, "min": functions.least, "max": functions.greatest}[name](
            *(each[1] for each in found)  # type: ignore[operator]
        )
        return kind, float(value) if kind == "Float" else value

    def operate(self, op: str, left: tuple[str, float], right: tuple[str, float]) -> tuple[str, float]:
        kind = "Integer" if left[0] == right[0] == "Integer" else "Float"
        a, b = left[1], right[1]
        if kind == "Float" and op in ("+", "-", "*", "Mod"):
            a, b = float(a), float(b)
        if op in ("+", "-", "*"):
            value = a + b if op == "+" else a - b if op == "-" else a * b
            return kind, (
                value if LOW <= value <= HIGH else functions.overflow(value)
            ) if kind == "Integer" else value
        if op in _COMPARE:
            compare: Callable[[float, float], bool] = _COMPARE[op]
            return "Integer", int(compare(a, b))
        if op == "/":
            return "Float", a / b
        if op == "Mod":
            return kind, functions.modulo(a, b)
        if op == "^":
            return "Float", functions.power(a, b)
        whole: Callable[[float, float], int] = {
            "\\": functions.divide,
            "<<": functions.shift_left,
            ">>": functions.shift_right,
            "&": lambda x, y: functions.integer(x) & functions.integer(y),
            "|": lambda x, y: functions.integer(x) | functions.integer(y),
            "Xor": lambda x, y: functions.integer(x) ^ functions.integer(y),
        }[op]
        return "Integer", whole(a, b)


_COMPARE: dict[str, Callable[[float, float], bool]] = {
    "=": lambda a, b: a == b,
    "<>": lambda a, b: a != b,
    "<": lambda a, b: a < b,
    ">": lambda a, b: a > b,
    "<=": lambda a, b: a <= b,
    ">=": lambda a, b: a >= b,
}
