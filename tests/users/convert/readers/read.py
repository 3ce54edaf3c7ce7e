"""usage: read.py FILE.mcap RUN.csv: reads the file with the package mcap, checks each message
against its schema, and compares it with the recording."""

import csv
import json
import sys

import jsonschema
from mcap.reader import NonSeekingReader, make_reader

path, recording = sys.argv[1:]
with open(recording, newline="") as file:
    rows = list(csv.DictReader(line for line in file if not line.startswith("#")))


def nanoseconds(text):
    seconds, _, decimals = text.partition(".")
    return int(seconds) * 10**9 + int(decimals)


def listed(reader):
    checks = {}
    topics = {}
    for schema, channel, message in reader.iter_messages():
        if schema.id not in checks:
            checks[schema.id] = jsonschema.Draft202012Validator(json.loads(schema.data))
        value = json.loads(message.data)
        checks[schema.id].validate(value)
        topics.setdefault(channel.topic, (schema.name, []))[1].append((message.log_time, value))
    return topics


with open(path, "rb") as file:
    reader = make_reader(file, validate_crcs=True)
    statistics = reader.get_summary().statistics
    topics = listed(reader)
    (attachment,) = reader.iter_attachments()
with open(path, "rb") as file:
    assert listed(NonSeekingReader(file, validate_crcs=True)) == topics, "without the index"
with open(recording, "rb") as file:
    assert attachment.data == file.read(), "the recording in it is another"
assert statistics.message_count == sum(len(messages) for _, messages in topics.values())

name, messages = topics["/in"]
assert [time for time, _ in messages] == [nanoseconds(row["time"]) for row in rows]
for (_, value), row in zip(messages, rows):
    assert value["odometry"]["position"]["x"] == float(row["in.odometry.position.x"])
    echoes = {k: float(row[f"in.sonar[{k}]"]) for k in range(16) if row[f"in.sonar[{k}]"]}
    assert {int(k): x for k, x in value["sonar"].items()} == echoes
name, poses = topics["/pose/in.odometry"]
assert name == "foxglove.PoseInFrame" and len(poses) == len(rows)
assert topics["/tf"][0] == "foxglove.FrameTransform"
assert topics["/ranges"][0] == "foxglove.SceneUpdate"
frames = sum("Image" in (row.get("in.console.camera") or "") for row in rows)
images = topics.get("/image/in.console.camera", ("foxglove.RawImage", []))
assert images[0] == "foxglove.RawImage" and len(images[1]) == frames
print(f"ok   {path}: {statistics.message_count} messages, {frames} images, by Python's mcap")
