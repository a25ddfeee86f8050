"""What an axis and its encoder tell beyond position and speed."""

from __future__ import annotations

from motionlang.lang.keyword import Keyword
from motionlang.mint.keywords.defaults import IDLE

_MOVE = "MOVER(0) = 100\nGO(0)\nPRINT {}(0)"


def _reading(name: str, short: str, unit: str, verb: str, help: str,
             changes: str = "", solved: bool = False) -> Keyword:  # fmt: skip
    return Keyword(name, short, "reading", "R", "axis", unit, verb, help, _MOVE.format(name),
                   group="state", changes=changes, solved=solved)  # fmt: skip


def _window(name: str, unit: str, help: str, high: float) -> Keyword:
    return Keyword(name, "", "setting", "RW", "axis", unit, "sensing.window", help,
                   f"{name}(0) = 3\nPRINT {name}(0)", default=float(IDLE[name]), low=0, high=high,
                   group="state")  # fmt: skip


def _encoder(name: str, unit: str, help: str, low: float, default: float) -> Keyword:
    return Keyword(name, "", "setting", "RW", "channel", unit, "sensing.encoder_setting", help,
                   f"{name}(0) = 4\nPRINT {name}(0)", default=default, low=low, high=8388607.0,
                   group="encoders")  # fmt: skip


ROWS = (
    _reading("AXISMODE", "amd", "bits", "sensing.axis_mode",
             "Kind of motion: 0 idle, 1 a move, 2 JOG, 4 HOME, 8 a path, 16 FOLLOW, 32 CAM, 64 FLY, 128 SPLINE, "
             "256 OFFSET, 512 another one; 1024 is added while the axis is suspended."),
    Keyword("POSDEMAND", "", "reading", "RW", "axis", "uu", "demand",
            "The position that the profiler demands: POS, where no motor is simulated. Writing it, which makes the "
            "demand jump, is not simulated.", _MOVE.format("POSDEMAND"), group="state", changes="motion", solved=True),
    _reading("VELDEMAND", "", "uu/s", "demand_velocity", "The velocity that the profiler demands.",
             changes="motion", solved=True),
    _reading("ACCELDEMAND", "", "uu/s2", "sensing.acceleration", "The acceleration that the profiler demands."),
    _reading("POSTARGET", "", "uu", "sensing.target", "Where the move that is executing ends."),
    _reading("POSTARGETLAST", "", "uu", "sensing.last_target", "Where the last move of the buffer ends."),
    _reading("POSACHIEVED", "", "bool", "is_idle", "1 when the axis has come to the end of its moves, as IDLE is."),
    _window("IDLEMODE", "integer",
            "What IDLE asks for beyond the end of the move: bit 0 following error within IDLEPOS, bit 1 speed within "
            "IDLEVEL, either for IDLETIME; 0 nothing.", 3),
    _window("IDLEPOS", "uu", "Following error up to which an axis counts as idle.", 8388607.0),
    _window("IDLEVEL", "uu/s", "Speed up to which an axis counts as idle.", 8388607.0),
    _window("IDLETIME", "integer", "How many milliseconds an axis must have been inside its windows to be idle.",
            60000),
    _reading("IDLESETTLINGTIME", "", "integer", "sensing.settling_time",
             "How many milliseconds after the end of its move the axis was idle."),
    Keyword("SYSTEMSECONDS", "", "reading", "R", "none", "number", "sensing.seconds",
            "Seconds since power-up.", "PRINT SYSTEMSECONDS", default=0.0, group="control"),
    Keyword("ENCODER", "", "setting", "RW", "channel", "number", "sensing.encoder",
            "What the encoder of an axis shows, in units of ENCODERSCALE; POS = 0 does not change it.",
            "ENCODER(0) = 100\nPRINT ENCODER(0)", default=0.0, group="encoders", driven="encoder", solved=True),
    Keyword("ENCODERVEL", "", "reading", "R", "channel", "number", "sensing.encoder_speed",
            "Speed of an encoder, in units of ENCODERSCALE a second.",
            "JOG(0) = 100\nWAIT = 10\nPRINT ENCODERVEL(0)\nCANCEL(0)", default=0.0, group="encoders"),
    Keyword("ENCODERCOUNT", "", "reading", "R", "channel", "integer", "sensing.encoder_count",
            "Counts of the encoder of an axis since power-up.",
            "PRINT ENCODERCOUNT(0)", default=0.0, group="encoders"),
    _encoder("ENCODERSCALE", "number", "Counts of an encoder in one of its units.", 1e-6, 1.0),
    _encoder("ENCODERPRESCALE", "integer", "What the counts of an encoder are divided by first.", 1, 1.0),
    _encoder("ENCODERWRAP", "number", "The range in which ENCODER counts, from 0 on; 0 for no end.", 0, 0.0),
    Keyword("POSWRAP", "", "setting", "RW", "axis", "number", "sensing.wrap",
            "The range in which POS counts, from 0 on, in user units; 0 for no end. MOVEA stays within the turn.",
            "POSWRAP(0) = 360\nPOS(0) = 370\nPRINT POS(0)", default=0.0, low=0, high=8388607.0, group="state"),
    Keyword("POSROLLOVER", "", "setting", "RW", "axis", "integer", "sensing.turns",
            "How many times POS has wrapped.",
            "POSWRAP(0) = 360\nPOS(0) = 370\nPRINT POSROLLOVER(0)",
            default=0.0, low=-2147483648.0, high=2147483647.0, group="state"),
)  # fmt: skip
