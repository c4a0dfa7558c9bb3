# Joins the lists of models, one models.txt in each folder that has any, into
# the arrays that the code looks models up in, written as C:
#
#   awk -f src/models.awk src/*/models.txt src/*/*/models.txt left=1 FILE.c...
#
# A row names a kind and a descriptor of that kind. `struct drag_law` and the
# descriptor gidaspow_law make the row
#
#   drag_law  gidaspow_law
#
# and the array drag_laws[], of pointers, ended by NULL. The order is that of
# the rows, the first being the default; `after NAME` or `before NAME` at the
# end of a row puts the model next to another one, `first` before all others,
# `last` after them. A kind alone makes an array that may be empty. Where nothing
# but a constant tells the models of a kind apart, their descriptors are of the
# type struct model (base/model.h), and a row is
#
#   surface_shape:model  surface_plane
#
# `needs FOLDER` says that the folder does not work without that other one, which
# must then be among the words of `folders`, if that is given (-v folders=...).
#
# The files after left=1 are the source of the folders that are not built. Their
# keys, models and commands are listed in left_out_words[] (base/left_out.h).

function wrong(what) {
    print FILENAME ":" FNR ": " what >"/dev/stderr"
    failed = 1
    exit 2
}

# The word in the first quotes of a text.
function quoted(text) {
    sub(/^[^"]*"/, "", text)
    sub(/".*/, "", text)
    return text
}

left { # a key, or the name of a descriptor, on its line or on the next
    if (/\{"[a-z_.0-9<>]+", KEY_/ || /^ *\.name = "/ || /^const struct .*= \{"/ ||
        (opened && /^ *"/)) {
        folder = FILENAME
        sub(/\/[^\/]*$/, "", folder)
        left_out[++n_left] = "{\"" quoted($0) "\", \"" folder "\"}"
    }
    opened = /^const struct .*= \{$/
    next
}

{ sub(/#.*/, "") }
$1 == "needs" && folders != "" && !index(" " folders " ", " " $2 " ") {
    folder = FILENAME
    sub(/\/[^\/]*$/, "", folder)
    print folder " needs " $2 ", which is left out: leave out both" >"/dev/stderr"
    failed = 1
}
NF == 0 || $1 == "needs" { next }
{ split($1, word, ":"); $1 = word[1] }
!($1 in n) { kinds[++n_kinds] = $1; n[$1] = 0; type[$1] = word[2] }
NF == 1 { next }
NF == 3 && $3 == "last" {
    if ($1 in ends) wrong("there is a last " $1 " already: " ends[$1])
    ends[$1] = $2
    next
}
NF == 3 && $3 == "first" { at = 0 }
NF == 4 && ($3 == "after" || $3 == "before") {
    for (at = n[$1]; at > 0 && model[$1, at] != $4; at--) continue
    if (at == 0) wrong("there is no " $1 " " $4 " in the rows so far")
    if ($3 == "before") at--
}
NF == 3 && $3 == "first" || NF == 4 {
    for (i = n[$1]++; i > at; i--) model[$1, i + 1] = model[$1, i]
    model[$1, at + 1] = $2
    next
}
NF != 2 { wrong("expected a kind, a descriptor, and perhaps: after NAME, before NAME, or: first, last") }
{ model[$1, ++n[$1]] = $2 }

END {
    if (failed) exit 2
    print "/* Written by models.awk from the lists of the folders. */"
    print "#include <stddef.h>"
    for (k = 1; k <= n_kinds; k++) {
        kind = kinds[k]
        if (kind in ends) model[kind, ++n[kind]] = ends[kind]
        name = type[kind] != "" ? type[kind] : kind
        all = "const struct " name
        print "\nstruct " name ";"
        for (i = 1; i <= n[kind]; i++)
            print "extern " all " " model[kind, i] ";"
        print "extern " all " *const " kind "s[];"
        print all " *const " kind "s[] = {"
        for (i = 1; i <= n[kind]; i++) print "    &" model[kind, i] ","
        print "    NULL};"
    }
    print "\n#include \"base/left_out.h\"\nconst struct left_out left_out_words[] = {"
    for (i = 1; i <= n_left; i++) print "    " left_out[i] ","
    print "    {NULL, NULL}};"
}
