(** Compiler messages as values.

    A pass builds diagnostics, emits them into a sink, and continues if it can. {!Render_text} and
    {!Render_json} print them. A page in [compiler/explain/] explains each code. Messages start in
    lower case, do not end with a full stop, and put names from the program in backticks. *)

type severity = Error | Warning

type text
(** Text for users. Code that needs to know what a message says uses the message's topics instead.
*)

val for_display : text -> string
(** A test checks that only renderers and the language server call this function. *)

type topic = ..
(** The subject of a message or of a hint, for the rules that need to know whether it has been
    mentioned. Topics are compared with [=]. *)

type label = { at : Span.t; text : text }
(** Another place involved in the problem. *)

type hint = { text : text; topic : topic option }

type edit = { span : Span.t; text : string }
(** Replaces the text in the span. If the span is empty, inserts the text at its position. *)

type fix = {
  title : text;  (** the effect of the fix, as an imperative: [write `speed`] *)
  edits : edit list;  (** non-overlapping edits in one file *)
  safe : bool;
      (** whether a tool may apply the fix without asking: true only if there is no alternative and
          the fix does not change what the program computes; editors only offer the other fixes *)
}
(** A correction that a tool can apply. *)

type t = {
  severity : severity;
  code : string;  (** for example [E0401]; codes of warnings start with [W] *)
  at : Span.t;  (** the main place, where the user should look first *)
  message : text;
  here : text option;  (** printed next to the main place *)
  labels : label list;
  notes : text list;
  hints : hint list;  (** suggested corrections, each of which is probably right *)
  fixes : fix list;  (** the hints that a tool can apply, as edits *)
  about : topic list;  (** the topics of the message, the labels and the notes *)
}

val error : code:string -> at:Span.t -> ('a, Format.formatter, unit, t) format4 -> 'a
val warning : code:string -> at:Span.t -> ('a, Format.formatter, unit, t) format4 -> 'a

(** The functions below extend a diagnostic: [error … "…" |> label ~at "…" |> emit sink]. *)

type 'a extend := ('a, unit, string, t -> t) format4 -> 'a

val here : 'a extend
val label : at:Span.t -> 'a extend
val note : 'a extend
val hint : ?topic:topic -> 'a extend

val message : 'a extend
(** Replaces the message. *)

val fix : ?safe:bool -> string -> (Span.t * string) list -> t -> t
(** [fix title edits] adds a fix that replaces the text at each place. It is not [safe] by default.
*)

val write : Span.t -> string -> t -> t
(** Adds a fix that replaces the text at this place, with the title [write `…`]. *)

(** {1 Topics} *)

val suggestion : ?topic:topic -> ('a, unit, string, hint) format4 -> 'a
(** A hint, for rules that do not build the whole diagnostic. *)

val suggest : hint -> t -> t
val about : topic -> t -> t

val topics : t -> topic list
(** The topics of the diagnostic and of its hints. *)

(** {1 Comparing} *)

val is_same : t -> t -> bool
(** Do both have the same code and place? *)

val has_same_effect : fix -> fix -> bool
(** Do both have the same title? *)

type wording
(** The code, message, notes and hints. Wordings can be compared with [=] and hashed. *)

val wording : ?without_hints:bool -> t -> wording

(** {1 Collecting} *)

type sink
(** Collects diagnostics. A sink has no other state. *)

val sink : unit -> sink
val emit : sink -> t -> unit
val has_errors : sink -> bool

val errors : sink -> sink
(** A new sink with the errors of this sink, but without its warnings. *)

val all : sink -> t list
(** All diagnostics, sorted by place, without duplicates (same code and place). *)

exception Bug of { stage : string; message : string }
(** An internal error: the compiler violated one of its invariants. The user's program is never at
    fault. *)

val bug : stage:string -> ('a, Format.formatter, unit, 'b) format4 -> 'a
(** @raise Bug always *)
