This version reads the programs, worlds, plans and recordings of earlier ones. Each folder has files
that the version of its name wrote or read. A change of a file format adds a folder for the last
version without the change.

  $ cd 0.1

A replay of a recording computes the same outputs, bit for bit:

  $ cat > compare.py <<'PYTHON'
  > import sys
  > def rows(path):
  >     lines = [line.rstrip("\n") for line in open(path) if not line.startswith("#")]
  >     header, *rows = (line.split(",") for line in lines)
  >     return header, [dict(zip(header, row)) for row in rows]
  > (_, recorded), (columns, computed) = rows(sys.argv[1]), rows(sys.argv[2])
  > number = lambda cell: float(cell) if cell[:1] in set("-0123456789") else cell
  > equal = [number(a[c]) == number(b[c]) for a, b in zip(recorded, computed) for c in columns]
  > print(len(recorded), len(computed), len(columns), all(equal))
  > PYTHON
  $ for robot in pioneer scout create; do
  >   frobc trace drive.frob --robot $robot --input $robot.csv > replayed.csv && python3 compare.py $robot.csv replayed.csv
  > done
  12 12 3 True
  12 12 3 True
  12 12 10 True

The world and the plan:

  $ frobc run drive.frob --robot pioneer --world room.toml --for 1s --record new.csv | grep -c log
  1
  $ frobc sweep speeds.toml 2> progress | head -1
  4 runs: 4 held, 0 failed

A recording whose columns do not fit the program, or a world or plan with a key
that this version does not know, is rejected. The message names the column or
key:

  $ sed 's/in.leftStall/in.leftBlocked/' pioneer.csv > other.csv
  $ frobc trace drive.frob --robot pioneer --input other.csv 2>&1 | cut -c 1-100
  error: other.csv:2:326: the program's input has no `in.leftBlocked`
  error: other.csv:2:1: missing: `in.leftStall`; the header for this program is `time,in.odometry.posi
  $ { echo 'units = "cm"'; cat room.toml; } > other.toml
  $ frobc run drive.frob --robot pioneer --world other.toml --for 1s
  error: other.toml:1:1: unknown key `units`
  [2]
  $ { echo 'repeats = 3'; cat speeds.toml; } > faster.toml
  $ frobc sweep faster.toml
  error: faster.toml:1:1: unknown key `repeats`
  [2]
