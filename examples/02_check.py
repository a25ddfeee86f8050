"""Check a program without running it.

Every mistake is reported, with its line and a suggested fix.
"""

from motionlang import Source, check

for found in check(Source("feed.mnt", "SPED(0) = 100\nMOVER(0) = 200 : GO(0)\n")):
    print(found.line, found.code, found.hint)  # 1 unknown-word did you mean SPEED?
