"""What the move buffer holds: moves, paths, cams, offsets, dwells."""
