open Basis

type t = {
  variables : unit Int_table.t;
  mutable seconds : bool;
  mutable nanoseconds : bool;
  mutable operations : int;
}

let of_body body =
  let reads =
    { variables = Int_table.create 16; seconds = false; nanoseconds = false; operations = 0 }
  in
  Walk.expressions
    (fun (e : Ir.expr) ->
      reads.operations <- (reads.operations + match Walk.children e with [] -> 0 | _ :: _ -> 1);
      match e with
      | Variable v -> Int_table.replace reads.variables v.id ()
      | Dt -> reads.seconds <- true
      | Dt_nanoseconds -> reads.nanoseconds <- true
      | _ -> ())
    body;
  reads

let parameters reads variables =
  List.filter (fun (v : Ir.variable) -> Int_table.mem reads.variables v.id) variables
