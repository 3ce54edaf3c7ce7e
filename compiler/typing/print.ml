open Basis
open Pretty
open Ir

(* [own] in the printer is the name of the main module. *)

let global c (g : Global.t) =
  if String.equal g.module_ c.own || is_infix g.name then operator g.name
  else g.module_ ^ "." ^ g.name

let local c (x : Local.t) = Unique_names.find c.names ~id:x.id x.name
let level = function Constant -> "constant " | Static -> "static " | Signal -> "signal "

let representation = function
  | Int -> "Int"
  | Float -> "Float"
  | Representation_variable v -> v.name

let type_argument c t =
  let text = Show.ty t in
  let whole = text.[0] = '(' || not (String.contains text ' ') in
  put c (if whole then " @" ^ text else " @(" ^ text ^ ")")

let instantiation c (i : instantiation) =
  List.iter (type_argument c) i.types;
  List.iter (fun r -> put c (" @" ^ representation r)) i.representations

let name c nested text (i : instantiation) =
  parenthesized c
    (nested && (i.types <> [] || i.representations <> []))
    (fun () ->
      put c text;
      instantiation c i)

(* {1 Patterns} *)

let rec pattern c nested (p : pattern) =
  match p.desc with
  | Any -> put c "_"
  | Bound x -> put c (local c x)
  | As (x, p) ->
      put c (local c x ^ "@");
      pattern c true p
  | Tuple_of ps -> tuple c (pattern c false) ps
  | Array_of ps -> array c (pattern c false) ps
  | Constructed (k, ps) ->
      parenthesized c
        (nested && ps <> [])
        (fun () ->
          put c k.constructor.name;
          words c (pattern c true) ps)
  | Literal n -> put c (number n)

(* {1 Expressions} *)

(* Syntactic context: 0 for any, 1 for an operand or function, 2 for an argument. *)
let rec expr c depth (e : expr) =
  match e.desc with
  | Local (x, i) -> name c (depth > 1) (local c x) i
  | Global (g, i) -> name c (depth > 1) (global c g) i
  | Primitive (g, i) -> name c (depth > 1) (operator g.name) i
  | Method { method_; instantiation; class_ = _ } ->
      name c (depth > 1) (global c method_) instantiation
  | Constructor (k, _) -> put c k.constructor.name
  | Number n ->
      let text = number n in
      parenthesized c (depth > 0 && text.[0] = '-') (fun () -> put c text)
  | String text -> put c (Printf.sprintf "%S" text)
  | Tuple es -> tuple c (expr c 0) es
  | Array es -> array c (expr c 0) es
  | Index (a, k) ->
      parenthesized c (depth > 0) (fun () ->
          expr c 1 a;
          put c (" ! " ^ string_of_int k))
  | Apply ({ desc = Apply ({ desc = Primitive (g, _); _ }, a); _ }, b) when is_infix g.name ->
      hov c 0 ~parentheses:(depth > 0) (fun () ->
          expr c 1 a;
          put c (" " ^ g.name);
          space c;
          expr c 1 b)
  | Apply _ -> hov c 2 ~parentheses:(depth > 1) (fun () -> application c e [])
  | Run (h, input) ->
      hov c 2 ~parentheses:(depth > 1) (fun () ->
          put c "run";
          breakable_words c (expr c 2) [ h; input ])
  | Negate a ->
      parenthesized c (depth > 0) (fun () ->
          put c "-";
          expr c 2 a)
  | Power (a, k) ->
      parenthesized c (depth > 0) (fun () ->
          expr c 2 a;
          put c (" ^ " ^ string_of_int k))
  | Record (k, fields) ->
      parenthesized c (depth > 1) (fun () ->
          put c k.constructor.name;
          record c k fields)
  | Update (r, k, fields) ->
      parenthesized c (depth > 1) (fun () ->
          expr c 2 r;
          record c k fields)
  | Field (r, k, index) ->
      expr c 2 r;
      put c ("." ^ field k index)
  | If (condition, a, b) -> choice c depth condition a b
  | Guards (guarded, last) -> guards c depth guarded last
  | Lambda (patterns, body) -> lambda c depth patterns body
  | Case _ | Let _ | Proc _ -> vertical c 2 ~parentheses:(depth > 0) (fun () -> block c e)

and application c (e : expr) arguments =
  match e.desc with
  | Apply (f, a) -> application c f (a :: arguments)
  | _ ->
      expr c 1 e;
      breakable_words c (expr c 2) arguments

and choice c depth condition a b =
  hv c 0 ~parentheses:(depth > 0) (fun () ->
      put c "if ";
      expr c 0 condition;
      space c;
      put c "then ";
      expr c 0 a;
      space c;
      put c "else ";
      expr c 0 b)

and guards c depth guarded last =
  vertical c 0 ~parentheses:(depth > 0) (fun () ->
      List.iteri
        (fun i (guard, value) ->
          if i > 0 then cut c;
          put c "| ";
          expr c 0 guard;
          put c " -> ";
          expr c 0 value)
        guarded;
      Option.iter
        (fun last ->
          cut c;
          put c "| otherwise -> ";
          expr c 0 last)
        last)

and lambda c depth patterns body =
  hov c 2 ~parentheses:(depth > 0) (fun () ->
      put c "\\";
      List.iter
        (fun p ->
          pattern c true p;
          put c " ")
        patterns;
      put c "->";
      space c;
      expr c 0 body)

(* Prints an expression with each branch or equation on its own line. *)
and block c (e : expr) =
  match e.desc with
  | Case (scrutinee, branches) ->
      put c "case ";
      expr c 0 scrutinee;
      put c " of";
      lines c (branch c) branches
  | Let (bindings, body) ->
      put c "let";
      lines c (binding c) bindings;
      cut c;
      put c "in ";
      expr c 0 body
  | Proc { input; equations; output } ->
      put c "proc ";
      pattern c true input;
      put c " -> ";
      expr c 0 output;
      if equations <> [] then put c " where";
      lines c (binding c) equations
  | _ -> expr c 0 e

and branch c (b : branch) =
  hov c 2 (fun () ->
      pattern c false b.pattern;
      put c " ->";
      space c;
      expr c 0 b.value)

and field (k : constructor) index =
  match List.nth_opt k.fields index with
  | Some (name, _) when name <> "" -> name
  | Some _ | None -> string_of_int index

and record c k fields =
  let set (index, value) =
    put c (field k index ^ " = ");
    expr c 0 value
  in
  put c " { ";
  separated c set fields;
  put c " }"

and binding c (b : binding) =
  hov c 2 (fun () ->
      put c (level b.level);
      pattern c false b.pattern;
      put c (" :: " ^ Show.scheme b.scheme ^ " =");
      space c;
      expr c 0 b.value)

(* {1 Programs} *)

let definition c (d : definition) =
  Unique_names.clear c.names;
  cut c;
  put c (operator d.name.name ^ " :: " ^ Show.scheme d.scheme);
  cut c;
  vertical c 2 (fun () ->
      put c (operator d.name.name ^ " =");
      cut c;
      expr c 0 d.value);
  cut c

let program out (p : program) =
  let c = create out p.main_module in
  Format.pp_open_vbox out 0;
  put c ("module " ^ p.main_module);
  cut c;
  List.iter
    (fun (d : definition) -> if String.equal d.name.module_ p.main_module then definition c d)
    p.definitions;
  Format.pp_close_box out ();
  Format.pp_print_flush out ()
