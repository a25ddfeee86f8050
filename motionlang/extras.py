"""Libraries that may be missing: the extra of `pyproject.toml` that installs each, and the message without it.

numpy belongs to no extra, because the package depends on it. Some Pythons, such as a browser's, lack it all the same,
and most runs do without.
"""

from __future__ import annotations

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Sequence

# By the name that it is imported by: the extra, and the name that it is installed by.
LIBRARIES = {
    "matplotlib": ("plot", "matplotlib"),
    "pyarrow": ("parquet", "pyarrow"),
    "mcap": ("mcap", "mcap"),
    "can": ("can", "python-can"),
    "canopen": ("can", "canopen"),
    "serial": ("serial", "pyserial"),
    "shtab": ("completion", "shtab"),
}
# The libraries that the package depends on and that a run may do without.
REQUIRED = ("numpy",)


class MissingExtra(ImportError):
    """`user`, a feature or an option, needs libraries of an extra that are not installed.

    `message` names them and `hint` is the command that installs them, in double quotes, which every shell takes.
    """

    def __init__(self, user: str, libraries: Sequence[str]) -> None:
        names = " and ".join(LIBRARIES.get(library, ("", library))[1] for library in libraries)
        self.message = f"{user} needs {names}"
        if libraries[0] in REQUIRED:
            self.hint = f"python -m pip install {names}"
        else:
            self.hint = f'python -m pip install "motionlang[{LIBRARIES[libraries[0]][0]}]"'
        # An option can be left out; without a feature the command is of no use.
        self.is_option = user.startswith("--")
        super().__init__(f"{self.message}: {self.hint}")


def need(user: str, *libraries: str) -> None:
    """Raise MissingExtra if one of the `libraries`, all of one extra, is not installed."""
    from importlib.util import find_spec

    missing = [library for library in libraries if find_spec(library) is None]
    if missing:
        raise MissingExtra(user, missing)


def missing(error: BaseException, user: str) -> MissingExtra | None:
    """The error that says what `user` lacks, if `error` came of a library that is not installed; otherwise None."""
    if isinstance(error, MissingExtra):
        return error
    if isinstance(error, ImportError) and error.name in REQUIRED:
        return MissingExtra(user, [error.name])
    return None
