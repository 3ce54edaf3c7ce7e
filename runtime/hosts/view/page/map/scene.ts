// Draws the world as the simulator's pictures show it: the floor with a grid, and all objects.
import type { Instant } from "../protocol";
import { colour, isDark } from "../theme";
import { niceStep } from "../ticks";
import { formatNumber } from "../values";
import type { Pose } from "./pose";
import type { View } from "./view";
import { corners, type Disc, type Point, type World } from "./world";

/** Minimum distance between grid lines, in pixels. */
const gridSpace = 60;
const labelFont = "11px system-ui, sans-serif";

/** Draws paths and discs in world coordinates. */
export class Pen {
  constructor(
    readonly context: CanvasRenderingContext2D,
    readonly view: View,
  ) {}

  trace(points: readonly Point[], isClosed = false): void {
    const { context, view } = this;
    context.beginPath();
    for (const p of points) context.lineTo(...view.toPixel(p));
    if (isClosed) context.closePath();
  }

  line(points: readonly Point[], stroke: string, width: number, dash: number[] = []): void {
    this.trace(points);
    this.stroke(stroke, width, dash);
  }

  stroke(stroke: string, width: number, dash: number[] = []): void {
    const { context } = this;
    context.strokeStyle = stroke;
    context.lineWidth = width;
    context.setLineDash(dash);
    context.stroke();
    context.setLineDash([]);
  }

  shape(points: readonly Point[], fill: string): void {
    this.trace(points, true);
    this.fill(fill);
  }

  fill(fill: string): void {
    this.context.fillStyle = fill;
    this.context.fill();
  }

  disc(center: Point, pixels: number, fill: string): void {
    this.context.beginPath();
    this.context.arc(...this.view.toPixel(center), pixels, 0, 2 * Math.PI);
    this.fill(fill);
  }
}

/** Mixes two colours, each `#rrggbb`. */
export function blend(from: string, to: string, share: number): string {
  const part = (text: string, i: number) => parseInt(text.slice(2 * i + 1, 2 * i + 3), 16);
  const mixed = [0, 1, 2].map((i) =>
    Math.round(part(from, i) + share * (part(to, i) - part(from, i)))
      .toString(16)
      .padStart(2, "0"),
  );
  return `#${mixed.join("")}`;
}

/** The colour of a floor with this reflectance. A floor that reflects all light has the theme's
 * floor colour. On a dark page, bright and dark are swapped, so that lines on the floor stand
 * out. */
function shade(reflectance: number): string {
  return blend(colour("black-floor"), colour("floor"), reflectance);
}

function drawGrid(pen: Pen): void {
  const { context, view } = pen;
  const step = Math.max(niceStep(gridSpace / view.scale), 0.1);
  const [left, high] = view.fromPixel([0, 0]);
  const [right, low] = view.fromPixel([view.width, view.height]);
  const label = (x: number) => formatNumber(Math.round(x / step) * step).replace("-", "−");
  const write = (text: string, x: number, y: number) => {
    context.strokeStyle = colour("floor");
    context.lineWidth = 3;
    context.strokeText(text, x, y);
    context.fillText(text, x, y);
    context.strokeStyle = colour("map-grid");
    context.lineWidth = 1;
  };
  context.font = labelFont;
  context.lineWidth = 1;
  context.strokeStyle = colour("map-grid");
  context.fillStyle = colour("dim");
  for (let x = Math.ceil(left / step) * step; x <= right; x += step) {
    const at = Math.round(view.toPixel([x, 0])[0]) + 0.5;
    context.beginPath();
    context.moveTo(at, 0);
    context.lineTo(at, view.height);
    context.stroke();
    context.textAlign = "center";
    if (at > 34 && at < view.width - 12) write(label(x), at, view.height - 5);
  }
  context.textAlign = "left";
  for (let y = Math.ceil(low / step) * step; y <= high; y += step) {
    const at = Math.round(view.toPixel([0, y])[1]) + 0.5;
    context.beginPath();
    context.moveTo(0, at);
    context.lineTo(view.width, at);
    context.stroke();
    if (at > 12 && at < view.height - 20) write(label(y), 4, at - 3);
  }
}

/** Draws a scale bar, labelled with its length. */
export function drawScale({ context, view }: Pen): void {
  const metres = niceStep(70 / view.scale),
    across = metres * view.scale;
  const [x, y] = [view.width - across - 12, view.height - 24];
  context.beginPath();
  context.moveTo(x, y - 4);
  context.lineTo(x, y);
  context.lineTo(x + across, y);
  context.lineTo(x + across, y - 4);
  context.strokeStyle = context.fillStyle = colour("dim");
  context.lineWidth = 1.5;
  context.stroke();
  context.font = labelFont;
  context.textAlign = "center";
  const text = metres < 1 ? `${formatNumber(metres * 100)} cm` : `${formatNumber(metres)} m`;
  context.fillText(text, x + across / 2, y - 6);
  context.textAlign = "left";
}

function drawFloor(pen: Pen, world: World): void {
  for (const { points, reflectance } of world.patches) pen.shape(points, shade(reflectance));
  for (const { points, width, reflectance } of world.lines)
    pen.line(points, shade(reflectance), Math.max(1.5, width * pen.view.scale));
}

/** Draws the symbol of a lamp, which is not to scale. */
function drawLamp(pen: Pen, at: Point): void {
  const [x, y] = pen.view.toPixel(at);
  pen.context.beginPath();
  for (let k = 0; k < 8; k++) {
    const u = Math.cos((k * Math.PI) / 4),
      v = Math.sin((k * Math.PI) / 4);
    pen.context.moveTo(x + 8 * u, y + 8 * v);
    pen.context.lineTo(x + 12 * u, y + 12 * v);
  }
  pen.stroke(colour("lamp-edge"), 1.4);
  pen.disc(at, 5.5, colour("lamp"));
  pen.stroke(colour("lamp-edge"), 1.4);
}

function drawObjects(pen: Pen, world: World): void {
  const { scale } = pen.view;
  const solid = colour("solid");
  for (const hole of world.holes) {
    pen.shape(hole, colour("hole"));
    pen.stroke(colour("dim"), 1.2, [3, 3]);
  }
  for (const { points, thickness } of world.walls)
    pen.line(points, solid, Math.max(2, thickness * scale));
  for (const points of world.solids) pen.shape(points, solid);
  const round = ({ center, radius }: Disc, fill: string) => {
    pen.disc(center, radius * scale, fill);
  };
  for (const each of world.circles) round(each, solid);
  for (const each of world.cones) {
    round(each, colour("ball"));
    pen.stroke(colour("box-edge"), 1.2);
    round({ ...each, radius: 0.3 * each.radius }, colour("panel"));
  }
  for (const [from, to, middle, front] of world.posters) {
    pen.line([from, to], colour("believed"), 3);
    pen.line([middle, front], colour("believed"), 1.6);
  }
  for (const lamp of world.lamps) drawLamp(pen, lamp);
}

/** Draws the boxes and balls at their current positions. If the positions are unknown, as in a
 * recording, draws the objects at their initial positions with dashed edges. */
export function drawMovable(pen: Pen, world: World, objects: Instant["objects"]): void {
  const dash = objects ? [] : [3, 4];
  const at = (number: number, start: Pose): Pose => {
    const [x, y, heading] = objects?.[number] ?? [start.x, start.y, start.heading];
    return { x, y, heading };
  };
  world.boxes.forEach((box, i) => {
    pen.shape(corners(box, at(i, box.pose)), colour("box"));
    pen.stroke(colour("box-edge"), 1.2, dash);
  });
  world.balls.forEach(({ center: [x, y], radius }, i) => {
    const now = at(world.boxes.length + i, { x, y, heading: 0 });
    pen.disc([now.x, now.y], radius * pen.view.scale, colour("ball"));
    pen.stroke(colour("box-edge"), 1.2, dash);
  });
}

export function drawScene(pen: Pen, world: World | null): void {
  const { context, view } = pen;
  context.fillStyle = shade(world?.floor ?? 1);
  context.fillRect(0, 0, view.width, view.height);
  if (world) drawFloor(pen, world);
  drawGrid(pen);
  if (world) drawObjects(pen, world);
}

/** Opacity of sonar cones. */
export const coneOpacity = () => (isDark() ? 0.16 : 0.13);
