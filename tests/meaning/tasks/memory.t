States that exclude each other share memory, and a value that a task needs now and again later is
stored once.

  $ . ./trace.sh
  $ cat > lamp.frob <<'EOF'
  > lamp :: Float -> Task Float Float ()
  > lamp level = do
  >     sleepT 1[s] level
  >     mkTask (proc x -> (level * x, edge (x > level)))
  >     sleepT 2[s] (-level)
  > 
  > main :: SF Float Float
  > main = mapT abs snapT `thenSF` (\level -> runTask (forever (lamp level)) >>> arr (either id (\() -> 0)))
  > EOF
  $ frobc report lamp.frob | sed -n '/^state/,/^$/p' | without_lines
  state, in bytes
    thenSF               24                                Prelude.frob
      modes              16  memory shared by these modes  Prelude.frob
        thenSF           16  mode                          Prelude.frob
          modes          16  memory shared by these modes  lamp.frob:8
            sleepT       16  mode                          lamp.frob:3
              level       8  parameter                     lamp.frob:3
              time        4  time in ns                    Prelude.frob
              (padding)   4
            lamp         16  mode                          lamp.frob:4
              level       8  parameter                     lamp.frob:4
              delay       1  delay                         Prelude.frob
              (padding)   7
            sleepT       16  mode                          lamp.frob:5
              level       8  parameter                     lamp.frob:5
              y           8  parameter                     lamp.frob:5
      modes               4  memory shared by these modes  Prelude.frob
        thenSF            4  mode                          Prelude.frob
          modes           4  memory shared by these modes  lamp.frob:8
            sleepT        4  mode                          lamp.frob:5
              time        4  time in ns                    Prelude.frob
      mode                1  number of the active mode     Prelude.frob
      modes               1  memory shared by these modes  Prelude.frob
        thenSF            1  mode                          Prelude.frob
          mode            1  number of the active mode     lamp.frob:8
      (padding)           2
  

A task that never ends stores nothing about its end: this one stores one number for the time and one
for the state, like hand-written code.

  $ cat > blink.frob <<'EOF'
  > main :: SF () Float
  > main = runTask (forever (do
  >     sleepT 1[s] 1
  >     sleepT 1[s] 0)) >>> arr (either id id)
  > EOF
  $ frobc compile blink.frob
  $ sed -n '/^struct.* blink_state/,/^};/p' blink.h
  struct FROB_OVERLAID blink_state {
      union {
          struct {
              uint32_t time; /* time left in ns at Prelude.frob:358 */
          } sleepT;
          struct {
              uint32_t time; /* time left in ns at Prelude.frob:358 */
          } sleepT_2;
      } modes;      /* state of the modes at blink.frob:2 */
      uint8_t mode; /* active mode at blink.frob:2 */
      bool started; /* true after the first instant at Prelude.frob:252 */
  };
