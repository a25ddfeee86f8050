"""What a real controller recorded, held against what the run says: read, aligned in time, compared move by move."""
