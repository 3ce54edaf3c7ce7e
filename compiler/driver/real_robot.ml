let ( let* ) result continue =
  match result with Ok value -> continue value | Error text -> Commands.wrong_use text

let option name value = match value with Some value -> [ name; value ] | None -> []
let seconds = Printf.sprintf "%.9f"

type serve = {
  world : string option;
  seed : int;
  tcp : int option;
  duration : float option;
  model : string option;
  log : string option;
  link : string option;
}

let missing host = Printf.sprintf "the host %s is missing: install frobc again" host

let become host arguments =
  match Process.become host arguments with Not_found _ | Failed _ -> Commands.wrong_use (missing host)

let serve ~robot serve =
  let* resources = Resources.find () in
  let* _ = Robots.known robot in
  let world =
    Option.value serve.world ~default:(Filename.concat resources.worlds "room.toml")
  in
  become resources.server
    ([ "--world"; world; "--seed"; string_of_int serve.seed ]
    @ option "--robot" robot
    @ option "--tcp" (Option.map string_of_int serve.tcp)
    @ option "--for" (Option.map seconds serve.duration)
    @ option "--model" serve.model
    @ option "--log" serve.log
    @ option "--link" serve.link)
