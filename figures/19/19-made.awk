# The finest mesh of each flow of 19-made.c: errors and orders.
BEGIN { print "# flow, cells a side; error of u, order, in the largest, at walls; of p" }
$1 != "#" && $1 != last && row != "" { print row }
$1 != "#" {
    last = $1
    row = sprintf("%-15s %3d  %s %s %s %s  %s %s %s %s", $1, $2, $3, $9, $10, $11,
                  $6, $12, $13, $14)
}
END { print row }
