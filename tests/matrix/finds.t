What differs is found: a run that is stopped before its last row, a compiler's
warning.

  $ cat > once.frob << 'END'
  > main :: SF Float Float
  > main = proc x -> x * 3 + 1
  > END
  $ matrix () { sh ./run.sh ./emit.exe ../../stdlib ../../runtime 0 1 gcc-O0 once.frob; }
  $ matrix
  ok gcc-O0: 1 modules
  $ sed -i 's/i < r->count; i++/i < r->count - 1; i++/' runner.c && matrix
  FAIL gcc-O0
  gcc-O0, once:
  once: recording 0: the output differs
  once: recording 1: the output differs
  [1]
  $ sed -i 's/^int main(void)/int main(int argc, char **argv)/' runner.c && matrix 2>&1 | grep -c 'unused parameter'
  2
