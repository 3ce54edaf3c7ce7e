Conditions on the past, nested at random, have the results of RTAMT 0.4.10, a library for monitoring
signal temporal logic (`agree.py --store`; `make rtamt` compares a thousand new ones).

  $ frobc trace stored.frob --input stored.csv --engine interp | diff stored.expected -
  $ frobc trace stored.frob --input stored.csv | diff stored.expected -
