Text from others never controls a terminal: no escape or other control character reaches it
unchanged, from cells, column names, file names, or worlds. It is shown by its code.

  $ E=$(printf '\033')
  $ raw() { "$@" > out.txt 2>&1; LC_ALL=C grep -c "[$(printf '\001-\010\013-\037\177')]" out.txt > count.txt; test "$(cat count.txt)" = 0 || { echo "RAW: $*" | cat -v; cat -v out.txt; }; }
  $ cat > p.frob <<'F'
  > main :: SF Float Float
  > main = proc x -> x
  > F
  $ cat > drive.frob <<'F'
  > import Robot
  > main :: Program RobotInput RobotOutput
  > main = reactimateRobot (proc _ -> roMake (setVelTR 0.1[m/s] 0))
  > F
  $ printf 'time,in\n0,1\n' > in.csv
  $ printf 'time,in\n0,\033[31mred\n' > cell.csv
  $ printf 'time,in\033[2J\n0,1\n' > column.csv
  $ printf 'time\033[2J,in\n0,1\n' > first.csv
  $ printf '# param \033[2Jx=1\ntime,in\n0,1\n' > param.csv
  $ printf 'time,in\n\033]0;title\007,1\n' > time.csv
  $ printf 'time,in\n0,\302\2332J\n' > wide.csv
  $ cp in.csv "i${E}n.csv" && cp p.frob "p${E}.frob" && cp drive.frob "d${E}.frob"
  $ printf 'name = "A \\u001b[31mroom"\n[bad]\n"\\u001b[31mx" = 1\n' > "w${E}.toml"
  $ for file in cell column first param time wide "i${E}n" "missing${E}"; do
  >   raw frobc trace p.frob --input "$file.csv"
  >   raw frobc trace p.frob --engine interp --input "$file.csv"
  >   raw frobc convert "$file.csv" out.mcap
  >   raw timeout 60 frobc view --only-build "$file.csv" p.frob
  > done
  $ for command in check report compile 'format --check' fix 'fix --diff' 'trace --input in.csv' \
  >   'trace --input missing.csv' 'build --shared' run test falsify 'view --only-build in.csv'; do
  >   raw timeout 60 frobc $command "p${E}.frob"
  > done
  $ raw frobc run drive.frob --robot pioneer --world "w${E}.toml" --for 1s
  $ raw frobc run "d${E}.frob" --robot pioneer --for 1s --picture "p${E}.svg" --record "r${E}.csv"
  $ raw frobc run drive.frob --robot "${E}[31m"
  $ raw frobc run drive.frob --robot pioneer --device "tcp:${E}:1"
  $ raw timeout 60 frobc serve --world "w${E}.toml" --for 1s
  $ raw frobc sweep "no${E}.toml"
  $ raw frobc trace p.frob --param "${E}=1" --input in.csv
  $ raw frobc "comm${E}and"
  $ raw frobc run "--o${E}"
  $ raw frobc explain "${E}"
  $ raw frobc new "n${E}"
  $ frobc trace p.frob --input cell.csv 2>&1 > out.csv
  error: cell.csv:2:3: column `in`: expected a number, found `\027[31mred`
  [2]
  $ frobc trace p.frob --input wide.csv 2>&1 > out.csv
  error: wide.csv:2:3: column `in`: expected a number, found `\1552J`
  [2]
  $ frobc run "d${E}.frob" --robot pioneer --for 1s --record "r${E}.csv" | tail -1
  log: r\027.csv

A recording with one endless line, which is small when compressed, is rejected with bounded memory.

  $ cat > memory.py <<'P'
  > import resource, subprocess, sys
  > done = subprocess.run(sys.argv[1:], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, timeout=120)
  > said = [line for line in done.stdout.decode().splitlines() if line.startswith(("error", "FAIL"))]
  > peak = resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss // 1024
  > print(done.returncode, *said, "" if peak < 200 else f"with {peak} MB")
  > P
  $ head -c 100000000 /dev/zero | tr '\0' a | gzip -1 > endless.csv.gz
  $ (printf 'time,in\n0,1\n1,'; head -c 40000000 /dev/zero | tr '\0' ',') | gzip -1 > cells.csv.gz
  $ printf 'test "golden" = trace "in.csv" "endless.csv.gz"\n' | cat p.frob - > golden.frob && sed -i '1i import Trial' golden.frob
  $ for command in 'trace p.frob --input endless.csv.gz' 'trace p.frob --engine interp --input endless.csv.gz' \
  >   'convert endless.csv.gz out.mcap' 'convert endless.csv.gz out.csv' 'view endless.csv.gz p.frob' \
  >   'trace p.frob --input endless.csv.gz --picture out.svg -o out.csv' 'test golden.frob' \
  >   'trace p.frob --input cells.csv.gz' 'trace p.frob --engine interp --input cells.csv.gz' 'convert cells.csv.gz out.mcap'; do
  >   python3 memory.py timeout 60 frobc $command
  > done
  2 error: endless.csv.gz:1:1: the row is larger than 16 MB or has more than a million cells: this is not a recording 
  2 error: endless.csv.gz:1:1: the row is larger than 16 MB or has more than a million cells: this is not a recording 
  2 error: endless.csv.gz:1: the row is longer than 16 MB: this is not a recording 
  2 error: endless.csv.gz:1: the row is longer than 16 MB: this is not a recording 
  2 error: cannot view endless.csv.gz: it is not a recording: the first column must be `time` 
  2 
  1 FAIL  golden: cannot read endless.csv.gz: it is larger than 16 MB 
  2 error: cells.csv.gz:3:1: the row is larger than 16 MB or has more than a million cells: this is not a recording 
  2 error: cells.csv.gz:3:1: the row is larger than 16 MB or has more than a million cells: this is not a recording 
  2 error: cells.csv.gz:3: the row is longer than 16 MB: this is not a recording 
  $ mkdir rows && head -c 60000000 /dev/zero | tr '\0' a > rows/x.rows
  $ printf 'program = "trial.frob"\nseeds = [1, 1]\n' > plan.toml
  $ printf 'trial "stays" = Trial { world = "room.toml", lasts = 1[s], seeds = 1 `to` 1, judge = neverTouches }\n' | cat drive.frob - > trial.frob && sed -i '1i import Trial' trial.frob
  $ python3 memory.py timeout 60 frobc sweep plan.toml --rows rows
  0 
