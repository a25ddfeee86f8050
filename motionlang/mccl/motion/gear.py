"""Electronic gearing: a slave repeats every motion of its master, times the ratio, from where it is."""

from __future__ import annotations

from motionlang.controller.faults import Refusal

TYPE_CHECKING = False
if TYPE_CHECKING:
    from motionlang.mccl.axis.axis import AxisState
    from motionlang.mccl.runtime.board import Board
    from motionlang.profile import Profile


class Gear:
    """Holds a slave to its master until `release`; the ratio acts in counts and from now on.

    The slave is at once as fast as the ratio says: gearing knows no ramps.
    """

    __slots__ = ("_board", "_let_go", "_line", "_slave", "master")

    def __init__(self, board: Board, slave: AxisState, master: int, line: int) -> None:
        self._board, self._slave, self.master, self._line = board, slave, master, line
        slave.master = master
        self._let_go = board.controller.follow_profiles(master, self._follow)
        self.couple()

    def couple(self) -> None:
        """Take up the motion that the master is in, with the ratio as it is now."""
        controller = self._board.controller
        a = controller.axes[self.master]
        if not controller.is_idle(self.master):
            self._follow(a.profiles[-1].after(controller.clock.now - a.starts[-1]))

    def release(self) -> None:
        """The slave is its own again; what it was doing it goes on doing to the end of the master's move."""
        self._let_go()
        self._slave.master = None

    def _follow(self, profile: Profile) -> None:
        controller, number = self._board.controller, self._slave.number
        if not controller.is_enabled(number):
            return
        if profile.shape == "hold":
            # The master has arrived, as the slave does at this moment, or it was stopped dead.
            if controller.idle_time(number) > controller.clock.now:
                controller.abort(number)
            return
        ratio = self._slave.slave_ratio
        try:
            controller.play(number, profile.scaled(controller.demand(number), ratio), "SM", self._line)
        except Refusal as refusal:
            refusal.line = self._line
            raise
