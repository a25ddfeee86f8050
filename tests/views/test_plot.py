"""Pictures: reproducible bytes, all texts in position, no files left open."""

from __future__ import annotations

import re
from collections.abc import Mapping
from pathlib import Path
from types import MappingProxyType

import numpy as np
import pytest

pytest.importorskip("matplotlib")

from matplotlib.figure import Figure
from matplotlib.text import Text

from motionlang.execution import run
from motionlang.result import Run
from motionlang.servo import Loop, simulate
from motionlang.servo.settings import make_plant
from motionlang.servo.trace import ServoTrace
from motionlang.source import Source
from motionlang.views import plot
from motionlang.views.plot import write_plot
from motionlang.views.plot_panel import _ends_high
from motionlang.views.window import Window
from tests.views.runs import ballscrew, ended, new_run, pick, shift
from tests.views.test_vcd import switched

NO_SERVOS: Mapping[int, ServoTrace] = MappingProxyType({})


@pytest.fixture
def texts(monkeypatch: pytest.MonkeyPatch) -> None:
    """Let the SVG contain texts as text instead of outlines."""
    monkeypatch.setitem(plot.STYLE, "svg.fonttype", "none")


def drawn(run: Run, folder: Path, servos: Mapping[int, ServoTrace] = NO_SERVOS) -> list[str]:
    write_plot(run, str(folder / "x.svg"), servos)
    return re.findall(r"<text[^>]*>([^<]*)</text>", (folder / "x.svg").read_text(encoding="utf-8"))


@pytest.fixture
def unrendered_texts(monkeypatch: pytest.MonkeyPatch) -> list[str]:
    """Return the visible texts of the pictures that a test draws; no image is written."""
    found: list[str] = []

    def save(figure: Figure, *arguments: object, **options: object) -> None:
        found.extend(each.get_text() for each in figure.findobj(Text) if each.get_visible())

    monkeypatch.setattr(Figure, "savefig", save)
    return found


@pytest.fixture(scope="module")
def of_ballscrew(tmp_path_factory: pytest.TempPathFactory) -> list[str]:
    """Return the texts in the picture of AN00115's exercise."""
    return drawn_once(ballscrew(), tmp_path_factory)


@pytest.fixture(scope="module")
def of_pick(tmp_path_factory: pytest.TempPathFactory) -> list[str]:
    """Return the texts in the picture of three axes."""
    return drawn_once(pick(), tmp_path_factory)


def drawn_once(run: Run, folders: pytest.TempPathFactory) -> list[str]:
    with pytest.MonkeyPatch.context() as patch:
        patch.setitem(plot.STYLE, "svg.fonttype", "none")
        return drawn(run, folders.mktemp("drawn"))


def test_the_ballscrew_exercise_says_what_it_shows(of_ballscrew: list[str]) -> None:
    for text in ("ballscrew.mnt", "Mint  ·  ended after 1.00005 s", "MOVER · line 5", "time (s)",
                 "peak 250 uu/s", "peak 1250 uu/s²", "accel", "slew", "decel"):  # fmt: skip
        assert text in of_ballscrew
    assert "stop" not in of_ballscrew


def test_every_axis_has_its_panels_and_every_move_its_line(of_pick: list[str]) -> None:
    assert [text for text in of_pick if text.startswith("axis ")] == ["axis 0", "axis 1", "axis 2"]
    assert [text for text in of_pick if " · line " in text] == [
        "MOVER · line 5", "MOVEA · line 12", "MOVER · line 6", "JOG · line 14", "MOVER · line 8"]  # fmt: skip
    assert "stop" in of_pick


def test_jerk_is_drawn_where_acceleration_does_not_only_jump(
    of_ballscrew: list[str], of_pick: list[str]
) -> None:
    assert "jerk" not in of_ballscrew
    assert [of_pick.count(name) for name in ("acceleration", "jerk")] == [3, 2]


@pytest.mark.usefixtures("texts")
def test_channels_are_lanes_below_the_axes(tmp_path: Path) -> None:
    found = drawn(switched(), tmp_path)
    assert [text for text in found if text in ("ain0", "in3", "in12", "out1", "channels")] == [
        "ain0", "channels", "in3", "in12", "out1"]  # fmt: skip


def test_what_is_not_drawn_is_reported(unrendered_texts: list[str], tmp_path: Path) -> None:
    run, controller = new_run(axes=12)
    for axis in range(11):
        controller.move_by(axis, 100.0)
    controller.clock.advance(0.5)
    for channel in range(30):
        controller.outputs[channel] = 1
    controller.clock.advance(1.0)
    write_plot(ended(run), str(tmp_path / "x.svg"))
    assert any(
        text.endswith("3 more axes moved but are not drawn  ·  6 more channels changed but are not drawn")
        for text in unrendered_texts
    )


@pytest.mark.usefixtures("texts")
def test_a_servo_adds_its_error_and_its_output(tmp_path: Path) -> None:
    run = ballscrew()
    loop = Loop(proportional=0.05, derivative=0.5, dac_bits=12)
    servo = simulate(run.controller.axes[0], loop, make_plant({}), until=run.time)
    found = drawn(run, tmp_path, {0: servo})
    for text in ("motor", "demand", "following error", "output", "(DAC steps)"):
        assert text in found
    peak = abs(servo.error).max() / 1200.0
    assert f"peak {peak:.6g} uu" in found


def test_many_moves_are_neither_named_nor_shaded(unrendered_texts: list[str], tmp_path: Path) -> None:
    write_plot(shift(900), str(tmp_path / "x.svg"))
    assert "time (min)" in unrendered_texts
    assert not any("line" in text or text in ("accel", "slew", "decel") for text in unrendered_texts)


@pytest.mark.usefixtures("texts")
def test_a_name_with_any_letters_in_it(tmp_path: Path) -> None:
    run, controller = new_run("$x^{$\x1b漢.mnt")
    controller.move_by(0, 10.0, "$M_{", 1)
    controller.clock.advance(1.0)
    found = drawn(ended(run), tmp_path)
    assert "$x^{$␛漢.mnt" in found


def test_a_run_without_motion_or_time_is_drawn_too(tmp_path: Path) -> None:
    run, _ = new_run("hello.mnt")
    write_plot(ended(run), str(tmp_path / "x.png"))
    assert (tmp_path / "x.png").read_bytes().startswith(b"\x89PNG")


@pytest.mark.parametrize("suffix", [".png", ".svg"])
def test_the_same_run_gives_the_same_bytes(tmp_path: Path, suffix: str) -> None:
    for name in ("one", "two"):
        write_plot(ballscrew(), str(tmp_path / f"{name}{suffix}"))
    assert (tmp_path / f"one{suffix}").read_bytes() == (tmp_path / f"two{suffix}").read_bytes()


@pytest.mark.parametrize(
    ("end", "high"), [([0.0, 3.0, 10.0], True), ([0.0, 10.0, 1.0], False), ([0.0, -3.0, -10.0], False)]
)
def test_the_legend_lies_where_the_curves_do_not_end(end: list[float], high: bool) -> None:
    assert _ends_high([np.array(end), np.zeros(3)]) is high


def test_a_missing_folder_is_reported_with_the_requested_file(tmp_path: Path) -> None:
    path = str(tmp_path / "nowhere" / "x.png")
    with pytest.raises(FileNotFoundError) as caught:
        write_plot(ballscrew(), path)
    assert caught.value.filename == path


@pytest.mark.usefixtures("texts")
def test_a_window_of_a_run_has_the_peaks_of_that_window(tmp_path: Path) -> None:
    """A ramp of 1250 mm/s² reaches 125 mm/s after a tenth of a second.

    The name of the move stays visible.
    """
    write_plot(ballscrew(), str(tmp_path / "x.svg"), window=Window(0.05, 0.10005))
    found = re.findall(r"<text[^>]*>([^<]*)</text>", (tmp_path / "x.svg").read_text(encoding="utf-8"))
    assert "peak 125 uu/s" in found
    assert "MOVER · line 5" in found


@pytest.mark.usefixtures("texts")
@pytest.mark.parametrize("axes", [(0, 1), (0, 1, 2)])
@pytest.mark.slow
def test_a_path_is_drawn_in_the_colour_of_its_speed(tmp_path: Path, axes: tuple[int, ...]) -> None:
    write_plot(pick(), str(tmp_path / "x.svg"), window=Window(path=axes))
    found = re.findall(r"<text[^>]*>([^<]*)</text>", (tmp_path / "x.svg").read_text(encoding="utf-8"))
    assert any(text.startswith("speed (uu/s), at most ") for text in found)
    assert all(f"axis {axis} (uu)" in found for axis in axes)


@pytest.mark.usefixtures("texts")
def test_a_velocity_jump_is_marked(tmp_path: Path, of_pick: list[str]) -> None:
    jumping = Source("jump.mnt", "SPEED(0) = 50 : JOG(0) = 50\nWAIT(1000)\nCANCEL(0)\nWAIT(500)\n")
    assert any("velocity jump" in text for text in drawn(run(jumping), tmp_path))
    assert not any("velocity jump" in text for text in of_pick)
