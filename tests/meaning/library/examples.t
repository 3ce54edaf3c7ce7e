The examples in the doc comments of the library: `Example: ` and Frob in backticks. Each runs in both
engines, on an input with the names that the examples use.

  $ cat > examples.awk << 'AWK'
  > FNR == 1 { module = FILENAME; sub(/.*\//, "", module); sub(/\.frob/, "", module) }
  > /^-- Example: `.*`\.$/ {
  >     sub(/^-- Example: `/, ""); sub(/`\.$/, "")
  >     if (!(module in imported)) imports = imports "import " module "\n"
  >     imported[module]
  >     n++
  >     equations = equations "    example" n " = " $0 "\n"
  >     outputs = outputs (n > 1 ? ", " : "") "example" n
  > }
  > END {
  >     printf "import Control\n%s", imports
  >     print "gains :: Pid[1, 1]"
  >     print "gains = Pid { kp = 1, ki = 1[1/s], kd = 1[s], largest = 1 }"
  >     print "start :: Estimate 1"
  >     print "start = Estimate { mean = [0], covariance = [[1]] }"
  >     print "linear :: Linear 1 1 1"
  >     print "linear = Linear { f = [[1]], b = [[0.5]], q = [[0.1]], h = [[1]], r = [[0.5]] }"
  >     print "system :: System 1 1 1"
  >     print "system = System { move = \\_ u x -> vecAdd u x, noise = \\_ _ _ -> [[0.1]], measure = id, r = [[0.5]], residual = vecSub, small = 0.001 }"
  >     print "inputs :: SF (Float, Float[1/s], Angle, Float, Bool) (Float, Float[1/s], Angle, Float, Bool)"
  >     print "inputs = identity"
  >     print "main = proc given -> (" outputs ") where"
  >     print "    (reading, rate, heading, goal, pressed) = inputs given"
  >     print "    scan = (scanOf 0.1[m] 9[m] (generate (\\k -> toFloat k * reading * 1[m]) :: Array 36 Distance) :: Scan 36)"
  >     print "    pose = Pose { position = Vec2 { x = 1[m], y = 2[m] }, heading = heading }"
  >     printf "%s", equations
  > }
  > AWK
  $ awk -f examples.awk $(ls ../../../stdlib/*.frob) > examples.frob
  $ test $(grep -c '^    example' examples.frob) -ge 160
  $ cat > input.csv << ROWS
  > time,in.1,in.2,in.3,in.4,in.5
  > 0,1,0.1,3,0.5,false
  > 0.1,2,0.1,-3,0.5,true
  > 0.2,3,0.1,-2.9,1,true
  > ROWS
  $ for engine in c interp; do frobc trace examples.frob --engine $engine --input input.csv --output $engine.csv; done
  $ cmp c.csv interp.csv
  $ test $(tail -n 1 c.csv | tr , '\n' | grep -c .) -ge 230
