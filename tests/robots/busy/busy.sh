# Shared code of tests that run robots in real time. If the machine is busy with other work, the
# result of a real-time run depends on the machine rather than on the program.
#
# For tests in a neighbouring folder: `. ../busy/busy.sh`.
slow=$(cd ../busy && pwd)/slow.so

# Waits up to a minute for a condition; longer in slow time, because `sleep` is slow there, too.
until_true () {
  for attempt in $(seq 1200); do
    eval "$1" && return 0
    sleep 0.05
  done
  echo "the condition never became true: $1"
  return 1
}

# Whether the run that wrote this `summary` kept up with real time, according to the host's
# statistics: no step was late, at most one instant in ten was skipped, and few readings were stale.
kept_up () {
  [ ! -e summary ] || awk -F ': ' '{ value[$1] = $2 + 0 }
    END {
      exit value["late steps"] > 0 || value["longest step"] > 100 || value["stale readings"] > 2 ||
        value["overruns"] * 10 > value["steps"]
    }' summary
}

# Runs a command that starts robots itself, drives them in real time and writes `summary`; prints
# the command's output and returns its status. If the machine did not keep up, this discards the run
# and repeats the command in slow time, together with all processes that it starts. It also repeats
# the command if `$wants`, a condition on the results of the run, does not hold, because processes
# other than the host may have been too slow. The slowest run always counts.
in_time () {
  for FROB_SLOW in 1 4 16; do
    rm -f summary
    [ $FROB_SLOW = 1 ] || export FROB_SLOW LD_PRELOAD=$slow
    "$@" > in_time.said 2>&1
    in_time_status=$?
    unset LD_PRELOAD
    kept_up && eval "${wants:-true}" && break
  done
  kept_up || echo "the machine does not keep up even with a robot $FROB_SLOW times as slow"
  unset FROB_SLOW
  cat in_time.said
  return $in_time_status
}
