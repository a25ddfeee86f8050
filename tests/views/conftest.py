"""The cell of the tests of commands."""

from tests.cell import cell  # noqa: F401
