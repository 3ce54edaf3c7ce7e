(** The options that commands share, what they ask of the compiler, and what all commands tell on
    standard error. *)

type format = Text | Json

(** What is done with the assertions of a program. *)
type asserts =
  | Off  (** nothing of them is compiled *)
  | Count  (** they are judged, and what became of them is told *)
  | Stop  (** and the first that is violated ends the run *)
  | Margin  (** they are judged, and it is shown how nearly each held *)

type t = {
  format : format;  (** of diagnostics, and of a report *)
  dump : Stage.t option;
  stop_after : Stage.t option;
  lint : bool;
  specialization_limit : int;
  real : Basis.Real.t;  (** the precision of [Float] *)
  robot : string option;  (** the robot to compile for, where the program leaves it open *)
  probes : string list;  (** inner signals to be seen, as {!Probe.Selection} takes them *)
  asserts : asserts;
  params : string list;  (** values of the program's parameters, [NAME=VALUE] each *)
}

val with_params : t -> Resources.t -> entry:string -> string -> (Params.set list -> int) -> int
(** Goes on with what the program's parameters are set to; a wrong setting is told. *)

val param_options : Params.set list -> string list
(** For a host. *)

val assert_options : t -> string list
(** For a host. *)

val request :
  t -> ?robot:Robots.t -> ?entry:string -> ?batch:bool -> library:string -> string -> Request.t
(** What these options ask of the compiler for a file. *)

val status : Basis.Diagnostic.sink -> int
(** The exit status of a command that went as far as it could. *)

val wrong_use : string -> int
(** Says what is wrong with the call, and not with the program. *)

val ( let* ) : ('a, string) result -> ('a -> int) -> int
(** Goes on with a value, or says what is wrong with the call. *)

val colour : unit -> bool
(** Whether standard error shows colours, and these are wanted. *)

val print_diagnostics : format -> Basis.Source.t -> Basis.Diagnostic.sink -> unit
(** On standard error. *)

val report_bug : string -> string -> int
(** [report_bug stage message] says that it is a fault of the compiler's own. *)

val report_exception : exn -> int
(** Says what ended the command: what the system refused, which is {!Exit_status.wrong_use}, or a
    fault of the compiler's own, {!Exit_status.bug}. *)
