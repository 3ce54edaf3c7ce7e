(** The contents of a sweep's plan file. Numbers with units are not parsed yet. *)

type 'a placed = { place : string;  (** [FILE:LINE:COLUMN] *) value : 'a }

type variation =
  | Range of { low : string; high : string; steps : int  (** 0 if the values are sampled *) }
  | Values of string list

type sampling = Grid | Random | Latin

type t = {
  program : string placed;
  trial : string placed option;  (** label of the trial; [None] if the program has only one *)
  seeds : (int * int) option;  (** [None]: the trial's own seeds *)
  lasts : float option;  (** [None]: the trial's own duration *)
  rate : float option;  (** in Hz; 50 if [None] *)
  worlds : string placed list;
  robots : string placed list;
  sampling : sampling;
  points : int;  (** the number of points, if the points are sampled *)
  sampling_seed : int;
  params : (string * variation) placed list;
}
