lintian reports no errors and no warnings about the Debian packages frobc and frobc-doc.

  $ sh ../../../compiler/package/deb.sh $(dirname $(which frobc))/.. packages > built
  $ deb=$(head -n 1 built); doc=$(tail -n 1 built)
  $ [ $deb = $PWD/packages/frobc_$(frobc --version)_$(dpkg --print-architecture).deb ] || echo $deb
  $ [ $(dpkg-deb -f $deb Version) = $(frobc --version) ] || dpkg-deb -f $deb Version
  $ if command -v lintian > /dev/null; then lintian --fail-on error,warning $deb $doc 2>&1 | grep -v 'root privileges' || true; fi
  $ dpkg-deb -f $deb Depends Recommends | grep -o -e 'libbox2d' -e 'libcairo2 ' -e 'gcc | c-compiler'
  libbox2d
  libcairo2 
  gcc | c-compiler

When it is unpacked into a folder in place of the root, its compiler runs the wall follower in the
package, with the library and the simulator that are next to it.

  $ [ $doc = $PWD/packages/frobc-doc_$(frobc --version)_all.deb ] || echo $doc
  $ dpkg-deb -f $doc Section Architecture
  Section: doc
  Architecture: all
  $ dpkg-deb -x $deb root && dpkg-deb -x $doc root
  $ PATH=$PWD/root/usr/bin:$PATH
  $ cp -R root/usr/share/doc/frobc/examples/wall_follow . && cd wall_follow
  $ frobc run wall_follow.frob --for 20s --picture run.png | head -4; ls
  time simulated: 20.000 s
  distance driven: 6.365 m
  wall distance to keep: 0.200 m
  mean wall distance error: 0.0196 m
  README.md
  run.png
  wall_follow.frob
  wall_follow.test.frob
  world.toml
  $ frobc compile wall_follow.frob && grep -c wall_follow_step wall_follow.h
  4
  $ frobc build wall_follow.frob -o robot && ./robot --help | head -1; cd ..
  usage: wall_follow --device DEV [OPTION]...
  $ frobc new rover > /dev/null && cd rover && frobc test && cd ..
  ok    touches nothing: 10 seeds, 60 s
  ok    gets about: 10 seeds, 60 s
  2 tests: all hold
  $ mv root/usr/share/frobc/stdlib away; frobc check rover/rover.frob 2>&1 | grep -o 'in [^ ]*/root/usr, '  | sed 's|/.*/root|…/root|'
  in …/root/usr, 
  $ mv away root/usr/share/frobc/stdlib

frobc-doc contains the documentation. Its links lead to files in the package, except some to
sources.

  $ cd root/usr/share && ls doc/frobc man/man1
  doc/frobc:
  CHANGELOG.md
  README.md
  changelog.gz
  compiler
  copyright
  docs
  examples
  runtime
  sim
  stdlib
  
  man/man1:
  frobc-build.1.gz
  frobc-check.1.gz
  frobc-compile.1.gz
  frobc-convert.1.gz
  frobc-demo.1.gz
  frobc-doctor.1.gz
  frobc-explain.1.gz
  frobc-export.1.gz
  frobc-extras.1.gz
  frobc-falsify.1.gz
  frobc-fix.1.gz
  frobc-format.1.gz
  frobc-header.1.gz
  frobc-help.1.gz
  frobc-lsp.1.gz
  frobc-new.1.gz
  frobc-report.1.gz
  frobc-ros2.1.gz
  frobc-run.1.gz
  frobc-selftest.1.gz
  frobc-serve.1.gz
  frobc-sweep.1.gz
  frobc-test.1.gz
  frobc-trace.1.gz
  frobc-view.1.gz
  frobc.1.gz
  $ zcat man/man1/frobc.1.gz | grep -c "^.TH"
  1
  $ cd doc/frobc; for page in README.md docs/*.md docs/*/*.md; do
  >   grep -o '](\(../\)*[a-z0-9_.-]*\.\(md\|png\|svg\)' $page | sed 's/](//' | while read link; do
  >     test -e $(dirname $page)/$link || echo "$page: $link"
  >   done
  > done
