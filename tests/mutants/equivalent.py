"""Mutants that have no visible effect, by name, each with the reason.

Effects within rounding do not count, because two computations of one figure may differ in their last bits.
"""

from __future__ import annotations

EQUIVALENT: dict[str, str] = {
    "motionlang/copley/modes.py: ProfileModes: _run: last > here -> last >= here": (
        "an axis at rest at its target is not run; at speed it comes back to it from either side"
    ),
    "motionlang/copley/export.py: _read_back: initial + point.position -> initial - point.position": (
        "the point after an initial position is at that position: its distance is 0"
    ),
    "motionlang/analysis/certificate.py: contradictions: high < inf -> high <= inf": (
        "what has no end upwards has none downwards either, with any slack"
    ),
    "motionlang/analysis/proof/time_bounds.py: move_time: not a0 and distance < 0.0 -> not a0 or distance < 0.0": (
        "from a standstill the time is the same told from either side"
    ),
    "motionlang/log/log.py: Log: _pack_profiles: 0 -> 1 #2": (
        "one profile more stays as it is until the next are packed"
    ),
    "motionlang/analysis/proof/axes.py: check_profile: order.jerks[0] < inf -> order.jerks[0] <= inf": (
        "an endless jerk adds nothing"
    ),
    "motionlang/analysis/proof/path_bounds.py: check_along: span.length <= late -> span.length < late": (
        "just as long as the rounding of its time either is right"
    ),
    "motionlang/analysis/proof/outputs.py: 40 -> 41": (
        "how many rows are looked at, of as many as there are"
    ),
    "motionlang/log/expected_motion.py: _path: 0.0 -> 1.0 #2": ("nothing asks a straight path for its angle"),
    "motionlang/analysis/proof/prove.py: _bend: speed < SLACK -> speed <= SLACK": (
        "just at the size of rounding either is right"
    ),
    "motionlang/log/trace.py: Trace: _stretches: 0 -> 1": (
        "whether a trace of no axis has none or one profile, of the thousands that a stretch may have"
    ),
    "motionlang/servo/discrete.py: exponential: 5 -> 6": ("halved and squared once more, which is the same"),
    "motionlang/controller/feedback.py: Feedback: _check_standstill: "
    "was_at_standstill and (not self.at_standstill) -> was_at_standstill or not self.at_standstill": (
        "one look more at the present sample, which finds nothing new"
    ),
    "motionlang/servo/tuning.py: Suggestion: True -> False #2": (
        "slots: the attributes are the same without"
    ),
    "motionlang/servo/tuning.py: _least: low + edge -> low - edge": (
        "how soon the chords come near, from this side or from that"
    ),
    "motionlang/controller/triggers/next_watches.py: free_interval: at < here -> at <= here": (
        "on a watch neither side is free: the move is planned the long way"
    ),
    "motionlang/controller/io/bits.py: signed: word + 2147483648 -> word - 2147483648": (
        "both are the same in 32 bits"
    ),
    "motionlang/analysis/cycle/motions.py: Motions: that_ended: found >= 0 -> found > 0": (
        "the motion of number 0 is the last that is looked at"
    ),
    "motionlang/mint/keywords/buffer.py: read_status: "
    "(a.move.speed is not None) << 0 -> (a.move.speed is not None) >> 0": (
        "by no place to the left or to the right"
    ),
    "motionlang/mint/keywords/terminal.py: ask: 1 -> 2": (
        "of how often something was done only a change is asked"
    ),
    "motionlang/mint/keywords/presets.py: Presets: choose: value >= 0 -> value > 0": (
        "0 is the number of a channel, and passes the check"
    ),
    "motionlang/mint/keywords/modbus.py: Coils: __init__: 1 -> 2": ("a coil is on at every value but 0"),
    "motionlang/planners/feasibility.py: _travel: v >= speed -> v > speed": (
        "a peak that is just the speed leaves nothing to slew but rounding"
    ),
    "motionlang/planners/jerk_limited.py: JerkLimited: curve: self.duration > knots[-2] -> "
    "self.duration >= knots[-2]": (
        "where both are the same the last piece has no time in which anyone is on it"
    ),
    "motionlang/planners/segment_speed.py: _farthest: 0.5 -> 1.5 #3": (
        "how soon the secants come near; the halves that follow find the last bit from anywhere"
    ),
    "motionlang/planners/reparametrised.py: _on: distance < 0.0 -> distance <= 0.0": (
        "at 0 the straight continuation and the curve have the same position and slope"
    ),
    "motionlang/planners/curve.py: Profile: positions: len(pieces) - 1 -> len(pieces) + 1": (
        "the last knot is the duration, which the time has been found to lie before"
    ),
    "motionlang/planners/transition.py: initial_steps: bounds.decel * bounds.decel -> bounds.decel / bounds.decel": (
        "v0 beside it is at least as large as what can be lost by rounding there"
    ),
    "motionlang/planners/formula.py: Formula: _extremum: last > 0.0 -> last >= 0.0": (
        "a last of 0 has returned in the line before"
    ),
    "motionlang/planners/jerk.py: _directly: 0.5 -> 1.5": (
        "only whether the closed form is asked: the search that is asked otherwise comes to the same plan"
    ),
    "motionlang/planners/jerk.py: _stops_within: 1e-09 -> 1.000000001": (
        "only whether the plan is written out: the general one comes to the same"
    ),
    "motionlang/planners/jerk.py: peak_speed: v - u >= accel * rise -> v - u > accel * rise": (
        "where both are the same the closed form and Newton's steps come to the same speed"
    ),
    "motionlang/planners/jerk.py: _back: beyond <= 0.0 -> beyond < 0.0": (
        "0 is within the rounding that is asked for next"
    ),
    "motionlang/planners/jerk.py: peak_speed: low > 0.05 * (high - u) -> low >= 0.05 * (high - u)": (
        "where both are the same Newton's steps come to the same speed from either bound"
    ),
    "motionlang/planners/lookahead.py: _ramps_of: distance * (1.0 + _SLACK) -> distance / (1.0 + _SLACK)": (
        "`reaches` allows the slack once more, and the speed asked for has been found to fit without any"
    ),
    "motionlang/planners/ramps.py: _add_trapezoidal: 0.0 -> 1.0 #12": "the frequency of a wave of no height",
    "motionlang/planners/sample.py: _sample_short: edges[b] - edges[a] -> edges[b] + edges[a]": (
        "how many points are worked on at once"
    ),
    "motionlang/planners/sample.py: _sample_short: 0 -> 1": "how many points are worked on at once",
    "motionlang/planners/sample.py: _sample_short: 1 -> 2": "how many points are worked on at once",
    "motionlang/views/csv.py: _Buffer: fill: 1 -> 2 #3": (
        "NumPy takes any negative number for the unknown dimension"
    ),
    "motionlang/analysis/compare/alignment.py: _explained: len(run_times) - 1 -> len(run_times) + 1": (
        "a longer Fourier transform is padded with zeros"
    ),
    "motionlang/fast/command_rounds.py: advanced: many > 1 -> many >= 1": "one step at once is one step",
    "motionlang/mint/resolve/definitions.py: _Finder: _walk: known[text] is None and "
    "self.function.scope.find(text.partition('.')[0]) is not None -> known[text] is None or "
    "self.function.scope.find(text.partition('.')[0]) is not None": (
        "a name that is not cached is looked up again, with the same result"
    ),
    "motionlang/planners/table.py: _expand: time >= MOMENT -> time > MOMENT": (
        "exactly at the size of rounding both are right"
    ),
    "motionlang/planners/transition.py: profile_of_steps: 0.0 -> 1.0 #3": (
        "the frequency of a wave of no height"
    ),
    "motionlang/planners/transition.py: profile_of_steps: 0.0 -> 1.0 #4": "the phase of a wave of no height",
    "motionlang/servo/response.py: _gain_margin: ring.imag[:-1] < 0.0 -> ring.imag[:-1] <= 0.0": (
        "a response that is real exactly on the grid is found in the interval before"
    ),
    "motionlang/views/csv.py: _write: column <= -0.5 * 10.0 ** (-decimals) -> column < -0.5 * 10.0 ** "
    "(-decimals)": ("the sign of a number that is exactly half a digit comes from `_write_exactly`"),
    "motionlang/views/csv.py: _write: fractions.max() > near -> fractions.max() >= near": (
        "no row is beyond the bound, so `_write_exactly` has none to write"
    ),
    "motionlang/views/grid.py: decimals_of: 12 -> 13": "values below 1e-9 are 0 with any number of decimals",
    "motionlang/views/table.py: 2 -> 3 #2": (
        "of two columns that are dropped alike, the first is dropped first"
    ),
    "motionlang/cli/pvt_input.py: Move: True -> False": "slots: the attributes are the same without",
    "motionlang/views/outline.py: _points: begin > 0.0 -> begin >= 0.0": (
        "if nothing is in use from 0 on, the window ends at 0, too"
    ),
    "motionlang/mint/keywords/paths.py: put_arc: 2 -> 3": (
        "the centre of an arc is read from two coordinates alone"
    ),
    "motionlang/mint/syntax/layout.py: layout: token.at >= len(spans) -> token.at > len(spans)": (
        "the kinds behind the last span are the end of the text, which is no token of a block"
    ),
    "motionlang/mint/resolve/names.py: Names: __init__: 0 -> 1 #2": (
        "the numbers appended to generated names only have to differ"
    ),
    "motionlang/mccl/axis/inputs.py: _between: mark < here -> mark <= here": (
        "a position on a mark is not between two marks"
    ),
    "motionlang/mint/compile/intervals.py: _whole: a < 0 -> a <= 0": "a quotient of 0 has no sign",
    "motionlang/mint/compile/intervals.py: _whole: b < 0 -> b <= 0": "the divisors are positive",
    "motionlang/mint/compile/intervals.py: _whole: 0 -> 1": "a quotient of 0 has no sign",
    "motionlang/mint/compile/intervals.py: _whole: 0 -> 1 #2": "the smallest divisor of that range is 1",
    "motionlang/mint/compile/intervals.py: remainder: a[0] < 0 -> a[0] <= 0": "max(0, -most) is 0, too",
    "motionlang/mint/compile/intervals.py: remainder: a[1] > 0 -> a[1] >= 0": "min(0, most) is 0, too",
    "motionlang/mint/compile/intervals.py: narrow: 0 -> 1 #6": "both bounds of a constant are the same",
    "motionlang/mint/compile/intervals.py: narrow: 0 -> 1 #7": "both bounds of a constant are the same",
    "motionlang/planners/reparametrised.py: Reparametrised: _distances_at: distance < edge -> distance <= edge": (
        "the end itself is among the crossings of the curve"
    ),
    "motionlang/planners/reparametrised.py: Reparametrised: _distances_at: distance > edge -> distance >= edge": (
        "the end itself is among the crossings of the curve"
    ),
    "motionlang/planners/reparametrised.py: Reparametrised: peak_speed: low < 0.0 -> low <= 0.0": (
        "the section travelled has the slope at its beginning"
    ),
    "motionlang/planners/reparametrised.py: Reparametrised: peak_speed: high > self.path.duration -> "
    "high >= self.path.duration": "the section travelled has the slope at its end",
    "motionlang/planners/reparametrised.py: Reparametrised: _travelled_section: high < length -> "
    "high <= length": "a curve that is cut at its end is the same curve",
    "motionlang/planners/reparametrised.py: Reparametrised: _travelled_section: low > 0.0 -> low >= 0.0": (
        "what is left of a curve after 0 is the same curve"
    ),
    "motionlang/planners/reparametrised.py: _on: distance > path.duration -> distance >= path.duration": (
        "at its end the curve and the straight continuation have the same position and slope"
    ),
    "motionlang/planners/reparametrised.py: crossings: 1000000.0 -> 1000001.0": (
        "how near two crossings of a very long profile may be"
    ),
    "motionlang/lang/machine/operator.py: Operator: __init__: 1.0 -> 2.0": (
        "any time before the run is one at which no key is held"
    ),
    "motionlang/serve/server.py: Server: turn: 1 -> 2 #2": (
        "a single host comes first whichever number it should have"
    ),
    "motionlang/planners/jerk.py: _back: -b > decel -> -b >= decel": (
        "at the limit itself the search comes to the same plan as the closed form"
    ),
    "motionlang/controller/clock.py: WatchedClock: advance_to_news: (due := self.horizon) < end -> "
    "(due := self.horizon) <= end": "the end is watched once, by the loop or behind it",
    "motionlang/mint/runtime/power_up.py: PowerUp: __init__: 0 -> 1": (
        "no setting with a default uses the line of its write while the axis is at rest"
    ),
    "motionlang/planners/jerk.py: plan_jerk: gain >= accel * rise -> gain > accel * rise": (
        "a ramp that just reaches its rate takes 2 A/J, which is 2 sqrt(V/J) for V = A²/J"
    ),
    "motionlang/planners/jerk.py: plan_jerk: gain >= accel * rise -> gain > accel * rise #2": (
        "a ramp that just reaches its rate takes 2 A/J, which is 2 sqrt(V/J) for V = A²/J"
    ),
    "motionlang/planners/jerk.py: plan_jerk: gain >= accel * rise -> gain > accel * rise #3": (
        "the acceleration of a ramp that just reaches its rate rises during half of it"
    ),
    "motionlang/planners/jerk.py: plan_jerk: speed >= decel * fall -> speed > decel * fall": (
        "a ramp that just reaches its rate takes 2 A/J, which is 2 sqrt(V/J) for V = A²/J"
    ),
    "motionlang/planners/jerk.py: plan_jerk: speed >= decel * fall -> speed > decel * fall #2": (
        "a ramp that just reaches its rate takes 2 A/J, which is 2 sqrt(V/J) for V = A²/J"
    ),
    "motionlang/planners/jerk.py: plan_jerk: speed >= decel * fall -> speed > decel * fall #3": (
        "the deceleration of a ramp that just reaches its rate rises during half of it"
    ),
    "motionlang/analysis/proof/blends.py: _check_begin: 0 -> 1": (
        "before the second order of an axis only a path that took no time can have ended"
    ),
    "motionlang/debug/debugger.py: 65536 -> 65537": "a caller further back is found in the complete history",
    "motionlang/mcapi/calls/controller.py: old_configuration: 8 -> 9": (
        "of the types filled up, the first 8 are taken"
    ),
    "motionlang/controller/motion/follow.py: Gear: _log_offset: entry is None or entry.profile is None -> "
    "entry is None and entry.profile is None": "no program is known whose offset has no entry with a profile",
    "motionlang/controller/io/sensor.py: _last: 1 -> 2": (
        "the loop that follows counts down from any later tick"
    ),
    "motionlang/copley/switches.py: Switches: next_index: direction > 0 -> direction >= 0": (
        "the speed of a search is positive"
    ),
    "motionlang/copley/modes.py: ProfileModes: _search: velocity > 0 -> velocity >= 0": (
        "the speed of a search is positive"
    ),
    "motionlang/copley/modes.py: ProfileModes: _search: velocity > 0 -> velocity >= 0 #2": (
        "the speed of a search is positive"
    ),
    "motionlang/copley/modes.py: ProfileModes: __init__: False -> True": (
        "to choose the mode resets the handshake"
    ),
    "motionlang/copley/point.py: _field_trouble: wire + 2 ** 31 -> wire - 2 ** 31": (
        "both are the same in 32 bits"
    ),
    "motionlang/copley/master.py: Master: __init__: 0 -> 1": "the status is read before the first point",
    "motionlang/copley/master.py: Master: __init__: 0 -> 1 #2": "the status is read before the first point",
    "motionlang/copley/master.py: Master: __init__: 0 -> 1 #3": "the status is read before the first point",
    "motionlang/copley/master.py: Master: __init__: True -> False": (
        "the status is read before the first point"
    ),
    "motionlang/planners/crossing.py: _stays_on_one_side: 0.0 -> 1.0": (
        "the piece is searched instead, with the same result"
    ),
    "motionlang/servo/lookahead.py: crossing: off[0] > 0.0 -> off[0] >= 0.0": (
        "a first sample at the level is handled before"
    ),
    "motionlang/planners/transition.py: profile_of_steps: v1 * sign -> v1 / sign": "the sign is 1 or -1",
    "motionlang/planners/transition.py: profile_of_steps: v0 * sign -> v0 / sign": "the sign is 1 or -1",
    "motionlang/planners/transition.py: profile_of_steps: v0 * sign -> v0 / sign #2": "the sign is 1 or -1",
    "motionlang/mccl/resolve/decode.py: _no_command: False -> True": (
        "the command has no effect to count: its fault ends the line"
    ),
    "motionlang/mccl/motion/arcs.py: centre_between: abs(reach - radius) <= _EVEN * radius -> "
    "abs(reach - radius) < _EVEN * radius": ("at the size of rounding both centres are the same"),
    "motionlang/mccl/motion/arcs.py: centre_between: _EVEN * radius -> _EVEN / radius": (
        "at the size of rounding both centres are the same"
    ),
    "motionlang/mccl/motion/arcs.py: centre_between: abs(angle_to(start, end, centre, sense)) > 180.0 -> "
    "abs(angle_to(start, end, centre, sense)) >= 180.0": (
        "at a half circle the correction is half of the miss, which is allowed"
    ),
    "motionlang/mccl/motion/arcs.py: centre_between: 180.0 -> 181.0": (
        "just beyond a half circle the correction is half of the miss, which is allowed"
    ),
    "motionlang/mccl/motion/arcs.py: centre_between: abs(share) * hypot(dx, dy) > _MISS * radius -> "
    "abs(share) * hypot(dx, dy) >= _MISS * radius": (
        "only rounding decides if a correction is just as large as allowed"
    ),
    "motionlang/mccl/motion/arcs.py: end_of: 12 -> 13": ("the digits that rounding leaves"),
    "motionlang/mccl/motion/arcs.py: end_of: 12 -> 13 #2": ("the digits that rounding leaves"),
    "motionlang/mccl/motion/arcs.py: centre_by_radius: chord > 2.0 * abs(radius) * (1.0 + 1e-09) -> "
    "chord >= 2.0 * abs(radius) * (1.0 + 1e-09)": ("the limit is a diameter and an allowance for rounding"),
    "motionlang/mccl/motion/arcs.py: centre_by_radius: radius > 0.0 -> radius >= 0.0": (
        "a radius of 0 is too small for any chord"
    ),
    "motionlang/mccl/motion/arcs.py: _round: angle * sense -> angle / sense": ("the sense is 1 or -1"),
    "motionlang/mccl/motion/arcs.py: _round: found < _NONE -> found <= _NONE": (
        "just at the size of rounding either is right"
    ),
    "motionlang/mccl/motion/arcs.py: _round: found > 360.0 - _NONE -> found >= 360.0 - _NONE": (
        "just at the size of rounding either is right"
    ),
    "motionlang/controller/moves/geometry.py: Arc: shift: 2 -> 3": (
        "the axes are numbered in order, so another one behind the last changes no index"
    ),
    "motionlang/controller/moves/geometry.py: Arc: lay: round_ / length * (1.0 if sweep > 0.0 else -1.0) -> "
    "round_ / length / (1.0 if sweep > 0.0 else -1.0)": ("the sign is 1 or -1"),
    "motionlang/controller/moves/geometry.py: Arc: lay: sweep > 0.0 -> sweep >= 0.0": (
        "an arc of no angle is laid as a line before"
    ),
    "motionlang/controller/moves/geometry.py: Arc: _joined: i < j -> i <= j": ("the plane has two axes"),
    "motionlang/controller/moves/geometry.py: Arc: _joined: i < j -> i <= j #2": ("the plane has two axes"),
    "motionlang/controller/moves/geometry.py: corner: cosine > 0.9 -> cosine >= 0.9": (
        "both formulas give the angle there"
    ),
    "motionlang/controller/axis.py: Axis: velocity: time >= began -> time > began": (
        "the profile in force at its beginning is the same one"
    ),
    "motionlang/controller/axis.py: Axis: position: time >= began -> time > began": (
        "the profile in force at its beginning is the same one"
    ),
    "motionlang/mccl/keywords/flow_waits.py: passing: ready: (position - controller.position(number)) * side -> "
    "(position - controller.position(number)) / side": ("the side is 1 or -1"),
    "motionlang/repl/runner.py: Runner: __init__: 0.0 -> 1.0": (
        "the first command replaces the task that waits"
    ),
    "motionlang/repl/runner.py: Runner: __init__: 0.0 -> 1.0 #2": (
        "the first command replaces the task that waits"
    ),
    "motionlang/client/client.py: Client: _await_version: 0 -> 1": (
        "an answer with a prompt has three bytes or more"
    ),
    "motionlang/client/wire.py: TcpWire: __init__: 1 -> 2": "a socket option is on at every value but 0",
    "motionlang/mcapi/client.py: PortCalls: _connect: 1 -> 2": "a socket option is on at every value but 0",
    "motionlang/mcapi/client.py: PortCalls: _exchange: 65536 -> 65537": "how much is read at once",
    "motionlang/mcapi/calls/recording.py: capture_settings: 0.0 -> 1.0": "only the number of points is used",
    "motionlang/mcapi/log.py: _late: begin < latest -> begin <= latest": (
        "calls that begin at the same time are read in the order of their lines"
    ),
    "motionlang/mcapi/replay.py: Replay: _reach: console.now < time -> console.now <= time": (
        "a run up to the present changes nothing"
    ),
    "motionlang/lsp/documents.py: Document: change: end < start -> end <= start": (
        "both ends of an empty range are the same"
    ),
    "motionlang/serve/address.py: listen: 1 -> 2": "a socket option is on at every value but 0",
    "motionlang/serve/channel.py: TcpChannel: __init__: 1 -> 2": "a socket option is on at every value but 0",
    "motionlang/serve/channel.py: TcpChannel: __init__: 1 -> 2 #2": (
        "a socket option is on at every value but 0"
    ),
    "motionlang/mcapi/call.py: Call: __init__: 0 -> 1": "a call has the number of its host before it begins",
    "motionlang/mcapi/calls/dialogs.py: _sections: 1e+300 -> 1e+300": "the same number in floating point",
    "motionlang/mcapi/calls/settings.py: _direction: axis.direction > 0 -> axis.direction >= 0": (
        "a direction is 1 or -1"
    ),
    "motionlang/mcapi/session.py: Session: open: 2 -> 3": (
        "one number behind the last is enough to be refused"
    ),
    "motionlang/mcapi/session.py: wrapped: bits < 0 -> bits <= 0": "no integer has 0 bits",
    "motionlang/client/answer.py: end_of: 1 -> 2": "the byte before the searched ones belongs to no prompt",
    "motionlang/planners/feasibility.py: _travel: 0.0 -> 1.0 #10": "both ends of a slew have the same speed",
    "motionlang/planners/jerk.py: _directly: 3.0 -> 4.0": (
        "a plan without a closed form is left to the search, which finds the same plan"
    ),
    "motionlang/planners/solve.py: 0.0 -> 1.0": "equal ramps have no share of the time",
    "motionlang/fast/polled_ticks.py: 2 -> 3": "a walk that ends earlier continues tick by tick",
    "motionlang/mint/resolve/definitions.py: _Finder: _outline: block.name < 0 -> block.name <= 0": (
        "the name of a block follows its first token, so it is never token 0"
    ),
    "motionlang/mint/resolve/definitions.py: _Finder: _outline: block.name < 0 -> block.name <= 0 #2": (
        "the name of a block follows its first token, so it is never token 0"
    ),
    "motionlang/serve/outside.py: RealTime: advance: due_time > self.clock.now -> due_time >= self.clock.now": (
        "an advance to the present changes nothing"
    ),
    "motionlang/analysis/proof/entries.py: _check_ended: time < end + (late if last.tie is not None else -late) -> "
    "time <= end + (late if last.tie is not None else -late)": (
        "just at the size of rounding either is right"
    ),
    "motionlang/serve/address.py: listen: 128 -> 129": "the system bounds how many connections may wait",
    "motionlang/serve/server.py: Server: _woken: 64 -> 65": "how many signals to wake up are taken at once",
    "motionlang/serve/modbus.py: 10.0 -> 11.0": "the longest wait for a thread that starts and ends at once",
    "motionlang/serve/pace.py: LockStep: entered: self._busy_until > self._console.now -> "
    "self._busy_until >= self._console.now": "to run up to the present changes nothing",
    "motionlang/serve/pace.py: LockStep: work: self._busy_until > console.now -> self._busy_until >= console.now": (
        "to run up to the present changes nothing"
    ),
    "motionlang/serve/pace.py: LockStep: work: 1e+300 -> 1e+300": "the same number in floating point",
    "motionlang/views/servo_plot.py: plot_comparison: 0 -> 1 #2": (
        "every panel has the same lines for the legend"
    ),
    "motionlang/views/servo_plot.py: plot_comparison: 0 -> 1 #3": (
        "every panel has the same lines for the legend"
    ),
    "motionlang/views/csv.py: Formatter: _block: 1 -> 2 #3": "no row is a single character",
    "motionlang/views/csv.py: Formatter: _block: 1 -> 2 #4": "only what follows the first comma is used",
    "motionlang/views/csv.py: Formatter: _block: not self._first.fill(columns[:1], self._decimals[:1], _COMMA) -> "
    "self._first.fill(columns[:1], self._decimals[:1], _COMMA)": "the slow way writes the same",
    "motionlang/views/csv.py: _standstills: np.diff(edges) > LONG_REST -> np.diff(edges) >= LONG_REST": (
        "a rest is written the same in either way"
    ),
    "motionlang/views/csv.py: _Buffer: fill: 10.0 -> 11.0": "the slow way writes the same",
    "motionlang/views/outline.py: thinned: begin > 0.0 -> begin >= 0.0": "no point lies before 0",
    "motionlang/views/terminal.py: _picture: code < 32 -> code <= 32": "a blank is printable",
    "motionlang/views/terminal.py: _picture: 32 -> 33": "a blank is printable",
    "motionlang/views/table.py: _is_short: row.get('commanded_speed', 0.0) > row['peak_speed'] * (1.0 + 1e-09) -> "
    "row.get('commanded_speed', 0.0) >= row['peak_speed'] * (1.0 + 1e-09)": (
        "just at the size of rounding either is right"
    ),
    "motionlang/views/diff.py: change_lines: 0 -> 1": "only the line of the status is taken",
    "motionlang/fast/command_rounds.py: CommandRounds: jumped: until - CLOSE - now -> until - CLOSE + now": (
        "the lines that follow come down to the rounds that fit"
    ),
    "motionlang/lang/statement_time.py: StatementTime: __init__: abs(cost * UNITS - whole) < 1e-06 "
    "-> abs(cost * UNITS - whole) <= 1e-06": ("just at the size of rounding either is right"),
    "motionlang/fast/recurrence.py: Recurrence: __init__: 0 -> 1 #2": "one byte more of ten million",
    "motionlang/fast/recurrence.py: Recurrence: _begin: 0 -> 1": "one byte more of ten million",
    "motionlang/analysis/proof/path_bounds.py: check_along: back < -SLACK * max(1.0, slow.came) -> back <= "
    "-SLACK * max(1.0, slow.came)": ("just at the size of rounding either is right"),
    "motionlang/analysis/proof/path_bounds.py: check_along: fast <= SLACK * max(1.0, slow.came) -> fast < "
    "SLACK * max(1.0, slow.came)": ("just at the size of rounding either is right"),
    "motionlang/analysis/proof/path_bounds.py: check_along: peak > SLACK -> peak >= SLACK": (
        "just at the size of rounding either is right"
    ),
    "motionlang/analysis/proof/path_bounds.py: check_along: rate > SLACK * max(order.rates) -> rate >= SLACK "
    "* max(order.rates)": ("just at the size of rounding either is right"),
    "motionlang/analysis/proof/path_bounds.py: _check_end: reached > expected + SLACK * max(1.0, slow.came) + "
    "4.0 * late * max(order.rates) -> reached >= expected + SLACK * max(1.0, slow.came) + 4.0 * late * "
    "max(order.rates)": ("just at the size of rounding either is right"),
    "motionlang/analysis/proof/path_bounds.py: _check_joins: gap > slack + (rounded if name == 'acceleration' else "
    "0.0) -> gap >= slack + (rounded if name == 'acceleration' else 0.0)": (
        "just at the size of rounding either is right"
    ),
    "motionlang/analysis/proof/path_bounds.py: check_path_time: abs(first[2]) > SLACK * max(by.rates) -> "
    "abs(first[2]) >= SLACK * max(by.rates)": ("just at the size of rounding either is right"),
    "motionlang/analysis/proof/path_bounds.py: check_path_time: span.peak(1) > SLACK * speed -> span.peak(1) "
    ">= SLACK * speed": ("just at the size of rounding either is right"),
    "motionlang/analysis/proof/path_bounds.py: check_path_time: last[1] > SLACK * speed -> last[1] >= SLACK * speed": (
        "just at the size of rounding either is right"
    ),
    "motionlang/analysis/proof/paths.py: check_path: travelled >= layout.length * (1.0 - SLACK) -> "
    "travelled > layout.length * (1.0 - SLACK)": ("just at the size of rounding either is right"),
    "motionlang/analysis/proof/paths.py: check_path: abs(at - last) <= SLACK * max(1.0, abs(last)) -> "
    "abs(at - last) < SLACK * max(1.0, abs(last))": ("just at the size of rounding either is right"),
    "motionlang/analysis/proof/paths.py: check_path_end: PathLayout(path, starts).length > SLACK -> "
    "PathLayout(path, starts).length >= SLACK": ("just at the size of rounding either is right"),
    "motionlang/analysis/proof/path_bounds.py: enters_too_fast: lead(v0, a, most, by)[1] > left * (1.0 - "
    "SLACK) -> lead(v0, a, most, by)[1] >= left * (1.0 - SLACK)": (
        "just at the size of rounding either is right"
    ),
    "motionlang/analysis/proof/paths.py: stops_within: lead(velocity, acceleration, 0.0, by)[1] <= left "
    "* (1.0 + SLACK) -> lead(velocity, acceleration, 0.0, by)[1] < left * (1.0 + SLACK)": (
        "just at the size of rounding either is right"
    ),
    "motionlang/analysis/proof/path_bounds.py: until_rest: abs(span.at(span.length)[1]) <= SLACK * max(1.0, "
    "along[0].at(0.0)[1]) -> abs(span.at(span.length)[1]) < SLACK * max(1.0, along[0].at(0.0)[1])": (
        "just at the size of rounding either is right"
    ),
    "motionlang/analysis/proof/path_bounds.py: cannot_stop: lead(v0, a0 if by.smooth else 0.0, 0.0, by)[1] > "
    "left * (1.0 + SLACK) -> lead(v0, a0 if by.smooth else 0.0, 0.0, by)[1] >= left * (1.0 + SLACK)": (
        "just at the size of rounding either is right"
    ),
    "motionlang/analysis/proof/paths.py: _check_path: apart > slack * max(map(abs, layout.path.scales)) "
    "-> apart >= slack * max(map(abs, layout.path.scales))": ("just at the size of rounding either is right"),
    "motionlang/analysis/proof/paths.py: _check_path: off > slack -> off >= slack": (
        "just at the size of rounding either is right"
    ),
    "motionlang/analysis/proof/paths.py: _leads_to: abs(after.start_time - end) > ROUNDED * (1.0 + end) "
    "-> abs(after.start_time - end) >= ROUNDED * (1.0 + end)": (
        "just at the size of rounding either is right"
    ),
    "motionlang/analysis/proof/checker.py: Proof: uses: share <= 1.0 + SLACK -> share < 1.0 + SLACK": (
        "just at the size of rounding either is right"
    ),
    "motionlang/analysis/proof/checker.py: _continued_by: abs(move.start_time - end) <= 4.0 * ROUNDED * "
    "(1.0 + end) -> abs(move.start_time - end) < 4.0 * ROUNDED * (1.0 + end)": (
        "just at the size of rounding either is right"
    ),
    "motionlang/analysis/proof/checker.py: position: a.starts[i] >= time - ROUNDED * (1.0 + time) -> "
    "a.starts[i] > time - ROUNDED * (1.0 + time)": ("just at the size of rounding either is right"),
    "motionlang/analysis/proof/offsets.py: _left: abs(start - end) > LATE * (1.0 + start) -> abs(start - "
    "end) >= LATE * (1.0 + start)": ("just at the size of rounding either is right"),
    "motionlang/analysis/proof/offsets.py: check_offset: abs(profile.end - wanted) > SLACK * max(1.0, "
    "abs(wanted)) -> abs(profile.end - wanted) >= SLACK * max(1.0, abs(wanted)) #2": (
        "just at the size of rounding either is right"
    ),
    "motionlang/analysis/proof/offsets.py: check_offset: abs(profile.end - wanted) > SLACK * max(1.0, "
    "abs(wanted)) -> abs(profile.end - wanted) >= SLACK * max(1.0, abs(wanted))": (
        "just at the size of rounding either is right"
    ),
    "motionlang/analysis/proof/offsets.py: check_offset: abs(time - end) <= late -> abs(time - end) < late": (
        "just at the size of rounding either is right"
    ),
    "motionlang/analysis/diff/timeline.py: Timeline: _before: ends[0][0] <= start + NEAR -> ends[0][0] < "
    "start + NEAR": ("just at the size of rounding either is right"),
    "motionlang/analysis/proof/slowing.py: Slowing: bound: middle < self.until -> middle <= self.until": (
        "a segment is cut where an excuse ends, so its middle is elsewhere"
    ),
    "motionlang/analysis/proof/path_bounds.py: check_along: middle < slow.until -> middle <= slow.until": (
        "a segment is cut where an excuse ends, so its middle is elsewhere"
    ),
    "motionlang/analysis/proof/path_bounds.py: check_along: middle < slow.eased -> middle <= slow.eased": (
        "a segment is cut where an excuse ends, so its middle is elsewhere"
    ),
    "motionlang/analysis/proof/path_bounds.py: check_along: middle < max(slow.until, slow.eased) -> middle <= "
    "max(slow.until, slow.eased)": ("a segment is cut where an excuse ends, so its middle is elsewhere"),
    "motionlang/analysis/proof/slowing.py: Slowing: expected: time <= 0.0 -> time < 0.0": (
        "no time is left for the sections that follow"
    ),
    "motionlang/analysis/proof/slowing.py: _stretches: size > rate -> size >= rate": (
        "at the rate itself both formulas are the same"
    ),
    "motionlang/analysis/proof/slowing.py: _stretches: size > rate -> size >= rate #2": (
        "at the rate itself both formulas are the same"
    ),
    "motionlang/analysis/proof/slowing.py: slowing: a0 < 0.0 -> a0 <= 0.0": (
        "without an acceleration nothing leads beyond rest"
    ),
    "motionlang/analysis/proof/slowing.py: slowing: a0 > 0.0 -> a0 >= 0.0": (
        "an acceleration of 0 adds nothing"
    ),
    "motionlang/analysis/proof/path_bounds.py: _permitted: slow.speed > least -> slow.speed >= least": (
        "the speed that is always allowed is a bound without it"
    ),
    "motionlang/analysis/proof/path_layout.py: PathLayout: _angles: angle + k * 0.5 * pi < high -> angle "
    "+ k * 0.5 * pi <= high": ("the end of the arc is among its angles"),
    "motionlang/analysis/proof/checker.py: Run: logged: ends[before] > time -> ends[before] >= time": (
        "a path that ends just then has no distance left"
    ),
    "motionlang/analysis/proof/checker.py: Run: logged: chains[after][0].start_time < time -> "
    "chains[after][0].start_time <= time": ("a path that begins just then has travelled nothing"),
    "motionlang/analysis/proof/checker.py: Run: logged: entry.start_time < time -> entry.start_time <= time": (
        "an entry that begins just then has travelled nothing"
    ),
    "motionlang/analysis/proof/checker.py: Run: logged: _end(entry) <= time -> _end(entry) < time": (
        "an entry that ends just then has no distance left"
    ),
    "motionlang/analysis/diff/timeline.py: Timeline: _put: 1 -> 2": (
        "the numbers only keep the order of equal ends"
    ),
    "motionlang/analysis/diff/timeline.py: Timeline: __init__: 0 -> 1": (
        "the numbers only keep the order of equal ends"
    ),
    "motionlang/analysis/diff/charged.py: charged: abs(each.seconds) > NOTHING -> abs(each.seconds) >= NOTHING": (
        "just at the size of rounding either is right"
    ),
    "motionlang/analysis/diff/reports.py: _moves: False -> True #2": (
        "the starts in a merged run are not used here"
    ),
    "motionlang/analysis/diff/reports.py: _moves: True -> False #2": (
        "the starts in a merged run are not used here"
    ),
    "motionlang/analysis/proof/axes.py: _slowing: begun.came > speed -> begun.came >= speed": (
        "a speed just at the limit needs no excuse"
    ),
    "motionlang/analysis/proof/flanks.py: _flank: 0.0 -> 1.0 #5": (
        "a wave with one figure of 1 and the others 0 is no motion"
    ),
    "motionlang/analysis/proof/flanks.py: _flank: 0.0 -> 1.0 #6": (
        "a wave with one figure of 1 and the others 0 is no motion"
    ),
    "motionlang/analysis/proof/flanks.py: _flank: 0.0 -> 1.0 #7": (
        "a wave with one figure of 1 and the others 0 is no motion"
    ),
    "motionlang/analysis/proof/followers.py: _check_table: abs(travelled - wanted) > size -> "
    "abs(travelled - wanted) >= size": ("just at the size of rounding either is right"),
    "motionlang/analysis/proof/followers.py: _check_table: abs(curve.end - curve.start - values[-1] + "
    "values[0]) > size -> abs(curve.end - curve.start - values[-1] + values[0]) >= size": (
        "just at the size of rounding either is right"
    ),
    "motionlang/analysis/proof/followers.py: _check_table: abs(stated - slope) * positions[-1] > size -> "
    "abs(stated - slope) * positions[-1] >= size": ("just at the size of rounding either is right"),
    "motionlang/analysis/proof/followers.py: _check_table: abs(_on(curve, 0.5 * (left + right)) - first "
    "- 0.5 * (low + high) + values[0]) > size -> abs(_on(curve, 0.5 * (left + right)) - first - 0.5 * "
    "(low + high) + values[0]) >= size": ("just at the size of rounding either is right"),
    "motionlang/analysis/proof/outputs.py: _check_peak: reported > seen + slack -> reported >= seen + slack": (
        "just at the size of rounding either is right"
    ),
    "motionlang/servo/servo.py: Servo: _first_beyond: seen.first_beyond(limit) * self.loop.servo_rate -> "
    "seen.first_beyond(limit) / self.loop.servo_rate": ("the samples before it are then run one by one"),
    "motionlang/analysis/proof/flanks.py: begin: 0 -> 1": "both jerks are infinite, or neither is",
    "motionlang/analysis/proof/path_bounds.py: _check_joins: 0 -> 1": (
        "both jerks are infinite, or neither is"
    ),
    "motionlang/analysis/proof/paths.py: stops_within: 0 -> 1 #5": (
        "a stop from a positive speed only slows down"
    ),
    "motionlang/analysis/proof/paths.py: _check_path: each.begin <= share * length -> each.begin < share * length": (
        "where two segments meet both are at the same distance"
    ),
    "motionlang/analysis/sweeps/pool.py: 0.2 -> 1.2": (
        "when other processes are started; the rows are the same"
    ),
    "motionlang/servo/response.py: loop_figures: phase + 180.0 -> phase - 180.0": "both are the same angle",
    "motionlang/servo/response.py: loop_figures: 360.0 -> 361.0": (
        "only rounding decides if a phase is exactly 180 degrees"
    ),
    "motionlang/servo/response.py: _last_fall: gain[:-1] >= 1.0 -> gain[:-1] > 1.0": (
        "only rounding decides if a gain of the grid is exactly 1"
    ),
    "motionlang/servo/response.py: _last_fall: gain[1:] < 1.0 -> gain[1:] <= 1.0": (
        "only rounding decides if a gain of the grid is exactly 1"
    ),
    "motionlang/log/history.py: MoveFigures: __init__: -inf -> inf #2": (
        "a move without samples at rest has settled, whichever was the last"
    ),
    "motionlang/log/history.py: MoveFigures: __init__: 0.0 -> 1.0 #3": (
        "without samples the time at which the error was last outside is infinite"
    ),
    "motionlang/log/history.py: _Done: collect: self._begins[following] <= end -> "
    "self._begins[following] < end": ("a move that begins with the next block has no samples in this one"),
    "motionlang/mccl/keywords/flow.py: repeat: here != task.loop_log.end or task.loop_log.target -> "
    "here != task.loop_log.end and task.loop_log.target": (
        "a running loop from the first command on is extended only by a later RP, which has closed it before"
    ),
    "motionlang/mccl/keywords/flow.py: repeat: here != task.loop_log.end -> here == task.loop_log.end": (
        "to record a jump of a running loop again changes nothing"
    ),
    "motionlang/mccl/keywords/flow_waits.py: passing: 1.0 -> 2.0": "how large the allowance for rounding is",
    "motionlang/mccl/keywords/flow_waits.py: passing: 1.0 -> 2.0 #2": (
        "how large the allowance for rounding is"
    ),
    "motionlang/mccl/axis/motion_phase.py: at_target_time: axis.deadband <= 0.0 -> axis.deadband < 0.0": (
        "a move comes within 0 of its target when it ends"
    ),
    "motionlang/mccl/runtime/task.py: CommandTask: _continue: horizon < until -> horizon <= until": (
        "both are the same there"
    ),
    "motionlang/mint/runtime/waits.py: Waits: _log_passed: horizon < scheduler.until -> "
    "horizon <= scheduler.until": ("both are the same there"),
    "motionlang/serve/outside.py: LockStep: advance: self.clock.next_time() < time -> "
    "self.clock.next_time() <= time": ("an advance that ends early is repeated by its caller"),
    "motionlang/mcapi/replay.py: Replay: _reach: console.now < check.due -> console.now <= check.due": (
        "a run up to the present changes nothing"
    ),
    "motionlang/mint/compile/unsimulated_use.py: _location: 1 -> 2": "every negative offset means the same",
    "motionlang/mint/compile/for_loops.py: _continues: kind == 'i' -> kind != 'i'": (
        "the general condition means the same"
    ),
    "motionlang/mint/compile/for_loops.py: _continues: kind == 'i' -> kind != 'i' #2": (
        "the general condition means the same"
    ),
    "motionlang/mint/compile/for_loops.py: _continues: low > 0 -> low >= 0": (
        "a step of 0 counts upwards in the general condition, too"
    ),
    "motionlang/mint/compile/for_loops.py: _continues: 0 -> 1": "the general condition means the same",
    "motionlang/mccl/runtime/task.py: CommandTask: __init__: 0 -> 1 #3": (
        "a task without a line has no present command"
    ),
    "motionlang/copley/modes.py: crossing: profile.position(high) > position -> "
    "profile.position(high) >= position": ("the profile ends beyond the position"),
    "motionlang/log/history.py: MoveFigures: _sample_index: 62 -> 63": ("any index beyond all blocks"),
    "motionlang/mint/compile/statements.py: inner: 0 -> 1": (
        "at which depth a nested block becomes a function of its own"
    ),
    "motionlang/log/history.py: MoveFigures: _sample_index: 1 -> 2 #2": "any index beyond all blocks",
    "motionlang/mccl/keywords/flow.py: repeat: 1 -> 2 #3": "only a change of the number of effects matters",
    "motionlang/mint/runtime/waits.py: Rests: _computed: rest: 2 -> 3": (
        "a record that is made again is the same"
    ),
    "motionlang/mint/runtime/waits.py: Rests: rest_at: milliseconds / 1000.0 >= MIN_WAIT -> "
    "milliseconds / 1000.0 > MIN_WAIT": ("both functions wait as long there"),
    "motionlang/mint/lint/brackets.py: _Chain: _end: -1 -> 1 #2": (
        "between two operators of a chain all brackets are closed"
    ),
    "motionlang/mint/lint/brackets.py: _Chain: _end: 1 -> 2 #3": (
        "a bracket may be inserted on either side of one that closes"
    ),
    "motionlang/mint/lint/brackets.py: _Chain: _written: 0 -> 1": (
        "no text is between the first token of a line and itself"
    ),
    "motionlang/mint/lint/brackets.py: _Chain: _end: 1 -> 2 #2": (
        "between two operators of a chain all brackets are closed"
    ),
    "motionlang/planners/segment_speed.py: _farthest: -under < over -> -under <= over": (
        "if both ends are equally far, the direction of the small step does not matter"
    ),
    "motionlang/planners/curve.py: Profile: _beyond: time > self.duration -> time >= self.duration": (
        "at the end itself the added distance is 0"
    ),
    "motionlang/lang/waits.py: Condition: due: moment > now -> moment >= now": (
        "every moment is later than the begin, which is not before now"
    ),
    "motionlang/mint/compile/jumps.py: _write_groups: len(b.lines) - first < SIZE -> len(b.lines) - first <= SIZE": (
        "the size of a chunk of generated code, to the line"
    ),
    "motionlang/analysis/proof/blends.py: check_blend: 1.0 -> 2.0": (
        "the size of rounding of a time that is 0"
    ),
    "motionlang/notes/chapter12.py: Settings: True -> False #2": (
        "slots of a frozen class: it takes no other attributes without them, either"
    ),
    "motionlang/notes/chapter12.py: ListingRun: True -> False #2": (
        "slots of a frozen class: it takes no other attributes without them, either"
    ),
    "motionlang/notes/dac_override.py: OverrideRun: True -> False #2": (
        "slots of a frozen class: it takes no other attributes without them, either"
    ),
    "motionlang/notes/slip.py: Slip: True -> False #2": (
        "slots of a frozen class: it takes no other attributes without them, either"
    ),
    "motionlang/notes/tn1069_servo.py: Row: True -> False #2": (
        "slots of a frozen class: it takes no other attributes without them, either"
    ),
    "motionlang/repl/commands.py: Command: True -> False #2": (
        "slots of a frozen class: it takes no other attributes without them, either"
    ),
    "motionlang/serve/limits.py: Limits: True -> False #2": (
        "slots of a frozen class: it takes no other attributes without them, either"
    ),
    "motionlang/views/chapter12.py: Picture: True -> False #2": (
        "slots of a frozen class: it takes no other attributes without them, either"
    ),
    "motionlang/editor/hover.py: _comment_above: 0 -> 1 #2": (
        "a line that begins at offset 1 is below an empty one, which is no comment"
    ),
    "motionlang/editor/fixes.py: silencing: 1 -> 2": (
        "the second column of a line is in the same line; an empty line has only one"
    ),
    "motionlang/cli/event_status.py: complaints: max(handled.get(None, -1), handled.get(axis, -1)) > index -> "
    "max(handled.get(None, -1), handled.get(axis, -1)) >= index": (
        "a fault is no handler and clears nothing, so the indices differ"
    ),
    "motionlang/cli/event_status.py: complaints: 1 -> 2": ("-1 and -2 are both less than any index"),
    "motionlang/cli/event_status.py: complaints: 1 -> 2 #2": ("-1 and -2 are both less than any index"),
    "motionlang/planners/jerk.py: plan_jerk: 0.5 -> 1.5 #3": "a ratio above one half is one half",
    "motionlang/planners/jerk.py: plan_jerk: 0.5 -> 1.5 #4": "a ratio above one half is one half",
    "motionlang/planners/jerk.py: _directly: v0 * sign -> v0 / sign": "a sign is 1 or -1",
    "motionlang/planners/jerk.py: _directly: a0 * sign -> a0 / sign": "a sign is 1 or -1",
    "motionlang/planners/jerk.py: _directly: (target - start) * sign -> (target - start) / sign": (
        "a sign is 1 or -1"
    ),
    "motionlang/planners/jerk.py: _directly: top * sign -> top / sign": "a sign is 1 or -1",
    "motionlang/planners/jerk.py: _directly: rest * sign -> rest / sign": "a sign is 1 or -1",
    "motionlang/planners/jerk.py: _back: (target - start) * sign -> (target - start) / sign": (
        "a sign is 1 or -1"
    ),
    "motionlang/planners/jerk.py: _back: (size - covered) * sign -> (size - covered) / sign": (
        "a sign is 1 or -1"
    ),
    "motionlang/planners/jerk.py: _back: after * sign -> after / sign": "a sign is 1 or -1",
    "motionlang/planners/jerk.py: _back: -beyond * sign -> -beyond / sign": "a sign is 1 or -1",
    "motionlang/planners/jerk.py: _back: after * sign -> after / sign #2": "a sign is 1 or -1",
    "motionlang/planners/jerk.py: ramp_to: change >= accel * rise -> change > accel * rise": (
        "a ramp that just reaches its rate is the same by both formulas"
    ),
    "motionlang/planners/jerk.py: ramp_to: 0.5 -> 1.5": "a ratio above one half is one half",
    "motionlang/planners/jerk.py: peak_speed: v >= decel * fall -> v > decel * fall": (
        "a ramp that just reaches its rate is the same by both formulas"
    ),
    "motionlang/planners/jerk.py: peak_speed: gain >= accel * rise -> gain > accel * rise": (
        "a ramp that just reaches its rate is the same by both formulas"
    ),
    "motionlang/planners/jerk.py: peak_speed: v >= decel * fall -> v > decel * fall #2": (
        "a ramp that just reaches its rate is the same by both formulas"
    ),
    "motionlang/planners/jerk.py: peak_from_rest: v >= upper -> v > upper": (
        "a ramp that just reaches its rate is the same by both formulas"
    ),
    "motionlang/planners/jerk.py: peak_from_rest: v <= lower -> v < lower": (
        "a ramp that just reaches its rate is the same by both formulas"
    ),
    "motionlang/planners/jerk_limited.py: JerkLimited: __init__: head[0] * head[3] -> head[0] / head[3]": (
        "a sign is 1 or -1"
    ),
    "motionlang/planners/jerk_limited.py: _ahead: value * sign -> value / sign": "a sign is 1 or -1",
    "motionlang/controller/feedback.py: Feedback: _extend: 1 -> 2": (
        "one past sample more is stored, and has no event"
    ),
    "motionlang/controller/moves/course.py: Course: positions_at_rest: distance <= segment.length * (1.0 + SLACK) -> "
    "distance < segment.length * (1.0 + SLACK)": ("just at the size of rounding either is right"),
    "motionlang/fast/command_rounds.py: CommandRounds: _begin: 0 -> 1": (
        "one jump fewer of the two thousand after which another task is compared"
    ),
    "motionlang/mint/runtime/loop_skipping.py: Site: skip: level <= now -> level < now": (
        "if a reading changes at the end of an iteration, no equal iteration follows"
    ),
    "motionlang/mint/resolve/definitions.py: _Finder: _walk: at > ends[-1][0] -> at >= ends[-1][0]": (
        "no name is the first or the last token of a block"
    ),
    "motionlang/mint/resolve/definitions.py: _Finder: _walk: at > heads[-1] -> at >= heads[-1]": (
        "no name is the first or the last token of a block"
    ),
    "motionlang/mint/resolve/definitions.py: _Finder: _walk: ends[-1][0] < heads[-1] -> ends[-1][0] <= heads[-1]": (
        "no token is the last of one block and the first of another"
    ),
    "motionlang/mint/resolve/definitions.py: _Positions: _offsets: len(self._texts) - len(self._starts) -> "
    "len(self._texts) + len(self._starts)": "the additional offsets belong to no token",
    "motionlang/mint/resolve/definitions.py: _Finder: _leading: words & {kind.lower() for kind in _LEADING} -> "
    "words | {kind.lower() for kind in _LEADING}": "the search that follows finds the same names",
    "motionlang/mint/resolve/definitions.py: _Finder: _rest_of_define: 4 -> 5": (
        "the equals sign is the token after the name"
    ),
    "motionlang/mccl/axis/motion_phase.py: is_backward: each.distance < 0.0 -> each.distance <= 0.0": (
        "only profiles with a distance are compared"
    ),
    "motionlang/mccl/axis/status.py: _auxiliary: axis.direction < 0 -> axis.direction <= 0": (
        "a direction is 1 or -1"
    ),
    "motionlang/mccl/keywords/motion.py: _must_rest: (target - rest) * velocity -> (target - rest) / velocity": (
        "a quotient has the sign of the product"
    ),
    "motionlang/mccl/keywords/registers.py: _quotient: divisor < 0 -> divisor <= 0": (
        "a divisor of 0 has been rejected before"
    ),
    "motionlang/mccl/lint/checks.py: _next: 1 -> 2 #4": "an index beyond the end means the end",
    "motionlang/mccl/keywords/motion_auxiliary.py: _passed: mark > start -> mark >= start": (
        "the mark at which the search begins is not among those searched for"
    ),
    "motionlang/mccl/keywords/motion_auxiliary.py: _passed: here >= mark - _ON -> here > mark - _ON": (
        "just at the size of rounding either is right"
    ),
    "motionlang/mccl/keywords/motion_auxiliary.py: _passed: here <= mark + _ON -> here < mark + _ON": (
        "just at the size of rounding either is right"
    ),
    "motionlang/controller/motion/follow.py: Gear: _chased: 0.0 -> 1.0": (
        "only the velocity of the scaled profile is read"
    ),
    "motionlang/controller/triggers/homing.py: Homing: endless_motion: "
    "(watched_position(a, watch) - here) * velocity -> (watched_position(a, watch) - here) / velocity": (
        "only the sign counts, and the velocity is not 0"
    ),
    "motionlang/mint/hosts/hcp.py: Receiver: _read: 5 -> 6": "the frame has five bytes",
    "motionlang/mint/keywords/captures.py: Capture: __init__: 0.001 -> 1.001": (
        "a recording sets the period before it is read"
    ),
    "motionlang/analysis/proof/paths.py: check_path: i > 0 -> i >= 0": (
        "the first profile of an axis is its rest at power-up, and no path"
    ),
    "motionlang/mccl/resolve/decode.py: 20000 -> 20001": "the memo holds one more text",
    "motionlang/mccl/runtime/loop_log.py: 1 -> 2": "another number that no command of a line has",
    "motionlang/servo/discrete.py: Regime: True -> False": "nothing assigns to a regime or hashes one",
    "motionlang/servo/discrete.py: Regime: True -> False #2": "a regime has a dictionary, too",
    "motionlang/controller/feedback.py: Feedback: _is_armed: self.error_limit < INFINITY -> self.error_limit <= "
    "INFINITY": "no error is above an infinite limit",
    "motionlang/controller/motion/sampled_velocity.py: Track: _tick: velocity + following -> velocity - following": (
        "the end is finite only if the velocity that follows is 0"
    ),
    "motionlang/mccl/runtime/poll.py: Poll: __init__: 0.0 -> 1.0": (
        "the base of the last iteration is read only if the positions agree, which the first one never does"
    ),
    "motionlang/planners/segment_speed.py: exit_speed: length * (1.0 + _SLACK) -> length / (1.0 + _SLACK)": (
        "just at the size of rounding either is right"
    ),
    "motionlang/notes/slip.py: Slip: True -> False": "nothing assigns to one or hashes one",
    "motionlang/notes/dac_override.py: OverrideRun: True -> False": "nothing assigns to one or hashes one",
    "motionlang/notes/chapter12.py: Settings: True -> False": "nothing assigns to one or hashes one",
    "motionlang/notes/chapter12.py: ListingRun: True -> False": "nothing assigns to one or hashes one",
    "motionlang/notes/tn1069_servo.py: Row: True -> False": "nothing assigns to one or hashes one",
    "motionlang/notes/slip.py: _joined: begin <= made[-1][1] + 1e-12 -> begin < made[-1][1] + 1e-12": (
        "just at the size of rounding either is right"
    ),
    "motionlang/notes/tn1069.py: 1e+100 -> 1e+100": "the same number",
    "motionlang/notes/tn1069.py: nominal: 8.0 -> 9.0": "the long move reaches its velocity in either",
    "motionlang/notes/tn1069_servo.py: accel_for: duration(high) > time -> duration(high) >= time": (
        "another bracket of the same acceleration"
    ),
    "motionlang/notes/tn1069_servo.py: accel_for: 2.0 -> 3.0": "another bracket of the same acceleration",
    "motionlang/notes/tn1069_servo.py: accel_for: duration(middle) > time -> duration(middle) >= time": (
        "just at the size of rounding either is right"
    ),
    "motionlang/editor/hover.py: definition_page: 0 -> 1": "a name begins and ends in the same line",
    "motionlang/editor/hover.py: _comment_above: 0 -> 1": "a name begins and ends in the same line",
    "motionlang/editor/times.py: _seconds: value < 100 -> value <= 100": (
        "three digits of 100 to 101 are those of a whole number"
    ),
    "motionlang/editor/times.py: _seconds: 100 -> 101": (
        "three digits of 100 to 101 are those of a whole number"
    ),
    "motionlang/editor/navigation.py: folds: 0 -> 1 #4": (
        "a comment begins at line 1, or a fold of line 1 to line 0 is left out"
    ),
    "motionlang/errors.py: Spellings: nearest: 2.0 -> 3.0": (
        "a looser bound leaves more words to difflib, which decides"
    ),
    "motionlang/errors.py: Spellings: nearest: size - (letters & ~others).bit_count() -> size + (letters "
    "& ~others).bit_count()": ("a looser bound leaves more words to difflib, which decides"),
    "motionlang/errors.py: Spellings: nearest: length - (others & ~letters).bit_count() -> length + "
    "(others & ~letters).bit_count()": ("a looser bound leaves more words to difflib, which decides"),
    "motionlang/errors.py: _letters: 1 -> 2": "the bits are shifted alike for all words",
    "motionlang/errors.py: _letters: 63 -> 64": "a looser bound leaves more words to difflib, which decides",
    "motionlang/repl/history.py: _is_writable: 0 -> 1": "a system without O_NOFOLLOW",
    "motionlang/repl/history.py: _is_writable: 384 -> 385": "fchmod sets the permissions of the new file",
    "motionlang/repl/prompt.py: converse: 0 -> 1": "the bar is drawn again with the same text",
    "motionlang/files.py: Lock: release: 1 -> 2": "any negative number shows that the lock is released",
    "motionlang/files.py: _hold: 1 -> 2": "Windows locks another byte of a file without content",
    "motionlang/assumptions/answers.py: _answers_of_mccl: 0 -> 1": (
        "the line is set along with the name of a question"
    ),
    "motionlang/assumptions/answers.py: _are_equal: abs(float(wanted) - float(given)) <= 0.5000001 * "
    "10.0 ** (-decimals) + 1e-06 * abs(float(wanted)) * ('e' in given) -> abs(float(wanted) - "
    "float(given)) < 0.5000001 * 10.0 ** (-decimals) + 1e-06 * abs(float(wanted)) * ('e' in given)": (
        "just at the size of rounding either is right"
    ),
    "motionlang/execution.py: run: compiled.size > size -> compiled.size >= size": (
        "the same program is cached again"
    ),
    "motionlang/execution.py: _entry: '' if machine.accelerators.ranges is None else 'fast' -> 'fast' if "
    "machine.accelerators.ranges is None else ''": ("each kind of program still has a name of its own"),
    "motionlang/execution.py: _thresholds: hasattr(gc, 'get_threshold') and hasattr(gc, 'set_threshold') "
    "-> hasattr(gc, 'get_threshold') or hasattr(gc, 'set_threshold')": (
        "an interpreter has both functions or none"
    ),
    "motionlang/log/stream.py: 16000000 -> 16000001": ("one byte more of sixteen million is in memory"),
    "motionlang/log/stream.py: 8000000000 -> 8000000001": ("one byte more of eight billion"),
    "motionlang/log/stream.py: 24576 -> 24577": ("when records are packed; they read the same"),
    "motionlang/log/stream.py: 8192 -> 8193": ("when records are packed; they read the same"),
    "motionlang/log/stream.py: 2048 -> 2049": ("when records are packed; they read the same"),
    "motionlang/log/stream.py: Chunks: __init__: 1 -> 2": ("another number that no record has"),
    "motionlang/log/stream.py: Chunks: reread: 1 -> 2": ("another number that no record has"),
    "motionlang/log/repeated.py: 1024 -> 1025": ("how many records are made at once"),
    "motionlang/log/repeated.py: RepeatedRecords: _records: 1 -> 2 #2": (
        "the general expression gives the same times"
    ),
    "motionlang/log/repeated.py: rows_of: 1 -> 2": (
        "a record with a tuple before its last field has another one there"
    ),
    "motionlang/log/paths.py: _tangent: 20 -> 21": (
        "after twenty doublings a path that has moved has a direction"
    ),
    "motionlang/log/paths.py: _tangent: 2.0 -> 3.0": ("how fast the distance grows that has a direction"),
    "motionlang/log/paths.py: _tangent: 2.0 -> 3.0 #2": ("how fast the distance grows that has a direction"),
    "motionlang/log/paths.py: _tangent: 1.0 -> 2.0": (
        "a smallest distance that has a direction, within its rounding"
    ),
    "motionlang/log/paths.py: _tangent: 0 -> 1 #3": (
        "a smallest distance that has a direction, within its rounding"
    ),
    "motionlang/log/paths.py: _tangent: size > 1e-07 * max(1.0, float(np.abs(trace.at(path.axes[0], 'position', "
    "times)).max())) -> size >= 1e-07 * max(1.0, float(np.abs(trace.at(path.axes[0], 'position', times)).max()))": (
        "a smallest distance that has a direction, within its rounding"
    ),
    "motionlang/log/paths.py: _row: speed <= still -> speed < still": ("a speed of 0 is 0 either way"),
    "motionlang/log/paths.py: _length: 1 -> 2 #5": ("the last sample but one has an odd index"),
    "motionlang/log/extremes.py: 48 -> 49": ("the best of the samples is refined"),
    "motionlang/log/extremes.py: _searched: 1 -> 2 #3": ("a wider interval around the same extreme"),
    "motionlang/log/extremes.py: _searched: 1 -> 2 #4": ("a wider interval around the same extreme"),
    "motionlang/log/extremes.py: _differ: abs(right - left) > rounding + _MOMENT * max(abs(slope), "
    "abs(slope_after)) -> abs(right - left) >= rounding + _MOMENT * max(abs(slope), abs(slope_after))": (
        "just at the size of rounding either is right"
    ),
    "motionlang/log/extremes.py: peak_speed: profile.duration <= length + 4e-16 * (begin + length) -> "
    "profile.duration < length + 4e-16 * (begin + length)": (
        "a profile that is cut at its end has the same peak"
    ),
    "motionlang/log/extremes.py: peak_speed: length + 4e-16 * (begin + length) -> length - 4e-16 * (begin + length)": (
        "a profile that is cut at its end has the same peak"
    ),
    "motionlang/log/extremes.py: peak_speed: begin + length -> begin - length": (
        "a profile that is cut at its end has the same peak"
    ),
    "motionlang/log/log.py: 512 -> 513": ("when profiles are packed; they read the same"),
    "motionlang/log/log.py: 40960 -> 40961": ("when profiles are packed; they read the same"),
    "motionlang/log/log.py: 10240 -> 10241": ("when profiles are packed; they read the same"),
    "motionlang/log/move_rows.py: 2 -> 3": ("a recipe has two numbers, or four and more"),
    "motionlang/log/move_rows.py: _profile_index: k >= 0 and a.starts[k] == move.start_time -> k >= 0 or "
    "a.starts[k] == move.start_time": ("the same profile at another time reads the same"),
    "motionlang/log/moves.py: 16000 -> 16001": ("when moves are packed; they read the same"),
    "motionlang/log/moves.py: Moves: __init__: 0 -> 1": ("when moves are packed; they read the same"),
    "motionlang/log/moves.py: Moves: _tail_index: 1 -> 2 #2": ("the newest record is compared once more"),
    "motionlang/log/moves.py: Moves: _tail_index: 1 -> 2 #4": ("another number below 0"),
    "motionlang/log/order.py: PathOrder: 0.0 -> 1.0": ("every path is given this field"),
    "motionlang/log/order.py: PathOrder: -1 -> 1": ("every path is given this field"),
    "motionlang/log/order.py: PathOrder: 1 -> 2": ("every path is given this field"),
    "motionlang/log/order.py: Tie: 0.0 -> 1.0": ("every tie is given this field"),
    "motionlang/log/order.py: Tie: 0.0 -> 1.0 #2": ("a tie without a curve has no origin"),
    "motionlang/log/order.py: Tie: 1 -> 2": ("a tie without a curve has no direction"),
    "motionlang/log/time_slices.py: TimeSliceStream: __init__: 0.0 -> 1.0": (
        "the first slice sets it before it is read"
    ),
    "motionlang/log/trace.py: 65536 -> 65537": ("how many rows a chunk has"),
    "motionlang/log/trace.py: 200000000 -> 200000001": ("one row more of two hundred million"),
    "motionlang/log/trace.py: 4096 -> 4097": ("how much packed motion is read at once"),
    "motionlang/log/trace.py: 0.001 -> 1.001": ("how much packed motion is read at once"),
    "motionlang/log/trace.py: Column: True -> False": ("nothing assigns to a column or hashes one"),
    "motionlang/log/trace.py: Column: True -> False #2": (
        "slots of a frozen class: it takes no other attributes without them, either"
    ),
    "motionlang/log/trace.py: Samples: True -> False": ("nothing assigns to samples or hashes them"),
    "motionlang/log/trace.py: Samples: True -> False #2": (
        "slots of a frozen class: it takes no other attributes without them, either"
    ),
    "motionlang/log/trace.py: Trace: chunks: 1 -> 2": ("one row more than used"),
    "motionlang/log/trace.py: Trace: chunks: 1.0 -> 2.0 #2": (
        "how much packed motion is read for the last row"
    ),
    "motionlang/log/trace.py: Commanded: _fill: 1 -> 2 #2": ("one point more than used"),
    "motionlang/log/trajectory_points.py: Points: __init__: 0.0 -> 1.0": (
        "the first profile is at rest, and sets it"
    ),
    "motionlang/fast/command_rounds.py: 2000 -> 2001": ("one state more of two thousand"),
    "motionlang/fast/polled_ticks.py: PolledTicks: reached: len(self._known) > MAX_STATES -> "
    "len(self._known) >= MAX_STATES": ("one state fewer of a thousand"),
    "motionlang/fast/moves.py: FastAxis: loader: load: 1e+300 -> 1e+300": (
        "the same number, since 1 is below its last bit"
    ),
    "motionlang/fast/moves.py: FastAxis: loader: load: 1e+300 -> 1e+300 #2": (
        "the same number, since 1 is below its last bit"
    ),
    "motionlang/fast/moves.py: FastAxis: loader: load: 1e+300 -> 1e+300 #3": (
        "the same number, since 1 is below its last bit"
    ),
    "motionlang/fast/moves.py: FastAxis: loader: load: 1e+300 -> 1e+300 #4": (
        "the same number, since 1 is below its last bit"
    ),
    "motionlang/fast/moves.py: FastAxis: start_at_once: 1e+300 -> 1e+300": (
        "the same number, since 1 is below its last bit"
    ),
    "motionlang/fast/moves.py: FastAxis: start_at_once: 1e+300 -> 1e+300 #2": (
        "the same number, since 1 is below its last bit"
    ),
    "motionlang/fast/time_slices.py: TimeSlices: idle_round: 1023 -> 1024": (
        "when waits are packed; they read the same"
    ),
    "motionlang/fast/time_slices.py: TimeSlices: passes_among_others: 1023 -> 1024": (
        "when waits are packed; they read the same"
    ),
    "motionlang/client/virtual.py: VirtualWire: receive: timeout <= 0.0 -> timeout < 0.0": (
        "to run up to the present changes nothing"
    ),
    "motionlang/client/virtual.py: VirtualWire: receive: self.console.now < end -> self.console.now <= end": (
        "to run up to the present changes nothing"
    ),
    "motionlang/client/virtual.py: MintWire: True -> False": (
        "a Mint client does not ask if its line is fresh"
    ),
    "motionlang/client/virtual.py: MintWire: send: self._busy_until > self.console.now -> self._busy_until >= "
    "self.console.now": ("to run up to the present changes nothing"),
    "motionlang/client/virtual.py: MintWire: receive: timeout > 0.0 -> timeout >= 0.0": (
        "to run up to the present changes nothing"
    ),
    "motionlang/client/virtual.py: MintWire: receive: console.now < self._busy_until -> console.now <= "
    "self._busy_until": ("to run up to the present changes nothing"),
    "motionlang/client/wire.py: 65536 -> 65537": "how much is read at once",
    "motionlang/copley/modes.py: ProfileModes: _homing: self._position <= switches.negative -> self._position "
    "< switches.negative": ("an axis at the edge of its switch has nothing to search in either direction"),
    "motionlang/copley/modes.py: ProfileModes: _homing: self._position >= switches.positive -> self._position "
    "> switches.positive": ("an axis at the edge of its switch has nothing to search in either direction"),
    "motionlang/copley/modes.py: ProfileModes: _homing: self._position < switches.home -> self._position <= "
    "switches.home": ("an axis at the edge of its switch has nothing to search in either direction"),
    "motionlang/copley/modes.py: ProfileModes: _search: (reach - self._position) * velocity -> (reach - "
    "self._position) / velocity": ("only the sign counts, and the velocity is not 0"),
    "motionlang/copley/modes.py: ProfileModes: control: before & ~now -> before | ~now": (
        "without bit 4 nothing is in progress that its fall could end"
    ),
    "motionlang/copley/modes.py: ProfileModes: status: abs(self._drive.velocity - wanted) <= 1e-06 * max(1.0, "
    "abs(wanted)) -> abs(self._drive.velocity - wanted) < 1e-06 * max(1.0, abs(wanted))": (
        "just at the size of rounding either is right"
    ),
    "motionlang/copley/modes.py: ProfileModes: status: 1.0 -> 2.0": (
        "just at the size of rounding either is right"
    ),
    "motionlang/copley/modes.py: ProfileModes: status: abs(self._drive.velocity) < 1e-06 -> "
    "abs(self._drive.velocity) <= 1e-06": ("just at the size of rounding either is right"),
    "motionlang/copley/modes.py: crossing: (position - profile.position(ramps)) * profile.end_velocity -> "
    "(position - profile.position(ramps)) / profile.end_velocity": (
        "only the sign counts, and an endless profile has a velocity at its end"
    ),
    "motionlang/copley/modes.py: crossing: 80 -> 81": "the interval is already as short as the rounding",
    "motionlang/copley/modes.py: crossing: profile.position(middle) > position -> profile.position(middle) >= "
    "position": ("just at the size of rounding either is right"),
    "motionlang/copley/drive.py: Drive: __init__: 0.0 -> 1.0 #3": (
        "a move sets its velocity before its first segment"
    ),
    "motionlang/copley/drive.py: Drive: __init__: 0 -> 1 #2": (
        "a move replaces the entry before its first segment"
    ),
    "motionlang/copley/drive.py: Drive: __init__: 0 -> 1 #3": (
        "a move replaces the entry before its first segment"
    ),
    "motionlang/copley/objects.py: ObjectServer: _segment: 0 -> 1": (
        "an initial position takes no time, whatever its entry has"
    ),
    "motionlang/copley/objects.py: ObjectServer: _control: 0 -> 1 #5": (
        "no mode reads bit 0 of the control word"
    ),
    "motionlang/copley/objects.py: _wrapped: value + 2 ** 31 -> value - 2 ** 31": (
        "both are the same in 32 bits"
    ),
    "motionlang/copley/eds.py: eds: 125000 -> 125001": "the file has whole kbit/s",
    "motionlang/copley/eds.py: eds: 250000 -> 250001": "the file has whole kbit/s",
    "motionlang/copley/eds.py: eds: 500000 -> 500001": "the file has whole kbit/s",
    "motionlang/copley/eds.py: eds: 1000000 -> 1000001": "the file has whole kbit/s",
    "motionlang/copley/master.py: Master: _stream_packets: False -> True #2": (
        "it is set before the end of a list of points is reached"
    ),
    "motionlang/copley/master.py: Master: _received: 1 -> 2": "only a change of the number is noticed",
    "motionlang/copley/export.py: sdo_download: i // 7 -> i * 7": "both are even or both are odd",
    "motionlang/copley/packet.py: decode: 8 -> 9 #2": "there are eight bytes",
    "motionlang/copley/pdo.py: 64 -> 65": "every object has whole bytes",
    "motionlang/copley/point.py: _rounded: 1000.0 -> 1001.0": "up to 255 ms the difference is rounded away",
    "motionlang/copley/point.py: _time_trouble: time > 0.0 -> time >= 0.0": (
        "the time is infinite or negative"
    ),
    "motionlang/copley/point.py: _time_trouble: 0.0 -> 1.0 #2": "the time is infinite or negative",
    "motionlang/copley/point.py: _time_trouble: abs(exact - wire) > 1e-06 -> abs(exact - wire) >= 1e-06": (
        "just at the size of rounding either is right"
    ),
    "motionlang/copley/node.py: DriveNode: __init__: 0 -> 1 #3": (
        "no state but operational is compared with it"
    ),
    "motionlang/copley/node.py: DriveNode: _configure: 5632 -> 5633 #2": (
        "there is no object behind the four mappings"
    ),
    "motionlang/copley/node.py: DriveNode: _configure: 6656 -> 6657 #2": (
        "there is no object behind the four mappings"
    ),
    "motionlang/copley/node.py: DriveNode: _configure: 6144 -> 6145 #2": (
        "there is no object behind the four records"
    ),
    "motionlang/copley/node.py: DriveNode: _configure: 7168 -> 7169": (
        "there is no object behind the mappings"
    ),
    "motionlang/copley/node.py: DriveNode: _check_mapping: index < 6144 -> index <= 6144": (
        "a mapping is below 0x1604, or from 0x1A00 on"
    ),
    "motionlang/copley/node.py: DriveNode: _check_mapping: 6144 -> 6145": (
        "a mapping is below 0x1604, or from 0x1A00 on"
    ),
    "motionlang/copley/served.py: DriveServer: run_once: wall >= self._updated + CYCLE -> wall > "
    "self._updated + CYCLE": ("real time is never exactly a cycle later"),
    "motionlang/serve/modbus.py: ModbusServer: stop: self._loop is not None and self._over is not None and "
    "(self._thread is not None) -> self._loop is not None or self._over is not None or self._thread is not "
    "None": ("a server that has started has all three"),
    "motionlang/copley/buffer.py: Entry: True -> False": "nothing assigns to one, or hashes one",
    "motionlang/copley/buffer.py: Entry: True -> False #2": "slots: the attributes are the same without",
    "motionlang/copley/export.py: Export: True -> False": "nothing assigns to one, or hashes one",
    "motionlang/copley/export.py: Export: True -> False #2": "slots: the attributes are the same without",
    "motionlang/copley/master.py: Streamed: True -> False": "slots: the attributes are the same without",
    "motionlang/copley/objects.py: Object: True -> False": "nothing assigns to one, or hashes one",
    "motionlang/copley/objects.py: Object: True -> False #2": "slots: the attributes are the same without",
    "motionlang/copley/packet.py: Packet: True -> False": "nothing assigns to one, or hashes one",
    "motionlang/copley/packet.py: Packet: True -> False #2": "slots: the attributes are the same without",
    "motionlang/copley/packet.py: PacketCommand: True -> False": "nothing assigns to one, or hashes one",
    "motionlang/copley/packet.py: PacketCommand: True -> False #2": (
        "slots: the attributes are the same without"
    ),
    "motionlang/copley/packet.py: BufferStatus: True -> False": "nothing assigns to one, or hashes one",
    "motionlang/copley/packet.py: BufferStatus: True -> False #2": (
        "slots: the attributes are the same without"
    ),
    "motionlang/copley/pdo.py: Sent: True -> False": "slots: the attributes are the same without",
    "motionlang/copley/point.py: WirePoint: True -> False": "nothing assigns to one, or hashes one",
    "motionlang/copley/point.py: WirePoint: True -> False #2": "slots: the attributes are the same without",
    "motionlang/copley/point.py: BadPoint: True -> False #2": "nothing assigns to one, or hashes one",
    "motionlang/copley/point.py: BadPoint: True -> False #3": "slots: the attributes are the same without",
    "motionlang/copley/serial.py: BufferCommand: True -> False": "nothing assigns to one, or hashes one",
    "motionlang/copley/serial.py: BufferCommand: True -> False #2": (
        "slots: the attributes are the same without"
    ),
    "motionlang/copley/switches.py: Switches: True -> False": "nothing assigns to one, or hashes one",
    "motionlang/copley/switches.py: Switches: True -> False #2": "slots: the attributes are the same without",
    "motionlang/copley/table.py: Table: True -> False": "slots: the attributes are the same without",
    "motionlang/mcapi/client.py: Structure: __init__: 1 -> 2": "a field has one element or eight",
    "motionlang/mcapi/client.py: Structure: values: 1 -> 2": "a field has one element or eight",
    "motionlang/mcapi/client.py: Structure: fill: 1 -> 2": "a field has one element or eight",
    "motionlang/copley/bus.py: 1 -> 2": "another number in the names of channels",
    "motionlang/serve/modbus_requests.py: 6 -> 7": "the last object has the number 4",
    "motionlang/serve/modbus_requests.py: 6 -> 7 #2": "the last object has the number 4",
    "motionlang/serve/channel.py: 65536 -> 65537": "how much is read at once",
    "motionlang/serve/modbus_requests.py: 2 -> 3 #3": "there is no object 3",
    "motionlang/serve/modbus_requests.py: Request: 0 -> 1": "a request that only writes reads no registers",
    "motionlang/serve/limits.py: Limits: True -> False": "nothing assigns to one, or hashes one",
    "motionlang/mcapi/replay.py: Replay: _same_result: result > 0 -> result >= 0": (
        "MCOpen returns a handle from 1 on, or a negative code"
    ),
    "motionlang/mcapi/replay.py: Replay: _same_result: entry.result > 0 -> entry.result >= 0": (
        "MCOpen returns a handle from 1 on, or a negative code"
    ),
    "motionlang/debug/debugger.py: Debugger: go_to_time: before + 1 -> before - 1": (
        "a statement compared earlier is before the time"
    ),
    "motionlang/debug/debugger.py: Debugger: go_to_time: before + 1 -> before - 1 #2": (
        "a statement compared earlier is before the time"
    ),
    "motionlang/debug/debugger.py: Debugger: go_to_time: point.number > before + 1 -> point.number >= before + 1": (
        "the run is repeated up to the same statement"
    ),
    "motionlang/debug/debugger.py: Debugger: go_to_time: 0 -> 1": (
        "the first statement compared is number 1"
    ),
    "motionlang/debug/debugger.py: Debugger: go_to_time: give_up: now < time -> now <= time": (
        "a later statement is found, and the first one after that"
    ),
    "motionlang/debug/debugger.py: Debugger: go_to_time: decide: before + STRIDE -> before - STRIDE": (
        "all statements are compared, not one in 4096"
    ),
    "motionlang/debug/debugger.py: Debugger: _has_come: abs(each.time - moment.time) <= CLOSE "
    "-> abs(each.time - moment.time) < CLOSE": ("no two searches differ by just this rounding"),
    "motionlang/debug/debugger.py: Debugger: step_back: self._recorded_from() > 1 -> self._recorded_from() >= 1": (
        "a search finds no more than the complete record"
    ),
    "motionlang/debug/debugger.py: Debugger: step_back: 16 -> 17": (
        "how much more of the run is recorded each time"
    ),
    "motionlang/debug/debugger.py: Debugger: step_back: reach >= point.number -> reach > point.number": (
        "another search records nothing new"
    ),
    "motionlang/debug/debugger.py: Debugger: resume: begin > 1 -> begin >= 1": (
        "a search finds no more than the complete record"
    ),
    "motionlang/debug/debugger.py: Debugger: _forward: 0.0 -> 1.0 #2": (
        "before the first stop, the number is that for no mark"
    ),
    "motionlang/debug/debugger.py: Debugger: _forward: begin + STRIDE -> begin - STRIDE": (
        "all statements are compared, not one in 4096"
    ),
    "motionlang/debug/debugger.py: Debugger: _forward: decide: point.number + STRIDE -> point.number - STRIDE": (
        "all statements are compared, not one in 4096"
    ),
    "motionlang/debug/debugger.py: Debugger: _forward: nextafter(self._after, INFINITY) < self.stop.time -> "
    "nextafter(self._after, INFINITY) <= self.stop.time": (
        "a search up to where the last one ended finds nothing"
    ),
    "motionlang/debug/debugger.py: Debugger: _to_moment: lowest + 1 -> lowest - 1": (
        "an earlier statement is before the moment"
    ),
    "motionlang/debug/debugger.py: Debugger: _to_moment: lowest + 1 -> lowest - 1 #2": (
        "an earlier statement is before the moment"
    ),
    "motionlang/debug/debugger.py: Debugger: _to_moment: here.number > lowest + 1 -> here.number >= lowest + 1": (
        "the run is repeated up to the same statement"
    ),
    "motionlang/debug/debugger.py: Debugger: _to_moment: time < moment.time -> time <= moment.time": (
        "before a statement the log has only earlier moments, or those at 0"
    ),
    "motionlang/debug/debugger.py: Debugger: _to_moment: moment.time < INFINITY -> moment.time <= INFINITY": (
        "the run is repeated to its end once more"
    ),
    "motionlang/debug/debugger.py: Debugger: _to_moment: self._replay.point is None and (not self._replay.paused) "
    "-> self._replay.point is None or not self._replay.paused": (
        "the run is repeated up to the same statement"
    ),
    "motionlang/debug/debugger.py: Debugger: last_change: 0 -> 1": (
        "no change is found at the first statement"
    ),
    "motionlang/debug/debugger.py: 4096 -> 4097": ("how often the log is searched"),
    "motionlang/debug/replay.py: Replay: _advancing: False -> True": ("the run ends"),
    "motionlang/debug/replay.py: 0 -> 1": ("statements are numbered from 1"),
    "motionlang/debug/replay.py: 64 -> 65": ("how many statements are remembered for a step back"),
    "motionlang/debug/replay.py: 64 -> 65 #2": ("how long a pause waits for a statement"),
    "motionlang/debug/replay.py: 64 -> 65 #3": ("the stack of a thread"),
    "motionlang/debug/replay.py: 1024 -> 1025": ("the stack of a thread"),
    "motionlang/debug/replay.py: 1024 -> 1025 #2": ("the stack of a thread"),
    "motionlang/debug/replay.py: 0.05 -> 1.05": ("how often Ctrl-C is polled"),
    "motionlang/debug/patience.py: 16384 -> 16385": (
        "how long a command waits for a statement that may never begin"
    ),
    "motionlang/debug/checkpoints.py: 0.1 -> 1.1": ("how often a slow run is copied"),
    "motionlang/debug/checkpoints.py: 32 -> 33": ("how many copies there are"),
    "motionlang/debug/destinations.py: destination: 9 -> 10": ("no program has a hundred million lines"),
    "motionlang/debug/moments.py: _stops: profile.duration > 0 -> profile.duration >= 0": (
        "a profile of no duration has no velocity"
    ),
    "motionlang/debug/moments.py: _stops: 0.25 -> 1.25": (
        "a profile in motion is so at one of the other samples"
    ),
    "motionlang/debug/moments.py: _stops: 0.5 -> 1.5": (
        "a profile in motion is so at one of the other samples"
    ),
    "motionlang/debug/moments.py: _stops: 0.75 -> 1.75": (
        "a profile in motion is so at one of the other samples"
    ),
    "motionlang/debug/moments.py: _stops: abs(track.at(end + RESOLUTION).velocity) < RESOLUTION "
    "-> abs(track.at(end + RESOLUTION).velocity) <= RESOLUTION": (
        "just at the size of rounding either is right"
    ),
    "motionlang/debug/moments.py: _becomes_true: high - low > RESOLUTION -> high - low >= RESOLUTION": (
        "just at the size of rounding either is right"
    ),
    "motionlang/debug/moments.py: _becomes_true: high - low -> high + low": (
        "the bisection ends with the last bit instead, within rounding"
    ),
    "motionlang/debug/moments.py: _samples: 1 -> 2": (
        "the sample after the end of a profile is one of the next"
    ),
    "motionlang/debug/moments.py: _samples: start + length > after -> start + length >= after": (
        "samples up to the last search are dropped later"
    ),
    "motionlang/dap/adapter.py: Adapter: __init__: False -> True #2": ("`initialize` sets it"),
    "motionlang/dap/adapter.py: 5.0 -> 6.0": ("how long the end waits for a program that does not stop"),
    "motionlang/dap/relay.py: Relay: _maintain_copies: 1 -> 2": ("the engine sends one channel at a time"),
    "motionlang/dap/relay.py: 4096 -> 4097": ("packets are much shorter"),
    "motionlang/dap/showing.py: Showing: _end: 0 -> 1": ("the depth of a frame without a task is not used"),
    "motionlang/dap/showing.py: Showing: _local: depth < len(frames) -> depth <= len(frames)": (
        "the frames at a stop stay the same"
    ),
    "motionlang/dap/showing.py: Showing: _referred: fresh is not None and isinstance(fresh.value, list) "
    "-> fresh is not None or isinstance(fresh.value, list)": ("an array at a stop stays one"),
    "motionlang/dap/showing.py: 1000000 -> 1000001": ("more references than a client can show"),
    "motionlang/debug/moments.py: 0.7320508 -> 1.7320508000000001": (
        "no program subtracts either from a reading to divide by the difference"
    ),
    "motionlang/mint/runtime/waits.py: Rests: __init__: environment.statements.cost * UNITS"
    " -> environment.statements.cost / UNITS": (
        "a wait whose length is computed at run time has the same result"
    ),
    "motionlang/mint/runtime/waits.py: Rests: __init__: -1.0 -> 1.0": ("it is compared by identity"),
    "motionlang/mint/runtime/waits.py: Rests: _computed: rest: not self._left -> self._left": (
        "when the log of waits is packed"
    ),
    "motionlang/mint/runtime/waits.py: Rests: _computed: rest: 1.0 -> 2.0": (
        "other events are checked for one statement earlier"
    ),
    "motionlang/mint/runtime/waits.py: Waits: pause: pause: ignores_data or bool(axes)"
    " -> ignores_data and bool(axes)": ("the wait is checked more often, after changes that cannot end it"),
    "motionlang/mint/keywords/captures.py: Capture: _report_progress: step: 100 -> 101": (
        "no event follows that of 99 percent in either way"
    ),
    "motionlang/mint/keywords/captures.py: Capture: __init__: 0.0 -> 1.0": (
        "set when a capture starts, before it is read"
    ),
    "motionlang/mint/keywords/captures.py: Capture: __init__: 0.0 -> 1.0 #2": (
        "set when a capture starts, before it is read"
    ),
    "motionlang/mint/keywords/captures.py: Capture: __init__: 1 -> 2": (
        "no program can address one channel more"
    ),
    "motionlang/mint/keywords/camboxes.py: CamBox: __init__: 0.0 -> 1.0": (
        "set by CAMBOXDATA, without which a box cannot be enabled"
    ),
    "motionlang/mint/runtime/environment.py: Environment: random: 1 -> 2": (
        "only a change of the count matters"
    ),
    "motionlang/mint/runtime/environment.py: Environment: __init__: 0 -> 1 #3": (
        "only a change of the count matters"
    ),
    "motionlang/mint/keywords/network.py: read_event: 1 -> 2": ("only a change of the count matters"),
    "motionlang/mint/keywords/identity.py: Calendar: text: self.clock.now - self.since + 1e-09 -> "
    "self.clock.now - self.since - 1e-09": ("just at the size of rounding either is right"),
    "motionlang/mint/keywords/table_motion_splines.py: _seam: len(times) > 1 -> len(times) >= 1": (
        "the slope of one segment is the same by both formulas"
    ),
    "motionlang/mint/hosts/port.py: MintPort: _add: len(self._out) > most -> len(self._out) >= most": (
        "at the limit itself nothing is deleted"
    ),
    "motionlang/mint/hosts/port.py: MintPort: next_entry: 0 -> 1 #2": ("a frame has more than one character"),
    "motionlang/mint/hosts/console.py: MintConsole: _forget: 1 -> 2": ("how often history is trimmed"),
    "motionlang/mint/hosts/console.py: MintConsole: _forget: 0 -> 1": ("how often history is trimmed"),
    "motionlang/mint/hosts/console.py: MintConsole: __init__: 0 -> 1": ("how often history is trimmed"),
    "motionlang/mint/hosts/hcp.py: Receiver: take: code < 128 -> code <= 128": ("character 128 is no digit"),
    "motionlang/mint/hosts/hcp.py: Receiver: take: 128 -> 129": ("character 128 is no digit"),
    "motionlang/mint/hosts/hcp.py: Receiver: take: 5 -> 6 #2": (
        "a text that is too long is rejected at either length"
    ),
    "motionlang/mint/hosts/hcp.py: Receiver: take: len(frame) > 3 -> len(frame) >= 3": (
        "the third character of a frame is STX"
    ),
    "motionlang/mint/keywords/captures.py: Capture: __init__: 1 -> 2 #2": (
        "no program can address one trigger more"
    ),
    "motionlang/mint/keywords/captures.py: Capture: _report_progress: step: 100 -> 101 #2": (
        "one event more at the last point, where the capture ends"
    ),
    "motionlang/planners/root.py: bracketed_root: value < 0.0 -> value <= 0.0": (
        "a value of 0 has been returned before"
    ),
    "motionlang/planners/packed.py: packed: 2 -> 3": ("a recipe has two numbers, or four and more"),
    "motionlang/planners/curve.py: Profile: scaled: -1 -> 1": ("these recipes have two numbers"),
    "motionlang/planners/direction.py: _spans: 2.0 -> 3.0": (
        "only the sign of the velocity beyond an extremum counts"
    ),
    "motionlang/planners/feasibility.py: approach: v0 > 0.0 -> v0 >= 0.0": (
        "no distance at no speed has no direction"
    ),
    "motionlang/planners/crossing.py: 1e-09 -> 1.000000001": ("a larger margin only searches more pieces"),
    "motionlang/planners/jerk_limited.py: _ahead: left > 0.0 -> left >= 0.0": (
        "nothing left is a slew of no time"
    ),
    "motionlang/planners/sample.py: _multiply: SLICE // basis.shape[1] -> SLICE * basis.shape[1]": (
        "the size of the slices only keeps the BLAS from starting threads"
    ),
    "motionlang/planners/segment_speed.py: _farthest: 0.25 * _NEAR * x -> 0.25 * _NEAR / x": (
        "how soon the secants come near; bisection finds the last bit"
    ),
    "motionlang/planners/segment_speed.py: _farthest: stays < 0.0 -> stays <= 0.0": (
        "how soon the secants come near; bisection finds the last bit"
    ),
    "motionlang/controller/moves/buffer.py: Dwell: __init__: 1e+300 -> 1e+300": (
        "one more is the same number"
    ),
    "motionlang/controller/moves/buffer.py: Pulse: __init__: 1e+300 -> 1e+300": (
        "one more is the same number"
    ),
    "motionlang/controller/moves/buffer.py: known_end: 1e+300 -> 1e+300": ("one more is the same number"),
    "motionlang/controller/moves/path.py: load_arc: 1e+300 -> 1e+300": ("one more is the same number"),
    "motionlang/controller/moves/path.py: _starts: 1e+300 -> 1e+300": ("one more is the same number"),
    "motionlang/controller/moves/path.py: _put: 1e+300 -> 1e+300": ("one more is the same number"),
    "motionlang/controller/moves/cam.py: CurveFollow: _at: along < 0.0 -> along <= 0.0": (
        "at its beginning a curve is at its start either way"
    ),
    "motionlang/controller/moves/cam.py: Fly: follow: self.over > 0.0 -> self.over >= 0.0": (
        "a segment is one count of its master or more, in either direction"
    ),
    "motionlang/controller/moves/course.py: Course: planned: 0.0 -> 1.0": (
        "a path of no length has one position, whatever the distance along it"
    ),
    "motionlang/controller/motion/takeup.py: Takeup: rate: left > 0.0 -> left >= 0.0": (
        "nothing left has been returned before"
    ),
    "motionlang/controller/io/wiring.py: World: _wire_limit: sign > 0 -> sign >= 0": ("a sign is 1 or -1"),
    "motionlang/controller/io/wiring.py: World: _wire_fault: 0 -> 1 #2": (
        "an error of the controller has no bit"
    ),
    "motionlang/controller/joined.py: Joined: _range: len(packed) > _MAX_UNPACKED -> len(packed) >= _MAX_UNPACKED": (
        "how many unpacked profiles are stored for further readers"
    ),
    "motionlang/controller/watches.py: Watches: append: 1 -> 2": ("only the order of the numbers counts"),
    "motionlang/controller/feedback.py: Feedback: _extend: 1 -> 2 #2": ("one past sample more is stored"),
    "motionlang/controller/readers.py: _piece: now - begun -> now + begun": (
        "a piece is used only within its own time; before, the velocity is computed"
    ),
    "motionlang/analysis/cycle/slacks.py: _by_width: cuts.step > 1 -> cuts.step >= 1": (
        "a motion that began alone has no slack"
    ),
    "motionlang/analysis/cycle/slacks.py: _columns: 1 -> 2 #2": (
        "values at uneven distances are collected one by one, with the same result"
    ),
    "motionlang/analysis/cycle/slacks.py: _columns: firsts[1] - begin -> firsts[1] + begin": (
        "values at uneven distances are collected one by one, with the same result"
    ),
    "motionlang/analysis/cycle/slacks.py: _columns: end + 1 -> end - 1": (
        "values at uneven distances are collected one by one, with the same result"
    ),
    "motionlang/analysis/cycle/slacks.py: _columns: 1 -> 2 #4": (
        "a group has two moves or more, so the next index begins none"
    ),
    "motionlang/analysis/cycle/slacks.py: _columns: firsts == each or (len(firsts) == len(each) and firsts == "
    "list(each)) -> firsts == each and (len(firsts) == len(each) and firsts == list(each))": (
        "values at uneven distances are collected one by one, with the same result"
    ),
    "motionlang/analysis/cycle/slacks.py: _columns: len(firsts) == len(each) -> len(firsts) != len(each)": (
        "values at uneven distances are collected one by one, with the same result"
    ),
    "motionlang/analysis/cycle/slacks.py: _columns: end + k -> end - k": (
        "columns of unequal lengths are replaced by groups of single moves, with the same result"
    ),
    "motionlang/analysis/cycle/slacks.py: _columns: 1 -> 2 #5": (
        "a group has two moves or more, so the next index is not taken"
    ),
    "motionlang/analysis/proof/axes.py: check_profile: 1e+300 -> 1e+300": (
        "the same number in floating point"
    ),
    "motionlang/analysis/proof/path_layout.py: PathLayout: _angles: 2.0 -> 3.0": (
        "a second revolution has the directions of the first"
    ),
    "motionlang/analysis/proof/slowing.py: slowing: by.smooth and a0 -> by.smooth or a0": (
        "without an acceleration or a jerk nothing is added but the allowance for rounding"
    ),
    "motionlang/analysis/proof/prove.py: _excuse: abs(jump - paths_jump) > SLACK * max(1.0, abs(jump)) -> "
    "abs(jump - paths_jump) >= SLACK * max(1.0, abs(jump))": ("just at the size of rounding either is right"),
    "motionlang/analysis/proof/outputs.py: check_trace: min((abs(counts - counts_then) for counts_then in "
    "expected)) > slack -> min((abs(counts - counts_then) for counts_then in expected)) >= slack": (
        "just at the size of rounding either is right"
    ),
    "motionlang/analysis/proof/followers.py: check_points: abs(reached - points[n]) > SLACK * size -> "
    "abs(reached - points[n]) >= SLACK * size": ("just at the size of rounding either is right"),
    "motionlang/analysis/sweeps/job.py: worker_of: len(_WORKERS) >= MAX_WORKERS -> len(_WORKERS) > MAX_WORKERS": (
        "how many workers a process caches"
    ),
    "motionlang/mccl/runtime/task.py: BackgroundTask: end: True -> False": (
        "the line of the task has been abandoned, so it ends at its next time slice"
    ),
    "motionlang/mccl/motion/path.py: Path: _pace: 0.0 -> 1.0 #2": (
        "no command sets a ramp ratio of 0: PS0 selects another shape"
    ),
    "motionlang/mccl/hosts/port.py: PortTask: __init__: False -> True #4": (
        "each line sets it before it is read"
    ),
    "motionlang/mint/compile/intervals.py: remainder: 0 -> 1 #3": (
        "a dividend of 0 has the remainder 0 either way"
    ),
    "motionlang/mint/compile/loops.py: is_long: 0 -> 1": (
        "from how many ElseIfs on they are written as a loop, with the same result"
    ),
    "motionlang/mint/compile/loops.py: is_long: 1 -> 2 #2": (
        "from how many ElseIfs on they are written as a loop, with the same result"
    ),
    "motionlang/mint/compile/loops.py: is_long: count > MANY_CASES -> count >= MANY_CASES": (
        "from how many ElseIfs on they are written as a loop, with the same result"
    ),
    "motionlang/mint/compile/loop_times.py: Region: __init__: -1 -> 1": (
        "both are set by the jump that makes the region"
    ),
    "motionlang/mint/compile/loop_times.py: Region: __init__: 1 -> 2": (
        "both are set by the jump that makes the region"
    ),
    "motionlang/mint/compile/operators.py: arithmetic: "
    "left.range[2] == 'f' or right.range[2] == 'f' -> left.range[2] == 'f' and right.range[2] == 'f'": (
        "a short way to what follows for one float as well"
    ),
    "motionlang/mint/compile/statements.py: _assign_variable: "
    "type(target) is nodes.Name -> type(target) is not nodes.Name": (
        "whether the text of a target is cached"
    ),
    "motionlang/mint/compile/statements.py: _assign_variable: "
    "type(target) is nodes.Name and target.args is None -> "
    "type(target) is nodes.Name or target.args is None": ("a single variable is a name without an index"),
    "motionlang/mint/compile/expressions.py: _number: 0 -> 1": (
        "`literal` gives 0.0 and small fractions the same text"
    ),
    "motionlang/mint/compile/expressions.py: _number: 0 -> 1 #2": ("`literal` gives 0 the same text"),
    "motionlang/mint/compile/expressions.py: _number: known.__class__ is int -> known.__class__ is not int": (
        "`literal` gives each integer the same text, which is then not cached"
    ),
    "motionlang/mint/compile/conversions.py: as_float: 0 -> 1": ("`literal` gives 0.0 the same text"),
    "motionlang/mint/compile/keyword_use.py: _values: len(texts) < count -> len(texts) <= count": (
        "the numbers differ here"
    ),
    "motionlang/mint/compile/body.py: SharedData: __init__: False -> True": (
        "each statement sets it before it is read"
    ),
    "motionlang/mint/compile/body.py: Body: __init__: False -> True": (
        "each statement sets it before it is read"
    ),
    "motionlang/mint/compile/splitting.py: cut: "
    "sum(map(len, statements)) > most -> sum(map(len, statements)) >= most": (
        "how long a block is before it is split, with the same result"
    ),
    "motionlang/mint/resolve/definitions.py: _collide: "
    "one.scope[0] <= other.scope[1] -> one.scope[0] < other.scope[1]": (
        "no block begins with the last token of another one"
    ),
    "motionlang/mint/resolve/definitions.py: _collide: "
    "other.scope[0] <= one.scope[1] -> other.scope[0] < one.scope[1]": (
        "no block begins with the last token of another one"
    ),
    "motionlang/analysis/proof/prove.py: _check_join: bend > size + 4.0 * late * jerk -> "
    "bend >= size + 4.0 * late * jerk": ("just at the size of rounding either is right"),
    "motionlang/analysis/proof/prove.py: _check_join: bend > size + 4.0 * late * jerk -> "
    "bend >= size + 4.0 * late * jerk #2": ("just at the size of rounding either is right"),
    "motionlang/analysis/proof/prove.py: _step: abs(a.profiles[i - 1].end - end) <= SLACK * max(1.0, abs(end)) "
    "-> "
    "abs(a.profiles[i - 1].end - end) < SLACK * max(1.0, abs(end))": (
        "just at the size of rounding either is right"
    ),
    "motionlang/analysis/proof/prove.py: _check_move: abs(profile.distance) > SLACK * size -> "
    "abs(profile.distance) >= SLACK * size": ("just at the size of rounding either is right"),
    "motionlang/analysis/proof/prove.py: _zero: 0.0 -> 1.0": (
        "the zeros of one axis are only compared with each other"
    ),
    "motionlang/analysis/proof/followers.py: _slope_time: 2.0 * change >= rate * edges -> "
    "2.0 * change > rate * edges": ("both formulas give the time of the edges there"),
    "motionlang/analysis/proof/followers.py: check_points: abs(speed - velocities[n]) > SLACK * fast -> "
    "abs(speed - velocities[n]) >= SLACK * fast": ("just at the size of rounding either is right"),
    "motionlang/analysis/proof/followers.py: check_tie: abs(done - wanted) > SLACK * size + 8e-16 * (1.0 + time) "
    "* speed -> "
    "abs(done - wanted) >= SLACK * size + 8e-16 * (1.0 + time) * speed": (
        "just at the size of rounding either is right"
    ),
    "motionlang/analysis/proof/entries.py: _check_gap: a.starts[found.next_index] < until -> "
    "a.starts[found.next_index] <= until": ("a profile that begins then has no time before it"),
    "motionlang/analysis/proof/axes.py: _check_knots: abs(after[1]) > SLACK * sizes[1] -> "
    "abs(after[1]) >= SLACK * sizes[1]": ("just at the size of rounding either is right"),
    "motionlang/analysis/proof/axes.py: check_profile: power > 0.0 -> power >= 0.0": (
        "a stretch without power is at rest or has no acceleration, and uses nothing of either bound"
    ),
    "motionlang/analysis/proof/path_bounds.py: check_path_time: took > limit * (1.0 + SLACK) + 1e-09 -> "
    "took >= limit * (1.0 + SLACK) + 1e-09": ("just at the size of rounding either is right"),
    "motionlang/analysis/cycle/critical_path.py: Strip: by_phase: (high := (low + seconds)) < end -> "
    "(high := (low + seconds)) <= end": ("both are the end of the link"),
    "motionlang/analysis/cycle/critical_path.py: CriticalPath: _follow: time > over -> time >= over": (
        "a program that ends with its run has no motion after it"
    ),
    "motionlang/analysis/cycle/polls.py: _innermost: around[-1][1] <= span[0] + ROUNDING -> "
    "around[-1][1] < span[0] + ROUNDING": ("just at the size of rounding either is right"),
    "motionlang/mccl/runtime/task.py: CommandTask: comes_to_rest: scheduler is None -> scheduler is not None": (
        "the task then yields, and its wait passes with the same result, but slower"
    ),
    "motionlang/mccl/runtime/task.py: CommandTask: _pass: left is not None -> left is None": (
        "the task then yields, and its wait passes with the same result, but slower"
    ),
    "motionlang/mccl/runtime/task.py: CommandTask: __init__: 0 -> 1 #2": (
        "each line sets the index of its first command before it runs"
    ),
    "motionlang/mccl/resolve/line.py: Lines: __missing__: len(text) > MAX_LINE -> len(text) >= MAX_LINE": (
        "a text of just that length is no longer without its comment"
    ),
    "motionlang/mccl/axis/status.py: _auxiliary: 0 -> 1": ("a direction is 1 or -1"),
    "motionlang/mccl/runtime/poll.py: Poll: __init__: -1 -> 1": ("the first position differs from any other"),
    "motionlang/analysis/cycle/motions.py: Motions: that_ended: 0.0 -> 1.0": (
        "the first motion found replaces it"
    ),
    "motionlang/analysis/cycle/motions.py: Motions: that_ended: 0.0 -> 1.0 #2": (
        "the first motion found replaces it"
    ),
    "motionlang/analysis/proof/prove.py: _excuse: abs(before - after) > SLACK * max(1.0, before) -> "
    "abs(before - after) >= SLACK * max(1.0, before)": ("just at the size of rounding either is right"),
    "motionlang/fast/recurrence.py: Recurrence: __init__: 0 -> 1 #3": ("the first search sets it"),
    "motionlang/fast/recurrence.py: Recurrence: __init__: False -> True": ("the first search sets it"),
    "motionlang/fast/recurrence.py: Recurrence: __init__: 0.0 -> 1.0": (
        "a machine whose statements take no time is never compared"
    ),
    "motionlang/fast/recurrence.py: Recurrence: _begin: False -> True": (
        "only speed: whether states with another next task are stored until the first is compared"
    ),
    "motionlang/fast/recurrence.py: Recurrence: _skips: False -> True #2": (
        "only speed: shorter periods are not looked for"
    ),
    "motionlang/fast/recurrence.py: Recurrence: _skips: False -> True #3": (
        "a wait outside a period is outside of shorter ones, too"
    ),
    "motionlang/fast/recurrence.py: Recurrence: _skips: True -> False #2": (
        "only speed: shorter periods are looked for, too"
    ),
    "motionlang/fast/recurrence.py: Recurrence: _backs_off: 30 -> 31": ("a pause has at most 2048 slices"),
    "motionlang/fast/recurrence.py: Recurrence: leap: task.wait is None -> task.wait is not None #3": (
        "a period of no task never recurs, since the waits end at other times"
    ),
    "motionlang/fast/recurrence.py: Recurrence: leap: 0.0 -> 1.0 #2": (
        "without a WAIT the longest is 0, too"
    ),
    "motionlang/fast/recurrence.py: 10000000 -> 10000001": ("one byte more of ten million"),
    "motionlang/fast/recurrence.py: 20000 -> 20001": ("one state more of twenty thousand"),
    "motionlang/fast/walker.py: Walker: walk_all: count * cost -> count / cost": (
        "only speed: the same transition is looked up"
    ),
    "motionlang/fast/walker.py: Walker: walk_all: step.length * cost -> step.length / cost": (
        "only speed: the same transition is looked up"
    ),
    "motionlang/fast/walker.py: Walker: _repetitions: step.waits[0][2] / UNITS -> step.waits[0][2] * UNITS": (
        "only speed: how many repetitions are found at once"
    ),
    "motionlang/fast/walker.py: Walker: walk_all: times > 0 -> times >= 0": (
        "no repetition leaves the time as it is"
    ),
    "motionlang/fast/walker.py: Walker: walk_all: moment > base + count * cost + APART -> moment >= "
    "base + count * cost + APART": ("just at the size of rounding either is right"),
    "motionlang/fast/walker.py: Walker: walk_all: dues[1][0] > moment + step.length * cost + APART "
    "-> dues[1][0] >= moment + step.length * cost + APART": ("just at the size of rounding either is right"),
    "motionlang/fast/walker.py: Walker: next: dues[depth][0] > base + (origin + step.length) * cost "
    "+ APART -> dues[depth][0] >= base + (origin + step.length) * cost + APART": (
        "just at the size of rounding either is right"
    ),
    "motionlang/fast/walker.py: Walker: next: due[0] > base + (count + step.length) * cost + APART "
    "-> due[0] >= base + (count + step.length) * cost + APART": (
        "just at the size of rounding either is right"
    ),
    "motionlang/fast/walker.py: Walker: origin: due[0] > now + APART -> due[0] >= now + APART": (
        "just at the size of rounding either is right"
    ),
    "motionlang/fast/polled_ticks.py: PolledTicks: _path: due[0] > end -> due[0] >= end": (
        "just at the size of rounding either is right"
    ),
    "motionlang/fast/polled_ticks.py: PolledTicks: _observe: due[0] <= self._environment.clock.now + "
    "APART -> due[0] < self._environment.clock.now + APART": ("just at the size of rounding either is right"),
    "motionlang/fast/polled_ticks.py: PolledTicks: _learn_period: 0.0 -> 1.0": (
        "only the beginning of a known period is compared"
    ),
    "motionlang/fast/polled_ticks.py: PolledTicks: _checkpoint: 0.0 -> 1.0 #2": (
        "a wait whose end is not known gets none later"
    ),
    "motionlang/fast/polled_ticks.py: PolledTicks: _checkpoint: True -> False": ("either marks a WAIT"),
    "motionlang/fast/walk.py: Walk: __init__: 0.0 -> 1.0": "the first good transition sets it",
    "motionlang/fast/walk.py: Walk: __init__: 0.0 -> 1.0 #2": "the first good transition sets it",
    "motionlang/fast/walk.py: Walk: __init__: 0 -> 1 #2": "the first good transition sets it",
    "motionlang/fast/polled_ticks.py: PolledTicks: _transition: 0 -> 1": (
        "the ticks of these rows are not used"
    ),
    "motionlang/fast/transitions.py: first_statement: distance > 0.0 -> distance >= 0.0": (
        "a distance of 0 has returned in the lines before"
    ),
    "motionlang/fast/transitions.py: 0.0 -> 1.0": "nothing reads the beginning of what is never due",
    "motionlang/fast/moves.py: FastAxis: velocity: time > self.ends -> time >= self.ends": (
        "at its end the profile has the same velocity"
    ),
    "motionlang/fast/moves.py: FastAxis: position: time > self.ends -> time >= self.ends": (
        "at its end the profile has the same position"
    ),
    "motionlang/fast/moves.py: FastAxis: __init__: 0.0 -> 1.0": ("the start of a move sets it"),
    "motionlang/fast/moves.py: 0.0 -> 1.0": ("the distance before it matches no move"),
    "motionlang/fast/moves.py: 0.0 -> 1.0 #2": ("the distance before it matches no move"),
    "motionlang/fast/moves.py: 0.0 -> 1.0 #3": ("the distance before it matches no move"),
    "motionlang/fast/moves.py: 0.0 -> 1.0 #4": ("the distance before it matches no move"),
    "motionlang/fast/command_rounds.py: CommandRounds: __init__: 0 -> 1": ("the first jump sets it"),
    "motionlang/fast/command_rounds.py: CommandRounds: __init__: 0 -> 1 #2": ("the first jump sets it"),
    "motionlang/fast/command_rounds.py: CommandRounds: jumped: 0 -> 1 #3": (
        "the effects up to a state that is new are not used"
    ),
    "motionlang/fast/command_rounds.py: CommandRounds: jumped: until - CLOSE -> until + CLOSE #2": (
        "a round too many is taken off in the loop behind it"
    ),
    "motionlang/fast/command_rounds.py: CommandRounds: jumped: until - CLOSE <= now -> until - CLOSE < now": (
        "in no time no round fits"
    ),
    "motionlang/fast/command_rounds.py: CommandRounds: jumped: (time := advanced(now, task.cost, rounds "
    "* commands)) > until - CLOSE -> (time := advanced(now, task.cost, rounds * commands)) >= until - "
    "CLOSE": ("just at the size of rounding either is right"),
    "motionlang/fast/command_rounds.py: advanced: 2 -> 3": ("only speed: how many steps are added at once"),
    "motionlang/fast/command_rounds.py: advanced: 0.0 -> 1.0": (
        "only speed: how many steps are added at once"
    ),
    "motionlang/fast/command_rounds.py: advanced: 1 -> 2 #2": (
        "only speed: how many steps are added at once"
    ),
    "motionlang/fast/command_rounds.py: advanced: 0 -> 1 #2": ("one step at once is one step"),
    "motionlang/fast/timer_ticks.py: _Search: is_solvable: 1 -> 2": ("whether there is any"),
    "motionlang/fast/timer_ticks.py: TimerTicks: run: quiet <= clock.now -> quiet < clock.now": (
        "just at the size of rounding either is right"
    ),
    "motionlang/fast/timer_ticks.py: _is_short: wait.ends - wait.since < SHORT_WAIT -> wait.ends - "
    "wait.since <= SHORT_WAIT": ("just at the size of rounding either is right"),
    "motionlang/fast/command_counters.py: _counters_in: 2 -> 3": ("the last command of a loop is its jump"),
    "motionlang/fast/command_counters.py: _levels: first - 3 -> first + 3": (
        "the recall before a count sets the accumulator"
    ),
    "motionlang/fast/closed_form.py: ClosedForm: _inside: values.max() <= limit -> values.max() < limit": (
        "the samples are then compared one by one"
    ),
    "motionlang/fast/closed_form.py: ClosedForm: _inside: values.min() >= -limit -> values.min() > -limit": (
        "the samples are then compared one by one"
    ),
    "motionlang/fast/closed_form.py: ClosedForm: run: z and self._has[i] -> z or self._has[i]": (
        "only speed: a term more or less that is 0"
    ),
    "motionlang/fast/closed_form.py: ClosedForm: run: abs(number) > _NOTHING -> abs(number) >= _NOTHING": (
        "just at the size of rounding either is right"
    ),
    "motionlang/fast/closed_form.py: closed_form: 1 -> 2": (
        "twice the number of samples of a unit is a unit, too"
    ),
    "motionlang/fast/closed_form.py: ClosedFormServo: run_block: begin < until -> begin <= until": (
        "a mark more of the same sample"
    ),
    "motionlang/fast/closed_form.py: 512 -> 513": ("how long a table is at least"),
    "motionlang/fast/closed_form.py: ClosedFormServo: _form: 0 -> 1 #2": (
        "only speed: the form is looked up in its cache"
    ),
    "motionlang/fast/time_slices.py: TimeSlices: _horizon: max_slice < FULL_SLICE -> max_slice <= "
    "FULL_SLICE": ("where both are the same either is right"),
    "motionlang/fast/time_slices.py: TimeSlices: _horizon: event <= horizon -> event < horizon": (
        "only speed: a cancelled event at the end of a slice ends it, as does the end"
    ),
    "motionlang/fast/time_slices.py: TimeSlices: _horizon: event < until -> event <= until": (
        "where both are the same either is right"
    ),
    "motionlang/fast/time_slices.py: TimeSlices: _horizon: event < horizon -> event <= horizon": (
        "where both are the same either is right"
    ),
    "motionlang/fast/time_slices.py: TimeSlices: _horizon: due < horizon -> due <= horizon": (
        "where both are the same either is right"
    ),
    "motionlang/fast/time_slices.py: TimeSlices: ran_handler: event < until -> event <= until": (
        "where both are the same either is right"
    ),
    "motionlang/fast/time_slices.py: TimeSlices: idle_round: clock.now < time -> clock.now <= time": (
        "where both are the same either is right"
    ),
    "motionlang/fast/time_slices.py: TimeSlices: __init__: 0 -> 1 #2": ("the first round sets it"),
    "motionlang/fast/time_slices.py: TimeSlices: __init__: 0 -> 1 #3": ("the first round sets it"),
    "motionlang/fast/time_slices.py: TimeSlices: _last_checked: len(indices) > 1 -> len(indices) >= 1": (
        "the last one of one is that one"
    ),
    "motionlang/fast/ranges.py: Flow: _for: 1 -> 2 #4": (
        "the counter after a step is joined with its start, which is lower"
    ),
    "motionlang/fast/ranges.py: _constants: each + k -> each - k": ("the neighbours are the same"),
    "motionlang/fast/ranges.py: Flow: _number: 0 -> 1": ("both bounds of a constant are the same"),
    "motionlang/cli/mcapi_run.py: _run: True -> False": "the thread is joined before the function returns",
    "motionlang/servo/lookahead.py: next_side: off[start] > 0.0 -> off[start] >= 0.0": (
        "it is farther than the margin from the level, not at it"
    ),
    "motionlang/lang/scheduler.py: Scheduler: __init__: 0.0 -> 1.0": (
        "without statements of a machine, no task asks for their cost"
    ),
    "motionlang/servo/stretch.py: _acts: abs(change) <= _STILL + 4.0 * _ROUNDING * abs(here) -> "
    "abs(change) < _STILL + 4.0 * _ROUNDING * abs(here)": ("just at the size of rounding either is right"),
    "motionlang/mint/keywords/modbus.py: _bits: value > 0 -> value >= 0": (
        "a number beyond all floats of 32 bits is not 0"
    ),
    "motionlang/mint/compile/splitting.py: _shortened: length + len(statement) > SIZE -> length + "
    "len(statement) >= SIZE": ("where long code is cut: it does the same"),
    "motionlang/mint/compile/assembly.py: 1000 -> 1001": (
        "whether code is compiled at once or when it is called: it does the same"
    ),
    "motionlang/analysis/proof/path_layout.py: PathLayout: rates: 0.5 * pi - both -> 0.5 * pi + both": (
        "counted from all quarters, on both sides, the angles are the same"
    ),
    "motionlang/mccl/resolve/nearest.py: candidates: -1 -> 1": "the word has two letters: its last is at 1",
    "motionlang/planners/direction.py: _stretches: profile.duration < inf -> profile.duration <= inf": (
        "a stretch without end, in the same direction, comes before it"
    ),
    "motionlang/analysis/compare/alignment.py: _explained: 1.0 -> 2.0 #3": (
        "with fewer than two points the signal has no energy, and all shares are 0"
    ),
}
