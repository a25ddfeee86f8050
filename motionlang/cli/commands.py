"""The whole command line, read by argparse: every command, its options and its help."""

from __future__ import annotations

import argparse
import sys
from importlib import import_module
from typing import TYPE_CHECKING

from motionlang import __version__
from motionlang.cli.complaints import complain
from motionlang.cli.machine_options import add_dialect, add_machine, set_values
from motionlang.cli.options import Options
from motionlang.cli.parallel import add_jobs
from motionlang.cli.parser import Parser, add_command
from motionlang.cli.run_options import add_run
from motionlang.errors import ProgramError
from motionlang.execution import machine_of

if TYPE_CHECKING:
    from collections.abc import Callable, Sequence

    from motionlang.cli.parser import Commands

PROGRAM = "motionlang"
# Commands whose modules, with options of their own, are imported only where they are meant.
FAMILIES = {
    "pvt": ("motionlang.cli.pvt", "position-velocity-time moves for Copley drives"),
    "servo": ("motionlang.cli.servo", "the servo behind the profile: slip, DAC steps, tuning, comparison"),
    "diff": ("motionlang.cli.diff", "tell what a change did: two programs, or one and its golden files"),
    "sweep": ("motionlang.cli.sweep_options", "run a program in many variants, and say which is best"),
    "compare": (
        "motionlang.cli.compare",
        "hold what a real controller recorded against the run: residuals, lag and overshoot, line by line",
    ),
    "probe": ("motionlang.cli.probe", "ask a real controller which of the open readings hold"),
    "serve": ("motionlang.cli.serve", "let hosts talk to a virtual board, or to a Mint program over Modbus"),
}

EPILOG = """\
examples:
  motionlang run pick.mnt                        what the program prints, then a table of its moves
  motionlang run pick.mnt --plot pick.png        position, velocity and acceleration as a picture
  motionlang run pick.mnt --report json          the same figures for another program
  motionlang check *.mnt                         every mistake of every file, nothing run
  motionlang plan --distance 20 --time 0.6 --rule third
                                                 the speed and the rates of a move, and a program for it
  motionlang keywords ACCELTIME                  what a word means, with an example
"""


def parse(given: Sequence[str]) -> int:
    """Read a command line and run its command; argparse ends the process with 2 where it is wrong."""
    if given and given[0] == "help":
        given = [*given[1:2], "--help"]
    parser = build_parser(given[0] if given else "")
    if not given:
        parser.print_help(sys.stderr)
        return 2
    arguments, unknown = parser.parse_known_args(_with_factor(given))
    arguments.given = list(given)
    if unknown:
        whose = getattr(arguments, "parser", parser)
        whose.error(f"unrecognized arguments: {' '.join(unknown)}")
    try:
        if hasattr(arguments, "handler"):
            handler: Callable[[argparse.Namespace], int] = arguments.handler
            return handler(arguments)
        command: Callable[[argparse.Namespace, argparse.ArgumentParser], int] = arguments.command
        return command(arguments, arguments.parser)
    except ProgramError as error:  # of a machine that cannot be built as the command line has it
        complain(error.diagnostics, None, "")
        return 1


def _with_factor(given: Sequence[str]) -> list[str]:
    """`--realtime FILE` said as `--realtime=1 FILE`: argparse would take the file for the factor."""
    words = list(given)
    for i, word in enumerate(words):
        following = words[i + 1] if i + 1 < len(words) else ""
        if word == "--realtime" and not following[:1].isdigit() and following[:1] not in ("-", "."):
            words[i] = "--realtime=1"
    return words


def build_parser(command: str = "") -> argparse.ArgumentParser:
    """The parser with all its commands; those of `FAMILIES` are spelled out where `command` is one of them, or "*"."""
    parser = Parser(
        prog=PROGRAM,
        description="Run programs of motion controllers offline, in virtual time: Mint (Baldor/ABB) and MCCL (PMC).",
        epilog=EPILOG,
    )
    parser.add_argument("--version", action="version", version=f"{PROGRAM} {__version__}")
    commands = parser.add_subparsers(metavar="COMMAND", required=True)
    for add in (add_run, _add_check, _add_repl, _add_plan, _add_profiles, _add_keywords, _add_verify):
        add(commands)
    for name, (module, summary) in FAMILIES.items():
        if command in (name, "*"):
            import_module(module).add_parser(commands)
        else:
            commands.add_parser(name, help=summary)
    _add_completion(commands)
    return parser


# ------------------------------------------------------------------------------------------- the commands


CHECK_EPILOG = """\
Warnings are about what compiles and yet is hardly meant: a move that no GO starts, a wait that nothing can end.
docs/lint.md explains each; a comment with `lint: ignore CODE` silences one on its line.

exit status: 0 no file has a mistake; 1 one has (with --strict, or a warning); 2 the command line is wrong

examples:
  motionlang check pick.mnt --machine cell.toml      moves beyond the machine's travel, inputs that nothing drives
  motionlang check old.prg --model mintmt            what MintMT does not accept of a Mint v4 program
"""


def _add_check(commands: Commands) -> None:
    parser = add_command(
        commands,
        "check",
        "report every mistake and every warning of every file; nothing is run",
        _check,
        CHECK_EPILOG,
    )
    parser.add_argument(
        "files", metavar="FILE", nargs="+", help="programs, or folders with programs; - reads standard input"
    )
    add_dialect(parser)
    parser.add_argument(
        "--machine",
        metavar="M.toml",
        help="the machine the programs are for; without it pick.machine.toml beside pick.mnt, if there is one",
    )
    parser.add_argument(
        "--model",
        type=_model,
        metavar="MODEL",
        help="the controller they are for: mint4 or mintmt, or one of its names such as NextMove ESB; for MCCL one of "
        f"{', '.join(_mccl_models())}",
    )
    parser.add_argument("--strict", action="store_true", help="count warnings as mistakes")
    parser.add_argument(
        "--evidence",
        action="store_true",
        help="list the open readings that each program depends on, and how strong each is",
    )
    parser.add_argument(
        "--fix",
        action="store_true",
        help="write what can only have been meant one way into the files, then tell what is left",
    )
    _add_form(parser)
    add_jobs(parser)


def _add_form(parser: argparse.ArgumentParser) -> None:
    from motionlang.views.findings import FORMATS

    parser.add_argument(
        "--format",
        choices=FORMATS,
        default="text",
        help="what is printed: text; one document for another tool, as JSON, SARIF or JUnit's XML; or the commands by "
        "which GitHub marks the lines",
    )
    parser.add_argument(
        "--json", action="store_const", dest="format", const="json", help="the same as --format json"
    )


def _mccl_models() -> list[str]:
    from motionlang.mccl.models import MODELS

    return list(MODELS)


def _model(text: str) -> str:
    from motionlang.lang.dialect import unknown_model

    problem = unknown_model(text)
    if problem is not None:
        raise argparse.ArgumentTypeError("; ".join(problem))
    return text


def _check(arguments: argparse.Namespace, parser: argparse.ArgumentParser) -> int:
    from motionlang.cli.check import CheckOptions, check_command

    options = CheckOptions(
        arguments.dialect,
        form=arguments.format,
        jobs=arguments.jobs,
        machine=arguments.machine,
        model=arguments.model,
        strict=arguments.strict,
        evidence=arguments.evidence,
        fix=arguments.fix,
    )
    return check_command(arguments.files, options)


def _add_repl(commands: Commands) -> None:
    parser = add_command(commands, "repl", "type a program line by line and watch the axes", _repl)
    parser.add_argument("file", metavar="FILE", nargs="?", help="a program to run first")
    add_machine(parser)


def _repl(arguments: argparse.Namespace, parser: argparse.ArgumentParser) -> int:
    from motionlang.cli.input_files import read_machine_file
    from motionlang.repl import main

    settings: dict[str, object] = {}
    overrides: dict[str, float | str] = {}
    set_values(arguments.set, settings, overrides, parser)
    options = Options(arguments.machine or "")
    options.machine = machine_of(arguments.file or None, arguments.machine)
    if options.machine is not None:
        status = read_machine_file(options, settings)
        if status:
            return status
    return main(arguments.dialect, arguments.file, settings, overrides)


def _add_plan(commands: Commands) -> None:
    from motionlang.cli.plan import add_arguments, plan_command

    parser = add_command(
        commands, "plan", "find the missing figures of a move, and a program for it", plan_command
    )
    add_arguments(parser)


def _add_profiles(commands: Commands) -> None:
    from motionlang.cli.profiles import add_arguments, profiles_command

    parser = add_command(
        commands, "profiles", "compare the four velocity profiles of PMC's TN1069 by a move", profiles_command
    )
    add_arguments(parser)


def _add_keywords(commands: Commands) -> None:
    parser = add_command(commands, "keywords", "list the words of a language, or explain one", _keywords)
    parser.add_argument(
        "name",
        metavar="NAME",
        nargs="?",
        help="the word to explain, by its name or its short form, or the group to list",
    )
    add_dialect(parser, "one language; both without it")
    parser.add_argument("--json", action="store_true", help="print one JSON document and nothing else")


def _keywords(arguments: argparse.Namespace, parser: argparse.ArgumentParser) -> int:
    from motionlang.cli.keywords import keywords_command

    return keywords_command(arguments.name, arguments.dialect, arguments.json)


def _add_verify(commands: Commands) -> None:
    parser = add_command(commands, "verify", "run programs and compare them with their golden files", _verify)
    parser.add_argument(
        "paths",
        metavar="PATH",
        nargs="*",
        default=["scripts"],
        help="programs, or folders with programs (scripts); pick.mnt has its report in pick.golden.json beside it, "
        "and what it prints in pick.golden.txt",
    )
    parser.add_argument("--update", action="store_true", help="write the golden files anew")
    parser.add_argument(
        "--review", action="store_true", help="ask of each change of each program whether it is accepted"
    )
    _add_form(parser)
    add_jobs(parser)


def _verify(arguments: argparse.Namespace, parser: argparse.ArgumentParser) -> int:
    from motionlang.cli.verify import verify_command

    if arguments.review and (arguments.update or arguments.format != "text"):
        parser.error("--review asks, and goes with neither --update, which accepts everything, nor --format")
    return verify_command(
        arguments.paths, arguments.update, arguments.format, arguments.jobs, arguments.review
    )


def _add_completion(commands: Commands) -> None:
    from motionlang.cli.completion import SHELLS, completion_command

    parser = add_command(
        commands,
        "completion",
        "print what a shell needs to complete the command line",
        completion_command,
        COMPLETION,
    )
    parser.add_argument("shell", choices=SHELLS, help="the shell; needs the extra completion")


COMPLETION = """\
examples:
  motionlang completion bash > ~/.local/share/bash-completion/completions/motionlang
  motionlang completion zsh > ~/.zfunc/_motionlang
  motionlang completion fish > ~/.config/fish/completions/motionlang.fish
"""
