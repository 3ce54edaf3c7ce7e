open Basis
open Ir

type t = {
  constructors : constructor array Resolve.Global_table.t;
  most : int; (* maximum number of values to list *)
}

let create data =
  let table = Resolve.Global_table.create 64 in
  List.iter
    (fun (d : data) -> Resolve.Global_table.replace table d.tycon (Array.of_list d.constructors))
    data;
  { constructors = table; most = 3 }

type row = { pattern : pattern; guarded : bool }
type missing = Pattern_fact.missing = { named : string list; more : int }
type result = { missing : missing option; guarded_only : int option; useless : int list }

(* {1 Uncovered values} *)

type value =
  | Anything
  | Constructed of string * value list
  | Record of string * (string * value) list
      (** at least one field is something other than [Anything] *)
  | Tuple of value list
  | Array of value list

let show value =
  let out = Buffer.create 32 in
  let put = Buffer.add_string out in
  let rec go argument = function
    | Anything -> put "_"
    | Constructed (name, []) -> put name
    | Constructed (name, arguments) ->
        if argument then put "(";
        put name;
        List.iter
          (fun a ->
            put " ";
            go true a)
          arguments;
        if argument then put ")"
    | Record (name, fields) ->
        put (name ^ " { ");
        separated
          (fun (field, value) ->
            put (field ^ " = ");
            go false value)
          fields;
        put " }"
    | Tuple parts -> between "(" ")" parts
    | Array parts -> between "[" "]" parts
  and between opening closing parts =
    put opening;
    separated (go false) parts;
    put closing
  and separated : 'a. ('a -> unit) -> 'a list -> unit =
   fun put_one parts ->
    List.iteri
      (fun i part ->
        if i > 0 then put ", ";
        put_one part)
      parts
  in
  go false value;
  Buffer.contents out

(* {1 Head constructors} *)

(* The outermost constructor of a pattern. [arity]: the number of subpatterns. *)
type head =
  | Constructor of { index : int; name : string; arity : int; fields : string list }
      (** [fields]: the field names of a record *)
  | Components of int
  | Elements of int
  | Number of Exact.t

let rec head (p : pattern) =
  match p.desc with
  | Any | Bound _ -> None
  | As (_, p) -> head p
  | Tuple_of ps -> Some (Components (List.length ps), ps)
  | Array_of ps -> Some (Elements (List.length ps), ps)
  | Constructed (c, ps) ->
      let name = c.constructor.name and arity = List.length ps in
      let fields = if c.record then List.map fst c.fields else [] in
      Some (Constructor { index = c.index; name; arity; fields }, ps)
  | Literal n -> Some (Number n, [])

let arity = function
  | Constructor { arity; _ } -> arity
  | Components n | Elements n -> n
  | Number _ -> 0

let key = function
  | Constructor { index; _ } -> string_of_int index
  | Components _ | Elements _ -> ""
  | Number n -> Exact.to_string n

let rebuild head parts =
  match head with
  | Constructor { name; fields = []; _ } -> Constructed (name, parts)
  | Constructor { name; fields; _ } -> (
      match List.filter (fun (_, part) -> part <> Anything) (List.combine fields parts) with
      | [] -> Constructed (name, parts)
      | known -> Record (name, known))
  | Components _ -> Tuple parts
  | Elements _ -> Array parts
  | Number n -> Constructed (Exact.to_string n, [])

(* {1 Bounded lists} *)

(* The first elements of a list, and the number of remaining ones. *)
type 'a some = { first : 'a list; besides : int }

(* Limits the count, because the actual number may not fit in an [int]. *)
let limited n = min n 1_000_000

let some_of t all =
  let first = List.filteri (fun i _ -> i < t.most) all in
  { first; besides = limited (List.length all - List.length first) }

let none = { first = []; besides = 0 }
let count some = List.length some.first + some.besides

let append t a b =
  if count a = 0 then b
  else if count b = 0 then a
  else
    let { first; besides } = some_of t (a.first @ b.first) in
    { first; besides = limited (besides + a.besides + b.besides) }

let map f some = { some with first = List.map f some.first }

(* Combines each element of [a] with each element of [b]. *)
let pairs t f a b =
  let { first; _ } = some_of t (List.concat_map (fun x -> List.map (f x) b.first) a.first) in
  { first; besides = limited (count a * count b) - List.length first }

(* Values of [ty] that do not have any of these heads. Together they represent all such values. *)
let others t (ty : ty) heads =
  Work.steps (List.length heads);
  let given = Hashtbl.create 16 in
  List.iter (fun h -> Hashtbl.replace given (key h) ()) heads;
  let rec smallest n =
    if Hashtbl.mem given (string_of_int n) then smallest (n + 1) else string_of_int n
  in
  let all_but_given names =
    let missing = Array.length names - Hashtbl.length given in
    let rec go index wanted =
      if wanted = 0 then []
      else if Hashtbl.mem given (string_of_int index) then go (index + 1) wanted
      else
        let name, arity = names.(index) in
        Constructed (name, List.init arity (fun _ -> Anything)) :: go (index + 1) (wanted - 1)
    in
    let first = go 0 (min missing t.most) in
    { first; besides = limited (missing - List.length first) }
  in
  match ty with
  | Bool -> all_but_given [| ("False", 0); ("True", 0) |]
  | Data { tycon; _ } when tycon = Environment.array -> none
  | Data { tycon; _ } -> (
      match Resolve.Global_table.find_opt t.constructors tycon with
      | Some constructors ->
          Work.steps (Array.length constructors);
          all_but_given
            (Array.map (fun c -> (c.constructor.name, List.length c.fields)) constructors)
      | None -> Diagnostic.bug ~stage:"Typing.Coverage" "no data type `%s`" tycon.name)
  | Number (_, { base = []; variables = [] }) -> some_of t [ Constructed (smallest 0, []) ]
  | Number _ | Variable _ | String | Function _ | Signal_function _ | Size _ ->
      some_of t [ Anything ]
  | Tuple _ -> none

(* {1 The decision tree} *)

(* A row of the matrix: the patterns that remain to be examined, from left to right. *)
type line = { index : int; guards : bool; rest : pattern list }

(* The rows of a matrix, grouped by the head in their first column. *)
type column = {
  ty : ty option;  (** type of the column, if any row examines it *)
  groups : (head * line list) list;  (** the remaining rows for each head *)
  others : line list;  (** the remaining rows for all other heads *)
}

let first_and_rest line =
  match line.rest with
  | first :: rest -> (first, rest)
  | [] -> Diagnostic.bug ~stage:"Typing.Coverage" "a row is too short"

(* Linear time, except that a row without a head in this column is copied for each head. *)
let split lines =
  let groups = Hashtbl.create 16 in
  let heads = ref [] and others = ref [] and ty = ref None in
  (* The type of these wildcards is not used. *)
  let blank (p : pattern) h rest =
    List.fold_left (fun rest _ -> { p with desc = Any } :: rest) rest (List.init (arity h) Fun.id)
  in
  let group (first : pattern) h =
    match Hashtbl.find_opt groups (key h) with
    | Some group -> group
    | None ->
        let group =
          ref
            (List.map
               (fun line ->
                 Work.step ();
                 { line with rest = blank first h line.rest })
               !others)
        in
        Hashtbl.replace groups (key h) group;
        heads := (h, group) :: !heads;
        ty := Some first.ty;
        group
  in
  let add line =
    Work.step ();
    let first, rest = first_and_rest line in
    match head first with
    | Some (h, parts) ->
        let group = group first h in
        group := { line with rest = parts @ rest } :: !group
    | None ->
        List.iter
          (fun (h, group) ->
            Work.step ();
            group := { line with rest = blank first h rest } :: !group)
          !heads;
        others := { line with rest } :: !others
  in
  List.iter add lines;
  {
    ty = !ty;
    groups = List.rev_map (fun (h, group) -> (h, List.rev !group)) !heads;
    others = List.rev !others;
  }

(* Values that no row covers, and the row that would cover them if it had no guards. *)
type gap = { values : value list; passed : int option }

let rec take n values taken =
  if n = 0 then (List.rev taken, values)
  else match values with v :: rest -> take (n - 1) rest (v :: taken) | [] -> (List.rev taken, [])

let rec gaps t used width lines =
  match lines with
  | [] -> some_of t [ { values = List.init width (fun _ -> Anything); passed = None } ]
  | _ when width = 0 -> reached t used lines
  | _ ->
      let { ty; groups; others = rest } = split lines in
      let below (h, lines) =
        let rebuilt gap =
          let parts, rest = take (arity h) gap.values [] in
          { gap with values = rebuild h parts :: rest }
        in
        map rebuilt (gaps t used (arity h + width - 1) lines)
      in
      let below = List.fold_left (fun found group -> append t found (below group)) none groups in
      let heads =
        match ty with
        | None -> some_of t [ Anything ]
        | Some ty -> others t ty (List.map fst groups)
      in
      if count heads = 0 then below
      else
        let beside value gap = { gap with values = value :: gap.values } in
        append t (pairs t beside heads (gaps t used (width - 1) rest)) below

(* No columns are left, so this selects the first row whose guards are true. *)
and reached t used = function
  | [] -> some_of t [ { values = []; passed = None } ]
  | line :: rest ->
      used.(line.index) <- true;
      if line.guards then
        map (fun gap -> { gap with passed = Some line.index }) (reached t used rest)
      else none

let check ?most t rows =
  let t = { t with most = Option.value most ~default:t.most } in
  let used = Array.make (List.length rows) false in
  let line index (row : row) = { index; guards = row.guarded; rest = [ row.pattern ] } in
  let gaps = gaps t used 1 (List.mapi line rows) in
  let useless = ref [] in
  Array.iteri (fun i used -> if not used then useless := i :: !useless) used;
  let shown gap = String.concat ", " (List.map show gap.values) in
  {
    missing =
      (if count gaps = 0 then None
       else Some { named = List.map shown gaps.first; more = gaps.besides });
    guarded_only = (match gaps.first with gap :: _ -> gap.passed | [] -> None);
    useless = List.rev !useless;
  }
