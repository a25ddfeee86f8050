"""Motion that MCCL builds from more than one verb of the controller: contours, gears, joysticks, searches."""
