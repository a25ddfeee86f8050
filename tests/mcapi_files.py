"""Writer of the files made from the MCAPI table: `python -m tests.mcapi_files`.

They are the Python class, the page of functions, and the header and the stubs of the C library.
"""

from __future__ import annotations

import re
import textwrap
from pathlib import Path

from motionlang.mcapi import constants
from motionlang.mcapi.calls import readings, settings  # noqa: F401
from motionlang.mcapi.table import FUNCTIONS, STRUCTURES, Argument, Function, Structure
from motionlang.mccl.keywords import table

ROOT = Path(__file__).parents[1]
PACKAGE = ROOT / "motionlang" / "mcapi"
PYTHON = {"": "None", "d": "float", "str": "str", "v": "Any", "memory": "object", "buf": "str"}
# Arguments of PMC's binding that C does not have, and defaults.
SIGNATURES = {
    "MCReset": "axis: int, distance: float = 0.0",
    "MCGetInstalledModules": "size: int = 16",
    "MCGetTrajectoryRate": "axis: int = 0",
    "MCSetTrajectoryRate": "axis: int, rate: int",
    "MCGetDigitalFilter": "axis: int, coeff: list[float], num: int, actual: object = None",
    "pmcgets": "buffer: bytearray, size: int",
    "pmclookupvar": "varname: str, address: object = None",
}
# Written by hand in `client.py`.
BY_HAND = ("MCOpen", "MCClose", "MCGetError", "MCTranslateErrorEx")
ERRORS_IGNORED = (
    "MCIsAtTarget",
    "MCIsDigitalFilter",
    "MCIsEdgeFound",
    "MCIsIndexFound",
    "MCIsStopped",
    "pmclock",
)


# ------------------------------------------------------------------------------------------ the Python class


def python_type(each: Argument) -> str:
    if each.kind in STRUCTURES:
        return each.kind
    if each.size and each.kind != "buf":
        return "list[float]" if each.kind == "d" else "list[int]"
    return PYTHON.get(each.kind, "int")


def signature(function: Function) -> str:
    if function.name in SIGNATURES:
        return SIGNATURES[function.name]
    found = []
    for each in function.arguments:
        if not each.out or each.kind in STRUCTURES:
            found.append(f"{each.name}: {python_type(each)}" + (" | None" if each.optional else ""))
    return ", ".join(found)


def sent(each: Argument) -> str:
    """Return the expression that a method passes on for an argument."""
    if each.out or each.kind == "memory":
        return "1"
    if each.kind in STRUCTURES:
        return f"*_flat({each.name}.values())"
    if each.size:
        return f"*_flat({each.name})"
    return f"int({each.name})" if python_type(each) == "int" else each.name


def described(function: Function) -> str:
    """Return the docstring of a method, from the text of the table.

    The first sentence becomes the docstring if it is short enough. If not, the complete text goes below the
    first line.
    """
    if function.unsupported:
        return f"Call {function.name}, which is not supported: error 11."
    first = function.help.partition(". ")[0].rstrip(".") + "."
    if len(first) <= 72 and not first.startswith("What"):
        return first
    text = "\n        ".join(textwrap.wrap(function.help, 100))
    return f"Call {function.name}.\n\n        {text}\n        "


def method(function: Function) -> str:
    """Return one method of the class."""
    outputs = function.outputs
    arguments = ", ".join([f'"{function.name}"', *map(sent, function.arguments)])
    structure = next((each for each in outputs if each.kind in STRUCTURES), None)
    result, body = "None", f"self._do({arguments})"
    if structure is not None:
        body = f"self._fill({structure.name}, {arguments})"
    elif function.name == "pmcgets":
        result, body = "int", f"return self._text(buffer, {arguments})"
    elif function.name in ERRORS_IGNORED:
        result, body = "int", f"return self._is({arguments})"
    elif function.is_value:
        result, body = "int", f"return self._value({arguments})"
    elif any(each.size for each in outputs):
        result, body = "list[Any]", f"return list(self._do({arguments}))"
    elif len(outputs) > 1:
        result, body = "tuple[Any, ...]", f"return self._do({arguments})"
    elif outputs:
        kind = python_type(outputs[0])
        result, body = kind, f"found: {kind} = self._get({arguments})\n        return found"
        if kind == "Any":
            body = f"return self._get({arguments})"
    given = f"self, {signature(function)}" if signature(function) else "self"
    name = function.name.removeprefix("MC")
    text = described(function)
    return f'    def {name}({given}) -> {result}:\n        """{text}"""\n        {body}\n'


def structure_class(structure: Structure) -> str:
    kinds = {"d": "float", "i": "int", "s": "int", "D": "int"}
    fields = [
        f"    {field.name}: {f'list[{kinds[field.kind]}]' if field.count > 1 else kinds[field.kind]}"
        for field in structure.fields
    ]
    head = f'class {structure.name}(Structure):\n    """The structure {structure.name}."""\n\n'
    return head + "\n".join(fields) + "\n"


def binding() -> str:
    """Return the text of `binding.py`."""
    head = '''"""The class `Mcapi` with a method for every function, and the structures.

Written by `python -m tests.mcapi_files`, not by hand.
"""

# ruff: noqa
# fmt: off

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from motionlang.mcapi.client import Binding, Structure


def _flat(values: Sequence[float]) -> list[float]:
    """Return an array as it is sent: its length, then its values."""
    return [len(values), *values]
'''
    classes = [structure_class(each) for each in STRUCTURES.values()]
    methods = [method(each) for each in FUNCTIONS.values() if each.name not in BY_HAND]
    whole = 'class Mcapi(Binding):\n    """MCAPI as PMC\'s Python binding has it, without the library."""\n\n'
    return head + "\n\n" + "\n\n".join(classes) + "\n\n" + whole + "\n".join(methods)


# --------------------------------------------------------------------------------------- the page of functions

C_TYPES = {
    "h": "HCTRLR",
    "s": "short",
    "i": "int",
    "W": "WORD",
    "D": "DWORD",
    "u": "unsigned",
    "d": "double",
    "w": "HWND",
    "": "void",
}
PAGE_HEAD = """\
# Functions of MCAPI

What each of the {count} functions of MCAPI 4.4.1 does on a virtual board. [mcapi.md](mcapi.md) shows how a host uses
them. This page is generated by `python -m tests.mcapi_files`.

A function sends the commands in the column of MCCL; `a` is the axis. `→` comes before a result. {unsupported} functions
return MCERR_NOTSUPPORTED (11), for the reason given. On a model without a command, the functions that need it return 11
as well.

| function | arguments | MCCL | what it does here |
|---|---|---|---|
"""


def shown(each: Argument) -> str:
    name = f"{each.name}[{each.size}]" if each.size else each.name
    return f"→ {name}" if each.out else name


def page() -> str:
    """Return the text of docs/mcapi-functions.md."""
    names = {row.name for row in table()}
    unsupported = [each for each in FUNCTIONS.values() if each.unsupported]
    rows = [PAGE_HEAD.format(count=len(FUNCTIONS), unsupported=len(unsupported))]
    for each in FUNCTIONS.values():
        mccl = re.sub(r"\{\w+\}", "n", each.mccl)
        used = re.findall(r"a?([A-Z]{2})", mccl)
        assert not [name for name in used if name not in names], each.name
        does = each.help or f"Not supported: {each.unsupported}."
        arguments = ", ".join(map(shown, each.arguments))
        rows.append(f"| `{each.name}` | {arguments} | {f'`{mccl}`' if mccl else ''} | {does} |\n")
    return "".join(rows)


# ---------------------------------------------------------------------------------------------- the C library

HEADER = """\
/* Functions, structures and constants of MCAPI 4.4.1, for hosts of a virtual board.
 *
 * Written by `python -m tests.mcapi_files`, not by hand. Hosts ask for the guards of several versions.
 */
#ifndef MCAPI_H
#define MCAPI_H
#define __MCAPI_H__
#define _INC_MCAPI

#ifdef _WIN32
#include <windows.h>
#else
typedef unsigned short WORD;
typedef unsigned long DWORD;
typedef unsigned long HWND;
typedef const char *LPCSTR;
#endif
#ifndef APIENTRY
#define APIENTRY
#endif
#ifndef MCAPI_EXPORT
#define MCAPI_EXPORT
#endif

#ifdef __cplusplus
extern "C" {
#endif

typedef short HCTRLR;
typedef void (MCINTERRUPTPROC)(HWND, HCTRLR, WORD, DWORD);
"""
FOOT = """
#ifdef __cplusplus
}
#endif
#endif
"""


def c_type(each: Argument) -> str:
    """Return the type of an argument in C."""
    if each.kind in STRUCTURES:
        return f"{each.kind} *"
    if each.kind == "memory":
        return "MCINTERRUPTPROC *" if each.name == "lpIntFunc" else "void *"
    texts = {"v": "void *", "buf": "char *"}
    if each.kind in texts:
        return texts[each.kind]
    if each.kind == "str":
        return "const char *"
    pointer = " *" if each.out or each.size else " "
    return C_TYPES[each.kind] + pointer


def handle_index(function: Function) -> int:
    """Return the index of the handle in the C argument list: after a window, which comes first."""
    return int(function.arguments[:1] != () and function.arguments[0].kind == "w")


def c_arguments(function: Function) -> list[tuple[str, str]]:
    """Return type and name of each C argument, with the handle at its position."""
    found = [(c_type(each), each.name) for each in function.arguments]
    if function.has_handle:
        found.insert(handle_index(function), ("HCTRLR ", "hCtlr"))
    return found


def prototype(function: Function) -> str:
    given = ", ".join(kind + name for kind, name in c_arguments(function))
    return f"MCAPI_EXPORT {C_TYPES[function.kind]} APIENTRY {function.name}({given})"


def header() -> str:
    """Return the text of `mcapi.h`."""
    names = {name: value for name, value in vars(constants).items() if name.isupper() and name != "MESSAGES"}
    defines = "\n".join(f"#define {name} {value}" for name, value in names.items())
    structures = []
    for each in STRUCTURES.values():
        fields = [
            f"    {C_TYPES[field.kind]} {field.name}{f'[{field.count}]' if field.count > 1 else ''};"
            for field in each.fields
        ]
        structures.append("typedef struct {\n" + "\n".join(fields) + f"\n}} {each.name};")
    prototypes = ";\n".join(map(prototype, FUNCTIONS.values()))
    packed = "#pragma pack(push, 4)\n" + "\n\n".join(structures) + "\n#pragma pack(pop)\n"
    return f"{HEADER}\n{defines}\n\n{packed}\n{prototypes};\n{FOOT}"


def letters(function: Function) -> str:
    """Return the signature that the library reads, one code of letters per argument."""
    places = {name: place for place, (_, name) in enumerate(handle_first(function))}
    found = "h" if function.has_handle else ""
    for each in function.arguments:
        found += (">" if each.out else "") + ("?" if each.optional else "")
        if each.kind in STRUCTURES:
            found += "S" + chr(ord("a") + list(STRUCTURES).index(each.kind))
        elif each.kind == "v":
            found += f"v{places[each.type]}"
        elif each.kind == "buf":
            found += f"b{places[each.size]}"
        elif each.size:
            found += f"[{each.kind}{places[each.size]}"
        else:
            found += {"str": "t", "memory": "m"}.get(each.kind, each.kind)
    return found


def handle_first(function: Function) -> list[tuple[str, str]]:
    """Return type and name of each C argument, with the handle moved to the front."""
    found = c_arguments(function)
    if function.has_handle:
        found.insert(0, found.pop(handle_index(function)))
    return found


def stub(number: int, function: Function) -> str:
    """Return the C stub of a function."""
    values = []
    for kind, name in handle_first(function):
        field = "p" if kind.endswith("*") else "d" if kind == "double " else "i"
        values.append(
            f"{{.{field} = {name}}}" if kind != "HWND " else f"{{.i = (long long)(intptr_t){name}}}"
        )
    types = ", ".join(kind.strip() for kind, _ in c_arguments(function))
    names = ", ".join(name for _, name in c_arguments(function))
    result = C_TYPES[function.kind]
    store, back = ("r.i = ", f"return ({result})") if function.kind else ("", "")
    return (
        f"{prototype(function)}\n{{\n"
        f"    item a[] = {{{', '.join(values)}}}, r = {{0}};\n"
        f"    double begin;\n"
        f"    void *real = enter({number}, &begin);\n"
        f"    if (real) {store}(({result} (APIENTRY *)({types}))(intptr_t)real)({names});\n"
        f"    {back}leave({number}, a, r, begin, real != NULL){'.i' if back else ''};\n}}\n"
    )


def stubs() -> str:
    """Return the text of `stubs.h`."""
    head = "/* The stubs of the functions, written by `python -m tests.mcapi_files`, not by hand. */\n\n"
    layouts = []
    for each in STRUCTURES.values():
        fields = "".join(field.kind * field.count for field in each.fields)
        fields = "c" + fields[1:] if each.has_size else fields
        older = ", ".join(map(str, (*each.older, 0)))
        layouts.append(f'    {{"{fields}", {{{older}}}}}, /* {each.name} */')
    rows = [f'    {{"{each.name}", "{each.result}", "{letters(each)}"}},' for each in FUNCTIONS.values()]
    tables = (
        "static const structure STRUCTURES[] = {\n" + "\n".join(layouts) + "\n};\n\n"
        "static const function FUNCTIONS[] = {\n" + "\n".join(rows) + "\n};\n\n"
    )
    return head + tables + "\n".join(stub(number, each) for number, each in enumerate(FUNCTIONS.values()))


FILES = {
    PACKAGE / "binding.py": binding,
    ROOT / "docs" / "mcapi-functions.md": page,
    PACKAGE / "library" / "mcapi.h": header,
    PACKAGE / "library" / "stubs.h": stubs,
}


def main() -> None:
    for path, text in FILES.items():
        path.write_text(text(), encoding="utf-8")


if __name__ == "__main__":
    main()
