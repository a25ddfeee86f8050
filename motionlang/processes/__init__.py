"""Worker processes, for commands with many programs or variants."""
