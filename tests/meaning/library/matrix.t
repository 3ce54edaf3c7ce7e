The modules Matrix and Kalman, in both engines and in both precisions of Float, compared with numpy.

  $ . ./trace.sh
  $ python () { if test -x /usr/bin/python3; then /usr/bin/python3 -B "$@"; else python3 -B "$@"; fi; }
  $ engines () {
  >   for real in double float; do
  >     for engine in c interp; do
  >       frobc trace $1.frob --real $real --engine $engine --input $1.csv --output $1.$real.$engine 2>&1 | grep -v '^NaN: '
  >     done
  >     cmp $1.$real.c $1.$real.interp
  >   done
  > }

Random matrices, of which every tenth is singular:

  $ cat > matrix.frob << 'FROB'
  > import Matrix
  > type M = Matrix 3 3
  > main :: SF (M, M, Vector 3) ((M, M, M, M), (Vector 3, M, M, Matrix 3 2), (Vector 3, Float, Float, M))
  > main = proc (a, b, x) ->
  >     ( (matMul a b, transpose a, matAdd a (matScale 2 b), matSub a b)
  >     , (solve a x, matInverse a, cholesky (matAdd (matMul b (transpose b)) eye), solveMatrix a (transpose [x, a ! 1]))
  >     , (matVec a x, vecDot x (a ! 0), element 2 1 a, symmetric a) )
  > FROB
  $ cat > matrix.py << 'END'
  > import sys
  > import numpy as np
  > if len(sys.argv) == 1:
  >     r = np.random.default_rng(5)
  >     names = [f"in.{k}[{i}][{j}]" for k in (1, 2) for i in range(3) for j in range(3)]
  >     print("time," + ",".join(names + [f"in.3[{i}]" for i in range(3)]))
  >     for t in range(100):
  >         a = r.normal(size=(3, 3))
  >         if t % 10 == 3:
  >             a = np.array([[1, 2, 3], [2, 4, 6], [0, 1, 5]])
  >         print(f"{t}," + ",".join(map(repr, map(float, np.concatenate([a.ravel(), r.normal(size=12)])))))
  >     sys.exit()
  > given = np.loadtxt("matrix.csv", delimiter=",", skiprows=1)[:, 1:]
  > for real, most in ("double", 1e-9), ("float", 2e-3):
  >     found = np.loadtxt(f"matrix.{real}.c", delimiter=",", skiprows=1)[:, 1:]
  >     worst, singular = 0, 0
  >     for row, cells in zip(given, found):
  >         a, b, x = row[:9].reshape(3, 3), row[9:18].reshape(3, 3), row[18:]
  >         parts = [a @ b, a.T, a + 2 * b, a - b]
  >         if np.linalg.matrix_rank(a) < 3:
  >             nothing = np.full((3, 3), np.nan)
  >             parts += [nothing[0], nothing]
  >             singular += 1
  >         else:
  >             parts += [np.linalg.solve(a, x), np.linalg.inv(a)]
  >         parts += [np.linalg.cholesky(b @ b.T + np.eye(3))]
  >         rights = np.stack([x, a[1]], axis=1)
  >         parts += [np.full((3, 2), np.nan) if np.isnan(parts[4]).any() else np.linalg.solve(a, rights)]
  >         parts += [a @ x, x @ a[0], a[2, 1], (a + a.T) / 2]
  >         model = np.concatenate([np.ravel(p) for p in parts])
  >         assert (np.isnan(model) == np.isnan(cells)).all()
  >         worst = max(worst, np.nanmax(np.abs(model - cells) / (1 + np.abs(model))))
  >     print(real, len(given), "matrices,", singular, "singular:", worst < most)
  > END
  $ python matrix.py > matrix.csv
  $ engines matrix
  $ python matrix.py compare
  double 100 matrices, 10 singular: True
  float 100 matrices, 10 singular: True

A matrix that is not positive definite has no Cholesky decomposition, and NaN stays in its column:

  $ cat > not.frob << 'FROB'
  > import Matrix
  > main :: SF Float (Matrix 2 2, Matrix 2 2, Vector 2)
  > main = proc x -> (cholesky [[x, 1], [1, 1]], zeroMatrix, vecAdd zeroVector (vecScale x (vecSub [1, 2] [0, 1])))
  > FROB
  $ printf '%s\n' 4 1 -1 | rows in | frobc trace not.frob --input - 2>/dev/null | cells
  2,0,0.5,0.8660254037844386,0,0,0,0,4,4
  1,0,1,nan,0,0,0,0,1,1
  nan,0,nan,nan,0,0,0,0,-1,-1

A Kalman filter of position and speed, with steps that jitter, steps of length 0, long gaps,
measurements that are missing, and measurements that are NaN. numpy computes the textbook formulas:

  $ cat > kalman.frob << 'FROB'
  > import Kalman
  > import Matrix
  > main :: SF (Float, Maybe Float) (Vector 2, Matrix 2 2, Vector 2)
  > main = proc (push, seen) -> (e.mean, e.covariance, deviations e) where
  >     e = kalman model (Estimate { mean = [0, 1], covariance = diagonal [4, 9] }) ([push], maybe Nothing (\z -> Just [z]) seen)
  > model :: Time -> Linear 2 1 1
  > model step = Linear
  >     { f = [[1, t], [0, 1]], b = [[t * t / 2], [t]]
  >     , q = [[t ^ 3 / 3, t ^ 2 / 2], [t ^ 2 / 2, t]], h = [[1, 0]], r = [[0.25]] }
  >   where t = step / 1[s]
  > FROB
  $ cat > kalman.py << 'END'
  > import csv, sys
  > import numpy as np
  > if len(sys.argv) == 1:
  >     r = np.random.default_rng(6)
  >     print("time,in.1,in.2")
  >     t, x, v = 0, 1.0, 0.5
  >     for k in range(300):
  >         seen = "Nothing" if k % 7 == 3 else "Just nan" if k % 31 == 5 else f"Just ({x + r.normal() / 2:.9f})"
  >         u = np.sin(k / 20)
  >         print(f"{t:.9f},{u:.9f},{seen}")
  >         step = 0 if k % 50 == 0 else 6 if k % 97 == 60 else round(r.uniform(0.01, 0.2), 9)
  >         x, v, t = x + v * step + u * step**2 / 2, v + u * step, t + step
  >     sys.exit()
  > for real, most in ("double", 1e-9), ("float", 2e-3):
  >     found = np.loadtxt(f"kalman.{real}.c", delimiter=",", skiprows=1)[:, 1:]
  >     m, p, worst, before = np.array([0, 1.0]), np.diag([4.0, 9]), 0, None
  >     h = np.array([[1.0, 0]])
  >     for row, cells in zip(csv.DictReader(open("kalman.csv")), found):
  >         time, u = float(row["time"]), float(row["in.1"])
  >         if before:
  >             t, held = time - before[0], before[1]
  >             f = np.array([[1, t], [0, 1]])
  >             m = f @ m + np.array([t * t / 2, t]) * held
  >             p = f @ p @ f.T + np.array([[t**3 / 3, t**2 / 2], [t**2 / 2, t]])
  >         before = time, u
  >         text = row["in.2"].replace("Just ", "").strip("()")
  >         if text not in ("Nothing", "nan"):
  >             k = p @ h.T / (h @ p @ h.T + 0.25)
  >             m = m + (k * (float(text) - h @ m)).ravel()
  >             p = (np.eye(2) - k @ h) @ p
  >         model = np.concatenate([m, p.ravel(), np.sqrt(np.diag(p))])
  >         worst = max(worst, np.abs(model - cells).max())
  >     print(real, len(found), "estimates:", worst < most)
  > END
  $ python kalman.py > kalman.csv
  $ engines kalman
  $ python kalman.py compare
  double 300 estimates: True
  float 300 estimates: True

The parts of the filters, on numbers that are easy to check:

  $ cat > steps.frob << 'FROB'
  > import Geometry
  > import Kalman
  > import Matrix
  > main :: SF Float (Vector 1, Matrix 1 1, Vector 1, Matrix 1 1, Matrix 2 2, Matrix 1 1)
  > main = proc x -> (p.mean, p.covariance, u.mean, u.covariance, jacobian 0.125 (\[a, b] -> [a * b, a + b]) [x, 2], round3 turned) where
  >     e = Estimate { mean = [x], covariance = [[1]] }
  >     p = kalmanPredict [[2]] [[1]] [3] e
  >     u = kalmanUpdate [[1]] [[1]] [x] e
  >     turned = jacobianBy (\[a] [b] -> [angleDiff a b]) 0.125 (\[a] -> [wrapAngle (2 * a)]) [pi / 2]
  >     round3 = map (map (\y -> toFloat (round (y * 1000)) / 1000))
  > FROB
  $ printf '%s\n' 4 nan 8 | rows in | frobc trace steps.frob --input - 2> /dev/null | cells
  11,5,6,0.5,2,4,1,1,2
  nan,5,nan,1,nan,nan,nan,nan,2
  19,5,12,0.5,2,8,1,1,2

An extended Kalman filter, with exact derivatives in numpy: a vehicle that turns, and the distance
and the bearing of a beacon at (3, 1). Some steps have the length 0, one is a long gap, and some
measurements are NaN, which counts as missing.

  $ cat > ekf.frob << 'FROB'
  > import Geometry
  > import Kalman
  > import Matrix
  > main :: SF (Vector 2, Maybe (Vector 2)) (Vector 3, Matrix 3 3)
  > main = proc (u, z) -> (e.mean, e.covariance) where
  >     e = ekf vehicle (Estimate { mean = [0, 0, 0], covariance = diagonal [0.01, 0.01, 0.01] }) (u, z)
  > vehicle :: System 3 2 2
  > vehicle = System
  >     { move = drive, noise = \step _ _ -> matScale (step / 1[s]) (diagonal [0.01, 0.01, 0.02])
  >     , measure = beacon, r = diagonal [0.04, 0.01], residual = off, small = 0.0005 }
  > drive :: Time -> Vector 2 -> Vector 3 -> Vector 3
  > drive step [v, w] [x, y, a] = [x + t * v * cos a, y + t * v * sin a, a + t * w] where
  >     t = step / 1[s]
  > beacon :: Vector 3 -> Vector 2
  > beacon [x, y, a] = [hypot (3 - x) (1 - y), angleDiff (atan2 (1 - y) (3 - x)) a]
  > off :: Vector 2 -> Vector 2 -> Vector 2
  > off [d, b] [d', b'] = [d - d', angleDiff b b']
  > FROB
  $ cat > ekf.py << 'END'
  > import csv, sys
  > import numpy as np
  > def beacon(m):
  >     dx, dy = 3 - m[0], 1 - m[1]
  >     d = np.hypot(dx, dy)
  >     h = np.array([[-dx / d, -dy / d, 0], [dy / d**2, -dx / d**2, -1]])
  >     return np.array([d, np.arctan2(dy, dx) - m[2]]), h
  > def drive(m, u, t):
  >     c, s = np.cos(m[2]), np.sin(m[2])
  >     return m + t * np.array([u[0] * c, u[0] * s, u[1]]), np.array([[1, 0, -t * u[0] * s], [0, 1, t * u[0] * c], [0, 0, 1]])
  > if len(sys.argv) == 1:
  >     r = np.random.default_rng(7)
  >     print("time,in.1[0],in.1[1],in.2")
  >     m, t = np.zeros(3), 0
  >     for k in range(200):
  >         u = np.array([0.5, 0.4])
  >         z = beacon(m)[0] + r.normal(size=2) * [0.2, 0.1]
  >         z[1] = (z[1] + np.pi) % (2 * np.pi) - np.pi
  >         if k % 30 == 7: z[k % 2] = np.nan
  >         seen = f"Just [{z[0]:.9f}, {z[1]:.9f}]" if k % 5 == 2 else "Nothing"
  >         print(f'{t:.9f},{u[0]},{u[1]},"{seen}"')
  >         step = 0 if k % 40 == 2 else 3 if k == 100 else round(r.uniform(0.05, 0.15), 9)
  >         m, t = drive(m, u, step)[0], t + step
  >     sys.exit()
  > for real, most in ("double", 1e-5), ("float", 2e-2):
  >     found = np.loadtxt(f"ekf.{real}.c", delimiter=",", skiprows=1)[:, 1:]
  >     m, p, before, worst = np.zeros(3), np.eye(3) * 0.01, None, 0
  >     for row, cells in zip(csv.DictReader(open("ekf.csv")), found):
  >         time, u = float(row["time"]), np.array([float(row["in.1[0]"]), float(row["in.1[1]"])])
  >         if before:
  >             t = time - before[0]
  >             m, f = drive(m, before[1], t)
  >             p = f @ p @ f.T + t * np.diag([0.01, 0.01, 0.02])
  >         before = time, u
  >         if row["in.2"] != "Nothing":
  >             z = np.array([float(x) for x in row["in.2"][6:-1].split(",")])
  >             expected, h = beacon(m)
  >             off = z - expected
  >             off[1] = (off[1] + np.pi) % (2 * np.pi) - np.pi
  >         if row["in.2"] != "Nothing" and np.isfinite(off).all():
  >             k = p @ h.T @ np.linalg.inv(h @ p @ h.T + np.diag([0.04, 0.01]))
  >             m, p = m + k @ off, (np.eye(3) - k @ h) @ p
  >         worst = max(worst, np.abs(np.concatenate([m, p.ravel()]) - cells).max())
  >     print(real, len(found), "estimates:", worst < most)
  > END
  $ python ekf.py > ekf.csv
  $ engines ekf
  $ python ekf.py compare
  double 200 estimates: True
  float 200 estimates: True

The gains on the page about LQR are those that its Python program computes:

  $ awk '/^```python/ { on = 1; next } /^```/ { on = 0 } on' ../../../docs/how-to/lqr.md > gains.py
  $ python gains.py > gains
  $ grep -c "$(cat gains | tr -d '\n' | sed 's/[][]/./g')" ../../../docs/how-to/lqr.md
  2
