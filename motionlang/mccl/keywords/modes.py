"""Modes of operation, gearing and jogging."""

from __future__ import annotations

from motionlang.mccl.keywords.row import Group

_G = Group("modes")
_row = _G.row

ROWS = (
    _row("PM", "command", "C", "axes", "", "position_mode", "Position mode: moves to targets.", "1PM"),
    _row("VM", "command", "C", "axes", "", "velocity_mode", "Velocity mode: GO runs at SV in the direction of DI.",
         "1VM"),
    _row("QM", "command", "C", "axes", "", "torque_mode",
         "Torque mode: SQ sets the output directly; shows in the status, moves nothing without a simulated motor.",
         "1QM"),
    _row("GM", "command", "C", "axes", "", "gain_mode",
         "Gain mode: proportional gain only; shows in the status.", "1GM"),
    _row("CM", "command", "W", "axis", "number", "contour_mode",
         "Contour mode under the controlling axis n.", "1CM1", low=0, family="contours"),
    _row("SM", "command", "W", "axis", "number", "slave", "Slave the axis to master axis n; 0 ends it.",
         "1MN,2MN,2SM1", low=0),
    _row("SS", "setting", "W", "axis", "number", "slave_ratio", "Set the ratio of slave counts to master counts.",
         "2SS0.5", default=1),
    _row("SN", "command", "C", "axis", "", "sync_on",
         "Synchronise contour moves: the paths that follow wait for GO.", "1SN", family="contours"),
    _row("NS", "command", "C", "axis", "", "sync_off", "Contour moves start at once.", "1NS", family="contours"),
    _row("JN", "command", "C", "axes", "", "jog_on", "Jogging on: the axis follows its joystick input.", "1MN,1JN"),
    _row("JF", "command", "C", "axes", "", "jog_off", "Jogging off: the axis stops.", "1JF"),
    _row("JA", "setting", "W", "axes", "uu/s2", "jog_accel", "Set the acceleration of jogging.",
         "1JA50000", default=100000, low=0),
    _row("JV", "setting", "W", "axes", "uu/s", "jog_minimum", "Set the least velocity of jogging.",
         "1JV100", default=0, low=0),
    _row("JB", "setting", "W", "axes", "number", "jog_deadband",
         "Set the deadband of the joystick, volts either side of its offset.", "1JB0.2", default=0.1, low=0),
    _row("JG", "setting", "W", "axes", "uu/s", "jog_gain", "Set the velocity of jogging per volt.",
         "1JG2000", default=1000),
    _row("JO", "setting", "W", "axes", "number", "jog_offset", "Set the voltage of the joystick at rest.",
         "1JO2.5", default=0, low=-10, high=10),
)  # fmt: skip
