"""The tests; `python -m tests` runs the complete check."""

import os

# OpenBLAS sums in an order that depends on the processor, and with it the last digits of a servo response. Recorded
# results need one order. OpenBLAS reads this when NumPy is loaded.
os.environ.setdefault("OPENBLAS_CORETYPE", "Nehalem")
