On a terminal, progress fits on one line, however narrow the terminal and however long a label.
Ctrl-C ends each command with one line that says what was kept and how to continue.

  $ export PYTHONPATH=$PWD/../../../runtime/python PYTHONDONTWRITEBYTECODE=1
  $ export PATH=$(dirname $(command -v frobc)):/usr/bin:/bin
  $ cat > long.frob << 'FROB'
  > import Robot
  > import Trial
  > main :: (HasSonar i, DiffDrive o) => Program i o
  > main = reactimateRobot (proc i -> roMake (setVelTR 0.2[m/s] 0) where
  >     assert "a label that is longer than a terminal is wide, so that it has to be cut somewhere" (velocity i < 1[m/s]))
  > trial "a label that is longer than a terminal is wide, so that it has to be cut somewhere" = Trial { world = "room.toml", lasts = 60[s], seeds = 1 `to` 1000000, judge = proc t -> verdict (t.driven < 1000[m]) }
  > FROB
  $ printf 'program = "long.frob"\nrobots = ["pioneer"]\n' > long.toml

The test presses the key when it sees the first progress, so it does not depend on the speed.

  $ cat > press.py << 'PY'
  > import fcntl, os, pty, re, struct, sys, termios
  > columns = int(sys.argv[1])
  > child, terminal = pty.fork()
  > if child == 0:
  >     os.read(0, 1)  # the size is set
  >     os.execvp(sys.argv[2], sys.argv[2:])
  > fcntl.ioctl(terminal, termios.TIOCSWINSZ, struct.pack("HHHH", 24, columns, 0, 0))
  > os.write(terminal, b"\n")
  > said, pressed = b"", False
  > while True:
  >     try:
  >         said += os.read(terminal, 65536)
  >     except OSError:
  >         break
  >     if not pressed and b"\r\x1b[K" in said:
  >         os.write(terminal, b"\x03")
  >         pressed = True
  > _, status = os.waitpid(child, 0)
  > text = said.decode().replace("^C", "")
  > shown = re.findall("\r\x1b\\[K([^\r\n]*)", text)
  > widest = max(len(line) for line in shown if re.match("simulating|a label", line))
  > last = [line for line in re.split("[\r\n]+", text.replace("\x1b[K", "")) if line][-1]
  > print("fits" if 0 < widest < columns else shown, "Traceback" in text, os.WIFSIGNALED(status))
  > print(re.sub(r"\d[\d.]*", "N", last))
  > PY
  $ press () { python3 press.py "$@"; }
  $ press 80 frobc run long.frob --robot pioneer --for 100000s --record r.csv
  fits False False
  interrupted at N s: the summary covers the run until then, and so does r.csv; run the same command again to start over and overwrite that file
  $ press 12 frobc run long.frob --robot pioneer --for 100000s
  fits False False
  interrupted at N s: the summary covers the run until then; run the same command again to start over
  $ press 60 frobc test long.frob --robot pioneer --seeds 400
  fits False True
  interrupted: no test has finished, so no results were saved; run the same command again to start over
  $ press 60 frobc sweep long.toml
  fits False True
  interrupted: N of N runs are saved in long.rows; run the same command to perform the remaining N
  $ press 80 frobc sweep long.toml --jobs 2
  fits False True
  interrupted: N of N runs are saved in long.rows; run the same command to perform the remaining N
  $ press 60 frobc falsify long.frob --robot pioneer --seeds '1 to 1000' --for 60s --method random
  fits False True
  interrupted: no search has finished, so no results were saved; `--only 'a label that is longer than a terminal is wide, so that it has to be cut somewhere'` restarts the search that had performed N of at most N runs
