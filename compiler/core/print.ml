open Basis
open Ir

(* Strings are printed one by one instead of by [fprintf "%a"], which needs much more stack:
   expressions may be nested ten thousand deep. *)
type context = {
  out : Format.formatter;
  qualifies : Global.t -> bool;  (** whether this name is printed with its module *)
  data : (Global.t, Ir.data) Hashtbl.t;
  names : (int, string) Hashtbl.t;  (** names of the definition's variables, by id *)
  uses : (string, int) Hashtbl.t;  (** number of variables with each name *)
}

let put c text = Format.pp_print_string c.out text
let cut c = Format.pp_print_cut c.out ()
let space c = Format.pp_print_space c.out ()
let close c = Format.pp_close_box c.out ()

let parenthesized c yes f =
  if yes then (
    put c "(";
    f ();
    put c ")")
  else f ()

let rec separated c separator f = function
  | [] -> ()
  | [ x ] -> f x
  | x :: rest ->
      f x;
      put c separator;
      space c;
      separated c separator f rest

let enclosed c opening closing f parts =
  Format.pp_open_hvbox c.out 1;
  put c opening;
  separated c "," f parts;
  put c closing;
  close c

let tuple c = enclosed c "(" ")"

let operator text =
  match text.[0] with 'a' .. 'z' | 'A' .. 'Z' | '_' -> text | _ -> "(" ^ text ^ ")"

let global c (g : Global.t) =
  if c.qualifies g && operator g.name = g.name then g.module_ ^ "." ^ g.name else operator g.name

let local c (x : Local.t) =
  match Hashtbl.find_opt c.names x.id with
  | Some name -> name
  | None ->
      let count = 1 + Option.value ~default:0 (Hashtbl.find_opt c.uses x.name) in
      Hashtbl.replace c.uses x.name count;
      let name = if count = 1 && x.name <> "" then x.name else x.name ^ "_" ^ string_of_int count in
      Hashtbl.replace c.names x.id name;
      name

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
      List.iter
        (fun t ->
          put c " ";
          type_ c 2 t)
        arguments)

let type_arguments c types =
  List.iter
    (fun t ->
      put c " @";
      type_ c 2 t)
    types

let type_parameters c vs = List.iter (fun (v : variable) -> put c (" @" ^ v.name)) vs

let binder c (b : binder) =
  put c (local c b.local);
  put c " : ";
  type_ c 0 b.ty

(* {1 Expressions} *)

let constructor c (ty : ty) index =
  let declared =
    match ty with
    | Data (tycon, _) -> Hashtbl.find_opt c.data tycon
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
  | Number value -> number c level value
  | Boolean b -> put c (if b then "True" else "False")
  | String text -> put c (Printf.sprintf "%S" text)
  | Tuple parts -> tuple c (expr c 0) parts
  | Array elements -> enclosed c "[" "]" (expr c 0) elements
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
      parenthesized c
        (level > 1 && arguments <> [])
        (fun () ->
          Format.pp_open_hovbox c.out 2;
          put c (constructor c e.ty k);
          List.iter
            (fun a ->
              space c;
              expr c 2 a)
            arguments;
          close c)
  | Apply ({ desc = Apply ({ desc = Primitive (p, _); _ }, a); _ }, b)
    when operator (Primitive_table.name p) <> Primitive_table.name p ->
      parenthesized c (level > 0) (fun () ->
          Format.pp_open_hovbox c.out 0;
          expr c 1 a;
          put c (" " ^ Primitive_table.name p);
          space c;
          expr c 1 b;
          close c)
  | Apply _ ->
      parenthesized c (level > 1) (fun () ->
          Format.pp_open_hovbox c.out 2;
          application c e [];
          close c)
  | Lambda _ ->
      parenthesized c (level > 0) (fun () ->
          Format.pp_open_hovbox c.out 2;
          put c "\\";
          lambda c e;
          close c)
  | If (a, { desc = Boolean false; _ }, { desc = Boolean true; _ }) ->
      parenthesized c (level > 1) (fun () ->
          put c "not ";
          expr c 2 a)
  | If (a, b, { desc = Boolean false; _ }) ->
      parenthesized c (level > 0) (fun () ->
          Format.pp_open_hovbox c.out 0;
          expr c 1 a;
          put c " and";
          space c;
          expr c (if is_conjunction b then 0 else 1) b;
          close c)
  | If (_, a, b) ->
      parenthesized c (level > 0) (fun () ->
          if is_block a || is_block b then Format.pp_open_vbox c.out 0
          else Format.pp_open_hvbox c.out 0;
          choice c e;
          close c)
  | Let _ ->
      parenthesized c (level > 0) (fun () ->
          Format.pp_open_vbox c.out 0;
          lets c e;
          close c)
  | Proc p -> parenthesized c (level > 0) (fun () -> proc c p)

and choice c (e : expr) =
  match e.desc with
  | If (condition, a, b) when not (is_conjunction e) ->
      put c "if ";
      expr c 0 condition;
      space c;
      put c "then ";
      expr c 0 a;
      space c;
      put c "else ";
      choice c b
  | _ -> expr c 0 e

and name c level text types =
  parenthesized c
    (level > 1 && types <> [])
    (fun () ->
      put c text;
      type_arguments c types)

and number c level value =
  let exact = Exact.to_string value in
  let text =
    if String.length exact <= 20 then exact else Printf.sprintf "%.17g" (Exact.to_float value)
  in
  parenthesized c (level > 0 && text.[0] = '-') (fun () -> put c text)

and application c (e : expr) arguments =
  match e.desc with
  | Apply (f, a) -> application c f (a :: arguments)
  | _ ->
      expr c 1 e;
      List.iter
        (fun a ->
          space c;
          expr c 2 a)
        arguments

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
      Format.pp_open_hovbox c.out 2;
      put c "let ";
      binder c b;
      put c " =";
      space c;
      expr c 0 value;
      put c " in";
      close c;
      cut c;
      lets c body
  | _ -> expr c 0 e

and proc c p =
  Format.pp_open_vbox c.out 2;
  put c (Printf.sprintf "proc %s (" p.name);
  binder c p.input;
  put c ") where";
  List.iter
    (fun eq ->
      cut c;
      equation c eq)
    p.equations;
  cut c;
  Format.pp_open_hovbox c.out 2;
  put c "->";
  space c;
  expr c 0 p.output;
  close c;
  close c

and equation c eq =
  Format.pp_open_hovbox c.out 2;
  binder c eq.binder;
  (match eq.rhs with
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
      expr c 0 input);
  close c

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
  Format.pp_open_hvbox c.out 2;
  put c ("data " ^ d.tycon.name);
  List.iter (fun (v : variable) -> put c (" " ^ v.name)) d.parameters;
  List.iteri
    (fun i (k : constructor) ->
      space c;
      put c ((if i = 0 then "= " else "| ") ^ k.name.name);
      List.iter
        (fun (field, t) ->
          put c " ";
          if field <> "" then put c (field ^ ":");
          type_ c 2 t)
        k.fields)
    d.constructors;
  close c;
  cut c

let definition c (d : definition) =
  Hashtbl.reset c.names;
  Hashtbl.reset c.uses;
  cut c;
  put c (operator d.name.name);
  type_parameters c d.parameters;
  put c " :: ";
  type_ c 0 d.ty;
  cut c;
  Format.pp_open_vbox c.out 2;
  put c (operator d.name.name ^ " =");
  cut c;
  expr c 0 d.body;
  close c;
  cut c

(* Prints [frontDistance = frontDistance@Big]. *)
let instance c (i : instance) =
  cut c;
  Format.pp_open_vbox c.out 2;
  put c ("instance " ^ global c i.class_ ^ " ");
  type_ c 2 i.head;
  List.iter
    (fun (name, implementation) ->
      cut c;
      match implementation with
      | Given definition -> put c (operator name ^ " = " ^ global c definition)
      | Default definition -> put c ("default " ^ global c definition))
    i.methods;
  close c;
  cut c

(* The module of an instance is the one of the methods that it defines. If it defines none, it is
   the module of its class. *)
let belongs_to own (i : instance) =
  let given (_, implementation) =
    match implementation with Given g -> Some g | Default _ -> None
  in
  match List.find_map given i.methods with Some g -> own g | None -> own i.class_

let context out qualifies =
  { out; qualifies; data = Hashtbl.create 64; names = Hashtbl.create 64; uses = Hashtbl.create 64 }

let program out (p : program) =
  let own (g : Global.t) = String.equal g.module_ p.main_module in
  let c = context out (fun g -> not (own g)) in
  List.iter (fun (d : data) -> Hashtbl.replace c.data d.tycon d) p.data;
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
  close c;
  Format.pp_print_flush out ()

let ty out t = type_ (context out (fun g -> g.module_ <> "Prelude")) 0 t

let type_name t =
  let text = Buffer.create 64 in
  let out = Format.formatter_of_buffer text in
  Format.pp_set_margin out 1_000_000;
  type_ (context out (fun _ -> false)) 0 t;
  Format.pp_print_flush out ();
  Buffer.contents text
