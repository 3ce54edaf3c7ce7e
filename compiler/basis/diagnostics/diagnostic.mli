(** What the compiler has to say to the programmer, as values.

    A pass builds diagnostics and emits them into a sink, and goes on where it can; {!Render_text}
    and {!Render_json} print them. The code of each is explained by a page of [compiler/explain/].
    Texts are lower case, without a full stop, with names of the program in backticks. *)

type severity = Error | Warning

type label = { at : Span.t; text : string }
(** Another place that takes part. *)

type edit = { span : Span.t; text : string }
(** What is there becomes the text; an empty span is a place between two characters. *)

type fix = {
  title : string;  (** what it does, as an order: [write `speed`] *)
  edits : edit list;  (** in one file, none over another *)
  safe : bool;
      (** nothing else can have been meant, and what a program computes stays: it may be made
          unasked. Others an editor offers. *)
}
(** A cure that a tool can carry out. *)

type t = {
  severity : severity;
  code : string;  (** such as [E0401]; warnings start with [W] *)
  at : Span.t;  (** the one place to look at first *)
  message : string;
  here : string;  (** written beside the main place; may be empty *)
  labels : label list;
  notes : string list;
  hints : string list;  (** cures, each likely to be right *)
  fixes : fix list;  (** those of the hints that say what to write instead *)
}

val error : code:string -> at:Span.t -> ('a, Format.formatter, unit, t) format4 -> 'a
val warning : code:string -> at:Span.t -> ('a, Format.formatter, unit, t) format4 -> 'a

(** The rest adds to a diagnostic: [error … "…" |> label ~at "…" |> emit sink]. The texts are plain
    strings; use [Printf.sprintf] where they vary. *)

val here : string -> t -> t
val label : at:Span.t -> string -> t -> t
val note : string -> t -> t
val hint : string -> t -> t

val fix : ?safe:bool -> string -> (Span.t * string) list -> t -> t
(** [fix title edits]: each place with its new text; not safe unless said so. *)

val write : Span.t -> string -> t -> t
(** The fix that writes this text there, instead of what is there. *)

type sink
(** Collects diagnostics. Its only state is what was emitted. *)

val sink : unit -> sink
val emit : sink -> t -> unit
val last : sink -> t option

val revise_last : sink -> (t -> t) -> unit
(** Says more of what was emitted last, where more has come to be known. *)

val has_errors : sink -> bool

val all : sink -> t list
(** Everything emitted, by place; repeated ones (same code and place) once. *)

exception Bug of { stage : string; message : string }
(** A broken promise of the compiler's own: never the programmer's fault. *)

val bug : stage:string -> ('a, Format.formatter, unit, 'b) format4 -> 'a
(** Raises {!Bug}. *)
