A golden trace is the stored output of a program for an input, which the program
must still produce.

  $ mkdir here
  $ cat > here/speed.frob << 'FROB'
  > import Trial
  > 
  > main :: SF Float[m/s] (Float[m], Bool)
  > main = proc v -> (x, x >= 10[m]) where
  >     x = integral v
  > 
  > test "drives on" = trace "drive.csv" "driven.csv"
  > FROB
  $ printf 'time,in\n0,2\n1,2\n2,3\n6,0\n' > here/drive.csv

At first there is nothing to compare with; `--update` writes the output.

  $ frobc test here
  FAIL  drives on: there is no file here/driven.csv; it must contain the output of the trace: write it with `--update`
  1 test: 1 failed
  [1]
  $ frobc test here --update
  ok    drives on: 6 s; wrote here/driven.csv
  1 test: all hold
  $ cat here/driven.csv
  time,out.1,out.2
  0.000000000,0,false
  1.000000000,2,false
  2.000000000,4,false
  6.000000000,16,true
  $ frobc test here
  ok    drives on: 6 s
  1 test: all hold

If the output differs, the test fails and shows the difference.

  $ sed -i 's/>= 10/> 16/' here/speed.frob
  $ (cd here && frobc test)
  FAIL  drives on: line 5 of driven.csv is `6.000000000,16,true`, but the program returns `6.000000000,16,false`; if the program is right, update the file with `--update`
  1 test: 1 failed
  [1]
  $ echo '9.000000000,16,true' >> here/driven.csv
  $ frobc test here --json
  {"file":"here/speed.frob","label":"drives on","ok":false,"lasts":0,"error":"line 5 of here/driven.csv is `6.000000000,16,true`, but the program returns `6.000000000,16,false`; if the program is right, update the file with `--update`"}
  [1]
  $ frobc test here --update && frobc test here --update
  ok    drives on: 6 s; wrote here/driven.csv
  1 test: all hold
  ok    drives on: 6 s
  1 test: all hold

Only a trace is overwritten, and never the input; an invalid input is reported.

  $ echo "# my notes" > here/driven.csv
  $ frobc test here --update
  FAIL  drives on: --update would overwrite here/driven.csv, which is an existing file, but not a trace or a recording: move it away, or use another file name
  1 test: 1 failed
  [1]
  $ sed -i 's/driven.csv/drive.csv/' here/speed.frob
  $ frobc test here --update
  FAIL  drives on: --update would overwrite here/drive.csv, which is an input: use another file name
  1 test: 1 failed
  [1]
  $ printf 'time,in\n0,2\n1,x\n' > here/drive.csv
  $ frobc test here
  FAIL  drives on: here/drive.csv:3:3: column `in`: expected a number, found `x`
  1 test: 1 failed
  [1]
  $ rm here/drive.csv
  $ frobc test here
  FAIL  drives on: there is no file here/drive.csv; it must contain the input of the trace
  1 test: 1 failed
  [1]
