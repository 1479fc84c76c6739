#pragma once

#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace epafi::drivers {

/// A number with 17 significant digits, enough to read back the same double.
std::string exactly(double value);

/// A number as a cell: integers as they are, others with `exactly`.
template <class Number>
std::string number(Number value) {
  if constexpr (std::is_integral_v<Number>)
    return std::to_string(value);
  else
    return exactly(value);
}

/// A column of a table: its name, and the function that returns its cell of a row.
template <class Row>
struct Column {
  const char* name;
  std::string (*cell)(const Row& row);
};

/// The cell of a (nested) member of a row: row.a.b for &Row::a, &A::b.
template <class Row, auto... members>
std::string cellOf(const Row& row) {
  return number((row.*....*members));
}

template <class Row, std::size_t count>
void addNames(const Column<Row> (&columns)[count], const std::string& prefix,
              std::vector<std::string>& names) {
  for (const Column<Row>& column : columns)
    names.push_back(prefix + column.name);
}

template <class Row, std::size_t count>
void addCells(const Column<Row> (&columns)[count], const Row& row,
              std::vector<std::string>& cells) {
  for (const Column<Row>& column : columns)
    cells.push_back(column.cell(row));
}

/// One line of comma-separated values.
std::string csvLine(const std::vector<std::string>& cells);

/// The first line of a table with these columns, and the line of a row.
template <class Row, std::size_t count>
std::string csvHead(const Column<Row> (&columns)[count]) {
  std::vector<std::string> names;
  addNames(columns, "", names);
  return csvLine(names);
}

template <class Row, std::size_t count>
std::string csvRow(const Column<Row> (&columns)[count], const Row& row) {
  std::vector<std::string> cells;
  addCells(columns, row, cells);
  return csvLine(cells);
}

/// The cells of a row with the names of their columns.
using CsvRow = std::vector<std::pair<const char*, std::string>>;
/// Adds a row to a table, with a line of names before the first one.
void addRow(const CsvRow& row, std::string& table);
void append(CsvRow& row, const CsvRow& more);

/// The cells of a line of csvLine, with or without the line end.
std::vector<std::string> csvCells(const std::string& line);

}  // namespace epafi::drivers
