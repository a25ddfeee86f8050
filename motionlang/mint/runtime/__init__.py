"""Run a compiled Mint program: tasks, events, errors, waits, run-time library."""
