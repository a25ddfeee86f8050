"""One machine, programmed in the styles of the field.

Styles may be added, but never removed or rewritten: the list shows where the cost of a program depends on how it is
written. The programs never end.
"""

from __future__ import annotations

from typing import NamedTuple

# The speed that a style must reach, in multiples of real time; that of one which computes, prints or writes to a host
# in every iteration; and that of one with a simulated motor.
LEAST, LEAST_COMPUTING, LEAST_WITH_MOTOR = 15.0, 5.0, 50.0
COMPUTING = frozenset((
    "filter_task_wait_1", "filter_timer_1", "recipes_search", "watch_comms_position", "watch_comms_pair",
    "watch_net_position", "contours_streamed_6_ms",
))  # fmt: skip

_AXES = "SPEED(0, 1) = 100;\nACCEL(0, 1) = 500;\nDECEL(0, 1) = 500;\n"
_THERE, _BACK = "  MOVEA(0) = 100 : GO(0)\n", "  MOVEA(0) = 0 : GO(0)\n"
_PAUSE = "  PAUSE IDLE(0)\n"
_EVERY_SECOND: dict[str, object] = {"input": [{"channel": 0, "at": 0.7, "for": 0.3, "every": 1.0}]}
_MOTOR: dict[str, object] = {
    "kind": "brushless", "resistance": 1.2, "inductance": 2e-3, "torque_constant": 0.06, "inertia": 3e-5,
    "load_inertia": 5e-5, "amplifier_gain": 6.0,
}  # fmt: skip


class Style(NamedTuple):
    """A program that must reach `least` times real time.

    The suffix of `file` selects the language; `machine` has the settings of the machine file.
    """

    family: str
    file: str
    text: str
    machine: dict[str, object]
    least: float


STYLES: dict[str, Style] = {}


def _add(family: str, name: str, text: str, machine: dict[str, object] | None = None) -> None:
    whole = f"{family}_{name}"
    least = LEAST_COMPUTING if whole in COMPUTING or family == "display" else LEAST
    if family == "motors":
        least = LEAST_WITH_MOTOR
    suffix = "mcl" if family.startswith("mccl") else "mnt"
    STYLES[whole] = Style(family, f"{name}.{suffix}", text, machine or {}, least)


def _cycle(wait: str = _PAUSE, head: str = "", each: str = "  WAIT(500)\n", blocks: str = "") -> str:
    """Return a loop of moves there and back, each followed by `wait`.

    `each` is executed once per cycle; `head` comes before the loop, `blocks` at the end.
    """
    return f"{_AXES}{head}Loop\n{_THERE}{wait}{_BACK}{wait}{each}End Loop\nEnd\n{blocks}"


def _tasks(count: int, body: str, lines: str = "") -> tuple[str, str]:
    """Return the statements that start tasks, and the blocks of these tasks.

    `@` in `body` and `lines` is replaced by the number of the task.
    """
    runs = "".join(f"Run T{k}\n" for k in range(1, count + 1))
    blocks = (
        f"Task T{k}\n{lines}Loop\n{body}End Loop\nEnd Task\n".replace("@", str(k))
        for k in range(1, count + 1)
    )
    return runs, "".join(blocks)


# Every way to wait until the axis is at rest.
_add("rest", "pause", _cycle())
for _name, _wait in {
    "while": "  While Not IDLE(0)\n  End While\n",
    "while_zero": "  While IDLE(0) = 0 : End While\n",
    "repeat": "  Repeat\n  Until IDLE(0)\n",
    "loop_exit": "  Loop\n    If IDLE(0) Then Exit Loop\n  End Loop\n",
    "own_flag": "  done = 0\n  While done = 0\n    If IDLE(0) Then done = 1\n  End While\n",
    "pause_velocity": "  WAIT(10)\n  PAUSE VEL(0) = 0\n",
    "while_velocity": "  WAIT(10)\n  While VEL(0) <> 0\n  End While\n",
    "target": "  While POS(0) <> POSTARGET(0)\n  End While\n" + _PAUSE,
    "window": "  While ABS(POS(0) - POSTARGET(0)) > 0.01\n  End While\n" + _PAUSE,
    "remaining": "  While POSREMAINING(0) > 0.01\n  End While\n" + _PAUSE,
    "mode": "  While AXISMODE(0) <> 0\n  End While\n",
    "two_axes": "  While Not IDLE(0) Or Not IDLE(1)\n  End While\n",
    "time_out": "  t = TIME\n  While Not IDLE(0) And TIME - t < 5000\n  End While\n",
    "time_out_in_loop": "  t = TIME\n  While Not IDLE(0)\n    If TIME - t > 5000 Then STOP(0)\n  End While\n",
    "count_out": "  k = 0\n  While Not IDLE(0)\n    k = k + 1\n    If k > 1000000 Then STOP(0)\n  End While\n",
    "counter": "  k = 0\n  While Not IDLE(0)\n    k = k + 1\n  End While\n",
    "emergency_stop": "  While Not IDLE(0)\n    If INX(5) Then STOP(0)\n  End While\n",
    "axis_error": "  While Not IDLE(0)\n    If AXISERROR(0) Then CANCEL(0)\n  End While\n",
    "wait_1": "  While Not IDLE(0)\n    WAIT(1)\n  End While\n",
    "wait_10": "  While Not IDLE(0)\n    WAIT(10)\n  End While\n",
    "wait_10_counted": "  k = 0\n  While Not IDLE(0)\n    WAIT(10)\n    k = k + 1\n  End While\n",
}.items():
    _add("rest", _name, _cycle(_wait))
_add("rest", "goto", _AXES + "#again\n" + _THERE + "#there\nIf Not IDLE(0) Then Goto there\n" + _BACK
     + "#home\nIf Not IDLE(0) Then Goto home\nWAIT(500)\nGoto again\n")  # fmt: skip
for _name, _wait, _blocks in (
    ("sub", "  Settle\n", "Sub Settle\n  While Not IDLE(0)\n  End While\nEnd Sub\n"),
    ("sub_pause", "  Settle\n", f"Sub Settle\n{_PAUSE}End Sub\n"),
    (
        "function",
        "  While Not Rest(0)\n  End While\n",
        "Function Rest(ByVal a As Integer) As Integer\n  Rest = IDLE(a)\nEnd Function\n",
    ),
    (
        "sub_in_loop",
        "  While Not IDLE(0)\n    Guard\n  End While\n",
        "Sub Guard\n  If INX(5) Then STOP(0)\nEnd Sub\n",
    ),
):
    _add("rest", _name, _cycle(_wait, blocks=_blocks))

# What a loop does while it waits: nothing new.
for _name, _body in {
    "copy": "x = POS(0)",
    "maximum": "If POS(0) > x Then x = POS(0)",
    "lamp": "OUTX(1) = 1",
    "lamp_by_speed": "If VEL(0) > 0 Then OUTX(1) = 1 Else OUTX(1) = 0",
    "lamp_by_input": "OUTX(1) = INX(3)",
    "lamp_by_position": "If POS(0) > 50 Then OUTX(1) = 1 Else OUTX(1) = 0",
    "cam_switch": "OUTX(1) = POS(0) > 20 And POS(0) < 60",
    "lamps_on_off": "OUTX(1) = 1 : OUTX(2) = 0",
    "bank": "OUT(0) = 5",
    "bank_bit": "OUT(0) = OUT(0) Or 2",
    "bank_by_input": "If INX(3) Then OUT(0) = 1 Else OUT(0) = 2",
    "flag": "busy = 1",
    "flag_by_speed": "If VEL(0) > 0 Then busy = 1 Else busy = 0",
    "override_same": "FEEDRATEOVERRIDE(0) = 80",
    "speed_same": "SPEED(0) = 100",
    "comms_state": "COMMS(1) = 4",
    "comms_position": "COMMS(1) = POS(0)",
    "comms_pair": "COMMS(1) = POS(0) : COMMS(2) = VEL(0)",
    "comms_flag": "If COMMS(5) = 1 Then STOP(0)",
    "net_position": "NETFLOAT(1) = POS(0)",
    "nv_state": "NVLONG(1) = 4",
}.items():
    _add("watch", _name, _cycle(f"  While Not IDLE(0)\n    {_body}\n  End While\n"))
_add(
    "watch", "outputs_toggle", _cycle("  While Not IDLE(0)\n    OUTX(1) = 1\n    OUTX(1) = 0\n  End While\n")
)
_add("watch", "host_handshake", _cycle("  COMMS(1) = 1\n  While Not IDLE(0)\n    If COMMS(2) Then COMMS(1) = 0\n"
     "  End While\n"))  # fmt: skip

# Tasks alongside the moves.
_LAMP = "  If VEL(0) > 0 Then OUTX(@) = 1 Else OUTX(@) = 0\n"
for _name, _count, _body in (
    ("waits_for_input", 1, "  PAUSE INX(3)\n  OUTX(1) = 1\n  PAUSE Not INX(3)\n  OUTX(1) = 0\n"),
    ("blinks", 1, "  OUTX(2) = 1\n  WAIT(250)\n  OUTX(2) = 0\n  WAIT(250)\n"),
    ("lamp", 1, _LAMP),
    ("lamp_wait_10", 1, _LAMP + "  WAIT(10)\n"),
    ("lamp_wait_1", 1, _LAMP + "  WAIT(1)\n"),
    ("emergency_stop", 1, "  If INX(5) Then STOP(0)\n"),
    ("counts", 1, "  n = n + 1\n"),
    ("counts_and_watches", 1, "  n = n + 1\n  If INX(5) Then STOP(0)\n"),
    ("two_lamps", 2, _LAMP),
    ("four_lamps", 4, _LAMP),
    ("four_wait_100", 4, "  If INX(@) Then OUTX(@) = 1 Else OUTX(@) = 0\n  WAIT(100)\n"),
    ("32_watch", 31, "  If INX(1) Then OUTX(1) = 1\n"),
    ("32_wait", 31, "  PAUSE INX(1)\n"),
):
    _runs, _blocks = _tasks(_count, _body)
    _add("tasks", _name, _cycle(head=_runs, blocks=_blocks))
_runs, _blocks = _tasks(1, _LAMP)
_add("tasks", "watch_and_lamp", _cycle("  While Not IDLE(0)\n  End While\n", head=_runs, blocks=_blocks))  # fmt: skip
_add("tasks", "hand_flags_over", f"Dim ask As Integer, done As Integer\n{_AXES}Run Carrier\nLoop\n  ask = 1\n"
     "  While done = 0\n  End While\n  ask = 0\n  While done = 1\n  End While\nEnd Loop\nEnd\n"
     f"Task Carrier\nLoop\n  While ask = 0\n  End While\n{_THERE}  While Not IDLE(0)\n  End While\n  done = 1\n"
     f"  While ask = 1\n  End While\n{_BACK}  While Not IDLE(0)\n  End While\n  WAIT(500)\n  done = 0\n"
     "End Loop\nEnd Task\n")  # fmt: skip
_add("tasks", "hand_flags_pause", f"Dim ask As Integer, done As Integer\n{_AXES}Run Carrier\nLoop\n  ask = 1\n"
     "  PAUSE done = 1\n  ask = 0\n  PAUSE done = 0\nEnd Loop\nEnd\n"
     f"Task Carrier\nLoop\n  PAUSE ask = 1\n{_THERE}{_PAUSE}  done = 1\n"
     f"  PAUSE ask = 0\n{_BACK}{_PAUSE}  WAIT(500)\n  done = 0\nEnd Loop\nEnd Task\n")  # fmt: skip

# Handlers, and a loop that does the same as a handler that computes.
for _period in (1, 10, 100):
    for _name, _body in {
        "empty": "",
        "sets": "  OUTX(3) = 1\n",
        "counts": "  ticks = ticks + 1\n",
        "toggles": "  OUTX(3) = Not OUTX(3)\n",
    }.items():
        _add("handlers", f"timer_{_period}_{_name}", _cycle(head=f"TIMEREVENT = {_period}\n",
             blocks=f"Event TIMER\n{_body}End Event\n"))  # fmt: skip
_add("handlers", "input_counts", _cycle(blocks="Event IN0\n  parts = parts + 1\nEnd Event\n"), _EVERY_SECOND)
_add(
    "handlers",
    "input_stops",
    _cycle(blocks="Event IN0\n  If INX(5) Then STOP(0)\nEnd Event\n"),
    _EVERY_SECOND,
)
_FILTER = "  mean = mean * 0.9 + POS(0) * 0.1\n"
_add("filter", "task_wait_1", _cycle(head="Dim mean As Float\nRun T1\n", blocks=f"Task T1\nLoop\n{_FILTER}  WAIT(1)\n"
     "End Loop\nEnd Task\n"))  # fmt: skip
_add("filter", "timer_1", _cycle(head="Dim mean As Float\nTIMEREVENT = 1\n",
     blocks=f"Event TIMER\n{_FILTER}End Event\n"))  # fmt: skip

# Displays and host memory.
for _name, _body in {
    "line_wait_100": "    LINE 1, POS(0)\n    WAIT(100)\n",
    "line_wait_10": "    LINE 1, POS(0)\n    WAIT(10)\n",
    "line_state": '    LINE 1, "moving"\n',
    "line_state_wait_1": '    LINE 1, "moving"\n    WAIT(1)\n',
    "line_by_input": '    If INX(3) Then LINE 2, "door" Else LINE 2, "closed"\n',
    "comms_wait_1": "    COMMS(1) = POS(0)\n    WAIT(1)\n",
    "comms_wait_20": "    COMMS(1) = POS(0)\n    WAIT(20)\n",
}.items():
    _add("display", _name, _cycle(f"  While Not IDLE(0)\n{_body}  End While\n"))
_add("display", "print_each_cycle", _cycle(each='  n = n + 1\n  PRINT "part ", n\n  WAIT(500)\n'))  # fmt: skip
_runs, _blocks = _tasks(1, "  LINE 1, POS(0)\n  LINE 2, VEL(0)\n  WAIT(200)\n")
_add("display", "task_200", _cycle(head=_runs, blocks=_blocks))
_runs, _blocks = _tasks(1, "  COMMS(1) = POS(0)\n  COMMS(2) = VEL(0)\n")
_add("display", "task_comms", _cycle(head=_runs, blocks=_blocks))

# Step chains: a case for each step, called again and again.
_STEPS = (
    "  If stage = 0 Then\n    MOVEA(0) = 100 : GO(0) : stage = 1\n  End If\n"
    "  If stage = 1 And IDLE(0) Then stage = 2\n"
    "  If stage = 2 Then\n    MOVEA(0) = 0 : GO(0) : stage = 3\n  End If\n"
    "  If stage = 3 And IDLE(0) Then\n    stage = 4 : t = TIME\n  End If\n"
    "  If stage = 4 And TIME - t >= 500 Then stage = 0\n"
)
_SELECT = (
    "  Select Case stage\n    Case 0\n      MOVEA(0) = 100 : GO(0) : stage = 1\n"
    "    Case 1\n      If IDLE(0) Then stage = 2\n"
    "    Case 2\n      MOVEA(0) = 0 : GO(0) : stage = 3\n"
    "    Case 3\n      If IDLE(0) Then\n        stage = 4 : t = TIME\n      End If\n"
    "    Case 4\n      If TIME - t >= 500 Then stage = 0\n  End Select\n"
)
for _name, _body in {
    "if": _STEPS,
    "if_wait_1": _STEPS + "  WAIT(1)\n",
    "if_wait_10": _STEPS + "  WAIT(10)\n",
    "select": _SELECT,
    "select_wait_1": _SELECT + "  WAIT(1)\n",
    "select_wait_10": _SELECT + "  WAIT(10)\n",
    "select_guarded": "  If INX(5) Then STOP(0)\n" + _SELECT,
    "select_lamp": _SELECT + "  OUTX(1) = stage = 1\n",
}.items():
    _add("steps", _name, f"{_AXES}Dim stage As Integer, t As Integer\nLoop\n{_body}End Loop\n")  # fmt: skip
_add("steps", "select_in_sub", f"Dim stage As Integer, t As Integer\n{_AXES}Loop\n  Chain\nEnd Loop\nEnd\n"
     f"Sub Chain\n{_SELECT}End Sub\n")  # fmt: skip
_add("steps", "two_chains", f"Dim stage As Integer, t As Integer, other As Integer, s As Integer\n{_AXES}Loop\n"
     f"{_SELECT}"
     "  If other = 0 Then\n    OUTX(2) = 1 : s = TIME : other = 1\n  End If\n"
     "  If other = 1 And TIME - s > 300 Then\n    OUTX(2) = 0 : other = 0\n  End If\nEnd Loop\n")  # fmt: skip

# Captures, encoders, analogue inputs and joysticks.
_LATCH = "LATCHTRIGGERCHANNEL(0) = 3\nLATCHSOURCECHANNEL(0) = 0\nDim at As Float\n"
_MARKS: dict[str, object] = {"input": [{"channel": 3, "at": 0.5, "for": 0.1, "every": 2.0}]}
for _name, _wait in {
    "pause": "  LATCHENABLE(0) = 1\n  PAUSE LATCH(0) Or IDLE(0)\n  at = LATCHVALUE(0)\n" + _PAUSE,
    "while": "  LATCHENABLE(0) = 1\n  While Not IDLE(0)\n    If LATCH(0) Then at = LATCHVALUE(0)\n  End While\n",
}.items():
    _add("sensors", f"latch_{_name}", _cycle(_wait, head=_LATCH), _MARKS)
_WHEEL: dict[str, object] = {"encoder": [{"aux": 0, "velocity": 1000.0}]}
_add("sensors", "encoder_pause", f"{_AXES}Loop\n  AUXENCODER(0) = 0\n  PAUSE AUXENCODER(0) > 2500\n{_THERE}{_PAUSE}"
     f"{_BACK}{_PAUSE}End Loop\n", _WHEEL)  # fmt: skip
_add("sensors", "encoder_while", f"{_AXES}Loop\n  AUXENCODER(0) = 0\n  While AUXENCODER(0) < 2500\n  End While\n"
     f"{_THERE}{_PAUSE}{_BACK}{_PAUSE}End Loop\n", _WHEEL)  # fmt: skip
_STEADY: dict[str, object] = {"analogue": [{"channel": 0, "value": 40.0}]}
_RAMP: dict[str, object] = {
    "analogue": [{"channel": 0, "axis": 0, "above": 0.0, "value": 0.0, "per_unit": 0.5}]
}
_add("sensors", "force_level", _cycle("  While Not IDLE(0)\n    If ADC(0) > 80 Then STOP(0)\n  End While\n"),
     _STEADY)  # fmt: skip
_add("sensors", "force_ramp", _cycle("  While Not IDLE(0)\n    If ADC(0) > 80 Then STOP(0)\n  End While\n"),
     _RAMP)  # fmt: skip
_add(
    "sensors",
    "force_pause",
    _cycle("  PAUSE ADC(0) > 20 Or IDLE(0)\n" + _PAUSE),
    _RAMP,
)
_add("sensors", "override_by_pot", _cycle("  While Not IDLE(0)\n    FEEDRATEOVERRIDE(0) = ADC(0)\n  End While\n",
     "FEEDRATEMODE(0) = 2\n"), _STEADY)  # fmt: skip
_STICK: dict[str, object] = {
    "analogue": [
        {"channel": 0, "value": value, "at": 2.0 * k + 1.0}
        for k, value in enumerate((30.0, 0.0, -30.0, 0.0) * 3600)
    ]
}
_add("joystick", "pause", f"{_AXES}Loop\n  PAUSE ADC(0) > 10\n  JOG(0) = 30\n  PAUSE ADC(0) < 10\n  STOP(0)\n"
     "  PAUSE ADC(0) < -10\n  JOG(0) = -30\n  PAUSE ADC(0) > -10\n  STOP(0)\nEnd Loop\n", _STICK)  # fmt: skip
for _name, _body in {
    "follows": "  JOG(0) = ADC(0)\n",
    "follows_deadband": "  If ABS(ADC(0)) > 5 Then JOG(0) = ADC(0) Else STOP(0)\n",
    "follows_wait_10": "  JOG(0) = ADC(0)\n  WAIT(10)\n",
}.items():
    _add("joystick", _name, f"{_AXES}Loop\n{_body}End Loop\n", _STICK)

# Recipes in arrays.
_add("recipes", "indexed", _AXES + "Dim r(3) As Float\nr(1) = 20 : r(2) = 60 : r(3) = 100\nDim i As Integer\nLoop\n"
     f"  For i = 1 To 3\n    MOVEA(0) = r(i) : GO(0)\n  {_PAUSE}  Next\n  WAIT(500)\nEnd Loop\n")  # fmt: skip
_add("recipes", "search", _AXES + "Dim r(100) As Float, i As Integer\nFor i = 1 To 100 : r(i) = i : Next\nLoop\n"
     f"  i = 1\n  While r(i) < 100\n    i = i + 1\n  End While\n  MOVEA(0) = r(i) : GO(0)\n{_PAUSE}{_BACK}{_PAUSE}"
     "  WAIT(500)\nEnd Loop\n")  # fmt: skip
_add("recipes", "in_watch", _cycle("  While Not IDLE(0)\n    If POS(0) > r(2) Then OUTX(1) = 1 Else OUTX(1) = 0\n"
     "  End While\n", head="Dim r(3) As Float\nr(1) = 20 : r(2) = 60 : r(3) = 100\n"))  # fmt: skip
_add("recipes", "state_array", _cycle("  s(1) = 1\n  While s(1)\n    If IDLE(0) Then s(1) = 0\n  End While\n",
     head="Dim s(50) As Integer\n"))  # fmt: skip

# Cams, splines and followers of a shaft that jogs without end.
_SHAFT = "SPEED(0) = 180 : ACCEL(0) = 360\n"
_LIFT = (
    _SHAFT + "Dim lift(1001) As Float, n As Integer\nlift(1) = {0}\n"
    "For n = 1 To {0}\n  lift(n + 1) = 15 * (1 - Cos(n * 360 / {0}))\nNext\n"
    "MASTERSOURCE(1) = _msPOS\nMASTERCHANNEL(1) = 0\nMASTERDISTANCE(1) = 360 / {0}\nCAMTABLE(1, lift, NULL)\n"
    "CAM(1) = _spABSOLUTE | _spCONTINUOUS\nGO(1)\nJOG(0) = 180\n"
)
for _points in (24, 1000):
    for _name, _body in {
        "waits": "  WAIT(1000)\n",
        "pauses": "  PAUSE POS(1) > 15\n  PAUSE POS(1) < 15\n",
        "polled": "  While POS(1) <= 15\n  End While\n  While POS(1) >= 15\n  End While\n",
        "watched": "  If POS(1) > 15 Then OUTX(1) = 1 Else OUTX(1) = 0\n",
        "index": "  PAUSE CAMINDEX(1) = 12\n  PAUSE CAMINDEX(1) = 13\n",
    }.items():
        _add("cams", f"{_points}_{_name}", f"{_LIFT.format(_points)}Loop\n{_body}End Loop\n")  # fmt: skip
_FOLLOW = "MASTERSOURCE(1) = _msPOS\nMASTERCHANNEL(1) = 0\nFOLLOW(1) = 0.5\n"
_add("cams", "follow", _cycle(head=_FOLLOW))
_add(
    "cams",
    "follow_polled",
    _cycle("  While Not IDLE(1)\n  End While\n", head=_FOLLOW),
)
_add("cams", "follow_watched", _cycle("  While Not IDLE(0)\n    If POS(1) > 15 Then OUTX(1) = 1 Else OUTX(1) = 0\n"
     "  End While\n", head=_FOLLOW))  # fmt: skip
_ARM = "Dim way(5) As Float = 4, 300, 300, -300, -300\nSPLINETABLE(0, way, NULL, NULL)\nSPLINETIME(0) = 500\n"
for _name, _wait in {
    "pause": _PAUSE,
    "while": "  While Not IDLE(0)\n  End While\n",
    "watched": "  While Not IDLE(0)\n    If POS(0) > 300 Then OUTX(1) = 1 Else OUTX(1) = 0\n  End While\n",
}.items():
    _add("splines", _name, f"{_ARM}Loop\n  SPLINE(0) = _spSPLINE_1\n  GO(0)\n{_wait}End Loop\n")  # fmt: skip

# Short moves without a dwell: the cost of a move itself.
_SHORT = "SPEED(0, 1) = 100;\nACCEL(0, 1) = 5000;\nDECEL(0, 1) = 5000;\nLoop\n{}End Loop\n"
_add("moves", "relative", _SHORT.format("  MOVER(0) = 10 : GO(0)\n  PAUSE IDLE(0)\n"))
for _name, _body in {
    "vector": "  VECTORR(0, 1) = 10, 0 : GO(0)\n  PAUSE IDLE(0)\n",
    "vector_two": "  VECTORR(0, 1) = 8, 6 : GO(0)\n  PAUSE IDLE(0)\n",
    "two_axes": "  MOVER(0, 1) = 10, 10 : GO(0, 1)\n  PAUSE IDLE(0) And IDLE(1)\n",
    "while": "  MOVER(0) = 10 : GO(0)\n  While Not IDLE(0) : End While\n",
    "jog": "  JOG(0) = 100\n  WAIT(100)\n  STOP(0)\n  PAUSE IDLE(0)\n",
    "arc": "  CIRCLER(0, 1) = 10, 0, 60 : GO(0)\n  PAUSE IDLE(0)\n",
    "retarget": "  MOVER(0) = 5 : GO(0)\n  WAIT(30)\n  INCR(0) = 5\n  PAUSE IDLE(0)\n",
    "offset": "  OFFSET(0) = 10 : GO(0)\n  PAUSE IDLE(0)\n",
}.items():
    _add("moves", _name, _SHORT.format(_body))

# Long arcs: the velocity of an axis on an arc is a sine.
_ARC = "SPEED(0) = 100;\nACCEL(0) = 1000;\nDECEL(0) = 1000;\nLoop\n  CIRCLER(0, 1) = 100, 0, 360 : GO(0)\n{}End Loop\n"
_add("arcs", "pause", _ARC.format(_PAUSE))
for _name, _wait in {
    "velocity": "  PAUSE VEL(1) > 50\n  PAUSE VEL(1) < 10\n",
    "velocity_size": "  WAIT(10)\n  PAUSE ABS(VEL(0)) < 20\n",
    "velocity_watched": "  While Not IDLE(0)\n    If VEL(1) > 50 Then OUTX(1) = 1 Else OUTX(1) = 0\n  End While\n",
    "position": "  PAUSE POS(1) > 50\n",
}.items():
    _add("arcs", _name, _ARC.format(_wait + _PAUSE))

# Contours; streamed segments of 6 ms reload the buffer as it empties.
_CONTOUR = (
    "SPEED(0, 1) = 100;\nACCEL(0, 1) = 1000;\nDECEL(0, 1) = 1000;\nMOVEBUFFERSIZE(0, 1) = {0};\n"
    "CONTOURMODE(0) = {1}\nDim i As Integer\n"
)
_BATCH = (
    "Loop\n  For i = 1 To {0}\n    VECTORR(0, 1) = 2, 0.1 * (i Mod 3)\n  Next\n  GO(0)\n  PAUSE IDLE(0)\n"
    "End Loop\n"
)
_add("contours", "20_stops", _CONTOUR.format(20, 0) + _BATCH.format(20))
for _size in (20, 100):
    _add("contours", f"{_size}_blended", _CONTOUR.format(_size, 1) + _BATCH.format(_size))  # fmt: skip
_add("contours", "streamed_6_ms", _CONTOUR.format(20, 1) + "Loop\n  PAUSE MOVEBUFFERFREE(0) > 5\n  i = i + 1\n"
     "  VECTORR(0, 1) = 0.6, 0.02 * (i Mod 3) : GO(0)\nEnd Loop\n")  # fmt: skip

# Simulated motors.
_DRIVEN: dict[str, object] = {f"axis.0.plant.{key}": value for key, value in _MOTOR.items()}
_add("motors", "pause", _cycle(), _DRIVEN)
for _name, _body in {"while": "", "error_watched": "    If ABS(FOLERROR(0)) > 500 Then STOP(0)\n"}.items():
    _add("motors", _name, _cycle(f"  While Not IDLE(0)\n{_body}  End While\n"), _DRIVEN)  # fmt: skip

# The same in MCCL.
_MN = "1MN,1SV1000,1SA5000,1DS5000\n"
_MOVES = _MN + "1MA1000,{0},1MA0,{0},WA0.5,RP\n"
_add("mccl", "ws", _MOVES.format("1WS"))
for _name, _wait in {
    "ws_time": "1WS0.1",
    "wt": "1WT",
    "wp": "1WP500,1WS",
    "macro": "MC1",
    "status": "MC3",
    "status_window": "MC4",
    "status_counted": "MC6",
    "emergency_stop": "MC7",
    "position": "MC8",
    "velocity": "MC9",
    "status_wait_10": "MC10",
}.items():
    _add("mccl", _name, 'LU"STATUS",AR60,LU"POSITION",AR61,LU"VELOCITY",AR62\nMD1,1WS\nMD3,1RL@60,IC3,JR-2,NO\n'
         "MD4,1RL@60,IC3,JR-2,NO,1WS0.02\nMD6,RA30,AA1,AR30,1RL@60,IC3,JR-5,NO\n"
         "MD7,IN5,1ST,NO,1RL@60,IC3,JR-5,NO\nMD8,1RL@61,IG500,CN33,NO,IB501,CF33,NO,1RL@60,IC3,JR-9,NO\n"
         "MD9,1RL@62,IG100,CN33,NO,1RL@60,IC3,JR-6,NO\nMD10,WA0.01,1RL@60,IC3,JR-3,NO\n"
         + _MOVES.format(_wait))  # fmt: skip
_WATCHES = {
    "watch_writes": "MD5,IN5,CN34,NO,IF5,CF34,NO,RP\n",
    "watch_edge": "MD5,IN5,CN34,MJ6,NO,RP\nMD6,IF5,CF34,MJ5,NO,RP\n",
    "watch_wait_1": "MD5,IN5,CN34,NO,IF5,CF34,NO,WA0.001,RP\n",
    "watch_wait_10": "MD5,IN5,CN34,NO,IF5,CF34,NO,WA0.01,RP\n",
    "watch_register": "MD5,AL0,AR40,IN5,AL1,AR40,NO,RP\n",
    "watch_counts": "MD5,RA40,AA1,AR40,IN5,1ST,NO,RP\n",
    "watch_position": 'LU"POSITION",AR61\nMD5,1RL@61,IG500,CN33,NO,IB501,CF33,NO,RP\n',
    "waits_on_input": "MD5,WN5,CN34,WF5,CF34,RP\n",
    "blinks": "MD5,CN34,WA0.25,CF34,WA0.25,RP\n",
    "stop_watch": "MD5,IN5,1ST,NO,RP\n",
}
for _name, _watch in _WATCHES.items():
    _add("mccl", _name, _watch + "GT5\n" + _MOVES.format("1WS"))
for _count in (2, 4, 8):
    _add("mccl", f"{_count}_watches", "".join(f"MD{k},IN{k},CN{k + 32},NO,IF{k},CF{k + 32},NO,RP\n"
         for k in range(1, _count + 1)) + "".join(f"GT{k}\n" for k in range(1, _count + 1))
         + _MOVES.format("1WS"))  # fmt: skip
_add("mccl", "registers", _MN + "AL1000,AR10\nRA10,1MA@10,1WS,AL0,1MA@0,1WS,WA0.5,RP\n")
_add("mccl", "display", _MN + '1MA1000,1WS,FT"at",1TP,1MA0,1WS,WA0.5,RP\n')
_add("mccl", "cut_to_length", 'LU"AUXPOSITION",AR20\nMD1,1RL@20,IB3000,JR-2,NO,MC2,RP\nMD2,AS3000,1WL@20,CN33,'
     "WA0.05,CF33\n1AH0,MC1\n", {"encoder": [{"aux": 1, "velocity": 2500.0}]})  # fmt: skip
_add("mccl", "joystick", "1MN,1JA50000,1JG100,1JB0.5\n1JN\nWA1,RP\n",
     {"analogue": [{**each, "channel": 1} for each in _STICK["analogue"]]})  # type: ignore[attr-defined]  # fmt: skip
_add(
    "mccl",
    "path",
    "MN,1CM1,2CM1,1VV1000,1VA5000,1VD5000\n1CP1,1MA600,2MA800,1WS,1CP1,1MA0,2MA0,1WS,WA0.5,RP\n",
)
_add("mccl_moves", "mint", _SHORT.format("  MOVER(0) = 10 : GO(0)\n  PAUSE IDLE(0)\n"))
STYLES["mccl_moves_mint"] = STYLES["mccl_moves_mint"]._replace(file="mint.mnt")
_add(
    "mccl_moves",
    "relative",
    "1MN,1SV100,1SA5000,1DS5000\n1MR10,1WS,RP\n",
)
_add("mccl_moves", "absolute", "1MN,1SV100,1SA5000,1DS5000\n1MA10,1WS,1MA0,1WS,RP\n")  # fmt: skip
_add(
    "mccl_moves",
    "in_macro",
    "1MN,1SV100,1SA5000,1DS5000\nMD1,1MR10,1WS\nMC1,RP\n",
)

# Ten styles written after the work on timers, counters and switches, to see what it covers.
_POLLED = "  While Not IDLE(0)\n  End While\n"
_TICKS = "Dim ticks As Integer, parts As Integer, stage As Integer, t As Integer\nTIMEREVENT = {}\n"
for _name, _text in {
    "timer_while_polling": _cycle(
        _POLLED, head=_TICKS.format(1), blocks="Event TIMER\n  ticks = ticks + 1\nEnd Event\n"
    ),
    "timer_prescaler": _cycle(
        head=_TICKS.format(1),
        blocks="Event TIMER\n  ticks = ticks + 1\n  If ticks >= 250 Then\n    ticks = 0\n"
        "    OUTX(3) = Not OUTX(3)\n  End If\nEnd Event\n",
    ),
    "timer_watchdog": _cycle(
        head=_TICKS.format(10),
        each="  parts = parts + 1 : ticks = 0\n  WAIT(500)\n",
        blocks="Event TIMER\n  ticks = ticks + 1\n  If ticks > 2000 Then STOP(0)\n"
        "  If INX(5) Then STOP(0)\nEnd Event\n",
    ),
    "timer_step_chain": f"{_AXES}{_TICKS.format(10)}Loop\n  PAUSE INX(9)\nEnd Loop\nEnd\n"
    f"Event TIMER\n{_SELECT}End Event\n",
    "blinks_while_waiting": _cycle(
        "  While Not IDLE(0)\n    OUTX(1) = Not OUTX(1)\n    WAIT(100)\n  End While\n"
    ),
    "flickers": _cycle("  While Not IDLE(0)\n    OUTX(1) = Not OUTX(1)\n  End While\n"),
    "display_of_parts": _cycle(
        each='  parts = parts + 1\n  LINE 1, "parts ", parts\n  WAIT(500)\n', head="Dim parts As Integer\n"
    ),
    "heartbeat_and_stop": _cycle(
        head="Run Beat\nRun Guard\n",
        blocks="Task Beat\nLoop\n  OUTX(7) = 1\n  WAIT(500)\n  OUTX(7) = 0\n  WAIT(500)\nEnd Loop\nEnd Task\n"
        "Task Guard\nLoop\n  If Not INX(5) Then STOP(1)\n  WAIT(5)\nEnd Loop\nEnd Task\n",
    ),
}.items():
    _add("field", _name, _text)
_add("mccl_field", "time_out", 'LU"STATUS",AR60\nMD6,RA30,AA1,AR30,IG500000,1ST,NO,1RL@60,IC3,JR-8,NO\n'
     + _MOVES.format("AL0,AR30,MC6"))  # fmt: skip
_add("mccl_field", "two_counts", "MD5,RA40,AA1,AR40,NO,RP\nMD6,IN6,RA41,AA1,AR41,NO,RP\nGT5\nGT6\n"
     + _MOVES.format("1WS"))  # fmt: skip

# Loops that poll alongside a TIMER, with a WAIT or a counter of their own.
_LOOPS = {
    "wait_5": "    WAIT(5)\n",
    "wait_5_counted": "    n = n + 1\n    WAIT(5)\n",
    "wait_1": "    WAIT(1)\n",
    "counted": "    n = n + 1\n",
    "guarded_wait_5": "    If INX(5) Then STOP(0)\n    WAIT(5)\n",
}
_TIMERS = {"toggles": "  OUTX(3) = Not OUTX(3)\n", "lamp": _LAMP.replace("@", "3")}
for _period in (1, 10):
    for _handler, _steps in _TIMERS.items():
        for _name, _body in _LOOPS.items():
            _add(
                "timers",
                f"{_period}_{_handler}_{_name}",
                _cycle(
                    f"  While Not IDLE(0)\n{_body}  End While\n",
                    head=f"TIMEREVENT = {_period}\n",
                    blocks=f"Event TIMER\n{_steps}End Event\n",
                ),
            )
for _name, _wait, _count, _body in (
    ("lamp_wait_10", _PAUSE, 1, _LAMP + "  WAIT(10)\n"),
    ("poll_and_lamp_wait_10", _POLLED, 1, _LAMP + "  WAIT(10)\n"),
    ("wait_5_and_lamp", "  While Not IDLE(0)\n    WAIT(5)\n  End While\n", 1, _LAMP),
    ("two_guards_wait_10", _PAUSE, 2, "  If INX(@) Then STOP(0)\n  WAIT(10)\n"),
    ("poll_and_two_guards_wait_10", _POLLED, 2, "  If INX(@) Then STOP(0)\n  WAIT(10)\n"),
    ("poll_and_two_lamps", _POLLED, 2, _LAMP),
    ("poll_and_heartbeat", _POLLED, 1, "  OUTX(7) = 1\n  WAIT(500)\n  OUTX(7) = 0\n  WAIT(500)\n"),
):
    _runs, _blocks = _tasks(_count, _body)
    _add(
        "timers",
        f"tasks_{_name}",
        _cycle(
            _wait,
            head="TIMEREVENT = 10\n" + _runs,
            blocks=_blocks + "Event TIMER\n  ticks = ticks + 1\nEnd Event\n",
        ),
    )
