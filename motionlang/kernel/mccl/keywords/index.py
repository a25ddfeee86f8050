"""The keywords of each file, in lower case.

Written by `python -m tools.derived`; do not edit.
"""

from __future__ import annotations

FILES = {
    "trajectory": """
sa ds sv mv pt ps pp sq fs sh
""",
    "trajectory_backlash": """
bd bn bf
""",
    "filter": """
sg si il sd se fr vg ag dg db dt ob oo ph
""",
    "filter_stages": """
om im es hs ms ls fc hc
""",
    "limits": """
lm ln lf hl ll fn ff
""",
    "units": """
us ur ut uk uo uz ua
""",
    "modes_gearing": """
sm ss
""",
    "modes_jog": """
jn jf ja jv jb jg jo
""",
    "motion": """
mn mf ma mr gh go di st ab dh rt pm vm qm gm
""",
    "motion_auxiliary": """
ah af at az
""",
    "motion_homing": """
fi fe ia el we wi
""",
    "motion_points": """
lp lt mp
""",
    "motion_record": """
pr do dr dq
""",
    "contour": """
cp ca cr ea er rr cd vo vv va vd cm sn ns
""",
    "reports": """
tp tt to tf tv ts te tg ti td tl tk tq tb tz tx cx
""",
    "io": """
cn cf ci ct ch cl dn df in if wn wf ga oa tc ta
""",
    "macros": """
md mc mj rm gt et bk tm
""",
    "registers": """
al ar ra aa as am ad an ao ax ae ac sl sr gu tr
""",
    "registers_functions": """
av
""",
    "registers_variables": """
lu rb rw rl rv rd wb ww wl wv wd gx
""",
    "flow": """
rp jp jr ib ie ig iu is ic no
""",
    "flow_waits": """
wa ws wt wp wr ip ir
""",
    "miscellaneous": """
dm hm ef en pc xn xf dw fm cb bc lc nc oc op yf nf zf fl ve he
""",
    "miscellaneous_texts": """
ot ft fd
""",
}
