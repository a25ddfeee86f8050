"""The commands serve and mcapi, which share their options."""
