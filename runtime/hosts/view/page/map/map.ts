// The map: the robot's position by odometry, its path, its sonar readings, and the world.
import { clear } from "../canvas";
import type { Instant, Path, Way } from "../protocol";
import { drawShape, markSignals, moved, points, readingsList, readMarks } from "./marks";
import { robotNamed } from "./robots";
import type { Store } from "../store";
import { colour, onTheme } from "../theme";
import { Track } from "./track";
import { readWorld, type Point, type World } from "./world";

const pathPoints = 4000;
/** Height of the note below the map, in pixels. */
const noteHeight = 18;
/** Margin around the drawing, in metres. */
const margin = 0.35;

interface Pose {
  readonly x: number;
  readonly y: number;
  readonly heading: number;
}

/** Converts a pose relative to `frame` to the coordinates in which `frame` is given. */
function within(frame: Pose, pose: Pose): Pose {
  const cos = Math.cos(frame.heading),
    sin = Math.sin(frame.heading);
  return {
    x: frame.x + cos * pose.x - sin * pose.y,
    y: frame.y + sin * pose.x + cos * pose.y,
    heading: frame.heading + pose.heading,
  };
}

export function startMap(store: Store, host: HTMLElement): void {
  const { signals, robot: robotName, world: worldFile } = store.program;
  const number = (name: string) => signals.findIndex((signal) => signal.name === name);
  const x = number("in.odometry.position.x");
  const y = number("in.odometry.position.y");
  const heading = number("in.odometry.heading");
  const canvas = document.createElement("canvas");
  const context = canvas.getContext("2d");
  if (x < 0 || y < 0 || heading < 0 || !context) {
    host.hidden = true;
    document.body.classList.add("no-map");
    return;
  }
  host.append(canvas);
  const robot = robotNamed(robotName);
  const sonars = robot.sonars.map((_, k) => number(`in.sonar[${k}]`));
  const world: World | null = worldFile && readWorld(worldFile.text);
  const start: Pose = world?.start ?? { x: 0, y: 0, heading: 0 };
  // `believed` is the path by odometry; `ways` has the true paths of the robots in a live simulated
  // run.
  const believed = new Track();
  const ways = new Map<number, Track>();
  const shownTracks = () => (ways.size > 0 ? [...ways.values()] : [believed]);
  /** Path of the edited program, if it ran in the simulator. */
  let otherPath: Point[] = [];
  const marks = markSignals(signals);
  const showReadings = readingsList(host);
  /** Bounding corners of everything drawn so far. */
  let drawnWithin: Point[] = [];
  let toPixel = (p: Point): Point => p;
  let fromPixel = (p: Point): Point => p;
  const clicks = store.program.console.findIndex((control) => control.kind === "map");
  let scale = 1;
  /** The last click that was sent to the program. */
  let clicked: Point | null = null;

  const fit = () => {
    const lines = [...(world?.walls ?? []), ...(world?.lines ?? [])];
    const all: Point[] = [
      [start.x, start.y],
      ...drawnWithin,
      ...shownTracks().flatMap((track) => track.points),
      ...(world?.solids ?? []).flat(),
      ...lines.flatMap((line) => line.points),
    ];
    const xs = all.map((p) => p[0]),
      ys = all.map((p) => p[1]);
    const lowest = (numbers: number[]) => numbers.reduce((a, b) => Math.min(a, b)) - margin;
    const highest = (numbers: number[]) => numbers.reduce((a, b) => Math.max(a, b)) + margin;
    const least: Point = [lowest(xs), lowest(ys)];
    const most: Point = [highest(xs), highest(ys)];
    const { clientWidth: width, clientHeight } = host;
    const height = clientHeight - noteHeight;
    scale = Math.min(width / (most[0] - least[0]), height / (most[1] - least[1]));
    const left = (width - scale * (most[0] - least[0])) / 2;
    const top = (height - scale * (most[1] - least[1])) / 2;
    toPixel = ([px, py]) => [left + (px - least[0]) * scale, top + (most[1] - py) * scale];
    fromPixel = ([px, py]) => [least[0] + (px - left) / scale, most[1] - (py - top) / scale];
  };

  const trace = (points: readonly Point[]) => {
    context.beginPath();
    for (const p of points) context.lineTo(...toPixel(p));
  };
  const line = (points: readonly Point[], stroke: string, width: number) => {
    trace(points);
    context.strokeStyle = stroke;
    context.lineWidth = width;
    context.stroke();
  };
  const disc = (center: Point, radius: number, fill: string) => {
    context.beginPath();
    context.arc(...toPixel(center), radius, 0, 2 * Math.PI);
    context.fillStyle = fill;
    context.fill();
  };

  const drawCross = (at: Point) => {
    const [px, py] = toPixel(at);
    const arm = 6;
    context.beginPath();
    for (const side of [-1, 1]) {
      context.moveTo(px - arm, py - side * arm);
      context.lineTo(px + arm, py + side * arm);
    }
    context.strokeStyle = colour("mark");
    context.lineWidth = 2;
    context.stroke();
  };

  const drawWorld = (all: World) => {
    for (const { points, width } of all.lines)
      line(points, colour("dim"), Math.max(1.5, width * scale));
    for (const { points, thickness } of all.walls)
      line(points, colour("solid"), Math.max(2, thickness * scale));
    for (const solid of all.solids) {
      trace(solid);
      context.fillStyle = colour("solid");
      context.fill();
    }
    for (const { center, radius } of all.circles) disc(center, radius * scale, colour("solid"));
  };

  const drawBody = (pose: Pose, fill: string) => {
    const at: Point = [pose.x, pose.y];
    const radius = Math.max(5, robot.radius * scale);
    disc(at, radius, fill);
    const [px, py] = toPixel(at);
    context.beginPath();
    context.moveTo(px, py);
    context.lineTo(px + radius * Math.cos(pose.heading), py - radius * Math.sin(pose.heading));
    context.strokeStyle = colour("panel");
    context.lineWidth = 2;
    context.stroke();
  };

  const drawEchoes = (pose: Pose, cells: readonly string[]) => {
    robot.sonars.forEach((sonar, k) => {
      const range = Number(cells[sonars[k] ?? -1] || NaN);
      if (!(range > 0)) return;
      const from = within(pose, sonar);
      const to: Point = [
        from.x + range * Math.cos(from.heading),
        from.y + range * Math.sin(from.heading),
      ];
      line([[from.x, from.y], to], colour("mark"), 1);
      disc(to, 3, colour("mark"));
    });
  };

  /** Draws the position by odometry, in addition to the true one. */
  const drawBelief = (pose: Pose) => {
    context.beginPath();
    context.arc(...toPixel([pose.x, pose.y]), Math.max(5, robot.radius * scale), 0, 2 * Math.PI);
    context.setLineDash([4, 3]);
    context.strokeStyle = colour("dim");
    context.lineWidth = 1;
    context.stroke();
    context.setLineDash([]);
  };

  const drawTruth = (truth: NonNullable<Instant["truth"]>, { time, cells }: Instant) => {
    for (const way of ways.values()) line(way.points, colour("edge"), 1.5);
    truth.forEach(([px, py, heading, touches], i) => {
      const pose = { x: px, y: py, heading };
      const passed = ways.get(i)?.until(time) ?? [];
      line([...passed, [px, py]], colour(i === 0 ? "accent" : "dim"), i === 0 ? 2 : 1);
      if (i === 0) drawEchoes(pose, cells);
      drawBody(pose, colour(touches ? "bad" : i === 0 ? "accent" : "dim"));
    });
  };

  /** Returns the program's marks, placed in the frame of odometry or in the robot's frame. */
  const marksOf = (instant: Instant, robotIs: Pose) => {
    const { marks: drawn, readings } = readMarks(marks.map((i) => instant.cells[i] ?? ""));
    const placed = drawn
      .filter(({ frame }) => frame !== "image")
      .map(({ frame, colour, shape }) => {
        const place = (p: Point): Point => {
          const at = within(frame === "robot" ? robotIs : start, { x: p[0], y: p[1], heading: 0 });
          return [at.x, at.y];
        };
        return { colour, shape: moved(shape, place) };
      });
    const all = [...drawnWithin, ...placed.flatMap(({ shape }) => points(shape))];
    if (placed.length > 0) {
      const xs = all.map((p) => p[0]),
        ys = all.map((p) => p[1]);
      drawnWithin = [
        [Math.min(...xs), Math.min(...ys)],
        [Math.max(...xs), Math.max(...ys)],
      ];
    }
    return { placed, readings };
  };

  const draw = () => {
    const { clientWidth: width, clientHeight: height } = host;
    if (width === 0 || height === 0) return;
    clear(context, width, height);
    context.lineJoin = "round";
    context.lineCap = "round";
    const { instant } = store;
    const pose = instant && poseAt(instant.cells);
    const [truly] = instant?.truth ?? [];
    const robotIs = truly ? { x: truly[0], y: truly[1], heading: truly[2] } : pose;
    const { placed, readings } =
      instant && robotIs ? marksOf(instant, robotIs) : { placed: [], readings: [] };
    fit();
    if (world) drawWorld(world);
    if (clicked) drawCross(clicked);
    if (!instant || !pose) return;
    drawOther(instant);
    const drawMarks = () => {
      for (const { colour: name, shape } of placed) drawShape(context, shape, name, toPixel, scale);
      showReadings(readings);
    };
    if (instant.truth) {
      drawTruth(instant.truth, instant);
      drawBelief(pose);
      drawMarks();
      return;
    }
    line(believed.points, colour("edge"), 1.5);
    line([...believed.until(instant.time), [pose.x, pose.y]], colour("accent"), 2);
    drawEchoes(pose, instant.cells);
    drawBody(pose, colour("accent"));
    drawMarks();
  };
  /** Draws the path and the robot of the edited program, if it ran in the simulator. */
  const drawOther = (instant: Instant) => {
    if (otherPath.length === 0) return;
    line(otherPath, colour("mark"), 1.5);
    if (instant.others && instant.others[x] !== null)
      drawBody(poseAt(instant.others), colour("mark"));
  };
  const poseAt = (cells: readonly (string | null)[]): Pose => {
    const cell = (i: number) => Number(cells[i] ?? 0);
    return within(start, { x: cell(x), y: cell(y), heading: cell(heading) });
  };

  const grow = (instant: Instant) => {
    const pose = poseAt(instant.cells);
    instant.truth?.forEach(([px, py], i) => {
      const way = ways.get(i) ?? new Track();
      ways.set(i, way);
      way.extend(px, py, instant.time);
    });
    believed.extend(pose.x, pose.y, instant.time);
  };

  const inWorld = (points: Path["points"]): Point[] =>
    points.map(([, px, py]) => {
      const pose = within(start, { x: px ?? 0, y: py ?? 0, heading: 0 });
      return [pose.x, pose.y];
    });
  const load = () =>
    store.path(x, y, pathPoints, (answer: Path) => {
      believed.set(
        inWorld(answer.points),
        answer.points.map(([time]) => time),
      );
      otherPath = inWorld(answer.others ?? []);
      draw();
    });
  load();
  store.on("what-if", load);
  store.on("resumed", () => {
    ways.clear();
    load();
  });
  store.on("extent", () => {
    const { newest } = store;
    if (!newest) return;
    // Requests the paths from before the page was opened, once.
    if (ways.size === 0)
      newest.truth?.forEach((_, i) =>
        store.way(i, pathPoints, (way: Way) =>
          ways.get(i)?.set(
            way.points.map(([, px, py]) => [px, py]),
            way.points.map(([time]) => time),
          ),
        ),
      );
    grow(newest);
  });
  /** Converts a point to the program's coordinates, whose origin is where odometry started. */
  const byOdometry = ([px, py]: Point): Point => {
    const cos = Math.cos(start.heading),
      sin = Math.sin(start.heading);
    const dx = px - start.x,
      dy = py - start.y;
    return [cos * dx + sin * dy, cos * dy - sin * dx];
  };
  canvas.addEventListener("click", (event) => {
    if (clicks >= 0 && store.operates && store.following) {
      const place = fromPixel([event.offsetX, event.offsetY]);
      if (!store.command(`touch ${clicks} ${byOdometry(place).join(" ")}`)) return;
      clicked = place;
      draw();
      return;
    }
    const distance = ([px, py]: Point) => Math.hypot(px - event.offsetX, py - event.offsetY);
    const { points, times } = ways.get(0) ?? believed;
    const nearest = points
      .map((p, i) => ({ i, d: distance(toPixel(p)) }))
      .reduce((a, b) => (b.d < a.d ? b : a), { i: 0, d: Infinity });
    store.goToTime(times[nearest.i] ?? store.program.start);
  });
  const note = document.createElement("p");
  const place = world && worldFile ? `, in ${worldFile.name}` : "";
  note.textContent = `by odometry${place}`;
  store.on("extent", () => {
    if (store.newest?.truth) note.textContent = `simulated; dashed by odometry${place}`;
  });
  host.append(note);
  store.on("instant", draw);
  onTheme(draw);
  new ResizeObserver(draw).observe(host);
}
