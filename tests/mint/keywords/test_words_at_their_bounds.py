"""Keywords at the ends of their ranges and at the borders between two behaviours."""

from __future__ import annotations

import pytest

from motionlang import run
from motionlang.source import Source

RATES = "SPEED(0) = 100 : ACCEL(0) = 1000 : DECEL(0) = 1000\n"
EXACT: dict[str, object] = {"controller.instruction_time": 1e-9}
PLANT: dict[str, object] = {"axis.0.plant.inertia": 2e-4, "axis.0.plant.viscous": 1e-4}


def volts(*values: float, at: float = 0.0) -> dict[str, object]:
    """Return a machine whose analogue inputs 0, 1 and so on have these values, %."""
    entries = [{"channel": n, "at": at, "value": value} for n, value in enumerate(values)]
    return {**EXACT, "analogue": entries}


# A rule, the program, its output, and the machine.
WORDS: dict[str, tuple[str, list[str], dict[str, object]]] = {
    # -------------------------------------------------------------------------------- digital inputs and outputs
    "a bank has 32 inputs, the last of which is the sign": (
        "INPUTACTIVELEVEL(1) = 0\nPRINT INX(31), INX(32), INX(63), INX(64), ' ', IN(1)".replace("'", '"'),
        ["0110 -1"], {}),
    "a bit of INPUTACTIVELEVEL is that of its input": (
        "INPUTACTIVELEVEL(0) = -6\nPRINT INX(0), INX(1), INX(2), INX(3)\nPRINT INPUTACTIVELEVEL(0), IN(0)",
        ["1010", "-65"], {}),
    "the last input is 999, and the last bank 31": ("PRINT INX(999), IN(31)", ["00"], {}),
    "the last output is 999, and the last bank 31": (
        "OUTX(999) = 1 : OUTX(0) = 5 : PRINT OUTX(999), OUTX(0), OUT(31), OUT(0)", ["111281"], {}),
    "a bank of outputs is read as it was written, with its sign": (
        "OUT(1) = -2147483647 : PRINT OUT(1), OUTX(32), OUTX(33), OUTX(63), OUTX(64), OUTX(31)",
        ["-214748364710100"], {}),
    "a bit of OUTPUTACTIVELEVEL is that of its output": (
        "OUTPUTACTIVELEVEL(1) = -2 : PRINT OUTPUTACTIVELEVEL(1), OUTPUTACTIVELEVEL(0), OUTX(32)", ["-2-10"], {}),
    "a pulse lasts its milliseconds": (
        "PULSEOUTX(3) = 20 : WAIT 19 : PRINT OUTX(3) : WAIT 2 : PRINT OUTX(3)", ["1", "0"], EXACT),
    "relays have two banks of 32, and RELAY is the first of a bank": (
        "RELAYOUT(1) = -2147483647 : RELAY(0) = 1 : RELAYOUTX(2) = 1\n"
        "PRINT RELAYOUT(1), RELAYOUTX(32), RELAYOUTX(63), RELAYOUTX(62), RELAY(1), RELAYOUT(0), RELAYOUTX(1)",
        ["-2147483647110150"], {}),
    "a relay is no output": ("RELAYOUTX(3) = 1 : PRINT OUTX(3), OUT(0)", ["00"], {}),
    # ------------------------------------------------------------------------------------------- analogue channels
    # 40 % · 150 % - 10 % is 50 %.
    "an input has a gain and then an offset": (
        "ADCGAIN(0) = 150 : ADCOFFSET(0) = -10 : PRINT ADC(0)", ["50.0000"], volts(40.0)),
    "an input ends at 100 and -100, or at 0": (
        "ADCGAIN(0) = 300 : PRINT ADC(0), ADC(1)\nADCGAIN(1) = 300 : PRINT ADC(1) : ADCMODE(1) = 1 : PRINT ADC(1)",
        ["100.0000-40.0000", "-100.0000", "0.0000"], volts(40.0, -40.0)),
    "a dead band is around its middle and without its ends": (
        "ADCDEADBAND(0) = 5 : ADCDEADBANDOFFSET(0) = 10 : ADCDEADBAND(1) = 5 : ADCDEADBANDOFFSET(1) = 10\n"
        "ADCDEADBAND(2) = 5 : ADCDEADBANDOFFSET(2) = 10 : PRINT ADC(0), ' ', ADC(1), ' ', ADC(2)".replace("'", '"'),
        ["15.0000 10.0000 5.0000"], volts(15.0, 14.5, 5.0)),
    # The level is 40 %, and with the gain 80 %.
    "ADCOFFSETTRIM makes the present value 0": (
        "ADCGAIN(0) = 200 : ADCOFFSETTRIM(0) : PRINT ADC(0), ADCOFFSET(0)", ["0.0000-80.0000"], volts(40.0)),
    "DAC and AUXDAC are different outputs": (
        "DAC(0) = 20 : AUXDAC(0) = -30 : PRINT DAC(0), AUXDAC(0)", ["20.0000-30.0000"], {}),
    "a value on a limit is within it": (
        "ADCMAX(0) = 40 : ADCMIN(1) = -40 : ADCMONITOR(0) = 3\nPRINT ADCERROR(0), AXISERROR(0)\n"
        "ADCMAX(0) = 39.5 : PRINT AXISERROR(0) : ADCMAX(0) = 40 : AXISERROR(0) = 0 : PRINT AXISERROR(0)\n"
        "ADCMIN(1) = -39.5 : PRINT AXISERROR(0)", ["00", "128", "0", "128"], volts(40.0, -40.0)),
    # Marks are 10 apart. From 25 the axis goes back over the mark at 20, and over that once more.
    "a latch catches an index mark in both directions, and again on the way back": (
        RATES + "LATCHTRIGGERMODE(0) = 1 : LATCHENABLE(0) = 1 : LATCHMODE(0) = 1\n"
        "MOVEA(0) = 25 : GO(0) : PAUSE IDLE(0) : PRINT LATCH(0), LATCH(0), LATCHVALUE(0)\n"
        "MOVEA(0) = 15 : GO(0) : PAUSE IDLE(0) : PRINT LATCH(0), LATCHVALUE(0)\n"
        "MOVEA(0) = 25 : GO(0) : PAUSE IDLE(0) : PRINT LATCH(0), LATCHVALUE(0)\n"
        "MOVEA(0) = -15 : GO(0) : PAUSE IDLE(0) : PRINT LATCH(0), LATCHVALUE(0)",
        ["1020.0000", "120.0000", "120.0000", "1-10.0000"], {**EXACT, "axis.0.index_every": 10.0}),
    "a latch of one mark is armed again by LATCHENABLE, which forgets the mark": (
        RATES + "LATCHTRIGGERMODE(0) = 1 : LATCHENABLE(0) = 1\n"
        "MOVEA(0) = 25 : GO(0) : PAUSE IDLE(0) : PRINT LATCH(0), LATCH(0), LATCHENABLE(0), LATCHVALUE(0)\n"
        "LATCHENABLE(0) = 1 : PRINT LATCH(0), LATCHENABLE(0)\n"
        "MOVEA(0) = 5 : GO(0) : PAUSE IDLE(0) : PRINT LATCH(0), LATCHVALUE(0)",
        ["11010.0000", "01", "120.0000"], {**EXACT, "axis.0.index_every": 10.0}),
    # The mark at -10 is 0 from the last one, and the mark at 0 is 10 from it.
    "a latch ignores marks nearer than its distance, and marks within its time": (
        RATES + "LATCHTRIGGERMODE(0) = 1 : LATCHENABLE(0) = 1 : LATCHMODE(0) = 1\n"
        "MOVEA(0) = -15 : GO(0) : PAUSE IDLE(0) : PRINT LATCH(0), LATCHVALUE(0) : LATCHINHIBITVALUE(0) = 10\n"
        "MOVEA(0) = -9 : GO(0) : PAUSE IDLE(0) : PRINT LATCH(0)\n"
        "MOVEA(0) = 1 : GO(0) : PAUSE IDLE(0) : PRINT LATCH(0), LATCHVALUE(0)\n"
        "LATCHINHIBITVALUE(0) = 0 : LATCHINHIBITTIME(0) = 1000 : PRINT LATCHINHIBITTIME(0)\n"
        "MOVEA(0) = 21 : GO(0) : PAUSE IDLE(0) : PRINT LATCH(0), LATCHVALUE(0)\n"
        "WAIT 1000 : MOVEA(0) = 41 : GO(0) : PAUSE IDLE(0) : PRINT LATCH(0), LATCHVALUE(0)",
        ["1-10.0000", "0", "10.0000", "1000", "00.0000", "130.0000"], {**EXACT, "axis.0.index_every": 10.0}),
    "the last of 32 monitored inputs is the sign, and no other input counts": (
        "ADCMAX(31) = 10 : ADCMAX(0) = 10 : PRINT ADCERROR(0) : ADCMONITOR(0) = 2 : PRINT ADCERROR(0), AXISERROR(0)\n"
        "ADCMONITOR(0) = -2147483648 : PRINT ADCERROR(0), AXISERROR(0), ADCERROR(1)",
        ["0", "00", "-21474836481280"],
        {"analogue": [{"channel": channel, "at": 0.0, "value": 40.0} for channel in (0, 31)]}),
    # Banks at 0, 10, 20, 30 and 40 ms. Input 0 is active low and off, input 2 on from 10 to 30 ms, input 31 from 25 ms.
    "a capture records banks and channels as they were": (
        "Dim k As Integer\nCAPTUREMODE(0) = 13 : CAPTUREMODE(1) = 14 : CAPTUREMODE(2) = 12 : CAPTUREMODE(3) = 11\n"
        "CAPTUREMODEPARAMETER(2) = 1 : CAPTUREMODEPARAMETER(3) = 1 : ADCGAIN(1) = 50 : INPUTACTIVELEVEL(0) = -2\n"
        "CAPTURENUMPOINTS = 5 : CAPTUREPERIOD = 10000 : CAPTURE = 1 : OUTX(3) = 1\n"
        "WAIT 15 : DAC(1) = 25 : OUTX(3) = 0 : OUTX(1) = 1 : OUTX(32) = 1 : PAUSE CAPTURESTATUS = 3\nFor k = 0 To 4\n"
        'PRINT Int(CAPTUREPOINT(0, k)), " ", Int(CAPTUREPOINT(1, k)), " ", CAPTUREPOINT(2, k), " ",\n'
        "PRINT CAPTUREPOINT(3, k)\nNext",
        ["1 0 0.0000 0.0000", "5 8 0.0000 0.0000", "5 2 25.0000 20.0000", "-2147483647 2 25.0000 20.0000",
         "-2147483647 2 25.0000 20.0000"],
        {**EXACT, "input": [{"channel": 2, "at": 0.01, "for": 0.02}, {"channel": 31, "at": 0.025},
                            {"channel": 32, "at": 0.01}],
         "analogue": [{"channel": 1, "at": 0.02, "value": 40.0}, {"channel": 2, "at": 0.01, "value": 60.0}]}),
    # A unit of length has 4 counts, and one of speed 40.
    "a capture has the units of what it records": (
        "SPEED(0) = 2000 : ACCEL(0) = 20000 : DECEL(0) = 20000 : MOVER(0) = 1000 : GO(0)\n"
        "CAPTUREMODE(0) = 6 : CAPTUREMODE(1) = 2 : CAPTUREMODE(2) = 1 : CAPTURENUMPOINTS = 1 : SCALE(0) = 4\n"
        "VELSCALEFACTOR(0) = 40 : WAIT 250 : CAPTURE = 1\n"
        "PRINT Abs(CAPTUREPOINT(1, 0) - 50) < 0.1, FOLERROR(0) > 5e-4\n"
        "PRINT Abs(CAPTUREPOINT(0, 0) - FOLERROR(0)) < 1e-4, Abs(CAPTUREPOINT(2, 0) - POS(0)) < 1e-4",
        ["11", "11"], {**PLANT, **EXACT}),
    # The move takes 0.1 + 0.4 + 0.1 s.
    "IDLETIME is added to a move of a motor that stays within IDLEPOS": (
        "SPEED(0) = 2000 : ACCEL(0) = 20000 : DECEL(0) = 20000 : IDLEMODE(0) = 1 : IDLEPOS(0) = 30 : IDLETIME(0) = 50\n"
        'MOVER(0) = 1000 : GO(0) : PAUSE IDLE(0) : PRINT TIME, " ", IDLESETTLINGTIME(0) : IDLETIME(0) = 200\n'
        'MOVER(0) = 1000 : TIME = 0 : GO(0) : PAUSE IDLE(0) : PRINT TIME, " ", IDLESETTLINGTIME(0) : IDLEMODE(0) = 0\n'
        'MOVER(0) = 1000 : TIME = 0 : GO(0) : PAUSE IDLE(0) : PRINT TIME, " ", IDLESETTLINGTIME(0)',
        ["650 50", "800 200", "600 0"], {**PLANT, **EXACT}),
    # 10 at 100 per second and 1000 per s² take 0.2 s.
    "IDLETIME applies to a wait of one task that another task has set it for": (
        RATES + "Run Other\nMOVER(0) = 10 : GO(0) : PAUSE IDLE(0) : PRINT TIME\nEnd\n"
        "Task Other\n  WAIT 100\n  IDLEMODE(0) = 1 : IDLEPOS(0) = 5 : IDLETIME(0) = 30\nEnd Task", ["230"], EXACT),
    # The inputs are on for 0.1 s from 500, 1499.5 and 2100.5 ms.
    "a latch ignores edges of its input within its time": (
        "LATCHTRIGGERCHANNEL(0) = 3 : LATCHMODE(0) = 1 : LATCHINHIBITTIME(0) = 1000 : LATCHENABLE(0) = 1\n"
        "WAIT 600 : PRINT LATCH(0) : WAIT 1000 : PRINT LATCH(0) : WAIT 600 : PRINT LATCH(0)", ["1", "0", "1"],
        {**EXACT, "input": [{"channel": 3, "at": at, "for": 0.1} for at in (0.5, 1.4995, 2.1005)]}),
    "a field of a preset is an integer or a number, and a rate or a time": (
        "PRESETMOVESPEED(2) = 2.5 : PRESETMOVETYPE(2, 0) = 1 : PRESETACCEL(2, 1) = 7 : PRESETDECEL(2, 0) = 3.5\n"
        'PRINT PRESETMOVESPEED(2), " ", PRESETMOVETYPE(2, 0), " ", PRESETDECEL(2, 0), " ", PRESETMOVESPEED(1)',
        ["2.5000 1 3.5000 0.0000"], {}),
    # 1000 counts per second are 250 units: 100 is reached at 400 ms, and the move takes 200 ms.
    "a move starts at a position of an encoder, in its units": (
        RATES + "ENCODERSCALE(5) = 4 : TRIGGERSOURCE(0) = 1 : TRIGGERCHANNEL(0) = 5 : TRIGGERVALUE(0) = 100\n"
        "TRIGGERMODE(0) = 3 : MOVER(0) = 10 : PAUSE POS(0) = 10 : PRINT TIME", ["600"],
        {**EXACT, "encoder": [{"channel": 5, "velocity": 1000.0}]}),
    # Segments of 10 in 0.5 s, to the velocities 20, 30 and 40, from rest and later from 40. In the middle of one from v
    # to w the axis has gone 5 + 0.5 (v - w) / 8: 3.75 from 0 to 20, and 6.25 from 40 to 20.
    "a spline with velocities goes on at its last one": (
        "Dim p(4) As Float = 3, 10, 10, 10\nDim v(4) As Float = 3, 20, 30, 40\nDim t(4) As Float = 3, 500, 500, 500\n"
        "SPLINETABLE(0, p, v, t) : SPLINE(0) = 4 : GO(0)\n"
        'WAIT 250 : PRINT POS(0) : WAIT 1250 : PRINT POS(0), " ", VEL(0) : WAIT 250 : PRINT POS(0)\n'
        'WAIT 250 : PRINT POS(0), " ", VEL(0) : CANCEL(0)',
        ["3.7500", "30.0000 40.0000", "36.2500", "40.0000 20.0000"], EXACT),
    # The largest 32-bit Float is 3.4e38; 0x7F80 and 0xFF80 are the upper halves of the infinite ones.
    "a Float beyond 32 bits is infinite in a register of Modbus": (
        "MODBUSTCPFLOAT(1, 5) = -1e39 : MODBUSTCPFLOAT(1, 7) = 1e39 : MODBUSTCPFLOAT(1, 9) = -2.5\n"
        'PRINT MODBUSTCPFLOAT(1, 5), " ", MODBUSTCPFLOAT(1, 7), " ", MODBUSTCPFLOAT(1, 9)\n'
        'PRINT MODBUSTCP16(1, 6), " ", MODBUSTCP16(1, 8), " ", MODBUSTCP16(1, 5)',
        ["-Inf Inf -2.5000", "65408 32640 0"], {}),
    "ERRORCLEAR clears the errors of the controller with its group": (
        "WAIT 20 : PRINT MISCERROR : ERRORCLEAR(_egAXIS, 0) : PRINT MISCERROR\n"
        "ERRORCLEAR(_egMISC, 0) : PRINT MISCERROR\n"
        "WAIT 20 : PRINT MISCERROR : ERRORCLEAR(_egALL, 0) : PRINT MISCERROR\nEnd\nEvent ONERROR\nEnd Event",
        ["2", "2", "0", "4", "0"],
        {**EXACT, "fault": [{"kind": "controller", "at": at, "value": bits} for at, bits in ((0.01, 2), (0.03, 4))]}),
    "of the errors that call no handler the newest is read": (
        "Dim n As Integer\nERRORMASKCODE(3, 0) = 1 : ERRORMASKCODE(1001, 0) = 1\nSPEED(0) = -1 - n\nPRINT 1 / n\n"
        'PRINT ERRCODE, " ", ERRLINE\nEnd\nEvent ONERROR\nEnd Event', ["1001 4"], {}),
    "a jerk time may be long": (
        "ACCEL(0) = 10 : DECEL(0) = 10 : ACCELJERK(0) = 1 : DECELJERK(0) = 2\n"
        'PRINT ACCELJERKTIME(0), " ", DECELJERKTIME(0)', ["10000 5000"], {}),
    # The error is 1. From 10 to 11 ms the sum of errors rises from 9 to 10, and again 10 ms after it was cleared.
    "a new HTAKINT clears the sum of errors": (
        RATES + "HTACHANNEL(0) = 1 : HTAKPROP(0) = 0.5 : HTAKINT(0) = 0.25 : HTA(0) = 21 : WAIT 10.5 : PRINT VEL(0)\n"
        "HTAKINT(0) = 0.5 : WAIT 10 : PRINT VEL(0)", ["2.8750", "5.2500"], volts(0.0, 20.0)),
    "a spare analogue output is no other one": (
        'AUXDAC(1) = 20 : AUXDAC(2) = 30 : PRINT DAC(63), " ", DAC(62), " ", AUXDAC(1), " ", AUXDAC(2)',
        ["0.0000 0.0000 20.0000 30.0000"], {}),
    # 100 % take 200 ms up and 100 ms down: from 30 to 0 in 30 ms, then to -5 in 10 ms.
    "a torque falls to 0 in its own time, rises behind it, and begins at 0 after a stop": (
        "TORQUEREFRISETIME(0) = 200 : TORQUEREFFALLTIME(0) = 100 : TORQUEREF(0) = 30\n"
        "WAIT 20.5 : PRINT TORQUEDEMAND(0) : WAIT 60 : PRINT TORQUEDEMAND(0) : TORQUEREF(0) = -10\n"
        "WAIT 20 : PRINT TORQUEDEMAND(0) : WAIT 20 : PRINT TORQUEDEMAND(0), TORQUEREF(0)\n"
        "CANCEL(0) : TORQUEREF(0) = 20 : WAIT 20.5 : PRINT TORQUEDEMAND(0) : CANCEL(0)",
        ["10.0000", "30.0000", "10.0000", "-5.0000-10.0000", "10.0000"], {**PLANT, **EXACT}),
    "TORQUEREFSOURCE is the number of an analogue input plus 1": (
        "TORQUEREFSOURCE(0) = 2 : WAIT 2 : PRINT TORQUEDEMAND(0) : TORQUEREFENABLE(0) = 0 : WAIT 2\n"
        "PRINT TORQUEDEMAND(0) : TORQUEREFENABLE(0) = 1 : TORQUEREFSOURCE(0) = 1 : WAIT 2 : PRINT TORQUEDEMAND(0)\n"
        "CANCEL(0)",
        ["20.0000", "0.0000", "15.0000"], {**PLANT, **volts(15.0, 20.0)}),
    # A window of 0 is not that of the mode.
    "IDLEMODE chooses the window of the speed or that of the error": (
        "SPEED(0) = 2000 : ACCEL(0) = 20000 : DECEL(0) = 20000 : IDLETIME(0) = 50\n"
        "IDLEMODE(0) = 2 : IDLEPOS(0) = 0 : IDLEVEL(0) = 10000 : MOVER(0) = 1000 : GO(0) : PAUSE IDLE(0) : PRINT TIME\n"
        "IDLEMODE(0) = 1 : IDLEPOS(0) = 30 : IDLEVEL(0) = 0 : MOVER(0) = 1000 : GO(0) : PAUSE IDLE(0) : PRINT TIME",
        ["650", "1300"], {**PLANT, **EXACT}),
    "ERRDATA counts the data of an error from 1": (
        "MISCERRORDISABLE = 4 : WAIT 20\nPRINT ERRCODE, ERRDATA(0), ERRDATA(1), ERRDATA(2)\nEnd\n"
        "Event ONERROR\nEnd Event", ["20000040"],
        {"fault": [{"kind": "controller", "at": 0.01, "value": 4}]}),
    "a ramp time is that of the rate, or the one written": (
        'SPEED(0) = 100 : ACCEL(0) = 1 : DECEL(0) = 2 : PRINT ACCELTIME(0), " ", DECELTIME(0)\n'
        'ACCELTIME(0) = 50 : PRINT ACCELTIME(0), " ", ACCEL(0), " ", DECEL(0)',
        ["100000 50000", "50 2000.0000 2.0000"], {}),
    # Segments of 10. The phase begins with the second cycle, at 40, where segments 2 and 3 are 13 long: from 50 to 76.
    "CAMPHASESTATUS is 1 until the last of its segments is over": (
        RATES + "Dim r(5) As Float = 4, 1, 2, 2, 1\nSPEED(1) = 1000 : ACCEL(1) = 10000 : DECEL(1) = 10000\n"
        "MASTERCHANNEL(1) = 0 : CAMTABLE(1, r) : MASTERDISTANCE(1) = 10 : PRINT CAMPHASESTATUS(1)\n"
        "CAM(1) = 4 : GO(1) : PRINT CAMPHASESTATUS(1) : CAMPHASE(1, 2, 2, 6) : PRINT CAMPHASESTATUS(1)\n"
        "JOG(0) = 100 : PAUSE POS(0) > 41 : PRINT CAMPHASESTATUS(1) : PAUSE POS(0) > 75.9 : PRINT CAMPHASESTATUS(1)\n"
        "PAUSE POS(0) > 76.1 : PRINT CAMPHASESTATUS(1) : CANCEL(1)\n"
        "CAMPHASE(1, 2, 2, 6) : PRINT CAMPHASESTATUS(1) : CANCEL(0)", ["0", "0", "1", "1", "1", "0", "0"], EXACT),
    "CAMPHASE leaves some travel in each segment": (
        "Dim r(5) As Float = 4, 1, 2, 2, 1\nMASTERCHANNEL(1) = 0 : CAMTABLE(1, r) : MASTERDISTANCE(1) = 10\n"
        "CAMPHASE(1, 1, 4, -39) : CAMPHASE(1, 2, 1, -9) : PRINT CAMPHASESTATUS(1)", ["0"], {}),
    "a capture and its triggers begin without a quantity, a channel and a value": (
        "PRINT CAPTUREMODE(7), CAPTUREAXIS(0), CAPTUREMODEPARAMETER(7), CAPTURETRIGGERMODE(1)\n"
        "PRINT CAPTURETRIGGERSOURCE(0), CAPTURETRIGGERCHANNEL(0), CAPTURETRIGGERVALUE(1), CAPTURETRIGGERABSOLUTE(0)",
        ["0000", "000.00000"], {}),
    # 15 ms after its start a capture has one whole period of 10 ms before the trigger, in which the axis goes 1.
    "a trigger before the time before it leaves the points since the start": (
        RATES + "CAPTUREMODE(0) = 3 : CAPTURENUMPOINTS = 5 : CAPTUREPERIOD = 10000 : CAPTUREPRETRIGGERDURATION = 30\n"
        "JOG(0) = 100 : WAIT 1000 : CAPTURETRIGGERSOURCE(0) = 13 : CAPTURETRIGGERMODE(0) = 1 : CAPTURECOMMAND = 1\n"
        "WAIT 15 : CAPTURETRIGGER : PRINT POS(0) - CAPTUREPOINT(0, 0) : STOP(0)", ["1.0000"], EXACT),
    # The move takes 600 ms.
    "the time to settle is that from the end of the move to IDLE": (
        "SPEED(0) = 2000 : ACCEL(0) = 20000 : DECEL(0) = 20000 : IDLEMODE(0) = 2 : IDLEVEL(0) = 1 : IDLETIME(0) = 50\n"
        "MOVER(0) = 1000 : GO(0) : PAUSE IDLE(0)\n"
        "PRINT IDLESETTLINGTIME(0) > 60, Abs(TIME - 600 - IDLESETTLINGTIME(0)) < 2", ["11"], {**PLANT, **EXACT}),
    "the last of the controller's own registers": (
        "HOLDINGREGISTER(1999) = 5 : PRINT HOLDINGREGISTER(1999), HOLDINGREGISTER(1998)", ["50"], {}),
    "a cam box may switch 32767 ms ahead": (
        "Dim p(3) As Float = 2, 10, 20\nCAMBOXDATA(0, 5, 0, 0, 32767, p) : CAMBOX(0) = 1 : PRINT CAMBOX(0)", ["1"], {}),
    # ------------------------------------------------------------------------------------------------------ encoders
    # 1000 counts, divided by 5 and by 4.
    "an encoder is prescaled, scaled and shifted": (
        RATES + "ENCODERPRESCALE(0) = 5 : ENCODERSCALE(0) = 4 : MOVER(0) = 1000 : GO(0) : PAUSE IDLE(0)\n"
        "PRINT ENCODER(0), ENCODERCOUNT(0) : ENCODER(0) = 7 : PRINT ENCODER(0)\n"
        "MOVER(0) = -100 : GO(0) : PAUSE IDLE(0) : PRINT ENCODER(0), ENCODERCOUNT(0)",
        ["50.00001000", "7.0000", "2.0000900"], {}),
    # 1000 counts per second are 50 units: 50 to 55 takes 0.1 s, and 55 to the wrap at 60 as long again.
    "PAUSE ends when an encoder of the machine file crosses the level": (
        "ENCODERSCALE(5) = 4 : ENCODERPRESCALE(5) = 5 : ENCODER(5) = 50 : PAUSE ENCODER(5) > 55 : PRINT TIME\n"
        "ENCODERWRAP(5) = 60 : PAUSE ENCODER(5) < 5 : PRINT TIME : PAUSE ENCODER(5) >= 2.5 : PRINT TIME\n"
        "PAUSE ENCODER(5) > 70 OR TIME >= 2000 : PRINT TIME",
        ["100", "200", "250", "2000"], {**EXACT, "encoder": [{"channel": 5, "velocity": 1000.0}]}),
    # The ramp of 0.1 s puts the axis 5 behind: it is at 100.05 after 1050.5 ms. PAUSE tests that every millisecond.
    "PAUSE ends when the encoder of an axis has crossed the level": (
        RATES + "JOG(0) = 100 : PAUSE ENCODER(0) > 100.05 : PRINT TIME\n"
        "PAUSE ENCODER(0) >= 110.55 : PRINT TIME", ["1051", "1156"], EXACT),
    "a virtual encoder runs at AUXENCODERSPEED, in its units, until another mode ends that": (
        "AUXENCODERSCALE(1) = 4 : AUXENCODERSPEED(1) = 50 : WAIT 100\n"
        'PRINT AUXENCODER(1), " ", AUXENCODERSPEED(1), " ", AUXENCODERMODE(1)\n'
        'AUXENCODERMODE(1) = 8 : WAIT 1000 : PRINT AUXENCODER(1), " ", AUXENCODERVEL(1), " ", AUXENCODER(0)\n'
        'AUXENCODERSPEED(1) = 100 : WAIT 1000 : PRINT AUXENCODER(1), " ", AUXENCODERVEL(1)\n'
        'AUXENCODERMODE(1) = 0 : WAIT 1000 : PRINT AUXENCODER(1), " ", AUXENCODERVEL(1), " ", AUXENCODERMODE(1)',
        ["0.0000 50.0000 0", "50.0000 50.0000 0.0000", "150.0000 100.0000", "150.0000 0.0000 0"], EXACT),
    "OKTOLOADMOVE is 1 if all of the axes have space, do not stop and are enabled": (
        "Dim a(3) As Integer = 0, 1, 2\n" + RATES + "PRINT OKTOLOADMOVE(3, a) : MOVER(1) = 5 : MOVER(1) = 5\n"
        "PRINT OKTOLOADMOVE(3, a), OKTOLOADMOVE(1, a), OKTOLOADMOVE(2, a) : GO(1) : PAUSE IDLE(1)\n"
        "PRINT OKTOLOADMOVE(3, a) : JOG(0) = 50 : WAIT 500 : STOP(0) : WAIT 1 : PRINT OKTOLOADMOVE(3, a)\n"
        "PAUSE IDLE(0) : PRINT OKTOLOADMOVE(3, a) : DRIVEENABLE(2) = 0\n"
        "PRINT OKTOLOADMOVE(3, a), OKTOLOADMOVE(2, a)", ["1", "010", "1", "0", "1", "01"], EXACT),
    "the clock counts whole seconds from its date on": (
        'REALTIMECLOCK = "2024-02-28 23:59:59" : WAIT 900 : PRINT REALTIMECLOCK : WAIT 200 : PRINT REALTIMECLOCK',
        ["2024-02-28 23:59:59", "2024-02-29 00:00:00"], EXACT),
    "an encoder wraps at its end": (
        RATES + "ENCODERWRAP(0) = 360 : MOVER(0) = 360 : GO(0) : PAUSE IDLE(0) : PRINT ENCODER(0)\n"
        "MOVER(0) = -1 : GO(0) : PAUSE IDLE(0) : PRINT ENCODER(0)", ["0.0000", "359.0000"], {}),
    "POSROLLOVER counts the wraps in both directions": (
        RATES + "POSWRAP(0) = 360 : MOVER(0) = 725 : GO(0) : PAUSE IDLE(0) : PRINT POS(0), POSROLLOVER(0)\n"
        "MOVER(0) = -730 : GO(0) : PAUSE IDLE(0) : PRINT POS(0), POSROLLOVER(0)\n"
        "POSROLLOVER(0) = 3 : PRINT POS(0), POSROLLOVER(0) : POSWRAP(0) = 0 : PRINT POS(0)",
        ["5.00002", "355.0000-1", "355.00003", "1435.0000"], {}),
    "POSWRAP is a distance of the axis, in units of any scale": (
        "POSWRAP(0) = 360 : SCALEFACTOR(0) = 10 : PRINT POSWRAP(0) : SCALEFACTOR(0) = 20 : PRINT POSWRAP(0)",
        ["36.0000", "18.0000"], {}),
    "ACCELDEMAND is that of each ramp": (
        RATES + "MOVER(0) = 50 : GO(0) : WAIT 50 : PRINT ACCELDEMAND(0) : WAIT 100 : PRINT ACCELDEMAND(0)\n"
        "WAIT 400 : PRINT ACCELDEMAND(0), VELDEMAND(0) : PAUSE IDLE(0) : PRINT ACCELDEMAND(0)",
        ["1000.0000", "0.0000", "-1000.000050.0000", "0.0000"], EXACT),
    "AXISMODE is 2 for a jog and 1 for a move, and 1024 more while it is suspended": (
        RATES + "PRINT AXISMODE(0) : JOG(0) = 5 : PRINT AXISMODE(0) : STOP(0) : PAUSE IDLE(0)\n"
        "MOVER(0) = 5 : PRINT AXISMODE(0) : GO(0) : PRINT AXISMODE(0) : SUSPEND(0) = 1 : PRINT AXISMODE(0)\n"
        "SUSPEND(0) = 0 : PAUSE IDLE(0) : VECTORR(0, 1) = 3, 4 : GO(0) : PRINT AXISMODE(0), AXISMODE(1)",
        ["0", "2", "0", "1", "1025", "88"], {}),
    "the target of a jog is where it is": (
        RATES + "JOG(0) = 50 : WAIT 1000 : PRINT POSTARGET(0) - POS(0), POSTARGETLAST(0) - POS(0)\n"
        "STOP(0) : PAUSE IDLE(0) : POS(0) = 0\nMOVER(0) = 5 : MOVER(0) = 6 : GO(0)\n"
        "PRINT POSTARGET(0), POSTARGETLAST(0)", ["0.00000.0000", "5.000011.0000"], EXACT),
    # --------------------------------------------------------------------------------------------- speeds and rates
    "FEEDRATEPARAMETER 0 to 2 are a speed, an acceleration and a deceleration": (
        RATES + "FEEDRATEPARAMETER(0, 0) = 50 : FEEDRATEPARAMETER(0, 1) = 500 : FEEDRATEPARAMETER(0, 2) = 250\n"
        "PRINT FEEDRATEPARAMETER(0, 0), FEEDRATEPARAMETER(0, 1), FEEDRATEPARAMETER(0, 2)\n"
        # 0.1 s up, 10 at speed for 0.2 s, 0.2 s down: 2.5 + 10 + 5.
        "MOVER(0) = 17.5 : GO(0) : WAIT 50 : PRINT VEL(0) : WAIT 100 : PRINT VEL(0) : WAIT 250 : PRINT VEL(0)\n"
        "PAUSE IDLE(0) : PRINT TIME\n"
        "FEEDRATEPARAMETER(0, 0) = 0 : FEEDRATEPARAMETER(0, 1) = 0 : FEEDRATEPARAMETER(0, 2) = 0\n"
        "MOVER(0) = 50 : GO(0) : WAIT 300 : PRINT VEL(0)",
        ["50.0000500.0000250.0000", "25.0000", "50.0000", "25.0000", "500", "100.0000"], EXACT),
    # 200 at 1000 ms is 200 per s²; 400 at 1000 ms is 400.
    "ACCELTIMEMAX follows MAXSPEED until ACCEL is written": (
        RATES + "MAXSPEED(0) = 200 : ACCELTIMEMAX(0) = 1000 : DECELTIMEMAX(0) = 500\nPRINT ACCEL(0), DECEL(0)\n"
        "MAXSPEED(0) = 400 : PRINT ACCEL(0), DECEL(0)\nACCEL(0) = 100 : MAXSPEED(0) = 500 : PRINT ACCEL(0), DECEL(0)\n"
        "PRINT ACCELTIMEMAX(0), DECELTIMEMAX(0)",
        ["200.0000400.0000", "400.0000800.0000", "100.00001000.0000", "5000500"], {}),
    # The jerk is 500 / 0.1 s and 250 / 0.2 s.
    "a jerk time is the time in which its rate builds up": (
        "ACCEL(0) = 500 : DECEL(0) = 250 : ACCELJERKTIME(0) = 100 : DECELJERKTIME(0) = 200\n"
        "PRINT ACCELJERK(0), DECELJERK(0) : ACCELJERK(0) = 1000 : DECELJERK(0) = 1000\n"
        "PRINT ACCELJERKTIME(0), DECELJERKTIME(0)", ["5000.00001250.0000", "500250"], {}),
    "MAXSPEED, MAXACCEL and MAXDECEL limit a jog": (
        "SPEED(0) = 100 : ACCEL(0) = 1000 : DECEL(0) = 1000 : MAXSPEED(0) = 50 : MAXACCEL(0) = 100 : MAXDECEL(0) = 50\n"
        "JOG(0) = 80 : WAIT 100 : PRINT VEL(0) : WAIT 900 : PRINT VEL(0) : STOP(0) : WAIT 500 : PRINT VEL(0)",
        ["10.0000", "50.0000", "25.0000"], EXACT),
    # ------------------------------------------------------------------------------------------ compensation, homing
    # Play of 2 in 200 ms is 10 per second, added to the 100 of the axis.
    "while play is taken up the motor is faster than the axis": (
        RATES + "BACKLASH(0) = 2 : BACKLASHINTERVAL(0) = 200 : BACKLASHMODE(0) = 1\nMOVER(0) = 100 : GO(0)\n"
        "WAIT 150 : PRINT ENCODERVEL(0) : WAIT 100 : PRINT ENCODERVEL(0) : PAUSE IDLE(0)\n"
        "MOVER(0) = -100 : GO(0) : WAIT 150 : PRINT ENCODERVEL(0) : WAIT 100 : PRINT ENCODERVEL(0)",
        ["110.0000", "100.0000", "-110.0000", "-100.0000"], EXACT),
    "a new homing forgets the result of the last one": (
        RATES + "HOMESPEED(0) = 50 : HOME(0) = _hmNEGATIVE_INDEX : PAUSE IDLE(0) : PRINT HOMESTATUS(0)\n"
        "HOME(0) = _hmPOSITIVE_INDEX : PRINT HOMESTATUS(0) : PAUSE IDLE(0) : PRINT HOMESTATUS(0)",
        ["1", "0", "1"], {"axis.0.index_every": 0.5}),
    "HOMEACCEL and HOMEDECEL are those of the axis until they are written": (
        "ACCEL(0) = 700 : DECEL(0) = 800 : PRINT HOMEACCEL(0), HOMEDECEL(0)\n"
        "HOMEACCEL(0) = 70 : PRINT HOMEACCEL(0), HOMEDECEL(0)", ["700.0000800.0000", "70.0000800.0000"], {}),
    "HOMECREEPSPEED is HOMESPEED divided by HOMEBACKOFF until it is written": (
        "HOMESPEED(0) = 50 : HOMEBACKOFF(0) = 20 : PRINT HOMECREEPSPEED(0) : HOMECREEPSPEED(0) = 7\n"
        "HOMESPEED(0) = 60 : PRINT HOMECREEPSPEED(0)", ["2.5000", "7.0000"], {}),
    # ------------------------------------------------------------------------------------------------------- limits
    "two software limits of 0 are none, and one of them counts with the other": (
        RATES + "MOVER(0) = 5 : GO(0) : PAUSE IDLE(0) : PRINT AXISERROR(0), POS(0)\n"
        "MOVEA(0) = 0 : GO(0) : PAUSE IDLE(0)\n"
        "SOFTLIMITMODE(0) = _emCRASH_STOP : SOFTLIMITFORWARD(0) = 3 : MOVER(0) = 5 : GO(0) : PAUSE IDLE(0)\n"
        "PRINT AXISERROR(0), POS(0) USING 1, 1", ["05.0000", "163.0"], {}),
    "each error mode has its own error": (
        "SOFTLIMITMODE(0) = 1 : LIMITMODE(0) = 2 : FOLERRORMODE(0) = 3 : ERRORINPUTMODE(0) = 4 : ABORTMODE(0) = 5\n"
        "ADCERRORMODE(0) = 0\nPRINT SOFTLIMITMODE(0), LIMITMODE(0), FOLERRORMODE(0), ERRORINPUTMODE(0), ABORTMODE(0), "
        "ADCERRORMODE(0)", ["123450"], {}),
    "ABORTMODE 0 leaves an axis as it is": (
        RATES + "ABORTMODE(1) = _emIGNORE : JOG(0) = 50 : JOG(1) = 50 : WAIT 500 : ABORT : WAIT 500\n"
        "PRINT AXISERROR(0), AXISERROR(1), ' ', VEL(0), ' ', VEL(1)".replace("'", '"'), ["10 0.0000 50.0000"], {}),
    # ------------------------------------------------------------------------------------------------------ drives
    # 50 % of the highest speed.
    "an analogue reference is a fraction of DRIVESPEEDMAX, else of MAXSPEED, else of SPEED": (
        RATES + "SPEEDREFSOURCE(0) = 1 : SPEEDREFACCELTIME(0) = 1 : SPEEDREFDECELTIME(0) = 1\n"
        "PRINT SPEEDREF(0) : MAXSPEED(0) = 200 : PRINT SPEEDREF(0) : DRIVESPEEDMAX(0) = 300 : PRINT SPEEDREF(0)\n"
        "SPEEDREFENABLE(0) = 0 : PRINT SPEEDREF(0)", ["50.0000", "100.0000", "150.0000", "0.0000"], volts(50.0)),
    "DRIVESPEEDMAX limits a speed reference in both directions": (
        RATES + "DRIVESPEEDMAX(0) = 30 : SPEEDREF(0) = 80 : WAIT 500 : PRINT VEL(0), SPEEDREF(0)\n"
        "SPEEDREF(0) = -80 : WAIT 500 : PRINT VEL(0)", ["30.000080.0000", "-30.0000"], EXACT),
    # The ramp of 1 s is to 100: half of it after half a second.
    "the ramp times of a speed reference are those to the highest speed": (
        RATES + "SPEEDREFACCELTIME(0) = 1000 : SPEEDREFDECELTIME(0) = 500 : SPEEDREF(0) = 100\n"
        "WAIT 500 : PRINT VEL(0) : WAIT 1000 : PRINT VEL(0) : SPEEDREF(0) = 50 : WAIT 125 : PRINT VEL(0)",
        ["50.0000", "100.0000", "75.0000"], EXACT),
    "a speed reference of 0 does not take over from a move": (
        RATES + "MOVER(0) = 100 : GO(0) : WAIT 300 : SPEEDREF(0) = 0 : WAIT 100 : PRINT VEL(0) : PAUSE IDLE(0)\n"
        "PRINT POS(0)", ["100.0000", "100.0000"], EXACT),
    # ------------------------------------------------------------------------------------------------------- presets
    "a preset with a time has the rate that takes it to its speed": (
        # 50 in 500 ms is 100 per s²: half of it after 250 ms.
        RATES + "PRESETMOVETYPE(1, 0) = 4 : PRESETMOVEPOSITION(1) = 100 : PRESETMOVESPEED(1) = 50\n"
        "PRESETACCEL(1, 1) = 500 : PRESETINDEX(0) = 1 : PRESETMOVEENABLE(0) = 1\n"
        "WAIT 250 : PRINT VEL(0) : WAIT 500 : PRINT VEL(0) : PAUSE IDLE(0) : PRINT POS(0)",
        ["25.0000", "50.0000", "100.0000"], EXACT),
    "a rate of a preset clears its time, and the time the rate": (
        "PRESETACCEL(1, 1) = 500 : PRESETACCEL(1, 0) = 20 : PRINT PRESETACCEL(1, 0), PRESETACCEL(1, 1)\n"
        "PRESETACCEL(1, 1) = 500 : PRINT PRESETACCEL(1, 0), PRESETACCEL(1, 1)",
        ["20.00000.0000", "0.0000500.0000"], {}),
    "an absolute preset counts from the zero of the program, a relative one from the axis": (
        RATES + "PRESETMOVETYPE(0, 0) = 3 : PRESETMOVEPOSITION(0) = 10 : PRESETMOVETYPE(1, 0) = 4\n"
        "PRESETMOVEPOSITION(1) = 10 : PRESETMOVETYPE(2, 0) = 5 : PRESETMOVEPOSITION(2) = 7\n"
        "MOVER(0) = 30 : GO(0) : PAUSE IDLE(0) : POS(0) = 5\nPRESETMOVEENABLE(0) = 1 : PAUSE IDLE(0) : PRINT POS(0)\n"
        "PRESETINDEX(0) = 1 : PAUSE IDLE(0) : PRINT POS(0) : PRESETINDEX(0) = 2 : PRINT POS(0)",
        ["10.0000", "20.0000", "7.0000"], {}),
    "a jog preset has a direction, and the speed of the axis without one of its own": (
        RATES + "PRESETMOVETYPE(0, 0) = 2 : PRESETMOVETYPE(1, 0) = 2 : PRESETJOGDIRECTION(1) = 1\n"
        "PRESETJOGSPEED(1) = 40 : PRESETMOVEENABLE(0) = 1 : WAIT 500 : PRINT VEL(0)\n"
        "PRESETINDEX(0) = 1 : WAIT 500 : PRINT VEL(0)", ["100.0000", "-40.0000"], EXACT),
    # -------------------------------------------------------------------------------------------------------- Modbus
    "an Integer of a server is two registers, the lower half first": (
        'MODBUSTCP32(1, 10) = -2 : PRINT MODBUSTCP16(1, 10), " ", MODBUSTCP16(1, 11), " ", MODBUSTCP32(1, 10)',
        ["65534 65535 -2"], {}),
    "half of an own register is a word": (
        "NETINTEGER(3) = 65537 * 2 : PRINT HOLDINGREGISTER(6), HOLDINGREGISTER(7)\n"
        "HOLDINGREGISTER(7) = 65535 : PRINT NETINTEGER(3)", ["22", "-65534"], {}),
    "the last coil is 65535, and any value but 0 sets it": (
        "COIL(65535) = 1 : PRINT COIL(65535), COIL(65534), COIL(0)", ["100"], {}),
    # ------------------------------------------------------------------------------------------------------- splines
    "a segment of a spline takes 4 to 60000 ms, rounded down to an even number": (
        RATES + "Dim p(2) As Float = 1, 1\nSPLINETABLE(0, p, NULL, NULL) : SPLINETIME(0) = 5.9\n"
        "SPLINE(0) = 0 : GO(0) : PAUSE IDLE(0) : PRINT TIME, POS(0)", ["41.0000"], EXACT),
    # -------------------------------------------------------------------------------------------------------- jogging
    # 5 up in 0.1 s, 20 in 0.2 s and 5 down in 0.1 s.
    "a timed jog ramps down after JOGDURATION, once per command": (
        RATES + "JOGSPEED(0) = 100 : JOGMODE(0) = 1 : JOGDURATION(0) = 300 : JOGCOMMAND(0) = 1\n"
        "PAUSE IDLE(0) : PRINT POS(0), TIME : JOGCOMMAND(0) = 1 : WAIT 200 : PRINT POS(0)\n"
        "JOGCOMMAND(0) = -1 : PAUSE IDLE(0) : PRINT POS(0) USING 1, 4, TIME",
        ["30.0000400", "30.0000", "0.00001000"], EXACT),
    "a jog without a time ends with JOGCOMMAND 0, and JOGSPEED acts at once": (
        RATES + "JOGSPEED(0) = 100 : JOGCOMMAND(0) = 1 : WAIT 500 : JOGCOMMAND(0) = 0 : PAUSE IDLE(0) : PRINT POS(0)\n"
        "JOGCOMMAND(0) = -1 : WAIT 500 : JOGSPEED(0) = 50 : WAIT 100 : PRINT VEL(0)", ["50.0000", "-50.0000"], EXACT),
    # 200 in 1 s and 0.5 s are 200 and 400 per s².
    "the ramp times of a jog are those to the highest speed": (
        RATES + "MAXSPEED(0) = 200 : JOGACCELTIMEMAX(0) = 1000 : JOGDECELTIMEMAX(0) = 500 : JOG(0) = 100\n"
        "WAIT 250 : PRINT VEL(0) : WAIT 500 : JOG(0) = 0 : WAIT 125 : PRINT VEL(0)", ["50.0000", "50.0000"], EXACT),
    # ------------------------------------------------------------------------------------------------------ following
    "the ratio of a follower has a numerator and a denominator": (
        RATES + "MASTERCHANNEL(1) = 0 : FOLLOWNUMERATOR(1) = 2 : FOLLOWDENOM(1) = 4 : FOLLOW(1) = 3\n"
        "MOVER(0) = 10 : GO(0) : PAUSE IDLE(0) : PRINT POS(1), FOLLOW(1)\n"
        "FOLLOWDENOM(1) = 1 : MOVER(0) = 10 : GO(0) : PAUSE IDLE(0) : PRINT POS(1)\n"
        "FOLLOW(1) = 0 : MOVER(0) = 10 : GO(0) : PAUSE IDLE(0) : PRINT POS(1), FOLLOW(1)",
        ["15.00003.0000", "75.0000", "75.00000.0000"], {}),
    # 100 counts are 25 of the encoder, and 25 of the follower are 50 counts.
    "a follower goes by the units of its master and its own": (
        RATES + "ENCODERSCALE(0) = 4 : SCALEFACTOR(1) = 2 : MASTERSOURCE(1) = 1 : MASTERCHANNEL(1) = 0\n"
        "FOLLOW(1) = 1 : MOVER(0) = 100 : GO(0) : PAUSE IDLE(0) : PRINT POS(1), ENCODER(1)", ["25.000050.0000"], {}),
    # Its ratio rises evenly from 0 to 0.5, so it is at a quarter of its way when the master is at half.
    "FLY travels while its master travels MASTERDISTANCE": (
        RATES + "MASTERCHANNEL(1) = 0 : MASTERDISTANCE(1) = 20 : FLY(1) = 5 : GO(1) : MOVER(0) = 20 : GO(0)\n"
        "PAUSE POS(0) >= 10 : PRINT POS(1) USING 1, 2 : PAUSE IDLE(0) : PRINT POS(1), IDLE(1)",
        ["1.25", "5.00001"], EXACT),
    # ------------------------------------------------------------------------------------------------------ the buffer
    # 10 at 100 and 1000 per s² take 0.2 s.
    "a move starts at its input and no other": (
        RATES + "TRIGGERMODE(0) = 2 : TRIGGERINPUT(0) = 3 : MOVER(0) = 10 : PAUSE POS(0) = 10 : PRINT TIME",
        ["300"], {**EXACT, "input": [{"channel": 4, "at": 0.05}, {"channel": 3, "at": 0.1}]}),
    # Axis 0 is at 50 after 0.1 s up and 45 at 100.
    "a move starts at a position of another axis": (
        RATES + "SPEED(1) = 100 : ACCEL(1) = 1000 : DECEL(1) = 1000\n"
        "TRIGGERCHANNEL(1) = 0 : TRIGGERVALUE(1) = 50 : TRIGGERMODE(1) = 3 : MOVER(1) = 10 : JOG(0) = 100\n"
        "PAUSE POS(1) = 10 : PRINT TIME", ["750"], EXACT),
    "MOVEBUFFERSTATUS has bit 3 for an empty buffer and bit 4 for a full one": (
        "PRINT MOVEBUFFERSTATUS(0) : MOVER(0) = 1 : PRINT MOVEBUFFERSTATUS(0)\n"
        "MOVER(0) = 1 : PRINT MOVEBUFFERSTATUS(0)\nGO(0)", ["8", "0", "16"], {}),
    "MOVEOUT sets a bank between two moves": (
        RATES + "OUT(0) = 3 : MOVER(0) = 1 : MOVEOUT(0, 1) = -2147483647 : GO(0) : PRINT OUT(1) : PAUSE IDLE(0)\n"
        "PRINT OUT(1), OUTX(32), OUTX(63), OUT(0)", ["0", "-2147483647113"], {}),
    "a dwell and a pulse have their milliseconds": (
        RATES + "MOVER(0) = 10 : MOVEDWELL(0) = 250 : GO(0) : PAUSE IDLE(0) : PRINT TIME\n"
        "MOVER(0) = 10 : MOVEPULSEOUTX(0, 3) = 50 : GO(0) : PAUSE IDLE(0) : PRINT OUTX(3) : WAIT 49 : PRINT OUTX(3)\n"
        "WAIT 2 : PRINT OUTX(3)", ["450", "1", "1", "0"], EXACT),
    # ------------------------------------------------------------------------------------------------ hold to analogue
    # The input is 20 %: the errors are 5 and -5, and the speed is at most SPEED.
    "HTA runs at HTAKPROP times the error, up to SPEED": (
        RATES + "HTACHANNEL(0) = 1 : HTAKPROP(0) = 2 : HTA(0) = 25 : WAIT 200 : PRINT VEL(0), HTA(0)\n"
        "HTA(0) = 15 : WAIT 100 : PRINT VEL(0), HTA(0) : HTAKPROP(0) = 200 : WAIT 100 : PRINT VEL(0)\n"
        "HTA(0) = 25 : WAIT 300 : PRINT VEL(0)",
        ["10.000025.0000", "-10.000015.0000", "-100.0000", "100.0000"], volts(0.0, 20.0)),
    # -------------------------------------------------------------------------------------------------- buses and nodes
    "a controller without a number is in no group": (
        "GROUPMASTER(1, 3) = 1 : GROUP(1, 3, 1) = 1 : PRINT GROUPMASTERSTATUS(1, 3), GROUPSTATUS(1, 3), BUSNODE(1)\n"
        "BUSNODE(1) = 1 : PRINT GROUPMASTERSTATUS(1, 3), GROUPSTATUS(1, 3)", ["000", "11"], {}),
    "the controller is the master of a group by its own number": (
        "GROUPMASTER(1, 3) = 7 : PRINT GROUPMASTERSTATUS(1, 3) : BUSNODE(1) = 7\n"
        "PRINT GROUPMASTERSTATUS(1, 3), GROUPMASTERSTATUS(1, 4), GROUPMASTERSTATUS(2, 3), BUSNODE(1), BUSNODE(2)\n"
        "GROUPMASTER(1, 3) = 8 : PRINT GROUPMASTERSTATUS(1, 3), GROUPMASTER(1, 3), GROUPMASTER(1, 2)",
        ["0", "10070", "080"], {}),
    "the controller is in a group by its own number": (
        "GROUP(1, 3, 7) = 1 : PRINT GROUPSTATUS(1, 3) : BUSNODE(1) = 7\n"
        "PRINT GROUPSTATUS(1, 3), GROUPSTATUS(1, 2), GROUPSTATUS(2, 3), GROUP(1, 3, 8), GROUPINFO(1, 7)\n"
        "GROUP(1, 3, 7) = 0 : PRINT GROUPSTATUS(1, 3), GROUPINFO(1, 7)", ["0", "10008", "00"], {}),
    "GROUPCOMMS writes to the nodes of a group on its bus alone": (
        "GROUP(1, 3, 7) = 1 : GROUP(1, 4, 8) = 1 : GROUP(2, 3, 9) = 1 : GROUPCOMMS(1, 3, 5) = 2.5\n"
        "PRINT REMOTECOMMS(1, 7, 5), REMOTECOMMS(1, 8, 5), REMOTECOMMS(2, 9, 5), REMOTECOMMS(1, 7, 6)",
        ["2.50000.00000.00000.0000"], {}),
    "a connection has a direction, and a node counts those that begin at it": (
        "CONNECT(1, 2, 7) = 1 : CONNECT(1, 2, 8) = 1 : CONNECT(1, 3, 7) = 1 : CONNECT(2, 2, 7) = 1\n"
        "PRINT CONNECTSTATUS(1, 2), CONNECTSTATUS(1, 3), CONNECTSTATUS(1, 7), CONNECT(1, 2, 7), CONNECT(1, 7, 2)\n"
        "CONNECT(1, 2, 7) = 0 : PRINT CONNECTSTATUS(1, 2), CONNECTSTATUS(2, 2)", ["21010", "11"], {}),
    # Types 1 Boolean, 2 to 4 integers of 8, 16 and 32 bits, 5 to 7 without a sign: 65408 is 0xFF80, 32767 is 0x7FFF.
    "an object of a node is cut off to its type": (
        "Dim i As Integer\n"
        "REMOTEOBJECT(1, 2, 0x2000, 0, 7) = 65408\nFor i = 1 To 7\nPRINT REMOTEOBJECT(1, 2, 0x2000, 0, i)\nNext\n"
        "REMOTEOBJECT(1, 2, 0x2000, 0, 7) = 32767\nFor i = 1 To 7\nPRINT REMOTEOBJECT(1, 2, 0x2000, 0, i)\nNext\n"
        "REMOTEOBJECT(1, 2, 0x2000, 0, 4) = -2147483647\nPRINT REMOTEOBJECT(1, 2, 0x2000, 0, 4)\n"
        "REMOTEOBJECT(1, 2, 0x2000, 0, 3) = 32768\nPRINT REMOTEOBJECT(1, 2, 0x2000, 0, 4)",
        ["0", "-128", "-128", "65408", "128", "65408", "65408",
         "1", "-1", "32767", "32767", "255", "32767", "32767", "-2147483647", "-32768"], {}),
    # ------------------------------------------------------------------------------------------------------------ tasks
    "TASKSTATUS is 0 before a task and after it, 1 while it runs and 2 while it is suspended": (
        "PRINT TASKSTATUS(Blink) : Run Blink : PRINT TASKSTATUS(Blink) : TASKSUSPEND(Blink) : PRINT TASKSTATUS(Blink)\n"
        "TASKRESUME(Blink) : PRINT TASKSTATUS(Blink) : WAIT 50 : PRINT TASKSTATUS(Blink)\nEnd\n"
        "Task Blink\n  WAIT 20\nEnd Task", ["0", "1", "2", "1", "0"], {}),
    # ------------------------------------------------------------------------------------------- other small rules
    # Of one kind the first to come is the first.
    "events that have waited come by their urgency, whatever their numbers are": (
        "TIMEREVENT = 25 : EVENTDISABLE = -1 : WAIT 30 : TIMEREVENT = 0 : EVENTDISABLE = 0 : WAIT 5\nEnd\n"
        + "".join(f'Event {name}\nPRINT "{name}"\nEnd Event\n' for name in ("IN1", "IN3", "TIMER", "COMMS1", "COMMS2")),
        ["TIMER", "IN3", "IN1", "COMMS2", "COMMS1"],
        {"input": [{"channel": 3, "at": 0.005}, {"channel": 1, "at": 0.006}],
         "comms": [{"at": at, "element": element, "value": 1} for at, element in ((0.001, 2), (0.002, 1))]}),
    "the last of 64 analogue inputs gives a speed reference": (
        "SPEEDREFSOURCE(0) = 64 : PRINT SPEEDREFSOURCE(0)", ["64"], {}),
    "the number 0 is no error, and 1 is one": (
        "PRINT ERRORSTRING(0) : PRINT ERRORSTRING(1) <> ERRORSTRING(0)", ["no error", "1"], {}),
    "a second between the points of a capture is a million microseconds": (
        "CAPTUREPERIOD = 2000000 : PRINT CAPTUREPERIOD", ["2000000"], {}),
    "a clock that nobody set began when the controller did": (
        "WAIT(1500) : PRINT REALTIMECLOCK", ["2000-01-01 00:00:01"], {}),
    "a brake that has no delays is lifted at once": (
        "MOTORBRAKEOUTPUT(0) = 4 : MOTORBRAKEMODE(0) = 1 : DRIVEENABLE(0) = _OFF : WAIT(9)\n"
        "DRIVEENABLE(0) = _ON : PRINT OUTX(4)", ["1"], {"controller.instruction_time": 1e-9}),
    "a brake that has delays is lifted after the one and set after the other": (
        "MOTORBRAKEOUTPUT(0) = 4 : MOTORBRAKEMODE(0) = 1 : DRIVEENABLE(0) = _OFF\n"
        "MOTORBRAKEDELAY(0, 0) = 20 : MOTORBRAKEDELAY(0, 1) = 20\n"
        "DRIVEENABLE(0) = _ON : WAIT(15) : PRINT OUTX(4) : WAIT(15) : PRINT OUTX(4)\n"
        "DRIVEENABLE(0) = _OFF : WAIT(15) : PRINT OUTX(4) : WAIT(15) : PRINT OUTX(4)", ["0", "1", "1", "0"], {}),
    "without a highest speed there is no time up to it": (
        RATES + "PRINT ACCELTIMEMAX(0), DECELTIMEMAX(0)\nMAXSPEED(0) = 200 : PRINT ACCELTIMEMAX(0)",
        ["00", "200"], {}),
    "a motor that has not moved has no time to settle but what IDLETIME says": (
        "IDLEMODE(0) = 1 : IDLETIME(0) = 10 : PRINT IDLESETTLINGTIME(0)", ["10"], PLANT),
    "IDLETIME behind the move the axis is idle, whatever the sum of the two is rounded to": (
        "Dim n As Integer\nIDLEMODE(0) = 1 : IDLEPOS(0) = 5 : IDLETIME(0) = 5\n"
        "For n = 1 To 30\n  MOVER(0) = n * 7 : GO(0) : PAUSE IDLE(0)\nNext\nPRINT IDLE(0)", ["1"], {}),
    "DEFAULT forgets the following error that warns": (
        "FOLERRORWARNING(0) = 50 : DEFAULT(0) : KPROP(0) = 0.05\n"
        "SPEED(0) = 20000 : ACCEL(0) = 40000 : DECEL(0) = 40000\n"
        "MOVER(0) = 20000 : GO(0) : WAIT(300) : PRINT FOLERROR(0) > 50, AXISWARNING(0)", ["10"], PLANT),
    "the other software limit is at 0 until it is written": (
        RATES + "SOFTLIMITFORWARD(0) = 50 : PRINT SOFTLIMITREVERSE(0)", ["0.0000"], {}),
    "a deadband is so many of the 4096 steps of the range": (
        RATES + "HTACHANNEL(0) = 2 : HTAKPROP(0) = 1 : HTADEADBAND(0) = 64\n"
        "HTA(0) = 53.125 : WAIT(500) : PRINT POS(0)", ["0.0000"],
        {"analogue": [{"channel": 2, "at": 0.0, "value": 50.0}]}),
    "paths are blended into each other, at a distance, and moves have marks, where the program says so": (
        "PRINT BLENDMODE(0), BLENDDISTANCE(0), MOVEBUFFERID(0)", ["00.00000"], {}),
    "a path starts as it is loaded where the first of its axes says so": (
        "TRIGGERMODE(0) = _trAUTO : VECTORR(0, 1) = 3, 4 : PAUSE IDLE(0, 1) : PRINT POS(0), POS(1)",
        ["3.00004.0000"], {}),
    "before it homes an axis has no place at which it did": ("PRINT HOMEPOS(0)", ["0.0000"], {}),
    "COMMSREMOTE is about the first bus": (
        "COMMSREMOTE(2, 7) = 2.5 : PRINT COMMSREMOTE(2, 7), REMOTECOMMS(1, 2, 7), REMOTECOMMS(2, 2, 7)",
        ["2.50002.50001.5000"],
        {"remote": [{"bus": bus, "node": 2, "element": 7, "value": 1.5} for bus in (1, 2)]}),
    "five entries of comms have an event on a NextMove ESB-2": (
        "WAIT 300\nEnd\nEvent COMMS5\n  PRINT 5\nEnd Event\nEvent COMMS6\n  PRINT 6\nEnd Event", ["5"],
        {"controller.model": "NextMove ESB-2",
         "comms": [{"at": 0.1, "element": each, "value": 1} for each in (5, 6)]}),
    "zero has no sign, whether it is known before the run or not": (
        "Dim a As Float = 0\nPRINT Sgn(0), Sgn(0.0), Sgn(a), Sgn(-0.5), Sgn(0.5)", ["000-11"], {}),
    "a comparison of texts is no text": (
        'Const EQUAL_TEXTS = "a" = "a"\nConst BOTH = "a" + "b"\nConst ALSO = "a" & "b"\n'
        "PRINT EQUAL_TEXTS, BOTH, ALSO", ["1abab"], {}),
    "the last of 32 groups is the sign of the bits of a node": (
        "GROUP(1, 31, 7) = 1 : GROUP(1, 0, 8) = 1 : PRINT GROUPINFO(1, 7), GROUPINFO(1, 8)", ["-21474836481"],
        {}),
    # The nut is at 0 and 101 for 0 and 100 of the motor in forward motion, 1 lower in reverse. The motor
    # stays at 0 when the tables come into force.
    "before its first move an axis is compensated as in forward motion": (
        RATES + "Dim forward(3) As Float = 2, 0, 101\nDim back(3) As Float = 2, -1, 100\n"
        "PRECISIONTABLE(0, forward, back) : PRECISIONINCREMENT(0) = 100 : PRECISIONMODE(0) = _lsDUAL_TABLE\n"
        "PRINT ENCODER(0) : MOVEA(0) = 101 : GO(0) : PAUSE IDLE(0) : PRINT ENCODER(0)\n"
        "MOVEA(0) = 100 : GO(0) : PAUSE IDLE(0) : PRINT ENCODER(0)", ["0.0000", "100.0000", "100.0000"], {}),
}  # fmt: skip
# A statement with a number just outside its range, and the message.
OUTSIDE = {
    "PRINT INX(1000)": "there is no input 1000",
    "PRINT INX(-1)": "there is no input -1",
    "PRINT IN(32)": "there is no bank 32",
    "OUTX(1000) = 1": "there is no output 1000",
    "PRINT OUTX(1000)": "there is no output 1000",
    "OUT(32) = 1": "there is no bank 32",
    "OUTPUTACTIVELEVEL(32) = 1": "there is no bank 32",
    "RELAYOUTX(64) = 1": "there is no relay 64",
    "RELAYOUT(2) = 1": "there is no bank of relays 2",
    "PULSEOUTX(1000) = 1": "there is no output 1000",
    "PRINT ADC(64)": "there is no analogue input 64",
    "ADCGAIN(64) = 5": "there is no analogue input 64",
    "TORQUEREFSOURCE(0) = 65": "TORQUEREFSOURCE cannot be 65",
    "DAC(64) = 5": "there is no analogue output 64",
    "AUXDAC(64) = 5": "there is no spare analogue output 64",
    "PRINT MOTORBRAKEDELAY(0, 2)": "there is no delay of a brake 2",
    "PRINT FEEDRATEPARAMETER(0, 3)": "FEEDRATEPARAMETER has no parameter 3",
    "PRINT FEEDRATEPARAMETER(0, -1)": "FEEDRATEPARAMETER has no parameter -1",
    "PRINT PRESETMOVESPEED(64)": "there is no preset 64",
    "PRINT PRESETACCEL(1, 2)": "PRESETACCEL has no parameter 2",
    "PRINT PRESETMOVETYPE(1, 1)": "PRESETMOVETYPE has no parameter 1",
    "PRINT COIL(65536)": "there is no coil 65536",
    "PRINT MODBUSTCP16(1, 65536)": "Modbus server 1 rejects register 65536",
    "PRINT MODBUSTCP32(1, 65535)": "Modbus server 1 rejects registers 65535 and 65536",
    "PRINT LATCHVALUE(32)": "there is no latch channel 32",
    "PRINT CAPTUREMODE(8)": "there is no capture channel 8",
    "PRINT CAMBOX(32)": "there is no cam box 32",
    "CAM(1) = 8": "CAM cannot be 8",
    "CAM(1) = -1": "CAM cannot be -1",
    "CAPTURENUMPOINTS = 0": "a capture cannot have 0 points",
    "CAPTURENUMPOINTS = 100001": "a capture cannot have 100001 points",
    "PRINT ENCODER(99)": "there is no encoder 99",
    "PRINT CURRENTMEAS(0, 1)": "CURRENTMEAS: there is no current 1",
    "PRINT NODELIVE(3, 1)": "there is no bus 3",
    "PRINT NODELIVE(0, 1)": "there is no bus 0",
    "PRINT NODELIVE(1, 256)": "there is no node 256",
    "SPLINE(0) = 0": "axis 0 has no spline",
    "Dim r(5) As Float = 4, 1, 2, 2, 1\nCAMTABLE(1, r) : MASTERDISTANCE(1) = 10 : CAMPHASE(1, 1, 4, -40)": (
        "CAMPHASE cannot take 40 from segments 1 to 4"
    ),
    "Dim r(5) As Float = 4, 1, 2, 2, 1\nCAMTABLE(1, r) : MASTERDISTANCE(1) = 10 : CAMPHASE(1, 2, 1, -10)": (
        "CAMPHASE cannot take 10 from segments 2 to 2"
    ),
    "FLY(1) = 5": "FLY needs the distance of the master",
    "MASTERDISTANCE(0) = 5 : FLY(0) = 5": "axis 0 cannot follow axis 0: it would follow itself",
    "JOGCOMMAND(0) = 1": "axis 0 cannot jog: its JOGSPEED is 0",
    "MOVEOUTX(0, 1000) = 1": "there is no output 1000",
    "MOVEOUT(0, 32) = 1": "there is no bank 32",
    "PRINT GROUPSTATUS(1, 32)": "there is no group 32",
    "PRINT GROUPSTATUS(1, -1)": "there is no group -1",
    "HOLDINGREGISTER(2000) = 5": "there is no register 2000",
    "Dim p(3) As Float = 2, 10, 20\nCAMBOXDATA(0, 5, 0, 0, 32768, p)": "CAMBOXDATA cannot switch 32768 ms ahead",
    "GROUPCOMMS(1, 32, 9) = 4.5": "there is no group 32",
    "Dim k As Integer = 1\nMOVER(k) = 5 : MOVER(k) = 6 : MOVER(k) = 7": (
        "the program waits for space in the move buffer of axis 1, which can never happen"
    ),
    "Dim k As Integer = 1\nVECTORR(k, 2) = 5, 6 : VECTORR(k, 2) = 6, 7 : VECTORR(k, 2) = 7, 8": (
        "the program waits for space in the move buffers of axes 1, 2, which can never happen"
    ),
}


@pytest.mark.parametrize("rule", WORDS)
def test_what_it_prints(rule: str) -> None:
    text, expected, machine = WORDS[rule]
    result = run(Source("a.mnt", text), machine=machine, cache=False, until=20.0)
    assert [each.message for each in result.diagnostics] == []
    assert result.output == expected


# A number outside its range, and the hint.
LIMITS = {
    "TASKPRIORITY(T) = n\nTask T\nEnd Task": "it takes 0 to 255",
    "SPEED(0) = n - 301": "it takes 0 to 8388607",
    "POS(0) = n * 1e308": "a position is finite, in counts too",
    "JOG(0) = n * 1e308 - n * 1e308": "it takes -8388607 to 8388607",
}


@pytest.mark.parametrize("text", LIMITS)
def test_a_hint_has_the_range(text: str) -> None:
    result = run(Source("a.mnt", f"Dim n As Integer = 300\n{text}"), cache=False, until=10.0)
    assert [each.hint for each in result.diagnostics] == [f"{LIMITS[text]} (Mint error 3, value invalid)"]


@pytest.mark.parametrize("text", OUTSIDE)
def test_a_number_outside_its_range_is_refused(text: str) -> None:
    result = run(Source("a.mnt", text), cache=False, until=10.0)
    assert [each.message for each in result.diagnostics] == [OUTSIDE[text]]


def test_an_output_is_logged_as_1_or_0_when_it_changes() -> None:
    text = "OUTX(5) = 7 : OUTX(5) = 1 : OUTX(6) = -1 : OUTX(5) = 0 : OUT(1) = 5"
    result = run(Source("a.mnt", text), cache=False)
    assert [(each.channel, each.value) for each in result.controller.log.outputs] == [
        (5, 1),
        (6, 1),
        (5, 0),
        (32, 1),
        (34, 1),
    ]


def test_a_mode_of_an_encoder_that_has_no_effect_is_reported() -> None:
    """0 and 8, the virtual axis, have their effect."""
    for mode, reported in ((0, []), (8, []), (2, ["AUXENCODERMODE"])):
        result = run(Source("a.mnt", f"AUXENCODERMODE(0) = {mode}"), cache=False)
        assert list(result.machine.without_effect) == reported


# A program that waits for a level, and the milliseconds at which it passes that. With 100 per second and 1000 per s², a
# distance of d takes 50 ms + 10 ms * d, and a speed of v takes v ms. No moment is on a tick of the profiler, 1 ms.
LEVELS: dict[str, tuple[str, float]] = {
    "POS": ("JOG(0) = 100 : PAUSE POS(0) > 10.03", 150.3),
    "POS downwards": ("JOG(0) = -100 : PAUSE POS(0) <= -10.03", 150.3),
    "POSDEMAND": ("JOG(0) = 100 : PAUSE POSDEMAND(0) > 10.03", 150.3),
    "POSREMAINING": ("MOVER(0) = 100 : GO(0) : PAUSE POSREMAINING(0) < 80.03", 249.7),
    "OFFSET": ("MOVER(0) = 100 : GO(0) : PAUSE OFFSET(0) < 80.03", 249.7),
    "VEL": ("JOG(0) = 100 : PAUSE VEL(0) > 50.3", 50.3),
    "VELDEMAND": ("JOG(0) = 100 : PAUSE VELDEMAND(0) >= 50.3", 50.3),
    "VEL at the end": ("MOVER(0) = 100 : GO(0) : PAUSE POS(0) > 90 : PAUSE VEL(0) < 50.3", 1049.7),
    "TIME": ("WAIT 0.3 : TIME = 0 : PAUSE TIME >= 70", 70.3),
    "a variable of time": ("Dim t As Time\nWAIT 0.3 : t = 0 : PAUSE t >= 70", 70.3),
    "JOGTIME": ("JOGSPEED(0) = 100 : WAIT 0.3 : JOGCOMMAND(0) = 1 : PAUSE JOGTIME(0) >= 70", 70.3),
    "ENCODER": ("PAUSE ENCODER(5) > 10.3", 10.3),
    "AUXENCODER": ("PAUSE AUXENCODER(0) > 20.6", 10.3),
    "one or the other": ("JOG(0) = 100 : PAUSE POS(0) > 10.03 Or VEL(0) > 50.3", 50.3),
    "one and the other": ("JOG(0) = 100 : PAUSE POS(0) > 10.03 And VEL(0) > 50.3", 150.3),
}


@pytest.mark.parametrize("name", LEVELS)
def test_a_wait_for_a_level_ends_exactly_when_it_is_passed(name: str) -> None:
    text, time = LEVELS[name]
    encoders = [{"channel": 5, "velocity": 1000.0}, {"aux": 0, "velocity": 2000.0}]
    source = Source("a.mnt", f"{RATES}{text}\nOUTX(0) = 1\nCANCEL(0)")
    result = run(source, machine={**EXACT, "encoder": encoders}, cache=False, until=20.0)
    assert [each.time for each in result.controller.log.outputs] == [pytest.approx(time / 1000.0, abs=1e-7)]
