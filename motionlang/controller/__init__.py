"""The virtual multi-axis controller: counts and seconds, no language and no user units.

Start with `controller.Controller`; its public methods, listed in `verbs.VERBS`, are all that a language may do.
"""
