"""Notifications: kinds, order, and unsubscribing during a notification."""

from __future__ import annotations

from motionlang.kernel.controller.listeners import Listeners


def test_each_is_notified_of_its_subscription_in_the_order_of_subscribing() -> None:
    events: list[object] = []
    listeners = Listeners()
    listeners.append(lambda what, axis: events.append(("faults", what, axis)), "fault", "cleared")
    listeners.append(lambda what, axis: events.append(("all", what, axis)))
    listeners.put_first(lambda what, axis: events.append(("first", what, axis)))
    for what in ("fault", "scale"):
        listeners.notify(what, 2)
    assert events == [
        ("first", "fault", 2),
        ("faults", "fault", 2),
        ("all", "fault", 2),
        ("first", "scale", 2),
        ("all", "scale", 2),
    ]


def test_one_may_leave_and_another_come_during_notification() -> None:
    events: list[str] = []
    listeners = Listeners()

    def once(what: str, axis: int) -> None:
        listeners.remove(once)
        listeners.append(lambda what, axis: events.append("new"))
        events.append("once")

    listeners.append(once)
    listeners.append(lambda what, axis: events.append("other"))
    listeners.notify("idle", 0)
    assert events == ["once", "other"]
    assert once not in listeners
    listeners.notify("idle", 0)
    assert events == ["once", "other", "other", "new"]
