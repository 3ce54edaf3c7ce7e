// The shapes of the robots, and the positions and directions of their sonars, as in the
// simulator.
import type { Point } from "./world";

export interface Sonar {
  readonly x: number;
  readonly y: number;
  readonly heading: number;
}

export interface Robot {
  /** The corners of the body; empty for a round body. */
  readonly outline: readonly Point[];
  readonly radius: number;
  /** Half the distance between the driving wheels, and their radius; 0 if they are unknown. */
  readonly wheelSide: number;
  readonly wheelRadius: number;
  /** Distance from the robot's origin to the tip of the arrow that shows its heading. */
  readonly tip: number;
  readonly sonars: readonly Sonar[];
  /** Half the opening angle of a sonar's cone. */
  readonly halfAngle: number;
  /** The reading of a sonar that has no echo, in metres. */
  readonly reach: number;
}

// The position of each sonar in stdlib/Pioneer.frob, in metres ahead and to the left, and its
// direction, in degrees.
const pioneerSonars = [
  [0.069, 0.136, 90],
  [0.114, 0.119, 50],
  [0.148, 0.078, 30],
  [0.166, 0.027, 10],
  [0.166, -0.027, -10],
  [0.148, -0.078, -30],
  [0.114, -0.119, -50],
  [0.069, -0.136, -90],
  [-0.157, -0.136, -90],
  [-0.203, -0.119, -130],
  [-0.237, -0.078, -150],
  [-0.255, -0.027, -170],
  [-0.255, 0.027, 170],
  [-0.237, 0.078, 150],
  [-0.203, 0.119, 130],
  [-0.157, 0.136, 90],
] as const;

/** The outline of a Pioneer P3-DX: a rectangle whose corners are cut off. */
function pioneerOutline(): Point[] {
  const front = 0.211,
    back = -0.3,
    side = 0.2125,
    cut = 0.115;
  return [
    [front, cut - side],
    [front, side - cut],
    [front - cut, side],
    [back + cut, side],
    [back, side - cut],
    [back, cut - side],
    [back + cut, -side],
    [front - cut, -side],
  ];
}

const radians = (degrees: number) => (degrees * Math.PI) / 180;
const scoutRadius = 0.2;

const unknown: Robot = {
  outline: [],
  radius: 0.2,
  wheelSide: 0,
  wheelRadius: 0,
  tip: 0.17,
  sonars: [],
  halfAngle: 0,
  reach: Infinity,
};

const robots: Readonly<Record<string, Robot>> = {
  pioneer: {
    outline: pioneerOutline(),
    radius: 0.3,
    wheelSide: 0.165,
    wheelRadius: 0.09,
    tip: 0.166,
    sonars: pioneerSonars.map(([x, y, degrees]) => ({ x, y, heading: radians(degrees) })),
    halfAngle: radians(12),
    reach: 5,
  },
  // The sonars of stdlib/Scout.frob.
  scout: {
    ...unknown,
    radius: scoutRadius,
    wheelSide: 0.16,
    wheelRadius: 0.08,
    sonars: Array.from({ length: 16 }, (_, k) => {
      const heading = radians(22.5 * k);
      return { x: scoutRadius * Math.cos(heading), y: scoutRadius * Math.sin(heading), heading };
    }),
    halfAngle: radians(10),
    reach: 255 * 0.0254,
  },
  create: { ...unknown, radius: 0.17425, wheelSide: 0.109, wheelRadius: 0.036, tip: 0.15 },
};

export function robotNamed(name: string): Robot {
  return robots[name] ?? unknown;
}
