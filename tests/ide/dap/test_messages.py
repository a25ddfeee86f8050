"""Messages and arguments of requests, as they are read and refused."""

from __future__ import annotations

import io

import pytest

from motionlang.ide.dap.arguments import Arguments, RequestRefused
from motionlang.ide.dap.framing import MAX_BODY, MAX_HEADER, WrongMessage, read, written

# --------------------------------------------------------------------------------------------------- arguments


@pytest.mark.parametrize(
    ("kind", "value", "wanted"),
    [
        ("text", "x", "x"),
        ("text", 5, "a must be a text"),
        ("text", None, "a must be a text"),
        ("number", -7, -7),
        ("number", 2**53 - 1, 2**53 - 1),
        ("number", 2**53, "a must be a whole number"),
        ("number", -(2**53), "a must be a whole number"),
        ("number", True, "a must be a whole number"),
        ("number", 1.0, "a must be a whole number"),
        ("seconds", 0, 0.0),
        ("seconds", 2.5, 2.5),
        ("seconds", None, None),
        ("seconds", -0.5, "a must be a time in seconds"),
        ("seconds", 1e9, "a must be a time in seconds"),
        ("seconds", True, "a must be a time in seconds"),
        ("flag", True, True),
        ("flag", None, False),
        ("flag", 1, "a must be true or false"),
        ("objects", None, []),
        ("objects", [1], "a must be a list of objects"),
        ("objects", {}, "a must be a list of objects"),
        ("texts", None, []),
        ("texts", "x", ["x"]),
        ("texts", ["x", "y"], ["x", "y"]),
        ("texts", ["x", 1], "a must be a list of texts"),
        ("texts", 1, "a must be a list of texts"),
        ("items", None, {}),
        ("items", {"x": 1, "y": "z"}, {"x": 1, "y": "z"}),
        ("items", {"x": True}, "the values of a must be numbers or texts"),
        ("items", {"x": []}, "the values of a must be numbers or texts"),
        ("items", [], "a must be an object"),
    ],
)
def test_an_argument(kind: str, value: object, wanted: object) -> None:
    arguments = Arguments({"a": value})
    try:
        found = getattr(arguments, kind)("a")
    except RequestRefused as refused:
        found = str(refused)
    assert found == wanted


def test_arguments_that_are_missing() -> None:
    none = Arguments(None)
    assert (none.text("a", "x"), none.number("a", 7), none.seconds("a")) == ("x", 7, None)
    assert none.flag("a", True) is True
    with pytest.raises(RequestRefused, match="arguments must be an object"):
        Arguments([])


# --------------------------------------------------------------------------------------------------- messages


def framed(*parts: bytes) -> io.BytesIO:
    return io.BytesIO(b"".join(parts))


def test_messages_one_after_another() -> None:
    """The header has any letter case and further fields."""
    stream = framed(
        written({"a": "ä"}),
        b"\r\n\n",
        b"content-LENGTH : 2 \r\nContent-Type: x\r\n\r\n{}",
        b"Content-Length: 5\r\n\r\n{}",
    )
    assert [read(stream) for _ in range(4)] == [{"a": "ä"}, {}, None, None]
    assert written({"a": "ä"}) == b'Content-Length: 11\r\n\r\n{"a": "\xc3\xa4"}'


@pytest.mark.parametrize(
    ("data", "message", "is_fatal"),
    [
        (b"Content-Length: 2\r\n\r\n[]", "the message is not an object", False),
        (b"Content-Length: 1\r\n\r\n{", "the message is not JSON in UTF-8", False),
        (b"Content-Length: 1\r\n\r\n\xff", "the message is not JSON in UTF-8", False),
        (b"Content-Length: x\r\n\r\n", "the message may have up to 67108864 bytes", True),
        (
            b"Content-Length: %d\r\n\r\n" % (MAX_BODY + 1),
            f"the message may have up to {MAX_BODY} bytes",
            True,
        ),
        (b"Other: 1\r\n\r\n", "the header has no Content-Length", True),
        (b"x" * MAX_HEADER + b"\n", "the header is too long", True),
        (b"a: b\r\n" * 2000, "the header is too long", True),
        (b"no line end", "the header is too long", True),
    ],
)
def test_a_message_that_cannot_be_read(data: bytes, message: str, is_fatal: bool) -> None:
    """The stream can go on after a body that is no message."""
    with pytest.raises(WrongMessage) as caught:
        read(framed(data))
    assert (str(caught.value), caught.value.is_fatal) == (message, is_fatal)


class Narrow(io.BytesIO):
    """A stream on which at most 3 bytes of a message arrive at a time."""

    def read(self, size: int | None = -1, /) -> bytes:
        assert size is not None
        return super().read(min(size, 3))


def test_messages_that_arrive_in_several_packets() -> None:
    stream = Narrow(written({"a": "bcdef"}) + written({"g": 1}))
    assert [read(stream) for _ in range(3)] == [{"a": "bcdef"}, {"g": 1}, None]


def test_a_body_of_the_largest_size_is_read() -> None:
    """The stream ends before it."""
    assert read(framed(b"Content-Length: %d\r\n\r\n{}" % MAX_BODY)) is None


def test_a_header_of_the_largest_size() -> None:
    field = b"a: " + b"b" * (8192 - 3 - 2 - 19 - 2) + b"\r\n"
    head = b"Content-Length: 2\r\n"
    assert read(framed(field, head, b"\r\n{}")) == {}
    with pytest.raises(WrongMessage):
        read(framed(b"b", field, head, b"\r\n{}"))


def test_numbers_that_json_does_not_have_are_no_message() -> None:
    with pytest.raises(ValueError, match="not JSON compliant"):
        written({"a": float("nan")})
