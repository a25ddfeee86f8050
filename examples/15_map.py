"""See what a machine does: its channels, and the states in which it waits."""

import motionlang

text = (
    "' IN 1 part   OUT 2 clamp\nLoop\n  PAUSE INX(1)\n  OUTX(2) = 1\n  WAIT = 200\n  OUTX(2) = 0\nEnd Loop\n"
)
found = motionlang.map(motionlang.Source("clamp.mnt", text))
for channel in found.channels:
    print(channel.known_as, channel.lines)  # input 1 (part) [3]
    break
assert found.behaviour is not None
for state in found.behaviour.states[1:2]:
    print(state.statement, [each.until for each in state.transitions])  # PAUSE INX(1) ['input 1 (part) on']
