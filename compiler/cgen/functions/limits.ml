open Basis
open Step.Ir

let limited = function
  | Operation
      {
        operator = Maximum;
        ty = Float;
        arguments =
          [
            Operation { operator = Negate; arguments = [ most ]; _ };
            Operation { operator = Minimum; arguments = [ most'; y ]; _ };
          ];
        _;
      }
    when most = most' ->
      Some (most, y)
  | _ -> None

let in_body body =
  let found = Int_table.create 4 and reads = Int_table.create 4 in
  let count n (v : variable) =
    if Int_table.mem found v.id then
      let before = Option.value (Int_table.find_opt reads v.id) ~default:0 in
      Int_table.replace reads v.id (before + n)
  in
  let declared = function
    | Declare
        {
          variable;
          value = Operation { operator = Maximum; ty = Float; arguments = [ Float zero; x ]; _ };
          _;
        }
      when Int64.equal (Int64.bits_of_float zero) 0L ->
        Int_table.replace found variable.id x
    | _ -> ()
  in
  Step.Walk.statements declared body;
  let read e =
    match limited e with
    | Some (Variable v, _) -> count (-2) v
    | Some _ -> ()
    | None -> ( match e with Variable v -> count 1 v | _ -> ())
  in
  Step.Walk.expressions read body;
  Int_table.fold (fun id n () -> if n <> 0 then Int_table.remove found id) reads ();
  found
