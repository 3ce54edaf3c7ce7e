// The WebSocket connection to the viewer. Its address contains the token. The page reconnects
// whenever the connection is closed. A question waits for its answer, across several connections if
// necessary; a command is sent immediately or not at all.
import { token } from "./address";
import type { Answer, Picture } from "./protocol";

/** Parses a message that consists of JSON, a line feed, and pixels of one or three bytes each. */
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

/** Maps the first word of a question to the name of its answer, if the names differ. */
const answerOf: Readonly<Record<string, string>> = {
  time: "instant",
  cells: "instant",
  find: "found",
  drive: "what-if",
  with: "what-if",
};
/** Maximum number of unanswered questions that the page has sent. The viewer accepts fewer than 64
 * pending questions from a page. */
const mostSent = 32;
/** Delays before reconnecting, in ms. */
const soon = 250,
  later = 1000;
/** The close code that the viewer sends for a wrong token, for example the token of a viewer that
 *  used this port before. */
const refusal = 1008;

interface Question {
  readonly text: string;
  readonly kind: string;
}

export interface Listener {
  /** `question` is the text of the question that was answered; empty if the message is not an
   * answer. */
  answered(answer: Answer, question: string): void;
  /** The connection was closed, and `why` is the reason. If `final` is true, the page does not
   * reconnect. */
  closed(why: string, final: boolean): void;
}

/** A source of answers: a viewer or the data in a saved page. */
export interface Link {
  readonly isOpen: boolean;
  ask(text: string): void;
  more(): void;
  command(text: string): boolean;
}

export class Connection implements Link {
  private socket: WebSocket | null = null;
  /** Unanswered questions, oldest first. The first `sent` of them were sent on this connection. */
  private readonly questions: Question[] = [];
  private sent = 0;
  private delay = soon;
  /** The time in the viewer's last heartbeat. */
  private time = "";

  constructor(private readonly listener: Listener) {
    this.open();
  }

  get isOpen(): boolean {
    return this.socket?.readyState === WebSocket.OPEN;
  }

  private open(): void {
    const socket = new WebSocket(
      `ws://${location.host}/?${encodeURIComponent(token())}`,
      "frob-view",
    );
    socket.binaryType = "arraybuffer";
    socket.onmessage = ({ data }: MessageEvent<string | ArrayBuffer>) =>
      this.received(typeof data === "string" ? (JSON.parse(data) as Answer) : readPicture(data));
    socket.onopen = () => this.send();
    socket.onclose = ({ code, reason }) => {
      const isFinal = code === refusal;
      this.socket = null;
      this.sent = 0;
      if (!isFinal) setTimeout(() => this.open(), this.delay);
      this.delay = Math.min(2 * this.delay, later);
      this.listener.closed(reason, isFinal);
    };
    this.socket = socket;
  }

  private received(answer: Answer): void {
    const isAnswer =
      answer.is === "refused"
        ? !answer.command
        : this.questions.some(({ kind }) => kind === answer.is);
    if (answer.is === "beat") this.time = String(answer.time);
    this.delay = soon;
    let question = "";
    if (isAnswer && this.sent > 0) {
      const at =
        answer.is === "refused" ? 0 : this.questions.findIndex(({ kind }) => kind === answer.is);
      [{ text: question } = { text: "" }] = this.questions.splice(at, 1);
      this.sent--;
      this.send();
    }
    this.listener.answered(answer, question);
  }

  private send(): void {
    while (this.isOpen && this.sent < Math.min(mostSent, this.questions.length)) {
      this.socket?.send(this.questions[this.sent]?.text ?? "");
      this.sent++;
    }
  }

  ask(text: string): void {
    const word = text.split(" ", 1)[0] ?? "";
    const isWaiting = this.questions.slice(this.sent).some((question) => question.text === text);
    if (!isWaiting) this.questions.push({ text, kind: answerOf[word] ?? word });
    this.send();
  }

  /** Tells the viewer that the page has drawn the new data and is ready for more. */
  more(): void {
    if (this.isOpen) this.socket?.send("more");
  }

  /** If the command cannot be sent now, returns false and never sends it. */
  command(text: string): boolean {
    if (!this.isOpen) return false;
    // A stop has no timestamp, because the viewer must never reject it as too old.
    this.socket?.send(text === "stop" ? text : `at ${this.time || 0} ${text}`);
    return true;
  }
}
