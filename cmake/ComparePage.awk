# Does a page show what a program prints?  awk -f ComparePage.awk <page>.md <output>
#
# The page's rows of numbers, | 0.10 | 1.0000 |, against the output's last lines of as many numbers
# each, to the digits that the page has; fewer than two rows are a failure.
NR == FNR {
  if ($0 !~ /^\|[-+.0-9 |]*[0-9][-+.0-9 |]*\|$/) next
  ++rows
  columns = split($0, cells, "|") - 2
  for (c = 1; c <= columns; ++c) {
    gsub(/ /, "", cells[c + 1])
    said[rows, c] = cells[c + 1]
  }
  next
}
!/^#/ && NF == columns {
  ++lines
  for (c = 1; c <= columns; ++c) shown[lines, c] = $c
}
END {
  for (row = 1; row <= rows; ++row)
    for (c = 1; c <= columns; ++c) {
      text = said[row, c]
      digits = index(text, ".") ? length(text) - index(text, ".") : 0
      number = shown[lines - rows + row, c]
      apart = text - number
      if (apart < 0) apart = -apart
      if (!(apart <= 0.501 * 10 ^ -digits)) {
        print "row " row ", column " c " of the page: " text ", but the program prints " number
        bad = 1
      }
    }
  exit bad || rows < 2 || lines < rows
}
