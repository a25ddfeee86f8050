"""Motion other than moves: jogs, following, references, playback."""
