"""`motionlang copley serve` as a process: EDS file, exit, error messages."""

from __future__ import annotations

import re
import signal
import subprocess
import sys
from pathlib import Path
from typing import Any

import canopen
import pytest

from motionlang.cli import main
from tests.cli.programs import MAX_SECONDS
from tests.hosts.serve.test_command import line_with


def test_drives_are_served_until_a_signal(tmp_path: Path) -> None:
    path = tmp_path / "drive.eds"
    command = [
        sys.executable,
        "-m",
        "motionlang",
        "copley",
        "serve",
        "virtual:served",
        "--drives",
        "2",
        "--eds",
        str(path),
    ]
    with subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True) as process:
        assert line_with(process, "CANopen drives, nodes 1 to 2, on virtual served") == "; Ctrl-C ends it"
        units = line_with(process, "units: ")
        process.send_signal(signal.SIGTERM)
        out, err = process.communicate(timeout=MAX_SECONDS)
    assert units == "positions in counts, speeds in 0.1 counts/s, rates in 10 counts/s²"
    assert (process.returncode, err) == (0, "")
    assert re.fullmatch(r"received 0 frames; machine time \d+\.\d{3} s\n", out), out
    dictionary: Any = canopen.import_od(str(path), node_id=5)
    assert dictionary[0x1400][1].default == 0x205
    assert dictionary[0x6081].default == 100_000


@pytest.mark.parametrize(
    ("words", "message"),
    [
        ([], "the following arguments are required: INTERFACE:CHANNEL"),
        *(
            ([bus], f"'{bus}' is not INTERFACE:CHANNEL, such as socketcan:vcan0")
            for bus in ("vcan0", "virtual:", ":x")
        ),
        *(
            (["virtual:x", "--drives", count], f"'{count}' is not a number of drives from 1 to 127")
            for count in ("0", "128", "x")
        ),
        (["virtual:x", "--factor", "0"], "'0' is not a factor from 0.000001 to 1000000"),
        (["virtual:x", "--tcp", "0"], "unrecognized arguments: --tcp 0"),
        (["virtual:x", "--set", "width=3"], "--set width: the drives run no program with names"),
    ],
)
def test_what_does_not_go_together(
    words: list[str], message: str, capsys: pytest.CaptureFixture[str]
) -> None:
    with pytest.raises(SystemExit) as ended:
        main(["copley", "serve", *words])
    assert ended.value.code == 2
    assert message in capsys.readouterr().err


def test_a_bus_and_a_file_that_cannot_be_opened(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["copley", "serve", "nothing:x"]) == 1
    assert "error[address]: the CAN bus 'nothing x' cannot be opened" in capsys.readouterr().err
    assert main(["copley", "serve", "virtual:x", "--eds", str(tmp_path / "no" / "drive.eds")]) == 1
    assert "drive.eds cannot be written: no such file or directory" in capsys.readouterr().err
