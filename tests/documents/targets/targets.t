`make targets` runs each target of the Makefile in a short form, except targets that only prepare
others, `make test`, which has its own tests, and `clean`.

  $ top=../../..
  $ sed -n 's/^\.PHONY: *//p' $top/Makefile | tr ' ' '\n' | grep -vx 'all\|setup\|test\|targets\|clean' | sort > targets
  $ sh $top/tests/targets.sh --list | cut -d ' ' -f 1 | sort | diff targets -

Each rule has a short form or is excluded, and make accepts each short form.

  $ sed -n 's/^\([a-z][a-z-]*\):.*/\1/p' $top/Makefile | grep -vx 'all\|setup\|test\|targets\|clean' | sort -u | diff targets -
  $ sh $top/tests/targets.sh --list | while read -r form; do make -n -C $top $form > said 2>&1 || cat said; done

`make matrix` and `make prove` use each example, but not its test file, which has no `main`.

  $ for target in matrix prove; do make -n -C $top $target > said; grep -c 'examples/bug/bug\.frob' said; grep -o '[^ ]*\.test\.frob' said; done
  1
  1
  [1]

An unknown name is reported.

  $ sh $top/tests/targets.sh none
  FAIL none: add a short form of it to tests/targets.sh
  0 passed, 1 failed
  [1]
