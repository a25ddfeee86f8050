"""Tests of `motionlang.lang.syntax`."""
