"""Static checks of MCCL programs."""
