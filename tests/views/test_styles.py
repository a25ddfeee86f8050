"""Styles of all figures: sizes of type and lines, grids, ticks, frames, legends.

The golden file lists each style of a figure once, for the version of matplotlib in its first line; other versions have
other defaults. `--update` rewrites it. The data of figures, and their texts and colours, are in the digests of
`tests/generated`.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from functools import partial
from pathlib import Path
from typing import Any

import pytest

pytest.importorskip("matplotlib")

import matplotlib
from matplotlib.figure import Figure

from motionlang.cli import main
from motionlang.notes.chapter12 import Settings, run_listing
from motionlang.views.chapter12_plot import draw_figure
from motionlang.views.servo_plot import plot_listing
from motionlang.views.sweep_plot import plot_front, plot_map

GOLDEN = Path(__file__).parent / "styles.golden.txt"
VERSION = "matplotlib {}.{}".format(*matplotlib.__version__.split("."))
PROGRAM = """\
SPEED(0, 1, 2) = 100; : ACCEL(0, 1, 2) = 1000; : DECEL(0, 1, 2) = 1000;
OUT(1) = 1
VECTORR(0, 1) = 30, 40
VECTORR(0, 1) = 30, -40
GO(0)
MOVER(2) = 20 : GO(2)
PAUSE IDLE(0) And IDLE(2)
OUT(1) = 0
"""
LOOP = ["--inertia", "1e-5", "--kprop", "0.04", "--kderiv", "0.9"]
PVT = ["--positions=0,200,900,500", "--time", "20"]
COMMANDS = {
    "run": ["run", "a.mnt", "-q"],
    "path": ["run", "a.mnt", "-q", "--path", "0,1"],
    "path in space": ["run", "a.mnt", "-q", "--path", "0,1,2"],
    "sweep": ["sweep", "a.mnt", "--vary", "MOVER[2]@6=20,30", "-q", "-j", "1"],
    "plan": ["plan", "--distance", "30", "--time", "2", "--rule", "third"],
    "pvt": ["pvt", "plot", *PVT, "--velocities", "average"],
    "pvt refine": ["pvt", "refine", *PVT, "--compare", "1,2"],
    "step": ["servo", "step", "--time", "0.02"],
    "compare": ["servo", "compare"],
    "slip": ["servo", "slip", "--friction", "0.3", "--distance", "4", "--accel", "2"],
    "dac": ["servo", "dac", "--friction", "0.3"],
    "chapter 12": ["notes", "chapter12", "12.3"],
    "figure 12.7": ["servo", "figure", "12.7"],
    "tn1069": ["notes", "tn1069", "--distance", "3000"],
}

LISTING = run_listing(Settings(100, 10, 1, 40, kd=80, hold=4, max_steps=32), 100.0, 2.0, 20)
DRAWINGS: dict[str, Callable[[str], None]] = {
    **{
        f"drawing {number}": partial(draw_figure, number)
        for number in ("12.1", "12.4", "12.5", "12.6", "12.10", "12.11")
    },
    "listing": partial(plot_listing, LISTING),
    "map": lambda path: plot_map(path, ("x", "y", "z"), [(0, 0, 1), (1, 0, 2), (2, 0, 4)], {}, (1, 0)),
    "front": lambda path: plot_front(path, ("x", "y"), [(0, 3), (1, 1), (2, 2)], [(0, 3), (1, 1)], {}),
}


def styles(figure: Any) -> Iterator[str]:
    """Yield the style of every element of a figure."""
    yield f"size {[float(f'{each:.6g}') for each in figure.get_size_inches()]}"
    for text in figure.texts:
        yield text_style("head", text)
    for axes in figure.axes:
        yield f"place {[float(f'{each:.4g}') for each in axes.get_position().bounds]}"
        yield f"frame {[name for name in axes.spines if axes.spines[name].get_visible()]} {axes.get_axisbelow()}"
        for axis in (axes.xaxis, axes.yaxis):
            yield text_style("label", axis.label)
            yield text_style("offset", axis.get_offset_text())
            for tick in axis.get_major_ticks()[:1]:
                ends = tick.tick1line, tick.tick2line
                yield (
                    f"tick {[each.get_markersize() for each in ends]} {tick.label1.get_fontsize():g} {tick.get_pad():g}"
                )
                grid = tick.gridline
                yield f"grid {grid.get_visible()} {grid.get_color()} {grid.get_alpha()} {grid.get_linewidth():g}"
            yield f"positions {[float(f'{each:.6g}') for each in axis.get_majorticklocs()]}"
        for artist in axes.get_children():
            yield from artist_style(artist)


def artist_style(artist: Any) -> Iterator[str]:
    """Yield the style of an element of axes."""
    name, order = type(artist).__name__, artist.get_zorder()
    if hasattr(artist, "get_xydata"):
        style = artist.get_linestyle(), artist._unscaled_dash_pattern, artist.get_solid_joinstyle()
        yield f"{name} {artist.get_linewidth():g} {order:g} {artist.get_alpha()} {style} {artist.get_markersize():g}"
    elif hasattr(artist, "get_texts"):
        sizes = sorted({text.get_fontsize() for text in artist.get_texts()})
        yield f"{name} {artist._ncols} {artist.get_frame_on()} {sizes} {artist.borderpad:g} {artist._loc}"
    elif hasattr(artist, "get_text"):
        yield text_style(name, artist)
    elif hasattr(artist, "get_linewidths"):
        widths = sorted({float(f"{each:.6g}") for each in artist.get_linewidths()})
        limits = [float(f"{each:.6g}") for each in artist.get_clim() if each is not None]
        yield f"{name} {widths} {order:g} {artist.get_alpha()} {limits}"
    elif hasattr(artist, "get_linewidth"):
        yield f"{name} {artist.get_linewidth():g} {order:g} {artist.get_alpha()}"


def text_style(kind: str, text: Any) -> str:
    """Return the style of a text, and True if it may be read as a formula."""
    shift = tuple(map(float, text.xyann)) if getattr(text, "anncoords", "data") == "offset points" else ""
    return f"{kind} {text.get_fontsize():g} {text.get_fontweight()} {text.get_parse_math()} {shift}".rstrip()


def golden() -> dict[str, str]:
    """Return the sections of the golden file by their names.

    There are none for another version of matplotlib.
    """
    version, *sections = GOLDEN.read_text(encoding="utf-8").split("# ") if GOLDEN.exists() else [""]
    return dict(section.split("\n", 1) for section in sections) if version.strip() == VERSION else {}


@pytest.mark.parametrize("name", COMMANDS)
def test_the_styles_of_figures(
    name: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, request: pytest.FixtureRequest
) -> None:
    drawn: list[Figure] = []
    monkeypatch.setattr(Figure, "savefig", lambda figure, *_, **__: drawn.append(figure))
    monkeypatch.chdir(tmp_path)
    Path("a.mnt").write_text(PROGRAM, encoding="utf-8")
    assert main([*COMMANDS[name], "--plot", "a.svg"]) == 0
    (figure,) = drawn
    figure.draw_without_rendering()
    compare(name, figure, request)


@pytest.mark.parametrize("name", DRAWINGS)
def test_the_styles_of_drawings(name: str, figures: list[Figure], request: pytest.FixtureRequest) -> None:
    """Their data is in `test_note_figures.py`."""
    DRAWINGS[name]("x.svg")
    compare(name, figures[0], request)


def compare(name: str, figure: Figure, request: pytest.FixtureRequest) -> None:
    """Compare the styles of a figure with its section of the golden file."""
    update, recorded = request.config.getoption("--update"), golden()
    if not (update or recorded):
        pytest.skip(f"the styles of {VERSION} are not recorded")
    text = "".join(f"{line}\n" for line in dict.fromkeys(styles(figure)))
    if update:
        recorded[name] = text
        sections = [f"# {each}\n{recorded[each]}" for each in (*COMMANDS, *DRAWINGS) if each in recorded]
        GOLDEN.write_text("".join([f"{VERSION}\n", *sections]), encoding="utf-8", newline="\n")
    assert text == recorded[name]
