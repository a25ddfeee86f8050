"""The proof of a run: checks its motion against the commands, without planners."""
