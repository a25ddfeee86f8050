"""The simulated drive as a CANopen node, built on the `canopen` library.

It has an SDO server, the objects of CiA 301, PDOs with defaults, heartbeat, EMCY and the event of object 0x2012.
`update` performs the actions that are due. A bus in lock step has its own time and needs `update` only for status
words.
"""

from __future__ import annotations

from collections.abc import Sequence
from functools import partial
from typing import Any

from canopen import LocalNode, SdoAbortedError
from canopen.objectdictionary import ObjectDictionary, ODRecord, ODVariable, datatypes

from motionlang.kernel import INFINITY
from motionlang.kernel.version import __version__
from motionlang_copley.drive import Drive
from motionlang_copley.objects import BY_ADDRESS, OBJECTS, Abort, Object, ObjectServer
from motionlang_copley.pdo import (
    EVENT_DRIVEN,
    ID_STEP,
    MAX_BITS,
    PDO_INVALID,
    PDOS,
    RECEIVE_ID,
    RECEIVED,
    SEND_ID,
    SENT,
    STATUS_PERIOD,
    SYNCHRONOUS,
    Address,
    SentPdo,
    entry,
    sent_pdo,
)
from motionlang_copley.switches import Switches

KINDS: dict[str, int] = {
    "i8": datatypes.INTEGER8,
    "u8": datatypes.UNSIGNED8,
    "i16": datatypes.INTEGER16,
    "u16": datatypes.UNSIGNED16,
    "i32": datatypes.INTEGER32,
    "u32": datatypes.UNSIGNED32,
    "bytes8": datatypes.OCTET_STRING,
}
DEVICE_TYPE = 0x00020192
NAME, HARDWARE = "motionlang virtual drive", "virtual"
# CAN identifiers: SYNC, and those of a node without its number.
SYNC_ID, EMCY_ID, HEARTBEAT_ID = 0x80, 0x80, 0x700
RESET_NODE, RESET_COMMUNICATION = 129, 130
STOPPED, OPERATIONAL, PRE_OPERATIONAL = 4, 5, 127
# Seconds from a reset to the boot-up message; a master needs some to begin to wait for it.
BOOT_TIME = 0.02
# The object with the node whose heartbeat the drive waits for, and its longest time, ms.
CONSUMER_HEARTBEAT = 0x1016
# EMCY: a received PDO that is too short, and a heartbeat that does not come.
PDO_LENGTH, NO_HEARTBEAT = 0x8210, 0x8130
# The error register: bit 0 for any error, bit 4 for communication.
GENERIC, COMMUNICATION = 0x01, 0x10
# SDO requests: the mask of the command, that of a block upload and of its later steps; the answer that aborts one.
SDO_COMMAND, BLOCK_UPLOAD, BLOCK_STEP, SDO_ABORT = 0xE0, 0xA0, 0x03, 0x80
INVALID_COMMAND = 0x05040001
NOT_MAPPABLE, TOO_LONG, VALUE_RANGE, NO_SUBINDEX = 0x06040041, 0x06040042, 0x06090030, 0x06090011
# The value cannot be written in the present state.
NOT_NOW = 0x08000022
# An expedited download, the mask of its command, and the bits of its size.
EXPEDITED, EXPEDITED_MASK, WITH_SIZE = 0x22, 0xE3, 0x01


def object_dictionary(node_id: int = 0) -> ObjectDictionary:
    """Return the drive's dictionary, with the identifiers of a node.

    It has `OBJECTS`, the objects of CiA 301, and four PDOs in each direction. For node 0 the identifiers do not include
    the node number, as in an EDS.
    """
    dictionary = ObjectDictionary()  # type: ignore[no-untyped-call]  # the library is only partly typed
    u8 = datatypes.UNSIGNED8
    u16 = datatypes.UNSIGNED16
    u32 = datatypes.UNSIGNED32
    text = datatypes.VISIBLE_STRING
    for name, index, kind, access, default in (
        ("Device type", 0x1000, u32, "ro", DEVICE_TYPE),
        ("Error register", 0x1001, u8, "ro", 0),
        ("COB-ID SYNC", 0x1005, u32, "ro", SYNC_ID),
        ("Manufacturer device name", 0x1008, text, "const", NAME),
        ("Manufacturer hardware version", 0x1009, text, "const", HARDWARE),
        ("Manufacturer software version", 0x100A, text, "const", __version__),
        ("COB-ID EMCY", 0x1014, u32, "ro", EMCY_ID + node_id),
        ("Producer heartbeat time", 0x1017, u16, "rw", 0),
    ):
        dictionary.add_object(_variable(name, index, 0, kind, access, default, mappable=index == 0x1001))
    heartbeats = ODRecord("Consumer heartbeat time", CONSUMER_HEARTBEAT)
    heartbeats.add_member(_variable("Highest sub-index", CONSUMER_HEARTBEAT, 0, u8, "ro", 1))
    heartbeats.add_member(_variable("Node and time", CONSUMER_HEARTBEAT, 1, u32, "rw", 0))
    dictionary.add_object(heartbeats)
    _add_identity(dictionary, node_id)
    for number in range(PDOS):
        step = number * ID_STEP + node_id
        _add_pdo(dictionary, 0x1400 + number, 0x1600 + number, "Receive", RECEIVE_ID + step, RECEIVED[number])
        _add_pdo(dictionary, 0x1800 + number, 0x1A00 + number, "Transmit", SEND_ID + step, SENT[number])
    for each in OBJECTS:
        _add(dictionary, each)
    return dictionary


class DriveNode(LocalNode):
    """A node for one drive, whose objects are read and written by SDOs and PDOs."""

    def __init__(self, node_id: int, drive: Drive, switches: Switches | None = None) -> None:
        super().__init__(node_id, object_dictionary(node_id))
        self.drive = drive
        self._heartbeat_id = HEARTBEAT_ID + node_id
        self.objects = ObjectServer(drive, switches)
        self.objects.emergency = self.send_emergency
        drive.listener = self.send_status
        self.error_register = 0
        self._status_maps: list[tuple[int, list[Address]]] = []
        self._sent: list[SentPdo] = []
        self._receive_ids: list[int] = []
        # What the synchronous receive PDOs have received since the last SYNC, by identifier.
        self._received: dict[int, tuple[Sequence[Address], bytes]] = {}
        # The time at which the next heartbeat is due.
        self._heartbeat_at = INFINITY
        # The node whose heartbeat is expected, and the time by which it must come; infinite until the first.
        self._monitored, self._silent_at = 0, INFINITY
        # The time at which a reset is over.
        self._boot_at = INFINITY
        self._nmt_state = 0

    @property
    def now(self) -> float:
        """The time of the drive, seconds."""
        return self.drive.now

    def boot(self) -> None:
        """Join the bus: send the boot-up message and become pre-operational."""
        self.network.unsubscribe(self.sdo.rx_cobid, self.sdo.on_request)
        self.network.subscribe(self.sdo.rx_cobid, self._on_request)
        self.network.subscribe(0, self._commanded)
        self.network.subscribe(SYNC_ID, self._synchronise)
        self._start()

    def update(self) -> None:
        """Do what is due: heartbeat, state machine, PDOs whose data have changed."""
        self.objects.update()
        if self.now >= self._boot_at:
            self._start()
        if self.now >= self._heartbeat_at:
            self._heartbeat_at += self._heartbeat_period
            self._send_heartbeat()
        if self.now >= self._silent_at:
            self._silent_at = INFINITY
            self.objects.trip(NO_HEARTBEAT)
            if self.nmt_state == OPERATIONAL:
                self.nmt._state = PRE_OPERATIONAL  # without object 0x1029, CiA 301
        operational = self.nmt_state == OPERATIONAL
        if operational and self._nmt_state != OPERATIONAL:
            for each in self._sent:
                each.data = b""
        self._nmt_state = self.nmt_state
        if operational:
            for each in self._sent:
                data = self._data_of(each)
                if each.is_due(data, self.now):
                    self._transmit(each, data)

    def next_time(self) -> float:
        """Return the time, s, of the next `update`; infinite if only a frame requires one."""
        times = [self._heartbeat_at, self._boot_at, self._silent_at]
        if self.drive.next_boundary is not None:
            times.append(self.drive.next_boundary * 1e-6)
        if self.nmt_state == OPERATIONAL:
            times += [each.next_time() for each in self._sent]
        return min(times)

    @property
    def nmt_state(self) -> int:
        """The state of network management: 4 stopped, 5 operational, 127 pre-operational."""
        return int(self.nmt._state)

    def send_emergency(self, code: int) -> None:
        """Send an EMCY message; code 0 means that the errors have been cleared, and needs one."""
        if code == 0 and not self.error_register:
            return
        self.error_register = 0 if code == 0 else self.error_register | GENERIC
        if code >> 12 == 8 and code >> 8 in (0x81, 0x82):
            self.error_register |= COMMUNICATION
        if self.nmt_state:
            self.emcy.send(code, self.error_register)

    def get_data(self, index: int, subindex: int, check_readable: bool = False) -> bytes:
        """Return the bytes of an object, for the SDO server and for transmit PDOs."""
        entry = BY_ADDRESS.get((index, subindex))
        if (index, subindex) == (0x1001, 0):
            return bytes([self.error_register])
        if entry is None:
            return bytes(super().get_data(index, subindex, check_readable=check_readable))
        try:
            value = self.objects.read(index, subindex)
        except Abort as rejected:
            raise SdoAbortedError(rejected.code) from None
        return value.to_bytes(_size(entry), "little", signed=entry.kind[0] == "i")

    def _find_object(self, index: int, subindex: int) -> ODVariable:
        """Return an object of the dictionary; the library finds one without sub-indices at any of them."""
        found: ODVariable = super()._find_object(index, subindex)  # type: ignore[no-untyped-call]
        if found.subindex != subindex:
            raise SdoAbortedError(NO_SUBINDEX)
        return found

    def set_data(self, index: int, subindex: int, data: bytes, check_writable: bool = False) -> None:
        """Write an object, for the SDO server and for receive PDOs."""
        entry = BY_ADDRESS.get((index, subindex))
        if entry is None:
            self._configure(index, subindex, bytes(data), check_writable)
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

    # ------------------------------------------------------------------------------------- network management

    def _start(self) -> None:
        """Enter the state that follows a reset of the communication."""
        self.data_store.clear()
        self.error_register = 0
        self._heartbeat_at = self._boot_at = INFINITY
        self._listen_to(0)
        self._map_pdos()
        self.network.send_message(self._heartbeat_id, bytes([0]))
        self.nmt._state = PRE_OPERATIONAL

    def _commanded(self, _: int, data: bytearray, __: float) -> None:
        """Carry out a reset command of network management.

        The library has already changed the state of the node.
        """
        if len(data) >= 2 and data[1] in (0, self.id) and data[0] in (RESET_NODE, RESET_COMMUNICATION):
            if data[0] == RESET_NODE:
                self.objects.reset()
            self._heartbeat_at, self._boot_at = INFINITY, self.now + BOOT_TIME

    def _on_request(self, can_id: int, data: bytearray, timestamp: float) -> None:
        """Answer an SDO request, unless the node is stopped.

        A block upload is answered by a normal one, as far as the client allows that.
        """
        if self.nmt_state == STOPPED:
            return
        if len(data) == 8 and data[0] & SDO_COMMAND == BLOCK_UPLOAD and not self._may_switch(data):
            answer = bytes([SDO_ABORT]) + bytes(data[1:4]) + INVALID_COMMAND.to_bytes(4, "little")
            self.network.send_message(self.sdo.tx_cobid, answer)
            return
        self.sdo.on_request(can_id, self._sized(data), timestamp)  # type: ignore[no-untyped-call]

    def _sized(self, request: bytearray) -> bytearray:
        """Return a request with the size of its object if it is an expedited download that names none."""
        entry = (
            BY_ADDRESS.get((int.from_bytes(request[1:3], "little"), request[3]))
            if len(request) == 8
            else None
        )
        if entry is None or request[0] & EXPEDITED_MASK != EXPEDITED or _size(entry) > 4:
            return request
        return bytearray([EXPEDITED | WITH_SIZE | (4 - _size(entry)) << 2]) + request[1:]

    def _may_switch(self, request: bytearray) -> bool:
        """True if a block upload may become a normal one: its threshold (pst) is not below the size of the data.

        CiA 301: a threshold of 0 forbids it. The upload of an object that cannot be read has its own abort.
        """
        if request[0] & BLOCK_STEP:
            return False
        try:
            size = len(self.get_data(int.from_bytes(request[1:3], "little"), request[3], check_readable=True))
        except (SdoAbortedError, KeyError):
            return True
        return size <= request[5]

    @property
    def _heartbeat_period(self) -> float:
        return int.from_bytes(self.get_data(0x1017, 0), "little") * 1e-3

    def _listen_to(self, node: int) -> None:
        """Monitor the heartbeat of a node, beginning with its first one; 0 monitors none."""
        if self._monitored:
            self.network.unsubscribe(HEARTBEAT_ID + self._monitored, self._alive)
        self._monitored, self._silent_at = node, INFINITY
        if node:
            self.network.subscribe(HEARTBEAT_ID + node, self._alive)

    def _alive(self, _: int, data: bytearray, __: float) -> None:
        self._silent_at = self.now + (self._number(CONSUMER_HEARTBEAT, 1) & 0xFFFF) * 1e-3

    def _send_heartbeat(self) -> None:
        self.network.send_message(self._heartbeat_id, bytes([self.nmt_state]))

    # ---------------------------------------------------------------------------------------- configuration

    def _configure(self, index: int, subindex: int, data: bytes, check_writable: bool) -> None:
        """Write an object of CiA 301."""
        if index == 0x1017:
            self._check(index, subindex, data, check_writable)
            self.data_store.setdefault(index, {})[subindex] = data
            period = self._heartbeat_period
            self._heartbeat_at = self.now + period if period else INFINITY
            return
        if 0x1600 <= index < 0x1600 + PDOS or 0x1A00 <= index < 0x1A00 + PDOS:
            self._check_mapping(index, subindex, int.from_bytes(data, "little"))
        elif 0x1400 <= index < 0x1800 + PDOS:
            self._check_communication(index, subindex, int.from_bytes(data, "little"))
        super().set_data(index, subindex, data, check_writable=check_writable)
        if (index, subindex) == (CONSUMER_HEARTBEAT, 1):
            value = int.from_bytes(data, "little")
            self._listen_to(value >> 16 & 0x7F if value & 0xFFFF else 0)
        if 0x1400 <= index < 0x1C00:
            self._map_pdos()

    def _check(self, index: int, subindex: int, data: bytes, check_writable: bool) -> None:
        """Check a write in the way that the library does."""
        variable = self._find_object(index, subindex)
        if check_writable and not variable.writable:
            raise SdoAbortedError(0x06010002)
        if 8 * len(data) != len(variable):
            raise SdoAbortedError(0x06070010)

    def _check_communication(self, index: int, subindex: int, value: int) -> None:
        """Raise an abort for a type that is not served, and for parameters of a PDO that is in use."""
        if subindex == 2 and value not in SYNCHRONOUS and value not in EVENT_DRIVEN:
            raise SdoAbortedError(VALUE_RANGE)
        used = self._can_id(index)
        is_moved = subindex == 1 and not value & PDO_INVALID and value & 0x7FF != used
        if used is not None and (subindex == 3 or is_moved):
            raise SdoAbortedError(NOT_NOW)

    def _check_mapping(self, index: int, subindex: int, value: int) -> None:
        """Raise an abort if a mapping has an unknown object or too many bits."""
        if subindex == 0:
            bits = sum(
                int.from_bytes(self.get_data(index, n), "little") & 0xFF for n in range(1, min(value, 8) + 1)
            )
            if value > 8 or bits > MAX_BITS:
                raise SdoAbortedError(TOO_LONG)
            return
        address, bits = (value >> 16, value >> 8 & 0xFF), value & 0xFF
        found = BY_ADDRESS.get(address)
        needed = "w" if index < 0x1800 else "r"
        if found is None:
            fits = (address, bits, needed) == ((0x1001, 0), 8, "r")
        else:
            fits = bits == 8 * _size(found) and needed in found.access
        if value and not fits:
            raise SdoAbortedError(NOT_MAPPABLE)

    # ------------------------------------------------------------------------------------------------- PDOs

    def _map_pdos(self) -> None:
        """Subscribe to the configured receive PDOs, and store the transmit PDOs."""
        for can_id in self._receive_ids:
            self.network.unsubscribe(can_id)
        before = {each.can_id: each for each in self._sent}
        self._receive_ids, self._status_maps, self._sent = [], [], []
        for number in range(PDOS):
            self._map_receive(0x1400 + number, 0x1600 + number)
            self._map_transmit(0x1800 + number, 0x1A00 + number, before)

    def _map_receive(self, communication: int, mapping: int) -> None:
        can_id, addresses = self._can_id(communication), self._mapped(mapping)
        if can_id is None or not addresses:
            return
        length = sum(_size(BY_ADDRESS[address]) for address in addresses)
        is_synchronous = self._number(communication, 2) in SYNCHRONOUS

        def receive(_: int, data: bytearray, __: float) -> None:
            if self.nmt_state != OPERATIONAL:
                return
            if len(data) < length:
                self.send_emergency(PDO_LENGTH)
            elif is_synchronous:
                self._received[can_id] = addresses, bytes(data)
            else:
                self._take(addresses, bytes(data))

        self._receive_ids.append(can_id)
        self.network.subscribe(can_id, receive)

    def _take(self, addresses: Sequence[Address], data: bytes) -> None:
        """Write the objects of a receive PDO."""
        at = 0
        for index, sub in addresses:
            size = _size(BY_ADDRESS[index, sub])
            try:
                self.set_data(index, sub, data[at : at + size])
            except SdoAbortedError:
                return  # a PDO has no answer; the error is in the drive's log and status
            at += size

    def _map_transmit(self, communication: int, mapping: int, before: dict[int, SentPdo]) -> None:
        can_id, addresses = self._can_id(communication), self._mapped(mapping)
        kind = int.from_bytes(self.get_data(communication, 2), "little")
        if can_id is None or not addresses:
            return
        if (0x2012, 0) in addresses:
            if kind in EVENT_DRIVEN:
                self._status_maps.append((can_id, addresses))
            return
        made = sent_pdo(partial(self._number, communication), can_id, addresses)
        old = before.get(can_id)
        if old is not None and old.addresses == addresses:
            made.data, made.at = old.data, old.at
        self._sent.append(made)

    def _synchronise(self, _: int, __: bytearray, ___: float) -> None:
        """Let synchronous PDOs act that were received before a SYNC, and send those that are due at it."""
        received, self._received = self._received, {}
        if self.nmt_state == OPERATIONAL:
            for addresses, data in received.values():
                self._take(addresses, data)
            for each in self._sent:
                content = self._data_of(each)
                if each.on_sync(content):
                    self._transmit(each, content)

    def _data_of(self, pdo: SentPdo) -> bytes:
        return b"".join(self.get_data(index, sub) for index, sub in pdo.addresses)

    def _transmit(self, pdo: SentPdo, data: bytes) -> None:
        pdo.data, pdo.at = data, self.now
        self.network.send_message(pdo.can_id, data)

    def _number(self, index: int, subindex: int) -> int:
        return int.from_bytes(self.get_data(index, subindex), "little")

    def _can_id(self, communication: int) -> int | None:
        value = self._number(communication, 1)
        return None if value & PDO_INVALID else value & 0x7FF

    def _mapped(self, mapping: int) -> list[tuple[int, int]]:
        count = self.get_data(mapping, 0)[0]
        entries = [int.from_bytes(self.get_data(mapping, n), "little") for n in range(1, count + 1)]
        addresses = [(entry >> 16, entry >> 8 & 0xFF) for entry in entries]
        return [address for address in addresses if address in BY_ADDRESS or address == (0x1001, 0)]


def _add(dictionary: ObjectDictionary, entry: Object) -> None:
    access = {"r": "ro", "w": "wo", "rw": "rw"}[entry.access]
    variable = _variable(entry.name, entry.index, entry.sub, KINDS[entry.kind], access, None, mappable=True)
    if entry.sub == 0:
        dictionary.add_object(variable)
        return
    if entry.index not in dictionary:
        made = ODRecord(entry.name.rsplit(" ", 1)[0], entry.index)
        made.add_member(_variable("Highest sub-index", entry.index, 0, datatypes.UNSIGNED8, "ro", None))
        dictionary.add_object(made)
    record = dictionary[entry.index]
    assert isinstance(record, ODRecord)
    record[0].default = entry.sub
    record.add_member(variable)


def _add_identity(dictionary: ObjectDictionary, node_id: int) -> None:
    record = ODRecord("Identity object", 0x1018)
    record.add_member(_variable("Highest sub-index", 0x1018, 0, datatypes.UNSIGNED8, "ro", 4))
    for sub, name, value in (
        (1, "Vendor ID", 0),
        (2, "Product code", 0),
        (3, "Revision number", 0x00010000),
        (4, "Serial number", node_id),
    ):
        record.add_member(_variable(name, 0x1018, sub, datatypes.UNSIGNED32, "ro", value))
    dictionary.add_object(record)


def _add_pdo(
    dictionary: ObjectDictionary,
    communication: int,
    mapping: int,
    direction: str,
    can_id: int,
    default: tuple[tuple[int, int], ...],
) -> None:
    """Add one PDO with its default mapping; enable only the first of each direction."""
    record = ODRecord(f"{direction} PDO {(communication & 0xFF) + 1} communication", communication)
    sends = communication >= 0x1800
    on = communication & 0xFF == 0
    for sub, name, kind, value in (
        (0, "Highest sub-index", datatypes.UNSIGNED8, 5 if sends else 2),
        (1, "COB-ID", datatypes.UNSIGNED32, can_id if on else PDO_INVALID | can_id),
        (2, "Transmission type", datatypes.UNSIGNED8, 255),
        (3, "Inhibit time", datatypes.UNSIGNED16, 0),
        (5, "Event timer", datatypes.UNSIGNED16, STATUS_PERIOD if on else 0),
    ):
        if sends or sub < 3:
            access = "ro" if sub == 0 else "rw"
            record.add_member(_variable(name, communication, sub, kind, access, value))
    dictionary.add_object(record)
    record = ODRecord(f"{direction} PDO {(mapping & 0xFF) + 1} mapping", mapping)
    record.add_member(_variable("Number of objects", mapping, 0, datatypes.UNSIGNED8, "rw", len(default)))
    for sub in range(1, 9):
        value = entry(*default[sub - 1]) if sub <= len(default) else 0
        record.add_member(_variable(f"Object {sub}", mapping, sub, datatypes.UNSIGNED32, "rw", value))
    dictionary.add_object(record)


def _variable(
    name: str, index: int, sub: int, kind: int, access: str, default: Any, mappable: bool = False
) -> ODVariable:
    variable = ODVariable(name, index, sub)
    variable.data_type, variable.access_type, variable.default = kind, access, default
    variable.pdo_mappable = mappable
    return variable


def _size(entry: Object) -> int:
    return 8 if entry.kind == "bytes8" else int(entry.kind[1:]) // 8
