"""The playground and the documentation site, built and used in browsers.

`python -m tests.site` needs Node, a Chromium or a Firefox, and the extra `site`. `python -m tests` needs none of
these.
"""
