# A covering array of strength 2: rows of values in which every two values of
# every two choices meet, but for those that are apart. Greedy: each row begins
# with a pair that has not met, and takes for each further choice, in an order
# by chance, the value that meets most others for the first time.

# 0 <= n < m, by the generator of Park and Miller: exact in doubles.
function chance(m) {
    state = (state * 16807) % 2147483647
    return int(state / 2147483647 * m)
}

function choice(arrays, name, values,    n, i, v) {
    if (index(arrays, letter) == 0) return
    names[++n_names] = name
    n = split(values, v, " ")
    n_values[n_names] = n
    number[name] = n_names
    for (i = 1; i <= n; i++) {
        value[n_names, i] = v[i]
        index_of[name, v[i]] = i
    }
}

# never holds the pairs that are apart; forbidden lists them by value, for block.
function separate(k, v, j, w, why) {
    never[k, v, j, w]
    never[j, w, k, v]
    forbid(k, v, j, w)
    forbid(j, w, k, v)
    if (why == "") return
    refused[++n_refused] = k " " v " " j " " w
    reason[n_refused] = why
}

function forbid(k, v, j, w) {
    if ((k, v, j, w) in listed) return
    listed[k, v, j, w]
    forbidden[k, v, ++n_forbidden[k, v]] = j SUBSEP w
}

# Puts value v of choice k into the row (by 1), or takes it out (by -1).
# blocked counts, for each value of the others, what in the row it is apart from.
function enter(k, v, by,    i, other) {
    row[k] = by > 0 ? v : 0
    for (i = 1; i <= n_forbidden[k, v]; i++) {
        other = forbidden[k, v, i]
        if ((k, v, other) in never) blocked[other] += by
    }
}

# The values of a choice; "on" is all but off.
function these(name, values, v,    i, n) {
    if (values != "on") return split(values, v, " ")
    for (i = 1; i <= n_values[number[name]]; i++)
        if (value[number[name], i] != "off") v[++n] = value[number[name], i]
    return n
}

function apart(a, as, b, bs, why,    x, y, i, j, n, m) {
    if (!(a in number) || !(b in number)) return
    n = these(a, as, x)
    m = these(b, bs, y)
    for (i = 1; i <= n; i++)
        for (j = 1; j <= m; j++)
            if ((a, x[i]) in index_of && (b, y[j]) in index_of)
                separate(number[a], index_of[a, x[i]], number[b],
                         index_of[b, y[j]], why)
}

# How many pairs of value v of choice k would meet for the first time; -1: it
# cannot stand in this row.
function gain(k, v,    j, n) {
    if (blocked[k, v] > 0) return -1
    n = 0
    for (j = 1; j <= n_names; j++)
        if (row[j] > 0 && j != k) n += !((k, v, j, row[j]) in met)
    return n
}

# 1 if each choice that is still open has a value left that may stand.
function open_end(    k, v, some) {
    for (k = 1; k <= n_names; k++) {
        if (row[k] > 0) continue
        some = 0
        for (v = 1; v <= n_values[k] && !some; v++) some = !(blocked[k, v] > 0)
        if (!some) return 0
    }
    return 1
}

# The best value for choice k, ties by chance; 0 if none may stand.
function best_value(k,    v, w, g, most, best) {
    most = -1
    w = chance(n_values[k])
    for (v = 1; v <= n_values[k]; v++) {
        w = w % n_values[k] + 1
        g = gain(k, w)
        if (g <= most) continue
        enter(k, w, 1)
        if (open_end()) { most = g; best = w }
        enter(k, w, -1)
    }
    return most < 0 ? 0 : best
}

function shuffle_order(    i, j, t) {
    for (i = 1; i <= n_names; i++) order[i] = i
    for (i = n_names; i > 1; i--) {
        j = 1 + chance(i)
        t = order[i]; order[i] = order[j]; order[j] = t
    }
}

function complete_row(    i, k, v) {
    shuffle_order()
    for (i = 1; i <= n_names; i++) {
        k = order[i]
        if (row[k] > 0) continue
        v = best_value(k)
        if (v == 0) return 0
        enter(k, v, 1)
    }
    return 1
}

function note_row(    i, j) {
    for (i = 1; i <= n_names; i++)
        for (j = 1; j <= n_names; j++)
            if (i != j) met[i, row[i], j, row[j]]
}

function start_row(i, v, j, w,    k) {
    for (k = 1; k <= n_names; k++) row[k] = 0
    split("", blocked)
    enter(i, v, 1)
    enter(j, w, 1)
    return open_end()
}

# Calls use_row(WHY) for each row: WHY is "" or what is said against it. The
# pairs that are refused come after the others, each in a row where nothing
# else is wrong.
function cover(    i, j, v, w, lost) {
    for (i = 1; i <= n_names; i++)
        for (j = i + 1; j <= n_names; j++)
            for (v = 1; v <= n_values[i]; v++)
                for (w = 1; w <= n_values[j]; w++) {
                    if ((i, v, j, w) in met || (i, v, j, w) in never) continue
                    if (!start_row(i, v, j, w) || !complete_row()) {
                        lost++
                        print "cannot meet: " names[i] " " value[i, v] ", " \
                            names[j] " " value[j, w] >"/dev/stderr"
                        continue
                    }
                    note_row()
                    use_row("")
                }
    return lost + cover_refused()
}

function cover_refused(    i, part, lost) {
    for (i = 1; i <= n_refused; i++) {
        split(refused[i], part, " ")
        delete never[part[1], part[2], part[3], part[4]]
        delete never[part[3], part[4], part[1], part[2]]
        if (start_row(part[1], part[2], part[3], part[4]) && complete_row())
            use_row(reason[i])
        else
            lost++
        separate(part[1], part[2], part[3], part[4], "")
    }
    return lost
}
