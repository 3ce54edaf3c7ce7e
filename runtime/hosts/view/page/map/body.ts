// Draws a robot, its start, and the cones of its sonars.
import { colour } from "../theme";
import { placed, within, type Pose } from "./pose";
import type { Robot, Sonar } from "./robots";
import { coneOpacity, type Pen } from "./scene";
import type { Point } from "./world";

/** Minimum size of a robot, in pixels, so that it is visible on the map of a large world. */
const leastSize = 7;

function circle(radius: number): Point[] {
  return Array.from({ length: 32 }, (_, k) => [
    radius * Math.cos((k * Math.PI) / 16),
    radius * Math.sin((k * Math.PI) / 16),
  ]);
}

/** Factor by which a robot is enlarged on the map. */
function enlarged({ radius }: Robot, scale: number): number {
  return Math.max(1, leastSize / (radius * scale));
}

function outline(pen: Pen, robot: Robot, pose: Pose): Point[] {
  const by = enlarged(robot, pen.view.scale);
  const corners = robot.outline.length > 0 ? robot.outline : circle(robot.radius);
  return corners.map(([x, y]) => placed(pose, [x * by, y * by]));
}

export function drawOutline(pen: Pen, robot: Robot, pose: Pose, stroke: string): void {
  pen.trace(outline(pen, robot, pose), true);
  pen.stroke(stroke, 1.2, [2, 4]);
}

export function drawRobot(pen: Pen, robot: Robot, pose: Pose, fill: string, edge: string): void {
  const by = enlarged(robot, pen.view.scale);
  pen.shape(outline(pen, robot, pose), fill);
  pen.stroke(edge, 1.4);
  const at = (x: number, y: number) => placed(pose, [x * by, y * by]);
  const { wheelSide, wheelRadius, tip } = robot;
  for (const side of wheelSide > 0 ? [-wheelSide, wheelSide] : []) {
    const half = 0.14 * wheelSide;
    pen.shape(
      [
        at(-wheelRadius, side - half),
        at(wheelRadius, side - half),
        at(wheelRadius, side + half),
        at(-wheelRadius, side + half),
      ],
      edge,
    );
  }
  pen.shape(
    [at(tip, 0), at(0.36 * tip, 0.42 * tip), at(0.36 * tip, -0.42 * tip)],
    colour("robot-arrow"),
  );
}

/** The last echo of a sonar, and the robot's position at that time. */
export interface Echo {
  readonly sonar: Sonar;
  readonly range: number;
  readonly pose: Pose;
}

/** Draws the cone of each sonar up to its last echo, with an arc at the echo. A cone without
 * an echo has no arc. */
export function drawEchoes(pen: Pen, robot: Robot, echoes: readonly Echo[]): void {
  const { context } = pen;
  for (const { sonar, range, pose } of echoes) {
    if (!(range > 0)) continue;
    const from = within(pose, sonar);
    const arc: Point[] = [];
    for (let i = -6; i <= 6; i++) {
      const angle = from.heading + (robot.halfAngle * i) / 6;
      arc.push([from.x + range * Math.cos(angle), from.y + range * Math.sin(angle)]);
    }
    const isEcho = range < robot.reach * (1 - 1e-6);
    context.globalAlpha = isEcho ? coneOpacity() : coneOpacity() / 3;
    pen.shape([...arc, [from.x, from.y]], colour("sonar"));
    context.globalAlpha = 1;
    if (isEcho) pen.line(arc, colour("sonar"), 1.8);
  }
}
