"""A world that lasts: what only a full batch needs is found by a long run."""

from __future__ import annotations

from motionlang.kernel import Source, dialect_for
from motionlang_explore.exploration import entries, explore
from motionlang_explore.exploration.simple import lasting_world

# Behind eight racks the bath is changed, and the pump waits for its level.
STAINER = """\
; inputs 1 rack on lift  2 lid shut  3 confirm  4 grip made  5 bath full
; outputs 9 grip  10 pump  11 red lamp   registers 20 looks  21 racks
CT9,CT10,CT11
CF9,CF10,CF11
AL0,AR21
1MN,1SV40,1SA400,1DS400
MD10,WN1,WA0.8,IF1,MJ10,NO,CN9,AL50,AR20,MJ11
MD11,IN4,MJ12,NO,WA0.02,RA20,AS1,AR20,IE0,MJ80,NO,JR-10
MD12,1MA360,1WS0.1,WA2,IF2,MC48,NO,1MA0,1WS0.1,CF9,WF4,MJ13
MD13,RA21,AA1,AR21,FT"rack %d done",IG7,MJ70,NO,MJ10
MD48,CN11,OT"LID OPEN",WN2,WN3,CF11
MD70,AL0,AR21,CN10,AL160,AR20,MJ71
MD71,IN5,MJ72,NO,WA0.05,RA20,AS1,AR20,IE0,MJ81,NO,JR-10
MD72,CF10,OT"bath changed",MJ10
MD80,CF9,CN11,OT"GRIP FAULT",WN3,CF11,MJ10
MD81,CF10,CN11,OT"PUMP FAULT",WN3,CF11,MJ70
MJ10
"""


def test_an_input_that_only_a_full_batch_needs_is_taken_into_the_world() -> None:
    source = Source("stainer.mccl", STAINER)
    found = explore(dialect_for(source, None).program(source, {}, is_debug=True))
    world = found.world
    left = [each for each in entries(world.settings, "input") if each["channel"] != 5]
    short = world._replace(settings={**world.settings, "input": left})
    lasting = lasting_world(found._explorer, short._replace(run=found.run(short.settings, 60.0)))
    assert [each for each in entries(lasting.settings, "input") if each["channel"] == 5] == [
        {"channel": 5, "output": 10, "delay": 0.1}
    ]
    said = [each.text for each in lasting.run.machine.log.prints]
    assert any("bath changed" in each for each in said)
    assert not any("PUMP" in each for each in said)
