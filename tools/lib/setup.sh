# shellcheck shell=bash
# SPDX-License-Identifier: MIT
# What the commands in tools/ share: install what is missing, configure, build, run tests.
# Every command exits with one of these:
#   0 done   1 a build or a test failed   2 wrong use, or a tool is missing or too old
#   3 packages are missing and this user may not install them

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
cd "$root" || exit 2
export LC_ALL=C.UTF-8
# What ccache needs for precompiled headers. They must be told apart by what is in each file: by
# what the preprocessor leaves, one of before a comment changed is taken for one of now, and then
# the compiler reads that file twice.
export CCACHE_SLOPPINESS=pch_defines,time_macros
export CCACHE_DEPEND=1

# Debian packages; `package:command` is also satisfied by the command from anywhere else.
# shellcheck disable=SC2034 # used by the commands that source this file
packages_build=(g++:g++ cmake:cmake ninja-build:ninja ccache:ccache
    libtomlplusplus-dev libcli11-dev libfmt-dev)
# shellcheck disable=SC2034
packages_view=(libsfml-dev)
# shellcheck disable=SC2034
packages_test=(libgtest-dev libbox2d-dev python3:python3)
# shellcheck disable=SC2034
packages_display=(xvfb:Xvfb xauth:xauth xdotool:xdotool imagemagick:import libgl1-mesa-dri)
# shellcheck disable=SC2034
packages_sanitize=(clang:clang++ libclang-rt-14-dev)
# shellcheck disable=SC2034
packages_matrix=(g++:g++ clang:clang++)
# shellcheck disable=SC2034
packages_aarch64=(g++-aarch64-linux-gnu:aarch64-linux-gnu-g++ qemu-user:qemu-aarch64)
# shellcheck disable=SC2034
packages_wasm=(emscripten:em++ node-acorn nodejs:node)

say() { printf '%s\n' "$*"; }

# die CODE SENTENCE
die() {
    local code=$1
    shift
    printf '%s\n' "$*" >&2
    exit "$code"
}

# One line that is overwritten; where the output is not a terminal, a line every half minute.
progress_pause=30 progress_text="" progress_at=$SECONDS
progress() {
    progress_text=$*
    if [[ -t 1 ]]; then
        printf '\r\033[K%s' "$*"
    elif [[ -n $* ]] && ((SECONDS - progress_at >= progress_pause)); then
        say "$*, after $SECONDS s"
        progress_at=$SECONDS
    fi
}

# The next line of the input, in $line; while none comes, the progress goes on being shown.
read_line() {
    local part=""
    until IFS= read -r -t "$progress_pause" line; do
        (($? > 128)) || return 1 # the end; more than 128 is a pause
        part+=$line
        progress "$progress_text"
    done
    line=$part$line
}

jobs_wanted() { say "${CMAKE_BUILD_PARALLEL_LEVEL:-$(nproc 2>/dev/null || say 2)}"; }

# The packages among the arguments that are not there, one a line.
missing_packages() {
    local entry package command
    local -A installed=()
    while read -r package; do
        installed[$package]=1
    done < <(dpkg-query -W -f='${db:Status-Status} ${Package}\n' "${@%%:*}" 2>/dev/null |
        sed -n 's/^installed //p')
    for entry in "$@"; do
        package=${entry%%:*}
        command=${entry#"$package"}
        command=${command#:}
        if [[ -z ${installed[$package]:-} ]] &&
            ! { [[ -n $command ]] && command -v "$command" >/dev/null; }; then
            say "$package"
        fi
    done
}

# apt_as PREFIX... -- PACKAGE...: update and install, with the command in front of apt-get.
apt_as() {
    local prefix=()
    while [[ $1 != -- ]]; do
        prefix+=("$1")
        shift
    done
    shift
    mkdir -p build
    local log=build/setup.log
    local apt=("${prefix[@]}" env DEBIAN_FRONTEND=noninteractive apt-get -o DPkg::Lock::Timeout=300)
    say "Installing, which may take some minutes: $*"
    "${apt[@]}" update >"$log" 2>&1 || true # one broken source is no reason to stop
    if ! "${apt[@]}" install -y --no-install-recommends "$@" >>"$log" 2>&1; then
        tail -n 20 "$log" >&2
        die 2 "apt could not install what is missing; the whole log: $log"
    fi
}

# need_packages ENTRY...: after this they are there, or we have stopped. On a system without apt
# nothing is done: need_tool and CMake name what is missing.
need_packages() {
    command -v apt-get >/dev/null && command -v dpkg-query >/dev/null || return 0
    local missing
    mapfile -t missing < <(missing_packages "$@" | sort -u)
    ((${#missing[@]})) || return 0
    if ((EUID == 0)); then
        apt_as -- "${missing[@]}"
    elif command -v sudo >/dev/null && { sudo -n true 2>/dev/null || [[ -t 0 ]]; }; then
        say "sudo is used to install what is missing."
        apt_as sudo -- "${missing[@]}"
    else
        say "Packages are missing. Run this line as root, then try again:" >&2
        die 3 "apt-get update && apt-get install -y --no-install-recommends ${missing[*]}"
    fi
}

# need_tool COMMAND LEAST: stops with a sentence when it is missing or older.
need_tool() {
    local tool=$1 least=$2 found
    command -v "$tool" >/dev/null ||
        die 2 "$tool is missing: $tool $least or newer is needed, please install it."
    found=$("$tool" --version 2>/dev/null | grep -oE '[0-9]+(\.[0-9]+)+' | head -n 1)
    if [[ $(printf '%s\n%s\n' "$least" "$found" | sort -V | head -n 1) != "$least" ]]; then
        die 2 "$tool ${found:-of unknown version} is too old: $tool $least or newer is needed."
    fi
}

# What every build needs. The compiler is $CXX when set, else g++, else clang++.
need_build_tools() {
    need_tool cmake 3.25
    need_tool ninja 1.10
    if [[ -z ${CXX:-} ]]; then
        CXX=g++
        if ! command -v g++ >/dev/null && command -v clang++ >/dev/null; then
            CXX=clang++
        fi
    fi
    export CXX
    case $("$CXX" --version 2>/dev/null | head -n 1) in
        *clang*) need_tool "$CXX" 14 ;;
        *) need_tool "$CXX" 12 ;;
    esac
}

# show_failure LOG WHAT
show_failure() {
    progress ""
    say "$2 failed. The last lines:" >&2
    tail -n 40 "$1" >&2
    say "The whole log: $1" >&2
}

# configure_into DIR ARGUMENT...: runs cmake only when its arguments or the presets changed;
# changes of the CMake lists are noticed by ninja itself.
configure_into() {
    local dir=$1 stamp=$1/.configured log=$1/configure.log
    shift
    mkdir -p "$dir"
    rm -f "$dir/test.log" # so that an old result is never taken for this one
    if [[ -f $dir/build.ninja && -f $stamp && ! CMakePresets.json -nt $stamp &&
        $(<"$stamp") == "$*" ]]; then
        return 0
    fi
    progress "Configuring $dir"
    rm -f "$stamp"
    if ! cmake "$@" >"$log" 2>&1; then
        show_failure "$log" "Configuring $dir"
        return 1
    fi
    progress ""
    say "$*" >"$stamp"
}

# build_in DIR TARGET...: builds with one progress line; `all` when no target is given.
build_in() {
    local dir=$1 log=$1/build.log line
    shift
    [[ ! -f $log ]] || mv "$log" "$log.last"
    : >"$log"
    local started=$SECONDS
    local command=(cmake --build "$dir" -j "$(jobs_wanted)")
    (($#)) && command+=(--target "$@")
    # NINJA_STATUS is set so that the lines read below look as expected.
    NINJA_STATUS='[%f/%t] ' "${command[@]}" 2>&1 | while read_line; do
        printf '%s\n' "$line" >>"$log"
        if [[ $line =~ ^\[([0-9]+/[0-9]+)\]\  ]]; then
            progress "Building $dir: ${BASH_REMATCH[1]}"
        fi
    done
    if ((PIPESTATUS[0])); then
        show_failure "$log" "Building $dir"
        return 1
    fi
    progress ""
    if ! grep -q '^\[' "$log" && [[ -f $log.last ]]; then
        mv "$log.last" "$log" # nothing was built: the log of the build still tells how it went
    elif grep -q 'warning:' "$log"; then
        say "The build gave warnings: $log"
    fi
    say "Built $dir in $((SECONDS - started)) s."
}

# configure_and_build PRESET TARGET...
configure_and_build() {
    local preset=$1
    shift
    configure_into "build/$preset" --preset "$preset" || return 1
    sed -n '/is missing:/s/^-- //p' "build/$preset/configure.log" # what is left out, and why
    build_in "build/$preset" "$@"
}

# has_target DIR TARGET: does the configured build know this program?
has_target() { ninja -C "$1" -t query "$2" >/dev/null 2>&1; }

# run_tests DIR CTEST_ARGUMENT...: one progress line, the output of what failed, the closing lines.
# Everything else is in DIR/test.log.
run_tests() {
    local dir=$1 log=$1/test.log line show="" closing=""
    shift
    : >"$log"
    ctest --test-dir "$dir" --output-on-failure --no-tests=error \
        -j "${CTEST_PARALLEL_LEVEL:-$(jobs_wanted)}" "$@" 2>&1 |
        while read_line; do
            printf '%s\n' "$line" >>"$log"
            if [[ $line =~ ^[0-9]+%\ tests\ passed || $line == "No tests were found"* ]]; then
                closing=1
                progress ""
            elif [[ $line =~ ^\ *([0-9]+/[0-9]+)\ Test\ +#[0-9]+: ]]; then
                progress "Testing $dir: ${BASH_REMATCH[1]}"
                show=""
                if [[ $line == *'***'* && ! $line =~ \*\*\*(Skipped|Not\ Run) ]]; then
                    show=1
                    progress ""
                fi
            elif [[ $line =~ ^\ +Start\ +[0-9]+: ]]; then
                show=""
            fi
            [[ -n $show$closing ]] && printf '%s\n' "$line"
            true
        done
    local result=${PIPESTATUS[0]}
    ((result == 0)) || say "Tests failed; the whole log: $log" >&2
    return "$((result != 0))"
}
