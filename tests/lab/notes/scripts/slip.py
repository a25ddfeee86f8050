"""Print how fast a load that only friction holds may be accelerated, and check a move in four profiles.

The first figures are the example of chapter 12, a cube of 5 lb. The move has a load on a belt, in metres.
"""

from motionlang.kernel.planners import plan
from tests.lab.notes.vendor.dissect import (
    FRICTION,
    GRAVITY_FT,
    SPEED_FT_MIN,
    WEIGHT_LB,
    fastest_time,
    friction_force,
    slip_acceleration,
)
from tests.lab.notes.vendor.slip import check_profile

SHAPES = {
    "trapezoid": "trapezoidal",
    "sinusoidal": "sinusoidal S-curve",
    "scurve": "trapezoidal S-curve",
    "parabolic": "parabolic",
}

limit, speed = slip_acceleration(FRICTION, GRAVITY_FT), SPEED_FT_MIN / 60.0
print(
    f"friction force              {friction_force(WEIGHT_LB, FRICTION):.7g}          {WEIGHT_LB:g} · {FRICTION:g}"
)
print(f"fastest acceleration        {limit:.7g} ft/s²   {FRICTION:g} · {GRAVITY_FT:g}, whatever the weight")
print(f"fastest time to 100 ft/min  {fastest_time(speed, limit):.7f} s  {speed:.7g} / {limit:.7g}")

friction, gravity, distance, speed, accel = 0.25, 9.81, 0.5, 0.8, 2.6
print(f"\n{distance} m at {speed} m/s and {accel} m/s², friction {friction}, gravity {gravity} m/s²")
for shape, name in SHAPES.items():
    profile = plan(shape, 0.0, distance, speed, accel, accel, ramp=0.1)
    found = check_profile(profile, friction, gravity)
    print(
        f"\n{name}: the load {'slips' if found.slips else 'stays'}; peak {found.peak:.7g} of {found.limit:.7g} m/s² "
        f"at {found.peak_time:.7g} s, margin {found.margin:.1%}"
    )
    if found.slips:
        spans = ", ".join(f"{begin:.6f} to {end:.6f} s" for begin, end in found.spans)
        print(f"  beyond the limit from {spans}")
