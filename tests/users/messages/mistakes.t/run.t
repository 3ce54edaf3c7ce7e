A hundred mistakes and the messages for them. INDEX.md describes each mistake.

  $ for program in [01]*.frob; do echo "# $program"; frobc check "$program"; done 2>&1
  # 001_sonar_without_input.frob
  error[E0303]: expected a value, found a signal function that is not applied to a signal
   --> 001_sonar_without_input.frob:4:12
    |
  4 |     v = if frontSonar < 0.5[m] then 0 else 0.3[m/s])
    |            ^^^^^^^^^^   ------ this is `Float[m]`
    |            |
    |            this is `SF a Distance`
    |
    = hint: run the signal function on `i`: `frontSonar i`
  
  1 error
  # 002_sonar_as_field.frob
  error[E0310]: no type in scope has a field `frontSonar`
   --> 002_sonar_as_field.frob:4:23
    |
  4 |     v = 0.5[1/s] * (i.frontSonar - 0.3[m]))
    |                       ^^^^^^^^^^
    |
    = hint: `frontSonar` is a signal function: write `frontSonar i`
  
  1 error
  # 003_no_import_robot.frob
  error[E0205]: unknown name `reactimateRobot`
   --> 003_no_import_robot.frob:1:8
    |
  1 | main = reactimateRobot (proc i -> roMake (setVelTR v 0) where
    |        ^^^^^^^^^^^^^^^
    |
    = hint: `reactimateRobot`, `roMake`, `setVelTR` and `frontSonar` are in the library: `import Robot`
  
  1 error
  # 004_if_without_then.frob
  error[E0110]: expected `then` after the condition, found `else`
   --> 004_if_without_then.frob:4:45
    |
  4 |     v = if (frontSonar i > 0.5[m]) 0.3[m/s] else 0)
    |                                             ^^^^
    |
    = hint: put `then` after the condition: `if frontSonar i > 0.5[m] then 0.3[m/s] else 0`
  
  1 error
  # 005_sonar_in_a_task.frob
  error[E0341]: `frontSonar` is run outside of a `proc`
   --> 005_sonar_in_a_task.frob:8:8
    |
  8 |     if frontSonar i < 0.5[m]
    |        ^^^^^^^^^^^^ the statements of a task cannot run signal functions
    |
    = hint: to read it once, write `x <- ask frontSonar` before this, and `x` here
    = hint: to run it at every instant of a task, write `mkTask (proc i -> (output, event))`
  
  1 error
  # 006_hysteresis_one_argument.frob
  error[E0303]: expected a value, found a signal function that is not applied to a signal
   --> 006_hysteresis_one_argument.frob:4:18
    |
  3 | main :: SF Float Bool
    |         ------------- the signature of `main` requires the output `Bool`
  4 | main = proc x -> hysteresis 1 x
    |                  ^^^^^^^^^^^^^^ this is `SF Float Bool`
    |
    = note: expected `Bool`
    = hint: `hysteresis` takes two arguments before its signal: write `hysteresis 1 … x`, where the signal is `x`
  
  1 error
  # 007_local_at_two_types.frob
  error[E0320]: expected no unit, found `m/s`
   --> 007_local_at_two_types.frob:2:39
    |
  2 | main = proc (x, v) -> (twice x, twice v) where
    |                        -----    ----- ^ this is `Velocity` (m/s)
    |                        |        |
    |                        |        argument 1 of `twice` is `Float`
    |                        because of this use of `twice`
    |
    = hint: a local function without a signature has only one type: give `twice` a signature with a variable, as in `twice :: Float[u] -> …`
  
  1 error
  # 008_turn_without_unit.frob
  error[E0320]: expected the unit `1/s`, found none
   --> 008_turn_without_unit.frob:3:61
    |
  3 | main = reactimateRobot (proc i -> roMake (setVelTR 0.2[m/s] 30))
    |                                           --------          ^^ this is `Float`
    |                                           |
    |                                           argument 2 of `setVelTR` is `AngularVelocity` (1/s)
    |
    = hint: write `30[deg/s]` for degrees per second, or `30[rad/s]` for radians per second
  
  1 error
  # 009_pid_of_three_numbers.frob
  error[E0301]: expected `Pid[u, v]`, found a number
   --> 009_pid_of_three_numbers.frob:5:13
    |
  5 |     v = pid 1 0.1 0.01 (frontSonar i - 0.5[m]))
    |         --- ^
    |         |
    |         argument 1 of `pid` is `Pid[u, v]`
    |
    = hint: `pid` takes a single record, not separate numbers: write `pid (Pid { kp = 1, ki = 0.1, kd = 0.01, largest = … }) (frontSonar i - 0.5[m])`
  
  1 error
  # 010_pid_gains_without_units.frob
  error[E0320]: expected the unit `1/s`, found none
   --> 010_pid_gains_without_units.frob:6:34
    |
  6 |     gains = Pid { kp = 0.8, ki = 0.1, kd = 0.05, largest = 0.3[m/s] })
    |                             --   ^^^ this is `Float`
    |                             |
    |                             the field `ki` is `Float[1/s]`
    |
    = hint: give all numbers in the record their units: for a `Pid[m, m/s]` (u is `m`, v is `m/s`), for example, write `Pid { kp = 0.8[1/s], ki = 0.1[1/s^2], kd = 0.05, largest = 0.3[m/s] }`
  
  1 error
  # 011_pid_gain_of_wrong_unit.frob
  error[E0320]: expected the unit `1/s^2`, found `1/s`
   --> 011_pid_gain_of_wrong_unit.frob:4:35
    |
  4 | gains = Pid { kp = 0.8[1/s], ki = 0.1[1/s], kd = 0.05, largest = 0.3[m/s] }
    |                              --   ^^^^^^^^ this is `Float[1/s]`
    |                              |
    |                              the field `ki` is `Float[1/s^2]`
    |
    = note: in a `Pid`, the units depend on each other: `kp` has `v/u`, `ki` has `v/u/s`, `kd` has `v s/u`, `largest` has `v`
    = hint: write `0.1[1/s^2]` if you meant that unit
  
  1 error
  # 012_integral_in_a_branch.frob
  error[E0342]: `integral` is run in a branch
   --> 012_integral_in_a_branch.frob:5:26
    |
  5 |     way = if moving then integral v else 0
    |                          ^^^^^^^^^^ its output depends on when it started
    |
    = hint: to run it at every instant, add the equation `integralNow = integral v`, and write `integralNow` here
    = hint: to restart it whenever this branch is chosen, write `integralNow = resetOn integral (v, edge moving)`
    = hint: to pause it while this branch is not chosen, write `integral (if moving then v else 0)` in place of the whole `if`
  
  1 error
  # 013_timer_in_a_case.frob
  error[E0342]: `after` is run in a branch
   --> 013_timer_in_a_case.frob:6:23
    |
  6 |     Go -> if isEvent (after 2[s] ()) then 0 else 0.3[m/s]
    |                       ^^^^^^^^^^^^^ its output depends on when it started
    |
    = hint: to run it at every instant, add the equation `afterNow = after 2[s] ()`, and write `afterNow` here
    = hint: to restart it whenever this alternative is chosen, use `switch` to change between signal functions
  
  1 error
  # 014_delay_without_start.frob
  error[E0303]: expected a value, found a signal function that is not applied to a signal
   --> 014_delay_without_start.frob:2:22
    |
  2 | main = proc x -> x - delay x
    |                  -   ^^^^^^^ this is `SF Float Float`
    |                  |
    |                  this is `Float`
    |
    = note: expected `Float`
    = hint: `delay` takes an initial value before its signal: write `delay 0 x`
  
  1 error
  # 015_delay_arguments_swapped.frob
  error[E0340]: the initial value of `delay` must be static, but `x` is a signal
   --> 015_delay_arguments_swapped.frob:2:28
    |
  2 | main = proc x -> x - delay x 0
    |             -              ^
    |             |
    |             `x` is a signal: it comes from the `proc`'s input here
    |
    = hint: the initial value comes before the signal: write `delay 0 x`
  
  1 error
  # 016_speed_as_output.frob
  error[E0411]: `main` cannot run: its type is `HasBumpers a => Program a Float[m/s]`, so its output is not a robot's output
   --> 016_speed_as_output.frob:3:35
    |
  3 | main = reactimateRobot (proc i -> if bumped i then 0 else 0.3[m/s])
    |                                   ^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^
    |
    = hint: use `roMake` to create a robot's output, as in `roMake (setVelTR v omega)`
  
  1 error
  # 017_two_speeds_as_tuple.frob
  error[E0301]: expected `Velocity` (m/s), found a tuple with 2 elements
   --> 017_two_speeds_as_tuple.frob:3:52
    |
  3 | main = reactimateRobot (proc i -> roMake (setVelTR (0.3[m/s], 0)))
    |                                           -------- ^^^^^^^^^^^^^
    |                                           |
    |                                           argument 1 of `setVelTR` is `Velocity` (m/s)
    |
    = hint: write the arguments without parentheses or commas: `setVelTR 0.3[m/s] 0`
  
  1 error
  # 018_without_roMake.frob
  error[E0411]: `main` cannot run: its output is a function, `b -> b`, not a robot's output
   --> 018_without_roMake.frob:3:35
    |
  3 | main = reactimateRobot (proc _ -> setVelTR 0.3[m/s] 0)
    |                                   ^^^^^^^^^^^^^^^^^^^
    |
    = hint: use `roMake` to turn this function into a robot's output, as in `roMake (setVelTR v omega)`
  
  1 error
  # 019_speed_without_unit.frob
  error[E0320]: the operands of `<` have different units: `m` and `1`
   --> 019_speed_without_unit.frob:4:27
    |
  4 |     v = if frontSonar i < 0.5 then 0 else 0.3[m/s])
    |            ------------   ^^^ this is `Float`
    |            |
    |            this is `Distance` (m)
    |
    = hint: write `0.5[m]` if that is the right unit
  
  1 error
  # 020_speed_from_distance.frob
  error[E0320]: expected the unit `m/s`, found `m`
   --> 020_speed_from_distance.frob:3:53
    |
  3 | main = reactimateRobot (proc i -> roMake (setVelTR (frontSonar i - 0.5[m]) 0))
    |                                           --------  ^^^^^^^^^^^^^^^^^^^^^ this is `Float[m]`
    |                                           |
    |                                           argument 1 of `setVelTR` is `Velocity` (m/s)
    |
    = hint: multiply by a gain, as in `0.5[1/s] * (frontSonar i - 0.5[m])`, or, for the rate of change, write `derivative (frontSonar i - 0.5[m])`
  
  1 error
  # 021_distance_plus_speed.frob
  error[E0320]: the operands of `+` have different units: `m` and `m/s`
   --> 021_distance_plus_speed.frob:2:27
    |
  2 | main = proc (x, v) -> x + v * 2
    |                       -   ^^^^^ this is `Float[m/s]`
    |                       |
    |                       this is `Distance` (m)
    |
    = hint: multiply by a time, as in `1[s] * (v * 2)`, or, for the sum over time, write `integral (v * 2)`
  
  1 error
  # 022_squared_distance.frob
  error[E0320]: expected the unit `m`, found `m^2`
   --> 022_squared_distance.frob:4:18
    |
  3 | main :: SF Point2 Distance
    |         ------------------ the signature of `main` requires the output `Distance` (m)
  4 | main = proc p -> p.x ^ 2 + p.y ^ 2
    |                  ^^^^^^^^^^^^^^^^^ this is `Float[m^2]`
    |
    = hint: for the square root, write `sqrt (p.x ^ 2 + p.y ^ 2)`
    = hint: if this is the right result, write the signature as `main :: SF Point2 Float[m^2]`
  
  1 error
  # 023_time_as_number.frob
  error[E0303]: expected a value, found a signal function that is not applied to a signal
   --> 023_time_as_number.frob:2:18
    |
  2 | main = proc x -> time > 5
    |                  ^^^^   - this is a number
    |                  |
    |                  this is `SF a Time`
    |
    = hint: run the signal function on `()`: `time ()`
  
  1 error
  # 024_time_without_unit.frob
  error[E0320]: the operands of `>` have different units: `s` and `1`
   --> 024_time_without_unit.frob:2:28
    |
  2 | main = proc x -> time () > 5
    |                  -------   ^ this is `Float`
    |                  |
    |                  this is `Time` (s)
    |
    = hint: write `5[s]` if that is the right unit
  
  1 error
  # 025_no_else.frob
  error[E0110]: expected `else` after the first branch, found the end of the block
   --> 025_no_else.frob:4:27
    |
  4 |     v = if bumped i then 0)
    |                           ^
    |
    = hint: add an `else`: every `if` has a value
  
  1 error
  # 026_equation_twice.frob
  error[E0212]: `v` is defined twice here
   --> 026_equation_twice.frob:4:5
    |
  3 |     v = 0.5[1/s] * d
    |     - first defined here
  4 |     v = min v 0.3[m/s]
    |     ^
    |
    = hint: write one equation, `v = min (0.5[1/s] * d) 0.3[m/s]`, because an equation holds at every instant, unlike an assignment
  
  1 error
  # 027_counts_itself.frob
  error[E0401]: the signal `count` needs its own value in the same instant
   --> 027_counts_itself.frob:3:5
    |
  3 |     count = if pressed then count + 1 else count
    |     ^^^^^   ------------------------------------ `count` reads `count` here
    |
    = hint: let `count` read its own previous value: write `before = delay 0 count` and `count = if pressed then before + 1 else before`, where 0 is the initial value
  
  1 error
  # 028_task_as_robot.frob
  error[E0371]: expected a signal function, found a task
   --> 028_task_as_robot.frob:4:25
    |
  4 | main = reactimateRobot (driveTo (Vec2 { x = 1[m], y = 0 }))
    |        ---------------  ^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^ this is `Task c d Bool`
    |        |
    |        argument 1 of `reactimateRobot` is `SF a b`
    |
    = hint: use `reactimateTask t` to turn a task into a program
  
  1 error
  # 029_robot_as_task.frob
  error[E0371]: expected a task, found a signal function
   --> 029_robot_as_task.frob:3:24
    |
  3 | main = reactimateTask (proc i -> roMake (setVelTR 0.2[m/s] 0))
    |        --------------  ^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^ this is `SF d e`
    |        |
    |        argument 1 of `reactimateTask` is `Task a b c`
    |
    = hint: use `reactimateRobot` to turn a signal function into a program
    = hint: add the event that ends the task: `mkTask (proc i -> (roMake (setVelTR 0.2[m/s] 0), after 1[s] ()))`; with `never ()` as the event, it never ends
  
  1 error
  # 030_place_as_two_numbers.frob
  error[E0301]: expected `Point2`, found a number in `m`
   --> 030_place_as_two_numbers.frob:4:13
    |
  4 |     driveTo 1[m] 2[m]
    |     ------- ^^^^
    |     |
    |     argument 1 of `driveTo` is `Point2`
    |
    = hint: write a vector with its field names: `Vec2 { x = 1[m], y = 2[m] }`, with `import Geometry`
  
  error[E0301]: expected `Point2`, found a number
   --> 030_place_as_two_numbers.frob:5:13
    |
  5 |     driveTo 0 0)
    |     ------- ^
    |     |
    |     argument 1 of `driveTo` is `Point2`
    |
    = hint: write a vector with its field names: `Vec2 { x = 0, y = 0 }`, with `import Geometry`
  
  2 errors
  # 031_task_if_without_else.frob
  error[E0110]: expected `else` after the first branch, found the end of the statement
   --> 031_task_if_without_else.frob:8:57
    |
  7 |     if bumped i
    |     -- this `if`
  8 |       then sleepT 1[s] (roMake (setVelTR (-0.2[m/s]) 0))
    |                                                         ^
    |
    = hint: add an `else`: every `if` has a value; in the `do` of a task, write `else return True` if the task after `then` returns a `Bool`, as `forward` and `turnBy` do, or `else return ()` if it returns nothing
  
  1 error
  # 032_task_ends_with_bind.frob
  error[E0116]: the last statement of a `do` must be a task, so it cannot bind a name
   --> 032_task_ends_with_bind.frob:7:5
    |
  7 |     p <- robotPlace
    |     ^
    |
    = hint: remove `p <-` to return the task's result, or add a last statement such as `return p`
  
  1 error
  # 033_event_as_truth.frob
  error[E0301]: a condition must be `Bool`, but this is `Event ()`
   --> 033_event_as_truth.frob:5:12
    |
  4 |     hit = edge (bumped i)
    |     --- `hit` is bound here
  5 |     v = if hit then 0 else 0.3[m/s])
    |            ^^^
    |
    = hint: to test whether the condition is True, write `bumped i`; to test whether it becomes True in this instant, write `isEvent hit`
  
  1 error
  # 034_truth_as_event.frob
  error[E0301]: expected `Event a`, found `Bool`
   --> 034_truth_as_event.frob:2:37
    |
  2 | main = switch (proc d -> (0.3[m/s], d < 0.5[m])) (\_ -> constant 0)
    |        ------                       ^^^^^^^^^^
    |        |
    |        argument 1 of `switch` has the output `Event a`
    |
    = hint: use `edge (d < 0.5[m])`, which occurs when the condition becomes True, or `when (d < 0.5[m])`, which occurs whenever it is True; use `tag` to add a value
  
  1 error
  # 035_switch_to_signal_function.frob
  error[E0304]: expected a function, found a signal function: `SF a n[u]`
   --> 035_switch_to_signal_function.frob:2:58
    |
  2 | main = switch (proc d -> (0.3[m/s], edge (d < 0.5[m]))) (constant 0)
    |        ------                                            ^^^^^^^^^^
    |        |
    |        argument 2 of `switch` is `() -> SF Float[m] Float[m/s]`
    |
    = hint: write a function that ignores its argument: `\_ -> constant 0`
  
  1 error
  # 036_mode_calls_itself.frob
  error[E0342]: `drive` is run in its own definition
   --> 036_mode_calls_itself.frob:4:51
    |
  4 | drive = proc i -> if bumped i then roMake id else drive i
    |                                                   ^^^^^^^
    |
    = hint: an equation holds at every instant, so a signal function need not call itself to continue
    = hint: to change what runs after an event, use `switch (proc x -> (output, event)) (\_ -> …)`; replace `…` with the signal function to run next, which may be this one
  
  1 error
  # 037_misspelled_name.frob
  error[E0205]: unknown name `integrel`
   --> 037_misspelled_name.frob:2:18
    |
  2 | main = proc v -> integrel v
    |                  ^^^^^^^^
    |
    = hint: did you mean `integral`?
  
  1 error
  # 038_misspelled_unit.frob
  error[E0208]: unknown unit `meters`
   --> 038_misspelled_unit.frob:3:56
    |
  3 | main = reactimateRobot (proc i -> roMake (setVelTR 0.3[meters/sec] 0))
    |                                                        ^^^^^^
    |
    = hint: did you mean `m`?
  
  error[E0208]: unknown unit `sec`
   --> 038_misspelled_unit.frob:3:63
    |
  3 | main = reactimateRobot (proc i -> roMake (setVelTR 0.3[meters/sec] 0))
    |                                                               ^^^
    |
    = hint: did you mean `s`?
  
  2 errors
  # 039_unit_after_a_space.frob
  error[E0205]: there is a space between this unit and its number
   --> 039_unit_after_a_space.frob:3:56
    |
  3 | main = reactimateRobot (proc i -> roMake (setVelTR 0.3 [m/s] 0))
    |                                                        ^^^^^
    |
    = hint: write the unit in square brackets directly after the number: `0.3[m/s]`
  
  1 error
  # 040_truth_in_small_letters.frob
  error[E0205]: unknown name `true`
   --> 040_truth_in_small_letters.frob:2:32
    |
  2 | main = proc x -> if x > 1 then true else False
    |                                ^^^^
    |
    = hint: did you mean `True`?
  
  1 error
  # 041_fields_without_comma.frob
  error[E0110]: expected an operator, `,` and another field, or `}`, found `=`
   --> 041_fields_without_comma.frob:4:34
    |
  4 | main = proc x -> Gains { p = x i = 2 }
    |                                  ^
    |
    = hint: write a `,` between two fields
  
  1 error
  # 042_index_too_large.frob
  error[E0332]: index 4 is out of range for an array of 4 elements
   --> 042_index_too_large.frob:2:38
    |
  2 | main = proc ds -> min (ds ! 1) (ds ! 4)
    |                                 --   ^
    |                                 |
    |                                 this is `Array 4 Float[m]`
    |
    = hint: the first element is `ds ! 0`, the last `ds ! 3`; check the other indices too
  
  1 error
  # 043_index_computed.frob
  error[E0347]: the index of `!` must be constant, but `k` is not
   --> 043_index_computed.frob:2:29
    |
  2 | main = proc (ds, k) -> ds ! k
    |                  -          ^
    |                  |
    |                  `k` is bound here
    |
    = note: an index can be a number, the name of a constant, or arithmetic on these
    = hint: use `at k 0 ds`, which takes any index and returns `0` if there is no such element
  
  1 error
  # 044_case_misses_one.frob
  error[E0350]: this `case` does not cover every value
   --> 044_case_misses_one.frob:4:26
    |
  4 | main = proc side -> case side of
    |                          ^^^^ there is no branch for `Ahead`
    |
    = hint: add a branch `Ahead -> …`
  
  1 error
  # 045_argument_forgotten.frob
  error[E0301]: expected `Velocity` (m/s), found the function `Float[m/s] -> Float[m/s]`
   --> 045_argument_forgotten.frob:4:52
    |
  4 | main = reactimateRobot (proc i -> roMake (setVelTR v 0) where
    |                                           -------- ^
    |                                           |
    |                                           argument 1 of `setVelTR` is `Velocity` (m/s)
  5 |     v = limit (0.5[1/s] * frontSonar i))
    |         ------------------------------- this is `v`; it lacks one argument
    |
    = hint: `limit` takes two arguments: `limit :: n[u] -> n[u] -> n[u]`
  
  1 error
  # 046_argument_too_many.frob
  error[E0301]: expected `a -> a`, found a number
   --> 046_argument_too_many.frob:3:43
    |
  3 | main = reactimateRobot (proc i -> roMake (setVelTR 0.3[m/s] 0 0))
    |                                   ------  ^^^^^^^^^^^^^^^^^^^^^
    |                                   |
    |                                   argument 1 of `roMake` is `a -> a`
    |
    = hint: `setVelTR` has one argument too many here: write `setVelTR 0.3[m/s] 0` for the function
  
  1 error
  # 047_signature_only.frob
  error[E0214]: `wallFollow` has a signature but no definition
   --> 047_signature_only.frob:1:1
    |
  1 | wallFollow :: Distance -> SF Distance Velocity
    | ^^^^^^^^^^
    |
    = hint: did you mean `wallfollow`?
  
  1 error
  # 048_bracket_forgotten.frob
  error[E0111]: this `(` is never closed
   --> 048_bracket_forgotten.frob:3:42
    |
  3 | main = reactimateRobot (proc i -> roMake (setVelTR v 0 where
    |                                          ^            - a `)` is probably missing here
    |
    = hint: write `roMake (setVelTR v 0)`
  
  1 error
  # 049_where_not_indented.frob
  error[E0110]: this `where` has no definitions
   --> 049_where_not_indented.frob:2:20
    |
  2 | main = proc d -> v where
    |                    ^^^^^
    |
    = hint: indent the definitions after `where` further than the definition that the `where` belongs to
  
  1 error
  # 050_signal_outside_proc.frob
  error[E0205]: unknown name `i`
   --> 050_signal_outside_proc.frob:3:32
    |
  3 | speed = 0.5[1/s] * (frontSonar i - 0.3[m])
    |                                ^
  4 |
  5 | main = reactimateRobot (proc i -> roMake (setVelTR speed 0))
    |                              - this `i` is a signal of a `proc`
    |
    = hint: a signal can only be used inside its `proc`: move the equation to the `where` of that `proc`, or write a signal function with its own input: `proc i -> …`
  
  1 error
  # 051_task_started_in_proc.frob
  error[E0371]: `roMake` does not return a task, but `Task b c Bool` is needed here
   --> 051_task_started_in_proc.frob:5:59
    |
  5 |     if bumped i then driveTo (Vec2 { x = 0, y = 0 }) else roMake (setVelTR 0.2[m/s] 0))
    |                                                           ^^^^^^
    |
    = hint: a robot command is not a task: in a `do`, write `sleepT 1[s] (roMake …)` to give it for a fixed time, or `mkTask (proc i -> (roMake …, e))` to give it until an event `e` occurs
  
  1 error
  # 052_hold_without_start.frob
  error[E0303]: expected a value, found a signal function that is not applied to a signal
   --> 052_hold_without_start.frob:2:18
    |
  1 | main :: SF (Event Float) Float
    |         ---------------------- the signature of `main` requires the output `Float`
  2 | main = proc e -> hold e
    |                  ^^^^^^ this is `SF (Event (Event Float)) (Event Float)`
    |
    = note: expected `Float`
    = hint: `hold` takes an initial value before its signal: write `hold 0 e`
  
  1 error
  # 053_negative_argument.frob
  error[E0301]: this `-` subtracts from a function
   --> 053_negative_argument.frob:3:52
    |
  3 | main = reactimateRobot (proc i -> roMake (setVelTR -0.2[m/s] 0))
    |                                           -------- ^
    |                                           |
    |                                           this is `Velocity -> AngularVelocity -> a -> a`
    |
    = hint: put the negative argument in parentheses: `setVelTR (-0.2[m/s])`
  
  1 error
  # 054_setLight_on_pioneer.frob
  error[E0360]: there is no instance `HasLight PioneerOutput`
     --> 054_setLight_on_pioneer.frob:4:65
      |
    4 | main = reactimateRobot (proc i -> roMake (setVelTR 0.2[m/s] 0 . setLight On))
      |                                                                 ^^^^^^^^ `setLight` needs it
      |
     ::: stdlib/Capability.frob:230:17
      |
  230 |     setLight :: Light -> o -> o
      |                 --------------- `setLight` requires `HasLight o` here
      |
      = note: types with `HasLight`: `CreateOutput`
      = hint: for a program that runs on every robot with this capability, write the class instead of the robot's type: `main :: (HasOdometry i, HasLight o) => Program i o`
  
  1 error
  # 055_two_modules_T.frob
  error[E0301]: expected `Main.Pose`, found `Geometry.Pose`
   --> 055_two_modules_T.frob:7:18
    |
  6 | main :: SF RobotInput Pose
    |         ------------------ the signature of `main` requires the output `Main.Pose`
  7 | main = proc i -> robotPose i
    |                  ^^^^^^^^^^^
    |
    = hint: two types have the name `Pose`: use the same one in both places, or convert the value
  
  1 error
  # 056_main_with_parameter.frob
  error[E0411]: `main` cannot run: it still needs an argument, as its type `(HasSonar a, DiffDrive b) => Float[m] -> Program a b` shows
   --> 056_main_with_parameter.frob:3:1
    |
  3 | main d = reactimateRobot (proc i -> roMake (setVelTR (0.5[1/s] * (frontSonar i - d)) 0))
    | ^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^
    |
    = hint: give it another name, such as `run`, and write `main = run …`
  
  1 error
  # 057_several_clauses.frob
  error[E0115]: `sign` is defined by several clauses
   --> 057_several_clauses.frob:3:1
    |
  2 | sign 0 = 0
    | ---- the first
  3 | sign x = x / abs x
    | ^^^^
    |
    = hint: write one clause, `sign x = case x of`; on the lines below it, write a branch `pattern -> value` for each clause
  
  1 error
  # 058_list_type.frob
  error[E0110]: the type of an array cannot be written in brackets
   --> 058_list_type.frob:1:12
    |
  1 | average :: [Float] -> Float
    |            ^
    |
    = hint: write `average :: Array n Float -> Float`, or with a number instead of the size `n`
  
  1 error
  # 059_list_range.frob
  error[E0110]: Frob has no `..`
   --> 059_list_range.frob:2:33
    |
  2 | main = proc x -> foldl (+) x [1 .. 10]
    |                                 ^^
    |
    = hint: Frob has no ranges: write the elements, `[1, 2, 3, 4, 5, 6, 7, 8, 9, 10]`
  
  1 error
  # 060_where_after_do.frob
  error[E0205]: unknown name `v`
   --> 060_where_after_do.frob:6:18
    |
  2 | main = proc v -> do
    |             - this `v` is a signal of the `proc`
  ...
  6 |     scaled = 2 * v
    |                  ^
    |
    = hint: a `where` after `do` belongs to the whole definition and cannot use signals: write a `let` in the `do`
  
  1 error
  # 061_bind_operator.frob
  error[E0110]: Frob has no `>>=`
   --> 061_bind_operator.frob:3:35
    |
  3 | main = reactimateTask (robotPlace >>= \p -> driveTo p)
    |                                   ^^^
    |
    = hint: write each task on its own line in a `do`
  
  1 error
  # 062_fmap_operator.frob
  error[E0110]: Frob has no `<$>`
   --> 062_fmap_operator.frob:2:24
    |
  2 | main = proc e -> (* 2) <$> e
    |                        ^^^
    |
    = hint: write `mapE (* 2) e` for an event, or `map (* 2) e` for an array
  
  1 error
  # 063_pure_result.frob
  error[E0205]: unknown name `pure`
   --> 063_pure_result.frob:5:5
    |
  5 |     pure ())
    |     ^^^^
    |
    = hint: write `return`
  
  1 error
  # 064_num_constraint.frob
  error[E0223]: unknown type class `Num`
   --> 064_num_constraint.frob:1:10
    |
  1 | twice :: Num a => a -> a
    |          ^^^
    |
    = hint: Frob has no numeric type classes: write `twice :: n[u] -> n[u]`
  
  1 error
  # 065_texts_joined.frob
  error[E0110]: Frob has no `++`
   --> 065_texts_joined.frob:2:27
    |
  2 | main = proc n -> "count " ++ show n
    |                           ^^
    |
    = hint: strings and arrays cannot be concatenated: a string is a label, and an array has a fixed size
  
  1 error
  # 066_factorial.frob
  error[E0410]: `factorial` calls itself
   --> 066_factorial.frob:2:1
    |
  2 | factorial n = if n == 0 then 1 else n * factorial (n - 1)
    | ^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^
    |                                         |
    |                                         `factorial` uses `factorial` here
    |
    = note: functions cannot be recursive: use `foldl` or `scanl` to process an array; a signal function may only restart itself in the continuation of a switch
    = hint: for a loop over 0, 1, … up to `n`, write `foldl (\s k -> if k <= n then s + k else s) 0 (generate id :: Array 100 Int)`: `s + k` combines the result so far with the number `k`, 0 is the initial result, and the array size, here 100, must be greater than `n`
  
  1 error
  # 067_if_between_commands.frob
  error[E0116]: `if` and `case` cannot choose between commands
   --> 067_if_between_commands.frob:4:20
    |
  3 |     if b
    |     -- this chooses between commands
  4 |       then delay 0 -< x
    |                    ^^
    |
    = hint: choose the input, as in `y <- sf -< if c then a else b`, or run both commands and choose between their outputs
  
  1 error
  # 068_deriving.frob
  error[E0112]: Frob has no `deriving`
   --> 068_deriving.frob:1:23
    |
  1 | data Mode = Wait | Go deriving (Eq, Show)
    |                       ^^^^^^^^
    |
    = hint: remove it: `==` and `<` work on all data that contains no functions
  
  1 error
  # 069_maybe_as_value.frob
  error[E0301]: expected a number, found `Maybe Int`
   --> 069_maybe_as_value.frob:5:18
    |
  5 | main = proc i -> beaconSeen i + 1
    |                  ^^^^^^^^^^^^ - argument 1 of `+` is a number
    |
    = hint: use `fromMaybe 0 (beaconSeen i)`, where `0` replaces a missing value
  
  1 error
  # 070_operator_definition.frob
  error[E0110]: Frob has no `|+|`
   --> 070_operator_definition.frob:1:2
    |
  1 | (|+|) :: Float -> Float -> Float
    |  ^^^
    |
    = hint: programs cannot define operators: define a function, such as `combine a b = sqrt (a * a + b * b)`, and write ``a `combine` b``
  
  1 error
  # 071_double_for_velocity.frob
  error[E0320]: expected the unit `m/s`, found none
   --> 071_double_for_velocity.frob:5:8
    |
  4 | main :: SF Velocity Velocity
    |         -------------------- the signature of `main` requires `SF Velocity Velocity`
  5 | main = arr slow
    |        ^^^^^^^^ this is `SF Double Double`
    |
    = note: expected `SF Velocity Velocity`, found `SF Double Double`
    = hint: use `Float[m/s]` for this unit; without brackets, `Float` and `Double` have no unit
  
  1 error
  # 072_fromIntegral.frob
  error[E0205]: unknown name `fromIntegral`
   --> 072_fromIntegral.frob:2:18
    |
  2 | main = proc n -> fromIntegral n / 2
    |                  ^^^^^^^^^^^^
    |
    = hint: write `toFloat n`
  
  1 error
  # 073_int_times_float.frob
  error[E0312]: the operands of `*` are `Int` and `Float`
   --> 073_int_times_float.frob:2:27
    |
  2 | main = proc (n, x) -> n * x
    |                       -   ^ this is `Float`
    |                       |
    |                       this is `Int`
    |
    = hint: write `toFloat n`
  
  1 error
  # 074_function_for_signal_function.frob
  error[E0304]: expected a signal function, found a function: `n[v] -> n[v]`
   --> 074_function_for_signal_function.frob:2:21
    |
  2 | main = integral >>> (* 2)
    |        --------     ^^^^^
    |        |
    |        this is `SF Float[u] Float[u s]`
    |
    = hint: use `arr` to turn a function into a signal function: `arr (* 2)`
  
  1 error
  # 075_pattern_lambda_case.frob
  error[E0351]: the pattern of a function must match every value
   --> 075_pattern_lambda_case.frob:2:21
    |
  2 | main = proc e -> (\(Event x) -> x) e
    |                     ^^^^^^^ does not match `NoEvent`
    |
    = hint: use a `case`, with a branch for `NoEvent` too
  
  1 error
  # 076_let_without_in.frob
  error[E0110]: expected `in` and an expression after the definitions of this `let`, found `k`
   --> 076_let_without_in.frob:4:9
    |
  4 |         k * x
    |         ^
    |
    = hint: put `in` before the expression, `in k * x`; if this is another definition, start it at column 13
  
  1 error
  # 077_def_function.frob
  error[E0103]: unexpected character `:`
   --> 077_def_function.frob:1:24
    |
  1 | def limit(x, low, high):
    |                        ^
    |
    = hint: define a function by an equation: `limit x low high = max low (min x high)`
  
  1 error
  # 078_plus_equals.frob
  error[E0110]: Frob has no `+=`
   --> 078_plus_equals.frob:4:17
    |
  4 |     if b then n += 1
    |                 ^^
    |
    = hint: Frob has no assignments: write an equation that holds at every instant, as in `n = delay 0 n + 1`
  
  1 error
  # 079_print_call.frob
  error[E0110]: Frob has no `print`
   --> 079_print_call.frob:5:5
    |
  5 |     print("speed", v))
    |     ^^^^^
    |
    = hint: a program cannot print, so remove this line: `frobc run` prints the result of a task when the task ends; to see other values, make them outputs, and write all outputs to a file with `--record`
  
  1 error
  # 080_and_word.frob
  error[E0205]: Frob has no `and`
   --> 080_and_word.frob:2:25
    |
  2 | main = proc (b, x) -> b and x > 1
    |                         ^^^
    |
    = hint: write `&&` instead of `and`
  
  1 error
  # 081_single_equals.frob
  error[E0110]: expected `then` after the condition, found `=`
   --> 081_single_equals.frob:2:23
    |
  2 | main = proc n -> if n = 0 then 1 else 2
    |                       ^
    |
    = hint: use `==` to compare; `=` defines a name
  
  1 error
  # 082_elif.frob
  error[E0110]: Frob has no `elif`
   --> 082_elif.frob:2:34
    |
  2 | main = proc x -> if x > 1 then 1 elif x < -1 then -1 else x
    |                                  ^^^^
    |
    = hint: use `else if`: `if a then x else if b then y else z`
  
  1 error
  # 083_colon_block.frob
  error[E0103]: unexpected character `:`
   --> 083_colon_block.frob:4:16
    |
  4 |     if bumped i:
    |                ^
    |
    = hint: remove the colon: a block is delimited by its indentation; write a choice as `if c then a else b`
  
  1 error
  # 084_for_loop.frob
  error[E0103]: unexpected character `:`
   --> 084_for_loop.frob:4:16
    |
  4 |     for d in ds:
    |                ^
    |
    = hint: Frob has no loops: write `map f ds` or `foldl (+) 0 ds` for an array, or `forEachT ds f` to run a task for each element
  
  1 error
  # 085_call_with_commas.frob
  error[E0301]: expected `Velocity` (m/s), found a tuple with 2 elements
   --> 085_call_with_commas.frob:3:50
    |
  3 | main = reactimateRobot (proc i -> roMake(setVelTR(0.2[m/s], 0)))
    |                                          --------^^^^^^^^^^^^^
    |                                          |
    |                                          argument 1 of `setVelTR` is `Velocity` (m/s)
    |
    = hint: write the arguments without parentheses or commas: `setVelTR 0.2[m/s] 0`
  
  1 error
  # 086_python_lambda.frob
  error[E0103]: unexpected character `:`
   --> 086_python_lambda.frob:2:32
    |
  2 | main = proc xs -> map (lambda x: 2 * x) xs
    |                                ^
    |
    = hint: write an anonymous function as `\x -> 2 * x`
  
  1 error
  # 087_arduino_loop.frob
  error[E0110]: Frob has no `void`
   --> 087_arduino_loop.frob:1:1
    |
  1 | void loop() {
    | ^^^^
    |
    = hint: Frob has no procedures: write equations that hold at every instant, as in `main = reactimateRobot (proc i -> roMake (setVelTR v omega))`
  
  1 error
  # 088_while_loop.frob
  error[E0205]: unknown name `while`
   --> 088_while_loop.frob:4:5
    |
  4 |     while (not (bumped i))
    |     ^^^^^
    |
    = hint: to repeat the tasks below, replace this line with `forever $ do`, or with `whileT (proc i -> …) $ do` to repeat them while a condition holds; to end a task when something happens, use `abortWhen`
  
  1 error
  # 089_milliseconds.frob
  error[E0320]: expected the unit `s`, found none
   --> 089_milliseconds.frob:4:12
    |
  4 |     sleepT 1000 (roMake (setVelTR 0.2[m/s] 0))
    |     ------ ^^^^ this is `Float`
    |     |
    |     argument 1 of `sleepT` is `Time` (s)
    |
    = hint: write `1000[ms]` if these are milliseconds, or `1000[s]` if these are seconds
  
  error[E0320]: expected the unit `s`, found none
   --> 089_milliseconds.frob:5:12
    |
  5 |     sleepT 500 (roMake (setVelTR 0 1[rad/s])))
    |     ------ ^^^ this is `Float`
    |     |
    |     argument 1 of `sleepT` is `Time` (s)
    |
    = hint: write `500[ms]` if these are milliseconds, or `500[s]` if these are seconds
  
  2 errors
  # 090_int_declaration.frob
  error[E0205]: unknown name `m`
   --> 090_int_declaration.frob:2:18
    |
  2 | main = proc n -> m where
    |                  ^
  3 |     int m = n + 1
    |     --- this defines a function `int`
    |
    = hint: write `m = n + 1`, without a type
  
  1 error
  # 091_slash_comment.frob
  error[E0110]: Frob has no `//`
   --> 091_slash_comment.frob:1:1
    |
  1 | // follows a wall
    | ^^
    |
    = hint: write `--` to start a comment
  
  1 error
  # 092_question_mark.frob
  error[E0103]: unexpected character `?`
   --> 092_question_mark.frob:2:24
    |
  2 | main = proc x -> x > 0 ? x : 0
    |                        ^
    |
    = hint: use `if x > 0 then x else 0`
  
  1 error
  # 093_exclamation_mark.frob
  error[E0110]: Frob has no prefix `!`
   --> 093_exclamation_mark.frob:2:28
    |
  2 | main = proc (a, b) -> a && !b
    |                            ^
    |
    = hint: write `not b`
  
  1 error
  # 094_define.frob
  error[E0103]: unexpected character `#`
   --> 094_define.frob:1:1
    |
  1 | #define V_MAX 0.4
    | ^
    |
    = hint: define a constant by an equation: `v_max = 0.4`
  
  1 error
  # 095_remainder.frob
  error[E0103]: unexpected character `%`
   --> 095_remainder.frob:2:20
    |
  2 | main = proc n -> n % 2 == 0
    |                    ^
    |
    = hint: use ``x `mod` y`` for the remainder; 20 percent of x is `0.2 * x`
  
  1 error
  # 096_matlab_function.frob
  error[E0110]: Frob has no `function`
   --> 096_matlab_function.frob:1:1
    |
  1 | function y = twice(x)
    | ^^^^^^^^
    |
    = hint: define a function by an equation: `twice x = 2 * x`; a block ends where its indentation ends
  
  1 error
  # 097_element_powers.frob
  error[E0110]: Frob has no `.^`
   --> 097_element_powers.frob:2:22
    |
  2 | main = proc xs -> xs .^ 2
    |                      ^^
    |
    = hint: operators take numbers, not arrays: write `xs ^ 2` for numbers, or `map (\x -> x ^ 2) xs` for arrays
  
  1 error
  # 098_array_without_commas.frob
  error[E0302]: this is `Float`, not a function
   --> 098_array_without_commas.frob:2:12
    |
  2 | weights = [0.25 0.5 0.25]
    |            ^^^^ --- it is applied to an argument here
    |
    = hint: put commas between the elements: `[0.25, 0.5, 0.25]`
  
  1 error
  # 099_index_in_parentheses.frob
  error[E0302]: `ds` is `Array 3 Distance`, not a function
   --> 099_index_in_parentheses.frob:2:19
    |
  2 | main = proc ds -> ds(1) + ds(2)
    |                   ^^ - it is applied to an argument here
    |
    = hint: write `ds ! 1` for that element; the first element is `! 0`
  
  error[E0302]: `ds` is `Array 3 Distance`, not a function
   --> 099_index_in_parentheses.frob:2:27
    |
  2 | main = proc ds -> ds(1) + ds(2)
    |                           ^^ - it is applied to an argument here
    |
    = hint: write `ds ! 2` for that element; the first element is `! 0`
  
  2 errors
  # 100_tilde_equals.frob
  error[E0103]: unexpected character `~`
   --> 100_tilde_equals.frob:2:25
    |
  2 | main = proc (a, b) -> a ~= b
    |                         ^
    |
    = hint: use `/=` to compare for inequality
  
  1 error
  [1]
