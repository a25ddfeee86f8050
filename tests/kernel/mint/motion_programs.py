"""Random programs of motion keywords in any order, with valid and invalid values."""

from __future__ import annotations

from random import Random

_VALUES = ("0", "1", "-1", "5", "-7.5", "30", "100", "1e5", "0.001", "-1e5", "4", "2.5", "-30", "12")
_POSITIVE = ("1", "5", "30", "100", "0.5", "1000")
_TEXT = """
MOVER({a}) = {v}|MOVEA({a}) = {v}|VECTORR({a}, {b}) = {v}, {w}|VECTORA({a}, {b}) = {v}, {w}
CIRCLER({a}, {b}) = {v}, {p}, {g}|HELIXR(0, 1, 2) = {v}, {p}, {g}, {w}|GO({a})|GO(0, 1, 2)|STOP({a})|CANCEL({a})
SUSPEND({a}) = {i}|INCR({a}) = {v}|INCA({a}) = {v}|JOG({a}) = {v}
SPEED({a}) = {p}|ACCEL({a}) = {p}|DECEL({a}) = {p}|PROFILEMODE({a}) = {i}|ACCELJERKTIME({a}) = {m}|SRAMP({a}) = {m}
FEEDRATEMODE({a}) = {q}|FEEDRATEOVERRIDE({a}) = {m}|MAXSPEED({a}) = {p}
MAXACCEL({a}) = {p}|ACCELTIMEMAX({a}) = {p}|CONTOURMODE({a}) = {i}|CONTOURANGLE({a}) = {m}
MASTERCHANNEL({a}) = {b}|MASTERSOURCE({a}) = {t}|FOLLOW({a}) = {v}
FOLLOWMODE({a}) = {i}|FOLLOWDENOM({a}) = {p}|MASTERDISTANCE({a}) = {v}|FLY({a}) = {v}|OFFSET({a}) = {v}
OFFSETMODE({a}) = {q}|OFFSETDISTANCE({a}) = {v}|AUXENCODERMODE({b}) = 8 : AUXENCODERSPEED({b}) = {v}
CAMTABLE({a}, c, NULL)|CAMTABLE({a}, c, d)
CAM({a}) = {e}|CAMSTART({a}) = 2|CAMEND({a}) = {t}|CAMAMPLITUDE({a}) = {v}
SPLINETABLE({a}, c)|SPLINETABLE({a}, c, d, d)|SPLINE({a}) = {e}|SPLINE({a}) = 8 + {e}
SPLINETIME({a}) = 4|SPLINESUSPENDTIME({a}) = {m}|TRIGGERMODE({a}) = {q}|TRIGGERCHANNEL({a}) = {b}
TRIGGERVALUE({a}) = {v}|MOVEDWELL({a}) = {m}|MOVEOUTX({a}, 3) = 1|MOVEPULSEOUTX({a}, 3) = 20|POS({a}) = {v}
POSWRAP({a}) = 360|SCALEFACTOR({a}) = {p}|RESET({a})|DEFAULT({a})|MOVEBUFFERLOW({a}) = 1|WAIT = {m}|WAIT = 20|WAIT = 300
HTA({a}) = {h}|HTAKPROP({a}) = {v}|HTAKINT({a}) = {v}|HTADEADBAND({a}) = {m}|HTAFILTER({a}) = 0.5
PRINT VELERROR({a}), HTA({a}), JOG({a})
PRINT POS({a}), VEL({a}), OFFSET({a}), CAMINDEX({a}), SPLINEINDEX({a}), VELDEMANDPATH({a}), AXISMODE({a})
PRINT ACCELDEMAND({a}), OFFSETSTATUS({a}), ACCELTIMEMAX({a}), ACCELJERKTIME({a}), FOLLOW({a})
"""
_STATEMENTS = _TEXT.strip().replace("\n", "|").split("|")
_LOADS = ("MOVER", "MOVEA", "VECTORR", "VECTORA", "CIRCLER", "HELIXR", "FLY", "CAM", "SPLINE", "OFFSET")


def program(seed: int) -> str:
    """Return one program; a statement that fails is skipped."""
    random = Random(seed)
    lines = [
        "Dim c(5) As Float = 3, 10, 20, 5",
        "Dim d(5) As Float = 3, 30, 10, 40",
        "Dim s(3) As Float = 2, 7, 9",
        "MOVEBUFFERSIZE(0, 1, 2) = 50;",
    ]
    for _ in range(random.randint(5, 40)):
        text = _statement(random)
        lines.append(text)
        if text.split("(")[0] in _LOADS and random.random() < 0.5:
            lines.append("GO(0, 1, 2)")
    return "\n".join([*lines, "WAIT = 100", "End", "Event ONERROR", "End Event"])


def _statement(random: Random) -> str:
    first = random.choice((0, 0, 0, 1, 1, 2))
    return random.choice(_STATEMENTS).format(
        a=first,
        b=(first + 1) % 3,
        v=random.choice(_VALUES),
        w=random.choice(_VALUES),
        p=random.choice(_POSITIVE),
        g=random.choice(("90", "-180", "720", "0", "1e-9")),
        i=random.choice("01"),
        j=random.choice(("1", "-1", "0")),
        h=random.choice(("40", "-30", "0", "1e-3")),
        k=random.choice("1234567890") if random.random() < 0.9 else "10",
        t=random.choice("012"),
        q=random.choice("0123"),
        e=random.choice("01234567"),
        m=random.choice(("0", "10", "50", "100")),
    )
