Diagnostics for editors: one JSON object per line, with the field names of
rustc.

  $ cat > loop.frob <<EOF
  > main :: SF Float Float
  > main = proc x -> speed where
  >     speed = 2 * err
  >     err = x - speed
  > EOF
  $ frobc check --format=json loop.frob 2> diagnostics
  [1]
  $ sed 's/, "rendered":.*/}/' diagnostics
  {"message":"the signal `speed` needs its own value in the same instant","code":{"code":"E0401","explanation":"# a signal needs its own value in the same instant\n\nThe equations of a `proc` hold at every instant and can refer to each other in any order. But if a\nsignal depends on its own value in the same instant, no order of evaluation exists. The message\nshows the loop, one signal after the other. The loop can pass through signal functions whose output\ndepends on their input in the same instant. The components of tuples and records are separate\nsignals.\n\n```frob-error\nmain :: SF Float Float\nmain = proc target -> speed where\n    err   = target - speed\n    speed = 0.5 * err\n```\n\nChoose a signal in the loop for which the value from the previous instant is good enough, and read\nthat value with `delay`, which also needs a value for the first instant. `integral` breaks a loop\ntoo, because it only adds up past inputs. `derivative` does not.\n\n```frob\nmain :: SF Float Float\nmain = proc target -> speed where\n    err   = target - delay 0 speed\n    speed = 0.5 * err\n```\n"},"level":"error","spans":[{"file_name":"loop.frob","byte_start":56,"byte_end":61,"line_start":3,"line_end":3,"column_start":5,"column_end":10,"is_primary":true,"text":[{"text":"    speed = 2 * err","highlight_start":5,"highlight_end":10}],"label":null},{"file_name":"loop.frob","byte_start":64,"byte_end":71,"line_start":3,"line_end":3,"column_start":13,"column_end":20,"is_primary":false,"text":[{"text":"    speed = 2 * err","highlight_start":13,"highlight_end":20}],"label":"`speed` reads `err` here"},{"file_name":"loop.frob","byte_start":82,"byte_end":91,"line_start":4,"line_end":4,"column_start":11,"column_end":20,"is_primary":false,"text":[{"text":"    err = x - speed","highlight_start":11,"highlight_end":20}],"label":"`err` reads `speed` here"}],"children":[{"message":"let `err` read the previous value of `speed`: write `err = x - delay 0 speed`, where 0 is the initial value","code":null,"level":"help","spans":[],"children":[],"rendered":null}],"fixes":[{"title":"write `err = x - delay 0 speed`","safe":false,"edits":[{"span":{"file_name":"loop.frob","byte_start":82,"byte_end":91,"line_start":4,"line_end":4,"column_start":11,"column_end":20},"text":"x - delay 0 speed"}]}],"rendered":"error[E0401]: the signal `speed` needs its own value in the same instant\n --> loop.frob:3:5\n  |\n3 |     speed = 2 * err\n  |     ^^^^^   ------- `speed` reads `err` here\n4 |     err = x - speed\n  |           --------- `err` reads `speed` here\n  |\n  = hint: let `err` read the previous value of `speed`: write `err = x - delay 0 speed`, where 0 is the initial value\n"}

Of very many diagnostics, the first 1,000 errors and the first 1,000 warnings are shown. The last
object contains the number of omitted ones.

  $ names() { printf 'main :: SF Float Float\nmain = proc x -> x'; seq "$1" | sed 's/^/ + z/' | tr -d '\n'; echo; }
  $ names 1001 > one.frob
  $ frobc check --format json one.frob 2> diagnostics
  [1]
  $ wc -l < diagnostics
  1001
  $ tail -1 diagnostics
  {"message":"1 more error is not shown","code":null,"level":"note","spans":[],"children":[],"fixes":[],"rendered":"note: 1 more error is not shown\n","left_out":{"errors":1,"warnings":0}}
  $ { printf 'main :: SF Float Float\nmain = proc x -> x where\n'; seq 1234 | sed 's/.*/    y& = x/'; } > unread.frob
  $ frobc check --format json unread.frob 2>&1 | tail -1
  {"message":"234 more warnings are not shown","code":null,"level":"note","spans":[],"children":[],"fixes":[],"rendered":"note: 234 more warnings are not shown\n","left_out":{"errors":0,"warnings":234}}
  $ names 1000 > all.frob
  $ frobc check --format json all.frob 2>&1 | grep -c left_out
  0
  [1]
