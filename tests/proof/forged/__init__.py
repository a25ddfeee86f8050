"""Forged logs: single changes of a run's log, which the proof must reject (`logs.py`)."""
