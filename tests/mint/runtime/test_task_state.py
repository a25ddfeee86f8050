"""The state of a suspended task as bytes: equal if it would continue equally."""

from __future__ import annotations

from collections.abc import Generator
from typing import Any

import pytest

from motionlang.mint.runtime.task_state import of_task, of_values


class Semaphore:
    """A value that has no bytes of its own."""


HELD, OTHER = Semaphore(), Semaphore()


@pytest.mark.parametrize(
    ("one", "another", "same"),
    [
        ([1, 2.5, "a", None], [1, 2.5, "a", None], True),
        ([1], [2], False),
        ([1], [1.0], False),
        ([1, HELD], [1, HELD], True),
        ([1, HELD], [1, OTHER], False),
        ([1, HELD], [2, HELD], False),
        (["a", HELD], ["b", HELD], False),
        ([2.5, HELD], [3.5, HELD], False),
        ([None, HELD], [HELD, None], False),
        ([None, HELD], [0, HELD], False),
        ([[1, HELD], 2], [[1, HELD], 2], True),
        ([[1, HELD], 2], [[3, HELD], 2], False),
        ([(1, 2), HELD], [(1, 3), HELD], False),
    ],
)
def test_values_are_compared_by_value_and_objects_by_identity(
    one: list[Any], another: list[Any], same: bool
) -> None:
    """Numbers next to an object without bytes are still compared by value."""
    alive: dict[int, object] = {}
    assert (of_values(one, alive) == of_values(another, alive)) is same
    objects = {id(each) for each in (HELD, OTHER) if any(each in values for values in (one, another))}
    assert objects <= set(alive)
    assert all(isinstance(each, Semaphore) for each in alive.values())


def test_numbers_have_no_identity() -> None:
    """Large numbers that are computed twice are two objects."""
    values = [[float(f"1e{n}"), int(f"{10**n}"), f"text {n}", Semaphore] for n in (20, 20)]
    assert of_values(values[0], {}) == of_values(values[1], {})


def loop(p_array: list[float], count: int) -> Generator[None]:
    """Wait in each iteration, like a compiled task."""
    for v_i in range(count):
        _ = v_i
        yield
    yield
    del p_array


def state(task: Any, steps: int = 1) -> bytes | None:
    for _ in range(steps):
        next(task)
    return of_task(task, None, {}, lambda began: False)


def test_a_task_is_where_its_generators_and_variables_are() -> None:
    array = [1.0]
    assert state(loop(array, 3)) == state(loop(array, 3))
    assert state(loop(array, 3)) != state(loop(array, 3), 2)  # another value of v_i
    assert state(loop(array, 3)) != state(loop(array, 4))
    assert state(loop(array, 3)) != state(loop([1.0], 3))  # the variable of another caller
    assert state(loop(array, 1)) != state(loop(array, 1), 2)  # in another place
    assert of_task(iter([1]), None, {}, lambda began: False) is None  # no compiled code

    def call(p_array: list[float]) -> Generator[None]:
        yield from loop(p_array, 3)

    assert state(call(array)) == state(call(array))
    assert state(call(array)) != state(call(array), 2)
    assert state(call(array)) != state(loop(array, 3))


def test_the_beginning_of_an_old_loop_is_no_part_of_the_state() -> None:
    """It matters only whether the loop, at offset 7 of the program, is open."""

    def looped(t: tuple[float, float] | None) -> Generator[None]:  # `t` is no part of a state
        l7 = t
        yield
        del l7

    def found(begun: tuple[float, float] | None, old: float) -> bytes | None:
        task = looped(begun)
        next(task)
        return of_task(task, None, {}, lambda began: began[0] < old)

    assert found((3.0, 0.0), 5.0) == found((4.0, 0.0), 5.0)
    assert found((3.0, 0.0), 4.0) != found((4.0, 0.0), 4.0)
    assert found((3.0, 0.0), 5.0) != found(None, 5.0)


def test_an_operation_that_is_put_off_is_part_of_the_state() -> None:
    def wait() -> Generator[None]:
        yield

    task = wait()
    next(task)
    cases: list[Any] = [
        None,
        (print, (1, 2), (0,)),
        (print, (1, 3), (0,)),
        (print, (1, 2), (1,)),
        (len, (1, 2), (0,)),
    ]
    found = [of_task(task, case, {}, lambda began: False) for case in cases]
    assert len(set(found)) == len(cases)
    assert of_task(task, cases[1], {}, lambda began: False) == found[1]
