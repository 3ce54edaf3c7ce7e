Every kernel under its name in Frob, on the frames of a run, in both engines: in the first frame the
poster's red disc and frame are two blobs; two images from one camera have disparities, but no
depths.

  $ frobc run known.frob --world world.toml --for 1s --seed 1 --record run.csv > summary
  $ frobc trace kernels.frob --input run.csv > found.csv
  NaN: out, first at 0.000 s; to find its origin, run `frobc view --why-nan`
  $ frobc trace kernels.frob --input run.csv --engine interp | cmp - found.csv
  $ sed -n 2p found.csv | grep -oE 'pixels = [0-9]+|blobs = [0-9]+|known = [01]|nearest = [a-z]+|straight = [^}]*|gradient = [0-9]'
  pixels = 6440
  straight = Vec2 {x = 40, y = 50
  known = 1
  nearest = nan
  gradient = 3
  blobs = 2
