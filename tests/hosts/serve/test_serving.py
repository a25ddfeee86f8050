"""`motionlang serve` from its first line to its last, when no host connects."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

from motionlang.cli import main
from motionlang.hosts.serve import Server
from tests.cases import cases

PROGRAMS = {
    "plain.mnt": "Print 1\n",
    "mapped.mnt": "MODBUSPARAMETER(_busETHERNET, _mpREGISTER_MAPPING) = _rmCOMMS_ARRAY\nPrint 1\n",
    "wrong.mnt": "Print 1 / 0\n",
    "macros.mcl": "1MN\n",
}
MINT = "Virtual Controller, 8 axes"
BOARD = "MultiFlex PCI 1000 series, 8 axes"
LISTENING = "listening on 127.0.0.1:PORT\n"
MODBUS = "listening on 127.0.0.1:PORT (Modbus TCP)\n"
REMARK = (
    "clients see NETINTEGER and NETFLOAT; MODBUSPARAMETER(_busETHERNET, _mpREGISTER_MAPPING) = _rmCOMMS_ARRAY "
    "in the program shows them COMMS\n"
)
ANYONE = "any computer that can reach this one can"
SERVED = "served 0 hosts; machine time 0.000 s\n"
BOTH = "served 0 hosts, 0 Modbus requests; machine time 0.000 s\n"
ALONE = "listening on 127.0.0.1:PORT (Modbus TCP); Ctrl-C ends it\n"
ANSWERED = "answered 0 requests; machine time 0.000 s\n"
# The arguments; the exit status, standard output and standard error. In lock step, a Mint program runs for one step,
# usually 0.01 s, before a host connects; an MCCL board does not run.
COMMANDS = (
    ("plain.mnt --tcp 0", 0, f"{MINT}, in real time; Ctrl-C ends it\n{LISTENING}{SERVED}", ""),
    ("plain.mnt --tcp 0 --modbus 0", 0,
     f"{MINT}, in real time; Ctrl-C ends it\n{LISTENING}{MODBUS}{REMARK}{BOTH}", ""),
    ("mapped.mnt --tcp 0 --modbus 0", 0,
     f"{MINT}, in real time; Ctrl-C ends it\n{LISTENING}{MODBUS}{BOTH}", ""),
    ("--lang mint --tcp 0 --modbus 0", 0,
     f"{MINT}, in real time; Ctrl-C ends it\n{LISTENING}{MODBUS}{BOTH}", ""),
    ("plain.mnt --tcp 0.0.0.0:0 --modbus 0.0.0.0:0 --clock lockstep", 0,
     f"{MINT}, in lock step; Ctrl-C ends it\n{LISTENING}{MODBUS}{REMARK}{BOTH}".replace("127.0.0.1", "0.0.0.0")
     .replace("0.000", "0.010"),
     f"motionlang serve: warning: {ANYONE} connect to 0.0.0.0:PORT; there is no password\n"
     f"motionlang serve: warning: {ANYONE} write through 0.0.0.0:PORT; there is no password\n"),
    ("plain.mnt --tcp 0 --factor 2.5", 0,
     f"{MINT}, in real time, 2.5 × real time; Ctrl-C ends it\n{LISTENING}{SERVED}", ""),
    ("plain.mnt --tcp 0 --clock lockstep --step 0.5", 0,
     f"{MINT}, in lock step; Ctrl-C ends it\n{LISTENING}{SERVED}".replace("0.000", "0.500"), ""),
    ("plain.mnt --tcp 0 --clock lockstep --step 0", 0,
     f"{MINT}, in lock step; Ctrl-C ends it\n{LISTENING}{SERVED}", ""),
    ("macros.mcl --tcp 0 --tcp 0", 0, f"{BOARD}, in real time; Ctrl-C ends it\n{LISTENING * 2}{SERVED}", ""),
    ("macros.mcl --tcp 0 --clock lockstep", 0,
     f"{BOARD}, in lock step; Ctrl-C ends it\n{LISTENING}{SERVED}", ""),
    ("--tcp 0 --set controller.axes=3", 0,
     f"{BOARD.replace('8', '3')}, in real time; Ctrl-C ends it\n{LISTENING}{SERVED}", ""),
    ("plain.mnt --modbus 0 --clock lockstep", 0, "1\n", f"{ALONE}{REMARK}{ANSWERED}"),
    ("mapped.mnt --modbus 0 --clock lockstep", 0, "1\n", f"{ALONE}{ANSWERED}"),
    ("plain.mnt --modbus 0.0.0.0:0 --clock lockstep", 0, "1\n",
     f"{ALONE}{REMARK}warning: {ANYONE} write through 127.0.0.1:PORT; there is no password\n{ANSWERED}"
     .replace("127.0.0.1", "0.0.0.0")),
    ("wrong.mnt --modbus 0 --clock lockstep", 1, "",
     f"{ALONE}{REMARK}error[division-by-zero]: division by zero\n --> wrong.mnt:1:7\n  |\n1 | Print 1 / 0\n"
     f"  |       ^\n  hint: the divisor is 0 whatever the program does\n{ANSWERED}"),
    ("plain.mnt --tcp 0 --set rate=3", 1, "",
     "error[unknown-word]: the program has no constant or variable rate\n --> plain.mnt\n"
     "  hint: the program declares no names\n"),
)  # fmt: skip


@cases("line, status, out, err", COMMANDS)
def test_the_output_of_a_server_without_hosts(
    line: str,
    status: int,
    out: str,
    err: str,
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
) -> None:
    monkeypatch.chdir(tmp_path)
    monkeypatch.setattr(Server, "run", lambda self: None)
    for name, text in PROGRAMS.items():
        Path(name).write_text(text, encoding="utf-8")
    assert main(["serve", *line.split()]) == status
    found = [re.sub(r"(\.0\.0\.[01]):\d+", r"\1:PORT", each) for each in capsys.readouterr()]
    assert found == [out, err]


# Wrong command lines, and the end of the message.
WRONG = (
    ("", "no address for hosts: give --tcp or --modbus with HOST:PORT, or --pty"),
    ("--tcp 0 --factor 2 --clock lockstep", "--factor needs --clock real"),
    ("--tcp 0 --step 2", "--step needs --clock lockstep"),
    ("--tcp 0 --unit 1", "--unit needs --modbus HOST:PORT"),
    ("plain.mnt --modbus 0 --log", "--echo and --log need --tcp or --pty"),
    ("plain.mnt --modbus 0 --echo", "--echo and --log need --tcp or --pty"),
    ("--modbus 0", "--modbus needs a Mint program: motionlang serve FILE --modbus HOST:PORT"),
    ("--modbus 0 --lang mint", "--modbus needs a Mint program: motionlang serve FILE --modbus HOST:PORT"),
    ("--modbus 0 --tcp 0", "--modbus needs a Mint program: motionlang serve FILE --modbus HOST:PORT"),
    ("macros.mcl --modbus 0",
     "--modbus serves a Mint program; for a file with another extension add --lang mint"),
    ("plain.mnt --lang mccl --modbus 0",
     "--modbus serves a Mint program; for a file with another extension add --lang mint"),
    *((f"--tcp 0 --unit {unit}", f"argument --unit: '{unit}' is not a Modbus unit from 1 to 247")
      for unit in ("0", "248", "x")),
    *((f"--tcp 0 --max-hosts {count}",
       f"argument --max-hosts: '{count}' is not a number of connections from 1 to 1000")
      for count in ("0", "1001", "x")),
    *((f"--tcp 0 --factor {factor}", f"argument --factor: '{factor}' is not a factor from 0.000001 to 1000000")
      for factor in ("0", "9.9e-7", "1000001", "x", "nan")),
    *((f"--tcp 0 --clock lockstep --step {step}", f"argument --step: '{step}' is not a time from 0 to 3600 seconds")
      for step in ("-1e-9", "3600.1", "x")),
)  # fmt: skip
# Numbers at their bounds, which are allowed: the message is about what follows.
BOUNDS = ("--unit 1", "--unit 247", "--max-hosts 1", "--max-hosts 1000", "--factor 1e-6", "--factor 1e6",
          "--clock lockstep --step 0", "--clock lockstep --step 3600")  # fmt: skip


@cases(
    "line, message",
    (*WRONG, *((f"--tcp 0 {each} --unit 1", WRONG[3][1]) for each in BOUNDS)),
)
def test_a_wrong_command_line(
    line: str, message: str, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setenv("COLUMNS", "1000")
    with pytest.raises(SystemExit) as ended:
        main(["serve", *line.split()])
    assert ended.value.code == 2
    hint = "  hint: motionlang serve --help lists the options\n"
    assert capsys.readouterr().err == f"motionlang serve: error: {message}\n{hint}"
