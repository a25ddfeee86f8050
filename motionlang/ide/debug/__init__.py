"""A debugger that steps forward and back; it does not depend on any protocol."""
