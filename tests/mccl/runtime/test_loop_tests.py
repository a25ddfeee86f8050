"""The tests that a polling loop makes on each value it reads."""

from __future__ import annotations

from motionlang.mccl.resolve.line import line_of
from motionlang.mccl.runtime.loop_tests import tests_of as find_tests
from tests.cases import cases


@cases(
    "text, governs, expected",
    [
        ("1RL@20,IB300,JR-2", 2, {0: ["IB300"]}),
        ("NO,1RL@20,IS3,NO,IC4,JR-5", 2, {1: ["IS3", "IC4"]}),
        ("RA5,IE3,IG7,IU8,RP", 2, {0: ["IE3", "IG7", "IU8"]}),
        ("1RD@20,IB2.5,RP", 2, {0: ["IB2.5"]}),
        ("1RB@20,IS3,RP", 2, {0: ["IS3"]}),
        ("1RW@20,IS3,RP", 2, {0: ["IS3"]}),
        ("GA3,IB2,RP", 2, {0: ["IB2"]}),
        ("IN5,NO,NO,AL1,IB2,CN33,RP", 2, {3: ["IB2"]}),
        ("1RL@20,RP", 2, {0: []}),
        # A second value ends the use of the first one, unless a condition or a jump may leave it out.
        ("1RL@20,IB300,NO,NO,1RV@21,IS3,RP", 2, {0: ["IB300"], 4: ["IS3"]}),
        ("1RL@20,IB300,NO,1RV@21,IS3,RP", 2, {0: None, 3: ["IS3"]}),
        ("1RL@20,IB300,NO,1RV@21,IS3,RP", 1, {0: ["IB300"], 3: ["IS3"]}),
        ("1RL@20,IB300,NO,NO,1RV@21,IS3,RP", 3, {0: None, 4: ["IS3"]}),
        ("1RL@20,IN5,NO,1RV@21,IS3,RP", 2, {0: None, 3: ["IS3"]}),
        ("1RL@20,JR2,NO,NO,1RV@21,IS3,RP", 2, {0: None, 4: ["IS3"]}),
        ("1RL@20,IB300,NO,NO,1RV@21,IS3,JR-6", 2, {0: ["IB300"], 4: ["IS3"]}),
        # Any other use of the value.
        ("1RL@20,AA5,IB300,RP", 2, {0: None}),
        ("1RL@20,AR5,IB300,RP", 2, {0: None}),
        ("1RL@20,IB@0,RP", 2, {0: None}),
        ("1RL@20,IB@5,RP", 2, {0: ["IB@5"]}),
        ('LU"STATUS",1RL@0,IC3,RP', 2, {0: None, 1: ["IC3"]}),
        # The low bits of a value pass a number each time they wrap.
        ("1RB@20,IB3,RP", 2, {0: None}),
        ("1RW@20,IS3,IE3,RP", 2, {0: None}),
        # The accumulator of the iteration before, or an effect.
        ("IB300,1RL@20,RP", 2, None),
        ("1RL@0,IB300,RP", 2, None),
        ("RA0,IB300,RP", 2, None),
        ("RA@0,IB300,RP", 2, None),
        ("AA1,IB300,RP", 2, None),
        ("NO,NO,RP", 2, None),
        ("IN5,AL1,IB2,RP", 2, None),
        ("1RL@20,IB300,1MR5,RP", 2, None),
        ("1RL@20,IB300,WA1,RP", 2, None),
        ("1RL@20,IB300,BK,RP", 2, None),
        ("1RL@20,IB300,MC1,RP", 2, None),
        ("1RL@20,IB300,MJ1", 2, {0: None}),
    ],
)
def test_the_tests_of_a_loop(text: str, governs: int, expected: dict[int, list[str] | None] | None) -> None:
    """By the index of the command that reads.

    None if the value is used for more than tests.
    """
    line = line_of(text)
    assert line is not None
    found = find_tests(line.commands, governs)
    assert (found is None) is (expected is None)
    texts = {
        k: None if tests is None else [each.text for each in tests] for k, tests in (found or {}).items()
    }
    assert texts == (expected or {})
