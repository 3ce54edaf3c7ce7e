A recording converted to MCAP. The reader in this test checks all lengths, checksums, indexes and
offsets, and prints the first message of each topic.

  $ cat > run.csv <<END
  > # param gain=2[1/s]
  > time,in.odometry.position.x,in.odometry.position.y,in.odometry.heading,in.sonar[0],in.sonar[1],in.key,in.rearBumper,out.1,out.mode,probe.main.assert stays. below 2
  > 0,0,0,0,,,,false,nan,Turn,Open
  > 0.02,1.5,-0.25,3.1415926535897931,2.5,,119,true,+.5,"Wait (At 3)",Holds
  > 1234567890.1e-3,1e-3,inf,0,,,,false,-0,"say ""hi"", twice",Holds
  > END
  $ frobc convert run.csv run.mcap
  $ python3 structure.py run.mcap
  metadata params {'gain': '2[1/s]'}
  14 messages in 1 chunk
  /in frob.in 3
      {"odometry": {"position": {"x": 0, "y": 0}, "heading": 0}, "sonar": {}, "rearBumper": false}
  /out frob.out 3
      {"mode": "Turn"}
  /probe frob.probe 3
      {"main": {"assert stays. below 2": "Open"}}
  /tf foxglove.FrameTransform 2
      {"timestamp": {"sec": 0, "nsec": 0}, "parent_frame_id": "odometry", "child_frame_id": "robot", "translation": {"x": 0, "y": 0, "z": 0}, "rotation": {"x": 0, "y": 0, "z": 0, "w": 1}}
  /pose/in.odometry foxglove.PoseInFrame 2
      {"timestamp": {"sec": 0, "nsec": 0}, "frame_id": "odometry", "pose": {"position": {"x": 0, "y": 0, "z": 0}, "orientation": {"x": 0, "y": 0, "z": 0, "w": 1}}}
  /ranges foxglove.SceneUpdate 1
      {"deletions": [], "entities": [{"timestamp": {"sec": 0, "nsec": 20000000}, "frame_id": "robot", "id": "in.sonar[0]", "lifetime": {"sec": 0, "nsec": 700000000}, "frame_locked": true, "metadata": [], "lines": [{"type": 1, "pose": {"position": {"x": 0.069, "y": 0.136, "z": 0}, "orientation": {"x": 0, "y": 0, "z": 0.7071067811865475, "w": 0.7071067811865476}}, "thickness": 0.01, "scale_invariant": fal…

Numbers that JSON writes differently are converted, and values that are not numbers are omitted:

  $ grep -ao '{"[^{]*"mode":"[^}]*}' run.mcap
  {"1":0.5,"mode":"Wait (At 3)"}
  {"1":-0,"mode":"say \"hi\", twice"}

The same recording always results in the same bytes, and converting it back restores it; the same
for a compressed one, or with another compression:

  $ frobc convert run.csv again.mcap && cmp run.mcap again.mcap
  $ frobc convert run.mcap back.csv && cmp run.csv back.csv
  $ frobc convert run.csv run.csv.gz && gzip -dc run.csv.gz | cmp - run.csv
  $ frobc convert run.csv.gz packed.mcap
  $ frobc convert packed.mcap back.csv && cmp run.csv back.csv
  $ frobc convert packed.mcap back.csv.gz && cmp run.csv.gz back.csv.gz
  $ frobc convert packed.mcap back.csv.zst && zstd -dqc back.csv.zst | cmp - run.csv
  $ frobc convert back.csv.zst back.csv && cmp run.csv back.csv

A run of the simulator, with a camera: its frames become images, and converting back restores them.
The restored recording can be replayed.

  $ see=../../../examples/follow_ball/follow_ball.frob
  $ frobc run $see --for 1s --record ball.csv > summary
  $ frobc convert ball.csv ball.mcap
  $ python3 structure.py ball.mcap | cut -c1-230
  metadata params {'keptAway': '1[m]'}
  274 messages in 8 chunks
  /in frob.in 51
      {"odometry": {"position": {"x": 0, "y": 0}, "heading": 0}, "leftWheel": 0, "rightWheel": 0, "sonar": {}, "frontBumper": false, "rearBumper": false, "leftStall": false, "rightStall": false, "battery": 12.8, "motorsOn": true, "c
  /out frob.out 51
      {"forward": 0, "turn": 0.8}
  /tf foxglove.FrameTransform 51
      {"timestamp": {"sec": 0, "nsec": 0}, "parent_frame_id": "odometry", "child_frame_id": "robot", "translation": {"x": 0, "y": 0, "z": 0}, "rotation": {"x": 0, "y": 0, "z": 0, "w": 1}}
  /pose/in.odometry foxglove.PoseInFrame 51
      {"timestamp": {"sec": 0, "nsec": 0}, "frame_id": "odometry", "pose": {"position": {"x": 0, "y": 0, "z": 0}, "orientation": {"x": 0, "y": 0, "z": 0, "w": 1}}}
  /ranges foxglove.SceneUpdate 41
      {"deletions": [], "entities": [{"timestamp": {"sec": 0, "nsec": 20000000}, "frame_id": "robot", "id": "in.sonar[0]", "lifetime": {"sec": 0, "nsec": 700000000}, "frame_locked": true, "metadata": [], "lines": [{"type": 1, "pose"
  /image/in.console.camera foxglove.RawImage 29
      {"timestamp": {"sec": 0, "nsec": 0}, "frame_id": "/image/in.console.camera", "width": 320, "height": 240, "encoding": "rgb8", "step": 960, "file": "000000-1e19cbcf6c.ppm", "head": "P6\n# frob frame 0 captured_ns 0\n# camera 27
  $ mkdir back
  $ frobc convert ball.mcap back/ball.csv
  $ cmp ball.csv back/ball.csv && diff -r ball.frames back/ball.frames && echo as they were
  as they were
  $ frobc trace $see --input ball.csv --output traced.csv
  $ frobc trace $see --input back/ball.csv | cmp - traced.csv
  $ rm -r ball.frames/00000[1-4]*
  $ frobc convert ball.csv fewer.mcap
  warning: 4 frames named in ball.csv are missing from ball.frames or are not valid; they were omitted

Echoes of a Scout, whose sonars have other positions:

  $ frobc run ../../../examples/wall_follow/wall_follow.frob --robot scout --for 1s --record scout.csv > summary
  $ frobc convert scout.csv scout.mcap
  $ python3 structure.py scout.mcap | grep -A 1 ranges | cut -c1-400
  /ranges foxglove.SceneUpdate 23
      {"deletions": [], "entities": [{"timestamp": {"sec": 0, "nsec": 20000000}, "frame_id": "robot", "id": "in.sonar[0]", "lifetime": {"sec": 0, "nsec": 700000000}, "frame_locked": true, "metadata": [], "lines": [{"type": 1, "pose": {"position": {"x": 0.2, "y": 0, "z": 0}, "orientation": {"x": 0, "y": 0, "z": 0, "w": 1}}, "thickness": 0.01, "scale_invariant": false, "points": [{"x": 0, "y": 0, "z":

If the end is missing, the complete part is converted:

  $ { cat run.csv; printf '2,1,1'; } > torn.csv
  $ frobc convert torn.csv torn.mcap
  warning: torn.csv: its last line, line 6, is incomplete and was omitted; everything before that was converted
  $ python3 structure.py torn.mcap | grep messages
  14 messages in 1 chunk
  $ frobc convert torn.mcap back.csv && cmp torn.csv back.csv
  $ frobc convert torn.csv whole.csv
  warning: torn.csv: its last line, line 6, is incomplete and was omitted; everything before that was converted
  $ cmp run.csv whole.csv
  $ head -c -12 run.csv.gz > cut.csv.gz
  $ frobc convert cut.csv.gz whole.csv
  warning: cut.csv.gz: the archive is truncated or damaged; everything before that was converted
  $ head -n 4 run.csv | cmp - whole.csv
  $ frobc convert cut.csv.gz cut.mcap
  warning: cut.csv.gz: the archive is truncated or damaged; everything before that was converted
  $ frobc convert cut.mcap back.csv
  warning: the recording in cut.mcap: the archive is truncated or damaged

Not a recording:

  $ bad () { printf "$1" > bad.csv; frobc convert bad.csv bad.mcap; }
  $ bad ''
  error: bad.csv: not a recording: the first line must name the columns, starting with `time`
  [2]
  $ bad 'a,b\n1,2\n'
  error: bad.csv:1: not a recording: the first column must be `time`, not `a`; to choose the column with the times, add `--time-column NAME`
  [2]
  $ bad 'time,in\n0,1\n0.1\n0.2,1\n'
  error: bad.csv:3: wrong number of cells: the header has 2 columns, but this row has 1
  [2]
  $ bad 'time,in\n0,1\nsoon,1\n'
  error: bad.csv:3: `soon` is not a time in seconds
  [2]
  $ bad 'time,in\n0.2,1\n0.1,1\n'
  error: bad.csv:3: the time goes backwards: `0.1` comes after a later time
  [2]
  $ bad 'time,in\n-1,1\n'
  error: bad.csv:2: the time -1 is before 0, which MCAP cannot represent
  [2]
  $ bad 'time,in\n0,"never closed\n'
  warning: bad.csv: its last line, line 2, is incomplete and was omitted; everything before that was converted
  $ ls bad.mcap
  bad.mcap
  $ cp run.mcap fake.csv; frobc convert fake.csv bad.mcap
  error: cannot read fake.csv: it is an MCAP file; convert it to a recording with `frobc convert`
  [2]
  $ frobc convert gone.csv run.mcap
  error: there is no file gone.csv
  [2]
  $ frobc convert . run.mcap
  error: . is a folder
  [2]

Only `frobc convert` writes and reads MCAP:

  $ cat > main.frob <<END
  > main :: SF Float Float
  > main = proc x -> x
  > END
  $ frobc trace main.frob --input run.mcap
  error: cannot read run.mcap: it is an MCAP file; convert it to a recording with `frobc convert`
  [2]
  $ frobc trace main.frob --engine interp --input run.mcap
  error: cannot read run.mcap: it is an MCAP file; convert it to a recording with `frobc convert`
  [2]
  $ frobc view --print run.mcap main.frob
  error: cannot view run.mcap: it is an MCAP file; convert it to a recording with `frobc convert`
  [2]
  $ frobc trace main.frob --input run.csv --output out.mcap
  error: --output writes CSV, so out.mcap would not be an MCAP file: use a file name that ends in .csv; then `frobc convert RUN.csv out.mcap` converts it to MCAP
  [2]
  $ frobc run $see --for 1s --record out.mcap
  error: --record writes CSV, so out.mcap would not be an MCAP file: use a file name that ends in .csv; then `frobc convert RUN.csv out.mcap` converts it to MCAP
  [2]
  $ frobc check run.mcap
  error: run.mcap is not a Frob program but an MCAP recording; convert it: `frobc convert run.mcap RUN.csv`
  [2]

Names that do not determine a conversion, or that require none:

  $ frobc convert run.csv run.bag
  error: the name of run.bag must end in .csv, .csv.gz or .csv.zst for a recording, or in .mcap for MCAP
  [2]
  $ frobc convert run.txt run.mcap
  error: there is no file run.txt
  [2]
  $ cp run.csv run.txt; frobc convert run.txt run.mcap
  error: the name of run.txt must end in .csv, .csv.gz or .csv.zst for a recording, or in .mcap for MCAP
  [2]
  $ frobc convert run.mcap other.mcap
  error: run.mcap is already an MCAP file
  [2]
  $ frobc convert run.csv run.mcap.gz
  error: the name of run.mcap.gz must end in .csv, .csv.gz or .csv.zst for a recording, or in .mcap for MCAP
  [2]
  $ frobc convert run.csv
  frobc: required argument TO is missing
  Usage: frobc convert [OPTION]… FROM TO
  Try 'frobc convert --help' or 'frobc --help' for more information.
  [2]

Existing files are not lost:

  $ frobc convert run.csv run.csv
  error: convert would overwrite run.csv, which is an input: use another file name
  [2]
  $ ln -s run.csv link.csv; frobc convert run.csv link.csv
  error: convert would overwrite run.csv, which is an input: use another file name
  [2]
  $ printf '\211MCAP0\r\n of somebody else' > theirs.mcap
  $ frobc convert run.csv theirs.mcap
  error: convert would overwrite theirs.mcap, which is an existing file, but not an MCAP file written by frobc: move it away, or use another file name
  [2]
  $ echo notes > notes.csv; frobc convert run.mcap notes.csv
  error: convert would overwrite notes.csv, which is an existing file, but not a trace or a recording: move it away, or use another file name
  [2]
  $ cp run.mcap kept.mcap; frobc convert ball.csv kept.mcap 2> /dev/null; frobc convert run.csv kept.mcap && cmp kept.mcap run.mcap
  $ ln -s /dev/full full.mcap; frobc convert run.csv full.mcap
  error: cannot write full.mcap: No space left on device
  [2]
  $ ln -s /dev/full full.csv; frobc convert run.mcap full.csv
  error: cannot write full.csv: No space left on device
  [2]
  $ (ulimit -f 1; frobc convert ball.csv kept.mcap); cmp kept.mcap run.mcap; ls .frobc* 2> /dev/null
  error: cannot write kept.mcap: File too large
  [2]

MCAP files that are from other programs, truncated, or damaged:

  $ frobc convert theirs.mcap back.csv
  error: cannot read theirs.mcap: it is truncated or damaged
  [2]
  $ python3 - <<END
  > data = open("run.mcap", "rb").read()
  > open("other.mcap", "wb").write(data.replace(b"frobc", b"rosss", 1))
  > open("cut.mcap", "wb").write(data[:600])
  > open("start.mcap", "wb").write(data[:20])
  > at = data.index(b"1.5,-0.25")
  > open("flipped.mcap", "wb").write(data[:at] + b"2" + data[at + 1:])
  > END
  $ for file in other cut start flipped; do frobc convert $file.mcap new.csv; done
  error: cannot read other.mcap: it was written by another program, and reading it needs Python packages: run `frobc extras install mcap`
  error: cannot read cut.mcap: it is truncated or damaged
  error: cannot read start.mcap: it is truncated or damaged
  error: cannot read flipped.mcap: it is damaged: a checksum does not match its content
  [2]
  $ ls new.csv
  ls: cannot access 'new.csv': No such file or directory
  [2]

Whichever byte is changed, the result is an error, or the original recording:

  $ python3 - > seen <<END
  > import subprocess
  > data = open("run.mcap", "rb").read()
  > for at in range(0, len(data), 97):
  >     with open("byte.mcap", "wb") as file:
  >         file.write(data[:at] + bytes([data[at] ^ 255]) + data[at + 1:])
  >     done = subprocess.run(["frobc", "convert", "byte.mcap", "byte.csv"], capture_output=True, text=True)
  >     if done.returncode == 0:
  >         assert open("byte.csv", "rb").read() == open("run.csv", "rb").read(), at
  >     elif done.returncode != 2 or not done.stderr.startswith("error: cannot read byte.mcap: "):
  >         print(at, done)
  > END
  $ cat seen
