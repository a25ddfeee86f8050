"""Clients for PMC controllers and for the line of a Mint controller: `motionlang.hosts.client`."""

from __future__ import annotations

from motionlang.hosts.client import *  # noqa: F403
