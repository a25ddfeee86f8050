"""The world outside the axes: channels, encoders, sensors, the host, and how the machine is wired."""
