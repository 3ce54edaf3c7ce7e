// The values of one signal in the visible range. The viewer sends them; in a live run, more values
// arrive.
import type { Series, Signal } from "../protocol";
import type { Store } from "../store";

/** Maximum number of points in a request for the newest data. It is large enough for all of that
 * data. */
const mostPoints = 100_000;

type Values = (number | null)[];

export class Trace {
  times: number[] = [];
  values: Values = [];
  /** The edited program's values; empty if there are none. */
  others: Values = [];

  constructor(
    private readonly store: Store,
    readonly number: number,
    private readonly user: string,
    private readonly changed: () => void,
  ) {}

  get signal(): Signal {
    const signal = this.store.program.signals[this.number];
    if (!signal) throw new Error("the plotted signal does not exist");
    return signal;
  }

  /** Requests the data for the visible range. */
  load(width: number): void {
    const [from, to] = this.store.range;
    this.store.series.request(this.user, { signal: this.number, from, to, width }, (series) => {
      const isLate = from !== this.store.range[0] || to !== this.store.range[1];
      if (isLate && !this.store.following) return;
      this.times = series.times;
      this.values = series.values;
      this.others = series.others ?? [];
      this.changed();
    });
  }

  /** Requests data that has arrived since the last request, if the plot follows a live run. */
  grow(width: number): void {
    if (this.store.series.awaits(this.user, this.number)) return;
    // If the plot shows the whole run, appending would let its data grow without limit, so all data
    // is loaded again at the plot's resolution. All data is also loaded again if most of it is new,
    // as in a fast run.
    const [start, end] = this.store.range;
    const isNew = (this.times.at(-1) ?? start) < start + (end - start) / 2;
    if (this.times.length > 8 * width || isNew) {
      this.load(width);
      return;
    }
    const from = this.times.at(-1) ?? this.store.range[0];
    const to = this.store.program.end;
    const wanted = { signal: this.number, from, to, width: mostPoints };
    this.store.series.request(this.user, wanted, (series) => {
      if (!this.store.following) return;
      this.append(series);
      this.changed();
    });
  }

  private append(series: Series): void {
    const [from] = this.store.range;
    const last = this.times.at(-1) ?? -Infinity;
    const isNew = (_: unknown, i: number) => (series.times[i] ?? 0) > last;
    const times = [...this.times, ...series.times.filter(isNew)];
    // Keeps one point before the visible range, because its step extends into the range.
    const first = Math.max(0, times.findIndex((time) => time > from) - 1);
    const joined = (before: Values, more: Values) =>
      [...before, ...more.filter(isNew)].slice(first);
    const before = this.others.length > 0 ? this.others : this.values.map(() => null);
    this.others = series.others ? joined(before, series.others) : [];
    this.values = joined(this.values, series.values);
    this.times = times.slice(first);
  }

  get isEmpty(): boolean {
    return this.values.every((value) => value === null);
  }

  /** Returns the signal's value at a time: its last value at or before that time. For an event,
   * returns the value nearest to that time within `close` seconds. */
  at(seconds: number, close: number, values = this.values): number | null {
    let low = 0,
      high = this.times.length;
    while (low < high) {
      const middle = (low + high) >> 1;
      if ((this.times[middle] ?? 0) <= seconds) low = middle + 1;
      else high = middle;
    }
    if (this.signal.kind !== "event") return values[low - 1] ?? null;
    let best: number | null = null,
      apart = close;
    for (let i = low - 1; i >= 0 && seconds - (this.times[i] ?? 0) <= apart; i--)
      if (values[i] !== null) {
        best = values[i] ?? null;
        apart = seconds - (this.times[i] ?? 0);
        break;
      }
    for (let i = low; i < this.times.length && (this.times[i] ?? 0) - seconds < apart; i++)
      if (values[i] !== null) return values[i] ?? null;
    return best;
  }
}
