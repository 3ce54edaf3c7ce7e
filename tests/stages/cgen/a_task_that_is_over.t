A task that is over only waits for the mode that runs it to end, which it does at that very
instant. So that is no mode of its own: the task's last one tells that it is over, and leaves
out the rest of its step as any mode that ends.

  $ cat > laps.frob <<'END'
  > data In = In { go, stop, left :: Bool, x :: Float }
  > 
  > main :: SF In Float
  > main = proc i -> either id id (runTask (forever lap) i)
  > 
  > lap, straight, turns :: Task In Float ()
  > lap = do
  >     (_, way) <- straight `withSF` (proc i -> integral (i.x / 1[s]))
  >     r <- turns `timeOut` 5[s]
  >     case r of
  >         Just _ -> sleepT 1[s] way
  >         Nothing -> sleepT 2[s] (negate way)
  > straight = do
  >     mkTask (proc i -> (i.x, edge i.go))
  >     mkTask (proc i -> (integral (i.x / 1[s]), mergeE (edge i.stop) (when (i.x > 1.8))))
  > turns = do
  >     mkTask (proc i -> (2 * i.x, edge i.left))
  >     sleepT 3[s] 7
  > END
  $ frobc compile laps.frob --lint
  $ sed -n '/^static.* laps_straight_straight_2_step/,/^}/p' laps.c | sed "s, */\*.*,,"
  static inline void laps_straight_straight_2_step(struct laps_straight_straight_2_state *self,
          struct laps_straight_straight_2_flags *FROB_RESTRICT flags, double dt, bool i_stop,
          double i_x, double *out_1, bool *out_2)
  {
      self->i_x_integral += dt * self->i_x_integral_input;
      const bool t1 = i_stop & !flags->i_stop_prev || i_x > 1.8;
      *out_2 = t1;
      if (!t1) {
          *out_1 = self->i_x_integral;
          flags->i_stop_prev = i_stop;
          self->i_x_integral_input = i_x;
      }
  }
  $ grep -A 5 -h "the modes of" laps.h
  /* the modes of straight */
  enum {
      LAPS_STRAIGHT_STRAIGHT,
      LAPS_STRAIGHT_STRAIGHT_2
  };
  
  --
  /* the modes of turns */
  enum {
      LAPS_TURNS_TURNS,
      LAPS_TURNS_SLEEP_T
  };
  
  --
  /* the modes of main */
  enum {
      LAPS_WITH_SF,
      LAPS_TIME_OUT,
      LAPS_SLEEP_T
  };
  $ cat > in.awk <<'END'
  > function random() { seed = (seed * 1103515245 + 12345) % 2147483648; return seed / 2147483648 }
  > function truth() { return random() < 0.5 ? "true" : "false" }
  > BEGIN {
  >     seed = 7
  >     print "time,in.go,in.stop,in.left,in.x"
  >     for (k = 0; k < 600; k++) {
  >         printf "%.2f,%s,%s,%s,%.3f\n", time, truth(), truth(), truth(), 4 * random() - 2
  >         time += int(1 + 3 * random()) / 4
  >     }
  > }
  > END
  $ awk -f in.awk > in.csv
  $ frobc trace laps.frob --input in.csv > c.csv
  $ frobc trace laps.frob --input in.csv --engine interp | cmp - c.csv
  $ awk -F, 'NR == 1 || (NR >= 6 && NR <= 16)' c.csv
  time,out
  2.750000000,0.39000000000000001
  3.000000000,0.38600000000000001
  3.250000000,0.032250000000000001
  4.000000000,-2.798
  4.500000000,-1.496
  5.250000000,7
  5.750000000,7
  6.500000000,7
  6.750000000,7
  7.250000000,7
  8.000000000,7

The time at which a task is over bounds the time of its last mode too: it is just added to.

  $ sed -n '/^static.* laps_turns_sleepT_step/,/^}/p' laps.c | sed "s, */\*.*,,"
  static inline void laps_turns_sleepT_step(struct laps_turns_sleepT_state *self, int64_t dt_ns,
          double *out_1, bool *out_2)
  {
      self->time = frob_soon(self->time, dt_ns);
      const bool t1 = INT64_C(3000000000) <= self->time;
      *out_2 = t1;
      if (!t1) {
          *out_1 = 7.0;
      }
  }

Where what it puts out then is looked at, or where the output of that instant is still its
own, it stays a mode.

  $ cat > looked_at.frob <<'END'
  > data In = In { go, stop, left :: Bool, x :: Float }
  > 
  > main :: SF In Float
  > main = first_
  > 
  > first_, second_ :: SF In Float
  > first_ = switch (proc i -> (fst (part i), tag (when (snd (part i))) (fst (part i)))) after_
  > second_ = dSwitch (proc i -> (fst (part i), when (snd (part i)))) (\_ -> first_)
  > 
  > after_ :: Float -> SF In Float
  > after_ y = switch (proc i -> (y, edge i.left)) (\_ -> second_)
  > 
  > part :: SF In (Float, Bool)
  > part = switch (proc i -> ((i.x, False), edge i.go)) (\_ -> proc _ -> (5, True))
  > END
  $ frobc compile looked_at.frob --lint
  $ grep -A 5 -h "the modes of part" looked_at.h
  /* the modes of part */
  enum {
      LOOKED_AT_PART_PART,
      LOOKED_AT_PART_PART_2
  };
  
  $ frobc trace looked_at.frob --input in.csv > c.csv
  $ frobc trace looked_at.frob --input in.csv --engine interp | cmp - c.csv
  $ cut -d, -f2 c.csv | grep -c '^5$'
  259
