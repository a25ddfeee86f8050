"""The flow graph of a function: its steps, and which steps can follow each.

Problem. The linter and the range analysis need to know what may have happened before a statement or may happen after
it: where an axis is, whether a move is ever started, which numbers a variable can hold, which code is unreachable. Mint
has loops, Exit, Select, Goto and Gosub. All these questions are answered on one graph, built once for a function.

Idea. Conditions are steps of their own, so that a client can learn different facts on their true and false sides. Both
ends of a For loop are steps, too. A client describes what one step does; the graph iterates to a fixed point.

    n = 3                 0 start ─ 1 n = 3 ─ 2 n > 0 ─ yes ─ 3 n = n - 1
    While n > 0                               │   └─────────────────┘
     n = n - 1                                no
    End While                                 │
    Print n                                   4 Print n ─ 5 leave

Data. A `Step` has a kind, a tree node and the list `next`. The sides of a condition, `yes` and `no`, are in `next` too.

    start, leave   the two ends of the function; an Exit outside all loops leads to leave
    do             any other statement; an Exit or a Goto has its target in `next`
    test           a condition
    turn, next     the head of a For, whose true side is the body, and its Next, where the variable counts
    end            End: the program stops, and no step follows

A Goto may lead into a block. A Gosub leads to its label. In a function with a Gosub all Returns lead to one common
step, which leads to the statement after each Gosub: calls are not matched with returns. In other functions a Return
leads to leave. A label of the main program that has the name of an event and is the target of no jump is an event
handler, and another entry of the graph.

Invariants.
- `number` is in text order, except for leave and the common step of Returns, which come last. Every cycle has an edge
  to the same or a lower number: that edge leads back.
- `While 1` has no false side, and `Until 0` no true one. Unreachable steps are in `steps` as well; `reached`
  leaves them out.
- A `single` step has one edge into it, from a step with no other edge out. `forward` carries the state along such
  steps without storing it.

Analyses. `reached` finds the steps that some path leads to. `forward` computes facts that hold before a step: the
client applies a step to a state, and joins states where edges meet. Waiting steps are visited in text order, and the
last visit of a step has the final facts. `backward` computes what can happen on some path after a step, as bits of an
integer.

Cost. Building is linear in the statements. `forward` visits a step again whenever its state grows, so the client's
join has to stop growing: the range analysis widens bounds where an edge leads back. `backward` visits a step at most
once for each bit, and once more.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from heapq import heappop, heappush
from typing import TypeVar

from motionlang.kernel.mint.keywords.event_kinds import label_event
from motionlang.kernel.mint.syntax import nodes

State = TypeVar("State")

# Kinds of steps. "start" and "leave" are the two ends of the function, "end" is the end of the program.
# "turn" is the head of a For, where its limit is checked, and "next" is where it counts.
START, DO, TEST, LEAVE, END, HEAD, NEXT = "start", "do", "test", "leave", "end", "head", "next"


class Step:
    """A step of the graph.

    `node` is a statement (DO), a condition (TEST) or None. `yes` and `no` of a condition are both in `next`.
    `number` is the step's position in the text. `is_loop_head` is True if an edge leads back to the step. `loop` is
    the For of TURN and NEXT. `single` is True if only one edge leads to the step, from a step with no other
    edge out.
    """

    __slots__ = ("is_loop_head", "kind", "loop", "next", "no", "node", "number", "single", "yes")

    def __init__(self, kind: str, node: nodes.Node | None, number: int) -> None:
        self.kind, self.node, self.number = kind, node, number
        self.next: list[Step] = []
        self.yes: Step | None = None
        self.no: Step | None = None
        self.loop: nodes.For | None = None
        self.is_loop_head = self.single = False


# Edges without a target so far: the step, and which of its sides ("next", "yes", "no") is open.
Open = list[tuple[Step, str]]


class Graph:
    """The flow graph of a body; with `is_main` its labels may be event handlers."""

    def __init__(self, body: list[nodes.Stmt], is_main: bool = False) -> None:
        self.steps: list[Step] = []
        self.labels: dict[str, Step] = {}
        self.handlers: dict[str, Step] = {}
        self._jumps: list[tuple[Step, nodes.Jump]] = []
        self._after_gosub: dict[Step, Step] = {}
        self._returns: list[Step] = []
        self._exits: list[tuple[str, Open]] = []
        self.start = self._new(START, None, [])
        edges = self._block(body, [(self.start, "next")])
        self.leave = self._new(LEAVE, None, edges)
        self._join_jumps(is_main)
        self._find_single()

    def reached(self, *begin: Step) -> set[Step]:
        """Return the steps that can be reached from the given steps, including these.

        Without an argument the search begins at start and at the handlers.
        """
        found: set[Step] = set()
        stack = [*begin] or [self.start, *self.handlers.values()]
        while stack:
            step = stack.pop()
            if step not in found:
                found.add(step)
                stack.extend(step.next)
        return found

    def handled(self, *labels: str) -> Iterator[nodes.Node]:
        """Yield the statements and conditions that these handlers, or all, execute up to their Return."""
        found: set[Step] = set()
        stack = [step for label, step in self.handlers.items() if not labels or label in labels]
        while stack:
            step = stack.pop()
            if step in found:
                continue
            found.add(step)
            if step.node is not None:
                yield step.node
            if type(step.node) is not nodes.Return:
                stack += [*step.next, *([self._after_gosub[step]] if step in self._after_gosub else ())]

    def forward(
        self,
        first: State,
        follow: Callable[[Step, State], tuple[State | None, State | None]],
        join: Callable[[State, State, Step, bool], State],
        elsewhere: State,
        own: Callable[[State], State],
    ) -> None:
        """Compute the facts before each step, to a fixed point.

        `follow(step, state)` returns the states on the true (or only) side and on the false side, None for a side
        that no path takes. It may modify its argument, which is `own(state)` at the first step of a run of single
        steps. `join(a, b, step, back)` returns the facts common to both before a step, and `a` itself if `b`
        adds nothing new. `back` is True if the edge leads back in the text, as one edge of every cycle does.
        `first` are the facts at the start, `elsewhere` those at the start of an event handler. On the last visit of
        a step its facts are final.
        """
        before: dict[Step, State] = {self.start: first, **dict.fromkeys(self.handlers.values(), elsewhere)}
        waiting = sorted(step.number for step in before)
        queued = set(waiting)
        while waiting:
            step = self.steps[heappop(waiting)]
            queued.discard(step.number)
            yes, no = follow(step, own(before[step]))
            while len(step.next) == 1 and step.next[0].single:
                state = no if step.next[0] is step.no else yes
                if state is None:
                    break
                step = step.next[0]
                yes, no = follow(step, state)
            for after in step.next:
                back = after.number <= step.number
                for state in [yes, no] if after is step.yes is step.no else [no if after is step.no else yes]:
                    if state is None:
                        continue
                    old = before.get(after)
                    new = state if old is None else join(old, state, after, back)
                    if new is not old:
                        before[after] = new
                        if after.number not in queued:
                            queued.add(after.number)
                            heappush(waiting, after.number)

    def backward(self, last: int, end: int, follow: Callable[[Step, int], int]) -> dict[Step, int]:
        """Compute, as bits, what can happen on some path after each step.

        The bits are `last` where the function is left and `end` at the end of the program.
        """
        behind: dict[Step, int] = dict.fromkeys(self.steps, 0)
        came: dict[Step, list[Step]] = {step: [] for step in self.steps}
        for step in self.steps:
            for after in step.next:
                came[after].append(step)
            if not step.next:
                behind[step] = end if step.kind == END else last
        waiting = list(range(1 - len(self.steps), 1))
        queued = set(waiting)
        while waiting:
            step = self.steps[-heappop(waiting)]
            queued.discard(-step.number)
            bits = follow(step, behind[step])
            for earlier in came[step]:
                if behind[earlier] | bits != behind[earlier]:
                    behind[earlier] |= bits
                    if -earlier.number not in queued:
                        queued.add(-earlier.number)
                        heappush(waiting, -earlier.number)
        return behind

    # ---------------------------------------------------------------------------------------- building

    def _new(self, kind: str, node: nodes.Node | None, edges: Open) -> Step:
        step = Step(kind, node, len(self.steps))
        self.steps.append(step)
        self._lead(edges, step)
        return step

    def _lead(self, edges: Open, to: Step) -> None:
        for step, side in edges:
            if to not in step.next:
                step.next.append(to)
            if side != "next":
                setattr(step, side, to)

    def _block(self, body: list[nodes.Stmt], edges: Open) -> Open:
        for node in body:
            build = _BUILD.get(type(node))
            edges = [(self._new(DO, node, edges), "next")] if build is None else build(self, node, edges)
        return edges

    def _test(self, node: nodes.Node, edges: Open) -> Step:
        return self._new(TEST, node, edges)

    def _if(self, node: nodes.If, edges: Open) -> Open:
        out: Open = []
        while True:
            test = self._test(node.condition, edges)
            out += self._block(node.body, [(test, "yes")])
            edges = [(test, "no")]
            if len(node.orelse) != 1 or type(node.orelse[0]) is not nodes.If:
                return out + self._block(node.orelse, edges)
            node = node.orelse[0]

    def _select(self, node: nodes.Select, edges: Open) -> Open:
        subject = self._new(DO, node, edges)
        self._exits.append(("select", []))
        out: Open = []
        default = False
        for case in node.cases:
            default = default or not case.tests
            out += self._block(case.body, [(self._new(DO, case, [(subject, "next")]), "next")])
        return out + self._exits.pop()[1] + ([] if default else [(subject, "next")])

    def _for(self, node: nodes.For, edges: Open) -> Open:
        head = self._new(HEAD, None, [(self._new(DO, node, edges), "next")])
        head.loop = node
        out = self._iteration("for", node.body, head, [(head, "yes")], NEXT)
        return [(head, "no"), *out]

    def _while(self, node: nodes.While, edges: Open) -> Open:
        test = self._test(node.condition, edges)
        out = self._iteration("while", node.body, test, [(test, "yes")])
        return out if _always(node.condition) else [(test, "no"), *out]

    def _repeat(self, node: nodes.Repeat, edges: Open) -> Open:
        head = self._new(DO, node, edges)
        self._exits.append(("repeat", []))
        test = self._test(node.condition, self._block(node.body, [(head, "next")]))
        head.is_loop_head = True
        self._lead([(test, "no")], head)
        out = self._exits.pop()[1]
        return out if _never(node.condition) else [(test, "yes"), *out]

    def _loop(self, node: nodes.Loop, edges: Open) -> Open:
        head = self._new(DO, node, edges)
        return self._iteration("loop", node.body, head, [(head, "next")])

    def _iteration(
        self, kind: str, body: list[nodes.Stmt], head: Step, edges: Open, last: str | None = None
    ) -> Open:
        self._exits.append((kind, []))
        edges = self._block(body, edges)
        if last is not None:
            behind = self._new(last, None, edges)
            behind.loop = head.loop
            edges = [(behind, "next")]
        self._lead(edges, head)
        head.is_loop_head = True
        return self._exits.pop()[1]

    def _exit(self, node: nodes.Exit, edges: Open) -> Open:
        step = self._new(DO, node, edges)
        for kind, out in reversed(self._exits):
            if kind == node.kind or (not node.kind and kind != "select"):
                out.append((step, "next"))
                return []
        self._returns.append(step)
        return []

    def _end(self, node: nodes.End, edges: Open) -> Open:
        if node.name is not None:
            return [(self._new(DO, node, edges), "next")]
        self._new(END, node, edges)
        return []

    def _label(self, node: nodes.Label, edges: Open) -> Open:
        step = self.labels[node.name.lower()] = self._new(DO, node, edges)
        step.is_loop_head = True
        return [(step, "next")]

    def _jump(self, node: nodes.Jump, edges: Open) -> Open:
        step = self._new(DO, node, edges)
        self._jumps.append((step, node))
        if node.kind != "gosub":
            return []
        after = self._new(DO, None, [])
        self._after_gosub[step] = after
        return [(after, "next")]

    def _return(self, node: nodes.Return, edges: Open) -> Open:
        self._returns.append(self._new(DO, node, edges))
        return []

    def _join_jumps(self, is_main: bool) -> None:
        for step, node in self._jumps:
            label = self.labels.get(node.name.lower())
            if label is not None:
                step.next.append(label)
        targets = {node.name.lower() for _, node in self._jumps}
        for name, step in self.labels.items():
            if is_main and name not in targets and label_event(name) is not None:
                self.handlers[name] = step
        if self._after_gosub:
            back = self._new(DO, None, [])
            back.next = list(self._after_gosub.values())
        for step in self._returns:
            step.next.append(back if type(step.node) is nodes.Return and self._after_gosub else self.leave)

    def _find_single(self) -> None:
        incoming = dict.fromkeys(self.steps, 0)
        for step in self.steps:
            for after in step.next:
                incoming[after] += 1 + (len(step.next) > 1)
        for step in (self.start, *self.handlers.values()):
            incoming[step] += 1
        for step, count in incoming.items():
            step.single = count == 1


def _always(condition: nodes.Expr) -> bool:
    """True for a loop that is meant to run forever: `While 1`, `While _TRUE`."""
    return _literal(condition) not in (None, 0)


def _never(condition: nodes.Expr) -> bool:
    """True for a loop that is meant to run forever: `Until 0`."""
    return _literal(condition) == 0


_WORDS = {"_true": 1, "_on": 1, "_false": 0, "_off": 0}


def _literal(condition: nodes.Expr) -> float | None:
    if type(condition) is nodes.Number:
        return condition.value
    if type(condition) is nodes.Name and condition.args is None:
        return _WORDS.get(condition.name.lower())
    return None


_BUILD: dict[type, Callable[..., Open]] = {
    nodes.If: Graph._if,
    nodes.Select: Graph._select,
    nodes.For: Graph._for,
    nodes.While: Graph._while,
    nodes.Repeat: Graph._repeat,
    nodes.Loop: Graph._loop,
    nodes.Exit: Graph._exit,
    nodes.End: Graph._end,
    nodes.Label: Graph._label,
    nodes.Jump: Graph._jump,
    nodes.Return: Graph._return,
}
