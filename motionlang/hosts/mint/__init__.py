"""A Mint controller for hosts: its serial line, HCP, and the download of programs."""
