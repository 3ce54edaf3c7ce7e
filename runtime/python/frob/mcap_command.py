"""`python3 -m frob.mcap_command IN.mcap OUT.csv`: reads an MCAP file that another program wrote,
for `frobc convert`. Uses the package mcap, and mcap_ros2 for the messages of ROS 2."""

from __future__ import annotations

import json
import sys
from importlib.util import find_spec
from typing import Any, Dict, Iterator, List, Tuple

LONGEST = 64
"""Lists longer than this, such as images and maps, are omitted."""


class Unreadable(Exception):
    pass


def leaves(name: str, value: Any) -> Iterator[Tuple[str, str]]:
    """Yields the numbers and booleans of a message, with the names of their columns."""
    if isinstance(value, bool):
        yield name, "true" if value else "false"
    elif isinstance(value, (int, float)):
        yield name, repr(value)
    elif isinstance(value, dict):
        for key, part in value.items():
            yield from leaves(f"{name}.{key}", part)
    elif isinstance(value, (list, tuple)) and len(value) <= LONGEST:
        for number, part in enumerate(value):
            yield from leaves(f"{name}.{number}", part)
    elif hasattr(value, "__slots__"):
        for key in value.__slots__:
            yield from leaves(f"{name}.{key.lstrip('_')}", getattr(value, key))


def topic_name(topic: str) -> str:
    name = topic.strip("/").replace("/", ".")
    return "".join(c if c.isalnum() or c in "._-" else "_" for c in name) or "message"


def decoded(schema: Any, channel: Any, message: Any, ros: Any, skipped: Dict[str, str]) -> Any:
    """The content of a message; None if its encoding is not supported."""
    if channel.message_encoding == "json":
        return json.loads(message.data)
    if channel.message_encoding == "cdr" and ros is not None:
        decoder = ros.decoder_for(channel.message_encoding, schema)
        if decoder is not None:
            return decoder(message.data)
    skipped[channel.topic] = channel.message_encoding
    return None


def rows(reader: Any) -> Tuple[List[str], List[Tuple[int, Dict[str, str]]], Dict[str, str]]:
    """Returns the columns, in the order in which they first occur; for each message timestamp, the
    cells that change; and the skipped topics, with their encodings."""
    ros = None
    if find_spec("mcap_ros2") is not None:
        from mcap_ros2.decoder import DecoderFactory

        ros = DecoderFactory()
    columns: Dict[str, None] = {}
    changes: List[Tuple[int, Dict[str, str]]] = []
    skipped: Dict[str, str] = {}
    for schema, channel, message in reader.iter_messages():
        content = decoded(schema, channel, message, ros, skipped)
        cells = dict(leaves(topic_name(channel.topic), content))
        if not cells:
            continue
        columns.update(dict.fromkeys(cells))
        if changes and changes[-1][0] == message.log_time:
            changes[-1][1].update(cells)
        else:
            changes.append((message.log_time, cells))
    return list(columns), changes, skipped


def write(reader: Any, path: str) -> None:
    for attachment in reader.iter_attachments():
        if attachment.name.endswith(".csv"):
            with open(path, "wb") as file:
                file.write(attachment.data)
            return
    columns, changes, skipped = rows(reader)
    for topic, encoding in skipped.items():
        hint = ": run `frobc extras install ros`" if encoding == "cdr" else ""
        print(f"warning: skipped {topic}, whose encoding is {encoding}{hint}", file=sys.stderr)
    held: Dict[str, str] = {}
    start = None
    with open(path, "w", encoding="utf-8", newline="\n") as file:
        print("time", *columns, sep=",", file=file)
        for time, cells in changes:
            held.update(cells)
            if len(held) < len(columns):
                continue
            start = time if start is None else start
            seconds, rest = divmod(time - start, 10**9)
            print(f"{seconds}.{rest:09}", *(held[name] for name in columns), sep=",", file=file)
    if start is None:
        raise Unreadable("it contains no readable messages with numbers")


def main() -> int:
    source, path = sys.argv[1:3]
    try:
        from mcap.exceptions import McapError
        from mcap.reader import make_reader
    except ImportError:
        print("reading it needs Python packages: run `frobc extras install mcap`", file=sys.stderr)
        return 2
    try:
        with open(source, "rb") as file:
            write(make_reader(file), path)
    except (Unreadable, McapError, OSError, ValueError) as error:
        print(str(error) or type(error).__name__, file=sys.stderr)
        return 2
    return 0


if __name__ == "__main__":
    sys.exit(main())
