"""Runs of MCCL texts."""

from tests.mccl_runs import mccl, update  # noqa: F401
