"""Keyword rows that are no business of the controller's: tasks, events, errors and the terminal."""

from __future__ import annotations

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable

    from motionlang.mint.runtime.binding import Row
    from motionlang.mint.runtime.environment import Environment

    Operation = Callable[..., object]


# ---------------------------------------------------------------------------------------------------- tasks


def _read_task_priority(environment: Environment, row: Row) -> Operation:
    return lambda name: environment.priorities.get(name, 0)


def _write_task_priority(environment: Environment, row: Row) -> Operation:
    def write(name: str, value: int) -> None:
        row.check(value)
        environment.priorities[name] = value
        if name in environment.tasks:
            environment.tasks[name].priority = value

    return write


def _read_task_quantum(environment: Environment, row: Row) -> Operation:
    return lambda name: environment.quanta.get(name, 100)


def _write_task_quantum(environment: Environment, row: Row) -> Operation:
    def write(name: str, value: int) -> None:
        row.check(value)
        environment.quanta[name] = value

    return write


def _read_task_status(environment: Environment, row: Row) -> Operation:
    def read(name: str) -> int:
        task = environment.tasks.get(name)
        return 0 if task is None or task.done else 2 if task.suspended else 1

    return read


def _do_task_suspend(environment: Environment, row: Row) -> Operation:
    return lambda name: environment.suspend(name, True)


def _do_task_resume(environment: Environment, row: Row) -> Operation:
    return lambda name: environment.suspend(name, False)


# --------------------------------------------------------------------------------------------------- events


def _read_timer_event(environment: Environment, row: Row) -> Operation:
    return lambda: environment.events.timer


def _write_timer_event(environment: Environment, row: Row) -> Operation:
    def write(value: int) -> None:
        row.check(value)
        environment.events.set_timer(value)

    return write


def _read_event_active(environment: Environment, row: Row) -> Operation:
    return lambda: environment.events.bits(environment.events.active)


def _read_event_pending(environment: Environment, row: Row) -> Operation:
    return lambda: environment.events.bits(environment.events.pending)


def _read_event_disable(environment: Environment, row: Row) -> Operation:
    return lambda: environment.events.disabled


def _write_event_disable(environment: Environment, row: Row) -> Operation:
    return environment.events.disable


# --------------------------------------------------------------------------------------------------- errors


def _read_error_code(environment: Environment, row: Row) -> Operation:
    errors = environment.errors
    return lambda: errors.register().number


def _read_error_line(environment: Environment, row: Row) -> Operation:
    return environment.errors.line


def _read_error_string(environment: Environment, row: Row) -> Operation:
    errors = environment.errors
    return lambda: errors.register().text


def _read_error_data(environment: Environment, row: Row) -> Operation:
    errors = environment.errors

    def read(number: int) -> int:
        data = errors.register().data
        return data[number - 1] if 1 <= number <= len(data) else 0

    return read


def _read_error_present(environment: Environment, row: Row) -> Operation:
    return environment.errors.present


def _read_error_read_next(environment: Environment, row: Row) -> Operation:
    return environment.errors.read_next


def _read_error_read_code(environment: Environment, row: Row) -> Operation:
    return environment.errors.read_code


def _read_error_text(environment: Environment, row: Row) -> Operation:
    from motionlang.mint.runtime.errors import text_of

    return text_of


def _do_error_clear(environment: Environment, row: Row) -> Operation:
    return environment.errors.clear
