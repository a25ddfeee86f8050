"""The interactive prompt: `motionlang repl`."""
