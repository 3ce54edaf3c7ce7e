The library and the examples have no warnings.

  $ for file in $(find -L ../../../../stdlib ../../../../examples -name '*.frob' | sort); do
  >     (cd $(dirname $file) && frobc check $(basename $file) 2>&1) | grep '^warning' -A 1
  > done
  [1]
