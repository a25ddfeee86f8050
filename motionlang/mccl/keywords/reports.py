"""What the controller tells."""

from __future__ import annotations

from motionlang.mccl.keywords.row import Group

_G = Group("reports")
_row = _G.row

ROWS = (
    _row("TP", "reading", "R", "axes", "uu", "tell_position", "Tell the actual position.", "1TP", meant="POS PRINT"),
    _row("TT", "reading", "R", "axes", "uu", "tell_target", "Tell the target.", "1TT"),
    _row("TO", "reading", "R", "axes", "uu", "tell_optimal", "Tell the optimal position, that of the trajectory.",
         "1TO"),
    _row("TF", "reading", "R", "axes", "uu", "tell_following", "Tell the following error, optimal minus actual.",
         "1TF"),
    _row("TV", "reading", "R", "axes", "uu/s", "tell_velocity", "Tell the actual velocity.", "1TV"),
    _row("TS", "reading", "R", "axes", "bits", "tell_status",
         "Tell a status word: 0 status, 1 auxiliary, 2 profile, 3 mode.", "1TS", low=0, high=3, meant="STATUS"),
    _row("TE", "reading", "R", "none", "number", "tell_error", "Tell the last error of the interpreter.", "TE"),
    _row("TG", "reading", "R", "axes", "number", "tell_gain", "Tell the proportional gain.", "1TG"),
    _row("TI", "reading", "R", "axes", "number", "tell_integral", "Tell the integral gain.", "1TI"),
    _row("TD", "reading", "R", "axes", "number", "tell_derivative", "Tell the derivative gain.", "1TD"),
    _row("TL", "reading", "R", "axes", "number", "tell_integral_limit", "Tell the limit of the integral term.",
         "1TL"),
    _row("TK", "reading", "R", "axes", "number", "tell_velocity_gain", "Tell the velocity gain.", "1TK"),
    _row("TQ", "reading", "R", "axes", "number", "tell_torque", "Tell the torque limit.", "1TQ"),
    _row("TB", "reading", "R", "axes", "uu", "tell_breakpoint", "Tell the position of the breakpoint.", "1TB"),
    _row("TZ", "reading", "R", "axes", "uu", "tell_index", "Tell the position at which the index was last seen.",
         "1TZ"),
    _row("AT", "reading", "R", "axes", "uu", "tell_auxiliary",
         "Tell the position of the auxiliary encoder, which the machine file turns.", "1AT"),
    _row("AZ", "reading", "R", "axes", "uu", "tell_auxiliary_index",
         "Tell the position of the auxiliary encoder at its index, as AF found it.", "1AZ"),
    _row("TC", "reading", "R", "none", "number", "tell_channel", "Tell a digital channel: 1 on, 0 off.", "TC1",
         low=1, high=255),
    _row("TA", "reading", "R", "none", "number", "tell_analog", "Tell an analogue input, volts.", "TA1",
         low=1, high=255),
    _row("TR", "reading", "R", "none", "number", "tell_register", "Tell a register; 0 is the accumulator.", "AL5,TR0",
         low=0, high=255, meant="PRINT"),
    _row("TM", "reading", "R", "none", "number", "tell_macro", "List a macro; -1 lists all.", "TM-1", low=-1),
    _row("VE", "reading", "R", "none", "text", "tell_version", "Tell the model and the version.", "VE"),
    _row("DO", "reading", "R", "axes", "uu", "tell_recorded_optimal",
         "Tell n recorded optimal positions, one a line; 0 tells all of them.", "1MN,1PR5,1MR50,1WS,1DO0", low=0),
    _row("DR", "reading", "R", "axes", "uu", "tell_recorded_actual",
         "Tell n recorded actual positions, one a line; 0 tells all of them.", "1MN,1PR5,1MR50,1WS,1DR0", low=0),
    _row("DQ", "reading", "R", "axes", "number", "tell_recorded_torque",
         "Tell n recorded outputs in volts, one a line; 0 V without a simulated motor.",
         "1MN,1PR5,1MR50,1WS,1DQ0", low=0),
    _row("HE", "reading", "R", "none", "text", "tell_help", "List the commands.", "HE", meant="HELP"),
)  # fmt: skip
