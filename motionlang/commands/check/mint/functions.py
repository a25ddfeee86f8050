"""The checks that analyse one function at a time."""

from __future__ import annotations

from collections.abc import Callable, Mapping

from motionlang.commands.check.mint.brackets import check_brackets
from motionlang.commands.check.mint.buffer import Buffers
from motionlang.commands.check.mint.conditions import Conditions
from motionlang.commands.check.mint.facts import MintFacts
from motionlang.commands.check.mint.iterations import check_iterations
from motionlang.commands.check.mint.motion import Motion
from motionlang.commands.check.mint.reachability import Reachability
from motionlang.commands.check.mint.settings import Settings
from motionlang.kernel.mint.syntax.nodes import Module

Add = Callable[..., None]


def check_functions(facts: MintFacts, settings: Mapping[str, object], module: Module, add: Add) -> None:
    """Report the problems of all functions."""
    follower = facts.axes
    Motion(follower, add).check()
    checks = (
        Buffers(facts, follower, add).check,
        Settings(facts, follower, add).check,
        Reachability(facts, follower, settings, add).check,
        Conditions(facts, follower, module, settings, add).check,
    )
    for function in facts.functions:
        for check in checks:
            check(function)
        check_iterations(facts, function, add)
        check_brackets(facts, function, module.source, add)
