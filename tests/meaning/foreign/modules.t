Foreign code in modules: the header of an imported module is included whether or not the program
uses it.

  $ export CPATH=$(dirname "$(command -v frobc)")/../share/frobc/include
  $ mkdir vision
  $ cat > vision/Vision.frob <<'EOF'
  > module Vision (Frame, mean, shake) where
  > 
  > foreign include "vision.h"
  > foreign type Frame = "struct frame"
  > foreign mean :: Frame -> Float = "frame_mean"
  > foreign sf shake :: SF Float Float = "shake"
  > foreign hidden :: Float -> Float = "hidden"
  > EOF
  $ cat > vision/vision.h <<'EOF'
  > #ifndef VISION_H
  > #define VISION_H
  > struct frame { double mean; };
  > struct shake_state { double last; };
  > #endif
  > EOF
  $ cat > vision/radar.frob <<'EOF'
  > import qualified Vision as V
  > import Vision (shake)
  > 
  > -- | Another type of that name.
  > foreign type Frame = "struct sweep"
  > foreign strength :: Frame -> Float = "sweep_strength"
  > 
  > data Seen = Camera V.Frame | Radar Frame | Both V.Frame Frame
  > 
  > level :: Seen -> Float
  > level seen = case seen of
  >     Camera f -> V.mean f
  >     Radar s  -> strength s
  >     Both f s -> V.mean f + strength s
  > 
  > main :: SF Seen Float
  > main = arr level >>> shake
  > 
  > plain :: SF Float Float
  > plain = arr (2 *)
  > EOF
  $ frobc check --lint vision/radar.frob
  $ frobc compile --lint vision/radar.frob -o vision
  $ sed -n '/^struct radar_seen/,/^};/p' vision/radar.h
  struct radar_seen {
      uint8_t tag;
      const struct sweep *main_frame_0;
      const struct frame *vision_frame_0;
  };
  $ flags="-Wall -Wextra -Wpedantic -Wconversion -Wshadow -Werror -c -o out.o"
  $ for cc in gcc clang; do $cc -std=c99 $flags vision/radar.c; done
  $ for cc in g++ clang++; do $cc -x c++ -std=c++17 $flags vision/radar.c; done

An entry that calls no C needs no C file, whichever command compiles it. The header of the module
must still be allowed:

  $ printf 'time,in\n0,1\n1,2\n' > in.csv
  $ frobc trace vision/radar.frob --with vision/vision.h --entry plain --input in.csv
  time,out
  0.000000000,2
  1.000000000,4

Foreign names that a module does not export are not visible:

  $ cat > vision/peek.frob <<'EOF'
  > import Vision
  > main :: SF Float Float
  > main = arr hidden
  > EOF
  $ frobc check vision/peek.frob
  error[E0205]: unknown name `hidden`
   --> vision/peek.frob:3:12
    |
  3 | main = arr hidden
    |            ^^^^^^
  
  1 error
  [1]
