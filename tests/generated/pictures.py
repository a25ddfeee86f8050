"""Pictures as texts that describe what matplotlib would draw."""

from __future__ import annotations

import contextlib
from collections.abc import Iterable, Iterator
from typing import IO, Any

from tests.generated.command_lines import motor
from tests.generated.draw import Draw

# Points of a curve in the text; longer curves are sampled evenly.
POINTS = 48


@contextlib.contextmanager
def described() -> Iterator[None]:
    """Let figures write a description instead of an image within the context."""
    from matplotlib.figure import Figure

    save = Figure.savefig

    def describe(figure: Figure, file: IO[bytes], **options: object) -> None:
        metadata = sorted(options.pop("metadata", {}))  # type: ignore[call-overload]
        size = " by ".join(f"{each:g}" for each in figure.get_size_inches())
        lines = [f"{size} {sorted(options.items())} {metadata}", *_figure(figure)]
        file.write("".join(f"{line}\n" for line in lines).encode())

    Figure.savefig = describe  # type: ignore[method-assign,assignment]
    try:
        yield
    finally:
        Figure.savefig = save  # type: ignore[method-assign]


def _figure(figure: Any) -> Iterator[str]:
    yield from map(_text, figure.texts)
    for axes in figure.axes:
        box = ", ".join(f"{float(each):.4g}" for each in axes.get_position().bounds)
        yield f"axes {box}: {axes.get_xlabel()!r} {axes.get_ylabel()!r} {axes.get_xscale()} {axes.get_yscale()}"
        yield f"  from {_points([axes.get_xlim()])} {_points([axes.get_ylim()])} {axes.get_aspect()}"
        for child in axes.get_children():
            yield from (f"  {line}" for line in _artist(child))


def _artist(artist: Any) -> Iterator[str]:
    """Yield the description of one element of a figure."""
    name = type(artist).__name__
    if hasattr(artist, "get_xydata"):
        style = artist.get_color(), artist.get_linestyle(), artist.get_linewidth(), artist.get_marker()
        yield f"curve {style} {artist.get_alpha()} {artist.get_zorder()} {_points(artist.get_xydata())}"
    elif hasattr(artist, "get_texts"):
        yield f"legend {[each.get_text() for each in artist.get_texts()]} {artist._loc}"
    elif hasattr(artist, "get_text"):
        yield _text(artist)
    elif hasattr(artist, "get_offsets"):
        yield f"{name} {_points(artist.get_offsets())} {_points(artist.get_facecolor())} {artist.get_alpha()}"
        paths = artist.get_paths()
        yield from (f"  {_points(path.vertices)}" for path in paths[:: len(paths) // POINTS + 1])
    elif hasattr(artist, "get_patch_transform"):
        shape = artist.get_path().vertices if "Box" in name else artist.get_verts()
        outline = _points(artist.get_patch_transform().transform(artist.get_path().vertices))
        yield f"{name} {_points([artist.get_facecolor()])} {artist.get_linewidth()} {len(shape)} {outline}"
    elif hasattr(artist, "get_array") and artist.get_array() is not None:
        yield f"{name} {_points(artist.get_array())}"


def _text(text: Any) -> str:
    where = _points([text.get_position()])
    manner = text.get_horizontalalignment(), text.get_verticalalignment(), text.get_rotation()
    target = f" to {_points([text.xy])}" if hasattr(text, "xy") else ""
    return f"text {text.get_text()!r} {where}{target} {text.get_fontsize():g} {text.get_color()} {manner}"


def _points(rows: Iterable[Any]) -> str:
    found = [tuple(map(float, row)) if hasattr(row, "__len__") else float(row) for row in rows]
    step = len(found) / POINTS
    sampled = found if step <= 1.0 else [found[int(number * step)] for number in range(POINTS)] + found[-1:]
    return f"{len(found)}: {sampled}"


def picture_line(seed: int) -> list[str]:
    """Return the arguments of a command that draws `a.svg` and needs no program."""
    draw = Draw(seed)
    positions = ",".join(str(draw.randrange(-2000, 9000, 100)) for _ in range(draw.randrange(3, 7)))
    drive = [f"--positions={positions}", "--time", str(draw.randrange(5, 60))]
    distance, time, friction = (
        draw.randrange(20, 90),
        draw.randrange(1, 4),
        draw.choice(("0.1", "0.3", "0.6")),
    )
    lines = (
        ["pvt", "plot", *drive, "--velocities", draw.choice(("zero", "average", "exact"))],
        ["servo", "figure", f"12.{seed // 8 % 11 + 1}"],
        ["servo", "step", *motor(draw), "--time", "0.05"],
        ["notes", "tn1069", "--distance", f"{distance}00"],
        ["pvt", "refine", *drive, "--compare", "1,2,4"],
        [
            "plan",
            "--distance",
            str(distance),
            "--time",
            str(time),
            "--rule",
            draw.choice(("third", "quarter")),
        ],
        ["servo", "slip", "--friction", friction, "--distance", "4", "--accel", str(time)],
        ["servo", "compare", *motor(draw)],
        ["notes", "chapter12", f"12.{seed // 8 % 11 + 1}"],
        ["servo", "dac", "--friction", friction],
    )
    return [*lines[seed % len(lines)], "--plot", "a.svg"]
