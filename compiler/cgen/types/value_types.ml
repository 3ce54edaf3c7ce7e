module F = Flow.Ir
module M = Step.Ir

type owner = Program | Robot | Foreign_code

type known = {
  program : F.sum array;
  sum_owners : owner array;
  array_owners : (M.ty, owner) Hashtbl.t;
      (** owners of the array types that the program does not own *)
}

type t = {
  known : known;
  real : Basis.Real.t;
  name : string;
  scope : Name.scope;
  sums : Sum_type.t array;
  names : (M.ty, string) Hashtbl.t;  (** names of array structs *)
  mutable met : M.ty list;  (** arrays in use, newest first *)
  beside : t option;  (** the program's own table, if this table is for the user's C code *)
}

let is_array (ty : M.ty) =
  match ty with Array _ -> true | Bool | Int | Float | Nanoseconds | Sum _ | Foreign _ -> false

let foreign_type (ty : F.foreign_type) : Ir.ty =
  if ty.copyable then Named ty.c_type else Pointer_to_const (Named ty.c_type)

(* {1 Owners} *)

let known program =
  {
    program;
    sum_owners = Array.make (Array.length program) Program;
    array_owners = Hashtbl.create 4;
  }

let mark known owner shape =
  let rec ty : F.ty -> unit = function
    | Sum k ->
        if known.sum_owners.(k) = Program then known.sum_owners.(k) <- owner;
        List.iter
          (fun (slot, _) ->
            let array = Step.Layout.ty slot in
            if is_array array && not (Hashtbl.mem known.array_owners array) then
              Hashtbl.replace known.array_owners array owner;
            ty slot)
          (Step.Layout.sum known.program k).arrays
    | Array (_, element) -> ty element
    | Bool | Int | Float | Foreign _ -> ()
  in
  List.iter ty (Flow.Shape.leaves shape)

let marked t (ty : M.ty) =
  match ty with
  | Sum k -> t.known.sum_owners.(k)
  | ty -> Option.value (Hashtbl.find_opt t.known.array_owners ty) ~default:Program

let differ t ty = t.real = Single && Step.Block.numbers t.known.program ty > 0

(* Whether the type belongs to this table rather than to the program's own table. *)
let is_here t ty =
  match t.beside with None -> true | Some own -> marked t ty <> Program && differ own ty

(* Robots and foreign code only use doubles, so types that contain floats belong to the program. *)
let owner t ty = if differ t ty then Program else marked t ty

(* {1 Names} *)

(* The prefix of a type's name. Types that other code also uses have the prefix [frob]. *)
let prefix t ty = match owner t ty with Program -> t.name | Robot | Foreign_code -> "frob"

let rec array_name t (ty : M.ty) =
  match (Hashtbl.find_opt t.names ty, t.beside) with
  | Some name, _ -> name
  | None, Some own when not (is_here t ty) -> array_name own ty
  | None, _ ->
      (* Defines the type of the elements as well. *)
      (match ty with
      | Array (_, (Array _ as element)) -> ignore (array_name t element : string)
      | Array _ | Bool | Int | Float | Nanoseconds | Sum _ | Foreign _ -> ());
      let name = Name.fresh t.scope (prefix t ty ^ "_" ^ Array_type.name t.known.program ty) in
      Hashtbl.replace t.names ty name;
      t.met <- ty :: t.met;
      name

let sum_type t k sum =
  let slots = Step.Layout.sum t.known.program k in
  let array (ty, _) =
    match Step.Layout.ty ty with
    | Foreign foreign -> (ty, foreign_type foreign)
    | array -> (ty, Ir.Struct (array_name t array))
  in
  Sum_type.name t.scope ~prefix:(prefix t (Sum k)) ~real:t.real sum ~slots
    ~arrays:(List.map array slots.arrays)

let own scope ~name ~real known =
  let t =
    { known; real; name; scope; sums = [||]; names = Hashtbl.create 16; met = []; beside = None }
  in
  let sums = Array.mapi (sum_type t) known.program in
  { t with sums }

let of_foreign_code own =
  match own.real with
  | Double -> own
  | Single ->
      let t = { own with real = Double; names = Hashtbl.create 4; met = []; beside = Some own } in
      let sum k declared = if is_here t (Sum k) then sum_type t k declared else own.sums.(k) in
      let sums = Array.mapi sum own.known.program in
      { t with sums }

let sums t = t.sums

let ty t (ty : M.ty) : Ir.ty =
  match ty with
  | Array _ -> Struct (array_name t ty)
  | Bool -> Bool
  | Int -> Int32
  | Float -> Real t.real
  | Nanoseconds -> Int64
  | Sum k -> Struct t.sums.(k).struct_name
  | Foreign foreign -> foreign_type foreign

let arrays t = List.rev_map (fun ty -> (ty, Hashtbl.find t.names ty)) t.met

(* {1 Definitions} *)

(* A type that the user's C code uses may be defined by several programs and by the user's own
   header. *)
let defined struct_name = String.uppercase_ascii struct_name ^ "_DEFINED"

let once struct_name declarations =
  let guard = defined struct_name in
  (Ir.Text (Printf.sprintf "#ifndef %s\n#define %s\n" guard guard) :: declarations)
  @ [ Ir.Text "#endif\n" ]

let shared_once owner struct_name declarations =
  match owner with Program | Robot -> declarations | Foreign_code -> once struct_name declarations

type definition = {
  struct_name : string;
  parts : string list;  (** the structs that it contains, and those of the sums in its payload *)
  declarations : Ir.declaration list;
}

(* A sum in the payload is flattened into the struct, but code that reads the payload needs the
   names of the sum's tags. *)
let inner_sums t (sum : F.sum) =
  let inner : F.ty -> string option = function
    | Sum k -> Some t.sums.(k).struct_name
    | Bool | Int | Float | Array _ | Foreign _ -> None
  in
  List.concat_map
    (fun constructor -> List.filter_map inner (Flow.Shape.payload constructor))
    sum.constructors

(* Each type comes after the types that it consists of. *)
let definitions t ~of_:wanted =
  let sums = t.known.program in
  let done_ = Hashtbl.create 16 and definitions = ref [] in
  let define ?(inner = []) ty struct_name declarations =
    let owner = owner t ty in
    if wanted owner then
      let parts = inner @ Mentioned.structs declarations in
      let declarations = shared_once owner struct_name declarations in
      definitions := { struct_name; parts; declarations } :: !definitions
  in
  let rec add (type_ : M.ty) =
    if is_here t type_ && not (Hashtbl.mem done_ type_) then (
      Hashtbl.replace done_ type_ ();
      match type_ with
      | Sum k ->
          let own = t.sums.(k) in
          List.iter (fun (slot, _) -> add (Step.Layout.ty slot)) own.slots.arrays;
          define type_ own.struct_name
            ~inner:(inner_sums t sums.(k))
            (Sum_type.definition sums sums.(k) own)
      | Array (count, element) ->
          add element;
          let name = array_name t type_ in
          define type_ name [ Array_type.definition name ~count ~element:(ty t element) ]
      | Bool | Int | Float | Nanoseconds | Foreign _ -> ())
  in
  Array.iteri (fun k _ -> add (Sum k)) t.sums;
  List.iter (fun (array, _) -> add array) (arrays t);
  List.rev !definitions

let reached definitions ~from =
  let wanted = Hashtbl.create 16 in
  let want name = Hashtbl.replace wanted name () in
  List.iter want from;
  let is_wanted d = Hashtbl.mem wanted d.struct_name in
  (* Parts precede the structs that contain them, except for sums in a payload, which may come
     later. *)
  let rec spread () =
    let before = Hashtbl.length wanted in
    List.iter (fun d -> if is_wanted d then List.iter want d.parts) (List.rev definitions);
    if Hashtbl.length wanted > before then spread ()
  in
  spread ();
  List.partition is_wanted definitions

let declarations definitions = List.concat_map (fun d -> d.declarations) definitions
