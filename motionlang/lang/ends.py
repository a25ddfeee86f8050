"""Options that end a wait: `--input 2=1@0.5`, `--answer TEXT`, `--keys`.

They are suggested for a wait that nothing else can end. The wait itself may state its purpose; if it does
not, the condition at its source offset is analysed.
"""

from __future__ import annotations

TYPE_CHECKING = False
if TYPE_CHECKING:
    from motionlang.lang.dialect import Dialect
    from motionlang.lang.loop_dependencies import Read
    from motionlang.lang.machine.machine import Machine
    from motionlang.lang.task import Task
    from motionlang.lang.waits import Wait
    from motionlang.source import Source

# Seconds from now at which the suggested option acts.
SOON = 0.5
# A hint names so many inputs.
MAX_NAMED = 3


def what_ends(
    dialect: Dialect, source: Source, machine: Machine, task: Task, wait: Wait, at_prompt: bool = False
) -> str:
    """Return a hint with the option to type, or "" if no option ends the wait.

    `at_prompt` is for the interactive prompt, whose commands have the names of the options and count time
    from now.
    """
    dash, now = (".", 0.0) if at_prompt else ("--", machine.clock.now)
    at = f"{round(now + SOON, 1):g}"
    driven = dialect.driven_by(wait.why)
    leaves = _reads(dialect, source, task, wait)
    channels = sorted(number for kind, number in leaves if kind == "input" and number is not None)
    options = []
    if channels:
        levels = machine.controller.inputs
        options += [f"{dash}input {each}={int(not levels[each])}@{at}" for each in channels[:MAX_NAMED]]
        driven = driven or ["input"]
    if wait.cause == "operator":
        question = machine.operator.question.strip(" ?:")
        options.append(f'{dash}answer "{question}=1"' if question else f"{dash}answer 1")
        driven = ["answer"]
    elif "key" in driven:
        options.append(f"{dash}keys R@{at}")
    elif "analogue" in driven:
        channel = next((n for kind, n in leaves if kind == "analogue" and n is not None), 0)
        options.append(f"{dash}analog {channel}=25@{at}")
    entries = " or ".join(each if "." in each else f"[[{each}]]" for each in driven)
    if options:
        verbs = ("ends", "does") if len(options) == 1 else ("end", "do")
        return f"{' '.join(options)} {verbs[0]} it, as {verbs[1]} {entries} of the machine file"
    if any("." in each for each in driven):
        return f"the machine file says where it is: {entries}"
    return f"{entries} of the machine file says when it comes" if entries else ""


def _reads(dialect: Dialect, source: Source, task: Task, wait: Wait) -> frozenset[Read]:
    """Return the values that the condition of a wait reads."""
    if wait.cause == "input" and wait.what:
        return frozenset(("input", channel) for channel in wait.what)
    if not source.text.strip():
        return frozenset()
    found = dialect.loop_dependencies(source)(task.at)
    return frozenset() if found is None else found.leaves
