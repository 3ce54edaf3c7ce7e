// Answers the page's questions from the data in a saved page, in place of a viewer.
import type { Link, Listener } from "../connection";
import type { Answer, Instant, Path, Series, Signal, Way } from "../protocol";
import { unpack, type SavedRun } from "./format";

/** How long an event of the input stays visible, in seconds: see instant.c. */
const recentlySeconds = 0.4;

/** Returns the number that represents a cell in a plot. */
function numberOf({ names, kind }: Signal, cell: string): number | null {
  if (cell === "") return null;
  if (kind === "bool") return cell === "true" ? 1 : 0;
  const name = names.indexOf(cell.split(" ", 1)[0] ?? "");
  if (name >= 0) return name;
  const number = Number(cell);
  return Number.isFinite(number) ? number : kind === "event" ? 1 : null;
}

export class Saved implements Link {
  readonly isOpen = true;
  private run: SavedRun | null = null;

  constructor(
    text: string,
    private readonly listener: Listener,
  ) {
    void unpack(text).then((run) => {
      this.run = run;
      this.answer(run.program, "");
      this.answer(run.claims, "");
      if (run.whatIf) this.answer(run.whatIf, "");
    });
    // There is no viewer, so the page cannot lose contact with it.
    setInterval(() => this.answer({ is: "beat", time: 0 }, ""), 100);
  }

  more(): void {
    // A saved run does not grow.
  }

  command(): boolean {
    return false;
  }

  private answer(answer: Answer, question: string): void {
    this.listener.answered(answer, question);
  }

  ask(question: string): void {
    // As with a viewer, answers never arrive before the caller has finished.
    queueMicrotask(() => this.answer(this.answerTo(question), question));
  }

  private answerTo(question: string): Answer {
    const [word = "", ...rest] = question.split(" ");
    const [a = 0, b = 0, c = 0, d = 0] = rest.map(Number);
    const { run } = this;
    if (word === "keep") return { is: "keep" };
    if (!run) return { is: "refused", why: "the run is not loaded yet" };
    if (word === "instant") return this.instant(run, a);
    if (word === "time") return this.instant(run, this.at(run, a));
    if (word === "series") return this.series(run, a, b, c);
    if (word === "path") return this.path(run, a, b, d);
    if (word === "way") return this.way(run, a, c);
    if (word === "claims") return run.claims;
    if (word === "contacts")
      return { is: "contacts", count: run.contacts.length, all: run.contacts };
    const why = "a saved page cannot do this: use frobc view with the recording";
    return word === "find" ? { is: "found", why } : { is: "refused", why };
  }

  /** Returns the last instant at or before a time. */
  private at({ times }: SavedRun, seconds: number): number {
    let low = 0,
      high = times.length;
    while (high - low > 1) {
      const middle = (low + high) >> 1;
      if ((times[middle] ?? 0) <= seconds) low = middle;
      else high = middle;
    }
    return low;
  }

  private cell({ cells }: SavedRun, signal: number, k: number): string {
    return String(this.value(cells[signal] ?? [], k) ?? "");
  }

  private value<Value>(changes: readonly Value[], k: number): Value | null {
    let low = 0,
      high = changes.length / 2;
    while (high - low > 1) {
      const middle = (low + high) >> 1;
      if (Number(changes[2 * middle]) <= k) low = middle;
      else high = middle;
    }
    return changes[2 * low + 1] ?? null;
  }

  private instant(run: SavedRun, k: number): Instant {
    const truth = run.truth[k];
    const objects = this.value(run.objects, k) as Instant["objects"] | null;
    return {
      is: "instant",
      k,
      time: run.times[k] ?? 0,
      dt: run.dts[k] ?? 0,
      cells: run.cells.map((_, signal) => this.cell(run, signal, k)),
      ...(run.others ? { others: run.others.map((each) => this.other(each, k)) } : {}),
      recent: this.recent(run, k),
      ...(truth ? { truth } : {}),
      ...(objects ? { objects } : {}),
    };
  }

  private other(changes: readonly (number | string | null)[], k: number): string | null {
    const value = this.value(changes, k);
    return value === null ? null : String(value);
  }

  private recent(run: SavedRun, k: number): Instant["recent"] {
    const { signals } = run.program;
    const pose = ["position.x", "position.y", "heading"].map((name) =>
      signals.findIndex((signal) => signal.name === `in.odometry.${name}`),
    );
    const since = (run.times[k] ?? 0) - recentlySeconds;
    return signals.flatMap((signal, number) => {
      if (signal.side !== "input" || signal.kind !== "event") return [];
      for (let i = k; i >= 0 && (run.times[i] ?? 0) > since; i--) {
        const cell = this.cell(run, number, i);
        const value = numberOf(signal, cell);
        if (value === null) continue;
        const [x, y, heading] =
          run.truth[i]?.[0] ?? pose.map((each) => Number(this.cell(run, each, i) || NaN));
        return [[number, value, x ?? null, y ?? null, heading ?? null, cell] as const];
      }
      return [];
    });
  }

  private series(run: SavedRun, signal: number, from: number, to: number): Series {
    const first = this.at(run, from),
      end = Math.min(run.times.length, this.at(run, to) + 2);
    const of = run.program.signals[signal];
    const others = run.others?.[signal];
    return {
      is: "series",
      signal,
      from,
      to,
      times: run.times.slice(first, end),
      values: Array.from({ length: end - first }, (_, i) =>
        of ? numberOf(of, this.cell(run, signal, first + i)) : null,
      ),
      ...(others && of
        ? {
            others: Array.from({ length: end - first }, (_, i) =>
              numberOf(of, this.other(others, first + i) ?? ""),
            ),
          }
        : {}),
    };
  }

  private path(run: SavedRun, x: number, y: number, from: number): Path {
    const place = (signal: number, k: number) => Number(this.cell(run, signal, k) || NaN);
    const other = (signal: number, k: number) =>
      Number(this.other(run.others?.[signal] ?? [], k) ?? NaN);
    return {
      is: "path",
      x,
      y,
      from,
      next: run.times.length - 1,
      points: run.times
        .slice(from)
        .map((time, i) => [time, place(x, from + i), place(y, from + i)]),
      ...(run.others
        ? { others: run.times.map((time, k) => [time, other(x, k), other(y, k)] as const) }
        : {}),
    };
  }

  private way(run: SavedRun, robot: number, from: number): Way {
    return {
      is: "way",
      robot,
      from,
      next: run.times.length - 1,
      points: run.times
        .slice(from)
        .map((time, i) => [
          time,
          run.truth[from + i]?.[robot]?.[0] ?? NaN,
          run.truth[from + i]?.[robot]?.[1] ?? NaN,
        ]),
    };
  }
}
