#!/bin/sh
# Installs the formatters that `make fmt` runs, in pinned versions, into _build/formatters.
# Formatters that are already there are kept. If a formatter cannot be downloaded, the script names
# it, and the others still work.
#
# ocamlformat comes from Debian 13 (the package source of this machine, with the suite replaced).
# Its program needs Debian 13's C library, so both are unpacked next to each other, and a script
# starts the program through that library's own loader. clang-format and ruff come from PyPI,
# prettier from npm.
set -u
cd "$(dirname "$0")/../.." || exit 1
. tests/formatters/versions.sh
to=$PWD/_build/formatters
mkdir -p "$to"
missing=

install_ocamlformat() (
    set -e
    if command -v ocamlformat >/dev/null && [ "$(ocamlformat --version)" = "$OCAMLFORMAT" ]; then
        ln -sf "$(command -v ocamlformat)" "$to/ocamlformat"
        exit 0
    fi
    work=$to/debian
    mkdir -p "$work/lists/partial" "$work/archives/partial" "$work/root"
    . /etc/os-release
    source=$(apt-get indextargets --format '$(REPO_URI)|$(RELEASE)|$(COMPONENT)' \
        'Created-By: Packages' | awk -F'|' -v suite="$VERSION_CODENAME" \
        '$2 == suite && $3 == "main" { print $1; exit }')
    [ -n "$source" ]
    keys=/usr/share/keyrings/debian-archive-keyring.gpg
    echo "deb [signed-by=$keys] $source trixie main" >"$work/sources.list"
    apt() {
        apt-get -qq -o Dir::Etc::SourceList="$work/sources.list" -o Dir::Etc::SourceParts=/dev/null \
            -o Dir::State::Lists="$work/lists" -o Dir::Cache="$work" -o APT::Sandbox::User="$(id -un)" \
            -o Debug::NoLocking=1 "$@"
    }
    cd "$work"
    apt update
    apt download ocamlformat libc6 libzstd1
    for package in *.deb; do dpkg -x "$package" root; done
    rm -rf lists archives ./*.deb ./*cache.bin
    loader=$(find "$work/root/" -name 'ld-linux*.so.*' | head -n 1)
    cat >"$to/ocamlformat" <<END
#!/bin/sh
exec "$loader" --library-path "${loader%/*}" "$work/root/usr/bin/ocamlformat" "\$@"
END
    chmod +x "$to/ocamlformat"
)

install_from_pypi() (
    set -e
    [ -x "$to/python/bin/pip" ] || python3 -m venv "$to/python"
    "$to/python/bin/pip" -q --disable-pip-version-check install "clang-format==$CLANG_FORMAT" "ruff==$RUFF"
    ln -sf "$to/python/bin/clang-format" "$to/python/bin/ruff" "$to"
)

install_prettier() (
    set -e
    npm install --silent --no-fund --no-audit --prefix "$to/npm" "prettier@$PRETTIER"
    ln -sf "$to/npm/node_modules/.bin/prettier" "$to"
)

# Installs with a function unless a program already has the pinned version.
want() {
    name=$1 version=$2 install=$3
    case $("$to/$name" --version 2>/dev/null) in
        *"$version"*) return ;;
    esac
    $install >"$to/$name.log" 2>&1 && return
    missing="$missing $name"
    echo "make fmt: cannot install $name $version; the end of _build/formatters/$name.log:" >&2
    tail -n 3 "$to/$name.log" >&2
}

want ocamlformat "$OCAMLFORMAT" install_ocamlformat
want clang-format "$CLANG_FORMAT" install_from_pypi
want ruff "$RUFF" install_from_pypi
want prettier "$PRETTIER" install_prettier
[ -z "$missing" ]
