"""A command is a class of typed fields: its options, help, completion, page and TOML keys follow from them.

    @dataclass
    class Trace(Simulated):
        file: str = argument("FILE", "the program; - reads standard input")
        out: str = argument("OUT", "the file to write", suffixes=TRACES)
        rate: float = option("HZ", "samples per second (1000)", read=RATE, default=1000.0)

A base class that lists fields is a group of options in the help, under its `title`. A class without `run` is only such
a group. A class with `commands` has subcommands instead of options.
"""

from __future__ import annotations

import argparse
import os
import textwrap
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import MISSING, Field, dataclass, field, fields
from inspect import get_annotations
from typing import Any, ClassVar, Self

from motionlang.cli.complaints import complain
from motionlang.cli.parser import Commands, Parser, both, either, sentence
from motionlang.cli.signals import SIGNALS
from motionlang.kernel import Diagnostic, Source, dialect_of
from motionlang.kernel.files import is_plain, same_file, unwritable
from motionlang.kernel.tools import nearest, need, shown

# What commands read in a folder, besides programs and golden files.
DATA = ".toml"
# The optional library that writes a format.
WRITERS = {".png": "matplotlib", ".parquet": "pyarrow"}


def option(
    metavar: str, help: str, *, read: Callable[[str], Any] = str, default: Any = None, **more: Any
) -> Any:
    """Return a field that `--name VALUE` sets.

    `read` returns the value of a text, or raises ValueError with the reason. `more` may have `short`, a letter;
    `choices`; `suffixes` of a file to write; `writes`, true for one of any extension; `const`, the value of an option
    without one; and `many`, for an option that may be repeated.
    """
    made = {"metavar": metavar, "help": help, "read": read, **more}
    if more.get("many"):
        return field(default_factory=list, metadata=made)
    return field(default=default, metadata=made)


def flag(help: str, *, short: str = "", default: bool | None = False) -> Any:
    """Return a field that `--name` makes true; without a default, `--no-name` makes it false."""
    return field(default=default, metadata={"help": help, "short": short, "flag": True})


def argument(metavar: str, help: str, *, read: Callable[[str], Any] = str, **more: Any) -> Any:
    """Return a field that is given by its place.

    `more` may have `choices`, `suffixes`, a `default`, which makes it optional, and `many`: it then takes the rest of
    the line, at least one word if there is no default.
    """
    made = {"metavar": metavar, "help": help, "read": read, "place": True, **more}
    if more.get("many"):
        return field(default_factory=lambda: list(more.get("default", ())), metadata=made)
    return field(default=more.get("default", ""), metadata=made)


class WrongOption(ValueError):
    """An option, argument or key whose value cannot be used."""


class Refused(Exception):
    """A command cannot do its work: the diagnostics with the reason, and the exit status."""

    def __init__(
        self,
        diagnostics: Sequence[Diagnostic],
        *,
        file: str = "",
        source: Source | None = None,
        status: int = 1,
    ) -> None:
        super().__init__(diagnostics[0].message)
        self.diagnostics, self.file, self.source, self.status = diagnostics, file, source, status


@dataclass
class Command:
    """The base of all commands."""

    title: ClassVar[str] = "options"
    epilog: ClassVar[str] = ""
    removed: ClassVar[Mapping[str, str]] = {}
    # The subcommands of a command that only leads to others, with their summaries.
    commands: ClassVar[Mapping[str, tuple[type[Command], str]]] = {}
    # The words of the command line, for a crash report.
    given: Sequence[str] = field(default=(), init=False, repr=False)
    # The fields that the command line sets, also to their defaults.
    typed: frozenset[str] = field(default=frozenset(), init=False, repr=False)
    # What reports a wrong option that is only found while the command runs.
    _parser: Parser | None = field(default=None, init=False, repr=False)

    def run(self) -> int:
        """Do the work of the command; return the exit status."""
        raise NotImplementedError

    def check(self) -> None:
        """Raise WrongOption if options do not fit together."""

    def unnamed_files(self) -> list[str]:
        """Return the files that the command reads or writes without an option that names them."""
        return []

    def _check_files(self) -> None:
        """Raise WrongOption if a file to write is one that the command reads, or writes already."""
        given = [(each, getattr(self, each.name)) for each in fields(self) if each.init]
        targets = [(each, path) for each, path in given if path and _is_written(each)]
        read = [path for each, value in given if not _is_written(each) for path in _paths(value)]
        for each, path in targets:
            if each.metadata.get("suffixes"):
                _check_target(each, path)
            if not is_plain(path):
                continue
            name = _name(each)
            is_read = any(_is_in(path, other) for other in read)
            if is_read or any(same_file(path, other) for other in self.unnamed_files()):
                raise WrongOption(f"{name}: this command already uses {path}; write to another file")
            twice = next(
                (_name(other) for other, at in targets if other is not each and same_file(path, at)), ""
            )
            if twice:
                raise WrongOption(f"{name} and {twice} both write {path}; write to two files")

    def start(self) -> int:
        """Run the command and return the exit status; report what it refuses."""
        try:
            return self.perform()
        except Refused as refused:
            return self.refuse(refused)
        except WrongOption as error:
            assert self._parser is not None
            self._parser.error(str(error))

    def perform(self) -> int:
        """Run the command, unless a signal has come meanwhile."""
        SIGNALS.deliver()
        return self.run()

    def refuse(self, refused: Refused) -> int:
        """Report why the command did nothing; return the exit status."""
        complain(refused.diagnostics, refused.source, refused.file)
        return refused.status

    @classmethod
    def groups(cls) -> dict[str, list[Field[Any]]]:
        """Return the options of the class and its bases by the title of their group, the class first."""
        known = {each.name: each for each in fields(cls) if each.init and not each.metadata.get("place")}
        # A field that a class defines anew stays in the group of its base.
        owners = {name: base for base in cls.__mro__ for name in get_annotations(base)}
        found: dict[str, list[Field[Any]]] = {}
        for base in cls.__mro__:
            own = [each for name, each in known.items() if owners[name] is base]
            if own:
                found.setdefault(getattr(base, "title", Command.title), []).extend(own)
        return found

    @classmethod
    def add(cls, commands: Commands, name: str, summary: str) -> None:
        """Add the command to those of an argparse parser."""
        parser = commands.add_parser(
            name, help=summary, description=textwrap.fill(sentence(summary), 78), epilog=cls.epilog
        )
        parser.removed = cls.removed
        if cls.commands:
            inner = parser.add_subparsers(metavar=" | ".join(cls.commands), required=True)
            for word, (command, what) in cls.commands.items():
                command.add(inner, word, what)
            return
        places = " ".join(_place(each) for each in fields(cls) if each.metadata.get("place"))
        parser.usage = f"{parser.prog} {places} [options]".replace("  ", " ")
        for each in fields(cls):
            if each.metadata.get("place"):
                parser.add_argument(*_names(each), **_settings(each))
        for title, group in cls.groups().items():
            own = parser if title == Command.title else parser.add_argument_group(title)
            for each in group:
                own.add_argument(*_names(each), **_settings(each))
        parser.set_defaults(made=lambda given: cls._of(given, parser))

    @classmethod
    def _of(cls, given: argparse.Namespace, parser: Parser) -> Self:
        names = [each.name for each in fields(cls) if each.init and hasattr(given, each.name)]
        made = cls(**{name: getattr(given, name) for name in names})
        made.given, made.typed, made._parser = given.given, frozenset(names), parser
        try:
            made.check()
            made._check_files()
        except WrongOption as error:
            parser.error(str(error))
        return made

    @classmethod
    def keys(cls, *titles: str) -> dict[str, Field[Any]]:
        """Return the options of some groups by name, as keys of a TOML file."""
        return {
            each.name.strip("_"): each
            for title, group in cls.groups().items()
            for each in group
            if title in titles
        }

    def take(self, tree: Mapping[str, object], keys: Mapping[str, Field[Any]]) -> Iterator[tuple[str, str]]:
        """Set the options that the command line does not set; yield wrong keys with the reason.

        Each value is read as on the command line: a list is joined by commas, a table is repeated NAME=VALUE.
        """
        for key, value in tree.items():
            if key not in keys:
                near = nearest(key, keys)
                hint = f"did you mean {near}?" if near else f"the keys are {', '.join(keys)}"
                yield key, f"there is no key {key}; {hint}"
                continue
            try:
                read = _read(keys[key], value)
            except ValueError as error:
                yield key, f"{key}: {error}"
            else:
                if keys[key].name not in self.typed:
                    setattr(self, keys[key].name, read)


def _default(of: Field[Any]) -> Any:
    return of.default if of.default_factory is MISSING else of.default_factory()


def _place(of: Field[Any]) -> str:
    """Return an argument as the usage line shows it."""
    name = of.metadata["metavar"] + (" ..." if of.metadata.get("many") else "")
    return f"[{name}]" if "default" in of.metadata else name


def _names(of: Field[Any]) -> list[str]:
    """Return the spellings of an option; a trailing _ only keeps a name apart from a word of Python."""
    if of.metadata.get("place"):
        return [of.name]
    short = of.metadata.get("short")
    return [*([f"-{short}"] if short else []), "--" + of.name.strip("_").replace("_", "-")]


def _settings(of: Field[Any]) -> dict[str, Any]:
    """Return the arguments of `add_argument`; an option that is not typed leaves no value."""
    meta, found = of.metadata, {"help": of.metadata["help"]}
    if meta.get("flag"):
        action = argparse.BooleanOptionalAction if of.default is None else "store_true"
        return found | {"action": action, "dest": of.name, "default": argparse.SUPPRESS}
    found |= {"metavar": meta["metavar"] or None, "type": _reader(meta["read"])}
    if meta.get("choices"):
        found["choices"] = meta["choices"]
    if meta.get("suffixes"):
        found["help"] += f": {either(meta['suffixes'])}"
    if meta.get("place"):
        is_optional = "default" in meta
        if meta.get("many"):
            return found | {"nargs": "*" if is_optional else "+", "default": _default(of)}
        return found | ({"nargs": "?", "default": _default(of)} if is_optional else {})
    found |= {"dest": of.name, "default": argparse.SUPPRESS}
    if meta.get("many"):
        found["action"] = "append"
    if "const" in meta:
        found |= {"nargs": "?", "const": meta["const"]}
    return found


def _reader(read: Callable[[str], Any]) -> Callable[[str], Any]:
    """Return a reader whose ValueError argparse shows as it is."""

    def reader(text: str) -> Any:
        try:
            return read(text)
        except ValueError as error:
            raise argparse.ArgumentTypeError(str(error)) from None

    return reader


def _is_written(of: Field[Any]) -> bool:
    return bool(of.metadata.get("suffixes") or of.metadata.get("writes"))


def _paths(value: object) -> list[str]:
    """Return the files and folders that exist among the texts of an option."""
    texts = value if isinstance(value, list) else [value]
    return [each for each in texts if isinstance(each, str) and os.path.exists(each)]


def _is_in(path: str, used: str) -> bool:
    """True if a path leads to a file that exists, and that is `used` or what a command reads in that folder."""
    if not os.path.exists(path) or same_file(path, used):
        return os.path.exists(path)
    is_read = dialect_of(path) is not None or path.endswith(DATA) or ".golden." in path
    return is_read and os.path.realpath(path).startswith(os.path.join(os.path.realpath(used), ""))


def _name(of: Field[Any]) -> str:
    return of.metadata["metavar"] if of.metadata.get("place") else _names(of)[-1]


def _check_target(of: Field[Any], path: str) -> None:
    """Raise WrongOption if a file cannot be written, and MissingExtra without the library that writes its format."""
    name = _name(of)
    suffixes, suffix = of.metadata["suffixes"], os.path.splitext(path)[1].lower()
    if not path.lower().endswith(tuple(suffixes)):
        what = f"not {suffix} files" if suffix else "so the file needs one of these extensions"
        raise WrongOption(f"{name} writes {both(suffixes)}, {what}")
    if suffix in WRITERS:
        need(f"a {suffix} file", WRITERS[suffix])
    problem = unwritable(path)
    if problem is not None:
        raise WrongOption(problem)


def _read(of: Field[Any], value: object) -> Any:
    """Return the value of a TOML key, read as the option would be."""
    if of.metadata.get("flag"):
        if not isinstance(value, bool):
            raise WrongOption(f"true or false, not {shown(value)}")
        return value
    if of.metadata.get("many"):
        pairs = _flat(value) if isinstance(value, dict) else [("", value)]
        return [of.metadata["read"](f"{name}={_text(each)}" if name else _text(each)) for name, each in pairs]
    return of.metadata["read"](_text(value))


def _text(value: object) -> str:
    if isinstance(value, list):
        return ",".join(map(_text, value))
    return str(value).lower() if isinstance(value, bool) else str(value)


def _flat(tree: Mapping[str, object], prefix: str = "") -> list[tuple[str, object]]:
    found: list[tuple[str, object]] = []
    for key, value in tree.items():
        found += _flat(value, f"{prefix}{key}.") if isinstance(value, dict) else [(prefix + key, value)]
    return found
