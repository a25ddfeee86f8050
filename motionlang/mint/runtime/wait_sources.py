"""What of the machine file can end a wait: the section for the words that a condition looks at."""

from __future__ import annotations

import re

# Words of Mint with brackets -> the section in which the world says what they read.
SECTIONS: dict[str, str] = {
    **dict.fromkeys(("in", "inx", "instate", "instatex", "stopswitch", "homeswitch"), "input"),
    **dict.fromkeys(("adc",), "analogue"),
    **dict.fromkeys(("encoder", "auxencoder"), "encoder"),
    **dict.fromkeys(("comms", "commsinteger"), "comms"),
    **dict.fromkeys(("netinteger", "netfloat"), "netdata"),
    **dict.fromkeys(("dprlong", "dprfloat"), "dpr"),
    **dict.fromkeys(("remotein", "remoteinx", "remoteinbank", "remoteadc"), "remote"),
}
# Words that stand alone, too.
ALONE = {"INPUT": "answer", "INKEY": "key", "READKEY": "key", "SERIALCHAR": "serial"}
_WORD = re.compile(r"([a-z_]\w*)(\s*[(.[])?", re.IGNORECASE)


def what_ends(why: str) -> str:
    """A hint for a wait that nothing ends, from the words that say what it waits for; "" where none is of the world."""
    named = [SECTIONS.get(word.lower()) if bracket else None for word, bracket in _WORD.findall(why)]
    named += [ALONE.get(word.upper()) for word, _ in _WORD.findall(why)]
    found = dict.fromkeys(each for each in named if each)
    if not found:
        return ""
    sections = " or ".join(f"[[{each}]]" for each in found)
    hint = f"the machine file says when it comes, {sections}, and with run.until how long to wait for it"
    typed = "; run --realtime takes it from the keyboard of a terminal"
    return hint + typed if found.keys() & {"answer", "key"} else hint
