# Compares two files of words and numbers line by line: numbers may differ by `tolerance`.
#
#     awk -v tolerance=1 -f compare.awk FIRST SECOND
FNR == NR { lines[FNR] = $0; count = FNR; next }
{
    n = split(lines[FNR], expected)
    same = n == NF
    for (i = 1; i <= NF && same; i++) {
        number = $i ~ /^-?[0-9.]+$/ && expected[i] ~ /^-?[0-9.]+$/
        difference = $i - expected[i]
        same = number ? difference <= tolerance && -difference <= tolerance : $i == expected[i]
    }
    if (!same && failed++ < 10) {
        print FILENAME ":" FNR
        print "  " substr(lines[FNR], 1, 300)
        print "  " substr($0, 1, 300)
    }
    seen = FNR
}
END {
    if (seen != count) { print FILENAME ": " seen + 0 " lines, not " count; failed++ }
    exit failed != 0
}
