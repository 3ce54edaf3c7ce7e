let by_equation =
  "a function is defined by an equation, `f x = …`, and a block ends where the indentation does"

let no_procedures =
  "there are no procedures: a robot's program is equations that hold at every instant, `main = \
   reactimateRobot (proc i -> roMake (setVelTR v omega))`"

let cures =
  [
    ([ "end"; "endif"; "endfunction" ], by_equation);
    ( [ "while" ],
      "a task is done again and again by `whileT condition t`, where the condition is a signal \
       function, and by `forever t`" );
    ( [ "for"; "foreach" ],
      "nothing is repeated by a block: `map f xs` and `foldl (+) 0 xs` go through an array, \
       `forEachT xs f` does a task for each" );
    ( [ "print"; "println"; "printf"; "disp"; "fprintf"; "Serial"; "cout"; "puts" ],
      "nothing is printed: what is to be seen is an output, and `--record` writes all of them" );
    ( [ "struct"; "typedef" ],
      "a record is declared by `data`, and built by its constructor: `data Config = Config { speed \
       :: Velocity }`" );
    ([ "enum" ], "a choice of names is `data Side = LeftSide | RightSide`");
    ( [ "extern" ],
      "a function that is in C is declared with its type here, and its name there: `foreign \
       cubeRoot :: Float -> Float = \"cbrt\"`" );
    ([ "using"; "namespace" ], "names come from a module by `import Control`");
  ]

let of_word word = Option.map snd (List.find_opt (fun (words, _) -> List.mem word words) cures)

let waiting =
  "to wait in a task, write `sleepT 1[s] restingOutput`; in a `proc`, `after 1[s] ()` is an event \
   that occurs 1 s after the start"

let waits word =
  List.mem word [ "delay"; "delayMicroseconds"; "sleep"; "usleep"; "wait"; "pause"; "sleepT" ]

let needless =
  [ "const"; "constexpr"; "var"; "val"; "auto"; "static"; "final"; "local"; "global"; "def"; "let" ]
