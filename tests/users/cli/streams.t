Every command writes results to standard output, and messages to standard error. Each is run here
with a program that has a warning. Its standard output is for other tools: it equals, byte for byte,
that of the same program without the warning.

  $ export PYTHONPATH=$PWD/../../../runtime/python PYTHONDONTWRITEBYTECODE=1
  $ export PATH=$(dirname $(command -v frobc)):/usr/bin:/bin
  $ mkdir clean warned
  $ cat > clean/program.frob << 'FROB'
  > import Robot
  > import Trial
  > 
  > param speed :: Velocity = 0.2[m/s]
  > main :: (HasSonar i, DiffDrive o) => Program i o
  > main = reactimateRobot (proc i -> roMake (setVelTR speed 0) where
  >     assert "slow" (velocity i < 1[m/s]))
  > trial "goes" = Trial { world = "room.toml", lasts = 1[s], seeds = 1 `to` 2, judge = neverTouches }
  > FROB
  $ printf 'program = "program.frob"\nrobots = ["pioneer"]\n[params]\nspeed = ["0.1[m/s]", "0.2[m/s]"]\n' > clean/plan.toml
  $ cp ../../../examples/own_robot/* clean
  $ cp clean/* warned

No line number changes, because an unused import replaces an empty line.

  $ sed -i '3s/^$/import Past/' warned/program.frob
  $ sed -i '0,/^$/s//import Past/' warned/Rover.frob
  $ frobc check warned/program.frob 2>&1 | grep 'warning\['
  warning[W0306]: `Past` is imported, but nothing from it is used
  $ frobc check warned/Rover.frob 2>&1 | grep 'warning\['
  warning[W0306]: `Past` is imported, but nothing from it is used

Statements about the machine, the speed of a run, and the path of a build are omitted. For each
command, the test shows whether it warns.

  $ cat > both << 'SH'
  > shown () { sed -E "/^simulated seconds per second|^time simulated/d; s/^device: .*/device/; s|^/.*\.so$|BUILT|"; }
  > for kind in clean warned; do
  >   (cd $kind && "$@" 2> ../$kind.err < /dev/null; echo "status $?") | shown > $kind.out
  > done
  > cmp clean.out warned.out || diff clean.out warned.out
  > grep -q 'warning' clean.err && echo "there is nothing to warn of: $*"
  > grep -q 'warning' warned.err || echo "no warning: $*"
  > tail -n 1 warned.out
  > SH
  $ both () { sh ./both "$@"; }

  $ both frobc check program.frob
  status 0
  $ both frobc compile program.frob --robot pioneer
  status 0
  $ both frobc report program.frob --robot pioneer
  status 0
  $ both frobc report program.frob --robot pioneer --format=json
  status 0
  $ both frobc report program.frob --robot pioneer --states
  status 0
  $ both frobc run program.frob --robot pioneer --for 1s --record run.csv --probe list
  status 0
  $ both frobc run program.frob --robot pioneer --for 1s --record run.csv
  status 0
  $ both frobc trace program.frob --robot pioneer --input run.csv
  status 0
  $ both frobc trace program.frob --robot pioneer --input run.csv --engine interp
  status 0
  $ both frobc view run.csv program.frob --robot pioneer --only-build
  status 0
  $ both frobc test program.frob --robot pioneer
  status 0
  $ both frobc test program.frob --robot pioneer --json
  status 0
  $ both frobc sweep plan.toml
  status 0
  $ both frobc falsify program.frob --robot pioneer --for 1s --seeds '1 to 3' --runs 2 --method random
  status 0
  $ both frobc build program.frob --robot pioneer -o program
  status 0
  $ both frobc build program.frob --robot pioneer --shared -o program.so
  status 0
  $ both frobc export --platformio library program.frob --robot pioneer
  status 0
  $ cd warned && frobc fix program.frob --diff > fixes 2> errors < /dev/null
  $ sed -n '/^[-+]/p' fixes; cat errors; cd ..
  --- program.frob
  +++ program.frob
  -import Past

Warnings about a robot's module are for those who check the module, not for
those who use it.

  $ both frobc header Rover.frob
  no warning: frobc header Rover.frob
  status 0
  $ both frobc serve --robot Rover.frob --with rover_body.c --with rover_board.c --for 0.1s
  no warning: frobc serve --robot Rover.frob --with rover_body.c --with rover_board.c --for 0.1s
  status 0

If both streams go to the same place, the messages come first.

  $ cd warned
  $ frobc view run.csv program.frob --robot pioneer --only-build 2>&1 | sed -n '1p; $s|^/.*\.so$|BUILT|p'
  warning[W0306]: `Past` is imported, but nothing from it is used
  BUILT
  $ cd ..

The language server writes only the protocol.

  $ cat > speak.py << 'PY'
  > import json, re, subprocess, sys
  > def frame(method, number=None, **params):
  >     message = {"jsonrpc": "2.0", "method": method, "params": params}
  >     if number is not None:
  >         message["id"] = number
  >     body = json.dumps(message).encode()
  >     return b"Content-Length: %d\r\n\r\n%s" % (len(body), body)
  > opened = dict(uri="file:///program.frob", languageId="frob", version=1,
  >               text=open("warned/program.frob").read())
  > server = subprocess.Popen(["frobc", "lsp"], stdin=subprocess.PIPE, stdout=subprocess.PIPE)
  > def send(*messages):
  >     server.stdin.write(b"".join(messages))
  >     server.stdin.flush()
  > send(frame("initialize", 1, processId=None, rootUri=None, capabilities={}), frame("initialized"),
  >      frame("textDocument/didOpen", textDocument=opened))
  > said = b""
  > while b"W0306" not in said:
  >     said += server.stdout.read1() or sys.exit("it says nothing")
  > send(frame("shutdown", 2), frame("exit"))
  > said += server.stdout.read()
  > codes = []
  > while said:
  >     head = re.match(rb"(?:[A-Za-z-]+: [^\r\n]*\r\n)+\r\n", said)
  >     length = int(re.search(rb"Content-Length: (\d+)", head.group()).group(1))
  >     message = json.loads(said[head.end():head.end() + length])
  >     said = said[head.end() + length:]
  >     codes += [d["code"] for d in message.get("params", {}).get("diagnostics", [])]
  > print(codes)
  > PY
  $ python3 speak.py
  ['W0306']

The other commands do not take a program that could have a warning; the list below contains all
commands.

  $ frobc --help=plain | sed -n '/^COMMANDS/,/^COMMON/s/^       \([a-z0-9]*\) .*/\1/p' | xargs
  build check compile convert demo doctor explain export extras falsify fix format header help lsp new report ros2 run selftest serve sweep test trace view
