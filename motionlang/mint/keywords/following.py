"""Following a master: gearing, flying shears, cams, offsets on top, and what the master is."""

from __future__ import annotations

from motionlang.lang.keyword import Keyword

_LARGEST = 8388607.0
_READY = "SPEED(0) = 100 : ACCEL(0) = 1000 : DECEL(0) = 1000\nMASTERCHANNEL(1) = 0\n"
_FLY = (
    _READY
    + "MASTERDISTANCE(1) = 10\nFLY(1) = 5\nFLY(1) = 5\nGO(1)\nMOVER(0) = 20\nGO(0)\nPAUSE IDLE(0)\nPRINT POS(1)"
)
_OFFSET = (
    _READY
    + "FOLLOW(1) = 1\nJOG(0) = 50\n{}WAIT = 1000\nOFFSET(1) = 10\nGO(1)\nWAIT = 2000\nPRINT POS(1) - POS(0)\nCANCELALL"
)


def _setting(
    name: str, short: str, unit: str, help: str, default: float, low: float, high: float, family: str = ""
) -> Keyword:
    return Keyword(name, short, "setting", "RW", "axis", unit, "following.masters.setting", help,
                   f"{name}(1) = 1\nPRINT {name}(1)", default=default, low=low, high=high,
                   group="following", family=family)  # fmt: skip


_SOURCES = (
    ("POS", "the position of an axis"),
    ("ENCODER", "an encoder"),
    ("AUXENCODER", "an auxiliary encoder"),
)
_OFFSET_MODES = (
    ("STANDARD", "ACCEL and DECEL, SPEED on top of the base speed"),
    ("SPEED_LIMIT", "the same within MAXSPEED and without reversing"),
    ("ACCEL_MOD", "over OFFSETDISTANCE of the master, half of it speeding up"),
    ("SPEED_MOD", "over OFFSETDISTANCE of the master at constant speed between ACCEL and DECEL"),
)
_STATUS = (
    ("MAXSPEED", "MAXSPEED was reached"),
    ("MINSPEED", "the axis came to rest"),
    ("MAXACCEL", "not done, it needs a higher acceleration"),
    ("MAXDECEL", "not done, it needs a higher deceleration"),
    ("PROFILEERROR", "not done, it needs an infinite acceleration"),
    ("ZEROACCEL", "not done, the acceleration is zero or less"),
)


def _constant(name: str, value: int, help: str) -> Keyword:
    return Keyword(name, "", "constant", "R", "none", "integer", str(value), help, f"PRINT {name}",
                   group="constants")  # fmt: skip


ROWS = (
    *(_constant(f"_ms{name}", n, f"MASTERSOURCE: {help}.") for n, (name, help) in enumerate(_SOURCES)),
    *(_constant(f"_of{name}", n, f"OFFSETMODE: {help}.") for n, (name, help) in enumerate(_OFFSET_MODES)),
    *(_constant(f"_os{name}", 1 << n, f"OFFSETSTATUS: {help}.") for n, (name, help) in enumerate(_STATUS)),
    _setting("MASTERSOURCE", "", "integer",
             "What MASTERCHANNEL is: _msPOS an axis, _msENCODER an encoder, _msAUXENCODER an auxiliary encoder.",
             0.0, 0, 2),
    _setting("MASTERCHANNEL", "", "integer", "The axis or encoder that the axis follows.", 0.0, 0, 63),
    _setting("MASTERDISTANCE", "", "number",
             "How far the master goes, in its own units, during a FLY or a segment of a cam; negative for backwards.",
             0.0, -_LARGEST, _LARGEST),
    _setting("FOLLOWMODE", "", "integer",
             "How FOLLOW begins: 0 at the master's speed at once, 1 with ramps at ACCEL and DECEL.", 0.0, 0, 1),
    Keyword("FOLLOW", "FL", "setting", "RW", "axis", "number", "following.follow",
            "Follow the master: units of this axis for each unit of the master. 0 ends it; no GO is needed.",
            _READY + "FOLLOW(1) = 0.5\nMOVER(0) = 100\nGO(0)\nPAUSE IDLE(0)\nPRINT POS(1)",
            default=0.0, low=-_LARGEST, high=_LARGEST, group="motion", effect="act follows"),
    Keyword("FOLLOWNUMERATOR", "", "setting", "RW", "axis", "number", "following.part",
            "FOLLOW is multiplied by this and divided by FOLLOWDENOM: 1 and 3 make an exact third.",
            _READY + "FOLLOWDENOM(1) = 3\nFOLLOWNUMERATOR(1) = 2\nFOLLOW(1) = 1\nMOVER(0) = 99\nGO(0)\n"
            "PAUSE IDLE(0)\nPRINT POS(1)", default=1.0, low=-_LARGEST, high=_LARGEST, group="motion"),
    Keyword("FOLLOWDENOM", "", "setting", "RW", "axis", "number", "following.part",
            "What FOLLOW is divided by.",
            _READY + "FOLLOWDENOM(1) = 3\nFOLLOW(1) = 1\nMOVER(0) = 99\nGO(0)\nPAUSE IDLE(0)\nPRINT POS(1)",
            default=1.0, low=1e-9, high=_LARGEST, group="motion"),
    _setting("GEARING", "GR", "%",
             "How much of the slave's lag GEARINGMODE corrects. Without a simulated motor there is no lag to correct.",
             100.0, -_LARGEST, _LARGEST, "gearing"),
    _setting("GEARINGMODE", "GRM", "integer", "1: the slave's lag behind its master is corrected, see GEARING.",
             0.0, 0, 1),
    Keyword("FLY", "", "move", "W", "axis", "uu", "following.fly",
            "Load a segment of a flying shear: go this distance while the master goes MASTERDISTANCE. Its ratio to the "
            "master changes evenly from that of the segment before, so two equal segments end at a ratio of 0.",
            _FLY, group="motion", effect="course follows"),
    Keyword("OFFSET", "", "move", "RW", "axis", "uu", "following.offset",
            "Load a distance on top of following; an axis that follows nobody moves by it. Reading it gives the "
            "distance still to go, of a move too.",
            _OFFSET.format(""), group="motion", effect="course follows", solved=True),
    Keyword("OFFSETMODE", "", "setting", "RW", "axis", "integer", "following.masters.setting",
            "How OFFSET is done: _ofSTANDARD, _ofSPEED_LIMIT, _ofACCEL_MOD or _ofSPEED_MOD.",
            _OFFSET.format("OFFSETMODE(1) = _ofSPEED_MOD : OFFSETDISTANCE(1) = 50\n"),
            default=0.0, low=0, high=3, group="following", family="offset modes"),
    _setting("OFFSETDISTANCE", "", "number",
             "How far the master goes during an OFFSET of mode 2 or 3, in its own units.", 0.0, -_LARGEST, _LARGEST),
    Keyword("OFFSETSTATUS", "OFS", "reading", "R", "axis", "bits", "offset_status",
            "How the last OFFSET went: the _os constants, 0 as wanted.",
            _OFFSET.format("") + "\nPRINT OFFSETSTATUS(1)", default=0.0, group="following"),
    Keyword("AUXENCODER", "", "setting", "RW", "auxchannel", "number", "following.auxiliary.position",
            "What an auxiliary encoder shows, in units of AUXENCODERSCALE.",
            "AUXENCODERMODE(0) = 8 : AUXENCODERSPEED(0) = 100\nWAIT = 500\nPRINT AUXENCODER(0)",
            default=0.0, group="encoders", driven="encoder", solved=True),
    Keyword("AUXENCODERVEL", "", "reading", "R", "auxchannel", "number", "following.auxiliary.velocity",
            "Speed of an auxiliary encoder, in units of AUXENCODERSCALE a second.",
            "AUXENCODERMODE(0) = 8 : AUXENCODERSPEED(0) = 100\nPRINT AUXENCODERVEL(0)", default=0.0, group="encoders"),
    Keyword("AUXENCODERMODE", "", "setting", "RW", "auxchannel", "integer", "following.auxiliary.mode",
            "8: the auxiliary encoder is a virtual axis, which runs at AUXENCODERSPEED. Other values have no effect.",
            "AUXENCODERMODE(0) = 8 : AUXENCODERSPEED(0) = 100\nWAIT = 500\nPRINT AUXENCODER(0)",
            default=0.0, low=0.0, high=2147483647.0, group="encoders"),
    Keyword("AUXENCODERSPEED", "", "setting", "RW", "auxchannel", "number", "following.auxiliary.speed",
            "The speed at which an auxiliary encoder of AUXENCODERMODE 8 counts by itself: a master without a machine.",
            "AUXENCODERMODE(0) = 8 : AUXENCODERSPEED(0) = 100\nWAIT = 500\nPRINT AUXENCODER(0)",
            default=0.0, low=-_LARGEST, high=_LARGEST, group="encoders"),
    *(
        Keyword(f"AUX{name}", "", "setting", "RW", "auxchannel", unit, "following.auxiliary.setting", help,
                f"AUX{name}(0) = 4\nPRINT AUX{name}(0)", default=default, low=low, high=_LARGEST, group="encoders")
        for name, unit, help, default, low in (
            ("ENCODERSCALE", "number", "Counts of an auxiliary encoder in one of its units.", 1.0, 1e-6),
            ("ENCODERPRESCALE", "integer", "What the counts of an auxiliary encoder are divided by first.", 1.0, 1),
            ("ENCODERWRAP", "number", "The range in which AUXENCODER counts, from 0 on; 0 for no end.", 0.0, 0),
        )
    ),
)  # fmt: skip
