"""The options of a run on the command line: reports, file formats, rates."""

from __future__ import annotations

REPORTS = ("table", "json", "none")
TRACES = (".csv", ".npz", ".parquet", ".vcd", ".mcap")
PLOTS = (".png", ".svg", ".html")
PROFILES = (".json", ".speedscope.json")
RATE = 1000.0
CPU = 60.0
# TN1069: trajectory points per second, and samples of the loop that interpolates linearly between them.
TRAJECTORY_RATE, SERVO_RATE = 1000.0, 4000.0


Axes = tuple[int, ...] | None


class Options:
    """The options of a run, as given on the command line."""

    def __init__(self, file: str) -> None:
        self.file = file
        self.dialect: str | None = None
        self.machine: str | None = None
        self.report = "table"
        self.everything = False
        self.until: float | None = None
        self.realtime: float | None = None
        # Processor time of a run that no machine time ends, s; 0 means any.
        self.cpu = CPU
        self.trace: str | None = None
        self.rate = RATE
        # Trajectory points per second if the trace has to be as the controller computes it.
        self.points: float | None = None
        # The columns of the trace, see Trace.choose; None for the usual ones.
        self.columns: list[str] | None = None
        self.plot: str | None = None
        # The interval and axes of the run in the picture: see views.window.Window.
        self.window: tuple[float, float | None, Axes, Axes] = (0.0, None, None, None)
        # `--set` by key of the machine file, and by name of the program.
        self.settings: dict[str, object] = {}
        self.overrides: dict[str, float | str] = {}
        # `--input`, `--analog`, `--answer` and `--keys`, by the parameters of lang.machine.entries.with_entries.
        self.world: dict[str, list[str]] = {}
        self.nv: str | None = None
        # The command line itself, for crash reports.
        self.given: list[str] = []
        self.prove = False
        # The time profile: as a table, and as a file.
        self.profile = False
        self.paths = False
        self.profile_to: str | None = None
        self.certify = False
        # Quantities of the report, by the names of analysis.quantities.
        self.keep: tuple[str, ...] = ()
        self.show_tree = False
        # Gigabytes that the log may take on the disk; None for the default.
        self.log_size: float | None = None
        # The events that do not make the exit status 1: names of cli.event_status.ALLOWED.
        self.allow: frozenset[str] = frozenset()

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Options) and vars(self) | {"given": other.given} == vars(other)

    __hash__ = None  # type: ignore[assignment]
