"""usage: structure.py FILE.mcap: reads MCAP according to its specification, and checks everything
redundant in it: lengths, checksums, the index of each chunk, the summary and its offsets, the
counts. Then prints, for each topic, its schema, the number of its messages, and the first message.
"""

import json
import struct
import sys
import zlib

MAGIC = b"\x89MCAP0\r\n"
NAMES = {
    1: "Header",
    2: "Footer",
    3: "Schema",
    4: "Channel",
    5: "Message",
    6: "Chunk",
    7: "MessageIndex",
    8: "ChunkIndex",
    9: "Attachment",
    10: "AttachmentIndex",
    11: "Statistics",
    12: "Metadata",
    13: "MetadataIndex",
    14: "SummaryOffset",
    15: "DataEnd",
}
FIELDS = {
    "Header": "ss",
    "Footer": "QQI",
    "Schema": "Hsss",
    "Channel": "HHssm",
    "Chunk": "QQQIsL",
    "MessageIndex": "Hi",
    "ChunkIndex": "QQQQnQsQQ",
    "Attachment": "QQssLI",
    "AttachmentIndex": "QQQQQss",
    "Statistics": "QHIIIIQQn",
    "Metadata": "sm",
    "MetadataIndex": "QQs",
    "SummaryOffset": "BQQ",
    "DataEnd": "I",
}


class Reader:
    def __init__(self, data, at=0):
        self.data, self.at = data, at

    def take(self, n):
        assert self.at + n <= len(self.data), "a record ends too early"
        self.at += n
        return self.data[self.at - n : self.at]

    def number(self, code):
        return struct.unpack("<" + code, self.take(struct.calcsize("<" + code)))[0]

    def field(self, code):
        if code in "BHIQ":
            return self.number(code)
        part = self.take(self.number("Q" if code == "L" else "I"))
        if code in "sL":
            return part
        inner, pairs = Reader(part), []
        kinds = {"m": "ss", "n": "HQ", "i": "QQ"}[code]
        while inner.at < len(part):
            pairs.append((inner.field(kinds[0]), inner.field(kinds[1])))
        return pairs if code == "i" else dict(pairs)

    def record(self):
        start = self.at
        name, length = NAMES[self.number("B")], self.number("Q")
        content = Reader(self.take(length))
        if name == "Message":
            fields = [content.number(code) for code in "HIQQ"] + [content.data[content.at :]]
        else:
            fields = [content.field(code) for code in FIELDS[name]]
            assert content.at == length, f"{name} is longer than its fields"
        return name, start, self.at - start, fields

    def records(self, end):
        while self.at < end:
            yield self.record()
        assert self.at == end


def same(what, found, stated):
    assert found == stated, f"{what}: {found}, and not {stated}"


def read(data):
    same("magic", (data[:8], data[-8:]), (MAGIC, MAGIC))
    footer_at = len(data) - 8 - 29
    _, _, _, (summary, offsets, summary_crc) = Reader(data, footer_at).record()
    same("summary's CRC", zlib.crc32(data[summary : len(data) - 12]), summary_crc)

    schemas, channels, messages, chunks, attached, meta = {}, {}, [], {}, {}, {}
    definitions = {"Schema": [], "Channel": []}
    chunk = None
    records = list(Reader(data, 8).records(summary))
    same("first and last", (records[0][0], records[-1][0]), ("Header", "DataEnd"))
    same("who wrote it", records[0][3], [b"", b"frobc"])
    same("data's CRC", zlib.crc32(data[: records[-1][1]]), records[-1][3][0])
    for name, at, length, fields in records[1:-1]:
        if name == "Chunk":
            first, last, size, crc, compression, inside = fields
            same(
                "chunk's size, CRC, compression",
                (len(inside), zlib.crc32(inside), b""),
                (size, crc, compression),
            )
            found = {}
            for inner, inner_at, _, parts in Reader(inside).records(len(inside)):
                if inner == "Message":
                    channel, sequence, time, published, text = parts
                    assert channel in channels, "a message before its channel"
                    same("times", published, time)
                    found.setdefault(channel, []).append((time, inner_at))
                    messages.append((channel, sequence, time, text))
                else:
                    known = schemas if inner == "Schema" else channels
                    assert parts[0] not in known, f"two of {inner} {parts[0]}"
                    assert inner == "Schema" or parts[1] in schemas, "a channel before its schema"
                    known[parts[0]] = parts
                    definitions[inner].append(parts)
            times = [time for index in found.values() for time, _ in index]
            same("times", (min(times), max(times)), (first, last))
            chunk = chunks[at] = [first, last, at, length, {}, 0, b"", size, size]
        elif name == "MessageIndex":
            channel, index = fields
            same("index", index, found.pop(channel))
            chunk[4][channel] = at
            chunk[5] += length
        else:
            assert not chunks, f"{name} after chunks"
            if name == "Attachment":
                crc = zlib.crc32(data[at + 9 : at + length - 4])
                same("attachment's CRC", crc, fields[5])
                attached[at] = [at, length, *fields[:2], len(fields[4]), *fields[2:4]]
            else:
                same("kind", name, "Metadata")
                meta[at] = [at, length, fields[0]]
                print(
                    "metadata",
                    fields[0].decode(),
                    {k.decode(): v.decode() for k, v in fields[1].items()},
                )
    same("indexes that are missing", found, {})
    for channel in channels:
        numbers = [sequence for other, sequence, _, _ in messages if other == channel]
        same("sequence", numbers, list(range(len(numbers))))

    times = [time for _, _, time, _ in messages]
    counts = {c: sum(other == c for other, *_ in messages) for c in channels}
    expected = {
        "Schema": definitions["Schema"],
        "Channel": definitions["Channel"],
        "Statistics": [
            [
                len(messages),
                len(schemas),
                len(channels),
                len(attached),
                len(meta),
                len(chunks),
                min(times),
                max(times),
                counts,
            ]
        ],
        "ChunkIndex": list(chunks.values()),
        "AttachmentIndex": list(attached.values()),
        "MetadataIndex": list(meta.values()),
    }
    groups = {}
    for name, at, length, fields in Reader(data, summary).records(offsets):
        groups.setdefault(name, [at, 0, []])
        groups[name][1] = at + length
        groups[name][2].append(fields)
    same(
        "summary",
        {name: group[2] for name, group in groups.items()},
        {name: fields for name, fields in expected.items() if fields},
    )
    stated = [fields for *_, fields in Reader(data, offsets).records(footer_at)]
    codes = {name: code for code, name in NAMES.items()}
    same("offsets", stated, [[codes[n], g[0], g[1] - g[0]] for n, g in groups.items()])
    return schemas, channels, messages, len(chunks)


def main(path):
    with open(path, "rb") as file:
        schemas, channels, messages, chunks = read(file.read())
    print(f"{len(messages)} messages in {chunks} chunk{'s' if chunks > 1 else ''}")
    for number, (_, schema, topic, encoding, _) in channels.items():
        _, name, form, text = schemas[schema]
        same("encodings", (encoding, form), (b"json", b"jsonschema"))
        json.loads(text)
        own = [json.loads(text) for channel, *_, text in messages if channel == number]
        print(topic.decode(), name.decode(), len(own))
        shown = json.dumps(own[0])
        print("   ", shown if len(shown) < 400 else shown[:400] + "…")


main(sys.argv[1])
