"""Tasks, events and errors."""

from __future__ import annotations

from motionlang.lang.keyword import Keyword

_TUTORIAL = "Mint programming tutorial, part 5"
_LIBRARY = "Mint type library"
_BLINK = "\nWAIT = 50\nEnd\nTask Blink\n  Loop\n    WAIT = 20\n  End Loop\nEnd Task"
_TICK = '\nWAIT = 50\nEnd\nEvent TIMER\n  PRINT "tick"\nEnd Event'
_FAIL = '\nEnd\nEvent ONERROR\n  PRINT ERRCODE, " ", ERRLINE, " ", ERRSTRING\n  ERRORCLEAR(0, 0)\nEnd Event'

ROWS = (
    Keyword("TASKPRIORITY", "", "setting", "RW", "task", "integer", "task_priority",
            "Priority of a task, of which ParentTask is the main program: of several that can run, the one with the "
            "highest number does.",
            f"TASKPRIORITY(Blink) = 2\nRun Blink\nPRINT TASKPRIORITY(Blink){_BLINK}",
            default=0.0, low=0, high=255, source=_TUTORIAL, trust="memory", group="tasks"),
    Keyword("TASKQUANTUM", "", "setting", "RW", "task", "integer", "task_quantum",
            "How many statements a task executes before another one gets its turn.",
            f"TASKQUANTUM(Blink) = 10\nRun Blink\nPRINT TASKQUANTUM(Blink){_BLINK}",
            default=100.0, low=1, high=65535, source=_TUTORIAL, trust="manual", group="tasks"),
    Keyword("TASKSTATUS", "", "reading", "R", "task", "integer", "task_status",
            "0 when a task is not running, 1 when it is, 2 when it is suspended.",
            f"Run Blink\nPRINT TASKSTATUS(Blink){_BLINK}",
            default=0.0, source=_TUTORIAL, trust="memory", group="tasks"),
    Keyword("TASKSUSPEND", "", "command", "C", "task", "", "task_suspend",
            "Hold a task until TASKRESUME.",
            f"Run Blink\nTASKSUSPEND(Blink)\nPRINT TASKSTATUS(Blink){_BLINK}",
            source=_TUTORIAL, trust="manual", group="tasks"),
    Keyword("TASKRESUME", "", "command", "C", "task", "", "task_resume",
            "Let a suspended task go on.",
            f"Run Blink\nTASKSUSPEND(Blink)\nTASKRESUME(Blink)\nPRINT TASKSTATUS(Blink){_BLINK}",
            source=_TUTORIAL, trust="memory", group="tasks"),
    Keyword("TIMEREVENT", "", "setting", "RW", "none", "integer", "timer_event",
            "Period of the event TIMER in milliseconds; 0 switches it off.",
            f"TIMEREVENT = 20{_TICK}",
            default=0.0, low=0, high=2147483647, source=_LIBRARY, trust="memory", group="events"),
    Keyword("EVENTACTIVE", "", "reading", "R", "none", "bits", "event_active",
            "Bit pattern of the events that are being handled.",
            "PRINT EVENTACTIVE", default=0.0, source=_LIBRARY, trust="memory", group="events"),
    Keyword("EVENTPENDING", "", "reading", "R", "none", "bits", "event_pending",
            "Bit pattern of the events that wait to be handled.",
            "PRINT EVENTPENDING", default=0.0, source=_LIBRARY, trust="memory", group="events"),
    Keyword("EVENTDISABLE", "", "setting", "RW", "none", "bits", "event_disable",
            "Bit pattern of the events that must wait, bit 5 the timer.",
            f"EVENTDISABLE = 0x20\nTIMEREVENT = 20\nWAIT = 30\nPRINT EVENTPENDING\nEVENTDISABLE = 0{_TICK}",
            default=0.0, source=_LIBRARY, trust="memory", group="events"),
    Keyword("ERRCODE", "", "reading", "R", "none", "integer", "error_code",
            "Number of the error that was read last, or that has called ONERROR since.",
            f"SPEED(0) = 0\nMOVER(0) = 1\nGO(0){_FAIL}", source=_LIBRARY, trust="code", group="errors"),
    Keyword("ERRLINE", "", "reading", "R", "none", "integer", "error_line",
            "Line of the program of the error that was read last, or that has called ONERROR since.",
            f"SPEED(0) = 0\nMOVER(0) = 1\nGO(0){_FAIL}", source=_LIBRARY, trust="code", group="errors"),
    Keyword("ERRSTRING", "", "reading", "R", "none", "text", "error_string",
            "Text of the error that was read last, or that has called ONERROR since.",
            f"SPEED(0) = 0\nMOVER(0) = 1\nGO(0){_FAIL}", source=_LIBRARY, trust="code", group="errors"),
    Keyword("ERRDATA", "", "reading", "R", "index", "integer", "error_data",
            "Data of the error that was read last: of an axis error 1 is the axis, 2 its error bits.",
            'ABORT\nWhile ERRORREADNEXT(_egAXIS, 0)\n  PRINT ERRDATA(1), " ", ERRDATA(2)\nEnd While',
            source=_LIBRARY, trust="code", group="errors"),
    Keyword("ERRORPRESENT", "", "reading", "R", "group, data", "bool", "error_present",
            "Whether a group of errors holds any; data is the axis of the group _egAXIS.",
            "PRINT ERRORPRESENT(_egALL, 0)", source=_LIBRARY, trust="code", group="errors"),
    Keyword("ERRORREADNEXT", "", "reading", "R", "group, data", "bool", "error_read_next",
            "Read the next error of a group into ERRCODE, ERRLINE, ERRSTRING and ERRDATA; 0 when there is none.",
            "PRINT ERRORREADNEXT(_egALL, 0)", source=_LIBRARY, trust="code", group="errors"),
    Keyword("ERRORREADCODE", "", "reading", "R", "code, data", "bool", "error_read_code",
            "Read an error of a given number into the registers; 0 when there is none.",
            "PRINT ERRORREADCODE(3, 0)", source=_LIBRARY, trust="code", group="errors"),
    Keyword("ERRORCLEAR", "", "command", "C", "group, data", "", "error_clear",
            "Forget the errors of a group, those of an axis on the axis too.",
            "ABORT\nERRORCLEAR(_egALL, 0)\nPRINT AXISERROR(0)", source=_LIBRARY, trust="code", group="errors"),
    Keyword("ERRORSTRING", "", "reading", "R", "code", "text", "error_text",
            "The text of an error's number.",
            "PRINT ERRORSTRING(40)", source=_LIBRARY, trust="code", group="errors"),
)  # fmt: skip
