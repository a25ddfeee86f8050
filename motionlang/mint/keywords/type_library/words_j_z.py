"""The words of Mint's type library (build 5626), J to Z: NAME|short form|index|type|access|meaning."""

from __future__ import annotations

WORDS = """\
JOG||axis|float|RW|constant-speed motion
JOGACCELTIMEMAX||axis|int|RW|jog group
JOGAWAY||axis|int|RW|jog group
JOGAWAYOFFSET||axis|float|R|jog group
JOGCOMMAND|jgc|axis|int|RW|jog from input
JOGDECELTIMEMAX||axis|int|RW|jog group
JOGDURATION||axis|int|RW|jog time
JOGMODE||axis|int|RW|jog options
JOGSPEED|jgs|axis|float|RW|jog speed preset
JOGTIME||axis|int|R|jog group
KACCEL||axis|float|RW|acceleration feedforward
KASINT||axis|float|RW|loop gain group
KASPROP||axis|float|RW|loop gain group
KDERIV|kd|axis|float|RW|derivative gain
KEYPADFIRMWAREVERSION||none|string|RW|loop gain group
KFINT||axis|float|RW|loop gain group
KFPROP||axis|float|RW|loop gain group
KFTIME||axis|float|RW|loop gain group
KIINT|kii|axis|float|RW|current loop integral
KINT|ki|axis|float|RW|integral gain
KINTLIMIT|kil|axis|float|RW|integral clamp (percent)
KINTMODE|kim|axis|int|RW|when integral acts
KIPROP|kip|axis|float|RW|current loop proportional
KITRACK||axis|int|RW|loop gain group
KNIFEMASTERAXIS||axis|int|RW|knife master
KNIFEMODE||axis|int|RW|knife control mode
KNIFESTATUS||axis|int|RW|knife status
KPROP|kp|axis|float|RW|proportional gain
KVDERIV|kvd|axis|float|RW|speed loop derivative
KVDERIVTCONST||axis|float|RW|loop gain group
KVEL||axis|float|RW|velocity feedback gain
KVELFF||axis|float|RW|velocity feedforward
KVFILTERLEVEL||axis|int|RW|loop gain group
KVINT|kvi|axis|float|RW|speed loop integral
KVMEAS||axis|float|RW|loop gain group
KVPROP|kvp|axis|float|RW|speed loop proportional
KVTIME||axis|float|RW|speed loop filter
KVTRACK||axis|int|RW|speed loop tracking
LANGUAGE||none|string|RW|host: PC-side item
LANGUAGEPACK||none|string|RW|listed by the type library without a meaning
LATCH||latchchannel|bool|R|latch channel fired
LATCHENABLE||latchchannel|bool|RW|arm latch channel
LATCHINHIBITTIME||latchchannel|int|RW|ignore time
LATCHINHIBITVALUE||latchchannel|float|RW|ignore distance
LATCHMODE||latchchannel|int|RW|auto/manual re-arm
LATCHSETUP||devicetype, channel|int|RW|latch channel group
LATCHSETUPMULTIPLE||devicetype, channel|var|RW|latch channel group
LATCHSOURCE||latchchannel|int|RW|what is latched
LATCHSOURCECHANNEL||latchchannel|int|RW|channel latched
LATCHTRIGGERCHANNEL||latchchannel|int|RW|trigger input
LATCHTRIGGEREDGE||latchchannel|int|RW|edge
LATCHTRIGGERMODE||latchchannel|int|RW|trigger kind
LATCHVALUE||latchchannel|float|R|latched value
LED||none|int|RW|LED mode
LEDDISPLAY||none|int|RW|LED bits
LIFETIME||none|int|RW|life counter
LIMIT||axis|bool|R|either limit active
LIMITFORWARD|lf|axis|bool|R|forward limit state
LIMITFORWARDINPUT|lfi|axis|int|RW|forward limit input
LIMITMODE||axis|int|RW|action on limit
LIMITREVERSE|lr|axis|bool|R|reverse limit state
LIMITREVERSEINPUT|lri|axis|int|RW|reverse limit input
LISTOF||listof, parameter|var|RW|host: PC-side item
LOADDAMPING||axis|float|RW|load data group
LOADINERTIA||axis|float|RW|load data group
LOGCOMMSERRORS||none|bool|RW|host: (host logging)
LOGFILENAME||none|string|RW|host: (host logging)
LOGRXENABLED||none|bool|RW|host: (host logging)
LOGTXENABLED||none|bool|RW|host: (host logging)
LOOPTIME|lt|none|int|RW|servo loop time, microseconds
MASTERCHANNEL||axis|int|RW|master channel for follow/cam/fly
MASTERDISTANCE||axis|float|RW|master distance of a segment
MASTERSOURCE||axis|int|RW|what the master is
MAXACCEL||axis|float|RW|limit
MAXDECEL||axis|float|RW|limit
MAXSPEED||axis|float|RW|limit
MILERROROFFSETGLOBAL||none|int|RW|host: PC-side item
MINTEXECUTING||none|bool|RW|program running (host side)
MINTEXPRESSIONS||lhs|var|RW|host: PC-side item
MINTEXTENDEDSTATUS||command, data|int|R|listed by the type library without a meaning
MINTLINEEXECUTING||none|int|RW|line now executing (host side)
MINTSTATUS||command|int|R|state of Mint program
MISCERROR||none|int|RW|controller-level error bits
MISCERRORDISABLE||none|int|RW|mask
MODULENAME||moduleid|string|R|listed by the type library without a meaning
MONITORPARAMETER||group, mode, parameter|int|R|listed by the type library without a meaning
MOTORBASEFREQ||axis|float|RW|motor data group
MOTORBASEVOLTS||axis|float|RW|motor data group
MOTORBRAKE||axis|bool|W|motor data group
MOTORBRAKEDELAY||axis, channel|int|RW|motor data group
MOTORBRAKEMODE||axis|int|RW|motor data group
MOTORBRAKEOUTPUT||axis|int|RW|motor data group
MOTORBRAKESTATUS||axis|int|R|motor data group
MOTORCATALOGNUMBER||axis|string|RW|motor data group
MOTORDIRECTION||axis|int|RW|motor data group
MOTORENCODERLINES|mel|axis|int|RW|motor data group
MOTORFEEDBACK||axis|int|RW|motor data group
MOTORFEEDBACKALIGNMENT||axis|float|RW|motor data group
MOTORFEEDBACKANGLE||axis|float|R|motor data group
MOTORFEEDBACKOFFSET||axis|float|RW|motor data group
MOTORFEEDBACKSTATUS||axis|int|R|motor data group
MOTORFLUX||axis|float|RW|motor data group
MOTORFLUXMAX||axis|float|RW|motor data group
MOTORFLUXMIN||axis|float|RW|motor data group
MOTORFLUXTCONST||axis|float|RW|motor data group
MOTORINSTABILITYFREQ||axis|float|RW|motor data group
MOTORLINEARENCODERRESOLUTION||axis|int|RW|motor data group
MOTORLINEARPOLEPITCH||axis|float|RW|motor data group
MOTORLS|mls|axis|float|RW|motor data group
MOTORMAGCURRENT||axis|float|RW|motor data group
MOTORMAGCURRENTCOEFF||axis, channel|float|RW|motor data group
MOTORMAGCURRENTMAX||axis|float|RW|motor data group
MOTORMAGCURRENTMIN||axis|float|RW|motor data group
MOTORMAGIND||axis|float|RW|motor data group
MOTOROVERLOADAREA||axis|float|R|motor data group
MOTOROVERLOADMODE||axis|int|RW|motor data group
MOTORPEAKCURRENT||axis|float|RW|motor data group
MOTORPEAKDURATION||axis|float|RW|motor data group
MOTORPOLES|mp|axis|int|RW|motor data group
MOTORPOWERMEASURED||axis|float|R|motor data group
MOTORRATEDCURRENT|mrc|axis|float|RW|motor data group
MOTORRATEDFREQ||axis|float|RW|motor data group
MOTORRATEDSPEED||axis|float|RW|motor data group
MOTORRATEDSPEEDMMPS||axis|float|RW|motor data group
MOTORRATEDSPEEDRPM||axis|int|RW|motor data group
MOTORRATEDVOLTS||axis|float|RW|motor data group
MOTORRESOLVEROFFSET||axis|float|RW|motor data group
MOTORRESOLVERSPEED||axis|float|RW|motor data group
MOTORROTORLEAKAGEIND||axis|float|RW|motor data group
MOTORROTORRES||axis|float|RW|motor data group
MOTORRS|mrs|axis|float|RW|motor data group
MOTORSLIPFREQ||axis|float|RW|motor data group
MOTORSPECNUMBER||axis|string|RW|motor data group
MOTORSPEEDMAXMMPS||axis|float|RW|motor data group
MOTORSPEEDMAXRPM||axis|int|RW|motor data group
MOTORSTABILITYGAIN||axis|float|RW|motor data group
MOTORSTATORLEAKAGEIND||axis|float|RW|motor data group
MOTORSTATORRES||axis|float|RW|motor data group
MOTORTEMPERATUREINPUT||axis|int|RW|motor data group
MOTORTEMPERATUREMODE||axis|int|RW|motor data group
MOTORTEMPERATURESWITCH||axis|bool|R|motor data group
MOTORTESTMODE||param|float|RW|motor data group
MOTORTYPE||axis|int|RW|motor data group
MOVEA||axis|float|W|load absolute move
MOVEBUFFERFREE||axis|int|R|free places in move buffer
MOVEBUFFERID||axis|int|RW|id stamped on moves loaded
MOVEBUFFERIDLAST||axis|int|R|id of move executing
MOVEBUFFERLOW||axis|int|RW|level for low event
MOVEBUFFERSIZE||axis|int|RW|size of move buffer
MOVEBUFFERSTATUS||axis|int|R|status of buffer
MOVECORRECTION||axis|float|W|add correction to move
MOVEDWELL||axis|int|W|load a dwell (ms) in buffer
MOVEOUT||axis, outputbank|int|W|load an output change in buffer
MOVEOUTX||axis, channel|bool|W|load one-bit output change
MOVEPULSEOUTX||axis, channel|int|W|load an output pulse
MOVER||axis|float|W|load relative move
MOVERTEST||axis, param|float|RW|listed by the type library without a meaning
MOVESTATUS||axis|int|R|status of move
MULTIPLECOMMANDSEXECUTE||flags|var|R|host: PC-side item
NETFLOAT||index|float|RW|network data array (float)
NETFLOATMULTIPLE||index, elements|var|RW|several locations at once, of the PC's side: a program uses NETFLOAT
NETINTEGER||index|int|RW|network data array (integer)
NETINTEGERMULTIPLE||index, elements|var|RW|several locations at once, of the PC's side: a program uses NETINTEGER
NODE|nd|none|int|RW|serial node
NODELIVE||canbus, node|bool|R|TRUE if node alive
NODENUMBER||none|int|RW|listed by the type library without a meaning
NODETYPE||canbus, node|int|RW|type of node
NODETYPEEXTENDED||bus, node|var|RW|listed by the type library without a meaning
NUMBEROF|no|item|int|RW|count of a resource
NUMBEROFEXTENDED|noe|item, parameter|int|RW|listed by the type library without a meaning
NVFLOAT||address|float|RW|non-volatile float
NVLONG||address|int|RW|non-volatile integer
OFFSET||axis|float|W|superimposed offset move
OFFSETDISTANCE||axis|float|RW|master distance over which offset occurs
OFFSETMODE||axis|int|RW|how offset profiled
OFFSETSTATUS||axis|int|R|result bits of last offset
OKTOLOADMOVE||numberofaxes, axisarray|bool|R|host: PC-side item
OPTIONCARDBUS||slot|int|R|option card group
OPTIONCARDNETWORKADDRESS||slot|int|RW|option card group
OPTIONCARDNETWORKSTATUS||slot|int|R|option card group
OPTIONCARDOBJECTFLOAT||slot, object, instance, attribute, type|float|RW|option card group
OPTIONCARDOBJECTINTEGER||slot, object, instance, attribute, type|int|RW|option card group
OPTIONCARDOBJECTSTRING||slot, object, instance, attribute, type|string|RW|option card group
OPTIONCARDSTATUS||slot|int|R|option card group
OPTIONCARDTYPE||slot|int|R|option card group
OPTIONCARDVERSION||slot, item|int|R|option card group
OUT|ot|bank|int|RW|bank of outputs
OUTPUTACTIVELEVEL|oal|bank|int|RW|active level bits
OUTPUTMONITORMODE||output|int|RW|output monitor group
OUTPUTMONITORMODEPARAMETER||output|int|RW|output monitor group
OUTPUTTYPE||output|int|R|listed by the type library without a meaning
OUTX|otx|output|bool|RW|one output
PARAMETERLISTSTRING||parameter, enumeration|string|R|parameter table group
PARAMETERNUMBERSUBSET||subset|var|R|parameter table group
PARAMETERTABLEVERSION||none|int|RW|parameter table group
PARAMETERVALUESSUBSET||subset, parameter|var|R|parameter table group
PARAMSAVEMODE||channel|bool|RW|listed by the type library without a meaning
PDOLOSSMODE||axis|int|RW|listed by the type library without a meaning
PHASESEARCHBACKOFF||axis|int|RW|commutation search group
PHASESEARCHBANDWIDTH||axis|float|RW|commutation search group
PHASESEARCHCURRENT||axis|float|RW|commutation search group
PHASESEARCHINPUT||axis|int|RW|commutation search group
PHASESEARCHMODE||axis|int|RW|commutation search group
PHASESEARCHOUTPUT||axis|int|RW|commutation search group
PHASESEARCHSPEED||axis|int|RW|commutation search group
PHASESEARCHSTATUS||axis|bool|R|commutation found
PHASESEARCHTRAVEL||axis|int|RW|commutation search group
PLATFORM|ptm|none|int|RW|controller type
PLATFORMNAME||none|string|RW|listed by the type library without a meaning
PLCAUTOENABLE||none|bool|RW|background PLC task group
PLCCONDITION||channel, conditionno|int|RW|background PLC task group
PLCENABLE|pe|none|bool|RW|background PLC task group
PLCENABLEACTION||channel|bool|RW|background PLC task group
PLCGEARFACTOR||none|int|RW|background PLC task group
PLCOPERATOR||channel, conditionno|int|RW|background PLC task group
PLCPARAMETER||channel, conditionno|int|RW|background PLC task group
PLCSTATUS|pss|none|int|RW|background PLC task group
PLCTASKDATA||channel, pncondition1, pnparam1, pnoperator, pncondition2, pnparam2|bool|R|background PLC task group
PLCTASKSTATUS||channel|int|R|background PLC task group
PLCTIME||none|int|RW|background PLC task group
PLXDATA||address|int|RW|listed by the type library without a meaning
PORTNUMBER||none|int|RW|host: PC-side item
PORTSPEED||none|int|RW|host: PC-side item
POS|ps|axis|float|RW|position (write = preset)
POSACHIEVED||axis|bool|R|in position
POSDEMAND||axis|float|RW|instantaneous demand position
POSITIONCONTROLLOOPTIME||axis|int|RW|listed by the type library without a meaning
POSREF||axis|float|RW|position reference
POSREMAINING||axis|float|R|distance to target
POSROLLOVER||axis|int|RW|count of wraps
POSROLLOVERDEMAND||axis|int|R|wraps of demand
POSROLLOVERTARGET||axis|int|R|rollover group
POSROLLOVERTARGETLAST||axis|int|R|rollover group
POSSCALEFACTOR||axis|float|RW|position scaling
POSSCALEUNITS||axis|string|RW|text of position units
POSTARGET||axis|float|R|target of move executing
POSTARGETLAST||axis|float|R|target of last move in buffer
POSTRIMGAIN||axis|float|RW|listed by the type library without a meaning
POSWRAP||axis|float|RW|wrap range
POWERBASEPARAMETER||param|float|RW|listed by the type library without a meaning
POWERREADYINPUT||param|int|RW|listed by the type library without a meaning
POWERREADYOUTPUT||param|int|RW|listed by the type library without a meaning
PRECISIONAXIS||axisorchannel|int|RW|error-mapping table group
PRECISIONINCREMENT||axisorchannel|float|RW|error-mapping table group
PRECISIONMODE||axisorchannel|int|RW|error-mapping table group
PRECISIONOFFSET||axisorchannel|float|RW|error-mapping table group
PRECISIONSOURCE||axisorchannel|int|RW|error-mapping table group
PRECISIONSOURCECHANNEL||axisorchannel|int|RW|error-mapping table group
PRESETACCEL||preset, fmt|float|RW|preset moves (drives) group
PRESETDECEL||preset, fmt|float|RW|preset moves (drives) group
PRESETDWELLTIME||axis|int|RW|preset moves (drives) group
PRESETDWELLTIMEOLD||none|int|RW|obsolete spelling
PRESETINDEX||axis|int|RW|preset moves (drives) group
PRESETINDEXMODE||axis|int|RW|preset moves (drives) group
PRESETINDEXMODEOLD||none|int|RW|obsolete spelling
PRESETINDEXOLD||none|int|RW|obsolete spelling
PRESETINDEXSOURCE||axis|int|RW|preset moves (drives) group
PRESETINDEXSOURCEOLD||none|int|RW|obsolete spelling
PRESETINPUTSMAX||axis|int|RW|preset moves (drives) group
PRESETINPUTSMAXOLD||none|int|RW|obsolete spelling
PRESETINPUTSTATE||axis|int|R|preset moves (drives) group
PRESETINPUTSTATEOLD||none|int|RW|obsolete spelling
PRESETJOGDIRECTION||preset|int|RW|preset moves (drives) group
PRESETJOGSPEED||preset|float|RW|preset moves (drives) group
PRESETMOVEENABLE||axis|bool|RW|preset moves (drives) group
PRESETMOVEENABLEOLD||none|int|RW|obsolete spelling
PRESETMOVEHOMETYPE||preset|int|RW|preset moves (drives) group
PRESETMOVEPARAMETER||preset, param|float|RW|preset moves (drives) group
PRESETMOVEPOSITION||preset|float|RW|preset moves (drives) group
PRESETMOVESPEED||preset|float|RW|preset moves (drives) group
PRESETMOVETYPE||preset, param|int|RW|preset moves (drives) group
PRESETSELECTORINPUT||axis|int|RW|preset moves (drives) group
PRESETSELECTORINPUTOLD||none|int|RW|obsolete spelling
PRESETTRIGGERINPUT||axis|int|RW|preset moves (drives) group
PRESETTRIGGERINPUTOLD||none|int|RW|obsolete spelling
PRODUCTCATALOGNUMBER||none|string|RW|listed by the type library without a meaning
PRODUCTSERIALNUMBER||none|string|RW|listed by the type library without a meaning
PROFILEMODE||axis|int|RW|trapezoidal / S-ramp / other
PROFILETIME||none|int|RW|profiler update time
PULSECOUNTER||none|int|RW|pulse counter
PULSEDIRMODE||none|int|RW|listed by the type library without a meaning
PULSEOUTX||channel|int|W|pulse an output for n ms
PWMONTIME||axis|int|RW|PWM output group
PWMPERIOD||none|int|RW|PWM output group
RAMTEST||none|int|RW|listed by the type library without a meaning
READKEY||termid|int|R|key currently held (keypad)
REALTIMECLOCK||none|date|RW|listed by the type library without a meaning
RELAY||bank|bool|RW|relay output
RELAYOUT||bank|int|RW|relay group
RELAYOUTPUTBANKSETUP||bank|int|RW|relay group
RELAYOUTX||relay|bool|RW|relay group
RELEASEBUILD||none|bool|RW|listed by the type library without a meaning
REMOTEADC||canbus, node, channel|float|R|remote analogue in
REMOTEADCDELTA||canbus, node, channel|int|RW|remote node over bus group
REMOTEBAUD||canbus|int|W|remote node over bus group
REMOTECOMMS||bus, node, index|float|RW|comms of remote node
REMOTECOMMSINTEGER||bus, node, index|int|RW|remote node over bus group
REMOTEDAC||canbus, node, channel|float|RW|remote analogue out
REMOTEDEBOUNCE||canbus, node|int|RW|remote node over bus group
REMOTEEMERGENCYMESSAGE||canbus, node|int|R|remote node over bus group
REMOTEENCODER||canbus, node, channel|int|RW|remote node over bus group
REMOTEERROR||canbus, node|int|R|remote node over bus group
REMOTEESTOP||canbus, node|bool|RW|remote node over bus group
REMOTEIN||canbus, node|int|R|remote inputs
REMOTEINBANK||canbus, node, bank|int|R|remote node over bus group
REMOTEINHIBITTIME||bus|int|RW|remote node over bus group
REMOTEINPUTACTIVELEVEL||canbus, node|int|RW|remote node over bus group
REMOTEINX||canbus, node, input|bool|R|remote input
REMOTEMODE||canbus, node|int|RW|remote node over bus group
REMOTENODE||canbus|int|W|remote node over bus group
REMOTENUMBEROF||bus, node, item|int|RW|remote node over bus group
REMOTEOBJECT||bus, node, index, subindex, vartype|int|RW|CANopen object
REMOTEOBJECTFLOAT||bus, node, index, subindex|float|RW|remote node over bus group
REMOTEOBJECTSTRING||bus, node, index, subindex|string|RW|remote node over bus group
REMOTEOUT||canbus, node|int|RW|remote outputs
REMOTEOUTBANK||canbus, node, bank|int|RW|remote node over bus group
REMOTEOUTPUTACTIVELEVEL||canbus, node|int|RW|remote node over bus group
REMOTEOUTPUTERROR||canbus, node|int|RW|remote node over bus group
REMOTEOUTX||canbus, node, output|bool|RW|remote output
REMOTEPDOIN||bus, cobid, bank|int|R|remote node over bus group
REMOTEPDOMODE||bus, node|int|RW|remote node over bus group
REMOTEPDOVALID||bus, node|bool|R|remote node over bus group
REMOTESTATUS||canbus, node|int|RW|remote node over bus group
RESETINPUT|rsi|axis|int|RW|input that resets axis
REVCOUNTDEADBAND||axis|int|RW|listed by the type library without a meaning
SCALEFACTOR||axis|float|RW|counts per user unit
SCALEUNITS||axis, channel|int|RW|listed by the type library without a meaning
SCANOVERRUNLIMIT||none|int|RW|listed by the type library without a meaning
SENTINELACTION||sentinelchannel|int|RW|action of sentinel
SENTINELACTIONMODE||sentinelchannel|int|RW|sentinel (watch) channel group
SENTINELACTIONPARAMETER||sentinelchannel|int|RW|sentinel (watch) channel group
SENTINELLATCH||channel|bool|R|sentinel (watch) channel group
SENTINELPERIOD||sentinelchannel|int|RW|sentinel (watch) channel group
SENTINELSOURCE||sentinelchannel|int|RW|quantity watched
SENTINELSOURCE2||sentinelchannel|int|RW|sentinel (watch) channel group
SENTINELSOURCE2PARAMETER||sentinelchannel|int|RW|sentinel (watch) channel group
SENTINELSOURCEPARAMETER||sentinelchannel|int|RW|sentinel (watch) channel group
SENTINELSTATE||sentinelchannel|int|R|sentinel state
SENTINELTRIGGERABSOLUTE||sentinelchannel|bool|RW|sentinel (watch) channel group
SENTINELTRIGGERMODE||sentinelchannel|int|RW|trigger
SENTINELTRIGGERVALUEFLOAT||sentinelchannel, sentinelband|float|RW|sentinel (watch) channel group
SENTINELTRIGGERVALUEINTEGER||sentinelchannel, sentinelband|int|RW|sentinel (watch) channel group
SERIALBAUD|sb|port|int|RW|serial port group
SERIALBAUDSSUPPORTED||channel|var|R|serial port group
SERIALBUFFERUSAGE||none|int|RW|serial port group
SERIALCHAR||none|int|RW|serial port group
SERIALHANDSHAKEMODE||none|int|RW|serial port group
SERVERVERSION||none|string|RW|host: PC-side item
SEXTANT||axis|int|RW|listed by the type library without a meaning
SHOWPROGRESSDIALOGS||none|bool|RW|host: PC-side item
SOFTLIMITFORWARD||axis|float|RW|software limit +
SOFTLIMITMODE||axis|int|RW|action on soft limit
SOFTLIMITREVERSE||axis|float|RW|software limit -
SOFTWAREDIAGNOSTIC||param1, param2|int|R|listed by the type library without a meaning
SPEED||axis|float|RW|slew speed of moves, uu/s
SPEEDDEMAND|sdd|axis|float|RW|demand speed (drives)
SPEEDERROR||axis|float|R|speed (drives) group
SPEEDERRORFATAL||axis|float|RW|speed (drives) group
SPEEDFILTERBAND||axis|float|RW|speed filter group
SPEEDFILTERFREQ||axis|float|RW|speed filter group
SPEEDFILTERPOLES||axis|int|RW|speed filter group
SPEEDFILTERRIPPLE||axis|float|RW|speed filter group
SPEEDFILTERTYPE||axis|int|RW|speed filter group
SPEEDMEASURED|sms|axis|float|R|measured speed (drives)
SPEEDOBSERVERENABLE||axis|bool|RW|speed observer group
SPEEDOBSERVERK1||axis|float|RW|speed observer group
SPEEDOBSERVERK2||axis|float|RW|speed observer group
SPEEDOBSERVERKJ||axis|float|RW|speed observer group
SPEEDREF|sdr|axis|float|RW|speed reference (drives)
SPEEDREFACCELJERKENDTIME||axis|float|RW|speed reference ramp (drives) group
SPEEDREFACCELJERKSTARTTIME||axis|float|RW|speed reference ramp (drives) group
SPEEDREFACCELSOURCE||axis|int|RW|speed reference ramp (drives) group
SPEEDREFACCELTIME||axis|float|RW|speed reference ramp (drives) group
SPEEDREFDECELJERKENDTIME||axis|float|RW|speed reference ramp (drives) group
SPEEDREFDECELJERKSTARTTIME||axis|float|RW|speed reference ramp (drives) group
SPEEDREFDECELTIME||axis|float|RW|speed reference ramp (drives) group
SPEEDREFENABLE||axis|bool|RW|speed reference ramp (drives) group
SPEEDREFERRORDECELTIME||axis|float|RW|speed reference ramp (drives) group
SPEEDREFSOURCE||axis|int|RW|speed reference ramp (drives) group
SPEEDTESTREF||axis|float|RW|speed (drives) group
SPEEDTESTREFACCELTIME||axis|float|RW|speed (drives) group
SPEEDTESTREFDECELTIME||axis|float|RW|speed (drives) group
SPLINE||axis|int|RW|start spline
SPLINEEND||axis|int|RW|last segment
SPLINEINDEX||axis|int|R|segment executing
SPLINESTART||axis|int|RW|first segment
SPLINESUSPENDTIME||axis|int|RW|ms to ramp on suspend/stop
SPLINETIME||axis|int|RW|ms per segment
SRAMP||axis|float|RW|S-ramp smoothing, percent
STATICHANDLE||lpsztask, lpszvariable|int|R|host: PC-side item
STEPPER||channel|float|RW|stepper pulse count
STEPPERDELAY||channel|float|RW|stepper group
STEPPERIO||axis|int|RW|stepper group
STEPPERMODE||channel|int|RW|pulse mode
STEPPERSCALE||channel|float|RW|scaling
STEPPERVEL||channel|float|R|velocity
STEPPERWRAP||channel|float|RW|wrap
STOPINPUT||axis|int|RW|stop input
STOPINPUTMODE||axis|int|RW|action of stop input
STOPMODE||axis|int|RW|how STOP behaves
STOPSWITCH||axis|bool|R|state of stop input
SUPPORTSMINT||none|bool|RW|host: PC-side item
SUSPEND||axis|int|RW|hold motion (feedhold)
SUSPENDINPUT||axis|int|RW|input for suspend
SUSPENDSWITCH||axis|bool|R|its state
SYSTEMSECONDS||none|float|RW|seconds since power-up
SYSTEMSTATE||none|int|RW|listed by the type library without a meaning
TEMPERATURE||channel|float|R|temperature
TEMPERATURELIMITFATAL||channel|float|R|listed by the type library without a meaning
TEMPERATURELIMITWARNING||channel|float|R|listed by the type library without a meaning
TERMINALADDRESS||terminalid|int|RW|terminal address
TERMINALDEVICE||terminalid|int|RW|terminal device
TERMINALMODE||terminalid|int|RW|terminal mode
TERMINALPORT||terminalid|int|RW|terminal port
TERMINALXOFF||terminalid|bool|W|terminal group
TIME||none|int|RW|free-running ms counter (writable)
TIMEREVENT||none|int|RW|period of timer event, ms
TIMESCALE||axis|float|RW|time base for speed/accel
TORQUE||axis|float|RW|constant torque move
TORQUEDEMAND||axis|float|R|torque demand
TORQUEFILTERBAND||axis, stage|float|RW|torque filter group
TORQUEFILTERDEPTH||axis, stage|float|RW|torque filter group
TORQUEFILTERFREQ||axis, stage|float|RW|torque filter group
TORQUEFILTERTYPE||axis, stage|int|RW|torque filter group
TORQUELIMITNEG||axis|float|RW|limit -
TORQUELIMITPOS||axis|float|RW|limit +
TORQUEPROVINGMODE||axis|int|RW|torque group
TORQUEREF|tqr|axis|float|RW|torque reference
TORQUEREFENABLE||axis|bool|RW|torque reference ramp group
TORQUEREFERRORFALLTIME||axis|float|RW|torque reference ramp group
TORQUEREFFALLTIME||axis|float|RW|torque reference ramp group
TORQUEREFRISETIME||axis|float|RW|torque reference ramp group
TORQUEREFSOURCE||axis|int|RW|torque reference ramp group
TRIGGERCHANNEL||axis|int|RW|channel
TRIGGERCOMPENSATION||axis|float|RW|lag compensation
TRIGGERINPUT||axis|int|RW|input
TRIGGERMODE||axis|int|RW|when a loaded move starts
TRIGGERSOURCE||axis|int|RW|source for trigger
TRIGGERVALUE||axis|float|RW|level
USBDEVICELIST||none|var|RW|host: (host link)
USBDRIVERVERSION||none|string|RW|host: (host link)
USERMOTION||axis|int|W|listed by the type library without a meaning
USERPOSITIONUNITS||axis|string|RW|listed by the type library without a meaning
USERTIMEUNITS||axis|string|RW|listed by the type library without a meaning
VARIABLEDATA||bstrtaskname, bstrvarname|var|RW|host: PC-side item
VECTORANGLE||axisx, axisy|float|R|angle of the current vector
VEL||axis|float|R|measured velocity
VELDEMAND||axis|float|R|demand velocity
VELDEMANDPATH||axis|float|R|path velocity of interpolated move
VELERROR||axis|float|R|velocity error
VELFATAL||axis|float|RW|velocity error trip
VELFATALMODE||axis|int|RW|action
VELREF||axis|float|RW|velocity reference
VELSCALEFACTOR||axis|float|RW|velocity scaling
VELSCALEUNITS||axis|string|RW|text of units
VELSETPOINTMAX||axis|float|RW|window
VELSETPOINTMIN||axis|float|RW|window
VFBOOSTTRANSITIONMODE||axis|int|RW|V/f drive group
VFDEADBAND||axis, channel|float|RW|V/f drive group
VFDEADBANDCENTREFREQ||axis, channel|float|RW|V/f drive group
VFPROFILE||axis|float|RW|V/f drive group
VFSLIPCOMPENSATIONMODE||axis|int|RW|V/f drive group
VFTHREEPOINTFREQ||axis|float|RW|V/f drive group
VFTHREEPOINTMODE||axis|int|RW|V/f drive group
VFTHREEPOINTVOLTS||axis|float|RW|V/f drive group
VOLTAGEDEMAND||axis, channel|float|R|listed by the type library without a meaning
ZEROSPEEDDEADBAND||axis|float|RW|zero speed window
"""
