open Basis
module Ir = Typing.Ir

type t = {
  data : (Ir.Global.t, Ir.data) Hashtbl.t;
  variables : (string, Span.t * Ir.ty) Hashtbl.t;  (** types of variables, by name *)
}

(* {1 Patterns} *)

let add found (local : Ir.Local.t) ty = Hashtbl.add found local.name (local.span, ty)

let rec pattern found (p : Ir.pattern) =
  match p.desc with
  | Any | Literal _ -> ()
  | Bound local -> add found local p.ty
  | As (local, inner) ->
      add found local p.ty;
      pattern found inner
  | Tuple_of parts | Array_of parts | Constructed (_, parts) -> List.iter (pattern found) parts

let rec expr found (e : Ir.expr) =
  List.iter (pattern found) (Typing.Walk.patterns e);
  Typing.Walk.parts (expr found) e

let of_program (program : Ir.program) =
  let data = Hashtbl.create 64 and variables = Hashtbl.create 256 in
  List.iter (fun (d : Ir.data) -> Hashtbl.replace data d.tycon d) program.data;
  List.iter (fun (d : Ir.definition) -> expr variables d.value) program.definitions;
  { data; variables }

(* {1 Parts} *)

let fields t (ty : Ir.ty) =
  match ty with
  | Data { tycon; units; arguments } -> (
      match Hashtbl.find_opt t.data tycon with
      | Some { constructors = [ only ]; unit_parameters; type_parameters; _ } ->
          let values = Substitution.data ~unit_parameters units ~type_parameters arguments in
          List.map (fun (name, ty) -> (name, Substitution.apply values ty)) only.fields
      | Some _ | None -> [])
  | Tuple parts -> List.map (fun ty -> ("", ty)) parts
  | _ -> []

let rec part t (ty : Ir.ty) path : Ir.ty option =
  match (path, ty) with
  | [], _ -> Some ty
  | word :: rest, Data { tycon = { name = "Array"; _ }; arguments = [ _; element ]; _ }
    when String.length word > 0 && word.[0] = '[' ->
      part t element rest
  | path, Data ({ tycon = { name = "Array"; _ }; arguments = [ size; element ]; _ } as array) ->
      let within element = Ir.Data { array with arguments = [ size; element ] } in
      Option.map within (part t element path)
  | word :: rest, ty -> (
      let fields = fields t ty in
      match List.assoc_opt word fields with
      | Some field when word <> "" -> part t field rest
      | _ -> (
          match int_of_string_opt word with
          | Some k when k >= 1 && k <= List.length fields ->
              part t (snd (List.nth fields (k - 1))) rest
          | Some _ | None -> None))

let type_of_signal t ~name (written : Span.t) =
  match String.split_on_char '.' name with
  | [] -> None
  | name :: path ->
      (* For a component of a tuple pattern, [written] is the span of the whole pattern, and the
         variable lies inside it. *)
      let is_there ((span : Span.t), _) =
        String.equal span.file written.file
        && span.start >= written.start && span.stop <= written.stop
      in
      Hashtbl.find_all t.variables name |> List.find_opt is_there |> Option.map snd
      |> Fun.flip Option.bind (fun ty -> part t ty path)

let type_of t (p : Catalogue.probe) =
  match p.own with Running_mode -> None | Signal s -> type_of_signal t ~name:s.name s.span

let times_seconds k (ty : Ir.ty) : Ir.ty =
  match ty with
  | Number (representation, unit_) ->
      let second : Ir.Global.t = { module_ = "Prelude"; name = "s" } in
      let seconds : Ir.unit_ = { base = [ (second, Typing.Rational.of_int k) ]; variables = [] } in
      Number (representation, Substitution.product [ unit_; seconds ])
  | ty -> ty

(* Derived units that the library defines. Hz is omitted on purpose: 1/s may also be an angular
   velocity. *)
let derived =
  [
    ("N", [ ("kg", 1); ("m", 1); ("s", -2) ]);
    ("J", [ ("kg", 1); ("m", 2); ("s", -2) ]);
    ("W", [ ("kg", 1); ("m", 2); ("s", -3) ]);
    ("V", [ ("A", -1); ("kg", 1); ("m", 2); ("s", -3) ]);
    ("Ohm", [ ("A", -2); ("kg", 1); ("m", 2); ("s", -3) ]);
    ("Pa", [ ("kg", 1); ("m", -1); ("s", -2) ]);
  ]

let short (u : Ir.unit_) =
  let is_factor (name, power) =
    let is_it ((g : Ir.Global.t), p) =
      String.equal g.name name && Typing.Rational.equal p (Typing.Rational.of_int power)
    in
    List.exists is_it u.base
  in
  let is_it (_, factors) =
    List.compare_lengths factors u.base = 0 && List.for_all is_factor factors
  in
  match List.find_opt is_it derived with Some (name, _) -> name | None -> Typing.Show.unit_ u

let rec unit_ (ty : Ir.ty) =
  match ty with
  | Number (_, { base = []; variables = [] }) -> None
  | Number (_, ({ variables = []; _ } as unit_)) -> Some (short unit_)
  | Data { tycon = { name = "Event" | "Array"; _ }; arguments; _ } -> (
      match List.rev arguments with last :: _ -> unit_ last | [] -> None)
  | _ -> None
