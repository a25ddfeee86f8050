/* A host in C that calls functions of every kind, and checks what comes back. It ends with the number of the check that
 * failed, 0 for none. It never sets cbSize, as a beam-line host does; other hosts set the size, 128 or 136. */
#include <locale.h>
#include <math.h>
#include <pthread.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "mcapi.h"

#define CHECK(number, condition) if (!(condition)) { fprintf(stderr, "check %d: %s\n", number, #condition); exit(number); }

static HCTRLR h;

static void *reads(void *count)
{
    for (int k = 0; k < 200; k++) {
        double position = -1;
        if (MCGetPositionEx(h, 2, &position) == 0 && position == 0.0) ++*(int *)count;
    }
    return NULL;
}

int main(void)
{
    double position = -1.0, low = 0, high = 0, data[4];
    short hard = 0, soft = 0;
    char text[16], wide[64];
    MCSTATUSEX status, after;
    MCFILTEREX filter = {0}, found;
    MCMOTIONEX motion;
    MCPARAM param;
    struct { unsigned cbSize, status, aux, profile, mode, after; } narrow;
    unsigned sizes[] = {20, 128, 136};
    int modules[3], counts[8] = {0}, value = 12345, back = 0;
    pthread_t threads[8];
    DWORD analog = 9;

    setlocale(LC_ALL, "de_DE.UTF-8");
    memset(&motion, 7, sizeof motion);
    CHECK(1, MCGetMotionConfigEx(6, 1, &motion) == MCERR_CONTROLLER && ((char *)&motion)[50] == 7)
    CHECK(2, MCOpen(16, MC_OPEN_BINARY, NULL) == -MCERR_NO_CONTROLLER)
    h = MCOpen(0, MC_OPEN_BINARY, NULL);
    CHECK(3, h == 1)
    MCEnableAxis(h, 1, 1);
    MCMoveAbsolute(h, 1, 5000.5);
    CHECK(4, MCIsStopped(h, 1, 10.0) == 1)
    CHECK(5, MCGetPositionEx(h, 1, &position) == 0 && position == 5001.0)
    memset(&status, 0x55, sizeof status);
    CHECK(6, MCGetStatusEx(h, 1, &status) == 0 && status.Status >> MC_STAT_MTR_ENABLE & 1)
    CHECK(7, status.cbSize == 0x55555555 && status.ModeStatus == 1 && sizeof status == 36)
    CHECK(8, MCDecodeStatusEx(h, &status, MC_STAT_MODE_POS) == 1)
    for (int k = 0; k < 3; k++) { /* PMC's binding sets 136 before Python 3.12, and 128 from then on */
        memset(&narrow, 0x55, sizeof narrow);
        narrow.cbSize = sizes[k];
        CHECK(9, MCGetStatusEx(h, 1, (MCSTATUSEX *)&narrow) == 0 && narrow.status >> 3 & 1 && narrow.mode == 1)
        CHECK(9, narrow.after == 0x55555555)
    }
    memset(&after, 0x55, sizeof after);
    CHECK(10, MCGetStatusEx(h, 99, &after) == MCERR_AXIS_NUMBER && after.Status == 0x5555555555555555UL)
    filter.cbSize = sizeof filter;
    filter.Gain = 0.25;
    filter.OutputOffset = 1.5;
    CHECK(11, MCSetFilterConfigEx(h, 1, &filter) == 0)
    memset(&found, 0, sizeof found);
    CHECK(12, MCGetFilterConfigEx(h, 1, &found) == 0 && found.Gain == 0.25 && found.OutputOffset == 1.5)
    found.cbSize = 92;
    found.OutputOffset = -1.0;
    CHECK(13, MCGetFilterConfigEx(h, 1, &found) == 0 && found.OutputOffset == -1.0)
    CHECK(14, MCGetPositionEx(h, 1, NULL) == MCERR_RANGE && MCGetError(h) == MCERR_RANGE && MCGetError(h) == 0)
    MCMoveAbsolute(h, 1, NAN);
    CHECK(15, MCGetError(h) == MCERR_RANGE)
    memset(wide, 'x', sizeof wide);
    CHECK(16, MCTranslateErrorEx(MCERR_AXIS_NUMBER, wide, 5) == MCERR_RANGE && !strcmp(wide, "axis") && wide[5] == 'x')
    CHECK(17, MCTranslateErrorEx(MCERR_AXIS_NUMBER, wide, 64) == 0 && !strcmp(wide, "axis number out of range"))
    CHECK(18, MCSetLimits(h, 1, MC_LIMIT_PLUS | MC_LIMIT_SMOOTH, 0, -100.25, 250.5) == 0)
    CHECK(19, MCGetLimits(h, 1, &hard, &soft, &low, &high) == 0 && hard == 9 && low == -100.0 && high == 251.0)
    CHECK(20, MCSetRegister(h, 30, &value, MC_TYPE_LONG) == 0 && MCGetRegister(h, 30, &back, MC_TYPE_LONG) == 0)
    CHECK(21, back == 12345)
    CHECK(22, MCGetInstalledModules(h, modules, 3) == 0 && modules[0] == MFXSERVO && modules[2] == MFXSERVO)
    MCGetConfiguration(h, &param);
    CHECK(23, param.ControllerType == MFXPCI1000 && param.AxisType[7] == MC_TYPE_SERVO && param.AmpFault == 1)
    CHECK(24, MCGetAnalogEx(h, 1, &analog) == 0 && analog == 2048)
    CHECK(25, MCCaptureData(h, 1, 4, 0.0, 0.0) == 0)
    MCWait(h, 0.01);
    CHECK(26, MCGetCaptureData(h, 1, MC_CAPTURE_ACTUAL, 0, 4, data) == 0 && data[3] == 5001.0)
    CHECK(27, MCConfigureCompare(h, 1, data, 4, 0.0, 0, 0.0) == MCERR_NOTSUPPORTED)
    CHECK(28, MCBlockBegin(h, MC_BLOCK_COMPOUND, 0) == 0 && MCBlockEnd(h, NULL) == 0)
    CHECK(29, MCBlockEnd(h, NULL) == MCERR_BLOCK_MODE)
    for (int k = 0; k < 8; k++) pthread_create(&threads[k], NULL, reads, &counts[k]);
    MCMoveAbsolute(h, 1, 0.0);
    CHECK(30, MCIsStopped(h, 1, 10.0) == 1)
    for (int k = 0; k < 8; k++) { pthread_join(threads[k], NULL); CHECK(31, counts[k] == 200) }
    h = MCOpen(0, MC_OPEN_ASCII, "name");
    CHECK(32, h == 2 && pmcputs(h, "AL\"x=1\"\r") == 8)
    CHECK(33, pmcgets(h, text, sizeof text) > 0 && text[0] == '?' && atoi(text + 1) == 2)
    CHECK(34, pmcputs(h, "1TP\r") == 4 && pmcgets(h, text, 4) == 3 && !strcmp(text, "01 "))
    CHECK(35, pmcgetc(h) == '0' && MCClose(h) == 0 && MCClose(h) == MCERR_CONTROLLER)
    printf("%g\n", position);
    return 0;
}
