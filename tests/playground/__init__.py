"""The Python files of the playground; `python -m tests.site` tests it in browsers."""
