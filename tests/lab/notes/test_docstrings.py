"""The examples in the docstrings of `tests.lab.notes.vendor`, and that each public function has one."""

from __future__ import annotations

import doctest
import inspect
from importlib import import_module
from pkgutil import iter_modules
from types import ModuleType

import pytest

from tests.lab.notes import vendor

MODULES = [import_module(f"tests.lab.notes.vendor.{each.name}") for each in iter_modules(vendor.__path__)]


@pytest.mark.parametrize("module", MODULES, ids=lambda module: module.__name__.split(".")[-1])
def test_each_function_has_an_example_that_holds(module: ModuleType) -> None:
    assert doctest.testmod(module).failed == 0
    functions = inspect.getmembers(module, inspect.isfunction)
    own = [each for name, each in functions if each.__module__ == module.__name__ and name[0] != "_"]
    assert own
    assert [each.__name__ for each in own if ">>>" not in (each.__doc__ or "")] == []
