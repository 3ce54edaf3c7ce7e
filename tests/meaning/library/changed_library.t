The library's syntax trees are built into the compiler. If a module of the library was changed, the
compiler reads the file, and places in messages refer to that file.

  $ cp -rL "$(dirname "$(command -v frobc)")/../share" share
  $ chmod -R u+w share
  $ export FROB_HOME=.
  $ cat > main.frob <<EOF
  > import Control
  > main = proc x -> thrice x
  > EOF
  $ frobc check main.frob 2>&1 | head -n 1
  error[E0205]: unknown name `thrice`

  $ printf '\nthrice :: Float -> Float\nthrice x = 3 * x\n' >> share/frobc/stdlib/Control.frob
  $ frobc check main.frob

A mistake in it is shown at its line.

  $ { echo 'module Control where'; echo; echo 'four = 4 + true'; sed 1,/where/d share/frobc/stdlib/Control.frob; } > Control.frob
  $ mv Control.frob share/frobc/stdlib
  $ frobc check main.frob 2>&1 | sed -n '1,2p'
  error[E0205]: unknown name `true`
   --> stdlib/Control.frob:3:12
