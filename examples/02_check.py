"""Check a program without running it: every mistake, with its line and what to type instead."""

from motionlang import Source, check

for found in check(Source("feed.mnt", "SPED(0) = 100\nMOVER(0) = 200 : GO(0)\n")):
    print(found.line, found.code, found.hint)  # 1 unknown-word did you mean SPEED?
