A program as a shared object, for hosts that load it: with a table, and a function for many steps.

  $ echo 'main :: SF Float Float
  > main = proc x -> 2 * integral x / 1[s]' > twice.frob
  $ frobc build --shared twice.frob
  $ nm -D --defined-only twice.so | cut -d ' ' -f 3
  frob_program
  twice_reset
  twice_step
  twice_step_ns
  twice_steps
  $ frobc build --shared twice.frob -o other.so && cmp twice.so other.so

It is for this machine, and does not overwrite files that frobc did not create.

  $ frobc build --shared twice.frob --target cortex-m
  error: --shared only works for this machine: remove --target
  [2]
  $ echo precious > mine.so
  $ frobc build --shared twice.frob -o mine.so
  error: -o would overwrite mine.so, which is an existing file, but not a program built by frobc: move it away, or use another file name
  [2]
