#!/bin/sh
# Facts about commands, from a table of them: what a person types, and what happens.
#
#   sh tests/table.sh build tests/tables/cli.txt [WORD...]
#
# A row of the table is one of these, and lines that begin with a blank belong to it:
#
#   NAME | CODE | TEXT | COMMAND   a fact: the command ends with the code, and what it
#                                  prints, on either stream, holds the text (-: anything)
#   NAME: COMMAND                  a fact: the command ends with 0
#   $ COMMAND                      what the rows below need; it ends with 0
#   < FILE                         the lines that follow are written to the file
#   << FILE                        as well, with $variables in them replaced
#   == TITLE
#   ? COMMAND                      if it fails, the rows down to the next title are left out;
#                                  where no row is left the table counts as skipped
#
# Commands are those of sh, in a new folder. build/winnow is `winnow`; $top is the project,
# $build its build, $1 the first WORD.
set -u
# A process that was started by nohup never hears of a hangup, nor do its children.
if [ -z "${HEARS:-}" ] && env --default-signal=HUP true 2>/dev/null; then
    HEARS=hangups exec env --default-signal=HUP,INT,TERM sh "$0" "$@"
fi
build=$(cd "$1" && pwd)
table=$(cd "$(dirname "$2")" && pwd)/$(basename "$2")
title=$(basename "$2" .txt)
shift 2
top=$PWD
PATH=$build:$PATH
work=$(mktemp -d)
trap 'chmod -R u+w "$work"; rm -rf "$work"' EXIT
mkdir "$work/here" && cd "$work/here" || exit 1
failed=0
facts=0
left_out=
missing=
break='
'
exec 3>&1
# Threads that wait should not keep others from working on a busy machine.
export OMP_WAIT_POLICY=passive

wrong() { # WHAT: of the command whose words are in said
    printf 'FAILED %s:\n' "$1" >&3 && tail -n 40 "$work/said" | cut -c -400 >&3
    failed=$((failed + 1))
}

fact() { # NAME CODE TEXT COMMAND...
    name=$1 code=$2 text=$3
    shift 3
    ("$@") >"$work/said" 2>&1 </dev/null 4<&-
    found=$?
    if [ $found -ne "$code" ]; then
        wrong "$name: exit code $found, not $code"
    elif [ "$text" != - ] && ! grep -qF -- "$text" "$work/said"; then
        wrong "$name: no \"$text\" in"
    else
        facts=$((facts + 1)) && echo "    $name" >&3
    fi
}

take() { # ROW WORDS...
    all=$1
    shift
    first=${all%%"$break"*}
    rest=${all#"$first"}
    rest=${rest#"$break"}
    case $left_out$all in
    '' | '#'* | yes[!=]*) ;;
    '== '* | 'yes== '*) echo "${all#== }:" && left_out= ;;
    '? '*)
        eval "${all#? }" >/dev/null 2>&1 || { left_out=yes && missing=${all#? }; }
        [ -z "$left_out" ] || echo "    left out, since this fails: $missing"
        ;;
    '<< '*) eval "cat >${first#<< } <<END_OF_FILE$break$rest${break}END_OF_FILE" ;;
    '< '*) printf '%s\n' "$rest" | sed 's/^    //' >"${first#< }" ;;
    '$ '*)
        { eval "${all#\$ }" && true; } >"$work/said" 2>&1 </dev/null || wrong "what is needed, ${first#\$ }"
        ;;
    *)
        if echo "$first" | grep -q '^[A-Za-z0-9_]*:'; then
            fact "${first%%:*}" 0 - eval "${all#*:}"
        else
            name=${first%% | *} first=${first#* | }
            code=${first%% | *} first=${first#* | }
            text=${first%% | *} command=${first#* | }
            case $first in *' |') text=${first% |} command= ;; esac
            fact "$name" "$code" "$text" eval "$command$break$rest"
        fi
        ;;
    esac
}

row=
while IFS= read -r line <&4; do
    case $line in
    ' '*) row=$row$break$line ;;
    *) take "$row" "$@" && row=$line ;;
    esac
done 4<"$table"
take "$row" "$@"
if [ "$missing" ] && [ $((facts + failed)) -eq 0 ]; then
    echo "skipped: $title: this fails: $missing"
    exit
fi
echo "$title: $facts passed, $failed failed"
[ $failed -eq 0 ] && [ $facts -gt 0 ]
