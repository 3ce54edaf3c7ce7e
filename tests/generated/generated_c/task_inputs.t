The C code of a task names the task's inputs like the program: by the names of the task's own input
or, if it does not name its input, as in `sleepT`, by those of the enclosing machine.

  $ cat > patrol.frob <<END
  > data Sensed = Sensed { bump :: Bool, side :: Distance, front :: Distance }
  > data Command = Command { speed :: Velocity, turn :: AngularVelocity }
  > 
  > follow, backUp, turnAway :: Task Sensed Command ()
  > follow = mkTask (proc i -> (Command { speed = 0.3[m/s], turn = 0.8[1/(m s)] * (i.side - 0.5[m]) }, edge i.bump))
  > backUp = sleepT 1[s] (Command { speed = -0.2[m/s], turn = 0 })
  > turnAway = mkTask (proc now -> (Command { speed = 0, turn = 0.8[1/s] }, when (now.front > 0.6[m])))
  > 
  > main :: SF (Bool, Distance, Distance) Command
  > main = proc (b, s, f) -> either id id (runTask (forever patrol) Sensed { bump = b, side = s, front = f }) where
  >     patrol = do
  >         follow
  >         backUp
  >         seen <- snapT
  >         whenT (seen.side < 0.3[m]) turnAway
  > END
  $ frobc compile patrol.frob
  $ grep -v ';' patrol.c | grep -oE '(bool|double) [a-z]+_[a-z]+[,)]|(bool|double) t[0-9][,)]'
  bool i_bump,
  double i_side,
  double i_side,
  double now_front,
