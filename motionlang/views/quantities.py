"""The quantities of an axis that pictures show, and their units."""

UNITS = {"position": "uu", "velocity": "uu/s", "acceleration": "uu/s²", "jerk": "uu/s³"}

# The phases of a move and the colours of their shades.
PHASES = {
    "accel": "#e3f4ea",
    "slew": "#edf3fb",
    "decel": "#fdeee2",
    "stop": "#fadede",
    "segment": "#f1ebf9",
    "hold": "#f4f6f8",
}

COLOURS = {
    "position": "#1f5fae",
    "velocity": "#0b7a5b",
    "acceleration": "#b4490f",
    "jerk": "#8a3b76",
    "following error": "#b3261e",
    "output": "#6b4fa0",
    "motor": "#e08a1e",
}
