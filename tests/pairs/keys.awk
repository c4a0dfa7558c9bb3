# What `winnow list keys` says of the values of each key: names and true or false; of a
# number with a default, this and another one; of an effect that asks for nothing, off,
# on, and on with other values of its keys. A key that choices.awk and case.awk do not name
# is a choice by its path, so that a new key is tested without being told.

# The values of a key whose choice has a name of its own, but for some.
function values_of(path, but,    n, i, v, kept) {
    asked[path]
    n = split(values[path], v, " ")
    for (i = 1; i <= n; i++)
        if (index(" " but " ", " " v[i] " ") == 0) kept = kept " " v[i]
    return kept
}

# Twice the default, or as much as may be; half of it if that is less.
function another(d, what,    most) {
    most = match(what, /<=? [-+.0-9e]+/) ? substr(what, RSTART + 2, RLENGTH - 2) + 0 : 1e300
    if (what ~ /^a whole/) return d + 1 <= most ? d + 1 : d - 1
    return d == 0 ? "0.1" : sprintf("%g", 2 * d <= most ? 2 * d : d / 2)
}

# An effect off, on with what it asks for, and on with another value of its other keys.
function effect(path, asks,    i, n, part, key, more) {
    asked[path]
    n = split(others[path], part, ";")
    for (i = 1; i < n; i++) {
        key = part[i]
        sub(/=.*/, "=", key)
        if (index(";" asks, ";" key) == 0) more = more part[i] ";"
    }
    return "off {" asks "}" (more == "" ? "" : " {" asks more "}")
}

function learn(line,    path, what, d, part, v) {
    if (line !~ /^[a-z]/) return
    path = what = line
    sub(/ = .*/, "", path)
    sub(/^[^=]* = /, "", what)
    d = match(what, /; default [^;]*/) ? substr(what, RSTART + 10, RLENGTH - 10) : ""
    needs[path] = match(what, /; needs [a-z]*/) ? substr(what, RSTART + 8, RLENGTH - 8) : ""
    if (what ~ /; required/ && path ~ /^effects[.].*[.]/) {
        sub(/[.][a-z_]*$/, "", path)
        delete values[path]
        return
    }
    sub(/ *;.*/, "", what)
    order_of[++n_keys] = path
    if (path ~ /^effects[.][a-z_]*$/ && what ~ /^a group/)
        values[path] = "off {}"
    else if (what ~ /^[A-Za-z0-9-]+( or [A-Za-z0-9-]+)+$/) {
        gsub(/ or /, " ", what)
        values[path] = what
    } else if (d ~ /^[-+.0-9e]+$/ && what ~ /^a (whole )?number/)
        values[path] = d " " another(d, what)
    if (split(path, part, ".") == 3 && part[1] == "effects" && d != "" && path in values) {
        split(values[path], v, " ")
        what = d == v[1] ? v[2] : v[1]
        others["effects." part[2]] = others["effects." part[2]] part[3] "=" \
            (what ~ /^([-+.0-9e]+|true|false)$/ ? what : "\"" what "\"") ";"
    }
}

BEGIN {
    while ((("\"" winnow "\" list keys") | getline line) > 0) learn(line)
    while ((getline line <(parts "/choices.awk")) > 0) told = told line
    while ((getline line <(parts "/case.awk")) > 0) told = told line
    arrays["fluid"] = "cfm"; arrays["particles"] = "cpm"; arrays["bodies"] = "f"
    arrays["averaging"] = arrays["exchange"] = arrays["effects"] = "cm"
}

# After the choices that have names.
function learn_others(    i, path, part, of) {
    for (i = 1; i <= n_keys; i++) {
        path = order_of[i]
        if (!(path in values) || path in asked || path in number || split(path, part, ".") != 2 ||
            told ~ "[^a-z_.]" part[2] " = ") continue
        of = part[1] != "output" ? arrays[part[1]] : needs[path] == "particles" ? "cp" : \
            needs[path] == "fluid" ? "cf" : "cpf"
        choice(of, path, part[1] == "effects" ? effect(path) : values[path])
    }
}

# The words that set them in the row of case.awk.
function other_keys(    k, words) {
    for (k in v)
        if (k ~ /[.]/ && v[k] != "" && v[k] != "off" && (k !~ /^bodies/ || on("bodies")))
            words = words " -s " k "=" v[k]
    return words
}
