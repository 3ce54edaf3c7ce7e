Operators on the past. Each function is shown next to its definition, for a signal that is True
where there is a 1.

  $ . ./trace.sh

  $ cat > past.frob << FROB
  > import Past
  > main :: SF (Int, Int) (Bool, Bool, Bool, Bool, Bool)
  > main = proc (a, b) -> (ever p, always p, since (p, q), within 2[s] p, heldFor 2[s] p) where
  >     p = a == 1
  >     q = b == 1
  > FROB
  $ printf '%s\n' 0,0 1,0 1,0 1,1 1,0 1,0 0,0 0,0 0,0 1,0 | rows in.1,in.2 > in.csv
  $ trace past < in.csv
  time,out.1,out.2,out.3,out.4,out.5
  0.000000000,false,false,false,false,false
  1.000000000,true,false,false,true,false
  2.000000000,true,false,false,true,false
  3.000000000,true,false,true,true,true
  4.000000000,true,false,true,true,true
  5.000000000,true,false,true,true,true
  6.000000000,true,false,false,true,false
  7.000000000,true,false,false,true,false
  8.000000000,true,false,false,false,false
  9.000000000,true,false,false,true,false
  $ single past

A negative time counts as 0, and a NaN time never passes. At the first instant there is no past.

  $ cat > edges.frob << FROB
  > import Past
  > main :: SF (Int, Int) (Bool, Bool, Bool, Bool, Bool)
  > main = proc (a, _) -> (always p, within (-1[s]) p, heldFor (-1[s]) p, within nan p, heldFor nan p) where
  >     p = a == 1
  >     nan = 0[s] * log (-1)
  > FROB
  $ printf '%s\n' 1,0 1,0 0,0 | rows in.1,in.2 > in.csv
  $ trace edges < in.csv 2> warning
  time,out.1,out.2,out.3,out.4,out.5
  0.000000000,true,true,true,false,false
  1.000000000,true,true,true,false,false
  2.000000000,false,false,false,false,false

Verdicts also show whether the condition applied.

  $ cat > claims.frob << FROB
  > import Past
  > main :: SF (Int, Int) (Verdict, Verdict, Verdict, Verdict, Bool)
  > main = proc (a, b) -> (p \`implies\` q, afterwards (p, q), answers, by 2[s] q, holds (max answers (verdict (a < 2)))) where
  >     p = a == 1
  >     q = b == 1
  >     answers = respondsWithin 2[s] (p, q)
  > FROB
  $ printf '%s\n' 0,0 1,1 0,0 1,0 0,0 0,1 1,0 0,0 0,0 0,0 0,1 | rows in.1,in.2 > in.csv
  $ trace claims < in.csv
  time,out.1,out.2,out.3,out.4,out.5
  0.000000000,NotAsked,NotAsked,NotAsked,Open,true
  1.000000000,Holds,Holds,Holds,Holds,true
  2.000000000,NotAsked,Fails,NotAsked,Holds,true
  3.000000000,Fails,Fails,Open,Holds,true
  4.000000000,NotAsked,Fails,Open,Holds,true
  5.000000000,NotAsked,Holds,Holds,Holds,true
  6.000000000,Fails,Fails,Open,Holds,true
  7.000000000,NotAsked,Fails,Open,Holds,true
  8.000000000,NotAsked,Fails,Open,Holds,true
  9.000000000,NotAsked,Fails,Fails,Holds,false
  10.000000000,NotAsked,Holds,Holds,Holds,true
  $ single claims
  $ printf '%s\n' 0,0 0,0 0,0 0,0 0,1 | rows in.1,in.2 > in.csv
  $ trace claims < in.csv | cut -d, -f5
  out.4
  Open
  Open
  Open
  Fails
  Fails
