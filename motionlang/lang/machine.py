"""The machine a program runs on: the controller, the terminal, and the world that the machine file describes."""

from __future__ import annotations

from motionlang.controller.controller import Controller
from motionlang.lang.terminal import Terminal

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable, Mapping

    from motionlang.controller.host import HostMemory
    from motionlang.controller.world import World
    from motionlang.errors import Diagnostic
    from motionlang.lang.scheduler import Scheduler

DEFAULT_AXES = 8
INSTRUCTION_TIME = 10e-6


class Machine:
    """A controller with its terminal, and the settings that a language needs to run on it."""

    __slots__ = (
        "_host",
        "controller",
        "diagnostics",
        "instruction_time",
        "model",
        "overrides",
        "scheduler",
        "settings",
        "terminal",
        "world",
    )

    def __init__(
        self,
        settings: Mapping[str, object] | None = None,
        *,
        first_axis: int = 0,
        show: Callable[[str], None] | None = None,
        overrides: Mapping[str, float | str] | None = None,
    ) -> None:
        self.settings = dict(settings or {})
        get = self.settings.get
        self.model = str(get("controller.model", ""))
        self.instruction_time = float(get("controller.instruction_time", INSTRUCTION_TIME))  # type: ignore[arg-type]
        self.controller = Controller(int(get("controller.axes", DEFAULT_AXES)), first_axis)  # type: ignore[call-overload]
        self.world = _world(self.controller, self.settings)
        self._host: HostMemory | None = None
        self.terminal = Terminal(show)
        # What `--set NAME=VALUE` gives to the program's own names.
        self.overrides = dict(overrides or {})
        # What the program did wrong without ending: MCCL answers with a code and goes on.
        self.diagnostics: list[Diagnostic] = []
        # Who runs the tasks, so that a program can start further ones; set by whoever starts the program.
        self.scheduler: Scheduler | None = None

    @property
    def host(self) -> HostMemory:
        """The memory shared with a host, from the first use on, with what the machine file lets the host write."""
        if self._host is None:
            from motionlang.controller.host import HostMemory

            self._host = HostMemory()
            for area in ("comms", "netdata"):
                for entry in self.settings.get(area, ()):  # type: ignore[attr-defined]
                    self._host.schedule(self.controller.clock, area, entry)
        return self._host


def _world(controller: Controller, settings: Mapping[str, object]) -> World | None:
    """The world of a machine file, None where the file says nothing beyond the controller itself."""
    if all(key.startswith("controller.") for key in settings):
        return None
    from motionlang.controller.world import World

    return World(controller, settings)
