open Basis
open Typing.Ir

type level = Level of Typing.Ir.level | Parameter
type local = { scheme : scheme; level : level }

type t = {
  program : Typing.Ir.program;
  types : (Span.t * ty) array;
  locals : (Span.t * local) Place_table.t;
  globals : (Resolve.Ir.Global.t, scheme) Hashtbl.t Lazy.t;
}

let plain ty : scheme = { types = []; representations = []; units = []; context = []; ty }

let of_program (program : Typing.Ir.program) ~main =
  let types = ref [] and locals = Place_table.create 256 in
  let rec pattern level (p : pattern) =
    types := (p.span, p.ty) :: !types;
    let bound (l : Resolve.Ir.Local.t) =
      Place_table.replace locals (Place_table.place l.span) (l.span, { scheme = plain p.ty; level })
    in
    match p.desc with
    | Any | Literal _ -> ()
    | Bound l -> bound l
    | As (l, inner) ->
        bound l;
        pattern level inner
    | Tuple_of ps | Array_of ps | Constructed (_, ps) -> List.iter (pattern level) ps
  in
  let binding (b : binding) =
    pattern (Level b.level) b.pattern;
    match b.pattern.desc with
    | Bound l ->
        Place_table.replace locals (Place_table.place l.span)
          (l.span, { scheme = b.scheme; level = Level b.level })
    | _ -> ()
  in
  let rec expr (e : expr) =
    types := (e.span, e.ty) :: !types;
    (match e.desc with
    | Case (_, branches) -> List.iter (fun (b : branch) -> pattern Parameter b.pattern) branches
    | Let (bindings, _) -> List.iter binding bindings
    | Lambda (ps, _) -> List.iter (pattern Parameter) ps
    | Proc { input; equations; _ } ->
        pattern (Level Signal) input;
        List.iter binding equations
    | _ -> ());
    Typing.Walk.parts expr e
  in
  List.iter
    (fun (d : definition) -> if String.equal d.name.module_ main then expr d.value)
    program.definitions;
  let globals =
    lazy
      (let table = Hashtbl.create 256 in
       List.iter (fun (g, s) -> Hashtbl.replace table g s) program.primitives;
       List.iter
         (fun (c : class_declaration) ->
           List.iter (fun (g, s) -> Hashtbl.replace table g s) c.methods)
         program.classes;
       List.iter (fun (d : definition) -> Hashtbl.replace table d.name d.scheme) program.definitions;
       table)
  in
  { program; types = Array.of_list !types; locals; globals }

(* The type of the smallest span. Spans are nested, so the smallest one starts last and ends first.
   If several expressions have this span, uses the outermost, which comes last in the list because
   it is visited first. *)
let type_at t p =
  let smaller best ((s : Span.t), ty) =
    if s.start <= p && p <= s.stop && s.start < s.stop then
      match best with
      | Some ((other : Span.t), _) when other.start > s.start || other.stop < s.stop -> best
      | Some _ | None -> Some (s, ty)
    else best
  in
  Array.fold_left smaller None t.types

let spans_at t p =
  Array.fold_left
    (fun spans ((s : Span.t), _) -> if s.start <= p && p <= s.stop then s :: spans else spans)
    [] t.types

let local t (s : Span.t) = Option.map snd (Place_table.find_opt t.locals (Place_table.place s))
let global t g = Hashtbl.find_opt (Lazy.force t.globals) g
let locals t = Place_table.fold (fun _ found all -> found :: all) t.locals []
let data t = t.program.data
