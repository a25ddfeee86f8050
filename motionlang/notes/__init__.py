"""Figures that the vendors' notes print, one file per note; no run imports them."""
