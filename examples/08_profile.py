"""See where the time of a run goes, by line."""

import motionlang

text = "SPEED(0) = 100\nMOVER(0) = 200 : GO(0)\nPAUSE IDLE(0)\nWAIT = 500\n"
profile = motionlang.profile(motionlang.Source("feed.mnt", text))
for share in profile.lines():
    if share.seconds > 0.1 and share.line == 4:
        print(share.line, f"{share.seconds:.2f} s")  # 4 0.50 s
