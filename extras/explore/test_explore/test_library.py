"""The names of the package `motionlang` that this distribution has."""

from __future__ import annotations

import contextlib
import importlib
import inspect
import pkgutil
from collections.abc import Callable

import pytest

import motionlang
import motionlang_explore
from motionlang.kernel.tools import MissingExtra
from tests.test_library import ERRORS, FEED, LIMITS, OWN, WRONG

# A call of each function.
CALLS: dict[str, Callable[[], object]] = {
    "cover": lambda: motionlang.cover(FEED),
    "explore": lambda: motionlang.explore(FEED),
    "improve": lambda: motionlang.improve(FEED, machine=LIMITS),
    "map": lambda: motionlang.map(FEED, run=True),
}


@pytest.mark.slow
def test_no_submodule_hides_a_name() -> None:
    for each in pkgutil.walk_packages(motionlang_explore.__path__, "motionlang_explore."):
        with contextlib.suppress(MissingExtra):
            importlib.import_module(each.name)
    for name, call in CALLS.items():
        assert not inspect.ismodule(getattr(motionlang, name)), name
        call()


def test_every_function_is_called_here() -> None:
    assert {name for name in motionlang.__all__ if name not in OWN} == CALLS.keys()


def test_every_name_has_a_docstring() -> None:
    for name in CALLS:
        assert inspect.getdoc(getattr(motionlang, name)), name


@pytest.mark.parametrize("name", CALLS)
def test_a_program_with_errors_is_a_program_error_with_its_lines(name: str) -> None:
    with pytest.raises(motionlang.ProgramError, match=ERRORS):
        getattr(motionlang, name)(WRONG)


@pytest.mark.parametrize("name", CALLS)
def test_a_docstring_names_the_errors(name: str) -> None:
    assert "aise" in str(inspect.getdoc(getattr(motionlang, name)))
