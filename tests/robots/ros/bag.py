"""Writes a bag as rosbag2 does: a folder with metadata.yaml and a .db3 file.

usage: bag.py FAKE BAG NODE [FIRST [LAST]] : from the files FAKE.columns and FAKE.instants of the
fake ROS 2, with the instants from FIRST to LAST.
"""

import os
import sqlite3
import struct
import sys


def serialized(text):
    """A std_msgs/msg/String in CDR."""
    data = text.encode() + b"\0"
    return b"\0\1\0\0" + struct.pack("<I", len(data)) + data


def main():
    fake, bag, node = sys.argv[1:4]
    first = int(sys.argv[4]) if len(sys.argv) > 4 else 0
    last = int(sys.argv[5]) if len(sys.argv) > 5 else 10**9
    os.makedirs(bag, exist_ok=True)
    with open(os.path.join(bag, "metadata.yaml"), "w", encoding="utf-8") as file:
        print("rosbag2_bagfile_information:\n  storage_identifier: sqlite3", file=file)
    database = sqlite3.connect(os.path.join(bag, "bag_0.db3"))
    database.executescript(
        "CREATE TABLE IF NOT EXISTS topics(id INTEGER PRIMARY KEY, name TEXT NOT NULL,"
        " type TEXT NOT NULL, serialization_format TEXT NOT NULL,"
        " offered_qos_profiles TEXT NOT NULL);"
        "CREATE TABLE IF NOT EXISTS messages(id INTEGER PRIMARY KEY, topic_id INTEGER NOT NULL,"
        " timestamp INTEGER NOT NULL, data BLOB NOT NULL);"
    )
    for kind in ["columns", "instants"]:
        topic = database.execute(
            "INSERT INTO topics(name, type, serialization_format, offered_qos_profiles)"
            " VALUES(?, 'std_msgs/msg/String', 'cdr', '')",
            (f"{node}/{kind}",),
        ).lastrowid
        with open(f"{fake}.{kind}", encoding="utf-8") as file:
            texts = file.read().split("\0")[:-1]
        for number, text in enumerate(texts):
            if kind == "columns" or first <= number <= last:
                database.execute(
                    "INSERT INTO messages(topic_id, timestamp, data) VALUES(?, ?, ?)",
                    (topic, number, serialized(text)),
                )
    database.commit()


main()
