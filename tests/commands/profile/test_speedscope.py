"""Check `--profile-to x.speedscope.json` against the documented file format.

The schema is https://www.speedscope.app/file-format-schema.json; the rules that it does not have are those of
speedscope's importer.
"""

from __future__ import annotations

import json
from collections.abc import Iterator
from copy import deepcopy
from math import fsum, isfinite
from pathlib import Path
from typing import Any

import pytest

from motionlang.cli import main
from motionlang.kernel import run

ROOT = Path(__file__).parents[3]
Row = dict[str, Any]

SCHEMA = "https://www.speedscope.app/file-format-schema.json"
UNITS = ("none", "nanoseconds", "microseconds", "milliseconds", "seconds", "bytes")
# The fields of each object, the optional ones with a "?".
FILE = {
    "$schema": str,
    "shared": dict,
    "profiles": list,
    "name?": str,
    "exporter?": str,
    "activeProfileIndex?": int,
}
FRAME = {"name": str, "file?": str, "line?": int, "col?": int}
# The type of profile that is written, of two.
SAMPLED = {"type": str, "name": str, "unit": str, "startValue": float, "endValue": float, "samples": list,
           "weights": list}  # fmt: skip

# One sub that calls another, a task alongside; paths; waits of MCCL.
PROGRAMS = ("mint/tray-loader.mnt", "mint/palletiser.mnt", "mint/contour-glue.mnt", "mccl/contour-arcs.mcl")


def problems(file: Row) -> Iterator[str]:
    """Yield the errors of a document."""
    yield from _fields("the file", file, FILE)
    if file.get("$schema") != SCHEMA:
        yield "it is not told as one of speedscope"
    frames = file["shared"]["frames"]
    for frame in frames:
        yield from _fields("a frame", frame, FRAME)
    if not file["profiles"]:
        yield "there is no profile"
    for profile in file["profiles"]:
        yield from _fields("a profile", profile, SAMPLED)
        if profile["type"] != "sampled":
            yield f"it is {profile['type']}"
        if profile["unit"] not in UNITS:
            yield f"{profile['unit']} is no unit"
        if profile["endValue"] < profile["startValue"]:
            yield "it ends before it begins"
        yield from _sampled(profile, len(frames))


def _fields(what: str, row: Row, fields: dict[str, type]) -> Iterator[str]:
    known = {name.removesuffix("?"): kind for name, kind in fields.items()}
    for name in row.keys() - known.keys():
        yield f"{what} has a {name}"
    for name, kind in known.items():
        if name not in row:
            if f"{name}?" not in fields:
                yield f"{what} has no {name}"
        elif not isinstance(row[name], (int, float) if kind is float else kind):
            yield f"the {name} of {what} is no {kind.__name__}"


def _sampled(profile: Row, frames: int) -> Iterator[str]:
    samples, weights = profile["samples"], profile["weights"]
    if len(samples) != len(weights):
        yield "not every sample has a weight"
    if not all(0 <= each < frames for sample in samples for each in sample):
        yield "a stack has a frame that there is not"
    if not all(isfinite(each) and each >= 0.0 for each in weights):
        yield "a weight is negative"
    whole = profile["endValue"] - profile["startValue"]
    if abs(fsum(weights) - whole) > 1e-9 * max(whole, 1.0):
        yield "the weights do not add up to the profile"


@pytest.fixture
def document(request: pytest.FixtureRequest, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> Row:
    path = tmp_path / "x.speedscope.json"
    program = ROOT / "scripts" / getattr(request, "param", PROGRAMS[0])
    main(["profile", str(program), "--format", "none", "--to", str(path)])
    capsys.readouterr()
    found: Row = json.loads(path.read_text(encoding="utf-8"))
    return found


@pytest.mark.parametrize("document", PROGRAMS, indirect=True)
def test_speedscope_opens_it(document: Row) -> None:
    assert list(problems(document)) == []
    (profile,) = document["profiles"]
    assert profile["unit"] == "seconds"
    name = next(each for each in PROGRAMS if each.endswith(document["name"].rpartition("/")[2]))
    assert profile["endValue"] == pytest.approx(run(ROOT / "scripts" / name).time)
    # A line is a frame of its own, and is in the file that the frame names.
    text = (ROOT / "scripts" / name).read_text(encoding="utf-8").splitlines()
    lines = [frame for frame in document["shared"]["frames"] if "line" in frame]
    assert lines
    for frame in lines:
        assert frame["name"] == f"line {frame['line']}: {text[frame['line'] - 1].strip()[:60]}"


# Documents that the check of this page must reject, by the change that makes them.
BROKEN = {
    "the file has no $schema": lambda file: file.pop("$schema"),
    "it is not told as one of speedscope": lambda file: file.update({"$schema": "x"}),
    "the file has a version": lambda file: file.update(version="0.1"),
    "there is no profile": lambda file: file["profiles"].clear(),
    "a frame has no name": lambda file: file["shared"]["frames"][0].pop("name"),
    "the line of a frame is no int": lambda file: file["shared"]["frames"][0].update(line="3"),
    "it is evented": lambda file: file["profiles"][0].update(type="evented"),
    "seconds? is no unit": lambda file: file["profiles"][0].update(unit="seconds?"),
    "it ends before it begins": lambda file: file["profiles"][0].update(startValue=1e9),
    "not every sample has a weight": lambda file: file["profiles"][0]["weights"].pop(),
    "a stack has a frame that there is not": lambda file: file["profiles"][0]["samples"][0].append(10_000),
    "a weight is negative": lambda file: file["profiles"][0]["weights"].__setitem__(0, -1.0),
    "the weights do not add up to the profile": lambda file: file["profiles"][0]["weights"].__setitem__(
        0, 9.0
    ),
}


@pytest.mark.parametrize("wrong", BROKEN)
def test_what_it_would_not_open_is_reported(document: Row, wrong: str) -> None:
    broken = deepcopy(document)
    BROKEN[wrong](broken)
    assert wrong in list(problems(broken))
