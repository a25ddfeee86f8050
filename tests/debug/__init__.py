"""Debug builds, the engine of the debugger, and its commands at the prompt."""
