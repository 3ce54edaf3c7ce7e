open Flow.Ir
open Build

let float x = Float x
let leaf ty = Leaf ty

let tuple shapes =
  Product
    {
      product_name = "";
      product_module = "";
      constructor = "";
      record = false;
      parts = List.map (fun shape -> ("", shape)) shapes;
    }

let program ?(sums = [||]) b name ~input ~output =
  { (Build.program ~sums b) with name; input; output }

(* The wall follower from the paper, with its gains and limits as literals. *)
let wall_follow =
  let b = create () in
  let _ =
    node b "wallFollow" (fun n ->
        let v_curr = input n "vCurr" in
        let f = input n "f" in
        let s = input n "s" in
        let limit lo hi x = op n Maximum [ lo; op n Minimum [ hi; x ] ] in
        let error = op n Subtract [ f; float 0.2 ] in
        let v =
          let_ ~line:12 n "v"
            (Op
               ( Maximum,
                 [ float (-0.4); op n Minimum [ float 0.4; op n Multiply [ float 0.5; error ] ] ] ))
        in
        let rate = let_ ~line:13 n "" (Derivative s) in
        let most = op n Multiply [ op n (Elementary Sin) [ float 0.3 ]; v_curr ] in
        let side = op n Multiply [ float 1.5; op n Subtract [ s; float 0.2 ] ] in
        let limited = limit (op n Negate [ most ]) most side in
        let omega =
          let_ ~line:13 n "omega" (Op (Multiply, [ float 1.2; op n Subtract [ limited; rate ] ]))
        in
        [ ("1", v); ("2", omega) ])
  in
  program b "wall_follow"
    ~input:(tuple [ leaf Float; leaf Float; leaf Float ])
    ~output:(tuple [ leaf Float; leaf Float ])

let maybe_float =
  {
    name = "Maybe Float";
    module_ = "Prelude";
    constructors =
      [
        { constructor = "Nothing"; fields = [] };
        { constructor = "Just"; fields = [ ("", leaf Float) ] };
      ];
  }

(* A value that is held between occurrences, and a counter of them. *)
let hold =
  let b = create () in
  let _ =
    node b "hold" (fun n ->
        let e = input ~ty:(Sum 0) n "e" in
        let kept = declare ~line:4 n "kept" in
        let count = declare ~ty:Int ~line:5 n "count" in
        let occurs = let_ ~ty:Bool ~line:3 n "occurs" (Is_constructor (e, 1)) in
        let value = let_ ~line:3 n "" (Payload { value = e; constructor = 1; leaf = 0 }) in
        let held =
          let_ ~line:4 n "held" (If { condition = occurs; then_ = value; else_ = Signal kept })
        in
        define n kept (Delay { init = float 0.; next = held });
        let more = op ~ty:Int n Add [ Signal count; Int 1l ] in
        let next =
          let_ ~ty:Int ~line:5 n "" (If { condition = occurs; then_ = more; else_ = Signal count })
        in
        define n count (Delay { init = Int 0l; next });
        let out =
          let_ ~ty:(Sum 0) ~line:6 n "" (Construct { constructor = 1; payload = [ held ] })
        in
        let small = op ~ty:Bool n Less [ held; float 1. ] in
        let none = let_ ~ty:(Sum 0) n "" (Construct { constructor = 0; payload = [] }) in
        let result =
          let_ ~ty:(Sum 0) ~line:6 n "" (If { condition = small; then_ = none; else_ = out })
        in
        [ ("1", result); ("2", next) ])
  in
  program b "hold" ~sums:[| maybe_float |] ~input:(leaf (Sum 0))
    ~output:(tuple [ leaf (Sum 0); leaf Int ])

(* A computation needed in only one branch moves into it, for all values that the same condition
   selects. *)
let branches =
  let b = create () in
  let _ =
    node b "turn" (fun n ->
        let x = input n "x" in
        let y = input n "y" in
        let near = let_ ~ty:Bool ~line:3 n "near" (Op (Less, [ x; float 1. ])) in
        let angle = let_ ~line:4 n "angle" (Op (Elementary Atan2, [ y; x ])) in
        let r = let_ ~line:5 n "r" (Op (Elementary Hypot, [ x; y ])) in
        let cos_ = op n (Elementary Cos) [ angle ] in
        let a = op n Multiply [ r; cos_ ] in
        let b_ = op n Divide [ angle; r ] in
        let u = let_ ~line:6 n "" (If { condition = near; then_ = a; else_ = x }) in
        let w = let_ ~line:6 n "w" (If { condition = near; then_ = b_; else_ = y }) in
        let far = op ~ty:Bool n Less [ float 10.; x ] in
        let q = let_ ~line:7 n "q" (If { condition = far; then_ = float 10.; else_ = x }) in
        [ ("1", u); ("2", w); ("3", q); ("4", op n Add [ w; q ]) ])
  in
  program b "branches"
    ~input:(tuple [ leaf Float; leaf Float ])
    ~output:(tuple [ leaf Float; leaf Float; leaf Float; leaf Float ])

(* If a choice determines itself from step to step, it becomes a predictable branch; a choice
   that depends on the input does not. *)
let feedback =
  let b = create () in
  let _ =
    node b "feedback" (fun n ->
        let x = input n "x" in
        let before = declare ~line:2 n "before" in
        let full = let_ ~ty:Bool ~line:3 n "full" (Op (Less_equal, [ float 1.; Signal before ])) in
        let more = op n Add [ Signal before; x ] in
        let sum = let_ ~line:4 n "sum" (If { condition = full; then_ = float 0.; else_ = more }) in
        define n before (Delay { init = float 0.; next = sum });
        let low = op ~ty:Bool n Less [ x; float 0. ] in
        let positive = let_ ~line:5 n "" (If { condition = low; then_ = float 0.; else_ = x }) in
        let last = let_ ~line:5 n "last" (Delay { init = float 0.; next = positive }) in
        [ ("1", Signal before); ("2", last) ])
  in
  program b "feedback" ~input:(leaf Float) ~output:(tuple [ leaf Float; leaf Float ])

(* Delays that read each other's old values. *)
let exchange =
  let b = create () in
  let _ =
    node b "exchange" (fun n ->
        let go = input ~ty:Bool n "go" in
        let p = declare ~line:2 n "p" in
        let q = declare ~line:3 n "q" in
        let older = declare ~line:4 n "older" in
        define n p (Delay { init = float 1.; next = Signal q });
        define n q (Delay { init = float 2.; next = Signal p });
        define n older (Delay { init = float 0.; next = Signal p });
        let c = declare ~line:5 n "c" and d = declare ~line:6 n "d" in
        let c' = let_ ~line:5 n "" (If { condition = go; then_ = Signal d; else_ = Signal c }) in
        let d' = let_ ~line:6 n "" (If { condition = go; then_ = Signal c; else_ = Signal d }) in
        define n c (Delay { init = float 3.; next = c' });
        define n d (Delay { init = float 4.; next = d' });
        [
          ("p", Signal p); ("q", Signal q); ("older", Signal older); ("c", Signal c); ("d", Signal d);
        ])
  in
  program b "exchange" ~input:(leaf Bool)
    ~output:(tuple [ leaf Float; leaf Float; leaf Float; leaf Float; leaf Float ])

(* Two copies of a node with parameters, and local time. *)
let instances =
  let b = create () in
  let pi =
    node b ~file:"Control.frob" "pi" (fun n ->
        let kp = static n "kp" in
        let ki = static n "ki" in
        let e = input n "error" in
        let sum = let_ ~line:8 n "sum" (Integral e) in
        [ ("", op n Add [ op n Multiply [ kp; e ]; op n Multiply [ ki; sum ] ]) ])
  in
  let polar =
    node b ~kind:Function "polar" (fun n ->
        let x = input n "x" in
        let y = input n "y" in
        [ ("r", op n (Elementary Hypot) [ x; y ]); ("phi", op n (Elementary Atan2) [ y; x ]) ])
  in
  let _ =
    node b "drive" (fun n ->
        let x = input n "goal.x" in
        let y = input n "goal.y" in
        let r = declare ~line:5 n "r" and phi = declare ~line:5 n "phi" in
        call ~line:5 n polar [ x; y ] [ r; phi ];
        let forward = declare ~line:6 n "forward" and turn = declare ~line:7 n "turn" in
        call ~line:6 ~statics:[ float 0.5; float 0.1 ] n pi [ Signal r ] [ forward ];
        let gain = op n (Elementary Exp) [ float (-1.) ] in
        call ~line:7 ~statics:[ gain; float 0. ] n pi [ Signal phi ] [ turn ];
        let t = let_ ~line:8 n "t" (Time { restart = Bool false }) in
        let started = op ~ty:Bool n Less_equal [ float 1.; t ] in
        let forward' =
          let_ ~line:9 n "forward'"
            (If { condition = started; then_ = Signal forward; else_ = float 0. })
        in
        [ ("forward", forward'); ("turn", Signal turn) ])
  in
  let goal =
    Product
      {
        product_name = "Goal";
        product_module = "Main";
        constructor = "Goal";
        record = true;
        parts =
          [
            ( "goal",
              Product
                {
                  product_name = "Point2";
                  product_module = "Geometry";
                  constructor = "Point2";
                  record = true;
                  parts = [ ("x", leaf Float); ("y", leaf Float) ];
                } );
          ];
      }
  in
  program b "drive" ~input:goal ~output:(tuple [ leaf Float; leaf Float ])

(* Names that are not valid in C, or mean something else there. *)
let names =
  let b = create () in
  let _ =
    node b "names" (fun n ->
        let int = input n "int" in
        let y1 = input n "y1" in
        let prime = let_ n "y'" (Op (Add, [ int; y1 ])) in
        let prime' = let_ n "y_prime" (Op (Multiply, [ prime; int ])) in
        let self = let_ n "self" (Delay { init = float 0.; next = prime' }) in
        let dt = let_ n "dt" (Op (Subtract, [ self; prime ])) in
        let t1 = let_ n "t1" (Op (Add, [ dt; float 1. ])) in
        let unnamed = op n Multiply [ t1; t1 ] in
        [ ("", op n Add [ unnamed; unnamed ]) ])
  in
  program b "names" ~input:(tuple [ leaf Float; leaf Float ]) ~output:(leaf Float)

(* Every operation whose result the language defines but C leaves undefined. *)
let totality =
  let b = create () in
  let _ =
    node b "totality" (fun n ->
        let a = input ~ty:Int n "a" in
        let b = input ~ty:Int n "b" in
        let x = input n "x" in
        let y = input n "y" in
        let ints =
          List.map
            (fun (name, operator) -> (name, op ~ty:Int n operator [ a; b ]))
            [
              ("add", Add);
              ("sub", Subtract);
              ("mul", Multiply);
              ("div", Div);
              ("mod", Mod);
              ("min", Minimum);
              ("max", Maximum);
            ]
        in
        let int = List.map (fun (name, operator) -> (name, op ~ty:Int n operator [ a ])) in
        let converted = List.map (fun (name, operator) -> (name, op ~ty:Int n operator [ x ])) in
        let floats = List.map (fun (name, operator, ys) -> (name, op n operator ys)) in
        List.concat
          [
            ints;
            int [ ("negate", Negate); ("abs", Absolute); ("signum", Signum) ];
            converted
              [ ("round", Round); ("floor", Floor); ("ceiling", Ceiling); ("truncate", Truncate) ];
            floats
              [
                ("fmin", Minimum, [ x; y ]);
                ("fmax", Maximum, [ x; y ]);
                ("fsignum", Signum, [ x ]);
                ("capped", Minimum, [ x; float 1. ]);
                ("raised", Maximum, [ float 1.; x ]);
                ("min0", Minimum, [ x; float 0. ]);
                ("max0", Maximum, [ float 0.; x ]);
                ("limit", Maximum, [ op n Negate [ x ]; op n Minimum [ x; y ] ]);
              ];
          ])
  in
  let names ty = List.map (fun name -> (name, leaf ty)) in
  let record name parts =
    Product
      { product_name = name; product_module = "Main"; constructor = name; record = true; parts }
  in
  program b "totality"
    ~input:(record "Given" (names Int [ "a"; "b" ] @ names Float [ "x"; "y" ]))
    ~output:
      (record "Results"
         (names Int
            [
              "add";
              "sub";
              "mul";
              "div";
              "mod";
              "min";
              "max";
              "negate";
              "abs";
              "signum";
              "round";
              "floor";
              "ceiling";
              "truncate";
            ]
         @ names Float [ "fmin"; "fmax"; "fsignum"; "capped"; "raised"; "min0"; "max0"; "limit" ]))

(* Local time, and values that depend on the first instant or on unusual values of dt. *)
let clock =
  let b = create () in
  let _ =
    node b "clock" (fun n ->
        let x = input n "x" in
        let t = let_ n "t" (Time { restart = Bool false }) in
        let sum = let_ n "sum" (Integral x) in
        let slope = let_ n "slope" (Derivative x) in
        [ ("t", t); ("sum", sum); ("slope", slope) ])
  in
  program b "clock" ~input:(leaf Float) ~output:(tuple [ leaf Float; leaf Float; leaf Float ])

(* Nested sums, which are flattened; with () and tuples inside; also for the host's table. *)
let shapes =
  let either =
    {
      name = "Either (Maybe Float) Bool";
      module_ = "Prelude";
      constructors =
        [
          { constructor = "Left"; fields = [ ("", leaf (Sum 0)) ] };
          { constructor = "Right"; fields = [ ("", leaf Bool) ] };
        ];
    }
  in
  let event =
    {
      name = "Event (Int, Float)";
      module_ = "Prelude";
      constructors =
        [
          { constructor = "NoEvent"; fields = [] };
          { constructor = "Event"; fields = [ ("", tuple [ leaf Int; leaf Float ]) ] };
        ];
    }
  in
  let b = create () in
  let _ =
    node b "shapes" (fun n ->
        let e = input ~ty:(Sum 1) n "e" in
        let v = input ~ty:(Sum 2) n "v" in
        let left = let_ ~ty:Bool n "" (Is_constructor (e, 0)) in
        let inner = let_ ~ty:(Sum 0) n "" (Payload { value = e; constructor = 0; leaf = 0 }) in
        let nothing = let_ ~ty:(Sum 0) n "" (Construct { constructor = 0; payload = [] }) in
        let chosen =
          let_ ~ty:(Sum 0) n "chosen" (If { condition = left; then_ = inner; else_ = nothing })
        in
        let again = let_ ~ty:(Sum 1) n "" (Construct { constructor = 0; payload = [ chosen ] }) in
        let x = let_ n "" (Payload { value = v; constructor = 1; leaf = 1 }) in
        let occurs = let_ ~ty:Bool n "" (Is_constructor (v, 1)) in
        let more = let_ ~ty:(Sum 2) n "" (Construct { constructor = 1; payload = [ Int 7l; x ] }) in
        let result = let_ ~ty:(Sum 2) n "" (If { condition = occurs; then_ = more; else_ = v }) in
        let last = declare ~ty:(Sum 1) n "last" in
        let zero = let_ ~ty:(Sum 0) n "" (Construct { constructor = 1; payload = [ float 0. ] }) in
        let init = let_ ~ty:(Sum 1) n "" (Construct { constructor = 0; payload = [ zero ] }) in
        define n last (Delay { init; next = again });
        [ ("1", Signal last); ("2", result) ])
  in
  let unit = tuple [] in
  program b "shapes" ~sums:[| maybe_float; either; event |]
    ~input:(tuple [ leaf (Sum 1); unit; tuple [ leaf (Sum 2) ] ])
    ~output:(tuple [ leaf (Sum 1); unit; leaf (Sum 2) ])

let all =
  [
    ("wall_follow", wall_follow);
    ("hold", hold);
    ("branches", branches);
    ("feedback", feedback);
    ("exchange", exchange);
    ("drive", instances);
    ("names", names);
    ("totality", totality);
    ("clock", clock);
    ("shapes", shapes);
  ]
