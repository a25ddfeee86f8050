"""The groups of options that commands share: program and machine, world, report, processes."""

from __future__ import annotations

import os
import sys
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field, fields
from html import escape
from io import BytesIO, TextIOWrapper
from typing import Any, BinaryIO, ClassVar, cast

from motionlang import kernel
from motionlang.cli.command import Command, Refused, WrongOption, flag, option
from motionlang.cli.complaints import complain, no_dialect, unreadable, unwritten
from motionlang.cli.parser import either
from motionlang.cli.readers import allowed, whole
from motionlang.kernel import (
    MACHINE_SUFFIX,
    STDIN,
    STDIN_NAME,
    Diagnostic,
    ProgramError,
    Source,
    dialect_of,
    dialects,
    language_of,
    machine_of,
)
from motionlang.kernel.files import replacing
from motionlang.kernel.lang import canonical
from motionlang.kernel.tools import clipped, shown
from motionlang.views.documents import page
from motionlang.views.table import Document
from motionlang.views.terminal import draws, plain

# What each form of output is, for help.
FORMS = {
    "text": "text",
    "json": "one JSON document",
    "csv": "CSV",
    "none": "none",
    "sarif": "SARIF",
    "junit": "JUnit XML",
    "github": "GitHub workflow commands, which annotate the lines",
}


# Returns the content of a file from a text and the name of the file.
Page = Callable[[str, str], str]


def _html(text: str, name: str) -> str:
    font = "DejaVu Sans Mono, Consolas, Menlo, monospace"
    return page(name, f"<pre>{escape(text)}</pre>", f"body{{margin:2rem}}pre{{font:14px/1.3 {font}}}")


def _markdown(text: str, name: str) -> str:
    fence = "```"
    while fence in text:
        fence += "`"
    return f"{fence}text\n{text.rstrip()}\n{fence}\n"


# The extensions of files that have the text of a command as a page, or as a block of Markdown.
PAGES: dict[str, Page] = {".html": _html, ".md": _markdown}


def forms(*names: str, what: str = "the form") -> Any:
    """Return the field of the form of `what`; the first name is the default."""
    listed = [FORMS[name] for name in names]
    listed[0] += " (the default)"
    help = f"{what}: {either(listed)}"
    return option("", help, choices=names)


def accepted_events() -> Any:
    """Return the field of the events that a good run may have."""
    return option(
        "KIND,…",
        "accept events: limit, soft-limit, following-error, fault or all",
        read=allowed,
        default=frozenset(),
    )


@dataclass
class Language(Command):
    """The language of a program."""

    title: ClassVar[str] = "program"
    # The program; commands have it as an argument.
    file: str = field(default="", init=False)
    lang: str | None = option("", "the language; default: by file extension", choices=dialects())

    @property
    def language(self) -> kernel.Dialect | None:
        """The language of the program, if it is known."""
        return language_of(self.lang, self.file)

    def unnamed_files(self) -> list[str]:
        return machine_next_to(self.file)

    def known_language(self) -> kernel.Dialect:
        """Return the language of the program; Refused if nothing names it."""
        if self.language is None:
            raise Refused([no_dialect(self.file)], file=self.file, status=2)
        return self.language

    def source(self) -> Source:
        """Return the program, read from its file or standard input; Refused if it cannot be read."""
        return read(self.file)


@dataclass
class OnMachine(Language):
    """The language of a program, and the machine file."""

    title: ClassVar[str] = "program"
    machine: str | None = option(
        "M.toml", "the machine file (pick.machine.toml next to pick.mnt, if it exists)"
    )


@dataclass
class ProgramOptions(OnMachine):
    """A program and its machine."""

    title: ClassVar[str] = "program"
    set: list[str] = option(
        "NAME=VALUE",
        "set a name of the program, or a key such as controller.axes; may be repeated",
        many=True,
    )

    def machine_path(self) -> str | None:
        """Return the path of the machine file: the given one, or that next to the program; None without one."""
        return machine_of(self.file or None, self.machine)

    def settings(self) -> kernel.CheckedSettings:
        """Return the settings of the machine file and of `--set`, which come first; Refused for a wrong file."""
        settings, path = kernel.CheckedSettings(given_settings(self.set, self.language)), self.machine_path()
        if path is not None:
            for key, value in settings_of(path, self.language).items():
                settings.setdefault(key, value)
        return settings

    def overrides(self) -> dict[str, float | str]:
        """Return the values that `--set` gives to names and literals of the program."""
        return given_overrides(self.set)

    def check(self) -> None:
        super().check()
        given_settings(self.set, self.language)


@dataclass
class WorldOptions(Command):
    """The world of a program: inputs, answers, keys."""

    title: ClassVar[str] = "world"
    input: list[str] = option(
        "CHANNEL=VALUE@S",
        "a digital input: 2=1@0.5 is on from 0.5 s, 2=out4+0.3 follows output 4; docs/commands/run.md has all forms",
        many=True,
    )
    analog: list[str] = option("CHANNEL=PERCENT@S", "an analogue input: 0=25@1 is 25 %% from 1 s", many=True)
    answer: list[str] = option(
        "TEXT",
        "the answer to the next INPUT, or, as PROMPT=TEXT, to one that asks PROMPT",
        many=True,
    )
    keys_: list[str] = option(
        "TEXT@S", "keys that the operator presses, such as R@0.5, {Enter}@2 or {Esc}@3", many=True
    )

    def entries(self) -> dict[str, list[str]]:
        """Return what is given, by the parameters of `with_entries`."""
        given = {"inputs": self.input, "analog": self.analog, "answers": self.answer, "keys": self.keys_}
        return {name: texts for name, texts in given.items() if texts}


@dataclass
class OutputOptions(Command):
    """The form of the output, and its file."""

    title: ClassVar[str] = "report"
    # The forms that the extension of the file chooses; the text becomes a page for those of `PAGES`.
    suffixes: ClassVar[Mapping[str, str]] = {".json": "json", ".csv": "csv"}
    format: str = forms("text", "json", "csv", "none")
    quiet: bool = flag("print no report: --format none, unless -o writes it into a file", short="q")
    output: str | None = option(
        "FILE",
        "write to FILE instead of standard output; .json, .csv, .html and .md choose the form",
        short="o",
        writes=True,
    )
    _page: Page | None = field(default=None, init=False, repr=False)

    def check(self) -> None:
        super().check()
        if self.quiet and self.output is None:
            self.format = "none"
        self._choose_form()

    def _choose_form(self) -> None:
        """Choose the form by the extension of the file, unless an option has."""
        if self.output is not None and self.format == "none":
            raise WrongOption(
                f"--format none leaves nothing to write into {self.output}; leave out one of them"
            )
        if self.format is not None:
            return
        choices = next(each.metadata["choices"] for each in fields(self) if each.name == "format")
        suffix = os.path.splitext(self.output or "")[1].lower()
        default = "text" if self.output is not None else choices[0]
        self.format = self.suffixes.get(suffix, default)
        if self.format == "text":
            self._page = PAGES.get(suffix)

    def _check_files(self) -> None:
        super()._check_files()
        path = self.output or ""
        if path.lower().endswith(".toml") or dialect_of(path) is not None:
            raise WrongOption(f"--output writes neither machine files nor programs, such as {path}")

    def start(self) -> int:
        if self.output is None:
            return super().start()
        return into(self.output, super().start, self._page)

    def show(self, document: Document, text: str) -> None:
        """Print what the command has found, in the form that is wanted."""
        if self.format == "json":
            sys.stdout.write(document.json())
        elif self.format == "csv":
            document.csv(sys.stdout)
        elif self.format == "text":
            sys.stdout.write(text if draws(sys.stdout) else plain(text))


@dataclass
class Findings(OutputOptions):
    """Findings about programs, also in forms for other tools."""

    format: str = forms("text", "json", "csv", "none", "sarif", "junit", "github")
    quiet: bool = flag("print the findings only", short="q")

    def check(self) -> None:
        Command.check(self)
        self._choose_form()


@dataclass
class Jobs(Command):
    """Work on several processes."""

    title: ClassVar[str] = "processes"
    jobs: int = option(
        "N", "worker processes; default: one per core", short="j", default=0,
        read=whole("a number of processes from 1 to 1024", 1, 1024),
    )  # fmt: skip


def machine_next_to(program: str | None) -> list[str]:
    """Return the machine file that belongs next to a program, whether it exists or not; none if it has no folder."""
    return [os.path.splitext(program)[0] + MACHINE_SUFFIX] if program and program != STDIN else []


def read(file: str) -> Source:
    """Return the text of a file, or of standard input for `-`; Refused if it cannot be read."""
    try:
        return Source.from_file(STDIN_NAME, sys.stdin.buffer) if file == STDIN else Source.read(file)
    except OSError as error:
        raise Refused([unreadable(file, error)], file=file) from None


def settings_of(path: str, language: kernel.Dialect | None = None) -> dict[str, object]:
    """Return the settings of a machine file; Refused for a wrong file."""
    machine = read(path)
    try:
        return kernel.read_machine(machine, language=language)
    except ProgramError as error:
        raise Refused(error.diagnostics, source=machine, file=path) from None


def given_settings(pairs: Sequence[str], language: kernel.Dialect | None) -> dict[str, object]:
    """Return the keys of the machine file among NAME=VALUE pairs; WrongOption for an invalid pair."""
    found: dict[str, object] = {}
    for pair in pairs:
        name, equals, text = _split(pair)
        if not equals or not name:
            raise WrongOption(f"--set needs NAME=VALUE, not {shown(pair)}")
        if "." in name:
            found[name] = _setting(text)
            problem = kernel.check_setting(name, found[name], language)
            if problem is not None:
                raise WrongOption(f"--set {clipped(pair)}: {problem[0]}; {problem[1]}")
    return found


def given_overrides(pairs: Sequence[str]) -> dict[str, float | str]:
    """Return the names and literals of the program among NAME=VALUE pairs, which are valid."""
    return {name: _number_or_text(text) for name, _, text in map(_split, pairs) if "." not in name}


def _split(pair: str) -> tuple[str, str, str]:
    name, equals, text = pair.partition("=")
    return canonical(name) or name.strip(), equals, text


def _setting(text: str) -> object:
    """Parse the value of a machine key as in the machine file; a bare word is a text."""
    try:
        return kernel.read_value(text)
    except ProgramError:  # no TOML, more digits than Python reads, or nested too deeply
        return text


def _number_or_text(text: str) -> float | str:
    try:
        return float(text)
    except ValueError:
        return text


def with_world(settings: dict[str, object], entries: dict[str, list[str]]) -> dict[str, object]:
    """Return the settings, overridden by the entries of a world; Refused if one is wrong."""
    try:
        return kernel.with_entries(settings, **entries)
    except kernel.WrongEntry as error:
        raise Refused([Diagnostic("option", error.message, hint=error.hint)], status=2) from None


def into(path: str, command: Callable[[], int], page: Page | None = None) -> int:
    """Run a command with standard output redirected to a file, replaced at the end.

    `page` returns the content of the file from the output and the name of the file. Returns the exit status of the
    command, or 1 if the file cannot be written.
    """
    before = sys.stdout
    try:
        with replacing(path) as out:
            target = cast("BinaryIO", out) if page is None else BytesIO()
            sys.stdout = TextIOWrapper(target, "utf-8", write_through=True)
            try:
                return command()
            finally:
                sys.stdout.flush()
                sys.stdout.detach()
                sys.stdout = before
                if page is not None:
                    out.write(
                        page(cast("BytesIO", target).getvalue().decode(), os.path.basename(path)).encode()
                    )
    except OSError as error:
        complain([unwritten(path, error)], None, path)
        return 1
