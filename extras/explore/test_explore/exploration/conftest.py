"""The cell of the test of the command."""

from tests.cell import cell  # noqa: F401
