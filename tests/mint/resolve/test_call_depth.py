"""Programs whose calls may nest too deeply, so that the calls are counted."""

from __future__ import annotations

from motionlang.lang.nesting import MAX_DEPTH
from motionlang.mint.resolve.call_depth import count_calls
from motionlang.mint.resolve.symbols import Function
from tests.cases import cases


def is_counted(calls: dict[str, str], typed: bool = False, gosub: bool = False) -> bool:
    """Return if calls are counted; `calls` maps each function to those that it calls."""
    functions = {name: Function("sub", name, name, [], None) for name in calls}
    for name, callees in calls.items():
        functions[name].calls = {functions[callee] for callee in callees.split()}
    functions["main"].gosubs = gosub
    count_calls(list(functions.values()), typed)
    counted = {function.counted for function in functions.values()}
    assert len(counted) == 1  # all functions or none
    return counted == {True}


@cases(
    "calls, counted",
    [
        ({"main": ""}, False),
        ({"main": "a b", "a": "", "b": "a"}, False),
        ({"main": "a b", "a": "b", "b": "", "unused": "a"}, False),
        ({"main": "a", "a": "a"}, True),
        ({"main": "a", "a": "b", "b": "a"}, True),
        ({"main": "", "a": "b", "b": "a"}, True),
    ],
)
def test_a_function_that_calls_itself_is_counted(calls: dict[str, str], counted: bool) -> None:
    assert is_counted(calls) == counted


def test_lines_at_a_prompt_and_gosubs_are_counted() -> None:
    """Later lines may add calls, and a Gosub may lead to itself."""
    calls = {"main": "a", "a": ""}
    assert not is_counted(calls)
    assert is_counted(calls, typed=True)
    assert is_counted(calls, gosub=True)


def test_a_chain_of_calls_that_is_too_long_is_counted() -> None:
    """The longest path decides: `main` calls the first and the last sub."""

    def chain(length: int) -> dict[str, str]:
        subs = {f"sub{n}": f"sub{n + 1}" for n in range(1, length)}
        return {"main": f"sub1 sub{length}", **subs, f"sub{length}": ""}

    assert not is_counted(chain(MAX_DEPTH))
    assert is_counted(chain(MAX_DEPTH + 1))
