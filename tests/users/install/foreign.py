"""usage: foreign.py FILE: writes a small MCAP file, in the form in which other programs write it,
without using packages."""

import struct
import sys


def text(value: bytes) -> bytes:
    return struct.pack("<I", len(value)) + value


def record(code: int, content: bytes) -> bytes:
    return struct.pack("<BQ", code, len(content)) + content


MAGIC = b"\x89MCAP0\r\n"
SCHEMA = struct.pack("<H", 1) + text(b"Speed") + text(b"jsonschema") + text(b"{}")
CHANNEL = struct.pack("<HH", 1, 1) + text(b"/wheel") + text(b"json") + text(b"")

with open(sys.argv[1], "wb") as file:
    file.write(MAGIC + record(1, text(b"") + text(b"test")))
    file.write(record(3, SCHEMA) + record(4, CHANNEL))
    for number in range(3):
        time = 10**18 + number * 10**8
        content = b'{"speed": %d.5, "on": true}' % number
        file.write(record(5, struct.pack("<HIQQ", 1, number, time, time) + content))
    file.write(record(15, struct.pack("<I", 0)) + record(2, struct.pack("<QQI", 0, 0, 0)) + MAGIC)
