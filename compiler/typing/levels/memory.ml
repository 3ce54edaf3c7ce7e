open Ir

type t = {
  senses : (Global.t, unit) Hashtbl.t Lazy.t;
  globals : (Global.t, bool) Hashtbl.t Lazy.t;
  locals : (int, expr) Hashtbl.t;
}

let rec gives_signal_function = function
  | Signal_function _ -> true
  | Function (_, result) -> gives_signal_function result
  | Variable _ | Number _ | Bool | String | Tuple _ | Data _ | Size _ -> false

(* Library functions that are stateful only if their arguments are. *)
let transparent = List.map Environment.built_in [ "mapSF"; "parZ"; "onEvent" ]
let is_transparent g = List.mem g transparent

(* Does this name refer to a stateful signal function? A local variable is examined where it is
   bound. *)
let made_of senses globals (e : expr) =
  match e.desc with
  | Global (g, _) -> Option.value (Hashtbl.find_opt globals g) ~default:true
  | Primitive (g, _) -> gives_signal_function e.ty && not (is_transparent g)
  | Method { method_; _ } -> gives_signal_function e.ty && not (Hashtbl.mem senses method_)
  | _ -> false

let create (p : program) =
  let senses =
    lazy
      (let found = Hashtbl.create 32 in
       let method_ ((g, scheme) : Global.t * scheme) =
         match (scheme.types, scheme.ty) with
         | robot :: _, Signal_function (Variable input, _) when robot.id = input.id ->
             Hashtbl.replace found g ()
         | _ -> ()
       in
       List.iter (fun (c : class_declaration) -> List.iter method_ c.methods) p.classes;
       found)
  in
  let globals =
    lazy
      (let found = Hashtbl.create 256 in
       let definition (d : definition) =
         Hashtbl.replace found d.name (Parts.exists (made_of (Lazy.force senses) found) d.value)
       in
       List.iter definition p.definitions;
       found)
  in
  { senses; globals; locals = Hashtbl.create 16 }

let local m (b : binding) =
  match (b.pattern.desc, b.pattern.ty) with
  | Bound x, Signal_function _ -> Hashtbl.replace m.locals x.id b.value
  | _ -> ()

let rec remembers m e =
  Parts.exists
    (fun (e : expr) ->
      match e.desc with
      | Local (x, _) when gives_signal_function e.ty -> (
          match Hashtbl.find_opt m.locals x.id with
          | Some value ->
              Hashtbl.remove m.locals x.id;
              let found = remembers m value in
              Hashtbl.replace m.locals x.id value;
              found
          | None -> true)
      | _ -> made_of (Lazy.force m.senses) (Lazy.force m.globals) e)
    e
