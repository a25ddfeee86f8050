"""What happens at a position: watches, zones, limits, latches, homing."""
