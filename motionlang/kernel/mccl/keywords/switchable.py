"""The assumptions about MCCL that can be set.

They include the format of replies, codes, the origin of jumps and settings at power-up.
"""

from __future__ import annotations

from motionlang.kernel.lang.machine.switch import Switch

# The first choice is the default.
SWITCHES = {
    "mccl.reply-form": Switch("01 1234", "1 1234", "01=1234", "1234"),
    "mccl.channel-form": Switch("1", "ON"),
    "mccl.no-breakpoint": Switch("0", "NONE"),
    "mccl.hex-letters": Switch("capital", "small"),
    "mccl.error-told": Switch("kept", "cleared"),
    "mccl.skipped": Switch(2, 1, 3),
    "mccl.jump-base": Switch(0, 1),
    "mccl.jump-relative": Switch("itself", "next"),
    "mccl.repeat-for-ever": Switch("for ever", "once"),
    "mccl.abort-rate": Switch("at once", "DS"),
    "mccl.quotient": Switch("cut", "real"),
    "mccl.overflow": Switch("wraps", "stays"),
    "mccl.shift-right": Switch("sign", "zeros"),
    "mccl.angles": Switch("degrees", "radians"),
    "mccl.code-parameter": Switch(low=-99, high=99, whole=True),
    "mccl.code-no-axis": Switch(low=-99, high=99, whole=True),
    "mccl.code-not-assigned": Switch(low=-99, high=99, whole=True),
    "mccl.gain-default": Switch(low=0, high=1e6),
    "mccl.integral-default": Switch(low=0, high=1e6),
    "mccl.derivative-default": Switch(low=0, high=1e6),
    "mccl.integral-limit-default": Switch(low=0, high=1e6),
    "mccl.velocity-gain-default": Switch(low=0, high=1e6),
    "mccl.torque-default": Switch(low=0, high=1e6),
}
# Stored settings of an axis, by the assumption on their value at power-up.
SWITCHED = {
    "mccl.gain-default": "kept_gain",
    "mccl.integral-default": "kept_integral",
    "mccl.derivative-default": "kept_derivative",
    "mccl.integral-limit-default": "kept_integral_limit",
    "mccl.velocity-gain-default": "kept_velocity_gain",
    "mccl.torque-default": "kept_torque",
}
