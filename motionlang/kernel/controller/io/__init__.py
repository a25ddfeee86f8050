"""The environment of the axes: channels, encoders, sensors, the host, the wiring."""
