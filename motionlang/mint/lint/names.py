"""Checks of names: variables, subs and tasks that nothing uses, and axes that two tasks command."""

from __future__ import annotations

from typing import TYPE_CHECKING

from motionlang.mint.lint.effects import Facts, Key
from motionlang.mint.resolve.symbols import SEMAPHORE, Function, Symbol
from motionlang.mint.syntax import nodes
from motionlang.mint.syntax.traversal import walk

if TYPE_CHECKING:
    from collections.abc import Callable

    Add = Callable[..., None]

_COMMANDS = frozenset(("move", "entry", "course", "path", "go", "act"))
# Words with which tasks take turns.
_TURNS = frozenset(("task_status", "task_suspend", "task_resume"))


def check_names(facts: Facts, add: Add) -> None:
    """Everything that is declared and never used."""
    for function in facts.functions:
        for symbol in function.scope.names.values():
            if symbol.home is function and symbol.kind == "variable" and symbol.declared and symbol.uses <= 0:
                _unused_variable(facts, symbol, add)
    run = {
        node.name.lower()
        for function in facts.functions
        for node in walk(function.body)
        if type(node) is nodes.Run
    }
    for function in facts.functions:
        if function.kind == "task" and function.name.lower() not in run:
            add(
                "unused-task",
                f"nothing runs the task {function.name}",
                function.at,
                f"Run {function.name} starts it",
            )
        elif function.kind == "sub" and not facts.roots[function]:
            add("unused-sub", f"nothing calls {function.name}", function.at)


def _unused_variable(facts: Facts, symbol: Symbol, add: Add) -> None:
    given = facts.writers.get(symbol)
    if symbol in facts.kept or (given and symbol.type.name == SEMAPHORE):
        return  # who takes a semaphore waits for it: that is its use
    what = "is given a value that nothing reads" if given else "is declared and never used"
    add("unused-variable", f"{symbol.name} {what}", symbol.at)


def check_tasks(facts: Facts, add: Add) -> None:
    """Axes that two tasks command, when nothing in the program lets them take turns."""
    if _take_turns(facts):
        return
    main = facts.names.main
    tasks = [function for function in facts.functions if function.kind == "task"]
    first: dict[Key, Function] = {}
    for task in tasks:
        if _is_told(facts, task):
            continue
        for key in sorted(_axes(facts, task), key=str):
            if key in first:
                _two(facts, task, first[key], key, add)
            elif key in _after_run(facts, main, task):
                _two(facts, task, main, key, add)
            first.setdefault(key, task)


def _axes(facts: Facts, function: Function) -> set[Key]:
    return facts.touched(function, _COMMANDS) - {None}


def _take_turns(facts: Facts) -> bool:
    symbols = [symbol for function in facts.functions for symbol in function.scope.names.values()]
    if any(symbol.kind == "variable" and symbol.type.name == SEMAPHORE for symbol in symbols):
        return True
    if any(act.row is not None and act.row.verb in _TURNS for _, _, act in facts.all_acts()):
        return True
    bodies = [node for function in facts.functions for node in walk(function.body)]
    return any(type(node) is nodes.End and node.name is not None for node in bodies)


def _is_told(facts: Facts, task: Function) -> bool:
    """A task that looks at variables of others before it moves is told when it may."""
    for function in facts.called(task):
        for node in walk(function.body):
            condition = getattr(node, "condition", None)
            for name in walk([condition]) if condition is not None else ():
                symbol = function.scope.find(name.name) if type(name) is nodes.Name else None
                if symbol is not None and symbol.shared:
                    return True
    return False


def _after_run(facts: Facts, main: Function, task: Function) -> set[Key]:
    """The axes that the parent may command once it has started a task."""
    stack = [
        step
        for step in facts.graphs[main].steps
        if type(step.node) is nodes.Run and step.node.name.lower() == task.name.lower()
    ]
    found: set[Key] = set()
    seen = set(stack)
    while stack:
        step = stack.pop()
        for act in facts.acts[step]:
            if act.role in _COMMANDS:
                found.update(act.axes)
            elif act.callee is not None:
                found.update(facts.outer(main, act, key) for key in facts.touched(act.callee, _COMMANDS))
        new = [each for each in step.next if each not in seen]
        seen.update(new)
        stack.extend(new)
    return found


def _two(facts: Facts, task: Function, other: Function, key: Key, add: Add) -> None:
    at = next(
        act.at
        for _, _, act in facts.all_acts(facts.called(task))
        if act.role in _COMMANDS
        and (key in act.axes or None in act.axes or any(isinstance(k, Symbol) for k in act.axes))
    )
    who = "the parent" if other.kind == "main" else f"the task {other.name}"
    add("two-tasks", f"axis {key} is commanded by the task {task.name} and by {who}", at,
        "let one task command it, or let them take turns")  # fmt: skip
