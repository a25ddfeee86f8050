"""The cell of the tests."""

from tests.cell import cell  # noqa: F401
