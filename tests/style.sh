#!/bin/sh
# The rules of style that a machine can check. Says everything that is wrong.
#
#   sh tests/style.sh build      (after the build: object files are looked at)
#   sh tests/style.sh build long (what takes longer, besides)
set -u
build=${1:-build}
extent=${2:-quick}
found=$(mktemp)
trap 'rm -f "$found"' EXIT

flags='-std=c11 -D_POSIX_C_SOURCE=200809L -fopenmp -Isrc -Itests -fsyntax-only
-Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wmissing-prototypes -Wno-missing-field-initializers -Werror'
flags="$flags $(pkg-config --cflags hdf5 2>/dev/null)"
sources=$(find src tests -name '*.[ch]' | sort)
# What includes headers of LAMMPS and PETSc, which need not be there, is laid
# out and measured only.
ranks=src/distributed/ranks
units=$(find src -name '*.c' -not -path "$ranks/*" | sort)
headers=$(find src -name '*.h' -not -path "$ranks/*" | sort)
objects=$(find "$build/src" -name '*.o' -not -path "*/$ranks/*" 2>/dev/null | sort)

wrong() { # prefixes each line of the input with a rule; notes that it is broken
    sed "s/^/$1: /" >>"$found"
}

# What a rule returns that needs a program which is not here.
left_out=77

long() { [ "$extent" != long ] || echo "$1"; }

layout() {
    command -v clang-format >/dev/null || return $left_out
    # shellcheck disable=SC2086 # one word a file
    clang-format --dry-run $sources chapters/steps/*.c 2>&1 | grep 'warning:' |
        wrong 'not as clang-format lays it out'
}

# Every header compiles alone: it is the first that a source file includes, which was
# compiled, or it is compiled here. And every source file does with clang, too.
alone() {
    for header in $headers; do
        first=$(grep -m 1 '^#include' "${header%.h}.c" 2>/dev/null)
        [ "$first" != "#include \"${header#src/}\"" ] || continue
        for compiler in gcc $(long clang); do
            command -v $compiler >/dev/null || continue
            # shellcheck disable=SC2086
            printf '#include "%s"\nextern int nothing;\n' "${header#src/}" |
                $compiler $flags -x c - 2>&1 | grep -E 'error:' |
                wrong "header does not compile alone ($compiler)"
        done
    done
}

clang_too() {
    command -v clang >/dev/null || return $left_out
    # shellcheck disable=SC2086
    clang $flags $units $(find tests -name '*.c' -not -path 'tests/ranks/*') 2>&1 | grep -E 'error:' |
        wrong 'clang objects'
}

# A module knows itself and earlier ones; some not even all of these.
modules() {
    grep -rn --include='*.[ch]' '^#include "' src | awk '
    BEGIN {
        n = split("base mesh linear fluid dem averaging coupling resolved output record case tell report study distributed",
                  order, " ")
        for (i = 1; i <= n; i++) rank[order[i]] = i
        apart["linear mesh"]; apart["dem fluid"]; apart["averaging fluid"]
        apart["output fluid"]; apart["output coupling"]
    }
    { # src/module/[folder/]file:line:#include "other/[folder/]file"
        split($1, path, "/"); split($0, quoted, "\"")
        split(quoted[2], included, "/")
        module = path[2]; other = included[1]
        if (module ~ /^(main|commands|run_command)[.]c/) next
        if (rank[other] == 0 || rank[other] > rank[module] ||
            (module " " other) in apart)
            print $0
    }' | wrong 'module includes one it may not know'
}

# An exported name begins with a file of its module, or with a part of one ("--- magnus").
names() {
    # shellcheck disable=SC2086
    parts=$(awk '/^\/[*] --- [a-z ]*(:| -)/ {
        gsub(/^.* --- |(:| -+ ).*$/, ""); gsub(/ /, "_"); print FILENAME "/" $0 ".part" }' \
        $units $headers)
    # shellcheck disable=SC2086
    nm -A -g --defined-only $objects | awk -v files="$headers
$units
$parts" '
    BEGIN { # behind[module]: a pattern of its files and parts, those of its folders too
        n = split(files, file, "\n")
        for (i = 1; i <= n; i++) {
            m = split(file[i], part, "[/.]")
            behind[part[2]] = behind[part[2]] "|" part[m - 1]
        }
    }
    { # build/.../src/module/[folder/]file.o:0000 T name
        path = $1
        sub(/^.*\/src\//, "", path)
        if (path ~ /^(main|commands)[.]o/) next
        n = split(path, part, "[/.]")
        own = "^(" part[n - 1] behind[part[1]] ")(s?_.*|s?)$"
        if ($3 !~ own) print $1 " " $3
    }' | wrong 'exported name without its module'
}

# A function has a name of its own in all of src, also one that its file alone can
# call, so that a search finds it. Words in capitals are macros.
unique() {
    command -v ctags >/dev/null || return $left_out
    ctags -R --languages=C --kinds-C=f -x src | awk '
    $1 !~ /^[A-Z_0-9]+$/ && $1 != "main" && $1 in place {
        print $1 ": " place[$1] " and " $4
    }
    { place[$1] = $4 }' | wrong 'two functions of one name'
}

# Constant tables of pointers are relocated (.data.rel.ro); what changes while
# the program runs is in .data or .bss.
variables() {
    # shellcheck disable=SC2086
    nm -A -f sysv $objects | awk -F'|' '
        $7 ~ /^\.(data|bss|tdata|tbss)/ && $7 !~ /^\.data\.rel\.ro/ {
            print $1
        }' | wrong 'variable at file scope that may change'
}

# A model that its kind's array does not name is never chosen.
models() {
    kinds=$(grep -l MODEL_MEMBERS $headers | xargs awk '
        /^struct [a-z_]+ {/ { kind = $2 } /^    MODEL_MEMBERS/ { print kind }' | paste -sd '|')
    # shellcheck disable=SC2086
    grep -hoE "^(static )?const struct ($kinds) [a-z_0-9]+ = \{" $units |
        sed 's/ = {//; s/.* //' | while read -r model; do
        # shellcheck disable=SC2086
        grep -qE "&$model\b" $units || echo "$model"
    done | wrong 'model that no array names'
}

lengths() {
    # shellcheck disable=SC2086 # one word a file
    wc -l $headers | awk '$1 > 250 && $2 != "total" { print $2 ": " $1 " lines" }' |
        wrong 'header of more than 250 lines'
    for unit in $units "$ranks"/*.c; do
        lines=$(wc -l <"$unit")
        [ "$lines" -le 500 ] || echo "$unit: $lines lines" |
            wrong 'file of more than 500 lines'
        awk -v file="$unit" '
            /^[a-z].*\(/ { start = NR }
            /^}/ { if (start && NR - start + 1 > 60)
                       print file ":" start ": " NR - start + 1 " lines"
                   start = 0 }' "$unit" |
            wrong 'function of more than 60 lines'
    done
}

# A compiler cache would leave the tree out.
tree() { # module
    # shellcheck disable=SC2086
    CCACHE_DISABLE=1 clang $flags -fno-color-diagnostics -Xclang -ast-dump "$1" \
        2>/dev/null
}

# A cast of a real number beyond the range of the whole one gives nonsense: only
# base/number makes one of the other. clang knows the type of what is cast.
casts() {
    grep -n -E '\<l?l(round|rint)[fl]?\(' $units $headers |
        wrong 'whole number that number.h did not make'
    [ "$extent" = long ] && command -v clang >/dev/null || return
    tree src/base/number.c | grep -q '<FloatingToIntegral>' ||
        echo 'none in number.c' | wrong 'casts are not seen'
    for unit in $(grep -l -E '\((int|long|unsigned( long)?|u?int[0-9]*_t|size_t)\)' \
        $units); do
        tree "$unit" | awk -v file="$unit" '
            /^[|`]-FunctionDecl/ { mine = $0 !~ / number_(int|long|clamped) / }
            /CStyleCastExpr.*<FloatingToIntegral>/ && mine { print file }'
    done | uniq -c | wrong 'cast of a real number, which number.h does'
}

text() {
    grep -rn --include='*.[ch]' '^ *# *if' src |
        grep -v -E '#ifndef [A-Z0-9_]+_H$|_OPENMP|MADV_HUGEPAGE' | wrong 'code behind #if'
    for unit in $units $(find tests -name '*.c'); do
        head -1 "$unit" | grep -q 'SPDX-License-Identifier: GPL-3.0-or-later' ||
            echo "$unit" | wrong 'no licence in the first line'
    done
}

# .clang-tidy says what is looked for.
tidy() {
    if command -v clang-tidy >/dev/null; then
        # shellcheck disable=SC2086
        clang-tidy --quiet $units -- $flags 2>/dev/null | grep ' error: ' |
            wrong 'clang-tidy'
    else
        echo "style: no clang-tidy here, left out"
        return $left_out
    fi
}

# Functions that nothing calls; tests and figures count. Its other checks do not
# follow arrays in structs and unnamed ones: gcc, clang and sanitizers see more.
unused() {
    if command -v cppcheck >/dev/null; then
        cppcheck -q --std=c11 --enable=unusedFunction -Isrc -Itests \
            --template='{file}:{line}: {id} {message}' src tests figures 2>&1 |
            grep ' unusedFunction ' | grep '^src' |
            grep -v "'settings_item'" | # macros of settings.h call it
            wrong 'cppcheck'
    else
        echo "style: no cppcheck here, left out"
        return $left_out
    fi
}

# A guard is the path of its header, so that no two are the same.
guards() {
    for header in $headers; do
        guard=$(echo "${header#src/}" | tr 'a-z/.' 'A-Z__')
        grep -q "^#ifndef $guard\$" "$header" ||
            echo "$header: $guard" | wrong 'guard that is not the path'
    done
}

facts=0
failed=0
for rule in layout alone guards modules names unique variables models lengths casts text \
    $(long "clang_too tidy unused"); do
    : >"$found"
    $rule
    code=$?
    if [ -s "$found" ]; then
        echo "FAILED $rule, $(wc -l <"$found") times:" && cat "$found"
        failed=$((failed + 1))
    elif [ $code -ne $left_out ]; then
        facts=$((facts + 1))
    fi
done
echo "style, $extent: $facts passed, $failed failed"
[ $failed -eq 0 ]
