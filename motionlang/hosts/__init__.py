"""Programs outside the controller: hosts that it serves, clients that talk to it.

`serve` lets hosts connect to a controller that runs a program, by the protocol of `console`; `mint` and `mccl` are the
consoles, ports and line editors of the languages. `client` is the other end: answers and errors of a real, a served or
a virtual board. `commands` has what is typed: `serve`. An ordinary run imports nothing of this package.
"""
