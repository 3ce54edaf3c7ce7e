// Requests and stores the paths of all robots: the path according to odometry and, in a
// live simulated run, the true paths.
import type { Store } from "../store";
import { placed, type Pose } from "./pose";
import { Track } from "./track";
import type { Extent } from "./view";
import type { Point } from "./world";

/** Approximate maximum number of points in a path. */
const mostPoints = 6000;

export class Ways {
  readonly believed: Track;
  /** The true paths of simulated robots; empty if they are unknown. */
  readonly true: Track[] = [];
  /** The robot's path with the edited program, if that ran in the simulator. */
  other: Point[] = [];
  private pending = 0;
  private turn = 0;

  constructor(
    private readonly store: Store,
    /** The numbers of the signals that contain the position according to odometry. */
    private readonly x: number,
    private readonly y: number,
    private readonly start: Pose,
    private readonly extent: Extent,
    private readonly changed: () => void,
  ) {
    this.believed = new Track(extent);
    store.on("what-if", () => this.loadBelieved(0));
    store.on("resumed", () => this.grow());
    store.on("extent", () => this.grow());
    this.loadBelieved(0);
  }

  /** The path of the first robot. */
  get first(): Track {
    return this.true[0] ?? this.believed;
  }

  private grow(): void {
    const { newest } = this.store;
    if (this.pending > 0 || !newest) return;
    const robots = newest.truth?.length ?? 0;
    while (this.true.length < robots) this.true.push(new Track(this.extent));
    this.loadBelieved(this.believed.next);
    if (robots > 0) this.loadTrue(0);
    // Requests the paths of the other robots one at a time, because there may be hundreds.
    if (robots > 1) this.loadTrue(1 + (this.turn++ % (robots - 1)));
  }

  private received(): void {
    this.pending--;
    this.changed();
  }

  private loadBelieved(from: number): void {
    const inWorld = (points: readonly (readonly [number, number | null, number | null])[]) =>
      points.map(([, x, y]) => placed(this.start, [x ?? NaN, y ?? NaN]));
    this.pending++;
    this.store.path(this.x, this.y, mostPoints, from, (answer) => {
      if (answer) {
        const times = answer.points.map(([time]) => time);
        this.believed.extend(answer.from, inWorld(answer.points), times, answer.next);
        this.other = inWorld(answer.others ?? []);
        this.extent.addAll(this.other);
      }
      this.received();
    });
  }

  private loadTrue(robot: number): void {
    const track = this.true[robot];
    if (!track) return;
    this.pending++;
    this.store.way(robot, mostPoints, track.next, (answer) => {
      if (answer)
        track.extend(
          answer.from,
          answer.points.map(([, x, y]) => [x, y]),
          answer.points.map(([time]) => time),
          answer.next,
        );
      this.received();
    });
  }
}
