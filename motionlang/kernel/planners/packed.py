"""Profiles as plain tuples, the compact form of the log, and their restoration.

For ramps the recipe is stored, not the pieces made from it. If a profile was scaled together with its pieces, the
restored pieces may differ in the last bit.
"""

from __future__ import annotations

from math import inf

from motionlang.kernel.planners.curve import Profile, hold
from motionlang.kernel.planners.ramps import Curve
from motionlang.kernel.planners.reparametrised import Reparametrised
from motionlang.kernel.planners.sequence import ProfileSequence
from motionlang.kernel.planners.superposition import Superposed

# (shape, start, end, duration, recipe), followed by the curve if no recipe gives it; (position,) for rest
# without end; (name, arguments, shape, end) for a formula.
Packed = tuple[object, ...]

_HOLD = 1
RAMPS = 5
_CURVE = 6


def packed(profile: Profile) -> Packed:
    """Return a profile as a tuple of numbers, texts and nested tuples."""
    recipe = profile._recipe
    if len(recipe) > 2:
        return profile.shape, profile.start, profile.end, profile.duration, recipe
    if profile.pieced:
        if profile.shape == "hold" and profile.duration == inf:
            return (profile.start,)
        return profile.shape, profile.start, profile.end, profile.duration, recipe, profile.curve
    name = type(profile).__name__
    components = tuple(_packed_component(getattr(profile, each)) for each in _COMPONENTS[name])
    return name, components, profile.shape, profile.end


def unpacked(row: Packed) -> Profile:
    """Return the profile that `packed` has converted to a tuple."""
    if len(row) == _HOLD:
        return hold(row[0])  # type: ignore[arg-type]
    if len(row) == RAMPS:
        return Profile(*row)  # type: ignore[arg-type]
    if len(row) == _CURVE:
        made = Profile(*row[:-1])  # type: ignore[arg-type]
        curve: Curve = row[-1]  # type: ignore[assignment]
        made._curve = curve
        return made
    name, components, shape, end = row
    formula = _formula(name, tuple(_unpacked_component(each) for each in components))  # type: ignore[attr-defined,arg-type]
    formula.shape, formula.end = shape, end  # type: ignore[assignment]  # a path's end is that of its plan
    return formula


# The attributes of each formula, in the order of its arguments.
_COMPONENTS = {
    "ProfileSequence": ("shape", "segments", "name"),
    "Reparametrised": ("along", "path", "shape", "lift"),
    "Superposed": ("first", "second", "shape"),
}


def _packed_component(component: object) -> object:
    if isinstance(component, Profile):
        return ("profile", packed(component))
    if isinstance(component, tuple):
        return ("profiles", tuple(packed(each) for each in component))
    return component


def _unpacked_component(component: object) -> object:
    if not isinstance(component, tuple):
        return component
    kind, content = component
    return unpacked(content) if kind == "profile" else tuple(unpacked(each) for each in content)


def _formula(name: str, components: tuple[object, ...]) -> Profile:
    made: Profile = {
        "ProfileSequence": ProfileSequence,
        "Reparametrised": Reparametrised,
        "Superposed": Superposed,
    }[name](*components)
    return made
