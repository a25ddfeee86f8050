"""What can be said of an MCCL program without running it."""
