"""Compare a recording of a real controller with the run."""

from motionlang import Source, compare, run

text = "SPEED(0) = 100 : ACCEL(0) = 1000 : DECEL(0) = 1000\nMOVER(0) = 200 : GO(0)\nPAUSE IDLE(0)\n"
result = run(Source("feed.mnt", text))
samples = result.trace(rate=100, quantities=["position"])
# A drive that lags by 30 ms and records the time in milliseconds.
lines = [f"{1000 * time + 30:.3f},{position:.6f}" for time, position in samples.tolist()]
recording = Source("drive.csv", "\n".join(["t,PosAct", *lines]) + "\n")
found = compare(result, recording, {"time": "t*0.001", "position.0": "PosAct"}, tolerances={"position": 0.01})
print(f"{1000 * found.delay:.1f} ms")  # 30.0 ms
print(found.is_within)  # True
