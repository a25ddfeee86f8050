"""The words of Mint's type library (build 5626), A to I: NAME|short form|index|type|access|meaning."""

from __future__ import annotations

WORDS = """\
AAABUILD||none|int|RW|host: PC-side item
ABORTMODE||axis|int|RW|what the axis does when ABORT is issued (no action/crash stop/error-decel/disable...)
ABSENCODER||axis|int|R|absolute encoder group
ABSENCODERCOSOFFSET||axis|int|RW|absolute encoder group
ABSENCODEROFFSET||axis|int|RW|absolute encoder group
ABSENCODERSINGAIN||axis|int|RW|absolute encoder group
ABSENCODERSINOFFSET||axis|int|RW|absolute encoder group
ABSENCODERTURNS||channel|int|RW|absolute encoder group
ACCEL||axis|float|RW|acceleration of profiled moves, user units/s^2
ACCELDEMAND||axis|float|R|instantaneous profiler acceleration
ACCELJERK||axis|float|RW|jerk limit while acceleration builds up, uu/s^3
ACCELJERKTIME||axis|int|RW|time (ms) over which acceleration ramps to ACCEL (S-ramp)
ACCELSCALEFACTOR||axis|float|RW|acceleration scaling (newer drives)
ACCELSCALEUNITS||axis|string|RW|text name of accel units
ACCELSENSORDELAY||axis|int|RW|accelerometer feedback group
ACCELSENSORENABLE||axis|bool|RW|accelerometer feedback group
ACCELSENSORFILTERFREQ||axis|float|RW|accelerometer feedback group
ACCELSENSORKINT||axis|float|RW|accelerometer feedback group
ACCELSENSORKPROP||axis|float|RW|accelerometer feedback group
ACCELSENSORMODE||axis|int|RW|accelerometer feedback group
ACCELSENSOROFFSET||axis|float|RW|accelerometer feedback group
ACCELSENSORSCALE||axis|float|RW|accelerometer feedback group
ACCELSENSORTYPE||axis|int|RW|accelerometer feedback group
ACCELSENSORVEL||axis|float|R|accelerometer feedback group
ACCELSENSORVELERROR||axis|float|R|accelerometer feedback group
ACCELSENSORVELERRORFATAL||axis|float|RW|accelerometer feedback group
ACCELSENSORVELERRORMODE||axis|int|RW|accelerometer feedback group
ACCELTIME||axis|int|RW|acceleration given as a time (ms)
ACCELTIMEMAX||axis|int|RW|acceleration given as time (ms) to reach maximum speed
ACTIVEEVENTCODES||event|var|R|listed by the type library without a meaning
ACTIVERS485NODE||none|int|RW|host: PC-side item
ADC||channel|float|R|analogue input, percent
ADCDEADBAND|add|channel|float|RW|analogue deadband
ADCDEADBANDHYSTERESIS||channel|float|RW|analogue input group
ADCDEADBANDOFFSET||channel|float|RW|analogue input group
ADCERROR||axis|int|R|analogue input group
ADCERRORMODE||axis|int|RW|analogue input group
ADCFILTER||channel|float|RW|analogue input group
ADCGAIN|ag|channel|float|RW|analogue input gain
ADCMAX||channel|float|RW|upper ADC limit for error
ADCMIN||channel|float|RW|lower ADC limit for error
ADCMODE|am|channel|int|RW|analogue input range
ADCMONITOR||axis|int|RW|analogue input group
ADCOFFSET|ao|channel|float|RW|analogue input offset
ADCTIMECONSTANT||channel|float|RW|analogue input group
ANALOGINPUTSETUP||channel|int|RW|listed by the type library without a meaning
ANALOGOUTPUTSETUP||channel|int|RW|listed by the type library without a meaning
APIARGUMENTVALUES||table, argument|var|R|listed by the type library without a meaning
APIVALUE||table, family, index, args|var|RW|listed by the type library without a meaning
APIVALUEWRITEMODE||none|int|RW|listed by the type library without a meaning
APPDATAWRITEPERMISSION||none|bool|RW|host: PC-side item
ASYNCERRORPRESENT||none|bool|RW|listed by the type library without a meaning
AUTOHOMEMODE||axis|int|RW|automatic mode group
AUTOSTARTMODE||axis|int|RW|automatic mode group
AUTOTUNEERROR||none|int|RW|automatic mode group
AUTOTUNEPARAM||param|float|RW|automatic mode group
AUTOTUNESTATUS||none|int|RW|automatic mode group
AUXDAC|ad|channel|float|RW|spare analogue output
AUXDACMODE||channel|int|RW|listed by the type library without a meaning
AUXENCODER||auxchannel|float|RW|auxiliary encoder position
AUXENCODERMODE||auxchannel|int|RW|auxiliary encoder options
AUXENCODERPRESCALE||auxchannel|int|RW|auxiliary encoder group
AUXENCODERSCALE||auxchannel|float|RW|auxiliary encoder scaling
AUXENCODERSPEED||auxchannel|float|RW|virtual-speed source for aux encoder
AUXENCODERVEL||auxchannel|float|R|auxiliary encoder velocity
AUXENCODERWRAP||auxchannel|float|RW|auxiliary encoder wrap range
AUXENCODERZEROENABLE||auxchannel|bool|W|auxiliary encoder group
AUXENCODERZEROLATCHMODE||auxchannel|int|RW|auxiliary encoder group
AUXENCODERZEROPOSITION||auxchannel|float|R|auxiliary encoder group
AUXENCODERZLATCH||auxchannel|bool|R|auxiliary encoder group
AVERAGEVEL||axis|float|R|listed by the type library without a meaning
AXISADC||axis|int|RW|listed by the type library without a meaning
AXISBUS||axis|int|R|bus the (remote) axis is mapped to
AXISCHANNEL||axis|int|RW|hardware channel of the axis
AXISDAC||axis|int|RW|DAC channel used by the axis
AXISERROR||axis|int|RW|bit pattern of latched axis errors
AXISERRORLOGMASK||axis|int|RW|listed by the type library without a meaning
AXISMODE|amd|axis|int|R|current mode of motion (0 = idle)
AXISNODE||axis|int|R|node the axis is mapped to
AXISPDOUTPUT||axis|int|RW|listed by the type library without a meaning
AXISPOSENCODER||axis|int|RW|position feedback channel
AXISSTATUS||axis|int|R|axis status bits
AXISSTATUSWORD||axis|int|R|listed by the type library without a meaning
AXISSYNCDELAY||axis|int|RW|listed by the type library without a meaning
AXISVELENCODER||axis|int|RW|velocity feedback channel
AXISWARNING||axis|int|RW|bit pattern of warnings
AXISWARNINGDISABLE||axis|int|RW|listed by the type library without a meaning
BACKLASH||axis|float|RW|backlash compensation size
BACKLASHINTERVAL||axis|int|RW|backlash application rate
BACKLASHMODE||axis|int|RW|backlash on/off
BALDORDEBUG||none|bool|RW|host: PC-side item
BETABUILD||none|bool|RW|listed by the type library without a meaning
BLENDDISTANCE||axis|float|RW|distance before end of move at which blending starts
BLENDMODE||axis|int|RW|enable blending of interpolated moves
BOOST||axis|bool|RW|listed by the type library without a meaning
BOOTLOADERBAUDSSUPPORTED||none|var|RW|host: PC-side item
BOOTLOADERDETAILS||none|string|RW|host: PC-side item
BRIDGECOMPENABLE||axis|bool|RW|bridge drive group
BRIDGEERRORCURRENT||axis|float|RW|bridge drive group
BRIDGEERRORVOLTAGE||axis|float|RW|bridge drive group
BUFFERCHARS||none|var|RW|host: PC-side item
BUFFERDEPTH||buffer, param|int|RW|listed by the type library without a meaning
BURNINPARAMETER||param|float|RW|listed by the type library without a meaning
BUSBAUD||busid|int|RW|bus baud rate
BUSBAUDSSUPPORTED||bus|var|R|bus group
BUSCOMMANDMASK||fieldbus|int|RW|bus group
BUSCYCLERATE||bus|int|RW|bus group
BUSENABLE||none|bool|RW|bus group
BUSEVENT||busid|int|R|next bus event code
BUSEVENTINFO||busid|int|R|data of bus event
BUSMESSAGEMODE||bus|int|RW|bus group
BUSNODE||bus|int|RW|own node number
BUSPDOMAPCONTENT||bus, node, in, peernode, slot|var|RW|bus group
BUSPROCESSDATA||bus, in, channel|int|RW|bus group
BUSPROCESSDATAINTERVAL||busid|int|RW|bus group
BUSPROCESSDATAPARAMETER||bus, in, channel|int|RW|bus group
BUSPROTOCOL||bus|int|R|bus group
BUSSTATE||busid|int|R|bus state
BUSTELEGRAMDIAGNOSTICS||busid|var|R|bus group
BUSTELEGRAMDIAGNOSTICSTRINGS||busid|var|R|bus group
CAM||axis|int|RW|start a cam move (mode value)
CAMAMPLITUDE||axis|float|RW|scale factor on cam table
CAMBOX||cambox|int|RW|cam box (position-driven outputs) enable
CAMEND||axis|int|RW|last segment used
CAMINDEX||axis|int|R|segment now executing
CAMPHASESTATUS||axis|int|R|state of CAMPHASE
CAMSTART||axis|int|RW|first segment used
CANBAUD||canbus|int|RW|CAN bus group
CANBUSSTATE||canbus|int|R|CAN bus group
CANEVENT||canbus|int|R|CAN bus group
CANEVENTINFO||canbus|int|R|CAN bus group
CAPTURE||none|int|RW|old-style data capture trigger
CAPTUREAXIS||channel|int|RW|axis captured
CAPTUREBUFFERSIZE||none|int|RW|data capture group
CAPTURECOMMAND||none|int|RW|data capture group
CAPTUREDURATION|cpr|none|int|RW|capture length ms
CAPTUREEVENT||none|int|RW|data capture group
CAPTUREEVENTAXIS||none|int|RW|data capture group
CAPTUREEVENTDELAY||none|int|RW|data capture group
CAPTUREHSMODE||channel|int|RW|data capture group
CAPTUREINTERVAL|cpi|none|int|RW|servo ticks between samples
CAPTUREMODE|cpm|channel|int|RW|what a capture channel records
CAPTUREMODENAME||channel|string|R|data capture group
CAPTUREMODEPARAMETER|cpmp|axis|int|RW|data capture group
CAPTURENUMPOINTS||none|int|RW|points per channel
CAPTUREPERIOD|cpp|none|int|RW|sample period
CAPTUREPOINT||channel, index|float|R|read back one sample
CAPTUREPRETRIGGERDURATION||none|int|RW|pre-trigger length
CAPTUREPROGRESS||posttrigger|int|R|percent captured
CAPTURESTATUS||none|int|RW|capture state
CAPTURETRIGGERABSOLUTE||trigger|bool|RW|data capture group
CAPTURETRIGGERCHANNEL||trigger|int|RW|data capture group
CAPTURETRIGGERMODE||trigger|int|RW|trigger kind
CAPTURETRIGGERSOURCE||trigger|int|RW|data capture group
CAPTURETRIGGERVALUE||trigger|float|RW|trigger level
CARDNUMBER||none|int|RW|host: PC-side item
CHANNELTYPE||channel|int|R|listed by the type library without a meaning
COIL||coil|bool|RW|listed by the type library without a meaning
COMMANDREFSOURCE||axis|int|RW|listed by the type library without a meaning
COMMANDREFSOURCEPARAMETER||axis|int|RW|listed by the type library without a meaning
COMMISSIONED||axis|bool|RW|listed by the type library without a meaning
COMMS||index|float|RW|shared comms array element (float)
COMMSCONTROLLERDATA||enum, param|var|R|comms group
COMMSINTEGER||index|int|RW|comms array element as integer
COMMSMAPDATATYPE||axis|int|RW|comms map group
COMMSMAPMODE||index|int|RW|comms map group
COMMSMAPPARAMETER||index|int|RW|comms map group
COMMSMODE||none|int|RW|comms group
COMMSMULTIPLE||index, count|var|RW|several elements at once, of the PC's side: a program uses COMMS
COMMSMULTIPLEREMOTE||node, index, count|var|RW|several elements of a node, of the PC's side: a program uses COMMSREMOTE
COMMSREMOTE||node, index|float|RW|comms array of another node
COMMSSYNC||none|bool|RW|comms group
COMMSTESTMODE||none|int|RW|comms group
COMMSTESTPARAMETER||parameter|float|RW|comms group
COMPAREENABLE||output|bool|RW|position-compare output enable
COMPARELATCH||axis|int|RW|compare state
COMPAREMODE||axis|int|RW|compare mode
COMPAREOUTPUT||axis|int|RW|output used by compare
COMPAREPOS||axis, register|float|RW|compare positions
CONFIG|cf|axis|int|RW|axis type: off/servo/stepper/virtual...
CONNECT||canbus, fromnode, tonode|int|RW|listed by the type library without a meaning
CONNECTINFO||bus, fromnode|var|R|listed by the type library without a meaning
CONNECTSTATUS||canbus, fromnode|int|R|listed by the type library without a meaning
CONTOURANGLE||axis|float|RW|max vector angle for contouring without slowing
CONTOURMODE||axis|int|RW|contouring on/off/options
CONTOURPARAMETER||axis, param|float|RW|contouring parameter
CONTOURRATIO||axis1, axis2|float|RW|listed by the type library without a meaning
CONTROLLERDATA||enum, param|var|R|control group
CONTROLLERID||none|string|RW|host: (control)
CONTROLLERPRESENT||none|bool|RW|host: (control)
CONTROLLERTYPE||none|int|RW|control group
CONTROLMODE||axis|int|RW|drive control mode (position/speed/torque)
CONTROLMODESTARTUP||axis|int|RW|control mode at power-up
CONTROLRATE||axis, channel|int|RW|loop rates
CONTROLREFCHANNEL||axis|int|RW|channel of that source
CONTROLREFSOURCE||axis|int|RW|source of demand
CONTROLREFSOURCESTARTUP||axis|int|RW|control group
COUNTSTATICS||none|int|RW|listed by the type library without a meaning
CPUCLOCKSPEED||none|float|RW|listed by the type library without a meaning
CURRENTDEMAND||axis, channel|float|R|current demand
CURRENTLIMIT|cl|axis|float|RW|current limit
CURRENTMEAS|cms|axis, channel|float|R|measured current
CUSTOMERID||none|int|RW|listed by the type library without a meaning
DAC||channel|float|RW|demand output, percent
DACLIMITMAX||channel|float|RW|limit of demand output
DACMODE||channel|int|RW|DAC mode
DACMONITORABSOLUTE||channel|int|RW|monitor signal on DAC group
DACMONITORAXIS||channel|int|RW|monitor signal on DAC group
DACMONITORGAIN||channel|float|RW|monitor signal on DAC group
DACMONITORMODE||channel|int|RW|monitor signal on DAC group
DACMONITORMODEPARAMETER||channel|int|RW|monitor signal on DAC group
DACMONITOROFFSET||channel|float|RW|monitor signal on DAC group
DACMONITORSCALE||channel|float|RW|monitor signal on DAC group
DACOFFSET||channel|float|RW|DAC offset
DACRAMP||channel|int|RW|DAC ramp on enable
DBCONFIG||axis|int|RW|dynamic brake group
DBDELAY||axis, channel|float|RW|dynamic brake group
DBENABLE||axis|bool|RW|dynamic brake group
DBEXTAVGPOWER||axis|float|RW|dynamic brake group
DBEXTPEAKDURATION||axis|float|RW|dynamic brake group
DBEXTPEAKPOWER||axis|float|RW|dynamic brake group
DBEXTR||axis|float|RW|dynamic brake group
DBEXTTHERMALTIMECONST||axis|float|RW|dynamic brake group
DBEXTTRIPINPUT||axis|int|RW|dynamic brake group
DBFREQ||axis|float|RW|dynamic brake group
DBMODE||axis|int|RW|dynamic brake group
DBOVERLOADMODE||axis|int|RW|dynamic brake group
DBSWITCHINGVOLTS||axis|float|RW|dynamic brake group
DBVOLTS||axis|int|R|dynamic brake group
DBVOLTSLIMIT||axis|float|RW|dynamic brake group
DECEL||axis|float|RW|deceleration, uu/s^2
DECELJERK||axis|float|RW|jerk while deceleration builds
DECELJERKTIME||axis|int|RW|time to build deceleration
DECELTIME||axis|int|RW|deceleration as time
DECELTIMEMAX||axis|int|RW|deceleration as time from max speed
DEVICEOPEN||none|bool|RW|host: PC-side item
DIAGNOSTICINDEXEDPARAMETER||group, captureindex, gdipindex|float|RW|diagnostics (host) group
DIAGNOSTICINDEXEDSTRING||channel, index|string|R|diagnostics (host) group
DIAGNOSTICPARAMETER||group, parameter|float|RW|diagnostics (host) group
DIAGNOSTICSTRING||channel|string|RW|diagnostics (host) group
DIGITALINPUTBANKSETUP||bank|int|RW|listed by the type library without a meaning
DIGITALOUTPUTBANKSETUP||bank|int|RW|listed by the type library without a meaning
DIPSWITCHES||none|int|RW|listed by the type library without a meaning
DPRFLOAT||address|float|RW|dual-port RAM group
DPRLONG||address|int|RW|dual-port RAM group
DRIVEBUSNOMINALVOLTS|dbn|axis|int|R|drive data group
DRIVEBUSOVERVOLTS||axis|int|RW|drive data group
DRIVEBUSTCONST||axis|float|RW|drive data group
DRIVEBUSUNDERVOLTS||axis|int|RW|drive data group
DRIVEBUSVOLTS|dbv|axis|float|R|DC bus volts
DRIVEDATA||transaction|int|RW|drive data group
DRIVEENABLE|de|axis|bool|RW|enable/disable drive of the axis
DRIVEENABLEINPUTMODE||axis|int|RW|drive data group
DRIVEENABLEMODE||axis|int|RW|how enable input and keyword interact
DRIVEENABLEOUTPUT|deo|axis|int|RW|output used for enable
DRIVEENABLESWITCH|des|axis|bool|R|state of hardware enable input
DRIVEERROR|dre|axis|int|RW|drive error bits
DRIVEERRORLOGMASK||axis|int|RW|drive data group
DRIVEERRORSTRING||errorcode|string|R|drive data group
DRIVEFAULT||axis|int|R|drive data group
DRIVEFAULTMASK||none|int|RW|drive data group
DRIVEFEEDBACK|dfb|none|int|RW|drive data group
DRIVEFEEDBACKSOURCE||axis|int|RW|drive data group
DRIVEOKOUTPUT|doo|axis|int|RW|drive data group
DRIVEOPERATINGMODE||axis|int|RW|drive data group
DRIVEOPERATINGZONE||axis|int|RW|drive data group
DRIVEOVERLOADAREA|doa|axis|float|R|drive overload group
DRIVEOVERLOADFATAL||axis|float|RW|drive overload group
DRIVEOVERLOADGAIN||axis|float|RW|drive overload group
DRIVEOVERLOADMODE|dom|axis|int|RW|drive overload group
DRIVEOVERLOADWARNING||axis|float|RW|drive overload group
DRIVEPARAMETER||table, parameter|var|RW|drive data group
DRIVEPARAMETERFLOAT||table, parameter|float|RW|drive data group
DRIVEPARAMETERINTEGER||table, parameter|int|RW|drive data group
DRIVEPEAKCURRENT|dpc|axis|float|R|drive data group
DRIVEPEAKDURATION||axis|float|R|drive data group
DRIVEPWMFREQ||axis|float|R|drive data group
DRIVEPWMMODE||axis|int|RW|drive data group
DRIVERATEDCURRENT|drc|axis|float|R|drive data group
DRIVERATEDHORSEPOWER||axis|float|R|drive data group
DRIVERATINGZONE||axis|int|RW|drive data group
DRIVERATINGZONEINFO||axis, zone, param|float|R|drive data group
DRIVESPEEDFATAL||axis|float|RW|drive data group
DRIVESPEEDMAX|dsm|axis|float|RW|application maximum speed
DRIVESPEEDMAXMMPS||axis|float|RW|drive data group
DRIVESPEEDMAXRPM||axis|int|RW|drive data group
DRIVESPEEDMIN||axis|float|RW|drive data group
DRIVETESTMODE||none|int|RW|drive data group
DRIVETESTPARAMETER||param|float|RW|drive data group
DRIVEUNDERLOADWARNING||axis|float|RW|drive data group
DRIVEUSED||none|int|RW|drive data group
DRIVEUSEDDATE||none|string|RW|drive data group
DRIVEVOLTS||axis|float|R|drive data group
EEPROMDATA||address|int|RW|memory group
EEPROMSAVEBUFFERSTATUS||none|bool|RW|memory group
EFFORT||axis|float|R|percent drive effort
ENABLESWITCH||axis|bool|R|listed by the type library without a meaning
ENCODER||channel|float|RW|encoder position (scaled)
ENCODERCOUNT||axis|int|R|encoder group
ENCODERCYCLESIZE||axis|int|RW|encoder group
ENCODERFILTERDEPTH||encoderchannel|int|RW|encoder group
ENCODERFILTERTYPE||encoderchannel|int|RW|encoder group
ENCODERLINESIN|eli|axis|int|RW|encoder group
ENCODERLINESOUT|elo|axis|int|RW|encoder group
ENCODERMODE||channel|int|RW|count direction etc.
ENCODEROUTCHANNEL||channel|int|RW|encoder group
ENCODEROUTRESOLUTION||channel|int|RW|encoder group
ENCODERPRESCALE||channel|int|RW|divide raw counts
ENCODERRESOLUTION||channel|int|RW|counts per rev
ENCODERSCALE||channel|float|RW|encoder scaling
ENCODERSETUP||channel|int|RW|encoder group
ENCODERSTATES||none|int|RW|encoder group
ENCODERSTATUS||channel|int|R|encoder group
ENCODERTESTMODE||channel|int|RW|encoder group
ENCODERTYPE||channel|int|RW|feedback type
ENCODERVEL||channel|float|R|encoder velocity
ENCODERWRAP||channel|float|RW|encoder wrap range
ENCODERZACTIVELEVEL||none|bool|RW|encoder group
ENCODERZLATCH||channel|bool|R|index latch
ERRCODE||none|int|RW|code of the error last read
ERRDATA||index|int|R|extra data of that error
ERRLINE||none|int|RW|program line of that error
ERRORBITMAPSTRINGS||type|var|R|error reading group
ERRORDECEL||axis|float|RW|deceleration used for error/stop-input stops
ERRORINPUT|ei|axis|int|RW|input mapped as axis error input
ERRORINPUTMODE|eim|axis|int|RW|action on that input
ERRORLIST||group, data|var|R|error reading group
ERRORLOGSTRING||type, errorcode|string|R|error reading group
ERRORMASK||axis|int|RW|which errors cause default action
ERRORMASKCODE||code, data|bool|RW|mask one code
ERRORPRESENT||group, data|bool|R|TRUE if group has errors
ERRORREADCODE||group, data|bool|R|TRUE if given error present and loads ERRCODE...
ERRORREADNEXT||group, data|bool|R|read next error of group
ERRORSTRING||errorcode|string|R|text for code
ERRORSWITCH|es|axis|bool|R|state of error input
ERRPARAMFAMILY||none|int|RW|error reading group
ERRPARAMINDEX||none|int|RW|error reading group
ERRSTRING||none|string|RW|text of that error
EVENTACTIVE||none|int|RW|bit pattern of events executing
EVENTDISABLE||none|int|RW|bit pattern of masked events
EVENTPENDING||none|int|RW|bit pattern of events waiting
EXTENDEDEVENTDATA||none|var|RW|listed by the type library without a meaning
FASTAUXENABLE||axis|int|W|fast latch of aux encoder group
FASTAUXENCODER||axis|float|R|fast latch of aux encoder group
FASTAUXLATCH||axis|bool|R|fast latch of aux encoder group
FASTAUXLATCHDISTANCE||axis|float|RW|fast latch of aux encoder group
FASTAUXLATCHEDGE||axis|bool|RW|fast latch of aux encoder group
FASTAUXLATCHMODE||axis|int|RW|fast latch of aux encoder group
FASTAUXSELECT||axis|int|RW|fast latch of aux encoder group
FASTENABLE||axis|int|W|arm fast latch
FASTENCODER||axis|float|R|encoder value latched by fast input
FASTLATCH||axis|bool|R|fast latch occurred
FASTLATCHDISTANCE||axis|float|RW|ignore distance
FASTLATCHEDGE||axis|bool|RW|latch edge
FASTLATCHMODE||axis|int|RW|latch mode
FASTPOS||axis|float|R|axis position latched by fast input
FASTSELECT||axis|int|RW|input used for latch
FEEDBACKFAULTENABLE|ffe|none|int|RW|listed by the type library without a meaning
FEEDRATE||axis|float|RW|speed of the next loaded move
FEEDRATEMODE||axis|int|RW|which feed rate source applies
FEEDRATEOVERRIDE||axis|float|RW|percentage override
FEEDRATEPARAMETER||axis, override|float|RW|per-move speed/accel parameter
FIRMWARECOMPONENTVERSION||component|float|R|firmware group
FIRMWARECRC||none|int|RW|firmware group
FIRMWAREMINTVMBUILD||none|int|RW|firmware group
FIRMWAREVERSION||none|string|RW|firmware group
FLY||axis|float|W|flying-shear segment: slave distance over MASTERDISTANCE
FOLERROR|fe|axis|float|R|following error
FOLERRORFATAL||axis|float|RW|following error trip level
FOLERRORMODE||axis|int|RW|action on fatal following error
FOLERRORWARNING||axis|float|RW|warning level
FOLLOW||axis|float|RW|gear ratio to master
FOLLOWDENOM||axis|float|RW|ratio denominator
FOLLOWMODE||axis|int|RW|how FOLLOW engages
FOLLOWNUMERATOR||axis|float|RW|ratio numerator
FREQ||axis|float|RW|constant pulse frequency on a stepper axis
FRICTIONCOMPENSATION||axis|float|RW|friction compensation group
FRICTIONCOMPENSATIONSPEED||axis|float|RW|friction compensation group
FRICTIONCOMPENSATIONTCONST||axis|float|RW|friction compensation group
GEARING||axis|float|RW|percent lag compensation
GEARINGMODE||axis|int|RW|lag compensation on/off
GLOBALERROROUTPUT|geo|none|int|RW|output driven when any error
GROUP||canbus, group, nodeid|int|RW|CAN group group
GROUPCOMMS||canbus, group, index|float|W|CAN group group
GROUPINFO||bus, node|int|R|CAN group group
GROUPMASTER||canbus, group|int|RW|CAN group group
GROUPMASTERSTATUS||canbus, group|int|R|CAN group group
GROUPSTATUS||canbus, group|int|R|CAN group group
H2USBDEVICELIST||none|var|RW|host: PC-side item
HALL||axis|int|R|hall sensors group
HALLFORWARDANGLE||axis, sextant|float|RW|hall sensors group
HALLREVERSEANGLE||axis, sextant|float|RW|hall sensors group
HALLTABLE||axis, state|int|RW|hall sensors group
HOLDINGREGISTER||register|int|RW|listed by the type library without a meaning
HOLDSWITCH||axis|int|R|listed by the type library without a meaning
HOME||axis|int|RW|start homing (type)
HOMEACCEL||axis|float|RW|homing acceleration
HOMEBACKOFF||axis|float|RW|divisor of speed when backing off
HOMECREEPSPEED||axis|float|RW|speed seeking index
HOMEDECEL||axis|float|RW|homing deceleration
HOMEINPUT|hi|axis|int|RW|home switch input
HOMEOFFSET||axis|float|RW|distance moved after datum
HOMEPHASE||axis|int|R|phase of homing
HOMEPOS||axis|float|R|position at end of homing before zeroing
HOMEREFPOS||axis|float|RW|position assigned at datum
HOMESOURCES||axis|int|R|listed by the type library without a meaning
HOMESPEED||axis|float|RW|homing speed
HOMESTATUS||axis|bool|RW|1 when homed
HOMESWITCH|hsw|axis|bool|R|state of home input
HOMETYPE||axis|int|RW|stored homing type
HTA||axis|float|RW|hold-to-analogue group
HTACHANNEL||axis|int|RW|hold-to-analogue group
HTADAMPING||axis|float|RW|hold-to-analogue group
HTADEADBAND||axis|float|RW|hold-to-analogue group
HTAFILTER||axis|float|RW|hold-to-analogue group
HTAKINT||axis|float|RW|hold-to-analogue group
HTAKPROP||axis|float|RW|hold-to-analogue group
ICMCHANNEL||none|int|RW|listed by the type library without a meaning
IDLE||axis|bool|R|TRUE when axis idle
IDLEMODE||axis|int|RW|which checks IDLE makes
IDLEPOS||axis|float|RW|position window for idle
IDLESETTLINGTIME||axis|int|R|measured settling time
IDLETIME||axis|int|RW|time windows must hold
IDLEVEL||axis|float|RW|velocity window for idle
IMASK||bank|int|RW|mask of input events
IN||bank|int|R|bank of inputs
INCA||axis|float|W|change target of move in progress (absolute)
INCR||axis|float|W|change target of move in progress (relative)
INITERROR||none|int|RW|listed by the type library without a meaning
INITWARNING||none|int|RW|listed by the type library without a meaning
INKEY||terminalid|int|R|key from terminal (0 if none)
INPUTACTIVELEVEL||bank|int|RW|active high/low bits
INPUTDEBOUNCE||bank|int|RW|debounce samples
INPUTMODE||bank|int|RW|edge/level bits
INPUTNEGTRIGGER||bank|int|RW|falling edge bits
INPUTPOSTRIGGER||bank|int|RW|rising edge bits
INSTATE||bank|int|R|raw state of bank
INSTATEX|isx|input|bool|R|raw state of one input
INTERFACEID||none|string|RW|host: PC-side item
INTERNALDATA||enum1, enum2|var|R|host: PC-side item
INX||input|bool|R|one input
"""
