"""Orders of a run in short, one line each, as tests compare them."""

from __future__ import annotations

from math import inf
from typing import Any

from motionlang import prove, run
from motionlang.commands.prove.expected_motion import ExpectedMotion
from motionlang.commands.prove.order import ENDLESS, Order, PathOrder, Tie
from motionlang.kernel import Source

USUAL = {"speed": inf, "rates": ENDLESS, "jerks": ENDLESS}


def recorded(program: str, name: str = "orders.mnt", **machine: object) -> ExpectedMotion:
    """Run a program whose statements take next to no time; return its orders."""
    settings = {"controller.instruction_time": 1e-9, **machine}
    result = run(Source(name, program), machine=settings, prove=True)
    assert result.diagnostics == []
    assert prove(result).violations == []
    return ExpectedMotion.of_run(result)


def in_short(value: Any) -> str:
    """Return a value with at most six digits."""
    if isinstance(value, Order):
        return f"({short(value)})"
    if isinstance(value, PathOrder):
        return fields(value, angle_into=0.0, length=None, plane=(0, 1), centre=(0.0, 0.0), angle=0.0)
    if isinstance(value, Tie):
        master: Any = value.master.index
        curve: Any = None if value.curve is None else value.curve.end
        return fields(value._replace(master=master, curve=curve))
    if isinstance(value, (tuple, list)):
        return "/".join(map(in_short, value)) or "none"
    return f"{value:.6g}" if isinstance(value, float) else str(value)


def fields(record: Any, **usual: object) -> str:
    """Return the fields of a record that differ from the usual ones."""
    usual = {**record._field_defaults, **usual}
    shown = [(name, each) for name, each in zip(record._fields, record, strict=True)]
    return " ".join(
        f"{name}={in_short(each)}"
        for name, each in shown
        if each != usual.get(name)
        and each not in ((), (inf,) * len(each) if isinstance(each, tuple) else None)
    )


def short(order: Order) -> str:
    """Return an order without the usual settings."""
    shaped: dict[str, object] = (
        {"shape": "trapezoid", "ramp": 0.1} if order.shape else {"shape": "", "ramp": 0.0}
    )
    rest = fields(order._replace(kind="", line=0), kind="", line=0, **USUAL, **shaped)
    return f"{order.kind}:{order.line} {rest}".strip()


def orders_of(found: ExpectedMotion, axis: int) -> list[str]:
    """Return the orders of an axis, each with the start of its profile."""
    starts = found._controller.axes[axis].starts
    return [
        f"{start:.3f} {short(order)}" + (f" datum={datum:.6g}" if datum else "")
        for start, order, datum in zip(starts, found.of[axis], found.data[axis], strict=True)
    ]
