"""Numbers of NumPy in the description of a servo."""

from __future__ import annotations

from dataclasses import fields

TYPE_CHECKING = False
if TYPE_CHECKING:
    from _typeshed import DataclassInstance


def take_python_numbers(figures: DataclassInstance) -> None:
    """Replace the scalars of NumPy among some figures by Python's numbers.

    The generated code of a servo has the text of each, and that of a scalar names NumPy.
    """
    for field in fields(figures):
        value = getattr(figures, field.name)
        if hasattr(value, "item"):
            object.__setattr__(figures, field.name, value.item())
