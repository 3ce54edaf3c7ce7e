open Basis

let words text = String.split_on_char '.' text
let is_number word = word <> "" && String.for_all (fun c -> '0' <= c && c <= '9') word

let rec is_end wanted whole =
  wanted = whole || match whole with [] -> false | _ :: rest -> is_end wanted rest

(* The path to the instance, and this path extended by one word of the signal's name at a time. *)
let ways (p : Catalogue.probe) =
  let instance = List.concat_map words p.whole in
  let further ways word = (List.hd ways @ [ word ]) :: ways in
  List.fold_left further [ instance ] (words p.signal)

let is_meant wanted (p : Catalogue.probe) =
  let without way = List.filter (fun word -> not (is_number word)) way in
  let is_it way = is_end wanted way || is_end wanted (without way) in
  match List.rev (ways p) with
  | [] -> false
  | instance :: signal -> (is_it instance && not p.handed_down) || List.exists is_it signal

let candidates probes =
  let names (p : Catalogue.probe) =
    let without = List.filter (fun word -> not (is_number word)) (words p.name) in
    p.name :: p.signal :: String.concat "." without :: List.concat_map words p.whole
  in
  List.sort_uniq String.compare (List.concat_map names probes)

let claims = "assert"
let margins = "margin"
let is_margin (p : Catalogue.probe) = Core.Margin.is_column p.signal
let is_claim (p : Catalogue.probe) = Resolve.Labels.is_name p.signal
let prefix = "probe."

let find probes names =
  let plain name =
    if String.starts_with ~prefix name then
      String.sub name (String.length prefix) (String.length name - String.length prefix)
    else name
  in
  let rec all wanted = function
    | [] ->
        let is_wanted p = List.exists (fun meant -> meant p) wanted in
        Ok (List.filter is_wanted probes)
    | "all" :: rest -> all ((fun (p : Catalogue.probe) -> not p.handed_down) :: wanted) rest
    | name :: rest when name = claims -> all (is_claim :: wanted) rest
    | name :: rest when name = margins -> all (is_margin :: wanted) rest
    | name :: rest ->
        let meant =
          let exact (p : Catalogue.probe) = String.equal p.name (plain name) in
          if List.exists exact probes then exact else is_meant (words (plain name))
        in
        if List.exists meant probes then all (meant :: wanted) rest
        else Error (name, Suggest.closest (plain name) (candidates probes))
  in
  all [] names
