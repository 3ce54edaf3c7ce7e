// Requests for the points of plots. Each requester, such as a plot, has at most one pending
// request for a signal, so that a page with many plots does not request more than it can draw.
import type { Series } from "../protocol";

export interface SeriesWanted {
  readonly signal: number;
  readonly from: number;
  readonly to: number;
  /** Width of the plot in pixels: the number of columns. */
  readonly width: number;
}

interface Request {
  readonly wanted: SeriesWanted;
  readonly then: (series: Series) => void;
}

interface Slot extends Request {
  /** The next request, which is sent when this one has been answered or refused. */
  next: Request | null;
}

export class SeriesRequests {
  private readonly slots = new Map<string, Slot>();

  constructor(private readonly ask: (question: string) => void) {}

  /** If several requests are made while one is pending, only the last one is sent, and the others
   * get no answer. */
  request(user: string, wanted: SeriesWanted, then: (series: Series) => void): void {
    const key = `${user} ${wanted.signal}`;
    const slot = this.slots.get(key);
    if (slot) slot.next = { wanted, then };
    else this.send(key, { wanted, then });
  }

  /** Whether this requester has a pending request for the signal. */
  awaits(user: string, signal: number): boolean {
    return this.slots.has(`${user} ${signal}`);
  }

  private send(key: string, { wanted, then }: Request): void {
    const { signal, from, to, width } = wanted;
    this.slots.set(key, { wanted, then, next: null });
    this.ask(`series ${signal} ${from} ${to} ${Math.max(1, Math.round(width))}`);
  }

  received(series: Series): void {
    for (const { then } of this.end(series.signal, series.from, series.to)) then(series);
  }

  /** Removes the pending requests for a series, and sends any requests that were waiting for them.
   * Returns the removed requests. */
  end(signal: number, from: number, to: number): Request[] {
    const ended = [...this.slots].filter(
      ([, { wanted }]) => wanted.signal === signal && wanted.from === from && wanted.to === to,
    );
    return ended.map(([key, slot]) => {
      this.slots.delete(key);
      if (slot.next) this.send(key, slot.next);
      return slot;
    });
  }
}
