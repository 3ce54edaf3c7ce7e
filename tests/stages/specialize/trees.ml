open Basis
open Core.Ir

let span = Span.start_of_file "test.frob"
let make desc ty : expr = { desc; ty; span }
let float : ty = Float
let local id name ty : binder = { local = { id; name; span }; ty }
let main name : Global.t = { module_ = "Main"; name }
let var (b : binder) = make (Local b.local) b.ty

let number x =
  match Exact.of_literal (string_of_float x ^ "0") with
  | Some exact -> make (Number exact) Float
  | None -> invalid_arg "number"

let tuple es = make (Tuple es) (Tuple (List.map (fun (e : expr) -> e.ty) es))

let component (e : expr) i =
  match e.ty with
  | Tuple tys -> make (Component (e, i)) (List.nth tys i)
  | _ -> invalid_arg "component"

let if_ condition (a : expr) b = make (If (condition, a, b)) a.ty

let lambda binders body =
  List.fold_right
    (fun (b : binder) (body : expr) -> make (Lambda (b, body)) (Function (b.ty, body.ty)))
    binders body

let apply f arguments =
  List.fold_left
    (fun (f : expr) argument ->
      match f.ty with
      | Function (_, result) -> make (Apply (f, argument)) result
      | _ -> invalid_arg "apply")
    f arguments

let let_ binder value (body : expr) = make (Let { binder; value; body }) body.ty

let binary primitive (a : expr) b =
  let result : ty = match primitive with Core.Primitive.Less | Equal -> Bool | _ -> a.ty in
  let ty = Function (a.ty, Function (a.ty, result)) in
  apply (make (Primitive (primitive, [ a.ty ])) ty) [ a; b ]

let ( + ) = binary Add
let ( * ) = binary Multiply

let proc name (input : binder) equations (output : expr) =
  make (Proc { name; input; equations; output }) (Signal_function (input.ty, output.ty))

let equation (binder : binder) rhs = { binder; rhs; span }
let ( := ) binder e = equation binder (Pure e)
let run binder signal_function input = equation binder (Run { signal_function; input })

let delay (x : expr) =
  apply (make (Primitive (Delay, [ x.ty ])) (Function (x.ty, Signal_function (x.ty, x.ty)))) [ x ]

let derivative = make (Primitive (Derivative, [])) (Signal_function (Float, Float))

type scheme = { name : string; parameters : variable list; ty : ty }

let global { name; parameters; ty } types =
  let substitution =
    List.fold_left2
      (fun map (v : variable) ty -> Specialize.Variables.add v.id ty map)
      Specialize.Variables.empty parameters types
  in
  make (Global (main name, types)) (Specialize.Types.close substitution ty)

let define ?(parameters = []) name (body : expr) =
  ({ name = main name; parameters; ty = body.ty; body; span }, { name; parameters; ty = body.ty })

let a : variable = { id = 1; name = "a" }
let b : variable = { id = 2; name = "b" }
let c : variable = { id = 3; name = "c" }
let maybe ty : ty = Data (main "Maybe", [ ty ])

let construct ty constructor arguments =
  make (Construct { data = main "Maybe"; constructor; arguments }) (maybe ty)

let nothing ty = construct ty 0 []
let just (e : expr) = construct e.ty 1 [ e ]
let is_just e = make (Is_constructor (e, 1)) Bool

let from_just (e : expr) =
  match e.ty with
  | Data (_, [ ty ]) -> make (Payload { value = e; constructor = 1; field = 0 }) ty
  | _ -> invalid_arg "from_just"

let program definitions =
  {
    main_module = "Main";
    real = Double;
    data =
      [
        {
          tycon = main "Maybe";
          parameters = [ a ];
          constructors =
            [
              { name = main "Nothing"; record = false; fields = [] };
              { name = main "Just"; record = false; fields = [ ("", Variable a) ] };
            ];
          span;
        };
      ];
    instances = [];
    foreign = { headers = []; types = []; values = [] };
    console = [];
    definitions;
    params = [];
  }
