"""Debug builds, the debugger's engine, and its commands at the prompt."""
