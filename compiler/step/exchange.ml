open Basis

(* What a statement touches: variables by id, fields by id. *)
type touched = {
  read : unit Int_table.t;  (** variables *)
  set : unit Int_table.t;  (** variables *)
  fields_read : unit Int_table.t;
  fields_set : unit Int_table.t;
}

let add table id = Int_table.replace table id ()

let touched statement =
  let t =
    {
      read = Int_table.create 8;
      set = Int_table.create 8;
      fields_read = Int_table.create 8;
      fields_set = Int_table.create 8;
    }
  in
  Walk.expressions
    (fun (e : Ir.expr) ->
      match e with
      | Variable v -> add t.read v.id
      | Field f -> add t.fields_read f.id
      | _ -> ())
    [ statement ];
  Walk.statements
    (fun (s : Ir.statement) ->
      match s with
      | Declare { variable; _ } | Assign { place = Local variable; _ } -> add t.set variable.id
      | Assign { place = Own field; _ } -> add t.fields_set field.id
      | If { uninitialized; _ } -> List.iter (fun (v : Ir.variable) -> add t.set v.id) uninitialized
      | Assign { place = Result _; _ }
      | Step _ | Loop _ | Reset _ | Enter _ | Start _ | Begin _ | Await _ | Run _ | Return _ ->
          ())
    [ statement ];
  t

let meet a b = Int_table.fold (fun id () any -> any || Int_table.mem b id) a false

(* Nothing but values and assignments. *)
let is_plain statement =
  let plain = ref true in
  Walk.statements
    (fun (s : Ir.statement) ->
      match s with
      | Declare _ | Assign _ | If _ -> ()
      | Step _ | Loop _ | Reset _ | Enter _ | Start _ | Begin _ | Await _ | Run _ | Return _ -> plain := false)
    [ statement ];
  !plain

let may_exchange moved statement =
  is_plain statement
  &&
  let other = touched statement in
  not
    (meet moved.read other.set || meet moved.set other.read || meet moved.set other.set
   || meet moved.fields_read other.fields_set
    || meet moved.fields_set other.fields_read
    || meet moved.fields_set other.fields_set)
