"""Figures printed in the vendors' notes, one file per note; no run imports them."""
