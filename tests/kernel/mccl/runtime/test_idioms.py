"""Two idioms remembered from PMC's manuals work with "skip two" and JR.

JR counts from its own position.
"""

from __future__ import annotations

from tests.mccl_runs import Runner

POLL = '1LU"STATUS",1RL@0,IC25,JR-3,NO'
RUN = '1VM,1DI0,1GO,1LU"STATUS",1RL@0,IS23,MJ11,NO,IS16,MJ12,NO,JR-8'
MACROS = "MD11,1ST,1WS,1TP,AL11,TR0\nMD12,1AB,1TP,AL12,TR0\n1MN,1SV10000,1SA100000,1DS100000\n"


def test_poll_until_a_bit_sets(mccl: Runner) -> None:
    """Bit 25 is the auxiliary input, which is channel 201 for axis 1."""
    result = mccl(f"{POLL},1TP\nTR0", machine={"input": [{"channel": 201, "at": 2.5}]})
    assert result.output[0] == "01 0"
    assert int(result.output[1]) & 1 << 25
    assert 2.5 <= result.time < 2.501


def test_the_same_when_the_bit_is_set_already(mccl: Runner) -> None:
    result = mccl(f"WA0.1,{POLL},1TP", machine={"input": [{"channel": 201, "at": 0.0}]})
    assert result.output == ["01 0"]
    assert result.time < 0.101


def test_run_until_the_home_switch(mccl: Runner) -> None:
    """Bit 23 is the switch; from 10000 counts/s at 100000 counts/s² a stop takes 500.

    The loop detects the switch half an iteration late at most.
    """
    result = mccl(MACROS + RUN, machine={"axis.1.home_switch": [20000.0, 20500.0]})
    position, macro = result.output
    assert 20500 <= int(position.split()[1]) <= 20502
    assert macro == "11"


def test_run_until_the_other_bit(mccl: Runner) -> None:
    """Bit 16 is set by LN2, which a background task executes after a second."""
    text = "MD1,WA1,1LN2\n" + MACROS + "GT1\n" + RUN
    result = mccl(text)
    position, macro = result.output
    assert 9400 <= int(position.split()[1]) <= 9600
    assert macro == "12"


def test_the_input_bits_are_live(mccl: Runner) -> None:
    """Bits 22 (index), 25 (auxiliary), 28 and 29 (user inputs) follow their inputs."""
    machine = {
        "axis.1.index_every": 1000.0,
        "input": [{"channel": channel, "at": 1.0, "for": 1.0} for channel in (201, 217, 233)],
    }
    bits = (1 << 25) | (1 << 28) | (1 << 29)
    result = mccl("1TS,WA1.5,1TS,WA1,1TS,1MN,1MR500,1WS,1TS,1MR500,1WS,1TS", machine=machine)
    words = [int(line.split()[1]) for line in result.output]
    assert [word & bits for word in words] == [0, bits, 0, 0, 0]
    assert [bool(word & 1 << 22) for word in words] == [True, True, True, False, True]


def test_a_loop_that_waits_for_the_index_input_is_skipped_to_it(mccl: Runner) -> None:
    text = '1MN,1SV10,1SA1000,1DS1000,1MR100000,WA1\nLU"STATUS",AR10\n1RL@10,IC22,JR-2,NO,1TP'
    result = mccl(text, machine={"axis.1.index_every": 50_000.0}, until=6000.0)
    assert result.output == ["01 50000"]


def test_the_inputs_of_an_axis_beyond_the_fourth(mccl: Runner) -> None:
    """Channels 49 to 52 are home, limit +, limit - and amplifier fault of axis 5."""
    machine = {"input": [{"channel": channel, "at": 0.0} for channel in (49, 50, 51, 52)]}
    (line,) = mccl("WA0.1,5TS", machine=machine).output
    bits = 1 << 23 | 1 << 24 | 1 << 26 | 1 << 27
    assert int(line.split()[1]) & bits == bits
