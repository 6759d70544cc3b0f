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
refuse "no scene's name contains nosuch" tools/crosscheck --scenes Pendulum nosuch
timeout 60 python3 -B tools/lib/crosscheck.py --check-options --scenes Pendulum ||
    { echo 'FAILED: a scene that exists is refused' && failed=1; }
mkdir -p box2d3/include/box2d && : >box2d3/include/box2d/id.h
for also in '--profiles fast' '--engines kodo64'; do
    # shellcheck disable=SC2086 # two words
    refuse 'give no --engines or --profiles' tools/bench --box2d3 box2d3 $also
done
tools/bench --help | grep -q '^The column "missed targets"' ||
    { echo 'FAILED: tools/bench --help does not explain its columns' && failed=1; }
exit $failed
