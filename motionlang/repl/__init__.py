"""The prompt: `motionlang repl`."""
