"""Programs for forged logs: each kind of motion, begun, changed and ended."""

from __future__ import annotations

from motionlang.kernel import Run, Source
from tests.proof import run

_RATES = "SPEED(0) = 50 : ACCEL(0) = 100 : DECEL(0) = 200 : FEEDRATEMODE(0) = 2\n"
_SMOOTH = "PROFILEMODE(0) = 1 : ACCELJERK(0) = 500 : DECELJERK(0) = 900\n"
_REST = "PAUSE IDLE(0)\n"
_SLAVE = "SPEED(1) = 80 : ACCEL(1) = 300 : DECEL(1) = 400 : MASTERSOURCE(1) = _msPOS : MASTERCHANNEL(1) = 0\n"
_JOB = "MOVER(0) = 80 : GO(0) : PAUSE IDLE(0)\nMOVER(0) = -3 : GO(0) : PAUSE IDLE(0)\n"
_EVENTS = (
    "MOVER(0) = 200 : GO(0)\nWAIT 300\nSPEED(0) = 70\nWAIT 900\nSPEED(0) = 20\nWAIT 100\nDECEL(0) = 150\nWAIT 400\n"
    "FEEDRATEOVERRIDE(0) = 40\nWAIT 700\nMAXSPEED(0) = 5\nWAIT 400\nSUSPEND(0) = 1\nWAIT 500\nSUSPEND(0) = 0\n"
    "FEEDRATEOVERRIDE(0) = 100 : MAXSPEED(0) = 90\nWAIT 300\nACCEL(0) = 30\nWAIT 400\nSTOP(0)\nPAUSE IDLE(0)\n"
)  # fmt: skip
_JOGS = (
    "JOG(0) = 50\nWAIT 200\nJOG(0) = 60\nWAIT 700\nJOG(0) = 20\nWAIT 150\nJOG(0) = -30\nWAIT 800\nMAXSPEED(0) = 10\n"
    "WAIT 500\nSTOP(0)\nPAUSE IDLE(0)\n"
)  # fmt: skip
_PATH = "VECTORR(0, 1) = 30, 40 : GO(0)\nWAIT 300\nSPEED(0) = 20\nWAIT 700\nSPEED(0) = 60\n" + _REST
_SUSPENDED = (
    "VECTORR(0, 1) = 60, 20 : GO(0)\nWAIT 300\nFEEDRATEOVERRIDE(0) = 30\nWAIT 400\nSUSPEND(0) = 1\nWAIT 500\n"
    "SUSPEND(0) = 0\nWAIT 300\nMAXSPEED(1) = 2\nWAIT 500\nSTOP(0)\n" + _REST
)  # fmt: skip
_CONTOUR = (
    "MOVEBUFFERSIZE(0, 1, 2) = 9;\nCONTOURMODE(0) = 1 : CONTOURANGLE(0) = 20 : MAXACCEL(1) = 60 : MAXDECEL(1) = 90\n"
    "VECTORR(0, 1) = 20, 0\nCIRCLER(0, 1) = 0, 10, 90\nSPEED(0) = 30 : VECTORR(0, 1) = 0, 15\n"
    "HELIXR(0, 1, 2) = -8, 0, 180, 5\nVECTORR(0, 1) = 0, -10\nGO(0)\nPAUSE IDLE(0) And IDLE(1) And IDLE(2)\n"
)  # fmt: skip
_DRIVE = "JOG(0) = 30\nWAIT 700\n"
_STOP = "STOP(0) : PAUSE IDLE(0)\nWAIT 100\nSTOP(1) : PAUSE IDLE(1)\n"
_CAM = "Dim rise(5) As Float = 4, 10, 25, 20, 0\nMASTERDISTANCE(1) = 12\nCAMTABLE(1, rise)\n"

MINT = {
    "moves": _RATES + _JOB,
    "moves in S-ramps": _SMOOTH + _RATES + _JOB,
    "moves in times": "SPEED(0) = 50 : ACCELTIME(0) = 400 : DECELTIME(0) = 300\n" + _JOB,
    "S-ramps in times": "PROFILEMODE(0) = 1 : ACCELJERKTIME(0) = 100 : DECELJERKTIME(0) = 50\n" + _RATES + _JOB,
    "events": _RATES + _EVENTS,
    "events in S-ramps": _SMOOTH + _RATES + _EVENTS,
    "jogs": _RATES + _JOGS,
    "jogs in S-ramps": _SMOOTH + _RATES + _JOGS,
    "targets": _RATES + "MOVEA(0) = 100 : GO(0)\nWAIT 900\nINCA(0) = 60\nWAIT 600\nINCA(0) = -20\n" + _REST,
    "targets in S-ramps": (
        _SMOOTH + _RATES + "MOVEA(0) = 100 : GO(0)\nWAIT 900\nINCA(0) = 60\nWAIT 600\nINCA(0) = -20\n" + _REST
    ),
    "a limit": _RATES
    + "ERRORDECEL(0) = 700 : SOFTLIMITFORWARD(0) = 40 : SOFTLIMITMODE(0) = 3\nJOG(0) = 50\nWAIT 3000\n",
    "paths": _RATES + _PATH,
    "paths in S-ramps": _SMOOTH + _RATES + _PATH,
    "held paths": _RATES + _SUSPENDED,
    "held paths in S-ramps": _SMOOTH + _RATES + _SUSPENDED,
    "a contour": _RATES + _CONTOUR,
    "a contour in S-ramps": _SMOOTH + _RATES + _CONTOUR,
    "an arc": "MAXACCEL(0) = 70\n" + _RATES + "CIRCLER(0, 1) = -10, 0, 300 : GO(0)\n" + _REST,
    "gears": (
        _RATES + _SLAVE + "FOLLOWMODE(1) = 1 : FOLLOW(1) = 0.5\n" + _DRIVE + "FOLLOW(1) = -1.5\nWAIT 800\n"
        "SPEED(0) = 10 : OFFSET(1) = 7 : GO(1)\nWAIT 900\nJOG(0) = -20\nWAIT 500\n" + _STOP
    ),
    "two offsets": (
        _RATES + _SLAVE + "FOLLOWMODE(1) = 1 : FOLLOW(1) = 0.5\n" + _DRIVE + "OFFSET(1) = 30 : GO(1)\nWAIT 200\n"
        "OFFSET(1) = 12 : GO(1)\nWAIT 1500\n" + _STOP
    ),
    "gears at once": _RATES + _SLAVE + "FOLLOW(1) = 0.75\n" + _DRIVE + _STOP,
    "a cam": _RATES + _SLAVE + _CAM + "CAM(1) = 0 : GO(1)\n" + _DRIVE + "WAIT 800\n" + _STOP,
    "cams on and on": _RATES + _SLAVE + _CAM + "CAM(1) = _spCONTINUOUS : GO(1)\n" + _DRIVE + "WAIT 2500\n" + _STOP,
    "a shear": (
        _RATES + _SLAVE + "MOVEBUFFERSIZE(1) = 9 : MASTERDISTANCE(1) = 10\n"
        "FLY(1) = 5 : FLY(1) = 10 : FLY(1) = 5 : GO(1)\n"
        + _DRIVE + "WAIT 900\n" + _STOP
    ),
    "a spline": (
        _RATES + "Dim way(5) As Float = 4, 5, 10, 10, 5\nSPLINETABLE(0, way)\n"
        "SPLINETIME(0) = 500\nSPLINE(0) = 0 : GO(0)\n"
        "WAIT 600\nSUSPEND(0) = 1\nWAIT 300\nSUSPEND(0) = 0\n" + _REST
    ),
    "a dwell": _RATES + "MOVEBUFFERSIZE(0) = 9\nMOVER(0) = 30 : MOVEDWELL(0) = 250 : MOVER(0) = -30 : GO(0)\n" + _REST,
}  # fmt: skip

_BOARD = "1MN,1SV5000,1SA10000,1DS20000"
_SHAPE = "1MR6000,1WS0.1,1MR-300,1WS0.1\n1MR5000,WA0.4,1SV2000,1MA9000,WA0.3,1SV6000,1MA4000,WA0.5,1ST,1WS0\n"
_MODE = "1VM,1DI0,1GO,WA0.8,1SV2000,1GO,WA0.6,1SV6000,1GO,WA0.3,1ST,1WS0\n"
MCCL = {
    "trapezoids of PMC": f"{_BOARD},1PT\n" + _SHAPE,
    "S-curves of PMC": f"{_BOARD},1PS0.2\n" + _SHAPE,
    "parabolas of PMC": f"{_BOARD},1PP\n" + _SHAPE,
    "velocity mode": f"{_BOARD},1PT\n" + _MODE,
    "velocity mode in S-curves": f"{_BOARD},1PS0.2\n" + _MODE,
    "a contour of PMC": (
        "1US1000,2US1000,1MN,2MN\n1CM1,2CM1,1VV50,1VA200,1VD300\n1SN\n1CP1,1MA20,2MA0\n1CP3,1CA20,2CA5,1MA20,2MA10\n"
        "1CP1,1MA0,2MA10\n1GO,1WS0\n1NS,1CP2,1RR20,1MA20,2MA30,1WS0\n"
    ),
    "gears of PMC": f"{_BOARD}\n2MN,3MN,2SS0.666667,2SM1,3SS-1,3SM2\n1MR3000,WA0.3,2SS0.25,1WS0.1\n",
}  # fmt: skip

PROGRAMS = {f"{name}.mnt": text for name, text in MINT.items()} | {
    f"{name}.mcl": text for name, text in MCCL.items()
}


def ran(name: str) -> Run:
    """Return the run of a program, prepared for a proof."""
    machine = {"controller.instruction_time": 1e-9}
    return run(Source(name, PROGRAMS[name]), machine=machine, until=60.0)
