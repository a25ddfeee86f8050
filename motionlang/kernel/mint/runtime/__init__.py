"""Run a compiled Mint program: tasks, events, errors, waits, and operations."""
