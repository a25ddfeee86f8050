"""Sessions at the prompt: a program stepped forward and back, showing its state."""

from __future__ import annotations

from collections.abc import Iterator

from motionlang.kernel import Source, dialect, read_machine
from motionlang.repl.session import Session
from tests.generated.draw import Draw
from tests.generated.motion import Generated

# Lines of a session.
LINES = 14


def typed(program: Generated) -> Iterator[str]:
    """Yield the lines that a user types to debug a program in the working directory."""
    draw = Draw(program.seed + 4000)
    first, count = int(program.language == "mccl"), program.text.count("\n") + 1
    variables = sorted({word for word in program.text.split() if word.isidentifier() and word.islower()})
    yield f".debug {program.name}"
    yield f".break {draw.randrange(1, count + 1)}"
    for _ in range(LINES):
        axis, time = first + draw.randrange(3), round(draw.uniform(0.0, 0.1), 3)
        yield draw.choice(
            (
                ".step", ".step", ".step", ".back", ".back", ".reverse", f".goto {time}", f".goto {time}",
                f".changed axis {axis}", ".vars",
                f".vars {draw.choice(variables or ['none'])} + 1", ".axes", ".time", ".report",
                f".break axis {axis} starts",
            )
        )  # fmt: skip
    yield from (".break", ".vars", f".goto {time}", ".axes")


def shown(program: Generated) -> str:
    """Return the session of a program as the screen shows it."""
    settings = read_machine(Source("a.machine.toml", program.machine_file))
    session = Session(dialect(program.language), settings)
    session.width = 80
    try:
        return "".join(f"> {line}\n{session.feed(line)}" for line in typed(program))
    finally:
        if session.debugging is not None:
            session.debugging.debugger.abandon()  # its run waits in a thread with a large stack
