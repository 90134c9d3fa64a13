#!/usr/bin/env bash
# run.sh SOURCE PROGRAM_FOLDER DOCUMENT: runs the commands of the document's ```console blocks in a copy of the
# examples, and compares what they print.
#
# A line that begins with "$ " is a command; "# exit N" at its end states another exit code than 0. The lines
# below it are what it prints, "..." standing for any lines; without such lines only the exit code counts.
set -u
source=$1 programs=$2 document=$3
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
cp -r "$source/examples" "$scratch"
cd "$scratch" || exit 1
export PATH=$programs:$PATH

failures=0 commands=0
command="" expected=""

# Expected text as a pattern: every character stands for itself, a line "..." for any lines.
pattern_of() {
    sed -e 's/[][\\*?]/\\&/g' -e 's/^\.\.\.$/*/' <<<"$1"
}

finish_command() {
    [ -n "$command" ] || return
    local code=0 actual status pattern
    [[ $command =~ '# exit '([0-9]+)$ ]] && code=${BASH_REMATCH[1]}
    actual=$(bash -c "$command" 2>&1 </dev/null)
    status=$?
    commands=$((commands + 1))
    if [ "$status" != "$code" ]; then
        failures=$((failures + 1))
        printf '%s: $ %s\nexit code %s, not %s; it printed\n%s\n' "$document" "$command" "$status" "$code" "$actual"
    elif [ -n "$expected" ]; then
        pattern=$(pattern_of "${expected%$'\n'}")
        # shellcheck disable=SC2053 # a pattern on purpose
        if [[ $actual != $pattern ]]; then
            failures=$((failures + 1))
            printf '%s: $ %s\nprints something else (< document, > program):\n' "$document" "$command"
            diff <(printf '%s' "$expected") <(printf '%s\n' "$actual")
        fi
    fi
    command="" expected=""
}

inside=no
while IFS= read -r line || [ -n "$line" ]; do
    if [ "$inside" = no ]; then
        [ "$line" = '```console' ] && inside=yes
    elif [ "$line" = '```' ]; then
        finish_command
        inside=no
    elif [[ $line == '$ '* ]]; then
        finish_command
        command=${line#'$ '}
    else
        expected+=$line$'\n'
    fi
done <"$source/$document"

printf '%s: %s commands, %s failed\n' "$document" "$commands" "$failures"
[ "$failures" = 0 ]
