"""The panel: a machine that is operated in a browser.

`play.py` runs a program in a thread of its own, with the changes of a hand at multiples of 20 ms, and `pace.py`
holds it to real time. `rest.py` says what it waits for. `state.py` shows a machine as data. `session.py` is what all
pages share: it pauses, goes back, starts again and saves (`scenario.py`). `server.py` serves the page and the data, and
takes the actions.
"""
