"""The assumptions about MCCL that a machine file can settle.

Each choice, shown by its output.
"""

from __future__ import annotations

from tests.cases import cases
from tests.mccl.conftest import Runner

# Name, value, program, and the output with the default and with the value.
CHOICES: list[tuple[str, object, str, list[str], list[str]]] = [
    ("reply-form", "1 1234", "1TP,TC33", ["01 0", "33 0"], ["1 0", "33 0"]),
    ("reply-form", "01=1234", "1TP,TC33", ["01 0", "33 0"], ["01=0", "33=0"]),
    ("reply-form", "1234", "1TP,TC33", ["01 0", "33 0"], ["0", "0"]),
    ("channel-form", "ON", "CN33,TC33,TC34", ["33 1", "34 0"], ["33 ON", "34 OFF"]),
    ("no-breakpoint", "NONE", "1TB,1IP5,1TB", ["01 0", "01 5"], ["01 NONE", "01 5"]),
    ("hex-letters", "small", "HM,AL-17,TR0,AL171,TR0", ["FFFFFFEF", "AB"], ["ffffffef", "ab"]),
    ("error-told", "cleared", "1XX\nTE,TE", ["?1", "1", "1"], ["?1", "1", "0"]),
    # Every whole number is hexadecimal, positions and velocities, too; real numbers stay decimal.
    ("hex-letters", "small", "HM,1DH255,1TP,1TT,1TO,1TV,1TB,TE,1TX,1PR1,1DO1,1AH171,1AT,1TG",
     ["01 FF", "01 FF", "01 FF", "01 0", "01 0", "0", "01 0", "01 FF", "01 AB", "01 0.000000"],
     ["01 ff", "01 ff", "01 ff", "01 0", "01 0", "0", "01 0", "01 ff", "01 ab", "01 0.000000"]),
    ("hex-letters", "small", "1DH-1,HM,1TP,1US2,1MN,1TP,1XX\nTE,DM,1TP,TE", ["01 FFFFFFFF", "01 -0.500000", "?1",
     "1", "01 -0.500000", "1"], ["01 ffffffff", "01 -0.500000", "?1", "1", "01 -0.500000", "1"]),
    # The condition fails: 2, 1 or 3 commands are skipped. It holds: none is.
    ("skipped", 1, "AL0,IE1,AA1,AA2,AA4,TR0\nAL0,IE0,AA1,AA2,AA4,TR0", ["4", "7"], ["6", "7"]),
    ("skipped", 3, "AL0,IE1,AA1,AA2,AA4,TR0\nAL0,IE0,AA1,AA2,AA4,TR0", ["4", "7"], ["0", "7"]),
    ("jump-base", 1, "AL5,JP3,AL6,AL7,TR0", ["7"], ["7"]),
    ("jump-base", 1, "AL5,JP4,AL6,AL7,TR0", ["5"], ["7"]),
    ("jump-base", 1, "JP0", [], ["?-1"]),
    ("jump-relative", "next", "AL5,JR1,AL6,AL7,TR0", ["7"], ["7"]),
    ("jump-relative", "next", "AL5,JR2,AL6,AL7,TR0", ["7"], ["5"]),
    ("repeat-for-ever", "once", "AL1,AR20\nRA20,AA1,AR20,IB9,RP,NO,TR20", ["9"], ["3"]),
    # 0.05 s at 1000 counts/s are 45 counts; 1000 counts/s at 10000 counts/s2 take another 50.
    ("abort-rate", "DS", "1MN,1SV1000,1SA10000,1DS10000,1MR900,WA0.2,1AB,1WS,1TP", ["01 150"], ["01 200"]),
    ("quotient", "real", "AL7,AD2,TR0,AL-6,AD3,TR0", ["3", "-2"], ["3.500000", "-2.000000"]),
    ("overflow", "stays", "AL2147483647,AA1,TR0,AA0,TR0", ["-2147483648"] * 2, ["2147483647"] * 2),
    ("overflow", "stays", "AL-2147483648,AS1,TR0,AA1,TR0", ["2147483647", "-2147483648"],
     ["-2147483648", "-2147483647"]),
    ("overflow", "stays", "AL2147483646,AA1,TR0,AL-2147483647,AS1,TR0", ["2147483647", "-2147483648"],
     ["2147483647", "-2147483648"]),
    ("overflow", "stays", "AL3000000000,TR0", ["-1294967296"], ["2147483647"]),
    ("overflow", "stays", "AL-2147483648,AD-1,TR0", ["-2147483648"], ["2147483647"]),
    ("overflow", "stays", "AL-2147483648,AV0,TR0", ["-2147483648"], ["2147483647"]),
    ("overflow", "stays", "AL3000000000.0,AA1,TR0", ["3000000001.000000"], ["3000000001.000000"]),
    ("shift-right", "zeros", "AL-16,SR2,TR0,AL16,SR2,TR0", ["-4", "4"], ["1073741820", "4"]),
    ("shift-right", "zeros", "AL-1,SR0,TR0,SR31,TR0", ["-1", "-1"], ["-1", "1"]),
    ("angles", "radians", "AL1,AV5,TR0,AL1,AV7,TR0,AL0,AV2,TR0", ["90.000000", "45.000000", "0.000000"],
     ["1.570796", "0.785398", "0.000000"]),
    ("angles", "radians", "AL30,AV2,TR0,AL60,AV3,TR0,AL4,AV8,TR0", ["0.500000", "0.500000", "2.000000"],
     ["-0.988032", "-0.952413", "2.000000"]),
    ("code-parameter", -40, "JR9\nTE", ["?-1", "-1"], ["?-40", "-40"]),
    ("code-no-axis", -41, "FE\nTE", ["?-14", "-14"], ["?-41", "-41"]),
    ("code-not-assigned", -42, "9MA5\nTE", ["?-15", "-15"], ["?-42", "-42"]),
    ("gain-default", 1.5, "1TG", ["01 0.000000"], ["01 1.500000"]),
    ("integral-default", 1.5, "1TI", ["01 0.000000"], ["01 1.500000"]),
    ("derivative-default", 1.5, "1TD", ["01 0.000000"], ["01 1.500000"]),
    ("integral-limit-default", 1.5, "1TL", ["01 0.000000"], ["01 1.500000"]),
    ("velocity-gain-default", 1.5, "1TK", ["01 0.000000"], ["01 1.500000"]),
    ("torque-default", 1.5, "1TQ,1SQ2,1TQ,1RT,1TQ", ["01 10.000000", "01 2.000000", "01 10.000000"],
     ["01 1.500000", "01 2.000000", "01 1.500000"]),
]  # fmt: skip


@cases("name, value, program, usual, other", CHOICES)
def test_a_choice_changes_the_output(
    name: str, value: object, program: str, usual: list[str], other: list[str], mccl: Runner
) -> None:
    assert mccl(program).output == usual
    assert mccl(program, machine={f"assumptions.mccl.{name}": value}).output == other


def test_a_jump_out_of_the_line_is_reported_as_the_program_counts(mccl: Runner) -> None:
    for base, last in ((0, 2), (1, 3)):
        (found,) = mccl("AL5,JP9,TR0", machine={"assumptions.mccl.jump-base": base}).diagnostics
        assert found.message.startswith("there is no command 9 here")
        assert found.hint == f"they are numbered {base} to {last}"
