"""Clients for controllers; `motionlang.client` is their public name."""
