// The path of a robot: its corners, and the time at which the robot passed each of them. In a live
// run, the path grows: the viewer sends all corners since the last one, even for instants that the
// page has not shown.
import type { Extent } from "./view";
import type { Point } from "./world";

export class Track {
  points: Point[] = [];
  times: number[] = [];
  /** The instant of the last corner, from which the path is continued. */
  next = 0;
  /** The index of this corner in `points`. Points after it are provisional. */
  private corner = -1;

  constructor(private readonly extent: Extent) {}

  /** Adds the part of the path that starts at instant `from`. Its last corner is at instant
   * `next`. */
  extend(from: number, points: readonly Point[], times: readonly number[], next: number): void {
    if (from !== this.next && from !== 0) return;
    const kept = from === 0 ? 0 : this.corner + 1;
    // The new part starts with a corner that is already known.
    const skipped = kept === 0 ? 0 : 1;
    this.points.length = this.times.length = kept;
    this.points.push(...points.slice(skipped));
    this.times.push(...times.slice(skipped));
    this.extent.addAll(points);
    this.next = next;
    if (points.length > 1) this.corner = this.points.length - 2;
    else if (kept === 0) this.corner = this.points.length - 1;
  }

  /** Returns the number of points that the robot has passed by this time. */
  passed(time: number): number {
    let low = 0,
      high = this.times.length;
    while (low < high) {
      const middle = (low + high) >> 1;
      if ((this.times[middle] ?? 0) <= time) low = middle + 1;
      else high = middle;
    }
    return low;
  }

  /** Returns the position at a time, interpolated between the points before and after it. */
  at(time: number): Point | undefined {
    const after = this.passed(time);
    const p = this.points[after - 1] ?? this.points[0],
      q = this.points[after] ?? p;
    if (!p || !q) return undefined;
    const from = this.times[after - 1] ?? time,
      to = this.times[after] ?? from;
    const share = to > from ? Math.min(1, Math.max(0, (time - from) / (to - from))) : 0;
    return [p[0] + share * (q[0] - p[0]), p[1] + share * (q[1] - p[1])];
  }

  /** Returns the time at which the path was closest to a point. */
  nearest([x, y]: Point): number | undefined {
    let best = Infinity,
      time: number | undefined = this.times[0];
    for (let i = 0; i + 1 < this.points.length; i++) {
      const [ax, ay] = this.points[i] ?? [0, 0],
        [bx, by] = this.points[i + 1] ?? [0, 0];
      const dx = bx - ax,
        dy = by - ay,
        length = dx * dx + dy * dy;
      const share =
        length > 0 ? Math.min(1, Math.max(0, ((x - ax) * dx + (y - ay) * dy) / length)) : 0;
      const apart = Math.hypot(ax + share * dx - x, ay + share * dy - y);
      if (apart >= best) continue;
      best = apart;
      const from = this.times[i] ?? 0;
      time = from + share * ((this.times[i + 1] ?? from) - from);
    }
    return time;
  }
}
