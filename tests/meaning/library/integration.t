Integration, in both engines and in both precisions of Float. numpy computes the same
independently.

  $ . ./trace.sh
  $ python () { if test -x /usr/bin/python3; then /usr/bin/python3 -B "$@"; else python3 -B "$@"; fi; }
  $ engines () {
  >   for real in double float; do
  >     for engine in c interp; do
  >       frobc trace $1.frob --real $real --engine $engine --input $1.csv --output $1.$real.$engine
  >     done
  >     cmp $1.$real.c $1.$real.interp
  >   done
  > }

The trapezoidal rule, with steps that jitter, a step of length 0, and a gap of 99 s:

  $ cat > tustin.frob << FROB
  > import Integration
  > main :: SF Float[m/s] Float[m]
  > main = trapezoidalIntegral
  > FROB
  $ python - > tustin.csv << END
  > import random
  > random.seed(4)
  > print("time,in")
  > t = 5
  > for k in range(400):
  >     print(f"{t:.9f},{random.uniform(-3, 3):.6f}")
  >     t += 0 if k % 50 == 7 else 99 if k == 200 else random.uniform(0.001, 0.05)
  > END
  $ engines tustin
  $ python - << END
  > import numpy as np
  > t, x = np.loadtxt("tustin.csv", delimiter=",", skiprows=1).T
  > model = np.append(0, np.cumsum(np.diff(t) * (x[1:] + x[:-1]) / 2))
  > for real, most in ("double", 1e-9), ("float", 1e-3):
  >     found = np.loadtxt(f"tustin.{real}.c", delimiter=",", skiprows=1)[:, 1]
  >     print(real, np.abs(found - model).max() < most)
  > END
  double True
  float True

NaN at one instant makes it NaN from then on, as with `integral`:

  $ printf '%s\n' 1 nan 1 | rows in | trace tustin 2>&1 | cells | xargs
  0 nan nan

At twice the rate, its error is a quarter. That of the rectangle rule is half:

  $ cat > errors.frob << FROB
  > import Integration
  > main :: SF Float (Float[s], Float[s])
  > main = proc x -> (trapezoidalIntegral x - exact, integral x - exact) where
  >     exact = (1 - cos (time () / 1[s])) * 1[s]
  > FROB
  $ for rate in 10 20 40; do
  >   awk -v rate=$rate 'BEGIN { print "time,in"; for (k = 0; k <= rate; k++) printf "%.9f,%.17g\n", k / rate, sin(k / rate) }' |
  >     frobc trace errors.frob --input - | tail -n 1
  > done | awk -F, 'NR > 1 { printf "%.2f %.2f\n", tustin / $2, rectangle / $3 } { tustin = $2; rectangle = $3 }'
  4.00 2.01
  4.00 2.00

A pendulum keeps its energy for 60 s, with steps that jitter between 10 and 30 ms. If each
rate is integrated by the rectangle rule, its energy grows until it goes over the top:

  $ cat > pendulum.frob << FROB
  > import Integration
  > g :: Float[1/s^2]
  > g = 9.81[1/s^2]
  > swing :: Float[1/s^2] -> (Angle, AngularVelocity) -> (AngularVelocity, Float[1/s^2])
  > swing push (angle, rate) = (rate, push - g * sin angle)
  > energy :: (Angle, AngularVelocity) -> Float[1/s^2]
  > energy (angle, rate) = rate * rate / 2 - g * cos angle
  > main :: SF Float[1/s^2] (Angle, Float[1/s^2], Float[1/s^2], Float[1/s^2])
  > main = proc push -> (fst state, energy state, energy coarse, energy (angle, rate)) where
  >     state = rungeKutta alongPair 10 swing (1, 0) push
  >     coarse = rungeKutta alongPair 1 swing (1, 0) push
  >     rate = integral (push - g * sin angle)
  >     angle = 1 + integral rate
  > FROB
  $ python - > pendulum.csv << END
  > import random
  > random.seed(5)
  > print("time,in")
  > t = 0
  > while t < 60:
  >     print(f"{t:.9f},0")
  >     t += random.uniform(0.01, 0.03)
  > END
  $ engines pendulum
  $ for real in double float; do
  >   awk -F, 'NR == 2 { first = $3 } NR > 1 { fine = $3 - first; coarse = $4 - first; rectangle = $5 - first
  >       if (fine < 0) fine = -fine; if (coarse < 0) coarse = -coarse
  >       if (fine > most) most = fine; if (coarse > more) more = coarse }
  >     END { print (most < 1e-9 ? "1e-9" : most < 1e-3 ? "1e-3" : most), (more < 1e-3 ? "1e-3" : more), (rectangle > 10) }' pendulum.$real.c
  > done
  1e-9 1e-3 1
  1e-3 1e-3 1

The same steps in Python, with a push that changes:

  $ awk -F, -v OFS=, 'NR > 1 { $2 = NR % 7 - 3 } NR <= 800' pendulum.csv > pushed.csv
  $ cp pendulum.frob pushed.frob
  $ engines pushed
  $ python - << END
  > import numpy as np
  > t, push = np.loadtxt("pushed.csv", delimiter=",", skiprows=1).T
  > def rates(x, u):
  >     return np.array([x[1], u - 9.81 * np.sin(x[0])])
  > x = np.array([1.0, 0.0])
  > model = [1.0]
  > for dt, u in zip(np.diff(t), push):
  >     h = dt / 10
  >     for _ in range(10):
  >         k1 = rates(x, u)
  >         k2 = rates(x + h / 2 * k1, u)
  >         k3 = rates(x + h / 2 * k2, u)
  >         k4 = rates(x + h * k3, u)
  >         x = x + h / 6 * (k1 + 2 * k2 + 2 * k3 + k4)
  >     model.append(x[0])
  > for real, most in ("double", 1e-10), ("float", 1e-2):
  >     found = np.loadtxt(f"pushed.{real}.c", delimiter=",", skiprows=1)[:, 1]
  >     print(real, np.abs(found - model).max() < most)
  > END
  double True
  float True

At twice as many sub-steps, the error is a sixteenth. The number of sub-steps is
between 1 and 64. A step of length 0 changes nothing:

  $ cat > decay.frob << FROB
  > import Integration
  > main :: SF Float (Float, Float, Float, Bool, Bool)
  > main = proc u -> (one - exact, two - exact, four - exact, none == one, many == most) where
  >     exact = exp (-(time () / 1[s]))
  >     one = decay 1 u
  >     two = decay 2 u
  >     four = decay 4 u
  >     none = decay (-3) u
  >     many = decay 1000 u
  >     most = decay mostSubSteps u
  > decay :: Int -> SF Float Float
  > decay n = rungeKutta alongLine n (\\u x -> (u - x) / 1[s]) 1
  > FROB
  $ printf 'time,in\n0,0\n0.1,0\n0.1,0\n' | trace decay | tail -n 1 |
  >   awk -F, '{ print ($2 / $3 > 14 && $2 / $3 < 18), ($3 / $4 > 14 && $3 / $4 < 18), $5, $6 }'
  1 1 true true
  $ printf 'time,in\n0,0\n0.1,0\n0.1,0\n' | trace decay | tail -n 2 | cut -d, -f2- | uniq | wc -l
  1

A state can be an array. One step at a time, without a signal function:

  $ cat > chain.frob << FROB
  > import Integration
  > main :: SF Float (Array 2 Float, Float)
  > main = proc u -> (xs, rungeKuttaStep alongLine (\\x -> -x / 1[s]) 0.1[s] u) where
  >     xs = rungeKutta alongArray 4 rates [1, 0] u
  > rates :: Float -> Array 2 Float -> Array 2 Float[1/s]
  > rates u [x, y] = [(u - x) / 1[s], (x - y) / 1[s]]
  > FROB
  $ printf 'time,in\n0,0\n1,1\n2,1\n' | trace chain | cells | rounded
  1,0,0
  0.367894199,0.367817315,0.9048375
  0.767451943,0.534924199,0.9048375
