"""The proof of a run: checks its motion against what the program commanded, without the planners."""
