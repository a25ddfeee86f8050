"""Statements in the five source documents, and a command that reproduces each."""
