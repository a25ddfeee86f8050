"""Motion that MCCL builds from more than one verb of the controller: contours, joysticks, searches."""
