"""What a change did: two runs, or a run and its golden report, aligned by what they have in them and not by numbers."""
