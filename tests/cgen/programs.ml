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

let program ?(sums = [||]) b name ~input ~output = { (Build.program ~sums b) with name; input; output }

(* The paper's wall follower, with its gains and limits as literals. *)
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
          let_ ~line:12 n "v" (Op (Maximum, [ float (-0.4); op n Minimum [ float 0.4; op n Multiply [ float 0.5; error ] ] ]))
        in
        let rate = let_ ~line:13 n "" (Derivative s) in
        let most = op n Multiply [ op n (Elementary Sin) [ float 0.3 ]; v_curr ] in
        let side = op n Multiply [ float 1.5; op n Subtract [ s; float 0.2 ] ] in
        let limited = limit (op n Negate [ most ]) most side in
        let omega =
          let_ ~line:13 n "omega"
            (Op (Multiply, [ float 1.2; op n Subtract [ limited; rate ] ]))
        in
        [ ("1", v); ("2", omega) ])
  in
  program b "wall_follow" ~input:(tuple [ leaf Float; leaf Float; leaf Float ])
    ~output:(tuple [ leaf Float; leaf Float ])

let all = [ ("wall_follow", wall_follow) ]
