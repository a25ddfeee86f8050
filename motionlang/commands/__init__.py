"""Questions about a program or its runs, a folder each, called as the command is typed.

    motionlang profile pick.mnt    commands/profile/__init__.py   the question: from a run to data
                                   commands/profile/view.py       how the answer looks
                                   commands/profile/command.py    how it is typed: fields, help, exit status

A question knows nothing of a terminal, so `motionlang.functions` asks the same ones. A command without a question of
its own, such as `run` or `trace`, has only its command and its view. `processes` and `quantities` are shared by
several.
"""
