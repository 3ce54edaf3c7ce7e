A component in C++ is used like one in C.

  $ cat > median.h <<'EOF'
  > #ifndef MEDIAN_H
  > #define MEDIAN_H
  > struct median_state {
  >     double last[3];
  >     int count;
  > };
  > #endif
  > EOF
  $ cat > smooth.frob <<'EOF'
  > foreign include "median.h"
  > 
  > -- | Of the last three samples: a single wrong one does not show.
  > foreign sf median :: SF Float Float = "median"
  > 
  > main :: SF Float Float
  > main = median
  > EOF
  $ cat > median.cc <<'EOF'
  > #include "smooth.h"
  > #include <algorithm>
  > #include <vector>
  > 
  > extern "C" void median_reset(median_state *self) { self->count = 0; }
  > 
  > extern "C" void median_step(median_state *self, double, const median_input *in, median_output *out) {
  >     self->last[self->count++ % 3] = in->value;
  >     std::vector<double> known(self->last, self->last + std::min(self->count, 3));
  >     std::sort(known.begin(), known.end());
  >     out->value = known[(known.size() - 1) / 2];
  > }
  > EOF
  $ printf 'time,in\n0,1\n1,2\n2,99\n3,3\n4,4\n' > in.csv
  $ frobc trace smooth.frob --with median.cc --with median.h --input in.csv
  time,out
  0.000000000,1
  1.000000000,1
  2.000000000,2
  3.000000000,3
  4.000000000,4

A file that is neither C nor C++ is linked unchanged: an object, or a library.

  $ cat > doubled.frob <<'EOF'
  > foreign twice :: Int -> Int = "twice"
  > 
  > main :: SF Int Int
  > main = proc n -> twice n
  > EOF
  $ echo 'int twice(int n) { return 2 * n; }' > twice.c
  $ gcc -fPIC -c twice.c && gcc -shared -o libtwice.so twice.o && rm twice.c
  $ printf 'time,in\n0,21\n' > in.csv
  $ frobc trace doubled.frob --with twice.o --input in.csv
  time,out
  0.000000000,42
  $ LD_LIBRARY_PATH=. frobc trace doubled.frob --with ./libtwice.so --input in.csv
  time,out
  0.000000000,42
