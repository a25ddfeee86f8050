"""Questions about a run, or about many: cycle time, differences, recordings, proof, sweeps."""
