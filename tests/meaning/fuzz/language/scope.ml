open Choice

type t = {
  random : Random.State.t;
  bias : Bias.t;
  prefix : string;
  methods : bool;
  count : int ref;
  seen : Coverage.t;
  declared : Type.t list;
  variables : (string * Type.t) list;
  functions : (string * Type.t list * Type.t) list;
  run : (t -> int -> Type.t -> string) option;
  senses : (t -> int -> Type.t -> string) option;
}

let fresh s start =
  incr s.count;
  Printf.sprintf "%s%s%d" s.prefix start !(s.count)

let note s name = Coverage.note s.seen name

let note_type s (ty : Type.t) =
  match ty with
  | Array (_, Array _) -> note s "array of arrays"
  | Array (_, Data data) when Type.is_record data -> note s "array of records"
  | Measure _ -> note s "unit"
  | Data { head; _ } when String.starts_with ~prefix:"Series" head -> note s "data with parameters"
  | Float | Int | Bool | Tuple _ | Array _ | Data _ -> ()

let any_type s =
  let ty = Type.any s.random ~declared:s.declared in
  note_type s ty;
  if not (chance s.random s.bias.events) then ty
  else Type.event (if chance s.random 3 then Type.unit else ty)

let bind variables s = { s with variables = variables @ s.variables }

let variable s ty =
  match List.filter (fun (_, t) -> t = ty) s.variables with
  | [] -> None
  | those -> Some (fst (one_of s.random those))
