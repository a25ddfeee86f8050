"""Random polling programs: tasks, an event, subs, Goto, and a scenario of inputs; one to three tasks."""

from __future__ import annotations

from random import Random

# A duration without a period that is its multiple: at a tie, rounding decides the first statement.
COST = 0.7310585e-5

_HEAD = """\
Dim g As Integer, h As Integer, q As Float
Dim a(4) As Integer, sem As Semaphore, clock As Time
TIME = 0
SPEED(0) = 50 : ACCEL(0) = 500 : DECEL(0) = 500
"""
_SUBS = """\
Sub Act(ByVal k As Integer)
  PRINT "act ", k, " ", TIME
End Sub
Sub Look()
  If INX(1) Then g = 1 Else g = 0
End Sub
Function Counted(ByVal level As Float) As Float
  q = q + 1
  Counted = level
End Function
Function Late(ByVal level As Float) As Float
  WAIT = 1
  Late = level
End Function
Function Ready() As Integer
  Ready = INX(2) And g
End Function
"""
_CONDITIONS = (
    "INX(0)", "INX(1) = 0", "INX(2) And g", "TIME > 40", "TIME > 700", "IDLE(0)", "Not IDLE(0)", "POS(0) > 12",
    "clock > 300", "h > 0", "POS(0) > TIME / 100", "Ready()",
    "POS(0) > Counted(4)", "TIME > Counted(500)", "POS(0) < Late(11)", "COMMS(1) > 0", "POS(0) + 1 < q", "OUTX(3)",
    "VEL(0) > 30", "VEL(0) = 0", "VELDEMAND(0) < 49.5", "ABS(FOLERROR(0)) > 5", "AUXENCODER(0) > 20",
    "TIME - 40 > h", "500 < TIME + 20 - h", "ABS(POS(0) - POSTARGET(0)) < 3", "POSTARGET(0) - POS(0) > 2",
    "2 - (h - POS(0)) > 5", "ABS(3 - POS(0)) > 4", "ABS(h - (9 - POS(0)) + 2) > 4", "POSTARGETLAST(0) = POS(0)",
    "COMMS(2) > 9", "COMMS(3) > q",
)  # fmt: skip
_ACTS = (
    'PRINT "acted ", TIME', "OUTX(3) = 1", "OUTX(3) = 0", "g = 1 - g", "h = h + 1", "TIME = 0",
    "PAUSE IDLE(0)", "PAUSE INX(1) Or TIME > 300",
    "EVENTDISABLE = 0xFFFF", "EVENTDISABLE = 0", "TIMEREVENT = 45",
    "FEEDRATEOVERRIDE(0) = 50", "STOP(0)", "MOVER(0) = 5 : GO(0)", "COMMS(1) = h",
    "Act(3)", "clock = 0", "a(2) = a(1) + 1", "WAIT = 17", "JOG(0) = 20 * INX(1)",
)  # fmt: skip
# With a second task, which they control; and a semaphore.
_TASK_ACTS = (
    "TASKQUANTUM(T1) = 20", "TASKQUANTUM(T1) = 130", "TASKPRIORITY(T1) = 1", "TASKPRIORITY(T1) = 0",
    "TASKSUSPEND(T1)", "TASKRESUME(T1)", "Run T1", "End T1", "sem = 1", "sem = 0",
)  # fmt: skip
_LOOPS = (
    ("Loop", "End Loop"),
    ("While TIME < 2500", "End While"),
    ("While INX(3) = 0", "End While"),
    ("Repeat", "Until 0"),
    ("Repeat", "Until INX(3) Or TIME > 2500"),
)


def program(seed: int) -> tuple[str, dict[str, object]]:
    """Return a program and its machine."""
    random = Random(seed)
    tasks = random.choice((1, 1, 2, 2, 3))
    lines = [_HEAD]
    if random.random() < 0.3:
        lines += [f"TIMEREVENT = {random.choice((70, 333, 500))}"]
        lines += ["Event TIMER", "  h = h + 1", "End Event"]
    lines += [f"Run T{k}" for k in range(1, tasks)]
    lines += [
        f"Dim s{k} As Integer, x{k} As Integer, i{k} As Integer, n{k} As Integer, p{k} As Float, v{k} As Float"
        for k in range(tasks)
    ]
    acts = _ACTS if tasks == 1 else _ACTS + _TASK_ACTS
    lines += _loop(random, 0, acts)
    lines += [
        'PRINT "end ", TIME, g, h, a(1), a(2), a(3), " ", n0, " ", p0, " ", v0, " ", COMMS(2), COMMS(3)'
    ]
    for k in range(1, tasks):
        lines += [f"Task T{k}", *_loop(random, k, acts), "End Task"]
    machine: dict[str, object] = {
        "controller.instruction_time": COST,
        "encoder": [{"aux": 0, "velocity": 45.0}],
    }
    entries = [_input(random) for _ in range(random.randint(0, 6))]
    return "\n".join([*lines, _SUBS]), machine | ({"input": entries} if entries else {})


def _input(random: Random) -> dict[str, object]:
    entry: dict[str, object] = {"channel": random.randint(0, 3), "at": round(random.uniform(0, 2.5), 4)}
    return entry | ({"for": round(random.uniform(0.001, 0.8), 4)} if random.random() < 0.6 else {})


def _loop(random: Random, k: int, acts: tuple[str, ...]) -> list[str]:
    body = _statements(random, k, acts)
    if k == 0 and random.random() < 0.2:
        return ["again:", *body, f"If {random.choice(('1', 'TIME < 2500', 'INX(3) = 0'))} Then Goto again"]
    first, last = random.choice(_LOOPS)
    return [first, *body, last]


def _statements(random: Random, k: int, acts: tuple[str, ...]) -> list[str]:
    """Return statements that mostly read or repeat, with only a few actions."""
    out: list[str] = []
    for _ in range(random.randint(1, 4)):
        kind, condition = random.randrange(18), random.choice(_CONDITIONS)
        if kind < 5:
            act = random.choice(acts)
            out += [
                f"If {condition} And s{k} < {random.randint(1, 6)} Then",
                f"s{k} = s{k} + 1",
                act,
                "End If",
            ]
        elif kind == 5:
            out += [f"For i{k} = 1 To 3", f"a(i{k}) = INX(i{k})", "Next"]
        else:
            channel = random.randint(0, 3)
            out += [
                (f"x{k} = INX({channel})", "Look()", f"OUTX(4) = INX({channel})", "q = POS(0)",
                 f"WAIT = {random.randint(1, 30)}", f"If {condition} Then x{k} = 3", f"x{k} = {channel}",
                 f"If {condition} Then n{k} = n{k} + 2", f"If POS(0) > p{k} Then p{k} = POS(0)",
                 f"If v{k} <= VEL(0) Then v{k} = VEL(0)", "STOP(0)", f"COMMS({k + 2}) = POS(0) - {k}")[kind - 6]
            ]  # fmt: skip
    return out
