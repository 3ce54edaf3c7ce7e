Recordings of other programs: the message says which option reads them, and both engines support it.

  $ cat > speed.frob << FROB
  > data In = In { speed :: Velocity, ok :: Bool }
  > main :: SF In (Distance, Time)
  > main = proc i -> (integral (if i.ok then i.speed else 0), time ())
  > FROB
  $ trace() {
  >   frobc trace speed.frob --input "$@" > c.out 2> c.err
  >   frobc trace speed.frob --input "$@" --engine interp > interp.out 2> interp.err
  >   cmp c.err interp.err
  >   if [ -s c.err ]; then cat c.err; else cmp c.out interp.out; cat c.out; fi
  > }

Semicolons, decimal commas, other names, a column that the program does not have; times since 1970,
whose differences count, to the nanosecond:

  $ cat > log.csv << CSV
  > Time;wheel_speed;flag;note
  > 1700000000,10;0,5;true;start
  > 1700000000,123456789;Inf;true;
  > 1700000000,123456790;NaN;false;
  > 1700000001,5;-Infinity;true;
  > CSV
  $ trace log.csv
  error: log.csv:1:1: the first column must be `time`, but it is `Time;wheel_speed;flag;note`; its columns are separated by semicolons: add `--separator ';'`
  $ trace log.csv --separator ';'
  error: log.csv:1:1: the first column must be `time`, but it is `Time`; to choose the column with the times, add `--time-column Time`
  error: log.csv:1:6: the program's input has no `wheel_speed`
  error: log.csv:1:18: the program's input has no `flag`
  error: log.csv:1:23: the program's input has no `note`
  error: log.csv:1:1: missing: `in.speed`, `in.ok`; the header for this program is `time,in.speed,in.ok`; to read it from another column, add `--column in.speed=NAME`
  $ trace log.csv --separator ';' --time-column Time --column in.ok=flag
  error: log.csv:1:1: missing: `in.speed`; the header for this program is `time,in.speed,in.ok`; to read it from another column, add `--column in.speed=NAME`
  $ trace log.csv --separator ';' --time-column Time --column in.ok=flag --column in.speed=wheel_speed
  error: log.csv:2:1: `1700000000,10` is not a time in seconds; for numbers with a decimal comma, add `--decimal-comma`
  $ trace log.csv --separator ';' --time-column Time --column in.ok=flag --column in.speed=wheel_speed --decimal-comma
  time,out.1,out.2
  1700000000.100000000,0,0
  1700000000.123456789,0.011728394499999999,0.023456788999999999
  1700000000.123456790,inf,0.023456790000000002
  1700000001.500000000,inf,1.3999999999999999
  $ trace log.csv --separator ';' --time-column Zeit
  error: log.csv:1:1: there is no column `Zeit` for `--time-column`; the columns are `Time`, `wheel_speed`, `flag`, `note`
  $ trace log.csv --separator ';' --column in.speed=whel
  error: log.csv:1:1: there is no column `whel` for `--column`; the columns are `Time`, `wheel_speed`, `flag`, `note`

A quote in a name is quoted as well:

  $ printf "it's time,in.speed,in.ok\n0,1,true\n" > quotes.csv
  $ trace quotes.csv
  error: quotes.csv:1:1: the first column must be `time`, but it is `it's time`; to choose the column with the times, add `--time-column 'it'\''s time'`
  $ printf "time,in.speed,it's ok\n0,1,true\n" > quotes.csv
  $ trace quotes.csv
  error: quotes.csv:1:15: the program's input has no `it's ok`
  error: quotes.csv:1:1: missing: `in.ok`; the header for this program is `time,in.speed,in.ok`; to read it from another column, add `--column 'in.ok=it'\''s ok'`

Tabs; a column whose name a shell would split:

  $ printf 'in.speed\tstamp [s]\tis ok\n1\t1.7e9\ttrue\n1\t1.7000000000000000014e9\ttrue\n' > tabs.csv
  $ trace tabs.csv
  error: tabs.csv:1:1: the first column must be `time`, but it is `in.speed\009stamp [s]\009is ok`; its columns are separated by tabs: add `--separator tab`
  $ trace tabs.csv --separator tab
  error: tabs.csv:1:1: the first column must be `time`, but it is `in.speed`; to choose the column with the times, add `--time-column 'stamp [s]'`
  error: tabs.csv:1:10: the program's input has no `stamp [s]`
  error: tabs.csv:1:20: the program's input has no `is ok`
  error: tabs.csv:1:1: missing: `in.speed`, `in.ok`; the header for this program is `time,in.speed,in.ok`; to read it from another column, add `--column in.speed=NAME`
  $ trace tabs.csv --separator tab --time-column 'stamp [s]'
  error: tabs.csv:1:1: missing: `in.ok`; the header for this program is `time,in.speed,in.ok`; to read it from another column, add `--column 'in.ok=is ok'`
  $ trace tabs.csv --separator tab --time-column 'stamp [s]' --column 'in.ok=is ok'
  time,out.1,out.2
  1700000000.000000000,0,0
  1700000000.000000001,1.0000000000000001e-09,1.0000000000000001e-09

An instant may be as late as 4 · 10^9 s, and 8 · 10^9 s after the previous one:

  $ printf 'time,in.speed,in.ok\n%s,1,true\n%s,1,true\n' -4e9 4e9 > far.csv
  $ trace far.csv
  time,out.1,out.2
  -4000000000.000000000,0,0
  4000000000.000000000,1000000000,1000000000
  $ printf 'time,in.speed,in.ok\n%s,1,true\n' 4000000000.000000001 > far.csv
  $ trace far.csv
  error: far.csv:2:1: `4000000000.000000001` is not a time in seconds

Every spelling of NaN and infinity, with and without a sign:

  $ printf 'time,in\n0,nan\n1,NaN\n2,-NAN\n3,Inf\n4,-inf\n5,+INF\n6,Infinity\n7,-infinity\n' > names.csv
  $ echo 'main :: SF Float Float
  > main = proc x -> x' > same.frob
  $ frobc trace same.frob --input names.csv > c.out
  $ frobc trace same.frob --input names.csv --engine interp | cmp - c.out
  $ cut -d, -f2 c.out | xargs
  out nan nan nan inf -inf inf inf -inf
  $ printf 'time,in\n0,Info\n' | frobc trace same.frob --input -
  error: standard input:2:3: column `in`: expected a number, found `Info`
  time,out
  [2]

`convert` and `view` accept the same options; `view` shows late times relative to the first one:

  $ frobc convert log.csv again.csv --separator ';'
  error: log.csv:1: not a recording: the first column must be `time`, not `Time`; to choose the column with the times, add `--time-column Time`
  [2]
  $ frobc convert log.csv again.csv --separator ';' --time-column Time --column in.ok=flag --column in.speed=wheel_speed --decimal-comma
  $ cat again.csv
  time,in.speed,in.ok
  1700000000.10,0.5,true
  1700000000.123456789,Inf,true
  1700000000.123456790,NaN,false
  1700000001.5,-Infinity,true
  $ frobc trace speed.frob --input again.csv | head -3
  time,out.1,out.2
  1700000000.100000000,0,0
  1700000000.123456789,0.011728394499999999,0.023456788999999999
  $ frobc view log.csv speed.frob --print
  error: cannot view log.csv: it is not a recording: the first column must be `time`; its columns are separated by semicolons: add `--separator ';'`
  [2]
  $ (frobc view log.csv speed.frob --print --separator ';' --time-column Time --column in.ok=flag --column in.speed=wheel_speed --decimal-comma 2> told & echo $! > id; wait) > page &
  $ for i in $(seq 400); do grep -qs 'times are shown' told && break; sleep 0.05; done; kill $(cat id); cat told
  log.csv:2: times are shown relative to the first instant, which is at 1700000000.10 s

Numbers that would be rounded to infinity are rejected, and those near 0 become 0. In single
precision the limit is lower:

  $ both() {
  >   frobc trace same.frob --input "$@" > c.out 2> c.err
  >   frobc trace same.frob --input "$@" --engine interp > interp.out 2> interp.err
  >   cmp c.err interp.err
  >   cmp c.out interp.out
  >   cat c.err
  > }
  $ printf 'time,in\n0,1e-400\n1,1.79e308\n2,-1e400\n' > large.csv
  $ both large.csv
  error: large.csv:4:3: column `in`: expected a number up to 1.79e308, or `inf`, found `-1e400`
  $ cat c.out
  time,out
  0.000000000,0
  1.000000000,1.79e+308
  $ frobc convert large.csv large.mcap
  error: large.csv:4: column `in`: expected a number up to 1.79e308, or `inf`, found `-1e400`
  [2]
  $ (frobc view large.csv same.frob --print 2> told & echo $! > id; wait) > page &
  $ for i in $(seq 400); do grep -qs omitted told && break; sleep 0.05; done; kill $(cat id); cat told
  large.csv:4: column `in`: `-1e400` is not a valid value; expected a number up to 1.79e308, or `inf`; this row and the rows after it are omitted
  $ printf 'time,in\n0,3.4e38\n1,1e39\n' > large.csv
  $ both large.csv --real float
  error: large.csv:3:3: column `in`: expected a number up to 3.4e38, or `inf`, found `1e39`
  $ printf '# param gain=1e400\ntime,in\n0,1\n' > large.csv
  $ echo 'param gain :: Float = 1
  > main :: SF Float Float
  > main = proc x -> gain * x' > gain.frob
  $ frobc trace gain.frob --input large.csv
  error: large.csv: the parameter `gain` is a number in 1, not `1e400`; to override the recorded value, use `--param`
  [2]
  $ frobc trace gain.frob --input large.csv --engine interp
  error: large.csv: the parameter `gain` is a number in 1, not `1e400`; to override the recorded value, use `--param`
  [2]

Times in a smaller unit than seconds:

  $ for time in 1700000000000 1700000000000000 1700000000000000000 1.7e18 -1e30; do
  >   printf "time,in\n$time,1\n" > unit.csv
  >   both unit.csv
  > done
  error: unit.csv:2:1: `1700000000000` is not a time in seconds; the maximum is 4000000000 s: this looks like milliseconds, so divide the times by 1e3
  error: unit.csv:2:1: `1700000000000000` is not a time in seconds; the maximum is 4000000000 s: this looks like microseconds, so divide the times by 1e6
  error: unit.csv:2:1: `1700000000000000000` is not a time in seconds; the maximum is 4000000000 s: this looks like nanoseconds, so divide the times by 1e9
  error: unit.csv:2:1: `1.7e18` is not a time in seconds; the maximum is 4000000000 s: this looks like nanoseconds, so divide the times by 1e9
  error: unit.csv:2:1: `-1e30` is not a time in seconds; the maximum is 4000000000 s
  $ frobc convert unit.csv unit.mcap
  error: unit.csv:2: `-1e30` is not a time in seconds; the maximum is 4000000000 s
  [2]
  $ printf 'time,in\n1.7e18,1\n' > unit.csv
  $ frobc convert unit.csv unit.mcap
  error: unit.csv:2: `1.7e18` is not a time in seconds; the maximum is 4000000000 s: this looks like nanoseconds, so divide the times by 1e9
  [2]
  $ frobc view unit.csv same.frob --print
  unit.csv:2: `1.7e18` is not a time in seconds; the maximum is 4000000000 s: this looks like nanoseconds, so divide the times by 1e9; this row and the rows after it are omitted
  error: cannot view unit.csv: it contains no instant
  [2]

Lines that end with carriage returns alone, as old spreadsheets wrote them:

  $ printf 'time,in\r0,1\r1,2\r' > returns.csv
  $ both returns.csv
  error: returns.csv:1:1: the lines end with carriage returns only: convert them to line feeds with `tr '\r' '\n'`
  $ frobc convert returns.csv returns.mcap
  error: returns.csv:1: the lines end with carriage returns only: convert them to line feeds with `tr '\r' '\n'`
  [2]
  $ frobc view returns.csv same.frob --print
  error: cannot view returns.csv: the lines end with carriage returns only: convert them to line feeds with `tr '\r' '\n'`
  [2]
  $ tr '\r' '\n' < returns.csv > feeds.csv
  $ both feeds.csv
  $ printf '# param gain=2\rtime,in\r0,1\r' > returns.csv
  $ both returns.csv
  error: returns.csv:1:1: the lines end with carriage returns only: convert them to line feeds with `tr '\r' '\n'`

A decimal comma needs another separator, or quotes:

  $ printf 'time,in\n0,5,1,5\n' > commas.csv
  $ both commas.csv --decimal-comma
  error: commas.csv:2:5: wrong number of cells: the header has 2 columns, but this row has 4; if numbers have a decimal comma, put them in double quotes, or separate the cells by `;` and add `--separator ';'`
  $ frobc convert commas.csv commas.mcap --decimal-comma
  error: commas.csv:2: wrong number of cells: the header has 2 columns, but this row has 4; if numbers have a decimal comma, put them in double quotes, or separate the cells by `;` and add `--separator ';'`
  [2]
  $ printf 'time,in\n"0,5","1,5"\n' > commas.csv
  $ both commas.csv --decimal-comma
  $ printf 'Zeit;in\n0,5;1,5\n' > commas.csv
  $ both commas.csv --decimal-comma --time-column Zeit
  error: commas.csv:1:1: there is no column `Zeit` for `--time-column`; the columns are `Zeit;in`; its columns are separated by semicolons: add `--separator ';'`

A control character in the name of a column is shown as a code, and quoted for the shell:

  $ printf 'time,"i\033n\n\tx"\n0,1\n' > names.csv
  $ both names.csv
  error: names.csv:1:7: the program's input has no `i\027n\010\009x`
  error: names.csv:1:1: missing: `in`; the header for this program is `time,in`; to read it from another column, add `--column $'in=i\033n\012\011x'`
  $ printf 'time,i\033n\n0,1\n' > names.csv
  $ both names.csv
  error: names.csv:1:6: the program's input has no `i\027n`
  error: names.csv:1:1: missing: `in`; the header for this program is `time,in`; to read it from another column, add `--column $'in=i\033n'`
  $ both names.csv --column "in=$(printf 'i\033n')"
  $ both names.csv --column "in=$(printf 'i\033m')"
  error: names.csv:1:1: there is no column `i\027m` for `--column`; the columns are `time`, `i\027n`
  $ frobc convert names.csv names.mcap
  error: names.csv:1: the name of column 2, `i\027n`, contains a control character: rename the column
  [2]

An archive of zero bytes is rejected at its beginning. That its end is missing is not reported,
because `frobc` does not read that far:

  $ head -c 200M /dev/zero | gzip -1 | head -c -8 > zeros.csv.gz
  $ both zeros.csv.gz
  error: zeros.csv.gz:1:1: there is a zero byte: this is not a CSV file
  $ frobc convert zeros.csv.gz zeros.mcap
  error: zeros.csv.gz:1: the row is longer than 16 MB: this is not a recording
  [2]
  $ frobc view zeros.csv.gz same.frob --print
  error: cannot view zeros.csv.gz: it is not a recording: the first column must be `time`
  [2]

Invalid options:

  $ frobc trace speed.frob --input log.csv --separator ab 2>&1 | head -1
  frobc: option '--separator': `ab` is neither `tab` nor a single character
  $ frobc trace speed.frob --input log.csv --column in.speed 2>&1 | head -1
  frobc: option '--column': `in.speed` does not have the form NAME=COLUMN:
