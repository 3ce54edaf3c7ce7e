The types that a host sees keep their names, even if an internal function has the same name.

  $ cat > battery.frob <<'FROB'
  > data Advice = GoOn | Stop
  > 
  > advice :: Float[V] -> Advice
  > advice u = if u > 11[V] then GoOn else Stop
  > 
  > main :: SF (Float[V], Float[V]) (Advice, Advice)
  > main = proc (u, v) -> (advice u, advice v)
  > FROB
  $ frobc compile battery.frob
  $ grep "struct battery_advice" battery.h
  struct battery_advice {
      struct battery_advice f1;
      struct battery_advice f2;
