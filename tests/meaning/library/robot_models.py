"""Independent implementations of the modules Behaviour, Driving and Motion, for control_models.py."""

import math

NAN = math.nan


def nanoseconds(t):
    return round(t * 1e9)


# Behaviours


def settled(q):
    since = [None]  # the time since which the layer has requested the robot

    def step(time, layer):
        since[0] = None if layer is None else time if since[0] is None else since[0]
        passes = layer is not None and nanoseconds(time - since[0]) >= nanoseconds(q)
        return layer if passes else None

    return step


def sticky(q):
    held = [None, 0.0]  # the last command, and when the layer took control of the robot

    def step(time, layer):
        command, since = held
        if command is None:
            since = time
        if layer is None and nanoseconds(time - since) < nanoseconds(q):
            layer = command
        held[:] = layer, since
        return layer

    return step


def retries(n, wait, longest, rest):
    """A task that fails while the button is pressed and succeeds with a reset. The result is 10
    for success and 20 for failure."""
    state = dict(left=n, wait=wait, sleeps=None, end=None)

    def step(time, fails, succeeds):
        s = state
        while s["end"] is None:
            if s["sleeps"] is not None:
                start, pause = s["sleeps"]
                if nanoseconds(time - start) < nanoseconds(pause):
                    return rest
                s["sleeps"] = None
            if succeeds:
                s["end"] = 10
            elif not fails:
                return 0
            elif s["left"] <= 1:
                s["end"] = 20
            else:
                pause = min(s["wait"], longest)
                s.update(left=s["left"] - 1, wait=2 * pause, sleeps=(time, max(pause, 1e-3)))
        return s["end"]

    return step


def behaviours():
    slow, kept, both = settled(0.05), sticky(0.1), (settled(0.03), sticky(0.2))
    tries = retries(4, 0.05, 0.15, -1)

    def step(time, x, heading, rate, goal, pressed, reset, *_):
        layer = 1 if pressed else None
        low = 2 if reset else None
        cell = lambda command: -9 if command is None else command
        return [
            cell(slow(time, layer)),
            cell(kept(time, layer)),
            cell(both[1](time, both[0](time, layer))),
            cell(layer if layer is not None else low),
            tries(time, pressed, reset),
        ]

    return step


# A robot that follows its commands exactly


class Ideal:
    """Integrates the command of each instant until the next one."""

    def __init__(self):
        self.x = self.y = self.heading = 0.0
        self.last = None

    def move(self, time):
        if self.last is not None:
            before, v, omega = self.last
            dt = time - before
            self.x += dt * v * math.cos(self.heading)
            self.y += dt * v * math.sin(self.heading)
            self.heading += dt * omega

    def drive(self, time, v, omega):
        self.last = time, v, omega


def limited(most, x):
    return max(-most, min(most, x))


def turn(a, b):
    return math.remainder(a - b, 2 * math.pi)


TURN, NEAR = math.radians(60), math.radians(2)


def task(command, ends):
    robot, state = Ideal(), dict(first=True, done=False)

    def step(time):
        if state["done"]:
            return [0.0, 0.0, True]
        robot.move(time)
        if not state["first"] and ends(robot):
            state["done"] = True
            return [0.0, 0.0, True]
        state["first"] = False
        v, omega = command(robot)
        robot.drive(time, v, omega)
        return [v, omega, False]

    return step


def driving():
    """`turnTo` 200 degrees, `turnBy` 450 degrees, and `forward` 1.5 m."""
    to = math.radians(200)
    left, heading = [math.radians(450)], [0.0]

    def by(robot):
        """What is left of 450 degrees. A long step may hide half a turn."""
        left[0] -= turn(robot.heading, heading[0])
        heading[0] = robot.heading
        return left[0]

    tasks = [
        task(
            lambda r: (0.0, limited(TURN, 2 * turn(to, r.heading))),
            lambda r: abs(turn(to, r.heading)) < NEAR,
        ),
        task(
            lambda r: (0.0, limited(TURN, 2 * by(r))),
            lambda r: abs(by(r)) < NEAR,
        ),
        task(
            lambda r: (limited(0.3, 1.5 - r.x), limited(TURN, 2 * turn(0, r.heading))),
            lambda r: abs(1.5 - r.x) < 0.02,
        ),
    ]
    return lambda time, *_: sum((t(time) for t in tasks), [])


# Paths, sampled every 5 mm


POINTS = [(0, 0), (2, 0), (2, 1), (2, 1), (0.5, 1), (1.5, 1)]


def paths():
    samples, stops = [], []
    length = 0.0
    for k, (a, b) in enumerate(zip(POINTS, POINTS[1:])):
        way = math.dist(a, b)
        n = max(1, round(200 * way))
        for j in range(n + 1):
            part = j / n
            point = tuple(p + part * (q - p) for p, q in zip(a, b))
            samples.append((length + part * way, point))
        length += way
    stops = [4.5, length]  # it turns back at (0.5, 1)

    def step(time, x, heading, rate, goal, *_):
        if not all(map(math.isfinite, (x, heading, goal))):
            return None
        s = 1.5 * (goal + 2)
        here = (x, heading)
        point = min(samples, key=lambda sample: abs(sample[0] - s))[1]
        d = min(math.dist(p, here) for _, p in samples)
        stop = next((stop for stop in stops if stop > s), length)
        aim = math.hypot(x, goal)
        curvature = 2 * math.sin(heading) / aim if aim > 0 else 0.0
        return [*point, d, stop, length, curvature]

    return step


MODELS = dict(behaviours=behaviours, driving=driving, paths=paths)
TOLERANCE = dict(paths=(1e-2, 1e-2), driving=(1e-9, 5e-3))
