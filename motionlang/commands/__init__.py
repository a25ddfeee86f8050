"""Questions about one or many runs: cycle time, differences, proof, sweeps."""
