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

It builds as such tools build it: each source by itself, with `src` to include
from, and without the system's calls. The board is a few lines here.

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
