# The median of v[1] to v[n], which it sorts.
function median(v, n,  i, j, x) {
    for (i = 2; i <= n; i++)
        for (j = i; j > 1 && v[j] < v[j - 1]; j--) {
            x = v[j]; v[j] = v[j - 1]; v[j - 1] = x
        }
    return v[int((n + 1) / 2)]
}
