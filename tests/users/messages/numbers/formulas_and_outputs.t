A quotient the other way round:

  $ check () { cat > main.frob; frobc check main.frob 2>&1 | grep "hint"; }
  $ check <<'END'
  > turnFor :: Distance -> Velocity -> AngularVelocity
  > turnFor radius speed = radius / speed
  > END
    = hint: swap the operands to get the unit `1/s`: write `speed / radius`
    = hint: if this is the right result, write the signature as `turnFor :: Distance -> Velocity -> Float[s]`
  $ check <<'END'
  > eta :: Distance -> Velocity -> Time
  > eta d v = (v + 0.1[m/s]) / d
  > END
    = hint: swap the operands to get the unit `s`: write `d / (v + 0.1[m/s])`
    = hint: if this is the right result, write the signature as `eta :: Distance -> Velocity -> Float[1/s]`

A number without a unit in an output of a signal function:

  $ check <<'END'
  > walk :: SF Int Velocity
  > walk = switch (proc n -> (0.3, edge (n > 1000))) (\_ -> constant 0)
  > END
    = hint: write `0.3[m/s]` if that is the right unit

Missing parentheses around a comparison, and an angle compared with a distance:

  $ check <<'END'
  > import Robot
  > main :: HasSonar i => SF i (Event ())
  > main = proc i -> when frontSonar i < 0.5[m]
  > END
    = hint: put parentheses around the whole argument of `when`: `when (frontSonar i …)`
  $ check <<'END'
  > main :: SF Distance (Event ())
  > main = proc d -> when d < 0.5[m]
  > END
    = hint: put parentheses around the argument, because function application binds tighter than `<`: `when (d < …)`
  $ check <<'END'
  > main :: SF Angle Bool
  > main = proc heading -> heading < 1[m]
  > END
    = hint: `heading` is an angle: write `1[rad]`
