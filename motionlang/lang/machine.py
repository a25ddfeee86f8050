"""The machine a program runs on: the controller, the terminal, and the world that the machine file describes.

Every key of `machine.toml` has a default; a key that does not exist, or a value of the wrong kind, is a diagnostic
with its line. `KEYS` is the whole vocabulary.
"""

from __future__ import annotations

from motionlang.controller.controller import Controller
from motionlang.lang.terminal import Terminal

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable, Mapping

    from motionlang.errors import Diagnostic
    from motionlang.lang.scheduler import Scheduler
    from motionlang.source import Source

# key -> (kind, default, help). `axis.N.…` stands for every axis.
KEYS: dict[str, tuple[type, object, str]] = {
    "controller.model": (str, "", "The model to behave like; empty for the dialect's own default."),
    "controller.axes": (int, 8, "The number of axes."),
    "controller.instruction_time": (float, 10e-6, "What one statement costs, in seconds of machine time."),
}
MAX_AXES = 64


class Machine:
    """A controller with its terminal, and the settings that a language needs to run on it."""

    __slots__ = (
        "controller",
        "diagnostics",
        "instruction_time",
        "model",
        "overrides",
        "scheduler",
        "terminal",
    )

    def __init__(
        self,
        settings: Mapping[str, object] | None = None,
        *,
        first_axis: int = 0,
        show: Callable[[str], None] | None = None,
        overrides: Mapping[str, float | str] | None = None,
    ) -> None:
        values = {key: default for key, (_, default, _) in KEYS.items()} | dict(settings or {})
        self.model = str(values["controller.model"])
        self.instruction_time = float(values["controller.instruction_time"])  # type: ignore[arg-type]
        self.controller = Controller(int(values["controller.axes"]), first_axis)  # type: ignore[call-overload]
        self.terminal = Terminal(show)
        # What `--set NAME=VALUE` gives to the program's own names.
        self.overrides = dict(overrides or {})
        # What the program did wrong without ending: MCCL answers with a code and goes on.
        self.diagnostics: list[Diagnostic] = []
        # Who runs the tasks, so that a program can start further ones; set by whoever starts the program.
        self.scheduler: Scheduler | None = None


def read_machine(source: Source) -> dict[str, object]:
    """The settings of a machine file by their dotted keys; ProgramError with every mistake in it."""
    import tomllib

    from motionlang.errors import Diagnostic, ProgramError

    try:
        tree = tomllib.loads(source.text)
    except tomllib.TOMLDecodeError as error:
        raise ProgramError([_toml_mistake(error)]) from None
    settings: dict[str, object] = {}
    mistakes: list[Diagnostic] = []
    for key, value in _flatten(tree):
        problem = check_setting(key, value)
        if problem is None:
            settings[key] = float(value) if KEYS[key][0] is float else value  # type: ignore[arg-type]
        else:
            line = _line_of(source, key)
            mistakes.append(Diagnostic("machine-file", problem[0], line, 1, hint=problem[1]))
    if mistakes:
        raise ProgramError(mistakes)
    return settings


def check_setting(key: str, value: object) -> tuple[str, str] | None:
    """What is wrong with one setting, and a hint; None when nothing is."""
    from motionlang.errors import nearest

    row = KEYS.get(key)
    if row is None:
        near = nearest(key, KEYS)
        return (
            f"there is no key {key}",
            f"did you mean {near}?" if near else f"the keys are {', '.join(KEYS)}",
        )
    kind = row[0]
    fits = isinstance(value, kind) or (kind is float and isinstance(value, int))
    if not fits or isinstance(value, bool) is not (kind is bool):
        return f"{key} must be {_KIND_NAMES[kind]}, not {value!r}", row[2]
    if key == "controller.axes" and not 1 <= value <= MAX_AXES:  # type: ignore[operator]
        return f"controller.axes must be 1 to {MAX_AXES}, not {value}", row[2]
    if key == "controller.instruction_time" and not 1e-9 <= value <= 1.0:  # type: ignore[operator]
        return f"controller.instruction_time must be 1e-9 to 1 second, not {value}", row[2]
    return None


_KIND_NAMES = {str: "a text", int: "a whole number", float: "a number", bool: "true or false"}


def _flatten(tree: Mapping[str, object], prefix: str = "") -> list[tuple[str, object]]:
    pairs: list[tuple[str, object]] = []
    for key, value in tree.items():
        if isinstance(value, dict):
            pairs.extend(_flatten(value, f"{prefix}{key}."))
        else:
            pairs.append((prefix + key, value))
    return pairs


def _line_of(source: Source, key: str) -> int:
    """The line that sets `key`, for the message; 0 where the file's own spelling hides it."""
    section, _, name = key.rpartition(".")
    inside = section == ""
    for number, line in enumerate(source.text.split("\n"), 1):
        text = line.strip()
        if text.startswith("["):
            inside = text.strip("[] ") == section
        elif text.split("=")[0].strip() in ((name,) if inside else (key,)):
            return number
    return 0


def _toml_mistake(error: Exception) -> Diagnostic:
    import re

    from motionlang.errors import Diagnostic

    text = str(error)
    place = re.search(r"\(at line (\d+), column (\d+)\)", text)
    line, column = (int(place[1]), int(place[2])) if place else (0, 0)
    return Diagnostic("machine-file", text.split(" (at ")[0], line, column, hint="the machine file is TOML")
