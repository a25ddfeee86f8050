"""Commands of Mint's type library and console words that have no value: NAME|short form|index|meaning."""

from __future__ import annotations

WORDS = """\
ADCOFFSETTRIM||channel|null an analogue input
AUTOTUNE||axis, operation|autotune a drive
AUTOTUNEABORT||none|end an autotune
BLEND||axis|begin blending into the next move now
BUSRESET||bus|reset a bus
CANBUSRESET||bus|reset a CAN bus
CAMBOXDATA||box, output, source, channel, time, data|define the switching points of a cam box
CAMPHASE||axis, index, segments, delta|shift the phase of a cam
CAMSEGMENT||axis, table, start, data|rewrite a part of a cam table
CAMTABLE||axis, positions, lengths|attach cam arrays, whose element 1 is the count
CAPTURETRIGGER||none|trigger the data capture
CIRCLEA||axes|arc about an absolute centre: x, y, angle
CIRCLER||axes|arc about a centre relative to the start: x, y, angle
CLEARERRORLOG||none|empty the error log
CONTROLLERRESET||none|restart the controller
PROCESSORRESET||none|restart the controller
DEFAULT||axis|default parameters of an axis
DEFAULTALL||none|default parameters of every axis
ERRORCLEAR||group, data|clear errors
EVENTPEND||type, data, data|raise an event
EVENTUNPEND||type, data, data|drop an event that waits
FACTORYDEFAULTS|fdf|none|restore the factory's parameters
SYSTEMDEFAULTS|sdf|none|restore the system's parameters
HELIXA||axes|helix about an absolute centre: x, y, angle, z
HELIXR||axes|helix about a relative centre: x, y, angle, z
KNIFE||axis|knife move
MOVEFIDUCIAL||axis|fiducial scan
NODESCAN||bus, node|look for a node on a bus
PARAMETERSAVE||none|store the parameters
PLCDEFAULT||level|default the background PLC task
PLCTASK||channel|define a background PLC task
PRECISIONTABLE||axis, forward, reverse|attach an error-mapping table
PUSHREDIRECT||node|route calls to a remote node
POPREDIRECT||none|end the routing of calls to a remote node
REMOTEPDOOUT||bus, node, data|send a process data object
REMOTERESET||bus, node|reset a remote node
SENTINEL||channel, source, parameter, mode, absolute, low, high|define a sentinel
SERIALCLEARERROR||port|clear a serial error
SERIALCLEARRECEIVEBUFFER||port|empty a serial receive buffer
SERIALCLEARTRANSMITBUFFER||port|empty a serial transmit buffer
SPLINESEGMENT||axis, table, start, data|rewrite a part of a spline
SPLINETABLE||axis, positions, velocities, lengths|attach spline arrays
VECTORA||axes|linear interpolation of several axes to a position
VECTORR||axes|linear interpolation of several axes by distances
RESET||axis|clear the errors of an axis, zero its position, enable it
RESETALL||none|reset every axis
DATUM||axis|home to the encoder's index (v3)
BEEP||none|sound the keypad
BEEPON||none|switch key clicks on
BEEPOFF||none|switch key clicks off
BINARY||none|binary mode of the terminal
BOL||none|go to the begin of the line on the terminal
TRON||none|line trace on
TROFF||none|line trace off
NOP||none|do nothing
TERMINAL|tm|none|the terminal that is printed to
VIEW||keyword|repeat a value on the command line
CON||none|console word: the configuration buffer
PROG||none|console word: the program buffer
NEW||none|console word: empty the buffer
EDIT||none|console word: edit the buffer
"""
