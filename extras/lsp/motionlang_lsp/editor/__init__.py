"""The features of an editor as pure functions of a text.

They use no protocol, clock or thread.
"""
