"""Motion that is not a move to a position: jogs, following, references; stopping, suspending, overriding."""
