"""A debugger that steps back: stops, replay and the journal, without any protocol."""
