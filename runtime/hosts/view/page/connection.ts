// The WebSocket to the viewer: the token first, then requests.
import type { Answer } from "./protocol";

export class Connection {
  private readonly socket: WebSocket;

  constructor(answered: (answer: Answer) => void, closed: (why: string) => void) {
    this.socket = new WebSocket(`ws://${location.host}/`, "frob-view");
    this.socket.onopen = () => this.ask(`hello ${location.hash.slice(1)}`);
    this.socket.onmessage = (event: MessageEvent<string>) =>
      answered(JSON.parse(event.data) as Answer);
    this.socket.onclose = (event) => closed(event.reason || "the viewer has ended");
  }

  ask(request: string): void {
    if (this.socket.readyState === WebSocket.OPEN) this.socket.send(request);
  }
}
