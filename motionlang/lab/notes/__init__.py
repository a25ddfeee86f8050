"""Calculations of the vendors' notes, a module per subject; no run imports them.

`tn1069` has PMC's comparison of four profiles and `tn1069_servo` the same under servo control; `an00115` has ABB's
formulas of a trapezoidal move. Of chapter 12 of PMC's manual, `dissect` has the formulas, `figures` the example behind
the figures, `slip` checks a move of a load held by friction, `dac_override` shows what a DAC step does to it, and
`chapter12` is the listing in C. The scripts in `examples/notes/` print what the documents print.
"""
