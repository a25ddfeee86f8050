"""Examples and fixes of the diagnostics that no rule of the linter has, for `help` and docs/diagnostics.md.

A test runs both commands of each example: the first produces the diagnostic, the second does not.
"""

from __future__ import annotations

from collections.abc import Mapping

MINT, MCCL, MACHINE = "pick.mnt", "pick.mcl", "pick.machine.toml"


class Example:
    """The files of an example, and its command without `motionlang`."""

    __slots__ = ("command", "files")

    def __init__(self, files: Mapping[str, str], command: str) -> None:
        self.files, self.command = files, command


Pair = tuple[Example, Example]


def _checked(wrong: str, right: str) -> Pair:
    """Two programs in Mint for `check`."""
    return _programs("check", MINT, wrong, right, "")


def _run(wrong: str, right: str, machine: str = "") -> Pair:
    """Two programs in Mint whose diagnostic appears at run time."""
    return _programs("run", MINT, wrong, right, machine)


def _run_mccl(wrong: str, right: str) -> Pair:
    return _programs("run", MCCL, wrong, right, "")


def _programs(verb: str, name: str, wrong: str, right: str, machine: str) -> Pair:
    files = {MACHINE: machine} if machine else {}
    command = f"{verb} {name}"
    return Example({name: wrong, **files}, command), Example({name: right, **files}, command)


def _machines(program: str, wrong: str, right: str, command: str = f"run {MINT}") -> Pair:
    return Example({MINT: program, MACHINE: wrong}, command), Example(
        {MINT: program, MACHINE: right}, command
    )


def _commands(files: Mapping[str, str], wrong: str, right: str) -> Pair:
    return Example(files, wrong), Example(files, right)


_MOVE = "MOVER(0) = 5 : GO(0)\nPAUSE IDLE(0)\n"

# By code: the files and the command that get the diagnostic, and those after the fix.
EXAMPLES: dict[str, Pair] = {
    "syntax": _checked("PAUSE IDLE(0\n", "PAUSE IDLE(0)\n"),
    "language": _commands({"pick.prg": "1MN,1MR100\n", MCCL: "1MN,1MR100\n"}, "run pick.prg", f"run {MCCL}"),
    "missing-end": _checked("If INX(1) Then\n  OUTX(1) = 1\n", "If INX(1) Then\n  OUTX(1) = 1\nEnd If\n"),
    "stray-end": _checked("OUTX(1) = 1\nEnd If\n", "OUTX(1) = 1\n"),
    "read-only": _checked("IDLE(0) = 1\n", "PAUSE IDLE(0)\n"),
    "write-only": _checked("PRINT MOVER(0)\n", "PRINT POSREMAINING(0)\n"),
    "not-a-command": _checked("SPEED(0)\n" + _MOVE, "PRINT SPEED(0)\n" + _MOVE),
    "type": _checked('Dim n As Integer\nn = "five"\nPRINT n\n', "Dim n As Integer\nn = 5\nPRINT n\n"),
    "duplicate": _checked("Dim part = 1\nDim part = 2\nPRINT part\n", "Dim part = 1\npart = 2\nPRINT part\n"),
    "axis": _checked("SPEED(40) = 5\nMOVER(0) = 5 : GO(0)\n", "SPEED(0) = 5\nMOVER(0) = 5 : GO(0)\n"),
    "channel": _run("OUTX(1000) = 1\n", "OUTX(1) = 1\n"),
    "terminal": _run("PRINT #0, 1\n", "PRINT #1, 1\n"),
    "one-terminal": _run(
        "Dim n\nTERMINAL = 3\nINPUT n\nPRINT n\n",
        "Dim n\nTERMINAL = 1\nINPUT n\nPRINT n\n",
        '[[answer]]\ntext = "5"\n',
    ),
    "index": _run(
        "Dim a(3)\nDim i\ni = 9\na(i) = 1\nPRINT a(i)\n",
        "Dim a(3)\nDim i\ni = 3\na(i) = 1\nPRINT a(i)\n",
    ),
    "division-by-zero": _run("Dim x\nPRINT 1 / x\n", "Dim x = 2\nPRINT 1 / x\n"),
    "overflow": _run("Dim n As Integer = 3000000000\nPRINT n\n", "Dim n As Float = 3000000000\nPRINT n\n"),
    "string-overflow": _run(
        'Dim s As String * 4\ns = "abcdef"\nPRINT s\n', 'Dim s As String * 6\ns = "abcdef"\nPRINT s\n'
    ),
    "argument": _run("Dim x = -4\nPRINT Sqrt(x)\n", "Dim x = -4\nPRINT Sqrt(Abs(x))\n"),
    "disabled-axis": _run("DRIVEENABLE(0) = 0\n" + _MOVE, "DRIVEENABLE(0) = 1\n" + _MOVE),
    "enable-input": _run(
        "DRIVEENABLE(0) = 1\n" + _MOVE,
        "PAUSE INX(2)\nDRIVEENABLE(0) = 1\n" + _MOVE,
        "[axis.0]\nenable_input = 2\n[[input]]\nchannel = 2\nat = 0.5\nvalue = 1\n",
    ),
    "axis-error": _run(
        "SOFTLIMITFORWARD(0) = 3\nJOG(0) = 10\nPAUSE IDLE(0)\nMOVER(0) = -1 : GO(0)\n",
        "SOFTLIMITFORWARD(0) = 3\nJOG(0) = 10\nPAUSE IDLE(0)\nCANCEL(0)\nMOVER(0) = -1 : GO(0)\n",
    ),
    "moving": _run_mccl("1MN,1MR1000\n1CM1\n", "1MN,1MR1000,1WS\n1CM1\n"),
    "stopping": _run(
        "DECEL(0) = 1\nJOG(0) = 5\nWAIT = 100\nSTOP(0)\nMOVER(0) = 5 : GO(0)\n",
        "DECEL(0) = 1\nJOG(0) = 5\nWAIT = 100\nSTOP(0)\nPAUSE IDLE(0)\nMOVER(0) = 5 : GO(0)\n",
    ),
    "buffer-in-use": _run(
        "MOVER(0) = 5 : GO(0)\nMOVEBUFFERSIZE(0) = 4\n",
        "MOVER(0) = 5 : GO(0)\nPAUSE IDLE(0)\nMOVEBUFFERSIZE(0) = 4\n",
    ),
    "buffer-full": _run_mccl(
        "1MN,2MN,1CM1,2CM1,1SN\nMD1,1CP1,1MR1,2MR1\nMC1,RP1000\n1GO\n",
        "1MN,2MN,1CM1,2CM1,1SN\nMD1,1CP1,1MR1,2MR1\nMC1,RP5\n1GO\n",
    ),
    "never": _run("PAUSE INX(2)\nPRINT 1\n", "PAUSE IDLE(0)\nPRINT 1\n"),
    "not-primed": _run("PRINT ERRCODE\n", "If ERRORPRESENT(0, 0) Then PRINT ERRORREADNEXT(0, 0)\n"),
    "recursion": _run(
        "PRINT Down(9)\nFunction Down(ByVal n As Integer) As Integer\n  Down = Down(n - 1)\nEnd Function\n",
        "PRINT Down(9)\nFunction Down(ByVal n As Integer) As Integer\n  If n > 0 Then Down = Down(n - 1)\n"
        "End Function\n",
    ),
    "golden": _commands({MINT: _MOVE}, f"verify {MINT} --format json", f"verify --update {MINT}"),
    "beyond-limit": _machines(
        "SPEED(0) = 500\n" + _MOVE,
        "[axis.0.limits]\nspeed = 1\n",
        "[axis.0.limits]\nspeed = 1000\nacceleration = 1e9\n",
        f"certify {MINT}",
    ),
    "window": _commands({MINT: _MOVE}, f"plot {MINT} pick.svg --from 100", f"plot {MINT} pick.svg"),
    "budget": _machines(_MOVE, "[budget]\ntime = 0.001\n", "[budget]\ntime = 10\n"),
    "recording": _commands(
        {MINT: _MOVE, "drive.csv": "time,PosAct\n0,0\n0.01,2\n0.02,5\n0.03,5\n0.04,5\n"},
        f"compare {MINT} drive.csv",
        f"compare {MINT} drive.csv --map position.0=PosAct",
    ),
    "extra": _commands({MINT: _MOVE}, f"trace {MINT} pick.parquet", f"trace {MINT} pick.csv"),
    "file": _commands({MINT: _MOVE}, "run pack.mnt", f"run {MINT}"),
    "address": _commands({MCCL: "1MN\n"}, "serve --tcp 203.0.113.1:5000", "serve --tcp 127.0.0.1:5000"),
    "machine-file": _machines(_MOVE, "[axis.0]\nspeeed = 5\n", "[axis.0]\ntravel = [0, 10]\n"),
    "option": _commands(
        {MINT: "SPEED(0) = 100\n" + _MOVE},
        f"run {MINT} --set SPEED[0]@2=250",
        f"run {MINT} --set SPEED[0]@1=250",
    ),
    "guess": _machines(
        "PAUSE INX(2)\n",
        "[[input]]\nchannel = 2\nat = 0.5\nvalue = 1\nguess = true\n",
        "[[input]]\nchannel = 2\nat = 0.5\nvalue = 1\n",
    ),
    "not-a-number": _commands(
        {MINT: 'Dim n\nINPUT "How many? ", n\nPRINT n\n'}, f"run {MINT} --answer 3x", f"run {MINT} --answer 3"
    ),
    "unasked": _commands({MINT: _MOVE}, f"run {MINT} --answer 5", f"run {MINT}"),
    "command-error": _run_mccl("1MN,1GO\n", "1MN,1VM,1GO\n"),
    "model": _commands(
        {MINT: "SPEED.0 = 5\n" + _MOVE, "new.mnt": "SPEED(0) = 5\n" + _MOVE},
        f"check {MINT} --model mintmt",
        "check new.mnt --model mintmt",
    ),
}

# By code: what to do about it.
FIXES: dict[str, str] = {
    "syntax": 'write what the hint names at the mark, such as a missing ) or "; motionlang help WORD shows how a '
    "keyword is written",
    "language": "give the file the extension of its language, or choose the language with --lang",
    "missing-end": "close the block with the End, Next or Until that the hint names",
    "stray-end": "delete the line, or open the block before it",
    "read-only": "read the keyword instead of writing it",
    "write-only": "read another keyword; motionlang help WORD names related ones",
    "not-a-command": "write the value with =, or read it in an expression",
    "type": "convert the value, or declare the variable with the type of the value",
    "duplicate": "rename one of the two, or assign to the one that exists",
    "axis": "use an axis of this controller; controller.axes of the machine file sets their number",
    "channel": "use a channel of this controller; the hint names the range",
    "terminal": "use a terminal that exists; the hint lists them",
    "one-terminal": "choose one terminal with TERMINAL before INPUT",
    "index": "keep the subscript within the bounds of its Dim",
    "division-by-zero": "test the divisor before this line",
    "overflow": "use a Float, or keep the value within the range of its type",
    "string-overflow": "declare a longer String",
    "argument": "test the value before this line",
    "disabled-axis": "enable the axis with DRIVEENABLE before it moves",
    "enable-input": "wait for the input before you enable the drive",
    "axis-error": "clear the error with CANCEL or RESET before the next move",
    "moving": "wait for standstill, or stop the axis first",
    "stopping": "wait for standstill with PAUSE IDLE before the next move",
    "buffer-in-use": "set the size before the first move, or wait for standstill",
    "buffer-full": "start the moves before the buffer is full",
    "never": "start the motion that the program waits for; if the machine ends the wait, --input 2=1@0.5 or the "
    "machine file says when",
    "not-primed": "read an error with ERRORREADNEXT first",
    "recursion": "end the recursion with a condition",
    "limit": "end the run sooner with --until",
    "golden": "if the change is intended, motionlang verify --update FILE accepts it",
    "beyond-limit": "reduce the speed or the rate at the line that the certificate names, or correct the limit",
    "interrupted": "end the run with --until S, or give it more processor time with --cpu S; a sweep continues with "
    "--resume",
    "crash": "report it with the folder that the hint names",
    "window": "choose a time span and axes that the run has",
    "budget": "shorten the lines that motionlang profile shows, or correct the budget",
    "recording": "assign its columns with --map; the hint lists them",
    "extra": "install the library with the command in the hint, or choose another format",
    "file": "give the path of a file that exists, in a folder that you may read and write",
    "address": "choose a free port, and an address of this computer",
    "machine-file": "write the key or the value that the hint names; motionlang check PROGRAM reports all mistakes of "
    "the file, and docs/machine-file.md lists all keys",
    "option": "write the address or the value that the hint names; motionlang check --literals FILE lists the "
    "addresses of a program",
    "guess": "correct the entry in the machine file, and remove its guess = true",
    "not-a-number": "answer with a number alone, or read a text, which may be anything: Dim s As String",
    "unasked": "remove the answer, or correct the prompt that it is for",
    "command-error": "bring the axis into the state that the hint names before the command, such as 1PM for position "
    "mode or 1MN to switch it on",
    "model": "write it in the notation of the model, or choose another model; --fix converts Mint v4",
}
