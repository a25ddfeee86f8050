"""What each motion command does to an axis in each state, as tables of text."""
