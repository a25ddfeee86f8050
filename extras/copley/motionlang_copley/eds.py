"""The EDS file of the simulated drive, for the configuration tools of masters.

The text depends only on the dictionary: its date is fixed, so one version always writes the same bytes.
"""

from __future__ import annotations

import warnings
from io import StringIO
from typing import Any

from canopen.objectdictionary import ODVariable
from canopen.objectdictionary.eds import export_eds

from motionlang.kernel.version import __version__
from motionlang_copley.drive import Drive
from motionlang_copley.node import EMCY_ID, HARDWARE, NAME, object_dictionary
from motionlang_copley.objects import ObjectServer
from motionlang_copley.pdo import ID_STEP, PDO_INVALID, PDOS, RECEIVE_ID, SEND_ID

_DATE, _TIME = "01-01-2026", "12:00AM"


def eds() -> str:
    """Return the EDS of one drive; identifiers are relative to the node number."""
    dictionary: Any = object_dictionary()  # the library types records and variables alike
    information = dictionary.device_information
    information.vendor_name, information.vendor_number = "motionlang", 0
    information.product_name, information.product_number = NAME, 0
    information.revision_number, information.order_code = 0x00010000, HARDWARE
    information.simple_boot_up_slave, information.simple_boot_up_master = True, False
    information.granularity, information.LSS_supported = 8, False
    information.nr_of_RXPDO = information.nr_of_TXPDO = PDOS
    information.allowed_baudrates = {125_000, 250_000, 500_000, 1_000_000}
    dictionary.comments = f"Simulated drive of motionlang {__version__}"
    dictionary[0x1014].default_raw = f"$NODEID+0x{EMCY_ID:X}"
    for first, base in ((0x1400, RECEIVE_ID), (0x1800, SEND_ID)):
        for number in range(PDOS):
            can_id = base + number * ID_STEP | (PDO_INVALID if number else 0)
            dictionary[first + number][1].default_raw = f"$NODEID+0x{can_id:X}"
    for (index, sub), value in ObjectServer(Drive()).values.items():
        found = dictionary[index]
        variable: Any = found if isinstance(found, ODVariable) else found[sub]
        variable.default = value
        if value < 0:
            variable.default_raw = str(value)  # the library would write 0x-3
    text = StringIO()
    info = {
        "FileName": "drive.eds",
        "FileVersion": 1,
        "FileRevision": 1,
        "EdsVersion": "4.0",  # spelt as in the library, which otherwise adds a second one
        "Description": NAME,
        "CreatedBy": "motionlang",
        "ModifiedBy": "motionlang",
        "CreationDate": _DATE,
        "CreationTime": _TIME,
        "ModificationDate": _DATE,
        "ModificationTime": _TIME,
    }
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", DeprecationWarning)  # the library asks for the date in an old way
        export_eds(dictionary, text, info)  # type: ignore[no-untyped-call]
    return text.getvalue()
