"""The servo: held against a plain step loop, the golden figures of chapter 12, and the control library."""
