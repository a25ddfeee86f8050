"""MCAP files, as the library of the format reads them."""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np
import pytest

from motionlang.commands.trace.export import write_trace
from motionlang.kernel import Source, run
from tests.commands.trace.test_vcd import switched
from tests.views.runs import pick

reader = pytest.importorskip("mcap.reader")


def messages(path: Path) -> dict[str, list[tuple[int, dict[str, object]]]]:
    """Return times (ns) and contents of all messages, by topic."""
    found: dict[str, list[tuple[int, dict[str, object]]]] = {}
    last = 0
    with path.open("rb") as file:
        for schema, channel, message in reader.make_reader(file).iter_messages():
            assert (schema.encoding, channel.message_encoding) == ("jsonschema", "json")
            assert message.log_time >= last
            last = message.log_time
            found.setdefault(channel.topic, []).append((message.log_time, json.loads(message.data)))
    return found


def test_every_sample_is_in_it(tmp_path: Path) -> None:
    run = pick()
    write_trace(run.trace, str(tmp_path / "x.mcap"), 100.0)
    found = messages(tmp_path / "x.mcap")
    samples = run.trace.sample(100.0)
    for axis in run.trace.axes:
        times, rows = zip(*found[f"/axis{axis}"], strict=True)
        assert list(times) == np.rint(samples.time * 1e9).astype(np.int64).tolist()
        for quantity, name in (("position", "position_uu"), ("velocity", "velocity_uu_per_s")):
            assert [row[name] for row in rows] == pytest.approx(samples.get(axis, quantity).tolist())


def test_the_program_and_the_channels_are_in_it(tmp_path: Path) -> None:
    write_trace(pick().trace, str(tmp_path / "x.mcap"), 10.0)
    (time, first), *others = messages(tmp_path / "x.mcap")["/program"]
    assert (time, first) == (0, {"axis": 0, "line": 5, "command": "MOVER", "state": "accel"})
    assert {row["state"] for _, row in others} >= {"slew", "decel", "end"}
    write_trace(switched().trace, str(tmp_path / "x.mcap"), 10.0)
    outputs = messages(tmp_path / "x.mcap")["/outputs/out1"]
    assert outputs == [(0, {"value": 0.0}), (150000001, {"value": 1.0}), (600000000, {"value": 0.0})]


def test_the_same_run_gives_the_same_bytes(tmp_path: Path) -> None:
    for name in ("one.mcap", "two.mcap"):
        write_trace(pick().trace, str(tmp_path / name), 50.0)
    assert (tmp_path / "one.mcap").read_bytes() == (tmp_path / "two.mcap").read_bytes()


def test_events_are_a_topic(tmp_path: Path) -> None:
    jumping = Source("jump.mnt", "SPEED(0) = 50 : JOG(0) = 50\nWAIT(1000)\nCANCEL(0)\n")
    write_trace(run(jumping).trace, str(tmp_path / "x.mcap"), 10.0)
    found = messages(tmp_path / "x.mcap")["/events"]
    assert [(row["kind"], row["axis"], row["value"]) for _, row in found][-1] == (
        "velocity jump",
        0,
        pytest.approx(50.0),
    )
