"""Random whole machines in three notations, with the truth known by construction.

A machine homes, waits for a start, works through stages with clamps, moves and checks, may reject or alarm, and starts
again. A good part prints `PART n`; any other cycle prints `BAD n` or `ALARM`. Patterns of the trade are drawn: how it
waits, for what it waits, what it does with it, and how the program is organised. They are drawn independently of what
the exploration can do.

`python -m tests.generated.machines SEED` prints the machine of a seed, and its patterns to standard error.
"""

from __future__ import annotations

import sys
from collections.abc import Callable, Iterable, Sequence
from random import Random

SUFFIXES = {"v4": ".prg", "mt": ".mnt", "mccl": ".mccl"}
_NOTATIONS = ("v4", "v4", "mt", "mt", "mccl", "mccl")
_STARTS = ("one", "edge", "two", "level", "hands", "recipe")
# MCCL knows neither INKEY nor a comms array.
_MINT_STARTS = (*_STARTS, "number", "key", "mixed", "menu")
_STAGES = (
    "clamp", "process", "look", "check", "dwell", "clampout", "adc", "pulses", "pulsesinmove", "countinmove",
    "rise", "lookup",
)  # fmt: skip
_STYLES = {
    "v4": ("sequence", "gosub", "state", "packed"),
    "mt": ("sequence", "gosub", "state", "select", "packed"),
    "mccl": ("sequence", "calls", "table", "packed"),
}
# What a machine may have in addition, and how often.
_EXTRAS = {
    "guard": 0.2, "inverted": 0.2, "chain": 0.15, "lamp": 0.25, "batch": 0.3, "leave": 0.35, "keyswitch": 0.2,
    "handover": 0.25, "waitin": 0.3, "held": 0.2, "home": 0.5,
}  # fmt: skip
# One wait in a polled loop takes this long, in milliseconds.
_POLL_MS = 20

Lines = list[str]


class Plan:
    """What is drawn before a word is written: channels, stages, style and extras."""

    def __init__(self, seed: int) -> None:
        self.random = random = Random(seed)
        self.notation = random.choice(_NOTATIONS)
        is_mccl = self.notation == "mccl"
        self._inputs = random.sample(range(1, 17) if is_mccl else range(16), 16)
        self._outputs = random.sample(range(33, 49) if is_mccl else range(16), 16)
        self.axes = random.choice((1, 1, 2))
        self.start = random.choice(_STARTS if is_mccl else _MINT_STARTS)
        self.style = random.choice(_STYLES[self.notation])
        self.stages = random.sample(_STAGES, random.randint(2, 4))
        self.extras = {extra for extra, share in _EXTRAS.items() if random.random() < share}
        # Version 4 has no tasks.
        if self.notation == "v4":
            self.extras.discard("handover")
        if is_mccl:
            self.extras -= {"lamp", "home"}
        # Patterns that only some waits draw are added where they are written.
        self.notes = [
            f"start-{self.start}",
            self.style,
            *self.stages,
            *sorted(self.extras - {"waitin", "held"}),
        ]

    def input(self) -> int:
        """Return a digital input that nothing else uses."""
        return self._inputs.pop()

    def output(self) -> int:
        """Return a digital output that nothing else uses."""
        return self._outputs.pop()

    @property
    def has_lamp(self) -> bool:
        """True if a lamp blinks beside the program."""
        return "lamp" in self.extras


class Mint:
    """A machine in Mint, with the notation of version 4 or of MintMT."""

    def __init__(self, plan: Plan) -> None:
        self.plan, self.random = plan, plan.random
        self.is_v4 = plan.notation == "v4"
        self.head: Lines = []
        self.tail: Lines = []
        self.names = ["n", "bad", "scan", "ticks", "stage", "good", "k", "cnt", "now", "last", "hold", "ok"]
        self.beacon = plan.output() if self.random.random() < 0.5 else None
        self.acknowledge_input = plan.input()
        self.leave_input: int | None = None

    # The notation.

    def indexed(self, word: str, index: int) -> str:
        return f"{word}.{index}" if self.is_v4 else f"{word}({index})"

    def on(self, channel: int) -> str:
        return self.indexed("INX", channel)

    def off(self, channel: int) -> str:
        is_comparison = self.is_v4 or self.random.random() < 0.5
        return f"{self.on(channel)} = 0" if is_comparison else f"Not {self.on(channel)}"

    def switch(self, channel: int, value: int | str) -> str:
        return f"{self.indexed('OUTX', channel)} = {value}"

    def wait(self, milliseconds: int) -> str:
        return f"WAIT = {milliseconds}" if self.is_v4 else f"Wait({milliseconds})"

    def say(self, text: str, *values: str) -> str:
        return f'? "{text}"' + "".join(f",{value}" for value in values) if self.is_v4 else (
            f'Print "{text}"' + "".join(f"; {value}" for value in values)
        )  # fmt: skip

    def any_of(self, *conditions: str) -> str:
        return (" OR " if self.is_v4 else " Or ").join(conditions)

    def all_of(self, *conditions: str) -> str:
        return (" AND " if self.is_v4 else " And ").join(conditions)

    def masked(self, name: str, bits: int) -> str:
        return f"({name} & {bits})"

    def pause(self, condition: str) -> str:
        return f"{'PAUSE' if self.is_v4 else 'Pause'} {condition}"

    def if_(self, condition: str, then: Iterable[str], other: Sequence[str] = ()) -> Lines:
        lines = [f"IF {condition} DO" if self.is_v4 else f"If {condition} Then", *_indented(then)]
        if other:
            lines += ["ELSE" if self.is_v4 else "Else", *_indented(other)]
        return [*lines, "ENDIF" if self.is_v4 else "End If"]

    def loop(self, body: Iterable[str]) -> Lines:
        return ["LOOP" if self.is_v4 else "Loop", *_indented(body), "ENDL" if self.is_v4 else "End Loop"]

    def repeat(self, body: Iterable[str], until: str) -> Lines:
        first, last = ("REPEAT", "UNTIL") if self.is_v4 else ("Repeat", "Until")
        return [first, *_indented(body), f"{last} {until}"]

    def while_(self, condition: str, body: Iterable[str]) -> Lines:
        first, last = ("WHILE", "ENDW") if self.is_v4 else ("While", "End While")
        return [f"{first} {condition}", *_indented(body), last]

    def call(self, name: str, body: Lines) -> str:
        """Add a sub to the end of the program, and return its call."""
        if self.is_v4:
            self.tail += [f"#{name.upper()}", *body, "RETURN"]
            return f"GOSUB {name.upper()}"
        self.tail += [f"Sub {name}", *_indented(body), "End Sub"]
        return name

    def variable(self, name: str) -> str:
        if name not in self.names:
            self.names.append(name)
        return name

    def move(self, axis: int, target: int, speed: int | None = None) -> Lines:
        speeds = [f"{self.indexed('SPEED', axis)} = {speed}"] if speed else []
        return [*speeds, f"{self.start_move(axis, target)} : {self.pause(self.indexed('IDLE', axis))}"]

    def start_move(self, axis: int, target: int) -> str:
        return f"{self.indexed('MOVEA', axis)} = {target} : {self.indexed('GO', axis)}"

    def stop(self, axis: int) -> str:
        return f"{self.indexed('STOP', axis)} : {self.pause(self.indexed('IDLE', axis))}"

    # Waits.

    def await_(self, condition: str, alarm: Lines | None = None) -> Lines:
        """Wait for a condition in one of the manners of the trade."""
        manner = self.random.choice(
            ("pause", "pause", "repeat", "scan", "blink", "timeout" if alarm else "pause")
        )
        if manner == "repeat":
            return self.repeat([self.wait(20)], condition)
        if manner == "scan":
            return self.repeat(["scan = scan + 1", self.wait(10)], condition)
        if manner == "blink" and self.beacon is not None:
            return self.repeat(
                [self.switch(self.beacon, 1), self.wait(150), self.switch(self.beacon, 0), self.wait(150)],
                condition,
            )
        if manner == "timeout" and alarm:
            self.plan.notes.append("timeout")
            return [
                "ticks = 0",
                *self.repeat(
                    [self.wait(20), "ticks = ticks + 1"], self.any_of(f"({condition})", "ticks > 150")
                ),
                *self.if_("ticks > 150", alarm),
            ]
        return [self.pause(condition)]

    def await_input(self, channel: int, level: int, alarm: Lines | None = None) -> Lines:
        """Wait for a level of an input, sometimes with a routine that takes channel, level and time."""
        if "waitin" not in self.plan.extras or self.random.random() < 0.3:
            return self.await_(self.on(channel) if level else self.off(channel), alarm)
        self.plan.notes.append("waitin")
        given = (channel, level, self.random.choice((800, 2000, 3000)))
        if self.is_v4:
            call = [f"ch = {given[0]} : lv = {given[1]} : ms = {given[2]} : GOSUB WAITIN"]
            return [*call, *self.if_("ok = 0", alarm)] if alarm else self.repeat(call, "ok = 1")
        text = f"waitIn({given[0]}, {given[1]}, {given[2]})"
        return self.if_(f"{text} = 0", alarm) if alarm else self.repeat([f"ok = {text}"], "ok = 1")

    def waiting_routine(self) -> Lines:
        if self.is_v4:
            body = [*self.if_("INX[ch] = lv", ["ok = 1"]), self.wait(5)]
            return ["#WAITIN", "TIME = 0 : ok = 0", *self.repeat(body, "ok = 1 OR TIME > ms"), "RETURN"]
        body = [*self.if_("INX(ch) = lv", ["seen = 1"]), self.wait(5)]
        return [
            "Function waitIn(ByVal ch As Integer, ByVal lv As Integer, ByVal ms As Integer) As Integer",
            "  Dim t As Integer, seen As Integer",
            "  t = TIME",
            "  seen = 0",
            *_indented(self.repeat(body, "seen = 1 Or TIME - t > ms")),
            "  waitIn = seen",
            "End Function",
        ]

    def held(self, channel: int) -> Lines:
        """Wait until an input has been on for a second and a half without a break."""
        self.plan.notes.append("reset-held")
        count = self.if_(self.on(channel), ["hold = hold + 1"], ["hold = 0"])
        return ["hold = 0", *self.repeat([*count, self.wait(_POLL_MS)], "hold >= 75")]

    def acknowledged(self) -> Lines:
        if "held" in self.plan.extras:
            return self.held(self.acknowledge_input)
        return [self.pause(self.on(self.acknowledge_input))]

    def alarm(self) -> Lines:
        lit = [] if self.beacon is None else [self.switch(self.beacon, 1)]
        dark = [] if self.beacon is None else [self.switch(self.beacon, 0)]
        return [self.say("ALARM"), *lit, *self.acknowledged(), *dark]

    # Starts.

    def start(self) -> Lines:
        starts: dict[str, Callable[[], Lines]] = {
            "one": self.start_one, "edge": self.start_edge, "two": self.start_two, "level": self.start_level,
            "hands": self.start_hands, "recipe": self.start_recipe, "number": self.start_number,
            "key": self.start_key, "mixed": self.start_mixed, "menu": self.start_menu,
        }  # fmt: skip
        return starts[self.plan.start]()

    def start_one(self) -> Lines:
        self.leave_input = channel = self.plan.input()
        return self.await_input(channel, 1)

    def start_edge(self) -> Lines:
        channel = self.plan.input()
        return [*self.await_input(channel, 0), *self.await_input(channel, 1)]

    def start_two(self) -> Lines:
        self.leave_input, other = self.plan.input(), self.plan.input()
        return self.await_(self.all_of(self.on(self.leave_input), self.on(other)))

    def start_level(self) -> Lines:
        return self.await_(f"{self.indexed('ADC', 0)} > {self.random.randint(20, 70)}")

    def start_number(self) -> Lines:
        place = self.indexed("COMMS", 1)
        return [*self.await_(f"{place} = {self.random.randint(2, 9)}"), f"{place} = 0"]

    def start_mixed(self) -> Lines:
        place, channel = self.indexed("COMMS", 1), self.plan.input()
        both = self.all_of(self.on(channel), f"{place} = {self.random.randint(2, 9)}")
        return [*self.await_(both), f"{place} = 0"]

    def start_key(self) -> Lines:
        code = ord(self.random.choice("GSR157"))
        return self.repeat(["k = INKEY", self.wait(20)], f"k = {code}")

    def start_hands(self) -> Lines:
        """Two buttons, the second within half a second of the first; else release both and begin again."""
        left, right = self.plan.input(), self.plan.input()
        none = self.all_of(f"{self.on(left)} = 0", f"{self.on(right)} = 0")
        both = self.all_of(self.on(left), self.on(right))
        missed = [self.say("HANDS"), self.pause(none)] if self.random.random() < 0.5 else [self.pause(none)]
        if self.random.random() < 0.5:
            second = [
                "TIME = 0",
                self.pause(self.any_of(f"({both})", "TIME > 500")),
                *self.if_(both, ["ok = 1"], missed),
            ]
        else:
            second = [
                "ticks = 0",
                *self.while_(
                    f"({both}) = 0 {'AND' if self.is_v4 else 'And'} ticks < 50",
                    ["ticks = ticks + 1", self.wait(10)],
                ),
                *self.if_("ticks < 50", ["ok = 1"], missed),
            ]
        first = self.pause(self.any_of(self.on(left), self.on(right)))
        return [self.pause(none), "ok = 0", *self.repeat([first, *second], "ok = 1")]

    def start_recipe(self) -> Lines:
        """A number of two inputs, or of the comms array, chooses a length; 3 is no recipe."""
        recipe = self.variable("recipe")
        if self.random.random() < 0.6:
            low, high = self.plan.input(), self.plan.input()
            read = [f"{recipe} = {self.on(low)} + 2 * {self.on(high)}", self.wait(_POLL_MS)]
        else:
            read = [f"{recipe} = {self.indexed('COMMS', 2)}", self.wait(_POLL_MS)]
        lengths = self.random.sample(range(20, 150, 10), 2)
        length = self.variable("length")
        if self.is_v4:
            chosen = [
                *self.if_(f"{recipe} = 1", [f"{length} = {lengths[0]}"]),
                *self.if_(f"{recipe} = 2", [f"{length} = {lengths[1]}"]),
                *self.if_(f"{recipe} > 2", [*self.alarm(), "good = 0"]),
            ]
        else:
            chosen = [
                f"Select Case {recipe}",
                "  Case 1",
                f"    {length} = {lengths[0]}",
                "  Case 2",
                f"    {length} = {lengths[1]}",
                "  Case Else",
                *_indented(_indented([*self.alarm(), "good = 0"])),
                "End Select",
            ]
        go = f"{self.indexed('MOVEA', 0)} = {length} : {self.indexed('GO', 0)}"
        return [
            f"{length} = 10",
            *self.repeat(read, f"{recipe} > 0"),
            *chosen,
            f"{go} : {self.pause(self.indexed('IDLE', 0))}",
        ]

    def start_menu(self) -> Lines:
        """A menu by keys: R runs, C cleans, 1 to 3 choose a speed and enter confirms."""
        valve = self.plan.output()
        clean = [self.switch(valve, 1), self.wait(300), self.switch(valve, 0)]
        ready = self.variable("ready")
        speed = self.indexed("SPEED", 0)
        asks = self.say("R)UN C)LEAN")
        if self.random.random() < 0.5:
            if self.is_v4:
                choice = [*self.if_("k = 67", clean), *self.if_("k = 82", [f"{ready} = 1"])]
            else:
                choice = [
                    "Select Case k",
                    "  Case 67",
                    *_indented(_indented(clean)),
                    "  Case 82",
                    f"    {ready} = 1",
                ]
                choice.append("End Select")
            return [asks, f"{ready} = 0", *self.repeat(["k = INKEY", *choice, self.wait(20)], f"{ready} = 1")]
        digit = self.all_of("k > 48", "k < 52")
        pick = self.if_(digit, [f"{speed} = 60 * (k - 48)", f"{ready} = 1"])
        confirm = self.if_(self.all_of("k = 13", f"{ready} = 1"), [f"{ready} = 2"])
        return [
            self.say("SPEED 1-3, ENTER"),
            f"{ready} = 0",
            *self.repeat(["k = INKEY", *pick, *confirm, self.wait(20)], f"{ready} = 2"),
        ]

    # Stages.

    def stage(self, kind: str) -> Lines:
        stages: dict[str, Callable[[], Lines]] = {
            "clamp": self.clamp, "process": self.process, "look": self.look, "check": self.check,
            "dwell": self.dwell, "clampout": self.clampout, "adc": self.adc, "pulses": self.pulses,
            "pulsesinmove": self.pulses_in_move, "countinmove": self.count_in_move, "rise": self.rise,
            "lookup": self.lookup,
        }  # fmt: skip
        return stages[kind]()

    def clamp(self) -> Lines:
        channel, output = self.plan.input(), self.plan.output()
        waits = self.await_input(channel, 1, self.alarm())
        return [self.switch(output, 1), *waits, self.wait(100), self.switch(output, 0)]

    def clampout(self) -> Lines:
        channel, output = self.plan.input(), self.plan.output()
        closed, opened = (self.await_input(channel, level, self.alarm()) for level in (1, 0))
        return [self.switch(output, 1), *closed, *self.move(0, 150, 80), self.switch(output, 0), *opened]

    def process(self) -> Lines:
        output, axis = self.plan.output(), self.plan.axes - 1
        moves = self.move(axis, self.random.choice((30, 60)), 12)
        return [
            self.switch(output, 1),
            *moves,
            self.switch(output, 0),
            f"{self.indexed('SPEED', axis)} = 200",
        ]

    def look(self) -> Lines:
        """Half a second in which an input must come, or the part is bad."""
        channel, output = self.plan.input(), self.plan.output()
        looks = self.while_(
            self.all_of(self.off(channel), "ticks < 25"), [self.wait(20), "ticks = ticks + 1"]
        )
        verdict = self.if_("ticks >= 25", ["good = 0"])
        return [self.switch(output, 1), "ticks = 0", *looks, *verdict, self.switch(output, 0)]

    def check(self) -> Lines:
        """An input that must be off, or on, as the program passes."""
        bad_is_on = self.random.random() < 0.5
        verdict = (["good = 0"], []) if bad_is_on else (["ticks = 1"], ["good = 0"])
        return self.if_(self.on(self.plan.input()), *verdict)

    def dwell(self) -> Lines:
        return [self.wait(self.random.choice((150, 300, 500)))]

    def adc(self) -> Lines:
        return self.await_(f"{self.indexed('ADC', 1)} > {self.random.randint(20, 60)}", self.alarm())

    def edge_count(self, channel: int) -> Lines:
        rising = self.if_(self.all_of("now = 1", "last = 0"), ["cnt = cnt + 1"])
        return [f"now = {self.on(channel)}", *rising, "last = now", self.wait(5)]

    def pulses(self) -> Lines:
        """Count pulses at rest, such as turns of a crank."""
        channel, count = self.plan.input(), self.random.randint(2, 4)
        if self.random.random() < 0.5:
            one = [self.pause(self.off(channel)), self.pause(self.on(channel)), "cnt = cnt + 1"]
            return ["cnt = 0", *self.repeat(one, f"cnt = {count}")]
        return ["cnt = 0 : last = 1", *self.repeat(self.edge_count(channel), f"cnt >= {count}")]

    def pulses_in_move(self) -> Lines:
        """Jog until so many pulses were counted, such as marks of a web; too far makes a bad part."""
        channel, count = self.plan.input(), self.random.randint(2, 4)
        far = f"{self.indexed('POS', 0)} > 900"
        is_limited = self.random.random() < 0.5
        end = self.any_of(f"cnt >= {count}", far) if is_limited else f"cnt >= {count}"
        verdict = self.if_(f"cnt < {count}", ["good = 0"]) if is_limited else []
        jog = f"{self.indexed('JOG', 0)} = {self.random.choice((30, 60))}"
        return [
            "cnt = 0 : last = 1",
            jog,
            *self.repeat(self.edge_count(channel), end),
            self.stop(0),
            *verdict,
        ]

    def count_in_move(self) -> Lines:
        """Count pulses in a move of given length; fewer than expected make a bad part."""
        channel, count = self.plan.input(), self.random.randint(1, 3)
        moves = self.while_(self.moving(0), self.edge_count(channel))
        return [
            f"{self.indexed('SPEED', 0)} = 50 : cnt = 0 : last = 1",
            self.start_move(0, self.random.choice((180, 220))),
            *moves,
            *self.if_(f"cnt < {count}", ["good = 0"]),
        ]

    def moving(self, axis: int) -> str:
        idle = self.indexed("IDLE", axis)
        return f"{idle} = 0" if self.is_v4 else f"Not {idle}"

    def rise(self) -> Lines:
        """Jog until a level has risen; it must be low again before the jog."""
        level, limit = self.indexed("ADC", 2), self.random.randint(25, 60)
        jog = f"{self.indexed('JOG', 0)} = {self.random.choice((20, 40))}"
        if self.random.random() < 0.4:
            tare = self.variable("tare")
            return [f"{tare} = {level}", jog, *self.repeat([], f"{level} - {tare} >= {limit}"), self.stop(0)]
        return [*self.await_(f"{level} < {limit // 2}"), jog, self.pause(f"{level} > {limit}"), self.stop(0)]

    def lookup(self) -> Lines:
        """A step within the stage that a number chooses: three short steps of one small state machine."""
        step, ready = self.variable("phase"), self.plan.input()
        output = self.plan.output()
        first = [self.switch(output, 1), f"{step} = 1"]
        second = self.if_(self.on(ready), [self.switch(output, 0), f"{step} = 2"])
        third = self.if_(f"{self.on(ready)} = 0", [f"{step} = 3"])
        if self.is_v4:
            parts = [(i, part) for i, part in enumerate((first, second, third))]
            # In reverse, so that one pass does one step.
            body = [line for i, part in reversed(parts) for line in self.if_(f"{step} = {i}", part)]
        else:
            body = [f"Select Case {step}"]
            for i, part in enumerate((first, second, third)):
                body += [f"  Case {i}", *_indented(_indented(part))]
            body.append("End Select")
        return [f"{step} = 0", *self.repeat([*body, self.wait(_POLL_MS)], f"{step} = 3")]

    # The whole.

    def guards(self) -> Lines:
        """What must be right before a cycle begins."""
        lines: Lines = []
        if "guard" in self.plan.extras:
            lines += self.await_input(self.plan.input(), 1)
        if "chain" in self.plan.extras:
            chain = self.plan.input()
            lines += self.while_(f"{self.on(chain)} = 0", [*self.alarm(), self.pause(self.on(chain))])
        if "keyswitch" in self.plan.extras:
            lines += self.manual()
        if "handover" in self.plan.extras:
            lines += self.handover()
        return lines

    def manual(self) -> Lines:
        """A key switch; with it off, two buttons jog the axis."""
        automatic, plus, minus = (self.plan.input() for _ in range(3))
        speed = self.random.choice((15, 30))
        jog = self.indexed("JOG", 0)
        back = self.if_(self.on(minus), [f"{jog} = -{speed}"], [self.indexed("STOP", 0)])
        jogs = self.if_(self.on(plus), [f"{jog} = {speed}"], back)
        body = self.while_(self.off(automatic), [*jogs, self.wait(_POLL_MS)])
        return [*body, self.stop(0), *self.move(0, 0)]

    def handover(self) -> Lines:
        """A second task loads an axis of its own and hands over by flags."""
        ready, axis, present = self.variable("ready1"), self.plan.axes, self.plan.input()
        feed = [*self.move(axis, 40, 80), *self.move(axis, 0)]
        loads = [self.pause(self.on(present)), *feed] if self.random.random() < 0.6 else [
            *feed, *self.repeat([self.wait(15)], self.on(present)),
        ]  # fmt: skip
        if self.random.random() < 0.5:
            want = self.variable("want")
            task = [self.pause(f"{want} = 1"), f"{want} = 0", *loads, f"{ready} = 1"]
            main = [f"{want} = 1", self.pause(f"{ready} = 1"), f"{ready} = 0"]
        else:
            task = [*loads, f"{ready} = 1", self.pause(f"{ready} = 0")]
            main = [self.pause(f"{ready} = 1"), f"{ready} = 0"]
        self.head.append("Run loader")
        self.tail += ["Task loader", *_indented(self.loop(task)), "End Task"]
        return main

    def advance(self) -> Lines:
        """The first move of a cycle, in which an inverted guard must stay closed (off)."""
        target = self.random.choice((50, 80, 120))
        if "inverted" not in self.plan.extras:
            return self.move(0, target)
        guard = self.plan.input()
        fault = [self.stop(0), *self.alarm(), self.pause(f"{self.on(guard)} = 0"), self.start_move(0, target)]
        watches = self.while_(self.moving(0), [*self.if_(self.on(guard), fault), self.wait(10)])
        return [*self.await_(f"{self.on(guard)} = 0"), self.start_move(0, target), *watches]

    def finish(self) -> Lines:
        back = [
            line
            for axis in range(self.plan.axes)
            for line in self.move(axis, 0, self.random.choice((None, 200)))
        ]
        lines = [*back, "n = n + 1"]
        lines += self.if_("good = 1", [self.say("PART ", "n")], ["bad = bad + 1", self.say("BAD ", "bad")])
        if "leave" in self.plan.extras:
            if self.leave_input is None:
                lines += self.await_input(self.plan.input(), 1)
            else:
                lines += self.await_input(self.leave_input, 0)
        if "batch" in self.plan.extras:
            released = self.pause(f"{self.on(self.acknowledge_input)} = 0")
            end = [self.say("BATCH"), *self.acknowledged(), released, "n = 0"]
            lines += self.if_(f"n >= {self.random.choice((3, 5, 20))}", end)
        return lines

    def body(self, parts: list[Lines]) -> Lines:
        """Organise the parts of a cycle in the style of the plan."""
        style, count = self.plan.style, len(parts)
        if style == "sequence":
            return self.loop([line for part in parts for line in part])
        if style == "gosub":
            return self.loop([self.call(f"part{i}", part) for i, part in enumerate(parts)])
        if style == "select":
            lines = ["Select Case stage"]
            for i, part in enumerate(parts):
                lines += [f"  Case {i}", *_indented(_indented(part)), f"    stage = {(i + 1) % count}"]
            return self.loop([*lines, "End Select"])
        if style == "state":
            following = self.variable("nextone")
            lines = []
            for i, part in enumerate(parts):
                lines += self.if_(f"stage = {i}", [*part, f"{following} = {(i + 1) % count}"])
            return self.loop([*lines, f"stage = {following}", self.wait(10)])
        # Step in bits 0 to 3, stop button in bit 4: one number, as a host would read it.
        flags, stop = self.variable("flags"), self.plan.input()
        lines = self.if_(self.on(stop), [f"{flags} = {flags} | 16"])
        lines += self.if_(
            f"{self.masked(flags, 16)} <> 0",
            [*self.alarm(), self.pause(f"{self.on(stop)} = 0"), f"{flags} = {self.masked(flags, 15)}"],
        )
        lines += [f"stage = {self.masked(flags, 15)}"]
        for i, part in enumerate(parts):
            lines += self.if_(
                f"stage = {i}", [*part, f"{flags} = {self.masked(flags, 16)} | {(i + 1) % count}"]
            )
        return self.loop([*lines, self.wait(10)])

    def lamp(self) -> None:
        output = self.plan.output()
        lit = self.variable("lit")
        if self.is_v4:
            self.head.append("TIMEREVENT = 250")
            self.tail += ["#TIMER", f"{lit} = 1 - {lit}", self.switch(output, lit), "RETURN"]
        elif self.random.random() < 0.5:
            self.head.append("TIMEREVENT = 250")
            self.tail += ["Event TIMER", f"  {lit} = 1 - {lit}", f"  {self.switch(output, lit)}", "End Event"]
        else:
            blinks = [self.switch(output, 1), self.wait(300), self.switch(output, 0), self.wait(300)]
            self.head.append("Run tkLamp")
            self.tail += ["Task tkLamp", *_indented(self.loop(blinks)), "End Task"]

    def text(self) -> str:
        plan = self.plan
        axes = range(plan.axes)
        parts = [["good = 1", *self.guards(), *self.start()], self.advance()]
        parts += [self.stage(kind) for kind in plan.stages]
        parts.append(self.finish())
        body = self.body(parts)
        if plan.has_lamp:
            self.lamp()
        if "waitin" in plan.notes:
            self.tail += self.waiting_routine()
            if self.is_v4:
                self.names += ["ch", "lv", "ms"]
        settings = []
        for axis in axes:
            speed, ramp = self.random.choice((100, 200, 400)), self.random.choice((1000, 2000))
            words = (("SPEED", speed), ("ACCEL", ramp), ("DECEL", ramp))
            settings.append(" : ".join(f"{self.indexed(word, axis)} = {value}" for word, value in words))
        if "home" in plan.extras:
            homes = (
                f"{self.indexed('HOME', axis)} = 0 : {self.pause(self.indexed('IDLE', axis))}"
                for axis in axes
            )
            settings += homes
        if "held" in plan.extras and self.random.random() < 0.5:
            settings += [self.say("RESET"), *self.held(self.acknowledge_input)]
        used = "\n".join([*settings, *self.head, *body, *self.tail])
        names = [name for name in self.names if name in used]
        if self.is_v4:
            first = ["REM machine, drawn", "AUTO", *(f"{name} = 0" for name in names)]
            return "\n".join([*first, *settings, *self.head, *body, "END", *self.tail]) + "\n"
        dims = "Dim " + ", ".join(f"{name} As Integer" for name in names)
        return "\n".join(["' machine, drawn", "Auto", dims, *settings, *self.head, *body, *self.tail]) + "\n"


# Registers of a machine in MCCL. Tasks share all of them from 10.
_PARTS, _BAD, _GOOD, _TICKS, _COUNT, _STEP, _CHANNEL, _OK, _READY, _WANT = range(20, 30)
_FLAGS = 40
_FIRST_TABLE = 200


class Mccl:
    """A machine in MCCL: a chain of macros, with jumps for whatever is not straight on."""

    def __init__(self, plan: Plan) -> None:
        self.plan, self.random = plan, plan.random
        self.macros: dict[int, Lines] = {}
        self.following = 10
        self.current = 0
        self.acknowledge_input = plan.input()
        self.leave_input: int | None = None
        self.setup: Lines = []
        self.routine = 0

    # The notation.

    def label(self) -> int:
        """Reserve the number of a macro."""
        self.following += 1
        return self.following

    def begin(self, number: int) -> None:
        """Write to macro `number` from here on; the current one runs on into it if it does not jump."""
        if self.current and self.macros[self.current][-1:] != ["!"]:
            self.macros[self.current].append(f"MJ{number}")
        self.open(number)

    def open(self, number: int) -> None:
        self.current = number
        self.macros[number] = []

    def put(self, *commands: str) -> None:
        self.macros[self.current] += [*commands]
        # A line holds 255 characters.
        if sum(map(len, self.macros[self.current])) > 150:
            self.begin(self.label())

    def jump(self, number: int) -> None:
        """End the current macro with a jump."""
        self.macros[self.current] += [f"MJ{number}", "!"]

    def count(self, register: int) -> None:
        self.put(f"RA{register}", "AA1", f"AR{register}")

    def set(self, register: int, value: int) -> None:
        self.put(f"AL{value}", f"AR{register}")

    def stop(self, axis: int) -> None:
        self.put(f"{axis}ST", f"{axis}WS.1", f"{axis}PM")

    def move(self, axis: int, target: int) -> None:
        self.put(f"{axis}MA{target}", f"{axis}WS.1")

    # Waits.

    def await_input(self, channel: int, level: int, has_alarm: bool = False) -> None:
        """Wait for a level of an input in one of the manners of the trade."""
        choice = self.random.choice(("wait", "wait", "poll", "timeout" if has_alarm else "wait"))
        if "waitin" in self.plan.extras and level and self.random.random() < 0.7:
            self.await_by_routine(channel, has_alarm)
        elif choice == "wait":
            self.put(f"W{'N' if level else 'F'}{channel}")
        elif choice == "poll":
            poll, done = self.label(), self.label()
            self.begin(poll)
            self.put(f"I{'N' if level else 'F'}{channel}", f"MJ{done}", "NO", "WA.02")
            self.jump(poll)
            self.open(done)
        else:
            self.plan.notes.append("timeout")
            poll, late, done = self.label(), self.label(), self.label()
            self.set(_TICKS, 0)
            self.begin(poll)
            self.put(f"I{'N' if level else 'F'}{channel}", f"MJ{done}", "NO", "WA.02")
            self.put(f"RA{_TICKS}", "AA1", f"AR{_TICKS}", "IG150", f"MJ{late}", "NO")
            self.jump(poll)
            self.open(late)
            self.alarm()
            self.begin(done)

    def await_by_routine(self, channel: int, has_alarm: bool) -> None:
        """Call a macro that waits two seconds for the input whose number is in a register."""
        self.plan.notes.append("waitin")
        self.routine = self.routine or self.label()
        call, failed, done = self.label(), self.label(), self.label()
        self.begin(call)
        self.put(f"AL{channel}", f"AR{_CHANNEL}", f"MC{self.routine}", f"RA{_OK}", "IE1", f"MJ{done}", "NO")
        self.jump(failed)
        self.open(failed)
        if has_alarm:
            self.alarm()
            self.begin(done)
        else:
            self.put("WA.01")
            self.jump(call)
            self.open(done)

    def waiting_routine(self, number: int) -> None:
        poll, found = self.label(), self.label()
        self.open(number)
        self.set(_TICKS, 0)
        self.set(_OK, 0)
        self.begin(poll)
        self.put(f"IN@{_CHANNEL}", f"MJ{found}", "NO", "WA.02")
        self.put(f"RA{_TICKS}", "AA1", f"AR{_TICKS}", "IG100", "BK", "NO")
        self.jump(poll)
        self.open(found)
        self.put("AL1", f"AR{_OK}")

    def acknowledged(self) -> None:
        if "held" not in self.plan.extras:
            self.put(f"WN{self.acknowledge_input}")
            return
        self.held(self.acknowledge_input)

    def held(self, channel: int) -> None:
        """Wait until an input has been on for a second and a half without a break."""
        self.plan.notes.append("reset-held")
        again, poll, done = self.label(), self.label(), self.label()
        self.begin(again)
        self.put("WA.02", f"AL0,AR{_TICKS}")
        self.begin(poll)
        self.put(f"IF{channel}", f"MJ{again}", "NO", "WA.02")
        self.put(f"RA{_TICKS}", "AA1", f"AR{_TICKS}", "IG74", f"MJ{done}", "NO")
        self.jump(poll)
        self.open(done)

    def alarm(self) -> None:
        self.put('OT"ALARM"')
        self.acknowledged()

    # Starts.

    def start(self) -> None:
        plan, kind = self.plan, self.plan.start
        if kind == "one":
            self.leave_input = plan.input()
            self.await_input(self.leave_input, 1)
        elif kind == "edge":
            channel = plan.input()
            self.await_input(channel, 0)
            self.await_input(channel, 1)
        elif kind == "two":
            self.leave_input, other = plan.input(), plan.input()
            self.put(f"WN{self.leave_input}", f"WN{other}")
        elif kind == "level":
            self.await_level(1, above=self.random.randint(2, 7))
        elif kind == "hands":
            self.hands(plan.input(), plan.input())
        else:
            self.recipe(plan.input(), plan.input())

    def await_level(self, channel: int, above: int | None = None, below: int = 0) -> None:
        poll, done = self.label(), self.label()
        self.begin(poll)
        test = f"IB{below}" if above is None else f"IG{above}"
        self.put(f"GA{channel}", test, f"MJ{done}", "NO", "WA.02")
        self.jump(poll)
        self.open(done)

    def hands(self, left: int, right: int) -> None:
        """Two buttons, the second within half a second of the first; else release both and begin again."""
        again, first, second, late, done = (self.label() for _ in range(5))
        has_right = self.label()
        self.begin(again)
        self.put(f"WF{left}", f"WF{right}", f"AL0,AR{_TICKS}")
        self.begin(first)
        self.put(f"IN{left}", f"MJ{second}", "NO", f"IN{right}", f"MJ{second}", "NO", "WA.01")
        self.jump(first)
        self.open(second)
        self.put(f"IN{left}", f"MJ{has_right}", "NO")
        self.jump(late)
        self.open(has_right)
        self.put(f"IN{right}", f"MJ{done}", "NO")
        self.jump(late)
        self.open(late)
        self.put("WA.02", f"RA{_TICKS}", "AA1", f"AR{_TICKS}", "IG25", f"MJ{again}", "NO")
        self.jump(second)
        self.open(done)

    def recipe(self, low: int, high: int) -> None:
        """A jump table: a number of two inputs chooses a length; 3 is no recipe."""
        read, done = self.label(), self.label()
        table = _FIRST_TABLE + 20
        self.begin(read)
        self.put(
            "AL0",
            f"IN{low}",
            "AA1",
            "NO",
            f"IN{high}",
            "AA2",
            "NO",
            f"AA{table}",
            f"AR{_STEP}",
            f"MJ@{_STEP}",
        )
        self.macros[self.current].append("!")
        self.open(table)
        self.put("WA.02")
        self.jump(read)
        for i, length in enumerate(self.random.sample(range(2000, 15000, 1000), 2), 1):
            self.open(table + i)
            self.move(1, length)
            self.jump(done)
        self.open(table + 3)
        self.alarm()
        self.set(_GOOD, 0)
        self.begin(done)

    # Stages.

    def stage(self, kind: str) -> None:
        stages: dict[str, Callable[[], None]] = {
            "clamp": self.clamp, "process": self.process, "look": self.look, "check": self.check,
            "dwell": self.dwell, "clampout": self.clampout, "adc": self.adc, "pulses": self.pulses,
            "pulsesinmove": self.pulses_in_move, "countinmove": self.count_in_move, "rise": self.rise,
            "lookup": self.lookup,
        }  # fmt: skip
        stages[kind]()

    def clamp(self) -> None:
        output = self.plan.output()
        self.put(f"CN{output}")
        self.await_input(self.plan.input(), 1, has_alarm=True)
        self.put("WA.1", f"CF{output}")

    def clampout(self) -> None:
        channel, output = self.plan.input(), self.plan.output()
        self.put(f"CN{output}")
        self.await_input(channel, 1, has_alarm=True)
        self.move(1, 12000)
        self.put(f"CF{output}")
        self.await_input(channel, 0, has_alarm=True)

    def process(self) -> None:
        output, axis = self.plan.output(), self.plan.axes
        self.put(
            f"CN{output}", f"{axis}SV800", f"{axis}MA2400", f"{axis}WS.1", f"CF{output}", f"{axis}SV10000"
        )

    def look(self) -> None:
        """Half a second in which an input must come, or the part is bad."""
        channel, output = self.plan.input(), self.plan.output()
        poll, late, done = self.label(), self.label(), self.label()
        self.put(f"CN{output}", f"AL0,AR{_TICKS}")
        self.begin(poll)
        self.put(f"IN{channel}", f"MJ{done}", "NO", "WA.02")
        self.put(f"RA{_TICKS}", "AA1", f"AR{_TICKS}", "IG24", f"MJ{late}", "NO")
        self.jump(poll)
        self.open(late)
        self.set(_GOOD, 0)
        self.begin(done)
        self.put(f"CF{output}")

    def check(self) -> None:
        """An input that must be off, or on, as the program passes."""
        test = self.random.choice(("IN", "IF"))
        self.put(f"{test}{self.plan.input()}", "AL0", f"AR{_GOOD}")

    def dwell(self) -> None:
        self.put(f"WA{self.random.choice(('.15', '.3', '.5'))}")

    def adc(self) -> None:
        self.await_level(2, above=self.random.randint(2, 6))

    def jog(self) -> None:
        self.put("1VM", "1DI0", f"1SV{self.random.choice((2000, 4000))}", "1GO")

    def end_jog(self) -> None:
        self.stop(1)
        self.put("1SV10000")

    def edges(self, channel: int, count: int) -> None:
        again, done = self.label(), self.label()
        self.set(_COUNT, 0)
        self.begin(again)
        self.put(
            f"WF{channel}",
            f"WN{channel}",
            f"RA{_COUNT}",
            "AA1",
            f"AR{_COUNT}",
            f"IE{count}",
            f"MJ{done}",
            "NO",
        )
        self.jump(again)
        self.open(done)

    def pulses(self) -> None:
        """Count pulses at rest, such as turns of a crank."""
        self.edges(self.plan.input(), self.random.randint(2, 4))

    def pulses_in_move(self) -> None:
        """Jog until so many pulses were counted, such as marks of a web."""
        self.jog()
        self.edges(self.plan.input(), self.random.randint(2, 4))
        self.end_jog()

    def count_in_move(self) -> None:
        """Look for a mark in a jog of two seconds; a part without one is bad."""
        channel, done, late, poll = self.plan.input(), self.label(), self.label(), self.label()
        self.set(_TICKS, 0)
        self.jog()
        self.begin(poll)
        self.put(f"IN{channel}", f"MJ{done}", "NO", "WA.01")
        self.put(f"RA{_TICKS}", "AA1", f"AR{_TICKS}", "IG200", f"MJ{late}", "NO")
        self.jump(poll)
        self.open(late)
        self.set(_GOOD, 0)
        self.begin(done)
        self.end_jog()

    def rise(self) -> None:
        """Jog until a level has risen; it must be low again before the jog."""
        limit = self.random.randint(3, 7)
        self.await_level(3, below=limit - 1)
        self.jog()
        self.await_level(3, above=limit)
        self.end_jog()

    def lookup(self) -> None:
        """Three short steps behind one jump by a register."""
        channel, output = self.plan.input(), self.plan.output()
        table, dispatch, done = _FIRST_TABLE + 40, self.label(), self.label()
        self.set(_STEP, table)
        self.begin(dispatch)
        self.put("WA.02", f"MJ@{_STEP}")
        self.macros[self.current].append("!")
        for i, commands in enumerate(
            ([f"CN{output}"], [f"IF{channel}", f"MJ{dispatch}", "NO", f"CF{output}"])
        ):
            self.open(table + i)
            self.put(*commands)
            self.set(_STEP, table + i + 1)
            self.jump(dispatch)
        self.open(table + 2)
        self.put(f"IN{channel}", f"MJ{dispatch}", "NO")
        self.jump(done)
        self.open(done)

    # The whole.

    def guards(self) -> None:
        plan = self.plan
        if "guard" in plan.extras:
            self.await_input(plan.input(), 1)
        if "chain" in plan.extras:
            chain, again, open_, closed = plan.input(), self.label(), self.label(), self.label()
            self.begin(again)
            self.put(f"IN{chain}", f"MJ{closed}", "NO")
            self.jump(open_)
            self.open(open_)
            self.alarm()
            self.put(f"WN{chain}")
            self.jump(again)
            self.open(closed)
        if "keyswitch" in plan.extras:
            self.manual()
        if "handover" in plan.extras:
            self.handover()

    def manual(self) -> None:
        """A key switch; with it off, two buttons jog the axis in steps."""
        automatic, plus, minus = (self.plan.input() for _ in range(3))
        loop, forth, back, done = (self.label() for _ in range(4))
        self.begin(loop)
        self.put(
            f"IN{automatic}",
            f"MJ{done}",
            "NO",
            f"IN{plus}",
            f"MC{forth}",
            "NO",
            f"IN{minus}",
            f"MC{back}",
            "NO",
        )
        self.put("WA.02")
        self.jump(loop)
        for number, sign in ((forth, ""), (back, "-")):
            self.open(number)
            self.put(f"1MR{sign}500", "1WS.02")
        self.open(done)
        self.move(1, 0)

    def handover(self) -> None:
        """A background task loads an axis of its own and hands over by registers."""
        axis, present, task = self.plan.axes + 1, self.plan.input(), self.label()
        wants = self.random.random() < 0.5
        outer = self.current
        self.open(task)
        if wants:
            self.put(f"RA{_WANT}", "IE0", "WA.01", "JP0", "AL0", f"AR{_WANT}")
        self.put(
            f"WN{present}", f"{axis}MA4000", f"{axis}WS.1", f"{axis}MA0", f"{axis}WS.1", "AL1", f"AR{_READY}"
        )
        if not wants:
            cleared = self.label()
            self.begin(cleared)
            self.put(f"RA{_READY}", "IE1", "WA.01", "JP0")
        self.jump(task)
        self.setup += [f"{axis}SV20000,{axis}SA100000,{axis}DS100000,{axis}MN", f"GT{task}"]
        self.current = outer
        if wants:
            self.set(_WANT, 1)
        ready = self.label()
        self.begin(ready)
        self.put(f"RA{_READY}", "IE0", "WA.01", "JP0", "AL0", f"AR{_READY}")

    def advance(self) -> None:
        """The first move of a cycle; an inverted guard is active low, so that its channel reads on when open."""
        target = self.random.choice((5000, 9000))
        if "inverted" not in self.plan.extras:
            self.move(1, target)
            return
        guard = self.plan.input()
        is_low_true = self.random.random() < 0.5
        if is_low_true:
            self.setup.insert(0, f"CL{guard}")
        closed, opened = ("N", "F") if is_low_true else ("F", "N")
        again, poll, fault, done = (self.label() for _ in range(4))
        self.begin(again)
        self.put(f"W{closed}{guard}", f"1MA{target}", f"AL0,AR{_TICKS}")
        self.begin(poll)
        self.put(f"I{opened}{guard}", f"MJ{fault}", "NO", "WA.02")
        self.put(f"RA{_TICKS}", "AA1", f"AR{_TICKS}", "IG60", f"MJ{done}", "NO")
        self.jump(poll)
        self.open(fault)
        self.put("1ST", "1WS.1")
        self.alarm()
        self.jump(again)
        self.open(done)
        self.put("1WS.1")

    def finish(self) -> None:
        good, bad, done = self.label(), self.label(), self.label()
        for axis in range(1, self.plan.axes + 1):
            self.move(axis, 0)
        self.put(f"RA{_GOOD}", "IE1", f"MJ{good}", "NO")
        self.jump(bad)
        self.open(bad)
        self.put(f"RA{_BAD}", "AA1", f"AR{_BAD}", 'FT"BAD %d"')
        self.jump(done)
        self.open(good)
        self.put(f"RA{_PARTS}", "AA1", f"AR{_PARTS}", 'FT"PART %d"')
        self.begin(done)
        if "leave" in self.plan.extras:
            if self.leave_input is None:
                self.await_input(self.plan.input(), 1)
            else:
                self.await_input(self.leave_input, 0)
        if "batch" in self.plan.extras:
            full, on = self.label(), self.label()
            self.put(f"RA{_PARTS}", f"IG{self.random.choice((2, 4, 19))}", f"MJ{full}", "NO")
            self.jump(on)
            self.open(full)
            self.put('OT"BATCH"')
            self.acknowledged()
            self.put(f"WF{self.acknowledge_input}", "AL0", f"AR{_PARTS}")
            self.begin(on)

    def text(self) -> str:
        plan = self.plan
        stages = plan.stages
        parts: list[Callable[[], None]] = [self.begin_cycle, self.advance]
        parts += [lambda kind=kind: self.stage(kind) for kind in stages]  # type: ignore[misc]
        parts.append(self.finish)
        held = "held" in plan.extras and self.random.random() < 0.5
        main = self.organise(parts)
        if held:
            power_up = self.label()
            self.open(power_up)
            self.put('OT"RESET"')
            self.held(self.acknowledge_input)
            self.setup.append(f"MC{power_up}")
        if self.routine:
            self.waiting_routine(self.routine)
        axes = ",".join(
            f"{axis}SV{self.random.choice((10000, 20000))},{axis}SA100000,{axis}DS100000,{axis}MN"
            for axis in range(1, plan.axes + 1)
        )
        lines = ["; machine, drawn", f"MD1,{axes}"]
        for number, commands in self.macros.items():
            lines.append(f"MD{number}," + ",".join(command for command in commands if command != "!"))
        registers = [*range(_PARTS, _WANT + 1), _FLAGS]
        lines += [
            "AL0," + ",".join(f"AR{register}" for register in registers),
            "MC1",
            *self.setup,
            f"MC{main}",
        ]
        return "\n".join(lines) + "\n"

    def begin_cycle(self) -> None:
        self.set(_GOOD, 1)
        self.guards()
        self.start()

    def organise(self, parts: list[Callable[[], None]]) -> int:
        """Write the parts in the style of the plan, and return the macro that runs them."""
        style, entries = self.plan.style, [self.label() for _ in parts]
        main = self.label()
        for i, (part, entry) in enumerate(zip(parts, entries, strict=True)):
            self.open(_FIRST_TABLE + i if style in ("table", "packed") else entry)
            part()
            if style == "sequence":
                self.jump(entries[(i + 1) % len(parts)])
            elif style == "table":
                self.set(_FLAGS, _FIRST_TABLE + (i + 1) % len(parts))
                self.jump(main)
            elif style == "packed":
                self.put(f"RA{_FLAGS}", "AN16", f"AO{(i + 1) % len(parts)}", f"AR{_FLAGS}")
                self.jump(main)
        if style == "sequence":
            return entries[0]
        self.open(main)
        if style == "calls":
            self.macros[main] = [*(f"MC{entry}" for entry in entries), "RP"]
        elif style == "table":
            self.setup.append(f"AL{_FIRST_TABLE},AR{_FLAGS}")
            self.macros[main] = ["WA.01", f"MJ@{_FLAGS}"]
        else:
            self.packed(main)
        return main

    def packed(self, main: int) -> None:
        """Step in bits 0 to 3, stop button in bit 4: one number, as a host would read it."""
        stop, alarm, table = self.plan.input(), self.label(), self.label()
        self.put("WA.01", f"RA{_FLAGS}", f"IN{stop}", "AO16", "NO", f"AR{_FLAGS}", "IS4", f"MJ{alarm}", "NO")
        self.jump(table)
        self.open(alarm)
        self.alarm()
        self.put(f"WF{stop}", f"RA{_FLAGS}", "AN15", f"AR{_FLAGS}")
        self.begin(table)
        self.put(f"RA{_FLAGS}", "AN15", f"AA{_FIRST_TABLE}", f"AR{_CHANNEL}", f"MJ@{_CHANNEL}")
        self.macros[self.current].append("!")


def _indented(lines: Iterable[str]) -> Lines:
    return [f"  {line}" for line in lines]


def machine(seed: int) -> tuple[str, str, list[str]]:
    """Return the file suffix, the text and the patterns of the machine of `seed`."""
    plan = Plan(seed)
    text = Mccl(plan).text() if plan.notation == "mccl" else Mint(plan).text()
    return SUFFIXES[plan.notation], text, [plan.notation, *dict.fromkeys(plan.notes)]


if __name__ == "__main__":
    suffix, text, notes = machine(int(sys.argv[1]))
    print(text, end="")
    print(suffix, *notes, file=sys.stderr)
