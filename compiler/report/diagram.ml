let quoted text =
  let out = Buffer.create 32 in
  String.iter
    (function
      | ('"' | '\\') as c ->
          Buffer.add_char out '\\';
          Buffer.add_char out c
      | '\n' -> Buffer.add_string out "\\n"
      | c -> Buffer.add_char out c)
    text;
  "\"" ^ Buffer.contents out ^ "\""

(* Machines and states are identified by numbers; the number of a state is unique within its
   machine. *)
let start number = Printf.sprintf "start%d" number
let any number = Printf.sprintf "any%d" number
let state number mode = Printf.sprintf "state%d_%d" number mode

let attributes list =
  match List.filter (fun (_, value) -> value <> "") list with
  | [] -> ""
  | list ->
      let one (name, value) = name ^ "=" ^ value in
      Printf.sprintf " [%s]" (String.concat ", " (List.map one list))

let arrow ppf number (a : Machines.arrow) =
  let from =
    match a.source with Start -> start number | Any -> any number | State k -> state number k
  in
  Format.fprintf ppf "    %s -> %s%s;@." from (state number a.target)
    (attributes
       [
         ("label", if a.label = "" then "" else quoted a.label);
         ("style", if a.may_be_immediate then "dashed" else "");
         ("arrowhead", if a.delayed then "onormal" else "");
       ])

let machine ppf number (m : Machines.t) =
  Format.fprintf ppf "  subgraph cluster%d {@.    label=%s;@." number (quoted m.title);
  Format.fprintf ppf "    %s [shape=point];@." (start number);
  List.iteri
    (fun k (s : Machines.state) ->
      Format.fprintf ppf "    %s [label=%s];@." (state number k) (quoted (s.name ^ "\n" ^ s.place)))
    m.states;
  let starts, others =
    List.partition (fun (a : Machines.arrow) -> a.source = Machines.Start) m.arrows
  in
  List.iter (arrow ppf number) starts;
  if List.exists (fun (a : Machines.arrow) -> a.source = Machines.Any) others then
    Format.fprintf ppf "    %s [label=any, shape=plaintext];@." (any number);
  List.iter (arrow ppf number) others;
  Format.fprintf ppf "  }@."

let print ppf ~name machines =
  Format.fprintf ppf "digraph %s {@.  node [shape=box, style=rounded];@." (quoted name);
  List.iteri (machine ppf) machines;
  List.iteri
    (fun number (m : Machines.t) ->
      List.iteri
        (fun k (s : Machines.state) ->
          List.iter
            (fun inner ->
              Format.fprintf ppf "  %s -> %s [style=dotted, arrowhead=none];@." (state number k)
                (start inner))
            s.inside)
        m.states)
    machines;
  Format.fprintf ppf "}@."
