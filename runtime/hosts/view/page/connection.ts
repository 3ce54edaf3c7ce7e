// The WebSocket to the viewer: the token first, then requests.
import type { Answer, Picture } from "./protocol";

/** JSON, a line feed, and pixels of one or three bytes. */
function readPicture(message: ArrayBuffer): Picture {
  const bytes = new Uint8Array(message),
    feed = bytes.indexOf(10);
  const picture = JSON.parse(new TextDecoder().decode(bytes.subarray(0, feed))) as Picture;
  const { columns, rows, grey } = picture;
  if (!columns || !rows) return picture;
  const data = new Uint8ClampedArray(4 * columns * rows).fill(255);
  const step = grey ? 1 : 3;
  for (let from = feed + 1, to = 0; to < data.length; from += step, to += 4)
    for (let i = 0; i < 3; i++) data[to + i] = bytes[grey ? from : from + i] ?? 0;
  return { ...picture, data };
}

export class Connection {
  private readonly socket: WebSocket;

  constructor(answered: (answer: Answer) => void, closed: (why: string) => void) {
    this.socket = new WebSocket(`ws://${location.host}/`, "frob-view");
    this.socket.binaryType = "arraybuffer";
    this.socket.onopen = () => this.ask(`hello ${location.hash.slice(1)}`);
    this.socket.onmessage = ({ data }: MessageEvent<string | ArrayBuffer>) =>
      answered(typeof data === "string" ? (JSON.parse(data) as Answer) : readPicture(data));
    this.socket.onclose = (event) => closed(event.reason || "the viewer has ended");
  }

  ask(request: string): void {
    if (this.socket.readyState === WebSocket.OPEN) this.socket.send(request);
  }
}
