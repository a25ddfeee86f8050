"""The state of an MCCL axis: units, mode, inputs, limits, status words, motor."""
