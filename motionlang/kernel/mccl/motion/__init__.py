"""MCCL motion built from several operations of the controller.

It covers contours, joysticks and searches.
"""
