"""Two tasks, or a task and its parent, command the same axis without any coordination.

A Semaphore, a keyword that asks for the state of a task or suspends it, and `End task` coordinate the tasks of a
program. A task that tests a shared variable may be controlled by others.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from motionlang.commands.check.rule import Rule, RuleCase, Warn
from motionlang.kernel.mint.resolve.symbols import SEMAPHORE, Function
from motionlang.kernel.mint.syntax import nodes
from motionlang.kernel.mint.syntax.traversal import walk

if TYPE_CHECKING:
    from collections.abc import Iterable, Iterator

    from motionlang.commands.check.mccl.mccl_facts import MacroFacts
    from motionlang.commands.check.mint.mint_facts import MintFacts
    from motionlang.kernel.lang import AxisKey as Key
    from motionlang.kernel.lang import Use

_COMMANDS = frozenset(("move", "entry", "course", "path", "go", "act"))
_COMMANDS_MCCL = frozenset(("start", "run", "act"))
_COORDINATION_MCCL = frozenset(("store", "end_task"))
# Verbs of the keywords by which tasks coordinate.
_COORDINATION = frozenset(("task_status", "task_suspend", "task_resume"))


def check_mint(facts: MintFacts, warn: Warn) -> None:
    if _are_coordinated(facts):
        return
    main = facts.names.main
    first: dict[Key, Function] = {}
    for task in (function for function in facts.functions if function.kind == "task"):
        if _is_coordinated(facts, task):
            continue
        for key in sorted(facts.touched(task, _COMMANDS) - {None}, key=str):
            other = first.setdefault(key, task)
            if other is not task:
                _report(facts, task, f"the task {other.name}", key, warn)
            elif key in _after_run(facts, main, task):
                _report(facts, task, "the parent", key, warn)


def _report(facts: MintFacts, task: Function, who: str, key: Key, warn: Warn) -> None:
    at = next(
        act.at
        for function in facts.called(task)
        for act in facts.acts_of[function]
        if act.role in _COMMANDS
        and (key in act.axes or None in act.axes or any(isinstance(k, str) for k in act.axes))
    )
    message = f"axis {key} is commanded by the task {task.name} and by {who}"
    warn(message, at, "command it from one task, or synchronise the tasks")


def _are_coordinated(facts: MintFacts) -> bool:
    symbols = [symbol for function in facts.functions for symbol in function.scope.names.values()]
    if any(symbol.kind == "variable" and symbol.type.name == SEMAPHORE for symbol in symbols):
        return True
    if any(row.function in _COORDINATION for row in facts.used):
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


def check_mccl(facts: MacroFacts, warn: Warn) -> None:
    """Report a background task and the foreground that command an axis; a shared register may coordinate them."""
    if any(command.function in _COORDINATION_MCCL for command, _ in facts.commands):
        return
    for task in (part for part in facts.parts if part.kind == "task"):
        axes = _axes_of(facts.acts_of[task])
        for p, statement in facts.statements_of(facts.parts[0]):
            if task.name not in statement.starts:
                continue
            for key in sorted(axes & _axes_of(_behind(facts, p)), key=str):
                at = next(
                    act.at for act in facts.acts_of[task] if act.role in _COMMANDS_MCCL and key in act.axes
                )
                message = f"axis {key} is commanded by the background {task.name} and by the foreground"
                warn(message, at, "command it from one task, or let one wait for the other")


def _behind(facts: MacroFacts, p: int) -> Iterator[Use]:
    """Yield what follows the start of a task before the next wait."""
    seen: set[int] = set()
    stack = list(facts.graph.within[p])
    while stack:
        q = stack.pop()
        statement = facts.statement_at.get(q)
        if q not in seen and not (statement is not None and statement.waits):
            seen.add(q)
            yield from facts.acts.get(q, ())
            stack += facts.graph.within[q]


def _axes_of(uses: Iterable[Use]) -> set[Key]:
    return {key for use in uses if use.role in _COMMANDS_MCCL for key in use.axes} - {None}


RULE = Rule(
    code="two-tasks",
    text="""\
Two tasks command moves of the same axis; or a task and its parent do, after the parent has started the task. There is
no warning if the program makes them take turns: by a Semaphore, by TASKSTATUS, TASKSUSPEND or `End task`, or by a
variable that the task checks before it moves.

In MCCL: a macro that GT runs in the background moves an axis that the foreground commands before its next wait. There
is no warning if the file stores a register or ends a task.
""",
    fix="let one task command the axis, or use a Semaphore",
    mint=RuleCase(
        check_mint,
        wrong=("Run Feed\nMOVER(0) = 5 : GO(0)\nTask Feed\n  MOVER(0) = 9 : GO(0)\nEnd Task\n"),
        right=("Run Feed\nMOVER(0) = 5 : GO(0)\nTask Feed\n  MOVER(1) = 9 : GO(1)\nEnd Task\n"),
    ),
    mccl=RuleCase(
        check_mccl,
        wrong="MD1,1MR100,1WS\n1MN,2MN\nGT1,1MR50,1WS\n",
        right="MD1,1MR100,1WS\n1MN,2MN\nGT1,2MR50,2WS\n",
    ),
)
