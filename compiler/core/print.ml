open Basis
open Pretty
open Ir

type own = {
  qualifies : Global.t -> bool;  (** whether this name is printed with its module *)
  data : (Global.t, Ir.data) Hashtbl.t;
}

let global c (g : Global.t) =
  if c.own.qualifies g && not (is_infix g.name) then g.module_ ^ "." ^ g.name else operator g.name

let local c (x : Local.t) = Unique_names.find c.names ~id:x.id x.name

(* {1 Types} *)

(* Syntactic context: 0 for any, 1 for the left of an arrow, 2 for an argument of a type
   constructor. *)
let rec type_ c level = function
  | Variable v -> put c v.name
  | Bool -> put c "Bool"
  | Int -> put c "Int"
  | Float -> put c "Float"
  | String -> put c "String"
  | Tuple parts -> tuple c (type_ c 0) parts
  | Function (a, b) ->
      parenthesized c (level > 0) (fun () ->
          type_ c 1 a;
          put c " -> ";
          type_ c 0 b)
  | Signal_function (a, b) -> constructed c level "SF" [ a; b ]
  | Data (tycon, arguments) -> constructed c level (global c tycon) arguments
  | Array (size, element) -> constructed c level "Array" [ size; element ]
  | Size n -> put c (string_of_int n)

and constructed c level name arguments =
  parenthesized c
    (level > 1 && arguments <> [])
    (fun () ->
      put c name;
      words c (type_ c 2) arguments)

let type_arguments c types =
  let argument t =
    put c "@";
    type_ c 2 t
  in
  words c argument types

let type_parameters c vs = words c (fun (v : variable) -> put c ("@" ^ v.name)) vs

let binder c (b : binder) =
  put c (local c b.local);
  put c " : ";
  type_ c 0 b.ty

(* {1 Expressions} *)

let constructor c (ty : ty) index =
  let declared =
    match ty with
    | Data (tycon, _) -> Hashtbl.find_opt c.own.data tycon
    | Variable _ | Bool | Int | Float | String | Tuple _ | Function _ | Signal_function _ | Array _
    | Size _ ->
        None
  in
  match declared with
  | Some d when index < List.length d.constructors -> (List.nth d.constructors index).name.name
  | Some _ | None -> "#" ^ string_of_int index

let is_conjunction (e : expr) =
  match e.desc with If (_, _, { desc = Boolean false; _ }) -> true | _ -> false

(* Is the expression easier to read on several lines? *)
let is_block (e : expr) =
  match e.desc with Let _ -> true | If _ -> not (is_conjunction e) | _ -> false

(* Syntactic context: 0 for any, 1 for an operand or function, 2 for an argument. *)
let rec expr c level (e : expr) =
  match e.desc with
  | Local x -> put c (local c x)
  | Global (g, types) -> name c level (global c g) types
  | Primitive (p, types) -> name c level (operator (Primitive_table.name p)) types
  | Method m -> name c level m.name (m.ty :: m.types)
  | Number value ->
      let text = number value in
      parenthesized c (level > 0 && text.[0] = '-') (fun () -> put c text)
  | Boolean b -> put c (if b then "True" else "False")
  | String text -> put c (Printf.sprintf "%S" text)
  | Tuple parts -> tuple c (expr c 0) parts
  | Array elements -> array c (expr c 0) elements
  | Index (array, k) ->
      parenthesized c (level > 0) (fun () ->
          expr c 1 array;
          put c (" ! " ^ string_of_int k))
  | Component (value, index) ->
      expr c 2 value;
      put c ("." ^ string_of_int index)
  | Payload { value; constructor = k; field } ->
      expr c 2 value;
      put c (Printf.sprintf ".%s.%d" (constructor c value.ty k) field)
  | Is_constructor (value, k) ->
      parenthesized c (level > 0) (fun () ->
          expr c 2 value;
          put c (" ? " ^ constructor c value.ty k))
  | Construct { constructor = k; arguments; data = _ } ->
      hov c 2
        ~parentheses:(level > 1 && arguments <> [])
        (fun () ->
          put c (constructor c e.ty k);
          breakable_words c (expr c 2) arguments)
  | Apply ({ desc = Apply ({ desc = Primitive (p, _); _ }, a); _ }, b)
    when is_infix (Primitive_table.name p) ->
      infix c level a (Primitive_table.name p) 1 b
  | Apply _ -> hov c 2 ~parentheses:(level > 1) (fun () -> application c e [])
  | Lambda _ ->
      hov c 2 ~parentheses:(level > 0) (fun () ->
          put c "\\";
          lambda c e)
  | If (condition, a, b) -> choice c level e condition a b
  | Let _ -> vertical c 0 ~parentheses:(level > 0) (fun () -> lets c e)
  | Proc p -> parenthesized c (level > 0) (fun () -> proc c p)

and infix c level a operator level_of_b b =
  hov c 0 ~parentheses:(level > 0) (fun () ->
      expr c 1 a;
      put c (" " ^ operator);
      space c;
      expr c level_of_b b)

and choice c level (e : expr) condition (a : expr) (b : expr) =
  match (a.desc, b.desc) with
  | Boolean false, Boolean true ->
      parenthesized c (level > 1) (fun () ->
          put c "not ";
          expr c 2 condition)
  | _, Boolean false -> infix c level condition "and" (if is_conjunction a then 0 else 1) a
  | _, _ ->
      let box = if is_block a || is_block b then vertical else hv in
      box c 0 ~parentheses:(level > 0) (fun () -> choices c e)

and choices c (e : expr) =
  match e.desc with
  | If (condition, a, b) when not (is_conjunction e) ->
      put c "if ";
      expr c 0 condition;
      space c;
      put c "then ";
      expr c 0 a;
      space c;
      put c "else ";
      choices c b
  | _ -> expr c 0 e

and name c level text types =
  parenthesized c
    (level > 1 && types <> [])
    (fun () ->
      put c text;
      type_arguments c types)

and application c (e : expr) arguments =
  match e.desc with
  | Apply (f, a) -> application c f (a :: arguments)
  | _ ->
      expr c 1 e;
      breakable_words c (expr c 2) arguments

and lambda c (e : expr) =
  match e.desc with
  | Lambda (b, body) ->
      put c "(";
      binder c b;
      put c ") ";
      lambda c body
  | Let _ ->
      put c "->";
      Format.pp_force_newline c.out ();
      expr c 0 e
  | _ ->
      put c "->";
      space c;
      expr c 0 e

(* A chain of bindings may be as long as the program, so this loop is tail-recursive. *)
and lets c (e : expr) =
  match e.desc with
  | Let { binder = b; value; body } ->
      hov c 2 (fun () ->
          put c "let ";
          binder c b;
          put c " =";
          space c;
          expr c 0 value;
          put c " in");
      cut c;
      lets c body
  | _ -> expr c 0 e

and proc c p =
  vertical c 2 (fun () ->
      put c (Printf.sprintf "proc %s (" p.name);
      binder c p.input;
      put c ") where";
      lines c (equation c) p.equations;
      cut c;
      hov c 2 (fun () ->
          put c "->";
          space c;
          expr c 0 p.output))

and equation c eq =
  hov c 2 (fun () ->
      binder c eq.binder;
      match eq.rhs with
      | Pure value ->
          put c " =";
          space c;
          expr c 0 value
      | Run { signal_function; input } ->
          put c " <-";
          space c;
          expr c 1 signal_function;
          space c;
          put c "-< ";
          expr c 0 input)

(* {1 Programs} *)

let foreign_type c (t : foreign_type) =
  put c
    (Printf.sprintf "foreign type %s = %S%s" t.foreign_type.name t.c_type
       (if t.copyable then " copyable" else ""));
  cut c

let foreign_value c ((f : Primitive.foreign), ty) =
  put c (match f.kind with Stateless _ -> "foreign " | Stateful -> "foreign sf ");
  put c (f.foreign_name ^ " :: ");
  type_ c 0 ty;
  put c (Printf.sprintf " = %S" f.symbol);
  cut c

let data c (d : data) =
  let field (name, t) =
    if name <> "" then put c (name ^ ":");
    type_ c 2 t
  in
  hv c 2 (fun () ->
      put c ("data " ^ d.tycon.name);
      words c (fun (v : variable) -> put c v.name) d.parameters;
      List.iteri
        (fun i (k : constructor) ->
          space c;
          put c ((if i = 0 then "= " else "| ") ^ k.name.name);
          words c field k.fields)
        d.constructors);
  cut c

let definition c (d : definition) =
  Unique_names.clear c.names;
  cut c;
  put c (operator d.name.name);
  type_parameters c d.parameters;
  put c " :: ";
  type_ c 0 d.ty;
  cut c;
  vertical c 2 (fun () ->
      put c (operator d.name.name ^ " =");
      cut c;
      expr c 0 d.body);
  cut c

(* Prints each method, for example as [frontDistance = frontDistance@Big]. *)
let instance c (i : instance) =
  let implementation (name, implementation) =
    match implementation with
    | Given definition -> put c (operator name ^ " = " ^ global c definition)
    | Default definition -> put c ("default " ^ global c definition)
  in
  cut c;
  vertical c 2 (fun () ->
      put c ("instance " ^ global c i.class_ ^ " ");
      type_ c 2 i.head;
      lines c implementation i.methods);
  cut c

(* An instance belongs to the module of the methods that it defines or, if it defines none, to the
   module of its class. *)
let belongs_to own (i : instance) =
  let given (_, implementation) =
    match implementation with Given g -> Some g | Default _ -> None
  in
  match List.find_map given i.methods with Some g -> own g | None -> own i.class_

let context out qualifies = create out { qualifies; data = Hashtbl.create 64 }

let program out (p : program) =
  let own (g : Global.t) = String.equal g.module_ p.main_module in
  let c = context out (fun g -> not (own g)) in
  List.iter (fun (d : data) -> Hashtbl.replace c.own.data d.tycon d) p.data;
  Format.pp_open_vbox out 0;
  put c ("module " ^ p.main_module);
  cut c;
  let declared (d : Ir.data) = own d.tycon && d.constructors <> [] in
  List.iter (fun d -> if declared d then data c d) p.data;
  List.iter (fun t -> if own t.foreign_type then foreign_type c t) p.foreign.types;
  let own_value ((f : Primitive.foreign), _) = String.equal f.module_ p.main_module in
  List.iter (fun v -> if own_value v then foreign_value c v) p.foreign.values;
  List.iter
    (fun (param : param) ->
      if own param.param then (
        put c ("param " ^ param.label);
        cut c))
    p.params;
  List.iter (fun (d : definition) -> if own d.name then definition c d) p.definitions;
  List.iter (fun i -> if belongs_to own i then instance c i) p.instances;
  Format.pp_close_box out ();
  Format.pp_print_flush out ()

let ty out t = type_ (context out (fun g -> g.module_ <> "Prelude")) 0 t

let type_name t =
  let text = Buffer.create 64 in
  let out = Format.formatter_of_buffer text in
  Format.pp_set_margin out 1_000_000;
  type_ (context out (fun _ -> false)) 0 t;
  Format.pp_print_flush out ();
  Buffer.contents text
