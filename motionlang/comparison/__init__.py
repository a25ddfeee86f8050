"""What programs did, and how it differs: acts of two runs, ways or reports, aligned in order and compared in time."""
