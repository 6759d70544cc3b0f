#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# command_test.sh WORLDS ROOT: command-line tests of the program `worlds` and of tools/worlds, which
# refuses wrong use before a build.
set -u
program=$1 tool=$2/tools/worlds
work=$(mktemp -d) || exit 1
trap 'rm -rf "$work"' EXIT
cd "$work" || exit 1
failed=0

# expect CODE PATTERN COMMAND...: checks the exit code and one line of the output (both streams).
expect() {
    local code=$1 pattern=$2 output got
    shift 2
    output=$(timeout 60 "$@" 2>&1)
    got=$?
    if ((got != code)) || ! grep -Eq -- "$pattern" <<<"$output"; then
        printf 'FAILED: %s\n  exit code %s, expected %s; no line like: %s\n%s\n' \
            "$*" "$got" "$code" "$pattern" "$output"
        failed=1
    fi
}

mkdir folder && echo 'a text' >text && printf 'world 1 \ngravity 0' >half
over=18446744073709551616

expect 0 '^  sleep ' "$program" --help
expect 0 'of 1 worlds, 0 findings' "$program" --count 1 --seed 1
expect 0 '^world 1' "$program" --seed 18446744073709551615 --count 1 --print
expect 2 'folder is a folder' "$program" --replay folder
expect 2 'nowhere cannot be read' "$program" --replay nowhere
for file in text half; do
    expect 2 "$file is no saved world" "$program" --replay "$file"
done
for wrong in '--count 0' "--count $over" "--seed $over" '--seed -1' '--jobs 0' '--jobs 4294967297' \
    '--seed 18446744073709551615 --count 2' '--nosuch 1' '--seed'; do
    # shellcheck disable=SC2086 # several words
    expect 2 'wrong use' "$program" $wrong
done

expect 0 'tests/worlds/known' "$tool" --help
expect 2 'folder is a folder' "$tool" --replay folder
expect 2 'no readable file nowhere' "$tool" --replay nowhere
expect 2 'text is no saved world' "$tool" --replay text
for wrong in '--count 0' '--count 00' "--count $over" '--count x'; do
    # shellcheck disable=SC2086
    expect 2 'count must be a whole number from 1' "$tool" $wrong
done
for wrong in "--seed $over" '--seed -1' '--seed 99999999999999999999999'; do
    # shellcheck disable=SC2086
    expect 2 'seed must be a whole number' "$tool" $wrong
done
expect 2 'precision must be' "$tool" --precision half
exit $failed
