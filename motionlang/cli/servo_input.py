"""The loop and the motor of a `servo` command, from its various sources.

The sources are a machine file, single values, and the gains of a language.
"""

from __future__ import annotations

import argparse
from collections.abc import Mapping

from motionlang.cli.parser import option
from motionlang.errors import ProgramError
from motionlang.lang.dialect import dialect
from motionlang.lang.gains import gain_words, written
from motionlang.servo.gains import MODELS, mccl_loop, mint_loop
from motionlang.servo.loop import Loop
from motionlang.servo.plant import Drive, Motor
from motionlang.servo.settings import PLANT, SERVO, Key, make_loop, make_plant

EXAMPLE = {"load_inertia": 4e-5, "viscous": 2e-5}
"""The changes of the commands' motor from [axis.N.plant]'s defaults.

They apply if no machine file describes one.
"""


def gains_of(language: str) -> dict[str, str]:
    """Return the gain keywords of a language, and the loop quantity that each sets."""
    return gain_words(language, dialect(language).table())


PLANT_OPTIONS = (
    option("--machine", "M.toml", "take [axis.N.plant] and [axis.N.servo] from a machine file"),
    option("--axis", "N", "the axis of the machine file (0)", int, default=0),
    option("--plant", "NAME=VALUE", f"a property of the motor: {', '.join(PLANT)}; may be repeated",
           action="append", default=[]),
)  # fmt: skip


LOOP_OPTIONS = (
    option("--loop", "NAME=VALUE", f"a property of the servo loop: {', '.join(SERVO)}; may be repeated",
           action="append", default=[]),
    option("--mint", "WORD=VALUE", f"a gain in Mint's units: {', '.join(gains_of('mint'))}",
           action="append", default=[]),
    option("--mccl", "WORD=VALUE", f"a gain in MCCL's units: {', '.join(gains_of('mccl'))}",
           action="append", default=[]),
    option("--model", None, "the board of the MCCL gains (multiflex)", choices=MODELS, default="multiflex"),
    option("--bandwidth", "HZ", "bandwidth to tune for if no gains are given, Hz (50)", float),
)  # fmt: skip


def plant_of(args: argparse.Namespace) -> Motor | Drive:
    """Return the motor that the options describe; ValueError names an invalid option."""
    options = pairs(args.plant, PLANT)
    example = {} if options.get("kind") == "drive" else EXAMPLE
    return make_plant((_section(args, "plant") or example) | options)


def loop_of(args: argparse.Namespace, plant: Motor | Drive, scale: float = 1.0) -> Loop:
    """Return the loop that the options describe.

    If no gain is given, the loop is tuned for the plant, without feed-forward. `scale` is in counts per user unit,
    the unit of MCCL's feed-forward gains.
    """
    from dataclasses import replace

    if args.mint and args.mccl:
        raise ValueError("give gains of either Mint or MCCL, not both")
    section = _section(args, "servo") | pairs(args.loop, SERVO)
    if args.mint:
        return make_loop(section, mint_loop(written(gains_of("mint"), numbers(args.mint))))
    if args.mccl:
        return make_loop(section, mccl_loop(written(gains_of("mccl"), numbers(args.mccl)), args.model, scale))
    loop = make_loop(section)
    if any((loop.proportional, loop.integral, loop.derivative, loop.velocity_feedback)):
        return loop
    from motionlang.servo.tuning import suggest

    tuned = suggest(plant, args.bandwidth or 50.0, loop).loop
    given = {
        name: getattr(loop, name) for name in ("velocity_ff", "accel_ff", "decel_ff", "dac_bits", "override")
    }
    return replace(tuned, **given)


def machine_of(args: argparse.Namespace) -> dict[str, object] | None:
    """Return the settings of --machine, or of the machine file next to the program.

    Its motors are omitted if options describe one. Returns None if there is no file. ValueError names an invalid
    entry.
    """
    from motionlang.errors import ProgramError
    from motionlang.lang.machine.file import read_machine
    from motionlang.source import Source

    path = _machine_path(args)
    if path is None:
        return None
    try:
        settings = read_machine(Source.read(path))
    except ProgramError as error:
        raise _first(path, error) from None
    if args.plant or args.loop or args.mint or args.mccl or args.bandwidth:
        return {key: value for key, value in settings.items() if ".plant." not in key}
    return settings


def _first(path: str, error: ProgramError) -> ValueError:
    """Return the first error of a machine file as one sentence."""
    first = error.diagnostics[0]
    return ValueError(f"{path}:{first.line}: {first.message}; {first.hint}")


def pairs(texts: list[str], keys: Mapping[str, Key]) -> dict[str, object]:
    """Parse NAME=VALUE texts by the types of the keys."""
    found: dict[str, object] = {}
    for text in texts:
        name, equals, value = text.partition("=")
        if not equals:
            raise ValueError(f"{text!r} is not NAME=VALUE")
        found[name.strip()] = _value(value.strip(), keys.get(name.strip()))
    return found


def numbers(texts: list[str]) -> dict[str, float]:
    """Parse KEYWORD=VALUE texts; return numbers by upper-case keyword."""
    found: dict[str, float] = {}
    for text in texts:
        word, equals, value = text.partition("=")
        try:
            found[word.strip().upper()] = float(value)
        except ValueError:
            raise ValueError(
                f"{text!r} is not WORD=VALUE with a number" if equals else f"{text!r} is not WORD=VALUE"
            ) from None
    return found


def _value(text: str, key: Key | None) -> object:
    if key is not None and key.kind == "flag":
        return {"true": True, "false": False, "1": True, "0": False}.get(text.lower(), text)
    if key is not None and key.kind == "text":
        return text
    try:
        return int(text) if key is not None and key.kind == "count" else float(text)
    except ValueError:
        return text


def _machine_path(args: argparse.Namespace) -> str | None:
    from motionlang.execution import machine_of

    return machine_of(getattr(args, "file", None), args.machine)


def _section(args: argparse.Namespace, name: str) -> dict[str, object]:
    """Return `[axis.N.plant]` or `[axis.N.servo]` of the machine file, or nothing.

    The file may be the one next to the program.
    """
    path = _machine_path(args)
    if path is None:
        return {}
    from motionlang.errors import ProgramError
    from motionlang.lang.machine.file import read_toml
    from motionlang.source import Source

    try:
        found: object = read_toml(Source.read(path))
    except ProgramError as error:
        raise _first(path, error) from None
    for key in ("axis", str(args.axis), name):
        found = found.get(key, {}) if isinstance(found, dict) else {}
    if not isinstance(found, dict):
        raise ValueError(f"{path}: axis.{args.axis}.{name} must be a table")
    return dict(found)
