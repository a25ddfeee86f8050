"""The time profile of a run: the time of each task, and the critical path."""
