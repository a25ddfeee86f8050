"""Exported frames, sent to a drive."""

from __future__ import annotations

import pytest

from motionlang.lab.pvt.drive.point import to_wire
from motionlang.lab.pvt.export import export
from motionlang.lab.pvt.scurve import scurve
from motionlang_copley.bus import LockstepBus
from motionlang_copley.drive import Drive

SCURVE = to_wire(scurve(1000.0, 0.1))


@pytest.mark.parametrize("form", ["pdo", "sdo", "record"])
@pytest.mark.parametrize("node", [1, 42])
def test_the_frames_move_a_drive(form: str, node: int) -> None:
    """Every exported frame is sent on the bus, and the drive executes the S-curve."""
    drive = Drive()
    with LockstepBus(drive, node) as bus:
        for line in export(SCURVE, form, node).lines:
            if not line.startswith("#"):
                can_id, data = line.split("#")
                bus.network.send_message(int(can_id, 16), bytes.fromhex(data))
    drive.run_until(500_000)
    assert drive.log == [(0.0, "move started at 0"), (0.4, "move ended at 1000")]
    assert [p.end for p in drive.profiles if p.shape == "pvt"] == [83, 500, 917, 1000]
