"""A board behind an ASCII interface: ports, a server's console, and downloads."""
