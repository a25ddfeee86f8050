"""The servo against a plain step loop, chapter 12, and the control library."""
