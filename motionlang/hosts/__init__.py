"""Programs outside the controller: hosts that it serves, clients that talk to it, MCAPI, drives on a CAN bus.

An ordinary run imports nothing of this package.
"""
