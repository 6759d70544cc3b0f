#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# tool_options.sh ROOT: tools refuse wrong use with exit code 2 and one sentence, before a build. They
# run in a copy without build folders.
set -u
work=$(mktemp -d) || exit 1
trap 'rm -rf "$work"' EXIT
mkdir "$work/tests" && cp -r "$1/tools" "$work/tools" && cp -r "$1/tests/cross" "$work/tests/cross" ||
    exit 1
cd "$work" || exit 1
failed=0

# refuse PATTERN COMMAND...
refuse() {
    local pattern=$1 output got
    shift
    output=$(timeout 60 "$@" 2>&1)
    got=$?
    if ((got != 2)) || ! grep -Eq -- "$pattern" <<<"$output" || [[ -e build ]]; then
        printf 'FAILED: %s\n  exit code %s, expected 2; no line like: %s\n%s\n' \
            "$*" "$got" "$pattern" "$output"
        failed=1
    fi
}

echo 'a page' >page.md
refuse 'none of the lines has been run' tools/mutants --report page.md
[[ $(<page.md) == 'a page' ]] || { echo 'FAILED: the page was overwritten' && failed=1; }
for wrong in '--jobs 0' '--jobs -1' '--jobs many' '--only 0' '--only -1' '--only 1 99'; do
    # shellcheck disable=SC2086 # several words
    refuse 'whole number from 1|expected' tools/mutants $wrong
done
refuse 'no folder nowhere' tools/crosscheck --output nowhere/page.html
refuse 'no folder nowhere' tools/crosscheck --picture nowhere/page.svg
refuse 'tools is a folder' tools/crosscheck --output tools
refuse "no scene's name or title contains nosuch; tools/crosscheck --list" \
    tools/crosscheck --scenes Pendulum nosuch
timeout 60 python3 -B tools/lib/crosscheck.py --check-options \
    --scenes Pendulum pendulum head-on 'meet HEAD-on, e = 0.5' ||
    { echo 'FAILED: a scene that exists is refused' && failed=1; }
grep -qx 'BallThroughPinsBouncesAndFallsOut' <<<"$(tools/crosscheck --list)" ||
    { echo 'FAILED: tools/crosscheck --list does not name a scene' && failed=1; }
refuse '^tools/crosscheck: --list writes no page' tools/crosscheck --list --scenes Pendulum
refuse '^tools/crosscheck: there is no file .*/nowhere.toml' tools/crosscheck nowhere.toml
refuse '^tools/crosscheck: a file has one scene: give no --scenes' \
    tools/crosscheck tests/cross/example.toml --scenes Pendulum
refuse 'the sandbox has no scene Nosuch; destructoooor --list' tools/sidebyside Nosuch
refuse '^tools/crosscheck: there is no file .*/nowhere.toml' tools/sidebyside nowhere.toml
refuse '^tools/thesis: there is no folder nowhere' tools/thesis --output nowhere/page.html
refuse '^tools/thesis: tools is a folder' tools/thesis --output tools
mkdir -p box2d3/include/box2d && : >box2d3/include/box2d/id.h
for also in '--profiles fast' '--engines kodo64'; do
    # shellcheck disable=SC2086 # two words
    refuse 'give no --engines or --profiles' tools/bench --box2d3 box2d3 $also
done
refuse '^tools/crosscheck: .*no installed Box2D 3 in' tools/crosscheck --box2d3 nowhere
refuse '^tools/crosscheck: --errors measures all scenes' tools/crosscheck --errors --list
# I5: a file whose name begins with a dash is a file, and no option of realpath.
: >-x.replay
refuse '^[^:]*--sandbox cannot be combined' tools/play --replay -x.replay --sandbox
# Options that would have no effect.
for wrong in '--check --survivors' '--check --only 1' '--report page.md --jobs 2'; do
    # shellcheck disable=SC2086
    refuse '^tools/mutants: --(check|report) runs no line: give no --' tools/mutants $wrong
done
for tool in bench trade; do
    refuse "^tools/$tool: --quick is one run each: give no --repeat" "tools/$tool" --quick --repeat 3
done
for wrong in '--scenes pyramid' '--repeat 2' '--quick'; do
    # shellcheck disable=SC2086
    refuse "^tools/trade: --dials has .*: give no ${wrong%% *}" tools/trade --dials $wrong
done
refuse "invalid choice: 'default'" tools/bench --profiles default
grep -q -- '^    tools/mutants .*--survivors' <<<"$(tools/mutants --help)" ||
    { echo 'FAILED: --survivors is missing in the first line of tools/mutants --help' && failed=1; }
tools/bench --help | grep -q '^The column "missed targets"' ||
    { echo 'FAILED: tools/bench --help does not explain its columns' && failed=1; }
exit $failed
