# Reads "scene program contacts height speed rate" and prints medians, and the
# medians of the ratios of our rate to the others', turn by turn.
function median(list,   n, i, j, x, v) {
    n = split(list, v, " ")
    for (i = 1; i <= n; i++)
        for (j = i + 1; j <= n; j++)
            if (v[j] + 0 < v[i] + 0) { x = v[i]; v[i] = v[j]; v[j] = x }
    return n % 2 ? v[(n + 1) / 2] : (v[n / 2] + v[n / 2 + 1]) / 2
}
{
    key = $1 " " $2
    if (!(key in rates)) order[++keys] = key
    if (!($1 in begun)) { scene[++scenes] = $1; begun[$1] }
    turn = ++turns[key]
    rates[key] = rates[key] " " $6
    at[key, turn] = $6
    state[key] = $3 " " $4 " " $5
}
END {
    printf "%-15s %-9s %9s %10s %10s %12s\n", "scene", "program", "contacts",
           "height mm", "rms m/s", "M steps/s"
    for (k = 1; k <= keys; k++) {
        split(order[k], name, " ")
        split(state[order[k]], s, " ")
        printf "%-15s %-9s %9.2f %10.3f %10.2g %12.2f\n", name[1], name[2], s[1],
               s[2], s[3], median(rates[order[k]])
    }
    print ""
    for (c = 1; c <= scenes; c++)
        for (k = 1; k <= keys; k++) {
            split(order[k], name, " ")
            if (name[1] != scene[c] || name[2] == "winnow") continue
            list = ""
            for (t = 1; t <= turns[order[k]]; t++) {
                ours = at[name[1] " winnow", t]
                if (name[2] == "lammps-2") ours = at[name[1] " winnow-2", t]
                ratio = ours / at[order[k], t]
                list = list " " (name[2] == "winnow-2" ? 1 / ratio : ratio)
            }
            what = name[2] == "winnow-2" ? "two threads over one" \
                 : name[2] == "lammps-2" ? "two threads over lammps on two" \
                 : "winnow over " name[2]
            printf "%s, %s = %.2f\n", name[1], what, median(list)
        }
}
