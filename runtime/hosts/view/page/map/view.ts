// Determines which part of the world the map shows: everything, the surroundings of the robot, or
// a part that the user has chosen.
import type { Point } from "./world";

/** Margin around everything, in metres. */
const margin = 0.35;
/** Minimum and maximum scale, in pixels per metre. */
const leastScale = 0.5,
  mostScale = 2000;
/** Initial width of the area that the map shows when it follows the robot, in metres. */
const surroundings = 4;

/** A bounding box, which grows to include each added point. */
export class Extent {
  left = Infinity;
  right = -Infinity;
  low = Infinity;
  high = -Infinity;

  add([x, y]: Point, around = 0): void {
    if (!Number.isFinite(x) || !Number.isFinite(y)) return;
    this.left = Math.min(this.left, x - around);
    this.right = Math.max(this.right, x + around);
    this.low = Math.min(this.low, y - around);
    this.high = Math.max(this.high, y + around);
  }

  addAll(points: readonly Point[]): void {
    for (const point of points) this.add(point);
  }

  get corners(): Point[] {
    return this.left > this.right
      ? []
      : [
          [this.left, this.low],
          [this.right, this.high],
        ];
  }
}

export type ViewMode = "all" | "robot" | "chosen";

export class View {
  mode: ViewMode = "all";
  /** Pixels per metre. */
  scale = 1;
  width = 1;
  height = 1;
  private centre: Point = [0, 0];

  readonly toPixel = ([x, y]: Point): Point => [
    this.width / 2 + (x - this.centre[0]) * this.scale,
    this.height / 2 - (y - this.centre[1]) * this.scale,
  ];

  readonly fromPixel = ([x, y]: Point): Point => [
    this.centre[0] + (x - this.width / 2) / this.scale,
    this.centre[1] - (y - this.height / 2) / this.scale,
  ];

  /** Identifies the visible part of the world, so that the map can detect a change. */
  get key(): string {
    return [this.scale, ...this.centre, this.width, this.height].join();
  }

  /** Depending on the mode, fits everything into the view or centres the view on the robot. */
  update({ left, right, low, high }: Extent, robot: Point): void {
    if (this.mode === "robot") this.centre = robot;
    if (this.mode !== "all" || left > right) return;
    const across = right - left + 2 * margin,
      up = high - low + 2 * margin;
    this.scale = Math.min(this.width / across, this.height / up);
    this.centre = [(left + right) / 2, (low + high) / 2];
  }

  showAll(): void {
    this.mode = "all";
  }

  follow(): void {
    if (this.mode === "all") this.scale = Math.max(this.scale, this.width / surroundings);
    this.mode = "robot";
  }

  /** Zooms around this pixel, or around the robot if the map follows it. */
  zoom(factor: number, at: Point): void {
    const [x, y] = this.fromPixel(at);
    this.scale = Math.min(mostScale, Math.max(leastScale, this.scale * factor));
    if (this.mode === "robot") return;
    this.mode = "chosen";
    const [u, v] = this.fromPixel(at);
    this.centre = [this.centre[0] + x - u, this.centre[1] + y - v];
  }

  pan(dx: number, dy: number): void {
    this.mode = "chosen";
    this.centre = [this.centre[0] - dx / this.scale, this.centre[1] + dy / this.scale];
  }

  /** For storing. */
  get state(): ViewState {
    return { mode: this.mode, scale: this.scale, x: this.centre[0], y: this.centre[1] };
  }

  set state({ mode, scale, x, y }: ViewState) {
    if (![scale, x, y].every(Number.isFinite) || scale <= 0) return;
    this.mode = mode;
    this.scale = scale;
    this.centre = [x, y];
  }
}

export interface ViewState {
  readonly mode: ViewMode;
  readonly scale: number;
  readonly x: number;
  readonly y: number;
}
