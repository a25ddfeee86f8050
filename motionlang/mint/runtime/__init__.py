"""A compiled Mint program as it runs: tasks, events, errors, waits, and what generated code calls."""
