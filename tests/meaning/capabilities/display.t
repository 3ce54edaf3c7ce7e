The drawing of a program is part of its output: it passes through branches, switches, tasks, loops
and delays like the output. Both engines draw the same, and the program without the probe draws
nothing.

  $ cat > both.sh <<'EOF'
  > set -e
  > frobc trace $1 --input $2 --probe draw --lint > c.csv
  > frobc trace $1 --input $2 --probe draw --engine interp > interp.csv
  > cmp c.csv interp.csv
  > frobc trace $1 --input $2 --probe draw --real float > c.csv
  > frobc trace $1 --input $2 --probe draw --real float --engine interp > float.csv
  > cmp c.csv float.csv
  > cat interp.csv
  > EOF
  $ cat > Vehicle.frob <<'EOF'
  > module Vehicle where
  > import Capability
  > import Display
  > 
  > data Out = Out { ahead :: Float, drawing :: Drawing }
  > 
  > instance RobotOutput Out where
  >     restingOutput = Out { ahead = 0, drawing = blank }
  > 
  > instance HasDisplay Out where
  >     drawingOf out = out.drawing
  >     withDrawing marks out = out { drawing = marks }
  > EOF
  $ cat > in.csv <<EOF
  > time,in
  > 0,0
  > 1,1
  > 2,-2
  > 3,nan
  > EOF

Each kind of mark, and a branch that draws at some instants only. A text is written as in the
language, and a number in the unit that it has there.

  $ cat > kinds.frob <<'EOF'
  > import Capability
  > import Display
  > import Geometry
  > import Vehicle
  > 
  > main :: SF Float Out
  > main = proc x -> roMake (above . draw (number "speed" (x * 1[km/hour])) . below) where
  >     p = Vec2 { x = 1[m], y = 2[m] }
  >     below = draw (InWorld Red (Line p zeroVec)) . draw (OnRobot Grey (Arrow zeroVec p))
  >         . draw (InWorld Blue (Circle p 0.5[m])) . draw (InWorld Purple (Cross p))
  >         . draw (InWorld Green (Box p 90[deg] 2[m] 1[m]))
  >     above = if x > 0 then draw (OnRobot Orange (label p "an \"x\", \\ über")) else id
  > EOF
  $ sh both.sh kinds.frob in.csv
  time,out.ahead,probe.draw[0],probe.draw[1],probe.draw[2],probe.draw[3],probe.draw[4],probe.draw[5],probe.draw[6]
  0.000000000,0,"InWorld Green (Box Vec2 {x = 1, y = 2} 1.5707963267948966 2 1)","InWorld Purple (Cross Vec2 {x = 1, y = 2})","InWorld Blue (Circle Vec2 {x = 1, y = 2} 0.5)","OnRobot Grey (Arrow Vec2 {x = 0, y = 0} Vec2 {x = 1, y = 2})","InWorld Red (Line Vec2 {x = 1, y = 2} Vec2 {x = 0, y = 0})","Reading ""speed"" 0 ""m/s""",
  1.000000000,0,"InWorld Green (Box Vec2 {x = 1, y = 2} 1.5707963267948966 2 1)","InWorld Purple (Cross Vec2 {x = 1, y = 2})","InWorld Blue (Circle Vec2 {x = 1, y = 2} 0.5)","OnRobot Grey (Arrow Vec2 {x = 0, y = 0} Vec2 {x = 1, y = 2})","InWorld Red (Line Vec2 {x = 1, y = 2} Vec2 {x = 0, y = 0})","Reading ""speed"" 0.27777777777777779 ""m/s""","OnRobot Orange (Label Vec2 {x = 1, y = 2} ""an \""x\"", \\ über"")"
  2.000000000,0,"InWorld Green (Box Vec2 {x = 1, y = 2} 1.5707963267948966 2 1)","InWorld Purple (Cross Vec2 {x = 1, y = 2})","InWorld Blue (Circle Vec2 {x = 1, y = 2} 0.5)","OnRobot Grey (Arrow Vec2 {x = 0, y = 0} Vec2 {x = 1, y = 2})","InWorld Red (Line Vec2 {x = 1, y = 2} Vec2 {x = 0, y = 0})","Reading ""speed"" (-0.55555555555555558) ""m/s""",
  3.000000000,0,"InWorld Green (Box Vec2 {x = 1, y = 2} 1.5707963267948966 2 1)","InWorld Purple (Cross Vec2 {x = 1, y = 2})","InWorld Blue (Circle Vec2 {x = 1, y = 2} 0.5)","OnRobot Grey (Arrow Vec2 {x = 0, y = 0} Vec2 {x = 1, y = 2})","InWorld Red (Line Vec2 {x = 1, y = 2} Vec2 {x = 0, y = 0})","Reading ""speed"" nan ""m/s""",
  $ frobc report kinds.frob | tail -1
  maximum number of marks drawn in an instant: 7; the generated C does not draw them
  $ frobc trace kinds.frob --probe list | head -2
  draw :: drawings, at most 7 marks at a time
  main.p.x :: Float[m]  kinds.frob:8

Without the probe nothing is drawn, and the C is the same as without marks.

  $ cat > without.frob <<'EOF'
  > import Capability
  > import Vehicle
  > 
  > main :: SF Float Out
  > main = proc _ -> roMake id
  > EOF
  $ frobc trace kinds.frob --input in.csv
  time,out.ahead
  0.000000000,0
  1.000000000,0
  2.000000000,0
  3.000000000,0
  $ for p in kinds without; do frobc compile $p.frob -o $p; done
  $ sed -n '/_step/,$p' kinds/kinds.c | sed 's/kinds/without/g; s/line [0-9]*//' > a
  $ sed -n '/_step/,$p' without/without.c | sed 's/line [0-9]*//' | diff a -

Tasks, and a delayed output: the marks of the current output count. At the end the output is at
rest, without marks.

  $ cat > steps.frob <<'EOF'
  > import Capability
  > import Display
  > import Geometry
  > import Vehicle
  > 
  > main :: SF Float (Either Out Bool)
  > main = runTask (do
  >     sleepT 1[s] (roMake (draw (InWorld Red (Cross zeroVec))))
  >     mkTask (proc x -> let o = roMake (draw (number "x" x)) in
  >         (overlay (delay restingOutput o) o, when (x < 0)))
  >     return True)
  > 
  > shown :: SF Float Out
  > shown = proc x -> out where
  >     out = either id (\_ -> restingOutput) (main x)
  > EOF
  $ cat > many.csv <<EOF
  > time,in
  > 0,0
  > 1,1
  > 2,2
  > 3,-1
  > 4,-1
  > EOF
  $ frobc trace steps.frob --entry shown --input many.csv --probe draw > c.csv
  $ frobc trace steps.frob --entry shown --input many.csv --probe draw --engine interp | diff c.csv -
  $ cat c.csv
  time,out.ahead,probe.draw[0],probe.draw[1]
  0.000000000,0,"InWorld Red (Cross Vec2 {x = 0, y = 0})",
  1.000000000,0,"Reading ""x"" 1 """"",
  2.000000000,0,"Reading ""x"" 1 """"","Reading ""x"" 2 """""
  3.000000000,0,,
  4.000000000,0,,

A drawing in a loop counts once per iteration. Comparisons of outputs ignore it.

  $ cat > loop.frob <<'EOF'
  > import Capability
  > import Display
  > import Geometry
  > import Vehicle
  > 
  > main :: SF Float Out
  > main = proc x -> (if same then shown else roMake id) where
  >     places = [Vec2 { x = x * 1[m], y = 0 }, Vec2 { x = 2[m], y = 0 }, Vec2 { x = 0, y = 3[m] }]
  >     shown = foldl crossed (roMake (drawPath (InWorld Yellow) places)) places
  >     same = shown == roMake id && not (shown < roMake id)
  >     crossed out p = if p.x > 0.5[m] then draw (OnRobot Red (Cross p)) out else out
  > EOF
  $ sh both.sh loop.frob in.csv
  time,out.ahead,probe.draw[0],probe.draw[1],probe.draw[2],probe.draw[3],probe.draw[4],probe.draw[5]
  0.000000000,0,"InWorld Yellow (Line Vec2 {x = 0, y = 0} Vec2 {x = 0, y = 0})","InWorld Yellow (Line Vec2 {x = 0, y = 0} Vec2 {x = 2, y = 0})","InWorld Yellow (Line Vec2 {x = 2, y = 0} Vec2 {x = 0, y = 3})","OnRobot Red (Cross Vec2 {x = 2, y = 0})",,
  1.000000000,0,"InWorld Yellow (Line Vec2 {x = 1, y = 0} Vec2 {x = 1, y = 0})","InWorld Yellow (Line Vec2 {x = 1, y = 0} Vec2 {x = 2, y = 0})","InWorld Yellow (Line Vec2 {x = 2, y = 0} Vec2 {x = 0, y = 3})","OnRobot Red (Cross Vec2 {x = 1, y = 0})","OnRobot Red (Cross Vec2 {x = 2, y = 0})",
  2.000000000,0,"InWorld Yellow (Line Vec2 {x = -2, y = 0} Vec2 {x = -2, y = 0})","InWorld Yellow (Line Vec2 {x = -2, y = 0} Vec2 {x = 2, y = 0})","InWorld Yellow (Line Vec2 {x = 2, y = 0} Vec2 {x = 0, y = 3})","OnRobot Red (Cross Vec2 {x = 2, y = 0})",,
  3.000000000,0,"InWorld Yellow (Line Vec2 {x = nan, y = 0} Vec2 {x = nan, y = 0})","InWorld Yellow (Line Vec2 {x = nan, y = 0} Vec2 {x = 2, y = 0})","InWorld Yellow (Line Vec2 {x = 2, y = 0} Vec2 {x = 0, y = 3})","OnRobot Red (Cross Vec2 {x = 2, y = 0})",,
  $ frobc report loop.frob | tail -1
  maximum number of marks drawn in an instant: 6; the generated C does not draw them

A program that does not draw has no such probe; one that keeps adding to its previous drawing has no
bound.

  $ frobc trace without.frob --input in.csv --probe draw
  error[E0506]: this program has no inner signal `draw`
   --> without.frob:5:1
    |
  5 | main = proc _ -> roMake id
    | ^^^^
    |
    = hint: `--probe list` lists all inner signals
  
  1 error
  [2]
  $ cat > trail.frob <<'EOF'
  > import Capability
  > import Display
  > import Geometry
  > import Vehicle
  > 
  > main :: SF Float Out
  > main = proc x -> out where
  >     out = draw (InWorld Red (Cross Vec2 { x = x * 1[m], y = 0 })) (delay restingOutput out)
  > EOF
  $ frobc check trail.frob
  error[E0432]: `main` may draw more than 1000 marks in an instant
   --> trail.frob:7:1
    |
  7 | main = proc x -> out where
    | ^^^^
    |
    = note: the maximum number of marks must be known before the program runs
    = hint: draw on a new output in each instant: an output that is stored, for example by `delay`, keeps its marks
  
  1 error
  [1]
