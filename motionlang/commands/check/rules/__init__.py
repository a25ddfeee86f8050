"""The rules of the linter, a file each; a new file here is a new rule."""

from __future__ import annotations

from importlib import import_module
from pkgutil import iter_modules

from motionlang.commands.check.rule import Rule


def _rules() -> list[Rule]:
    return [import_module(f"{__name__}.{each.name}").RULE for each in iter_modules(__path__)]


# The rules by their codes, in alphabetical order.
RULES: dict[str, Rule] = {rule.code: rule for rule in _rules()}
