# shellcheck shell=bash
# SPDX-License-Identifier: MIT
# Shared by the commands in tools/: installs packages, configures, builds, runs tests.
# Exit codes of every command:
#   0 done   1 a build or a test failed   2 wrong use, or a tool is missing or too old
#   3 packages are missing and this user may not install them

unset CDPATH # with it, cd prints a second line, and may go elsewhere
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
cd "$root" || exit 2
export LC_ALL=C.UTF-8
# ccache with precompiled headers. Depend mode compares file contents. Preprocessor mode would reuse
# a precompiled header from before a change of a comment, and the compiler would then read that file
# a second time.
export CCACHE_SLOPPINESS=pch_defines,time_macros
export CCACHE_DEPEND=1

# Debian packages; `package:command` is satisfied by the command too, whatever its origin.
# shellcheck disable=SC2034 # used by the commands that source this file
packages_build=(g++:g++ cmake:cmake ninja-build:ninja ccache:ccache
    libtomlplusplus-dev libcli11-dev libfmt-dev)
# shellcheck disable=SC2034
packages_view=(libsfml-dev libimgui-dev libgif-dev)
# shellcheck disable=SC2034
packages_test=(libgtest-dev libbox2d-dev python3:python3 pkgconf:pkg-config dpkg-dev:dpkg-shlibdeps)
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
# shellcheck disable=SC2034
packages_windows=(g++-mingw-w64-x86-64-posix:x86_64-w64-mingw32-g++-posix wine64)

say() { printf '%s\n' "$*"; }

# die CODE SENTENCE
die() {
    local code=$1
    shift
    printf '%s\n' "$*" >&2
    exit "$code"
}

# One line that is overwritten; without a terminal, a line every half minute.
progress_pause=30 progress_text="" progress_at=$SECONDS
progress() {
    progress_text=$*
    [[ ! -d build ]] || printf '%s, after %d s\n' "${*:-done}" "$SECONDS" >build/progress.txt
    if [[ -t 1 ]]; then
        printf '\r\033[K%s' "$*"
    elif [[ -n $* ]] && ((SECONDS - progress_at >= progress_pause)); then
        say "$*, after $SECONDS s"
        progress_at=$SECONDS
    fi
}

# Reads the next line of the input into $line; shows the progress while it waits.
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

# Prints the packages among the arguments that are not installed, one per line.
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

# apt_as PREFIX... -- PACKAGE...: runs apt-get update and install, with PREFIX before the command.
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
    "${apt[@]}" update >"$log" 2>&1 || true # a broken source of packages may be unrelated
    if ! "${apt[@]}" install -y --no-install-recommends "$@" >>"$log" 2>&1; then
        tail -n 20 "$log" >&2
        die 2 "apt could not install the missing packages; full log: $log"
    fi
}

# need_packages ENTRY...: installs missing packages, or exits. Does nothing on a system without apt:
# need_tool and CMake report missing tools there.
need_packages() {
    command -v apt-get >/dev/null && command -v dpkg-query >/dev/null || return 0
    local missing
    mapfile -t missing < <(missing_packages "$@" | sort -u)
    ((${#missing[@]})) || return 0
    if ((EUID == 0)); then
        apt_as -- "${missing[@]}"
    elif command -v sudo >/dev/null && { sudo -n true 2>/dev/null || [[ -t 0 ]]; }; then
        say "Missing packages are installed with sudo."
        apt_as sudo -- "${missing[@]}"
    else
        say "Packages are missing. Run this command as root, then try again:" >&2
        die 3 "apt-get update && apt-get install -y --no-install-recommends ${missing[*]}"
    fi
}

# need_tool COMMAND LEAST: exits with a message if the tool is missing or older than LEAST.
need_tool() {
    local tool=$1 least=$2 found
    command -v "$tool" >/dev/null ||
        die 2 "$tool is missing: $tool $least or newer is needed, please install it."
    found=$("$tool" --version 2>/dev/null | grep -oE '[0-9]+(\.[0-9]+)+' | head -n 1)
    if [[ $(printf '%s\n%s\n' "$least" "$found" | sort -V | head -n 1) != "$least" ]]; then
        die 2 "$tool ${found:-of unknown version} is too old: $tool $least or newer is needed."
    fi
}

# Checks the tools of every build. The compiler is $CXX if set, else g++, else clang++.
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
    say "Full log: $1" >&2
}

# configure_into DIR ARGUMENT...: runs cmake only if its arguments or the presets have changed.
# Ninja itself detects changes of the CMake lists.
configure_into() {
    local dir=$1 stamp=$1/.configured log=$1/configure.log
    shift
    mkdir -p "$dir"
    rm -f "$dir/test.log" # an old result must not be mistaken for a new one
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

# build_in DIR TARGET...: builds with one progress line; default target: all.
build_in() {
    local dir=$1 log=$1/build.log line
    shift
    [[ ! -f $log ]] || mv "$log" "$log.last"
    : >"$log"
    local started=$SECONDS
    local command=(cmake --build "$dir" -j "$(jobs_wanted)")
    (($#)) && command+=(--target "$@")
    # NINJA_STATUS fixes the format that is parsed below.
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
        mv "$log.last" "$log" # nothing was built: keep the log of the last build
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
    sed -n '/is missing:/s/^-- //p' "build/$preset/configure.log" # omitted targets, with the reason
    build_in "build/$preset" "$@"
}

# has_target DIR TARGET: true if the configured build has this target.
has_target() { ninja -C "$1" -t query "$2" >/dev/null 2>&1; }

# run_tests DIR CTEST_ARGUMENT...: prints one progress line, the output of failed tests and the
# summary. The full output is in DIR/test.log.
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
    ((result == 0)) || say "Tests failed; full log: $log" >&2
    return "$((result != 0))"
}
