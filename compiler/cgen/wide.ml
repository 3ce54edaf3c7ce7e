open Ir

(* Where a result is found: in the struct after the call, or where the struct says
   before it. The latter are those that the function does not always write; of what it
   leaves there is nothing to take over. *)
type place = Inside | Elsewhere

(* Two ways to be given more than a few things. *)
type shape = {
  kept : int;  (* parameters that stay: state and time *)
  given : member list;
  given_struct : string;
  results : (member * place) list;
  results_struct : string;
}

let plain desc = { desc; comment = "" }
let bug format = Basis.Diagnostic.bug ~stage:"Cgen.Wide" format
let is_kept (_, name) = List.mem name [ "self"; "flags"; "dt"; "dt_ns" ]

let rec split_kept = function
  | parameter :: others when is_kept parameter ->
      let kept, rest = split_kept others in
      (parameter :: kept, rest)
  | rest -> ([], rest)

(* Is the result written whatever happens? *)
let is_always_written (f : function_) name =
  let writes s =
    match s.desc with Assign (Unary (Dereference, Name n), _) -> String.equal n name | _ -> false
  in
  List.exists writes f.body

let shape ~struct_name (f : function_) =
  if List.compare_length_with f.parameters Machine.Parameters.most <= 0 then None
  else
    let kept, rest = split_kept f.parameters in
    let given, results =
      List.partition_map
        (fun (ty, name) ->
          match ty with
          | Pointer ty when is_always_written f name -> Either.Right ({ name; ty; comment = "" }, Inside)
          | Pointer _ -> Right ({ name; ty; comment = "" }, Elsewhere)
          | ty -> Left { name; ty; comment = "" })
        rest
    in
    let named suffix = function [] -> "" | _ :: _ -> struct_name (f.name ^ suffix) in
    Some
      {
        kept = List.length kept;
        given;
        given_struct = named "_in" given;
        results;
        results_struct = named "_out" results;
      }

(* {1 Walks} *)

let rec map_expr f e =
  let again = map_expr f in
  match f again e with
  | Some e -> e
  | None -> (
      match e with
      | Name _ | Boolean _ | Integer _ | Long _ | Float _ -> e
      | Unary (operator, e) -> Unary (operator, again e)
      | Binary (operator, a, b) -> Binary (operator, again a, again b)
      | Conditional (a, b, c) ->
          let a = again a in
          let b = again b in
          Conditional (a, b, again c)
      | Call (name, es) -> Call (name, Basis.Long_list.map again es)
      | Member (e, name) -> Member (again e, name)
      | Arrow (e, name) -> Arrow (again e, name)
      | Subscript (a, b) -> Subscript (again a, again b)
      | Aggregate es -> Aggregate (Basis.Long_list.map again es)
      | Cast (ty, e) -> Cast (ty, again e))

(* Each expression of a statement, and the statements of each body in it. *)
let map_statement ~expr ~body (s : statement) =
  let desc =
    match s.desc with
    | Constant c -> Constant { c with value = expr c.value }
    | Table t -> Table { t with value = expr t.value }
    | Variables _ | Continue | Break -> s.desc
    | Variable v -> Variable { v with value = expr v.value }
    | Initialize i -> Initialize { i with values = Basis.Long_list.map expr i.values }
    | Assign (place, value) ->
        let place = expr place in
        Assign (place, expr value)
    | Add_to (place, value) ->
        let place = expr place in
        Add_to (place, expr value)
    | Do e -> Do (expr e)
    | If { condition; then_; else_ } ->
        let condition = expr condition in
        let then_ = body then_ in
        If { condition; then_; else_ = body else_ }
    | Switch { value; cases } ->
        let value = expr value in
        Switch { value; cases = List.map (fun (constant, case) -> (constant, body case)) cases }
    | For f -> For { f with body = body f.body }
    | Repeat r -> Repeat { r with body = body r.body }
    | Return e -> Return (expr e)
  in
  { s with desc }

let names_of (f : function_) =
  let names = Hashtbl.create 64 in
  let note name = Hashtbl.replace names name () in
  List.iter (fun (_, name) -> note name) f.parameters;
  let expr e =
    map_expr
      (fun _ e ->
        (match e with Name name | Call (name, _) -> note name | _ -> ());
        None)
      e
  in
  let rec body statements =
    List.map
      (fun s ->
        (match s.desc with
        | Constant { name; _ } | Table { name; _ } | Variable { name; _ } | Initialize { name; _ } ->
            note name
        | Variables { names; _ } -> List.iter note names
        | For { index; _ } -> note index
        | Assign _ | Add_to _ | Do _ | If _ | Switch _ | Repeat _ | Continue | Break | Return _ -> ());
        map_statement ~expr ~body s)
      statements
  in
  ignore (body f.body);
  Hashtbl.fold (fun name () all -> name :: all) names []

(* {1 The function} *)

(* Its parameters where they are now. *)
let inside shape ~given ~results e =
  let is_given name = List.exists (fun (m : member) -> String.equal m.name name) shape.given in
  let is_result name at = List.exists (fun ((m : member), p) -> String.equal m.name name && p = at) shape.results in
  let result name = Arrow (Name results, name) in
  map_expr
    (fun _ e ->
      match e with
      | Unary (Dereference, Name name) when is_result name Inside -> Some (result name)
      | Arrow (Name name, field) when is_result name Inside -> Some (Member (result name, field))
      | Name name when is_result name Inside -> Some (Unary (Address, result name))
      | Name name when is_result name Elsewhere -> Some (result name)
      | Name name when is_given name -> Some (Arrow (Name given, name))
      | _ -> None)
    e

let definition shape scope (f : function_) =
  let given = Name.fresh scope "in" and results = Name.fresh scope "out" in
  let expr = inside shape ~given ~results in
  let rec body statements = Basis.Long_list.map (map_statement ~expr ~body) statements in
  let pointer members ty name = match members with [] -> [] | _ :: _ -> [ (ty, name) ] in
  {
    f with
    parameters =
      List.filteri (fun k _ -> k < shape.kept) f.parameters
      @ pointer shape.given (Pointer_to_const (Struct shape.given_struct)) given
      @ pointer shape.results (Pointer (Struct shape.results_struct)) results;
    body = body f.body;
  }

(* {1 Calls} *)

let rec split n list =
  match list with
  | x :: rest when n > 0 ->
      let first, others = split (n - 1) rest in
      (x :: first, others)
  | rest -> ([], rest)

let at = function Unary (Address, e) -> e | e -> Unary (Dereference, e)

(* The call, and what stands before and after the statement in which it is. *)
let call scope shape name arguments =
  let kept, rest = split shape.kept arguments in
  let given, results = split (List.length shape.given) rest in
  if List.compare_lengths results shape.results <> 0 then bug "a call of `%s` with too few places" name;
  let variable members suffix =
    match members with [] -> "" | _ :: _ -> Name.fresh scope (name ^ suffix)
  in
  let in_ = variable given "_given" and out = variable results "_results" in
  let address members name = match members with [] -> [] | _ :: _ -> [ Unary (Address, Name name) ] in
  let before =
    (match given with
    | [] -> []
    | values ->
        let values = List.map Expression.in_braces values in
        [ plain (Initialize { ty = Struct shape.given_struct; name = in_; values }) ])
    @
    match results with
    | [] -> []
    | _ :: _ ->
        plain (Variables { ty = Struct shape.results_struct; names = [ out ] })
        :: List.filter_map
             (function
               | e, ((m : member), Elsewhere) -> Some (plain (Assign (Member (Name out, m.name), e)))
               | _, (_, Inside) -> None)
             (List.combine results shape.results)
  and after =
    List.filter_map
      (function
        | e, ((m : member), Inside) -> Some (plain (Assign (at e, Member (Name out, m.name))))
        | _, (_, Elsewhere) -> None)
      (List.combine results shape.results)
  in
  (Call (name, kept @ address given in_ @ address results out), before, after)

let rec with_calls scope shapes ~results statements =
  List.concat_map
    (fun s ->
      let before = ref [] and after = ref [] in
      let expr =
        map_expr (fun again e ->
            match e with
            | Call (name, arguments) when Hashtbl.mem shapes name ->
                let arguments = Basis.Long_list.map again arguments in
                let e, first, last = call scope (Hashtbl.find shapes name) name arguments in
                before := List.rev_append first !before;
                after := !after @ last;
                Some e
            | _ -> None)
      in
      let s = map_statement ~expr ~body:(with_calls scope shapes ~results) s in
      List.iter
        (fun assignment ->
          match assignment.desc with
          | Assign (Name name, _) -> Hashtbl.replace results name ()
          | _ -> ())
        !after;
      List.rev_append !before (s :: !after))
    statements

(* Results that nobody reads: their variables had an address, and were none that a
   compiler finds unused. *)
let without_unread ~results statements =
  let read = Hashtbl.create 16 in
  let expr e =
    map_expr
      (fun _ e ->
        (match e with Name name -> Hashtbl.replace read name () | _ -> ());
        None)
      e
  in
  let rec note statements =
    List.map
      (fun s ->
        match s.desc with
        | Assign (Name _, value) ->
            ignore (expr value);
            s
        | _ -> map_statement ~expr ~body:note s)
      statements
  in
  ignore (note statements);
  let is_unread name = Hashtbl.mem results name && not (Hashtbl.mem read name) in
  let rec clean statements =
    List.filter_map
      (fun s ->
        match s.desc with
        | (Assign (Name name, _) | Variable { name; _ }) when is_unread name -> None
        | Variables { ty; names } -> (
            match List.filter (fun name -> not (is_unread name)) names with
            | [] -> None
            | names -> Some { s with desc = Variables { ty; names } })
        | _ -> Some (map_statement ~expr:Fun.id ~body:clean s))
      statements
  in
  clean statements

let calls_any shapes (f : function_) =
  let found = ref false in
  let expr e =
    map_expr
      (fun _ e ->
        (match e with Call (name, _) when Hashtbl.mem shapes name -> found := true | _ -> ());
        None)
      e
  in
  let rec body statements = List.map (map_statement ~expr ~body) statements in
  ignore (body f.body);
  !found

let structs shape =
  let define name = function
    | [] -> []
    | members -> [ Struct_definition { name; overlaid = false; members; comment = "" } ]
  in
  define shape.given_struct shape.given
  @ define shape.results_struct (List.map fst shape.results)

let functions ~struct_name (functions : function_ list) =
  let shapes = Hashtbl.create 8 in
  let found =
    List.filter_map
      (fun f ->
        let shape = match f.linkage with External -> None | Static | Static_inline | Static_marked _ -> shape ~struct_name f in
        Option.iter (Hashtbl.replace shapes f.name) shape;
        shape)
      functions
  in
  if found = [] then ([], functions)
  else
    let change f =
      let shape = Hashtbl.find_opt shapes f.name in
      if Option.is_none shape && not (calls_any shapes f) then f
      else
        let scope = Name.scope Identifiers ~taken:(names_of f) in
        let f = match shape with None -> f | Some shape -> definition shape scope f in
        let results = Hashtbl.create 16 in
        let body = with_calls scope shapes ~results f.body in
        { f with body = (if Hashtbl.length results = 0 then body else without_unread ~results body) }
    in
    (List.concat_map structs found, Basis.Long_list.map change functions)
