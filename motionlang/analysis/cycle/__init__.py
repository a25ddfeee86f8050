"""Where the time of a run goes: each task's own time, and the chain of what its end waited for."""
