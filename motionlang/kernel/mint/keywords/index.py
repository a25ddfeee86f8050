"""The keywords of each file, in lower case.

Written by `python -m tools.derived`; do not edit.
"""

from __future__ import annotations

FILES = {
    "hold_to_analogue": """
hta htachannel htakprop hkp htadamping htakint htadeadband hdb htafilter
""",
    "jogging": """
jog jg
""",
    "axis": """
axes scalefactor scale posscalefactor speed sp accel ac decel acceltime deceltime acceljerk deceljerk
profilemode movebuffersize mb driveenable de driveenableswitch des
""",
    "feedrate": """
feedrate feedratemode frm feedrateoverride fro maxspeed maxaccel maxdecel acceltimemax deceltimemax
acceljerktime deceljerktime sramp
""",
    "motion": """
mover mr movea ma go cancel cn cancelall cna
""",
    "buffer": """
_trauto _trgo _trinput _trposition movebufferid mbi movebufferidlast movebufferstatus mbs movebufferlow
triggermode triggerinput triggersource triggerchannel triggervalue movedwell moveout moveoutx movepulseoutx
""",
    "compensation": """
backlash backlashinterval bli backlashmode blm _bloff precisiontable precisionincrement precisionoffset pco
precisionmode _lsoff _lssingle_table _lsdual_table
""",
    "on_the_fly": """
incr inca suspend
""",
    "paths": """
vectora va vectorr vr circlea ca circler cr helixa helixr contourmode contourangle veldemandpath
""",
    "following": """
_mspos _msencoder _msauxencoder _ofstandard _ofspeed_limit _ofaccel_mod _ofspeed_mod _osmaxspeed _osminspeed
_osmaxaccel _osmaxdecel _osprofileerror _oszeroaccel follow fl follownumerator followdenom fly offset
offsetmode offsetstatus ofs
""",
    "following_masters": """
mastersource masterchannel masterdistance followmode gearing gr gearingmode grm offsetdistance
""",
    "following_auxiliary": """
auxencoder auxencodervel auxencodermode auxencoderspeed auxencoderscale auxencoderprescale auxencoderwrap
auxencoderzlatch aez
""",
    "table_motion_cams": """
camtable cam camstart camend camamplitude camindex
""",
    "table_motion_splines": """
_spspline_1 _spabsolute _spt_absolute _spcontinuous _spspline_2 splinetable spline spl splinestart splineend
splinetime splinesuspendtime splineindex
""",
    "state": """
idle id pos ps vel vl posremaining folerror fe movebufferfree
""",
    "timing": """
time wait wt
""",
    "tasks": """
taskpriority taskquantum taskstatus tasksuspend taskresume timerevent eventactive eventpending eventdisable
errcode errline errstring errdata errorpresent errorreadnext errorreadcode errorclear errorstring
""",
    "terminal": """
terminal tm _term1 _term2 _term3 inkey ik readkey rk cls locate line bol beep (terminal) (printer) (row)
""",
    "io_inputs": """
in inx instate instatex isx inputactivelevel inputdebounce idb inputmode inputpostrigger inputnegtrigger imask
""",
    "io_outputs": """
out ot outx otx pulseoutx outputactivelevel oal adc adcgain ag adcoffset ao dac
""",
    "io_signals": """
driveenableoutput deo globalerroroutput geo
""",
    "comms": """
modbusparameter _mpenable _mpdebug _mpdropped_frames _mpregister_mapping _rmcomms_array _rmnet_data
_busserial1 _busethernet comms commsinteger netfloat netinteger
""",
    "modbus": """
modbustcp16 modbustcp32 modbustcpfloat
""",
    "remote": """
remotein remoteinx remoteinbank remoteout remoteoutx remoteoutbank remoteadc remotedac remotemode nodelive
""",
    "network": """
_cetnone _cetoperational _cetpassive _cetoff _cetreceive_overrun _cetdied _cetlive _cetemergency
_cettransmit_overrun busevent canevent buseventinfo caneventinfo
""",
    "limits": """
_emignore _emcrash_stop _emcrash_stop_disable _emerror_decel _emerror_decel_disable _emcall_event
softlimitforward softlimitreverse softlimitmode limitmode limitforward lf limitreverse lr limit folerrormode
errorinputmode axiserror errordecel abortmode abort (line)
""",
    "limits_switches": """
limitforwardinput lfi limitreverseinput lri errorinput ei errorswitch es stopinput stopswitch suspendinput
suspendswitch resetinput rsi
""",
    "limits_resetting": """
stopinputmode stop st stopmode reset resetall default defaultall
""",
    "homing": """
home hm hometype homespeed homebackoff homecreepspeed homeaccel homedecel homeoffset homerefpos homepos hps
homestatus homephase homeinput hi homeswitch hsw _hmnegative_switch _hmnegative_switch_index
_hmpositive_switch _hmpositive_switch_index _hmnegative_index _hmpositive_index _hmnegative_limit
_hmnegative_limit_index _hmpositive_limit _hmpositive_limit_index
""",
    "latches": """
latchtriggermode latchtriggerchannel latchtriggeredge latchsource latchsourcechannel latchmode latchenable
latch latchvalue fastselect fastenable fastlatchedge fastlatchmode fastlatch fastpos fastencoder
""",
    "sensing": """
axismode amd posdemand veldemand acceldemand velerror postarget postargetlast posachieved idlemode idlepos
idlevel idletime systemseconds encoder encodervel encoderscale encoderprescale encoderwrap poswrap posrollover
""",
    "servo": """
kprop kp kint ki kintlimit kil kintmode kim kderiv kd kvel kvelff kaccel looptime lt folerrorfatal torque
""",
    "functions": """
abs sgn int min max sqrt sqr exp log sin cos tan asin acos atan rnd len asc chr str val left right mid iif
""",
    "nonvolatile": """
nvlong nvfloat
""",
    "no_effect": """
_cfoff _cfservo _cfstepper _cfvirtual
""",
    "identity": """
numberof no _noaxes _egcontroller mintexecuting supportsmint nop tron troff _iefailed_to_read_carrier_eeprom
_iefailed_to_read_power1_eeprom _iedsp_failed_to_initialise _iedsp_lost_user_data _iefailed_to_clear_all
_iefailed_to_set_watchdog _ieeeprom_defaults_used
""",
    "legacy": """
err erl erraxis mode holdtoanalog bank contouron contouroff
""",
    "constants": """
_true _false _on _off _pi _maxint _minint _pmtrapezoidal _pmsramp _egall _egsynchronous _egaxis _egmisc
""",
    "language": """
print ? input pause dim const define if then elseif else select case for next step while repeat until loop
exit goto gosub return sub function byval byref task run event startup auto end type as integer float string
semaphore controller using and or xor not mod to is rem
""",
    "library": """
aaabuild absencoder absencodercosoffset absencoderoffset absencodersingain absencodersinoffset absencoderturns
accelscaleunits accelsensordelay accelsensorenable accelsensorfilterfreq accelsensorkint accelsensorkprop
accelsensormode accelsensoroffset accelsensorscale accelsensortype accelsensorvel accelsensorvelerror
accelsensorvelerrorfatal accelsensorvelerrormode activeeventcodes activers485node adcdeadbandhysteresis
adcerror adcerrormode adcfilter adcmax adcmin adcmonitor adctimeconstant analoginputsetup analogoutputsetup
apiargumentvalues apivalue apivaluewritemode appdatawritepermission autohomemode autostartmode autotuneerror
autotuneparam autotunestatus auxdacmode axisadc axisbus axischannel axisdac axiserrorlogmask axisnode
axispdoutput axisposencoder axisstatus axisstatusword axissyncdelay axisvelencoder axiswarning
axiswarningdisable baldordebug betabuild boost bootloaderbaudssupported bootloaderdetails bridgecompenable
bridgeerrorcurrent bridgeerrorvoltage bufferchars bufferdepth burninparameter busbaud busbaudssupported
buscommandmask buscyclerate busenable busmessagemode busnode buspdomapcontent busprocessdata
busprocessdatainterval busprocessdataparameter busprotocol bustelegramdiagnostics bustelegramdiagnosticstrings
canbaud capture captureaxis capturebuffersize capturecommand captureduration cpr captureevent captureeventaxis
captureeventdelay capturehsmode captureinterval cpi capturemode cpm capturemodename capturemodeparameter cpmp
capturenumpoints captureperiod cpp capturepoint capturepretriggerduration captureprogress capturestatus
capturetriggerabsolute capturetriggerchannel capturetriggermode capturetriggersource capturetriggervalue
cardnumber channeltype commandrefsource commandrefsourceparameter commissioned commscontrollerdata
commsmapdatatype commsmapmode commsmapparameter commsmode commsmultiple commsmultipleremote commssync
commstestmode commstestparameter config cf connect connectinfo connectstatus contourparameter contourratio
controllerdata controllerid controllerpresent controllertype controlmode controlmodestartup controlrate
controlrefchannel controlrefsource controlrefsourcestartup countstatics cpuclockspeed currentlimit cl
customerid daclimitmax dacmode dacmonitorabsolute dacmonitoraxis dacmonitorgain dacmonitormode
dacmonitormodeparameter dacmonitoroffset dacmonitorscale dacoffset dacramp dbconfig dbdelay dbenable
dbextavgpower dbextpeakduration dbextpeakpower dbextr dbextthermaltimeconst dbexttripinput dbfreq dbmode
dboverloadmode dbswitchingvolts dbvolts dbvoltslimit deviceopen diagnosticindexedparameter
diagnosticindexedstring diagnosticparameter diagnosticstring digitalinputbanksetup digitaloutputbanksetup
dipswitches drivebusnominalvolts dbn drivebusovervolts drivebustconst drivebusundervolts drivebusvolts dbv
drivedata driveenableinputmode driveenablemode driveerrorlogmask driveerrorstring drivefaultmask drivefeedback
dfb drivefeedbacksource driveokoutput doo driveoperatingmode driveoperatingzone driveoverloadarea doa
driveoverloadfatal driveoverloadgain driveoverloadmode dom driveoverloadwarning driveparameter
driveparameterfloat driveparameterinteger drivepeakcurrent dpc drivepeakduration drivepwmfreq drivepwmmode
driveratedcurrent drc driveratedhorsepower driveratingzone driveratingzoneinfo drivespeedfatal
drivespeedmaxmmps drivespeedmaxrpm drivespeedmin drivetestmode drivetestparameter driveunderloadwarning
driveused driveuseddate drivevolts eepromdata eepromsavebufferstatus encodercyclesize encoderfilterdepth
encoderfiltertype encoderlinesin eli encoderlinesout elo encodermode encoderoutchannel encoderoutresolution
encoderresolution encodersetup encoderstates encoderstatus encodertestmode encodertype encoderzactivelevel
errorbitmapstrings errorlist errorlogstring errparamfamily errparamindex extendedeventdata feedbackfaultenable
ffe firmwarecomponentversion firmwarecrc firmwaremintvmbuild firmwareversion folerrorwarning
frictioncompensation frictioncompensationspeed frictioncompensationtconst group groupcomms groupinfo
groupmaster groupmasterstatus groupstatus h2usbdevicelist hall hallforwardangle hallreverseangle halltable
holdswitch homesources icmchannel initerror initwarning interfaceid internaldata jogaway jogawayoffset kasint
kasprop keypadfirmwareversion kfint kfprop kftime kiint kii kiprop kip kitrack knifemasteraxis knifemode
knifestatus kvderiv kvd kvderivtconst kvfilterlevel kvint kvi kvmeas kvprop kvp kvtime kvtrack language
languagepack latchsetup latchsetupmultiple led leddisplay lifetime listof loaddamping loadinertia
logcommserrors logfilename logrxenabled logtxenabled milerroroffsetglobal mintexpressions mintextendedstatus
mintlineexecuting mintstatus modulename monitorparameter motorbasefreq motorbasevolts motorcatalognumber
motordirection motorencoderlines mel motorfeedback motorfeedbackalignment motorfeedbackangle
motorfeedbackoffset motorfeedbackstatus motorflux motorfluxmax motorfluxmin motorfluxtconst
motorinstabilityfreq motorlinearencoderresolution motorlinearpolepitch motorls mls motormagcurrent
motormagcurrentcoeff motormagcurrentmax motormagcurrentmin motormagind motoroverloadarea motoroverloadmode
motorpeakcurrent motorpeakduration motorpoles mp motorpowermeasured motorratedcurrent mrc motorratedfreq
motorratedspeed motorratedspeedmmps motorratedspeedrpm motorratedvolts motorresolveroffset motorresolverspeed
motorrotorleakageind motorrotorres motorrs mrs motorslipfreq motorspecnumber motorspeedmaxmmps
motorspeedmaxrpm motorstabilitygain motorstatorleakageind motorstatorres motortemperatureinput
motortemperaturemode motortemperatureswitch motortestmode motortype movertest movestatus
multiplecommandsexecute netfloatmultiple netintegermultiple node nd nodenumber nodetype nodetypeextended
numberofextended noe optioncardbus optioncardnetworkaddress optioncardnetworkstatus optioncardobjectfloat
optioncardobjectinteger optioncardobjectstring optioncardstatus optioncardtype optioncardversion
outputmonitormode outputmonitormodeparameter outputtype parameterliststring parameternumbersubset
parametertableversion parametervaluessubset paramsavemode pdolossmode phasesearchbackoff phasesearchbandwidth
phasesearchcurrent phasesearchinput phasesearchmode phasesearchoutput phasesearchspeed phasesearchtravel
platform ptm platformname plcautoenable plccondition plcenable pe plcenableaction plcgearfactor plcoperator
plcparameter plcstatus pss plctaskdata plctaskstatus plctime plxdata portnumber portspeed
positioncontrollooptime posscaleunits postrimgain powerbaseparameter powerreadyinput powerreadyoutput
precisionaxis precisionsource precisionsourcechannel presetdwelltimeold presetindexmodeold presetindexold
presetindexsourceold presetinputsmaxold presetinputstateold presetmoveenableold presetselectorinputold
presettriggerinputold productcatalognumber productserialnumber profiletime pulsecounter pulsedirmode pwmontime
pwmperiod ramtest realtimeclock relayoutputbanksetup releasebuild remoteadcdelta remotebaud remotedebounce
remoteemergencymessage remoteerror remoteinhibittime remotenode remotenumberof remoteoutputerror remotepdomode
remotestatus revcountdeadband scaleunits scanoverrunlimit sentinelaction sentinelactionmode
sentinelactionparameter sentinellatch sentinelperiod sentinelsource sentinelsource2 sentinelsource2parameter
sentinelsourceparameter sentinelstate sentineltriggerabsolute sentineltriggermode sentineltriggervaluefloat
sentineltriggervalueinteger serialbaud sb serialbaudssupported serialhandshakemode serverversion sextant
showprogressdialogs softwarediagnostic speederrorfatal speedfilterband speedfilterfreq speedfilterpoles
speedfilterripple speedfiltertype speedobserverenable speedobserverk1 speedobserverk2 speedobserverkj
speedrefaccelsource statichandle stepperdelay stepperio steppermode systemstate temperature
temperaturelimitfatal temperaturelimitwarning terminaladdress terminaldevice terminalmode terminalport
terminalxoff torquefilterband torquefilterdepth torquefilterfreq torquefiltertype torquelimitneg
torquelimitpos torqueprovingmode torquereferrorfalltime triggercompensation usbdevicelist usbdriverversion
usermotion userpositionunits usertimeunits variabledata velfatal velfatalmode velscaleunits velsetpointmax
velsetpointmin vfboosttransitionmode vfdeadband vfdeadbandcentrefreq vfprofile vfslipcompensationmode
vfthreepointfreq vfthreepointmode vfthreepointvolts voltagedemand zerospeeddeadband presetmovetype
presetmoveposition presetmovespeed presetaccel presetdecel presetjogspeed presetjogdirection
presetmovehometype presetmoveparameter presetindex presetindexmode presetindexsource presetdwelltime
presetselectorinput presetinputsmax presettriggerinput relay relayout relayoutx auxdac ad motorbrake
motorbrakemode motorbrakeoutput motorbrakedelay cambox fastauxselect fastauxenable fastauxlatchedge
fastauxlatchmode fastauxlatchdistance auxencoderzeroenable auxencoderzerolatchmode comparemode compareoutput
comparepos compareenable remoteestop remoteinputactivelevel remoteoutputactivelevel errormask errormaskcode
driveerror dre miscerror miscerrordisable presetinputstate motorbrakestatus fastauxlatch fastauxencoder
encoderzlatch auxencoderzeroposition comparelatch busstate canbusstate remotecomms remotecommsinteger
commsremote remoteencoder remoteobject remoteobjectfloat remoteobjectstring remotepdoin remotepdovalid
asyncerrorpresent enableswitch drivefault posrolloverdemand posrollovertarget posrollovertargetlast
presetmoveenable movecorrection timescale freq speedref sdr speedtestref velref posref speeddemand sdd
torqueref tqr jogcommand jgc velscalefactor accelscalefactor drivespeedmax dsm speedrefenable speedrefsource
speedrefacceltime speedrefdeceltime speedrefacceljerkstarttime speedrefacceljerkendtime
speedrefdeceljerkstarttime speedrefdeceljerkendtime speedreferrordeceltime speedtestrefacceltime
speedtestrefdeceltime torquerefenable torquerefsource torquerefrisetime torquereffalltime jogspeed jgs jogmode
jogduration jogacceltimemax jogdeceltimemax speedmeasured sms speederror torquedemand effort currentmeas cms
currentdemand jogtime feedrateparameter blendmode blenddistance vectorangle camphasestatus stepper steppervel
stepperscale stepperwrap encodercount idlesettlingtime adcdeadband add adcdeadbandoffset adcmode am dprfloat
dprlong holdingregister coil serialchar serialbufferusage fastlatchdistance latchinhibittime latchinhibitvalue
phasesearchstatus averagevel oktoloadmove autotune autotuneabort clearerrorlog controllerreset processorreset
knife movefiducial parametersave plcdefault plctask pushredirect popredirect sentinel binary view con prog new
edit capturetrigger adcoffsettrim beepon beepoff datum eventpend eventunpend camboxdata busreset canbusreset
nodescan remotereset remotepdoout blend camsegment camphase splinesegment serialclearreceivebuffer
serialcleartransmitbuffer serialclearerror systemdefaults sdf factorydefaults fdf servoc
""",
}
