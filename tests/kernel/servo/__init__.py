"""The servo compared with a plain step loop, chapter 12, and the control library."""
