open Basis
open Ir

(* Strings are printed one by one instead of by [fprintf "%a"], which needs much more stack:
   expressions may be nested ten thousand deep. *)
type context = {
  out : Format.formatter;
  main_module : string;
  names : (int, string) Hashtbl.t;  (** names of the definition's variables, by id *)
  uses : (string, int) Hashtbl.t;  (** number of variables with each name *)
}

let put c text = Format.pp_print_string c.out text
let cut c = Format.pp_print_cut c.out ()
let space c = Format.pp_print_space c.out ()
let close c = Format.pp_close_box c.out ()

let parenthesized c yes f =
  if yes then put c "(";
  f ();
  if yes then put c ")"

let listed c opening closing f parts =
  Format.pp_open_hvbox c.out 1;
  put c opening;
  List.iteri
    (fun i part ->
      if i > 0 then (
        put c ",";
        space c);
      f part)
    parts;
  put c closing;
  close c

let tuple c f parts = listed c "(" ")" f parts
let array c f parts = listed c "[" "]" f parts

let operator text =
  match text.[0] with 'a' .. 'z' | 'A' .. 'Z' | '_' -> text | _ -> "(" ^ text ^ ")"

let global c (g : Global.t) =
  if String.equal g.module_ c.main_module || operator g.name <> g.name then operator g.name
  else g.module_ ^ "." ^ g.name

let local c (x : Local.t) =
  match Hashtbl.find_opt c.names x.id with
  | Some name -> name
  | None ->
      let count = 1 + Option.value ~default:0 (Hashtbl.find_opt c.uses x.name) in
      Hashtbl.replace c.uses x.name count;
      let name = if count = 1 then x.name else x.name ^ "_" ^ string_of_int count in
      Hashtbl.replace c.names x.id name;
      name

let number n =
  let exact = Exact.to_string n in
  if String.length exact <= 20 then exact else Printf.sprintf "%.17g" (Exact.to_float n)

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
          List.iter
            (fun p ->
              put c " ";
              pattern c true p)
            ps)
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
  | Apply ({ desc = Apply ({ desc = Primitive (g, _); _ }, a); _ }, b)
    when operator g.name <> g.name ->
      parenthesized c (depth > 0) (fun () ->
          Format.pp_open_hovbox c.out 0;
          expr c 1 a;
          put c (" " ^ g.name);
          space c;
          expr c 1 b;
          close c)
  | Apply _ -> words c depth (fun () -> application c e [])
  | Run (h, input) ->
      words c depth (fun () ->
          put c "run";
          argument c h;
          argument c input)
  | Negate a ->
      parenthesized c (depth > 0) (fun () ->
          put c "-";
          expr c 2 a)
  | Power (a, k) ->
      parenthesized c (depth > 0) (fun () ->
          expr c 2 a;
          put c (" ^ " ^ string_of_int k))
  | If (condition, a, b) ->
      parenthesized c (depth > 0) (fun () ->
          Format.pp_open_hvbox c.out 0;
          put c "if ";
          expr c 0 condition;
          space c;
          put c "then ";
          expr c 0 a;
          space c;
          put c "else ";
          expr c 0 b;
          close c)
  | Case (scrutinee, branches) ->
      block c depth (fun () ->
          put c "case ";
          expr c 0 scrutinee;
          put c " of";
          List.iter (branch c) branches)
  | Let (bindings, body) ->
      block c depth (fun () ->
          put c "let";
          List.iter (binding c) bindings;
          cut c;
          put c "in ";
          expr c 0 body)
  | Lambda (patterns, body) ->
      parenthesized c (depth > 0) (fun () ->
          Format.pp_open_hovbox c.out 2;
          put c "\\";
          List.iter
            (fun p ->
              pattern c true p;
              put c " ")
            patterns;
          put c "->";
          space c;
          expr c 0 body;
          close c)
  | Guards (guarded, last) -> guards c depth guarded last
  | Proc { input; equations; output } ->
      block c depth (fun () ->
          put c "proc ";
          pattern c true input;
          put c " -> ";
          expr c 0 output;
          if equations <> [] then put c " where";
          List.iter (binding c) equations)
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

and words c depth f =
  parenthesized c (depth > 1) (fun () ->
      Format.pp_open_hovbox c.out 2;
      f ();
      close c)

and block c depth f =
  parenthesized c (depth > 0) (fun () ->
      Format.pp_open_vbox c.out 2;
      f ();
      close c)

and argument c a =
  space c;
  expr c 2 a

and application c (e : expr) arguments =
  match e.desc with
  | Apply (f, a) -> application c f (a :: arguments)
  | _ ->
      expr c 1 e;
      List.iter (argument c) arguments

and branch c (b : branch) =
  cut c;
  Format.pp_open_hovbox c.out 2;
  pattern c false b.pattern;
  put c " ->";
  space c;
  expr c 0 b.value;
  close c

and guards c depth guarded last =
  parenthesized c (depth > 0) (fun () ->
      Format.pp_open_vbox c.out 0;
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
        last;
      close c)

and field (k : constructor) index =
  match List.nth_opt k.fields index with
  | Some (name, _) when name <> "" -> name
  | Some _ | None -> string_of_int index

and record c k fields =
  put c " { ";
  List.iteri
    (fun i (index, value) ->
      if i > 0 then (
        put c ",";
        space c);
      put c (field k index ^ " = ");
      expr c 0 value)
    fields;
  put c " }"

and binding c (b : binding) =
  cut c;
  Format.pp_open_hovbox c.out 2;
  put c (level b.level);
  pattern c false b.pattern;
  put c (" :: " ^ Show.scheme b.scheme ^ " =");
  space c;
  expr c 0 b.value;
  close c

(* {1 Programs} *)

let definition c (d : definition) =
  Hashtbl.reset c.names;
  Hashtbl.reset c.uses;
  cut c;
  put c (operator d.name.name ^ " :: " ^ Show.scheme d.scheme);
  cut c;
  Format.pp_open_vbox c.out 2;
  put c (operator d.name.name ^ " =");
  cut c;
  expr c 0 d.value;
  close c;
  cut c

let program out (p : program) =
  let c =
    { out; main_module = p.main_module; names = Hashtbl.create 64; uses = Hashtbl.create 64 }
  in
  Format.pp_open_vbox out 0;
  put c ("module " ^ p.main_module);
  cut c;
  List.iter
    (fun (d : definition) -> if String.equal d.name.module_ p.main_module then definition c d)
    p.definitions;
  close c;
  Format.pp_print_flush out ()
