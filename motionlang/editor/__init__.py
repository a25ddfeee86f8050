"""The features of an editor as pure functions of a text.

There is no protocol, clock or thread in them.
"""
