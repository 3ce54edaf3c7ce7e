type kind = Number | Truth | Words
type column = { name : string; kind : kind }

type t = {
  path : string;
  params : (string * string) list;
  columns : column array;
  torn : string option;
}

exception Wrong of int * string

let wrong line format = Printf.ksprintf (fun text -> raise_notrace (Wrong (line, text))) format
let is_text line = String.for_all (fun c -> c >= ' ' || c = '\t') line

(* {1 Rows} *)

(* No cell of a trace has a line feed in it. *)
let cells line =
  if not (String.contains line '"') then Ok (Array.of_list (String.split_on_char ',' line))
  else
    let at = ref 0 in
    let read () =
      if !at = String.length line then None
      else (
        incr at;
        Some line.[!at - 1])
    in
    match Interp.Csv.next (Interp.Csv.reader read) with
    | Ok (Some row) -> Ok (Array.of_list (List.map (fun (c : Interp.Csv.cell) -> c.text) row.cells))
    | Ok None -> Ok [| "" |]
    | Error _ -> Error "a quoted cell that does not end in its line, or begins behind a blank"

let without_return line =
  let n = String.length line in
  if n > 0 && line.[n - 1] = '\r' then String.sub line 0 (n - 1) else line

let mark = "\xef\xbb\xbf"

let without_mark line =
  if String.starts_with ~prefix:mark line then String.sub line 3 (String.length line - 3) else line

(* Calls [head] for comments before the header, [header] for that, and [row] for the rows, each
   with its line; [damaged] if the end is missing, with the reason, or a better one. The last row
   is torn where it is too short: nobody knows before there is no other. *)
let read path ~damaged ~head ~header ~row =
  let read channel =
    let width = ref 0 and short = ref None in
    let take number line =
      Option.iter (fun (number, text) -> wrong number "%s" text) !short;
      if line = "" then ()
      else if !width = 0 && line.[0] = '#' then head line
      else
        match cells line with
        | _ when !width = 0 && not (is_text line) -> wrong number "not a recording: it is no text"
        | Error text -> short := Some (number, text)
        | Ok cells when !width = 0 ->
            if cells.(0) <> "time" then
              wrong number "not a recording: its first column is `time`, not `%s`"
                (String.sub cells.(0) 0 (min 20 (String.length cells.(0))));
            width := Array.length cells;
            header line cells
        | Ok cells when Array.length cells <> !width ->
            let text =
              Printf.sprintf "the header names %d columns, but cells in this row: %d" !width
                (Array.length cells)
            in
            short := Some (number, text)
        | Ok cells -> row number line cells
    in
    let rec lines number =
      match input_line channel with
      | line ->
          let line = without_return line in
          take number (if number = 1 then without_mark line else line);
          lines (number + 1)
      | exception End_of_file -> ()
      | exception Sys_error reason -> wrong number "cannot read the file: %s" reason
    in
    match lines 1 with
    | () when !width = 0 ->
        Error [ path ^ ": not a recording: there is no line that names its columns, `time` first" ]
    | () ->
        Option.iter
          (fun (number, _) ->
            damaged (Printf.sprintf "line %d, its last, is torn and left out" number))
          !short;
        Ok ()
    | exception Wrong (line, text) -> Error [ Printf.sprintf "%s:%d: %s" path line text ]
  in
  Result.map_error (String.concat "\n") (Packed.with_input ~damaged path read)

(* {1 What is in it} *)

let is_number text =
  match text.[0] with
  | '0' .. '9' | '+' | '-' | '.' | 'n' | 'i' -> (
      match float_of_string_opt text with
      | Some _ -> not (String.contains text '_' || String.contains text 'x')
      | None -> false)
  | _ -> false

let kind_of text =
  if is_number text then Number else if text = "true" || text = "false" then Truth else Words

let param line =
  let prefix = "# param " in
  if not (String.starts_with ~prefix line) then None
  else
    match String.index_opt line '=' with
    | Some i ->
        let n = String.length prefix in
        Some (String.sub line n (i - n), String.sub line (i + 1) (String.length line - i - 1))
    | None -> None

let survey path =
  let params = ref [] and names = ref [||] and kinds = ref [||] and torn = ref None in
  let see column text =
    if text <> "" then
      let kind = kind_of text in
      match !kinds.(column) with
      | None -> !kinds.(column) <- Some kind
      | Some before -> if before <> kind then !kinds.(column) <- Some Words
  in
  let header _ cells =
    names := cells;
    kinds := Array.map (fun _ -> None) cells
  in
  read path
    ~damaged:(fun reason -> torn := Some reason)
    ~head:(fun line -> params := Option.to_list (param line) @ !params)
    ~header
    ~row:(fun _ _ cells -> Array.iteri see cells)
  |> Result.map (fun () ->
         let column k name = { name; kind = Option.value !kinds.(k) ~default:Number } in
         { path; params = List.rev !params; columns = Array.mapi column !names; torn = !torn })

let iter t run =
  let before = ref 0 in
  let row line _ cells =
    match Interp.Trace.nanoseconds cells.(0) with
    | None -> wrong line "`%s` is not a time in seconds" cells.(0)
    | Some time when time < 0 -> wrong line "the time %s is before 0, which MCAP has not" cells.(0)
    | Some time when time < !before ->
        wrong line "time goes back: `%s` comes after a later time" cells.(0)
    | Some time ->
        before := time;
        run ~time cells
  in
  read t.path ~damaged:ignore ~head:ignore ~header:(fun _ _ -> ()) ~row

let lines t run =
  read t.path ~damaged:ignore ~head:run
    ~header:(fun line _ -> run line)
    ~row:(fun _ line _ -> run line)
