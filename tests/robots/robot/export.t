`frobc export --platformio` writes a library folder, with a main program for
boards with the Arduino framework.

  $ frobc export drive.frob --platformio drive
  $ cat drive/library.json
  {
    "name": "drive",
    "version": "0.1.0",
    "description": "The Frob program drive, with the runtime that drives its robot",
    "frameworks": "*",
    "platforms": "*",
    "headers": "drive.h",
    "build": {
      "flags": ["-ffp-contract=off"]
    }
  }
  $ ls drive drive/src drive/examples/drive
  drive:
  examples
  library.json
  src
  
  drive/examples/drive:
  main.cpp
  
  drive/src:
  core
  drive.c
  drive.h
  drive_driver.c
  drive_host.c
  drive_memory.c
  drivers
  elementary
  frob
  hal
  hosts

It builds the way such tools build it: each source separately, with `src` as the
include folder, and without system calls. The board is simulated by a few lines
here.

  $ cat > Arduino.h <<'FAKE'
  > #include <cstddef>
  > #include <cstdint>
  > struct Port {
  >     void begin(std::uint32_t) {}
  >     int available() { return 0; }
  >     int availableForWrite() { return 1; }
  >     int read() { return -1; }
  >     void write(std::uint8_t) {}
  >     void flush() {}
  >     void println(const char *) {}
  > };
  > extern Port Serial, Serial1;
  > std::uint32_t micros();
  > void yield();
  > FAKE
  $ cat > board.cpp <<'FAKE'
  > #include "Arduino.h"
  > Port Serial, Serial1;
  > static std::uint32_t now;
  > std::uint32_t micros() { return now += 1000; }
  > void yield() {}
  > void setup();
  > void loop();
  > int main() {
  >     setup();
  >     for (int i = 0; i < 100; ++i) loop();
  > }
  > FAKE
  $ strict="-Wall -Wextra -Wpedantic -Wconversion -Wshadow -Werror -ffp-contract=off -Idrive/src"
  $ for source in $(find drive/src -name '*.c'); do gcc -std=c99 $strict -c $source -o $(echo $source | tr / _).o || echo $source; done
  $ g++ -std=c++17 $strict -I. drive/examples/drive/main.cpp board.cpp *.o -lm -o board
  $ ./board

In single precision.

  $ rm -r drive *.o
  $ frobc export drive.frob --real float --platformio drive
  $ for source in $(find drive/src -name '*.c'); do gcc -std=c99 $strict -c $source -o $(echo $source | tr / _).o || echo $source; done
  $ g++ -std=c++17 $strict -I. drive/examples/drive/main.cpp board.cpp *.o -lm -o board
  $ ./board

With the user's C: the library includes its headers, and the headers that they
include.

  $ mkdir c c/parts && cat > c/half_way.frob <<'FROB'
  > import Robot
  > foreign include "half.h"
  > foreign sf halved :: SF Velocity Velocity = "halved"
  > main = reactimateRobot (proc _ -> roMake (setVelTR (halved 0.4[m/s]) 0))
  > FROB
  $ echo '#include "parts/state.h"' > c/half.h
  $ echo 'struct halved_state { int steps; };' > c/parts/state.h
  $ echo 'static double half(double x) { return x / 2; }' > c/inside.h
  $ cat > c/halved.c <<'C'
  > #include "half_way.h"
  >   #  include "inside.h"
  > #include <math.h>
  > void halved_reset(struct halved_state *self) { self->steps = 0; }
  > void halved_step(struct halved_state *self, double dt, const struct halved_input *in, struct halved_output *out)
  > {
  >     (void)dt;
  >     self->steps++;
  >     out->value = half(in->value);
  > }
  > C
  $ echo '#error of an earlier run' > c/half_way.h
  $ for real in float double; do
  >   frobc export c/half_way.frob --real $real --robot pioneer --with c/halved.c --with c/half.h --platformio half
  >   for source in half/src/*.c; do gcc -std=c99 $strict -Ihalf/src -c $source -o out.o || echo $source; done
  > done
  $ ls half/src half/src/parts | grep -E 'half|inside|state'
  half/src:
  half.h
  half_way.c
  half_way.h
  half_way_driver.c
  half_way_host.c
  half_way_memory.c
  inside.h
  half/src/parts:
  state.h

Files outside the folder cannot be exported.

  $ echo '#include "../elsewhere.h"' >> c/inside.h && touch elsewhere.h
  $ frobc export c/half_way.frob --robot pioneer --with c/halved.c --with c/half.h --platformio half
  error: c/inside.h includes "../elsewhere.h", which is not in the same folder: move it there
  [2]
