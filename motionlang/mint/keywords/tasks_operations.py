"""Tasks, events and errors: nothing of it concerns the controller."""

from __future__ import annotations

from motionlang.mint.runtime.errors import text_of

TYPE_CHECKING = False
if TYPE_CHECKING:
    from motionlang.mint.runtime.binding import Operation, Row
    from motionlang.mint.runtime.environment import Environment


def read_task_priority(environment: Environment, row: Row) -> Operation:
    return lambda name: environment.priorities.get(name, 0)


def write_task_priority(environment: Environment, row: Row) -> Operation:
    """TASKPRIORITY, of a task that runs and of one that is started later."""

    def write(name: str, value: int) -> None:
        environment.priorities[name] = value
        if name in environment.tasks:
            environment.tasks[name].priority = value

    return write


def read_task_quantum(environment: Environment, row: Row) -> Operation:
    return lambda name: environment.quanta.get(name, 100)


def write_task_quantum(environment: Environment, row: Row) -> Operation:
    def write(name: str, value: int) -> None:
        environment.quanta[name] = value

    return write


def read_task_status(environment: Environment, row: Row) -> Operation:
    def read(name: str) -> int:
        task = environment.tasks.get(name)
        return 0 if task is None or task.done else 2 if task.suspended else 1

    return read


def do_task_suspend(environment: Environment, row: Row) -> Operation:
    return lambda name: _suspend(environment, name, True)


def do_task_resume(environment: Environment, row: Row) -> Operation:
    return lambda name: _suspend(environment, name, False)


def read_timer_event(environment: Environment, row: Row) -> Operation:
    return lambda: environment.events.timer


def write_timer_event(environment: Environment, row: Row) -> Operation:
    def write(value: int) -> None:
        environment.events.set_timer(value)

    return write


def read_event_active(environment: Environment, row: Row) -> Operation:
    return lambda: environment.events.bits(environment.events.active)


def read_event_pending(environment: Environment, row: Row) -> Operation:
    return lambda: environment.events.bits(environment.events.pending)


def read_event_disable(environment: Environment, row: Row) -> Operation:
    return lambda: environment.events.disabled


def write_event_disable(environment: Environment, row: Row) -> Operation:
    return environment.events.disable


def read_error_code(environment: Environment, row: Row) -> Operation:
    errors = environment.errors
    return lambda: errors.register().number


def read_error_line(environment: Environment, row: Row) -> Operation:
    return environment.errors.line


def read_error_string(environment: Environment, row: Row) -> Operation:
    errors = environment.errors
    return lambda: errors.register().text


def read_error_data(environment: Environment, row: Row) -> Operation:
    """ERRDATA: 0 beyond the last of the error."""
    errors = environment.errors

    def read(number: int) -> int:
        data = errors.register().data
        return data[number - 1] if 1 <= number <= len(data) else 0

    return read


def read_error_present(environment: Environment, row: Row) -> Operation:
    return environment.errors.present


def read_error_read_next(environment: Environment, row: Row) -> Operation:
    return environment.errors.read_next


def read_error_read_code(environment: Environment, row: Row) -> Operation:
    return environment.errors.read_code


def read_error_text(environment: Environment, row: Row) -> Operation:
    return text_of


def do_error_clear(environment: Environment, row: Row) -> Operation:
    return environment.errors.clear


def _suspend(environment: Environment, name: str, hold: bool) -> None:
    """Hold a task, or let it go on; one that holds itself is held at its next turn."""
    task = environment.tasks.get(name)
    if task is None or task.done or task.suspended is hold:
        return
    task.suspended = hold
    if hold and task is environment.task:
        environment.clock.at(environment.clock.now, lambda: None)  # everybody looks around
    elif hold:
        task.held, task.wait = task.wait, task.never()
    else:
        task.wait, task.held = task.held, None


OPERATIONS = {
    "task_priority": {"read": read_task_priority, "write": write_task_priority},
    "task_quantum": {"read": read_task_quantum, "write": write_task_quantum},
    "task_status": {"read": read_task_status},
    "task_suspend": {"do": do_task_suspend},
    "task_resume": {"do": do_task_resume},
    "timer_event": {"read": read_timer_event, "write": write_timer_event},
    "event_active": {"read": read_event_active},
    "event_pending": {"read": read_event_pending},
    "event_disable": {"read": read_event_disable, "write": write_event_disable},
    "error_code": {"read": read_error_code},
    "error_line": {"read": read_error_line},
    "error_string": {"read": read_error_string},
    "error_data": {"read": read_error_data},
    "error_present": {"read": read_error_present},
    "error_read_next": {"read": read_error_read_next},
    "error_read_code": {"read": read_error_read_code},
    "error_text": {"read": read_error_text},
    "error_clear": {"do": do_error_clear},
}
