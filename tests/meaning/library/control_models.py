"""Independent implementations of the modules Angles, Filters, Imu, Logic and Pid.

    control_models.py input SEED           prints an input with uneven steps, steps of length 0,
                                           gaps, NaN for single instants, and headings that wrap
    control_models.py steady SEED          the same with steps of constant length, without NaN
    control_models.py MODEL INPUT OUTPUT…  compares each output of frobc with a model

The models use other formulas than the library where there are any: complex numbers for angles,
biquads and small time steps for filters and motions, explicit state machines for the rest.
"""

import cmath
import csv
import math
import random
import statistics
import sys

import robot_models

NAN = math.nan
PI = math.pi


# Inputs


def steps(r, steady):
    time = 0.0
    for k in range(400):
        yield time
        if steady:
            time += 0.02
        elif r.random() < 0.05:
            pass
        elif r.random() < 0.02:
            time += r.uniform(3, 9)
        else:
            time += r.uniform(0.005, 0.06)
        time = round(time, 9)


def print_input(seed, steady):
    r = random.Random(seed)
    heading, reading, pressed, reset = 3.0, 0.0, False, False
    print("time,in.1,in.2,in.3,in.4,in.5,in.6,in.7")
    goal = 1.0
    for k, time in enumerate(steps(r, steady)):
        heading += r.gauss(0.1, 0.3)
        reading += r.gauss(0, 0.1)
        if r.random() < 0.03:
            goal = r.uniform(-2, 2)
        pressed ^= r.random() < 0.15
        reset ^= r.random() < 0.1
        x = reading + (r.uniform(-9, 9) if r.random() < 0.05 else 0)
        rate = r.gauss(0, 1)
        manual = r.uniform(-3, 3) if 150 <= k < 180 else NAN
        cells = [x, math.remainder(heading, 2 * PI), rate, goal]
        if not steady and k % 37 == 5:
            cells[r.randrange(4)] = NAN
        if not steady and k == 300:
            cells = [NAN] * 4
        bools = ["true" if b else "false" for b in (pressed, reset)]
        print(f"{time:.9f}", *map(repr, cells), *bools, repr(manual), sep=",")


# Code that models share


def finite(*xs):
    return all(math.isfinite(x) for x in xs)


class Clock:
    """The step of each instant, and the step that controllers use."""

    def __init__(self):
        self.last = self.usual = None

    def tick(self, time):
        self.dt = 0.0 if self.last is None else time - self.last
        self.last = time
        if not self.usual:
            self.control = self.dt
        else:
            self.control = min(self.dt, max(0.2, 2 * self.usual))
        self.usual = self.control or self.usual


class Held:
    """A filter whose state is one number: that number, and the time of its last finite output."""

    def __init__(self, first, update):
        self.first, self.update, self.state, self.time = first, update, None, 0.0

    def __call__(self, time, dt, *inputs):
        if self.state is None:
            y = self.first(*inputs)
        else:
            y = self.update(self.state, time - self.time, *inputs)
        if not finite(*inputs):
            return NAN
        self.state, self.time = y, time
        return y


def share(tau, h):
    return h / (max(0, tau) + h) if h > 0 else 0.0


def wrapped(a):
    return cmath.phase(cmath.exp(1j * a)) if finite(a) else NAN


def turn(a, b):
    """The shorter way from b to a."""
    return cmath.phase(cmath.exp(1j * a) / cmath.exp(1j * b)) if finite(a, b) else NAN


class Slope:
    """The derivative of the output of a low-pass filter, computed from the filter."""

    def __init__(self, tau):
        self.tau, self.low, self.x, self.d, self.time = tau, None, None, 0.0, 0.0

    def __call__(self, time, x):
        if not finite(x):
            return NAN
        h = time - self.time
        if self.x is None:
            self.low = x
        elif self.tau > 0:
            # the low-pass filter lags behind its input by tau times the slope
            self.low = x - (self.tau / (self.tau + h)) * (x - self.x + self.tau * self.d)
            self.d = (x - self.low) / self.tau
        elif h > 0:
            self.d = (x - self.x) / h
        self.x, self.time = x, time
        return self.d


# Angles


def angles():
    clock = Clock()
    unwrapped = Held(wrapped, lambda y, h, a: y + turn(a, y))
    low = Held(wrapped, lambda y, h, a: wrapped(y + share(0.3, h) * turn(a, y)))
    limited = Held(wrapped, lambda y, h, a: wrapped(y + max(-limit(), min(limit(), turn(a, y)))))
    limit = lambda: 2 * clock.control
    fused = Held(
        lambda w, a: wrapped(a),
        lambda y, h, w, a: wrapped(y + w * h + share(0.5, h) * turn(a, y + w * h)),
    )
    last = []
    before = [None, 0.0, 0.0]  # the angle, its time, the rate

    def step(time, x, a, w, goal, *_):
        clock.tick(time)
        rate = NAN
        if finite(a):
            h = time - before[1]
            if before[0] is not None and h > 0:
                before[2] = turn(a, before[0]) / h
            before[:2] = a, time
            rate = before[2]
            last[:] = ([a] + (last or [a] * 4))[:4]
        vectors = [k * cmath.exp(1j * b) for k, b in zip([3, 2, 1, 1], last)]
        mean = cmath.phase(sum(vectors)) if finite(a) else NAN
        pair = cmath.phase(cmath.exp(1j * a) + cmath.exp(1j * goal)) if finite(a, goal) else NAN
        return [
            unwrapped(time, 0, a),
            rate,
            low(time, 0, a),
            limited(time, 0, a),
            pair,
            mean,
            fused(time, 0, w, a),
        ]

    return step


# Inertial measurement units


def imu():
    """Readings arrive while the button is pressed. A reset means that there is no magnetometer."""
    state = []  # the heading after the last reading without a NaN, and its time

    def step(time, x, a, w, goal, arrives, no_compass, *_):
        if not arrives:
            return [state[0] if state else 0.0]
        if not state:
            heading = 0.0 if no_compass else a
        else:
            h = time - state[1]
            heading = wrapped(state[0] + w * h)
            if not no_compass:
                heading = wrapped(heading + share(0.5, h) * turn(a, heading))
        if finite(heading):
            state[:] = [heading, time]
        return [heading]

    return step


# Filters


def alpha_beta(alpha, beta):
    state = []

    def step(time, x):
        if not finite(x):
            return NAN, NAN
        if not state:
            state[:] = [x, 0.0, time]
        y, v, t = state
        h = time - t
        r = x - (y + v * h)
        state[:] = [y + v * h + alpha * r, v + (beta / h * r if h > 0 else 0), time]
        return state[:2]

    return step


def second_order(f, q):
    """The trapezoidal rule for x'' + w/q x' + w² x = w² u, prewarped, by Cramer's rule. The state is
    the output of the low-pass filter, its derivative divided by w, and the input of the last step,
    in the units of the current step."""
    state = []

    def step(time, u):
        if not finite(u):
            return [NAN] * 3
        if not state:
            state[:] = [u, 0.0, time]
        low, band, t = state
        n = f * (time - t)
        if n >= 0.5:
            low, band, n = u, 0.0, 0.0
        g = math.tan(PI * n)
        # s1 and s2 are what the integrators hold between steps; the outputs l and b satisfy
        # l = s2 + g b and b = s1 + g (u - b / q - l)
        det = (1 + g / q) + g * g
        b = (band + g * u - g * low) / det
        l = (low * (1 + g / q) + g * (band + g * u)) / det
        state[:] = [l + g * b, b + g * (u - b / q - l), time]
        return [l, b / q, u - b / q - l]

    return step


def rank_median(xs):
    return NAN if any(map(math.isnan, xs)) else statistics.median(xs)


def hampel(k, xs):
    m = rank_median(xs)
    return xs[0] if abs(xs[0] - m) <= k * 1.4826 * rank_median([abs(x - m) for x in xs]) else m


def jumps(d, q):
    state = []  # the accepted value, and the time of the last accepted finite input

    def step(time, x):
        if not state:
            state[:] = [x, time] if finite(x) else []
            return x
        y, t = state
        late = round((time - t) * 1e9) >= round(q * 1e9)
        if finite(x) and (late or abs(x - y) <= d):
            state[:] = [x, time]
            return x
        return NAN if late else y

    return step


def filters():
    clock = Clock()
    low = Held(lambda x: x, lambda y, h, x: y + share(0.3, h) * (x - y))
    slopes = [Slope(0.1), Slope(0.0)]
    fused = Held(
        lambda w, x: x,
        lambda y, h, w, x: (y + w * h) * (1 - share(0.5, h)) + share(0.5, h) * x,
    )
    ab = alpha_beta(0.5, 0.2)
    butter, vibration = second_order(3, math.sqrt(0.5)), second_order(8, 4)
    ramp = Held(
        lambda x: x,
        lambda y, h, x: min(y + min(0.2, clock.control), max(y - min(0.2, 3 * clock.control), x)),
    )
    kept = jumps(0.5, 0.15)
    last = []

    def step(time, x, a, w, goal, *_):
        clock.tick(time)
        window = ([x] + (last or [x] * 7))[:7]
        if finite(x):
            last[:] = window
        l = butter(time, x)
        return [
            x - low(time, 0, x),
            *[s(time, x) for s in slopes],
            fused(time, 0, w, x),
            *ab(time, x),
            l[0],
            l[2],
            x - vibration(time, x)[1],
            ramp(time, 0, x),
            rank_median(window[:3]),
            rank_median(window[:5]),
            rank_median(window),
            rank_median(window[:4]),
            hampel(3, window),
            kept(time, x),
        ]

    return step


def biquads():
    """The filters of second order from the Audio EQ Cookbook, with steps of 0.02 s."""

    def biquad(f, q, coefficients):
        w = 2 * PI * f * 0.02
        alpha, cos = math.sin(w) / (2 * q), math.cos(w)
        b = coefficients(alpha, cos)
        past = []

        def step(x):
            if not past:
                y = x * sum(b) / (2 - 2 * cos)  # at rest
                past[:] = [x, x, y, y]
            x1, x2, y1, y2 = past
            y = b[0] * x + b[1] * x1 + b[2] * x2 + 2 * cos * y1 - (1 - alpha) * y2
            past[:] = [x, x1, y / (1 + alpha), y1]
            return y / (1 + alpha)

        return step

    low = biquad(3, math.sqrt(0.5), lambda a, c: [(1 - c) / 2, 1 - c, (1 - c) / 2])
    high = biquad(3, math.sqrt(0.5), lambda a, c: [(1 + c) / 2, -1 - c, (1 + c) / 2])
    band = biquad(3, 2, lambda a, c: [a, 0, -a])
    stop = biquad(8, 4, lambda a, c: [1, -2 * c, 1])
    return lambda time, x, *_: [low(x), high(x), band(x), stop(x)]


# Motions


def motions():
    """A double integrator with limits, in steps of 0.02 ms, by the rule of the switching curve."""
    most, a = 1.0, 2.0
    clock = Clock()
    state = []

    def step(time, x, heading, w, goal, *_):
        clock.tick(time)
        if not finite(goal):
            return [NAN, NAN]
        if not state:
            state[:] = [goal, 0.0]
        y, v = state
        n = max(1, round(clock.control / 2e-5))
        h = clock.control / n
        for _ in range(n if h else 0):
            d = goal - y
            if abs(d) <= a * h * h and abs(v) <= 2 * a * h:
                y, v = goal, 0.0
                break
            wanted = math.copysign(min(most, math.sqrt(2 * a * abs(d))), d)
            new = v + max(-a * h, min(a * h, wanted - v))
            y, v = y + (v + new) / 2 * h, new
        state[:] = [y, v]
        return [y, v]

    return step


# Logic


def logic():
    state = dict(
        s=False, r=False, on=None, rose=False, last=False, true=None, false=None, flip=False
    )
    ns = lambda t: round(t * 1e9)

    def step(time, x, a, w, goal, b, reset, *_):
        s = state
        s["s"] = True if b else False if reset else s["s"]
        s["r"] = False if reset else True if b else s["r"]
        if s["on"] is not None and ns(time - s["on"]) >= ns(0.3):
            s["on"] = None
        rises = b and not s["last"]
        if rises and s["on"] is None:
            s["on"] = time
        if b and (s["true"] is None or not s["last"]):
            s["true"] = time
        if b:
            s["false"] = time
        on_delay = b and ns(time - s["true"]) >= ns(0.1)
        off_delay = b or (s["false"] is not None and ns(time - s["false"]) < ns(0.1))
        s["flip"] ^= rises and time > 0
        s["last"] = b
        return [s["s"], s["r"], s["on"] is not None, on_delay, off_delay, s["flip"]]

    return step


# Controllers


def controller(low, high, kp, ki, kd, b=1.0, c=0.0, tf=0.0, start=None):
    """An incremental PID: the integral is what remains of the output."""
    clock = Clock()
    of_r, of_y = Slope(tf), Slope(tf)
    state = dict(total=None, error=None)

    def step(time, r, y, rate=None, manual=None, ff=0.0):
        clock.tick(time)
        sr, sy = of_r(time, r), of_y(time, y)
        p = kp * (b * r - y) + ff
        d = kd * (c * sr - (sy if rate is None else rate))
        old, total = state["total"], None
        if manual is not None:
            total = min(max(manual, low), high) - p - d if ki else 0.0
        elif old is None:
            total = 0.0 if start is None or not ki else min(max(start, low), high) - p - d
        else:
            e = state["error"]
            more = ki * (e or 0.0) * clock.control
            total = old + more
            if more > 0:
                total = max(old, min(total, high - p - max(d, 0.0)))
            elif more < 0:
                total = min(old, max(total, low - p - min(d, 0.0)))
        u = manual if manual is not None else p + d + total
        if not finite(p + d):
            return min(max(u, low), high) if finite(u) else NAN
        state["total"] = total
        if finite(r - y):
            state["error"] = r - y
        return min(max(u, low), high)

    return step


def controllers():
    simple = controller(-2, 2, 2, 0.5, 0.1)
    rich = controller(0, 1.5, 2, 1, 0.2, b=0.4, c=0.3, tf=0.1)
    measured = controller(-2, 2, 2, 0.5, 0.3)
    tracked = controller(-2, 2, 2, 0.5, 0.1, start=1.25)
    fed = controller(-2, 2, 1, 0.5, 0)
    of_angles = controller(-2, 2, 2, 0.5, 0.1)
    unwrapped = Held(wrapped, lambda y, h, a: y + turn(a, y))

    def step(time, x, a, w, goal, pressed, reset, manual):
        h = unwrapped(time, 0, a)
        # with an error that is not finite, only the output of manual control is known
        return [
            simple(time, goal, x),
            rich(time, goal, x),
            measured(time, goal, x, rate=w),
            tracked(time, goal, x, manual=manual if finite(manual) else None),
            fed(time, goal, x, ff=w),
            of_angles(time, h + turn(goal, h), h),
        ]

    return step


MODELS = dict(
    angles=angles,
    imu=imu,
    filters=filters,
    biquads=biquads,
    motions=motions,
    logic=logic,
    controllers=controllers,
    **robot_models.MODELS,
)
# Absolute differences, in double and in single precision. The model of motions is approximate.
TOLERANCE = dict(motions=(5e-3, 1e-2), angles=(1e-9, 2e-4), imu=(1e-9, 2e-4), biquads=(1e-9, 2e-4))
TOLERANCE.update(robot_models.TOLERANCE)


def number(cell):
    return cell == "true" if cell in ("true", "false") else float(cell)


def differ(model, wanted, cell, tolerance):
    if isinstance(wanted, bool):
        return wanted != number(cell)
    found = float(cell)
    if math.isnan(wanted) or math.isnan(found):
        return math.isnan(wanted) != math.isnan(found)
    apart = abs(wanted - found)
    if model in ("angles", "imu") and max(abs(wanted), abs(found)) < 3.2:
        apart = min(apart, 2 * PI - apart)
    return apart > tolerance * max(1, abs(wanted))


def compare(model, inputs, outputs):
    with open(inputs) as file:
        rows = list(csv.reader(file))[1:]
    step = MODELS[model]()
    wanted = [step(float(row[0]), *map(number, row[1:])) for row in rows]
    # a model returns None if it does not know the values
    known = [row for row in wanted if row is not None]
    for name in outputs:
        with open(name) as file:
            found = list(csv.reader(file))[1:]
        tolerance = TOLERANCE.get(model, (1e-9, 1e-3))["float" in name]
        wrong = 0
        for k, (w, f) in enumerate(zip(wanted, found, strict=True)):
            if w is None:
                continue
            for column, (x, cell) in enumerate(zip(w, f[1:], strict=True)):
                if differ(model, x, cell, tolerance):
                    wrong += 1
                    if wrong <= 5:
                        print(f"{name}: row {k} ({f[0]} s), out.{column + 1} is {cell}, not {x}")
        values = sum(map(len, known))
        print(f"{name}: {values} values, {wrong} differ")


if __name__ == "__main__":
    if sys.argv[1] in ("input", "steady"):
        print_input(int(sys.argv[2]), sys.argv[1] == "steady")
    else:
        compare(sys.argv[1], sys.argv[2], sys.argv[3:])
