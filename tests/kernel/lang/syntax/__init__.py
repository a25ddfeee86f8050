"""Tests of `motionlang.kernel.lang.syntax`."""
