"""Tasks, events and errors: keywords that do not involve the controller."""

from __future__ import annotations

from motionlang.kernel.lang.keyword import Actions, Keyword
from motionlang.kernel.mint.runtime.binding import of
from motionlang.kernel.mint.runtime.environment import Environment
from motionlang.kernel.mint.runtime.errors import Errors, text_of
from motionlang.kernel.mint.runtime.events import Events


def write_priority(environment: Environment, name: str, value: int) -> None:
    """TASKPRIORITY: set the priority of a task, whether it runs yet or not."""
    environment.priorities[name] = value
    if name in environment.by_name:
        environment.by_name[name].priority = value


def write_quantum(environment: Environment, name: str, value: int) -> None:
    """TASKQUANTUM: set the quantum of a task, whether it runs yet or not."""
    environment.quanta[name] = value
    if name in environment.by_name:
        environment.by_name[name].set_time_slice()


def read_status(environment: Environment, name: str) -> int:
    task = environment.by_name.get(name)
    return 0 if task is None or task.done else 2 if task.suspended else 1


def read_data(errors: Errors, number: int) -> int:
    """ERRDATA: return a data value of the error, 0 beyond the last one."""
    data = errors.register().data
    return data[number - 1] if 1 <= number <= len(data) else 0


def suspend(environment: Environment, name: str, hold: bool = True) -> None:
    """Suspend a task (`hold`) or resume it.

    A task that suspends itself stops at its next time slice.
    """
    task = environment.by_name.get(name)
    if task is None or task.done or task.suspended is hold:
        return
    task.suspended = hold
    if hold and task is environment.task:
        environment.clock.at(environment.clock.now, lambda: None)  # all tasks check again
    elif hold:
        task.suspended_wait, task.wait = task.wait, task.never()
    else:
        task.wait, task.suspended_wait = task.suspended_wait, None


# ------------------------------------------------------------------------------------------------- keywords

_TASK_PRIORITY = Actions(
    read=of(Environment, lambda e, name: e.priorities.get(name, 0)), write=of(Environment, write_priority)
)
_TASK_QUANTUM = Actions(
    read=of(Environment, lambda e, name: e.quanta.get(name, 100)), write=of(Environment, write_quantum)
)
_TIMER_EVENT = Actions(
    "timer_event", read=of(Events, lambda events: events.timer), write=of(Events, Events.set_timer)
)
_EVENT_DISABLE = Actions(read=of(Events, lambda events: events.disabled), write=of(Events, Events.disable))

_BLINK = "\nWAIT = 50\nEnd\nTask Blink\n  Loop\n    WAIT = 20\n  End Loop\nEnd Task"
_TICK = '\nWAIT = 50\nEnd\nEvent TIMER\n  PRINT "tick"\nEnd Event'
_FAIL = '\nEnd\nEvent ONERROR\n  PRINT ERRCODE, " ", ERRLINE, " ", ERRSTRING\n  ERRORCLEAR(0, 0)\nEnd Event'


ROWS = (
    Keyword("TASKPRIORITY", "", "setting", "RW", "task", "integer", _TASK_PRIORITY,
            "Priority of a task; ParentTask is the main program. Of several ready tasks the one with the highest "
            "number runs.",
            f"TASKPRIORITY(Blink) = 2\nRun Blink\nPRINT TASKPRIORITY(Blink){_BLINK}",
            default=0.0, low=0, high=255, group="tasks"),
    Keyword("TASKQUANTUM", "", "setting", "RW", "task", "integer", _TASK_QUANTUM,
            "Number of statements that a task executes in one time slice.",
            f"TASKQUANTUM(Blink) = 10\nRun Blink\nPRINT TASKQUANTUM(Blink){_BLINK}",
            default=100.0, low=1, high=65535, group="tasks"),
    Keyword("TASKSTATUS", "", "reading", "R", "task", "integer",
            Actions("task_status", read=of(Environment, read_status)),
            "0 when a task is not running, 1 when it is, 2 when it is suspended.",
            f"Run Blink\nPRINT TASKSTATUS(Blink){_BLINK}", default=0.0, group="tasks"),
    Keyword("TASKSUSPEND", "", "command", "C", "task", "", Actions("task_suspend", do=of(Environment, suspend)),
            "Hold a task until TASKRESUME.",
            f"Run Blink\nTASKSUSPEND(Blink)\nPRINT TASKSTATUS(Blink){_BLINK}", group="tasks"),
    Keyword("TASKRESUME", "", "command", "C", "task", "",
            Actions("task_resume", do=of(Environment, lambda e, name: suspend(e, name, False))),
            "Let a suspended task go on.",
            f"Run Blink\nTASKSUSPEND(Blink)\nTASKRESUME(Blink)\nPRINT TASKSTATUS(Blink){_BLINK}", group="tasks"),
    Keyword("TIMEREVENT", "", "setting", "RW", "none", "integer", _TIMER_EVENT,
            "Period of the event TIMER in milliseconds; 0 switches it off.",
            f"TIMEREVENT = 20{_TICK}", default=0.0, low=0, high=2147483647, group="events"),
    Keyword("EVENTACTIVE", "", "reading", "R", "none", "bits",
            Actions(read=of(Events, lambda events: events.bits(events.active))),
            "Bit pattern of the events that are being handled.",
            "PRINT EVENTACTIVE", default=0.0, group="events"),
    Keyword("EVENTPENDING", "", "reading", "R", "none", "bits",
            Actions(read=of(Events, lambda events: events.bits(events.pending))),
            "Bit pattern of the events that wait to be handled.",
            "PRINT EVENTPENDING", default=0.0, group="events"),
    Keyword("EVENTDISABLE", "", "setting", "RW", "none", "bits", _EVENT_DISABLE,
            "Bit pattern of the events that must wait, bit 5 the timer.",
            f"EVENTDISABLE = 0x20\nTIMEREVENT = 20\nWAIT = 30\nPRINT EVENTPENDING\nEVENTDISABLE = 0{_TICK}",
            default=0.0, group="events"),
    Keyword("ERRCODE", "", "reading", "R", "none", "integer",
            Actions(read=of(Errors, lambda errors: errors.register().number)),
            "Number of the error that was read last, or that has called ONERROR since.",
            f"ACCEL(0) = 0\nMOVER(0) = 1\nGO(0){_FAIL}", group="errors"),
    Keyword("ERRLINE", "", "reading", "R", "none", "integer", Actions(read=of(Errors, Errors.line)),
            "Line of the program of the error that was read last, or that has called ONERROR since.",
            f"ACCEL(0) = 0\nMOVER(0) = 1\nGO(0){_FAIL}", group="errors"),
    Keyword("ERRSTRING", "", "reading", "R", "none", "text",
            Actions(read=of(Errors, lambda errors: errors.register().text)),
            "Text of the error that was read last, or that has called ONERROR since.",
            f"ACCEL(0) = 0\nMOVER(0) = 1\nGO(0){_FAIL}", group="errors"),
    Keyword("ERRDATA", "", "reading", "R", "index", "integer", Actions(read=of(Errors, read_data)),
            "Data of the error that was read last: of an axis error 1 is the axis, 2 its error bits.",
            'ABORT\nWhile ERRORREADNEXT(_egAXIS, 0)\n  PRINT ERRDATA(1), " ", ERRDATA(2)\nEnd While', group="errors"),
    Keyword("ERRORPRESENT", "", "reading", "R", "group, data", "bool", Actions(read=of(Errors, Errors.present)),
            "True if a group of errors has any; data is the axis of the group _egAXIS.",
            "PRINT ERRORPRESENT(_egALL, 0)", group="errors"),
    Keyword("ERRORREADNEXT", "", "reading", "R", "group, data", "bool", Actions(read=of(Errors, Errors.read_next)),
            "Read the next error of a group into ERRCODE, ERRLINE, ERRSTRING and ERRDATA; 0 when there is none.",
            "PRINT ERRORREADNEXT(_egALL, 0)", group="errors"),
    Keyword("ERRORREADCODE", "", "reading", "R", "code, data", "bool", Actions(read=of(Errors, Errors.read_code)),
            "Read an error of a given number into the registers; 0 when there is none.",
            "PRINT ERRORREADCODE(3, 0)", group="errors"),
    Keyword("ERRORCLEAR", "", "command", "C", "group, data", "", Actions(do=of(Errors, Errors.clear)),
            "Forget the errors of a group, those of an axis on the axis too.",
            "ABORT\nERRORCLEAR(_egALL, 0)\nPRINT AXISERROR(0)", group="errors"),
    Keyword("ERRORSTRING", "", "reading", "R", "code", "text", Actions(read=lambda environment, row: text_of),
            "The text of an error's number.",
            "PRINT ERRORSTRING(40)", group="errors"),
)  # fmt: skip
