"""Diagnostics of many files in formats for other tools.

The formats are SARIF, JUnit XML and GitHub workflow commands.
"""

from __future__ import annotations

import json
import os
from collections.abc import Sequence
from pathlib import PurePath
from urllib.parse import quote

from motionlang.kernel import CODES, Diagnostic, Source
from motionlang.kernel.version import __version__
from motionlang.views.diagnostics import render, tally
from motionlang.views.terminal import printable

SARIF = "https://json.schemastore.org/sarif-2.1.0.json"


class Found:
    """The diagnostics of one file.

    `path` is the file that they refer to, possibly the machine file. `strict` counts warnings as errors. `command` is
    that which found them, if it is not the one that is run.
    """

    __slots__ = ("command", "diagnostics", "file", "is_wrong", "path", "source")

    def __init__(
        self,
        file: str,
        diagnostics: Sequence[Diagnostic],
        source: Source | None = None,
        path: str = "",
        strict: bool = False,
        command: str = "",
    ) -> None:
        self.command = command
        self.file, self.diagnostics, self.source, self.path = file, diagnostics, source, path or file
        self.is_wrong = any(strict or each.severity == "error" for each in diagnostics)


def written(found: Sequence[Found], form: str, command: str) -> str:
    """Return the whole document in a format for other tools.

    `form` is "sarif", "junit" or "github". `command` is the name of the command, such as
    "check".
    """
    return {"sarif": _sarif, "junit": _junit, "github": _github}[form](found, command)


def _sarif(found: Sequence[Found], command: str) -> str:
    results = [_result(each.path, one) for each in found for one in each.diagnostics]
    rules = [
        {"id": code, "shortDescription": {"text": CODES[code]}}
        for code in sorted({one.code for each in found for one in each.diagnostics})
    ]
    driver = {"name": "motionlang", "version": __version__, "rules": rules}
    run = {"tool": {"driver": driver}, "columnKind": "unicodeCodePoints", "results": results}

    return json.dumps({"$schema": SARIF, "version": "2.1.0", "runs": [run]}, indent=1) + "\n"


def _result(file: str, one: Diagnostic) -> dict[str, object]:
    location: dict[str, object] = {"artifactLocation": {"uri": _uri(file)}}
    if one.line:
        location["region"] = {"startLine": one.line}
        if one.column:
            location["region"] = {
                "startLine": one.line, "startColumn": one.column, "endColumn": one.column + max(one.length, 1),
            }  # fmt: skip
    return {
        "ruleId": one.code,
        "level": one.severity,
        "message": {"text": _with_hint(one)},
        "locations": [{"physicalLocation": location}],
    }


def _uri(path: str) -> str:
    """Return the URI of a file: relative, or `file:///…` for an absolute path."""
    pure = PurePath(path)
    return pure.as_uri() if pure.is_absolute() else quote(os.fsencode(pure.as_posix()))


def _junit(found: Sequence[Found], command: str) -> str:
    """Return one test case per file and command.

    A file with an error is a failure; warnings are its output.
    """
    name = quoteattr(f"motionlang {command}")
    wrong = [each for each in found if each.is_wrong]
    head = f'name={name} tests="{len(found)}" failures="{len(wrong)}"'
    lines = ['<?xml version="1.0" encoding="utf-8"?>', f"<testsuites {head}>", f"<testsuite {head}>"]
    for each in found:
        classname = quoteattr(f"motionlang {each.command or command}")
        lines.append(f"<testcase classname={classname} name={quoteattr(_xml(each.file))}>")
        text = "\n".join(render(one, each.source, name=each.path) for one in each.diagnostics)
        if each.is_wrong:
            lines.append(
                f"<failure message={quoteattr(tally(each.diagnostics))}>{escape(_xml(text))}</failure>"
            )
        elif text:
            lines.append(f"<system-out>{escape(_xml(text))}</system-out>")
        lines.append("</testcase>")
    return "\n".join([*lines, "</testsuite>", "</testsuites>"]) + "\n"


def escape(text: str) -> str:
    """Return text as the content of an XML element.

    `xml.sax` would import an HTTP client.
    """
    return text.replace("&", "&amp;").replace("<", "&lt;").replace(">", "&gt;")


def quoteattr(text: str) -> str:
    """Return text as a quoted XML attribute."""
    for letter, entity in (("\n", "&#10;"), ("\r", "&#13;"), ("\t", "&#9;")):
        text = text.replace(letter, entity) if letter in text else text
    return '"' + escape(text).replace('"', "&quot;") + '"'


def _xml(text: str) -> str:
    """Return the text without the control characters that XML does not allow."""
    return "\n".join(printable(line) for line in text.split("\n"))


def _github(found: Sequence[Found], command: str) -> str:
    lines = []
    for each in found:
        for one in each.diagnostics:
            properties = {"file": each.path, "line": one.line, "col": one.column}
            if one.column:
                properties["endColumn"] = one.column + max(one.length, 1)
            properties["title"] = one.code
            given = ",".join(f"{key}={_property(str(value))}" for key, value in properties.items() if value)
            lines.append(f"::{one.severity} {given}::{_data(_with_hint(one))}\n")
    return "".join(lines)


def _with_hint(one: Diagnostic) -> str:
    return f"{one.message}\n{one.hint}" if one.hint else one.message


def _data(text: str) -> str:
    return text.replace("%", "%25").replace("\r", "%0D").replace("\n", "%0A")


def _property(text: str) -> str:
    return _data(text).replace(":", "%3A").replace(",", "%2C")
