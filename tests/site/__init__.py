"""The playground, built and used in browsers: `python -m tests.site`.

It needs Node and a Chromium or a Firefox; `python -m tests` needs none of them.
"""
