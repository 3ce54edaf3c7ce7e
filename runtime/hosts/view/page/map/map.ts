// The map: the world, the robots with their paths and sonars, and the program's marks.
import { clear } from "../canvas";
import type { Instant } from "../protocol";
import type { Store } from "../store";
import { colour, onTheme } from "../theme";
import { drawEchoes, drawOutline, drawRobot, type Echo } from "./body";
import { startGestures } from "./gestures";
import { drawShape, markSignals, moved, points, readingsList, readMarks } from "./marks";
import { placed, relative, within, type Pose } from "./pose";
import { robotNamed } from "./robots";
import { drawScan, readScan } from "./scan";
import { drawMovable, drawScale, drawScene, Pen } from "./scene";
import { Extent, View } from "./view";
import { viewButtons } from "./view_buttons";
import { drawTimes, drawWay } from "./way";
import { Ways } from "./ways";
import { readWorld, worldPoints, type Point, type World } from "./world";

/** Difference between odometry and truth, in metres, above which the map shows both. */
const drift = 0.03;

export function startMap(store: Store, host: HTMLElement): View | null {
  const { signals, robot: robotName, world: worldFile } = store.program;
  const number = (name: string) => signals.findIndex((signal) => signal.name === name);
  const x = number("in.odometry.position.x");
  const y = number("in.odometry.position.y");
  const heading = number("in.odometry.heading");
  const canvas = document.createElement("canvas");
  const context = canvas.getContext("2d");
  // The layer that does not change between instants: the world and the grid.
  const scene = document.createElement("canvas").getContext("2d");
  if (x < 0 || y < 0 || heading < 0 || !context || !scene) {
    host.hidden = true;
    document.body.classList.add("no-map");
    return null;
  }
  canvas.tabIndex = 0;
  canvas.role = "application";
  canvas.ariaLabel = "Map: pan with the arrow keys, zoom with + and -";
  host.append(canvas);
  const robot = robotNamed(robotName);
  const sonars = robot.sonars.map((_, k) => number(`in.sonar[${k}]`));
  const world: World | null = worldFile && readWorld(worldFile.text);
  const start: Pose = world?.start ?? { x: 0, y: 0, heading: 0 };
  const marks = markSignals(signals);
  const showReadings = readingsList(host);
  const clicks = store.program.console.findIndex((control) => control.kind === "map");
  /** The last click that was sent to the program. */
  let clicked: Point | null = null;
  const extent = new Extent();
  extent.add([start.x, start.y], 0.5);
  if (world) extent.addAll(worldPoints(world));
  const view = new View();
  const pen = new Pen(context, view);
  const ways = new Ways(store, x, y, start, extent, () => draw());

  const poseAt = (cells: readonly (string | null)[]): Pose => {
    const cell = (i: number) => Number(cells[i] ?? 0);
    return within(start, { x: cell(x), y: cell(y), heading: cell(heading) });
  };

  let sceneKey = "";
  const showScene = () => {
    const key = `${view.key} ${devicePixelRatio} ${colour("floor")}`;
    if (key !== sceneKey) {
      clear(scene, view.width, view.height);
      scene.lineJoin = scene.lineCap = "round";
      drawScene(new Pen(scene, view), world);
      sceneKey = key;
    }
    context.drawImage(scene.canvas, 0, 0, view.width, view.height);
  };

  const drawCross = (at: Point) => {
    const [px, py] = view.toPixel(at);
    const arm = 6;
    context.beginPath();
    for (const side of [-1, 1]) {
      context.moveTo(px - arm, py - side * arm);
      context.lineTo(px + arm, py + side * arm);
    }
    pen.stroke(colour("mark"), 2);
  };

  const echoesOf = ({ recent, truth }: Instant): Echo[] =>
    recent.flatMap(([signal, range, x, y, heading]) => {
      const sonar = robot.sonars[sonars.indexOf(signal)];
      if (!sonar || x === null || y === null || heading === null) return [];
      const pose = { x, y, heading };
      return [{ sonar, range, pose: truth ? pose : within(start, pose) }];
    });

  const drawScans = ({ recent, truth }: Instant) => {
    for (const [, , x, y, heading, cell] of recent) {
      const places = cell === undefined ? null : readScan(cell);
      if (!places || x === null || y === null || heading === null) continue;
      const pose = { x, y, heading };
      drawScan(pen, places, truth ? pose : within(start, pose));
    }
  };

  /** Marks the places where the robot has touched an object so far. */
  const drawContacts = (now: number) => {
    const arm = 4;
    context.beginPath();
    for (const [time, ...at] of store.contacts) {
      if (time > now) break;
      const [px, py] = view.toPixel(at);
      for (const side of [-1, 1]) {
        context.moveTo(px - arm, py - side * arm);
        context.lineTo(px + arm, py + side * arm);
      }
    }
    pen.stroke(colour("bad"), 2.5);
  };

  /** Draws the paths of all robots. For the first robot, which runs the shown program, also draws
   * its sonars, scans and collisions. */
  const drawWays = (instant: Instant, robots: readonly Pose[], believed: Pose) => {
    drawOutline(pen, robot, start, colour("robot-edge"));
    robots.forEach((pose, i) => {
      const track = ways.true[i] ?? (i === 0 ? ways.believed : undefined);
      if (track) drawWay(pen, track, instant.time, [pose.x, pose.y], i === 0);
    });
    const [first] = robots;
    if (!first) return;
    const { program } = store;
    if (robots.length === 1)
      drawTimes(pen, ways.first, instant.time, [program.start, program.end], [first.x, first.y]);
    if (instant.truth && Math.hypot(believed.x - first.x, believed.y - first.y) > drift) {
      const passed = ways.believed.passed(instant.time);
      const all: Point[] = [...ways.believed.points.slice(0, passed), [believed.x, believed.y]];
      pen.line(all, colour("believed"), 1.3, [1, 5]);
      drawOutline(pen, robot, believed, colour("believed"));
    }
    drawEchoes(pen, robot, echoesOf(instant));
    drawScans(instant);
    drawContacts(instant.time);
  };

  /** Returns the program's marks, converted from the odometry frame or the robot's frame to world
   * coordinates. */
  const marksOf = (instant: Instant, robotIs: Pose) => {
    const { marks: drawn, readings } = readMarks(marks.map((i) => instant.cells[i] ?? ""));
    const shapes = drawn
      .filter(({ frame }) => frame !== "image")
      .map(({ frame, colour, shape }) => ({
        colour,
        shape: moved(shape, (p) => placed(frame === "robot" ? robotIs : start, p)),
      }));
    for (const { shape } of shapes) extent.addAll(points(shape));
    return { shapes, readings };
  };

  const drawInstant = (
    instant: Instant,
    robots: readonly Pose[],
    believed: Pose,
    shapes: ReturnType<typeof marksOf>["shapes"],
  ) => {
    drawWays(instant, robots, believed);
    if (ways.other.length > 0) {
      pen.line(ways.other, colour("mark"), 1.5);
      if (instant.others && instant.others[x] !== null)
        drawRobot(pen, robot, poseAt(instant.others), colour("floor"), colour("mark"));
    }
    robots.forEach((pose, i) => {
      const touches = instant.truth?.[i]?.[3] === 1;
      const fill = colour(touches ? "bad" : i === 0 ? "robot" : "dim");
      drawRobot(pen, robot, pose, fill, colour("robot-edge"));
    });
    for (const { colour: name, shape } of shapes)
      drawShape(context, shape, name, view.toPixel, view.scale);
  };

  const draw = () => {
    const { clientWidth: width, clientHeight: height } = canvas;
    if (width === 0 || height === 0) return;
    clear(context, width, height);
    context.lineJoin = context.lineCap = "round";
    const { instant } = store;
    const believed = instant ? poseAt(instant.cells) : start;
    const robots = instant?.truth?.map(([x, y, heading]) => ({ x, y, heading })) ?? [believed];
    for (const pose of robots) extent.add([pose.x, pose.y], robot.radius);
    const drawn = instant && marksOf(instant, robots[0] ?? believed);
    if (drawn) showReadings(drawn.readings);
    view.width = width;
    view.height = height;
    view.update(extent, [robots[0]?.x ?? 0, robots[0]?.y ?? 0]);
    showScene();
    if (world) drawMovable(pen, world, instant?.objects);
    if (instant && drawn) drawInstant(instant, robots, believed, drawn.shapes);
    if (clicked) drawCross(clicked);
    drawScale(pen);
  };

  const viewed = () => store.changed("view");
  const showMode = viewButtons(host, view, viewed);
  startGestures(canvas, view, {
    moved: viewed,
    clicked: (at) => {
      const place = view.fromPixel(at);
      if (clicks >= 0 && store.operates && store.following) {
        if (!store.command(`touch ${clicks} ${relative(start, place).join(" ")}`)) return;
        clicked = place;
        draw();
        return;
      }
      store.goToTime(ways.first.nearest(place) ?? store.program.start);
    },
  });

  const note = document.createElement("p");
  const place = world && worldFile ? ` in ${worldFile.name}` : "";
  note.textContent = `by odometry${place}; click the path to go there`;
  store.on("extent", () => {
    if (store.newest?.truth) note.textContent = `simulated${place}; dotted: by odometry`;
  });
  host.append(note);
  store.on("instant", draw);
  store.on("view", () => {
    showMode();
    draw();
  });
  onTheme(draw);
  new ResizeObserver(draw).observe(canvas);
  return view;
}
