"""Profiles as plain tuples, the compact form of the log, and their restoration.

For ramps the recipe is stored, not the pieces made from it. If a profile was scaled together with its pieces, the
restored pieces may differ in the last bit.
"""

from __future__ import annotations

from motionlang.planners.curve import Profile, hold

TYPE_CHECKING = False
if TYPE_CHECKING:
    from motionlang.planners.ramps import Curve

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
        if profile.shape == "hold" and profile.duration == _FOREVER:
            return (profile.start,)
        return profile.shape, profile.start, profile.end, profile.duration, recipe, profile.curve
    name = type(profile).__name__
    parts = tuple(_packed_component(getattr(profile, each)) for each in _PARTS[name])
    return name, parts, profile.shape, profile.end


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
    name, parts, shape, end = row
    formula = _formula(name, tuple(_unpacked_component(each) for each in parts))  # type: ignore[attr-defined,arg-type]
    formula.shape, formula.end = shape, end  # type: ignore[assignment]  # a path's end is that of its plan
    return formula


_FOREVER = float("inf")
# The attributes of each formula, in the order of its arguments.
_PARTS = {
    "Extrapolated": ("profile", "lead"),
    "ProfileSequence": ("shape", "parts", "name"),
    "Reparametrised": ("along", "path", "shape", "lift"),
    "Rate": ("profile",),
    "Superposed": ("first", "second", "shape"),
}


def _packed_component(part: object) -> object:
    if isinstance(part, Profile):
        return ("profile", packed(part))
    if isinstance(part, tuple):
        return ("profiles", tuple(packed(each) for each in part))
    return part


def _unpacked_component(part: object) -> object:
    if not isinstance(part, tuple):
        return part
    kind, held = part
    return unpacked(held) if kind == "profile" else tuple(unpacked(each) for each in held)


def _formula(name: str, parts: tuple[object, ...]) -> Profile:
    from motionlang.planners.extrapolation import Extrapolated
    from motionlang.planners.rate import Rate
    from motionlang.planners.reparametrised import Reparametrised
    from motionlang.planners.sequence import ProfileSequence
    from motionlang.planners.superposition import Superposed

    made: Profile = {
        "Extrapolated": Extrapolated,
        "ProfileSequence": ProfileSequence,
        "Reparametrised": Reparametrised,
        "Rate": Rate,
        "Superposed": Superposed,
    }[name](*parts)
    return made
