// Reads and draws the scans of a lidar.
import { colour } from "../theme";
import { placed, type Pose } from "./pose";
import type { Pen } from "./scene";
import type { Point } from "./world";

const size = 3;

/** Parses the cell of an event that contains a `Scan` of the library's module Lidar. Returns the
 * positions of the objects relative to the robot, or null for any other event. */
export function readScan(cell: string): Point[] | null {
  const ranges = /^Scan \{ranges = \[([^\]]*)\]/.exec(cell)?.[1]?.split(", ");
  const farthest = Number(/farthest = ([^,}]+)/.exec(cell)?.[1]);
  const seat = /seat = Vec2 \{x = ([^,]+), y = ([^}]+)\}/.exec(cell);
  if (!ranges || !seat) return null;
  const [x, y] = [Number(seat[1]), Number(seat[2])];
  return ranges.flatMap((range, k): Point[] => {
    const distance = range.startsWith("Just ") ? Number(range.slice(5)) : NaN;
    if (!(distance < farthest)) return [];
    const bearing = (2 * Math.PI * k) / ranges.length;
    return [[x + distance * Math.cos(bearing), y + distance * Math.sin(bearing)]];
  });
}

/** Draws the objects in a scan. `pose` is the robot's pose when it received the scan. */
export function drawScan(pen: Pen, places: readonly Point[], pose: Pose): void {
  const { context, view } = pen;
  context.fillStyle = colour("sonar");
  for (const place of places) {
    const [x, y] = view.toPixel(placed(pose, place));
    context.fillRect(x - size / 2, y - size / 2, size, size);
  }
}
