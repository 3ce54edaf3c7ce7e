open Basis
open Typing.Ir

let span = Span.start_of_file "test.frob"
let no_unit = { base = []; variables = [] }
let float : ty = Number (Float, no_unit)
let local id name : Local.t = { id; name; span }
let none = { types = []; representations = [] }
let make desc ty : expr = { desc; ty; span }
let var x ty = make (Local (x, none)) ty
let number n = make (Number (Exact.of_int n)) float
let prelude name : Global.t = { module_ = "Prelude"; name }
let main name : Global.t = { module_ = "Main"; name }

let boolean b =
  let index = if b then 1 else 0 in
  let name = if b then "True" else "False" in
  let constructor = { constructor = prelude name; index; record = false; fields = [] } in
  make (Constructor (constructor, prelude "Bool")) Bool

let types es = List.map (fun (e : expr) -> e.ty) es
let tuple es = make (Tuple es) (Tuple (types es))
let primitive name instantiation ty = make (Primitive (prelude name, instantiation)) ty

let apply (f : expr) a =
  match f.ty with
  | Function (_, result) -> make (Apply (f, a)) result
  | Signal_function (_, result) -> make (Run (f, a)) result
  | Variable _ | Number _ | Bool | String | Tuple _ | Data _ | Size _ -> invalid_arg "apply"

let plus (a : expr) b =
  let on_float = { types = []; representations = [ Float ] } in
  apply (apply (primitive "+" on_float (Function (a.ty, Function (a.ty, a.ty)))) a) b

let delay (initial : expr) s =
  let ty = initial.ty in
  let delay =
    primitive "delay"
      { types = [ ty ]; representations = [] }
      (Function (ty, Signal_function (ty, ty)))
  in
  apply (apply delay initial) s

let case scrutinee branches =
  let branches = List.map (fun (pattern, value) -> { pattern; value }) branches in
  make (Case (scrutinee, branches)) (List.hd branches).value.ty

let guards alternatives last = make (Guards (alternatives, last)) (snd (List.hd alternatives)).ty
let let_ bindings (body : expr) = make (Let (bindings, body)) body.ty

let lambda patterns (body : expr) =
  let arrow (p : pattern) result = Function (p.ty, result) in
  make (Lambda (patterns, body)) (List.fold_right arrow patterns body.ty)

let proc (input : pattern) equations (output : expr) =
  make (Proc { input; equations; output }) (Signal_function (input.ty, output.ty))

let pattern desc ty : pattern = { desc; ty; span }
let any ty = pattern Any ty
let bound x ty = pattern (Bound x) ty
let pair (a : pattern) (b : pattern) = pattern (Tuple_of [ a; b ]) (Tuple [ a.ty; b.ty ] : ty)
let literal n ty = pattern (Literal (Exact.of_int n)) ty
let construct c ty parts = pattern (Constructed (c, parts)) ty
let monomorphic ty : scheme = { types = []; representations = []; units = []; context = []; ty }

let binding pattern (value : expr) =
  { pattern; scheme = monomorphic value.ty; value; recursive = false; level = Constant; span }

let a : variable = { id = 1; name = "a" }
let nothing = { constructor = main "Nothing"; index = 0; record = false; fields = [] }
let just = { constructor = main "Just"; index = 1; record = false; fields = [ ("", Variable a) ] }

let maybe =
  {
    tycon = main "Maybe";
    unit_parameters = [];
    type_parameters = [ a ];
    constructors = [ nothing; just ];
    span;
  }

let maybe_of ty = Data { tycon = main "Maybe"; units = []; arguments = [ ty ] }

let program definitions =
  let definition (name, (value : expr)) =
    { name = main name; scheme = monomorphic value.ty; needs = []; value; doc = None; span }
  in
  {
    main_module = "Main";
    real = Double;
    data = [ maybe ];
    primitives = [];
    foreign = { headers = []; foreign_types = []; values = [] };
    classes = [];
    instances = [];
    definitions = List.map definition definitions;
    params = [];
  }

let messages pass definitions =
  let sink = Diagnostic.sink () in
  pass sink (program definitions);
  let lines (d : Diagnostic.t) =
    Printf.sprintf "%s: %s [%s]" d.code
      (Diagnostic.for_display d.message)
      (Option.fold d.here ~none:"" ~some:Diagnostic.for_display)
    :: List.map (fun (l : Diagnostic.label) -> "  " ^ Diagnostic.for_display l.text) d.labels
  in
  String.concat "\n" (List.concat_map lines (Diagnostic.all sink))
