The code in docs/generated-c.md is what frobc generates, and its examples build
and run. Blocks of code by language and number:

  $ page=../../../docs/generated-c.md
  $ block() { awk -v start="\`\`\`$1" -v wanted="$2" '$0 == "```" { inside = 0 } inside && n == wanted; $0 == start { inside = 1; n++ }' $page; }
  $ block frob 1 >cruise.frob
  $ frobc compile cruise.frob
  $ block c 1 >shown && awk '/^struct cruise_input/ { shown = 1 } shown; shown && /out\);/ && ++n == 2 { exit }' cruise.h | diff shown -
  $ block c 2 >shown && sed -n '/^\/\* main/,$p' cruise.c | diff shown -

The arithmetic check:

  $ block c 3 >ask.c && echo 'int main(void) { return !may_drive(); }' >>ask.c
  $ include=$(dirname "$(command -v frobc)")/../share/frobc/include
  $ gcc -O2 -ffp-contract=off -I "$include" ask.c -o ask && ./ask
  $ gcc -O2 -ffast-math -I "$include" ask.c -o ask && ./ask
  this must not drive: its arithmetic treats floating-point numbers as real numbers: compile without -ffast-math and its suboptions
  [1]

From C:

  $ block c 4 >drive.c
  $ flags="-Wall -Wextra -Wpedantic -Wconversion -Wshadow -Werror"
  $ gcc -std=c99 -O2 -ffp-contract=off $flags -I "$include" -c cruise.c
  $ frobc compile --standalone cruise.frob
  $ gcc -std=c99 -O2 -ffp-contract=off $flags cruise.c drive.c -lm -o drive_c && ./drive_c
  4.000 V at 0.000 m/s
  3.240 V at 0.200 m/s
  2.624 V at 0.362 m/s
  2.125 V at 0.493 m/s

In single precision:

  $ mkdir single && frobc compile cruise.frob --real float -o single
  $ block c 5 >shown && sed -n '/^void cruise_step_ns/,/^}/p' single/cruise.c | diff shown -

From C++, linked with C, and compiled as C++:

  $ block cpp 1 >drive.cc
  $ gcc -std=c99 -O2 -ffp-contract=off $flags -c cruise.c
  $ g++ -std=c++17 $flags drive.cc cruise.o -o drive_cc && ./drive_cc
  4.000 V, 2.000 V
  $ clang++ -std=c++17 $flags drive.cc -x c++ cruise.c -o drive_all && ./drive_all
  4.000 V, 2.000 V

The state diagram:

  $ block frob 2 >patrol.frob
  $ block dot 1 >shown && frobc report patrol.frob --states | diff shown -
  $ frobc report patrol.frob --svg | diff ../../../docs/patrol.svg -
