"""The variants of a sweep, and the expressions that select variants."""

from __future__ import annotations

import random
from itertools import product

import pytest

from motionlang.commands.sweep.expression import Expression, pareto
from motionlang.commands.sweep.space import Dimension, Drawn, Grid, dimension, space_of


def test_the_last_name_of_a_grid_changes_fastest() -> None:
    grid = Grid([dimension("a=1:3:3"), dimension("b=x,0.5"), dimension("axis.0.travel=[0, 5],[1, 2]")])
    assert [grid[n] for n in range(len(grid))] == list(product((1, 2, 3), ("x", 0.5), ([0, 5], [1, 2])))


@pytest.mark.parametrize(
    ("text", "values"),
    [
        ("n=0:1:5", [0, 0.25, 0.5, 0.75, 1]),
        ("n=10:1:4", [10, 7, 4, 1]),
        ("n=0.1:0.3:3", [0.1, 0.2, 0.3]),
        ("n=5:9:1", [5]),
        ("n=-1e-3", [-0.001]),
        ("n='a,b', c", ["a,b", "c"]),
        ("n=true,007", [True, 7]),
    ],
)
def test_values_as_they_are_written(text: str, values: list[object]) -> None:
    grid = Grid([dimension(text)])
    assert [grid[n][0] for n in range(len(grid))] == values


@pytest.mark.parametrize(
    ("text", "values"),
    [
        ("n=1:4:4", ["1", "2", "3", "4"]),
        ("n=1:2:3", ["1", "1.5", "2"]),
        ("n=1:2.5:4", ["1.0", "1.5", "2.0", "2.5"]),
        ("n=1.0:2:1", ["1.0"]),
    ],
)
def test_values_are_integers_if_both_ends_are(text: str, values: list[str]) -> None:
    grid = Grid([dimension(text)])
    assert [repr(grid[n][0]) for n in range(len(grid))] == values


@pytest.mark.parametrize(
    "text", ["n", "n=", "=1", "n=1:2:0", "n=1:2:2.5", "n=a:b:3", "n=1:inf:3", "n=1:2:-4"]
)
def test_what_is_no_range_is_refused(text: str) -> None:
    with pytest.raises(ValueError, match="is not"):
        dimension(text)


def test_what_is_wrong_with_a_grid_is_reported() -> None:
    with pytest.raises(ValueError, match=r"how many values of n\? A grid needs n=1:2:COUNT"):
        Grid([dimension("n=1:2")])
    with pytest.raises(ValueError, match="varied twice"):
        Grid([dimension("n=1:2:2"), dimension("n=1,2")])
    with pytest.raises(ValueError, match="more than"):
        Grid([dimension("n=1:2:99999"), dimension("m=1:2:99999")])
    with pytest.raises(ValueError, match="point 1 differs in names"):
        space_of([{"a": 1.0}, {"b": 1.0}])


def test_a_latin_hypercube_has_one_point_in_each_interval() -> None:
    count = 50
    drawn = Drawn([dimension("a=0:50"), dimension("b=-1:1"), dimension("c=x,y")], count, 7, True)
    points = [drawn[n] for n in range(count)]
    assert sorted(int(a) for a, _, _ in points if isinstance(a, float)) == list(range(count))
    assert sorted(int((b + 1) * 25) for _, b, _ in points if isinstance(b, float)) == list(range(count))
    assert [c for _, _, c in points].count("x") == count / 2
    assert points == [Drawn(drawn.dimensions, count, 7, True)[n] for n in range(count)]
    assert points != [Drawn(drawn.dimensions, count, 8, True)[n] for n in range(count)]


def test_random_points_lie_within_and_do_not_depend_on_how_many_there_are() -> None:
    few, many = (Drawn([dimension("a=2:3"), Dimension("b", [1, 4])], count, 0, False) for count in (5, 500))
    assert [few[n] for n in range(5)] == [many[n] for n in range(5)]
    assert all(2 <= a <= 3 and b in (1, 4) for a, b in map(many.__getitem__, range(500)))  # type: ignore[operator]


VALUES: dict[str, object] = {
    "time": 2.5,
    "peak.0": 300.0,
    "axis.0.plant.inertia": 1e-5,
    "prints.1": "done",
    "none": None,
}


@pytest.mark.parametrize(
    ("text", "value"),
    [
        ("time", 2.5),
        ("time + 0.1 * peak.0", 32.5),
        ("peak.0 < 400 and not time > 3", True),
        ("1 < time <= 2.5", True),
        ("abs(-time) ** 2", 6.25),
        ("max(time, peak.0, 1e3)", 1000.0),
        ("axis.0.plant.inertia * 1e5", pytest.approx(1.0)),
        ('prints.1 == "done"', True),
        ("peak.0 % 7", 6.0),
        ("none + 1", None),
        ("1 / 0", None),
        ("time ** 1e9", None),
        ("prints.1 * 1000", None),
    ],
)
def test_an_expression(text: str, value: object) -> None:
    assert Expression(text)(VALUES) == value


@pytest.mark.parametrize("text", ["", "time +", "time; peak", "f(time)", "time[0]", "lambda: 1", "().__class__",
                                  "abs(*time)", "min()", "x" * 9 + "(", "1" + "+1" * 600, "(" * 400])  # fmt: skip
def test_what_is_no_expression(text: str) -> None:
    with pytest.raises(ValueError, match="is not an expression such as"):
        Expression(text)


def test_a_front_is_what_nothing_beats() -> None:
    draw = random.Random(5)
    for width in (2, 3):
        for _ in range(60):
            costs = [tuple(float(draw.randrange(6)) for _ in range(width)) for _ in range(draw.randrange(25))]
            found = {costs[n] for n in pareto(costs)}
            beaten = {
                a for a in costs for b in costs if b != a and all(x <= y for x, y in zip(b, a, strict=True))
            }
            assert found == set(costs) - beaten
            assert len(found) == len(pareto(costs))


@pytest.mark.parametrize(
    ("text", "values"),
    [
        ("n=0:4:5", [0, 1, 2, 3, 4]),
        ("n=0:4:3", [0, 2, 4]),
        ("n=0:1:3", [0, 0.5, 1]),
        ("n=0.0:4.0:3", [0.0, 2.0, 4.0]),
        ("n=7:7:2", [7, 7]),
        ("n=1:2:1", [1]),
    ],
)
def test_steps_of_a_range_are_integers_if_it_is_written_so(text: str, values: list[float]) -> None:
    found = dimension(text)
    shown = [found[k] for k in range(len(found))]
    assert [(each, type(each)) for each in shown] == [(each, type(each)) for each in values]


@pytest.mark.parametrize(
    ("fraction", "number", "letter"),
    [(0.0, 10.0, "x"), (0.49, 14.9, "x"), (0.5, 15.0, "y"), (1.0, 20.0, "y")],
)
def test_the_value_at_a_fraction(fraction: float, number: float, letter: str) -> None:
    """The values of a list have equal shares, and 1 is in the last one."""
    assert dimension("a=10:20").at(fraction) == pytest.approx(number)
    assert dimension("a=x,y").at(fraction) == letter


def test_a_grid_of_python_values() -> None:
    """A number is one value, a text is written as on the command line."""
    space = space_of({"a": 5, "b": "1:3:3", "c": [2.5, "x"]})
    assert (len(space), space[0], space[5]) == (6, (5, 1, 2.5), (5, 3, "x"))
    assert space_of(space) is space
    assert (len(space_of([])), space_of([{"a": 1}, {"a": 2}])[1]) == (0, (2,))
    with pytest.raises(ValueError, match="a has no values"):
        space_of({"a": []})


@pytest.mark.parametrize(
    ("count", "taken"), [(0, False), (1, True), (100_000_000, True), (100_000_001, False)]
)
def test_the_number_of_points(count: int, taken: bool) -> None:
    if taken:
        assert len(Drawn([dimension("a=0:1")], count, 0, False)) == count
    else:
        with pytest.raises(ValueError, match="a sweep has 1 to 100000000 variants"):
            Drawn([dimension("a=0:1")], count, 0, False)


def test_a_grid_has_a_largest_size() -> None:
    assert len(Grid([dimension("a=0:1:10000"), dimension("b=0:1:10000")])) == 100_000_000
    with pytest.raises(ValueError, match="100010000 variants are more than 100000000"):
        Grid([dimension("a=0:1:10000"), dimension("b=0:1:10001")])


@pytest.mark.parametrize(
    ("text", "value"),
    [
        ("1 + 2 * 3 - 4 / 2", 5.0),
        ("7 % 4", 3),
        ("2 ** 3", 8),
        ("2 ** 100", 2**100),
        ("2 ** 101", None),
        ("2 ** -101", None),
        ("+time", 2.5),
        ("1 < 2 < 3", True),
        ("1 < 3 < 2", False),
        ("2 <= 2", True),
        ("2 >= 3", False),
        ("2 != 2", False),
        ("time == 2.5 or missing > 1", True),
        ("missing > 1 or time == 2.5", None),
        ("time > 9 and missing > 1", False),
        ("min(3, 1, 2)", 1),
        ("not time", False),
        ("True", True),
    ],
)
def test_operators_of_an_expression(text: str, value: object) -> None:
    assert Expression(text)(VALUES) == value


@pytest.mark.parametrize(
    ("text", "value"), [("time", 2.5), ("1e308 * 10", None), ("prints.1", None), ("none", None), ("2", 2.0)]
)
def test_a_finite_number(text: str, value: float | None) -> None:
    assert Expression(text).number(VALUES) == value


def test_names_of_an_expression_and_its_largest_size() -> None:
    """A text and a function are no names; `1 + 1 + …` has three nodes for each number."""
    assert Expression("max(time, peak.0) + peak.0").names == ("time", "peak.0")
    assert Expression('prints.1 == "time"').names == ("prints.1",)
    assert Expression("1" + "+1" * 160)(VALUES) == 161
    for text in ("1" + "+1" * 170, "max(time, key=1)", "time.x()", "[1]"):
        with pytest.raises(ValueError, match="is not an expression such as"):
            Expression(text)


@pytest.mark.parametrize(("signs", "additions", "is_valid"), [(2, 165, True), (1, 166, False)])
def test_an_expression_has_at_most_500_nodes(signs: int, additions: int, is_valid: bool) -> None:
    """An addition has three nodes, its sign among them, and a minus has two.

    1 + 3 · 165 + 2 · 2 = 500, and 1 + 3 · 166 + 2 · 1 = 501.
    """
    text = "-" * signs + "1" + "+1" * additions
    if is_valid:
        assert Expression(text).names == ()
    else:
        with pytest.raises(ValueError, match="is not an expression"):
            Expression(text)
