In a folder, trials that need a library that is not installed are skipped; in a file that is named,
they fail, for the same reason. The library's name in this test is not a real one.

  $ mkdir none && printf 'no library' > none/libapriltag.so.3
  $ export LD_LIBRARY_PATH=$PWD/none
  $ cp -r ../../../examples/dock_tag . && chmod -R u+w dock_tag
  $ frobc test dock_tag --seeds 1
  skip  docks in time: needs the library libapriltag, which is not installed
        sudo apt-get install libapriltag-dev
  skip  docks within 2 cm and 2 degrees: needs the library libapriltag, which is not installed
        sudo apt-get install libapriltag-dev
  error: no test was run; see above for how to run the skipped tests
  [2]
  $ printf 'import Trial\ntest "another" = during 1[s] (proc () -> True)\n' > dock_tag/another.frob
  $ frobc test dock_tag --seeds 1 | tail -n 1
  1 test: all hold; 2 skipped
  $ frobc test dock_tag/dock_tag.frob --seeds 1
  FAIL  docks in time: this program detects tags, but the library libapriltag.so.3 is not installed: install it (Debian: `sudo apt-get install libapriltag-dev`); replaying a recording does not need it
  FAIL  docks within 2 cm and 2 degrees: this program detects tags, but the library libapriltag.so.3 is not installed: install it (Debian: `sudo apt-get install libapriltag-dev`); replaying a recording does not need it
  2 tests: 2 failed
  [1]
