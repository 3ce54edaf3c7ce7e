module M = Step.Ir
module V = Vocabulary

type t = {
  name : string;
  path : string;
  wide : bool;
  modes : string list;
  within : (int * int) option;
}

(* Arrays with more machines than this are omitted, because they would need too many columns to be
   readable. *)
let longest_array = 64

type search = {
  v : Program_names.t;
  names : Basis.Names.t;
  mutable found : t list;
  mutable count : int;
}

let join path name = if String.equal path "" then name else path ^ "." ^ name

(* [path]: the path to the struct that contains the node's state. [element]: the indices of the
   arrays on the path, such as [[2]]. *)
let rec node s k ~path ~element ~within =
  let node_ = s.v.program.nodes.(k) in
  let path_of (field : M.field) =
    join path (String.concat "." (Basis.Int_table.find s.v.nodes.(k).paths field.id))
  in
  let is_running (field : M.field) = field.content = Running_mode in
  let machine =
    match List.find_opt is_running node_.state with
    | None -> None
    | Some field ->
        s.found <-
          {
            name = Basis.Names.unique s.names (node_.origin ^ element);
            path = path_of field;
            wide = Array.length s.v.nodes.(k).modes > 256;
            modes =
              List.map
                (fun (m : Program_names.mode) -> m.member)
                (Array.to_list s.v.nodes.(k).modes);
            within;
          }
          :: s.found;
        s.count <- s.count + 1;
        Some (s.count - 1)
  in
  let rec field ~within (f : M.field) =
    match f.content with
    | Value _ | Running_mode | Component _ -> ()
    | State_of inner ->
        let is_here = V.home s.v inner = V.home s.v k in
        node s inner ~path:(if is_here then path else path_of f) ~element ~within
    | States_of { node = inner; count } when count <= longest_array ->
        for i = 0 to count - 1 do
          let number = Printf.sprintf "[%d]" i in
          node s inner ~path:(path_of f ^ number) ~element:(element ^ number) ~within
        done
    | States_of _ -> ()
    | Modes modes ->
        List.iteri
          (fun number mode ->
            let within = match machine with Some m -> Some (m, number) | None -> within in
            List.iter (field ~within) (Step.State.fields_of_mode mode))
          modes
  in
  List.iter (field ~within) node_.state

let of_program (v : Program_names.t) =
  let s = { v; names = Basis.Names.create (); found = []; count = 0 } in
  node s (Array.length v.program.nodes - 1) ~path:"" ~element:"" ~within:None;
  List.rev s.found
