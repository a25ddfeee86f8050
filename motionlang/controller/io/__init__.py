"""The world around the axes: channels, encoders, sensors, the host, the wiring."""
