A mode that ends leads straight to the first step of the next: what it would do besides
is left out, the machine within it among that.

  $ cat > duty.frob <<'END'
  > main :: SF (Bool, Float) Float
  > main = rest
  > 
  > rest, work, up, down :: SF (Bool, Float) Float
  > rest = switch (proc (on, _) -> (0, edge on)) (\_ -> work)
  > work = switch (proc i -> (up i, edge (not (fst i)))) (\_ -> rest)
  > up = switch (proc (_, x) -> (integral (x / 1[s]), edge (x < 0))) (\_ -> down)
  > down = switch (proc (_, x) -> (-1, edge (x > 0))) (\_ -> up)
  > END
  $ frobc compile duty.frob --lint
  $ sed -n '/^static.* duty_rest_work_step/,/^}/p' duty.c | sed "s, */\*.*,,"
  static inline void duty_rest_work_step(struct duty_rest_work_state *self,
                                         struct duty_rest_work_flags *FROB_RESTRICT flags,
                                         double dt,
                                         bool i_1,
                                         double i_2,
                                         double *out_2,
                                         bool *out_3)
  {
      const bool t1 = !i_1 & flags->i_1_prev;
      *out_3 = t1;
      if (!t1) {
          const double t2 = duty_up_step(&self->up, &flags->up, dt, i_2);
          *out_2 = t2;
          flags->i_1_prev = i_1;
      }
  }
  $ printf 'time,in.1,in.2\n0,false,1\n1,true,1\n2,true,2\n3,true,-1\n4,true,3\n5,true,3\n6,false,-1\n7,true,2\n8,true,2\n' > in.csv
  $ frobc trace duty.frob --input in.csv | tee c.csv
  time,out
  0.000000000,0
  1.000000000,0
  2.000000000,1
  3.000000000,-1
  4.000000000,0
  5.000000000,3
  6.000000000,0
  7.000000000,0
  8.000000000,2
  $ frobc trace duty.frob --input in.csv --engine interp | cmp - c.csv
