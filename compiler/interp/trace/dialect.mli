(** Reads recordings from other programs, which may use a different separator, a decimal comma, or
    other column names. The hosts have the same options (runtime/hosts/common/dialect.h) and the
    same messages. *)

type t = {
  separator : char;
  decimal_comma : bool;  (** whether numbers have a decimal comma, as in [0,5] *)
  time_column : string option;
      (** the name of the time column; [None] for the first column, which must be called [time] *)
  columns : (string * string) list;
      (** for each renamed column, its name in the program and its name in the recording *)
}

val ours : t

val names : t -> bool
(** Does the dialect name any columns? If so, unknown columns of the recording are ignored. *)

val arguments : t -> string list
(** The dialect as command-line options for a host. *)

val header : t -> string list -> (int * string list, string) result
(** The index of the time column in the recording, and the program's names for the columns, with
    [time] first. The error names the missing column. *)

val to_front : int -> 'a list -> 'a list
(** Moves the element at this index to the front of the list. *)

val cell : t -> string -> string
(** Replaces the decimal comma of a number with a decimal point. *)

(** {1 Hints for error messages}

    A hint is empty if no option would help. *)

val time_hint : t -> string list -> string
(** The hint for a header whose first column is not [time]. *)

val separator_hint : t -> string list -> string option
(** The part of {!time_hint} about a different separator. If the result is [Some], the header was
    split at the wrong places, so messages about other columns would be misleading. *)

val column_hint : missing:string -> unknown:string list -> string
(** The hint for a missing column, if the recording has unknown columns. *)

val width_hint : t -> width:int -> cells:int -> string
(** The hint for a row with [cells] cells where the header has [width] columns. *)

val number_hint : t -> string -> string
(** The hint for a cell that is not a number. *)
