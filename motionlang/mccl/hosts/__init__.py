"""A board behind an ASCII interface: ports, the console of a server, downloads."""
