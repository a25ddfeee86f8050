"""What `serve --log` writes of hosts and their lines."""

from __future__ import annotations

import pytest

from motionlang.hosts.serve.spy import Spy


@pytest.mark.parametrize(
    ("pieces", "lines"),
    [
        ([b"1TP\r"], ["1 < 1TP"]),
        ([b"1T", b"P\r\n2TP\n"], ["1 < 1TP", "1 < 2TP"]),
        ([b"1MR\x1b"], ["1 < 1MR\\x1b"]),
        ([b"\x05"], ["1 < \\x05"]),
        ([b"\r\n\n"], ["1 < "]),
        # A frame ends with its checksum behind ETX.
        ([b"\x0201\x03", b"2"], ["1 < \\x0201\\x032"]),
        ([b"\x06\x15"], ["1 < \\x06", "1 < \\x15"]),
        ([b"x" * 199], []),
        ([b"x" * 201, b"\r"], ["1 < " + "x" * 200, "1 < x"]),
        ([b"a'b\\\xe4\r"], ["1 < a'b\\\\\xe4"]),
    ],
)
def test_data_from_a_host_is_logged_by_line(pieces: list[bytes], lines: list[str]) -> None:
    found: list[str] = []
    spy = Spy(found.append)
    for each in pieces:
        spy.sent(1, each)
    assert [each.removesuffix("\n") for each in found] == lines


def test_answers_are_logged_without_prompts() -> None:
    """A remark ends the unfinished lines of its host."""
    found: list[str] = []
    spy = Spy(found.append)
    spy.answered(1, b"\n>")
    spy.answered(1, b"01 0\r\nP>")
    spy.answered(1, b"12>")
    spy.answered(2, b"x>")
    spy.answered(2, b"y")
    spy.sent(1, b">\r")
    spy.sent(1, b"half")
    spy.remark(1, "has left")
    assert found == ["1 > 01 0\n", "1 < >\n", "1 < half\n", "host 1 has left\n"]
    spy.remark(2, "has left")
    assert found[4:] == ["2 > x>y\n", "host 2 has left\n"]


def test_without_traffic_the_log_has_the_remarks() -> None:
    found: list[str] = []
    spy = Spy(found.append, traffic=False)
    spy.sent(1, b"1TP\r")
    spy.answered(1, b"01 0\r\n")
    spy.remark(1, "has left")
    assert found == ["host 1 has left\n"]
