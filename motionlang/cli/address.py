"""The type of an argument that is an address to listen on."""

from __future__ import annotations

import argparse

from motionlang.serve.address import BadAddress, parse


def address(text: str) -> tuple[str, int]:
    """Return host and port of `HOST:PORT`, or of a port number alone."""
    try:
        return parse(text)
    except BadAddress as problem:
        raise argparse.ArgumentTypeError(str(problem)) from None
