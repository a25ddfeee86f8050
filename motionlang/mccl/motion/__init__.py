"""MCCL motion built from several verbs of the controller.

It covers contours, joysticks and searches.
"""
