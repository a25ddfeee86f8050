/* Functions, structures and constants of MCAPI 4.4.1, for hosts of a virtual board.
 *
 * Written by `python -m tools.derived`, not by hand. Hosts ask for the guards of several versions.
 */
#ifndef MCAPI_H
#define MCAPI_H
#define __MCAPI_H__
#define _INC_MCAPI

#ifdef _WIN32
#include <windows.h>
#else
typedef unsigned short WORD;
typedef unsigned long DWORD;
typedef unsigned long HWND;
typedef const char *LPCSTR;
#endif
#ifndef APIENTRY
#define APIENTRY
#endif
#ifndef MCAPI_EXPORT
#define MCAPI_EXPORT
#endif

#ifdef __cplusplus
extern "C" {
#endif

typedef short HCTRLR;
typedef void (MCINTERRUPTPROC)(HWND, HCTRLR, WORD, DWORD);

#define MC_ALL_AXES 0
#define MC_ABSOLUTE 0
#define MC_RELATIVE 1
#define MC_BLOCK_COMPOUND 0
#define MC_BLOCK_TASK 1
#define MC_BLOCK_MACRO 2
#define MC_BLOCK_RESETM 3
#define MC_BLOCK_CANCEL 4
#define MC_BLOCK_CONTR_USER 5
#define MC_BLOCK_CONTR_LIN 6
#define MC_BLOCK_CONTR_CW 7
#define MC_BLOCK_CONTR_CCW 8
#define MC_CAPTURE_ACTUAL 16
#define MC_CAPTURE_ERROR 32
#define MC_CAPTURE_OPTIMAL 64
#define MC_CAPTURE_TORQUE 128
#define MC_CAPTURE_ADVANCED 256
#define MC_CAPTURE_AUXILIARY 512
#define MC_CAPTURE_STATUS 1024
#define MC_COMPARE_DISABLE 0
#define MC_COMPARE_ENABLE 1
#define MC_COMPARE_STATIC 1
#define MC_COMPARE_TOGGLE 2
#define MC_COMPARE_ONESHOT 3
#define MC_COMPARE_STROBE 5
#define MC_COMPARE_INVERT 128
#define MC_COUNT_CAPTURE 1
#define MC_COUNT_COMPARE 2
#define MC_COUNT_CONTOUR 4
#define MC_COUNT_FILTER 8
#define MC_COUNT_FILTERMAX 16
#define MC_COUNT_RECORD 32
#define MC_CURRENT_FULL 1
#define MC_CURRENT_HALF 2
#define MC_DIO_FIXED 256
#define MC_DIO_INPUT 1
#define MC_DIO_OUTPUT 2
#define MC_DIO_HIGH 4
#define MC_DIO_LOW 8
#define MC_DIO_LATCH 16
#define MC_DIO_LATCHABLE 512
#define MC_DIO_STEPPER 1024
#define MC_DIR_POSITIVE 1
#define MC_DIR_NEGATIVE 2
#define MC_ENC_FAULT_PRI 1
#define MC_ENC_FAULT_AUX 2
#define MC_INT_NORMAL 0
#define MC_INT_FREEZE 1
#define MC_INT_ZERO 2
#define MC_IM_OPENLOOP 0
#define MC_IM_CLOSEDLOOP 1
#define MC_LIMIT_ABRUPT 4
#define MC_LIMIT_BOTH 3
#define MC_LIMIT_INVERT 128
#define MC_LIMIT_MINUS 2
#define MC_LIMIT_OFF 0
#define MC_LIMIT_PLUS 1
#define MC_LIMIT_SMOOTH 8
#define MC_LRN_POSITION 1
#define MC_LRN_TARGET 2
#define MC_MAX_ID 15
#define MC_MODE_CONTOUR 0
#define MC_MODE_GAIN 1
#define MC_MODE_POSITION 2
#define MC_MODE_TORQUE 3
#define MC_MODE_VELOCITY 4
#define MC_MODE_UNKNOWN 5
#define MC_MODULE_TYPE 15
#define MC_MODULE_SUBTYPE 240
#define MC_OM_BIPOLAR 0
#define MC_OM_UNIPOLAR 1
#define MC_OM_PULSE_DIR 0
#define MC_OM_CW_CCW 1
#define MC_OM_BI_PWM 2
#define MC_OM_UNI_PWM 3
#define MC_OM_PIEZO 4
#define MC_OM_SINE_NOENC 32768
#define MC_OM_SINE_ENC 49152
#define MC_OPEN_ASCII 1
#define MC_OPEN_BINARY 2
#define MC_OPEN_EXCLUSIVE 32768
#define MC_PHASE_STD 0
#define MC_PHASE_REV 1
#define MC_PROF_UNKNOWN 0
#define MC_PROF_TRAPEZOID 1
#define MC_PROF_SCURVE 2
#define MC_PROF_PARABOLIC 4
#define MC_RATE_UNKNOWN 0
#define MC_RATE_LOW 1
#define MC_RATE_MEDIUM 2
#define MC_RATE_HIGH 4
#define MC_STAT_BUSY 0
#define MC_STAT_MTR_ENABLE 1
#define MC_STAT_MODE_VEL 2
#define MC_STAT_TRAJ 3
#define MC_STAT_DIR 4
#define MC_STAT_JOG_ENAB 5
#define MC_STAT_HOMED 6
#define MC_STAT_ERROR 7
#define MC_STAT_LOOK_INDEX 8
#define MC_STAT_LOOK_EDGE 9
#define MC_STAT_BREAKPOINT 10
#define MC_STAT_FOLLOWING 11
#define MC_STAT_AMP_ENABLE 12
#define MC_STAT_AMP_FAULT 13
#define MC_STAT_PLIM_ENAB 14
#define MC_STAT_PLIM_TRIP 15
#define MC_STAT_MLIM_ENAB 16
#define MC_STAT_MLIM_TRIP 17
#define MC_STAT_PSOFT_ENAB 18
#define MC_STAT_PSOFT_TRIP 19
#define MC_STAT_MSOFT_ENAB 20
#define MC_STAT_MSOFT_TRIP 21
#define MC_STAT_INP_INDEX 22
#define MC_STAT_INP_HOME 23
#define MC_STAT_INP_AMP 24
#define MC_STAT_INP_AUX 25
#define MC_STAT_INP_PLIM 26
#define MC_STAT_INP_MLIM 27
#define MC_STAT_INP_USER1 28
#define MC_STAT_INP_USER2 29
#define MC_STAT_PHASE 30
#define MC_STAT_FULL_STEP 31
#define MC_STAT_HALF_STEP 32
#define MC_STAT_JOGGING 33
#define MC_STAT_PJOG_ENAB 34
#define MC_STAT_PJOG_ON 35
#define MC_STAT_MJOG_ENAB 36
#define MC_STAT_MJOG_ON 37
#define MC_STAT_INP_PJOG 38
#define MC_STAT_INP_MJOG 39
#define MC_STAT_STOPPING 40
#define MC_STAT_PROG_DIR 41
#define MC_STAT_AT_TARGET 42
#define MC_STAT_ACCEL 43
#define MC_STAT_MODE_POS 44
#define MC_STAT_MODE_TRQE 45
#define MC_STAT_MODE_ARC 46
#define MC_STAT_MODE_CNTR 47
#define MC_STAT_MODE_SLAVE 48
#define MC_STAT_LMT_ABORT 49
#define MC_STAT_LMT_STOP 50
#define MC_STAT_CAPTURE 51
#define MC_STAT_RECORD 52
#define MC_STAT_SYNC 53
#define MC_STAT_MODE_LIN 54
#define MC_STAT_INDEX_FOUND 55
#define MC_STAT_POS_CAPT 56
#define MC_STAT_NULL 57
#define MC_STAT_EDGE_FOUND 58
#define MC_STAT_PRI_ENC_FAULT 59
#define MC_STAT_AUX_ENC_FAULT 60
#define MC_STAT_LOOK_AUX_IDX 61
#define MC_STAT_AUX_IDX_FND 62
#define MC_STEP_FULL 1
#define MC_STEP_HALF 2
#define MC_THREAD 256
#define MC_TYPE_NONE 0
#define MC_TYPE_REG 1
#define MC_TYPE_LONG 2
#define MC_TYPE_FLOAT 3
#define MC_TYPE_DOUBLE 4
#define MC_TYPE_STRING 5
#define MC_TYPE_SERVO 1
#define MC_TYPE_STEPPER 2
#define NO_CONTROLLER 0
#define DCXPC100 1
#define DCXAT100 2
#define DCXAT200 3
#define DC2PC100 4
#define DC2STN 5
#define DCXAT300 6
#define DCXPCI300 7
#define DCXPCI100 8
#define MFXPCI1000 9
#define MFXETH1000 10
#define MC100 5
#define MC110 4
#define MC150 6
#define MC160 7
#define MC200 0
#define MC210 16
#define MC260 1
#define MC300 2
#define MC302 22
#define MC320 162
#define MC360 3
#define MC362 23
#define MC400 8
#define MC500 12
#define MF300 10
#define MF310 9
#define NO_MODULE 15
#define MFXSERVO 252
#define MFXSTEPPER 253
#define DC2SERVO 254
#define DC2STEPPER 255
#define MCERRMASK_UNSUPPORTED 1
#define MCERRMASK_HANDLE 2
#define MCERRMASK_AXIS 4
#define MCERRMASK_PARAMETER 8
#define MCERRMASK_IO 16
#define MCERRMASK_SYSTEM 32
#define MCERRMASK_STANDARD 4294967294
#define MCERR_NOERROR 0
#define MCERR_NO_CONTROLLER 1
#define MCERR_OUT_OF_HANDLES 2
#define MCERR_OPEN_EXCLUSIVE 3
#define MCERR_MODE_UNAVAIL 4
#define MCERR_UNSUPPORTED_MODE 5
#define MCERR_INIT_DRIVER 6
#define MCERR_NOT_PRESENT 7
#define MCERR_ALLOC_MEM 8
#define MCERR_WINDOWSERROR 9
#define MCERR_OS_ERROR 9
#define MCERR_NOTSUPPORTED 11
#define MCERR_OBSOLETE 12
#define MCERR_CONTROLLER 13
#define MCERR_WINDOW 14
#define MCERR_AXIS_NUMBER 15
#define MCERR_AXIS_TYPE 16
#define MCERR_ALL_AXES 17
#define MCERR_AXIS_ACTIVE 31
#define MCERR_RANGE 18
#define MCERR_CONSTANT 19
#define MCERR_NOT_INITIALIZED 30
#define MCERR_UNKNOWN_REPLY 20
#define MCERR_NO_REPLY 21
#define MCERR_REPLY_SIZE 22
#define MCERR_REPLY_AXIS 23
#define MCERR_REPLY_COMMAND 24
#define MCERR_TIMEOUT 25
#define MCERR_BLOCK_MODE 26
#define MCERR_COMM_PORT 27
#define MCERR_CANCEL 28
#define MCERR_NOT_FOUND 29
#define MCERR_SOCKET 32
#define MC_LINEAR 1
#define MC_CIRC_CW 2
#define MC_CIRC_CCW 3
#define MC_CENTER_ABS 0
#define MC_CENTER_REL 1
#define MC_DATA_ACTUAL 0
#define MC_DATA_OPTIMAL 1
#define MC_DATA_ERROR 2
#define MC_DATA_TORQUE 3
#define MC_LIMIT_HIGH 1
#define MC_LIMIT_LOW 2
#define MC_BLOCK_CONTR_CC 7

#pragma pack(push, 4)
typedef struct {
    int cbSize;
    int ModuleType;
    int ModuleLocation;
    int MotorType;
    int CaptureModes;
    int CapturePoints;
    int CaptureAndCompare;
    double HighRate;
    double MediumRate;
    double LowRate;
    double HighStepMin;
    double HighStepMax;
    double MediumStepMin;
    double MediumStepMax;
    double LowStepMin;
    double LowStepMax;
    int AuxEncoder;
} MCAXISCONFIG;

typedef struct {
    int cbSize;
    double PhaseA;
    double PhaseB;
    int Divisor;
    int PreScale;
    int Repeat;
} MCCOMMUTATION;

typedef struct {
    double VectorAccel;
    double VectorDecel;
    double VectorVelocity;
    double VelocityOverride;
} MCCONTOUR;

typedef struct {
    int cbSize;
    double Gain;
    double IntegralGain;
    double IntegrationLimit;
    int IntegralOption;
    double DerivativeGain;
    double DerSamplePeriod;
    double FollowingError;
    double VelocityGain;
    double AccelGain;
    double DecelGain;
    double EncoderScaling;
    int UpdateRate;
    double PositionDeadband;
    double DelayAtTarget;
    double OutputOffset;
    double OutputDeadband;
} MCFILTEREX;

typedef struct {
    double DerivativeGain;
    double DerSamplePeriod;
    double IntegralGain;
    double IntegrationLimit;
    double VelocityGain;
    double AccelGain;
    double DecelGain;
    double FollowingError;
} MCFILTER;

typedef struct {
    int cbSize;
    double Acceleration;
    double MinVelocity;
    double Deadband;
    double Gain;
    double Offset;
    int Channel;
} MCJOGEX;

typedef struct {
    double Acceleration;
    double MinVelocity;
    double Deadband;
    double Gain;
    double Offset;
} MCJOG;

typedef struct {
    int cbSize;
    double Acceleration;
    double Deceleration;
    double Velocity;
    double MinVelocity;
    int Direction;
    double Torque;
    double Deadband;
    double DeadbandDelay;
    int StepSize;
    int Current;
    int HardLimitMode;
    int SoftLimitMode;
    double SoftLimitLow;
    double SoftLimitHigh;
    int EnableAmpFault;
} MCMOTIONEX;

typedef struct {
    double Acceleration;
    double Deceleration;
    double Velocity;
    double MinVelocity;
    short Direction;
    double Gain;
    double Torque;
    double Deadband;
    double DeadbandDelay;
    short StepSize;
    short Current;
    short HardLimitMode;
    short SoftLimitMode;
    double SoftLimitLow;
    double SoftLimitHigh;
    short EnableAmpFault;
    short Rate;
} MCMOTION;

typedef struct {
    int cbSize;
    int ID;
    int ControllerType;
    int NumberAxes;
    int MaximumAxes;
    int MaximumModules;
    int Precision;
    int DigitalIO;
    int AnalogInput;
    int AnalogOutput;
    int PointStorage;
    int CanDoScaling;
    int CanDoContouring;
    int CanChangeProfile;
    int CanChangeRates;
    int SoftLimits;
    int MultiTasking;
    int AmpFault;
    double AnalogInpMin;
    double AnalogInpMax;
    int AnalogInpRes;
    double AnalogOutMin;
    double AnalogOutMax;
    int AnalogOutRes;
    int OutputMode;
    int AtTarget;
    int OutputControl;
    int LineModeAscii;
} MCPARAMEX;

typedef struct {
    short ID;
    short ControllerType;
    short NumberAxes;
    short DigitalIO;
    short AnalogInput;
    short AnalogOutput;
    short AxisType[8];
    short PointStorage;
    short CanDoScaling;
    short CanDoContouring;
    short CanChangeProfile;
    short CanChangeRates;
    short SoftLimits;
    short MultiTasking;
    short AmpFault;
} MCPARAM;

typedef struct {
    double Constant;
    double Offset;
    double Rate;
    double Scale;
    double Zero;
    double Time;
} MCSCALE;

typedef struct {
    int cbSize;
    DWORD Status;
    DWORD AuxStatus;
    DWORD ProfileStatus;
    DWORD ModeStatus;
} MCSTATUSEX;
#pragma pack(pop)

MCAPI_EXPORT void APIENTRY MCAbort(HCTRLR hCtlr, WORD axis);
MCAPI_EXPORT int APIENTRY MCArcCenter(HCTRLR hCtlr, WORD axis, short type, double position);
MCAPI_EXPORT int APIENTRY MCArcEndAngle(HCTRLR hCtlr, WORD axis, short type, double angle);
MCAPI_EXPORT int APIENTRY MCArcRadius(HCTRLR hCtlr, WORD axis, double radius);
MCAPI_EXPORT int APIENTRY MCBlockBegin(HCTRLR hCtlr, int mode, int num);
MCAPI_EXPORT int APIENTRY MCBlockEnd(HCTRLR hCtlr, int *taskID);
MCAPI_EXPORT int APIENTRY MCCancelTask(HCTRLR hCtlr, int taskID);
MCAPI_EXPORT int APIENTRY MCCaptureData(HCTRLR hCtlr, WORD axis, int points, double period, double delay);
MCAPI_EXPORT short APIENTRY MCClose(HCTRLR hCtlr);
MCAPI_EXPORT int APIENTRY MCConfigureCompare(HCTRLR hCtlr, WORD axis, double *values, int num, double inc, int mode, double period);
MCAPI_EXPORT short APIENTRY MCConfigureDigitalIO(HCTRLR hCtlr, WORD channel, WORD mode);
MCAPI_EXPORT int APIENTRY MCContourDistance(HCTRLR hCtlr, WORD axis, double distance);
MCAPI_EXPORT int APIENTRY MCContourPath(HCTRLR hCtlr, WORD axis, WORD wMode, const char *buffer);
MCAPI_EXPORT int APIENTRY MCDecodeStatus(HCTRLR hCtlr, DWORD status, int bit);
MCAPI_EXPORT int APIENTRY MCDecodeStatusEx(HCTRLR hCtlr, MCSTATUSEX *status, int bit);
MCAPI_EXPORT void APIENTRY MCDirection(HCTRLR hCtlr, WORD axis, WORD dir);
MCAPI_EXPORT int APIENTRY MCEdgeArm(HCTRLR hCtlr, WORD axis, double position);
MCAPI_EXPORT void APIENTRY MCEnableAxis(HCTRLR hCtlr, WORD axis, short state);
MCAPI_EXPORT int APIENTRY MCEnableBacklash(HCTRLR hCtlr, WORD axis, double backlash, short state);
MCAPI_EXPORT int APIENTRY MCEnableCapture(HCTRLR hCtlr, WORD axis, int count);
MCAPI_EXPORT int APIENTRY MCEnableCompare(HCTRLR hCtlr, WORD axis, int count);
MCAPI_EXPORT int APIENTRY MCEnableDigitalFilter(HCTRLR hCtlr, WORD axis, int state);
MCAPI_EXPORT void APIENTRY MCEnableDigitalIO(HCTRLR hCtlr, WORD channel, short state);
MCAPI_EXPORT int APIENTRY MCEnableEncoderFault(HCTRLR hCtlr, WORD axis, int state);
MCAPI_EXPORT void APIENTRY MCEnableGearing(HCTRLR hCtlr, WORD axis, WORD master, double ratio, short state);
MCAPI_EXPORT int APIENTRY MCEnableInterrupt(HWND hWnd, HCTRLR hCtlr, WORD axis, DWORD mask, MCINTERRUPTPROC *lpIntFunc);
MCAPI_EXPORT void APIENTRY MCEnableJog(HCTRLR hCtlr, WORD axis, short state);
MCAPI_EXPORT void APIENTRY MCEnableSync(HCTRLR hCtlr, WORD axis, short state);
MCAPI_EXPORT void APIENTRY MCErrorNotify(HWND hWnd, HCTRLR hCtlr, DWORD errormask);
MCAPI_EXPORT int APIENTRY MCFindAuxEncIdx(HCTRLR hCtlr, WORD axis, double position);
MCAPI_EXPORT int APIENTRY MCFindEdge(HCTRLR hCtlr, WORD axis, double position);
MCAPI_EXPORT int APIENTRY MCFindIndex(HCTRLR hCtlr, WORD axis, double position);
MCAPI_EXPORT int APIENTRY MCGetAccelerationEx(HCTRLR hCtlr, WORD axis, double *acceleration);
MCAPI_EXPORT WORD APIENTRY MCGetAnalog(HCTRLR hCtlr, WORD channel);
MCAPI_EXPORT int APIENTRY MCGetAnalogEx(HCTRLR hCtlr, int channel, DWORD *value);
MCAPI_EXPORT int APIENTRY MCGetAuxEncIdxEx(HCTRLR hCtlr, WORD axis, double *index);
MCAPI_EXPORT int APIENTRY MCGetAuxEncPosEx(HCTRLR hCtlr, WORD axis, double *position);
MCAPI_EXPORT int APIENTRY MCGetAxisConfiguration(HCTRLR hCtlr, WORD axis, MCAXISCONFIG *axiscfg);
MCAPI_EXPORT int APIENTRY MCGetBreakpointEx(HCTRLR hCtlr, WORD axis, double *breakpoint);
MCAPI_EXPORT int APIENTRY MCGetCaptureData(HCTRLR hCtlr, WORD axis, int type, int start, int points, double *data);
MCAPI_EXPORT int APIENTRY MCGetCaptureSettings(HCTRLR hCtlr, WORD axis, int *points, double *period, double *delay, int *index);
MCAPI_EXPORT void APIENTRY MCGetConfiguration(HCTRLR hCtlr, MCPARAM *param);
MCAPI_EXPORT int APIENTRY MCGetConfigurationEx(HCTRLR hCtlr, MCPARAMEX *param);
MCAPI_EXPORT short APIENTRY MCGetContourConfig(HCTRLR hCtlr, WORD axis, MCCONTOUR *contour);
MCAPI_EXPORT int APIENTRY MCGetContouringCount(HCTRLR hCtlr, WORD axis);
MCAPI_EXPORT int APIENTRY MCGetCount(HCTRLR hCtlr, WORD axis, int type, int *count);
MCAPI_EXPORT int APIENTRY MCGetDecelerationEx(HCTRLR hCtlr, WORD axis, double *deceleration);
MCAPI_EXPORT int APIENTRY MCGetDigitalFilter(HCTRLR hCtlr, WORD axis, double *coeff, int num, int *actual);
MCAPI_EXPORT short APIENTRY MCGetDigitalIO(HCTRLR hCtlr, WORD channel);
MCAPI_EXPORT int APIENTRY MCGetDigitalIOConfig(HCTRLR hCtlr, WORD channel, WORD *mode);
MCAPI_EXPORT int APIENTRY MCGetDigitalIOEx(HCTRLR hCtlr, WORD channel, unsigned *state);
MCAPI_EXPORT short APIENTRY MCGetError(HCTRLR hCtlr);
MCAPI_EXPORT short APIENTRY MCGetFilterConfig(HCTRLR hCtlr, WORD axis, MCFILTER *filter);
MCAPI_EXPORT int APIENTRY MCGetFilterConfigEx(HCTRLR hCtlr, WORD axis, MCFILTEREX *filter);
MCAPI_EXPORT int APIENTRY MCGetFollowingError(HCTRLR hCtlr, WORD axis, double *error);
MCAPI_EXPORT int APIENTRY MCGetGain(HCTRLR hCtlr, WORD axis, double *gain);
MCAPI_EXPORT int APIENTRY MCGetIndexEx(HCTRLR hCtlr, WORD axis, double *index);
MCAPI_EXPORT int APIENTRY MCGetInstalledModules(HCTRLR hCtlr, int *modules, int size);
MCAPI_EXPORT short APIENTRY MCGetJogConfig(HCTRLR hCtlr, WORD axis, MCJOG *jog);
MCAPI_EXPORT int APIENTRY MCGetJogConfigEx(HCTRLR hCtlr, WORD axis, MCJOGEX *jog);
MCAPI_EXPORT int APIENTRY MCGetLimits(HCTRLR hCtlr, WORD axis, short *hardlimitmode, short *softlimitmode, double *softlimitminus, double *softlimitplus);
MCAPI_EXPORT int APIENTRY MCGetModuleInputMode(HCTRLR hCtlr, WORD axis, int *mode);
MCAPI_EXPORT int APIENTRY MCGetModuleOutputMode(HCTRLR hCtlr, WORD axis, WORD *mode);
MCAPI_EXPORT short APIENTRY MCGetMotionConfig(HCTRLR hCtlr, WORD axis, MCMOTION *motion);
MCAPI_EXPORT int APIENTRY MCGetMotionConfigEx(HCTRLR hCtlr, WORD axis, MCMOTIONEX *motion);
MCAPI_EXPORT int APIENTRY MCGetOperatingMode(HCTRLR hCtlr, WORD axis, int *mode);
MCAPI_EXPORT int APIENTRY MCGetOptimalEx(HCTRLR hCtlr, WORD axis, double *optimal);
MCAPI_EXPORT int APIENTRY MCGetPositionEx(HCTRLR hCtlr, WORD axis, double *position);
MCAPI_EXPORT int APIENTRY MCGetProfile(HCTRLR hCtlr, WORD axis, WORD *profile);
MCAPI_EXPORT int APIENTRY MCGetRegister(HCTRLR hCtlr, int reg, void *value, int type);
MCAPI_EXPORT short APIENTRY MCGetScale(HCTRLR hCtlr, WORD axis, MCSCALE *scale);
MCAPI_EXPORT int APIENTRY MCGetServoOutputPhase(HCTRLR hCtlr, WORD axis, WORD *phase);
MCAPI_EXPORT DWORD APIENTRY MCGetStatus(HCTRLR hCtlr, WORD axis);
MCAPI_EXPORT int APIENTRY MCGetStatusEx(HCTRLR hCtlr, WORD axis, MCSTATUSEX *status);
MCAPI_EXPORT int APIENTRY MCGetTargetEx(HCTRLR hCtlr, WORD axis, double *target);
MCAPI_EXPORT int APIENTRY MCGetTorque(HCTRLR hCtlr, WORD axis, double *torque);
MCAPI_EXPORT int APIENTRY MCGetTrajectoryRate(HCTRLR hCtlr, int *rate);
MCAPI_EXPORT int APIENTRY MCGetVectorVelocity(HCTRLR hCtlr, WORD axis, double *velocity);
MCAPI_EXPORT int APIENTRY MCGetVelocityActual(HCTRLR hCtlr, WORD axis, double *velocity);
MCAPI_EXPORT int APIENTRY MCGetVelocityEx(HCTRLR hCtlr, WORD axis, double *velocity);
MCAPI_EXPORT int APIENTRY MCGetVelocityOverride(HCTRLR hCtlr, WORD axis, double *override);
MCAPI_EXPORT DWORD APIENTRY MCGetVersion(HCTRLR hCtlr);
MCAPI_EXPORT void APIENTRY MCGo(HCTRLR hCtlr, WORD axis);
MCAPI_EXPORT int APIENTRY MCGoEx(HCTRLR hCtlr, WORD axis, double param);
MCAPI_EXPORT void APIENTRY MCGoHome(HCTRLR hCtlr, WORD axis);
MCAPI_EXPORT int APIENTRY MCIndexArm(HCTRLR hCtlr, WORD axis, double position);
MCAPI_EXPORT int APIENTRY MCInterruptOnPosition(HCTRLR hCtlr, WORD axis, int mode, double position);
MCAPI_EXPORT int APIENTRY MCIsAtTarget(HCTRLR hCtlr, WORD axis, double timeout);
MCAPI_EXPORT int APIENTRY MCIsDigitalFilter(HCTRLR hCtlr, WORD axis);
MCAPI_EXPORT int APIENTRY MCIsEdgeFound(HCTRLR hCtlr, WORD axis, double timeout);
MCAPI_EXPORT int APIENTRY MCIsIndexFound(HCTRLR hCtlr, WORD axis, double timeout);
MCAPI_EXPORT int APIENTRY MCIsStopped(HCTRLR hCtlr, WORD axis, double timeout);
MCAPI_EXPORT int APIENTRY MCLearnPoint(HCTRLR hCtlr, WORD axis, int index, WORD mode);
MCAPI_EXPORT void APIENTRY MCMacroCall(HCTRLR hCtlr, WORD macro);
MCAPI_EXPORT void APIENTRY MCMoveAbsolute(HCTRLR hCtlr, WORD axis, double position);
MCAPI_EXPORT void APIENTRY MCMoveRelative(HCTRLR hCtlr, WORD axis, double distance);
MCAPI_EXPORT int APIENTRY MCMoveToPoint(HCTRLR hCtlr, WORD axis, int index);
MCAPI_EXPORT HCTRLR APIENTRY MCOpen(short nID, WORD mode, const char *name);
MCAPI_EXPORT int APIENTRY MCReopen(HCTRLR hCtlr, WORD newmode);
MCAPI_EXPORT int APIENTRY MCRepeat(HCTRLR hCtlr, int count);
MCAPI_EXPORT void APIENTRY MCReset(HCTRLR hCtlr, WORD axis);
MCAPI_EXPORT void APIENTRY MCSetAcceleration(HCTRLR hCtlr, WORD axis, double rate);
MCAPI_EXPORT void APIENTRY MCSetAnalog(HCTRLR hCtlr, WORD channel, WORD value);
MCAPI_EXPORT int APIENTRY MCSetAnalogEx(HCTRLR hCtlr, int channel, DWORD value);
MCAPI_EXPORT void APIENTRY MCSetAuxEncPos(HCTRLR hCtlr, WORD axis, double position);
MCAPI_EXPORT int APIENTRY MCSetCommutation(HCTRLR hCtlr, WORD axis, MCCOMMUTATION *commutation);
MCAPI_EXPORT short APIENTRY MCSetContourConfig(HCTRLR hCtlr, WORD axis, MCCONTOUR *contour);
MCAPI_EXPORT void APIENTRY MCSetDeceleration(HCTRLR hCtlr, WORD axis, double rate);
MCAPI_EXPORT int APIENTRY MCSetDigitalFilter(HCTRLR hCtlr, WORD axis, double *coeff, int num);
MCAPI_EXPORT short APIENTRY MCSetFilterConfig(HCTRLR hCtlr, WORD axis, MCFILTER *filter);
MCAPI_EXPORT int APIENTRY MCSetFilterConfigEx(HCTRLR hCtlr, WORD axis, MCFILTEREX *filter);
MCAPI_EXPORT int APIENTRY MCSetGain(HCTRLR hCtlr, WORD axis, double gain);
MCAPI_EXPORT short APIENTRY MCSetJogConfig(HCTRLR hCtlr, WORD axis, MCJOG *jog);
MCAPI_EXPORT int APIENTRY MCSetJogConfigEx(HCTRLR hCtlr, WORD axis, MCJOGEX *jog);
MCAPI_EXPORT int APIENTRY MCSetLimits(HCTRLR hCtlr, WORD axis, short hardlimitmode, short softlimitmode, double softlimitminus, double softlimitplus);
MCAPI_EXPORT int APIENTRY MCSetModuleInputMode(HCTRLR hCtlr, WORD axis, int Mode);
MCAPI_EXPORT void APIENTRY MCSetModuleOutputMode(HCTRLR hCtlr, WORD axis, WORD mode);
MCAPI_EXPORT short APIENTRY MCSetMotionConfig(HCTRLR hCtlr, WORD axis, MCMOTION *motion);
MCAPI_EXPORT int APIENTRY MCSetMotionConfigEx(HCTRLR hCtlr, WORD axis, MCMOTIONEX *motion);
MCAPI_EXPORT void APIENTRY MCSetOperatingMode(HCTRLR hCtlr, WORD axis, WORD caxis, WORD mode);
MCAPI_EXPORT void APIENTRY MCSetPosition(HCTRLR hCtlr, WORD axis, double position);
MCAPI_EXPORT void APIENTRY MCSetProfile(HCTRLR hCtlr, WORD axis, WORD mode);
MCAPI_EXPORT int APIENTRY MCSetRegister(HCTRLR hCtlr, int reg, void *value, int type);
MCAPI_EXPORT short APIENTRY MCSetScale(HCTRLR hCtlr, WORD axis, MCSCALE *scale);
MCAPI_EXPORT void APIENTRY MCSetServoOutputPhase(HCTRLR hCtlr, WORD axis, WORD phase);
MCAPI_EXPORT int APIENTRY MCSetTimeoutEx(HCTRLR hCtlr, double timeout, double *oldtimeOut);
MCAPI_EXPORT int APIENTRY MCSetTorque(HCTRLR hCtlr, WORD axis, double torque);
MCAPI_EXPORT int APIENTRY MCSetTrajectoryRate(HCTRLR hCtlr, int rate);
MCAPI_EXPORT int APIENTRY MCSetVectorVelocity(HCTRLR hCtlr, WORD axis, double velocity);
MCAPI_EXPORT void APIENTRY MCSetVelocity(HCTRLR hCtlr, WORD axis, double rate);
MCAPI_EXPORT int APIENTRY MCSetVelocityOverride(HCTRLR hCtlr, WORD axis, double override);
MCAPI_EXPORT void APIENTRY MCStop(HCTRLR hCtlr, WORD axis);
MCAPI_EXPORT int APIENTRY MCTranslateErrorEx(short nError, char *buffer, int length);
MCAPI_EXPORT void APIENTRY MCWait(HCTRLR hCtlr, double period);
MCAPI_EXPORT void APIENTRY MCWaitForDigitalIO(HCTRLR hCtlr, WORD channel, short state);
MCAPI_EXPORT int APIENTRY MCWaitForEdge(HCTRLR hCtlr, WORD axis, short state);
MCAPI_EXPORT int APIENTRY MCWaitForIndex(HCTRLR hCtlr, WORD axis);
MCAPI_EXPORT void APIENTRY MCWaitForPosition(HCTRLR hCtlr, WORD axis, double position);
MCAPI_EXPORT void APIENTRY MCWaitForRelative(HCTRLR hCtlr, WORD axis, double distance);
MCAPI_EXPORT void APIENTRY MCWaitForStop(HCTRLR hCtlr, WORD axis, double period);
MCAPI_EXPORT void APIENTRY MCWaitForTarget(HCTRLR hCtlr, WORD axis, double period);
MCAPI_EXPORT short APIENTRY pmccmd(HCTRLR hCtlr, short size, void *buffer);
MCAPI_EXPORT int APIENTRY pmccmdex(HCTRLR hCtlr, WORD axis, WORD command, void *argument, int type);
MCAPI_EXPORT int APIENTRY pmccmdrpyex(HCTRLR hCtlr, WORD axis, WORD cmd, void *arg, int arg_type, void *rpy, int rpy_type);
MCAPI_EXPORT short APIENTRY pmcgetc(HCTRLR hCtlr);
MCAPI_EXPORT void APIENTRY pmcgetram(HCTRLR hCtlr, WORD offset, void *buffer, short size);
MCAPI_EXPORT int APIENTRY pmcgetramex(HCTRLR hCtlr, DWORD offset, void *buffer, DWORD size);
MCAPI_EXPORT short APIENTRY pmcgets(HCTRLR hCtlr, char *buffer, short size);
MCAPI_EXPORT DWORD APIENTRY pmclock(HCTRLR hCtlr, DWORD wait_msec);
MCAPI_EXPORT int APIENTRY pmclookupvar(HCTRLR hCtlr, const char *varname, DWORD *address);
MCAPI_EXPORT short APIENTRY pmcputc(HCTRLR hCtlr, short character);
MCAPI_EXPORT void APIENTRY pmcputram(HCTRLR hCtlr, WORD offset, void *buffer, short size);
MCAPI_EXPORT int APIENTRY pmcputramex(HCTRLR hCtlr, DWORD offset, void *buffer, DWORD size);
MCAPI_EXPORT short APIENTRY pmcputs(HCTRLR hCtlr, const char *buffer);
MCAPI_EXPORT short APIENTRY pmcrdy(HCTRLR hCtlr);
MCAPI_EXPORT short APIENTRY pmcrpy(HCTRLR hCtlr, short size, void *buffer);
MCAPI_EXPORT int APIENTRY pmcrpyex(HCTRLR hCtlr, void *reply, int type);
MCAPI_EXPORT void APIENTRY pmcunlock(HCTRLR hCtlr);

#ifdef __cplusplus
}
#endif
#endif
