"""The command serve, and what it shares with other servers of hosts."""
