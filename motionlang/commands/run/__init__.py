"""Run a program and print what it did."""
