"""What Python programs use: functions, the types of a report, and rows as tables."""
