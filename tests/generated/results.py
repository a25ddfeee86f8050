"""Everything that users see of generated programs, as texts, and their digests.

A change that should alter no result must leave every text unchanged:

    python -m tests.generated.results /tmp/now
    python -m tests.generated.results /tmp/before --commit HEAD
    diff -r /tmp/before /tmp/now

This writes the texts of this tree, and those of the package of a commit, into two folders. A text is the
output of one kind of command on one program, such as `words-17.damaged.txt`. `results.txt` has the digests of
all texts, one line per program, and a test compares them; `pytest tests/generated/test_results.py --update`
rewrites it.

A case is named `FAMILY-SEED`, or `gallery-NAME` for every second program of `scripts/`. Some cases write to a
coloured terminal of 60 or 100 columns, the others to a pipe (`on_terminal`). Digests do not depend on the
last digits of long figures, which differ between mathematical libraries.
"""

from __future__ import annotations

import argparse
import contextlib
import hashlib
import io
import os
import re
import subprocess
import sys
import tempfile
from collections.abc import Callable, Iterator
from pathlib import Path

from motionlang import __version__
from motionlang.cli import main as command
from motionlang.kernel import Source, run
from tests.commits import unpacked
from tests.extras import ABSENT
from tests.generated import handlers, sessions, tasks
from tests.generated.command_lines import command_line
from tests.generated.damage import damaged
from tests.generated.draw import Draw
from tests.generated.motion import Generated, generate
from tests.generated.pictures import described, picture_line

if "lsp" not in ABSENT:
    from test_lsp.editor.answers import answers, machine_file_answers

ROOT = Path(__file__).parents[2]
DIGESTS = Path(__file__).with_name("results.txt")
# The distributions whose commands and answers are among the texts.
EXTRAS = {"extras/lsp": "motionlang_lsp", "extras/explore": "motionlang_explore"}
# The seeds of each family of programs, and of command lines without a program.
SEEDS = {
    "motion": range(1, 37),
    "words": range(1, 55),
    "tasks": range(1, 17),
    "handlers": range(1, 13),
    "commands": range(1, 169),
    "pictures": range(1, 31),
}
# Columns of the terminal by the last two bits of a seed; None for a pipe.
TERMINALS = (None, 60, None, 100)
# Machine seconds of a run.
UNTIL = "3"
# Added to each machine file, for the certificate.
LIMITS = """
[axis.1.limits]
position = [-50.0, 50.0]
speed = 60.0
acceleration = 900.0
jerk = 1e5
"""
MOTOR = """\
kind = "brushless"
resistance = 1.2
inductance = 2e-3
torque_constant = 0.06
inertia = 3e-5
amplifier_gain = 6.0
"""
_FIGURE = re.compile(r"-?\d+\.\d+(?:e[+-]?\d+)?|-?\d+e-\d+")
# Figures of at least this many characters are rounded to significant digits and to decimals; smaller ones than
# `SMALL` are only rounding errors of others. `OFF` moves exact halves of the last digit to one side.
LONG, DIGITS, DECIMALS, SMALL, OFF = 11, 9, 11, 1e-9, 1.0 + 3e-12

# What an editor shows is left out without motionlang-lsp, and `init` without motionlang-explore.
LEFT_OUT = (
    *(("editor", "machine") if "lsp" in ABSENT else ()),
    *(("init",) if "explore" in ABSENT else ()),
)

# Texts without a digest. The first five depend on the last bit of a figure: whether two times are the same, or a
# figure has another sign.
UNSTABLE = (
    "motion-2.compare", "motion-32.table", "words-41.certify", "pictures-24.picture",
    "tasks-15.init",
    # An eigenvalue, and the decay of simulated motors, whose last digits differ between versions of numpy.
    "commands-13.output", "pictures-15.picture",
)  # fmt: skip


def names() -> list[str]:
    """Return the names of all cases."""
    drawn = [f"{family}-{seed}" for family, seeds in SEEDS.items() for seed in seeds]
    return [*drawn, *(f"gallery-{name}" for name in sorted(_gallery())[::2])]


def _gallery() -> dict[str, Path]:
    return {path.name: path for path in (ROOT / "scripts").rglob("*") if path.suffix in (".mnt", ".mcl")}


def digests(name: str) -> dict[str, str]:
    """Return the digest of each text of a case, by kind."""
    return {
        kind: hashlib.sha256(rounded(text).encode()).hexdigest()[:7]
        for kind, text in texts(name).items()
        if f"{name}.{kind}" not in UNSTABLE
    }


def rounded(text: str) -> str:
    """Return a text with its long figures rounded to fewer digits."""

    def figure(match: re.Match[str]) -> str:
        if len(match[0]) < LONG and "e-" not in match[0]:
            return match[0]
        value = float(match[0])
        return "0.0" if abs(value) < SMALL else repr(round(float(f"{value * OFF:.{DIGITS}g}"), DECIMALS))

    return _FIGURE.sub(figure, text)


def texts(name: str) -> dict[str, str]:
    """Return the texts of a case by kind.

    The working directory must be a folder that the case may write to.
    """
    family, _, seed = name.partition("-")
    with on_terminal(TERMINALS[int(seed) % 4] if seed.isdigit() else None):
        found = _texts(family, seed)
    return {kind: text.replace(__version__, "VERSION") for kind, text in found.items()}


def _texts(family: str, seed: str) -> dict[str, str]:
    if family == "commands":
        line = command_line(int(seed))
        return {"program": " ".join(line), "output": said(*line)}
    if family == "pictures":
        return _pictures(int(seed))
    program = _program(family, seed)
    _write(program.name, program)
    found = {"program": program.text + program.machine_file}
    if family == "gallery":
        found["damaged"] = _damaged(program)
        if "lsp" not in ABSENT:
            found |= {"editor": _editor(program), "machine": _machine(program, seed)}
        return found
    found["report"] = said("run", program.name, "--format", "json", "--until", UNTIL)
    for kind in _kinds(program.seed):
        if kind not in LEFT_OUT:
            found[kind] = _KINDS[kind](program)
    if program.seed % 6 == 2:
        found["session"] = sessions.shown(program)
    return found


def _pictures(seed: int) -> dict[str, str]:
    """Draw the motion of a program, the rows of a sweep, or a command's own figure."""
    if seed % 2:
        line = picture_line(seed // 2)
        program = " ".join(line)
    else:
        made = generate(seed, "motion" if seed % 4 else "words")
        _write(made.name, made)
        program = made.text + made.machine_file
        first = "0" if made.language == "mint" else "1"
        options = (
            [],
            ["--path", f"{first},2"],
            ["--axes", first, "--from", "0.1", "--to", "0.9"],
        )[seed // 2 % 3]
        line = ["plot", made.name, "a.svg", "--until", UNTIL, *options]
    return {"program": program, **_drawn(line)}


def _drawn(line: list[str]) -> dict[str, str]:
    """Return the output of a command, and the description of its figure `a.svg`."""
    with described():
        printed = said(*line)
    drawn = Path("a.svg").read_text(encoding="utf-8") if Path("a.svg").exists() else "no picture\n"
    Path("a.svg").unlink(missing_ok=True)
    return {"output": printed, "picture": drawn}


def _kinds(seed: int) -> Iterator[str]:
    """Yield the two kinds of command for the program of a seed."""
    kinds = tuple(_KINDS)
    yield kinds[seed % len(kinds)]
    yield kinds[(seed * 5 + 3) % len(kinds)]


def _program(family: str, seed: str) -> Generated:
    """Return the program of a case.

    A program of the gallery is named by `seed` and has no machine.
    """
    if family in ("motion", "words"):
        return generate(int(seed), family)
    if family == "gallery":
        path = _gallery()[seed]
        return Generated(len(seed), path.parent.name, path.read_text(encoding="utf-8"), {}, path.stem)
    text, machine = (tasks if family == "tasks" else handlers).program(int(seed))
    return Generated(int(seed), "mint", text, machine, family)


def _write(name: str, program: Generated, text: str = "", machine: str = LIMITS) -> None:
    Path(name).write_text(text or program.text, encoding="utf-8")
    Path(name).with_suffix(".machine.toml").write_text(program.machine_file + machine, encoding="utf-8")


class _Terminal(io.StringIO):
    """Standard output of a command: a terminal if `COLUMNS` is set, else a pipe."""

    encoding = "utf-8"

    def isatty(self) -> bool:
        return "COLUMNS" in os.environ


@contextlib.contextmanager
def on_terminal(columns: int | None) -> Iterator[None]:
    """Let commands write to a terminal of this width, or to a pipe for None."""
    if columns is not None:
        os.environ["COLUMNS"] = str(columns)
    try:
        yield
    finally:
        os.environ.pop("COLUMNS", None)


def said(*arguments: str) -> str:
    """Return the output of a command, its error output and its exit status."""
    out, errors = _Terminal(), io.StringIO()
    with contextlib.redirect_stdout(out), contextlib.redirect_stderr(errors):
        try:
            status: object = command(arguments)
        except SystemExit as end:
            status = end.code
    return f"{out.getvalue()}{errors.getvalue()}exit status {status}\n"


def _said(verb: str, program: Generated, *options: str) -> str:
    return said(verb, program.name, *options, "--until", UNTIL)


def _written(printed: str, path: str) -> str:
    """Return what a command printed, and the file that it wrote."""
    written = Path(path)
    return printed + (written.read_text(encoding="utf-8") if written.exists() else "no file\n")


def _changes(program: Generated) -> str:
    """Return the output of a run, and the levels of its channels."""
    options = ("--rate", "25", "--columns", "position", "--channels")
    return _written(_said("trace", program, "a.csv", *options), "a.csv")


def _traced(program: Generated) -> str:
    """Certify a program, and sample its motion."""
    certified = _said("certify", program, "-q")
    _said("trace", program, "a.csv", "--rate", "25")
    return _written(certified, "a.csv")


# Options of `check`.
_CHECKS = (
    (), ("--evidence",), ("--literals",), ("--format", "sarif"), (), ("--format", "junit"), ("--literals",),
    ("--format", "github"), (), ("--strict",),
)  # fmt: skip
_MODELS = {"mint": ("mintmt", "NextMove ESB", "mint4"), "mccl": ("dcx-pci100", "dcx-at200", "multiflex")}


def _damaged(program: Generated) -> str:
    """Return the findings of `check` in a program and in a copy with mistakes."""
    text = damaged(program.text, program.language, program.seed)
    _write(f"damaged{Path(program.name).suffix}", program, text)
    files = program.name, f"damaged{Path(program.name).suffix}"
    model = ("--model", _MODELS[program.language][program.seed % 3]) if program.seed % 5 == 0 else ()
    return text + said("check", "-j", "1", *model, *_CHECKS[program.seed % len(_CHECKS)], *files)


def _fault(program: Generated) -> str:
    """Return the run of a copy with mistakes, and the copy after a quick fix."""
    name = f"fault{Path(program.name).suffix}"
    _write(name, program, damaged(program.text, program.language, program.seed + 1000))
    fixed = said("check", "-j", "1", "--fix", name)
    return fixed + said("run", name, "--until", UNTIL) + Path(name).read_text(encoding="utf-8")


def _machine(program: Generated, name: str) -> str:
    """Return the output of `check` and an editor for a machine file with mistakes."""
    path = _gallery()[name].with_suffix(".machine.toml")
    if not path.exists():
        return ""
    text = damaged(path.read_text(encoding="utf-8"), "mint", program.seed + 3000, 1)
    _write(program.name, program, machine=text)
    return text + said("check", "-j", "1", program.name) + machine_file_answers(text, Draw(program.seed))


def _variant(program: Generated) -> str:
    """Write a variant of the program with some larger figures, and return its name."""
    name = f"variant{Path(program.name).suffix}"
    draw = Draw(program.seed)
    varied = re.sub(
        r"(?<![\w.(])\d\d+(?![\w.])",
        lambda found: str(int(found[0]) + 1) if draw.chance(0.2) else found[0],
        program.text,
    )
    _write(name, program, varied)
    return name


def _diff(program: Generated) -> str:
    """Compare the program with a variant."""
    name = _variant(program)
    form = ("--format", "json") if program.seed % 3 == 0 else ()
    return said("diff", program.name, name, "--until", UNTIL, *form)


def _compare(program: Generated) -> str:
    """Compare the program with a recording of a variant."""
    name = _variant(program)
    traced = said("trace", name, "r.csv", "--until", UNTIL, "--rate", "200")
    form = ("--format", "json") if program.seed % 3 == 0 else ()
    return traced + said("compare", program.name, "r.csv", "--until", UNTIL, *form)


def _golden(program: Generated) -> str:
    """Write the golden files of a program, and compare a variant with them."""
    name = f"golden{Path(program.name).suffix}"
    limited = f"{LIMITS}\n[run]\nuntil = {UNTIL}\n"
    _write(name, program, machine=limited)
    written = said("verify", "-j", "1", "--update", name)
    _write(name, program, Path(_variant(program)).read_text(encoding="utf-8"), machine=limited)
    form = (("--review",), (), ("--format", "json"))[program.seed % 3]
    return written + said("verify", "-j", "1", *form, name)


def _tree(program: Generated) -> str:
    """Return the syntax tree, which is below the findings."""
    shown = said("check", program.name, "--tree")
    return shown[shown.find("Module\n") :]


def _init(program: Generated) -> str:
    """Guess a machine for the program."""
    name = f"first{Path(program.name).suffix}"
    _write(name, program)
    machine = Path(name).with_suffix(".machine.toml")
    machine.unlink()
    printed = said("init", name, "--until", UNTIL, "--seconds", "600")
    return printed + (machine.read_text(encoding="utf-8") if machine.exists() else "no machine file\n")


def _profile(program: Generated) -> str:
    """Return the time profile of a run."""
    form = (".json", ".csv", ".csv")[program.seed // 4 % 3]
    return _written(_said("profile", program, "-o", f"a{form}"), f"a{form}")


def _notebook(program: Generated) -> str:
    source = Source(program.name, program.text)
    return run(source, machine=program.machine, until=float(UNTIL))._repr_html_()


def _motor(program: Generated) -> str:
    """Run the program with a simulated motor, with or without friction."""
    name = f"motor{Path(program.name).suffix}"
    friction = (0.0, 0.01)[program.seed % 2]
    _write(name, program, machine=f"{LIMITS}\n[axis.1.plant]\n{MOTOR}coulomb = {friction}\n")
    return said("run", name, "--until", "1", "--format", ("text", "json")[program.seed // 2 % 2])


def _sweep(program: Generated) -> str:
    """Run the program in two variants."""
    varied = "--vary", "controller.instruction_time=1e-5,1e-4", "--keep", "time,position.0,peak.0,prints"
    return said("sweep", program.name, "-j", "1", "--until", UNTIL, *varied)


def _editor(program: Generated) -> str:
    """Return the answers of the language server for a copy with mistakes."""
    text = damaged(program.text, program.language, program.seed + 2000)
    return text + answers(program, text)


_KINDS: dict[str, Callable[[Generated], str]] = {
    "damaged": _damaged,
    "table": lambda program: _said("profile", program, *(["--all"] if program.seed // 4 % 2 else [])),
    "editor": _editor,
    "trace": _traced,
    "fault": _fault,
    "certify": lambda program: _said("certify", program),
    "columns": lambda program: _written(
        _said("trace", program, "p.csv", "--columns", "position,jerk", "--rate", "50"), "p.csv"
    ),
    "diff": _diff,
    "picture": lambda program: _written(_said("plot", program, "a.html"), "a.html"),
    "profile": _profile,
    "changes": _changes,
    "tree": _tree,
    "sweep": _sweep,
    "compare": _compare,
    "golden": _golden,
    "init": _init,
    "notebook": _notebook,
    "motor": _motor,
}


def write_texts(folder: Path, chosen: list[str]) -> None:
    """Write the texts of cases into a folder."""
    for name in chosen:
        for kind, text in texts(name).items():
            (folder / f"{name}.{kind}.txt").write_text(text, encoding="utf-8")


def main(arguments: list[str]) -> int:
    """Write the texts of some cases, or of all cases, into a folder."""
    parser = argparse.ArgumentParser(prog="tests.generated.results")
    parser.add_argument("folder", type=Path)
    parser.add_argument("name", nargs="*", help="a case, such as words-17; default: all")
    parser.add_argument("--commit", help="use the package of this commit instead of this tree's")
    given = parser.parse_args(arguments)
    folder = given.folder.absolute()
    folder.mkdir(parents=True, exist_ok=True)
    with tempfile.TemporaryDirectory() as temporary:
        if given.commit is None:
            os.environ["MOTIONLANG_CACHE"] = temporary
            os.chdir(temporary)
            write_texts(folder, given.name or names())
            return 0
        packages = [f"{folder}/{name}" for folder, name in EXTRAS.items()]
        unpacked(given.commit, Path(temporary), "motionlang", "grammars", *packages)
        paths = os.pathsep.join(
            str(Path(root, each)) for each in (".", *EXTRAS) for root in (temporary, ROOT)
        )
        again = [sys.executable, "-m", "tests.generated.results", str(folder), *given.name]
        return subprocess.run(
            again, check=False, cwd=temporary, env={**os.environ, "PYTHONPATH": paths}
        ).returncode


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
