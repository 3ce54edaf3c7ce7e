// Positions and directions in the plane, and how they are converted between frames.
import type { Point } from "./world";

export interface Pose {
  readonly x: number;
  readonly y: number;
  readonly heading: number;
}

/** Converts a pose relative to `frame` into the coordinates in which `frame` itself is given. */
export function within(frame: Pose, pose: Pose): Pose {
  const [x, y] = placed(frame, [pose.x, pose.y]);
  return { x, y, heading: frame.heading + pose.heading };
}

/** Like `within`, but for a point. */
export function placed(frame: Pose, [x, y]: Point): Point {
  const cos = Math.cos(frame.heading),
    sin = Math.sin(frame.heading);
  return [frame.x + cos * x - sin * y, frame.y + sin * x + cos * y];
}

/** The inverse of `placed`. */
export function relative(frame: Pose, [x, y]: Point): Point {
  const cos = Math.cos(frame.heading),
    sin = Math.sin(frame.heading);
  const dx = x - frame.x,
    dy = y - frame.y;
  return [cos * dx + sin * dy, cos * dy - sin * dx];
}
