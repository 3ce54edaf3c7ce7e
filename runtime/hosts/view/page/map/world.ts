// World files: parses the part of TOML that they use, and extracts what the map shows.

import { placed, type Pose } from "./pose";

export type Point = readonly [number, number];

export interface World {
  readonly start: Pose;
  readonly walls: readonly { readonly points: readonly Point[]; readonly thickness: number }[];
  readonly solids: readonly (readonly Point[])[];
  readonly circles: readonly Disc[];
  /** Boxes and balls at their initial positions. Robots can push them. */
  readonly boxes: readonly Box[];
  readonly balls: readonly Disc[];
  readonly cones: readonly Disc[];
  readonly lamps: readonly Point[];
  /** The two ends of each poster, its centre, and a point in front of it. */
  readonly posters: readonly (readonly [Point, Point, Point, Point])[];
  readonly holes: readonly (readonly Point[])[];
  /** Reflectance of the floor: 0 is black, 1 white. */
  readonly floor: number;
  readonly patches: readonly { readonly points: readonly Point[]; readonly reflectance: number }[];
  readonly lines: readonly {
    readonly points: readonly Point[];
    readonly width: number;
    readonly reflectance: number;
  }[];
}

export interface Box {
  readonly pose: Pose;
  readonly length: number;
  readonly width: number;
}

export interface Disc {
  readonly center: Point;
  readonly radius: number;
}

type Value = string | number | boolean | Value[];
type Table = Map<string, Value>;

/** Removes comments; no world file has a `#` in a string. */
function withoutComments(text: string): string {
  return text
    .split("\n")
    .map((line) => line.replace(/#.*$/, ""))
    .join("\n");
}

function parseValue(text: string): Value {
  // TOML allows a trailing comma in an array; JSON does not.
  return JSON.parse(text.trim().replace(/,(\s*\])/g, "$1")) as Value;
}

/** Matches the name of a table, or a key with its value. A value extends to the next key or table
 * name. */
const tableName = String.raw`\[\[?\s*(\w+)\s*\]\]?\s*$`;
const nextEntry = String.raw`\s*(?:\w+\s*=|\[\[?\s*\w+\s*\])`;
const entry = new RegExp(
  String.raw`^\s*${tableName}|^\s*(\w+)\s*=\s*((?:(?!^${nextEntry}).*\n?)+)`,
  "gm",
);

/** Returns all tables by name, in order; ignores invalid values. */
function tables(text: string): Map<string, Table[]> {
  const all = new Map<string, Table[]>();
  let table: Table = new Map();
  for (const [, name, key, value] of withoutComments(text).matchAll(entry)) {
    if (name !== undefined) {
      table = new Map();
      all.set(name, [...(all.get(name) ?? []), table]);
    } else if (key !== undefined && value !== undefined) {
      try {
        table.set(key, parseValue(value));
      } catch {
        // The map does not need this value.
      }
    }
  }
  return all;
}

function number(table: Table | undefined, key: string, otherwise: number): number {
  const value = table?.get(key);
  return typeof value === "number" ? value : otherwise;
}

function point(value: Value | undefined): Point {
  if (!Array.isArray(value)) return [0, 0];
  const [x, y] = value;
  return [typeof x === "number" ? x : 0, typeof y === "number" ? y : 0];
}

function points(table: Table): Point[] {
  const value = table.get("points");
  const all = Array.isArray(value) ? value.map(point) : [];
  const [first] = all;
  return table.get("closed") === true && first ? [...all, first] : all;
}

const angle = (table: Table, key: string) => (number(table, key, 0) * Math.PI) / 180;

function box(table: Table): Box {
  const [x, y] = point(table.get("center"));
  const [length, width] = point(table.get("size"));
  return { pose: { x, y, heading: angle(table, "angle_deg") }, length, width };
}

/** Returns the corners of a box at this pose. */
export function corners({ length, width }: Box, pose: Pose): Point[] {
  const corner = (along: number, across: number): Point =>
    placed(pose, [along * length, across * width]);
  return [corner(-0.5, -0.5), corner(0.5, -0.5), corner(0.5, 0.5), corner(-0.5, 0.5)];
}

/** Returns the two ends of a poster or a tag, its centre, and a point in front of it. The map draws
 * it as a line with a tick on the side that it faces. */
function poster(table: Table): [Point, Point, Point, Point] {
  const [x, y] = point(table.get("center"));
  const size = table.get("size");
  const half = (typeof size === "number" ? size : point(size)[0]) / 2;
  const pose = { x, y, heading: angle(table, "facing_deg") };
  return [placed(pose, [0, half]), placed(pose, [0, -half]), [x, y], placed(pose, [0.08, 0])];
}

function disc(radius: number): (table: Table) => Disc {
  return (table) => {
    const [first] = points(table).length > 0 ? points(table) : wayOf(table);
    return {
      center: first ?? point(table.get("center")),
      radius: number(table, "radius", radius),
    };
  };
}

/** Returns the path that a ball follows; empty if it has none. */
function wayOf(table: Table): Point[] {
  const way = table.get("way");
  return Array.isArray(way) ? way.map(point) : [];
}

export function readWorld(text: string): World {
  const all = tables(text);
  const of = (name: string) => all.get(name) ?? [];
  const [start] = of("start");
  return {
    start: {
      x: number(start, "x", 0),
      y: number(start, "y", 0),
      heading: start ? angle(start, "heading_deg") : 0,
    },
    walls: of("wall").map((wall) => ({
      points: points(wall),
      thickness: number(wall, "thickness", 0.1),
    })),
    solids: of("polygon").map(points),
    circles: of("circle").map(disc(0)),
    boxes: of("box").map(box),
    balls: of("ball").map(disc(0.1)),
    cones: of("cone").map(disc(0.15)),
    lamps: of("lamp").map((lamp) => point(lamp.get("position"))),
    posters: [...of("poster"), ...of("tag")].map(poster),
    holes: of("hole").map(points),
    floor: number(of("floor")[0], "reflectance", 1),
    patches: of("patch").map((patch) => ({
      points: points(patch),
      reflectance: number(patch, "reflectance", 0.5),
    })),
    lines: of("tape").map((tape) => ({
      points: points(tape),
      width: number(tape, "width", 0.05),
      reflectance: number(tape, "reflectance", 0.05),
    })),
  };
}

/** Returns points that determine the bounding box of everything in a world. */
export function worldPoints(world: World): Point[] {
  const around = ({ center: [x, y], radius }: Disc): Point[] => [
    [x - radius, y - radius],
    [x + radius, y + radius],
  ];
  return [
    ...[...world.walls, ...world.lines, ...world.patches].flatMap((each) => each.points),
    ...[...world.solids, ...world.holes].flat(),
    ...world.boxes.flatMap((each) => corners(each, each.pose)),
    ...[...world.circles, ...world.balls, ...world.cones].flatMap(around),
    ...world.lamps,
    ...world.posters.flatMap(([a, b]) => [a, b]),
  ];
}
