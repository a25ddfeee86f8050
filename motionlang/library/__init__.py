"""The library for Python programs: functions, the types of a report, and rows as tables."""
