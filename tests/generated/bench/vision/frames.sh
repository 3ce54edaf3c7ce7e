#!/bin/sh
# Measures how long frames take to reach a program, and how soon a camera recovers: see frames.c.
# The argument is the working folder.
set -eu
out=$1/frames
tests=tests/robots/camera
rm -rf "$out"
mkdir -p "$out"
gcc -std=c99 -O2 -Wall -Wextra -Werror -Iruntime $tests/frames.c runtime/hosts/camera/turbo.c \
    -ldl -o "$out/film"
gcc -std=gnu99 -O2 -Wall -Wextra -Werror -fPIC -shared $tests/fake_camera.c -ldl \
    -o "$out/fake_camera.so"
camera=runtime/hosts/camera
gcc -std=c99 -D_GNU_SOURCE -O2 -Wall -Wextra -Werror -Iruntime -Iruntime/include \
    tests/generated/bench/vision/frames.c $(ls $camera/*.c | grep -v /cameras.c) \
    runtime/hosts/common/tag_finder.c runtime/core/frame.c -lm -ldl -o "$out/frames"
cd "$out"
./film rgb 300 320 240 >raw
./film jpeg 300 320 240 >jpegs
./film yuyv 40 64 48 >yuyv
mkfifo pipe
./frames on-the-way pipe raw jpegs
LD_PRELOAD=$PWD/fake_camera.so FAKE_FORM=YUYV FAKE_SIZE=64x48 FAKE_FRAMES=yuyv \
    ./frames again 96 8
