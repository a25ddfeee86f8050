"""`@record` generates the slots and the `__init__` of a class of plain fields."""

from __future__ import annotations

from inspect import signature

import pytest

from motionlang.record import as_dict, record


@record
class Point:
    """A place on a map."""

    y: float
    x: float = 0.0

    def moved(self, by: float) -> Point:
        return Point(self.y, self.x + by)


@record
class Named(Point):
    name: str = "home"


def test_a_record_is_made_of_its_fields_in_order() -> None:
    point = Point(2.0, x=3.0).moved(1.0)
    assert (point.y, point.x) == (2.0, 4.0)
    assert Point(2.0).x == 0.0
    assert Point.__doc__ == "A place on a map."
    assert [*signature(Point).parameters] == ["y", "x"]


def test_a_record_has_no_other_attributes() -> None:
    with pytest.raises(AttributeError):
        Point(1.0).z = 2.0  # type: ignore[attr-defined]
    with pytest.raises(TypeError):
        Point()  # type: ignore[call-arg]


def test_the_fields_of_a_base_come_first() -> None:
    named = Named(1.0, 2.0, "work")
    assert (named.y, named.x, named.name) == (1.0, 2.0, "work")


def test_a_default_of_a_base_holds_in_a_subclass() -> None:
    named = Named(1.0)
    assert (named.x, named.name) == (0.0, "home")


def test_a_record_as_a_dictionary() -> None:
    assert as_dict(Point(1.0, 2.0)) == {"x": 2.0, "y": 1.0}
    assert as_dict(Named(1.0)) == {"name": "home"}
