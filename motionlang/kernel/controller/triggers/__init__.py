"""Actions that a position or a state triggers: limits, zones, homing."""
