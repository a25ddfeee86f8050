"""The interactive prompt: `motionlang repl`.

`Session` takes lines and returns what the terminal of the controller would show; it needs no terminal itself. Around it
are the prompt with its history and completion, the commands that begin with a dot, and the bar that shows the machine.
"""
