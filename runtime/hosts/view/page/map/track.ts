// The way that a robot has come, and when it passed each point of it.
import type { Point } from "./world";

/** How far apart points are that are added as it drives, in metres. */
const apart = 0.01;

export class Track {
  points: Point[] = [];
  times: number[] = [];

  set(points: Point[], times: number[]): void {
    this.points = points;
    this.times = times;
  }

  /** Adds where it is now, if that is somewhere else. */
  extend(x: number, y: number, time: number): void {
    const last = this.points.at(-1);
    if (last && Math.hypot(x - last[0], y - last[1]) < apart) return;
    this.points.push([x, y]);
    this.times.push(time);
  }

  /** What it has passed by then. */
  until(time: number): Point[] {
    return this.points.filter((_, i) => (this.times[i] ?? 0) <= time);
  }
}
