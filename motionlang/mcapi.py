"""MCAPI for virtual boards, as a host imports it: `motionlang.hosts.mcapi`."""

from __future__ import annotations

from motionlang.hosts.mcapi import *  # noqa: F403
