// usage: node read.mjs FILE.mcap: reads the file with @mcap/core, by its index and as a stream.
import { open, readFile } from "node:fs/promises";
import { McapIndexedReader, McapStreamReader } from "@mcap/core";

const path = process.argv[2];
const file = await open(path);
const readable = {
  size: async () => BigInt((await file.stat()).size),
  read: async (offset, length) => {
    const bytes = new Uint8Array(Number(length));
    await file.read(bytes, 0, bytes.length, Number(offset));
    return bytes;
  },
};
const reader = await McapIndexedReader.Initialize({ readable });
const counts = new Map();
for await (const message of reader.readMessages({ validateCrcs: true })) {
  const channel = reader.channelsById.get(message.channelId);
  JSON.parse(new TextDecoder().decode(message.data));
  counts.set(channel.topic, (counts.get(channel.topic) ?? 0) + 1);
}
await file.close();

const stream = new McapStreamReader({ validateCrcs: true });
stream.append(await readFile(path));
let messages = 0;
for (let record; (record = stream.nextRecord()); ) {
  messages += record.type === "Message" ? 1 : 0;
}
const total = [...counts.values()].reduce((sum, n) => sum + n, 0);
if (!stream.done() || total !== messages || BigInt(total) !== reader.statistics.messageCount) {
  throw new Error(`${total} messages by the index, ${messages} without it`);
}
console.log(`ok   ${path}: ${total} messages on ${counts.size} topics, by @mcap/core`);
