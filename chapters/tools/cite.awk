# cite.awk -- reads citations of the four documents. A library of functions for
# ledger.awk and refs.awk.
#
# After load_ledger(): key[1..n_keys] in order, position[key], title[key],
# status[key]. After cites(line, form): cited[1..n_cited] are the keys that the
# line cites between the form's marks, and unknown holds what looks like a
# citation and is none. The forms: in_brackets, in_quotes.

BEGIN {
    in_brackets = "\\[(SX15|XS11|LS|EW18)[ ,][^]]*\\]"
    in_quotes = "\"(SX15|XS11|LS|EW18)[ ,:][^\"]*\""
}

function load_ledger(file,    line, f, k) {
    while ((getline line < file) > 0) {
        if (line ~ /^#/ || line == "") continue
        if (split(line, f, / *[|] */) != 3 || f[1] in position) {
            print file ": cannot read: " line >"/dev/stderr"
            exit 1
        }
        key[++n_keys] = f[1]
        position[f[1]] = n_keys
        title[f[1]] = f[2]
        status[f[1]] = f[3]
    }
    close(file)
    for (k = 1; k <= n_keys; k++)
        if (status[key[k]] !~ /^(done|in part: .+|not yet: .+|as .+)$/ ||
            status[key[k]] ~ /^as / && !(stands_for(key[k]) in position)) {
            print file ": " key[k] " is " status[key[k]] "?" >"/dev/stderr"
            exit 1
        }
}

# The key whose function, test and chapter stand for this one.
function stands_for(k) {
    while (status[k] ~ /^as /) k = substr(status[k], 4)
    return k
}

function cites(line, form,    part) {
    n_cited = 0
    unknown = ""
    while (match(line, form)) {
        part = substr(line, RSTART + 1, RLENGTH - 2)
        line = substr(line, RSTART + RLENGTH)
        read_list(part)
    }
}

# "XS11 2.11-2.14, 3.1, LS 5.27": the document holds until another is named.
function read_list(text,    parts, n, i, doc, s) {
    n = split(text, parts, / *[,;] */)
    doc = ""
    for (i = 1; i <= n; i++) {
        s = parts[i]
        if (match(s, /^(SX15|XS11|LS|EW18)([ :]|$)/)) {
            doc = s
            sub(/[ :].*/, "", doc)
            s = substr(s, RLENGTH + 1)
        }
        gsub(/[()]/, "", s)
        sub(/ [a-z].*/, "", s) # "4.12 with e instead of 0"
        # words, and places that are no equations
        if (s == "" || s ~ /^[a-z][a-z]/ || s ~ /^(Table|Fig|Section|Appendix)/)
            continue
        if (s ~ /^[0-9]$/ && doc ~ /^(XS11|LS)$/) continue # a chapter
        if (!read_keys(doc, s)) unknown = unknown " [" doc " " s "]"
    }
}

# One key, all of its letters, or a range of keys; 0 if there are none.
function read_keys(doc, s,    ends, a, b, k) {
    if (split(s, ends, "-") == 2) {
        if (ends[2] ~ /^[a-z]$/) # 5a-c
            ends[2] = substr(ends[1], 1, length(ends[1]) - 1) ends[2]
    } else
        ends[2] = ends[1]
    a = find_key(doc " " ends[1], 1)
    b = find_key(doc " " ends[2], 0)
    if (!a || !b || a > b) return 0
    for (k = a; k <= b; k++) cited[++n_cited] = key[k]
    return 1
}

# The place of a key in the ledger; of the first or last of its letters.
function find_key(s, want_first,    i, found) {
    if (s in position) return position[s]
    found = 0
    for (i = 1; i <= n_keys; i++)
        if (substr(key[i], 1, length(s)) == s &&
            substr(key[i], length(s) + 1) ~ /^[a-z]$/ &&
            !(want_first && found))
            found = i
    return found
}

# The key in the name of a test: xs11_2_13_..., sx15_a_1b_..., sx15_5c_...;
# "" if the name holds none, and unknown if it holds a wrong one.
function cites_name(name,    w, n, doc, s) {
    n_cited = 0
    unknown = ""
    n = split(name, w, "_")
    if (n < 3 || w[1] !~ /^(sx15|xs11|ls|ew18)$/) return
    doc = toupper(w[1])
    if (w[2] == "algorithm") s = "Algorithm " w[3] "." w[4]
    else if (w[2] ~ /^[ab]$/ && w[3] ~ /^[0-9]+[a-c]?$/)
        s = toupper(w[2]) "." w[3]
    else if (doc ~ /^(SX15|EW18)$/ && w[2] ~ /^[0-9]+[a-c]?$/) s = w[2]
    else if (w[2] ~ /^[0-9]+$/ && w[3] ~ /^[0-9]+[a-c]?$/) s = w[2] "." w[3]
    else return
    if (!read_keys(doc, s)) unknown = " [" doc " " s "]"
}
