`make` first installs missing packages, except those that another package provides, as Debian 13's
Emacs provides elpa-eglot. This test replaces Debian's tools with stubs.

  $ mkdir bin
  $ cat > bin/dpkg-query <<'SH'
  > #!/bin/sh
  > case $3 in
  > gcc) printf 'install ok installed' ;;
  > "") printf 'installed, c-compiler\ninstalled, elpa-eglot (= 1.17.30), elpa-xref (= 1.7.0)\nconfig-files, gone (= 1)\n' ;;
  > *) exit 1 ;;
  > esac
  > SH
  $ printf '#!/bin/sh\necho "apt-get $*" >> asked\n' > bin/apt-get
  $ printf '#!/bin/sh\nexec "$@"\n' > bin/sudo
  $ chmod +x bin/*
  $ setup() { PATH=$PWD/bin:$PATH sh ../../setup.sh "$@"; }
  $ setup gcc elpa-eglot c-compiler elpa-xref; cat asked
  cat: asked: No such file or directory
  [1]
  $ setup gcc gone elpa valgrind
  Installing Debian packages: gone elpa valgrind
  $ tail -n 1 asked
  apt-get install -y --no-install-recommends gone elpa valgrind
