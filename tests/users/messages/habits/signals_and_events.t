Signals, events and values that may be missing, used as plain values or as objects with methods. Each
program is the output `y` of a signal function of a robot's input; the test shows the message without
the source, and checks the line with which the hint replaces it.

  $ try () { # TYPE LINE CORRECTED-LINE
  >   for line in "$2" "$3"; do
  >     printf 'import Control\nimport Robot\nimport Lidar\nf :: SF RobotInput %s\nf = proc i -> y where\n' "$1" > program.frob
  >     printf '    _echo = (sonars i ! 3).echo\n    _key = keyPressed i\n    _d = frontSonar i\n' >> program.frob
  >     printf '    _near = maybe Nothing (rangeAt 0) (latestScan 0.5[s] i :: Maybe (Scan 36))\n' >> program.frob
  >     printf '%b\n' "$line" >> program.frob
  >     frobc check program.frob 2>&1 | grep -v 'W0306\|: remove it$' | grep '^error\|^warning\|hint'
  >   done
  > }

A method of an event or of a `Maybe`:

  $ try Bool '    y = _echo.isEvent()' '    y = isEvent _echo'
  error[E0310]: `Event Distance` has no field `isEvent`
     = hint: `isEvent` is a function: write `isEvent _echo`
  [1]
  $ try Bool '    y = _echo.occurred' '    y = isEvent _echo'
  error[E0310]: `Event Distance` has no field `occurred`
     = hint: write `isEvent _echo`, which is True when the event occurs
  [1]
  $ try Distance '    y = _echo.hold(0)' '    y = hold 0 _echo'
  error[E0310]: `Event Distance` has no field `hold`
     = hint: `hold` is a function: write `hold 0 _echo`
  [1]
  $ try Distance '    y = _echo.value' '    y = hold 0 _echo'
  error[E0310]: `Event Distance` has no field `value`
     = hint: an event has a value only when it occurs: write `hold 0 _echo` for its latest value, which is 0 at first
  [1]
  $ try '(Event Int)' '    y = _key.tag(3)' '    y = tag _key 3'
  error[E0310]: `Event Int` has no field `tag`
     = hint: `tag` is a function: write `tag _key 3`
  [1]
  $ try '(Event Int)' '    y = _key.mapE(\\k -> k + 1)' '    y = mapE (\\k -> k + 1) _key'
  error[E0310]: `Event Int` has no field `mapE`
     = hint: `mapE` is a function: write `mapE (\k -> k + 1) _key`
  [1]
  $ try Distance '    y = _near.fromMaybe(0)' '    y = fromMaybe 0 _near'
  error[E0310]: `Maybe Distance` has no field `fromMaybe`
     = hint: `fromMaybe` is a function: write `fromMaybe 0 _near`
  [1]
  $ try Distance '    y = _near.value' '    y = fromMaybe 0 _near'
  error[E0310]: `Maybe Distance` has no field `value`
     = hint: the value may be missing: write `fromMaybe 0 _near`, where `0` replaces a missing value
  [1]
  $ try Bool '    y = _near.isJust()' '    y = maybe False (const True) _near'
  error[E0310]: `Maybe Distance` has no field `isJust`
     = hint: write `maybe False (const True) _near`, which is True if there is a value
  [1]
  $ try Distance '    y = _d.limit(1[m])' '    y = limit 1[m] _d'
  error[E0310]: `Float[m]` has no field `limit`
     = hint: `limit` is a function: write `limit 1[m] _d`
  [1]

A value that may be missing, in an event or in its place:

  $ try Distance '    y = hold 2[m] (mapE ahead _key)\n    ahead _ = _near' '    y = hold 2[m] (mapE (fromMaybe 2[m] . ahead) _key)\n    ahead _ = _near'
  error[E0301]: expected `Event n[m]`, found `Event (Maybe Distance)`
     = hint: the value of this event may be missing: write `mapE (fromMaybe 2[m] . ahead) _key`, where `2[m]` replaces a missing value
  [1]
  $ try Distance '    y = hold 0 e\n    e = tag _key _near' '    y = hold 0 (mapE (fromMaybe 0) e)\n    e = tag _key _near'
  error[E0301]: expected `Event n[u]`, found `Event (Maybe Distance)`
     = hint: the value of this event may be missing: write `mapE (fromMaybe 0) e`, where `0` replaces a missing value
  [1]
  $ try Distance '    y = tag _key _near' '    y = hold 0 (mapE (fromMaybe 0) (tag _key _near))'
  error[E0301]: expected `Distance` (m), found `Event (Maybe Distance)`
    = hint: an event has a value only when it occurs, and even then this value may be missing: write `hold 0 (mapE (fromMaybe 0) y)`, which is 0 at first and whenever the value is missing
  [1]
  $ try Distance '    y = hold 0 _near' '    y = fromMaybe 0 _near'
  error[E0301]: expected `Event n[u]`, found `Maybe Distance`
     = hint: this is a `Maybe`, not an event: write `fromMaybe 0 _near`, without `hold`, where `0` replaces a missing value
  [1]

In a comparison with an upper limit, a value of 0 would make the condition True:

  $ try Bool '    y = _echo < 0.4[m]' '    y = hold 4[m] _echo < 0.4[m]'
  error[E0301]: expected `Float[m]`, found `Event Distance`
     = hint: an event has a value only when it occurs: write `hold 4[m] _echo` for its latest value; the initial value `4[m]` makes the comparison False
  [1]
  $ try Bool '    y = 0.4[m] > _echo' '    y = 0.4[m] > hold 4[m] _echo'
  error[E0301]: expected `Float[m]`, found `Event Distance`
     = hint: an event has a value only when it occurs: write `hold 4[m] _echo` for its latest value; the initial value `4[m]` makes the comparison False
  [1]
  $ try Bool '    y = _echo > 0.4[m]' '    y = hold 0 _echo > 0.4[m]'
  error[E0301]: expected `Float[m]`, found `Event Distance`
     = hint: an event has a value only when it occurs: write `hold 0 _echo` for its latest value, which is 0 at first
  [1]
  $ try Bool '    y = _near < 0.4[m]' '    y = fromMaybe 4[m] _near < 0.4[m]'
  error[E0301]: expected `Float[m]`, found `Maybe Distance`
     = hint: use `fromMaybe 4[m] _near`: if the value is missing, `4[m]` replaces it, and the comparison is False
  [1]

A forgotten `integral` or `derivative`:

  $ try Distance '    y = way\n    way :: Distance\n    way = velocity i' '    y = way\n    way :: Distance\n    way = integral (velocity i)'
  error[E0320]: expected the unit `m`, found `m/s`
     = hint: for the sum over time, write `integral (velocity i)`; for a fixed time, `1[s] * (velocity i)`
     = hint: if this is the right result, write the signature as `way :: Velocity`
  [1]
  $ try Bool '    y = way < 2[m]\n    way = velocity i' '    y = integral way < 2[m]\n    way = velocity i'
  error[E0320]: the operands of `<` have different units: `m/s` and `m`
     = hint: write `2[m/s]` if you meant that unit
     = hint: for the sum over time, write `integral way` before the `<`
  [1]
  $ try Bool '    y = frontSonar i < 0.2[m/s]' '    y = derivative (frontSonar i) < 0.2[m/s]'
  error[E0320]: the operands of `<` have different units: `m` and `m/s`
     = hint: write `0.2[m]` if you meant that unit
     = hint: for the rate of change, write `derivative (frontSonar i)` before the `<`
  [1]

An assertion about a value that is not a condition:

  $ try Distance '    y = _d\n    assert "keeps off" _d' '    y = _d\n    assert "keeps off" (_d <= 1[m])'
  error[E0360]: `Float[m]` is not a condition
     = hint: assert a condition: compare the value with a limit, as in `(_d <= 1[m])`
  [1]
  $ try Distance '    y = _d\n    assert "seen" _near' '    y = _d\n    assert "seen" (_near /= Nothing)'
  error[E0360]: `Maybe Distance` is not a condition
     = hint: assert a condition, such as `(_near /= Nothing)`
  [1]
  $ try Distance '    y = _d\n    assert "heard" _echo' '    y = _d\n    assert "heard" (isEvent _echo)'
  error[E0360]: `Event Distance` is not a condition
     = hint: use `isEvent _echo`, which is True when the event occurs
  [1]
