(** Whole nanoseconds in a time, as the library's [nanoseconds] computes them
    of seconds:

    {[ if ns < big then (ns + big) - big else ns
       where ns = max 0 (seconds * 1e9) ]}

    with [big] = 2^52, or 2^23 in single precision. Local time is kept in nanoseconds, so
    of local time they are mostly just what is kept. *)

open Basis

val nanoseconds : Real.t -> float -> float
(** Of a time in seconds. *)

val exact_below : int64
(** In double precision: fewer nanoseconds than that, divided by 10^9 to be seconds, are what
    {!nanoseconds} of these gives. (Two roundings are off by less than half a
    nanosecond up to 2^51.) *)

val reaches : Real.t -> float -> int64 option
(** The least local time whose nanoseconds are at least that number; [None] if
    none are. *)

val recognize : Real.t -> (Ir.atom -> Ir.rhs option) -> Ir.rhs -> Ir.rhs
(** [Time Nanoseconds] for what computes them of [Time Seconds], given the
    definitions of signals; else the same. *)
