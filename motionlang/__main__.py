"""`python -m motionlang`."""

from __future__ import annotations

import sys

from motionlang.cli import main

sys.exit(main())
