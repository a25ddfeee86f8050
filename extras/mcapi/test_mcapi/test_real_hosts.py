"""Public hosts, unmodified."""

from __future__ import annotations

import json
import os
import shutil
import socket
import subprocess
import sys
from importlib.util import find_spec
from pathlib import Path
from typing import Any

import pytest

from test_mcapi.conftest import FUNCTIONS, needs_compiler

HERE = Path(__file__).parent
# Methods that fail in PMC's binding before they reach the library, on a real board as well.
BROKEN = {
    "ConfigureCompare",  # num.inc
    "GetDigitalFilter",  # its `actual` is no pointer
    "GetDigitalIOConfig",  # a variable that does not exist
    "GetTrajectoryRate",  # one argument too many
    "GetVersion",  # the value of an int
    "pmccmdex",  # a reference to None
    "pmclookupvar",  # one argument too few
}
COUNTS_PER_MM, BACKLASH = 2000, 500
STAGES = f"""
[stage]
port = PORT
axis = 1
startup_behavior = "trust_state"
enable_backlash_correction = true
backlash = {BACKLASH}
counts_per_mm = {COUNTS_PER_MM}
"""
# Without a state that has numbers, the loop of the daemon ends.
STATE = "position = 25.0\ndestination = 25.0\nhw_limits = [0.0, 50.0]\n"

needs_hosts = pytest.mark.skipif(
    find_spec("yaqd_pmc") is None or find_spec("yaqc") is None, reason="yaqd-pmc and yaqc are not installed"
)
needs_file = pytest.mark.skipif(shutil.which("file") is None, reason="PMC's binding needs the program `file`")


def motionlang(*words: str) -> list[str]:
    return [sys.executable, "-m", "motionlang", "mcapi", *words]


@pytest.fixture(scope="module")
def environment(tmp_path_factory: pytest.TempPathFactory) -> dict[str, str]:
    """A user's environment in which the library has been built."""
    found = {**os.environ, "MOTIONLANG_CACHE": str(tmp_path_factory.mktemp("cache"))}
    subprocess.run(motionlang("build"), env=found, check=True, stdout=subprocess.DEVNULL)
    return found


@needs_compiler
@needs_hosts
@needs_file
@pytest.mark.slow
def test_every_method_of_the_binding(environment: dict[str, str]) -> None:
    """All 139 methods work; Python errors are the binding's own."""
    command = motionlang("run", "--clock", "lockstep", "--", sys.executable, str(HERE / "binding_host.py"))
    done = subprocess.run(command, env=environment, capture_output=True, text=True, timeout=100, check=False)
    assert done.returncode == 0, done.stderr[-2000:]
    found: dict[str, Any] = json.loads(done.stdout)
    assert len({*found, "Open"} - {"Handle"}) == 139
    assert {*found} - {"Handle"} <= {name.removeprefix("MC") for name in FUNCTIONS}
    assert {
        name for name, value in found.items() if isinstance(value, str) and value.endswith("Error")
    } == BROKEN
    assert found["GetAccelerationEx"] == 100_000.0
    assert found["GetDigitalIOEx"] == 0
    assert found["DecodeStatus"] == 0
    assert found["IsStopped"] in (0, 1)
    assert found["pmcgets"] == "error the handle does not support this mode"


@needs_compiler
@needs_hosts
@needs_file
@pytest.mark.skipif(sys.version_info >= (3, 12), reason="yaqd-pmc does not yield to its event loop there")
@pytest.mark.slow
def test_a_laboratory_stage(environment: dict[str, str], tmp_path: Path) -> None:
    """yaqd-pmc moves the stage with its approach against backlash, and stops it."""
    import yaqc  # type: ignore[import-untyped]

    with socket.socket() as free:
        free.bind(("127.0.0.1", 0))
        port = free.getsockname()[1]
    stages = tmp_path / "stages.toml"
    stages.write_text(STAGES.replace("PORT", str(port)), encoding="utf-8")
    state = tmp_path / "yaqd-state" / "pmc" / "stage-state.toml"
    state.parent.mkdir(parents=True)
    state.write_text(STATE, encoding="utf-8")
    log = tmp_path / "stage.log"
    options = ["--set", "controller.model=dcx-pci100", "--record", str(log)]
    daemon = [sys.executable, "-c", "from yaqd_pmc._pmc import PmcMotor; PmcMotor.main()"]
    command = motionlang("run", *options, "--", *daemon, "--config", str(stages))
    own = {**environment, "XDG_DATA_HOME": str(tmp_path)}
    with subprocess.Popen(command, env=own, stderr=subprocess.PIPE, text=True) as running:
        try:
            stage = connected(yaqc, port, running)
            assert stage.get_position() == 25.0
            for wanted in (25.5, 25.2):
                stage.set_position(wanted)
                while abs(stage.get_position() - wanted) > 20.5 / COUNTS_PER_MM or stage.busy():
                    pass
            stage.set_position(45.0)
            while stage.get_position() < 26.0:
                pass
            stage.stop()
            stage.shutdown()
            stage._socket._socket.close()
            running.communicate(timeout=30)
        finally:
            if running.poll() is None:
                running.kill()
    calls = [line.split(" ", 3)[3] for line in log.read_text(encoding="latin-1").splitlines()[1:]]
    moves = [call.split() for call in calls if call.startswith("MCMoveAbsolute")]
    counts = [float(move[3]) for move in moves]
    # Position in mm counts down from 50; a move to more millimetres goes past its target and comes back.
    wanted_counts = [(50.0 - mm) * COUNTS_PER_MM for mm in (25.5, 25.5, 25.2, 45.0)]
    wanted_counts[0] -= BACKLASH
    wanted_counts[3] -= BACKLASH
    assert counts == pytest.approx(wanted_counts)
    assert any(call.startswith("MCStop 1 1") for call in calls)
    done = subprocess.run(
        motionlang("replay", str(log)), env=own, capture_output=True, text=True, check=False
    )
    assert (done.returncode, done.stdout) == (0, f"{len(calls)} calls, 0 differences\n")


def connected(yaqc: Any, port: int, running: subprocess.Popen[str]) -> Any:
    """Return a client of the daemon as soon as the daemon listens."""
    while running.poll() is None:
        try:
            socket.create_connection(("127.0.0.1", port)).close()
        except ConnectionRefusedError:
            continue
        return yaqc.Client(port)
    raise AssertionError(running.stderr.read() if running.stderr is not None else "")
