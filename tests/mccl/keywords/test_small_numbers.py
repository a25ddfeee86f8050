"""The least and the largest numbers that MCCL accepts.

They are those of registers, macros, tasks, texts, channels and limits.
"""

from __future__ import annotations

from tests.cases import cases
from tests.mccl.conftest import Runner


@cases(
    "program, output",
    [
        # 32 bits, two's complement.
        ("AL2147483647,TR0", ["2147483647"]),
        ("AL2147483648,TR0", ["-2147483648"]),
        ("AL-2147483648,TR0", ["-2147483648"]),
        ("AL-2147483649,TR0", ["2147483647"]),
        ("AL4294967295,TR0", ["-1"]),
        ("AL4294967296,TR0", ["0"]),
        ("AL-2147483648,AS1,TR0", ["2147483647"]),
        ("AL65536,AM65536,TR0", ["0"]),
        ("AL1,SL31,TR0", ["-2147483648"]),
        ("AL-2147483648,SR31,TR0", ["-1"]),
        ("AL2147483647,SR31,TR0", ["0"]),
        ("AL1,SL0,TR0,SR0,TR0", ["1", "1"]),
        ("AL1,SL32", ["?-1"]),
        ("AL1,SR32", ["?-1"]),
        ("AL-1,IS31,AL5,NO,TR0", ["5"]),
        ("AL2147483647,IS31,AL5,NO,TR0", ["2147483647"]),
        ("AL2147483647,IC31,AL5,NO,TR0", ["5"]),
        ("AL1,IS0,AL5,NO,TR0", ["5"]),
        ("AL1,IC0,AL5,NO,TR0", ["1"]),
        ("AL-2,IS0,AL5,NO,TR0", ["-2"]),
        ("AL-2,IC0,AL5,NO,TR0", ["5"]),
        ("IS32", ["?-1"]),
        ("IC32", ["?-1"]),
        ("IS-1", ["?-1"]),
        ("IC-1", ["?-1"]),
        ("AL1,AA1,TR0,IB3,JP1", ["2", "3"]),
        ("JP-1", ["?-1"]),
        # Quotients of integers are cut off towards zero.
        ("AL7,AD-2,TR0", ["-3"]),
        ("AL-7,AD2,TR0", ["-3"]),
        ("AL-7,AD-2,TR0", ["3"]),
        ("AL7,AD2,TR0", ["3"]),
        ("AL0,AD-3,TR0", ["0"]),
        ("AL6,AD-2,TR0", ["-3"]),
        ("AL-2147483648,AD-1,TR0", ["-2147483648"]),
        ("AL-7.0,AD2,TR0", ["-3.500000"]),
        ("AL7,AD0.0", ["?-1"]),
        # Bits of real numbers are those of their integer part.
        ("AL5.9,AN4,TR0", ["4"]),
        ("AL-5.9,AC,TR0", ["4"]),
        # Real numbers have six decimals, and end somewhere.
        ("AL0.0000005,TR0", ["0.000000"]),
        ("AL-0.0000001,TR0", ["0.000000"]),
        ("AL-0.000001,TR0", ["-0.000001"]),
        ("AL1000000000000000,TR0", ["-1530494976"]),
        ("AL1000000000000000.0,TR0", ["1000000000000000.000000"]),
        ("AL1000000000000001.0", ["?-1"]),
        ("AL-1000000000000001.0", ["?-1"]),
        ("AL1.0\nAM1000000000000000.0,RP18\nAM1000.0,TR1\nAM1000000000000000.0,TR1", ["0", "?-1"]),
        ("AL1000000000000000.0,AR10,AL0,AL@10,TR0", ["1000000000000000.000000"]),
        ("AL-1000000000000000.0,AR10,AL0,AL@10,TR0", ["-1000000000000000.000000"]),
        ("AL1000000000000000.0,AM2,AR10\nAL@10\nTR10", ["?-1", "2000000000000000.000000"]),
        ("AL1.0,AR10,SL@10,AL32,AR10\nSL@10", ["?-1"]),
        # Registers 0 to 255; 0 to 9 are a task's own.
        ("AL7,AR255,TR255", ["7"]),
        ("AR256", ["?-1"]),
        ("RA256", ["?-1"]),
        ("AL256,AR10,RA@10", ["?-1"]),
        ("MD1,AL7,AR9,AR10\nGT1,WA0.1,TR9,TR10", ["0", "7"]),
        # A sine is exactly 0 at multiples of 180 degrees alone, a tangent is exact there, too.
        ("AL180,AV2,TR0,AL-360,AV2,TR0,AL181,AV2,TR0", ["0.000000", "0.000000", "-0.017452"]),
        ("AL90,AV3,TR0,AL0,AV3,TR0,AL180,AV3,TR0", ["0.000000", "1.000000", "-1.000000"]),
        ("AL180,AV4,TR0,AL181,AV4,TR0,AL90,AV4", ["0.000000", "0.017455", "?-1"]),
        # A fraction is no number of a register, a macro or a channel.
        ("AL1.5,AR10,TR@10", ["?-1"]),
        ("TR1.5", ["?-1"]),
        ("CN33.5", ["?-1"]),
        # A word has a sign, a byte none.
        ('LU"SPEED",AR10,AL32767,1WL@10,1RW@10,TR0', ["32767"]),
        ('LU"SPEED",AR10,AL32768,1WL@10,1RW@10,TR0', ["-32768"]),
        ('LU"SPEED",AR10,AL65535,1WL@10,1RW@10,TR0,1RB@10,TR0', ["-1", "255"]),
        ('LU"SPEED",AR10,AL65536,1WL@10,1RW@10,TR0,1RB@10,TR0', ["0", "0"]),
        ('LU"SPEED",AR10,AL256,1WL@10,1RB@10,TR0', ["0"]),
        ('LU"SPEED",AR10,AL131071,1WL@10,AL0,1WW@10,1RL@10,TR0', ["65536"]),
        ('LU"SPEED",AR10,AL511,1WL@10,AL257,1WB@10,1RL@10,TR0', ["257"]),
        ('LU"SPEED",AR10,AL0,1WL@10,1RL@10,TR0', ["0"]),
    ],
)  # fmt: skip
def test_numbers_and_registers(program: str, output: list[str], mccl: Runner) -> None:
    assert mccl(program).output == output


@cases(
    "program, output",
    [
        # Macros 0 to 1000; calls are nested 100 deep.
        ("MD0,AL7\nMC0,TR0", ["7"]),
        ("MD1000,AL7\nMC1000,TR0", ["7"]),
        ("MD1001,AL7", ["?-5"]),
        ("MC-1", ["?-5"]),
        ("MJ1001", ["?-5"]),
        ("MD1,AA1,MC1\nMC1\nTR0", ["?-1", "100"]),
        ("MD1,AA1,IB100,MC1,NO\nMC1\nTR0", ["100"]),
        ("MD1,AA1,IB101,MC1,NO\nMC1\nTR0", ["?-1", "100"]),
        ("TM-1", []),
        ("TM-2", ["?-1"]),
        ("MD3,AL1\nMD2,AL2\nTM-1,TM3", ["MD2,AL2", "MD3,AL1", "MD3,AL1"]),
        # 32 background tasks.
        ("MD1,WA9\nGT1,RP31\nTR0", ["32"]),
        ("MD1,WA0.5\nGT1,RP32\nTR0", ["?-1", "32"]),
        ("MD1,WA0.1\nGT1,WA0.2,ET1", ["?-1"]),
        ("MD1,WA0.1\nGT1,WA0.05,ET1,GT1,TR0", ["2"]),
        # Commands of a line are numbered from 0, and the end is the number of commands.
        ("JP4,AL1,AL2,AL3", []),
        ("JP5,AL1,AL2,AL3", ["?-1"]),
        ("JR4,AL1,AL2,AL3", []),
        ("JR5,AL1,AL2,AL3", ["?-1"]),
        ("AL1,JR-2", ["?-1"]),
        ("AL0,AR10\nRA10,AA1,AR10,IB3,JR-4,NO,TR0", ["3"]),
        ("MD1,RA10,AA1,AR10,IB3,JP0,NO,TR0\nMC1", ["3"]),
        ("AL1,TR0,RP1", ["1", "1"]),
        ("AL1,TR0,RP-1", ["1", "?-3"]),
        ("AL-2,AR10,TR0,RP@10", ["-2", "?-3"]),
    ],
)  # fmt: skip
def test_macros_tasks_and_jumps(program: str, output: list[str], mccl: Runner) -> None:
    assert mccl(program).output == output


@cases(
    "program, output",
    [
        # A width of up to 80 characters, up to 20 decimals.
        ('AL5,FT"%80d"', [f"{5:80d}"]),
        ('AL5,FT"%81d"', ["?-1"]),
        ('AL5,FT"%080d"', [f"{5:080d}"]),
        ('AL5,FT"%100d"', ["?-1"]),
        ('AL5,FT"%.20d"', [f"{5:020d}"]),
        ('AL5,FT"%.21d"', ["?-1"]),
        ('AL1,AD4.0,FD"%.20f"', ["0.25000000000000000000"]),
        ('AL1,AD4.0,FD"%.21f"', ["?-1"]),
        ('AL1,AD4.0,FD"%.001f"', ["?-1"]),
        ('AL1,AD4.0,FD"%.f|%5.1f|%-8g|%+.0e"', ["0|  0.2|0.25    |+2e-01"]),
        ('AL-1,FT"%x|%d|% d"', ["ffffffff|-1|-1"]),
        ('AL5,FT"% d|%%|%d%%"', [" 5|%|5%"]),
        ('AL5.7,FT"%d"', ["5"]),
        ('AL5,FT"100%%"', ["100%"]),
        ('AL5,FT"%"', ["?-1"]),
        ('AL5,FT"%5"', ["?-1"]),
        ('AL5,FT"%f"', ["?-1"]),
        ('AL5,FD"%x"', ["?-1"]),
        ('OT"100%%"', ["100%%"]),
        ('OT"a\\\\b\\ta"', ["a\\b\ta"]),
        ('OT""', [""]),
    ],
)  # fmt: skip
def test_texts(program: str, output: list[str], mccl: Runner) -> None:
    assert mccl(program).output == output


@cases(
    "volts, percent",
    [("10", 100.0), ("12", 100.0), ("-10", -100.0), ("-12", -100.0), ("9.9", 99.0), ("-9.9", -99.0), ("0", 0.0),
     ("10.05", 100.0)],
)  # fmt: skip
def test_an_analogue_output_ends_at_ten_volts(volts: str, percent: float, mccl: Runner) -> None:
    assert mccl(f"AL{volts},OA1").controller.analogue_outputs[1] == percent


@cases("mode", [0, 1, 2, 4, 5, 6, 8, 9, 10, 128, 129, 138])
def test_modes_of_limits(mode: int, mccl: Runner) -> None:
    assert mccl(f"1LM{mode}").output == []


@cases("mode", [3, 7, 11, 12, 13, 14, 15, 16, 32, 64, 131, 140, 144, 256, -1])
def test_modes_of_limits_that_there_are_not(mode: int, mccl: Runner) -> None:
    assert mccl(f"1LM{mode}").output == ["?-1"]


@cases(
    "line, outputs",
    [
        ("CN32", ["?-1"]), ("CN33", []), ("CN48", []), ("CN49", ["?-1"]), ("CN0", ["?-1"]),
        ("CT255,CN255,TC255", ["255 1"]), ("CT256", ["?-1"]), ("CI33,CN33", ["?-1"]),
        ("CL33,CN33,TC33,CH33,TC33", ["33 1", "33 0"]),
        ("CL33,CF33,TC33,CH33,TC33", ["33 0", "33 1"]), ("CL1,TC1,CH1,TC1", ["01 1", "01 0"]),
        ("CT1,CI1,TC1", ["01 0"]), ("CN33,RT\nCN33,CT1,CL2\nRT\nTC33,CN1,TC2", ["33 0", "?-1"]),
    ],
)  # fmt: skip
def test_channels(line: str, outputs: list[str], mccl: Runner) -> None:
    """Channels 33 to 48 are outputs at power-up."""
    assert mccl(line).output == outputs


@cases(
    "units, output",
    [
        ("1US1000,1MN,1MR1.2345,1WS,1TP", ["01 1.235000"]),
        ("1US-1,1MN", ["?-1"]),
        ("1US0", ["?-1"]),
        ("1US1,1UO0,1MN,1MR1.5,1WS,1TP", ["01 2"]),
        ("1MN,1MR-1.5,1WS,1TP", ["01 -1"]),
        ("1MN,1MR-1.6,1WS,1TP", ["01 -2"]),
        ("1UO1,1MN,1MR1,1WS,1TP", ["01 0.000000"]),
        ("1UR2,1MN,1SV3,1VM,1GO,WA0.1,1TV,1ST", ["01 3.000000"]),
        ("1MN,1SV3.5,1VM,1GO,WA0.1,1TV,1ST", ["01 4"]),
        ("1MN,1SV3.4,1VM,1GO,WA0.1,1TV,1ST", ["01 3"]),
        ("UT0", ["?-1"]),
        ("UT2,1MN,1SV100,1MR1000,WA1,1TP,1ST", ["01 200"]),
    ],
)  # fmt: skip
def test_units(units: str, output: list[str], mccl: Runner) -> None:
    assert mccl(units).output == output


@cases(
    "line, output",
    [
        ("TE", ["0"]),
        ("1XX\nTE,TE", ["?1", "1", "1"]),
        ("WA-1\n1TP\nTE", ["?-1", "01 0", "-1"]),
        ("MC5\nRT\nTE", ["?-6", "0"]),
    ],
)
def test_the_last_error_is_told_until_a_reset(line: str, output: list[str], mccl: Runner) -> None:
    assert mccl(line).output == output


@cases(
    "program, message, hint",
    [
        ('AL5,FT"%s"', "%s is not a number format here", "such as %d, %6d or %08X"),
        ('AL5,FT"%f"', "%f is not a number format here", "such as %d, %6d or %08X"),
        ('AL5,FT"%"', "% is not a number format here", "such as %d, %6d or %08X"),
        ('AL5.0,FD"%d"', "%d is not a number format here", "such as %f, %8.3f or %g"),
    ],
)
def test_a_wrong_format_names_formats_that_fit(program: str, message: str, hint: str, mccl: Runner) -> None:
    (found,) = mccl(program).diagnostics
    assert (found.message.partition(" (")[0], found.hint) == (message, hint)


@cases(
    "program, message",
    [
        ("AL2,AV5", "there is no arc sine of 2"),
        ("AL-90,AV4", "there is no tangent of -90"),
        ("AL-4,AV8", "there is no square root of -4"),
        ("AL1000,AV9", "the result is too large for a register"),
    ],
)
def test_a_function_without_a_value_is_named(program: str, message: str, mccl: Runner) -> None:
    (found,) = mccl(program).diagnostics
    assert found.message.partition(" (")[0] == message
