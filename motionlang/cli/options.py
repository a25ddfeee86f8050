"""What the command line asks of a run, and what may be asked: reports, formats of files, rates."""

from __future__ import annotations

REPORTS = ("table", "json", "none")
TRACES = (".csv", ".npz", ".parquet", ".vcd", ".mcap")
PLOTS = (".png", ".svg", ".html")
PROFILES = (".json", ".trace.json", ".speedscope.json")
RATE = 1000.0
# TN1069: trajectory points a second, and samples of the loop that goes from one to the next in a straight line.
TRAJECTORY_RATE, SERVO_RATE = 1000.0, 4000.0


TYPE_CHECKING = False
if TYPE_CHECKING:
    Axes = tuple[int, ...] | None


class Options:
    """What the command line asks of a run."""

    __slots__ = (
        "allow",
        "cache",
        "certify",
        "columns",
        "dialect",
        "everything",
        "file",
        "given",
        "log_size",
        "machine",
        "nv",
        "overrides",
        "paths",
        "plot",
        "points",
        "profile",
        "profile_to",
        "prove",
        "rate",
        "realtime",
        "report",
        "settings",
        "show_code",
        "trace",
        "until",
        "window",
        "world",
    )

    def __init__(self, file: str) -> None:
        self.file = file
        self.dialect: str | None = None
        self.machine: str | None = None
        self.report = "table"
        self.everything = False
        self.until: float | None = None
        self.realtime: float | None = None
        self.trace: str | None = None
        self.rate = RATE
        # Trajectory points a second where the trace is to be as the controller computes it.
        self.points: float | None = None
        # What the trace has columns of, see Trace.choose; None for the usual ones.
        self.columns: list[str] | None = None
        self.plot: str | None = None
        # What of the run the picture shows: see views.window.Window.
        self.window: tuple[float, float | None, Axes, Axes] = (0.0, None, None, None)
        # `--set` by what it names: keys of the machine file, and names of the program.
        self.settings: dict[str, object] = {}
        self.overrides: dict[str, float | str] = {}
        # `--input`, `--analog`, `--answer` and `--keys`, by the parameters of lang.machine.entries.with_entries.
        self.world: dict[str, list[str]] = {}
        self.nv: str | None = None
        self.cache = True
        # The command line itself, to be told where it brought motionlang down.
        self.given: list[str] = []
        self.prove = False
        # The time profile: as a table, and as a file.
        self.profile = False
        self.paths = False
        self.profile_to: str | None = None
        self.certify = False
        self.show_code = False
        # Gigabytes that the log may take on the disk; None for the usual ones.
        self.log_size: float | None = None
        # What of the run's events does not make the exit status 1: names of cli.event_status.ALLOWED.
        self.allow: frozenset[str] = frozenset()

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Options) and all(
            getattr(self, name) == getattr(other, name) for name in Options.__slots__ if name != "given"
        )

    __hash__ = None  # type: ignore[assignment]
