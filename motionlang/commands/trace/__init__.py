"""The motion of a run as columns of a file."""
