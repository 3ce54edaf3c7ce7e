A camera of eight by eight pixels looks at a wall. Its frames come 30 times a second and are 40 ms
old when they arrive; the program sees each of them at one instant.

  $ cat > world.toml <<'TOML'
  > robot = "pioneer"
  > [start]
  > x = 0
  > y = 0
  > [camera]
  > width = 8
  > height = 8
  > latency = 0.04
  > noise = 3
  > [[wall]]
  > points = [[2, -3], [2, 3]]
  > colour = "red"
  > TOML
  $ cat > looks.frob <<'FROB'
  > import Robot
  > import Vision
  > 
  > red :: ColourRange
  > red = ColourRange
  >     { hueFrom = 330[deg], hueTo = 30[deg], saturationFrom = 0.5, saturationTo = 1
  >     , valueFrom = 0.1, valueTo = 1 }
  > 
  > pixelsOf :: Frame -> Int
  > pixelsOf f = (findBlob f.image (everywhere f.image) red).pixels
  > 
  > looks :: (HasCamera i, DiffDrive o) => SF i o
  > looks = proc i -> roMake (setVelTR v omega) where
  >     v     = 0.01[m/s] * toFloat (hold 0 (mapE pixelsOf (camera i)))
  >     omega = frameAge (camera i) * 1[rad/s^2]
  > 
  > main = reactimateRobot looks
  > FROB
  $ frobc run looks.frob --record log.csv --for 0.2s > /dev/null
  $ head -1 log.csv | tr , '\n' | grep -n camera
  30:in.console.camera

A recording names a frame by its number, its size in bytes, and a hash of its contents. The frames
are stored next to it, as PPM files.

  $ sed 's/^\([0-9.]*\),.*"\(Frame.*\)",.*/\1 \2/; s/^\([0-9.]*\),.*/\1/; 1d' log.csv | sed 's/0x[0-9a-f]*/HASH/'
  0.000000000
  0.020000000
  0.040000000 Frame {image = Image 0 337 HASH, age = 0.040000000000000001, number = 0}
  0.060000000
  0.080000000 Frame {image = Image 1 344 HASH, age = 0.044999999999999998, number = 1}
  0.100000000
  0.120000000 Frame {image = Image 2 344 HASH, age = 0.050000000000000003, number = 2}
  0.140000000 Frame {image = Image 3 345 HASH, age = 0.040000000000000001, number = 3}
  0.160000000
  0.180000000 Frame {image = Image 4 345 HASH, age = 0.044999999999999998, number = 4}
  0.200000000
  $ ls log.frames | sed 's/-.*[.]/-HASH./'
  000000-HASH.ppm
  000001-HASH.ppm
  000002-HASH.ppm
  000003-HASH.ppm
  000004-HASH.ppm
  $ head -6 log.frames/000001-*.ppm | tr -d '\000' | grep -a '^[P#0-9]' | head -6
  P6
  # frob frame 1 captured_ns 35000000
  # camera 6.9282032302755105 6.9282032302755105 3.5 3.5 0 0 0 0 0
  # seat 0.12 0 0.27000000000000002 0 0 0
  8 8
  255

Each engine reproduces the run from it: compiled, in single precision, and the interpreter, which
calls the same kernels.

  $ frobc trace looks.frob --robot pioneer --input log.csv > c.csv
  $ sed 's/"[^"]*"//' log.csv | cut -d, -f1,31,32 | cmp - c.csv
  $ frobc trace looks.frob --robot pioneer --input log.csv --engine interp | cmp - c.csv
  $ frobc trace looks.frob --robot pioneer --input log.csv --real float > float.csv
  $ frobc trace looks.frob --robot pioneer --input log.csv --real float --engine interp | cmp - float.csv
  $ sed -n 4,5p c.csv
  0.040000000,0.40000000000000002,0.040000000000000001
  0.060000000,0.40000000000000002,0.059999999999999998

A second recording with the same name replaces the first one and its frames.

  $ frobc run looks.frob --record log.csv --for 0.05s > /dev/null; ls log.frames | wc -l
  1

A frame that is missing, changed, or truncated, or that is another file.

  $ frame=$(ls log.frames/*); cp $frame kept.ppm
  $ both() { for engine in c interp; do frobc trace looks.frob --robot pioneer --input log.csv --engine $engine > /dev/null; done 2>&1 | sed 's/ found .*//; s/-[0-9a-f]\{10\}[.]/-HASH./'; }
  $ rm $frame; both
  error: log.csv:4:151: column `in.console.camera`: expected an existing frame (log.frames/000000-HASH.ppm: No such file or directory),
  error: log.csv:4:151: column `in.console.camera`: expected an existing frame (log.frames/000000-HASH.ppm: No such file or directory),
  $ { head -c -1 kept.ppm; printf x; } > $frame; both
  error: log.csv:4:151: column `in.console.camera`: expected the recorded frame (its file was changed),
  error: log.csv:4:151: column `in.console.camera`: expected the recorded frame (its file was changed),
  $ head -c 200 kept.ppm > $frame; both
  error: log.csv:4:151: column `in.console.camera`: expected an existing frame (log.frames/000000-HASH.ppm: its size does not match its header),
  error: log.csv:4:151: column `in.console.camera`: expected an existing frame (log.frames/000000-HASH.ppm: its size does not match its header),
  $ echo hello > $frame; both
  error: log.csv:4:151: column `in.console.camera`: expected an existing frame (log.frames/000000-HASH.ppm: it is not a frame written by frobc),
  error: log.csv:4:151: column `in.console.camera`: expected an existing frame (log.frames/000000-HASH.ppm: it is not a frame written by frobc),

A cell that does not name a frame.

  $ sed 's/Image 0 337 0x[0-9a-f]*/Image zero/' log.csv > odd.csv
  $ for engine in c interp; do frobc trace looks.frob --robot pioneer --input odd.csv --engine $engine > out; done 2>&1 | sed 's/ found .*//'
  error: odd.csv:4:151: column `in.console.camera`: expected an image, as `Image NUMBER SIZE HASH`,
  error: odd.csv:4:151: column `in.console.camera`: expected an image, as `Image NUMBER SIZE HASH`,
