"""The debugger as a server of the Debug Adapter Protocol, over stdio and TCP."""
