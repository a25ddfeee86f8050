"""Statements of the five documents, and the command that reproduces each."""
