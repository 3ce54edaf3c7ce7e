// The path of a robot, with the time at which it passed each point.
import type { Point } from "./world";

/** Minimum distance of points that are added during a live run, in metres. */
const apart = 0.01;

export class Track {
  points: Point[] = [];
  times: number[] = [];

  set(points: Point[], times: number[]): void {
    this.points = points;
    this.times = times;
  }

  /** Adds the current position, unless it is close to the last one. */
  extend(x: number, y: number, time: number): void {
    const last = this.points.at(-1);
    if (last && Math.hypot(x - last[0], y - last[1]) < apart) return;
    this.points.push([x, y]);
    this.times.push(time);
  }

  /** Returns the points passed by this time. */
  until(time: number): Point[] {
    return this.points.filter((_, i) => (this.times[i] ?? 0) <= time);
  }
}
