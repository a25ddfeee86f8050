"""Random command lines for commands that need no program, each from a seed."""

from __future__ import annotations

from motionlang.kernel import CODES
from tests.generated.draw import Draw, table

_MOTOR = {
    "load_inertia": (1e-6, 1e-4), "viscous": (0.0, 1e-4), "coulomb": (0.0, 0.01),
    "load_torque": (-0.02, 0.02), "breakaway": (0.0, 0.02),
}  # fmt: skip
_LOOP = {
    "proportional": (1e-3, 2e-2), "integral": (0.0, 1e-4), "derivative": (0.0, 0.6), "velocity_ff": (0.0, 5e-5),
    "output_deadband": (0.0, 0.1), "output_limit": (2.0, 10.0), "output_offset": (-0.1, 0.1),
}  # fmt: skip
# Figures of a move, and those that determine one.
_PLAN = {
    "--distance": (-300.0, 300.0), "--time": (1.0, 3.0), "--accel-time": (0.02, 0.4), "--slew-time": (0.05, 1.0),
    "--decel-time": (0.02, 0.4), "--speed": (150.0, 500.0), "--accel": (1000.0, 9000.0), "--decel": (1000.0, 9000.0),
}  # fmt: skip
_RECIPES = (
    ("--distance", "--time"), ("--distance", "--speed", "--accel"), ("--distance", "--speed", "--accel", "--decel"),
    ("--distance", "--time", "--accel-time", "--decel-time"),
    ("--speed", "--accel-time", "--slew-time", "--decel-time"),
    ("--distance", "--time", "--accel", "--decel"), ("--distance", "--speed", "--accel-time", "--decel"),
)  # fmt: skip


def command_line(seed: int) -> list[str]:
    """Return the arguments of one command."""
    draw = Draw(seed)
    return _KINDS[seed % len(_KINDS)](draw)


def _figure(draw: Draw, low: float, high: float) -> str:
    return f"{float(f'{draw.uniform(low, high):.3g}'):g}"


def _some(draw: Draw, options: dict[str, tuple[float, float]], share: float) -> list[str]:
    """Return some options, each with a value from its range."""
    return [
        each
        for option, (low, high) in options.items()
        if draw.chance(share)
        for each in (option, _figure(draw, low, high))
    ]


def _pairs(draw: Draw, option: str, ranges: dict[str, tuple[float, float]], share: float) -> list[str]:
    """Return the option with NAME=VALUE for some of the names."""
    return [
        each
        for name, (low, high) in ranges.items()
        if draw.chance(share)
        for each in (option, f"{name}={_figure(draw, low, high)}")
    ]


def _json(draw: Draw) -> list[str]:
    return ["--format", "json"] if draw.chance(0.4) else []


def _plan(draw: Draw) -> list[str]:
    recipe = draw.choice(_RECIPES)
    given = [each for option in recipe for each in _figures(draw, option)]
    if draw.chance(0.15):  # one figure more than needed contradicts the others
        given += _figures(draw, draw.choice(tuple(_PLAN)))
    rule = (
        ["--rule", draw.choice(("third", "quarter", "equal"))] if recipe == ("--distance", "--time") else []
    )
    language = ["--lang", draw.choice(("mint", "mccl"))] if draw.chance(0.7) else []
    times = ["--use-times"] if draw.chance(0.3) else []
    axis = ["--axis", str(draw.randrange(1, 4))] if draw.chance(0.3) else []
    return ["plan", *given, *rule, *_scale(draw), *language, *times, *axis, *_json(draw)]


def _figures(draw: Draw, option: str) -> list[str]:
    return [option, _figure(draw, *_PLAN[option])]


def _scale(draw: Draw) -> list[str]:
    """Return options for the counts of a user unit, given directly or by the encoder."""
    kind = draw.randrange(4)
    if kind == 0:
        return []
    if kind == 1:
        return ["--scale", _figure(draw, 1.0, 2000.0)]
    gear = ["--gear", draw.choice(("3:1", "2", "5:2"))] if draw.chance(0.5) else []
    unit = ["--pitch", _figure(draw, 1.0, 20.0)] if kind == 2 else ["--degrees"]
    return ["--encoder-lines", str(draw.randrange(500, 2500)), *gear, *unit]


def _points(draw: Draw) -> list[str]:
    """Return points of a drive: an S-curve, or positions with times."""
    if draw.chance(0.25):
        limits = {"--jerk": (1e6, 1e8), "--accel": (1e5, 1e6), "--speed": (1e4, 2e5)}
        return ["--scurve", _figure(draw, 500.0, 50000.0), *_some(draw, limits, 0.8)]
    positions = [0]
    for _ in range(draw.randrange(2, 7)):
        positions.append(positions[-1] + draw.randrange(-2000, 6000, 50))
    if draw.chance(0.15):
        return [f"--positions={','.join(map(str, positions))}", "--time", "20", "--linear"]
    manner = draw.choice(("zero", "average", "refine", "exact"))
    velocities = [
        "--velocities",
        manner,
        *(["--sweeps", str(draw.randrange(1, 5))] if manner == "refine" else []),
    ]
    several = draw.chance(0.5)
    times = (
        ",".join(str(draw.randrange(5, 60)) for _ in positions[1:]) if several else str(draw.randrange(5, 60))
    )
    start = ["--start", str(draw.randrange(-500, 500, 10))] if draw.chance(0.2) else []
    return [f"--positions={','.join(map(str, positions))}", "--time", times, *start, *velocities]


def _pvt(draw: Draw) -> list[str]:
    return ["pvt", "plot", *_points(draw), *_json(draw)]


def _refine(draw: Draw) -> list[str]:
    compared = ["--compare", "1,2,5"] if draw.chance(0.5) else []
    return ["pvt", "refine", *_points(draw), *compared, *_json(draw)]


def _export(draw: Draw) -> list[str]:
    form = draw.choice(("csv", "serial", "pdo", "sdo", "record"))
    relative = ["--relative"] if draw.chance(0.3) else []
    node = ["--node", str(draw.randrange(1, 128))] if draw.chance(0.3) else []
    return ["pvt", "export", *_points(draw), "--format", form, *relative, *node]


def motor(draw: Draw) -> list[str]:
    """Return options for some properties of a simulated motor."""
    soft = {"resonance": (40.0, 200.0), "backlash": (0.0, 4.0)}
    return _pairs(draw, "--plant", _MOTOR, 0.3) + _pairs(draw, "--plant", soft, float(draw.chance(0.3)))


def _step(draw: Draw) -> list[str]:
    board = ["--model", draw.choice(("multiflex", "dcx"))] if draw.chance(0.3) else []
    size = ["--size", str(draw.randrange(20, 2000, 20))] if draw.chance(0.5) else []
    loop = _pairs(draw, "--loop", _LOOP, 0.4)
    return ["servo", "step", *motor(draw), *loop, *board, *size, "--time", "0.05", *_json(draw)]


def _compare(draw: Draw) -> list[str]:
    equal = ["--equal", draw.choice(("acceleration", "time"))] if draw.chance(0.5) else []
    return ["servo", "compare", *motor(draw), *equal, *_json(draw)]


def _tune(draw: Draw) -> list[str]:
    plain = ["--no-integral"] if draw.chance(0.3) else []
    return ["servo", "tune", *motor(draw), "--bandwidth", _figure(draw, 15.0, 80.0), *plain, *_json(draw)]


def _keyword(draw: Draw) -> list[str]:
    language = draw.choice(("mint", "mccl"))
    names = sorted(table(language))
    return ["help", draw.choice(names), draw.choice(names), *_json(draw)]


def _explain(draw: Draw) -> list[str]:
    return ["help", f"error[{draw.choice(sorted(CODES))}]"]


_KINDS = (
    _plan, _pvt, _plan, _refine, _plan, _export, _refine, _export, _plan, _step, _step, _export, _keyword, _tune, _plan,
    _compare, _step, _keyword, _plan, _explain, _pvt, _step, _keyword,
)  # fmt: skip
