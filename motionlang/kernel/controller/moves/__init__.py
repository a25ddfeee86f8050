"""What the move buffer can hold besides moves: paths, cams, offsets, timed points."""
