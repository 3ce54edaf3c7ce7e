An image exists for one instant. A program that would keep it longer is rejected, and the message
says what to store instead.

  $ cat > keeps.frob <<'FROB'
  > import Vision
  > 
  > main :: SF (Event Frame) Float[px]
  > main = proc frame -> case hold Nothing (mapE Just frame) of
  >     Just f  -> (lens f.image).width
  >     Nothing -> 0
  > FROB
  $ frobc check keeps.frob
  error[E0430]: an image cannot be kept from one instant to the next
   --> keeps.frob:4:27
    |
  4 | main = proc frame -> case hold Nothing (mapE Just frame) of
    |                           ^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^
    |
    = note: the camera reuses the memory of an image for later frames
    = hint: when the frame arrives, compute the numbers that you need, and `hold` them
  
  1 error
  [1]

Results computed from it may be stored.

  $ cat > finds.frob <<'FROB'
  > import Vision
  > 
  > main :: SF (Event Frame) Float[px]
  > main = hold 0 <<< arr (mapE (\f -> (lens f.image).width))
  > FROB
  $ frobc check finds.frob

The report counts the kernel calls of a step, and states what the host must provide.

  $ cat > sees.frob <<'FROB'
  > import Robot
  > import Vision
  > 
  > main = reactimateRobot sees
  > 
  > sees :: (HasCamera i, DiffDrive o) => SF i o
  > sees = proc i -> roMake (setVelTR v 0) where
  >     v = hold 0 (mapE wide (camera i))
  >     wide f = 0.1[m/s] * ((findBlob f.image (everywhere f.image) all).cx / 1[px])
  >     all = ColourRange
  >         { hueFrom = 0, hueTo = 360[deg], saturationFrom = 0, saturationTo = 1
  >         , valueFrom = 0, valueTo = 1 }
  > FROB
  $ frobc report sees.frob --robot pioneer | grep -E 'calls|camera'
    calls of frob_find_blob   1  at most the whole image
    calls of frob_image_lens  1
    camera  camera    sees.frob:8

A robot's C struct does not contain a camera, and a program without a camera has nothing for one.

  $ frobc header pioneer | grep -ci -E 'camera|image|frame'
  0
  [1]
  $ frobc compile sees.frob --robot pioneer && grep -A3 'struct sees_input {' sees.h
  struct sees_input {
      struct frob_pioneer_input robot;
      struct sees_console console;
  };

The names of kernels are reserved for the library: a user's program calls them through it.

  $ cat > own.frob <<'FROB'
  > foreign mine :: Float -> Float = "frob_image_lens"
  > 
  > main :: SF Float Float
  > main = arr mine
  > FROB
  $ frobc check own.frob 2>&1 | head -1
  error[E0232]: `frob_image_lens` cannot be the C name of your function: it is used by the generated C code and its runtime

A world without a camera, and hosts that do not support any.

  $ cat > dark.toml <<'TOML'
  > [start]
  > x = 0
  > y = 0
  > TOML
  $ frobc run sees.frob --world dark.toml --for 1s
  error: the program uses a camera, `camera`, but the robot in this world has no camera: add a table [camera] to the world file
  [2]
  $ cat > named.toml <<'TOML'
  > [start]
  > x = 0
  > y = 0
  > [stereo]
  > [[camera]]
  > name = "front"
  > [[camera]]
  > name = "rear"
  > TOML
  $ frobc run sees.frob --world named.toml --for 1s
  error: the program uses a camera, `camera`, but the robot in this world has no camera with this name; it has `front`, `rear`: add `name = "camera"` to one of them in the world file, or write [[camera]] for each and add another one
  [2]
  $ cat > deep.frob <<'FROB'
  > import Robot
  > import Stereo
  > import Vision
  > 
  > main :: (HasStereo i, DiffDrive o) => Program i o
  > main = reactimateRobot (proc i -> roMake (setVelTR (speed i) 0)) where
  >     speed = proc i -> 0.1[1/s] * hold 0 (mapE (fromMaybe 0) (nearestSeen middle i))
  >     middle = Region { x = 100[px], y = 60[px], width = 120[px], height = 60[px] }
  > FROB
  $ frobc run deep.frob --world dark.toml --robot pioneer --for 1s
  error: the program uses a camera, `left`, but the robot in this world has no camera: add a table [stereo] to the world file
  error: the program uses a camera, `right`, but the robot in this world has no camera: add a table [stereo] to the world file
  [2]
  $ frobc check deep.frob --robot create
  error[E0503]: `create` has no `HasStereo`
   --> deep.frob:7:62
    |
  7 |     speed = proc i -> 0.1[1/s] * hold 0 (mapE (fromMaybe 0) (nearestSeen middle i))
    |                                                              ^^^^^^^^^^^ `nearestSeen` needs it
    |
    = note: only `pioneer` has this capability
    = note: `main` is compiled for `create`, but there is no instance `HasStereo CreateInput`
    = hint: compile it with `--robot pioneer`
  
  1 error
  [1]
  $ frobc build sees.frob --robot pioneer --target cortex-m -o sees
  error: sees uses the camera `camera`, but cameras are available only in the simulator and on Linux robots, not on boards
  [2]
  $ frobc run sees.frob --view --for 1s
  error: this program uses a camera, and the viewer reads its frames from a recording: add `--record LOG.csv` to `--view`
  [2]
