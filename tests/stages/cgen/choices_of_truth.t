A choice with True or False in it is written with `||` or `&&`.

  $ cat > nearer.frob <<'FROB'
  > data Side = LeftSide | RightSide | At Float
  > 
  > main :: SF (Side, Side) (Bool, Bool)
  > main = proc (a, b) -> (a < At 2, if isLeft a then b == LeftSide else False) where
  >     isLeft s = case s of
  >         LeftSide -> True
  >         _ -> False
  > FROB
  $ frobc compile nearer.frob
  $ sed -n '/out->/p' nearer.c
      out->f1 = t1 || a.tag == NEARER_SIDE_RIGHT_SIDE || a.f0 < 2.0;
      out->f2 = t1 && b.tag == NEARER_SIDE_LEFT_SIDE;
