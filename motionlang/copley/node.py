"""The simulated drive as a CANopen node, by the `canopen` library.

It has an SDO server, PDOs and the event of object 0x2012.
"""

from __future__ import annotations

from typing import Any

from canopen import LocalNode, SdoAbortedError
from canopen.objectdictionary import ObjectDictionary, ODRecord, ODVariable, datatypes

from motionlang.copley.drive import Drive
from motionlang.copley.objects import BY_ADDRESS, OBJECTS, Abort, Object, ObjectServer

KINDS: dict[str, int] = {
    "i8": datatypes.INTEGER8,
    "u8": datatypes.UNSIGNED8,
    "i16": datatypes.INTEGER16,
    "u16": datatypes.UNSIGNED16,
    "i32": datatypes.INTEGER32,
    "u32": datatypes.UNSIGNED32,
    "bytes8": datatypes.OCTET_STRING,
}
PDOS = 4
EVENT_DRIVEN = (254, 255)
PDO_INVALID = 1 << 31


def object_dictionary() -> ObjectDictionary:
    """Return the drive's dictionary.

    It has `OBJECTS`, the device type, and four PDOs in each direction.
    """
    dictionary = ObjectDictionary()  # type: ignore[no-untyped-call]  # the library is only partly typed
    dictionary.add_object(_variable("Device type", 0x1000, 0, datatypes.UNSIGNED32, "ro", 0x00020192))
    for number in range(PDOS):
        _add_pdo(dictionary, 0x1400 + number, 0x1600 + number, "Receive", 0x200 + number * 0x100)
        _add_pdo(dictionary, 0x1800 + number, 0x1A00 + number, "Transmit", 0x180 + number * 0x100)
    for entry in OBJECTS:
        _add(dictionary, entry)
    return dictionary


class DriveNode(LocalNode):
    """A node for one drive, whose objects SDOs and PDOs read and write."""

    def __init__(self, node_id: int, drive: Drive) -> None:
        super().__init__(node_id, object_dictionary())
        self.drive = drive
        self.objects = ObjectServer(drive)
        drive.listener = self.send_status
        self._status_maps: list[tuple[int, list[tuple[int, int]]]] = []
        self._receive_ids: list[int] = []

    def get_data(self, index: int, subindex: int, check_readable: bool = False) -> bytes:
        """Return the bytes of an object, for the SDO server and for transmit PDOs."""
        entry = BY_ADDRESS.get((index, subindex))
        if entry is None:
            return bytes(super().get_data(index, subindex, check_readable=check_readable))
        try:
            value = self.objects.read(index, subindex)
        except Abort as rejected:
            raise SdoAbortedError(rejected.code) from None
        return value.to_bytes(_size(entry), "little", signed=entry.kind[0] == "i")

    def set_data(self, index: int, subindex: int, data: bytes, check_writable: bool = False) -> None:
        """Write an object, for the SDO server and for receive PDOs."""
        entry = BY_ADDRESS.get((index, subindex))
        if entry is None:
            super().set_data(index, subindex, data, check_writable=check_writable)
            if 0x1400 <= index < 0x1C00:
                self._map_pdos()
            return
        try:
            self._write(entry, bytes(data))
        except Abort as rejected:
            raise SdoAbortedError(rejected.code) from None

    def send_status(self) -> None:
        """Transmit every event-driven PDO that carries object 0x2012."""
        for can_id, addresses in self._status_maps:
            data = b"".join(self.get_data(index, sub) for index, sub in addresses)
            self.network.send_message(can_id, data)

    def _write(self, entry: Object, data: bytes) -> None:
        if entry.kind == "bytes8":
            self.objects.write_packet(data)
            return
        if len(data) != _size(entry):
            raise Abort(0x06070010, f"object {entry.index:#06x} holds {_size(entry)} bytes")
        value = int.from_bytes(data, "little", signed=entry.kind[0] == "i")
        self.objects.write(entry.index, entry.sub, value)

    def _map_pdos(self) -> None:
        """Subscribe to the configured receive PDOs, and store the transmit PDOs."""
        for can_id in self._receive_ids:
            self.network.unsubscribe(can_id)
        self._receive_ids, self._status_maps = [], []
        for number in range(PDOS):
            self._map_receive(0x1400 + number, 0x1600 + number)
            self._map_transmit(0x1800 + number, 0x1A00 + number)

    def _map_receive(self, communication: int, mapping: int) -> None:
        can_id, addresses = self._can_id(communication), self._mapped(mapping)
        if can_id is None or not addresses:
            return

        def receive(_: int, data: bytearray, __: float) -> None:
            at = 0
            for index, sub in addresses:
                size = _size(BY_ADDRESS[index, sub])
                try:
                    self.set_data(index, sub, bytes(data[at : at + size]))
                except SdoAbortedError:
                    return  # a PDO has no answer; the error is in the drive's log and status
                at += size

        self._receive_ids.append(can_id)
        self.network.subscribe(can_id, receive)

    def _map_transmit(self, communication: int, mapping: int) -> None:
        can_id, addresses = self._can_id(communication), self._mapped(mapping)
        kind = int.from_bytes(self.get_data(communication, 2), "little")
        if can_id is not None and kind in EVENT_DRIVEN and (0x2012, 0) in addresses:
            self._status_maps.append((can_id, addresses))

    def _can_id(self, communication: int) -> int | None:
        value = int.from_bytes(self.get_data(communication, 1), "little")
        return None if value & PDO_INVALID else value & 0x7FF

    def _mapped(self, mapping: int) -> list[tuple[int, int]]:
        count = self.get_data(mapping, 0)[0]
        entries = [int.from_bytes(self.get_data(mapping, n), "little") for n in range(1, count + 1)]
        addresses = [(entry >> 16, entry >> 8 & 0xFF) for entry in entries]
        return [address for address in addresses if address in BY_ADDRESS]


def _add(dictionary: ObjectDictionary, entry: Object) -> None:
    access = {"r": "ro", "w": "wo", "rw": "rw"}[entry.access]
    variable = _variable(entry.name, entry.index, entry.sub, KINDS[entry.kind], access, None)
    if entry.sub == 0:
        dictionary.add_object(variable)
        return
    if entry.index not in dictionary:
        made = ODRecord(entry.name.rsplit(" ", 1)[0], entry.index)
        made.add_member(_variable("Highest sub-index", entry.index, 0, datatypes.UNSIGNED8, "ro", 0))
        dictionary.add_object(made)
    record = dictionary[entry.index]
    assert isinstance(record, ODRecord)
    record[0].default = entry.sub
    record.add_member(variable)


def _add_pdo(dictionary: ObjectDictionary, communication: int, mapping: int, way: str, can_id: int) -> None:
    """Add one PDO, which is invalid and empty until a master configures it."""
    record = ODRecord(f"{way} PDO {communication & 0xFF} communication", communication)
    for sub, name, kind, default in (
        (0, "Highest sub-index", datatypes.UNSIGNED8, 2),
        (1, "COB-ID", datatypes.UNSIGNED32, PDO_INVALID | can_id),
        (2, "Transmission type", datatypes.UNSIGNED8, 255),
    ):
        record.add_member(_variable(name, communication, sub, kind, "rw", default))
    dictionary.add_object(record)
    record = ODRecord(f"{way} PDO {communication & 0xFF} mapping", mapping)
    record.add_member(_variable("Number of objects", mapping, 0, datatypes.UNSIGNED8, "rw", 0))
    for sub in range(1, 9):
        record.add_member(_variable(f"Object {sub}", mapping, sub, datatypes.UNSIGNED32, "rw", 0))
    dictionary.add_object(record)


def _variable(name: str, index: int, sub: int, kind: int, access: str, default: Any) -> ODVariable:
    variable = ODVariable(name, index, sub)
    variable.data_type, variable.access_type, variable.default = kind, access, default
    variable.pdo_mappable = True
    return variable


def _size(entry: Object) -> int:
    return 8 if entry.kind == "bytes8" else int(entry.kind[1:]) // 8
