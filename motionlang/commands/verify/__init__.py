"""Do programs still do what they did: golden files, scenarios, sweeps."""
