"""Runs of MCCL texts."""

from tests.mccl_runs import mccl  # noqa: F401
