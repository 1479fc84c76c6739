# Do tables say the same?  awk -f CompareColumns.awk <file> <file>...
#
# Numbers of the first file against those of the others, to 1e-9 of the column's largest one;
# lines that begin with # are skipped, fewer than two rows are a failure.
/^#/ { next }
FILENAME != file { file = FILENAME; ++files; row = 0 }
{
  ++row
  rows[files] = row
  for (c = 1; c <= NF; ++c)
    if (files == 1) {
      value[row, c] = $c
      size = $c < 0 ? -$c : $c
      if (size > scale[c]) scale[c] = size
    } else {
      apart = $c - value[row, c]
      if (apart < 0) apart = -apart
      if (!(apart <= 1e-9 * scale[c])) {
        print FILENAME ": row " row ", column " c ": " $c ", but " value[row, c]
        bad = 1
      }
    }
}
END {
  for (f = 1; f <= files; ++f)
    if (rows[f] < 2 || rows[f] != rows[1]) bad = 1
  exit files == 0 || bad
}
