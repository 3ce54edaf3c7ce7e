"""`python3 -m frob.bag_command BAG PROGRAM OUT.csv`: extracts the recording of a program from a ROS 2
bag, for `frobc trace` and `frobc view`.

A bag is a rosbag2 folder, or one of the files in it (.db3 or .mcap). A program that runs as a ROS 2
node publishes its instants: the topic `NODE/columns` contains the beginning of its recording, and
the topic `NODE/instants` contains a number and a row for each instant. Files in MCAP format require
the package mcap."""

from __future__ import annotations

import os
import re
import sqlite3
import struct
import sys
from typing import Dict, Iterator, List, NamedTuple, Tuple

TEXT = "std_msgs/msg/String"


class Unreadable(Exception):
    pass


class Message(NamedTuple):
    topic: str
    data: bytes


def text_of(data: bytes) -> str:
    """Returns the text in a serialized std_msgs/msg/String."""
    if len(data) < 8:
        raise Unreadable("a message from the program is damaged")
    order = "<" if data[1] & 1 else ">"
    (length,) = struct.unpack_from(order + "I", data, 4)
    if length < 1 or 8 + length > len(data):
        raise Unreadable("a message from the program is damaged")
    return data[8 : 8 + length - 1].decode("utf-8", errors="replace")


def in_sqlite(path: str) -> Iterator[Message]:
    """Yields the messages of programs in a .db3 file."""
    database = sqlite3.connect(f"file:{path}?mode=ro", uri=True)
    try:
        query = (
            "SELECT topics.name, messages.data FROM messages JOIN topics"
            " ON topics.id = messages.topic_id WHERE topics.type = ?"
            " AND (topics.name LIKE '%/columns' OR topics.name LIKE '%/instants')"
            " ORDER BY messages.timestamp, messages.id"
        )
        for topic, data in database.execute(query, (TEXT,)):
            yield Message(topic, bytes(data))
    finally:
        database.close()


def in_mcap(path: str) -> Iterator[Message]:
    """Yields the messages of programs in an MCAP file."""
    try:
        from mcap.exceptions import McapError
        from mcap.reader import make_reader
    except ImportError:
        raise Unreadable(
            "reading MCAP requires a Python package: run `frobc extras install ros`"
        ) from None
    try:
        with open(path, "rb") as file:
            for schema, channel, message in make_reader(file).iter_messages():
                if (
                    schema is not None
                    and schema.name == TEXT
                    and channel.topic.endswith(("/columns", "/instants"))
                ):
                    yield Message(channel.topic, message.data)
    except McapError as error:
        raise Unreadable(f"{os.path.basename(path)} is damaged: {error}") from None


def files_of(bag: str) -> List[str]:
    """Returns the files of a bag, in order."""
    if bag.endswith(".zstd"):
        raise Unreadable("it is compressed: run `zstd -d` on it")
    if not os.path.isdir(bag):
        return [bag]
    names = [name for name in os.listdir(bag) if name.endswith((".db3", ".mcap"))]
    if not names:
        zipped = any(name.endswith(".zstd") for name in os.listdir(bag))
        raise Unreadable(
            "its files are compressed: run `zstd -d` on them"
            if zipped
            else "the folder has no .db3 or .mcap files, so it is not a bag"
        )

    def key(name: str) -> List[Tuple[int, str]]:
        return [(int(part or -1), rest) for part, rest in re.findall(r"(\d*)(\D*)", name)]

    return [os.path.join(bag, name) for name in sorted(names, key=key)]


def messages_of(bag: str) -> Iterator[Message]:
    for path in files_of(bag):
        yield from in_mcap(path) if path.endswith(".mcap") else in_sqlite(path)


def program_of(columns: str) -> str:
    """Returns the name of the program, given the lines at the beginning of its recording."""
    first = columns.split("\n", 1)[0]
    return first[len("# program ") :] if first.startswith("# program ") else ""


def recordings_in(bag: str) -> Dict[str, Tuple[str, Dict[int, str]]]:
    """Returns, for each node, the beginning of its recording, and the recording's rows by
    number."""
    heads: Dict[str, str] = {}
    rows: Dict[str, Dict[int, str]] = {}
    for topic, data in messages_of(bag):
        node, kind = topic.rsplit("/", 1)
        text = text_of(data)
        if kind == "columns" and text.startswith("# program "):
            if heads.get(node, text) != text:
                raise Unreadable(
                    f"it has several runs of {node}: record each run in a separate bag"
                )
            heads[node] = text
        elif kind == "instants":
            number, _, row = text.partition(" ")
            if number.isdigit():
                known = rows.setdefault(node, {})
                if known.setdefault(int(number), row) != row:
                    raise Unreadable(
                        f"it has several runs of {node}: record each run in a separate bag"
                    )
    return {node: (head, rows.get(node, {})) for node, head in heads.items()}


def recording_of(bag: str, program: str) -> str:
    """Returns the recording of the program."""
    found = recordings_in(bag)
    nodes = sorted(node for node, (head, _) in found.items() if program_of(head) == program)
    if not nodes:
        others = sorted({program_of(head) for head, _ in found.values()})
        raise Unreadable(
            f"it has no instants of the program {program}, only of {', '.join(others)}"
            if others
            else "it contains no recording of a program: record the topics NODE/columns and"
            " NODE/instants"
        )
    if len(nodes) > 1:
        raise Unreadable(f"{program} ran as several nodes: {', '.join(nodes)}")
    head, rows = found[nodes[0]]
    if 0 not in rows:
        first = min(rows, default=0)
        raise Unreadable(
            f"it lacks the first {first} instants of {nodes[0]}, so it cannot be replayed:"
            " start `ros2 bag record` before the program"
            if rows
            else f"it has no instants of {nodes[0]}"
        )
    count = next(n for n in range(len(rows) + 1) if n not in rows)
    if count < len(rows):
        print(
            f"warning: the bag lacks instants of {nodes[0]} from number {count} on;"
            " the replay ends before them",
            file=sys.stderr,
        )
    return head + "".join(rows[number] for number in range(count))


def main() -> int:
    bag, program, path = sys.argv[1:4]
    try:
        recording = recording_of(bag, program)
        with open(path, "w", encoding="utf-8", newline="\n") as file:
            file.write(recording)
    except (Unreadable, OSError, sqlite3.Error) as error:
        print(str(error) or type(error).__name__, file=sys.stderr)
        return 2
    return 0


if __name__ == "__main__":
    sys.exit(main())
