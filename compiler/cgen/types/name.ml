open Basis

type kind = Identifiers | Members

type scope = {
  kind : kind;
  within : scope option;
  taken : unit String_table.t;
  counts : int String_table.t;  (** the last number that was appended to a name *)
}

let is_reserved kind name =
  C_names.is_taken name
  || match kind with Identifiers -> C_names.is_function name | Members -> false

let scope ?within ?(taken = []) kind =
  let table = String_table.create 16 in
  List.iter (fun name -> String_table.replace table name ()) taken;
  { kind; within; taken = table; counts = String_table.create 16 }

let rec is_taken_in scope name =
  String_table.mem scope.taken name
  || match scope.within with Some outer -> is_taken_in outer name | None -> false

let is_taken scope name = is_reserved scope.kind name || is_taken_in scope name

(* Removes leading, trailing and repeated underscores, because C and C++ reserve some names that
   contain them. *)
let tidy text =
  String.concat "_" (List.filter (fun part -> part <> "") (String.split_on_char '_' text))

let identifier text =
  let buffer = Buffer.create (String.length text) in
  String.iter
    (function
      | ('a' .. 'z' | 'A' .. 'Z' | '0' .. '9' | '_') as c -> Buffer.add_char buffer c
      | '\'' -> Buffer.add_string buffer "_prime"
      | _ -> Buffer.add_char buffer '_')
    text;
  match tidy (Buffer.contents buffer) with
  | "" -> "x"
  | name -> ( match name.[0] with '0' .. '9' -> "x" ^ name | _ -> name)

let snake text =
  let buffer = Buffer.create (String.length text) in
  String.iteri
    (fun k c ->
      match c with
      | 'A' .. 'Z' ->
          let after_lower =
            k > 0 && match text.[k - 1] with 'a' .. 'z' | '0' .. '9' -> true | _ -> false
          in
          if after_lower then Buffer.add_char buffer '_';
          Buffer.add_char buffer (Char.lowercase_ascii c)
      | c -> Buffer.add_char buffer c)
    text;
  identifier (Buffer.contents buffer)

let longest = 48

let short name =
  if String.length name <= longest then name
  else
    match String.rindex_from_opt name longest '_' with
    | Some k when k > longest / 2 -> String.sub name 0 k
    | Some _ | None -> String.sub name 0 longest

let rec numbered scope base separator =
  let count = 1 + Option.value (String_table.find_opt scope.counts base) ~default:0 in
  String_table.replace scope.counts base count;
  let name = String.concat separator [ base; string_of_int count ] in
  if is_taken scope name then numbered scope base separator else name

let fresh scope text =
  let name =
    if String.equal text "" then numbered scope "t" ""
    else
      let base = identifier text in
      (* A name that looks like a macro needs a prefix, because appending a number would not change
         that. *)
      let base = if C_names.is_macro_like base then "x_" ^ base else base in
      if is_taken scope base then (
        if not (String_table.mem scope.counts base) then String_table.replace scope.counts base 1;
        numbered scope base "_")
      else base
  in
  String_table.replace scope.taken name ();
  name
