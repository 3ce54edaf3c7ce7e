A trial may require only a given proportion of its runs to succeed. Runs continue until this is
decided, or until there are no more seeds; the outcome does not depend on how many run at a time.

  $ cat > chance.frob << 'FROB'
  > import Robot
  > import Trial
  > import WallFollow
  > main :: (HasSonar i, DiffDrive o) => Program i o
  > main = reactimateRobot (wallFollow1 0.4[m])
  > trial "never touches" = Trial { world = "room.toml", lasts = 1[s], seeds = holdsWith 0.9 0.95 (1 `to` 1000), judge = neverTouches }
  > trial "is there at once" = Trial { world = "room.toml", lasts = 1[s], seeds = holdsWith 0.9 0.95 (1 `to` 1000), judge = proc t -> verdict (t.driven > 1[m]) }
  > trial "is soon decided" = Trial { world = "room.toml", lasts = 1[s], seeds = holdsWith 0.99 0.95 (5 `to` 24), judge = neverTouches }
  > FROB
  $ frobc test chance.frob --robot pioneer | grep '^[okFA0-9]'
  ok    never touches: holds in at least 0.9 of runs, with confidence 0.95: held in 38 of 38 runs, so the true fraction is between 0.9075 and 1.0000
  FAIL  is there at once: does not hold in 0.9 of runs, with confidence 0.95: held in 0 of 3 runs, so the true fraction is between 0.0000 and 0.7076; seed 1: failed at 0.000 s
  FAIL  is soon decided: undecided whether it holds in at least 0.99 of runs, with confidence 0.95: held in 20 of 20 runs, so the true fraction is between 0.8316 and 1.0000
  3 tests: 2 failed
  $ frobc test chance.frob --robot pioneer --json -j 1 > one
  [1]
  $ frobc test chance.frob --robot pioneer --json -j 3 | cmp - one
  $ sed -n 's/.*\("chance":{[^}]*}\).*/\1/p' one | sed 's/\(0\.[0-9]\{6\}\)[0-9]*/\1/g'
  "chance":{"share":0.9,"confidence":0.95,"decision":"holds","least":0.907487,"most":1}
  "chance":{"share":0.9,"confidence":0.95,"decision":"fails","least":0,"most":0.707598}
  "chance":{"share":0.99,"confidence":0.95,"decision":"open","least":0.831566,"most":1}
  $ frobc test chance.frob --robot pioneer -k touches --seeds 10 | grep touches
  FAIL  never touches: undecided whether it holds in at least 0.9 of runs, with confidence 0.95: held in 10 of 10 runs, so the true fraction is between 0.6915 and 1.0000
  $ sed 's/0.9 0.95/1.5 0.95/' chance.frob > wrong.frob
  $ frobc test wrong.frob 2>&1 | grep error
  error[E0392]: `holdsWith` needs a proportion between 0 and 1 and a confidence between 0.5 and 1, not 1.5 and 0.95
  error[E0392]: `holdsWith` needs a proportion between 0 and 1 and a confidence between 0.5 and 1, not 1.5 and 0.95
  2 errors

If a trial fails, the run that failed earliest is examined, and those disturbances of the world are
removed without which it still fails.

  $ installed=$(dirname $(dirname $(command -v frobc)))
  $ cp $installed/share/frobc/worlds/room.toml noisy.toml
  $ printf '\n[drive]\nslip = 0.1\n[light]\nnoise = 0.1 # of light\n' >> noisy.toml
  $ cat > shrinks.frob << 'FROB'
  > import Robot
  > import Trial
  > import WallFollow
  > main :: (HasSonar i, DiffDrive o) => Program i o
  > main = reactimateRobot (wallFollow1 0.3[m])
  > trial "knows where it is" = Trial { world = "noisy.toml", lasts = 20[s], seeds = 1 `to` 3, judge = proc t -> verdict (t.odometryError < 0.2[m]) }
  > trial "keeps half a metre" = Trial { world = "noisy.toml", lasts = 20[s], seeds = 1 `to` 3, judge = keepsOff 0.5[m] }
  > FROB
  $ frobc test shrinks.frob --robot pioneer | grep 'disturbances\|view\|FAIL' | sed -E 's/[0-9]+\.[0-9]{3}/N/g; s/seed [0-9]/seed N/; s/-[0-9](-simpler)?\./-N\1./g; s/--seed [0-9]/--seed N/; s/--at [0-9.]*s/--at Ns/'
  FAIL  knows where it is: 3 of 3 seeds; seed N: failed at N s
        frobc view failed/knows-where-it-is-N.csv shrinks.frob --robot pioneer --world noisy.toml --seed N --at Ns
        a simpler run, with none of the world's disturbances except [drive] slip, also fails: seed N: failed at N s
          frobc view failed/knows-where-it-is-N-simpler.csv shrinks.frob --robot pioneer --world failed/knows-where-it-is-N-simpler.toml --seed N --at Ns
  FAIL  keeps half a metre: 3 of 3 seeds; seed N: failed at N s
        frobc view failed/keeps-half-a-metre-N.csv shrinks.frob --robot pioneer --world noisy.toml --seed N --at Ns
        a simpler run, without any of the world's disturbances, also fails: seed N: failed at N s
          frobc view failed/keeps-half-a-metre-N-simpler.csv shrinks.frob --robot pioneer --world failed/keeps-half-a-metre-N-simpler.toml --seed N --at Ns
  $ grep -n '#.*noise\|slip\|written' failed/knows-where-it-is-*.toml | sed 's/.*toml://'
  1:# written by frobc: noisy.toml, reduced to the disturbances without which the run does not fail
  3:# pillar and a crate; ideal wheels, and sonars with a little noise.
  30:# noise = 0.005
  35:slip = 0.1
  37:# noise = 0.1 # of light

The report about a run describes only that run, and so does the report about the
simpler one: the time, the outputs, the seed and the command that shows it agree
with each other and with the recording.

  $ cat > agree.py << 'PY'
  > import csv, re, shlex, sys
  > blocks = [[]]
  > for line in sys.stdin:
  >     if line.startswith("FAIL") or "a simpler run" in line:
  >         blocks.append([])
  >     blocks[-1].append(line)
  > for block in blocks[1:]:
  >     text = "".join(block)
  >     seed, at = re.search(r"seed (\d+): failed at ([0-9.]+) s", text).groups()
  >     forward = re.search(r"out.forward: .*, then (\S+)", text).group(1)
  >     view = shlex.split(re.search(r"frobc view .*", text).group())
  >     of = lambda option: view[view.index(option) + 1]
  >     *_, last = csv.DictReader(line for line in open(view[2]) if not line.startswith("#"))
  >     assert of("--seed") == seed, text
  >     assert abs(float(of("--at")[:-1]) - float(at)) < 5e-4, text
  >     assert abs(float(last["time"]) - float(at)) < 5e-4, text
  >     assert "%.6g" % float(last["out.forward"]) == forward, text
  >     print("simpler" in view[2], "simpler" in of("--world"))
  > PY
  $ frobc test shrinks.frob --robot pioneer -k half | python3 agree.py
  False False
  True True
