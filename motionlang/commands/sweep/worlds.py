"""The worlds of a sweep: the machine files and scenarios of a folder."""

from __future__ import annotations

import os

from motionlang.kernel import ProgramError, Source, read_machine

# The end of the name of a sweep's file, which is next to its program.
SUFFIX = ".sweep.toml"


def settings_of(path: str, is_layer: bool) -> dict[str, object]:
    """Return the settings of a machine file or a scenario; ProgramError if invalid.

    They include the name of the file.
    """
    try:
        settings = read_machine(Source.read(path), is_layer=is_layer)
        settings.pop("expect", None)  # of a world itself, not of its variants
        return settings
    except ProgramError as error:
        for each in error.diagnostics:
            each.message = (
                f"{os.path.basename(path)}, line {each.line}: {each.message}" if each.line else each.message
            )
        raise


def machine_files(folder: str) -> list[tuple[str, str]]:
    """Return names and paths of the machine files of a folder, in order.

    Raises ValueError if there are none.
    """
    found = []
    for file in sorted(os.listdir(folder)):
        if file.endswith(".toml") and not file.endswith(SUFFIX):
            found.append((file.removesuffix(".toml").removesuffix(".machine"), os.path.join(folder, file)))
    if not found:
        raise ValueError(f"no machine files in {folder}: they end in .toml")
    return found
