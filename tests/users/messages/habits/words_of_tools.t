Words of MATLAB, NumPy, Haskell and ROS, loops by recursion, and a counter. Each program is one or
more lines under a signature; the test shows the message without the source, and checks the lines
with which the hint replaces them.

  $ try () { # SIGNATURE LINES CORRECTED-LINES
  >   for lines in "$2" "$3"; do
  >     printf 'import Matrix\nimport Robot\nf :: %s\n%b\n' "$1" "$lines" > program.frob
  >     frobc check program.frob 2>&1 | grep -v 'W0306\|: remove it$' | grep '^error\|^warning\|hint'
  >   done
  > }

  $ try 'Array 2 (Array 2 Float) -> Array 2 (Array 2 Float)' 'f m = m * m'\' 'f m = matMul m (transpose m)'
  error[E0205]: unknown name `m'`
    = hint: `'` is part of the name: for the transpose of `m`, write `matMul m (transpose m)`
  [1]
  $ try 'Matrix 2 3 -> Matrix 3 3' 'f m = m'\'' * m' 'f m = matMul (transpose m) m'
  error[E0205]: unknown name `m'`
    = hint: `'` is part of the name: for the transpose of `m`, write `matMul (transpose m) m`
  [1]
  $ try 'Array 2 (Array 2 Float) -> Array 2 (Array 2 Float)' 'f m = m * transpose m' 'f m = matMul m (transpose m)'
  error[E0301]: expected a number, found `Array 2 (Array 2 Float)`
    = hint: to multiply a matrix by a matrix, write `matMul m (transpose m)`
  [1]
  $ try 'SF (Array 4 Float) (Array 4 Float)' 'f = proc x -> delay zeros(1, 4) x' 'f = proc x -> delay [0, 0, 0, 0] x'
  error[E0205]: unknown name `zeros`
    = hint: write `[0, 0, 0, 0]`: an array literal lists its elements
  [1]
  $ try 'Array 2 (Array 2 Float)' 'f = ones(2, 2)' 'f = [[1, 1], [1, 1]]'
  error[E0205]: unknown name `ones`
    = hint: write `[[1, 1], [1, 1]]`: an array literal lists its elements
  [1]
  $ try 'SF (Array 20 Float) (Array 20 Float)' 'f = proc x -> delay zeros(20) x' 'f = proc x -> delay (generate (const 0)) x'
  error[E0205]: unknown name `zeros`
    = hint: write `(generate (const 0))`: its type determines the number of elements
  [1]
  $ try 'SF RobotInput Int' 'f = proc i -> hold 0 (fmap (\\k -> k - 48) (keyPressed i))' 'f = proc i -> hold 0 (mapE (\\k -> k - 48) (keyPressed i))'
  error[E0205]: unknown name `fmap`
    = hint: write `mapE`
  [1]
  $ try 'SF RobotInput Float' 'f = proc i -> sum (fmap (\\x -> x * 2) xs) where\n    xs = [1, 2]' 'f = proc _ -> sum (map (\\x -> x * 2) xs) where\n    xs = [1, 2]'
  error[E0205]: unknown name `fmap`
    = hint: write `map`
  [1]

The command of a robot in ROS:

  $ try 'SF RobotInput RobotOutput' 'f = proc i -> Twist { linear = v, angular = 0 } where\n    v = if bumped i then 0 else 0.3[m/s]' 'f = proc i -> roMake (setVelTR v 0) where\n    v = if bumped i then 0 else 0.3[m/s]'
  error[E0206]: unknown constructor `Twist`
    = hint: a robot's output is a command, not a `Twist`: write `roMake (setVelTR v 0)`
  [1]
  $ printf 'import Robot\nimport Ros\nf :: SF RobotInput RobotOutput\nf = proc _ -> twist 0.2[m/s] 0\n' > twist.frob
  $ frobc check twist.frob 2>&1 | grep '^error\|hint'
  error[E0301]: expected `RobotOutput`, found `Twist`
    = hint: a robot's output is a command, not a `Twist`: write `roMake (setVelTR v omega)`, where `v` is the `linear` velocity and `omega` the `angular` one

Loops and counters:

  $ try 'Int -> Int' 'f n = if n <= 0 then 0 else n + f (n - 1)' 'f n = foldl (\\s k -> if k <= n then s + k else s) 0 (generate id :: Array 100 Int)'
  error[E0410]: `f` calls itself
    = hint: for a loop over 0, 1, … up to `n`, write `foldl (\s k -> if k <= n then s + k else s) 0 (generate id :: Array 100 Int)`: `s + k` combines the result so far with the number `k`, 0 is the initial result, and the array size, here 100, must be greater than `n`
  [1]
  $ try 'SF Bool Int' 'f = proc b -> n where\n    n    = 0\n    n   += if b then 1 else 0' 'f = proc b -> n where\n    n = delay 0 n + (if b then 1 else 0)'
  error[E0110]: Frob has no `+=`
    = hint: Frob has no assignments: write an equation that holds at every instant: instead of both lines, write `n = delay 0 n + (if b then 1 else 0)`
  [1]
  $ try 'SF Bool Int' 'f = proc b -> n where\n    n = 0\n    n = delay 0 n + (if b then 1 else 0)' 'f = proc b -> n where\n    n = delay 0 n + (if b then 1 else 0)'
  error[E0212]: `n` is defined twice here
    = hint: remove `n = 0`: the `delay` in the other equation already has the initial value
  [1]

An integral in a branch:

  $ try 'SF RobotInput Distance' 'f = proc i -> if bumped i then 0 else integral (velocity i)' 'f = proc i -> integral (if bumped i then 0 else velocity i)'
  error[E0342]: `integral` is run in a branch
    = hint: to run it at every instant, add the equation `integralNow = integral (velocity i)`, and write `integralNow` here
    = hint: to restart it whenever this branch is chosen, write `integralNow = resetOn integral (velocity i, edge (not (bumped i)))`
    = hint: to pause it while this branch is not chosen, write `integral (if bumped i then 0 else velocity i)` in place of the whole `if`
  [1]

Statements of a task:

  $ try '(HasSonar i, DiffDrive o) => Task i o Bool' 'f = do\n    arrived <- forward 1[m]\n    if not arrived\n      then turnBy 180[deg]' 'f = do\n    arrived <- forward 1[m]\n    if not arrived\n      then turnBy 180[deg]\n      else return True'
  error[E0110]: expected `else` after the first branch, found the end of the block
    = hint: add an `else`: every `if` has a value; in the `do` of a task, write `else return True` if the task after `then` returns a `Bool`, as `forward` and `turnBy` do, or `else return ()` if it returns nothing
  [1]
  $ try '(HasSonar i, DiffDrive o) => Task i o Bool' 'f = do\n    arrived <- forward 1[m]\n    print(arrived)\n    return arrived' 'f = do\n    arrived <- forward 1[m]\n    return arrived'
  error[E0205]: unknown name `print`
    = hint: a program cannot print, so remove this: `frobc run FILE --view` shows every signal, `--probe v --record run.csv` records the signal `v`, and the result of a task is printed when the task ends
  [1]
