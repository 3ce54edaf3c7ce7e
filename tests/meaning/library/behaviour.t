Layers that compete for the robot.

  $ . ./trace.sh

The higher layer wins; each of three layers, and none:

  $ cat > layers.frob << FROB
  > import Behaviour
  > main :: SF (Bool, Bool, Bool) (Maybe Int, Maybe Int, Bool)
  > main = proc (a, b, c) -> (layer1 \`over\` layer2 \`over\` layer3, arbitrate [layer1, layer2, layer3], wants layer2) where
  >     layer1 = onlyIf a 1
  >     layer2 = onlyIf b 2
  >     layer3 = onlyIf c 3
  > FROB
  $ printf '%s\n' true,true,true false,true,true false,false,true true,false,true false,false,false |
  >   rows in.1,in.2,in.3 | trace layers | cells
  Just 1,Just 1,true
  Just 2,Just 2,true
  Just 3,Just 3,false
  Just 1,Just 1,false
  Nothing,Nothing,false
  $ single layers

`settled 0.3[s]` lets a layer through once it has wanted the robot for 0.3 s. `sticky 0.3[s]` lets
it keep the robot for at least 0.3 s, with its last command. The numbers are the inputs of a layer
every 0.1 s, with a step of length 0 and a gap; 0 is `Nothing`:

  $ cat > dwell.frob << FROB
  > import Behaviour
  > main :: SF Int (Int, Int, Int, Int, Int, Int)
  > main = proc n -> (cell (settled 0.3[s] l), cell (sticky 0.3[s] l), cell (settled 0 l), cell (sticky 0 l), cell (settled nan l), cell (sticky nan l)) where
  >     l = onlyIf (n /= 0) n
  >     cell = fromMaybe 0
  >     nan = 0[s] / 0
  > FROB
  $ seconds () { printf '%s\n' "$@" | awk -v OFS=, 'BEGIN { print "time", "in" } { split($1, a, ":"); print a[1], a[2] }'; }
  $ seconds 0:1 0.1:0 0.2:0 0.3:0 0.4:0 0.5:2 0.6:3 0.6:4 0.7:5 0.8:6 0.9:7 1:0 1.1:0 9:8 9.1:0 20:0 |
  >   trace dwell | cells | tr '\n' ' ' | fold -w 84
  0,1,1,1,0,1 0,1,0,0,0,0 0,1,0,0,0,0 0,0,0,0,0,0 0,0,0,0,0,0 0,2,2,2,0,2 0,3,3,3,0,3 
  0,4,4,4,0,4 0,5,5,5,0,5 6,6,6,6,0,6 7,7,7,7,0,7 0,0,0,0,0,0 0,0,0,0,0,0 0,8,8,8,0,8 
  0,8,0,0,0,0 0,0,0,0,0,0 
  $ single dwell

A negative time counts as 0:

  $ cat > negative.frob << FROB
  > import Behaviour
  > main :: SF Int (Maybe Int, Maybe Int)
  > main = proc n -> (settled (after 1) layer, sticky (after 1) layer) where
  >     layer = onlyIf (n /= 0) n
  > after :: Float -> Time
  > after x = -x * 1[s]
  > FROB
  $ seconds 0:1 0.1:0 0.2:2 | trace negative | cells
  Just 1,Just 1
  Nothing,Nothing
  Just 2,Just 2

An attempt that fails immediately is repeated after 0.1 s, then after 0.2 s, then after 0.3 s, which
is the longest wait; the fourth is the last. 7 is the output while it waits:

  $ cat > backoff.frob << FROB
  > import Behaviour
  > attempts :: Int -> Time -> SF Bool (Either Int (Maybe Int))
  > attempts n wait = runTask (retryBackoff n wait 0.3[s] 7 attempt)
  > attempt :: Task Bool Int (Maybe Int)
  > attempt = untilRight (proc good -> if good then Right (Just 5) else Right Nothing)
  > main :: SF Bool (Either Int (Maybe Int), Either Int (Maybe Int), Either Int (Maybe Int), Either Int (Maybe Int))
  > main = proc b -> (attempts 4 0.1[s] b, attempts 0 0.1[s] b, attempts 3 (0[s] / 0) b, attempts 3 (-1[s]) b)
  > FROB
  $ tenths () { awk -v till="$1" 'BEGIN { print "time,in"; for (k = 0; k < 9; k++) print k / 10 "," (k >= till ? "true" : "false") }'; }
  $ tenths 99 | trace backoff | cells | uniq -c
        2 Left 7,Right Nothing,Left 7,Left 7
        4 Left 7,Right Nothing,Right Nothing,Right Nothing
        3 Right Nothing,Right Nothing,Right Nothing,Right Nothing
  $ tenths 3 | trace backoff | cells | uniq -c
        2 Left 7,Right Nothing,Left 7,Left 7
        1 Left 7,Right Nothing,Right Nothing,Right Nothing
        6 Right (Just 5),Right Nothing,Right Nothing,Right Nothing
  $ single backoff
