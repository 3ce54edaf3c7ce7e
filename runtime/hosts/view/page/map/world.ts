// World files: parses the part of TOML that they use, and extracts what the map shows.

export type Point = readonly [number, number];

export interface World {
  readonly start: { readonly x: number; readonly y: number; readonly heading: number };
  readonly walls: readonly { readonly points: readonly Point[]; readonly thickness: number }[];
  readonly solids: readonly (readonly Point[])[];
  readonly circles: readonly { readonly center: Point; readonly radius: number }[];
  readonly lines: readonly { readonly points: readonly Point[]; readonly width: number }[];
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
  // TOML allows a comma at the end of an array, JSON does not.
  return JSON.parse(text.trim().replace(/,(\s*\])/g, "$1")) as Value;
}

/** Matches a line with a table's name, or a key and its value, up to the next of either. */
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
        // Not needed for the map.
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

function box(table: Table): Point[] {
  const [x, y] = point(table.get("center"));
  const [length, width] = point(table.get("size"));
  const angle = (number(table, "angle_deg", 0) * Math.PI) / 180;
  const corner = (along: number, across: number): Point => [
    x + along * length * Math.cos(angle) - across * width * Math.sin(angle),
    y + along * length * Math.sin(angle) + across * width * Math.cos(angle),
  ];
  return [corner(-0.5, -0.5), corner(0.5, -0.5), corner(0.5, 0.5), corner(-0.5, 0.5)];
}

export function readWorld(text: string): World {
  const all = tables(text);
  const of = (name: string) => all.get(name) ?? [];
  const [start] = of("start");
  return {
    start: {
      x: number(start, "x", 0),
      y: number(start, "y", 0),
      heading: (number(start, "heading_deg", 0) * Math.PI) / 180,
    },
    walls: of("wall").map((wall) => ({
      points: points(wall),
      thickness: number(wall, "thickness", 0.1),
    })),
    solids: [...of("polygon").map(points), ...of("box").map(box)],
    circles: of("circle").map((circle) => ({
      center: point(circle.get("center")),
      radius: number(circle, "radius", 0),
    })),
    lines: of("tape").map((tape) => ({ points: points(tape), width: number(tape, "width", 0.05) })),
  };
}
