"""Tasks, events and errors: nothing of it concerns the controller."""

from __future__ import annotations

from motionlang.mint.runtime.binding import of
from motionlang.mint.runtime.environment import Environment
from motionlang.mint.runtime.errors import Errors, text_of
from motionlang.mint.runtime.events import Events


def write_priority(environment: Environment, name: str, value: int) -> None:
    """TASKPRIORITY, of a task that runs and of one that is started later."""
    environment.priorities[name] = value
    if name in environment.tasks:
        environment.tasks[name].priority = value


def write_quantum(environment: Environment, name: str, value: int) -> None:
    """TASKQUANTUM, likewise."""
    environment.quanta[name] = value
    if name in environment.tasks:
        environment.tasks[name].set_turn()


def read_status(environment: Environment, name: str) -> int:
    task = environment.tasks.get(name)
    return 0 if task is None or task.done else 2 if task.suspended else 1


def read_data(errors: Errors, number: int) -> int:
    """ERRDATA: 0 beyond the last of the error."""
    data = errors.register().data
    return data[number - 1] if 1 <= number <= len(data) else 0


def suspend(environment: Environment, name: str, hold: bool = True) -> None:
    """Hold a task, or let it go on; one that holds itself is held at its next turn."""
    task = environment.tasks.get(name)
    if task is None or task.done or task.suspended is hold:
        return
    task.suspended = hold
    scheduler = environment.machine.scheduler
    if scheduler is not None:
        scheduler.stir()
    if hold and task is environment.task:
        environment.clock.at(environment.clock.now, lambda: None)  # everybody looks around
    elif hold:
        task.held, task.wait = task.wait, task.never()
    else:
        task.wait, task.held = task.held, None


OPERATIONS = {
    "task_priority": {
        "read": of(Environment, lambda e, name: e.priorities.get(name, 0)),
        "write": of(Environment, write_priority),
    },
    "task_quantum": {
        "read": of(Environment, lambda e, name: e.quanta.get(name, 100)),
        "write": of(Environment, write_quantum),
    },
    "task_status": {"read": of(Environment, read_status)},
    "task_suspend": {"do": of(Environment, suspend)},
    "task_resume": {"do": of(Environment, lambda e, name: suspend(e, name, False))},
    "timer_event": {"read": of(Events, lambda events: events.timer), "write": of(Events, Events.set_timer)},
    "event_active": {"read": of(Events, lambda events: events.bits(events.active))},
    "event_pending": {"read": of(Events, lambda events: events.bits(events.pending))},
    "event_disable": {
        "read": of(Events, lambda events: events.disabled),
        "write": of(Events, Events.disable),
    },
    "error_code": {"read": of(Errors, lambda errors: errors.register().number)},
    "error_line": {"read": of(Errors, Errors.line)},
    "error_string": {"read": of(Errors, lambda errors: errors.register().text)},
    "error_data": {"read": of(Errors, read_data)},
    "error_present": {"read": of(Errors, Errors.present)},
    "error_read_next": {"read": of(Errors, Errors.read_next)},
    "error_read_code": {"read": of(Errors, Errors.read_code)},
    "error_text": {"read": lambda environment, row: text_of},
    "error_clear": {"do": of(Errors, Errors.clear)},
}
