"""The log of a run, and the motion that is read from it: streams, tracks, trace, figures."""
