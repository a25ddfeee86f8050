"""The cost of many watches that an axis never reaches, compared with two.

Prints `name value unit`: the processor time of a move with 1 000 watches over that with 2, the smallest of
each side of alternating runs. The watches are beyond both ends of the axis's range.
"""

from __future__ import annotations

from timing import seconds

from motionlang.controller.controller import Controller

ROUNDS = 7
MOVES = 300
MANY = 1000


def shuttle(count: int) -> Controller:
    """Return a controller whose axis 0 has `count` watches beyond its range."""
    c = Controller(1)
    for k in range(count // 2):
        c.watch(0, 1000.0 + 10.0 * k, lambda _: None, physical=k % 2 == 0)
        c.watch(0, -1000.0 - 10.0 * k, lambda _: None, physical=k % 2 == 1)
    return c


def moves(c: Controller) -> None:
    """Make `MOVES` moves to and fro."""
    for k in range(MOVES):
        c.move_to(0, 500.0 if k % 2 == 0 else -500.0)
        c.clock.advance(c.clock.now + 10.0)


def main() -> None:
    """Measure and print."""
    few, many = shuttle(2), shuttle(MANY)
    times: dict[int, list[float]] = {2: [], MANY: []}
    for _ in range(ROUNDS):
        times[2].append(seconds(lambda: moves(few)))
        times[MANY].append(seconds(lambda: moves(many)))
    print(f"watches_move_with_2 {min(times[2]) / MOVES * 1e6:.1f} us")
    print(f"watches_thousand {min(times[MANY]) / min(times[2]):.2f} times a move with 2")


if __name__ == "__main__":
    main()
