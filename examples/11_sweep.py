"""Run a program in many variants and find the fastest."""

from motionlang import Source, sweep

TEXT = "Dim rate = 100\nSPEED(0) = rate\nMOVER(0) = 200 : GO(0)\nPAUSE IDLE(0)\n"

if __name__ == "__main__":
    rows = sorted(sweep(Source("feed.mnt", TEXT), {"rate": "100:400:4"}, jobs=1), key=lambda row: row.index)
    print([row["rate"] for row in rows])  # [100, 200, 300, 400]
    table = sweep(Source("feed.mnt", TEXT), {"rate": "100:400:4"}, jobs=1).columns()
    print(table["time"] == sorted(table["time"], reverse=True))  # True
