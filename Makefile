# Frob: `make run` drives a robot in the simulator, `make test` tests it all.
# Both install what is missing first, and say so.

# What a Debian machine needs, by package.
PACKAGES = ocaml ocaml-dune menhir libmenhir-ocaml-dev libcmdliner-ocaml-dev \
  libalcotest-ocaml-dev libqcheck-ocaml-dev libbox2d-dev libtomlplusplus-dev \
  libcairo2-dev libmpfr-dev pkg-config gcc g++ clang libclang-rt-dev \
  libtcc-dev tcc libwebsockets-dev

# What only `make test` needs: a browser, and another client, for the page of `frobc view`;
# editors for `frobc lsp`; what makes the Debian package, and judges it; numpy and pandas for
# the Python package; JPEG for cameras; compressed recordings.
TEST_PACKAGES = chromium chromium-driver fonts-dejavu-core python3-selenium python3-websockets \
  neovim emacs-nox elpa-eglot libapriltag-dev dpkg-dev lintian python3-numpy python3-pandas \
  libturbojpeg0 zstd

# What only `make matrix` needs: compilers and emulators of other machines.
MATRIX_PACKAGES = gcc-aarch64-linux-gnu libc6-dev-arm64-cross \
  gcc-arm-linux-gnueabihf libc6-dev-armhf-cross qemu-user valgrind \
  gcc-arm-none-eabi libnewlib-arm-none-eabi qemu-system-arm \
  arduino-core-avr gcc-avr avr-libc

# What only `make bench` needs, and what other tools it compares with, where they
# can be had.
BENCH_PACKAGES = valgrind gcc-arm-none-eabi libnewlib-arm-none-eabi qemu-system-arm \
  libapriltag-dev libturbojpeg0 python3
COMPARED_PACKAGES = ghc libghc-copilot-dev libghc-copilot-c99-dev python3-opencv python3-numpy python3-pip

# What only `make site` and `make pictures` need; mkdocs itself comes from PyPI, see
# docs/site/requirements.txt.
SITE_PACKAGES = python3-venv
PICTURE_PACKAGES = imagemagick chromium chromium-driver fonts-dejavu-core python3-selenium

# What only `make deb` needs.
DEB_PACKAGES = dpkg-dev lintian

# What only `make photographs` needs; it takes pictures from three packages besides.
PHOTOGRAPH_PACKAGES = python3-opencv python3-numpy python3-pip libapriltag-dev

# What only `make prove` needs; the second does without the first where Debian has none, as 13.
ANALYSIS_PACKAGES = frama-c-base
PROVE_PACKAGES = cppcheck

# What only `make wheel` and `make python` need; they take the rest from PyPI.
WHEEL_PACKAGES = python3 python3-venv

# What only `make slurm` needs.
SLURM_PACKAGES = slurmctld slurmd slurm-client

# What only `make rtamt` and `make falsify` need; they take the rest from PyPI.
RTAMT_PACKAGES = python3 python3-venv

# What only `make mcap` needs; it takes the packages mcap and @mcap/core from PyPI and npm besides.
MCAP_PACKAGES = python3 python3-venv

# What only `make fuzz-frontend` needs.
AFL_PACKAGES = afl++

# For `make matrix` and `make prove`: the examples, with a robot for those that leave it open.
EXAMPLES = $(wildcard examples/*/[a-z]*.frob)
FOR_A_ROBOT = sed 's|.*/light_seek.frob|&:examples/light_seek/Moth.frob|; s|.*/line_follow.frob|&:create|; s|.*/safe_stick.frob|&:pioneer|; s|.*/teleop/.*|&:pioneer|; s|.*/clicked.frob|&:pioneer|'

# For `make prove`: which programs.
PROGRAMS ?= $(shell printf '%s\n' $(EXAMPLES) | $(FOR_A_ROBOT))

# Calls between modules are direct, as in what opam builds, so that frobc takes 4 % fewer
# instructions than with dune's dev profile (10,000 generated lines, by callgrind); warnings
# are errors all the same (see dune).
export DUNE_PROFILE ?= optimized

PREFIX ?= /usr/local
FROBC = _build/install/default/bin/frobc
OUT = _build/run

# For `make fuzz`: how many random programs, and from which seed.
N ?= 1000
SEED ?= $(shell date +%s)

# For `make mutants`: within how many random programs each fault is to be found, and
# which faults of tests/meaning/mutants/list, by number; none: all.
MUTANT_PROGRAMS ?= 10000
MUTANTS ?=

# For `make seeds`: how many seeds for each example and robot; for `make soak`:
# how many seeds for each robot.
SEEDS ?= 100

# For how long `make fuzz-frontend` runs, and each robot of `make soak` is driven.
fuzz-frontend: SECONDS ?= 600
soak: SECONDS ?= 3600

# For `make fuzz-drivers`: how many bytes for each wire format.
BYTES ?= 1000000000

.PHONY: all setup run test test-clients vsix page site pictures seeds fuzz fuzz-format fuzz-lsp fuzz-frontend mutants faults fuzz-drivers soak elementary matrix prove bench photographs install deb clean rtamt falsify mcap wheel python slurm

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

# The language server, the grammar and the extension under clients and tools of others, from PyPI
# and npm; what cannot be had is left out, with a word.
test-clients: all
	@sh tests/setup.sh $(SITE_PACKAGES)
	@PATH=$(CURDIR)/_build/install/default/bin:$$PATH sh tests/users/editors/clients/run.sh _build/clients

# The extension for Visual Studio Code, in _build/vsix; with npm, which users need not have.
vsix:
	@sh compiler/editors/vscode/build.sh _build/vsix

# The page of `frobc view` anew from its sources; with npm, which users need not have.
page:
	@sh runtime/hosts/view/page/build.sh _build/page runtime/hosts/view/page/bundle

# The documentation as a site to read and search in, in _build/site.
site: export NO_MKDOCS_2_WARNING = 1
site: all
	@sh tests/setup.sh $(SITE_PACKAGES)
	@test -d _build/site-tools || python3 -m venv _build/site-tools
	@_build/site-tools/bin/pip install --quiet --disable-pip-version-check -r docs/site/requirements.txt
	@python3 -B docs/site/build.py . $(FROBC) _build/site-pages
	@_build/site-tools/bin/mkdocs build --quiet --config-file docs/site/mkdocs.yml
	@echo "the site: _build/site/index.html"

# The pictures that the pages of docs/ show of their programs' runs, anew; and those of the page
# of `frobc view` for programs that see.
pictures: all
	@sh tests/setup.sh $(PICTURE_PACKAGES)
	@PATH=$(CURDIR)/_build/install/default/bin:$$PATH sh docs/site/pictures.sh docs/tutorial/*.md $(wildcard docs/how-to/*.md)
	@/usr/bin/python3 -B docs/site/page_pictures.py $(FROBC) .

fuzz: all
	@dune build tests/meaning/fuzz/main.exe
	@_build/default/tests/meaning/fuzz/main.exe --count $(N) --seed $(SEED) --jobs $$(nproc) --sanitize-every 50

# The formatter's laws on random programs with comments sprinkled in.
fuzz-format: N = 10000
fuzz-format: setup
	@dune build ./tests/users/format/of_random_programs.exe
	@_build/default/tests/users/format/of_random_programs.exe $(N) $(SEED)

# The language server on random edits of the examples.
fuzz-lsp: N = 10000
fuzz-lsp: all
	@cd _build && PATH=$(CURDIR)/_build/install/default/bin:$$PATH PYTHONPATH=$(CURDIR)/tests/users/lsp \
	  python3 $(CURDIR)/tests/users/lsp/random_edits.py $(SEED) $(N) $(CURDIR)/examples/*/*.frob

# Deliberate faults in the compiler: the random programs must find each. With direct calls
# between modules each fault would ask for all that depends on its module to be built again.
mutants: DUNE_PROFILE = dev
mutants: setup
	@sh tests/meaning/mutants/run.sh $(MUTANT_PROGRAMS) 1 $(MUTANTS)

# The compiler on bytes that are nearly programs, in a build that afl-fuzz can watch.
fuzz-frontend: setup
	@sh tests/setup.sh $(AFL_PACKAGES)
	@mkdir -p $(CURDIR)/_build
	@OCAMLPARAM='_,afl-instrument=1' dune build --build-dir $(CURDIR)/_build/afl ./tests/users/frontend/harness.exe
	@sh tests/users/frontend/run.sh $(CURDIR)/_build/afl/default/tests/users/frontend/harness.exe $(CURDIR)/stdlib $(SECONDS)

# Deliberate faults in the examples: their trials should find each; which they do not is told.
faults: N = 200
faults: SEED = 1
faults: all
	@mkdir -p _build/bench
	@sh tests/generated/bench/faults/run.sh _build/bench $(N) $(SEED)

fuzz-drivers: setup
	@dune build ./tests/robots/wire/fuzz/fuzz_scout ./tests/robots/wire/fuzz/fuzz_create ./tests/robots/wire/fuzz/fuzz_pioneer
	@sh tests/robots/wire/fuzz/run.sh _build/default/tests/robots/wire/fuzz $(BYTES) $(SEED) scout create pioneer

# The examples with many seeds of noise, in the simulator and through each robot's
# driver and line, and BUG in real time behind each line: what a minute is too short
# for in `make test`.
seeds: all
	@dune build ./tests/robots/line/frob-line
	@sh tests/robots/line/seeds.sh $(CURDIR)/$(FROBC) _build/default/tests/robots/line/frob-line examples $(SEEDS)
	@sh tests/robots/robot/bug.sh $(CURDIR)/$(FROBC) $(CURDIR)/examples
	@PATH=$(CURDIR)/_build/install/default/bin:$$PATH sh tests/robots/run/all_seeds.sh $(SEEDS)

# The module Past beside RTAMT, from PyPI, in an environment of its own.
rtamt: N = 1000
rtamt: all
	@sh tests/setup.sh $(RTAMT_PACKAGES)
	@test -x _build/rtamt/bin/python || { python3 -m venv _build/rtamt && _build/rtamt/bin/pip install --quiet rtamt==0.4.10; }
	@_build/rtamt/bin/python tests/meaning/rtamt/agree.py $(CURDIR)/$(FROBC) $(N) $(SEED)

# Recordings as MCAP, read by the packages of those who made the format, from PyPI and npm.
mcap: all
	@sh tests/setup.sh $(MCAP_PACKAGES)
	@sh tests/users/convert/readers/run.sh $(CURDIR)/$(FROBC) _build/mcap

# Searches for runs that break the requirements of a benchmark, beside another tool: with the
# libraries from PyPI.
falsify: all
	@sh tests/setup.sh $(RTAMT_PACKAGES)
	@test -x _build/falsify/bin/python || { python3 -m venv _build/falsify && _build/falsify/bin/pip install --quiet numpy cma==4.5.0 psy-taliro==3.2.0; }
	@FROBC=$(CURDIR)/$(FROBC) PYTHONPATH=runtime/python PYTHONDONTWRITEBYTECODE=1 _build/falsify/bin/python \
	  tests/users/python/chasing_cars.py examples/chasing_cars/chasing_cars.frob

# The Python package with frobc and its hosts, in _build/wheel; and that wheel tried in
# virtual environments, with what it works with. Both take tools from PyPI.
wheel: all
	@sh tests/setup.sh $(WHEEL_PACKAGES)
	@sh runtime/python/wheel.sh $(CURDIR)/_build

python: wheel
	@sh tests/users/python/venv.sh $(CURDIR)/_build

# A sweep as an array of jobs under Slurm, whose daemons run here while it lasts.
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

# The elementary functions of single precision on every float; of two arguments, on as
# many pairs. An hour's work for two processors.
elementary: setup
	@dune build ./tests/generated/elementary/single_errors_fast
	@echo exp log sin cos tan asin acos atan pow atan2 hypot | tr ' ' '\n' | \
	  xargs -P $$(nproc) -n 1 _build/default/tests/generated/elementary/single_errors_fast 1

# No undefined behaviour in the C of the examples, and a clamp that holds, by static
# analysis; and what MISRA C says.
prove: all
	@sh tests/setup.sh $(PROVE_PACKAGES)
	@sh tests/setup.sh $(ANALYSIS_PACKAGES) || ! apt-cache show $(ANALYSIS_PACKAGES) 2>/dev/null | grep -q .
	@sh tests/generated/prove/run.sh $(CURDIR)/$(FROBC) runtime docs/generated-c.md $(PROGRAMS)

soak: setup
	@dune build ./tests/robots/faults/soak
	@_build/default/tests/robots/faults/soak $(SEED) $(SEEDS) $(SECONDS)

bench: all
	@sh tests/setup.sh $(BENCH_PACKAGES)
	-@sh tests/setup.sh $(COMPARED_PACKAGES)
	@sh tests/generated/bench/run.sh

# The kernels of vision on photographs, beside OpenCV and what is known of what is on them: from
# scikit-image (PyPI), opencv-doc and visp-images-data (Debian), fetched, and not installed.
photographs: setup
	@sh tests/setup.sh $(PHOTOGRAPH_PACKAGES)
	@sh tests/generated/photographs/run.sh _build/photographs

install: setup
	dune build -p frobc @install
	dune install -p frobc --prefix $(PREFIX) --mandir $(PREFIX)/share/man --docdir $(PREFIX)/share/doc frobc
	sh compiler/package/documents.sh $(PREFIX)/share/doc/frobc
	@echo "installed: $(PREFIX)/bin/frobc, with its documentation in $(PREFIX)/share/doc/frobc"

# A Debian package of the same, in _build/deb.
deb: all
	@sh tests/setup.sh $(DEB_PACKAGES)
	@sh compiler/package/deb.sh _build/install/default _build/deb
	@lintian --fail-on error,warning _build/deb/frobc_*.deb

clean:
	dune clean
