// Draws the path of a robot. The colour changes from light at the start to dark at the shown
// instant, and there is a mark every few seconds.
import { colour } from "../theme";
import { formatNumber } from "../values";
import { niceStep } from "../ticks";
import { blend, type Pen } from "./scene";
import type { Track } from "./track";
import type { Point } from "./world";

/** Number of pieces into which a path is divided, each with its own colour. */
const pieces = 48;
/** Approximate number of time marks. */
const marks = 6;
/** Minimum distance between a mark and the robot or the previous mark, in pixels. */
const markSpace = 26;

/** Omits points that are less than half a pixel away from the previous one. */
function thinned(pen: Pen, points: readonly Point[]): Point[] {
  const all: Point[] = [];
  let last: Point | undefined;
  for (const p of points) {
    const q = pen.view.toPixel(p);
    if (last && Math.hypot(q[0] - last[0], q[1] - last[1]) < 0.5) continue;
    last = q;
    all.push(p);
  }
  return all;
}

/** Draws the path up to the robot's position at `time`, and the rest in a faint colour. */
export function drawWay(
  pen: Pen,
  track: Track,
  time: number,
  robot: Point,
  isFirst: boolean,
): void {
  const passed = track.passed(time);
  const rest = [robot, ...thinned(pen, track.points.slice(passed))];
  if (rest.length > 1) pen.line(rest, colour("way-rest"), 1.5);
  const points = [...thinned(pen, track.points.slice(0, passed)), robot];
  if (!isFirst) {
    pen.line(points, colour("dim"), 1);
    return;
  }
  const count = Math.min(pieces, points.length - 1);
  for (let piece = 0; piece < count; piece++) {
    const from = Math.floor((piece * (points.length - 1)) / count),
      to = Math.floor(((piece + 1) * (points.length - 1)) / count);
    pen.line(
      points.slice(from, to + 1),
      blend(colour("way-early"), colour("way-late"), count > 1 ? piece / (count - 1) : 1),
      2.6,
    );
  }
}

/** Marks the path up to `time` with a dot every few seconds of the run, and labels each dot with
 * its time. */
export function drawTimes(
  pen: Pen,
  track: Track,
  time: number,
  [start, end]: readonly [number, number],
  robot: Point,
): void {
  const { context, view } = pen;
  const step = niceStep(Math.max(end - start, 1) / marks);
  const apart = (p: Point, q: Point) => Math.hypot(p[0] - q[0], p[1] - q[1]);
  let last = view.toPixel(robot);
  context.font = "11px system-ui, sans-serif";
  context.textAlign = "center";
  for (let t = Math.ceil(start / step + 0.5) * step; t <= time; t += step) {
    const at = track.at(t),
      before = track.at(t - 0.5);
    if (!at || !before) continue;
    const pixel = view.toPixel(at);
    if (apart(pixel, view.toPixel(robot)) < markSpace || apart(pixel, last) < markSpace) continue;
    last = pixel;
    // Puts the label to the right of the path, away from a wall that the robot follows on its
    // left.
    const heading = Math.atan2(at[1] - before[1], at[0] - before[0]);
    const [x, y] = [pixel[0] + 18 * Math.sin(heading), pixel[1] + 14 * Math.cos(heading) + 4];
    pen.disc(at, 3.2, colour("panel"));
    pen.stroke(colour("way-late"), 1.6);
    const text = `${formatNumber(Math.round(t / step) * step)} s`;
    context.lineWidth = 3;
    context.strokeStyle = colour("floor");
    context.strokeText(text, x, y);
    context.fillStyle = colour("way-late");
    context.fillText(text, x, y);
  }
  context.textAlign = "left";
}
