Both engines run each program on rows of input:

  $ both() {
  >   echo "time,$2" > in.csv; program=$1; shift 2; k=0
  >   for row; do echo "$k,$row" >> in.csv; k=$((k + 1)); done
  >   frobc trace $program.frob --input in.csv | tee c.csv | cut -d, -f2-
  >   frobc trace $program.frob --input in.csv --engine interp | cmp - c.csv
  > }

Loops over the same elements are fused: neither the products nor the pushes are
ever stored in an array.

  $ cat > avoid.frob <<'EOF'
  > main :: SF (Array 4 Float) (Float, Float)
  > main = proc xs -> (sum (zipWith (*) [1, 2, 3, 4] pushes), sum (zipWith (*) [4, -3, 2, -1] pushes)) where
  >     pushes = map (\x -> if x < 1 then 1 - x else 0) (mapSF smooth xs)
  > 
  > smooth :: SF Float Float
  > smooth = proc x -> y where
  >     before = delay 3 y
  >     y = before + 0.5 * (x - before)
  > 
  > sum :: Array n Float -> Float
  > sum = foldl (+) 0
  > EOF
  $ frobc compile avoid.frob --lint
  $ sed -n '/^void avoid_step/,/^}/p' avoid.c | sed "s, */\*.*,,"
  void avoid_step_ns(struct avoid_state *self, int64_t dt_ns, double dt,
          const struct avoid_input *in, struct avoid_output *out)
  {
      (void)dt_ns;
      (void)dt;
      static const struct avoid_float_4 t1 = {{1.0, 2.0, 3.0, 4.0}};
      static const struct avoid_float_4 t2 = {{4.0, -3.0, 2.0, -1.0}};
      double t3 = 0.0;
      double t4 = 0.0;
      for (int32_t i = 0; i < 4; i++) {
          avoid_main_loop_step(&self->smooth[i], t3, t4, in->value[i], t1.at[i], t2.at[i], &t3,
                  &t4);
      }
      out->f1 = t3;
      out->f2 = t4;
  }
  void avoid_step(struct avoid_state *self, double dt, const struct avoid_input *in,
          struct avoid_output *out)
  {
      (void)dt;
      avoid_step_ns(self, 0, 0.0, in, out);
  }
  $ both avoid 'in[0],in[1],in[2],in[3]' 1,2,3,4 0.5,0.25,0,-1 0,0,nan,9 1,1,1,1
  out.1,out.2
  0,0
  0,0
  1,0.5625
  0.5,0.28125

A loop that needs the whole array, or the end of another loop, is not fused: `shares` needs the
total, and `fromFirst` needs an element before the loop has computed it.

  $ cat > waits.frob <<'EOF'
  > main :: SF (Array 3 Float) (Float, Array 3 Float, Array 3 Float, Float)
  > main = proc xs -> (total, shares, fromFirst, foldl (-) total shares) where
  >     twice = map (* 2) xs
  >     total = foldl (+) 0 twice
  >     shares = map (/ total) twice
  >     fromFirst = map (\x -> x - twice ! 0) twice
  > EOF
  $ frobc compile waits.frob --lint
  $ both waits 'in[0],in[1],in[2]' 1,2,3 0.5,0.25,0 -1,0,nan 4,1,1
  out.1,out.2[0],out.2[1],out.2[2],out.3[0],out.3[1],out.3[2],out.4
  12,0.16666666666666666,0.33333333333333331,0.5,0,2,4,11
  1.5,0.66666666666666663,0.33333333333333331,0,0,-0.5,-1,0.5
  nan,nan,nan,nan,0,2,nan,nan
  12,0.66666666666666663,0.16666666666666666,0.16666666666666666,0,-6,-6,11.000000000000002

A loop that depends on another one through a third, which has a different size,
is not fused with it.

  $ cat > around.frob <<'EOF'
  > main :: SF (Array 3 Float, Array 2 Float) (Float, Float)
  > main = proc (xs, ys) -> (foldl (\s x -> s * x + least) 1 doubled, foldl (+) least ys) where
  >     doubled = map (* 2) xs
  >     least = foldl min 100 (map (\y -> y + foldl max 0 doubled) ys)
  > EOF
  $ frobc compile around.frob --lint
  $ both around 'in.1[0],in.1[1],in.1[2],in.2[0],in.2[1]' 1,2,3,4,5 0,0,0,-1,1 3,2,1,nan,1
  out.1,out.2
  358,19
  -1,-1
  nan,nan

States, parameters and results of the loops stay separate; a loop may run a
machine.

  $ cat > states.frob <<'EOF'
  > main :: SF (Array 3 Float, Float) (Array 3 Float, Array 3 Float, Int)
  > main = proc (xs, k) -> (ys, zs, n) where
  >     ys = map (* k) (mapSF toggle xs)
  >     zs = mapSF (delay 1 >>> delay 2) ys
  >     n = foldl (\m z -> if z > k then m + 1 else m) 0 zs
  > 
  > toggle, negative :: SF Float Float
  > toggle = switch (proc x -> (x, edge (x > 2))) (\_ -> negative)
  > negative = switch (proc x -> (-x, edge (x < 1))) (\_ -> toggle)
  > EOF
  $ frobc compile states.frob --lint
  $ sed '/_is_valid(/,$d' states.c | grep -c "for ("
  4
  $ both states 'in.1[0],in.1[1],in.1[2],in.2' 1,2,3,1 3,2,1,2 0,0,4,1 3,3,3,-1 1,0,1,2
  out.1[0],out.1[1],out.1[2],out.2[0],out.2[1],out.2[2],out.3
  1,2,3,2,2,2,3
  -6,4,2,1,1,1,0
  0,0,-4,1,2,3,2
  3,3,3,-6,4,2,2
  -2,0,-2,0,0,-4,0

The least and the greatest element are their own keys. NaN never wins over a number, and the first
of equal elements wins.

  $ cat > extremes.frob <<'EOF'
  > main :: SF (Array 3 Float) (Float, Float, Float)
  > main = proc xs -> (least, maximumBy id xs, 1 / least) where
  >     least = minimumBy id xs
  > EOF
  $ frobc compile extremes.frob --lint
  $ both extremes 'in[0],in[1],in[2]' 1,2,3 3,2,1 nan,2,1 1,nan,2 2,1,nan nan,nan,1 nan,nan,nan 0,-0,0 -0,0,-0 inf,-inf,nan
  out.1,out.2,out.3
  1,3,1
  1,3,1
  1,2,1
  1,2,1
  1,2,1
  1,1,1
  nan,nan,nan
  0,0,inf
  -0,-0,-inf
  -inf,inf,-0

A fold that starts with an element of an array that another loop computes comes after that loop.

  $ cat > starts.frob <<'EOF'
  > main :: SF (Array 3 Float) (Float, Float, Float)
  > main = proc xs -> (foldl (-) (ys ! 0) ys, foldl (-) (ys ! 1) ys, minimumBy id ys) where
  >     ys = mapSF (proc x -> x + delay 0 x) xs
  > EOF
  $ frobc compile starts.frob --lint
  $ both starts 'in[0],in[1],in[2]' 1,2,3 3,2,1 nan,2,1 -0,nan,0 0,0,0
  out.1,out.2,out.3
  -5,-4,1
  -8,-8,4
  nan,nan,2
  nan,nan,1
  nan,nan,0

NaN is handled correctly even if the result is only compared, or if the test is
written differently.

  $ cat > told.frob <<'EOF'
  > main :: SF (Array 3 Float, Float) (Bool, Bool, Float)
  > main = proc (xs, q) -> (least < q, q < largest, if largest > q then largest else 0) where
  >     least = foldl (\b x -> if not (b <= x) && x == x then x else b) (xs ! 1) xs
  >     largest = maximumBy id (map (* 2) xs)
  > EOF
  $ frobc compile told.frob --lint
  $ both told 'in.1[0],in.1[1],in.1[2],in.2' 1,2,3,1 2,nan,1,1.5 nan,nan,nan,inf 2,-inf,inf,0
  out.1,out.2,out.3
  false,true,6
  true,true,4
  false,false,0
  true,true,inf

The contribution of an element may depend on a condition, and so may the value that is passed from
one iteration to the next.

  $ cat > where.frob <<'EOF'
  > main :: SF (Array 3 Float, Float) (Float, Float, Float)
  > main = proc (xs, q) -> (foldl (+) 0 (map near xs), foldl (+) 0 (map far xs), foldl restarted 0 xs) where
  >     near x = if x < q then q - x else 0
  >     far x = if x < q then 0 else x
  >     restarted s x = if x < q then s + x else 0
  > EOF
  $ frobc compile where.frob --lint
  $ sed -n '/main_loop/,$p' where.c | grep "?" | sed "s, */\*.*,,"
      return t1 + (x < q ? q - x : 0.0);
      return t1 + (x < q ? 0.0 : x);
  $ both where 'in.1[0],in.1[1],in.1[2],in.2' 1,2,3,2.5 nan,2,-1,1.5 -0,0,inf,0 1,2,3,nan
  out.1,out.2,out.3
  2,3,0
  2.5,nan,-1
  0,inf,0
  0,6,0
