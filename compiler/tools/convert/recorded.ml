type kind = Number | Truth | Words
type column = { name : string; kind : kind }

type t = {
  path : string;
  dialect : Interp.Dialect.t;
  params : (string * string) list;
  columns : column array;
  torn : string option;
}

exception Wrong of int * string

let wrong line format = Printf.ksprintf (fun text -> raise_notrace (Wrong (line, text))) format
let is_text line = String.for_all (fun c -> c >= ' ' || c = '\t') line

(* {1 Rows} *)

(* Cells of a trace contain no line feeds. *)
let split separator line =
  if not (String.contains line '"') then Ok (Array.of_list (String.split_on_char separator line))
  else
    let at = ref 0 in
    let read () =
      if !at = String.length line then None
      else (
        incr at;
        Some line.[!at - 1])
    in
    match Interp.Csv.next (Interp.Csv.reader ~separator read) with
    | Ok (Some row) -> Ok (Array.of_list (List.map (fun (c : Interp.Csv.cell) -> c.text) row.cells))
    | Ok None -> Ok [| "" |]
    | Error _ -> Error "a quoted cell does not end on its line, or follows a space"

let without_return line =
  let n = String.length line in
  if n > 0 && line.[n - 1] = '\r' then String.sub line 0 (n - 1) else line

let mark = "\xef\xbb\xbf"

let without_mark line =
  if String.starts_with ~prefix:mark line then String.sub line 3 (String.length line - 3) else line

(* Whether a column contains the time or a value of the program. If the dialect names columns, all
   other columns are ignored. *)
let is_ours name =
  name = "time"
  || List.exists
       (fun root ->
         name = root
         || List.exists (fun c -> String.starts_with ~prefix:(root ^ c) name) [ "."; "[" ])
       [ "in"; "out"; "mode"; "probe" ]

let check_name number k name =
  if not (is_text name) then
    wrong number "the name of column %d, `%s`, contains a control character: rename the column"
      (k + 1) (Basis.Printable.name name)

(* Calls [head] for each comment before the header, [header] for the header, and [row] for each row,
   together with its line. If the end of the file is missing, calls [damaged] with the reason. A row
   that is too short is an error, unless it is the last row, which may be truncated. *)
let read path ~(dialect : Interp.Dialect.t) ~damaged ~head ~header ~row =
  let read channel =
    let width = ref 0 and short = ref None and time_cell = ref 0 and kept = ref [] in
    let cells number line =
      let only_kept cells =
        if List.compare_lengths cells !kept <> 0 then cells
        else List.map snd (List.filter fst (List.combine !kept cells))
      in
      let translated cells =
        let cells = List.map (Interp.Dialect.cell dialect) (Array.to_list cells) in
        if !width > 0 then Array.of_list (only_kept (Interp.Dialect.to_front !time_cell cells))
        else
          match Interp.Dialect.header dialect cells with
          | Ok (time, names) ->
              time_cell := time;
              if Interp.Dialect.names dialect then kept := List.map is_ours names;
              Array.of_list (only_kept names)
          | Error text -> wrong number "%s" text
      in
      let split = split dialect.separator line in
      if dialect = Interp.Dialect.ours then split else Result.map translated split
    in
    let take number line =
      Option.iter (fun (number, text) -> wrong number "%s" text) !short;
      if line = "" then ()
      else if !width = 0 && line.[0] = '#' then head line
      else
        match cells number line with
        | _ when !width = 0 && String.contains line '\000' ->
            wrong number "not a recording: it is not a text file"
        | _ when !width = 0 && String.contains line '\r' -> wrong number "%s" Interp.Trace.returns
        | Error text -> short := Some (number, text)
        | Ok cells when !width = 0 ->
            if cells.(0) <> "time" then
              wrong number "not a recording: the first column must be `time`, not `%s`%s"
                (String.sub cells.(0) 0 (min 20 (String.length cells.(0))))
                (Interp.Dialect.time_hint dialect (Array.to_list cells));
            Array.iteri (check_name number) cells;
            width := Array.length cells;
            header line cells
        | Ok cells when Array.length cells <> !width ->
            let text =
              Printf.sprintf
                "wrong number of cells: the header has %d columns, but this row has %d%s" !width
                (Array.length cells)
                (Interp.Dialect.width_hint dialect ~width:!width ~cells:(Array.length cells))
            in
            (* A truncated row has fewer cells than the others. *)
            if Array.length cells > !width then wrong number "%s" text
            else short := Some (number, text)
        | Ok cells -> row number line cells
    in
    let text = Lines.of_channel channel in
    let rec lines number =
      match Lines.next text with
      | Some line ->
          let line = without_return line in
          take number (if number = 1 then without_mark line else line);
          lines (number + 1)
      | None -> ()
      | exception Lines.Too_long ->
          wrong number "the row is longer than %d MB: this is not a recording"
            (Lines.longest / 1024 / 1024)
      | exception Sys_error reason -> wrong number "cannot read the file: %s" reason
    in
    match lines 1 with
    | () when !width = 0 ->
        Error
          [ path ^ ": not a recording: the first line must name the columns, starting with `time`" ]
    | () ->
        Option.iter
          (fun (number, _) ->
            damaged (Printf.sprintf "its last line, line %d, is incomplete and was omitted" number))
          !short;
        Ok ()
    | exception Wrong (line, text) -> Error [ Printf.sprintf "%s:%d: %s" path line text ]
  in
  Result.map_error (String.concat "\n") (Packed.with_input ~damaged path read)

(* {1 Contents} *)

let is_number text =
  match text.[0] with
  | '0' .. '9' | '+' | '-' | '.' | 'n' | 'N' | 'i' | 'I' -> (
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

let survey ~dialect path =
  let params = ref [] and names = ref [||] and kinds = ref [||] and torn = ref None in
  let see line column text =
    if text <> "" then (
      let kind = kind_of text in
      if kind = Number && Interp.Cell.overflows text then
        wrong line "column `%s`: expected %s, found `%s`" !names.(column)
          (Interp.Cell.largest Double) text;
      match !kinds.(column) with
      | None -> !kinds.(column) <- Some kind
      | Some before -> if before <> kind then !kinds.(column) <- Some Words)
  in
  let header _ cells =
    names := cells;
    kinds := Array.map (fun _ -> None) cells
  in
  read path ~dialect
    ~damaged:(fun reason -> torn := Some reason)
    ~head:(fun line -> params := Option.to_list (param line) @ !params)
    ~header
    ~row:(fun line _ cells -> Array.iteri (see line) cells)
  |> Result.map (fun () ->
         let column k name = { name; kind = Option.value !kinds.(k) ~default:Number } in
         let params = List.rev !params and columns = Array.mapi column !names in
         { path; dialect; params; columns; torn = !torn })

let iter t run =
  let before = ref 0 in
  let row line _ cells =
    match Interp.Trace.nanoseconds cells.(0) with
    | None ->
        wrong line "`%s` is not a time in seconds%s%s" cells.(0)
          (Interp.Dialect.number_hint t.dialect cells.(0))
          (Interp.Trace.too_far cells.(0))
    | Some time when time < 0 ->
        wrong line "the time %s is before 0, which MCAP cannot represent" cells.(0)
    | Some time when time < !before ->
        wrong line "the time goes backwards: `%s` comes after a later time" cells.(0)
    | Some time ->
        before := time;
        run ~time cells
  in
  read t.path ~dialect:t.dialect ~damaged:ignore ~head:ignore ~header:(fun _ _ -> ()) ~row

let quoted cell =
  if String.contains cell ',' || String.contains cell '"' then
    "\"" ^ String.concat "\"\"" (String.split_on_char '"' cell) ^ "\""
  else cell

let lines t run =
  let written line cells =
    if t.dialect = Interp.Dialect.ours then line
    else String.concat "," (List.map quoted (Array.to_list cells))
  in
  read t.path ~dialect:t.dialect ~damaged:ignore ~head:run
    ~header:(fun line cells -> run (written line cells))
    ~row:(fun _ line cells -> run (written line cells))
