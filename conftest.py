"""Options of the test run."""

from __future__ import annotations

import gc
import os
import signal
import zipfile
from importlib import import_module
from pathlib import Path

import pytest
from _pytest.runner import runtestprotocol

# Hypothesis imports the plugins of other libraries, such as that of trio, in each process.
os.environ.setdefault("HYPOTHESIS_NO_PLUGINS", "1")
from hypothesis import HealthCheck, settings
from hypothesis.internal.conjecture import providers

from motionlang.kernel.lang.syntax.grammar import GRAMMARS
from motionlang.kernel.tables import write
from tests import cases
from tests.built import distributions
from tests.extras import ABSENT
from tests.trees import nodes_of

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable, Generator

    from motionlang.kernel import Outside, Program, Run
    from motionlang.kernel.lang.scheduler import Stuck

TESTS = Path(__file__).parent / "tests"
# The tests of a distribution that is not installed are run only if they are named.
collect_ignore = [f"extras/{name}" for name in ABSENT]

# The tests share the processors already: threads of NumPy's BLAS would only wait for each other, in this process
# and in those that it starts.
os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")

# argparse looks up a translation of each of its messages in up to four files. In another locale than C, that takes
# half the time of building a parser.
os.environ["LANGUAGE"] = "C"

# Processes that the tests start buffer their output as a user's do, and know nothing of this terminal.
for _name in ("PYTHONUNBUFFERED", "NO_COLOR", "FORCE_COLOR", "COLUMNS", "LINES"):
    os.environ.pop(_name, None)
os.environ["TERM"] = "xterm"

# A shell starts background processes with Ctrl-C disabled, which every process of a test would inherit.
for _name in ("SIGINT", "SIGTERM", "SIGHUP"):
    _number = getattr(signal, _name, None)
    if _number is not None and signal.getsignal(_number) == signal.SIG_IGN:
        signal.signal(_number, signal.default_int_handler if _name == "SIGINT" else signal.SIG_DFL)

# All processes of the tests load this table, also those with a cache of their own.
write(GRAMMARS)

# No property depends on the speed of the machine, and each run draws the same cases. Hypothesis would also
# draw constants of those modules of the package that earlier tests have imported.
if hasattr(providers, "_local_constants"):  # private, so a later version may not have it
    providers._get_local_constants = lambda: providers._local_constants


def _draw_examples(all_of_them: bool) -> None:
    """Let properties draw a quarter of their examples, or all.

    It is called before test modules are imported.
    """
    if all_of_them:
        cases.draws_one_in = 1
    settings.register_profile(
        "motionlang",
        deadline=None,
        derandomize=True,
        database=None,
        max_examples=cases.examples(100),
        suppress_health_check=[HealthCheck.too_slow],
    )
    settings.load_profile("motionlang")


def _prove_every_run() -> None:
    """Prove every run, including runs of tests that do not request it.

    The proof is imported only here, on demand.
    """
    from motionlang.kernel import execution

    execute = execution._execute

    def proved(
        result: Run,
        compiled: Program,
        until: float | None,
        pace: Callable[[float], None] | None,
        outside: Outside | None,
    ) -> Stuck | None:
        from motionlang.kernel.controller import MotionListener
        from tests.proof.checks import prove
        from tests.proof.expected_motion import ExpectedMotion

        # A debugger goes back in a run, which the motion that is expected so far does not. Moves that were dropped
        # cannot be proved.
        is_proved = (
            not isinstance(result.controller.motion_listener, ExpectedMotion) and result.machine.hook is None
        )
        expected = ExpectedMotion(result.controller) if is_proved else None
        if expected is not None:
            result.controller.motion_listener = expected
        stuck = execute(result, compiled, until, pace, outside)
        if expected is not None:
            result.controller.motion_listener = MotionListener()
        if expected is not None and not expected.is_full and not result.controller.log.moves.first:
            found = prove(result.controller, expected, result.machine.clock.now).violations
            assert not found, [f"{each.line}: {each.message}" for each in found]
        return stuck

    execution._execute = proved


def pytest_configure(config: pytest.Config) -> None:
    """Prove every run of the complete suite; with `--prove`, also of selected tests."""
    _draw_examples(config.option.all_examples or "long" in config.option.markexpr)
    if config.args_source is pytest.Config.ArgsSource.TESTPATHS:
        config.option.prove = True
    if config.option.prove:
        _prove_every_run()


def _import_backwards(config: pytest.Config) -> None:
    """Import all test modules in reverse order in every second process.

    This is for the whole suite. The processes meet halfway, and each finds the bytecode of the other: in a fresh
    clone, assertions are then rewritten once. A module that cannot be imported is reported when its tests are
    collected.
    """
    process = getattr(config, "workerinput", {}).get("workerid", "gw0")
    if config.args_source is not pytest.Config.ArgsSource.TESTPATHS or int(process[2:]) % 2 == 0:
        return
    for path in sorted(TESTS.rglob("test_*.py"), reverse=True):
        try:
            import_module(".".join(path.relative_to(TESTS.parent).with_suffix("").parts))
        except (Exception, pytest.skip.Exception):
            pass


@pytest.hookimpl(wrapper=True)
def pytest_collection(session: pytest.Session) -> Generator[None, object, object]:
    """Exempt the modules and tests from garbage collection, for speed.

    They live as long as the process. The garbage of a test is collected while it is in the processor's cache. With
    Python's threshold of 700 objects, live ones are visited more often than necessary; with 20 000, the garbage is
    out of the cache.
    """
    gc.disable()
    try:
        _import_backwards(session.config)
        return (yield)
    finally:
        gc.freeze()
        gc.set_threshold(5000, 10, 10)
        gc.enable()


@pytest.hookimpl(tryfirst=True)
def pytest_runtest_protocol(item: pytest.Item, nextitem: pytest.Item | None) -> bool | None:
    """Send only reports of calls and of failures to the main process of xdist.

    Of the five messages of a test that passes it needs one, but `--durations` also needs those of setups. A
    skipped setup is reported, too.
    """
    if not hasattr(item.config, "workerinput") or item.config.option.durations is not None:
        return None
    for report in runtestprotocol(item, log=False, nextitem=nextitem):
        if report.when == "call" or not report.passed:
            item.ihook.pytest_runtest_logreport(report=report)
    return True


def pytest_addoption(parser: pytest.Parser) -> None:
    parser.addoption("--update", action="store_true", help="write golden files and transcripts anew")
    parser.addoption(
        "--all-examples", action="store_true", help="draw all examples of properties instead of a quarter"
    )
    parser.addoption("--prove", action="store_true", help="prove every run; always on in the whole suite")
    parser.addoption("--slow", action="store_true", help="run the tests marked slow, too")
    parser.addoption(
        "--max-cpu",
        type=float,
        metavar="S",
        help="fail a test that takes more processor time and is not slow",
    )


def _processor_time() -> float:
    """Return the processor time of this process and of its ended children, s."""
    return sum(os.times()[:4])


@pytest.hookimpl(wrapper=True)
def pytest_runtest_call(item: pytest.Item) -> Generator[None, None, None]:
    """Limit the processor time of a test that is not marked slow."""
    begun, most = _processor_time(), item.config.option.max_cpu
    yield
    taken = _processor_time() - begun
    if most is not None and taken > most and not any(map(item.get_closest_marker, ("slow", "long"))):
        pytest.fail(f"it took {taken:.1f} s of processor time; make it faster, or mark it slow")


def pytest_collection_modifyitems(config: pytest.Config, items: list[pytest.Item]) -> None:
    """Leave out the slow tests without `--slow`, and those that take minutes without `-m long`.

    The files at the top of `tests` come first. Some of their tests share a built wheel or the syntax trees of
    the package. The first process gets an eighth of all tests at once, so only that process builds these. The
    last tests take less than two seconds each, so that no process waits long for another at the end.
    """
    items.sort(key=lambda item: item.path.parent != TESTS)
    chosen = config.option.markexpr
    left_out = [] if "long" in chosen else ["long"]
    if not config.option.slow and "slow" not in chosen:
        left_out.append("slow")
    is_out = [any(map(item.get_closest_marker, left_out)) for item in items]
    config.hook.pytest_deselected(items=[item for item, out in zip(items, is_out, strict=True) if out])
    items[:] = [item for item, out in zip(items, is_out, strict=True) if not out]


@pytest.fixture
def update(pytestconfig: pytest.Config) -> bool:
    """True if the texts of golden files are to be rewritten."""
    return bool(pytestconfig.getoption("--update"))


@pytest.fixture
def golden(update: bool) -> Callable[[Path, str], None]:
    """Return the comparison of a text with its file, which `--update` rewrites first."""

    def compare(path: Path, text: str) -> None:
        if update:
            path.write_text(text, encoding="utf-8", newline="\n")
        assert text == path.read_text(encoding="utf-8")

    return compare


@pytest.fixture
def unrendered(monkeypatch: pytest.MonkeyPatch) -> None:
    """Let figures write no image, which takes matplotlib half a second.

    It is for tests of a command that also draws. The tests of each picture render it.
    """
    monkeypatch.setattr("motionlang.views.figure_files.svg", lambda figure: "")
    monkeypatch.setattr("motionlang.views.figure_files._png", lambda figure: b"")


@pytest.fixture(scope="session")
def package_trees() -> None:
    """Parse the package once, outside the time of the first test that reads all of it."""
    for path in (TESTS.parent / "motionlang").rglob("*.py"):
        nodes_of(path)


@pytest.fixture(scope="session")
def built(tmp_path_factory: pytest.TempPathFactory) -> tuple[Path, Path]:
    """Return the source distribution and the wheel."""
    sdist, wheel = distributions(tmp_path_factory.mktemp("built"), "sdist", "wheel")
    return sdist, wheel


@pytest.fixture(scope="session")
def wheel(built: tuple[Path, Path], tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Return the folder with the unpacked wheel."""
    folder = tmp_path_factory.mktemp("wheel")
    with zipfile.ZipFile(built[1]) as archive:
        archive.extractall(folder)
    return folder
