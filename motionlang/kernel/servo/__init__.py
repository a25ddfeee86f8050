"""The servo behind the profile: control loops, motors, and their simulation.

`Loop` and its forms define how the error becomes a voltage, `Motor` and `VelocityDrive` the effect of the voltage.
`simulate` runs a complete track, `Servo` runs it up to a clock's time. Each name is imported on first use: checking the
keys of a machine file needs only the modules that describe a loop. NumPy is imported only for columns.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from motionlang.kernel.lazy import lazy_names

if TYPE_CHECKING:
    from motionlang.kernel.servo.demand import Track as Track
    from motionlang.kernel.servo.gains import MODELS as MODELS
    from motionlang.kernel.servo.gains import Gains as Gains
    from motionlang.kernel.servo.gains import mccl_loop as mccl_loop
    from motionlang.kernel.servo.gains import mccl_values as mccl_values
    from motionlang.kernel.servo.gains import mint_loop as mint_loop
    from motionlang.kernel.servo.gains import mint_values as mint_values
    from motionlang.kernel.servo.loop import FULL_SCALE as FULL_SCALE
    from motionlang.kernel.servo.loop import Loop as Loop
    from motionlang.kernel.servo.loop import Override as Override
    from motionlang.kernel.servo.plant import Motor as Motor
    from motionlang.kernel.servo.plant import VelocityDrive as VelocityDrive
    from motionlang.kernel.servo.response import LoopFigures as LoopFigures
    from motionlang.kernel.servo.response import StepFigures as StepFigures
    from motionlang.kernel.servo.response import loop_figures as loop_figures
    from motionlang.kernel.servo.response import step_figures as step_figures
    from motionlang.kernel.servo.response import step_response as step_response
    from motionlang.kernel.servo.servo import Servo as Servo
    from motionlang.kernel.servo.servo import simulate as simulate
    from motionlang.kernel.servo.settings import KEYS as KEYS
    from motionlang.kernel.servo.settings import PLANT as PLANT
    from motionlang.kernel.servo.settings import SERVO as SERVO
    from motionlang.kernel.servo.settings import Key as Key
    from motionlang.kernel.servo.settings import make_loop as make_loop
    from motionlang.kernel.servo.settings import make_plant as make_plant
    from motionlang.kernel.servo.settings import section as section
    from motionlang.kernel.servo.trace import ServoTrace as ServoTrace
    from motionlang.kernel.servo.tuning import Suggestion as Suggestion
    from motionlang.kernel.servo.tuning import suggest as suggest

PUBLIC = {
    "loop": "Loop Override FULL_SCALE",
    "plant": "Motor VelocityDrive",
    "demand": "Track",
    "servo": "Servo simulate",
    "trace": "ServoTrace",
    "gains": "Gains MODELS mint_loop mint_values mccl_loop mccl_values",
    "response": "StepFigures LoopFigures step_response step_figures loop_figures",
    "tuning": "Suggestion suggest",
    "settings": "Key KEYS PLANT SERVO section make_loop make_plant",
}

if not TYPE_CHECKING:
    __getattr__ = lazy_names(__name__, PUBLIC)
