"""Entries of the move buffer other than moves of one axis: paths, cams, offsets, timed points."""
