"""The time profile of a run: each task's own time, and the critical path."""
