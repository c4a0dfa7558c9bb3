# listing.awk -- the listings of a page in colours, on stdin: C, and patches.
#
#   awk -v anchors=A -v functions=F -f colour.awk -f listing.awk

BEGIN { colour_begin() }

match($0, /^<pre class="(c|diff)[^"]*"><code>/) {
    printf "%s", substr($0, 1, RLENGTH)
    is_c = $0 ~ /^<pre class="c/
    $0 = substr($0, RLENGTH + 1)
    within = 1
    in_comment = 0
}

within {
    ends = sub(/<\/code><\/pre>$/, "")
    if (is_c) s = colour_line(plain($0))
    else s = /^\+/ ? span("st", $0) : /^-/ ? span("kw", $0) : $0
    print s (ends ? "</code></pre>" : "")
    if (ends) within = 0
    next
}

{ print }
