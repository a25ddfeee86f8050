"""Settings that are kept and read back but have no effect: of motors, drives, feedback, gains, ports, tests, presets.

The program of a real machine begins with pages of them. They are not simulated, and the report says which ones the
program wrote; it runs unchanged all the same. Until they are written they read 0 or an empty text, which the report
says, too. They stand in `type_library/values.txt` as "kept"; here are the constants that are written into them.
"""

from __future__ import annotations

from motionlang.lang.keyword import Keyword

VERB = "no_effect.value"
# Those of them that on a controller end what the axis was doing.
SWITCHES = frozenset(("CONFIG",))
# Those that set a quantity of the servo loop where `motionlang servo` is given them, and none in a run.
TUNES = {"DACLIMITMAX": "output_limit"}
_TYPES = (("OFF", "no axis"), ("SERVO", "a servo"), ("STEPPER", "a stepper"), ("VIRTUAL", "a virtual axis"))
ROWS = (
    *(
        Keyword(f"_cf{name}", "", "constant", "R", "none", "integer", str(value), f"CONFIG: {help}.",
                f"PRINT _cf{name}", group="constants")
        for value, (name, help) in enumerate(_TYPES)
    ),
)  # fmt: skip
