// The robots' sizes, and the positions and directions of their sonars.

export interface Sonar {
  readonly x: number;
  readonly y: number;
  readonly heading: number;
}

export interface Robot {
  readonly radius: number;
  readonly sonars: readonly Sonar[];
}

// The sonars of stdlib/Pioneer.frob: metres ahead, metres to the left, degrees.
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

const radians = (degrees: number) => (degrees * Math.PI) / 180;
const scoutRadius = 0.2;

const robots: Readonly<Record<string, Robot>> = {
  pioneer: {
    radius: 0.22,
    sonars: pioneerSonars.map(([x, y, degrees]) => ({ x, y, heading: radians(degrees) })),
  },
  // The sonars of stdlib/Scout.frob.
  scout: {
    radius: scoutRadius,
    sonars: Array.from({ length: 16 }, (_, k) => {
      const heading = radians(22.5 * k);
      return { x: scoutRadius * Math.cos(heading), y: scoutRadius * Math.sin(heading), heading };
    }),
  },
  create: { radius: 0.17425, sonars: [] },
};

export function robotNamed(name: string): Robot {
  return robots[name] ?? { radius: 0.2, sonars: [] };
}
