"""The quantities of an axis that pictures show, and their units."""

UNITS = {"position": "uu", "velocity": "uu/s", "acceleration": "uu/s²", "jerk": "uu/s³"}
