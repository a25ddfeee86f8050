"""Checks of names: unused variables, subs and tasks, axes that two tasks command."""

from __future__ import annotations

from collections.abc import Callable

from motionlang.commands.check.mint.facts import MintFacts
from motionlang.kernel.lang import AxisKey as Key
from motionlang.kernel.mint.resolve.facts import meaning
from motionlang.kernel.mint.resolve.problems import MAX_PROBLEMS
from motionlang.kernel.mint.resolve.symbols import (
    CONTROLLER,
    RECORD,
    SEMAPHORE,
    STRING,
    TIME,
    Function,
    Symbol,
)
from motionlang.kernel.mint.syntax import nodes
from motionlang.kernel.mint.syntax.traversal import walk
from motionlang.kernel.tools import nearest

Add = Callable[..., None]

_COMMANDS = frozenset(("move", "entry", "course", "path", "go", "act"))
# Verbs of the keywords by which tasks coordinate.
_COORDINATION = frozenset(("task_status", "task_suspend", "task_resume"))


def check_names(facts: MintFacts, add: Add) -> None:
    """Report names that are never used, and variables that are never assigned."""
    own = _own_reads(facts)
    suggestions = _Suggestions()
    for function in facts.functions:
        for symbol in function.scope.names.values():
            if symbol.kind == "define" and symbol.uses <= 0:
                add("unused-variable", f"{symbol.name} is defined and never used", symbol.at)
            if symbol.home is not function or symbol.kind != "variable":
                continue
            if symbol.uses <= own.get(symbol, 0):
                _unused_variable(facts, symbol, suggestions, add)
            elif symbol not in facts.writers:
                _no_value(facts, symbol, suggestions, add)
    run = {node.name.lower() for node in facts.of_kind(nodes.Run)}
    for function in facts.functions:
        if function.kind == "task" and function.name.lower() not in run:
            add(
                "unused-task",
                f"task {function.name} is never run",
                function.at,
                f"start it with Run {function.name}",
            )
        elif function.kind == "sub" and not facts.roots[function]:
            add("unused-sub", f"{function.name} is never called", function.at)


def _unused_variable(facts: MintFacts, symbol: Symbol, suggestions: _Suggestions, add: Add) -> None:
    given = facts.writers.get(symbol)
    if symbol in facts.retained or (given and symbol.type.name == SEMAPHORE):
        return  # taking a semaphore waits for it, which is a use
    what = "is declared and never used"
    if given:
        what = f"is assigned but never read{' elsewhere' if symbol.uses > 0 else ''}"
    near = None if symbol.declared else suggestions.most_similar(symbol, lambda each: each.uses > 0)
    hint = f"did you mean {near}?" if near else ""
    add("unused-variable", f"{symbol.name} {what}", symbol.at, hint, (near,) if near else ())


def _no_value(facts: MintFacts, symbol: Symbol, suggestions: _Suggestions, add: Add) -> None:
    """Report a variable that is read and never assigned, so it is always 0 or empty."""
    whole = symbol.is_array or symbol.type.name in (TIME, SEMAPHORE, CONTROLLER, RECORD)
    if whole or symbol in facts.retained or symbol in facts.begun:
        return
    value = "empty" if symbol.type.name == STRING else "0"
    near = suggestions.most_similar(symbol, lambda each: each in facts.writers and each.uses <= 1)
    hint = f"did you mean {near} in its assignment?" if near else "assign it in its Dim or before it is read"
    add(
        "no-value",
        f"{symbol.name} is read but never assigned: it is always {value}",
        symbol.at,
        hint,
        (near,) if near else (),
    )


class _Suggestions:
    """The search for names that the author may have meant.

    Each search takes time in proportion to the size of the program. So only the first findings, which are shown, get a
    suggestion.
    """

    def __init__(self) -> None:
        self._left = MAX_PROBLEMS

    def most_similar(self, symbol: Symbol, wanted: Callable[[Symbol], bool]) -> str | None:
        """Return the name of the most similar variable that is `wanted`, or None."""
        if self._left == 0:
            return None
        self._left -= 1
        others = [
            each.name
            for each in symbol.home.scope.symbols()
            if each is not symbol and each.kind == "variable" and wanted(each)
        ]
        return nearest(symbol.name, others)


def _own_reads(facts: MintFacts) -> dict[Symbol, int]:
    """Count the reads of each variable that only compute its own next value.

    In `n = n + 1`, for example, `n` is such a read.
    """
    found: dict[Symbol, int] = {}
    for node in facts.of_kind(nodes.Assign):
        if type(node.target) is not nodes.Name or node.target.args is not None:
            continue
        symbol = meaning(node.target)
        symbols = [meaning(each) for each in walk(node.values) if type(each) is nodes.Name]
        # A sub may print its argument or use it in another way.
        is_called = any(each is not None and each.kind == "sub" for each in symbols)
        if symbol is not None and symbol in symbols and not is_called:
            found[symbol] = found.get(symbol, 0) + symbols.count(symbol)
    return found


def check_tasks(facts: MintFacts, add: Add) -> None:
    """Report axes that two tasks command without any coordination in the program."""
    if _are_coordinated(facts):
        return
    main = facts.names.main
    tasks = [function for function in facts.functions if function.kind == "task"]
    first: dict[Key, Function] = {}
    for task in tasks:
        if _is_coordinated(facts, task):
            continue
        for key in sorted(_axes(facts, task), key=str):
            if key in first:
                _two(facts, task, first[key], key, add)
            elif key in _after_run(facts, main, task):
                _two(facts, task, main, key, add)
            first.setdefault(key, task)


def _axes(facts: MintFacts, function: Function) -> set[Key]:
    return facts.touched(function, _COMMANDS) - {None}


def _are_coordinated(facts: MintFacts) -> bool:
    symbols = [symbol for function in facts.functions for symbol in function.scope.names.values()]
    if any(symbol.kind == "variable" and symbol.type.name == SEMAPHORE for symbol in symbols):
        return True
    if any(row.verb in _COORDINATION for row in facts.used):
        return True
    return any(node.name is not None for node in facts.of_kind(nodes.End))


def _is_coordinated(facts: MintFacts, task: Function) -> bool:
    """True if the task tests a shared variable, through which others can control it."""
    for part in facts.called(task):
        for node in walk(part.body if isinstance(part, Function) else ()):
            condition = getattr(node, "condition", None)
            for name in walk([condition]) if condition is not None else ():
                symbol = name.symbol if type(name) is nodes.Name else None
                if symbol is not None and symbol.shared:
                    return True
    return False


def _after_run(facts: MintFacts, main: Function, task: Function) -> set[Key]:
    """Return the axes that the parent task may command after it has started a task."""
    begin = [
        p
        for p, node in facts.nodes_of(main)
        if type(node) is nodes.Run and node.name.lower() == task.name.lower()
    ]
    found: set[Key] = set()
    for p in facts.graph.reached_within(*begin):
        for act in facts.acts.get(p, ()):
            if act.role in _COMMANDS:
                found.update(act.axes)
            elif act.callee:
                found.update(facts.outer(act, key) for key in facts.touched(facts.callee(act), _COMMANDS))
    return found


def _two(facts: MintFacts, task: Function, other: Function, key: Key, add: Add) -> None:
    at = next(
        act.at
        for function in facts.called(task)
        for act in facts.acts_of[function]
        if act.role in _COMMANDS
        and (key in act.axes or None in act.axes or any(isinstance(k, str) for k in act.axes))
    )
    who = "the parent" if other.kind == "main" else f"the task {other.name}"
    add("two-tasks", f"axis {key} is commanded by the task {task.name} and by {who}", at,
        "command it from one task, or synchronise the tasks")  # fmt: skip
