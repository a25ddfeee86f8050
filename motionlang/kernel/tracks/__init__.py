"""What is read from the tracks of the axes: the whole motion, the trace, the motors, the trajectory points."""
