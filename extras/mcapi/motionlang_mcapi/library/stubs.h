/* The stubs of the functions, written by `python -m tools.derived`, not by hand. */

static const structure STRUCTURES[] = {
    {"ciiiiiidddddddddi", {16, 0}}, /* MCAXISCONFIG */
    {"cddiii", {0}}, /* MCCOMMUTATION */
    {"dddd", {0}}, /* MCCONTOUR */
    {"cdddidddddddidddd", {13, 0}}, /* MCFILTEREX */
    {"dddddddd", {0}}, /* MCFILTER */
    {"cdddddi", {0}}, /* MCJOGEX */
    {"ddddd", {0}}, /* MCJOG */
    {"cddddidddiiiiddi", {0}}, /* MCMOTIONEX */
    {"ddddsddddssssddss", {0}}, /* MCMOTION */
    {"ciiiiiiiiiiiiiiiiiddiddiiiii", {18, 24, 27, 0}}, /* MCPARAMEX */
    {"ssssssssssssssssssssss", {0}}, /* MCPARAM */
    {"dddddd", {0}}, /* MCSCALE */
    {"cDDDD", {0}}, /* MCSTATUSEX */
};

static const function FUNCTIONS[] = {
    {"MCAbort", "", "hW"},
    {"MCArcCenter", "i", "hWsd"},
    {"MCArcEndAngle", "i", "hWsd"},
    {"MCArcRadius", "i", "hWd"},
    {"MCBlockBegin", "i", "hii"},
    {"MCBlockEnd", "i", "h>?i"},
    {"MCCancelTask", "i", "hi"},
    {"MCCaptureData", "i", "hWidd"},
    {"MCClose", "s", "h"},
    {"MCConfigureCompare", "i", "hW[d3idid"},
    {"MCConfigureDigitalIO", "s=", "hWW"},
    {"MCContourDistance", "i", "hWd"},
    {"MCContourPath", "i", "hWWt"},
    {"MCDecodeStatus", "i=", "hDi"},
    {"MCDecodeStatusEx", "i=", "hSmi"},
    {"MCDirection", "", "hWW"},
    {"MCEdgeArm", "i", "hWd"},
    {"MCEnableAxis", "", "hWs"},
    {"MCEnableBacklash", "i", "hWds"},
    {"MCEnableCapture", "i", "hWi"},
    {"MCEnableCompare", "i", "hWi"},
    {"MCEnableDigitalFilter", "i", "hWi"},
    {"MCEnableDigitalIO", "", "hWs"},
    {"MCEnableEncoderFault", "i", "hWi"},
    {"MCEnableGearing", "", "hWWds"},
    {"MCEnableInterrupt", "i", "hwWDm"},
    {"MCEnableJog", "", "hWs"},
    {"MCEnableSync", "", "hWs"},
    {"MCErrorNotify", "", "hwD"},
    {"MCFindAuxEncIdx", "i", "hWd"},
    {"MCFindEdge", "i", "hWd"},
    {"MCFindIndex", "i", "hWd"},
    {"MCGetAccelerationEx", "i", "hW>d"},
    {"MCGetAnalog", "W=", "hW"},
    {"MCGetAnalogEx", "i", "hi>D"},
    {"MCGetAuxEncIdxEx", "i", "hW>d"},
    {"MCGetAuxEncPosEx", "i", "hW>d"},
    {"MCGetAxisConfiguration", "i", "hW>Sa"},
    {"MCGetBreakpointEx", "i", "hW>d"},
    {"MCGetCaptureData", "i", "hWiii>[d4"},
    {"MCGetCaptureSettings", "i", "hW>i>d>d>i"},
    {"MCGetConfiguration", "", "h>Sk"},
    {"MCGetConfigurationEx", "i", "h>Sj"},
    {"MCGetContourConfig", "s", "hW>Sc"},
    {"MCGetContouringCount", "i=", "hW"},
    {"MCGetCount", "i", "hWi>i"},
    {"MCGetDecelerationEx", "i", "hW>d"},
    {"MCGetDigitalFilter", "i", "hW>[d3i>i"},
    {"MCGetDigitalIO", "s=", "hW"},
    {"MCGetDigitalIOConfig", "i", "hW>W"},
    {"MCGetDigitalIOEx", "i", "hW>u"},
    {"MCGetError", "s!", "h"},
    {"MCGetFilterConfig", "s", "hW>Se"},
    {"MCGetFilterConfigEx", "i", "hW>Sd"},
    {"MCGetFollowingError", "i", "hW>d"},
    {"MCGetGain", "i", "hW>d"},
    {"MCGetIndexEx", "i", "hW>d"},
    {"MCGetInstalledModules", "i", "h>[i2i"},
    {"MCGetJogConfig", "s", "hW>Sg"},
    {"MCGetJogConfigEx", "i", "hW>Sf"},
    {"MCGetLimits", "i", "hW>s>s>d>d"},
    {"MCGetModuleInputMode", "i", "hW>i"},
    {"MCGetModuleOutputMode", "i", "hW>W"},
    {"MCGetMotionConfig", "s", "hW>Si"},
    {"MCGetMotionConfigEx", "i", "hW>Sh"},
    {"MCGetOperatingMode", "i", "hW>i"},
    {"MCGetOptimalEx", "i", "hW>d"},
    {"MCGetPositionEx", "i", "hW>d"},
    {"MCGetProfile", "i", "hW>W"},
    {"MCGetRegister", "i", "hi>v3i"},
    {"MCGetScale", "s", "hW>Sl"},
    {"MCGetServoOutputPhase", "i", "hW>W"},
    {"MCGetStatus", "D=", "hW"},
    {"MCGetStatusEx", "i", "hW>Sm"},
    {"MCGetTargetEx", "i", "hW>d"},
    {"MCGetTorque", "i", "hW>d"},
    {"MCGetTrajectoryRate", "i", "h>i"},
    {"MCGetVectorVelocity", "i", "hW>d"},
    {"MCGetVelocityActual", "i", "hW>d"},
    {"MCGetVelocityEx", "i", "hW>d"},
    {"MCGetVelocityOverride", "i", "hW>d"},
    {"MCGetVersion", "D=", "h"},
    {"MCGo", "", "hW"},
    {"MCGoEx", "i", "hWd"},
    {"MCGoHome", "", "hW"},
    {"MCIndexArm", "i", "hWd"},
    {"MCInterruptOnPosition", "i", "hWid"},
    {"MCIsAtTarget", "i?", "hWd"},
    {"MCIsDigitalFilter", "i?", "hW"},
    {"MCIsEdgeFound", "i?", "hWd"},
    {"MCIsIndexFound", "i?", "hWd"},
    {"MCIsStopped", "i?", "hWd"},
    {"MCLearnPoint", "i", "hWiW"},
    {"MCMacroCall", "", "hW"},
    {"MCMoveAbsolute", "", "hWd"},
    {"MCMoveRelative", "", "hWd"},
    {"MCMoveToPoint", "i", "hWi"},
    {"MCOpen", "h=", "sW?t"},
    {"MCReopen", "i", "hW"},
    {"MCRepeat", "i", "hi"},
    {"MCReset", "", "hW"},
    {"MCSetAcceleration", "", "hWd"},
    {"MCSetAnalog", "", "hWW"},
    {"MCSetAnalogEx", "i", "hiD"},
    {"MCSetAuxEncPos", "", "hWd"},
    {"MCSetCommutation", "i", "hWSb"},
    {"MCSetContourConfig", "s", "hWSc"},
    {"MCSetDeceleration", "", "hWd"},
    {"MCSetDigitalFilter", "i", "hW[d3i"},
    {"MCSetFilterConfig", "s", "hWSe"},
    {"MCSetFilterConfigEx", "i", "hWSd"},
    {"MCSetGain", "i", "hWd"},
    {"MCSetJogConfig", "s", "hWSg"},
    {"MCSetJogConfigEx", "i", "hWSf"},
    {"MCSetLimits", "i", "hWssdd"},
    {"MCSetModuleInputMode", "i", "hWi"},
    {"MCSetModuleOutputMode", "", "hWW"},
    {"MCSetMotionConfig", "s", "hWSi"},
    {"MCSetMotionConfigEx", "i", "hWSh"},
    {"MCSetOperatingMode", "", "hWWW"},
    {"MCSetPosition", "", "hWd"},
    {"MCSetProfile", "", "hWW"},
    {"MCSetRegister", "i", "hiv3i"},
    {"MCSetScale", "s", "hWSl"},
    {"MCSetServoOutputPhase", "", "hWW"},
    {"MCSetTimeoutEx", "i", "hd>?d"},
    {"MCSetTorque", "i", "hWd"},
    {"MCSetTrajectoryRate", "i", "hi"},
    {"MCSetVectorVelocity", "i", "hWd"},
    {"MCSetVelocity", "", "hWd"},
    {"MCSetVelocityOverride", "i", "hWd"},
    {"MCStop", "", "hW"},
    {"MCTranslateErrorEx", "i!", "s>b2i"},
    {"MCWait", "", "hd"},
    {"MCWaitForDigitalIO", "", "hWs"},
    {"MCWaitForEdge", "i", "hWs"},
    {"MCWaitForIndex", "i", "hW"},
    {"MCWaitForPosition", "", "hWd"},
    {"MCWaitForRelative", "", "hWd"},
    {"MCWaitForStop", "", "hWd"},
    {"MCWaitForTarget", "", "hWd"},
    {"pmccmd", "s", "hsm"},
    {"pmccmdex", "i", "hWW?v4i"},
    {"pmccmdrpyex", "i", "hWW?v4i>v6i"},
    {"pmcgetc", "s=", "h"},
    {"pmcgetram", "", "hWms"},
    {"pmcgetramex", "i", "hDmD"},
    {"pmcgets", "s=", "h>b2s"},
    {"pmclock", "D!", "hD"},
    {"pmclookupvar", "i", "ht>D"},
    {"pmcputc", "s=", "hs"},
    {"pmcputram", "", "hWms"},
    {"pmcputramex", "i", "hDmD"},
    {"pmcputs", "s=", "ht"},
    {"pmcrdy", "s=", "h"},
    {"pmcrpy", "s", "hsm"},
    {"pmcrpyex", "i", "h>v2i"},
    {"pmcunlock", "", "h"},
};

MCAPI_EXPORT void APIENTRY MCAbort(HCTRLR hCtlr, WORD axis)
{
    item a[] = {{.i = hCtlr}, {.i = axis}}, r = {0};
    double begin;
    void *real = enter(0, &begin);
    if (real) ((void (APIENTRY *)(HCTRLR, WORD))(intptr_t)real)(hCtlr, axis);
    leave(0, a, r, begin, real != NULL);
}

MCAPI_EXPORT int APIENTRY MCArcCenter(HCTRLR hCtlr, WORD axis, short type, double position)
{
    item a[] = {{.i = hCtlr}, {.i = axis}, {.i = type}, {.d = position}}, r = {0};
    double begin;
    void *real = enter(1, &begin);
    if (real) r.i = ((int (APIENTRY *)(HCTRLR, WORD, short, double))(intptr_t)real)(hCtlr, axis, type, position);
    return (int)leave(1, a, r, begin, real != NULL).i;
}

MCAPI_EXPORT int APIENTRY MCArcEndAngle(HCTRLR hCtlr, WORD axis, short type, double angle)
{
    item a[] = {{.i = hCtlr}, {.i = axis}, {.i = type}, {.d = angle}}, r = {0};
    double begin;
    void *real = enter(2, &begin);
    if (real) r.i = ((int (APIENTRY *)(HCTRLR, WORD, short, double))(intptr_t)real)(hCtlr, axis, type, angle);
    return (int)leave(2, a, r, begin, real != NULL).i;
}

MCAPI_EXPORT int APIENTRY MCArcRadius(HCTRLR hCtlr, WORD axis, double radius)
{
    item a[] = {{.i = hCtlr}, {.i = axis}, {.d = radius}}, r = {0};
    double begin;
    void *real = enter(3, &begin);
    if (real) r.i = ((int (APIENTRY *)(HCTRLR, WORD, double))(intptr_t)real)(hCtlr, axis, radius);
    return (int)leave(3, a, r, begin, real != NULL).i;
}

MCAPI_EXPORT int APIENTRY MCBlockBegin(HCTRLR hCtlr, int mode, int num)
{
    item a[] = {{.i = hCtlr}, {.i = mode}, {.i = num}}, r = {0};
    double begin;
    void *real = enter(4, &begin);
    if (real) r.i = ((int (APIENTRY *)(HCTRLR, int, int))(intptr_t)real)(hCtlr, mode, num);
    return (int)leave(4, a, r, begin, real != NULL).i;
}

MCAPI_EXPORT int APIENTRY MCBlockEnd(HCTRLR hCtlr, int *taskID)
{
    item a[] = {{.i = hCtlr}, {.p = taskID}}, r = {0};
    double begin;
    void *real = enter(5, &begin);
    if (real) r.i = ((int (APIENTRY *)(HCTRLR, int *))(intptr_t)real)(hCtlr, taskID);
    return (int)leave(5, a, r, begin, real != NULL).i;
}

MCAPI_EXPORT int APIENTRY MCCancelTask(HCTRLR hCtlr, int taskID)
{
    item a[] = {{.i = hCtlr}, {.i = taskID}}, r = {0};
    double begin;
    void *real = enter(6, &begin);
    if (real) r.i = ((int (APIENTRY *)(HCTRLR, int))(intptr_t)real)(hCtlr, taskID);
    return (int)leave(6, a, r, begin, real != NULL).i;
}

MCAPI_EXPORT int APIENTRY MCCaptureData(HCTRLR hCtlr, WORD axis, int points, double period, double delay)
{
    item a[] = {{.i = hCtlr}, {.i = axis}, {.i = points}, {.d = period}, {.d = delay}}, r = {0};
    double begin;
    void *real = enter(7, &begin);
    if (real) r.i = ((int (APIENTRY *)(HCTRLR, WORD, int, double, double))(intptr_t)real)(hCtlr, axis, points, period, delay);
    return (int)leave(7, a, r, begin, real != NULL).i;
}

MCAPI_EXPORT short APIENTRY MCClose(HCTRLR hCtlr)
{
    item a[] = {{.i = hCtlr}}, r = {0};
    double begin;
    void *real = enter(8, &begin);
    if (real) r.i = ((short (APIENTRY *)(HCTRLR))(intptr_t)real)(hCtlr);
    return (short)leave(8, a, r, begin, real != NULL).i;
}

MCAPI_EXPORT int APIENTRY MCConfigureCompare(HCTRLR hCtlr, WORD axis, double *values, int num, double inc, int mode, double period)
{
    item a[] = {{.i = hCtlr}, {.i = axis}, {.p = values}, {.i = num}, {.d = inc}, {.i = mode}, {.d = period}}, r = {0};
    double begin;
    void *real = enter(9, &begin);
    if (real) r.i = ((int (APIENTRY *)(HCTRLR, WORD, double *, int, double, int, double))(intptr_t)real)(hCtlr, axis, values, num, inc, mode, period);
    return (int)leave(9, a, r, begin, real != NULL).i;
}

MCAPI_EXPORT short APIENTRY MCConfigureDigitalIO(HCTRLR hCtlr, WORD channel, WORD mode)
{
    item a[] = {{.i = hCtlr}, {.i = channel}, {.i = mode}}, r = {0};
    double begin;
    void *real = enter(10, &begin);
    if (real) r.i = ((short (APIENTRY *)(HCTRLR, WORD, WORD))(intptr_t)real)(hCtlr, channel, mode);
    return (short)leave(10, a, r, begin, real != NULL).i;
}

MCAPI_EXPORT int APIENTRY MCContourDistance(HCTRLR hCtlr, WORD axis, double distance)
{
    item a[] = {{.i = hCtlr}, {.i = axis}, {.d = distance}}, r = {0};
    double begin;
    void *real = enter(11, &begin);
    if (real) r.i = ((int (APIENTRY *)(HCTRLR, WORD, double))(intptr_t)real)(hCtlr, axis, distance);
    return (int)leave(11, a, r, begin, real != NULL).i;
}

MCAPI_EXPORT int APIENTRY MCContourPath(HCTRLR hCtlr, WORD axis, WORD wMode, const char *buffer)
{
    item a[] = {{.i = hCtlr}, {.i = axis}, {.i = wMode}, {.p = buffer}}, r = {0};
    double begin;
    void *real = enter(12, &begin);
    if (real) r.i = ((int (APIENTRY *)(HCTRLR, WORD, WORD, const char *))(intptr_t)real)(hCtlr, axis, wMode, buffer);
    return (int)leave(12, a, r, begin, real != NULL).i;
}

MCAPI_EXPORT int APIENTRY MCDecodeStatus(HCTRLR hCtlr, DWORD status, int bit)
{
    item a[] = {{.i = hCtlr}, {.i = status}, {.i = bit}}, r = {0};
    double begin;
    void *real = enter(13, &begin);
    if (real) r.i = ((int (APIENTRY *)(HCTRLR, DWORD, int))(intptr_t)real)(hCtlr, status, bit);
    return (int)leave(13, a, r, begin, real != NULL).i;
}

MCAPI_EXPORT int APIENTRY MCDecodeStatusEx(HCTRLR hCtlr, MCSTATUSEX *status, int bit)
{
    item a[] = {{.i = hCtlr}, {.p = status}, {.i = bit}}, r = {0};
    double begin;
    void *real = enter(14, &begin);
    if (real) r.i = ((int (APIENTRY *)(HCTRLR, MCSTATUSEX *, int))(intptr_t)real)(hCtlr, status, bit);
    return (int)leave(14, a, r, begin, real != NULL).i;
}

MCAPI_EXPORT void APIENTRY MCDirection(HCTRLR hCtlr, WORD axis, WORD dir)
{
    item a[] = {{.i = hCtlr}, {.i = axis}, {.i = dir}}, r = {0};
    double begin;
    void *real = enter(15, &begin);
    if (real) ((void (APIENTRY *)(HCTRLR, WORD, WORD))(intptr_t)real)(hCtlr, axis, dir);
    leave(15, a, r, begin, real != NULL);
}

MCAPI_EXPORT int APIENTRY MCEdgeArm(HCTRLR hCtlr, WORD axis, double position)
{
    item a[] = {{.i = hCtlr}, {.i = axis}, {.d = position}}, r = {0};
    double begin;
    void *real = enter(16, &begin);
    if (real) r.i = ((int (APIENTRY *)(HCTRLR, WORD, double))(intptr_t)real)(hCtlr, axis, position);
    return (int)leave(16, a, r, begin, real != NULL).i;
}

MCAPI_EXPORT void APIENTRY MCEnableAxis(HCTRLR hCtlr, WORD axis, short state)
{
    item a[] = {{.i = hCtlr}, {.i = axis}, {.i = state}}, r = {0};
    double begin;
    void *real = enter(17, &begin);
    if (real) ((void (APIENTRY *)(HCTRLR, WORD, short))(intptr_t)real)(hCtlr, axis, state);
    leave(17, a, r, begin, real != NULL);
}

MCAPI_EXPORT int APIENTRY MCEnableBacklash(HCTRLR hCtlr, WORD axis, double backlash, short state)
{
    item a[] = {{.i = hCtlr}, {.i = axis}, {.d = backlash}, {.i = state}}, r = {0};
    double begin;
    void *real = enter(18, &begin);
    if (real) r.i = ((int (APIENTRY *)(HCTRLR, WORD, double, short))(intptr_t)real)(hCtlr, axis, backlash, state);
    return (int)leave(18, a, r, begin, real != NULL).i;
}

MCAPI_EXPORT int APIENTRY MCEnableCapture(HCTRLR hCtlr, WORD axis, int count)
{
    item a[] = {{.i = hCtlr}, {.i = axis}, {.i = count}}, r = {0};
    double begin;
    void *real = enter(19, &begin);
    if (real) r.i = ((int (APIENTRY *)(HCTRLR, WORD, int))(intptr_t)real)(hCtlr, axis, count);
    return (int)leave(19, a, r, begin, real != NULL).i;
}

MCAPI_EXPORT int APIENTRY MCEnableCompare(HCTRLR hCtlr, WORD axis, int count)
{
    item a[] = {{.i = hCtlr}, {.i = axis}, {.i = count}}, r = {0};
    double begin;
    void *real = enter(20, &begin);
    if (real) r.i = ((int (APIENTRY *)(HCTRLR, WORD, int))(intptr_t)real)(hCtlr, axis, count);
    return (int)leave(20, a, r, begin, real != NULL).i;
}

MCAPI_EXPORT int APIENTRY MCEnableDigitalFilter(HCTRLR hCtlr, WORD axis, int state)
{
    item a[] = {{.i = hCtlr}, {.i = axis}, {.i = state}}, r = {0};
    double begin;
    void *real = enter(21, &begin);
    if (real) r.i = ((int (APIENTRY *)(HCTRLR, WORD, int))(intptr_t)real)(hCtlr, axis, state);
    return (int)leave(21, a, r, begin, real != NULL).i;
}

MCAPI_EXPORT void APIENTRY MCEnableDigitalIO(HCTRLR hCtlr, WORD channel, short state)
{
    item a[] = {{.i = hCtlr}, {.i = channel}, {.i = state}}, r = {0};
    double begin;
    void *real = enter(22, &begin);
    if (real) ((void (APIENTRY *)(HCTRLR, WORD, short))(intptr_t)real)(hCtlr, channel, state);
    leave(22, a, r, begin, real != NULL);
}

MCAPI_EXPORT int APIENTRY MCEnableEncoderFault(HCTRLR hCtlr, WORD axis, int state)
{
    item a[] = {{.i = hCtlr}, {.i = axis}, {.i = state}}, r = {0};
    double begin;
    void *real = enter(23, &begin);
    if (real) r.i = ((int (APIENTRY *)(HCTRLR, WORD, int))(intptr_t)real)(hCtlr, axis, state);
    return (int)leave(23, a, r, begin, real != NULL).i;
}

MCAPI_EXPORT void APIENTRY MCEnableGearing(HCTRLR hCtlr, WORD axis, WORD master, double ratio, short state)
{
    item a[] = {{.i = hCtlr}, {.i = axis}, {.i = master}, {.d = ratio}, {.i = state}}, r = {0};
    double begin;
    void *real = enter(24, &begin);
    if (real) ((void (APIENTRY *)(HCTRLR, WORD, WORD, double, short))(intptr_t)real)(hCtlr, axis, master, ratio, state);
    leave(24, a, r, begin, real != NULL);
}

MCAPI_EXPORT int APIENTRY MCEnableInterrupt(HWND hWnd, HCTRLR hCtlr, WORD axis, DWORD mask, MCINTERRUPTPROC *lpIntFunc)
{
    item a[] = {{.i = hCtlr}, {.i = (long long)(intptr_t)hWnd}, {.i = axis}, {.i = mask}, {.p = lpIntFunc}}, r = {0};
    double begin;
    void *real = enter(25, &begin);
    if (real) r.i = ((int (APIENTRY *)(HWND, HCTRLR, WORD, DWORD, MCINTERRUPTPROC *))(intptr_t)real)(hWnd, hCtlr, axis, mask, lpIntFunc);
    return (int)leave(25, a, r, begin, real != NULL).i;
}

MCAPI_EXPORT void APIENTRY MCEnableJog(HCTRLR hCtlr, WORD axis, short state)
{
    item a[] = {{.i = hCtlr}, {.i = axis}, {.i = state}}, r = {0};
    double begin;
    void *real = enter(26, &begin);
    if (real) ((void (APIENTRY *)(HCTRLR, WORD, short))(intptr_t)real)(hCtlr, axis, state);
    leave(26, a, r, begin, real != NULL);
}

MCAPI_EXPORT void APIENTRY MCEnableSync(HCTRLR hCtlr, WORD axis, short state)
{
    item a[] = {{.i = hCtlr}, {.i = axis}, {.i = state}}, r = {0};
    double begin;
    void *real = enter(27, &begin);
    if (real) ((void (APIENTRY *)(HCTRLR, WORD, short))(intptr_t)real)(hCtlr, axis, state);
    leave(27, a, r, begin, real != NULL);
}

MCAPI_EXPORT void APIENTRY MCErrorNotify(HWND hWnd, HCTRLR hCtlr, DWORD errormask)
{
    item a[] = {{.i = hCtlr}, {.i = (long long)(intptr_t)hWnd}, {.i = errormask}}, r = {0};
    double begin;
    void *real = enter(28, &begin);
    if (real) ((void (APIENTRY *)(HWND, HCTRLR, DWORD))(intptr_t)real)(hWnd, hCtlr, errormask);
    leave(28, a, r, begin, real != NULL);
}

MCAPI_EXPORT int APIENTRY MCFindAuxEncIdx(HCTRLR hCtlr, WORD axis, double position)
{
    item a[] = {{.i = hCtlr}, {.i = axis}, {.d = position}}, r = {0};
    double begin;
    void *real = enter(29, &begin);
    if (real) r.i = ((int (APIENTRY *)(HCTRLR, WORD, double))(intptr_t)real)(hCtlr, axis, position);
    return (int)leave(29, a, r, begin, real != NULL).i;
}

MCAPI_EXPORT int APIENTRY MCFindEdge(HCTRLR hCtlr, WORD axis, double position)
{
    item a[] = {{.i = hCtlr}, {.i = axis}, {.d = position}}, r = {0};
    double begin;
    void *real = enter(30, &begin);
    if (real) r.i = ((int (APIENTRY *)(HCTRLR, WORD, double))(intptr_t)real)(hCtlr, axis, position);
    return (int)leave(30, a, r, begin, real != NULL).i;
}

MCAPI_EXPORT int APIENTRY MCFindIndex(HCTRLR hCtlr, WORD axis, double position)
{
    item a[] = {{.i = hCtlr}, {.i = axis}, {.d = position}}, r = {0};
    double begin;
    void *real = enter(31, &begin);
    if (real) r.i = ((int (APIENTRY *)(HCTRLR, WORD, double))(intptr_t)real)(hCtlr, axis, position);
    return (int)leave(31, a, r, begin, real != NULL).i;
}

MCAPI_EXPORT int APIENTRY MCGetAccelerationEx(HCTRLR hCtlr, WORD axis, double *acceleration)
{
    item a[] = {{.i = hCtlr}, {.i = axis}, {.p = acceleration}}, r = {0};
    double begin;
    void *real = enter(32, &begin);
    if (real) r.i = ((int (APIENTRY *)(HCTRLR, WORD, double *))(intptr_t)real)(hCtlr, axis, acceleration);
    return (int)leave(32, a, r, begin, real != NULL).i;
}

MCAPI_EXPORT WORD APIENTRY MCGetAnalog(HCTRLR hCtlr, WORD channel)
{
    item a[] = {{.i = hCtlr}, {.i = channel}}, r = {0};
    double begin;
    void *real = enter(33, &begin);
    if (real) r.i = ((WORD (APIENTRY *)(HCTRLR, WORD))(intptr_t)real)(hCtlr, channel);
    return (WORD)leave(33, a, r, begin, real != NULL).i;
}

MCAPI_EXPORT int APIENTRY MCGetAnalogEx(HCTRLR hCtlr, int channel, DWORD *value)
{
    item a[] = {{.i = hCtlr}, {.i = channel}, {.p = value}}, r = {0};
    double begin;
    void *real = enter(34, &begin);
    if (real) r.i = ((int (APIENTRY *)(HCTRLR, int, DWORD *))(intptr_t)real)(hCtlr, channel, value);
    return (int)leave(34, a, r, begin, real != NULL).i;
}

MCAPI_EXPORT int APIENTRY MCGetAuxEncIdxEx(HCTRLR hCtlr, WORD axis, double *index)
{
    item a[] = {{.i = hCtlr}, {.i = axis}, {.p = index}}, r = {0};
    double begin;
    void *real = enter(35, &begin);
    if (real) r.i = ((int (APIENTRY *)(HCTRLR, WORD, double *))(intptr_t)real)(hCtlr, axis, index);
    return (int)leave(35, a, r, begin, real != NULL).i;
}

MCAPI_EXPORT int APIENTRY MCGetAuxEncPosEx(HCTRLR hCtlr, WORD axis, double *position)
{
    item a[] = {{.i = hCtlr}, {.i = axis}, {.p = position}}, r = {0};
    double begin;
    void *real = enter(36, &begin);
    if (real) r.i = ((int (APIENTRY *)(HCTRLR, WORD, double *))(intptr_t)real)(hCtlr, axis, position);
    return (int)leave(36, a, r, begin, real != NULL).i;
}

MCAPI_EXPORT int APIENTRY MCGetAxisConfiguration(HCTRLR hCtlr, WORD axis, MCAXISCONFIG *axiscfg)
{
    item a[] = {{.i = hCtlr}, {.i = axis}, {.p = axiscfg}}, r = {0};
    double begin;
    void *real = enter(37, &begin);
    if (real) r.i = ((int (APIENTRY *)(HCTRLR, WORD, MCAXISCONFIG *))(intptr_t)real)(hCtlr, axis, axiscfg);
    return (int)leave(37, a, r, begin, real != NULL).i;
}

MCAPI_EXPORT int APIENTRY MCGetBreakpointEx(HCTRLR hCtlr, WORD axis, double *breakpoint)
{
    item a[] = {{.i = hCtlr}, {.i = axis}, {.p = breakpoint}}, r = {0};
    double begin;
    void *real = enter(38, &begin);
    if (real) r.i = ((int (APIENTRY *)(HCTRLR, WORD, double *))(intptr_t)real)(hCtlr, axis, breakpoint);
    return (int)leave(38, a, r, begin, real != NULL).i;
}

MCAPI_EXPORT int APIENTRY MCGetCaptureData(HCTRLR hCtlr, WORD axis, int type, int start, int points, double *data)
{
    item a[] = {{.i = hCtlr}, {.i = axis}, {.i = type}, {.i = start}, {.i = points}, {.p = data}}, r = {0};
    double begin;
    void *real = enter(39, &begin);
    if (real) r.i = ((int (APIENTRY *)(HCTRLR, WORD, int, int, int, double *))(intptr_t)real)(hCtlr, axis, type, start, points, data);
    return (int)leave(39, a, r, begin, real != NULL).i;
}

MCAPI_EXPORT int APIENTRY MCGetCaptureSettings(HCTRLR hCtlr, WORD axis, int *points, double *period, double *delay, int *index)
{
    item a[] = {{.i = hCtlr}, {.i = axis}, {.p = points}, {.p = period}, {.p = delay}, {.p = index}}, r = {0};
    double begin;
    void *real = enter(40, &begin);
    if (real) r.i = ((int (APIENTRY *)(HCTRLR, WORD, int *, double *, double *, int *))(intptr_t)real)(hCtlr, axis, points, period, delay, index);
    return (int)leave(40, a, r, begin, real != NULL).i;
}

MCAPI_EXPORT void APIENTRY MCGetConfiguration(HCTRLR hCtlr, MCPARAM *param)
{
    item a[] = {{.i = hCtlr}, {.p = param}}, r = {0};
    double begin;
    void *real = enter(41, &begin);
    if (real) ((void (APIENTRY *)(HCTRLR, MCPARAM *))(intptr_t)real)(hCtlr, param);
    leave(41, a, r, begin, real != NULL);
}

MCAPI_EXPORT int APIENTRY MCGetConfigurationEx(HCTRLR hCtlr, MCPARAMEX *param)
{
    item a[] = {{.i = hCtlr}, {.p = param}}, r = {0};
    double begin;
    void *real = enter(42, &begin);
    if (real) r.i = ((int (APIENTRY *)(HCTRLR, MCPARAMEX *))(intptr_t)real)(hCtlr, param);
    return (int)leave(42, a, r, begin, real != NULL).i;
}

MCAPI_EXPORT short APIENTRY MCGetContourConfig(HCTRLR hCtlr, WORD axis, MCCONTOUR *contour)
{
    item a[] = {{.i = hCtlr}, {.i = axis}, {.p = contour}}, r = {0};
    double begin;
    void *real = enter(43, &begin);
    if (real) r.i = ((short (APIENTRY *)(HCTRLR, WORD, MCCONTOUR *))(intptr_t)real)(hCtlr, axis, contour);
    return (short)leave(43, a, r, begin, real != NULL).i;
}

MCAPI_EXPORT int APIENTRY MCGetContouringCount(HCTRLR hCtlr, WORD axis)
{
    item a[] = {{.i = hCtlr}, {.i = axis}}, r = {0};
    double begin;
    void *real = enter(44, &begin);
    if (real) r.i = ((int (APIENTRY *)(HCTRLR, WORD))(intptr_t)real)(hCtlr, axis);
    return (int)leave(44, a, r, begin, real != NULL).i;
}

MCAPI_EXPORT int APIENTRY MCGetCount(HCTRLR hCtlr, WORD axis, int type, int *count)
{
    item a[] = {{.i = hCtlr}, {.i = axis}, {.i = type}, {.p = count}}, r = {0};
    double begin;
    void *real = enter(45, &begin);
    if (real) r.i = ((int (APIENTRY *)(HCTRLR, WORD, int, int *))(intptr_t)real)(hCtlr, axis, type, count);
    return (int)leave(45, a, r, begin, real != NULL).i;
}

MCAPI_EXPORT int APIENTRY MCGetDecelerationEx(HCTRLR hCtlr, WORD axis, double *deceleration)
{
    item a[] = {{.i = hCtlr}, {.i = axis}, {.p = deceleration}}, r = {0};
    double begin;
    void *real = enter(46, &begin);
    if (real) r.i = ((int (APIENTRY *)(HCTRLR, WORD, double *))(intptr_t)real)(hCtlr, axis, deceleration);
    return (int)leave(46, a, r, begin, real != NULL).i;
}

MCAPI_EXPORT int APIENTRY MCGetDigitalFilter(HCTRLR hCtlr, WORD axis, double *coeff, int num, int *actual)
{
    item a[] = {{.i = hCtlr}, {.i = axis}, {.p = coeff}, {.i = num}, {.p = actual}}, r = {0};
    double begin;
    void *real = enter(47, &begin);
    if (real) r.i = ((int (APIENTRY *)(HCTRLR, WORD, double *, int, int *))(intptr_t)real)(hCtlr, axis, coeff, num, actual);
    return (int)leave(47, a, r, begin, real != NULL).i;
}

MCAPI_EXPORT short APIENTRY MCGetDigitalIO(HCTRLR hCtlr, WORD channel)
{
    item a[] = {{.i = hCtlr}, {.i = channel}}, r = {0};
    double begin;
    void *real = enter(48, &begin);
    if (real) r.i = ((short (APIENTRY *)(HCTRLR, WORD))(intptr_t)real)(hCtlr, channel);
    return (short)leave(48, a, r, begin, real != NULL).i;
}

MCAPI_EXPORT int APIENTRY MCGetDigitalIOConfig(HCTRLR hCtlr, WORD channel, WORD *mode)
{
    item a[] = {{.i = hCtlr}, {.i = channel}, {.p = mode}}, r = {0};
    double begin;
    void *real = enter(49, &begin);
    if (real) r.i = ((int (APIENTRY *)(HCTRLR, WORD, WORD *))(intptr_t)real)(hCtlr, channel, mode);
    return (int)leave(49, a, r, begin, real != NULL).i;
}

MCAPI_EXPORT int APIENTRY MCGetDigitalIOEx(HCTRLR hCtlr, WORD channel, unsigned *state)
{
    item a[] = {{.i = hCtlr}, {.i = channel}, {.p = state}}, r = {0};
    double begin;
    void *real = enter(50, &begin);
    if (real) r.i = ((int (APIENTRY *)(HCTRLR, WORD, unsigned *))(intptr_t)real)(hCtlr, channel, state);
    return (int)leave(50, a, r, begin, real != NULL).i;
}

MCAPI_EXPORT short APIENTRY MCGetError(HCTRLR hCtlr)
{
    item a[] = {{.i = hCtlr}}, r = {0};
    double begin;
    void *real = enter(51, &begin);
    if (real) r.i = ((short (APIENTRY *)(HCTRLR))(intptr_t)real)(hCtlr);
    return (short)leave(51, a, r, begin, real != NULL).i;
}

MCAPI_EXPORT short APIENTRY MCGetFilterConfig(HCTRLR hCtlr, WORD axis, MCFILTER *filter)
{
    item a[] = {{.i = hCtlr}, {.i = axis}, {.p = filter}}, r = {0};
    double begin;
    void *real = enter(52, &begin);
    if (real) r.i = ((short (APIENTRY *)(HCTRLR, WORD, MCFILTER *))(intptr_t)real)(hCtlr, axis, filter);
    return (short)leave(52, a, r, begin, real != NULL).i;
}

MCAPI_EXPORT int APIENTRY MCGetFilterConfigEx(HCTRLR hCtlr, WORD axis, MCFILTEREX *filter)
{
    item a[] = {{.i = hCtlr}, {.i = axis}, {.p = filter}}, r = {0};
    double begin;
    void *real = enter(53, &begin);
    if (real) r.i = ((int (APIENTRY *)(HCTRLR, WORD, MCFILTEREX *))(intptr_t)real)(hCtlr, axis, filter);
    return (int)leave(53, a, r, begin, real != NULL).i;
}

MCAPI_EXPORT int APIENTRY MCGetFollowingError(HCTRLR hCtlr, WORD axis, double *error)
{
    item a[] = {{.i = hCtlr}, {.i = axis}, {.p = error}}, r = {0};
    double begin;
    void *real = enter(54, &begin);
    if (real) r.i = ((int (APIENTRY *)(HCTRLR, WORD, double *))(intptr_t)real)(hCtlr, axis, error);
    return (int)leave(54, a, r, begin, real != NULL).i;
}

MCAPI_EXPORT int APIENTRY MCGetGain(HCTRLR hCtlr, WORD axis, double *gain)
{
    item a[] = {{.i = hCtlr}, {.i = axis}, {.p = gain}}, r = {0};
    double begin;
    void *real = enter(55, &begin);
    if (real) r.i = ((int (APIENTRY *)(HCTRLR, WORD, double *))(intptr_t)real)(hCtlr, axis, gain);
    return (int)leave(55, a, r, begin, real != NULL).i;
}

MCAPI_EXPORT int APIENTRY MCGetIndexEx(HCTRLR hCtlr, WORD axis, double *index)
{
    item a[] = {{.i = hCtlr}, {.i = axis}, {.p = index}}, r = {0};
    double begin;
    void *real = enter(56, &begin);
    if (real) r.i = ((int (APIENTRY *)(HCTRLR, WORD, double *))(intptr_t)real)(hCtlr, axis, index);
    return (int)leave(56, a, r, begin, real != NULL).i;
}

MCAPI_EXPORT int APIENTRY MCGetInstalledModules(HCTRLR hCtlr, int *modules, int size)
{
    item a[] = {{.i = hCtlr}, {.p = modules}, {.i = size}}, r = {0};
    double begin;
    void *real = enter(57, &begin);
    if (real) r.i = ((int (APIENTRY *)(HCTRLR, int *, int))(intptr_t)real)(hCtlr, modules, size);
    return (int)leave(57, a, r, begin, real != NULL).i;
}

MCAPI_EXPORT short APIENTRY MCGetJogConfig(HCTRLR hCtlr, WORD axis, MCJOG *jog)
{
    item a[] = {{.i = hCtlr}, {.i = axis}, {.p = jog}}, r = {0};
    double begin;
    void *real = enter(58, &begin);
    if (real) r.i = ((short (APIENTRY *)(HCTRLR, WORD, MCJOG *))(intptr_t)real)(hCtlr, axis, jog);
    return (short)leave(58, a, r, begin, real != NULL).i;
}

MCAPI_EXPORT int APIENTRY MCGetJogConfigEx(HCTRLR hCtlr, WORD axis, MCJOGEX *jog)
{
    item a[] = {{.i = hCtlr}, {.i = axis}, {.p = jog}}, r = {0};
    double begin;
    void *real = enter(59, &begin);
    if (real) r.i = ((int (APIENTRY *)(HCTRLR, WORD, MCJOGEX *))(intptr_t)real)(hCtlr, axis, jog);
    return (int)leave(59, a, r, begin, real != NULL).i;
}

MCAPI_EXPORT int APIENTRY MCGetLimits(HCTRLR hCtlr, WORD axis, short *hardlimitmode, short *softlimitmode, double *softlimitminus, double *softlimitplus)
{
    item a[] = {{.i = hCtlr}, {.i = axis}, {.p = hardlimitmode}, {.p = softlimitmode}, {.p = softlimitminus}, {.p = softlimitplus}}, r = {0};
    double begin;
    void *real = enter(60, &begin);
    if (real) r.i = ((int (APIENTRY *)(HCTRLR, WORD, short *, short *, double *, double *))(intptr_t)real)(hCtlr, axis, hardlimitmode, softlimitmode, softlimitminus, softlimitplus);
    return (int)leave(60, a, r, begin, real != NULL).i;
}

MCAPI_EXPORT int APIENTRY MCGetModuleInputMode(HCTRLR hCtlr, WORD axis, int *mode)
{
    item a[] = {{.i = hCtlr}, {.i = axis}, {.p = mode}}, r = {0};
    double begin;
    void *real = enter(61, &begin);
    if (real) r.i = ((int (APIENTRY *)(HCTRLR, WORD, int *))(intptr_t)real)(hCtlr, axis, mode);
    return (int)leave(61, a, r, begin, real != NULL).i;
}

MCAPI_EXPORT int APIENTRY MCGetModuleOutputMode(HCTRLR hCtlr, WORD axis, WORD *mode)
{
    item a[] = {{.i = hCtlr}, {.i = axis}, {.p = mode}}, r = {0};
    double begin;
    void *real = enter(62, &begin);
    if (real) r.i = ((int (APIENTRY *)(HCTRLR, WORD, WORD *))(intptr_t)real)(hCtlr, axis, mode);
    return (int)leave(62, a, r, begin, real != NULL).i;
}

MCAPI_EXPORT short APIENTRY MCGetMotionConfig(HCTRLR hCtlr, WORD axis, MCMOTION *motion)
{
    item a[] = {{.i = hCtlr}, {.i = axis}, {.p = motion}}, r = {0};
    double begin;
    void *real = enter(63, &begin);
    if (real) r.i = ((short (APIENTRY *)(HCTRLR, WORD, MCMOTION *))(intptr_t)real)(hCtlr, axis, motion);
    return (short)leave(63, a, r, begin, real != NULL).i;
}

MCAPI_EXPORT int APIENTRY MCGetMotionConfigEx(HCTRLR hCtlr, WORD axis, MCMOTIONEX *motion)
{
    item a[] = {{.i = hCtlr}, {.i = axis}, {.p = motion}}, r = {0};
    double begin;
    void *real = enter(64, &begin);
    if (real) r.i = ((int (APIENTRY *)(HCTRLR, WORD, MCMOTIONEX *))(intptr_t)real)(hCtlr, axis, motion);
    return (int)leave(64, a, r, begin, real != NULL).i;
}

MCAPI_EXPORT int APIENTRY MCGetOperatingMode(HCTRLR hCtlr, WORD axis, int *mode)
{
    item a[] = {{.i = hCtlr}, {.i = axis}, {.p = mode}}, r = {0};
    double begin;
    void *real = enter(65, &begin);
    if (real) r.i = ((int (APIENTRY *)(HCTRLR, WORD, int *))(intptr_t)real)(hCtlr, axis, mode);
    return (int)leave(65, a, r, begin, real != NULL).i;
}

MCAPI_EXPORT int APIENTRY MCGetOptimalEx(HCTRLR hCtlr, WORD axis, double *optimal)
{
    item a[] = {{.i = hCtlr}, {.i = axis}, {.p = optimal}}, r = {0};
    double begin;
    void *real = enter(66, &begin);
    if (real) r.i = ((int (APIENTRY *)(HCTRLR, WORD, double *))(intptr_t)real)(hCtlr, axis, optimal);
    return (int)leave(66, a, r, begin, real != NULL).i;
}

MCAPI_EXPORT int APIENTRY MCGetPositionEx(HCTRLR hCtlr, WORD axis, double *position)
{
    item a[] = {{.i = hCtlr}, {.i = axis}, {.p = position}}, r = {0};
    double begin;
    void *real = enter(67, &begin);
    if (real) r.i = ((int (APIENTRY *)(HCTRLR, WORD, double *))(intptr_t)real)(hCtlr, axis, position);
    return (int)leave(67, a, r, begin, real != NULL).i;
}

MCAPI_EXPORT int APIENTRY MCGetProfile(HCTRLR hCtlr, WORD axis, WORD *profile)
{
    item a[] = {{.i = hCtlr}, {.i = axis}, {.p = profile}}, r = {0};
    double begin;
    void *real = enter(68, &begin);
    if (real) r.i = ((int (APIENTRY *)(HCTRLR, WORD, WORD *))(intptr_t)real)(hCtlr, axis, profile);
    return (int)leave(68, a, r, begin, real != NULL).i;
}

MCAPI_EXPORT int APIENTRY MCGetRegister(HCTRLR hCtlr, int reg, void *value, int type)
{
    item a[] = {{.i = hCtlr}, {.i = reg}, {.p = value}, {.i = type}}, r = {0};
    double begin;
    void *real = enter(69, &begin);
    if (real) r.i = ((int (APIENTRY *)(HCTRLR, int, void *, int))(intptr_t)real)(hCtlr, reg, value, type);
    return (int)leave(69, a, r, begin, real != NULL).i;
}

MCAPI_EXPORT short APIENTRY MCGetScale(HCTRLR hCtlr, WORD axis, MCSCALE *scale)
{
    item a[] = {{.i = hCtlr}, {.i = axis}, {.p = scale}}, r = {0};
    double begin;
    void *real = enter(70, &begin);
    if (real) r.i = ((short (APIENTRY *)(HCTRLR, WORD, MCSCALE *))(intptr_t)real)(hCtlr, axis, scale);
    return (short)leave(70, a, r, begin, real != NULL).i;
}

MCAPI_EXPORT int APIENTRY MCGetServoOutputPhase(HCTRLR hCtlr, WORD axis, WORD *phase)
{
    item a[] = {{.i = hCtlr}, {.i = axis}, {.p = phase}}, r = {0};
    double begin;
    void *real = enter(71, &begin);
    if (real) r.i = ((int (APIENTRY *)(HCTRLR, WORD, WORD *))(intptr_t)real)(hCtlr, axis, phase);
    return (int)leave(71, a, r, begin, real != NULL).i;
}

MCAPI_EXPORT DWORD APIENTRY MCGetStatus(HCTRLR hCtlr, WORD axis)
{
    item a[] = {{.i = hCtlr}, {.i = axis}}, r = {0};
    double begin;
    void *real = enter(72, &begin);
    if (real) r.i = ((DWORD (APIENTRY *)(HCTRLR, WORD))(intptr_t)real)(hCtlr, axis);
    return (DWORD)leave(72, a, r, begin, real != NULL).i;
}

MCAPI_EXPORT int APIENTRY MCGetStatusEx(HCTRLR hCtlr, WORD axis, MCSTATUSEX *status)
{
    item a[] = {{.i = hCtlr}, {.i = axis}, {.p = status}}, r = {0};
    double begin;
    void *real = enter(73, &begin);
    if (real) r.i = ((int (APIENTRY *)(HCTRLR, WORD, MCSTATUSEX *))(intptr_t)real)(hCtlr, axis, status);
    return (int)leave(73, a, r, begin, real != NULL).i;
}

MCAPI_EXPORT int APIENTRY MCGetTargetEx(HCTRLR hCtlr, WORD axis, double *target)
{
    item a[] = {{.i = hCtlr}, {.i = axis}, {.p = target}}, r = {0};
    double begin;
    void *real = enter(74, &begin);
    if (real) r.i = ((int (APIENTRY *)(HCTRLR, WORD, double *))(intptr_t)real)(hCtlr, axis, target);
    return (int)leave(74, a, r, begin, real != NULL).i;
}

MCAPI_EXPORT int APIENTRY MCGetTorque(HCTRLR hCtlr, WORD axis, double *torque)
{
    item a[] = {{.i = hCtlr}, {.i = axis}, {.p = torque}}, r = {0};
    double begin;
    void *real = enter(75, &begin);
    if (real) r.i = ((int (APIENTRY *)(HCTRLR, WORD, double *))(intptr_t)real)(hCtlr, axis, torque);
    return (int)leave(75, a, r, begin, real != NULL).i;
}

MCAPI_EXPORT int APIENTRY MCGetTrajectoryRate(HCTRLR hCtlr, int *rate)
{
    item a[] = {{.i = hCtlr}, {.p = rate}}, r = {0};
    double begin;
    void *real = enter(76, &begin);
    if (real) r.i = ((int (APIENTRY *)(HCTRLR, int *))(intptr_t)real)(hCtlr, rate);
    return (int)leave(76, a, r, begin, real != NULL).i;
}

MCAPI_EXPORT int APIENTRY MCGetVectorVelocity(HCTRLR hCtlr, WORD axis, double *velocity)
{
    item a[] = {{.i = hCtlr}, {.i = axis}, {.p = velocity}}, r = {0};
    double begin;
    void *real = enter(77, &begin);
    if (real) r.i = ((int (APIENTRY *)(HCTRLR, WORD, double *))(intptr_t)real)(hCtlr, axis, velocity);
    return (int)leave(77, a, r, begin, real != NULL).i;
}

MCAPI_EXPORT int APIENTRY MCGetVelocityActual(HCTRLR hCtlr, WORD axis, double *velocity)
{
    item a[] = {{.i = hCtlr}, {.i = axis}, {.p = velocity}}, r = {0};
    double begin;
    void *real = enter(78, &begin);
    if (real) r.i = ((int (APIENTRY *)(HCTRLR, WORD, double *))(intptr_t)real)(hCtlr, axis, velocity);
    return (int)leave(78, a, r, begin, real != NULL).i;
}

MCAPI_EXPORT int APIENTRY MCGetVelocityEx(HCTRLR hCtlr, WORD axis, double *velocity)
{
    item a[] = {{.i = hCtlr}, {.i = axis}, {.p = velocity}}, r = {0};
    double begin;
    void *real = enter(79, &begin);
    if (real) r.i = ((int (APIENTRY *)(HCTRLR, WORD, double *))(intptr_t)real)(hCtlr, axis, velocity);
    return (int)leave(79, a, r, begin, real != NULL).i;
}

MCAPI_EXPORT int APIENTRY MCGetVelocityOverride(HCTRLR hCtlr, WORD axis, double *override)
{
    item a[] = {{.i = hCtlr}, {.i = axis}, {.p = override}}, r = {0};
    double begin;
    void *real = enter(80, &begin);
    if (real) r.i = ((int (APIENTRY *)(HCTRLR, WORD, double *))(intptr_t)real)(hCtlr, axis, override);
    return (int)leave(80, a, r, begin, real != NULL).i;
}

MCAPI_EXPORT DWORD APIENTRY MCGetVersion(HCTRLR hCtlr)
{
    item a[] = {{.i = hCtlr}}, r = {0};
    double begin;
    void *real = enter(81, &begin);
    if (real) r.i = ((DWORD (APIENTRY *)(HCTRLR))(intptr_t)real)(hCtlr);
    return (DWORD)leave(81, a, r, begin, real != NULL).i;
}

MCAPI_EXPORT void APIENTRY MCGo(HCTRLR hCtlr, WORD axis)
{
    item a[] = {{.i = hCtlr}, {.i = axis}}, r = {0};
    double begin;
    void *real = enter(82, &begin);
    if (real) ((void (APIENTRY *)(HCTRLR, WORD))(intptr_t)real)(hCtlr, axis);
    leave(82, a, r, begin, real != NULL);
}

MCAPI_EXPORT int APIENTRY MCGoEx(HCTRLR hCtlr, WORD axis, double param)
{
    item a[] = {{.i = hCtlr}, {.i = axis}, {.d = param}}, r = {0};
    double begin;
    void *real = enter(83, &begin);
    if (real) r.i = ((int (APIENTRY *)(HCTRLR, WORD, double))(intptr_t)real)(hCtlr, axis, param);
    return (int)leave(83, a, r, begin, real != NULL).i;
}

MCAPI_EXPORT void APIENTRY MCGoHome(HCTRLR hCtlr, WORD axis)
{
    item a[] = {{.i = hCtlr}, {.i = axis}}, r = {0};
    double begin;
    void *real = enter(84, &begin);
    if (real) ((void (APIENTRY *)(HCTRLR, WORD))(intptr_t)real)(hCtlr, axis);
    leave(84, a, r, begin, real != NULL);
}

MCAPI_EXPORT int APIENTRY MCIndexArm(HCTRLR hCtlr, WORD axis, double position)
{
    item a[] = {{.i = hCtlr}, {.i = axis}, {.d = position}}, r = {0};
    double begin;
    void *real = enter(85, &begin);
    if (real) r.i = ((int (APIENTRY *)(HCTRLR, WORD, double))(intptr_t)real)(hCtlr, axis, position);
    return (int)leave(85, a, r, begin, real != NULL).i;
}

MCAPI_EXPORT int APIENTRY MCInterruptOnPosition(HCTRLR hCtlr, WORD axis, int mode, double position)
{
    item a[] = {{.i = hCtlr}, {.i = axis}, {.i = mode}, {.d = position}}, r = {0};
    double begin;
    void *real = enter(86, &begin);
    if (real) r.i = ((int (APIENTRY *)(HCTRLR, WORD, int, double))(intptr_t)real)(hCtlr, axis, mode, position);
    return (int)leave(86, a, r, begin, real != NULL).i;
}

MCAPI_EXPORT int APIENTRY MCIsAtTarget(HCTRLR hCtlr, WORD axis, double timeout)
{
    item a[] = {{.i = hCtlr}, {.i = axis}, {.d = timeout}}, r = {0};
    double begin;
    void *real = enter(87, &begin);
    if (real) r.i = ((int (APIENTRY *)(HCTRLR, WORD, double))(intptr_t)real)(hCtlr, axis, timeout);
    return (int)leave(87, a, r, begin, real != NULL).i;
}

MCAPI_EXPORT int APIENTRY MCIsDigitalFilter(HCTRLR hCtlr, WORD axis)
{
    item a[] = {{.i = hCtlr}, {.i = axis}}, r = {0};
    double begin;
    void *real = enter(88, &begin);
    if (real) r.i = ((int (APIENTRY *)(HCTRLR, WORD))(intptr_t)real)(hCtlr, axis);
    return (int)leave(88, a, r, begin, real != NULL).i;
}

MCAPI_EXPORT int APIENTRY MCIsEdgeFound(HCTRLR hCtlr, WORD axis, double timeout)
{
    item a[] = {{.i = hCtlr}, {.i = axis}, {.d = timeout}}, r = {0};
    double begin;
    void *real = enter(89, &begin);
    if (real) r.i = ((int (APIENTRY *)(HCTRLR, WORD, double))(intptr_t)real)(hCtlr, axis, timeout);
    return (int)leave(89, a, r, begin, real != NULL).i;
}

MCAPI_EXPORT int APIENTRY MCIsIndexFound(HCTRLR hCtlr, WORD axis, double timeout)
{
    item a[] = {{.i = hCtlr}, {.i = axis}, {.d = timeout}}, r = {0};
    double begin;
    void *real = enter(90, &begin);
    if (real) r.i = ((int (APIENTRY *)(HCTRLR, WORD, double))(intptr_t)real)(hCtlr, axis, timeout);
    return (int)leave(90, a, r, begin, real != NULL).i;
}

MCAPI_EXPORT int APIENTRY MCIsStopped(HCTRLR hCtlr, WORD axis, double timeout)
{
    item a[] = {{.i = hCtlr}, {.i = axis}, {.d = timeout}}, r = {0};
    double begin;
    void *real = enter(91, &begin);
    if (real) r.i = ((int (APIENTRY *)(HCTRLR, WORD, double))(intptr_t)real)(hCtlr, axis, timeout);
    return (int)leave(91, a, r, begin, real != NULL).i;
}

MCAPI_EXPORT int APIENTRY MCLearnPoint(HCTRLR hCtlr, WORD axis, int index, WORD mode)
{
    item a[] = {{.i = hCtlr}, {.i = axis}, {.i = index}, {.i = mode}}, r = {0};
    double begin;
    void *real = enter(92, &begin);
    if (real) r.i = ((int (APIENTRY *)(HCTRLR, WORD, int, WORD))(intptr_t)real)(hCtlr, axis, index, mode);
    return (int)leave(92, a, r, begin, real != NULL).i;
}

MCAPI_EXPORT void APIENTRY MCMacroCall(HCTRLR hCtlr, WORD macro)
{
    item a[] = {{.i = hCtlr}, {.i = macro}}, r = {0};
    double begin;
    void *real = enter(93, &begin);
    if (real) ((void (APIENTRY *)(HCTRLR, WORD))(intptr_t)real)(hCtlr, macro);
    leave(93, a, r, begin, real != NULL);
}

MCAPI_EXPORT void APIENTRY MCMoveAbsolute(HCTRLR hCtlr, WORD axis, double position)
{
    item a[] = {{.i = hCtlr}, {.i = axis}, {.d = position}}, r = {0};
    double begin;
    void *real = enter(94, &begin);
    if (real) ((void (APIENTRY *)(HCTRLR, WORD, double))(intptr_t)real)(hCtlr, axis, position);
    leave(94, a, r, begin, real != NULL);
}

MCAPI_EXPORT void APIENTRY MCMoveRelative(HCTRLR hCtlr, WORD axis, double distance)
{
    item a[] = {{.i = hCtlr}, {.i = axis}, {.d = distance}}, r = {0};
    double begin;
    void *real = enter(95, &begin);
    if (real) ((void (APIENTRY *)(HCTRLR, WORD, double))(intptr_t)real)(hCtlr, axis, distance);
    leave(95, a, r, begin, real != NULL);
}

MCAPI_EXPORT int APIENTRY MCMoveToPoint(HCTRLR hCtlr, WORD axis, int index)
{
    item a[] = {{.i = hCtlr}, {.i = axis}, {.i = index}}, r = {0};
    double begin;
    void *real = enter(96, &begin);
    if (real) r.i = ((int (APIENTRY *)(HCTRLR, WORD, int))(intptr_t)real)(hCtlr, axis, index);
    return (int)leave(96, a, r, begin, real != NULL).i;
}

MCAPI_EXPORT HCTRLR APIENTRY MCOpen(short nID, WORD mode, const char *name)
{
    item a[] = {{.i = nID}, {.i = mode}, {.p = name}}, r = {0};
    double begin;
    void *real = enter(97, &begin);
    if (real) r.i = ((HCTRLR (APIENTRY *)(short, WORD, const char *))(intptr_t)real)(nID, mode, name);
    return (HCTRLR)leave(97, a, r, begin, real != NULL).i;
}

MCAPI_EXPORT int APIENTRY MCReopen(HCTRLR hCtlr, WORD newmode)
{
    item a[] = {{.i = hCtlr}, {.i = newmode}}, r = {0};
    double begin;
    void *real = enter(98, &begin);
    if (real) r.i = ((int (APIENTRY *)(HCTRLR, WORD))(intptr_t)real)(hCtlr, newmode);
    return (int)leave(98, a, r, begin, real != NULL).i;
}

MCAPI_EXPORT int APIENTRY MCRepeat(HCTRLR hCtlr, int count)
{
    item a[] = {{.i = hCtlr}, {.i = count}}, r = {0};
    double begin;
    void *real = enter(99, &begin);
    if (real) r.i = ((int (APIENTRY *)(HCTRLR, int))(intptr_t)real)(hCtlr, count);
    return (int)leave(99, a, r, begin, real != NULL).i;
}

MCAPI_EXPORT void APIENTRY MCReset(HCTRLR hCtlr, WORD axis)
{
    item a[] = {{.i = hCtlr}, {.i = axis}}, r = {0};
    double begin;
    void *real = enter(100, &begin);
    if (real) ((void (APIENTRY *)(HCTRLR, WORD))(intptr_t)real)(hCtlr, axis);
    leave(100, a, r, begin, real != NULL);
}

MCAPI_EXPORT void APIENTRY MCSetAcceleration(HCTRLR hCtlr, WORD axis, double rate)
{
    item a[] = {{.i = hCtlr}, {.i = axis}, {.d = rate}}, r = {0};
    double begin;
    void *real = enter(101, &begin);
    if (real) ((void (APIENTRY *)(HCTRLR, WORD, double))(intptr_t)real)(hCtlr, axis, rate);
    leave(101, a, r, begin, real != NULL);
}

MCAPI_EXPORT void APIENTRY MCSetAnalog(HCTRLR hCtlr, WORD channel, WORD value)
{
    item a[] = {{.i = hCtlr}, {.i = channel}, {.i = value}}, r = {0};
    double begin;
    void *real = enter(102, &begin);
    if (real) ((void (APIENTRY *)(HCTRLR, WORD, WORD))(intptr_t)real)(hCtlr, channel, value);
    leave(102, a, r, begin, real != NULL);
}

MCAPI_EXPORT int APIENTRY MCSetAnalogEx(HCTRLR hCtlr, int channel, DWORD value)
{
    item a[] = {{.i = hCtlr}, {.i = channel}, {.i = value}}, r = {0};
    double begin;
    void *real = enter(103, &begin);
    if (real) r.i = ((int (APIENTRY *)(HCTRLR, int, DWORD))(intptr_t)real)(hCtlr, channel, value);
    return (int)leave(103, a, r, begin, real != NULL).i;
}

MCAPI_EXPORT void APIENTRY MCSetAuxEncPos(HCTRLR hCtlr, WORD axis, double position)
{
    item a[] = {{.i = hCtlr}, {.i = axis}, {.d = position}}, r = {0};
    double begin;
    void *real = enter(104, &begin);
    if (real) ((void (APIENTRY *)(HCTRLR, WORD, double))(intptr_t)real)(hCtlr, axis, position);
    leave(104, a, r, begin, real != NULL);
}

MCAPI_EXPORT int APIENTRY MCSetCommutation(HCTRLR hCtlr, WORD axis, MCCOMMUTATION *commutation)
{
    item a[] = {{.i = hCtlr}, {.i = axis}, {.p = commutation}}, r = {0};
    double begin;
    void *real = enter(105, &begin);
    if (real) r.i = ((int (APIENTRY *)(HCTRLR, WORD, MCCOMMUTATION *))(intptr_t)real)(hCtlr, axis, commutation);
    return (int)leave(105, a, r, begin, real != NULL).i;
}

MCAPI_EXPORT short APIENTRY MCSetContourConfig(HCTRLR hCtlr, WORD axis, MCCONTOUR *contour)
{
    item a[] = {{.i = hCtlr}, {.i = axis}, {.p = contour}}, r = {0};
    double begin;
    void *real = enter(106, &begin);
    if (real) r.i = ((short (APIENTRY *)(HCTRLR, WORD, MCCONTOUR *))(intptr_t)real)(hCtlr, axis, contour);
    return (short)leave(106, a, r, begin, real != NULL).i;
}

MCAPI_EXPORT void APIENTRY MCSetDeceleration(HCTRLR hCtlr, WORD axis, double rate)
{
    item a[] = {{.i = hCtlr}, {.i = axis}, {.d = rate}}, r = {0};
    double begin;
    void *real = enter(107, &begin);
    if (real) ((void (APIENTRY *)(HCTRLR, WORD, double))(intptr_t)real)(hCtlr, axis, rate);
    leave(107, a, r, begin, real != NULL);
}

MCAPI_EXPORT int APIENTRY MCSetDigitalFilter(HCTRLR hCtlr, WORD axis, double *coeff, int num)
{
    item a[] = {{.i = hCtlr}, {.i = axis}, {.p = coeff}, {.i = num}}, r = {0};
    double begin;
    void *real = enter(108, &begin);
    if (real) r.i = ((int (APIENTRY *)(HCTRLR, WORD, double *, int))(intptr_t)real)(hCtlr, axis, coeff, num);
    return (int)leave(108, a, r, begin, real != NULL).i;
}

MCAPI_EXPORT short APIENTRY MCSetFilterConfig(HCTRLR hCtlr, WORD axis, MCFILTER *filter)
{
    item a[] = {{.i = hCtlr}, {.i = axis}, {.p = filter}}, r = {0};
    double begin;
    void *real = enter(109, &begin);
    if (real) r.i = ((short (APIENTRY *)(HCTRLR, WORD, MCFILTER *))(intptr_t)real)(hCtlr, axis, filter);
    return (short)leave(109, a, r, begin, real != NULL).i;
}

MCAPI_EXPORT int APIENTRY MCSetFilterConfigEx(HCTRLR hCtlr, WORD axis, MCFILTEREX *filter)
{
    item a[] = {{.i = hCtlr}, {.i = axis}, {.p = filter}}, r = {0};
    double begin;
    void *real = enter(110, &begin);
    if (real) r.i = ((int (APIENTRY *)(HCTRLR, WORD, MCFILTEREX *))(intptr_t)real)(hCtlr, axis, filter);
    return (int)leave(110, a, r, begin, real != NULL).i;
}

MCAPI_EXPORT int APIENTRY MCSetGain(HCTRLR hCtlr, WORD axis, double gain)
{
    item a[] = {{.i = hCtlr}, {.i = axis}, {.d = gain}}, r = {0};
    double begin;
    void *real = enter(111, &begin);
    if (real) r.i = ((int (APIENTRY *)(HCTRLR, WORD, double))(intptr_t)real)(hCtlr, axis, gain);
    return (int)leave(111, a, r, begin, real != NULL).i;
}

MCAPI_EXPORT short APIENTRY MCSetJogConfig(HCTRLR hCtlr, WORD axis, MCJOG *jog)
{
    item a[] = {{.i = hCtlr}, {.i = axis}, {.p = jog}}, r = {0};
    double begin;
    void *real = enter(112, &begin);
    if (real) r.i = ((short (APIENTRY *)(HCTRLR, WORD, MCJOG *))(intptr_t)real)(hCtlr, axis, jog);
    return (short)leave(112, a, r, begin, real != NULL).i;
}

MCAPI_EXPORT int APIENTRY MCSetJogConfigEx(HCTRLR hCtlr, WORD axis, MCJOGEX *jog)
{
    item a[] = {{.i = hCtlr}, {.i = axis}, {.p = jog}}, r = {0};
    double begin;
    void *real = enter(113, &begin);
    if (real) r.i = ((int (APIENTRY *)(HCTRLR, WORD, MCJOGEX *))(intptr_t)real)(hCtlr, axis, jog);
    return (int)leave(113, a, r, begin, real != NULL).i;
}

MCAPI_EXPORT int APIENTRY MCSetLimits(HCTRLR hCtlr, WORD axis, short hardlimitmode, short softlimitmode, double softlimitminus, double softlimitplus)
{
    item a[] = {{.i = hCtlr}, {.i = axis}, {.i = hardlimitmode}, {.i = softlimitmode}, {.d = softlimitminus}, {.d = softlimitplus}}, r = {0};
    double begin;
    void *real = enter(114, &begin);
    if (real) r.i = ((int (APIENTRY *)(HCTRLR, WORD, short, short, double, double))(intptr_t)real)(hCtlr, axis, hardlimitmode, softlimitmode, softlimitminus, softlimitplus);
    return (int)leave(114, a, r, begin, real != NULL).i;
}

MCAPI_EXPORT int APIENTRY MCSetModuleInputMode(HCTRLR hCtlr, WORD axis, int Mode)
{
    item a[] = {{.i = hCtlr}, {.i = axis}, {.i = Mode}}, r = {0};
    double begin;
    void *real = enter(115, &begin);
    if (real) r.i = ((int (APIENTRY *)(HCTRLR, WORD, int))(intptr_t)real)(hCtlr, axis, Mode);
    return (int)leave(115, a, r, begin, real != NULL).i;
}

MCAPI_EXPORT void APIENTRY MCSetModuleOutputMode(HCTRLR hCtlr, WORD axis, WORD mode)
{
    item a[] = {{.i = hCtlr}, {.i = axis}, {.i = mode}}, r = {0};
    double begin;
    void *real = enter(116, &begin);
    if (real) ((void (APIENTRY *)(HCTRLR, WORD, WORD))(intptr_t)real)(hCtlr, axis, mode);
    leave(116, a, r, begin, real != NULL);
}

MCAPI_EXPORT short APIENTRY MCSetMotionConfig(HCTRLR hCtlr, WORD axis, MCMOTION *motion)
{
    item a[] = {{.i = hCtlr}, {.i = axis}, {.p = motion}}, r = {0};
    double begin;
    void *real = enter(117, &begin);
    if (real) r.i = ((short (APIENTRY *)(HCTRLR, WORD, MCMOTION *))(intptr_t)real)(hCtlr, axis, motion);
    return (short)leave(117, a, r, begin, real != NULL).i;
}

MCAPI_EXPORT int APIENTRY MCSetMotionConfigEx(HCTRLR hCtlr, WORD axis, MCMOTIONEX *motion)
{
    item a[] = {{.i = hCtlr}, {.i = axis}, {.p = motion}}, r = {0};
    double begin;
    void *real = enter(118, &begin);
    if (real) r.i = ((int (APIENTRY *)(HCTRLR, WORD, MCMOTIONEX *))(intptr_t)real)(hCtlr, axis, motion);
    return (int)leave(118, a, r, begin, real != NULL).i;
}

MCAPI_EXPORT void APIENTRY MCSetOperatingMode(HCTRLR hCtlr, WORD axis, WORD caxis, WORD mode)
{
    item a[] = {{.i = hCtlr}, {.i = axis}, {.i = caxis}, {.i = mode}}, r = {0};
    double begin;
    void *real = enter(119, &begin);
    if (real) ((void (APIENTRY *)(HCTRLR, WORD, WORD, WORD))(intptr_t)real)(hCtlr, axis, caxis, mode);
    leave(119, a, r, begin, real != NULL);
}

MCAPI_EXPORT void APIENTRY MCSetPosition(HCTRLR hCtlr, WORD axis, double position)
{
    item a[] = {{.i = hCtlr}, {.i = axis}, {.d = position}}, r = {0};
    double begin;
    void *real = enter(120, &begin);
    if (real) ((void (APIENTRY *)(HCTRLR, WORD, double))(intptr_t)real)(hCtlr, axis, position);
    leave(120, a, r, begin, real != NULL);
}

MCAPI_EXPORT void APIENTRY MCSetProfile(HCTRLR hCtlr, WORD axis, WORD mode)
{
    item a[] = {{.i = hCtlr}, {.i = axis}, {.i = mode}}, r = {0};
    double begin;
    void *real = enter(121, &begin);
    if (real) ((void (APIENTRY *)(HCTRLR, WORD, WORD))(intptr_t)real)(hCtlr, axis, mode);
    leave(121, a, r, begin, real != NULL);
}

MCAPI_EXPORT int APIENTRY MCSetRegister(HCTRLR hCtlr, int reg, void *value, int type)
{
    item a[] = {{.i = hCtlr}, {.i = reg}, {.p = value}, {.i = type}}, r = {0};
    double begin;
    void *real = enter(122, &begin);
    if (real) r.i = ((int (APIENTRY *)(HCTRLR, int, void *, int))(intptr_t)real)(hCtlr, reg, value, type);
    return (int)leave(122, a, r, begin, real != NULL).i;
}

MCAPI_EXPORT short APIENTRY MCSetScale(HCTRLR hCtlr, WORD axis, MCSCALE *scale)
{
    item a[] = {{.i = hCtlr}, {.i = axis}, {.p = scale}}, r = {0};
    double begin;
    void *real = enter(123, &begin);
    if (real) r.i = ((short (APIENTRY *)(HCTRLR, WORD, MCSCALE *))(intptr_t)real)(hCtlr, axis, scale);
    return (short)leave(123, a, r, begin, real != NULL).i;
}

MCAPI_EXPORT void APIENTRY MCSetServoOutputPhase(HCTRLR hCtlr, WORD axis, WORD phase)
{
    item a[] = {{.i = hCtlr}, {.i = axis}, {.i = phase}}, r = {0};
    double begin;
    void *real = enter(124, &begin);
    if (real) ((void (APIENTRY *)(HCTRLR, WORD, WORD))(intptr_t)real)(hCtlr, axis, phase);
    leave(124, a, r, begin, real != NULL);
}

MCAPI_EXPORT int APIENTRY MCSetTimeoutEx(HCTRLR hCtlr, double timeout, double *oldtimeOut)
{
    item a[] = {{.i = hCtlr}, {.d = timeout}, {.p = oldtimeOut}}, r = {0};
    double begin;
    void *real = enter(125, &begin);
    if (real) r.i = ((int (APIENTRY *)(HCTRLR, double, double *))(intptr_t)real)(hCtlr, timeout, oldtimeOut);
    return (int)leave(125, a, r, begin, real != NULL).i;
}

MCAPI_EXPORT int APIENTRY MCSetTorque(HCTRLR hCtlr, WORD axis, double torque)
{
    item a[] = {{.i = hCtlr}, {.i = axis}, {.d = torque}}, r = {0};
    double begin;
    void *real = enter(126, &begin);
    if (real) r.i = ((int (APIENTRY *)(HCTRLR, WORD, double))(intptr_t)real)(hCtlr, axis, torque);
    return (int)leave(126, a, r, begin, real != NULL).i;
}

MCAPI_EXPORT int APIENTRY MCSetTrajectoryRate(HCTRLR hCtlr, int rate)
{
    item a[] = {{.i = hCtlr}, {.i = rate}}, r = {0};
    double begin;
    void *real = enter(127, &begin);
    if (real) r.i = ((int (APIENTRY *)(HCTRLR, int))(intptr_t)real)(hCtlr, rate);
    return (int)leave(127, a, r, begin, real != NULL).i;
}

MCAPI_EXPORT int APIENTRY MCSetVectorVelocity(HCTRLR hCtlr, WORD axis, double velocity)
{
    item a[] = {{.i = hCtlr}, {.i = axis}, {.d = velocity}}, r = {0};
    double begin;
    void *real = enter(128, &begin);
    if (real) r.i = ((int (APIENTRY *)(HCTRLR, WORD, double))(intptr_t)real)(hCtlr, axis, velocity);
    return (int)leave(128, a, r, begin, real != NULL).i;
}

MCAPI_EXPORT void APIENTRY MCSetVelocity(HCTRLR hCtlr, WORD axis, double rate)
{
    item a[] = {{.i = hCtlr}, {.i = axis}, {.d = rate}}, r = {0};
    double begin;
    void *real = enter(129, &begin);
    if (real) ((void (APIENTRY *)(HCTRLR, WORD, double))(intptr_t)real)(hCtlr, axis, rate);
    leave(129, a, r, begin, real != NULL);
}

MCAPI_EXPORT int APIENTRY MCSetVelocityOverride(HCTRLR hCtlr, WORD axis, double override)
{
    item a[] = {{.i = hCtlr}, {.i = axis}, {.d = override}}, r = {0};
    double begin;
    void *real = enter(130, &begin);
    if (real) r.i = ((int (APIENTRY *)(HCTRLR, WORD, double))(intptr_t)real)(hCtlr, axis, override);
    return (int)leave(130, a, r, begin, real != NULL).i;
}

MCAPI_EXPORT void APIENTRY MCStop(HCTRLR hCtlr, WORD axis)
{
    item a[] = {{.i = hCtlr}, {.i = axis}}, r = {0};
    double begin;
    void *real = enter(131, &begin);
    if (real) ((void (APIENTRY *)(HCTRLR, WORD))(intptr_t)real)(hCtlr, axis);
    leave(131, a, r, begin, real != NULL);
}

MCAPI_EXPORT int APIENTRY MCTranslateErrorEx(short nError, char *buffer, int length)
{
    item a[] = {{.i = nError}, {.p = buffer}, {.i = length}}, r = {0};
    double begin;
    void *real = enter(132, &begin);
    if (real) r.i = ((int (APIENTRY *)(short, char *, int))(intptr_t)real)(nError, buffer, length);
    return (int)leave(132, a, r, begin, real != NULL).i;
}

MCAPI_EXPORT void APIENTRY MCWait(HCTRLR hCtlr, double period)
{
    item a[] = {{.i = hCtlr}, {.d = period}}, r = {0};
    double begin;
    void *real = enter(133, &begin);
    if (real) ((void (APIENTRY *)(HCTRLR, double))(intptr_t)real)(hCtlr, period);
    leave(133, a, r, begin, real != NULL);
}

MCAPI_EXPORT void APIENTRY MCWaitForDigitalIO(HCTRLR hCtlr, WORD channel, short state)
{
    item a[] = {{.i = hCtlr}, {.i = channel}, {.i = state}}, r = {0};
    double begin;
    void *real = enter(134, &begin);
    if (real) ((void (APIENTRY *)(HCTRLR, WORD, short))(intptr_t)real)(hCtlr, channel, state);
    leave(134, a, r, begin, real != NULL);
}

MCAPI_EXPORT int APIENTRY MCWaitForEdge(HCTRLR hCtlr, WORD axis, short state)
{
    item a[] = {{.i = hCtlr}, {.i = axis}, {.i = state}}, r = {0};
    double begin;
    void *real = enter(135, &begin);
    if (real) r.i = ((int (APIENTRY *)(HCTRLR, WORD, short))(intptr_t)real)(hCtlr, axis, state);
    return (int)leave(135, a, r, begin, real != NULL).i;
}

MCAPI_EXPORT int APIENTRY MCWaitForIndex(HCTRLR hCtlr, WORD axis)
{
    item a[] = {{.i = hCtlr}, {.i = axis}}, r = {0};
    double begin;
    void *real = enter(136, &begin);
    if (real) r.i = ((int (APIENTRY *)(HCTRLR, WORD))(intptr_t)real)(hCtlr, axis);
    return (int)leave(136, a, r, begin, real != NULL).i;
}

MCAPI_EXPORT void APIENTRY MCWaitForPosition(HCTRLR hCtlr, WORD axis, double position)
{
    item a[] = {{.i = hCtlr}, {.i = axis}, {.d = position}}, r = {0};
    double begin;
    void *real = enter(137, &begin);
    if (real) ((void (APIENTRY *)(HCTRLR, WORD, double))(intptr_t)real)(hCtlr, axis, position);
    leave(137, a, r, begin, real != NULL);
}

MCAPI_EXPORT void APIENTRY MCWaitForRelative(HCTRLR hCtlr, WORD axis, double distance)
{
    item a[] = {{.i = hCtlr}, {.i = axis}, {.d = distance}}, r = {0};
    double begin;
    void *real = enter(138, &begin);
    if (real) ((void (APIENTRY *)(HCTRLR, WORD, double))(intptr_t)real)(hCtlr, axis, distance);
    leave(138, a, r, begin, real != NULL);
}

MCAPI_EXPORT void APIENTRY MCWaitForStop(HCTRLR hCtlr, WORD axis, double period)
{
    item a[] = {{.i = hCtlr}, {.i = axis}, {.d = period}}, r = {0};
    double begin;
    void *real = enter(139, &begin);
    if (real) ((void (APIENTRY *)(HCTRLR, WORD, double))(intptr_t)real)(hCtlr, axis, period);
    leave(139, a, r, begin, real != NULL);
}

MCAPI_EXPORT void APIENTRY MCWaitForTarget(HCTRLR hCtlr, WORD axis, double period)
{
    item a[] = {{.i = hCtlr}, {.i = axis}, {.d = period}}, r = {0};
    double begin;
    void *real = enter(140, &begin);
    if (real) ((void (APIENTRY *)(HCTRLR, WORD, double))(intptr_t)real)(hCtlr, axis, period);
    leave(140, a, r, begin, real != NULL);
}

MCAPI_EXPORT short APIENTRY pmccmd(HCTRLR hCtlr, short size, void *buffer)
{
    item a[] = {{.i = hCtlr}, {.i = size}, {.p = buffer}}, r = {0};
    double begin;
    void *real = enter(141, &begin);
    if (real) r.i = ((short (APIENTRY *)(HCTRLR, short, void *))(intptr_t)real)(hCtlr, size, buffer);
    return (short)leave(141, a, r, begin, real != NULL).i;
}

MCAPI_EXPORT int APIENTRY pmccmdex(HCTRLR hCtlr, WORD axis, WORD command, void *argument, int type)
{
    item a[] = {{.i = hCtlr}, {.i = axis}, {.i = command}, {.p = argument}, {.i = type}}, r = {0};
    double begin;
    void *real = enter(142, &begin);
    if (real) r.i = ((int (APIENTRY *)(HCTRLR, WORD, WORD, void *, int))(intptr_t)real)(hCtlr, axis, command, argument, type);
    return (int)leave(142, a, r, begin, real != NULL).i;
}

MCAPI_EXPORT int APIENTRY pmccmdrpyex(HCTRLR hCtlr, WORD axis, WORD cmd, void *arg, int arg_type, void *rpy, int rpy_type)
{
    item a[] = {{.i = hCtlr}, {.i = axis}, {.i = cmd}, {.p = arg}, {.i = arg_type}, {.p = rpy}, {.i = rpy_type}}, r = {0};
    double begin;
    void *real = enter(143, &begin);
    if (real) r.i = ((int (APIENTRY *)(HCTRLR, WORD, WORD, void *, int, void *, int))(intptr_t)real)(hCtlr, axis, cmd, arg, arg_type, rpy, rpy_type);
    return (int)leave(143, a, r, begin, real != NULL).i;
}

MCAPI_EXPORT short APIENTRY pmcgetc(HCTRLR hCtlr)
{
    item a[] = {{.i = hCtlr}}, r = {0};
    double begin;
    void *real = enter(144, &begin);
    if (real) r.i = ((short (APIENTRY *)(HCTRLR))(intptr_t)real)(hCtlr);
    return (short)leave(144, a, r, begin, real != NULL).i;
}

MCAPI_EXPORT void APIENTRY pmcgetram(HCTRLR hCtlr, WORD offset, void *buffer, short size)
{
    item a[] = {{.i = hCtlr}, {.i = offset}, {.p = buffer}, {.i = size}}, r = {0};
    double begin;
    void *real = enter(145, &begin);
    if (real) ((void (APIENTRY *)(HCTRLR, WORD, void *, short))(intptr_t)real)(hCtlr, offset, buffer, size);
    leave(145, a, r, begin, real != NULL);
}

MCAPI_EXPORT int APIENTRY pmcgetramex(HCTRLR hCtlr, DWORD offset, void *buffer, DWORD size)
{
    item a[] = {{.i = hCtlr}, {.i = offset}, {.p = buffer}, {.i = size}}, r = {0};
    double begin;
    void *real = enter(146, &begin);
    if (real) r.i = ((int (APIENTRY *)(HCTRLR, DWORD, void *, DWORD))(intptr_t)real)(hCtlr, offset, buffer, size);
    return (int)leave(146, a, r, begin, real != NULL).i;
}

MCAPI_EXPORT short APIENTRY pmcgets(HCTRLR hCtlr, char *buffer, short size)
{
    item a[] = {{.i = hCtlr}, {.p = buffer}, {.i = size}}, r = {0};
    double begin;
    void *real = enter(147, &begin);
    if (real) r.i = ((short (APIENTRY *)(HCTRLR, char *, short))(intptr_t)real)(hCtlr, buffer, size);
    return (short)leave(147, a, r, begin, real != NULL).i;
}

MCAPI_EXPORT DWORD APIENTRY pmclock(HCTRLR hCtlr, DWORD wait_msec)
{
    item a[] = {{.i = hCtlr}, {.i = wait_msec}}, r = {0};
    double begin;
    void *real = enter(148, &begin);
    if (real) r.i = ((DWORD (APIENTRY *)(HCTRLR, DWORD))(intptr_t)real)(hCtlr, wait_msec);
    return (DWORD)leave(148, a, r, begin, real != NULL).i;
}

MCAPI_EXPORT int APIENTRY pmclookupvar(HCTRLR hCtlr, const char *varname, DWORD *address)
{
    item a[] = {{.i = hCtlr}, {.p = varname}, {.p = address}}, r = {0};
    double begin;
    void *real = enter(149, &begin);
    if (real) r.i = ((int (APIENTRY *)(HCTRLR, const char *, DWORD *))(intptr_t)real)(hCtlr, varname, address);
    return (int)leave(149, a, r, begin, real != NULL).i;
}

MCAPI_EXPORT short APIENTRY pmcputc(HCTRLR hCtlr, short character)
{
    item a[] = {{.i = hCtlr}, {.i = character}}, r = {0};
    double begin;
    void *real = enter(150, &begin);
    if (real) r.i = ((short (APIENTRY *)(HCTRLR, short))(intptr_t)real)(hCtlr, character);
    return (short)leave(150, a, r, begin, real != NULL).i;
}

MCAPI_EXPORT void APIENTRY pmcputram(HCTRLR hCtlr, WORD offset, void *buffer, short size)
{
    item a[] = {{.i = hCtlr}, {.i = offset}, {.p = buffer}, {.i = size}}, r = {0};
    double begin;
    void *real = enter(151, &begin);
    if (real) ((void (APIENTRY *)(HCTRLR, WORD, void *, short))(intptr_t)real)(hCtlr, offset, buffer, size);
    leave(151, a, r, begin, real != NULL);
}

MCAPI_EXPORT int APIENTRY pmcputramex(HCTRLR hCtlr, DWORD offset, void *buffer, DWORD size)
{
    item a[] = {{.i = hCtlr}, {.i = offset}, {.p = buffer}, {.i = size}}, r = {0};
    double begin;
    void *real = enter(152, &begin);
    if (real) r.i = ((int (APIENTRY *)(HCTRLR, DWORD, void *, DWORD))(intptr_t)real)(hCtlr, offset, buffer, size);
    return (int)leave(152, a, r, begin, real != NULL).i;
}

MCAPI_EXPORT short APIENTRY pmcputs(HCTRLR hCtlr, const char *buffer)
{
    item a[] = {{.i = hCtlr}, {.p = buffer}}, r = {0};
    double begin;
    void *real = enter(153, &begin);
    if (real) r.i = ((short (APIENTRY *)(HCTRLR, const char *))(intptr_t)real)(hCtlr, buffer);
    return (short)leave(153, a, r, begin, real != NULL).i;
}

MCAPI_EXPORT short APIENTRY pmcrdy(HCTRLR hCtlr)
{
    item a[] = {{.i = hCtlr}}, r = {0};
    double begin;
    void *real = enter(154, &begin);
    if (real) r.i = ((short (APIENTRY *)(HCTRLR))(intptr_t)real)(hCtlr);
    return (short)leave(154, a, r, begin, real != NULL).i;
}

MCAPI_EXPORT short APIENTRY pmcrpy(HCTRLR hCtlr, short size, void *buffer)
{
    item a[] = {{.i = hCtlr}, {.i = size}, {.p = buffer}}, r = {0};
    double begin;
    void *real = enter(155, &begin);
    if (real) r.i = ((short (APIENTRY *)(HCTRLR, short, void *))(intptr_t)real)(hCtlr, size, buffer);
    return (short)leave(155, a, r, begin, real != NULL).i;
}

MCAPI_EXPORT int APIENTRY pmcrpyex(HCTRLR hCtlr, void *reply, int type)
{
    item a[] = {{.i = hCtlr}, {.p = reply}, {.i = type}}, r = {0};
    double begin;
    void *real = enter(156, &begin);
    if (real) r.i = ((int (APIENTRY *)(HCTRLR, void *, int))(intptr_t)real)(hCtlr, reply, type);
    return (int)leave(156, a, r, begin, real != NULL).i;
}

MCAPI_EXPORT void APIENTRY pmcunlock(HCTRLR hCtlr)
{
    item a[] = {{.i = hCtlr}}, r = {0};
    double begin;
    void *real = enter(157, &begin);
    if (real) ((void (APIENTRY *)(HCTRLR))(intptr_t)real)(hCtlr);
    leave(157, a, r, begin, real != NULL);
}
