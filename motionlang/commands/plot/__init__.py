"""The motion of a run as a picture."""
