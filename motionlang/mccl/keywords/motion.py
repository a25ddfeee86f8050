"""Switching on, moving, stopping, homing, points and recording."""

from __future__ import annotations

from motionlang.mccl.keywords.row import Group

_G = Group("motion")
_row = _G.row

ROWS = (
    _row("MN", "command", "C", "axes", "", "motor_on",
         "Motor on: target, optimal and actual position become one, faults are forgotten, user units take effect.",
         "1MN", meant="ON ENABLE"),
    _row("MF", "command", "C", "axes", "", "motor_off", "Motor off: motion ends, the output is 0 V.",
         "1MF", meant="OFF DISABLE"),
    _row("MA", "move", "W", "axes", "uu", "move_to", "Move to a position.", "1MN,1MA1000", meant="MOVE MOVEA"),
    _row("MR", "move", "W", "axes", "uu", "move_by", "Move by a distance, counted from the present target.",
         "1MN,1MR-500", meant="MOVE MOVER"),
    _row("GH", "move", "C", "axes", "", "go_home", "Go home: move to position 0.", "1MN,1GH", meant="HOME"),
    _row("GO", "move", "W", "axes", "number", "go",
         "Start: run in velocity mode, or release the contour paths that wait.", "1MN,1VM,1GO,WA0.1,1ST"),
    _row("DI", "setting", "W", "axes", "bool", "direction", "Direction of velocity mode: 0 positive, 1 negative.",
         "1DI1", default=0, low=0, high=1),
    _row("ST", "command", "C", "axes", "", "stop", "Stop at the programmed deceleration.", "1ST", meant="STOP"),
    _row("AB", "command", "C", "axes", "", "abort", "Abort: stop at once, the motor stays on.", "1AB", meant="ABORT"),
    _row("DH", "command", "W", "axes", "uu", "define_home", "Define home: the present position becomes this one.",
         "1DH0"),
    _row("AH", "command", "W", "axes", "uu", "define_auxiliary",
         "Give the present position of the auxiliary encoder a new value.", "1AH100,1AT"),
    _row("FI", "command", "W", "axis", "uu", "find_index",
         "Find the index mark: while the axis runs, wait for the mark; there the position becomes this one. "
         "The machine file says where marks are (index_every).",
         "1MN,1VM,1GO,1FI0,1ST", meant="HOME"),
    _row("FE", "command", "W", "axis", "uu", "find_edge",
         "Find the edge of the coarse home switch: while the axis runs, wait for it; there the position becomes "
         "this one. The machine file says where the switch is (home_switch).", "1MN,1VM,1GO,1FE0,1ST", meant="HOME"),
    _row("IA", "command", "W", "axis", "uu", "arm_index",
         "Arm the index capture; complete it with WI, when the position at the mark becomes this one.", "1IA0"),
    _row("EL", "command", "W", "axis", "uu", "arm_edge",
         "Arm the capture of the home edge; complete it with WE, when the position at the edge becomes this one.",
         "1EL0"),
    _row("AF", "command", "W", "axis", "uu", "find_auxiliary_index",
         "Find the index of the auxiliary encoder: wait for its mark; there its position becomes this one. The machine "
         "file turns it and says where marks are ([[encoder]]).", "1AF0,1AT"),
    _row("LP", "command", "W", "axes", "number", "learn_position", "Learn the actual position as point n.",
         "1LP1", low=0, high=255),
    _row("LT", "command", "W", "axes", "number", "learn_target", "Learn the target as point n.",
         "1LT1", low=0, high=255),
    _row("MP", "move", "W", "axes", "number", "move_to_point", "Move to the learned point n.",
         "1MN,1LP1,1MR500,1WS,1MP1", low=0, high=255),
    _row("RT", "command", "C", "axes", "", "reset", "Reset the axis, or without an axis the whole controller.",
         "1RT", meant="RESET"),
    _row("PR", "command", "W", "axes", "number", "record",
         "Record n points of the motion, one every millisecond, read out with DO, DR and DQ.", "1PR100",
         low=0, high=10000),
    _row("IP", "command", "W", "axes", "uu", "break_at", "Set a breakpoint at a position: status bit 10 shows it.",
         "1IP500"),
    _row("IR", "command", "W", "axes", "uu", "break_after",
         "Set a breakpoint at a distance from the present position.", "1IR500"),
)  # fmt: skip
