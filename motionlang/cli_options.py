"""The whole command line, read by argparse: every command, its options and its help."""

from __future__ import annotations

import argparse
import math
import re
import sys
from importlib import import_module
from typing import TYPE_CHECKING, NoReturn

from motionlang import __version__
from motionlang.cli_run import PLOTS, RATE, REPORTS, SERVO_RATE, TRACES, TRAJECTORY_RATE, Options
from motionlang.errors import nearest
from motionlang.execution import ONE_SHIFT, dialects
from motionlang.lang.machine_file import KEYS, check_setting

if TYPE_CHECKING:
    from collections.abc import Callable, Sequence

PROGRAM = "motionlang"
HIGHEST_RATE = 10e6
# Commands whose modules, with options of their own, are imported only where they are meant.
FAMILIES = {
    "pvt": ("motionlang.cli_pvt", "position-velocity-time moves for Copley drives"),
    "servo": ("motionlang.cli_servo", "the servo behind the profile: slip, DAC steps, tuning, comparison"),
    "serve": ("motionlang.cli_serve", "let hosts talk to a virtual board, or to a Mint program over Modbus"),
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

RUN_EPILOG = """\
The language is told by the suffix: .mnt .mntx .prg are Mint, .mcl .mccl are MCCL.
Time is the machine's own: an hour of it takes a moment, unless --realtime is given.

exit status: 0 the program ran; 1 it is wrong or faulted (standard error says where); 2 the command line is wrong

examples:
  motionlang run pick.mnt --until 60 --trace pick.csv --rate 500
  motionlang run pick.mcl --trace pick.csv --as-controller
  motionlang run pick.mnt --set controller.axes=2 --set pitch=5
  generate-program | motionlang run - --dialect mint --report json
"""


def parse(given: Sequence[str]) -> int:
    """Read a command line and run its command; argparse ends the process with 2 where it is wrong."""
    parser = build_parser(given[0] if given else "")
    if not given:
        parser.print_help(sys.stderr)
        return 2
    arguments = parser.parse_args(_with_factor(given))
    if hasattr(arguments, "handler"):
        handler: Callable[[argparse.Namespace], int] = arguments.handler
        return handler(arguments)
    command: Callable[[argparse.Namespace, argparse.ArgumentParser], int] = arguments.command
    return command(arguments, arguments.parser)


def _with_factor(given: Sequence[str]) -> list[str]:
    """`--realtime FILE` said as `--realtime=1 FILE`: argparse would take the file for the factor."""
    words = list(given)
    for i, word in enumerate(words):
        following = words[i + 1] if i + 1 < len(words) else ""
        if word == "--realtime" and not following[:1].isdigit() and following[:1] not in ("-", "."):
            words[i] = "--realtime=1"
    return words


def build_parser(command: str = "") -> argparse.ArgumentParser:
    """The parser with all its commands; those of `FAMILIES` are only spelled out where `command` is one of them."""
    parser = _Parser(
        prog=PROGRAM,
        description="Run programs of motion controllers offline, in virtual time: Mint (Baldor/ABB) and MCCL (PMC).",
        epilog=EPILOG,
    )
    parser.add_argument("--version", action="version", version=f"{PROGRAM} {__version__}")
    commands = parser.add_subparsers(metavar="COMMAND", required=True)
    for add in (_add_run, _add_check, _add_repl, _add_plan, _add_profiles, _add_keywords, _add_verify):
        add(commands)
    for name, (module, summary) in FAMILIES.items():
        if name == command:
            import_module(module).add_parser(commands)
        else:
            commands.add_parser(name, help=summary)
    return parser


class _Parser(argparse.ArgumentParser):
    """argparse with whole words only and with help texts that keep their lines."""

    def __init__(self, **options: object) -> None:
        options.setdefault("formatter_class", argparse.RawDescriptionHelpFormatter)
        super().__init__(allow_abbrev=False, **options)  # type: ignore[arg-type]

    def error(self, message: str) -> NoReturn:
        """Say what is wrong in two lines and end with 2; the usage line is what --help is for."""
        self.exit(2, f"{self.prog}: error: {_in_our_words(message)}\n  hint: {self._hint(message)}\n")

    def _hint(self, message: str) -> str:
        wrong = re.search(r"unrecognized arguments: (--[\w-]+)|invalid choice: '([\w-]+)'", message)
        if wrong is not None:
            near = nearest(wrong[1] or wrong[2], self._words())
            if near is not None:
                return f"did you mean {near}?"
        return f"{self.prog} --help explains the command line"

    def _words(self) -> list[str]:
        """Every option and every choice, those of the commands too."""
        words: list[str] = []
        for action in self._actions:
            words += [*action.option_strings, *map(str, action.choices or ())]
            if isinstance(action, argparse._SubParsersAction):
                words += [word for parser in action.choices.values() for word in parser._words()]
        return words


def _in_our_words(message: str) -> str:
    """A wrong choice as it is said here, whichever way this Python's argparse quotes it."""
    wrong = re.fullmatch(r"argument (.+?): invalid choice: '(.*)' \(choose from (.*)\)", message, re.DOTALL)
    if wrong is None:
        return message
    if wrong[1] == "COMMAND" or " | " in wrong[1]:
        return f"there is no command {wrong[2]}"
    choices = wrong[3].replace("'", "")
    return f"argument {wrong[1]}: {wrong[2]!r} is not one of {choices}"


if TYPE_CHECKING:
    Commands = argparse._SubParsersAction[_Parser]


def _command(
    commands: Commands, name: str, summary: str, call: Callable[..., int], epilog: str = ""
) -> argparse.ArgumentParser:
    parser = commands.add_parser(name, help=summary, description=_sentence(summary), epilog=epilog)
    parser.set_defaults(command=call, parser=parser)
    return parser


def _either(words: Sequence[str]) -> str:
    return f"{', '.join(words[:-1])} or {words[-1]}"


def _sentence(summary: str) -> str:
    return summary[0].upper() + summary[1:] + "."


# ------------------------------------------------------------------------------------------------------ run


def _add_run(commands: Commands) -> None:
    parser = _command(
        commands, "run", "run a program on the virtual machine and report what it did", _run, RUN_EPILOG
    )
    parser.add_argument("file", metavar="FILE", help="the program; - reads standard input")
    add_machine(parser)
    parser.add_argument(
        "--report",
        choices=REPORTS,
        default="table",
        help="what follows the program's own output: a table (the default), or nothing; "
        "json prints one JSON document and nothing else",
    )
    parser.add_argument(
        "--until",
        type=_time,
        metavar="S",
        help="end the run after S seconds of machine time; without it the machine file says when, or it ends after "
        f"one shift, {ONE_SHIFT:.0f} s = 8 h",
    )
    parser.add_argument(
        "--realtime",
        type=_factor,
        nargs="?",
        const=1.0,
        metavar="FACTOR",
        help="hold the run to the wall clock, FACTOR machine seconds a second (1 without a FACTOR)",
    )
    parser.add_argument("--trace", metavar="OUT", help=f"sample the motion into a file: {_either(TRACES)}")
    parser.add_argument(
        "--rate",
        type=_rate,
        metavar="HZ",
        help=f"samples a second of the trace ({RATE:g}; with --as-controller {SERVO_RATE:g})",
    )
    parser.add_argument(
        "--as-controller",
        action="store_true",
        help="trace the points that the trajectory generator computes and the straight lines between them, "
        "which is what the servo loop is told, instead of the exact curve",
    )
    parser.add_argument(
        "--trajectory-rate",
        type=_rate,
        metavar="HZ",
        help=f"points a second of --as-controller ({TRAJECTORY_RATE:g}, as PMC's MultiFlex boards have)",
    )
    parser.add_argument("--plot", metavar="OUT", help=f"draw the motion into a file: {_either(PLOTS)}")
    parser.add_argument("--no-cache", action="store_true", help="compile anew, and do not keep the result")


def add_machine(parser: argparse.ArgumentParser) -> None:
    """What `run`, `repl` and `serve` need to know about the machine."""
    _add_dialect(parser)
    parser.add_argument(
        "--machine",
        metavar="M.toml",
        help="the machine the program is to run on; without it run takes pick.machine.toml beside pick.mnt, if there "
        "is one",
    )
    parser.add_argument(
        "--set",
        action="append",
        default=[],
        metavar="NAME=VALUE",
        help="give a value to a name of the program, or, by a dotted name, to a key of the machine file: "
        f"{', '.join(KEYS)}; may be repeated",
    )


def _add_dialect(
    parser: argparse.ArgumentParser, what: str = "the language, where the suffix does not say it"
) -> None:
    parser.add_argument(
        "--dialect", choices=dialects(), help="the language, where the suffix does not say it"
    )


def run_options(arguments: argparse.Namespace, parser: argparse.ArgumentParser) -> Options:
    """The options of a `run` line."""
    options = Options(arguments.file)
    for name in ("dialect", "machine", "report", "until", "realtime", "trace", "plot"):
        setattr(options, name, getattr(arguments, name))
    options.points = (arguments.trajectory_rate or TRAJECTORY_RATE) if arguments.as_controller else None
    options.rate = arguments.rate or (SERVO_RATE if arguments.as_controller else RATE)
    options.cache = not arguments.no_cache
    set_values(arguments.set, options.settings, options.overrides, parser)
    return options


def _run(arguments: argparse.Namespace, parser: argparse.ArgumentParser) -> int:
    from motionlang.cli_files import refused, wrong_target
    from motionlang.cli_run import refuse, run_command

    _check_sampling(arguments, parser)
    options = run_options(arguments, parser)
    for option, path in (("--trace", options.trace), ("--plot", options.plot)):
        if path is not None:
            problem = wrong_target(option, path)
            if problem is not None:
                parser.error(problem)
            diagnostic = refused(path)
            if diagnostic is not None:
                return refuse(options, [diagnostic], None, 1)
    return run_command(options)


def _check_sampling(arguments: argparse.Namespace, parser: argparse.ArgumentParser) -> None:
    """Options that would say something about nothing."""
    if arguments.trace is None:
        for name in ("rate", "as_controller"):
            if getattr(arguments, name):
                parser.error(f"--{name.replace('_', '-')} is about a trace: give --trace OUT")
    if arguments.trajectory_rate and not arguments.as_controller:
        parser.error("--trajectory-rate is about --as-controller, which is missing")


def set_values(
    pairs: Sequence[str],
    settings: dict[str, object],
    overrides: dict[str, float | str],
    parser: argparse.ArgumentParser,
) -> None:
    for pair in pairs:
        name, equals, text = pair.partition("=")
        name = name.strip()
        if not equals or not name:
            parser.error(f"--set needs NAME=VALUE, not {pair!r}")
        if "." not in name:
            overrides[name] = _value(text)
            continue
        value = _setting(text)
        problem = check_setting(name, value)
        if problem is not None:
            parser.error(f"--set {pair}: {problem[0]}; {problem[1]}")
        settings[name] = value


def _setting(text: str) -> object:
    """A machine key's value as the machine file would have it; a bare word is a text."""
    import tomllib

    try:
        return tomllib.loads(f"value = {text}")["value"]
    except (tomllib.TOMLDecodeError, RecursionError):
        return text


def _value(text: str) -> float | str:
    """A number where it reads as one."""
    try:
        return float(text)
    except ValueError:
        return text


def _number(text: str, low: float, high: float, what: str, *, open_low: bool = False) -> float:
    try:
        value = float(text)
    except ValueError:
        value = math.nan
    if not (low < value <= high or (value == low and not open_low)):
        raise argparse.ArgumentTypeError(f"{text!r} is not {what}")
    return value


def _time(text: str) -> float:
    return _number(text, 0.0, sys.float_info.max, "a time in seconds, 0 or more")


def _rate(text: str) -> float:
    what = f"a number of samples a second above 0, {HIGHEST_RATE:,.0f} at most"
    return _number(text, 0.0, HIGHEST_RATE, what, open_low=True)


def _factor(text: str) -> float:
    return _number(
        text, 0.0, sys.float_info.max, "a factor above 0: --realtime 10 is ten times as fast", open_low=True
    )


# ------------------------------------------------------------------------------------------- other commands


CHECK_EPILOG = """\
Warnings are about what compiles and yet is hardly meant: a move that no GO starts, a wait that nothing can end.
docs/lint.md explains each; a comment with `lint: ignore CODE` silences one on its line.

exit status: 0 no file has a mistake; 1 one has (with --strict, or a warning); 2 the command line is wrong

examples:
  motionlang check pick.mnt --machine cell.toml      moves beyond the machine's travel, inputs that nothing drives
  motionlang check old.prg --model mintmt            what MintMT does not accept of a Mint v4 program
"""


def _add_check(commands: Commands) -> None:
    parser = _command(
        commands,
        "check",
        "report every mistake and every warning of every file; nothing is run",
        _check,
        CHECK_EPILOG,
    )
    parser.add_argument("files", metavar="FILE", nargs="+", help="programs; - reads standard input")
    _add_dialect(parser)
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
    parser.add_argument("--json", action="store_true", help="print one JSON document and nothing else")


def _mccl_models() -> list[str]:
    from motionlang.mccl.models import MODELS

    return list(MODELS)


def _model(text: str) -> str:
    from motionlang.mint.models import NAMES, age

    if age(text) is None and text not in _mccl_models():
        near = nearest(text, [*NAMES, *_mccl_models()])
        hint = f"did you mean {near}?" if near else f"such as {', '.join([*NAMES, *_mccl_models()])}"
        raise argparse.ArgumentTypeError(f"{text!r} is no controller that is known here; {hint}")
    return text


def _check(arguments: argparse.Namespace, parser: argparse.ArgumentParser) -> int:
    from motionlang.cli_check import CheckOptions, check_command

    options = CheckOptions(
        arguments.dialect,
        as_json=arguments.json,
        machine=arguments.machine,
        model=arguments.model,
        strict=arguments.strict,
    )
    return check_command(arguments.files, options)


def _add_repl(commands: Commands) -> None:
    parser = _command(commands, "repl", "type a program line by line and watch the axes", _repl)
    parser.add_argument("file", metavar="FILE", nargs="?", help="a program to run first")
    add_machine(parser)


def _repl(arguments: argparse.Namespace, parser: argparse.ArgumentParser) -> int:
    from motionlang.cli_run import read_machine_file
    from motionlang.repl import main

    settings: dict[str, object] = {}
    overrides: dict[str, float | str] = {}
    set_values(arguments.set, settings, overrides, parser)
    options = Options(arguments.machine or "")
    options.machine = arguments.machine
    if arguments.machine is not None:
        status = read_machine_file(options, settings)
        if status:
            return status
    return main(arguments.dialect, arguments.file, settings, overrides)


def _add_plan(commands: Commands) -> None:
    from motionlang.cli_plan import add_arguments, plan_command

    parser = _command(
        commands, "plan", "find the missing figures of a move, and a program for it", plan_command
    )
    add_arguments(parser)


def _add_profiles(commands: Commands) -> None:
    parser = _command(
        commands, "profiles", "compare the four velocity profiles by the example of PMC's TN1069", _profiles
    )
    parser.add_argument(
        "--as-printed",
        action="store_true",
        help="the published figures beside the exact ones, each erratum named",
    )
    parser.add_argument("--json", action="store_true", help="print one JSON document and nothing else")


def _profiles(arguments: argparse.Namespace, parser: argparse.ArgumentParser) -> int:
    from motionlang.cli_profiles import profiles_command

    return profiles_command(arguments.as_printed, arguments.json)


def _add_keywords(commands: Commands) -> None:
    parser = _command(commands, "keywords", "list the words of a language, or explain one", _keywords)
    parser.add_argument(
        "name", metavar="NAME", nargs="?", help="the word to explain, by its name or its short form"
    )
    _add_dialect(parser, "one language; both without it")
    parser.add_argument("--json", action="store_true", help="print one JSON document and nothing else")


def _keywords(arguments: argparse.Namespace, parser: argparse.ArgumentParser) -> int:
    from motionlang.cli_keywords import keywords_command

    return keywords_command(arguments.name, arguments.dialect, arguments.json)


def _add_verify(commands: Commands) -> None:
    parser = _command(commands, "verify", "run programs and compare them with their golden files", _verify)
    parser.add_argument(
        "paths",
        metavar="PATH",
        nargs="*",
        default=["scripts"],
        help="programs, or folders with programs (scripts); pick.mnt has its report in pick.golden.json beside it, "
        "and what it prints in pick.golden.txt",
    )
    parser.add_argument("--update", action="store_true", help="write the golden files anew")


def _verify(arguments: argparse.Namespace, parser: argparse.ArgumentParser) -> int:
    from motionlang.cli_verify import verify_command

    return verify_command(arguments.paths, arguments.update)
