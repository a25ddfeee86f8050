"""What a run records, and its motion read from it: streams, tracks, trace, figures."""
