"""The motion of a run afterwards: as columns, as trajectory points, as what the motors did."""
