# steps.awk -- a step of the course as a listing: coloured, its citations as
# links, and marked where no step before it has the same line.
#
#   awk -v anchors=A -f colour.awk -f steps.awk BEFORE.c ... STEP.c
#
# The last file is the one that is shown.

BEGIN {
    colour_begin()
    shown = ARGV[ARGC - 1]
    while ((getline line < shown) > 0) text[++lines] = line
}
FILENAME == shown { nextfile }
{ earlier[key($0)] }

# A line, whatever its comment is aligned with.
function key(s) {
    gsub(/  +/, " ", s)
    return s
}

END {
    printf "<pre class=\"step\">"
    for (k = 1; k <= lines; k++) {
        out = colour_line(text[k])
        new = ARGC > 2 && !(key(text[k]) in earlier)
        printf "<span id=\"L%d\"%s>%s\n</span>", k, new ? " class=\"new\"" : "", out
    }
    print "</pre>"
}
